// What `dh_robot!` makes of src/panda.rs. Made by `cargo regen`; do not edit.

/// Franka Emika Panda; the caller chooses the last joint.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | d1 | q1 | -166.0 to 166.0 deg |
/// | q2 | -90 deg | 0 | 0 | q2 | -101.0 to 101.0 deg |
/// | q3 | 90 deg | 0 | d3 | q3 | -166.0 to 166.0 deg |
/// | q4 | 90 deg | a3 | 0 | q4 | -176.0 to -4.0 deg |
/// | q5 | -90 deg | -a3 | d5 | q5 | -166.0 to 166.0 deg |
/// | q6 | 90 deg | 0 | 0 | q6 | -1.0 to 215.0 deg |
/// | q7 | 90 deg | a6 | d7 | q7 | -166.0 to 166.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panda;
impl ::core::default::Default for Panda {
    fn default() -> Self {
        Panda
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Panda {
    /// Number of joints.
    pub const DOF: usize = 7;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 7] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.897246558310587, 2.897246558310587),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-1.7627825445142729, 1.7627825445142729),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-2.897246558310587, 2.897246558310587),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-3.07177948351002, -0.06981317007977318),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-2.897246558310587, 2.897246558310587),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-0.017453292519943295, 3.752457891787808),
        ::dh_robot::Joint::revolute("q7")
            .with_range(-2.897246558310587, 2.897246558310587),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 68 multiplications, 36 additions, 7 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[6], q[5], q[4], q[3], q[2], q[1], q[0]];
        let ([s7, s6, s5, s4, s3, s2, s1], [c7, c6, c5, c4, c3, c2, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.088 * c6 + 0.107 * s6;
        let t_2 = 0.088 * s6 - 0.107 * c6 + 0.384;
        let t_3 = t * s5;
        let t_4 = 0.0825 - t * c5;
        let t_5 = 0.0825 - (t_4 * c4 + t_2 * s4);
        let t_6 = t_4 * s4 - t_2 * c4 - 0.316;
        let t_7 = t_5 * c3 - t_3 * s3;
        let t_8 = t_5 * s3 + t_3 * c3;
        let t_9 = t_7 * c2 - t_6 * s2;
        let c7c6 = c7 * c6;
        let c7s6 = c7 * s6;
        let t_10 = c5 * c7c6 + s7 * s5;
        let t_11 = s5 * c7c6 - s7 * c5;
        let t_12 = c4 * t_10 - s4 * c7s6;
        let t_13 = s4 * t_10 + c4 * c7s6;
        let t_14 = c3 * t_12 - s3 * t_11;
        let t_15 = s3 * t_12 + c3 * t_11;
        let t_16 = c2 * t_14 + s2 * t_13;
        let t_17 = s2 * t_14 - c2 * t_13;
        let t_18 = c1 * t_16 - s1 * t_15;
        let t_19 = s1 * t_16 + c1 * t_15;
        let s6c5 = s6 * c5;
        let s6s5 = s6 * s5;
        let t_20 = c4 * s6c5 + c6 * s4;
        let t_21 = s4 * s6c5 - c6 * c4;
        let t_22 = c3 * t_20 - s3 * s6s5;
        let t_23 = s3 * t_20 + c3 * s6s5;
        let t_24 = c2 * t_22 + s2 * t_21;
        let t_25 = s2 * t_22 - c2 * t_21;
        let t_26 = c1 * t_24 - s1 * t_23;
        let t_27 = s1 * t_24 + c1 * t_23;
        ::dh_robot::pose::from_entries(
            [
                [t_18, -(t_17 * t_27 - t_19 * t_25), t_26],
                [t_19, -(t_18 * t_25 - t_17 * t_26), t_27],
                [-t_17, t_19 * t_26 - t_18 * t_27, -t_25],
            ],
            [t_9 * c1 - t_8 * s1, t_9 * s1 + t_8 * c1, -(t_7 * s2 + t_6 * c2 - 0.333)],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 80 multiplications, 44 additions, 7 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 7],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 7] {
        let angles = [q[0], q[1], q[2], q[3], q[4], q[5], q[6]];
        let ([s1, s2, s3, s4, s5, s6, s7], [c1, c2, c3, c4, c5, c6, c7]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let t = c1s2 * 0.316;
        let t_2 = s1s2 * 0.316;
        let t_3 = 0.333 + c2 * 0.316;
        let s2c3 = s2 * c3;
        let t_4 = c1c2 * c3 - s1 * s3;
        let t_5 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_6 = s1 * c3 + c1c2 * s3;
        let t_7 = c1 * c3 - s1c2 * s3;
        let t_8 = t + t_4 * 0.0825;
        let t_9 = t_2 + t_5 * 0.0825;
        let t_10 = t_3 - s2c3 * 0.0825;
        let t_11 = t_4 * c4 + c1s2 * s4;
        let t_12 = t_5 * c4 + s1s2 * s4;
        let t_13 = s2c3 * c4 - c2 * s4;
        let t_14 = c1s2 * c4 - t_4 * s4;
        let t_15 = s1s2 * c4 - t_5 * s4;
        let t_16 = c2 * c4 + s2c3 * s4;
        let t_17 = t_8 - 0.0825 * t_11 + t_14 * 0.384;
        let t_18 = t_9 - 0.0825 * t_12 + t_15 * 0.384;
        let t_19 = t_10 + 0.0825 * t_13 + t_16 * 0.384;
        let t_20 = t_11 * c5 - t_6 * s5;
        let t_21 = t_12 * c5 + t_7 * s5;
        let t_22 = t_13 * c5 - s2s3 * s5;
        let t_23 = t_6 * c5 + t_11 * s5;
        let t_24 = t_7 * c5 - t_12 * s5;
        let t_25 = s2s3 * c5 + t_13 * s5;
        let t_26 = t_20 * c6 + t_14 * s6;
        let t_27 = t_21 * c6 + t_15 * s6;
        let t_28 = t_22 * c6 - t_16 * s6;
        let t_29 = t_14 * c6 - t_20 * s6;
        let t_30 = t_15 * c6 - t_21 * s6;
        let t_31 = t_16 * c6 + t_22 * s6;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.333],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c2, -c1s2, -s1], [s1c2, -s1s2, c1], [-s2, -c2, 0.0]],
                [0.0, 0.0, 0.333],
            ),
            ::dh_robot::pose::from_entries(
                [[t_4, -t_6, c1s2], [t_5, t_7, s1s2], [-s2c3, s2s3, c2]],
                [t, t_2, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[t_11, t_14, t_6], [t_12, t_15, -t_7], [-t_13, t_16, -s2s3]],
                [t_8, t_9, t_10],
            ),
            ::dh_robot::pose::from_entries(
                [[t_20, -t_23, t_14], [t_21, t_24, t_15], [-t_22, t_25, t_16]],
                [t_17, t_18, t_19],
            ),
            ::dh_robot::pose::from_entries(
                [[t_26, t_29, t_23], [t_27, t_30, -t_24], [-t_28, t_31, -t_25]],
                [t_17, t_18, t_19],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_26 * c7 + t_23 * s7, t_23 * c7 - t_26 * s7, -t_29],
                    [t_27 * c7 - t_24 * s7, -(t_24 * c7 + t_27 * s7), -t_30],
                    [-(t_28 * c7 + t_25 * s7), -(t_25 * c7 - t_28 * s7), -t_31],
                ],
                [
                    t_17 + t_26 * 0.088 - t_29 * 0.107,
                    t_18 + t_27 * 0.088 - t_30 * 0.107,
                    t_19 - t_28 * 0.088 - t_31 * 0.107,
                ],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 91 multiplications, 44 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 7> {
        let angles = [q[0], q[1], q[2], q[3], q[4], q[5]];
        let ([s1, s2, s3, s4, s5, s6], [c1, c2, c3, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let s2c3 = s2 * c3;
        let t = c1c2 * c3 - s1 * s3;
        let t_2 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_3 = s1 * c3 + c1c2 * s3;
        let t_4 = c1 * c3 - s1c2 * s3;
        let t_5 = t * c4 + c1s2 * s4;
        let t_6 = t_2 * c4 + s1s2 * s4;
        let t_7 = s2c3 * c4 - c2 * s4;
        let t_8 = c1s2 * c4 - t * s4;
        let t_9 = s1s2 * c4 - t_2 * s4;
        let t_10 = c2 * c4 + s2c3 * s4;
        let t_11 = t_5 * c5 - t_3 * s5;
        let t_12 = t_6 * c5 + t_4 * s5;
        let t_13 = t_7 * c5 - s2s3 * s5;
        let t_14 = c6 * 0.088 + s6 * 0.107;
        let t_15 = s6 * 0.088 - c6 * 0.107;
        let t_16 = t_15 + 0.384;
        let t_17 = c5 * t_14;
        let t_18 = s5 * t_14;
        let t_19 = t_17 - 0.0825;
        let t_20 = c4 * t_19 - s4 * t_16;
        let t_21 = s4 * t_19 + c4 * t_16;
        let t_22 = 0.0825 + t_20;
        let t_23 = t_21 + 0.316;
        let t_24 = c3 * t_22 - s3 * t_18;
        let t_25 = s3 * t_22 + c3 * t_18;
        let t_26 = c2 * t_24 + s2 * t_23;
        let t_27 = s2 * t_24 - c2 * t_23;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(s1 * t_26 + c1 * t_25), c1 * t_26 - s1 * t_25, 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_27, -s1 * t_27, -t_26, -s1, c1, 0.0],
                [
                    -(c1c2 * t_25 + s1 * t_24),
                    -(s1c2 * t_25 - c1 * t_24),
                    s2 * t_25,
                    c1s2,
                    s1s2,
                    c2,
                ],
                [
                    -(t * t_21 - c1s2 * t_20),
                    -(t_2 * t_21 - s1s2 * t_20),
                    s2c3 * t_21 + c2 * t_20,
                    t_3,
                    -t_4,
                    -s2s3,
                ],
                [
                    -(t_5 * t_18 + t_3 * t_17),
                    -(t_6 * t_18 - t_4 * t_17),
                    t_7 * t_18 + s2s3 * t_17,
                    t_8,
                    t_9,
                    t_10,
                ],
                [
                    -(t_11 * t_15 - t_8 * t_14),
                    -(t_12 * t_15 - t_9 * t_14),
                    t_13 * t_15 + t_10 * t_14,
                    t_3 * c5 + t_5 * s5,
                    -(t_4 * c5 - t_6 * s5),
                    -(s2s3 * c5 + t_7 * s5),
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    -(t_8 * c6 - t_11 * s6),
                    -(t_9 * c6 - t_12 * s6),
                    -(t_10 * c6 + t_13 * s6),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 109 multiplications, 54 additions, 7 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 7],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 7>,
    ) {
        let angles = [q[0], q[1], q[2], q[3], q[4], q[5], q[6]];
        let ([s1, s2, s3, s4, s5, s6, s7], [c1, c2, c3, c4, c5, c6, c7]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let s2c3 = s2 * c3;
        let t = c1c2 * c3 - s1 * s3;
        let t_2 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_3 = s1 * c3 + c1c2 * s3;
        let t_4 = c1 * c3 - s1c2 * s3;
        let t_5 = t * c4 + c1s2 * s4;
        let t_6 = t_2 * c4 + s1s2 * s4;
        let t_7 = s2c3 * c4 - c2 * s4;
        let t_8 = c1s2 * c4 - t * s4;
        let t_9 = s1s2 * c4 - t_2 * s4;
        let t_10 = c2 * c4 + s2c3 * s4;
        let t_11 = t_5 * c5 - t_3 * s5;
        let t_12 = t_6 * c5 + t_4 * s5;
        let t_13 = t_7 * c5 - s2s3 * s5;
        let t_14 = t_3 * c5 + t_5 * s5;
        let t_15 = t_4 * c5 - t_6 * s5;
        let t_16 = s2s3 * c5 + t_7 * s5;
        let t_17 = t_11 * c6 + t_8 * s6;
        let t_18 = t_12 * c6 + t_9 * s6;
        let t_19 = t_13 * c6 - t_10 * s6;
        let t_20 = t_8 * c6 - t_11 * s6;
        let t_21 = t_9 * c6 - t_12 * s6;
        let t_22 = t_10 * c6 + t_13 * s6;
        let t_23 = c6 * 0.088 + s6 * 0.107;
        let t_24 = s6 * 0.088 - c6 * 0.107;
        let t_25 = t_24 + 0.384;
        let t_26 = c5 * t_23;
        let t_27 = s5 * t_23;
        let t_28 = t_26 - 0.0825;
        let t_29 = c4 * t_28 - s4 * t_25;
        let t_30 = s4 * t_28 + c4 * t_25;
        let t_31 = 0.0825 + t_29;
        let t_32 = t_30 + 0.316;
        let t_33 = c3 * t_31 - s3 * t_27;
        let t_34 = s3 * t_31 + c3 * t_27;
        let t_35 = c2 * t_33 + s2 * t_32;
        let t_36 = s2 * t_33 - c2 * t_32;
        let t_37 = c1 * t_35 - s1 * t_34;
        let t_38 = s1 * t_35 + c1 * t_34;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_17 * c7 + t_14 * s7, t_14 * c7 - t_17 * s7, -t_20],
                    [t_18 * c7 - t_15 * s7, -(t_15 * c7 + t_18 * s7), -t_21],
                    [-(t_19 * c7 + t_16 * s7), -(t_16 * c7 - t_19 * s7), -t_22],
                ],
                [t_37, t_38, -(t_36 - 0.333)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_38, t_37, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_36, -s1 * t_36, -t_35, -s1, c1, 0.0],
                    [
                        -(c1c2 * t_34 + s1 * t_33),
                        -(s1c2 * t_34 - c1 * t_33),
                        s2 * t_34,
                        c1s2,
                        s1s2,
                        c2,
                    ],
                    [
                        -(t * t_30 - c1s2 * t_29),
                        -(t_2 * t_30 - s1s2 * t_29),
                        s2c3 * t_30 + c2 * t_29,
                        t_3,
                        -t_4,
                        -s2s3,
                    ],
                    [
                        -(t_5 * t_27 + t_3 * t_26),
                        -(t_6 * t_27 - t_4 * t_26),
                        t_7 * t_27 + s2s3 * t_26,
                        t_8,
                        t_9,
                        t_10,
                    ],
                    [
                        -(t_11 * t_24 - t_8 * t_23),
                        -(t_12 * t_24 - t_9 * t_23),
                        t_13 * t_24 + t_10 * t_23,
                        t_14,
                        -t_15,
                        -t_16,
                    ],
                    [0.0, 0.0, 0.0, -t_20, -t_21, -t_22],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<7, f64> for Panda {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 7] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<7, f64> for Panda {
    #[inline]
    fn forward(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Panda::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 7]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 7] {
        Panda::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<7, f64> for Panda {
    #[inline]
    fn jacobian(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 7> {
        Panda::jacobian(self, q)
    }
}
