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
    /// Cost: 36 multiplications, 16 additions, 5 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1], q[0]];
        let ([s6, s5, s4, s2, s1], [c6, c5, c4, c2, c1]) = ::dh_robot::sincos::sincos_batch(
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
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
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
    /// origin of the last frame (or tool).
    ///
    /// Cost: 26 multiplications, 8 additions, 4 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1], q[3], q[4]];
        let ([s1, s2, s4, s5], [c1, c2, c4, c5]) = ::dh_robot::sincos::sincos_batch(
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
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
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
    /// Plan:
    /// 1. `q1`: a cos + b sin = c: two values.
    /// 2. `q2`: a cos + b sin = 0: two values half a turn apart.
    /// 3. `q3`: a linear equation.
    /// 4. `q6`: a cos + b sin = 0: two values half a turn apart.
    /// 5. `q4`: two equations in its sine and cosine: one value.
    /// 6. `q5`: two equations in its sine and cosine: one value.
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::inverse::frame_of(target, 0.5862999999999999) {
            Ok(frame) => frame,
            Err(why) => return ::dh_robot::Solutions::none(&Self::JOINTS, why),
        };
        let mut solutions = ::dh_robot::Solutions::new(&Self::JOINTS);
        if self.lanes(&frame, &mut solutions) {
            return solutions;
        }
        let setting = ::dh_robot::inverse::Setting {
            joints: &Self::JOINTS,
            reach: 0.5862999999999999,
            few: false,
            given: None,
        };
        let task = ::dh_robot::ik::Task::Pose(
            ::dh_robot::inverse::in_units(&frame, 0.5862999999999999),
        );
        ::dh_robot::inverse::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::ik::Pose,
        pick: ::dh_robot::inverse::Pick,
        found: &mut dyn FnMut([f64; 6], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::inverse::Attempt {
        let mut attempt = ::dh_robot::inverse::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = t[2][3] - 0.7027119222241174;
        let r0 = ::dh_robot::ik::solve_sincos(
            -t[1][3],
            t[0][3],
            -0.22804025243049636,
            1e-11,
        );
        if r0.roots.is_empty() {
            attempt.note(r0.outcome, free, "shoulder q1", 0.5862999999999999, "m");
        }
        let free = if r0.is_free() {
            attempt.degenerate = true;
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (i0, &[c1, s1]) in r0.or_if_free(pick.angle(0)).iter().enumerate() {
            let a0 = ::dh_robot::math::atan2(s1, c1);
            let t_3 = t[0][3] * c1 + t[1][3] * s1;
            let t_4 = t[0][0] * c1 + t[1][0] * s1;
            let t_5 = t[0][0] * s1 - t[1][0] * c1;
            let t_6 = t[0][1] * c1 + t[1][1] * s1;
            let t_7 = t[0][1] * s1 - t[1][1] * c1;
            let t_8 = t[0][2] * c1 + t[1][2] * s1;
            let t_9 = t[0][2] * s1 - t[1][2] * c1;
            let r1 = ::dh_robot::ik::solve_sincos(-t_3, t_2, 0.0, 1e-11);
            if r1.roots.is_empty() {
                attempt.note(r1.outcome, free, "elbow q2", 0.5862999999999999, "m");
            }
            let free = if r1.is_free() {
                attempt.degenerate = true;
                free.union(::dh_robot::FreeJoints::of(&[1]))
            } else {
                free
            };
            for (i1, &[c2, s2]) in r1.or_if_free(pick.angle(1)).iter().enumerate() {
                let a1 = ::dh_robot::math::atan2(s2, c2);
                let t_10 = t_4 * c2 - t[2][0] * s2;
                let t_11 = t_6 * c2 - t[2][1] * s2;
                let t_12 = t_8 * c2 - t[2][2] * s2;
                let r2 = ::dh_robot::ik::solve_quadratic(
                    0.0,
                    -1.0,
                    t_3 * s2 + t_2 * c2,
                    1e-11,
                );
                if r2.roots.is_empty() {
                    attempt.note(r2.outcome, free, "q3", 0.5862999999999999, "m");
                }
                let free = if r2.is_free() {
                    attempt.degenerate = true;
                    free.union(::dh_robot::FreeJoints::of(&[2]))
                } else {
                    free
                };
                for (i2, &q3) in r2.or_if_free(pick.length(2)).iter().enumerate() {
                    let a2 = q3 * 0.5862999999999999;
                    let r3 = ::dh_robot::ik::solve_sincos(
                        t_6 * s2 + t[2][1] * c2,
                        t_4 * s2 + t[2][0] * c2,
                        0.0,
                        1e-11,
                    );
                    if r3.roots.is_empty() {
                        attempt.note(r3.outcome, free, "wrist q6", 1.0, "");
                    }
                    let free = if r3.is_free() {
                        attempt.degenerate = true;
                        free.union(::dh_robot::FreeJoints::of(&[5]))
                    } else {
                        free
                    };
                    for (i3, &[c6, s6]) in r3
                        .or_if_free(pick.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let a3 = ::dh_robot::math::atan2(s6, c6);
                        let r4 = ::dh_robot::ik::solve_pair(
                            0.0,
                            -1.0,
                            t_5 * s6 + t_7 * c6,
                            1.0,
                            0.0,
                            t_10 * s6 + t_11 * c6,
                            1e-11,
                        );
                        if r4.roots.is_empty() {
                            attempt.note(r4.outcome, free, "q4", 1.0, "");
                        }
                        let free = if r4.is_free() {
                            attempt.degenerate = true;
                            free.union(::dh_robot::FreeJoints::of(&[3]))
                        } else {
                            free
                        };
                        for (i4, &[c4, s4]) in r4
                            .or_if_free(pick.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let a4 = ::dh_robot::math::atan2(s4, c4);
                            let t_13 = c6 * (t_5 * c4 + t_10 * s4)
                                - s6 * (t_7 * c4 + t_11 * s4);
                            let r5 = ::dh_robot::ik::solve_pair(
                                1.0,
                                0.0,
                                t_13,
                                0.0,
                                -1.0,
                                -(t_9 * c4 + t_12 * s4),
                                1e-11,
                            );
                            if r5.roots.is_empty() {
                                attempt.note(r5.outcome, free, "q5", 1.0, "");
                            }
                            let free = if r5.is_free() {
                                attempt.degenerate = true;
                                free.union(::dh_robot::FreeJoints::of(&[4]))
                            } else {
                                free
                            };
                            for (i5, &[c5, s5]) in r5
                                .or_if_free(pick.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let a5 = ::dh_robot::math::atan2(s5, c5);
                                let branch = ::dh_robot::Branch::ANY
                                    .with_step(0, i0)
                                    .with_shoulder(
                                        if i0 == 0 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    )
                                    .with_step(1, i1)
                                    .with_elbow(
                                        if i1 == 0 {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(2, i3)
                                    .with_wrist(
                                        if i3 == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    );
                                found([a0, a1, a2, a4, a5, a3], branch, free);
                            }
                        }
                    }
                }
            }
        }
        attempt
    }
    /// The plan for all branches at once; false where the robust way has to decide.
    #[inline]
    fn lanes(
        &self,
        t: &::dh_robot::ik::Pose,
        solutions: &mut ::dh_robot::Solutions<f64, 6, 8>,
    ) -> bool {
        let t_2 = t[2][3] - 0.7027119222241174;
        let mut f0 = [[0.0; 2]; 2];
        let mut m0 = [0.0; 1];
        let mut e0 = [0.0; 1];
        for l in 0..1 {
            let ([x, y, z, w], e, m) = ::dh_robot::lanes::sincos(
                -t[1][3],
                t[0][3],
                -0.22804025243049636,
            );
            f0[0][l] = x;
            f0[1][l] = y;
            f0[0][l + 1] = z;
            f0[1][l + 1] = w;
            m0[l] = m;
            e0[l] = e;
        }
        let c1_ = f0[0];
        let s1_ = f0[1];
        let g0: [f64; 2] = ::dh_robot::atan2_batch(&f0[1], &f0[0]);
        let mut v39_ = [0.0; 2];
        let mut v47_ = [0.0; 2];
        let mut v50_ = [0.0; 2];
        let mut v53_ = [0.0; 2];
        let mut v56_ = [0.0; 2];
        let mut v59_ = [0.0; 2];
        let mut v62_ = [0.0; 2];
        let mut v272_ = [0.0; 2];
        let mut v275_ = [0.0; 2];
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
        }
        let mut f1 = [[0.0; 4]; 2];
        let mut m1 = [0.0; 2];
        for l in 0..2 {
            let v39 = v39_[l];
            let ([x, y], m) = ::dh_robot::lanes::half_turn(-v39, t_2);
            f1[0][l] = x;
            f1[1][l] = y;
            f1[0][l + 2] = -x;
            f1[1][l + 2] = -y;
            m1[l] = m;
        }
        let c2_ = f1[0];
        let s2_ = f1[1];
        let half: [f64; 2] = ::dh_robot::atan2_batch(
            &::core::array::from_fn(|l| f1[1][l]),
            &::core::array::from_fn(|l| f1[0][l]),
        );
        let g1: [f64; 4] = ::core::array::from_fn(|k| {
            if k < 2 {
                half[k]
            } else if half[k - 2] > 0.0 {
                half[k - 2] - ::core::f64::consts::PI
            } else {
                half[k - 2] + ::core::f64::consts::PI
            }
        });
        let mut v90_ = [0.0; 4];
        let mut v93_ = [0.0; 4];
        let mut v96_ = [0.0; 4];
        let mut v99_ = [0.0; 4];
        let mut v102_ = [0.0; 4];
        let mut v105_ = [0.0; 4];
        for l in 0..4 {
            let v39 = v39_[l % 2];
            let v47 = v47_[l % 2];
            let v53 = v53_[l % 2];
            let v59 = v59_[l % 2];
            let c2 = c2_[l];
            let s2 = s2_[l];
            let t_12 = v47 * c2 - t[2][0] * s2;
            let t_13 = v53 * c2 - t[2][1] * s2;
            let t_14 = v59 * c2 - t[2][2] * s2;
            v90_[l] = v39 * s2 + t_2 * c2;
            v93_[l] = t_12;
            v96_[l] = v47 * s2 + t[2][0] * c2;
            v99_[l] = t_13;
            v102_[l] = v53 * s2 + t[2][1] * c2;
            v105_[l] = t_14;
        }
        let mut f2 = [[0.0; 4]; 2];
        let mut m2 = [0.0; 4];
        for l in 0..4 {
            let v90 = v90_[l];
            let (x, m) = ::dh_robot::lanes::linear(-1.0, v90);
            f2[0][l] = x;
            f2[1][l] = x;
            m2[l] = m;
        }
        let q3_ = f2[0];
        let g2: [f64; 4] = f2[0].map(|d| d * 0.5862999999999999);
        let mut v270_ = [0.0; 4];
        let mut v273_ = [0.0; 4];
        let mut v276_ = [0.0; 4];
        for l in 0..4 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let c2 = c2_[l];
            let s2 = s2_[l];
            let v272 = v272_[l % 2];
            let v275 = v275_[l % 2];
            let q3 = q3_[l];
            let t_15 = s2 * q3;
            v270_[l] = 0.7027119222241174 + c2 * q3;
            v273_[l] = c1 * t_15 - v272;
            v276_[l] = s1 * t_15 + v275;
        }
        let mut f3 = [[0.0; 8]; 2];
        let mut m3 = [0.0; 4];
        for l in 0..4 {
            let v102 = v102_[l];
            let v96 = v96_[l];
            let ([x, y], m) = ::dh_robot::lanes::half_turn(v102, v96);
            f3[0][l] = x;
            f3[1][l] = y;
            f3[0][l + 4] = -x;
            f3[1][l + 4] = -y;
            m3[l] = m;
        }
        let c6_ = f3[0];
        let s6_ = f3[1];
        let half: [f64; 4] = ::dh_robot::atan2_batch(
            &::core::array::from_fn(|l| f3[1][l]),
            &::core::array::from_fn(|l| f3[0][l]),
        );
        let g3: [f64; 8] = ::core::array::from_fn(|k| {
            if k < 4 {
                half[k]
            } else if half[k - 4] > 0.0 {
                half[k - 4] - ::core::f64::consts::PI
            } else {
                half[k - 4] + ::core::f64::consts::PI
            }
        });
        let mut v146_ = [0.0; 8];
        let mut v147_ = [0.0; 8];
        for l in 0..8 {
            let v50 = v50_[l % 2];
            let v56 = v56_[l % 2];
            let v93 = v93_[l % 4];
            let v99 = v99_[l % 4];
            let c6 = c6_[l];
            let s6 = s6_[l];
            v146_[l] = v50 * s6 + v56 * c6;
            v147_[l] = v93 * s6 + v99 * c6;
        }
        let mut f4 = [[0.0; 8]; 2];
        for l in 0..8 {
            let v146 = v146_[l];
            let v147 = v147_[l];
            let [x, y] = ::dh_robot::lanes::unit(v147, -v146);
            f4[0][l] = x;
            f4[1][l] = y;
        }
        let c4_ = f4[0];
        let s4_ = f4[1];
        let g4: [f64; 8] = ::dh_robot::atan2_batch(&f4[1], &f4[0]);
        let mut v191_ = [0.0; 8];
        let mut v199_ = [0.0; 8];
        let mut v228_ = [0.0; 8];
        let mut v231_ = [0.0; 8];
        for l in 0..8 {
            let v50 = v50_[l % 2];
            let v56 = v56_[l % 2];
            let v62 = v62_[l % 2];
            let v93 = v93_[l % 4];
            let v99 = v99_[l % 4];
            let v105 = v105_[l % 4];
            let c6 = c6_[l];
            let s6 = s6_[l];
            let c4 = c4_[l];
            let s4 = s4_[l];
            let s6c4 = s6 * c4;
            let s6s4 = s6 * s4;
            v191_[l] = v62 * c4 + v105 * s4;
            v199_[l] = c6 * (v50 * c4 + v93 * s4) - s6 * (v56 * c4 + v99 * s4);
            v228_[l] = s6c4;
            v231_[l] = s6s4;
        }
        let mut f5 = [[0.0; 8]; 2];
        for l in 0..8 {
            let v199 = v199_[l];
            let v191 = v191_[l];
            let [x, y] = ::dh_robot::lanes::unit(v199, v191);
            f5[0][l] = x;
            f5[1][l] = y;
        }
        let c5_ = f5[0];
        let s5_ = f5[1];
        let g5: [f64; 8] = ::dh_robot::atan2_batch(&f5[1], &f5[0]);
        let mut v238_ = [0.0; 8];
        let mut v241_ = [0.0; 8];
        let mut v244_ = [0.0; 8];
        let mut v252_ = [0.0; 8];
        let mut v255_ = [0.0; 8];
        let mut v258_ = [0.0; 8];
        for l in 0..8 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let c2 = c2_[l % 4];
            let s2 = s2_[l % 4];
            let c6 = c6_[l];
            let c4 = c4_[l];
            let s4 = s4_[l];
            let v228 = v228_[l];
            let v231 = v231_[l];
            let c5 = c5_[l];
            let s5 = s5_[l];
            let c6c5 = c6 * c5;
            let c6s5 = c6 * s5;
            let t_16 = s4 * c6c5 + v228;
            let t_17 = c4 * c6c5 - v231;
            let t_18 = c2 * t_16 - s2 * c6s5;
            let s4s5 = s4 * s5;
            let c4s5 = c4 * s5;
            let t_19 = c2 * s4s5 + s2 * c5;
            v238_[l] = s2 * t_16 + c2 * c6s5;
            v241_[l] = c1 * t_18 + s1 * t_17;
            v244_[l] = s1 * t_18 - c1 * t_17;
            v252_[l] = s2 * s4s5 - c2 * c5;
            v255_[l] = c1 * t_19 + s1 * c4s5;
            v258_[l] = s1 * t_19 - c1 * c4s5;
        }
        let mut error = [0.0; 8];
        for l in 0..8 {
            let v241 = v241_[l];
            let v244 = v244_[l];
            let v238 = v238_[l];
            let v255 = v255_[l];
            let v258 = v258_[l];
            let v252 = v252_[l];
            let v273 = v273_[l % 4];
            let v276 = v276_[l % 4];
            let v270 = v270_[l % 4];
            error[l] = (v241 - t[0][0]).abs() + (v244 - t[1][0]).abs()
                + (-v238 - t[2][0]).abs() + (v255 - t[0][2]).abs()
                + (v258 - t[1][2]).abs() + (-v252 - t[2][2]).abs()
                + (v273 - t[0][3]).abs() + (v276 - t[1][3]).abs()
                + (v270 - t[2][3]).abs();
        }
        let valid: [f64; 8] = ::core::array::from_fn(|l| 1.0 * e0[l % 1 % 1]);
        let margin: [f64; 8] = ::core::array::from_fn(|l| {
            1.0_f64
                .min(m0[l % 1 % 1])
                .min(m1[l % 2 % 2])
                .min(m2[l % 4 % 4])
                .min(m3[l % 4 % 4])
        });
        let q: [[f64; 8]; 6] = [
            ::core::array::from_fn(|l| g0[l / 1 % 2 * 1 + l % 1]),
            ::core::array::from_fn(|l| g1[l / 2 % 2 * 2 + l % 2]),
            ::core::array::from_fn(|l| g2[l % 4]),
            ::core::array::from_fn(|l| g4[l % 8]),
            ::core::array::from_fn(|l| g5[l % 8]),
            ::core::array::from_fn(|l| g3[l / 4 % 2 * 4 + l % 4]),
        ];
        const BRANCHES: [::dh_robot::Branch; 8] = {
            let mut all = [::dh_robot::Branch::ANY; 8];
            let mut l = 0;
            while l < 8 {
                let i0 = l / 1 % 2;
                let i1 = l / 2 % 2;
                let i3 = l / 4 % 2;
                all[l] = ::dh_robot::Branch::ANY
                    .with_step(0, i0)
                    .with_shoulder(
                        if i0 == 0 {
                            ::dh_robot::Shoulder::Left
                        } else {
                            ::dh_robot::Shoulder::Right
                        },
                    )
                    .with_step(1, i1)
                    .with_elbow(
                        if i1 == 0 {
                            ::dh_robot::Elbow::Up
                        } else {
                            ::dh_robot::Elbow::Down
                        },
                    )
                    .with_step(2, i3)
                    .with_wrist(
                        if i3 == 0 {
                            ::dh_robot::Wrist::NoFlip
                        } else {
                            ::dh_robot::Wrist::Flip
                        },
                    );
                l += 1;
            }
            all
        };
        ::dh_robot::lanes::collect(&valid, &margin, &error, &q, &BRANCHES, solutions)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::ik::Kinematics<6> for Stanford {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::ik::Pose {
        let angles = [q[5], q[4], q[3], q[1], q[0]];
        let ([s6, s5, s4, s2, s1], [c6, c5, c4, c2, c1]) = ::dh_robot::sincos::sincos_batch(
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
    ) -> (::dh_robot::ik::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
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
