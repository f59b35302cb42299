// What `dh_robot!` makes of src/pieper.rs. Made by `cargo regen`; do not edit.

/// Six revolute joints of which the last three axes meet: all twists and lengths are open.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in m:
///
/// | joint | alpha | a | d | theta |
/// |---|---|---|---|---|
/// | 1 | 0 | 0 | 0 | q1 |
/// | 2 | alpha1 | a1 | d2 | q2 |
/// | 3 | alpha2 | a2 | d3 | q3 |
/// | 4 | alpha3 | a3 | d4 | q4 |
/// | 5 | alpha4 | 0 | 0 | q5 |
/// | 6 | alpha5 | 0 | 0 | q6 |
///
/// The pose in closed form has 662 terms; `dh notes` derives it step by step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pieper {
    /// `alpha1` in radians.
    pub alpha1: f64,
    /// `alpha2` in radians.
    pub alpha2: f64,
    /// `alpha3` in radians.
    pub alpha3: f64,
    /// `alpha4` in radians.
    pub alpha4: f64,
    /// `alpha5` in radians.
    pub alpha5: f64,
    /// `a1` in m.
    pub a1: f64,
    /// `a2` in m.
    pub a2: f64,
    /// `a3` in m.
    pub a3: f64,
    /// `d2` in m.
    pub d2: f64,
    /// `d3` in m.
    pub d3: f64,
    /// `d4` in m.
    pub d4: f64,
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Pieper {
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
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 100 multiplications, 51 additions, 11 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [
            q[5],
            self.alpha5,
            q[4],
            self.alpha4,
            q[3],
            self.alpha3,
            q[2],
            self.alpha2,
            q[1],
            self.alpha1,
            q[0],
        ];
        let (
            [s6,
            s_alpha5,
            s5,
            s_alpha4,
            s4,
            s_alpha3,
            s3,
            s_alpha2,
            s2,
            s_alpha1,
            s1,
            ],
            [c6,
            c_alpha5,
            c5,
            c_alpha4,
            c4,
            c_alpha3,
            c3,
            c_alpha2,
            c2,
            c_alpha1,
            c1,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s6 * c_alpha5;
        let t_3 = s6 * s_alpha5;
        let t_4 = c6 * c5 - t_2 * s5;
        let t_5 = c6 * s5 + t_2 * c5;
        let t_6 = t_5 * c_alpha4 - t_3 * s_alpha4;
        let t_7 = t_5 * s_alpha4 + t_3 * c_alpha4;
        let t_8 = t_4 * c4 - t_6 * s4;
        let t_9 = t_4 * s4 + t_6 * c4;
        let t_10 = t_9 * c_alpha3 - t_7 * s_alpha3;
        let t_11 = t_9 * s_alpha3 + t_7 * c_alpha3;
        let t_12 = t_8 * c3 - t_10 * s3;
        let t_13 = t_8 * s3 + t_10 * c3;
        let t_14 = t_13 * c_alpha2 - t_11 * s_alpha2;
        let t_15 = t_13 * s_alpha2 + t_11 * c_alpha2;
        let t_16 = t_12 * c2 - t_14 * s2;
        let t_17 = t_12 * s2 + t_14 * c2;
        let t_18 = t_17 * c_alpha1 - t_15 * s_alpha1;
        let t_19 = t_17 * s_alpha1 + t_15 * c_alpha1;
        let t_20 = t_16 * c1 - t_18 * s1;
        let t_21 = t_16 * s1 + t_18 * c1;
        let t_22 = s_alpha5 * s5;
        let t_23 = s_alpha5 * c5;
        let t_24 = c_alpha4 * t_23 + c_alpha5 * s_alpha4;
        let t_25 = s_alpha4 * t_23 - c_alpha5 * c_alpha4;
        let t_26 = c4 * t_22 + s4 * t_24;
        let t_27 = s4 * t_22 - c4 * t_24;
        let t_28 = c_alpha3 * t_27 + s_alpha3 * t_25;
        let t_29 = s_alpha3 * t_27 - c_alpha3 * t_25;
        let t_30 = c3 * t_26 - s3 * t_28;
        let t_31 = s3 * t_26 + c3 * t_28;
        let t_32 = c_alpha2 * t_31 - s_alpha2 * t_29;
        let t_33 = s_alpha2 * t_31 + c_alpha2 * t_29;
        let t_34 = c2 * t_30 - s2 * t_32;
        let t_35 = s2 * t_30 + c2 * t_32;
        let t_36 = c_alpha1 * t_35 - s_alpha1 * t_33;
        let t_37 = s_alpha1 * t_35 + c_alpha1 * t_33;
        let t_38 = c1 * t_34 - s1 * t_36;
        let t_39 = s1 * t_34 + c1 * t_36;
        let t_40 = s_alpha3 * self.d4;
        let t_41 = c_alpha3 * self.d4 + self.d3;
        let t_42 = s3 * self.a3 - c3 * t_40;
        let t_43 = self.a2 + c3 * self.a3 + s3 * t_40;
        let t_44 = c_alpha2 * t_42 - s_alpha2 * t_41;
        let t_45 = s_alpha2 * t_42 + c_alpha2 * t_41 + self.d2;
        let t_46 = s2 * t_43 + c2 * t_44;
        let t_47 = self.a1 + c2 * t_43 - s2 * t_44;
        let t_48 = c_alpha1 * t_46 - s_alpha1 * t_45;
        ::dh_robot::pose::from_entries(
            [
                [t_20, t_19 * t_39 - t_21 * t_37, t_38],
                [t_21, t_20 * t_37 - t_19 * t_38, t_39],
                [t_19, t_21 * t_38 - t_20 * t_39, t_37],
            ],
            [
                c1 * t_47 - s1 * t_48,
                s1 * t_47 + c1 * t_48,
                s_alpha1 * t_46 + c_alpha1 * t_45,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 127 multiplications, 66 additions, 11 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [
            q[0],
            self.alpha1,
            q[1],
            self.alpha2,
            q[2],
            self.alpha3,
            q[3],
            self.alpha4,
            q[4],
            self.alpha5,
            q[5],
        ];
        let (
            [s1,
            s_alpha1,
            s2,
            s_alpha2,
            s3,
            s_alpha3,
            s4,
            s_alpha4,
            s5,
            s_alpha5,
            s6,
            ],
            [c1,
            c_alpha1,
            c2,
            c_alpha2,
            c3,
            c_alpha3,
            c4,
            c_alpha4,
            c5,
            c_alpha5,
            c6,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s1 * c_alpha1;
        let t_3 = c1 * c_alpha1;
        let t_4 = s1 * s_alpha1;
        let t_5 = c1 * s_alpha1;
        let t_6 = c_alpha1 * self.d2;
        let t_7 = c1 * self.a1 + t_4 * self.d2;
        let t_8 = s1 * self.a1 - t_5 * self.d2;
        let t_9 = s_alpha1 * s2;
        let t_10 = c1 * c2 - t_2 * s2;
        let t_11 = s1 * c2 + t_3 * s2;
        let t_12 = s_alpha1 * c2;
        let t_13 = t_2 * c2 + c1 * s2;
        let t_14 = t_3 * c2 - s1 * s2;
        let t_15 = t_13 * c_alpha2 - t_4 * s_alpha2;
        let t_16 = t_14 * c_alpha2 - t_5 * s_alpha2;
        let t_17 = t_12 * c_alpha2 + c_alpha1 * s_alpha2;
        let t_18 = t_4 * c_alpha2 + t_13 * s_alpha2;
        let t_19 = t_5 * c_alpha2 + t_14 * s_alpha2;
        let t_20 = c_alpha1 * c_alpha2 - t_12 * s_alpha2;
        let t_21 = t_7 + t_10 * self.a2 + t_18 * self.d3;
        let t_22 = t_8 + t_11 * self.a2 - t_19 * self.d3;
        let t_23 = t_6 + t_9 * self.a2 + t_20 * self.d3;
        let t_24 = t_10 * c3 - t_15 * s3;
        let t_25 = t_11 * c3 + t_16 * s3;
        let t_26 = t_9 * c3 + t_17 * s3;
        let t_27 = t_15 * c3 + t_10 * s3;
        let t_28 = t_16 * c3 - t_11 * s3;
        let t_29 = t_17 * c3 - t_9 * s3;
        let t_30 = t_27 * c_alpha3 - t_18 * s_alpha3;
        let t_31 = t_28 * c_alpha3 - t_19 * s_alpha3;
        let t_32 = t_29 * c_alpha3 + t_20 * s_alpha3;
        let t_33 = t_18 * c_alpha3 + t_27 * s_alpha3;
        let t_34 = t_19 * c_alpha3 + t_28 * s_alpha3;
        let t_35 = t_20 * c_alpha3 - t_29 * s_alpha3;
        let t_36 = t_21 + t_24 * self.a3 + t_33 * self.d4;
        let t_37 = t_22 + t_25 * self.a3 - t_34 * self.d4;
        let t_38 = t_23 + t_26 * self.a3 + t_35 * self.d4;
        let t_39 = t_24 * c4 - t_30 * s4;
        let t_40 = t_25 * c4 + t_31 * s4;
        let t_41 = t_26 * c4 + t_32 * s4;
        let t_42 = t_30 * c4 + t_24 * s4;
        let t_43 = t_31 * c4 - t_25 * s4;
        let t_44 = t_32 * c4 - t_26 * s4;
        let t_45 = t_42 * c_alpha4 - t_33 * s_alpha4;
        let t_46 = t_43 * c_alpha4 - t_34 * s_alpha4;
        let t_47 = t_44 * c_alpha4 + t_35 * s_alpha4;
        let t_48 = t_33 * c_alpha4 + t_42 * s_alpha4;
        let t_49 = t_34 * c_alpha4 + t_43 * s_alpha4;
        let t_50 = t_35 * c_alpha4 - t_44 * s_alpha4;
        let t_51 = t_39 * c5 - t_45 * s5;
        let t_52 = t_40 * c5 + t_46 * s5;
        let t_53 = t_41 * c5 + t_47 * s5;
        let t_54 = t_45 * c5 + t_39 * s5;
        let t_55 = t_46 * c5 - t_40 * s5;
        let t_56 = t_47 * c5 - t_41 * s5;
        let t_57 = t_54 * c_alpha5 - t_48 * s_alpha5;
        let t_58 = t_55 * c_alpha5 - t_49 * s_alpha5;
        let t_59 = t_56 * c_alpha5 + t_50 * s_alpha5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[t_10, -t_13, t_4], [t_11, t_14, -t_5], [t_9, t_12, c_alpha1]],
                [t_7, t_8, t_6],
            ),
            ::dh_robot::pose::from_entries(
                [[t_24, -t_27, t_18], [t_25, t_28, -t_19], [t_26, t_29, t_20]],
                [t_21, t_22, t_23],
            ),
            ::dh_robot::pose::from_entries(
                [[t_39, -t_42, t_33], [t_40, t_43, -t_34], [t_41, t_44, t_35]],
                [t_36, t_37, t_38],
            ),
            ::dh_robot::pose::from_entries(
                [[t_51, -t_54, t_48], [t_52, t_55, -t_49], [t_53, t_56, t_50]],
                [t_36, t_37, t_38],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [
                        t_51 * c6 - t_57 * s6,
                        -(t_57 * c6 + t_51 * s6),
                        t_48 * c_alpha5 + t_54 * s_alpha5,
                    ],
                    [
                        t_52 * c6 + t_58 * s6,
                        t_58 * c6 - t_52 * s6,
                        -(t_49 * c_alpha5 + t_55 * s_alpha5),
                    ],
                    [
                        t_53 * c6 + t_59 * s6,
                        t_59 * c6 - t_53 * s6,
                        t_50 * c_alpha5 - t_56 * s_alpha5,
                    ],
                ],
                [t_36, t_37, t_38],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 117 multiplications, 58 additions, 10 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [
            q[0],
            self.alpha1,
            q[1],
            self.alpha2,
            q[2],
            self.alpha3,
            q[3],
            self.alpha4,
            q[4],
            self.alpha5,
        ];
        let (
            [s1,
            s_alpha1,
            s2,
            s_alpha2,
            s3,
            s_alpha3,
            s4,
            s_alpha4,
            s5,
            s_alpha5,
            ],
            [c1,
            c_alpha1,
            c2,
            c_alpha2,
            c3,
            c_alpha3,
            c4,
            c_alpha4,
            c5,
            c_alpha5,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s1 * c_alpha1;
        let t_3 = c1 * c_alpha1;
        let t_4 = s1 * s_alpha1;
        let t_5 = c1 * s_alpha1;
        let t_6 = s_alpha1 * s2;
        let t_7 = c1 * c2 - t_2 * s2;
        let t_8 = s1 * c2 + t_3 * s2;
        let t_9 = s_alpha1 * c2;
        let t_10 = t_2 * c2 + c1 * s2;
        let t_11 = t_3 * c2 - s1 * s2;
        let t_12 = t_10 * c_alpha2 - t_4 * s_alpha2;
        let t_13 = t_11 * c_alpha2 - t_5 * s_alpha2;
        let t_14 = t_9 * c_alpha2 + c_alpha1 * s_alpha2;
        let t_15 = t_4 * c_alpha2 + t_10 * s_alpha2;
        let t_16 = t_5 * c_alpha2 + t_11 * s_alpha2;
        let t_17 = c_alpha1 * c_alpha2 - t_9 * s_alpha2;
        let t_18 = t_7 * c3 - t_12 * s3;
        let t_19 = t_8 * c3 + t_13 * s3;
        let t_20 = t_6 * c3 + t_14 * s3;
        let t_21 = t_12 * c3 + t_7 * s3;
        let t_22 = t_13 * c3 - t_8 * s3;
        let t_23 = t_14 * c3 - t_6 * s3;
        let t_24 = t_21 * c_alpha3 - t_15 * s_alpha3;
        let t_25 = t_22 * c_alpha3 - t_16 * s_alpha3;
        let t_26 = t_23 * c_alpha3 + t_17 * s_alpha3;
        let t_27 = t_15 * c_alpha3 + t_21 * s_alpha3;
        let t_28 = t_16 * c_alpha3 + t_22 * s_alpha3;
        let t_29 = t_17 * c_alpha3 - t_23 * s_alpha3;
        let t_30 = t_24 * c4 + t_18 * s4;
        let t_31 = t_25 * c4 - t_19 * s4;
        let t_32 = t_26 * c4 - t_20 * s4;
        let t_33 = t_27 * c_alpha4 + t_30 * s_alpha4;
        let t_34 = t_28 * c_alpha4 + t_31 * s_alpha4;
        let t_35 = t_29 * c_alpha4 - t_32 * s_alpha4;
        let t_36 = (t_30 * c_alpha4 - t_27 * s_alpha4) * c5
            + (t_18 * c4 - t_24 * s4) * s5;
        let t_37 = (t_31 * c_alpha4 - t_28 * s_alpha4) * c5
            - (t_19 * c4 + t_25 * s4) * s5;
        let t_38 = (t_32 * c_alpha4 + t_29 * s_alpha4) * c5
            - (t_20 * c4 + t_26 * s4) * s5;
        let t_39 = s_alpha3 * self.d4;
        let t_40 = c_alpha3 * self.d4 + self.d3;
        let t_41 = s3 * self.a3 - c3 * t_39;
        let t_42 = c3 * self.a3 + s3 * t_39 + self.a2;
        let t_43 = c_alpha2 * t_41 - s_alpha2 * t_40;
        let t_44 = c2 * t_42 - s2 * t_43;
        let t_45 = s2 * t_42 + c2 * t_43;
        let t_46 = t_44 + self.a1;
        let t_47 = c_alpha1 * t_45
            - s_alpha1 * (s_alpha2 * t_41 + c_alpha2 * t_40 + self.d2);
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(s1 * t_46 + c1 * t_47), c1 * t_46 - s1 * t_47, 0.0, 0.0, 0.0, 1.0],
                [
                    -(c1 * t_45 + t_2 * t_44),
                    -(s1 * t_45 - t_3 * t_44),
                    s_alpha1 * t_44,
                    t_4,
                    -t_5,
                    c_alpha1,
                ],
                [
                    t_18 * t_39 - t_21 * self.a3,
                    t_19 * t_39 + t_22 * self.a3,
                    t_20 * t_39 + t_23 * self.a3,
                    t_15,
                    -t_16,
                    t_17,
                ],
                [0.0, 0.0, 0.0, t_27, -t_28, t_29],
                [0.0, 0.0, 0.0, t_33, -t_34, t_35],
                [
                    0.0,
                    0.0,
                    0.0,
                    t_33 * c_alpha5 + t_36 * s_alpha5,
                    -(t_34 * c_alpha5 + t_37 * s_alpha5),
                    t_35 * c_alpha5 - t_38 * s_alpha5,
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 143 multiplications, 71 additions, 11 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [
            q[0],
            self.alpha1,
            q[1],
            self.alpha2,
            q[2],
            self.alpha3,
            q[3],
            self.alpha4,
            q[4],
            self.alpha5,
            q[5],
        ];
        let (
            [s1,
            s_alpha1,
            s2,
            s_alpha2,
            s3,
            s_alpha3,
            s4,
            s_alpha4,
            s5,
            s_alpha5,
            s6,
            ],
            [c1,
            c_alpha1,
            c2,
            c_alpha2,
            c3,
            c_alpha3,
            c4,
            c_alpha4,
            c5,
            c_alpha5,
            c6,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s1 * c_alpha1;
        let t_3 = c1 * c_alpha1;
        let t_4 = s1 * s_alpha1;
        let t_5 = c1 * s_alpha1;
        let t_6 = s_alpha1 * s2;
        let t_7 = c1 * c2 - t_2 * s2;
        let t_8 = s1 * c2 + t_3 * s2;
        let t_9 = s_alpha1 * c2;
        let t_10 = t_2 * c2 + c1 * s2;
        let t_11 = t_3 * c2 - s1 * s2;
        let t_12 = t_10 * c_alpha2 - t_4 * s_alpha2;
        let t_13 = t_11 * c_alpha2 - t_5 * s_alpha2;
        let t_14 = t_9 * c_alpha2 + c_alpha1 * s_alpha2;
        let t_15 = t_4 * c_alpha2 + t_10 * s_alpha2;
        let t_16 = t_5 * c_alpha2 + t_11 * s_alpha2;
        let t_17 = c_alpha1 * c_alpha2 - t_9 * s_alpha2;
        let t_18 = t_7 * c3 - t_12 * s3;
        let t_19 = t_8 * c3 + t_13 * s3;
        let t_20 = t_6 * c3 + t_14 * s3;
        let t_21 = t_12 * c3 + t_7 * s3;
        let t_22 = t_13 * c3 - t_8 * s3;
        let t_23 = t_14 * c3 - t_6 * s3;
        let t_24 = t_21 * c_alpha3 - t_15 * s_alpha3;
        let t_25 = t_22 * c_alpha3 - t_16 * s_alpha3;
        let t_26 = t_23 * c_alpha3 + t_17 * s_alpha3;
        let t_27 = t_15 * c_alpha3 + t_21 * s_alpha3;
        let t_28 = t_16 * c_alpha3 + t_22 * s_alpha3;
        let t_29 = t_17 * c_alpha3 - t_23 * s_alpha3;
        let t_30 = t_18 * c4 - t_24 * s4;
        let t_31 = t_19 * c4 + t_25 * s4;
        let t_32 = t_20 * c4 + t_26 * s4;
        let t_33 = t_24 * c4 + t_18 * s4;
        let t_34 = t_25 * c4 - t_19 * s4;
        let t_35 = t_26 * c4 - t_20 * s4;
        let t_36 = t_33 * c_alpha4 - t_27 * s_alpha4;
        let t_37 = t_34 * c_alpha4 - t_28 * s_alpha4;
        let t_38 = t_35 * c_alpha4 + t_29 * s_alpha4;
        let t_39 = t_27 * c_alpha4 + t_33 * s_alpha4;
        let t_40 = t_28 * c_alpha4 + t_34 * s_alpha4;
        let t_41 = t_29 * c_alpha4 - t_35 * s_alpha4;
        let t_42 = t_30 * c5 - t_36 * s5;
        let t_43 = t_31 * c5 + t_37 * s5;
        let t_44 = t_32 * c5 + t_38 * s5;
        let t_45 = t_36 * c5 + t_30 * s5;
        let t_46 = t_37 * c5 - t_31 * s5;
        let t_47 = t_38 * c5 - t_32 * s5;
        let t_48 = t_45 * c_alpha5 - t_39 * s_alpha5;
        let t_49 = t_46 * c_alpha5 - t_40 * s_alpha5;
        let t_50 = t_47 * c_alpha5 + t_41 * s_alpha5;
        let t_51 = t_39 * c_alpha5 + t_45 * s_alpha5;
        let t_52 = t_40 * c_alpha5 + t_46 * s_alpha5;
        let t_53 = t_41 * c_alpha5 - t_47 * s_alpha5;
        let t_54 = s_alpha3 * self.d4;
        let t_55 = c_alpha3 * self.d4 + self.d3;
        let t_56 = s3 * self.a3 - c3 * t_54;
        let t_57 = c3 * self.a3 + s3 * t_54 + self.a2;
        let t_58 = c_alpha2 * t_56 - s_alpha2 * t_55;
        let t_59 = s_alpha2 * t_56 + c_alpha2 * t_55 + self.d2;
        let t_60 = c2 * t_57 - s2 * t_58;
        let t_61 = s2 * t_57 + c2 * t_58;
        let t_62 = t_60 + self.a1;
        let t_63 = c_alpha1 * t_61 - s_alpha1 * t_59;
        let t_64 = c1 * t_62 - s1 * t_63;
        let t_65 = s1 * t_62 + c1 * t_63;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_42 * c6 - t_48 * s6, -(t_48 * c6 + t_42 * s6), t_51],
                    [t_43 * c6 + t_49 * s6, t_49 * c6 - t_43 * s6, -t_52],
                    [t_44 * c6 + t_50 * s6, t_50 * c6 - t_44 * s6, t_53],
                ],
                [t_64, t_65, s_alpha1 * t_61 + c_alpha1 * t_59],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_65, t_64, 0.0, 0.0, 0.0, 1.0],
                    [
                        -(c1 * t_61 + t_2 * t_60),
                        -(s1 * t_61 - t_3 * t_60),
                        s_alpha1 * t_60,
                        t_4,
                        -t_5,
                        c_alpha1,
                    ],
                    [
                        t_18 * t_54 - t_21 * self.a3,
                        t_19 * t_54 + t_22 * self.a3,
                        t_20 * t_54 + t_23 * self.a3,
                        t_15,
                        -t_16,
                        t_17,
                    ],
                    [0.0, 0.0, 0.0, t_27, -t_28, t_29],
                    [0.0, 0.0, 0.0, t_39, -t_40, t_41],
                    [0.0, 0.0, 0.0, t_51, -t_52, t_53],
                ]),
            ),
        )
    }
    /// [`forward`](Self::forward) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn forward_batch(
        &self,
        q: &[[f64; 6]],
        poses: &mut [::dh_robot::nalgebra::IsometryMatrix3<f64>],
    ) {
        for (q, to) in q.iter().zip(poses) {
            *to = self.forward(q);
        }
    }
    /// [`jacobian`](Self::jacobian) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn jacobian_batch(
        &self,
        q: &[[f64; 6]],
        jacobians: &mut [::dh_robot::nalgebra::SMatrix<f64, 6, 6>],
    ) {
        for (q, to) in q.iter().zip(jacobians) {
            *to = self.jacobian(q);
        }
    }
    /// [`jacobian`](Self::jacobian) in the axes of the last frame (or tool) instead of the base; the point is the same.
    #[inline]
    #[must_use]
    pub fn jacobian_in_tool(
        &self,
        q: &[f64; 6],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let (pose, jacobian) = self.forward_and_jacobian(q);
        ::dh_robot::velocity::in_axes_of(&pose, &jacobian)
    }
    /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.
    #[inline]
    #[must_use]
    pub fn jacobian_dot(
        &self,
        q: &[f64; 6],
        speeds: &[f64; 6],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        ::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)
    }
    /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn manipulability(&self, q: &[f64; 6]) -> f64 {
        ::dh_robot::velocity::manipulability(&self.jacobian(q))
    }
    /// The smallest singular value of the Jacobian, in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn smallest_singular_value(&self, q: &[f64; 6]) -> f64 {
        ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))
    }
    /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and
    /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).
    #[inline]
    #[must_use]
    pub fn solve_velocity(
        &self,
        q: &[f64; 6],
        twist: &::dh_robot::nalgebra::Vector6<f64>,
    ) -> ::dh_robot::velocity::JointSpeeds<f64, 6> {
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 6.19664904810903)
    }
}
impl ::dh_robot::Robot<6, f64> for Pieper {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Pieper {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Pieper::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Pieper::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Pieper {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Pieper::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        Pieper::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Pieper {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 6.19664904810903;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`, `q3`: two equations in two angles (Pieper's method) (two equations, each linear in the sine and cosine of either angle).
    /// 2. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 3. `q5`: an equation in sine and cosine (a cos + b sin = c, two values).
    /// 4. `q4`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 5. `q6`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        self.inverse_with_work(target).0
    }
    /// The solution that continues from the joint values `q`: the one of least travel, and on a self-motion (at a singular pose) the
    /// point of it nearest to `q`. Angles are shifted by whole turns towards `q`, within the ranges where that is possible; a solution out
    /// of range is given only if none is in range, or if it continues from `q` within 0.2 rad.
    ///
    /// # Errors
    /// The reason why no joint values reach the target.
    pub fn inverse_near(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        let unknowns = self.unknowns(&q.map(f64::from));
        ::dh_robot::runtime::solve_near::<
            _,
            6,
            8,
        >(
            self,
            setting,
            &task,
            &frame,
            Self::MAX_WORK,
            q,
            unknowns,
            |frame, sample, found| self.candidates(frame, sample, found),
        )
    }
    /// The same as [`inverse`](Self::inverse) by a thorough search, at special poses without a bound on its time: from many starts, at
    /// neighbouring poses and along self-motions. To compare with.
    #[must_use]
    pub fn inverse_exhaustive(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, sample, found| self.candidates(frame, sample, found),
        )
    }
    /// [`inverse`](Self::inverse) of every target: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn inverse_batch(
        &self,
        targets: &[::dh_robot::nalgebra::IsometryMatrix3<f64>],
        solutions: &mut [::dh_robot::Solutions<f64, 6, 8>],
    ) {
        for (target, to) in targets.iter().zip(solutions) {
            *to = self.inverse(target);
        }
    }
    /// [`inverse_near`](Self::inverse_near) of every target, from the joint values `q` of the same place: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn inverse_near_batch(
        &self,
        targets: &[::dh_robot::nalgebra::IsometryMatrix3<f64>],
        q: &[[f64; 6]],
        solutions: &mut [::core::result::Result<
            ::dh_robot::Solution<f64, 6>,
            ::dh_robot::Why<f64>,
        >],
    ) {
        for ((target, q), to) in targets.iter().zip(q).zip(solutions) {
            *to = self.inverse_near(target, q);
        }
    }
    /// [`inverse`](Self::inverse) of the nearest pose whose matrix is a rotation, and by how much the target's was off (the largest entry
    /// of `R^T R - 1`): for targets whose entries are off by up to 1e-3, such as those with three to five decimals.
    #[must_use]
    pub fn inverse_nearest_rotation(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> (::dh_robot::Solutions<f64, 6, 8>, f64) {
        match ::dh_robot::pose::nearest_rotation(target) {
            ::core::result::Result::Ok((target, deviation)) => {
                (self.inverse(&target), deviation)
            }
            ::core::result::Result::Err(why) => {
                (
                    ::dh_robot::Solutions::none(&Self::JOINTS, why),
                    ::dh_robot::pose::rotation_deviation(target.rotation.matrix()),
                )
            }
        }
    }
    /// The direction in which the arm can move at a solution with free joints while its target stays reached: joint speeds, the largest of
    /// them 1 (or the arm's size, for a length). `None` at an isolated solution.
    #[must_use]
    pub fn self_motion(
        &self,
        solution: &::dh_robot::Solution<f64, 6>,
    ) -> ::core::option::Option<[f64; 6]> {
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: false,
            given: [
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
            ],
        };
        ::dh_robot::runtime::self_motion(
            self,
            setting,
            |t| ::dh_robot::runtime::TaskTarget::Pose(*t),
            solution,
        )
    }
    /// The plan's unknowns at joint values.
    fn unknowns(&self, q: &[f64; 6]) -> [f64; 8] {
        [q[0], q[1], q[4], q[3], q[5], 0.0, 0.0, 0.0]
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        sample: &::dh_robot::runtime::Sample,
        found: &mut dyn FnMut([f64; 6], ::dh_robot::Branch, ::dh_robot::runtime::Path),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let path = ::dh_robot::runtime::Path::START;
        let angles = [self.alpha2, self.alpha3, self.alpha1, self.alpha4, self.alpha5];
        let (
            [s_alpha2,
            s_alpha3,
            s_alpha1,
            s_alpha4,
            s_alpha5,
            ],
            [c_alpha2,
            c_alpha3,
            c_alpha1,
            c_alpha4,
            c_alpha5,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
        let t_3 = self.d2 * Self::PER_LENGTH;
        let t_4 = self.d3 * Self::PER_LENGTH;
        let t_5 = self.d4 * Self::PER_LENGTH;
        let t_6 = t_3 + t_4 * c_alpha2 + c_alpha2 * t_5 * c_alpha3 - t[2][3] * c_alpha1;
        let t_7 = self.a3 * Self::PER_LENGTH;
        let t_8 = self.a1 * Self::PER_LENGTH;
        let t_9 = self.a2 * Self::PER_LENGTH;
        let t_10 = t_3 * (t_3 - c_alpha1 * t[2][3] * 2.0) + t_2 + t_8 * t_8 - t_9 * t_9
            - t_7 * t_7 - t_4 * t_4;
        let t_11 = 2.0 * t_9;
        let t_12 = 2.0 * t_8;
        let t_13 = t_3 * 2.0;
        let t_14 = t[2][3] * s_alpha1;
        let t_15 = s_alpha2 * c_alpha3;
        let t_16 = t_4 * s_alpha2;
        let t_17 = t[2][0] * s_alpha1;
        let t_18 = t[2][0] * c_alpha1;
        let t_19 = t[2][1] * s_alpha1;
        let t_20 = t[2][1] * c_alpha1;
        let t_21 = t[2][2] * s_alpha1;
        let t_22 = t[2][2] * c_alpha1;
        let t_23 = c_alpha4 * c_alpha5;
        let t_24 = s_alpha4 * c_alpha5;
        // Step 1: q1, q3 from two equations in two angles (Pieper's method).
        let q1_and_q3_roots = ::dh_robot::runtime::solve_bilinear_choosing(
            &[
                t_6,
                -s_alpha3 * s_alpha2 * t_5,
                s_alpha2 * t_7,
                t[1][3] * s_alpha1,
                0.0,
                0.0,
                -t[0][3] * s_alpha1,
                0.0,
                0.0,
            ],
            &[
                t_5 * (t_5 + c_alpha3 * t_4 * 2.0) - t_10,
                t_7 * t_11,
                s_alpha3 * t_5 * t_11,
                t[0][3] * t_12 - s_alpha1 * t[1][3] * t_13,
                0.0,
                0.0,
                t[1][3] * t_12 + s_alpha1 * t[0][3] * t_13,
                0.0,
                0.0,
            ],
            [sample.angle(0), sample.angle(1)],
            sample.tolerance,
        );
        if !q1_and_q3_roots.is_regular() {
            attempt
                .note(q1_and_q3_roots.outcome, &path, "q1, q3", Self::LENGTH_SCALE, "m");
        }
        let path = if q1_and_q3_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[0, 2]))
        } else {
            path
        };
        for (q1_and_q3_root, &[[c1, s1], [c3, s3]]) in q1_and_q3_roots.iter().enumerate()
        {
            let path = path.root(0, q1_and_q3_root);
            let q1 = ::dh_robot::runtime::atan2(s1, c1);
            let q3 = ::dh_robot::runtime::atan2(s3, c3);
            let t_25 = t[0][0] * c1 + t[1][0] * s1;
            let t_26 = t[0][0] * s1 - t[1][0] * c1;
            let t_27 = t[0][1] * c1 + t[1][1] * s1;
            let t_28 = t[0][1] * s1 - t[1][1] * c1;
            let t_29 = t[0][2] * c1 + t[1][2] * s1;
            let t_30 = t[0][2] * s1 - t[1][2] * c1;
            let t_31 = t_8 - (t[0][3] * c1 + t[1][3] * s1);
            let t_32 = c_alpha1 * (t[0][3] * s1 - t[1][3] * c1) - t_14;
            let t_33 = c_alpha1 * t_26 - t_17;
            let t_34 = s_alpha1 * t_26 + t_18;
            let t_35 = c_alpha1 * t_28 - t_19;
            let t_36 = s_alpha1 * t_28 + t_20;
            let t_37 = c_alpha1 * t_30 - t_21;
            let t_38 = s_alpha1 * t_30 + t_22;
            let t_39 = s_alpha2 * t_34;
            let t_40 = c_alpha2 * t_34;
            let t_41 = s_alpha2 * t_36;
            let t_42 = c_alpha2 * t_36;
            let t_43 = s_alpha2 * t_38;
            let t_44 = c_alpha2 * t_38;
            let t_45 = t_5 * (s_alpha3 * c_alpha2 * c3 + t_15)
                - (c_alpha2 * t_7 * s3 - t_16);
            // Step 2: q2 from sine and cosine.
            let q2_roots = ::dh_robot::runtime::solve_pair(
                t_31,
                t_32,
                -(t_9 + t_7 * c3 + s_alpha3 * t_5 * s3),
                t_32,
                -t_31,
                t_45,
                sample.tolerance,
            );
            if !q2_roots.is_regular() {
                attempt.note(q2_roots.outcome, &path, "q2", 1.0, "");
            }
            let path = if q2_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[1]))
            } else {
                path
            };
            for (q2_root, &[c2, s2]) in q2_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let q2 = ::dh_robot::runtime::atan2(s2, c2);
                let t_46 = t_25 * c2 - t_33 * s2;
                let t_47 = t_25 * s2 + t_33 * c2;
                let t_48 = t_27 * c2 - t_35 * s2;
                let t_49 = t_27 * s2 + t_35 * c2;
                let t_50 = t_29 * c2 - t_37 * s2;
                let t_51 = t_29 * s2 + t_37 * c2;
                let t_52 = c_alpha2 * t_47 - t_39;
                let t_53 = s_alpha2 * t_47 + t_40;
                let t_54 = c_alpha2 * t_49 - t_41;
                let t_55 = s_alpha2 * t_49 + t_42;
                let t_56 = c_alpha2 * t_51 - t_43;
                let t_57 = s_alpha2 * t_51 + t_44;
                let t_58 = c3 * t_46 - s3 * t_52;
                let t_59 = s3 * t_46 + c3 * t_52;
                let t_60 = c3 * t_48 - s3 * t_54;
                let t_61 = s3 * t_48 + c3 * t_54;
                let t_62 = c3 * t_50 - s3 * t_56;
                let t_63 = s3 * t_50 + c3 * t_56;
                let t_64 = c_alpha3 * t_63 - s_alpha3 * t_57;
                let t_65 = c_alpha3 * t_59 - s_alpha3 * t_53;
                let t_66 = c_alpha3 * t_61 - s_alpha3 * t_55;
                let t_67 = s_alpha4 * (s_alpha3 * t_59 + c_alpha3 * t_53);
                let t_68 = s_alpha4 * (s_alpha3 * t_61 + c_alpha3 * t_55);
                // Step 3: q5 from an equation in sine and cosine.
                let q5_roots = ::dh_robot::runtime::solve_sincos(
                    -s_alpha4 * s_alpha5,
                    0.0,
                    s_alpha3 * t_63 + c_alpha3 * t_57 - t_23,
                    sample.tolerance,
                );
                if !q5_roots.is_regular() {
                    attempt.note(q5_roots.outcome, &path, "wrist q5", 1.0, "");
                }
                if path.is_chosen() {
                    attempt
                        .see(
                            2,
                            &path,
                            [
                                -s_alpha4 * s_alpha5,
                                0.0,
                                s_alpha3 * t_63 + c_alpha3 * t_57 - t_23,
                            ],
                        );
                }
                let path = if q5_roots.is_free() {
                    attempt.choose(2, &path, ::dh_robot::FreeJoints::of(&[4]))
                } else {
                    path
                };
                for (q5_root, &[c5, s5]) in q5_roots
                    .or_if_free(sample.angle(2))
                    .iter()
                    .enumerate()
                {
                    let path = path.root(2, q5_root);
                    let q5 = ::dh_robot::runtime::atan2(s5, c5);
                    // Step 4: q4 from sine and cosine.
                    let q4_roots = ::dh_robot::runtime::solve_pair(
                        -t_62,
                        t_64,
                        -s_alpha5 * s5,
                        t_64,
                        t_62,
                        s_alpha5 * c_alpha4 * c5 + t_24,
                        sample.tolerance,
                    );
                    if !q4_roots.is_regular() {
                        attempt.note(q4_roots.outcome, &path, "q4", 1.0, "");
                    }
                    let path = if q4_roots.is_free() {
                        attempt.choose(3, &path, ::dh_robot::FreeJoints::of(&[3]))
                    } else {
                        path
                    };
                    for (q4_root, &[c4, s4]) in q4_roots
                        .or_if_free(sample.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let q4 = ::dh_robot::runtime::atan2(s4, c4);
                        let t_69 = c5 * (t_58 * c4 - t_65 * s4)
                            - s5 * (c_alpha4 * (t_58 * s4 + t_65 * c4) - t_67);
                        let t_70 = c5 * (t_60 * c4 - t_66 * s4)
                            - s5 * (c_alpha4 * (t_60 * s4 + t_66 * c4) - t_68);
                        // Step 5: q6 from sine and cosine.
                        let q6_roots = ::dh_robot::runtime::solve_pair(
                            1.0,
                            0.0,
                            t_69,
                            0.0,
                            -1.0,
                            t_70,
                            sample.tolerance,
                        );
                        if !q6_roots.is_regular() {
                            attempt.note(q6_roots.outcome, &path, "q6", 1.0, "");
                        }
                        let path = if q6_roots.is_free() {
                            attempt.choose(4, &path, ::dh_robot::FreeJoints::of(&[5]))
                        } else {
                            path
                        };
                        for (q6_root, &[c6, s6]) in q6_roots
                            .or_if_free(sample.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q6 = ::dh_robot::runtime::atan2(s6, c6);
                            let branch = ::dh_robot::Branch::ANY
                                .with_step(0, q1_and_q3_root)
                                .with_step(1, q5_root)
                                .with_wrist(
                                    if q5_root == 1 {
                                        ::dh_robot::Wrist::NoFlip
                                    } else {
                                        ::dh_robot::Wrist::Flip
                                    },
                                );
                            found([q1, q2, q3, q4, q5, q6], branch, path);
                        }
                    }
                }
            }
        }
        attempt
    }
    /// [`inverse`](Self::inverse) without its fast path: the plan root by root, with everything that special poses need; and how much was
    /// computed, which is never more than [`MAX_WORK`](Self::MAX_WORK).
    #[cold]
    #[inline(never)]
    #[must_use]
    pub fn inverse_with_work(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> (::dh_robot::Solutions<f64, 6, 8>, ::dh_robot::Work) {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return (
                    ::dh_robot::Solutions::none(&Self::JOINTS, why),
                    ::dh_robot::Work::NONE,
                );
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        ::dh_robot::runtime::solve_bounded(
            self,
            setting,
            &task,
            &frame,
            Self::MAX_WORK,
            |frame, sample, found| self.candidates(frame, sample, found),
        )
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for Pieper {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [
            q[5],
            self.alpha5,
            q[4],
            self.alpha4,
            q[3],
            self.alpha3,
            q[2],
            self.alpha2,
            q[1],
            self.alpha1,
            q[0],
        ];
        let (
            [s6,
            s_alpha5,
            s5,
            s_alpha4,
            s4,
            s_alpha3,
            s3,
            s_alpha2,
            s2,
            s_alpha1,
            s1,
            ],
            [c6,
            c_alpha5,
            c5,
            c_alpha4,
            c4,
            c_alpha3,
            c3,
            c_alpha2,
            c2,
            c_alpha1,
            c1,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s6 * c_alpha5;
        let t_3 = s6 * s_alpha5;
        let t_4 = c6 * c5 - t_2 * s5;
        let t_5 = c6 * s5 + t_2 * c5;
        let t_6 = t_5 * c_alpha4 - t_3 * s_alpha4;
        let t_7 = t_5 * s_alpha4 + t_3 * c_alpha4;
        let t_8 = t_4 * c4 - t_6 * s4;
        let t_9 = t_4 * s4 + t_6 * c4;
        let t_10 = t_9 * c_alpha3 - t_7 * s_alpha3;
        let t_11 = t_9 * s_alpha3 + t_7 * c_alpha3;
        let t_12 = t_8 * c3 - t_10 * s3;
        let t_13 = t_8 * s3 + t_10 * c3;
        let t_14 = t_13 * c_alpha2 - t_11 * s_alpha2;
        let t_15 = t_13 * s_alpha2 + t_11 * c_alpha2;
        let t_16 = t_12 * c2 - t_14 * s2;
        let t_17 = t_12 * s2 + t_14 * c2;
        let t_18 = t_17 * c_alpha1 - t_15 * s_alpha1;
        let t_19 = t_17 * s_alpha1 + t_15 * c_alpha1;
        let t_20 = t_16 * c1 - t_18 * s1;
        let t_21 = t_16 * s1 + t_18 * c1;
        let t_22 = s_alpha5 * s5;
        let t_23 = s_alpha5 * c5;
        let t_24 = c_alpha4 * t_23 + c_alpha5 * s_alpha4;
        let t_25 = s_alpha4 * t_23 - c_alpha5 * c_alpha4;
        let t_26 = c4 * t_22 + s4 * t_24;
        let t_27 = s4 * t_22 - c4 * t_24;
        let t_28 = c_alpha3 * t_27 + s_alpha3 * t_25;
        let t_29 = s_alpha3 * t_27 - c_alpha3 * t_25;
        let t_30 = c3 * t_26 - s3 * t_28;
        let t_31 = s3 * t_26 + c3 * t_28;
        let t_32 = c_alpha2 * t_31 - s_alpha2 * t_29;
        let t_33 = s_alpha2 * t_31 + c_alpha2 * t_29;
        let t_34 = c2 * t_30 - s2 * t_32;
        let t_35 = s2 * t_30 + c2 * t_32;
        let t_36 = c_alpha1 * t_35 - s_alpha1 * t_33;
        let t_37 = s_alpha1 * t_35 + c_alpha1 * t_33;
        let t_38 = c1 * t_34 - s1 * t_36;
        let t_39 = s1 * t_34 + c1 * t_36;
        let t_40 = s_alpha3 * self.d4;
        let t_41 = c_alpha3 * self.d4 + self.d3;
        let t_42 = s3 * self.a3 - c3 * t_40;
        let t_43 = self.a2 + c3 * self.a3 + s3 * t_40;
        let t_44 = c_alpha2 * t_42 - s_alpha2 * t_41;
        let t_45 = s_alpha2 * t_42 + c_alpha2 * t_41 + self.d2;
        let t_46 = s2 * t_43 + c2 * t_44;
        let t_47 = self.a1 + c2 * t_43 - s2 * t_44;
        let t_48 = c_alpha1 * t_46 - s_alpha1 * t_45;
        [
            [t_20, t_19 * t_39 - t_21 * t_37, t_38, c1 * t_47 - s1 * t_48],
            [t_21, t_20 * t_37 - t_19 * t_38, t_39, s1 * t_47 + c1 * t_48],
            [t_19, t_21 * t_38 - t_20 * t_39, t_37, s_alpha1 * t_46 + c_alpha1 * t_45],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [
            q[0],
            self.alpha1,
            q[1],
            self.alpha2,
            q[2],
            self.alpha3,
            q[3],
            self.alpha4,
            q[4],
            self.alpha5,
            q[5],
        ];
        let (
            [s1,
            s_alpha1,
            s2,
            s_alpha2,
            s3,
            s_alpha3,
            s4,
            s_alpha4,
            s5,
            s_alpha5,
            s6,
            ],
            [c1,
            c_alpha1,
            c2,
            c_alpha2,
            c3,
            c_alpha3,
            c4,
            c_alpha4,
            c5,
            c_alpha5,
            c6,
            ],
        ) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s1 * c_alpha1;
        let t_3 = c1 * c_alpha1;
        let t_4 = s1 * s_alpha1;
        let t_5 = c1 * s_alpha1;
        let t_6 = s_alpha1 * s2;
        let t_7 = c1 * c2 - t_2 * s2;
        let t_8 = s1 * c2 + t_3 * s2;
        let t_9 = s_alpha1 * c2;
        let t_10 = t_2 * c2 + c1 * s2;
        let t_11 = t_3 * c2 - s1 * s2;
        let t_12 = t_10 * c_alpha2 - t_4 * s_alpha2;
        let t_13 = t_11 * c_alpha2 - t_5 * s_alpha2;
        let t_14 = t_9 * c_alpha2 + c_alpha1 * s_alpha2;
        let t_15 = t_4 * c_alpha2 + t_10 * s_alpha2;
        let t_16 = t_5 * c_alpha2 + t_11 * s_alpha2;
        let t_17 = c_alpha1 * c_alpha2 - t_9 * s_alpha2;
        let t_18 = t_7 * c3 - t_12 * s3;
        let t_19 = t_8 * c3 + t_13 * s3;
        let t_20 = t_6 * c3 + t_14 * s3;
        let t_21 = t_12 * c3 + t_7 * s3;
        let t_22 = t_13 * c3 - t_8 * s3;
        let t_23 = t_14 * c3 - t_6 * s3;
        let t_24 = t_21 * c_alpha3 - t_15 * s_alpha3;
        let t_25 = t_22 * c_alpha3 - t_16 * s_alpha3;
        let t_26 = t_23 * c_alpha3 + t_17 * s_alpha3;
        let t_27 = t_15 * c_alpha3 + t_21 * s_alpha3;
        let t_28 = t_16 * c_alpha3 + t_22 * s_alpha3;
        let t_29 = t_17 * c_alpha3 - t_23 * s_alpha3;
        let t_30 = t_18 * c4 - t_24 * s4;
        let t_31 = t_19 * c4 + t_25 * s4;
        let t_32 = t_20 * c4 + t_26 * s4;
        let t_33 = t_24 * c4 + t_18 * s4;
        let t_34 = t_25 * c4 - t_19 * s4;
        let t_35 = t_26 * c4 - t_20 * s4;
        let t_36 = t_33 * c_alpha4 - t_27 * s_alpha4;
        let t_37 = t_34 * c_alpha4 - t_28 * s_alpha4;
        let t_38 = t_35 * c_alpha4 + t_29 * s_alpha4;
        let t_39 = t_27 * c_alpha4 + t_33 * s_alpha4;
        let t_40 = t_28 * c_alpha4 + t_34 * s_alpha4;
        let t_41 = t_29 * c_alpha4 - t_35 * s_alpha4;
        let t_42 = t_30 * c5 - t_36 * s5;
        let t_43 = t_31 * c5 + t_37 * s5;
        let t_44 = t_32 * c5 + t_38 * s5;
        let t_45 = t_36 * c5 + t_30 * s5;
        let t_46 = t_37 * c5 - t_31 * s5;
        let t_47 = t_38 * c5 - t_32 * s5;
        let t_48 = t_45 * c_alpha5 - t_39 * s_alpha5;
        let t_49 = t_46 * c_alpha5 - t_40 * s_alpha5;
        let t_50 = t_47 * c_alpha5 + t_41 * s_alpha5;
        let t_51 = t_39 * c_alpha5 + t_45 * s_alpha5;
        let t_52 = t_40 * c_alpha5 + t_46 * s_alpha5;
        let t_53 = t_41 * c_alpha5 - t_47 * s_alpha5;
        let t_54 = s_alpha3 * self.d4;
        let t_55 = c_alpha3 * self.d4 + self.d3;
        let t_56 = s3 * self.a3 - c3 * t_54;
        let t_57 = c3 * self.a3 + s3 * t_54 + self.a2;
        let t_58 = c_alpha2 * t_56 - s_alpha2 * t_55;
        let t_59 = s_alpha2 * t_56 + c_alpha2 * t_55 + self.d2;
        let t_60 = c2 * t_57 - s2 * t_58;
        let t_61 = s2 * t_57 + c2 * t_58;
        let t_62 = t_60 + self.a1;
        let t_63 = c_alpha1 * t_61 - s_alpha1 * t_59;
        let t_64 = c1 * t_62 - s1 * t_63;
        let t_65 = s1 * t_62 + c1 * t_63;
        (
            [
                [t_42 * c6 - t_48 * s6, -(t_48 * c6 + t_42 * s6), t_51, t_64],
                [t_43 * c6 + t_49 * s6, t_49 * c6 - t_43 * s6, -t_52, t_65],
                [
                    t_44 * c6 + t_50 * s6,
                    t_50 * c6 - t_44 * s6,
                    t_53,
                    s_alpha1 * t_61 + c_alpha1 * t_59,
                ],
            ],
            [
                [
                    -t_65,
                    -(c1 * t_61 + t_2 * t_60),
                    t_18 * t_54 - t_21 * self.a3,
                    0.0,
                    0.0,
                    0.0,
                ],
                [
                    t_64,
                    -(s1 * t_61 - t_3 * t_60),
                    t_19 * t_54 + t_22 * self.a3,
                    0.0,
                    0.0,
                    0.0,
                ],
                [0.0, s_alpha1 * t_60, t_20 * t_54 + t_23 * self.a3, 0.0, 0.0, 0.0],
                [0.0, t_4, t_15, t_27, t_39, t_51],
                [0.0, -t_5, -t_16, -t_28, -t_40, -t_52],
                [1.0, c_alpha1, t_17, t_29, t_41, t_53],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, f64> for Pieper {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 6, 8>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Pieper::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        Pieper::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Pieper {
    type Joints = ::dh_robot::runtime::Joints<6>;
}
