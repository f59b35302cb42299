// What `dh_robot!` makes of src/stanford.rs. Made by `cargo regen`; do not edit.

/// The Stanford arm: its third joint slides.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | 1 | q1 | 412mm | 0 | -90deg | -170deg..=170deg |
/// | 2 | q2 | 154mm | 0 | 90deg | -170deg..=170deg |
/// | 3 | -90deg | q3 | 20.3mm | 0 | 304.8mm..=1270mm |
/// | 4 | q4 | 0 | 0 | -90deg | -170deg..=170deg |
/// | 5 | q5 | 0 | 0 | 90deg | -90deg..=90deg |
/// | 6 | q6 | 0 | 0 | 0 | -170deg..=170deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁[c₂(s₄c₅c₆ + c₄s₆) − s₂s₅c₆] + s₁(c₄c₅c₆ − s₄s₆)
/// r₂₁ = s₁[c₂(s₄c₅c₆ + c₄s₆) − s₂s₅c₆] − c₁(c₄c₅c₆ − s₄s₆)
/// r₃₁ = −s₂(s₄c₅c₆ + c₄s₆) − c₂s₅c₆
/// r₁₂ = −c₁[c₂(s₄c₅s₆ − c₄c₆) − s₂s₅s₆] − s₁(c₄c₅s₆ + s₄c₆)
/// r₂₂ = −s₁[c₂(s₄c₅s₆ − c₄c₆) − s₂s₅s₆] + c₁(c₄c₅s₆ + s₄c₆)
/// r₃₂ = s₂(s₄c₅s₆ − c₄c₆) + c₂s₅s₆
/// r₁₃ = c₁(c₂s₄s₅ + s₂c₅) + s₁c₄s₅
/// r₂₃ = s₁(c₂s₄s₅ + s₂c₅) − c₁c₄s₅
/// r₃₃ = c₂c₅ − s₂s₄s₅
/// px  = s₁(a₃ − d₂) + q₃c₁s₂
/// py  = c₁(d₂ − a₃) + q₃s₁s₂
/// pz  = d₁ + q₃c₂
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 4, 5, 6; d₁ = 0.412, d₂ = 0.154, a₃ = 0.0203
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stanford;
impl ::core::default::Default for Stanford {
    fn default() -> Self {
        Stanford
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Stanford {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::prismatic("q3").with_range(0.3048, 1.27),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-1.5707963267948966, 1.5707963267948966),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-2.9670597283903604, 2.9670597283903604),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 36 multiplications, 16 additions, 5 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1], q[0]];
        let ([s6, s5, s4, s2, s1], [c6, c5, c4, c2, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * s4 + s6 * c4;
        let t_3 = c6c5 * c4 - s6 * s4;
        let t_4 = t_2 * c2 - c6s5 * s2;
        let t_5 = t_2 * s2 + c6s5 * c2;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5s4 = s5 * s4;
        let s5c4 = s5 * c4;
        let t_8 = c2 * s5s4 + c5 * s2;
        let t_9 = s2 * s5s4 - c5 * c2;
        let t_10 = c1 * t_8 + s1 * s5c4;
        let t_11 = s1 * t_8 - c1 * s5c4;
        let t_12 = s2 * q[2];
        ::dh_robot::pose::from_entries(
            [
                [t_6, -(t_5 * t_11 - t_7 * t_9), t_10],
                [t_7, -(t_6 * t_9 - t_5 * t_10), t_11],
                [-t_5, t_7 * t_10 - t_6 * t_11, -t_9],
            ],
            [
                c1 * t_12 - s1 * 0.13369999999999999,
                s1 * t_12 + c1 * 0.13369999999999999,
                c2 * q[2] + 0.412,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 45 multiplications, 21 additions, 5 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = s1 * 0.154;
        let t_3 = c1 * 0.154;
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let t_4 = 0.412 + c2 * q[2];
        let t_5 = t_2 - c1s2 * q[2] - s1 * 0.0203;
        let t_6 = t_3 + s1s2 * q[2] - c1 * 0.0203;
        let s2s4 = s2 * s4;
        let t_7 = c1c2 * s4 + s1 * c4;
        let t_8 = s1c2 * s4 - c1 * c4;
        let s2c4 = s2 * c4;
        let t_9 = s1 * s4 - c1c2 * c4;
        let t_10 = c1 * s4 + s1c2 * c4;
        let t_11 = t_7 * c5 - c1s2 * s5;
        let t_12 = t_8 * c5 - s1s2 * s5;
        let t_13 = s2s4 * c5 + c2 * s5;
        let t_14 = c1s2 * c5 + t_7 * s5;
        let t_15 = s1s2 * c5 + t_8 * s5;
        let t_16 = c2 * c5 - s2s4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
                [0.0, 0.0, 0.412],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c2, -s1, c1s2], [s1c2, c1, s1s2], [-s2, 0.0, c2]],
                [-t_2, t_3, 0.412],
            ),
            ::dh_robot::pose::from_entries(
                [[s1, c1c2, c1s2], [-c1, s1c2, s1s2], [0.0, -s2, c2]],
                [-t_5, t_6, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [[t_7, -c1s2, -t_9], [t_8, -s1s2, t_10], [-s2s4, -c2, -s2c4]],
                [-t_5, t_6, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [[t_11, -t_9, t_14], [t_12, t_10, t_15], [-t_13, -s2c4, t_16]],
                [-t_5, t_6, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_11 * c6 - t_9 * s6, -(t_9 * c6 + t_11 * s6), t_14],
                    [t_12 * c6 + t_10 * s6, t_10 * c6 - t_12 * s6, t_15],
                    [-(t_13 * c6 + s2c4 * s6), -(s2c4 * c6 - t_13 * s6), t_16],
                ],
                [-t_5, t_6, t_4],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 26 multiplications, 8 additions, 4 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1], q[3], q[4]];
        let ([s1, s2, s4, s5], [c1, c2, c4, c5]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let c2c4 = c2 * c4;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        let t_2 = c2 * s4s5 + s2 * c5;
        let t_3 = s2 * q[2];
        let t_4 = c2 * q[2];
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [
                    -(s1 * t_3 + c1 * 0.13369999999999999),
                    c1 * t_3 - s1 * 0.13369999999999999,
                    0.0,
                    0.0,
                    0.0,
                    1.0,
                ],
                [c1 * t_4, s1 * t_4, -t_3, -s1, c1, 0.0],
                [c1s2, s1s2, c2, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, c1s2, s1s2, c2],
                [0.0, 0.0, 0.0, c1 * c2c4 - s1 * s4, s1 * c2c4 + c1 * s4, -s2 * c4],
                [
                    0.0,
                    0.0,
                    0.0,
                    c1 * t_2 + s1 * c4s5,
                    s1 * t_2 - c1 * c4s5,
                    -(s2 * s4s5 - c2 * c5),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 44 multiplications, 18 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let c2c4 = c2 * c4;
        let s2c4 = s2 * c4;
        let t_2 = c1 * c2c4 - s1 * s4;
        let t_3 = s1 * c2c4 + c1 * s4;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        let t_4 = c2 * s4s5 + s2 * c5;
        let t_5 = s2 * s4s5 - c2 * c5;
        let t_6 = c1 * t_4 + s1 * c4s5;
        let t_7 = s1 * t_4 - c1 * c4s5;
        let t_8 = t_3 * t_5 - s2c4 * t_7;
        let t_9 = s2c4 * t_6 - t_2 * t_5;
        let t_10 = t_2 * t_7 - t_3 * t_6;
        let t_11 = s2 * q[2];
        let t_12 = c2 * q[2];
        let t_13 = c1 * t_11 - s1 * 0.13369999999999999;
        let t_14 = s1 * t_11 + c1 * 0.13369999999999999;
        (
            ::dh_robot::pose::from_entries(
                [
                    [-(t_8 * c6 - t_2 * s6), t_2 * c6 + t_8 * s6, t_6],
                    [-(t_9 * c6 - t_3 * s6), t_3 * c6 + t_9 * s6, t_7],
                    [t_10 * c6 - s2c4 * s6, -(s2c4 * c6 + t_10 * s6), -t_5],
                ],
                [t_13, t_14, t_12 + 0.412],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_14, t_13, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_12, s1 * t_12, -t_11, -s1, c1, 0.0],
                    [c1s2, s1s2, c2, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, c1s2, s1s2, c2],
                    [0.0, 0.0, 0.0, t_2, t_3, -s2c4],
                    [0.0, 0.0, 0.0, t_6, t_7, -t_5],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for Stanford {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Stanford {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Stanford::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Stanford::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Stanford {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Stanford::jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Stanford {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: an equation in sine and cosine (a cos + b sin = c, two values).
    /// 2. `q2`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 3. `q3`: a linear equation (a d + b = 0, one value).
    /// 4. `q6`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 5. `q4`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 6. `q5`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::runtime::frame_of(target, 0.5862999999999999) {
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
        let t_2 = t[2][3] - 0.7027119222241174;
        let q1_roots = ::dh_robot::runtime::solve_sincos(
            -t[1][3],
            t[0][3],
            -0.22804025243049636,
            1e-11,
        );
        if !q1_roots.is_regular() {
            attempt.note(q1_roots.outcome, free, "shoulder q1", 0.5862999999999999, "m");
        }
        let free = if q1_roots.is_free() {
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (q1_root, &[c1, s1]) in q1_roots.or_if_free(pick.angle(0)).iter().enumerate()
        {
            let q1 = ::dh_robot::runtime::atan2(s1, c1);
            let t_3 = t[0][3] * c1 + t[1][3] * s1;
            let t_4 = t[0][0] * c1 + t[1][0] * s1;
            let t_5 = t[0][0] * s1 - t[1][0] * c1;
            let t_6 = t[0][1] * c1 + t[1][1] * s1;
            let t_7 = t[0][1] * s1 - t[1][1] * c1;
            let t_8 = t[0][2] * c1 + t[1][2] * s1;
            let t_9 = t[0][2] * s1 - t[1][2] * c1;
            let q2_roots = ::dh_robot::runtime::solve_sincos(-t_3, t_2, 0.0, 1e-11);
            if !q2_roots.is_regular() {
                attempt
                    .note(q2_roots.outcome, free, "elbow q2", 0.5862999999999999, "m");
            }
            let free = if q2_roots.is_free() {
                free.union(::dh_robot::FreeJoints::of(&[1]))
            } else {
                free
            };
            for (q2_root, &[c2, s2]) in q2_roots
                .or_if_free(pick.angle(1))
                .iter()
                .enumerate()
            {
                let q2 = ::dh_robot::runtime::atan2(s2, c2);
                let t_10 = t_4 * c2 - t[2][0] * s2;
                let t_11 = t_6 * c2 - t[2][1] * s2;
                let t_12 = t_8 * c2 - t[2][2] * s2;
                let q3_roots = ::dh_robot::runtime::solve_quadratic(
                    0.0,
                    -1.0,
                    t_3 * s2 + t_2 * c2,
                    1e-11,
                );
                if !q3_roots.is_regular() {
                    attempt.note(q3_roots.outcome, free, "q3", 0.5862999999999999, "m");
                }
                let free = if q3_roots.is_free() {
                    free.union(::dh_robot::FreeJoints::of(&[2]))
                } else {
                    free
                };
                for (q3_root, &q3_scaled) in q3_roots
                    .or_if_free(pick.length(2))
                    .iter()
                    .enumerate()
                {
                    let q3 = q3_scaled * 0.5862999999999999;
                    let q6_roots = ::dh_robot::runtime::solve_sincos(
                        t_6 * s2 + t[2][1] * c2,
                        t_4 * s2 + t[2][0] * c2,
                        0.0,
                        1e-11,
                    );
                    if !q6_roots.is_regular() {
                        attempt.note(q6_roots.outcome, free, "wrist q6", 1.0, "");
                    }
                    let free = if q6_roots.is_free() {
                        free.union(::dh_robot::FreeJoints::of(&[5]))
                    } else {
                        free
                    };
                    for (q6_root, &[c6, s6]) in q6_roots
                        .or_if_free(pick.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let q6 = ::dh_robot::runtime::atan2(s6, c6);
                        let q4_roots = ::dh_robot::runtime::solve_pair(
                            0.0,
                            -1.0,
                            t_5 * s6 + t_7 * c6,
                            1.0,
                            0.0,
                            t_10 * s6 + t_11 * c6,
                            1e-11,
                        );
                        if !q4_roots.is_regular() {
                            attempt.note(q4_roots.outcome, free, "q4", 1.0, "");
                        }
                        let free = if q4_roots.is_free() {
                            free.union(::dh_robot::FreeJoints::of(&[3]))
                        } else {
                            free
                        };
                        for (q4_root, &[c4, s4]) in q4_roots
                            .or_if_free(pick.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q4 = ::dh_robot::runtime::atan2(s4, c4);
                            let t_13 = c6 * (t_5 * c4 + t_10 * s4)
                                - s6 * (t_7 * c4 + t_11 * s4);
                            let q5_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                t_13,
                                0.0,
                                -1.0,
                                -(t_9 * c4 + t_12 * s4),
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
                                .or_if_free(pick.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let q5 = ::dh_robot::runtime::atan2(s5, c5);
                                let branch = ::dh_robot::Branch::ANY
                                    .with_step(0, q1_root)
                                    .with_shoulder(
                                        if q1_root == 1 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    )
                                    .with_step(1, q2_root)
                                    .with_elbow(
                                        if q2_root == 0 {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(2, q6_root)
                                    .with_wrist(
                                        if q6_root == 0 {
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
        let frame = match ::dh_robot::runtime::frame_of(target, 0.5862999999999999) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 0.5862999999999999,
            few: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 0.5862999999999999),
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
            let q2_root = l / 2 % 2;
            let q6_root = l / 4 % 2;
            all[l] = ::dh_robot::Branch::ANY
                .with_step(0, q1_root)
                .with_shoulder(
                    if q1_root == 1 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                )
                .with_step(1, q2_root)
                .with_elbow(
                    if q2_root == 0 {
                        ::dh_robot::Elbow::Up
                    } else {
                        ::dh_robot::Elbow::Down
                    },
                )
                .with_step(2, q6_root)
                .with_wrist(
                    if q6_root == 0 {
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
        let t_2 = t[2][3] - 0.7027119222241174;
        let ([x0, y0, z0, w0], e0, m0) = ::dh_robot::runtime::lanes::sincos(
            -t[1][3],
            t[0][3],
            -0.22804025243049636,
        );
        let c1_ = [x0, z0];
        let s1_ = [y0, w0];
        let g0_ = ::dh_robot::runtime::lanes::angles(&[y0, w0], &[x0, z0]);
        let mut v39_ = [0.0; 2];
        let mut v47_ = [0.0; 2];
        let mut v50_ = [0.0; 2];
        let mut v53_ = [0.0; 2];
        let mut v56_ = [0.0; 2];
        let mut v59_ = [0.0; 2];
        let mut v62_ = [0.0; 2];
        let mut v272_ = [0.0; 2];
        let mut v275_ = [0.0; 2];
        let mut f1 = [[0.0; 4]; 2];
        let mut margin1_ = [0.0; 2];
        for l in 0..2 {
            let c1 = c1_[l];
            let s1 = s1_[l];
            let t_3 = t[0][3] * c1 + t[1][3] * s1;
            let t_4 = t[0][0] * c1 + t[1][0] * s1;
            let t_5 = t[0][0] * s1 - t[1][0] * c1;
            let t_6 = t[0][1] * c1 + t[1][1] * s1;
            let t_7 = t[0][1] * s1 - t[1][1] * c1;
            let t_8 = t[0][2] * c1 + t[1][2] * s1;
            let t_9 = t[0][2] * s1 - t[1][2] * c1;
            let t_10 = 0.22804025243049636 * s1;
            let t_11 = 0.22804025243049636 * c1;
            v39_[l] = t_3;
            v47_[l] = t_4;
            v50_[l] = t_5;
            v53_[l] = t_6;
            v56_[l] = t_7;
            v59_[l] = t_8;
            v62_[l] = t_9;
            v272_[l] = t_10;
            v275_[l] = t_11;
            let ([x1, y1], m1) = ::dh_robot::runtime::lanes::half_turn([[-t_3, t_2]]);
            f1[0][l] = x1;
            f1[1][l] = y1;
            f1[0][l + 2] = -x1;
            f1[1][l + 2] = -y1;
            margin1_[l] = m1;
        }
        let g1_ = ::dh_robot::runtime::lanes::angles(&f1[1], &f1[0]);
        q[1] = ::core::array::from_fn(|l| g1_[l / 2 % 2 * 2 + l % 2]);
        let c2_ = f1[0];
        let s2_ = f1[1];
        let v39_: [f64; 4] = ::core::array::from_fn(|l| v39_[l % 2]);
        let v47_: [f64; 4] = ::core::array::from_fn(|l| v47_[l % 2]);
        let v53_: [f64; 4] = ::core::array::from_fn(|l| v53_[l % 2]);
        let v59_: [f64; 4] = ::core::array::from_fn(|l| v59_[l % 2]);
        let c1_: [f64; 4] = ::core::array::from_fn(|l| c1_[l % 2]);
        let s1_: [f64; 4] = ::core::array::from_fn(|l| s1_[l % 2]);
        let v272_: [f64; 4] = ::core::array::from_fn(|l| v272_[l % 2]);
        let v275_: [f64; 4] = ::core::array::from_fn(|l| v275_[l % 2]);
        let v50_: [f64; 4] = ::core::array::from_fn(|l| v50_[l % 2]);
        let v56_: [f64; 4] = ::core::array::from_fn(|l| v56_[l % 2]);
        let v62_: [f64; 4] = ::core::array::from_fn(|l| v62_[l % 2]);
        let g0_: [f64; 4] = ::core::array::from_fn(|l| g0_[l / 1 % 2]);
        let margin1_: [f64; 4] = ::core::array::from_fn(|l| margin1_[l % 2]);
        let mut margin_ = [0.0; 4];
        let mut valid_ = [0.0; 4];
        let mut error_ = [0.0; 4];
        for l in 0..4 {
            let v39 = v39_[l];
            let v47 = v47_[l];
            let v53 = v53_[l];
            let v59 = v59_[l];
            let c2 = c2_[l];
            let s2 = s2_[l];
            let t_12 = v47 * c2 - t[2][0] * s2;
            let t_13 = v53 * c2 - t[2][1] * s2;
            let t_14 = v59 * c2 - t[2][2] * s2;
            let (q3_scaled, m2) = ::dh_robot::runtime::lanes::linear(
                -1.0,
                v39 * s2 + t_2 * c2,
            );
            let q3_scaled = q3_scaled;
            let g2 = q3_scaled * 0.5862999999999999;
            let c1 = c1_[l];
            let s1 = s1_[l];
            let v272 = v272_[l];
            let v275 = v275_[l];
            let t_15 = s2 * q3_scaled;
            let r3 = (c1 * t_15 - v272 - t[0][3]).abs()
                + (s1 * t_15 + v275 - t[1][3]).abs()
                + (0.7027119222241174 + c2 * q3_scaled - t[2][3]).abs();
            let ([c6, s6], m3) = ::dh_robot::runtime::lanes::half_turn([
                [v53 * s2 + t[2][1] * c2, v47 * s2 + t[2][0] * c2],
            ]);
            let g3 = ::dh_robot::runtime::lanes::angle(s6, c6);
            let v50 = v50_[l];
            let v56 = v56_[l];
            let [c4, s4] = ::dh_robot::runtime::lanes::unit(
                t_12 * s6 + t_13 * c6,
                -(v50 * s6 + v56 * c6),
            );
            let g4 = ::dh_robot::runtime::lanes::angle(s4, c4);
            let v62 = v62_[l];
            let t_16 = c6 * (v50 * c4 + t_12 * s4) - s6 * (v56 * c4 + t_13 * s4);
            let s6c4 = s6 * c4;
            let s6s4 = s6 * s4;
            let [c5, s5] = ::dh_robot::runtime::lanes::unit(t_16, v62 * c4 + t_14 * s4);
            let g5 = ::dh_robot::runtime::lanes::angle(s5, c5);
            let c6c5 = c6 * c5;
            let c6s5 = c6 * s5;
            let t_17 = s4 * c6c5 + s6c4;
            let t_18 = c4 * c6c5 - s6s4;
            let t_19 = c2 * t_17 - s2 * c6s5;
            let s4s5 = s4 * s5;
            let c4s5 = c4 * s5;
            let t_20 = c2 * s4s5 + s2 * c5;
            let r6 = (c1 * t_19 + s1 * t_18 - t[0][0]).abs()
                + (s1 * t_19 - c1 * t_18 - t[1][0]).abs()
                + (-(s2 * t_17 + c2 * c6s5) - t[2][0]).abs()
                + (c1 * t_20 + s1 * c4s5 - t[0][2]).abs()
                + (s1 * t_20 - c1 * c4s5 - t[1][2]).abs()
                + (-(s2 * s4s5 - c2 * c5) - t[2][2]).abs();
            let g0 = g0_[l];
            let margin1 = margin1_[l];
            margin_[l] = ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(
                    ::dh_robot::runtime::lanes::lesser(m0, margin1),
                    m2,
                ),
                m3,
            );
            valid_[l] = e0;
            error_[l] = r3 + r6;
            let h3 = ::dh_robot::runtime::lanes::opposite(g3);
            let h4 = ::dh_robot::runtime::lanes::opposite(g4);
            let h5 = ::dh_robot::runtime::lanes::negative(g5);
            q[0][l] = g0;
            q[2][l] = g2;
            q[3][l] = g4;
            q[4][l] = g5;
            q[5][l] = g3;
            q[0][l + 4] = g0;
            q[2][l + 4] = g2;
            q[3][l + 4] = h4;
            q[4][l + 4] = h5;
            q[5][l + 4] = h3;
        }
        *valid = ::core::array::from_fn(|l| valid_[l % 4]);
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for Stanford {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5], q[4], q[3], q[1], q[0]];
        let ([s6, s5, s4, s2, s1], [c6, c5, c4, c2, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * s4 + s6 * c4;
        let t_3 = c6c5 * c4 - s6 * s4;
        let t_4 = t_2 * c2 - c6s5 * s2;
        let t_5 = t_2 * s2 + c6s5 * c2;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5s4 = s5 * s4;
        let s5c4 = s5 * c4;
        let t_8 = c2 * s5s4 + c5 * s2;
        let t_9 = s2 * s5s4 - c5 * c2;
        let t_10 = c1 * t_8 + s1 * s5c4;
        let t_11 = s1 * t_8 - c1 * s5c4;
        let t_12 = s2 * q[2];
        [
            [t_6, -(t_5 * t_11 - t_7 * t_9), t_10, c1 * t_12 - s1 * 0.13369999999999999],
            [t_7, -(t_6 * t_9 - t_5 * t_10), t_11, s1 * t_12 + c1 * 0.13369999999999999],
            [-t_5, t_7 * t_10 - t_6 * t_11, -t_9, c2 * q[2] + 0.412],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let c2c4 = c2 * c4;
        let s2c4 = s2 * c4;
        let t_2 = c1 * c2c4 - s1 * s4;
        let t_3 = s1 * c2c4 + c1 * s4;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        let t_4 = c2 * s4s5 + s2 * c5;
        let t_5 = s2 * s4s5 - c2 * c5;
        let t_6 = c1 * t_4 + s1 * c4s5;
        let t_7 = s1 * t_4 - c1 * c4s5;
        let t_8 = t_3 * t_5 - s2c4 * t_7;
        let t_9 = s2c4 * t_6 - t_2 * t_5;
        let t_10 = t_2 * t_7 - t_3 * t_6;
        let t_11 = s2 * q[2];
        let t_12 = c2 * q[2];
        let t_13 = c1 * t_11 - s1 * 0.13369999999999999;
        let t_14 = s1 * t_11 + c1 * 0.13369999999999999;
        (
            [
                [-(t_8 * c6 - t_2 * s6), t_2 * c6 + t_8 * s6, t_6, t_13],
                [-(t_9 * c6 - t_3 * s6), t_3 * c6 + t_9 * s6, t_7, t_14],
                [t_10 * c6 - s2c4 * s6, -(s2c4 * c6 + t_10 * s6), -t_5, t_12 + 0.412],
            ],
            [
                [-t_14, c1 * t_12, c1s2, 0.0, 0.0, 0.0],
                [t_13, s1 * t_12, s1s2, 0.0, 0.0, 0.0],
                [0.0, -t_11, c2, 0.0, 0.0, 0.0],
                [0.0, -s1, 0.0, c1s2, t_2, t_6],
                [0.0, c1, 0.0, s1s2, t_3, t_7],
                [1.0, 0.0, 0.0, c2, -s2c4, -t_5],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, 8, f64> for Stanford {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 8> {
        Stanford::inverse(self, target)
    }
}
