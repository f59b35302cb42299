// What `dh_robot!` makes of src/panda.rs. Made by `cargo regen`; do not edit.

/// Franka Emika Panda; the caller chooses the last joint.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | 1 | 0 | 0 | 333mm | q1 | -166deg..=166deg |
/// | 2 | -90deg | 0 | 0 | q2 | -101deg..=101deg |
/// | 3 | 90deg | 0 | 316mm | q3 | -166deg..=166deg |
/// | 4 | 90deg | 82.5mm | 0 | q4 | -176deg..=-4deg |
/// | 5 | -90deg | -82.5mm | 384mm | q5 | -166deg..=166deg |
/// | 6 | 90deg | 0 | 0 | q6 | -1deg..=215deg |
/// | 7 | 90deg | 88mm | 107mm | q7 | -166deg..=166deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁(c₂{c₃[c₄(c₅c₆c₇ + s₅s₇) − s₄s₆c₇] − s₃(s₅c₆c₇ − c₅s₇)} + s₂[s₄(c₅c₆c₇ + s₅s₇) + c₄s₆c₇])
///       − s₁{s₃[c₄(c₅c₆c₇ + s₅s₇) − s₄s₆c₇] + c₃(s₅c₆c₇ − c₅s₇)}
/// r₂₁ = s₁(c₂{c₃[c₄(c₅c₆c₇ + s₅s₇) − s₄s₆c₇] − s₃(s₅c₆c₇ − c₅s₇)} + s₂[s₄(c₅c₆c₇ + s₅s₇) + c₄s₆c₇])
///       + c₁{s₃[c₄(c₅c₆c₇ + s₅s₇) − s₄s₆c₇] + c₃(s₅c₆c₇ − c₅s₇)}
/// r₃₁ = −s₂{c₃[c₄(c₅c₆c₇ + s₅s₇) − s₄s₆c₇] − s₃(s₅c₆c₇ − c₅s₇)} + c₂[s₄(c₅c₆c₇ + s₅s₇) + c₄s₆c₇]
/// r₁₂ = −c₁(c₂{c₃[c₄(c₅c₆s₇ − s₅c₇) − s₄s₆s₇] − s₃(s₅c₆s₇ + c₅c₇)} + s₂[s₄(c₅c₆s₇ − s₅c₇) + c₄s₆s₇])
///       + s₁{s₃[c₄(c₅c₆s₇ − s₅c₇) − s₄s₆s₇] + c₃(s₅c₆s₇ + c₅c₇)}
/// r₂₂ = −s₁(c₂{c₃[c₄(c₅c₆s₇ − s₅c₇) − s₄s₆s₇] − s₃(s₅c₆s₇ + c₅c₇)} + s₂[s₄(c₅c₆s₇ − s₅c₇) + c₄s₆s₇])
///       − c₁{s₃[c₄(c₅c₆s₇ − s₅c₇) − s₄s₆s₇] + c₃(s₅c₆s₇ + c₅c₇)}
/// r₃₂ = s₂{c₃[c₄(c₅c₆s₇ − s₅c₇) − s₄s₆s₇] − s₃(s₅c₆s₇ + c₅c₇)} − c₂[s₄(c₅c₆s₇ − s₅c₇) + c₄s₆s₇]
/// r₁₃ = c₁{c₂[c₃(c₄c₅s₆ + s₄c₆) − s₃s₅s₆] + s₂(s₄c₅s₆ − c₄c₆)} − s₁[s₃(c₄c₅s₆ + s₄c₆) + c₃s₅s₆]
/// r₂₃ = s₁{c₂[c₃(c₄c₅s₆ + s₄c₆) − s₃s₅s₆] + s₂(s₄c₅s₆ − c₄c₆)} + c₁[s₃(c₄c₅s₆ + s₄c₆) + c₃s₅s₆]
/// r₃₃ = −s₂[c₃(c₄c₅s₆ + s₄c₆) − s₃s₅s₆] + c₂(s₄c₅s₆ − c₄c₆)
/// px  = c₁[c₂(c₃{a₃ − c₄[a₃ − c₅(a₆c₆ + d₇s₆)] − s₄(d₅ + a₆s₆ − d₇c₆)} − s₃s₅(a₆c₆ + d₇s₆))
///       + s₂{d₃ − s₄[a₃ − c₅(a₆c₆ + d₇s₆)] + c₄(d₅ + a₆s₆ − d₇c₆)}]
///       − s₁(s₃{a₃ − c₄[a₃ − c₅(a₆c₆ + d₇s₆)] − s₄(d₅ + a₆s₆ − d₇c₆)} + c₃s₅(a₆c₆ + d₇s₆))
/// py  = s₁[c₂(c₃{a₃ − c₄[a₃ − c₅(a₆c₆ + d₇s₆)] − s₄(d₅ + a₆s₆ − d₇c₆)} − s₃s₅(a₆c₆ + d₇s₆))
///       + s₂{d₃ − s₄[a₃ − c₅(a₆c₆ + d₇s₆)] + c₄(d₅ + a₆s₆ − d₇c₆)}]
///       + c₁(s₃{a₃ − c₄[a₃ − c₅(a₆c₆ + d₇s₆)] − s₄(d₅ + a₆s₆ − d₇c₆)} + c₃s₅(a₆c₆ + d₇s₆))
/// pz  = d₁ − s₂(c₃{a₃ − c₄[a₃ − c₅(a₆c₆ + d₇s₆)] − s₄(d₅ + a₆s₆ − d₇c₆)} − s₃s₅(a₆c₆ + d₇s₆))
///       + c₂{d₃ − s₄[a₃ − c₅(a₆c₆ + d₇s₆)] + c₄(d₅ + a₆s₆ − d₇c₆)}
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, …, 7; d₁ = 0.333, d₃ = 0.316, a₃ = 0.0825, d₅ = 0.384,
///      a₆ = 0.088, d₇ = 0.107
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panda;
impl ::core::default::Default for Panda {
    fn default() -> Self {
        Panda
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
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
    /// Cost: 68 multiplications, 36 additions, 7 sine-cosine pairs. Proven equal to the product of the link transforms; equation (14) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[6], q[5], q[4], q[3], q[2], q[1], q[0]];
        let ([s7, s6, s5, s4, s3, s2, s1], [c7, c6, c5, c4, c3, c2, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c7c6 = c7 * c6;
        let c7s6 = c7 * s6;
        let t_2 = c7c6 * c5 + s7 * s5;
        let t_3 = c7c6 * s5 - s7 * c5;
        let t_4 = t_2 * c4 - c7s6 * s4;
        let t_5 = t_2 * s4 + c7s6 * c4;
        let t_6 = t_4 * c3 - t_3 * s3;
        let t_7 = t_4 * s3 + t_3 * c3;
        let t_8 = t_6 * c2 + t_5 * s2;
        let t_9 = t_6 * s2 - t_5 * c2;
        let t_10 = t_8 * c1 - t_7 * s1;
        let t_11 = t_8 * s1 + t_7 * c1;
        let s6c5 = s6 * c5;
        let s6s5 = s6 * s5;
        let t_12 = c4 * s6c5 + c6 * s4;
        let t_13 = s4 * s6c5 - c6 * c4;
        let t_14 = c3 * t_12 - s3 * s6s5;
        let t_15 = s3 * t_12 + c3 * s6s5;
        let t_16 = c2 * t_14 + s2 * t_13;
        let t_17 = s2 * t_14 - c2 * t_13;
        let t_18 = c1 * t_16 - s1 * t_15;
        let t_19 = s1 * t_16 + c1 * t_15;
        let t_20 = c6 * 0.088 + s6 * 0.107;
        let t_21 = s6 * 0.088 - c6 * 0.107 + 0.384;
        let t_22 = s5 * t_20;
        let t_23 = 0.0825 - c5 * t_20;
        let t_24 = 0.0825 - (c4 * t_23 + s4 * t_21);
        let t_25 = s4 * t_23 - c4 * t_21 - 0.316;
        let t_26 = c3 * t_24 - s3 * t_22;
        let t_27 = s3 * t_24 + c3 * t_22;
        let t_28 = c2 * t_26 - s2 * t_25;
        ::dh_robot::pose::from_entries(
            [
                [t_10, -(t_9 * t_19 - t_11 * t_17), t_18],
                [t_11, -(t_10 * t_17 - t_9 * t_18), t_19],
                [-t_9, t_11 * t_18 - t_10 * t_19, -t_17],
            ],
            [
                c1 * t_28 - s1 * t_27,
                s1 * t_28 + c1 * t_27,
                -(s2 * t_26 + c2 * t_25 - 0.333),
            ],
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
        let ([s1, s2, s3, s4, s5, s6, s7], [c1, c2, c3, c4, c5, c6, c7]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let t_2 = c1s2 * 0.316;
        let t_3 = s1s2 * 0.316;
        let t_4 = 0.333 + c2 * 0.316;
        let s2c3 = s2 * c3;
        let t_5 = c1c2 * c3 - s1 * s3;
        let t_6 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_7 = s1 * c3 + c1c2 * s3;
        let t_8 = c1 * c3 - s1c2 * s3;
        let t_9 = t_2 + t_5 * 0.0825;
        let t_10 = t_3 + t_6 * 0.0825;
        let t_11 = t_4 - s2c3 * 0.0825;
        let t_12 = t_5 * c4 + c1s2 * s4;
        let t_13 = t_6 * c4 + s1s2 * s4;
        let t_14 = s2c3 * c4 - c2 * s4;
        let t_15 = c1s2 * c4 - t_5 * s4;
        let t_16 = s1s2 * c4 - t_6 * s4;
        let t_17 = c2 * c4 + s2c3 * s4;
        let t_18 = t_9 - 0.0825 * t_12 + t_15 * 0.384;
        let t_19 = t_10 - 0.0825 * t_13 + t_16 * 0.384;
        let t_20 = t_11 + 0.0825 * t_14 + t_17 * 0.384;
        let t_21 = t_12 * c5 - t_7 * s5;
        let t_22 = t_13 * c5 + t_8 * s5;
        let t_23 = t_14 * c5 - s2s3 * s5;
        let t_24 = t_7 * c5 + t_12 * s5;
        let t_25 = t_8 * c5 - t_13 * s5;
        let t_26 = s2s3 * c5 + t_14 * s5;
        let t_27 = t_21 * c6 + t_15 * s6;
        let t_28 = t_22 * c6 + t_16 * s6;
        let t_29 = t_23 * c6 - t_17 * s6;
        let t_30 = t_15 * c6 - t_21 * s6;
        let t_31 = t_16 * c6 - t_22 * s6;
        let t_32 = t_17 * c6 + t_23 * s6;
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
                [[t_5, -t_7, c1s2], [t_6, t_8, s1s2], [-s2c3, s2s3, c2]],
                [t_2, t_3, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [[t_12, t_15, t_7], [t_13, t_16, -t_8], [-t_14, t_17, -s2s3]],
                [t_9, t_10, t_11],
            ),
            ::dh_robot::pose::from_entries(
                [[t_21, -t_24, t_15], [t_22, t_25, t_16], [-t_23, t_26, t_17]],
                [t_18, t_19, t_20],
            ),
            ::dh_robot::pose::from_entries(
                [[t_27, t_30, t_24], [t_28, t_31, -t_25], [-t_29, t_32, -t_26]],
                [t_18, t_19, t_20],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_27 * c7 + t_24 * s7, t_24 * c7 - t_27 * s7, -t_30],
                    [t_28 * c7 - t_25 * s7, -(t_25 * c7 + t_28 * s7), -t_31],
                    [-(t_29 * c7 + t_26 * s7), -(t_26 * c7 - t_29 * s7), -t_32],
                ],
                [
                    t_18 + t_27 * 0.088 - t_30 * 0.107,
                    t_19 + t_28 * 0.088 - t_31 * 0.107,
                    t_20 - t_29 * 0.088 - t_32 * 0.107,
                ],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (15) of the robot's notes.
    ///
    /// Cost: 94 multiplications, 44 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 7]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 7> {
        let angles = [q[0], q[1], q[2], q[3], q[4], q[5]];
        let ([s1, s2, s3, s4, s5, s6], [c1, c2, c3, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let s2c3 = s2 * c3;
        let t_2 = c1c2 * c3 - s1 * s3;
        let t_3 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_4 = s1 * c3 + c1c2 * s3;
        let t_5 = c1 * c3 - s1c2 * s3;
        let t_6 = t_2 * c4 + c1s2 * s4;
        let t_7 = t_3 * c4 + s1s2 * s4;
        let t_8 = s2c3 * c4 - c2 * s4;
        let t_9 = c1s2 * c4 - t_2 * s4;
        let t_10 = s1s2 * c4 - t_3 * s4;
        let t_11 = c2 * c4 + s2c3 * s4;
        let t_12 = t_6 * c5 - t_4 * s5;
        let t_13 = t_7 * c5 + t_5 * s5;
        let t_14 = t_8 * c5 - s2s3 * s5;
        let t_15 = t_4 * c5 + t_6 * s5;
        let t_16 = t_5 * c5 - t_7 * s5;
        let t_17 = s2s3 * c5 + t_8 * s5;
        let t_18 = t_9 * c6 - t_12 * s6;
        let t_19 = t_10 * c6 - t_13 * s6;
        let t_20 = t_11 * c6 + t_14 * s6;
        let t_21 = c6 * 0.088 + s6 * 0.107;
        let t_22 = s6 * 0.088 - c6 * 0.107 + 0.384;
        let t_23 = s5 * t_21;
        let t_24 = c5 * t_21 - 0.0825;
        let t_25 = 0.0825 + c4 * t_24 - s4 * t_22;
        let t_26 = s4 * t_24 + c4 * t_22 + 0.316;
        let t_27 = c3 * t_25 - s3 * t_23;
        let t_28 = s3 * t_25 + c3 * t_23;
        let t_29 = c2 * t_27 + s2 * t_26;
        let t_30 = s2 * t_27 - c2 * t_26;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(s1 * t_29 + c1 * t_28), c1 * t_29 - s1 * t_28, 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_30, -s1 * t_30, -t_29, -s1, c1, 0.0],
                [
                    -(c1c2 * t_28 + s1 * t_27),
                    -(s1c2 * t_28 - c1 * t_27),
                    s2 * t_28,
                    c1s2,
                    s1s2,
                    c2,
                ],
                [
                    -(t_6 * t_22 - t_9 * t_24),
                    -(t_7 * t_22 - t_10 * t_24),
                    t_8 * t_22 + t_11 * t_24,
                    t_4,
                    -t_5,
                    -s2s3,
                ],
                [-t_15 * t_21, t_16 * t_21, t_17 * t_21, t_9, t_10, t_11],
                [
                    (t_12 * c6 + t_9 * s6) * 0.107 + t_18 * 0.088,
                    (t_13 * c6 + t_10 * s6) * 0.107 + t_19 * 0.088,
                    -((t_14 * c6 - t_11 * s6) * 0.107 - t_20 * 0.088),
                    t_15,
                    -t_16,
                    -t_17,
                ],
                [0.0, 0.0, 0.0, -t_18, -t_19, -t_20],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 106 multiplications, 51 additions, 7 sine-cosine pairs.
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
        let ([s1, s2, s3, s4, s5, s6, s7], [c1, c2, c3, c4, c5, c6, c7]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let s2c3 = s2 * c3;
        let t_2 = c1c2 * c3 - s1 * s3;
        let t_3 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_4 = s1 * c3 + c1c2 * s3;
        let t_5 = c1 * c3 - s1c2 * s3;
        let t_6 = t_2 * c4 + c1s2 * s4;
        let t_7 = t_3 * c4 + s1s2 * s4;
        let t_8 = s2c3 * c4 - c2 * s4;
        let t_9 = c1s2 * c4 - t_2 * s4;
        let t_10 = s1s2 * c4 - t_3 * s4;
        let t_11 = c2 * c4 + s2c3 * s4;
        let t_12 = t_6 * c5 - t_4 * s5;
        let t_13 = t_7 * c5 + t_5 * s5;
        let t_14 = t_8 * c5 - s2s3 * s5;
        let t_15 = t_4 * c5 + t_6 * s5;
        let t_16 = t_5 * c5 - t_7 * s5;
        let t_17 = s2s3 * c5 + t_8 * s5;
        let t_18 = t_12 * c6 + t_9 * s6;
        let t_19 = t_13 * c6 + t_10 * s6;
        let t_20 = t_14 * c6 - t_11 * s6;
        let t_21 = t_9 * c6 - t_12 * s6;
        let t_22 = t_10 * c6 - t_13 * s6;
        let t_23 = t_11 * c6 + t_14 * s6;
        let t_24 = c6 * 0.088 + s6 * 0.107;
        let t_25 = s6 * 0.088 - c6 * 0.107 + 0.384;
        let t_26 = s5 * t_24;
        let t_27 = c5 * t_24 - 0.0825;
        let t_28 = 0.0825 + c4 * t_27 - s4 * t_25;
        let t_29 = s4 * t_27 + c4 * t_25 + 0.316;
        let t_30 = c3 * t_28 - s3 * t_26;
        let t_31 = s3 * t_28 + c3 * t_26;
        let t_32 = c2 * t_30 + s2 * t_29;
        let t_33 = s2 * t_30 - c2 * t_29;
        let t_34 = c1 * t_32 - s1 * t_31;
        let t_35 = s1 * t_32 + c1 * t_31;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_18 * c7 + t_15 * s7, t_15 * c7 - t_18 * s7, -t_21],
                    [t_19 * c7 - t_16 * s7, -(t_16 * c7 + t_19 * s7), -t_22],
                    [-(t_20 * c7 + t_17 * s7), -(t_17 * c7 - t_20 * s7), -t_23],
                ],
                [t_34, t_35, -(t_33 - 0.333)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_35, t_34, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_33, -s1 * t_33, -t_32, -s1, c1, 0.0],
                    [
                        -(c1c2 * t_31 + s1 * t_30),
                        -(s1c2 * t_31 - c1 * t_30),
                        s2 * t_31,
                        c1s2,
                        s1s2,
                        c2,
                    ],
                    [
                        -(t_6 * t_25 - t_9 * t_27),
                        -(t_7 * t_25 - t_10 * t_27),
                        t_8 * t_25 + t_11 * t_27,
                        t_4,
                        -t_5,
                        -s2s3,
                    ],
                    [-t_15 * t_24, t_16 * t_24, t_17 * t_24, t_9, t_10, t_11],
                    [
                        t_18 * 0.107 + t_21 * 0.088,
                        t_19 * 0.107 + t_22 * 0.088,
                        -(t_20 * 0.107 - t_23 * 0.088),
                        t_15,
                        -t_16,
                        -t_17,
                    ],
                    [0.0, 0.0, 0.0, -t_21, -t_22, -t_23],
                ]),
            ),
        )
    }
    /// [`forward`](Self::forward) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn forward_batch(
        &self,
        q: &[[f64; 7]],
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
        q: &[[f64; 7]],
        jacobians: &mut [::dh_robot::nalgebra::SMatrix<f64, 6, 7>],
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
        q: &[f64; 7],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 7> {
        let (pose, jacobian) = self.forward_and_jacobian(q);
        ::dh_robot::velocity::in_axes_of(&pose, &jacobian)
    }
    /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.
    #[inline]
    #[must_use]
    pub fn jacobian_dot(
        &self,
        q: &[f64; 7],
        speeds: &[f64; 7],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 7> {
        ::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)
    }
    /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn manipulability(&self, q: &[f64; 7]) -> f64 {
        ::dh_robot::velocity::manipulability(&self.jacobian(q))
    }
    /// The smallest singular value of the Jacobian, in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn smallest_singular_value(&self, q: &[f64; 7]) -> f64 {
        ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))
    }
    /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and
    /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).
    #[inline]
    #[must_use]
    pub fn solve_velocity(
        &self,
        q: &[f64; 7],
        twist: &::dh_robot::nalgebra::Vector6<f64>,
    ) -> ::dh_robot::velocity::JointSpeeds<f64, 7> {
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 1.393)
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
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 7],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 7>,
    ) {
        Panda::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Panda {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 1.393;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q4`: the law of cosines (a cos + b sin = c, two values).
    /// 2. `q5`: an equation in sine and cosine (a cos + b sin = c, two values).
    /// 3. `q6`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 4. `q1`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 5. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 6. `q3`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
        given: f64,
    ) -> ::dh_robot::Solutions<f64, 7, 8> {
        if !given.is_finite() {
            return ::dh_robot::Solutions::none(
                &Self::JOINTS,
                ::dh_robot::Why::NotFinite,
            );
        }
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 8]; 7];
        let mut valid = [0.0; 8];
        if !self.all_branches(&frame, given.into(), &mut q, &mut valid) {
            return self.inverse_with_work(target, given).0;
        }
        if valid == [1.0; 8] {
            let at = |branch: usize| ::dh_robot::runtime::batched::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                branch,
            );
            return ::dh_robot::Solutions::full(
                &Self::JOINTS,
                [at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)],
            );
        }
        ::dh_robot::runtime::batched::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)
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
        given: f64,
        q: &[f64; 7],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 7>, ::dh_robot::Why<f64>> {
        if !given.is_finite() {
            return ::core::result::Result::Err(::dh_robot::Why::NotFinite);
        }
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
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
                ::core::option::Option::Some(given.into()),
            ],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        let mut found = [[0.0; 8]; 7];
        let mut valid = [0.0; 8];
        if self.all_branches(&frame, given.into(), &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 7, 8> = ::dh_robot::runtime::batched::collect(
                &Self::JOINTS,
                &valid,
                &found,
                &Self::BRANCHES,
            );
            return ::dh_robot::runtime::nearest(&list, q, Self::LENGTH_SCALE);
        }
        let unknowns = self.unknowns(&q.map(f64::from));
        ::dh_robot::runtime::solve_near::<
            _,
            7,
            8,
        >(
            self,
            setting,
            &task,
            &frame,
            Self::MAX_WORK,
            q,
            unknowns,
            |frame, sample, found| self.candidates(frame, given.into(), sample, found),
        )
    }
    /// The same as [`inverse`](Self::inverse) by a thorough search, at special poses without a bound on its time: from many starts, at
    /// neighbouring poses and along self-motions. To compare with.
    #[must_use]
    pub fn inverse_exhaustive(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
        given: f64,
    ) -> ::dh_robot::Solutions<f64, 7, 8> {
        if !given.is_finite() {
            return ::dh_robot::Solutions::none(
                &Self::JOINTS,
                ::dh_robot::Why::NotFinite,
            );
        }
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
            given: [
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::Some(given.into()),
            ],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, sample, found| self.candidates(frame, given.into(), sample, found),
        )
    }
    /// [`inverse`](Self::inverse) of every target: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only. The values of the joints that you choose come with each target.
    #[inline]
    pub fn inverse_batch(
        &self,
        targets: &[::dh_robot::nalgebra::IsometryMatrix3<f64>],
        given: &[f64],
        solutions: &mut [::dh_robot::Solutions<f64, 7, 8>],
    ) {
        for ((target, given), to) in targets.iter().zip(given).zip(solutions) {
            *to = self.inverse(target, *given);
        }
    }
    /// [`inverse_near`](Self::inverse_near) of every target, from the joint values `q` of the same place: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only. The values of the joints that you choose come with each target.
    #[inline]
    pub fn inverse_near_batch(
        &self,
        targets: &[::dh_robot::nalgebra::IsometryMatrix3<f64>],
        given: &[f64],
        q: &[[f64; 7]],
        solutions: &mut [::core::result::Result<
            ::dh_robot::Solution<f64, 7>,
            ::dh_robot::Why<f64>,
        >],
    ) {
        for (((target, given), q), to) in targets.iter().zip(given).zip(q).zip(solutions)
        {
            *to = self.inverse_near(target, *given, q);
        }
    }
    /// [`inverse`](Self::inverse) of the nearest pose whose matrix is a rotation, and by how much the target's was off (the largest entry
    /// of `R^T R - 1`): for targets whose entries are off by up to 1e-3, such as those with three to five decimals.
    #[must_use]
    pub fn inverse_nearest_rotation(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
        given: f64,
    ) -> (::dh_robot::Solutions<f64, 7, 8>, f64) {
        match ::dh_robot::pose::nearest_rotation(target) {
            ::core::result::Result::Ok((target, deviation)) => {
                (self.inverse(&target, given), deviation)
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
        solution: &::dh_robot::Solution<f64, 7>,
    ) -> ::core::option::Option<[f64; 7]> {
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
                ::core::option::Option::Some(solution.q[6].into()),
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
    fn unknowns(&self, q: &[f64; 7]) -> [f64; 8] {
        [q[3], q[4], q[5], q[0], q[1], q[2], 0.0, 0.0]
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        given: f64,
        sample: &::dh_robot::runtime::Sample,
        found: &mut dyn FnMut([f64; 7], ::dh_robot::Branch, ::dh_robot::runtime::Path),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let path = ::dh_robot::runtime::Path::START;
        let t_2 = t[0][3] - t[0][2] * 0.07681263460157932;
        let t_3 = t[1][3] - t[1][2] * 0.07681263460157932;
        let t_4 = t[2][3] - t[2][2] * 0.07681263460157932;
        let t_5 = t[2][2] * 0.2390524048815506;
        let q7 = given;
        let (s7, c7) = ::dh_robot::runtime::sin_cos(q7);
        let t_6 = t[0][0] * c7 - t[0][1] * s7;
        let t_7 = t[1][0] * c7 - t[1][1] * s7;
        let t_8 = t[2][0] * c7 - t[2][1] * s7;
        let t_9 = t[0][0] * s7 + t[0][1] * c7;
        let t_10 = t[1][0] * s7 + t[1][1] * c7;
        let t_11 = t[2][0] * s7 + t[2][1] * c7;
        let t_12 = t_2 - t_6 * 0.06317300789662599;
        let t_13 = t_3 - t_7 * 0.06317300789662599;
        let t_14 = t_4 - t_8 * 0.06317300789662599;
        let t_15 = t_12 * t_12 + t_13 * t_13 + t_14 * t_14 - 0.13446604368370413;
        let t_16 = 0.2390524048815506 * (0.2390524048815506 - t_14 * 2.0) + t_15;
        let t_17 = t_9 * t_12 + t_10 * t_13 + t_11 * t_14 - t_11 * 0.2390524048815506;
        let t_18 = t_6 * t_12 + t_7 * t_13 + t_8 * t_14 - t_8 * 0.2390524048815506;
        let t_19 = t[0][2] * t_12 + t[1][2] * t_13 + t[2][2] * t_14 - t_5;
        // Step 1: q4 from the law of cosines.
        let q4_roots = ::dh_robot::runtime::solve_sincos(
            0.11805283210226085,
            -0.05952230643526318,
            t_16,
            sample.tolerance,
        );
        if !q4_roots.is_regular() {
            attempt
                .note_law(
                    q4_roots.outcome,
                    &path,
                    "elbow q4",
                    [0.13446604368370413, t_16],
                    false,
                    Self::LENGTH_SCALE,
                    "m",
                );
        }
        let path = if q4_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[3]))
        } else {
            path
        };
        for (q4_root, &[c4, s4]) in q4_roots
            .or_if_free(sample.angle(0))
            .iter()
            .enumerate()
        {
            let path = path.root(0, q4_root);
            let q4 = ::dh_robot::runtime::atan2(s4, c4);
            let t_20 = 0.059224694903086864 * (1.0 - c4) - 0.22684852835606603 * s4;
            let t_21 = 0.2756640344580043 + c4 * 0.22684852835606603
                - 0.059224694903086864 * s4;
            // Step 2: q5 from an equation in sine and cosine.
            let q5_roots = ::dh_robot::runtime::solve_sincos(
                0.0,
                t_20,
                -t_17,
                sample.tolerance,
            );
            if !q5_roots.is_regular() {
                attempt
                    .note(q5_roots.outcome, &path, "wrist q5", Self::LENGTH_SCALE, "m");
            }
            if path.is_chosen() {
                attempt.see(1, &path, [0.0, t_20, -t_17]);
            }
            let path = if q5_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[4]))
            } else {
                path
            };
            for (q5_root, &[c5, s5]) in q5_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let path = path.root(1, q5_root);
                let q5 = ::dh_robot::runtime::atan2(s5, c5);
                let t_22 = t_9 * s5;
                let t_23 = t_10 * s5;
                let t_24 = t_11 * s5;
                // Step 3: q6 from sine and cosine.
                let q6_roots = ::dh_robot::runtime::solve_pair(
                    t_18,
                    t_19,
                    -t_20 * c5,
                    -t_19,
                    t_18,
                    t_21,
                    sample.tolerance,
                );
                if !q6_roots.is_regular() {
                    attempt.note(q6_roots.outcome, &path, "q6", 1.0, "");
                }
                let path = if q6_roots.is_free() {
                    attempt.choose(2, &path, ::dh_robot::FreeJoints::of(&[5]))
                } else {
                    path
                };
                for (q6_root, &[c6, s6]) in q6_roots
                    .or_if_free(sample.angle(2))
                    .iter()
                    .enumerate()
                {
                    let q6 = ::dh_robot::runtime::atan2(s6, c6);
                    let t_25 = s4 * (c5 * (t_6 * c6 + t[0][2] * s6) + t_22)
                        + c4 * (t_6 * s6 - t[0][2] * c6);
                    let t_26 = s4 * (c5 * (t_7 * c6 + t[1][2] * s6) + t_23)
                        + c4 * (t_7 * s6 - t[1][2] * c6);
                    let t_27 = s4 * (c5 * (t_8 * c6 + t[2][2] * s6) + t_24)
                        + c4 * (t_8 * s6 - t[2][2] * c6);
                    // Step 4: q1 from a ratio of sine and cosine.
                    let q1_roots = ::dh_robot::runtime::solve_sincos(
                        -t_26,
                        t_25,
                        0.0,
                        sample.tolerance,
                    );
                    if !q1_roots.is_regular() {
                        attempt.note(q1_roots.outcome, &path, "shoulder q1", 1.0, "");
                    }
                    if path.is_chosen() {
                        attempt.see(3, &path, [-t_26, t_25, 0.0]);
                    }
                    let path = if q1_roots.is_free() {
                        attempt.choose(3, &path, ::dh_robot::FreeJoints::of(&[0]))
                    } else {
                        path
                    };
                    for (q1_root, &[c1, s1]) in q1_roots
                        .or_if_free(sample.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let path = path.root(3, q1_root);
                        let q1 = ::dh_robot::runtime::atan2(s1, c1);
                        let t_28 = t[0][0] * c1 + t[1][0] * s1;
                        let t_29 = t[0][1] * c1 + t[1][1] * s1;
                        let t_30 = t[0][2] * c1 + t[1][2] * s1;
                        let t_31 = c7 * t_28 - s7 * t_29;
                        let t_32 = c5 * (c6 * t_31 + s6 * t_30)
                            + s5 * (s7 * t_28 + c7 * t_29);
                        // Step 5: q2 from sine and cosine.
                        let q2_roots = ::dh_robot::runtime::solve_pair(
                            0.0,
                            1.0,
                            s4 * t_32 + c4 * (s6 * t_31 - c6 * t_30),
                            1.0,
                            0.0,
                            t_27,
                            sample.tolerance,
                        );
                        if !q2_roots.is_regular() {
                            attempt.note(q2_roots.outcome, &path, "q2", 1.0, "");
                        }
                        let path = if q2_roots.is_free() {
                            attempt.choose(4, &path, ::dh_robot::FreeJoints::of(&[1]))
                        } else {
                            path
                        };
                        for (q2_root, &[c2, s2]) in q2_roots
                            .or_if_free(sample.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q2 = ::dh_robot::runtime::atan2(s2, c2);
                            let t_33 = t_28 * c2 - t[2][0] * s2;
                            let t_34 = t_29 * c2 - t[2][1] * s2;
                            let t_35 = t_30 * c2 - t[2][2] * s2;
                            let t_36 = c7 * t_33 - s7 * t_34;
                            let t_37 = s7 * t_33 + c7 * t_34;
                            let t_38 = c6 * t_36 + s6 * t_35;
                            let t_39 = c4 * (c5 * t_38 + s5 * t_37)
                                - s4 * (s6 * t_36 - c6 * t_35);
                            // Step 6: q3 from sine and cosine.
                            let q3_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                t_39,
                                0.0,
                                -1.0,
                                s5 * t_38 - c5 * t_37,
                                sample.tolerance,
                            );
                            if !q3_roots.is_regular() {
                                attempt.note(q3_roots.outcome, &path, "q3", 1.0, "");
                            }
                            let path = if q3_roots.is_free() {
                                attempt.choose(5, &path, ::dh_robot::FreeJoints::of(&[2]))
                            } else {
                                path
                            };
                            for (q3_root, &[c3, s3]) in q3_roots
                                .or_if_free(sample.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let q3 = ::dh_robot::runtime::atan2(s3, c3);
                                let branch = ::dh_robot::Branch::ANY
                                    .with_step(0, q4_root)
                                    .with_elbow(
                                        if q4_root == 0 {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(1, q5_root)
                                    .with_wrist(
                                        if q5_root == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    )
                                    .with_step(2, q1_root)
                                    .with_shoulder(
                                        if q1_root == 0 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    );
                                found([q1, q2, q3, q4, q5, q6, q7], branch, path);
                            }
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
        given: f64,
    ) -> (::dh_robot::Solutions<f64, 7, 8>, ::dh_robot::Work) {
        if !given.is_finite() {
            return (
                ::dh_robot::Solutions::none(&Self::JOINTS, ::dh_robot::Why::NotFinite),
                ::dh_robot::Work::NONE,
            );
        }
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
            given: [
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::Some(given.into()),
            ],
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
            |frame, sample, found| self.candidates(frame, given.into(), sample, found),
        )
    }
    /// Which root each step takes in each branch.
    const BRANCHES: [::dh_robot::Branch; 8] = {
        let mut all = [::dh_robot::Branch::ANY; 8];
        let mut branch = 0;
        while branch < 8 {
            let q4_root = branch / 1 % 2;
            let q5_root = branch / 2 % 2;
            let q1_root = branch / 4 % 2;
            all[branch] = ::dh_robot::Branch::ANY
                .with_step(0, q4_root)
                .with_elbow(
                    if q4_root == 0 {
                        ::dh_robot::Elbow::Up
                    } else {
                        ::dh_robot::Elbow::Down
                    },
                )
                .with_step(1, q5_root)
                .with_wrist(
                    if q5_root == 0 {
                        ::dh_robot::Wrist::NoFlip
                    } else {
                        ::dh_robot::Wrist::Flip
                    },
                )
                .with_step(2, q1_root)
                .with_shoulder(
                    if q1_root == 0 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                );
            branch += 1;
        }
        all
    };
    /// The plan for all branches at once: joint values, and which branches are real; false where the fallback path has to decide.
    #[inline]
    fn all_branches(
        &self,
        t: &::dh_robot::runtime::Pose,
        given: f64,
        q: &mut [[f64; 8]; 7],
        valid: &mut [f64; 8],
    ) -> bool {
        let q7 = given;
        let (s7, c7) = ::dh_robot::runtime::sin_cos(q7);
        q[6] = [Self::JOINTS[6].normalize(given); 8];
        let t_2 = t[0][3] - t[0][2] * 0.07681263460157932;
        let t_3 = t[1][3] - t[1][2] * 0.07681263460157932;
        let t_4 = t[2][3] - t[2][2] * 0.07681263460157932;
        let t_5 = t[2][2] * 0.2390524048815506;
        let t_6 = t[0][0] * c7 - t[0][1] * s7;
        let t_7 = t[1][0] * c7 - t[1][1] * s7;
        let t_8 = t[2][0] * c7 - t[2][1] * s7;
        let t_9 = t[0][0] * s7 + t[0][1] * c7;
        let t_10 = t[1][0] * s7 + t[1][1] * c7;
        let t_11 = t[2][0] * s7 + t[2][1] * c7;
        let t_12 = t_2 - t_6 * 0.06317300789662599;
        let t_13 = t_3 - t_7 * 0.06317300789662599;
        let t_14 = t_4 - t_8 * 0.06317300789662599;
        let t_15 = t_12 * t_12 + t_13 * t_13 + t_14 * t_14 - 0.13446604368370413;
        let t_16 = 0.2390524048815506 * (0.2390524048815506 - t_14 * 2.0) + t_15;
        let t_17 = t_9 * t_12 + t_10 * t_13 + t_11 * t_14 - t_11 * 0.2390524048815506;
        let t_18 = t_6 * t_12 + t_7 * t_13 + t_8 * t_14 - t_8 * 0.2390524048815506;
        let t_19 = t[0][2] * t_12 + t[1][2] * t_13 + t[2][2] * t_14 - t_5;
        // Step 1: q4 from the law of cosines.
        let ([c4_first, s4_first, c4_second, s4_second], q4_valid, q4_margin) = ::dh_robot::runtime::batched::sincos(
            0.11805283210226085,
            -0.05952230643526318,
            t_16,
        );
        let all_c4 = [c4_first, c4_second];
        let all_s4 = [s4_first, s4_second];
        let all_q4 = ::dh_robot::runtime::batched::angles(
            &[s4_first, s4_second],
            &[c4_first, c4_second],
        );
        let mut all_t_20 = [0.0; 2];
        let mut all_t_21 = [0.0; 2];
        let mut q5_pairs = [[0.0; 4]; 2];
        let mut all_margin_1 = [0.0; 2];
        let mut all_valid_1 = [0.0; 2];
        for branch in 0..2 {
            let c4 = all_c4[branch];
            let s4 = all_s4[branch];
            let t_20 = 0.059224694903086864 * (1.0 - c4) - 0.22684852835606603 * s4;
            let t_21 = 0.2756640344580043 + c4 * 0.22684852835606603
                - 0.059224694903086864 * s4;
            all_t_20[branch] = t_20;
            all_t_21[branch] = t_21;
            // Step 2: q5 from an equation in sine and cosine.
            let ([c5_first, s5_first, c5_second, s5_second], q5_valid, q5_margin) = ::dh_robot::runtime::batched::sincos(
                0.0,
                t_20,
                -t_17,
            );
            q5_pairs[0][branch] = c5_first;
            q5_pairs[1][branch] = s5_first;
            q5_pairs[0][branch + 2] = c5_second;
            q5_pairs[1][branch + 2] = s5_second;
            all_margin_1[branch] = q5_margin;
            all_valid_1[branch] = q5_valid;
        }
        let all_q5 = ::dh_robot::runtime::batched::angles(&q5_pairs[1], &q5_pairs[0]);
        q[4] = ::core::array::from_fn(|branch| all_q5[branch / 2 % 2 * 2 + branch % 2]);
        let all_c5 = q5_pairs[0];
        let all_s5 = q5_pairs[1];
        let all_t_20: [f64; 4] = ::core::array::from_fn(|branch| all_t_20[branch % 2]);
        let all_t_21: [f64; 4] = ::core::array::from_fn(|branch| all_t_21[branch % 2]);
        let all_c4: [f64; 4] = ::core::array::from_fn(|branch| all_c4[branch % 2]);
        let all_s4: [f64; 4] = ::core::array::from_fn(|branch| all_s4[branch % 2]);
        let all_q4: [f64; 4] = ::core::array::from_fn(|branch| all_q4[branch / 1 % 2]);
        let all_margin_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_margin_1[branch % 2]
        });
        let mut all_margin = [0.0; 4];
        let all_valid_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_valid_1[branch % 2]
        });
        let mut all_valid = [0.0; 4];
        let mut all_error = [0.0; 4];
        for branch in 0..4 {
            let t_20 = all_t_20[branch];
            let c5 = all_c5[branch];
            let s5 = all_s5[branch];
            let t_22 = t_9 * s5;
            let t_23 = t_10 * s5;
            let t_24 = t_11 * s5;
            let s7s5 = s7 * s5;
            let s7c5 = s7 * c5;
            let t_21 = all_t_21[branch];
            // Step 3: q6 from sine and cosine.
            let ([c6, s6], q6_margin) = ::dh_robot::runtime::batched::pair(
                t_18,
                t_19,
                -t_20 * c5,
                -t_19,
                t_18,
                t_21,
            );
            let q6 = ::dh_robot::runtime::batched::angle(s6, c6);
            let c4 = all_c4[branch];
            let s4 = all_s4[branch];
            let t_25 = s4 * (c5 * (t_6 * c6 + t[0][2] * s6) + t_22)
                + c4 * (t_6 * s6 - t[0][2] * c6);
            let t_26 = s4 * (c5 * (t_7 * c6 + t[1][2] * s6) + t_23)
                + c4 * (t_7 * s6 - t[1][2] * c6);
            let t_27 = s4 * (c5 * (t_8 * c6 + t[2][2] * s6) + t_24)
                + c4 * (t_8 * s6 - t[2][2] * c6);
            let c7c6 = c7 * c6;
            let c7s6 = c7 * s6;
            let t_28 = c5 * c7c6 + s7s5;
            let t_29 = s5 * c7c6 - s7c5;
            let t_30 = c4 * t_28 - s4 * c7s6;
            let t_31 = s4 * t_28 + c4 * c7s6;
            let c5s6 = c5 * s6;
            let s6s5 = s6 * s5;
            let t_32 = c4 * c5s6 + s4 * c6;
            let t_33 = s4 * c5s6 - c4 * c6;
            let t_34 = 0.06317300789662599 * c6 + 0.07681263460157932 * s6;
            let t_35 = 0.2756640344580043 + 0.06317300789662599 * s6
                - 0.07681263460157932 * c6;
            let t_36 = s5 * t_34;
            let t_37 = 0.059224694903086864 - c5 * t_34;
            let t_38 = 0.059224694903086864 - (c4 * t_37 + s4 * t_35);
            let t_39 = 0.22684852835606603 - (s4 * t_37 - c4 * t_35);
            // Step 4: q1 from a ratio of sine and cosine.
            let ([c1, s1], q1_margin) = ::dh_robot::runtime::batched::half_turn([
                [-t_26, t_25],
            ]);
            let q1 = ::dh_robot::runtime::batched::angle(s1, c1);
            let t_40 = t[0][0] * c1 + t[1][0] * s1;
            let t_41 = t[0][1] * c1 + t[1][1] * s1;
            let t_42 = t[0][2] * c1 + t[1][2] * s1;
            let t_43 = c7 * t_40 - s7 * t_41;
            let t_44 = c5 * (c6 * t_43 + s6 * t_42) + s5 * (s7 * t_40 + c7 * t_41);
            // Step 5: q2 from sine and cosine.
            let [c2, s2] = ::dh_robot::runtime::batched::unit(
                t_27,
                s4 * t_44 + c4 * (s6 * t_43 - c6 * t_42),
            );
            let q2 = ::dh_robot::runtime::batched::angle(s2, c2);
            let t_45 = t_40 * c2 - t[2][0] * s2;
            let t_46 = t_41 * c2 - t[2][1] * s2;
            let t_47 = t_42 * c2 - t[2][2] * s2;
            let t_48 = c7 * t_45 - s7 * t_46;
            let t_49 = s7 * t_45 + c7 * t_46;
            let t_50 = c6 * t_48 + s6 * t_47;
            let t_51 = c4 * (c5 * t_50 + s5 * t_49) - s4 * (s6 * t_48 - c6 * t_47);
            let t_52 = s2 * t_31;
            let t_53 = c2 * t_31;
            let t_54 = s2 * t_33;
            let t_55 = c2 * t_33;
            let t_56 = s2 * t_39;
            let t_57 = c2 * t_39;
            // Step 6: q3 from sine and cosine.
            let [c3, s3] = ::dh_robot::runtime::batched::unit(
                t_51,
                -(s5 * t_50 - c5 * t_49),
            );
            let q3 = ::dh_robot::runtime::batched::angle(s3, c3);
            let t_58 = t_30 * c3 - t_29 * s3;
            let t_59 = t_30 * s3 + t_29 * c3;
            let t_60 = c2 * t_58 + t_52;
            let t_61 = c3 * t_32 - s3 * s6s5;
            let t_62 = s3 * t_32 + c3 * s6s5;
            let t_63 = c2 * t_61 + t_54;
            let t_64 = c3 * t_38 - s3 * t_36;
            let t_65 = s3 * t_38 + c3 * t_36;
            let t_66 = c2 * t_64 + t_56;
            let q3_error = (c1 * t_60 - s1 * t_59 - t[0][0]).abs()
                + (s1 * t_60 + c1 * t_59 - t[1][0]).abs()
                + (-(s2 * t_58 - t_53) - t[2][0]).abs()
                + (c1 * t_63 - s1 * t_62 - t[0][2]).abs()
                + (s1 * t_63 + c1 * t_62 - t[1][2]).abs()
                + (-(s2 * t_61 - t_55) - t[2][2]).abs()
                + (c1 * t_66 - s1 * t_65 - t[0][3]).abs()
                + (s1 * t_66 + c1 * t_65 - t[1][3]).abs()
                + (0.2390524048815506 - (s2 * t_64 - t_57) - t[2][3]).abs();
            let q4 = all_q4[branch];
            let margin_1 = all_margin_1[branch];
            let valid_1 = all_valid_1[branch];
            // How far the branch is from the target.
            all_margin[branch] = ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(
                    ::dh_robot::runtime::batched::lesser(q4_margin, margin_1),
                    q6_margin,
                ),
                q1_margin,
            );
            all_valid[branch] = q4_valid * valid_1;
            all_error[branch] = q3_error;
            // The mirrored half differs by signs.
            let q1_second = ::dh_robot::runtime::batched::opposite(q1);
            let q2_second = ::dh_robot::runtime::batched::negative(q2);
            let q3_second = ::dh_robot::runtime::batched::opposite(q3);
            q[0][branch] = q1;
            q[1][branch] = q2;
            q[2][branch] = q3;
            q[3][branch] = q4;
            q[5][branch] = ::dh_robot::runtime::batched::into_range(
                q6,
                -0.017453292519943295,
                3.752457891787808,
            );
            q[0][branch + 4] = q1_second;
            q[1][branch + 4] = q2_second;
            q[2][branch + 4] = q3_second;
            q[3][branch + 4] = q4;
            q[5][branch + 4] = ::dh_robot::runtime::batched::into_range(
                q6,
                -0.017453292519943295,
                3.752457891787808,
            );
        }
        *valid = ::core::array::from_fn(|branch| all_valid[branch % 4]);
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<7> for Panda {
    #[inline]
    fn forward(&self, q: &[f64; 7]) -> ::dh_robot::runtime::Pose {
        let angles = [q[6], q[5], q[4], q[3], q[2], q[1], q[0]];
        let ([s7, s6, s5, s4, s3, s2, s1], [c7, c6, c5, c4, c3, c2, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c7c6 = c7 * c6;
        let c7s6 = c7 * s6;
        let t_2 = c7c6 * c5 + s7 * s5;
        let t_3 = c7c6 * s5 - s7 * c5;
        let t_4 = t_2 * c4 - c7s6 * s4;
        let t_5 = t_2 * s4 + c7s6 * c4;
        let t_6 = t_4 * c3 - t_3 * s3;
        let t_7 = t_4 * s3 + t_3 * c3;
        let t_8 = t_6 * c2 + t_5 * s2;
        let t_9 = t_6 * s2 - t_5 * c2;
        let t_10 = t_8 * c1 - t_7 * s1;
        let t_11 = t_8 * s1 + t_7 * c1;
        let s6c5 = s6 * c5;
        let s6s5 = s6 * s5;
        let t_12 = c4 * s6c5 + c6 * s4;
        let t_13 = s4 * s6c5 - c6 * c4;
        let t_14 = c3 * t_12 - s3 * s6s5;
        let t_15 = s3 * t_12 + c3 * s6s5;
        let t_16 = c2 * t_14 + s2 * t_13;
        let t_17 = s2 * t_14 - c2 * t_13;
        let t_18 = c1 * t_16 - s1 * t_15;
        let t_19 = s1 * t_16 + c1 * t_15;
        let t_20 = c6 * 0.088 + s6 * 0.107;
        let t_21 = s6 * 0.088 - c6 * 0.107 + 0.384;
        let t_22 = s5 * t_20;
        let t_23 = 0.0825 - c5 * t_20;
        let t_24 = 0.0825 - (c4 * t_23 + s4 * t_21);
        let t_25 = s4 * t_23 - c4 * t_21 - 0.316;
        let t_26 = c3 * t_24 - s3 * t_22;
        let t_27 = s3 * t_24 + c3 * t_22;
        let t_28 = c2 * t_26 - s2 * t_25;
        [
            [t_10, -(t_9 * t_19 - t_11 * t_17), t_18, c1 * t_28 - s1 * t_27],
            [t_11, -(t_10 * t_17 - t_9 * t_18), t_19, s1 * t_28 + c1 * t_27],
            [-t_9, t_11 * t_18 - t_10 * t_19, -t_17, -(s2 * t_26 + c2 * t_25 - 0.333)],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 7],
    ) -> (::dh_robot::runtime::Pose, [[f64; 7]; 6]) {
        let angles = [q[0], q[1], q[2], q[3], q[4], q[5], q[6]];
        let ([s1, s2, s3, s4, s5, s6, s7], [c1, c2, c3, c4, c5, c6, c7]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let s2c3 = s2 * c3;
        let t_2 = c1c2 * c3 - s1 * s3;
        let t_3 = s1c2 * c3 + c1 * s3;
        let s2s3 = s2 * s3;
        let t_4 = s1 * c3 + c1c2 * s3;
        let t_5 = c1 * c3 - s1c2 * s3;
        let t_6 = t_2 * c4 + c1s2 * s4;
        let t_7 = t_3 * c4 + s1s2 * s4;
        let t_8 = s2c3 * c4 - c2 * s4;
        let t_9 = c1s2 * c4 - t_2 * s4;
        let t_10 = s1s2 * c4 - t_3 * s4;
        let t_11 = c2 * c4 + s2c3 * s4;
        let t_12 = t_6 * c5 - t_4 * s5;
        let t_13 = t_7 * c5 + t_5 * s5;
        let t_14 = t_8 * c5 - s2s3 * s5;
        let t_15 = t_4 * c5 + t_6 * s5;
        let t_16 = t_5 * c5 - t_7 * s5;
        let t_17 = s2s3 * c5 + t_8 * s5;
        let t_18 = t_12 * c6 + t_9 * s6;
        let t_19 = t_13 * c6 + t_10 * s6;
        let t_20 = t_14 * c6 - t_11 * s6;
        let t_21 = t_9 * c6 - t_12 * s6;
        let t_22 = t_10 * c6 - t_13 * s6;
        let t_23 = t_11 * c6 + t_14 * s6;
        let t_24 = c6 * 0.088 + s6 * 0.107;
        let t_25 = s6 * 0.088 - c6 * 0.107 + 0.384;
        let t_26 = s5 * t_24;
        let t_27 = c5 * t_24 - 0.0825;
        let t_28 = 0.0825 + c4 * t_27 - s4 * t_25;
        let t_29 = s4 * t_27 + c4 * t_25 + 0.316;
        let t_30 = c3 * t_28 - s3 * t_26;
        let t_31 = s3 * t_28 + c3 * t_26;
        let t_32 = c2 * t_30 + s2 * t_29;
        let t_33 = s2 * t_30 - c2 * t_29;
        let t_34 = c1 * t_32 - s1 * t_31;
        let t_35 = s1 * t_32 + c1 * t_31;
        (
            [
                [t_18 * c7 + t_15 * s7, t_15 * c7 - t_18 * s7, -t_21, t_34],
                [t_19 * c7 - t_16 * s7, -(t_16 * c7 + t_19 * s7), -t_22, t_35],
                [
                    -(t_20 * c7 + t_17 * s7),
                    -(t_17 * c7 - t_20 * s7),
                    -t_23,
                    -(t_33 - 0.333),
                ],
            ],
            [
                [
                    -t_35,
                    -c1 * t_33,
                    -(c1c2 * t_31 + s1 * t_30),
                    -(t_6 * t_25 - t_9 * t_27),
                    -t_15 * t_24,
                    t_18 * 0.107 + t_21 * 0.088,
                    0.0,
                ],
                [
                    t_34,
                    -s1 * t_33,
                    -(s1c2 * t_31 - c1 * t_30),
                    -(t_7 * t_25 - t_10 * t_27),
                    t_16 * t_24,
                    t_19 * 0.107 + t_22 * 0.088,
                    0.0,
                ],
                [
                    0.0,
                    -t_32,
                    s2 * t_31,
                    t_8 * t_25 + t_11 * t_27,
                    t_17 * t_24,
                    -(t_20 * 0.107 - t_23 * 0.088),
                    0.0,
                ],
                [0.0, -s1, c1s2, t_4, t_9, t_15, 0.0],
                [0.0, c1, s1s2, -t_5, t_10, -t_16, 0.0],
                [1.0, 0.0, c2, -s2s3, t_11, -t_17, 0.0],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<7, f64> for Panda {
    type Target = (::dh_robot::nalgebra::IsometryMatrix3<f64>, f64);
    type Solutions = ::dh_robot::Solutions<f64, 7, 8>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Panda::inverse(self, &target.0, target.1)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 7],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 7>, ::dh_robot::Why<f64>> {
        Panda::inverse_near(self, &target.0, target.1, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Panda {
    type Joints = ::dh_robot::runtime::Joints<7>;
}
