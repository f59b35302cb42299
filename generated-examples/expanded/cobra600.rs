// What `dh_robot!` makes of src/cobra600.rs. Made by `cargo regen`; do not edit.

/// Adept Cobra 600: the second twist of half a turn points the quill down.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | d1 | a1 | 0 | -50.0 to 50.0 deg |
/// | q2 | q2 | 0 | a2 | 180 deg | -88.0 to 88.0 deg |
/// | q3 | 0 | q3 | 0 | 0 | 0.0 to 0.21 |
/// | q4 | q4 | 0 | 0 | 0 | -360.0 to 360.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cobra600;
impl ::core::default::Default for Cobra600 {
    fn default() -> Self {
        Cobra600
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Cobra600 {
    /// Number of joints.
    pub const DOF: usize = 4;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 4] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-0.8726646259971648, 0.8726646259971648),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-1.53588974175501, 1.53588974175501),
        ::dh_robot::Joint::prismatic("q3").with_range(0.0, 0.21),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-6.283185307179586, 6.283185307179586),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 4 multiplications, 6 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[0] + q[1], q[0], q[0] + q[1] - q[3]];
        let ([s12, s1, s12m4], [c12, c1, c12m4]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        ::dh_robot::pose::from_entries(
            [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
            [0.275 * c12 + 0.325 * c1, 0.275 * s12 + 0.325 * s1, -(q[2] - 0.387)],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 4 multiplications, 6 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 4],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        let angles = [q[0], q[0] + q[1], q[0] + q[1] - q[3]];
        let ([s1, s12, s12m4], [c1, c12, c12m4]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c1 * 0.325;
        let t_2 = s1 * 0.325;
        let t_3 = t + 0.275 * c12;
        let t_4 = t_2 + 0.275 * s12;
        let t_5 = 0.387 - q[2];
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [t, t_2, 0.387],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, s12, 0.0], [s12, -c12, 0.0], [0.0, 0.0, -1.0]],
                [t_3, t_4, 0.387],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, s12, 0.0], [s12, -c12, 0.0], [0.0, 0.0, -1.0]],
                [t_3, t_4, t_5],
            ),
            ::dh_robot::pose::from_entries(
                [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
                [t_3, t_4, t_5],
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
        let t = 0.275 * c12;
        let t_2 = 0.275 * s12;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(t_2 + 0.325 * s1), t + 0.325 * c1, 0.0, 0.0, 0.0, 1.0],
                [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 4 multiplications, 6 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 4>,
    ) {
        let angles = [q[0] + q[1] - q[3], q[0] + q[1], q[0]];
        let ([s12m4, s12, s1], [c12m4, c12, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.275 * c12;
        let t_2 = 0.275 * s12;
        let t_3 = t + 0.325 * c1;
        let t_4 = t_2 + 0.325 * s1;
        (
            ::dh_robot::pose::from_entries(
                [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
                [t_3, t_4, -(q[2] - 0.387)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                    [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                    [0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<4, f64> for Cobra600 {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 4] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<4, f64> for Cobra600 {
    #[inline]
    fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Cobra600::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 4]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        Cobra600::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<4, f64> for Cobra600 {
    #[inline]
    fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        Cobra600::jacobian(self, q)
    }
}
