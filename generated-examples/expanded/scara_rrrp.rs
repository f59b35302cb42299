// What `dh_robot!` makes of src/scara_rrrp.rs. Made by `cargo regen`; do not edit.

/// A SCARA with its quill in the last joint.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | d1 | q1 | any |
/// | q2 | 0 | a1 | d2 | q2 | any |
/// | q3 | 0 | a2 | 0 | q3 | any |
/// | q4 | 0 | 0 | q4 | 0 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaraRrrp {
    /// `a1` in m.
    pub a1: f64,
    /// `a2` in m.
    pub a2: f64,
    /// `d1` in m.
    pub d1: f64,
    /// `d2` in m.
    pub d2: f64,
}
impl ::core::default::Default for ScaraRrrp {
    fn default() -> Self {
        ScaraRrrp {
            a1: 0.4,
            a2: 0.3,
            d1: 0.5,
            d2: 0.1,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl ScaraRrrp {
    /// Number of joints.
    pub const DOF: usize = 4;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 4] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::revolute("q2"),
        ::dh_robot::Joint::revolute("q3"),
        ::dh_robot::Joint::prismatic("q4"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 4 multiplications, 7 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[0] + q[1] + q[2], q[0] + q[1], q[0]];
        let ([s123, s12, s1], [c123, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        ::dh_robot::pose::from_entries(
            [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
            [
                self.a2 * c12 + self.a1 * c1,
                self.a2 * s12 + self.a1 * s1,
                self.d1 + q[3] + self.d2,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 4 multiplications, 7 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 4],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        let angles = [q[0], q[0] + q[1], q[0] + q[1] + q[2]];
        let ([s1, s12, s123], [c1, c12, c123]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c1 * self.a1;
        let t_2 = s1 * self.a1;
        let t_3 = self.d1 + self.d2;
        let t_4 = t + c12 * self.a2;
        let t_5 = t_2 + s12 * self.a2;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, self.d1],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, -s12, 0.0], [s12, c12, 0.0], [0.0, 0.0, 1.0]],
                [t, t_2, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
                [t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
                [t_4, t_5, t_3 + q[3]],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 4 multiplications, 3 additions, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        let angles = [q[0] + q[1], q[0]];
        let ([s12, s1], [c12, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.a2 * c12;
        let t_2 = self.a2 * s12;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(t_2 + self.a1 * s1), t + self.a1 * c1, 0.0, 0.0, 0.0, 1.0],
                [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 4 multiplications, 7 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 4>,
    ) {
        let angles = [q[0] + q[1] + q[2], q[0] + q[1], q[0]];
        let ([s123, s12, s1], [c123, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = self.a2 * c12;
        let t_2 = self.a2 * s12;
        let t_3 = t + self.a1 * c1;
        let t_4 = t_2 + self.a1 * s1;
        (
            ::dh_robot::pose::from_entries(
                [[c123, -s123, 0.0], [s123, c123, 0.0], [0.0, 0.0, 1.0]],
                [t_3, t_4, q[3] + self.d2 + self.d1],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                    [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
                    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<4, f64> for ScaraRrrp {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 4] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<4, f64> for ScaraRrrp {
    #[inline]
    fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        ScaraRrrp::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 4]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        ScaraRrrp::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<4, f64> for ScaraRrrp {
    #[inline]
    fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        ScaraRrrp::jacobian(self, q)
    }
}
