// What `dh_robot!` makes of src/gantry_wrist.rs. Made by `cargo regen`; do not edit.

/// Three slides at right angles, and a spherical wrist.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | q1 | 90 deg | any |
/// | q2 | 90 deg | 0 | q2 | 90 deg | any |
/// | q3 | 90 deg | 0 | q3 | 0 | any |
/// | q4 | 0 | 0 | d4 | q4 | any |
/// | q5 | 90 deg | 0 | 0 | q5 | any |
/// | q6 | -90 deg | 0 | d6 | q6 + 30 deg | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GantryWrist;
impl ::core::default::Default for GantryWrist {
    fn default() -> Self {
        GantryWrist
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl GantryWrist {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::prismatic("q1"),
        ::dh_robot::Joint::prismatic("q2"),
        ::dh_robot::Joint::prismatic("q3"),
        ::dh_robot::Joint::revolute("q4"),
        ::dh_robot::Joint::revolute("q5"),
        ::dh_robot::Joint::revolute("q6"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 18 multiplications, 9 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5] + 0.5235987755982988, q[4], q[3]];
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.2 * s5;
        let t_2 = c6_30 * c5;
        let t_3 = s6_30 * c5;
        ::dh_robot::pose::from_entries(
            [
                [s4 * t_2 + s6_30 * c4, -(s4 * t_3 - c6_30 * c4), -s5 * s4],
                [c6_30 * s5, -s6_30 * s5, c5],
                [c4 * t_2 - s6_30 * s4, -(c4 * t_3 + c6_30 * s4), -s5 * c4],
            ],
            [-(t * s4 - q[1]), 0.2 * c5 + 0.1 + q[2], -(t * c4 - q[0])],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 17 multiplications, 9 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[3], q[4], q[5] + 0.5235987755982988];
        let ([s4, s5, s6_30], [c4, c5, c6_30]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = q[2] + 0.1;
        let s4c5 = s4 * c5;
        let c4c5 = c4 * c5;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]],
                [q[1], 0.0, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
                [q[1], q[2], q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[s4, c4, 0.0], [0.0, 0.0, 1.0], [c4, -s4, 0.0]],
                [q[1], t, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[s4c5, -s4s5, -c4], [s5, c5, 0.0], [c4c5, -c4s5, s4]],
                [q[1], t, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [s4c5 * c6_30 + c4 * s6_30, c4 * c6_30 - s4c5 * s6_30, -s4s5],
                    [s5 * c6_30, -s5 * s6_30, c5],
                    [c4c5 * c6_30 - s4 * s6_30, -(s4 * c6_30 + c4c5 * s6_30), -c4s5],
                ],
                [q[1] - s4s5 * 0.2, t + c5 * 0.2, q[0] - c4s5 * 0.2],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 8 multiplications, 0 additions, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[4], q[3]];
        let ([s5, s4], [c5, c4]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = s5 * 0.2;
        let t_2 = c5 * 0.2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
                [-c4 * t, 0.0, s4 * t, 0.0, 1.0, 0.0],
                [-s4 * t_2, -t, -c4 * t_2, -c4, 0.0, s4],
                [0.0, 0.0, 0.0, -s5 * s4, c5, -s5 * c4],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 20 multiplications, 9 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[5] + 0.5235987755982988, q[4], q[3]];
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c6_30 * c5;
        let t_2 = s6_30 * c5;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_3 = s5 * 0.2;
        let t_4 = c5 * 0.2;
        let t_5 = c4 * t_3;
        let t_6 = s4 * t_3;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t * s4 + s6_30 * c4, -(s4 * t_2 - c6_30 * c4), -s5s4],
                    [c6_30 * s5, -s6_30 * s5, c5],
                    [t * c4 - s6_30 * s4, -(c4 * t_2 + c6_30 * s4), -s5c4],
                ],
                [-(t_6 - q[1]), t_4 + 0.1 + q[2], -(t_5 - q[0])],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
                    [-t_5, 0.0, t_6, 0.0, 1.0, 0.0],
                    [-s4 * t_4, -t_3, -c4 * t_4, -c4, 0.0, s4],
                    [0.0, 0.0, 0.0, -s5s4, c5, -s5c4],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for GantryWrist {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for GantryWrist {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        GantryWrist::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        GantryWrist::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for GantryWrist {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        GantryWrist::jacobian(self, q)
    }
}
