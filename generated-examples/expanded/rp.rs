// What `dh_robot!` makes of src/rp.rs. Made by `cargo regen`; do not edit.

/// Turn and slide: a point in polar coordinates.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | 0 | q1 | any |
/// | q2 | -90 deg | 0 | q2 | 0 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rp;
impl ::core::default::Default for Rp {
    fn default() -> Self {
        Rp
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Rp {
    /// Number of joints.
    pub const DOF: usize = 2;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 2] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::prismatic("q2"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 2 multiplications, 0 additions, 1 sine-cosine pair. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 2]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        ::dh_robot::pose::from_entries(
            [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
            [-q[1] * s1, q[1] * c1, 0.0],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 2 multiplications, 0 additions, 1 sine-cosine pair.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 2],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 2] {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
                [-s1 * q[1], c1 * q[1], 0.0],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 2 multiplications, 0 additions, 1 sine-cosine pair.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 2]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 2> {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-c1 * q[1], -s1 * q[1], 0.0, 0.0, 0.0, 1.0],
                [-s1, c1, 0.0, 0.0, 0.0, 0.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 2 multiplications, 0 additions, 1 sine-cosine pair.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 2],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 2>,
    ) {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = s1 * q[1];
        let t_2 = c1 * q[1];
        (
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
                [-t, t_2, 0.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_2, -t, 0.0, 0.0, 0.0, 1.0],
                    [-s1, c1, 0.0, 0.0, 0.0, 0.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<2, f64> for Rp {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 2] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<2, f64> for Rp {
    #[inline]
    fn forward(&self, q: &[f64; 2]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Rp::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 2]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 2] {
        Rp::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<2, f64> for Rp {
    #[inline]
    fn jacobian(&self, q: &[f64; 2]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 2> {
        Rp::jacobian(self, q)
    }
}
