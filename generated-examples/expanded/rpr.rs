// What `dh_robot!` makes of src/rpr.rs. Made by `cargo regen`; do not edit.

/// Turn, slide, turn: the slide moves across the first axis and the third joint turns about the slide's direction.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | 0 | q1 | any |
/// | q2 | 90 deg | 0 | q2 | 0 | any |
/// | q3 | 0 | 0 | l2 | q3 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rpr {
    /// `l2` in m.
    pub l2: f64,
}
impl ::core::default::Default for Rpr {
    fn default() -> Self {
        Rpr { l2: 0.4 }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Rpr {
    /// Number of joints.
    pub const DOF: usize = 3;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 3] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::prismatic("q2"),
        ::dh_robot::Joint::revolute("q3"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 6 multiplications, 1 addition, 2 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.l2 + q[1];
        ::dh_robot::pose::from_entries(
            [[c3 * c1, -s3 * c1, s1], [c3 * s1, -s3 * s1, -c1], [s3, c3, 0.0]],
            [t * s1, -t * c1, 0.0],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 8 multiplications, 2 additions, 2 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 3],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        let angles = [q[0], q[2]];
        let ([s1, s3], [c1, c3]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = s1 * q[1];
        let t_2 = c1 * q[1];
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [t, -t_2, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c3, -c1 * s3, s1], [s1 * c3, -s1 * s3, -c1], [s3, c3, 0.0]],
                [t + s1 * self.l2, -(t_2 + c1 * self.l2), 0.0],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 2 multiplications, 1 addition, 1 sine-cosine pair.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.l2 + q[1];
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [c1 * t, s1 * t, 0.0, 0.0, 0.0, 1.0],
                [s1, -c1, 0.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, s1, -c1, 0.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 6 multiplications, 1 addition, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 3>,
    ) {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.l2 + q[1];
        let t_2 = s1 * t;
        let t_3 = c1 * t;
        (
            ::dh_robot::pose::from_entries(
                [[c3 * c1, -s3 * c1, s1], [c3 * s1, -s3 * s1, -c1], [s3, c3, 0.0]],
                [t_2, -t_3, 0.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_3, t_2, 0.0, 0.0, 0.0, 1.0],
                    [s1, -c1, 0.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, s1, -c1, 0.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<3, f64> for Rpr {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 3] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<3, f64> for Rpr {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Rpr::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 3]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        Rpr::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<3, f64> for Rpr {
    #[inline]
    fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        Rpr::jacobian(self, q)
    }
}
