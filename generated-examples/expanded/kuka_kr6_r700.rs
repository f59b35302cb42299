// What `dh_robot!` makes of src/kuka_kr6_r700.rs. Made by `cargo regen`; do not edit.

/// KUKA KR 6 R700 sixx.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | 1 | q1 | 400mm | 25mm | -90deg | -170deg..=170deg |
/// | 2 | q2 - 90deg | 0 | 315mm | 0 | -190deg..=45deg |
/// | 3 | q3 | 0 | 35mm | -90deg | -120deg..=156deg |
/// | 4 | q4 | 365mm | 0 | 90deg | -185deg..=185deg |
/// | 5 | q5 | 0 | 0 | -90deg | -120deg..=120deg |
/// | 6 | q6 | 80mm | 0 | 0 | -350deg..=350deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁[s₂₃(c₄c₅c₆ − s₄s₆) + c₂₃s₅c₆] + s₁(s₄c₅c₆ + c₄s₆)
/// r₂₁ = s₁[s₂₃(c₄c₅c₆ − s₄s₆) + c₂₃s₅c₆] − c₁(s₄c₅c₆ + c₄s₆)
/// r₃₁ = c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆
/// r₁₂ = −c₁[s₂₃(c₄c₅s₆ + s₄c₆) + c₂₃s₅s₆] − s₁(s₄c₅s₆ − c₄c₆)
/// r₂₂ = −s₁[s₂₃(c₄c₅s₆ + s₄c₆) + c₂₃s₅s₆] + c₁(s₄c₅s₆ − c₄c₆)
/// r₃₂ = −c₂₃(c₄c₅s₆ + s₄c₆) + s₂₃s₅s₆
/// r₁₃ = −c₁(s₂₃c₄s₅ − c₂₃c₅) − s₁s₄s₅
/// r₂₃ = −s₁(s₂₃c₄s₅ − c₂₃c₅) + c₁s₄s₅
/// r₃₃ = −c₂₃c₄s₅ − s₂₃c₅
/// px  = c₁[a₁ + a₂s₂ + s₂₃(a₃ − d₆c₄s₅) + c₂₃(d₄ + d₆c₅)] − d₆s₁s₄s₅
/// py  = s₁[a₁ + a₂s₂ + s₂₃(a₃ − d₆c₄s₅) + c₂₃(d₄ + d₆c₅)] + d₆c₁s₄s₅
/// pz  = d₁ + a₂c₂ + c₂₃(a₃ − d₆c₄s₅) − s₂₃(d₄ + d₆c₅)
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 4, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      a₁ = 0.025, d₁ = 0.4, a₂ = 0.315, a₃ = 0.035, d₄ = 0.365, d₆ = 0.08
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KukaKr6R700;
impl ::core::default::Default for KukaKr6R700 {
    fn default() -> Self {
        KukaKr6R700
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl KukaKr6R700 {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-3.316125578789226, 0.7853981633974483),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-2.0943951023931953, 2.7227136331111543),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-3.2288591161895095, 3.2288591161895095),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-2.0943951023931953, 2.0943951023931953),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-6.1086523819801535, 6.1086523819801535),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 41 multiplications, 23 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * s23 + c6s5 * c23;
        let t_5 = t_2 * c23 - c6s5 * s23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = s23 * s5c4 - c5 * c23;
        let t_9 = c23 * s5c4 + c5 * s23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = s23 * 0.035 + c23 * 0.365 + 0.315 * s2 + 0.025;
        let t_13 = c23 * 0.035 - s23 * 0.365 + 0.315 * c2 + 0.4 - t_9 * 0.08;
        ::dh_robot::pose::from_entries(
            [
                [t_6, -(t_5 * t_11 - t_7 * t_9), -t_10],
                [t_7, -(t_6 * t_9 - t_5 * t_10), -t_11],
                [t_5, -(t_7 * t_10 - t_6 * t_11), -t_9],
            ],
            [c1 * t_12 - t_10 * 0.08, s1 * t_12 - t_11 * 0.08, t_13],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 58 multiplications, 29 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[3], q[4], q[5]];
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c1 * 0.025;
        let t_3 = s1 * 0.025;
        let t_4 = 0.315 * s2;
        let t_5 = t_2 + c1 * t_4;
        let t_6 = t_3 + s1 * t_4;
        let t_7 = 0.4 + 0.315 * c2;
        let t_8 = 0.035 * s23;
        let t_9 = t_5 + c1 * t_8;
        let t_10 = t_6 + s1 * t_8;
        let t_11 = t_7 + 0.035 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let t_12 = t_9 + c1c23 * 0.365;
        let t_13 = t_10 + s1c23 * 0.365;
        let t_14 = t_11 - s23 * 0.365;
        let c23c4 = c23 * c4;
        let t_15 = c1s23 * c4 + s1 * s4;
        let t_16 = s1s23 * c4 - c1 * s4;
        let c23s4 = c23 * s4;
        let t_17 = s1 * c4 - c1s23 * s4;
        let t_18 = c1 * c4 + s1s23 * s4;
        let t_19 = t_15 * c5 + c1c23 * s5;
        let t_20 = t_16 * c5 + s1c23 * s5;
        let t_21 = c23c4 * c5 - s23 * s5;
        let t_22 = c1c23 * c5 - t_15 * s5;
        let t_23 = s1c23 * c5 - t_16 * s5;
        let t_24 = s23 * c5 + c23c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
                [t_2, t_3, 0.4],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * s2, c1 * c2, -s1], [s1 * s2, s1 * c2, c1], [c2, -s2, 0.0]],
                [t_5, t_6, t_7],
            ),
            ::dh_robot::pose::from_entries(
                [[c1s23, s1, c1c23], [s1s23, -c1, s1c23], [c23, 0.0, -s23]],
                [t_9, t_10, t_11],
            ),
            ::dh_robot::pose::from_entries(
                [[t_15, c1c23, -t_17], [t_16, s1c23, t_18], [c23c4, -s23, c23s4]],
                [t_12, t_13, t_14],
            ),
            ::dh_robot::pose::from_entries(
                [[t_19, t_17, t_22], [t_20, -t_18, t_23], [t_21, -c23s4, -t_24]],
                [t_12, t_13, t_14],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_19 * c6 + t_17 * s6, t_17 * c6 - t_19 * s6, t_22],
                    [t_20 * c6 - t_18 * s6, -(t_18 * c6 + t_20 * s6), t_23],
                    [t_21 * c6 - c23s4 * s6, -(c23s4 * c6 + t_21 * s6), -t_24],
                ],
                [t_12 + t_22 * 0.08, t_13 + t_23 * 0.08, t_14 - t_24 * 0.08],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 50 multiplications, 20 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c23c4 = c23 * c4;
        let t_2 = c1s23 * c4 + s1 * s4;
        let t_3 = s1s23 * c4 - c1 * s4;
        let c23s4 = c23 * s4;
        let t_4 = s1 * c4 - c1s23 * s4;
        let t_5 = c1 * c4 + s1s23 * s4;
        let t_6 = s5 * 0.08;
        let t_7 = c5 * 0.08 + 0.365;
        let t_8 = s4 * t_6;
        let t_9 = c4 * t_6 - 0.035;
        let t_10 = s23 * t_9 - c23 * t_7;
        let t_11 = c23 * t_9 + s23 * t_7;
        let t_12 = t_10 - 0.315 * s2;
        let t_13 = t_11 - 0.315 * c2;
        let t_14 = t_12 - 0.025;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_14 - c1 * t_8, -(c1 * t_14 + s1 * t_8), 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_13, -s1 * t_13, t_12, -s1, c1, 0.0],
                [-c1 * t_11, -s1 * t_11, t_10, -s1, c1, 0.0],
                [-t_4 * t_6, t_5 * t_6, c23s4 * t_6, c1c23, s1c23, -s23],
                [
                    -(t_2 * c5 + c1c23 * s5) * 0.08,
                    -(t_3 * c5 + s1c23 * s5) * 0.08,
                    -(c23c4 * c5 - s23 * s5) * 0.08,
                    -t_4,
                    t_5,
                    c23s4,
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    c1c23 * c5 - t_2 * s5,
                    s1c23 * c5 - t_3 * s5,
                    -(s23 * c5 + c23c4 * s5),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 62 multiplications, 27 additions, 6 sine-cosine pairs.
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
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c23c4 = c23 * c4;
        let t_2 = c1s23 * c4 + s1 * s4;
        let t_3 = s1s23 * c4 - c1 * s4;
        let c23s4 = c23 * s4;
        let t_4 = s1 * c4 - c1s23 * s4;
        let t_5 = c1 * c4 + s1s23 * s4;
        let t_6 = t_2 * c5 + c1c23 * s5;
        let t_7 = t_3 * c5 + s1c23 * s5;
        let t_8 = c23c4 * c5 - s23 * s5;
        let t_9 = c1c23 * c5 - t_2 * s5;
        let t_10 = s1c23 * c5 - t_3 * s5;
        let t_11 = s23 * c5 + c23c4 * s5;
        let t_12 = s5 * 0.08;
        let t_13 = c5 * 0.08 + 0.365;
        let t_14 = s4 * t_12;
        let t_15 = c4 * t_12 - 0.035;
        let t_16 = s23 * t_15 - c23 * t_13;
        let t_17 = c23 * t_15 + s23 * t_13;
        let t_18 = t_16 - 0.315 * s2;
        let t_19 = t_17 - 0.315 * c2;
        let t_20 = t_18 - 0.025;
        let t_21 = c1 * t_20 + s1 * t_14;
        let t_22 = s1 * t_20 - c1 * t_14;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_6 * c6 + t_4 * s6, t_4 * c6 - t_6 * s6, t_9],
                    [t_7 * c6 - t_5 * s6, -(t_5 * c6 + t_7 * s6), t_10],
                    [t_8 * c6 - c23s4 * s6, -(c23s4 * c6 + t_8 * s6), -t_11],
                ],
                [-t_21, -t_22, -(t_19 - 0.4)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_22, -t_21, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_19, -s1 * t_19, t_18, -s1, c1, 0.0],
                    [-c1 * t_17, -s1 * t_17, t_16, -s1, c1, 0.0],
                    [-t_4 * t_12, t_5 * t_12, c23s4 * t_12, c1c23, s1c23, -s23],
                    [-t_6 * 0.08, -t_7 * 0.08, -t_8 * 0.08, -t_4, t_5, c23s4],
                    [0.0, 0.0, 0.0, t_9, t_10, -t_11],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for KukaKr6R700 {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for KukaKr6R700 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        KukaKr6R700::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        KukaKr6R700::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for KukaKr6R700 {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        KukaKr6R700::jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl KukaKr6R700 {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 2. `q3`: the law of cosines (a cos + b sin = c, two values).
    /// 3. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 4. `q4`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 5. `q5`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 6. `q6`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::runtime::frame_of(target, 1.2200000000000002) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 8]; 6];
        let mut valid = [0.0; 8];
        if !self.lanes(&frame, &mut q, &mut valid) {
            return self.robust(target);
        }
        if valid == [1.0; 8] {
            let at = |l: usize| ::dh_robot::runtime::lanes::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                l,
            );
            return ::dh_robot::Solutions::full(
                &Self::JOINTS,
                [at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)],
            );
        }
        ::dh_robot::runtime::lanes::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        pick: ::dh_robot::runtime::Pick,
        found: &mut dyn FnMut([f64; 6], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = t[0][3] - t[0][2] * 0.06557377049180327;
        let t_3 = t[1][3] - t[1][2] * 0.06557377049180327;
        let t_4 = t[2][3] - t[2][2] * 0.06557377049180327 - 0.32786885245901637;
        let t_5 = t_4 * t_4;
        let q1_roots = ::dh_robot::runtime::solve_sincos(-t_3, t_2, 0.0, 1e-11);
        if !q1_roots.is_regular() {
            attempt.note(q1_roots.outcome, free, "shoulder q1", 1.2200000000000002, "m");
        }
        let free = if q1_roots.is_free() {
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (q1_root, &[c1, s1]) in q1_roots.or_if_free(pick.angle(0)).iter().enumerate()
        {
            let q1 = ::dh_robot::runtime::atan2(s1, c1);
            let t_6 = t_2 * c1 + t_3 * s1;
            let t_7 = t_2 * s1 - t_3 * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let t_13 = t[0][2] * s1 - t[1][2] * c1;
            let t_14 = 0.020491803278688523 * (0.020491803278688523 - t_6 * 2.0);
            let t_15 = t_6 - 0.020491803278688523;
            let q3_roots = ::dh_robot::runtime::solve_sincos(
                0.014814565976887932,
                -0.15449475947325983,
                t_14 + t_6 * t_6 + t_7 * t_7 + t_5 - 0.15699744692287015,
                1e-11,
            );
            if !q3_roots.is_regular() {
                attempt
                    .note_law(
                        q3_roots.outcome,
                        free,
                        "elbow q3",
                        [
                            0.15699744692287015,
                            t_14 + t_6 * t_6 + t_7 * t_7 + t_5 - 0.15699744692287015,
                        ],
                        false,
                        1.2200000000000002,
                        "m",
                    );
            }
            let free = if q3_roots.is_free() {
                free.union(::dh_robot::FreeJoints::of(&[2]))
            } else {
                free
            };
            for (q3_root, &[c3, s3]) in q3_roots
                .or_if_free(pick.angle(1))
                .iter()
                .enumerate()
            {
                let q3 = ::dh_robot::runtime::atan2(s3, c3);
                let t_16 = 0.25819672131147536 + c3 * 0.028688524590163935
                    - 0.2991803278688524 * s3;
                let q2_roots = ::dh_robot::runtime::solve_pair(
                    -t_15,
                    t_4,
                    -(0.2991803278688524 * c3 + 0.028688524590163935 * s3),
                    t_4,
                    t_15,
                    t_16,
                    1e-11,
                );
                if !q2_roots.is_regular() {
                    attempt.note(q2_roots.outcome, free, "q2", 1.0, "");
                }
                let free = if q2_roots.is_free() {
                    free.union(::dh_robot::FreeJoints::of(&[1]))
                } else {
                    free
                };
                for (q2_root, &[c2, s2]) in q2_roots
                    .or_if_free(pick.angle(2))
                    .iter()
                    .enumerate()
                {
                    let q2 = ::dh_robot::runtime::atan2(s2, c2);
                    let t_17 = t_8 * c2 - t[2][0] * s2;
                    let t_18 = t_8 * s2 + t[2][0] * c2;
                    let t_19 = t_10 * c2 - t[2][1] * s2;
                    let t_20 = t_10 * s2 + t[2][1] * c2;
                    let t_21 = t_12 * c2 - t[2][2] * s2;
                    let t_22 = t_12 * s2 + t[2][2] * c2;
                    let t_23 = c3 * t_18 + s3 * t_17;
                    let t_24 = s3 * t_18 - c3 * t_17;
                    let t_25 = c3 * t_20 + s3 * t_19;
                    let t_26 = s3 * t_20 - c3 * t_19;
                    let t_27 = c3 * t_22 + s3 * t_21;
                    let q4_roots = ::dh_robot::runtime::solve_sincos(
                        -t_13,
                        t_27,
                        0.0,
                        1e-11,
                    );
                    if !q4_roots.is_regular() {
                        attempt.note(q4_roots.outcome, free, "wrist q4", 1.0, "");
                    }
                    let free = if q4_roots.is_free() {
                        free.union(::dh_robot::FreeJoints::of(&[3]))
                    } else {
                        free
                    };
                    for (q4_root, &[c4, s4]) in q4_roots
                        .or_if_free(pick.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let q4 = ::dh_robot::runtime::atan2(s4, c4);
                        let t_28 = t_23 * c4 + t_9 * s4;
                        let t_29 = t_25 * c4 + t_11 * s4;
                        let q5_roots = ::dh_robot::runtime::solve_pair(
                            0.0,
                            -1.0,
                            t_27 * c4 + t_13 * s4,
                            1.0,
                            0.0,
                            -(s3 * t_22 - c3 * t_21),
                            1e-11,
                        );
                        if !q5_roots.is_regular() {
                            attempt.note(q5_roots.outcome, free, "q5", 1.0, "");
                        }
                        let free = if q5_roots.is_free() {
                            free.union(::dh_robot::FreeJoints::of(&[4]))
                        } else {
                            free
                        };
                        for (q5_root, &[c5, s5]) in q5_roots
                            .or_if_free(pick.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q5 = ::dh_robot::runtime::atan2(s5, c5);
                            let q6_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                t_28 * c5 - t_24 * s5,
                                0.0,
                                -1.0,
                                t_29 * c5 - t_26 * s5,
                                1e-11,
                            );
                            if !q6_roots.is_regular() {
                                attempt.note(q6_roots.outcome, free, "q6", 1.0, "");
                            }
                            let free = if q6_roots.is_free() {
                                free.union(::dh_robot::FreeJoints::of(&[5]))
                            } else {
                                free
                            };
                            for (q6_root, &[c6, s6]) in q6_roots
                                .or_if_free(pick.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let q6 = ::dh_robot::runtime::atan2(s6, c6);
                                let branch = ::dh_robot::Branch::ANY
                                    .with_step(0, q1_root)
                                    .with_shoulder(
                                        if q1_root == 1 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    )
                                    .with_step(1, q3_root)
                                    .with_elbow(
                                        if (q3_root == 1) == (q1_root == 0) {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(2, q4_root)
                                    .with_wrist(
                                        if q4_root == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    );
                                found([q1, q2, q3, q4, q5, q6], branch, free);
                            }
                        }
                    }
                }
            }
        }
        attempt
    }
    /// The plan root by root, with everything that special poses need.
    #[cold]
    #[inline(never)]
    fn robust(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::runtime::frame_of(target, 1.2200000000000002) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 1.2200000000000002,
            few: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 1.2200000000000002),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    const BRANCHES: [::dh_robot::Branch; 8] = {
        let mut all = [::dh_robot::Branch::ANY; 8];
        let mut l = 0;
        while l < 8 {
            let q1_root = l / 1 % 2;
            let q3_root = l / 2 % 2;
            let q4_root = l / 4 % 2;
            all[l] = ::dh_robot::Branch::ANY
                .with_step(0, q1_root)
                .with_shoulder(
                    if q1_root == 1 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                )
                .with_step(1, q3_root)
                .with_elbow(
                    if (q3_root == 1) == (q1_root == 0) {
                        ::dh_robot::Elbow::Up
                    } else {
                        ::dh_robot::Elbow::Down
                    },
                )
                .with_step(2, q4_root)
                .with_wrist(
                    if q4_root == 0 {
                        ::dh_robot::Wrist::NoFlip
                    } else {
                        ::dh_robot::Wrist::Flip
                    },
                );
            l += 1;
        }
        all
    };
    /// The plan for all branches at once: joint values, and which branches are real; false where the robust way has to decide.
    #[inline]
    fn lanes(
        &self,
        t: &::dh_robot::runtime::Pose,
        q: &mut [[f64; 8]; 6],
        valid: &mut [f64; 8],
    ) -> bool {
        let t_2 = t[0][3] - t[0][2] * 0.06557377049180327;
        let t_3 = t[1][3] - t[1][2] * 0.06557377049180327;
        let t_4 = t[2][3] - t[2][2] * 0.06557377049180327 - 0.32786885245901637;
        let t_5 = t_4 * t_4;
        let ([x0, y0], m0) = ::dh_robot::runtime::lanes::half_turn([[-t_3, t_2]]);
        let c1_ = [x0, -x0];
        let s1_ = [y0, -y0];
        let g0_ = ::dh_robot::runtime::lanes::angles(&[y0, -y0], &[x0, -x0]);
        let mut v53_ = [0.0; 2];
        let mut v56_ = [0.0; 2];
        let mut v59_ = [0.0; 2];
        let mut v62_ = [0.0; 2];
        let mut v65_ = [0.0; 2];
        let mut v68_ = [0.0; 2];
        let mut v99_ = [0.0; 2];
        let mut f1 = [[0.0; 4]; 2];
        let mut margin1_ = [0.0; 2];
        let mut valid1_ = [0.0; 2];
        for l in 0..2 {
            let c1 = c1_[l];
            let s1 = s1_[l];
            let t_6 = t_2 * c1 + t_3 * s1;
            let t_7 = t_2 * s1 - t_3 * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let t_13 = t[0][2] * s1 - t[1][2] * c1;
            let t_14 = 0.020491803278688523 * (0.020491803278688523 - t_6 * 2.0);
            let t_15 = t_6 - 0.020491803278688523;
            v53_[l] = t_8;
            v56_[l] = t_9;
            v59_[l] = t_10;
            v62_[l] = t_11;
            v65_[l] = t_12;
            v68_[l] = t_13;
            v99_[l] = t_15;
            let ([x1, y1, z1, w1], e1, m1) = ::dh_robot::runtime::lanes::sincos(
                0.014814565976887932,
                -0.15449475947325983,
                t_14 + t_6 * t_6 + t_7 * t_7 + t_5 - 0.15699744692287015,
            );
            f1[0][l] = x1;
            f1[1][l] = y1;
            f1[0][l + 2] = z1;
            f1[1][l + 2] = w1;
            margin1_[l] = m1;
            valid1_[l] = e1;
        }
        let g1_ = ::dh_robot::runtime::lanes::angles(&f1[1], &f1[0]);
        q[2] = ::core::array::from_fn(|l| g1_[l / 2 % 2 * 2 + l % 2]);
        let c3_ = f1[0];
        let s3_ = f1[1];
        let v99_: [f64; 4] = ::core::array::from_fn(|l| v99_[l % 2]);
        let c1_: [f64; 4] = ::core::array::from_fn(|l| c1_[l % 2]);
        let s1_: [f64; 4] = ::core::array::from_fn(|l| s1_[l % 2]);
        let v53_: [f64; 4] = ::core::array::from_fn(|l| v53_[l % 2]);
        let v59_: [f64; 4] = ::core::array::from_fn(|l| v59_[l % 2]);
        let v65_: [f64; 4] = ::core::array::from_fn(|l| v65_[l % 2]);
        let v68_: [f64; 4] = ::core::array::from_fn(|l| v68_[l % 2]);
        let v56_: [f64; 4] = ::core::array::from_fn(|l| v56_[l % 2]);
        let v62_: [f64; 4] = ::core::array::from_fn(|l| v62_[l % 2]);
        let g0_: [f64; 4] = ::core::array::from_fn(|l| g0_[l / 1 % 2]);
        let margin1_: [f64; 4] = ::core::array::from_fn(|l| margin1_[l % 2]);
        let mut margin_ = [0.0; 4];
        let valid1_: [f64; 4] = ::core::array::from_fn(|l| valid1_[l % 2]);
        let mut valid_ = [0.0; 4];
        let mut error_ = [0.0; 4];
        for l in 0..4 {
            let c3 = c3_[l];
            let s3 = s3_[l];
            let t_16 = 0.25819672131147536 + c3 * 0.028688524590163935
                - 0.2991803278688524 * s3;
            let v99 = v99_[l];
            let ([c2, s2], m2) = ::dh_robot::runtime::lanes::pair(
                -v99,
                t_4,
                -(0.2991803278688524 * c3 + 0.028688524590163935 * s3),
                t_4,
                v99,
                t_16,
            );
            let g2 = ::dh_robot::runtime::lanes::angle(s2, c2);
            let c1 = c1_[l];
            let s1 = s1_[l];
            let v53 = v53_[l];
            let v59 = v59_[l];
            let v65 = v65_[l];
            let t_17 = v53 * c2 - t[2][0] * s2;
            let t_18 = v53 * s2 + t[2][0] * c2;
            let t_19 = v59 * c2 - t[2][1] * s2;
            let t_20 = v59 * s2 + t[2][1] * c2;
            let t_21 = v65 * c2 - t[2][2] * s2;
            let t_22 = v65 * s2 + t[2][2] * c2;
            let t_23 = c3 * t_18 + s3 * t_17;
            let t_24 = s3 * t_18 - c3 * t_17;
            let t_25 = c3 * t_20 + s3 * t_19;
            let t_26 = s3 * t_20 - c3 * t_19;
            let t_27 = c3 * t_22 + s3 * t_21;
            let t_28 = c3 * c2 - s3 * s2;
            let t_29 = c3 * s2 + s3 * c2;
            let t_30 = 0.028688524590163935 * t_29 + 0.2991803278688524 * t_28
                + 0.25819672131147536 * s2;
            let t_31 = 0.028688524590163935 * t_28 - 0.2991803278688524 * t_29
                + 0.25819672131147536 * c2;
            let t_32 = 0.020491803278688523 + t_30;
            let t_33 = 0.32786885245901637 + t_31;
            let t_34 = c1 * t_32;
            let t_35 = s1 * t_32;
            let v68 = v68_[l];
            let ([c4, s4], m3) = ::dh_robot::runtime::lanes::half_turn([[-v68, t_27]]);
            let g3 = ::dh_robot::runtime::lanes::angle(s4, c4);
            let v56 = v56_[l];
            let v62 = v62_[l];
            let t_36 = t_23 * c4 + v56 * s4;
            let t_37 = t_25 * c4 + v62 * s4;
            let [c5, s5] = ::dh_robot::runtime::lanes::unit(
                -(s3 * t_22 - c3 * t_21),
                -(t_27 * c4 + v68 * s4),
            );
            let g4 = ::dh_robot::runtime::lanes::angle(s5, c5);
            let c4s5 = c4 * s5;
            let s4s5 = s4 * s5;
            let t_38 = t_29 * c4s5 - c5 * t_28;
            let t_39 = t_28 * c4s5 + c5 * t_29;
            let t_40 = c1 * t_38 + s1 * s4s5;
            let t_41 = s1 * t_38 - c1 * s4s5;
            let r5 = (-t_40 - t[0][2]).abs() + (-t_41 - t[1][2]).abs()
                + (-t_39 - t[2][2]).abs()
                + (t_34 - 0.06557377049180327 * t_40 - t[0][3]).abs()
                + (t_35 - 0.06557377049180327 * t_41 - t[1][3]).abs()
                + (t_33 - 0.06557377049180327 * t_39 - t[2][3]).abs();
            let [c6, s6] = ::dh_robot::runtime::lanes::unit(
                t_36 * c5 - t_24 * s5,
                -(t_37 * c5 - t_26 * s5),
            );
            let g5 = ::dh_robot::runtime::lanes::angle(s6, c6);
            let c5c6 = c5 * c6;
            let s5c6 = s5 * c6;
            let t_42 = c4 * c5c6 - s4 * s6;
            let t_43 = s4 * c5c6 + c4 * s6;
            let t_44 = t_42 * t_29 + s5c6 * t_28;
            let r6 = (c1 * t_44 + s1 * t_43 - t[0][0]).abs()
                + (s1 * t_44 - c1 * t_43 - t[1][0]).abs()
                + (t_42 * t_28 - s5c6 * t_29 - t[2][0]).abs();
            let g0 = g0_[l];
            let margin1 = margin1_[l];
            let valid1 = valid1_[l];
            margin_[l] = ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(
                    ::dh_robot::runtime::lanes::lesser(m0, margin1),
                    m2,
                ),
                m3,
            );
            valid_[l] = valid1;
            error_[l] = r5 + r6;
            let h3 = ::dh_robot::runtime::lanes::opposite(g3);
            let h4 = ::dh_robot::runtime::lanes::negative(g4);
            let h5 = ::dh_robot::runtime::lanes::opposite(g5);
            q[0][l] = g0;
            q[1][l] = ::dh_robot::runtime::lanes::into_range(
                g2,
                -3.316125578789226,
                0.7853981633974483,
            );
            q[3][l] = g3;
            q[4][l] = g4;
            q[5][l] = g5;
            q[0][l + 4] = g0;
            q[1][l + 4] = ::dh_robot::runtime::lanes::into_range(
                g2,
                -3.316125578789226,
                0.7853981633974483,
            );
            q[3][l + 4] = h3;
            q[4][l + 4] = h4;
            q[5][l + 4] = h5;
        }
        *valid = ::core::array::from_fn(|l| valid_[l % 4]);
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for KukaKr6R700 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * s23 + c6s5 * c23;
        let t_5 = t_2 * c23 - c6s5 * s23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = s23 * s5c4 - c5 * c23;
        let t_9 = c23 * s5c4 + c5 * s23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = s23 * 0.035 + c23 * 0.365 + 0.315 * s2 + 0.025;
        let t_13 = c23 * 0.035 - s23 * 0.365 + 0.315 * c2 + 0.4 - t_9 * 0.08;
        [
            [t_6, -(t_5 * t_11 - t_7 * t_9), -t_10, c1 * t_12 - t_10 * 0.08],
            [t_7, -(t_6 * t_9 - t_5 * t_10), -t_11, s1 * t_12 - t_11 * 0.08],
            [t_5, -(t_7 * t_10 - t_6 * t_11), -t_9, t_13],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[5], q[1]];
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c23c4 = c23 * c4;
        let t_2 = c1s23 * c4 + s1 * s4;
        let t_3 = s1s23 * c4 - c1 * s4;
        let c23s4 = c23 * s4;
        let t_4 = s1 * c4 - c1s23 * s4;
        let t_5 = c1 * c4 + s1s23 * s4;
        let t_6 = t_2 * c5 + c1c23 * s5;
        let t_7 = t_3 * c5 + s1c23 * s5;
        let t_8 = c23c4 * c5 - s23 * s5;
        let t_9 = c1c23 * c5 - t_2 * s5;
        let t_10 = s1c23 * c5 - t_3 * s5;
        let t_11 = s23 * c5 + c23c4 * s5;
        let t_12 = s5 * 0.08;
        let t_13 = c5 * 0.08 + 0.365;
        let t_14 = s4 * t_12;
        let t_15 = c4 * t_12 - 0.035;
        let t_16 = s23 * t_15 - c23 * t_13;
        let t_17 = c23 * t_15 + s23 * t_13;
        let t_18 = t_16 - 0.315 * s2;
        let t_19 = t_17 - 0.315 * c2;
        let t_20 = t_18 - 0.025;
        let t_21 = c1 * t_20 + s1 * t_14;
        let t_22 = s1 * t_20 - c1 * t_14;
        (
            [
                [t_6 * c6 + t_4 * s6, t_4 * c6 - t_6 * s6, t_9, -t_21],
                [t_7 * c6 - t_5 * s6, -(t_5 * c6 + t_7 * s6), t_10, -t_22],
                [t_8 * c6 - c23s4 * s6, -(c23s4 * c6 + t_8 * s6), -t_11, -(t_19 - 0.4)],
            ],
            [
                [t_22, -c1 * t_19, -c1 * t_17, -t_4 * t_12, -t_6 * 0.08, 0.0],
                [-t_21, -s1 * t_19, -s1 * t_17, t_5 * t_12, -t_7 * 0.08, 0.0],
                [0.0, t_18, t_16, c23s4 * t_12, -t_8 * 0.08, 0.0],
                [0.0, -s1, -s1, c1c23, -t_4, t_9],
                [0.0, c1, c1, s1c23, t_5, t_10],
                [1.0, 0.0, 0.0, -s23, c23s4, -t_11],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, 8, f64> for KukaKr6R700 {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 8> {
        KukaKr6R700::inverse(self, target)
    }
}
