// What `dh_robot!` makes of src/cup_arm.rs. Made by `cargo regen`; do not edit.

/// The arm that grasps a cup, in millimetres, on its stand and with its gripper.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in mm:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | 0 | q1 | any |
/// | q2 | -90 deg | -a1 | 0 | q2 | any |
/// | q3 | 0 | a2 | 0 | q3 | any |
/// | q4 | -90 deg | -a3 | d4 | q4 | any |
/// | q5 | 90 deg | 0 | 0 | q5 | any |
/// | q6 | -90 deg | 0 | 0 | q6 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CupArm;
impl ::core::default::Default for CupArm {
    fn default() -> Self {
        CupArm
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl CupArm {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::revolute("q2"),
        ::dh_robot::Joint::revolute("q3"),
        ::dh_robot::Joint::revolute("q4"),
        ::dh_robot::Joint::revolute("q5"),
        ::dh_robot::Joint::revolute("q6"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in mm.
    ///
    /// Cost: 44 multiplications, 24 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[1], q[0]];
        let ([s6, s5, s4, s23, s2, s1], [c6, c5, c4, c23, c2, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 206.0 * s5;
        let t_2 = 206.0 * c5 + 338.0;
        let t_3 = t * s4;
        let t_4 = 40.0 + t * c4;
        let t_5 = 30.0 + t_4 * c23 + t_2 * s23 - 340.0 * c2;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_6 = c4 * c6c5 - s6 * s4;
        let t_7 = s4 * c6c5 + s6 * c4;
        let t_8 = c23 * t_6 - s23 * c6s5;
        let t_9 = s23 * t_6 + c23 * c6s5;
        let t_10 = c1 * t_8 + s1 * t_7;
        let t_11 = s1 * t_8 - c1 * t_7;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_12 = c23 * s5c4 + c5 * s23;
        let t_13 = s23 * s5c4 - c5 * c23;
        let t_14 = c1 * t_12 + s1 * s5s4;
        let t_15 = s1 * t_12 - c1 * s5s4;
        ::dh_robot::pose::from_entries(
            [
                [t_10, t_9 * t_15 - t_11 * t_13, -t_14],
                [t_11, t_10 * t_13 - t_9 * t_14, -t_15],
                [-t_9, -(t_11 * t_14 - t_10 * t_15), t_13],
            ],
            [
                -(t_5 * c1 + t_3 * s1),
                -(t_5 * s1 - t_3 * c1),
                t_4 * s23 - t_2 * c23 - 340.0 * s2 + 373.0,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 54 multiplications, 26 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[3], q[4], q[5]];
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c1 * 30.0;
        let t_2 = s1 * 30.0;
        let t_3 = c2 * 340.0;
        let t_4 = t - c1 * t_3;
        let t_5 = t_2 - s1 * t_3;
        let t_6 = 373.0 - s2 * 340.0;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let t_7 = t_4 + c1c23 * 40.0 + c1s23 * 338.0;
        let t_8 = t_5 + s1c23 * 40.0 + s1s23 * 338.0;
        let t_9 = t_6 + s23 * 40.0 - c23 * 338.0;
        let s23c4 = s23 * c4;
        let t_10 = c1c23 * c4 + s1 * s4;
        let t_11 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_12 = s1 * c4 - c1c23 * s4;
        let t_13 = c1 * c4 + s1c23 * s4;
        let t_14 = t_10 * c5 - c1s23 * s5;
        let t_15 = t_11 * c5 - s1s23 * s5;
        let t_16 = s23c4 * c5 + c23 * s5;
        let t_17 = c1s23 * c5 + t_10 * s5;
        let t_18 = s1s23 * c5 + t_11 * s5;
        let t_19 = c23 * c5 - s23c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 373.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, -s1], [s1 * c2, -s1 * s2, c1], [-s2, -c2, 0.0]],
                [-t, -t_2, 373.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c23, -c1s23, -s1], [s1c23, -s1s23, c1], [-s23, -c23, 0.0]],
                [-t_4, -t_5, t_6],
            ),
            ::dh_robot::pose::from_entries(
                [[t_10, t_12, -c1s23], [t_11, -t_13, -s1s23], [-s23c4, s23s4, -c23]],
                [-t_7, -t_8, t_9],
            ),
            ::dh_robot::pose::from_entries(
                [[t_14, -t_17, -t_12], [t_15, -t_18, t_13], [-t_16, -t_19, -s23s4]],
                [-t_7, -t_8, t_9],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_14 * c6 + t_12 * s6, t_12 * c6 - t_14 * s6, -t_17],
                    [t_15 * c6 - t_13 * s6, -(t_13 * c6 + t_15 * s6), -t_18],
                    [-(t_16 * c6 - s23s4 * s6), s23s4 * c6 + t_16 * s6, -t_19],
                ],
                [-t_7, -t_8, t_9],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (mm per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 49 multiplications, 22 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let s23c4 = s23 * c4;
        let t = c1c23 * c4 + s1 * s4;
        let t_2 = s1c23 * c4 - c1 * s4;
        let t_3 = s5 * 206.0;
        let t_4 = c5 * 206.0;
        let t_5 = t_4 + 338.0;
        let t_6 = c4 * t_3;
        let t_7 = s4 * t_3;
        let t_8 = t_6 + 40.0;
        let t_9 = c23 * t_8 + s23 * t_5;
        let t_10 = s23 * t_8 - c23 * t_5;
        let t_11 = t_9 - 340.0 * c2;
        let t_12 = t_10 - 340.0 * s2;
        let t_13 = t_11 + 30.0;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_13 - c1 * t_7, -(c1 * t_13 + s1 * t_7), 0.0, 0.0, 0.0, 1.0],
                [c1 * t_12, s1 * t_12, t_11, -s1, c1, 0.0],
                [c1 * t_10, s1 * t_10, t_9, -s1, c1, 0.0],
                [
                    c1c23 * t_7 - s1 * t_6,
                    s1c23 * t_7 + c1 * t_6,
                    -s23 * t_7,
                    -c1s23,
                    -s1s23,
                    -c23,
                ],
                [
                    -(t * t_4 - c1s23 * t_3),
                    -(t_2 * t_4 - s1s23 * t_3),
                    s23c4 * t_4 + c23 * t_3,
                    -(s1 * c4 - c1c23 * s4),
                    c1 * c4 + s1c23 * s4,
                    -s23 * s4,
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    -(c1s23 * c5 + t * s5),
                    -(s1s23 * c5 + t_2 * s5),
                    -(c23 * c5 - s23c4 * s5),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 67 multiplications, 32 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[5], q[1]];
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let s23c4 = s23 * c4;
        let t = c1c23 * c4 + s1 * s4;
        let t_2 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_3 = s1 * c4 - c1c23 * s4;
        let t_4 = c1 * c4 + s1c23 * s4;
        let t_5 = t * c5 - c1s23 * s5;
        let t_6 = t_2 * c5 - s1s23 * s5;
        let t_7 = s23c4 * c5 + c23 * s5;
        let t_8 = c1s23 * c5 + t * s5;
        let t_9 = s1s23 * c5 + t_2 * s5;
        let t_10 = c23 * c5 - s23c4 * s5;
        let t_11 = s5 * 206.0;
        let t_12 = c5 * 206.0;
        let t_13 = t_12 + 338.0;
        let t_14 = c4 * t_11;
        let t_15 = s4 * t_11;
        let t_16 = t_14 + 40.0;
        let t_17 = c23 * t_16 + s23 * t_13;
        let t_18 = s23 * t_16 - c23 * t_13;
        let t_19 = t_17 - 340.0 * c2;
        let t_20 = t_18 - 340.0 * s2;
        let t_21 = t_19 + 30.0;
        let t_22 = c1 * t_21 + s1 * t_15;
        let t_23 = s1 * t_21 - c1 * t_15;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_5 * c6 + t_3 * s6, t_3 * c6 - t_5 * s6, -t_8],
                    [t_6 * c6 - t_4 * s6, -(t_4 * c6 + t_6 * s6), -t_9],
                    [-(t_7 * c6 - s23s4 * s6), s23s4 * c6 + t_7 * s6, -t_10],
                ],
                [-t_22, -t_23, t_20 + 373.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_23, -t_22, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_20, s1 * t_20, t_19, -s1, c1, 0.0],
                    [c1 * t_18, s1 * t_18, t_17, -s1, c1, 0.0],
                    [
                        c1c23 * t_15 - s1 * t_14,
                        s1c23 * t_15 + c1 * t_14,
                        -s23 * t_15,
                        -c1s23,
                        -s1s23,
                        -c23,
                    ],
                    [
                        -(t * t_12 - c1s23 * t_11),
                        -(t_2 * t_12 - s1s23 * t_11),
                        s23c4 * t_12 + c23 * t_11,
                        -t_3,
                        t_4,
                        -s23s4,
                    ],
                    [0.0, 0.0, 0.0, -t_8, -t_9, -t_10],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for CupArm {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for CupArm {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        CupArm::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        CupArm::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for CupArm {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        CupArm::jacobian(self, q)
    }
}
