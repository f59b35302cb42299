// What `dh_robot!` makes of src/six_axis_chain.rs. Made by `cargo regen`; do not edit.

/// A chain of six axes of which the second, third and fourth are parallel.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | 0 | 0 | 90 deg | any |
/// | q2 | q2 | 0 | a2 | 0 | any |
/// | q3 | q3 | 0 | a3 | 0 | any |
/// | q4 | q4 | 0 | a4 | -90 deg | any |
/// | q5 | q5 | 0 | 0 | 90 deg | any |
/// | q6 | q6 | 0 | 0 | 0 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixAxisChain {
    /// `a2` in m.
    pub a2: f64,
    /// `a3` in m.
    pub a3: f64,
    /// `a4` in m.
    pub a4: f64,
}
impl ::core::default::Default for SixAxisChain {
    fn default() -> Self {
        SixAxisChain {
            a2: 0.5,
            a3: 0.4,
            a4: 0.2,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl SixAxisChain {
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
    /// Cost: 30 multiplications, 16 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[1] + q[2] + q[3], q[1] + q[2], q[1], q[0], q[5], q[4]];
        let ([s234, s23, s2, s1, s6, s5], [c234, c23, c2, c1, c6, c5]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t_2 = self.a4 * c234 + self.a3 * c23 + self.a2 * c2;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_3 = c234 * c6c5 - s234 * s6;
        let t_4 = s234 * c6c5 + c234 * s6;
        let t_5 = c1 * t_3 - s1 * c6s5;
        let t_6 = s1 * t_3 + c1 * c6s5;
        let c234s5 = c234 * s5;
        let s234s5 = s234 * s5;
        let t_7 = c1 * c234s5 + s1 * c5;
        let t_8 = s1 * c234s5 - c1 * c5;
        ::dh_robot::pose::from_entries(
            [
                [t_5, t_4 * t_8 - t_6 * s234s5, t_7],
                [t_6, t_5 * s234s5 - t_4 * t_7, t_8],
                [t_4, t_6 * t_7 - t_5 * t_8, s234s5],
            ],
            [t_2 * c1, t_2 * s1, self.a4 * s234 + self.a3 * s23 + self.a2 * s2],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 46 multiplications, 19 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4], q[5]];
        let ([s1, s2, s23, s234, s5, s6], [c1, c2, c23, c234, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t_2 = self.a2 * c2;
        let t_3 = self.a2 * s2;
        let t_4 = c1 * t_2;
        let t_5 = s1 * t_2;
        let t_6 = self.a3 * c23;
        let t_7 = t_4 + c1 * t_6;
        let t_8 = t_5 + s1 * t_6;
        let t_9 = t_3 + self.a3 * s23;
        let t_10 = self.a4 * c234;
        let t_11 = t_7 + c1 * t_10;
        let t_12 = t_8 + s1 * t_10;
        let t_13 = t_9 + self.a4 * s234;
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        let s234c5 = s234 * c5;
        let t_14 = c1c234 * c5 - s1 * s5;
        let t_15 = s1c234 * c5 + c1 * s5;
        let s234s5 = s234 * s5;
        let t_16 = s1 * c5 + c1c234 * s5;
        let t_17 = c1 * c5 - s1c234 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, s1], [s1 * c2, -s1 * s2, -c1], [s2, c2, 0.0]],
                [t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c23, -c1 * s23, s1], [s1 * c23, -s1 * s23, -c1], [s23, c23, 0.0]],
                [t_7, t_8, t_9],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c234, -s1, -c1s234], [s1c234, c1, -s1s234], [s234, 0.0, c234]],
                [t_11, t_12, t_13],
            ),
            ::dh_robot::pose::from_entries(
                [[t_14, -c1s234, t_16], [t_15, -s1s234, -t_17], [s234c5, c234, s234s5]],
                [t_11, t_12, t_13],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_14 * c6 - c1s234 * s6, -(c1s234 * c6 + t_14 * s6), t_16],
                    [t_15 * c6 - s1s234 * s6, -(s1s234 * c6 + t_15 * s6), -t_17],
                    [s234c5 * c6 + c234 * s6, c234 * c6 - s234c5 * s6, s234s5],
                ],
                [t_11, t_12, t_13],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 22 multiplications, 9 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let s5c234 = s5 * c234;
        let t_2 = c234 * self.a4;
        let t_3 = s234 * self.a4;
        let t_4 = t_2 + self.a3 * c23;
        let t_5 = t_3 + self.a3 * s23;
        let t_6 = t_4 + self.a2 * c2;
        let t_7 = t_5 + self.a2 * s2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-s1 * t_6, c1 * t_6, 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_7, -s1 * t_7, t_6, s1, -c1, 0.0],
                [-c1 * t_5, -s1 * t_5, t_4, s1, -c1, 0.0],
                [-c1 * t_3, -s1 * t_3, t_2, s1, -c1, 0.0],
                [0.0, 0.0, 0.0, -s234 * c1, -s234 * s1, c234],
                [0.0, 0.0, 0.0, c1 * s5c234 + c5 * s1, s1 * s5c234 - c5 * c1, s5 * s234],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 38 multiplications, 16 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c234 - s6 * s234;
        let t_3 = c6c5 * s234 + s6 * c234;
        let t_4 = t_2 * c1 - c6s5 * s1;
        let t_5 = t_2 * s1 + c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 + c5 * s1;
        let t_7 = s1 * s5c234 - c5 * c1;
        let t_8 = c234 * self.a4;
        let t_9 = s234 * self.a4;
        let t_10 = t_8 + self.a3 * c23;
        let t_11 = t_9 + self.a3 * s23;
        let t_12 = t_10 + self.a2 * c2;
        let t_13 = t_11 + self.a2 * s2;
        let t_14 = c1 * t_12;
        let t_15 = s1 * t_12;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_4, t_3 * t_7 - t_5 * s5s234, t_6],
                    [t_5, t_4 * s5s234 - t_3 * t_6, t_7],
                    [t_3, t_5 * t_6 - t_4 * t_7, s5s234],
                ],
                [t_14, t_15, t_13],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_15, t_14, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_13, -s1 * t_13, t_12, s1, -c1, 0.0],
                    [-c1 * t_11, -s1 * t_11, t_10, s1, -c1, 0.0],
                    [-c1 * t_9, -s1 * t_9, t_8, s1, -c1, 0.0],
                    [0.0, 0.0, 0.0, -s234 * c1, -s234 * s1, c234],
                    [0.0, 0.0, 0.0, t_6, t_7, s5s234],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for SixAxisChain {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for SixAxisChain {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        SixAxisChain::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        SixAxisChain::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for SixAxisChain {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        SixAxisChain::jacobian(self, q)
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl SixAxisChain {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// Plan:
    /// 1. `q1`: a cos + b sin = 0: two values half a turn apart.
    /// 2. `q6`: a cos + b sin = 0: two values half a turn apart.
    /// 3. `q5`: two equations in its sine and cosine: one value.
    /// 4. `q2 + q3 + q4`: two equations in its sine and cosine: one value.
    /// 5. `q3`: a cos + b sin = c: two values.
    /// 6. `q4`: two equations in its sine and cosine: one value.
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::inverse::frame_of(target, 1.1159566801270322) {
            Ok(frame) => frame,
            Err(why) => return ::dh_robot::Solutions::none(&Self::JOINTS, why),
        };
        let setting = ::dh_robot::inverse::Setting {
            joints: &Self::JOINTS,
            reach: 1.1159566801270322,
            few: false,
        };
        let task = ::dh_robot::ik::Task::Pose(
            ::dh_robot::inverse::in_units(&frame, 1.1159566801270322),
        );
        ::dh_robot::inverse::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, found| self.candidates(frame, found),
        )
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::ik::Pose,
        found: &mut dyn FnMut([f64; 6], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::inverse::Attempt {
        let mut attempt = ::dh_robot::inverse::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = self.a4 * 0.896092131359586;
        let t_3 = self.a2 * 0.896092131359586;
        let t_4 = self.a3 * 0.896092131359586;
        let t_5 = t_3 * t_3 + t_4 * t_4;
        let r0 = ::dh_robot::ik::solve_sincos(-t[1][3], t[0][3], 0.0, 1e-11);
        if r0.roots.is_empty() {
            attempt.note(r0.outcome, "q1", 1.1159566801270322, "m");
        }
        let free = if r0.is_free() {
            attempt.degenerate = true;
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (i0, &[c1, s1]) in r0.or_if_free([1.0, 0.0]).iter().enumerate() {
            let a0 = ::dh_robot::math::atan2(s1, c1);
            let t_6 = t[0][3] * c1 + t[1][3] * s1;
            let t_7 = t[0][3] * s1 - t[1][3] * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let t_13 = t[0][2] * s1 - t[1][2] * c1;
            let r1 = ::dh_robot::ik::solve_sincos(t_11, t_9, 0.0, 1e-11);
            if r1.roots.is_empty() {
                attempt.note(r1.outcome, "q6", 1.0, "");
            }
            let free = if r1.is_free() {
                attempt.degenerate = true;
                free.union(::dh_robot::FreeJoints::of(&[5]))
            } else {
                free
            };
            for (i1, &[c6, s6]) in r1.or_if_free([1.0, 0.0]).iter().enumerate() {
                let a1 = ::dh_robot::math::atan2(s6, c6);
                let t_14 = t_8 * c6 - t_10 * s6;
                let t_15 = t_9 * c6 - t_11 * s6;
                let t_16 = t[2][0] * c6 - t[2][1] * s6;
                let t_17 = t_8 * s6 + t_10 * c6;
                let t_18 = t_9 * s6 + t_11 * c6;
                let t_19 = t[2][0] * s6 + t[2][1] * c6;
                let t_20 = t[0][0] * c6 - t[0][1] * s6;
                let t_21 = t[1][0] * c6 - t[1][1] * s6;
                let r2 = ::dh_robot::ik::solve_pair(
                    0.0,
                    1.0,
                    -t_15,
                    1.0,
                    0.0,
                    t_13,
                    1e-11,
                );
                if r2.roots.is_empty() {
                    attempt.note(r2.outcome, "q5", 1.0, "");
                }
                let free = if r2.is_free() {
                    attempt.degenerate = true;
                    free.union(::dh_robot::FreeJoints::of(&[4]))
                } else {
                    free
                };
                for (i2, &[c5, s5]) in r2.or_if_free([1.0, 0.0]).iter().enumerate() {
                    let a2 = ::dh_robot::math::atan2(s5, c5);
                    let t_22 = t_14 * c5 + t_12 * s5;
                    let t_23 = t_15 * c5 + t_13 * s5;
                    let t_24 = t_16 * c5 + t[2][2] * s5;
                    let t_25 = t_6 - t_22 * t_2;
                    let t_26 = t_7 - t_23 * t_2;
                    let t_27 = t[2][3] - t_24 * t_2;
                    let t_28 = t[0][3] - t_2 * (c5 * t_20 + t[0][2] * s5);
                    let t_29 = t[1][3] - t_2 * (c5 * t_21 + t[1][2] * s5);
                    let r3 = ::dh_robot::ik::solve_pair(
                        1.0,
                        0.0,
                        t_22,
                        0.0,
                        -1.0,
                        t_17,
                        1e-11,
                    );
                    if r3.roots.is_empty() {
                        attempt.note(r3.outcome, "q2 + q3 + q4", 1.0, "");
                    }
                    let free = if r3.is_free() {
                        attempt.degenerate = true;
                        free.union(::dh_robot::FreeJoints::of(&[1, 2, 3]))
                    } else {
                        free
                    };
                    for (i3, &[c234, s234]) in r3
                        .or_if_free([1.0, 0.0])
                        .iter()
                        .enumerate()
                    {
                        let a3 = ::dh_robot::math::atan2(s234, c234);
                        let r4 = ::dh_robot::ik::solve_sincos(
                            2.0 * t_3 * t_4,
                            0.0,
                            t_27 * t_27 + t_28 * t_28 + t_29 * t_29 - t_5,
                            1e-11,
                        );
                        if r4.roots.is_empty() {
                            attempt.note(r4.outcome, "q3", 1.1159566801270322, "m");
                        }
                        let free = if r4.is_free() {
                            attempt.degenerate = true;
                            free.union(::dh_robot::FreeJoints::of(&[2]))
                        } else {
                            free
                        };
                        for (i4, &[c3, s3]) in r4
                            .or_if_free([1.0, 0.0])
                            .iter()
                            .enumerate()
                        {
                            let a4 = ::dh_robot::math::atan2(s3, c3);
                            let t_30 = t_4 + t_3 * c3;
                            let t_31 = t_3 * s3;
                            let r5 = ::dh_robot::ik::solve_pair(
                                -t_30,
                                t_31,
                                -(t_22 * t_25 + t_23 * t_26 + t_24 * t_27),
                                t_31,
                                t_30,
                                -(t_17 * t_25 + t_18 * t_26 + t_19 * t_27),
                                1e-11,
                            );
                            if r5.roots.is_empty() {
                                attempt.note(r5.outcome, "q4", 1.1159566801270322, "m");
                            }
                            let free = if r5.is_free() {
                                attempt.degenerate = true;
                                free.union(::dh_robot::FreeJoints::of(&[3]))
                            } else {
                                free
                            };
                            for (i5, &[c4, s4]) in r5
                                .or_if_free([1.0, 0.0])
                                .iter()
                                .enumerate()
                            {
                                let a5 = ::dh_robot::math::atan2(s4, c4);
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
                                    .with_wrist(
                                        if i1 == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    )
                                    .with_step(2, i4)
                                    .with_elbow(
                                        if i4 == 0 {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    );
                                found([a0, a3 - a4 - a5, a4, a5, a2, a1], branch, free);
                            }
                        }
                    }
                }
            }
        }
        attempt
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl ::dh_robot::ik::Kinematics<6> for SixAxisChain {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::ik::Pose {
        let angles = [q[1] + q[2] + q[3], q[1] + q[2], q[1], q[0], q[5], q[4]];
        let ([s234, s23, s2, s1, s6, s5], [c234, c23, c2, c1, c6, c5]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t_2 = self.a4 * c234 + self.a3 * c23 + self.a2 * c2;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_3 = c234 * c6c5 - s234 * s6;
        let t_4 = s234 * c6c5 + c234 * s6;
        let t_5 = c1 * t_3 - s1 * c6s5;
        let t_6 = s1 * t_3 + c1 * c6s5;
        let c234s5 = c234 * s5;
        let s234s5 = s234 * s5;
        let t_7 = c1 * c234s5 + s1 * c5;
        let t_8 = s1 * c234s5 - c1 * c5;
        [
            [t_5, t_4 * t_8 - t_6 * s234s5, t_7, t_2 * c1],
            [t_6, t_5 * s234s5 - t_4 * t_7, t_8, t_2 * s1],
            [
                t_4,
                t_6 * t_7 - t_5 * t_8,
                s234s5,
                self.a4 * s234 + self.a3 * s23 + self.a2 * s2,
            ],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::ik::Pose, [[f64; 6]; 6]) {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c234 - s6 * s234;
        let t_3 = c6c5 * s234 + s6 * c234;
        let t_4 = t_2 * c1 - c6s5 * s1;
        let t_5 = t_2 * s1 + c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 + c5 * s1;
        let t_7 = s1 * s5c234 - c5 * c1;
        let t_8 = c234 * self.a4;
        let t_9 = s234 * self.a4;
        let t_10 = t_8 + self.a3 * c23;
        let t_11 = t_9 + self.a3 * s23;
        let t_12 = t_10 + self.a2 * c2;
        let t_13 = t_11 + self.a2 * s2;
        let t_14 = c1 * t_12;
        let t_15 = s1 * t_12;
        (
            [
                [t_4, t_3 * t_7 - t_5 * s5s234, t_6, t_14],
                [t_5, t_4 * s5s234 - t_3 * t_6, t_7, t_15],
                [t_3, t_5 * t_6 - t_4 * t_7, s5s234, t_13],
            ],
            [
                [-t_15, -c1 * t_13, -c1 * t_11, -c1 * t_9, 0.0, 0.0],
                [t_14, -s1 * t_13, -s1 * t_11, -s1 * t_9, 0.0, 0.0],
                [0.0, t_12, t_10, t_8, 0.0, 0.0],
                [0.0, s1, s1, s1, -s234 * c1, t_6],
                [0.0, -c1, -c1, -c1, -s234 * s1, t_7],
                [1.0, 0.0, 0.0, 0.0, c234, s5s234],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, 8, f64> for SixAxisChain {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 8> {
        SixAxisChain::inverse(self, target)
    }
}
