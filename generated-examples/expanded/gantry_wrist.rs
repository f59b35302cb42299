// What `dh_robot!` makes of src/gantry_wrist.rs. Made by `cargo regen`; do not edit.

/// Three slides at right angles, and a spherical wrist.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in m:
///
/// | joint | alpha | a | d | theta |
/// |---|---|---|---|---|
/// | 1 | 0 | 0 | q1 | 90deg |
/// | 2 | 90deg | 0 | q2 | 90deg |
/// | 3 | 90deg | 0 | q3 | 0 |
/// | 4 | 0 | 0 | 100mm | q4 |
/// | 5 | 90deg | 0 | 0 | q5 |
/// | 6 | -90deg | 0 | 200mm | q6 + 30deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// ⎡ s₄c₅c₆ + c₄s₆   c₄c₆ − s₄c₅s₆  −s₄s₅  q₂ − d₆s₄s₅    ⎤
/// ⎢ s₅c₆           −s₅s₆            c₅    q₃ + d₄ + d₆c₅ ⎥
/// ⎣ c₄c₅c₆ − s₄s₆  −c₄c₅s₆ − s₄c₆  −c₄s₅  q₁ − d₆c₄s₅    ⎦
///
/// where c₄ = cos q₄, s₄ = sin q₄, c₅ = cos q₅, s₅ = sin q₅, c₆ = cos θ₆, s₆ = sin θ₆,
///      θ₆ = q₆ + 30°, d₄ = 0.1, d₆ = 0.2
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GantryWrist;
impl ::core::default::Default for GantryWrist {
    fn default() -> Self {
        GantryWrist
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
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
    /// Cost: 17 multiplications, 9 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5] + 0.5235987755982988, q[4], q[3]];
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c6_30 * c5;
        let t_3 = s6_30 * c5;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        ::dh_robot::pose::from_entries(
            [
                [t_2 * s4 + s6_30 * c4, -(s4 * t_3 - c6_30 * c4), -s5s4],
                [c6_30 * s5, -s6_30 * s5, c5],
                [t_2 * c4 - s6_30 * s4, -(c4 * t_3 + c6_30 * s4), -s5c4],
            ],
            [q[1] - s5s4 * 0.2, 0.1 + q[2] + c5 * 0.2, q[0] - s5c4 * 0.2],
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
        let ([s4, s5, s6_30], [c4, c5, c6_30]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = q[2] + 0.1;
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
                [q[1], t_2, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[s4c5, -s4s5, -c4], [s5, c5, 0.0], [c4c5, -c4s5, s4]],
                [q[1], t_2, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [s4c5 * c6_30 + c4 * s6_30, c4 * c6_30 - s4c5 * s6_30, -s4s5],
                    [s5 * c6_30, -s5 * s6_30, c5],
                    [c4c5 * c6_30 - s4 * s6_30, -(s4 * c6_30 + c4c5 * s6_30), -c4s5],
                ],
                [q[1] - s4s5 * 0.2, t_2 + c5 * 0.2, q[0] - c4s5 * 0.2],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 8 multiplications, 0 additions, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[4], q[3]];
        let ([s5, s4], [c5, c4]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s5 * 0.2;
        let t_3 = c5 * 0.2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
                [-c4 * t_2, 0.0, s4 * t_2, 0.0, 1.0, 0.0],
                [-s4 * t_3, -t_2, -c4 * t_3, -c4, 0.0, s4],
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
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c6_30 * c5;
        let t_3 = s6_30 * c5;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_4 = s5 * 0.2;
        let t_5 = c5 * 0.2;
        let t_6 = c4 * t_4;
        let t_7 = s4 * t_4;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_2 * s4 + s6_30 * c4, -(s4 * t_3 - c6_30 * c4), -s5s4],
                    [c6_30 * s5, -s6_30 * s5, c5],
                    [t_2 * c4 - s6_30 * s4, -(c4 * t_3 + c6_30 * s4), -s5c4],
                ],
                [-(t_7 - q[1]), t_5 + 0.1 + q[2], -(t_6 - q[0])],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
                    [-t_6, 0.0, t_7, 0.0, 1.0, 0.0],
                    [-s4 * t_5, -t_4, -c4 * t_5, -c4, 0.0, s4],
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
#[allow(unused, clippy::all, clippy::pedantic)]
impl GantryWrist {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 2;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: a linear equation (a d + b = 0, one value).
    /// 2. `q2`: a linear equation (a d + b = 0, one value).
    /// 3. `q3`: a linear equation (a d + b = 0, one value).
    /// 4. `q6`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 5. `q4`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 6. `q5`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 2> {
        let frame = match ::dh_robot::runtime::frame_of(target, 0.30000000000000004) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 2]; 6];
        let mut valid = [0.0; 2];
        if !self.lanes(&frame, &mut q, &mut valid) {
            return self.robust(target);
        }
        if valid == [1.0; 2] {
            let at = |l: usize| ::dh_robot::runtime::lanes::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                l,
            );
            return ::dh_robot::Solutions::full(&Self::JOINTS, [at(0), at(1)]);
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
        let t_2 = t[0][0] * 0.8660254037844386 - t[0][1] * 0.5;
        let t_3 = t[2][0] * 0.8660254037844386 - t[2][1] * 0.5;
        let t_4 = t[0][0] * 0.5 + t[0][1] * 0.8660254037844386;
        let t_5 = t[2][0] * 0.5 + t[2][1] * 0.8660254037844386;
        let t_6 = t[1][3] - t[1][2] * 0.6666666666666666 - 0.3333333333333333;
        let q1_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            1.0,
            -(t[2][3] - t[2][2] * 0.6666666666666666),
            1e-11,
        );
        if !q1_roots.is_regular() {
            attempt.note(q1_roots.outcome, free, "q1", 0.30000000000000004, "m");
        }
        let free = if q1_roots.is_free() {
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (q1_root, &q1_scaled) in q1_roots
            .or_if_free(pick.length(0))
            .iter()
            .enumerate()
        {
            let q1 = q1_scaled * 0.30000000000000004;
            let q2_roots = ::dh_robot::runtime::solve_quadratic(
                0.0,
                -1.0,
                t[0][3] - t[0][2] * 0.6666666666666666,
                1e-11,
            );
            if !q2_roots.is_regular() {
                attempt.note(q2_roots.outcome, free, "q2", 0.30000000000000004, "m");
            }
            let free = if q2_roots.is_free() {
                free.union(::dh_robot::FreeJoints::of(&[1]))
            } else {
                free
            };
            for (q2_root, &q2_scaled) in q2_roots
                .or_if_free(pick.length(1))
                .iter()
                .enumerate()
            {
                let q2 = q2_scaled * 0.30000000000000004;
                let q3_roots = ::dh_robot::runtime::solve_quadratic(
                    0.0,
                    -1.0,
                    t_6,
                    1e-11,
                );
                if !q3_roots.is_regular() {
                    attempt.note(q3_roots.outcome, free, "q3", 0.30000000000000004, "m");
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
                    let q3 = q3_scaled * 0.30000000000000004;
                    let q6_roots = ::dh_robot::runtime::solve_sincos(
                        -(t[1][0] * 0.5 + t[1][1] * 0.8660254037844386),
                        -(t[1][0] * 0.8660254037844386 - t[1][1] * 0.5),
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
                            1.0,
                            -(t_3 * s6 + t_5 * c6),
                            -1.0,
                            0.0,
                            -(t_2 * s6 + t_4 * c6),
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
                            let q5_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                c6 * (t_3 * c4 + t_2 * s4) - s6 * (t_5 * c4 + t_4 * s4),
                                0.0,
                                -1.0,
                                t[2][2] * c4 + t[0][2] * s4,
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
                                    .with_step(0, q6_root)
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
    ) -> ::dh_robot::Solutions<f64, 6, 2> {
        let frame = match ::dh_robot::runtime::frame_of(target, 0.30000000000000004) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 0.30000000000000004,
            few: false,
            given: [::core::option::Option::None; 6],
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 0.30000000000000004),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    const BRANCHES: [::dh_robot::Branch; 2] = {
        let mut all = [::dh_robot::Branch::ANY; 2];
        let mut l = 0;
        while l < 2 {
            let q6_root = l / 1 % 2;
            all[l] = ::dh_robot::Branch::ANY
                .with_step(0, q6_root)
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
        q: &mut [[f64; 2]; 6],
        valid: &mut [f64; 2],
    ) -> bool {
        let t_2 = t[0][0] * 0.8660254037844386 - t[0][1] * 0.5;
        let t_3 = t[2][0] * 0.8660254037844386 - t[2][1] * 0.5;
        let t_4 = t[0][0] * 0.5 + t[0][1] * 0.8660254037844386;
        let t_5 = t[2][0] * 0.5 + t[2][1] * 0.8660254037844386;
        let t_6 = t[1][3] - t[1][2] * 0.6666666666666666 - 0.3333333333333333;
        let mut margin_ = [0.0; 1];
        let mut valid_ = [0.0; 1];
        let mut error_ = [0.0; 1];
        let (q1_scaled, m0) = ::dh_robot::runtime::lanes::linear(
            1.0,
            -(t[2][3] - t[2][2] * 0.6666666666666666),
        );
        let q1_scaled = q1_scaled;
        let g0 = q1_scaled * 0.30000000000000004;
        let (q2_scaled, m1) = ::dh_robot::runtime::lanes::linear(
            -1.0,
            t[0][3] - t[0][2] * 0.6666666666666666,
        );
        let q2_scaled = q2_scaled;
        let g1 = q2_scaled * 0.30000000000000004;
        let (q3_scaled, m2) = ::dh_robot::runtime::lanes::linear(-1.0, t_6);
        let q3_scaled = q3_scaled;
        let g2 = q3_scaled * 0.30000000000000004;
        let t_7 = 0.3333333333333333 + q3_scaled;
        let ([c6, s6], m3) = ::dh_robot::runtime::lanes::half_turn([
            [
                -(t[1][0] * 0.5 + t[1][1] * 0.8660254037844386),
                -(t[1][0] * 0.8660254037844386 - t[1][1] * 0.5),
            ],
        ]);
        let g3 = ::dh_robot::runtime::lanes::angle(s6, c6);
        let t_8 = 0.8660254037844386 * c6 - 0.5 * s6;
        let t_9 = 0.5 * c6 + 0.8660254037844386 * s6;
        let [c4, s4] = ::dh_robot::runtime::lanes::unit(
            t_2 * s6 + t_4 * c6,
            -(t_3 * s6 + t_5 * c6),
        );
        let g4 = ::dh_robot::runtime::lanes::angle(s4, c4);
        let t_10 = s4 * t_8;
        let t_11 = c4 * t_8;
        let [c5, s5] = ::dh_robot::runtime::lanes::unit(
            c6 * (t_3 * c4 + t_2 * s4) - s6 * (t_5 * c4 + t_4 * s4),
            -(t[2][2] * c4 + t[0][2] * s4),
        );
        let g5 = ::dh_robot::runtime::lanes::angle(s5, c5);
        let t_12 = t_9 * c5;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let r6 = (-(s4 * t_12 - t_11) - t[0][1]).abs() + (-t_9 * s5 - t[1][1]).abs()
            + (-(c4 * t_12 + t_10) - t[2][1]).abs() + (-s4s5 - t[0][2]).abs()
            + (c5 - t[1][2]).abs() + (-c4s5 - t[2][2]).abs()
            + (q2_scaled - 0.6666666666666666 * s4s5 - t[0][3]).abs()
            + (t_7 + 0.6666666666666666 * c5 - t[1][3]).abs()
            + (q1_scaled - 0.6666666666666666 * c4s5 - t[2][3]).abs();
        let l = 0;
        margin_[l] = ::dh_robot::runtime::lanes::lesser(
            ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(m0, m1),
                m2,
            ),
            m3,
        );
        valid_[l] = 1.0;
        error_[l] = r6;
        let h3 = ::dh_robot::runtime::lanes::opposite(g3);
        let h4 = ::dh_robot::runtime::lanes::opposite(g4);
        let h5 = ::dh_robot::runtime::lanes::negative(g5);
        q[0][l] = g0;
        q[1][l] = g1;
        q[2][l] = g2;
        q[3][l] = g4;
        q[4][l] = g5;
        q[5][l] = g3;
        q[0][l + 1] = g0;
        q[1][l + 1] = g1;
        q[2][l + 1] = g2;
        q[3][l + 1] = h4;
        q[4][l + 1] = h5;
        q[5][l + 1] = h3;
        *valid = ::core::array::from_fn(|l| valid_[l % 1]);
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for GantryWrist {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5] + 0.5235987755982988, q[4], q[3]];
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c6_30 * c5;
        let t_3 = s6_30 * c5;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        [
            [t_2 * s4 + s6_30 * c4, -(s4 * t_3 - c6_30 * c4), -s5s4, q[1] - s5s4 * 0.2],
            [c6_30 * s5, -s6_30 * s5, c5, 0.1 + q[2] + c5 * 0.2],
            [t_2 * c4 - s6_30 * s4, -(c4 * t_3 + c6_30 * s4), -s5c4, q[0] - s5c4 * 0.2],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[5] + 0.5235987755982988, q[4], q[3]];
        let ([s6_30, s5, s4], [c6_30, c5, c4]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c6_30 * c5;
        let t_3 = s6_30 * c5;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_4 = s5 * 0.2;
        let t_5 = c5 * 0.2;
        let t_6 = c4 * t_4;
        let t_7 = s4 * t_4;
        (
            [
                [t_2 * s4 + s6_30 * c4, -(s4 * t_3 - c6_30 * c4), -s5s4, -(t_7 - q[1])],
                [c6_30 * s5, -s6_30 * s5, c5, t_5 + 0.1 + q[2]],
                [t_2 * c4 - s6_30 * s4, -(c4 * t_3 + c6_30 * s4), -s5c4, -(t_6 - q[0])],
            ],
            [
                [0.0, 1.0, 0.0, -t_6, -s4 * t_5, 0.0],
                [0.0, 0.0, 1.0, 0.0, -t_4, 0.0],
                [1.0, 0.0, 0.0, t_7, -c4 * t_5, 0.0],
                [0.0, 0.0, 0.0, 0.0, -c4, -s5s4],
                [0.0, 0.0, 0.0, 1.0, 0.0, c5],
                [0.0, 0.0, 0.0, 0.0, s4, -s5c4],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, 2, f64> for GantryWrist {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 2> {
        GantryWrist::inverse(self, target)
    }
}
