// What `dh_robot!` makes of src/planar_3r.rs. Made by `cargo regen`; do not edit.

/// Three links in a plane, every frame at the far end of its link.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | 0 | l1 | 0 | any |
/// | q2 | q2 | 0 | l2 | 0 | any |
/// | q3 | q3 | 0 | l3 | 0 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planar3r {
    /// `l1` in m.
    pub l1: f64,
    /// `l2` in m.
    pub l2: f64,
    /// `l3` in m.
    pub l3: f64,
}
impl ::core::default::Default for Planar3r {
    fn default() -> Self {
        Planar3r {
            l1: 5.0,
            l2: 2.0,
            l3: 1.0,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Planar3r {
    /// Number of joints.
    pub const DOF: usize = 3;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 3] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::revolute("q2"),
        ::dh_robot::Joint::revolute("q3"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 6 multiplications, 7 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[0] + q[1] + q[2], q[0] + q[1], q[0]];
        let ([s123, s12, s1], [c123, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        ::dh_robot::pose::from_entries(
            [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
            [
                self.l3 * c123 + self.l2 * c12 + self.l1 * c1,
                self.l3 * s123 + self.l2 * s12 + self.l1 * s1,
                0.0,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 6 multiplications, 7 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 3],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        let angles = [q[0], q[0] + q[1], q[0] + q[1] + q[2]];
        let ([s1, s12, s123], [c1, c12, c123]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = self.l1 * c1;
        let t_2 = self.l1 * s1;
        let t_3 = t + self.l2 * c12;
        let t_4 = t_2 + self.l2 * s12;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [t, t_2, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, -s12, 0.0], [s12, c12, 0.0], [0.0, 0.0, 1.0]],
                [t_3, t_4, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
                [t_3 + self.l3 * c123, t_4 + self.l3 * s123, 0.0],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 6 multiplications, 7 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let angles = [q[0] + q[1] + q[2], q[0] + q[1], q[0]];
        let ([s123, s12, s1], [c123, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c123 * self.l3;
        let t_2 = s123 * self.l3;
        let t_3 = t + self.l2 * c12;
        let t_4 = t_2 + self.l2 * s12;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(t_4 + self.l1 * s1), t_3 + self.l1 * c1, 0.0, 0.0, 0.0, 1.0],
                [-t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                [-t_2, t, 0.0, 0.0, 0.0, 1.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 6 multiplications, 7 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 3>,
    ) {
        let angles = [q[0] + q[1] + q[2], q[0] + q[1], q[0]];
        let ([s123, s12, s1], [c123, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c123 * self.l3;
        let t_2 = s123 * self.l3;
        let t_3 = t + self.l2 * c12;
        let t_4 = t_2 + self.l2 * s12;
        let t_5 = t_3 + self.l1 * c1;
        let t_6 = t_4 + self.l1 * s1;
        (
            ::dh_robot::pose::from_entries(
                [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
                [t_5, t_6, 0.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_6, t_5, 0.0, 0.0, 0.0, 1.0],
                    [-t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                    [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<3, f64> for Planar3r {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 3] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<3, f64> for Planar3r {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Planar3r::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 3]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        Planar3r::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<3, f64> for Planar3r {
    #[inline]
    fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        Planar3r::jacobian(self, q)
    }
}
