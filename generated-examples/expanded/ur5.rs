// What `dh_robot!` makes of src/ur5.rs. Made by `cargo regen`; do not edit.

/// Universal Robots UR5.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | 1 | q1 | 89.459mm | 0 | 90deg | -360deg..=360deg |
/// | 2 | q2 | 0 | -425mm | 0 | -360deg..=360deg |
/// | 3 | q3 | 0 | -392.25mm | 0 | -180deg..=180deg |
/// | 4 | q4 | 109.15mm | 0 | 90deg | -360deg..=360deg |
/// | 5 | q5 | 94.65mm | 0 | -90deg | -360deg..=360deg |
/// | 6 | q6 | 82.3mm | 0 | 0 | -360deg..=360deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁(c₂₃₄c₅c₆ − s₂₃₄s₆) + s₁s₅c₆
/// r₂₁ = s₁(c₂₃₄c₅c₆ − s₂₃₄s₆) − c₁s₅c₆
/// r₃₁ = s₂₃₄c₅c₆ + c₂₃₄s₆
/// r₁₂ = −c₁(c₂₃₄c₅s₆ + s₂₃₄c₆) − s₁s₅s₆
/// r₂₂ = −s₁(c₂₃₄c₅s₆ + s₂₃₄c₆) + c₁s₅s₆
/// r₃₂ = c₂₃₄c₆ − s₂₃₄c₅s₆
/// r₁₃ = s₁c₅ − c₁c₂₃₄s₅
/// r₂₃ = −s₁c₂₃₄s₅ − c₁c₅
/// r₃₃ = −s₂₃₄s₅
/// px  = −c₁(a₂c₂ + a₃c₂₃ − d₅s₂₃₄ + d₆c₂₃₄s₅) + s₁(d₄ + d₆c₅)
/// py  = −s₁(a₂c₂ + a₃c₂₃ − d₅s₂₃₄ + d₆c₂₃₄s₅) − c₁(d₄ + d₆c₅)
/// pz  = d₁ − a₂s₂ − a₃s₂₃ − d₅c₂₃₄ − d₆s₂₃₄s₅
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      c₂₃₄ = cos(q₂ + q₃ + q₄), s₂₃₄ = sin(q₂ + q₃ + q₄), d₁ = 0.089459, a₂ = 0.425,
///      a₃ = 0.39225, d₄ = 0.10915, d₅ = 0.09465, d₆ = 0.0823
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ur5;
impl ::core::default::Default for Ur5 {
    fn default() -> Self {
        Ur5
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Ur5 {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-3.141592653589793, 3.141592653589793),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-6.283185307179586, 6.283185307179586),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 35 multiplications, 21 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c234 - s6 * s234;
        let t_3 = c6c5 * s234 + s6 * c234;
        let t_4 = t_2 * c1 + c6s5 * s1;
        let t_5 = t_2 * s1 - c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 - c5 * s1;
        let t_7 = s1 * s5c234 + c5 * c1;
        let t_8 = s234 * 0.09465 - 0.39225 * c23 - 0.425 * c2;
        let t_9 = c234 * 0.09465 + 0.39225 * s23 + 0.425 * s2 - 0.089459
            + s5s234 * 0.0823;
        ::dh_robot::pose::from_entries(
            [
                [t_4, -(t_3 * t_7 - t_5 * s5s234), -t_6],
                [t_5, -(t_4 * s5s234 - t_3 * t_6), -t_7],
                [t_3, -(t_5 * t_6 - t_4 * t_7), -s5s234],
            ],
            [
                c1 * t_8 + s1 * 0.10915 - t_6 * 0.0823,
                s1 * t_8 - c1 * 0.10915 - t_7 * 0.0823,
                -t_9,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 50 multiplications, 24 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4], q[5]];
        let ([s1, s2, s23, s234, s5, s6], [c1, c2, c23, c234, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = 0.425 * c2;
        let t_3 = c1 * t_2;
        let t_4 = s1 * t_2;
        let t_5 = 0.089459 - 0.425 * s2;
        let t_6 = 0.39225 * c23;
        let t_7 = t_3 + c1 * t_6;
        let t_8 = t_4 + s1 * t_6;
        let t_9 = t_5 - 0.39225 * s23;
        let t_10 = t_7 - s1 * 0.10915;
        let t_11 = t_8 + c1 * 0.10915;
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        let t_12 = t_10 - c1s234 * 0.09465;
        let t_13 = t_11 - s1s234 * 0.09465;
        let t_14 = t_9 - c234 * 0.09465;
        let s234c5 = s234 * c5;
        let t_15 = c1c234 * c5 + s1 * s5;
        let t_16 = s1c234 * c5 - c1 * s5;
        let s234s5 = s234 * s5;
        let t_17 = s1 * c5 - c1c234 * s5;
        let t_18 = c1 * c5 + s1c234 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [0.0, 0.0, 0.089459],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, s1], [s1 * c2, -s1 * s2, -c1], [s2, c2, 0.0]],
                [-t_3, -t_4, t_5],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c23, -c1 * s23, s1], [s1 * c23, -s1 * s23, -c1], [s23, c23, 0.0]],
                [-t_7, -t_8, t_9],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c234, s1, c1s234], [s1c234, -c1, s1s234], [s234, 0.0, -c234]],
                [-t_10, -t_11, t_9],
            ),
            ::dh_robot::pose::from_entries(
                [[t_15, -c1s234, t_17], [t_16, -s1s234, -t_18], [s234c5, c234, -s234s5]],
                [-t_12, -t_13, t_14],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_15 * c6 - c1s234 * s6, -(c1s234 * c6 + t_15 * s6), t_17],
                    [t_16 * c6 - s1s234 * s6, -(s1s234 * c6 + t_16 * s6), -t_18],
                    [s234c5 * c6 + c234 * s6, c234 * c6 - s234c5 * s6, -s234s5],
                ],
                [
                    -(t_12 - t_17 * 0.0823),
                    -(t_13 + t_18 * 0.0823),
                    t_14 - s234s5 * 0.0823,
                ],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 37 multiplications, 15 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2] + q[3], q[4], q[1] + q[2], q[1]];
        let ([s1, s234, s5, s23, s2], [c1, c234, c5, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let t_2 = s5 * 0.0823;
        let t_3 = c5 * 0.0823 + 0.10915;
        let t_4 = c234 * t_2 - s234 * 0.09465;
        let t_5 = s234 * t_2 + c234 * 0.09465;
        let t_6 = t_4 + 0.39225 * c23;
        let t_7 = t_5 + 0.39225 * s23;
        let t_8 = t_6 + 0.425 * c2;
        let t_9 = t_7 + 0.425 * s2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_8 + c1 * t_3, -(c1 * t_8 - s1 * t_3), 0.0, 0.0, 0.0, 1.0],
                [c1 * t_9, s1 * t_9, -t_8, s1, -c1, 0.0],
                [c1 * t_7, s1 * t_7, -t_6, s1, -c1, 0.0],
                [c1 * t_5, s1 * t_5, -t_4, s1, -c1, 0.0],
                [
                    -(c1c234 * c5 + s1 * s5) * 0.0823,
                    -(s1c234 * c5 - c1 * s5) * 0.0823,
                    -s234 * c5 * 0.0823,
                    c1 * s234,
                    s1 * s234,
                    -c234,
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    s1 * c5 - c1c234 * s5,
                    -(c1 * c5 + s1c234 * s5),
                    -s234 * s5,
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 49 multiplications, 22 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[0], q[1] + q[2] + q[3], q[4], q[5], q[1] + q[2], q[1]];
        let ([s1, s234, s5, s6, s23, s2], [c1, c234, c5, c6, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        let s234c5 = s234 * c5;
        let t_2 = c1c234 * c5 + s1 * s5;
        let t_3 = s1c234 * c5 - c1 * s5;
        let s234s5 = s234 * s5;
        let t_4 = s1 * c5 - c1c234 * s5;
        let t_5 = c1 * c5 + s1c234 * s5;
        let t_6 = s5 * 0.0823;
        let t_7 = c5 * 0.0823 + 0.10915;
        let t_8 = c234 * t_6 - s234 * 0.09465;
        let t_9 = s234 * t_6 + c234 * 0.09465;
        let t_10 = t_8 + 0.39225 * c23;
        let t_11 = t_9 + 0.39225 * s23;
        let t_12 = t_10 + 0.425 * c2;
        let t_13 = t_11 + 0.425 * s2;
        let t_14 = c1 * t_12 - s1 * t_7;
        let t_15 = s1 * t_12 + c1 * t_7;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_2 * c6 - c1s234 * s6, -(c1s234 * c6 + t_2 * s6), t_4],
                    [t_3 * c6 - s1s234 * s6, -(s1s234 * c6 + t_3 * s6), -t_5],
                    [s234c5 * c6 + c234 * s6, c234 * c6 - s234c5 * s6, -s234s5],
                ],
                [-t_14, -t_15, -(t_13 - 0.089459)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_15, -t_14, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_13, s1 * t_13, -t_12, s1, -c1, 0.0],
                    [c1 * t_11, s1 * t_11, -t_10, s1, -c1, 0.0],
                    [c1 * t_9, s1 * t_9, -t_8, s1, -c1, 0.0],
                    [
                        -t_2 * 0.0823,
                        -t_3 * 0.0823,
                        -s234c5 * 0.0823,
                        c1s234,
                        s1s234,
                        -c234,
                    ],
                    [0.0, 0.0, 0.0, t_4, -t_5, -s234s5],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for Ur5 {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Ur5 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Ur5::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Ur5::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Ur5 {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Ur5::jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Ur5 {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: an equation in sine and cosine (a cos + b sin = c, two values).
    /// 2. `q2 + q3 + q4`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 3. `q5`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 4. `q6`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 5. `q3`: the law of cosines (a cos + b sin = c, two values).
    /// 6. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::runtime::frame_of(target, 1.192809) {
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
        let frame = match ::dh_robot::runtime::frame_of(target, 1.192809) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 1.192809,
            few: false,
            given: ::core::option::Option::None,
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 1.192809),
        );
        let mut found = [[0.0; 8]; 6];
        let mut valid = [0.0; 8];
        if self.lanes(&frame, &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 6, 8> = ::dh_robot::runtime::lanes::collect(
                &Self::JOINTS,
                &valid,
                &found,
                &Self::BRANCHES,
            );
            return ::dh_robot::runtime::nearest(&list, q, 1.192809);
        }
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
        let frame = match ::dh_robot::runtime::frame_of(target, 1.192809) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 1.192809,
            few: false,
            given: ::core::option::Option::None,
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 1.192809),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, sample, found| self.candidates(frame, sample, found),
        )
    }
    /// The plan's unknowns at joint values.
    fn unknowns(&self, q: &[f64; 6]) -> [f64; 8] {
        [q[0], q[1] + q[2] + q[3], q[4], q[5], q[2], q[1], 0.0, 0.0]
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
        let t_2 = t[0][3] - t[0][2] * 0.06899679663718164;
        let t_3 = t[1][3] - t[1][2] * 0.06899679663718164;
        let t_4 = t[2][3] - t[2][2] * 0.06899679663718164;
        let t_5 = t_4 - 0.07499859575170878;
        let q1_roots = ::dh_robot::runtime::solve_sincos(
            -t_3,
            t_2,
            0.09150668715611636,
            sample.tolerance,
        );
        if !q1_roots.is_regular() {
            attempt.note(q1_roots.outcome, &path, "shoulder q1", 1.192809, "m");
        }
        let path = if q1_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[0]))
        } else {
            path
        };
        for (q1_root, &[c1, s1]) in q1_roots
            .or_if_free(sample.angle(0))
            .iter()
            .enumerate()
        {
            let path = path.root(0, q1_root);
            let q1 = ::dh_robot::runtime::atan2(s1, c1);
            let t_6 = t_2 * c1 + t_3 * s1;
            let t_7 = t_2 * s1 - t_3 * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let q2_plus_q3_plus_q4_roots = ::dh_robot::runtime::solve_sincos(
                -t[2][2],
                t_12,
                0.0,
                sample.tolerance,
            );
            if !q2_plus_q3_plus_q4_roots.is_regular() {
                attempt
                    .note(
                        q2_plus_q3_plus_q4_roots.outcome,
                        &path,
                        "wrist q2 + q3 + q4",
                        1.0,
                        "",
                    );
            }
            if path.is_chosen() {
                attempt.see(1, &path, [-t[2][2], t_12, 0.0]);
            }
            let path = if q2_plus_q3_plus_q4_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[1, 2, 3]))
            } else {
                path
            };
            for (q2_plus_q3_plus_q4_root, &[c234, s234]) in q2_plus_q3_plus_q4_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let path = path.root(1, q2_plus_q3_plus_q4_root);
                let q2_plus_q3_plus_q4 = ::dh_robot::runtime::atan2(s234, c234);
                let q5_roots = ::dh_robot::runtime::solve_many(
                    &[
                        [-1.0, 0.0, -(t[0][2] * s1 - t[1][2] * c1)],
                        [0.0, -s234, t[2][2]],
                        [0.0, -c234, t_12],
                    ],
                    sample.tolerance,
                );
                if !q5_roots.is_regular() {
                    attempt.note(q5_roots.outcome, &path, "q5", 1.0, "");
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
                    let q5 = ::dh_robot::runtime::atan2(s5, c5);
                    let c234c5 = c234 * c5;
                    let t_13 = t_12 * c5;
                    let t_14 = t[2][2] * c5;
                    let q6_roots = ::dh_robot::runtime::solve_pair(
                        c234c5,
                        -s234,
                        t_8,
                        -s234,
                        -c234c5,
                        t_10,
                        sample.tolerance,
                    );
                    if !q6_roots.is_regular() {
                        attempt.note(q6_roots.outcome, &path, "q6", 1.0, "");
                    }
                    let path = if q6_roots.is_free() {
                        attempt.choose(3, &path, ::dh_robot::FreeJoints::of(&[5]))
                    } else {
                        path
                    };
                    for (q6_root, &[c6, s6]) in q6_roots
                        .or_if_free(sample.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let q6 = ::dh_robot::runtime::atan2(s6, c6);
                        let t_15 = (t[2][0] * s6 + t[2][1] * c6) * 0.07935050791870282;
                        let t_16 = t_6 + (t_8 * s6 + t_10 * c6) * 0.07935050791870282;
                        let t_17 = t_7 + (t_9 * s6 + t_11 * c6) * 0.07935050791870282;
                        let t_18 = t_5 + t_15;
                        let t_19 = t_16 * t_16 + t_17 * t_17 + t_18 * t_18
                            - 0.2434638836493361;
                        let t_20 = 0.09150668715611636
                            * ((t_8 * c6 - t_10 * s6) * s5 + t_13);
                        let t_21 = 0.09150668715611636
                            * ((t[2][0] * c6 - t[2][1] * s6) * s5 + t_14);
                        let q3_roots = ::dh_robot::runtime::solve_sincos(
                            0.23433656705012487,
                            0.0,
                            t_19,
                            sample.tolerance,
                        );
                        if !q3_roots.is_regular() {
                            attempt
                                .note_law(
                                    q3_roots.outcome,
                                    &path,
                                    "elbow q3",
                                    [0.2434638836493361, t_19],
                                    false,
                                    1.192809,
                                    "m",
                                );
                        }
                        if path.is_chosen() {
                            attempt.see(4, &path, [0.23433656705012487, 0.0, t_19]);
                        }
                        let path = if q3_roots.is_free() {
                            attempt.choose(4, &path, ::dh_robot::FreeJoints::of(&[2]))
                        } else {
                            path
                        };
                        for (q3_root, &[c3, s3]) in q3_roots
                            .or_if_free(sample.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let path = path.root(4, q3_root);
                            let q3 = ::dh_robot::runtime::atan2(s3, c3);
                            let t_22 = 0.3563018052345346 + 0.32884560730175577 * c3;
                            let t_23 = 0.32884560730175577 * s3;
                            let q2_roots = ::dh_robot::runtime::solve_many(
                                &[
                                    [-t_22, t_23, t_16 - t_20],
                                    [-t_23, -t_22, t_18 - t_21],
                                    [-t_23, -t_22, -(0.07499859575170878 + t_21 - (t_4 + t_15))],
                                ],
                                sample.tolerance,
                            );
                            if !q2_roots.is_regular() {
                                attempt.note(q2_roots.outcome, &path, "q2", 1.0, "");
                            }
                            let path = if q2_roots.is_free() {
                                attempt.choose(5, &path, ::dh_robot::FreeJoints::of(&[1]))
                            } else {
                                path
                            };
                            for (q2_root, &[c2, s2]) in q2_roots
                                .or_if_free(sample.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let q2 = ::dh_robot::runtime::atan2(s2, c2);
                                let branch = ::dh_robot::Branch::ANY
                                    .with_step(0, q1_root)
                                    .with_shoulder(
                                        if q1_root == 0 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    )
                                    .with_step(1, q2_plus_q3_plus_q4_root)
                                    .with_wrist(
                                        if q2_plus_q3_plus_q4_root == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    )
                                    .with_step(2, q3_root)
                                    .with_elbow(
                                        if (q3_root == 0) == (q1_root == 0) {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    );
                                found(
                                    [q1, q2, q3, q2_plus_q3_plus_q4 - q3 - q2, q5, q6],
                                    branch,
                                    path,
                                );
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
        let frame = match ::dh_robot::runtime::frame_of(target, 1.192809) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 1.192809,
            few: false,
            given: ::core::option::Option::None,
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 1.192809),
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
    const BRANCHES: [::dh_robot::Branch; 8] = {
        let mut all = [::dh_robot::Branch::ANY; 8];
        let mut l = 0;
        while l < 8 {
            let q1_root = l / 1 % 2;
            let q2_plus_q3_plus_q4_root = l / 2 % 2;
            let q3_root = l / 4 % 2;
            all[l] = ::dh_robot::Branch::ANY
                .with_step(0, q1_root)
                .with_shoulder(
                    if q1_root == 0 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                )
                .with_step(1, q2_plus_q3_plus_q4_root)
                .with_wrist(
                    if q2_plus_q3_plus_q4_root == 0 {
                        ::dh_robot::Wrist::NoFlip
                    } else {
                        ::dh_robot::Wrist::Flip
                    },
                )
                .with_step(2, q3_root)
                .with_elbow(
                    if (q3_root == 0) == (q1_root == 0) {
                        ::dh_robot::Elbow::Up
                    } else {
                        ::dh_robot::Elbow::Down
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
        let t_2 = t[0][3] - t[0][2] * 0.06899679663718164;
        let t_3 = t[1][3] - t[1][2] * 0.06899679663718164;
        let t_4 = t[2][3] - t[2][2] * 0.06899679663718164;
        let t_5 = t_4 - 0.07499859575170878;
        let ([x0, y0, z0, w0], e0, m0) = ::dh_robot::runtime::lanes::sincos(
            -t_3,
            t_2,
            0.09150668715611636,
        );
        let c1_ = [x0, z0];
        let s1_ = [y0, w0];
        let g0_ = ::dh_robot::runtime::lanes::angles(&[y0, w0], &[x0, z0]);
        let mut v46_ = [0.0; 2];
        let mut v49_ = [0.0; 2];
        let mut v54_ = [0.0; 2];
        let mut v57_ = [0.0; 2];
        let mut v60_ = [0.0; 2];
        let mut v63_ = [0.0; 2];
        let mut v66_ = [0.0; 2];
        let mut v69_ = [0.0; 2];
        let mut v262_ = [0.0; 2];
        let mut v265_ = [0.0; 2];
        let mut f1 = [[0.0; 4]; 2];
        let mut margin1_ = [0.0; 2];
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
            let t_13 = 0.09150668715611636 * s1;
            let t_14 = 0.09150668715611636 * c1;
            v46_[l] = t_6;
            v49_[l] = t_7;
            v54_[l] = t_8;
            v57_[l] = t_9;
            v60_[l] = t_10;
            v63_[l] = t_11;
            v66_[l] = t_12;
            v69_[l] = t[0][2] * s1 - t[1][2] * c1;
            v262_[l] = t_13;
            v265_[l] = t_14;
            let ([x1, y1], m1) = ::dh_robot::runtime::lanes::half_turn([
                [-t[2][2], t_12],
            ]);
            f1[0][l] = x1;
            f1[1][l] = y1;
            f1[0][l + 2] = -x1;
            f1[1][l + 2] = -y1;
            margin1_[l] = m1;
        }
        let g1_ = ::dh_robot::runtime::lanes::angles(&f1[1], &f1[0]);
        let c234_ = f1[0];
        let s234_ = f1[1];
        let mut v242_ = [0.0; 4];
        let mut v243_ = [0.0; 4];
        let v66_: [f64; 4] = ::core::array::from_fn(|l| v66_[l % 2]);
        let v69_: [f64; 4] = ::core::array::from_fn(|l| v69_[l % 2]);
        let mut g2_ = [0.0; 4];
        let c1_: [f64; 4] = ::core::array::from_fn(|l| c1_[l % 2]);
        let s1_: [f64; 4] = ::core::array::from_fn(|l| s1_[l % 2]);
        let mut v267_ = [0.0; 4];
        let mut v268_ = [0.0; 4];
        let mut v269_ = [0.0; 4];
        let v54_: [f64; 4] = ::core::array::from_fn(|l| v54_[l % 2]);
        let v60_: [f64; 4] = ::core::array::from_fn(|l| v60_[l % 2]);
        let mut g3_ = [0.0; 4];
        let v46_: [f64; 4] = ::core::array::from_fn(|l| v46_[l % 2]);
        let v49_: [f64; 4] = ::core::array::from_fn(|l| v49_[l % 2]);
        let v57_: [f64; 4] = ::core::array::from_fn(|l| v57_[l % 2]);
        let v63_: [f64; 4] = ::core::array::from_fn(|l| v63_[l % 2]);
        let mut v170_ = [0.0; 4];
        let mut v172_ = [0.0; 4];
        let mut v210_ = [0.0; 4];
        let mut f4 = [[0.0; 8]; 2];
        let mut g4_ = [0.0; 8];
        let mut margin2_ = [0.0; 4];
        let mut valid2_ = [0.0; 4];
        let mut error2_ = [0.0; 4];
        for l in 0..4 {
            let s234 = s234_[l];
            let c234 = c234_[l];
            let t_15 = s234 * 0.07935050791870282;
            let t_16 = c234 * 0.07935050791870282;
            v242_[l] = t_15;
            v243_[l] = t_16;
            let v66 = v66_[l];
            let v69 = v69_[l];
            let ([c5, s5], m2) = ::dh_robot::runtime::lanes::pair(
                -1.0,
                0.0,
                -v69,
                0.0,
                -s234,
                t[2][2],
            );
            let g2 = ::dh_robot::runtime::lanes::angle(s5, c5);
            g2_[l] = g2;
            let j4a = g2;
            q[4][l] = j4a;
            q[4][l + 4] = j4a;
            let c1 = c1_[l];
            let s1 = s1_[l];
            let c234c5 = c234 * c5;
            let t_17 = v66 * c5;
            let t_18 = t[2][2] * c5;
            let c234s5 = c234 * s5;
            let s234s5 = s234 * s5;
            let t_19 = c1 * c234s5 - s1 * c5;
            let t_20 = s1 * c234s5 + c1 * c5;
            let t_21 = 0.06899679663718164 * t_19;
            let t_22 = 0.06899679663718164 * t_20;
            let t_23 = 0.06899679663718164 * s234s5;
            v267_[l] = t_21;
            v268_[l] = t_22;
            v269_[l] = t_23;
            let r3 = (-t_19 - t[0][2]).abs() + (-t_20 - t[1][2]).abs()
                + (-s234s5 - t[2][2]).abs();
            let v54 = v54_[l];
            let v60 = v60_[l];
            let ([c6, s6], m3) = ::dh_robot::runtime::lanes::pair(
                c234c5,
                -s234,
                v54,
                -s234,
                -c234c5,
                v60,
            );
            let g3 = ::dh_robot::runtime::lanes::angle(s6, c6);
            g3_[l] = g3;
            let j5a = g3;
            q[5][l] = j5a;
            q[5][l + 4] = j5a;
            let v46 = v46_[l];
            let v49 = v49_[l];
            let v57 = v57_[l];
            let v63 = v63_[l];
            let t_24 = (t[2][0] * s6 + t[2][1] * c6) * 0.07935050791870282;
            let t_25 = v46 + (v54 * s6 + v60 * c6) * 0.07935050791870282;
            let t_26 = v49 + (v57 * s6 + v63 * c6) * 0.07935050791870282;
            let t_27 = t_5 + t_24;
            let t_28 = t_25 * t_25 + t_26 * t_26 + t_27 * t_27 - 0.2434638836493361;
            let t_29 = 0.09150668715611636 * ((v54 * c6 - v60 * s6) * s5 + t_17);
            let t_30 = 0.09150668715611636 * ((t[2][0] * c6 - t[2][1] * s6) * s5 + t_18);
            let c5c6 = c5 * c6;
            let c6s5 = c6 * s5;
            let t_31 = c234 * c5c6 - s234 * s6;
            v170_[l] = t_25 - t_29;
            v172_[l] = t_27 - t_30;
            v210_[l] = 0.07499859575170878 + t_30 - (t_4 + t_24);
            let r4 = (c1 * t_31 + s1 * c6s5 - t[0][0]).abs()
                + (s1 * t_31 - c1 * c6s5 - t[1][0]).abs()
                + (s234 * c5c6 + c234 * s6 - t[2][0]).abs();
            let ([x4, y4, z4, w4], e4, m4) = ::dh_robot::runtime::lanes::sincos(
                0.23433656705012487,
                0.0,
                t_28,
            );
            f4[0][l] = x4;
            f4[1][l] = y4;
            f4[0][l + 4] = z4;
            f4[1][l + 4] = w4;
            let g4 = ::dh_robot::runtime::lanes::angle(y4, x4);
            g4_[l] = g4;
            let h4 = ::dh_robot::runtime::lanes::angle(w4, z4);
            g4_[l + 4] = h4;
            let j2a = g4;
            q[2][l] = j2a;
            let j2b = h4;
            q[2][l + 4] = j2b;
            margin2_[l] = ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(m2, m3),
                m4,
            );
            valid2_[l] = e4;
            error2_[l] = r3 + r4;
        }
        let c3_ = f4[0];
        let s3_ = f4[1];
        let v170_: [f64; 8] = ::core::array::from_fn(|l| v170_[l % 4]);
        let v172_: [f64; 8] = ::core::array::from_fn(|l| v172_[l % 4]);
        let v210_: [f64; 8] = ::core::array::from_fn(|l| v210_[l % 4]);
        let c1_: [f64; 8] = ::core::array::from_fn(|l| c1_[l % 4]);
        let s1_: [f64; 8] = ::core::array::from_fn(|l| s1_[l % 4]);
        let v242_: [f64; 8] = ::core::array::from_fn(|l| v242_[l % 4]);
        let v243_: [f64; 8] = ::core::array::from_fn(|l| v243_[l % 4]);
        let v262_: [f64; 8] = ::core::array::from_fn(|l| v262_[l % 2]);
        let v265_: [f64; 8] = ::core::array::from_fn(|l| v265_[l % 2]);
        let v267_: [f64; 8] = ::core::array::from_fn(|l| v267_[l % 4]);
        let v268_: [f64; 8] = ::core::array::from_fn(|l| v268_[l % 4]);
        let v269_: [f64; 8] = ::core::array::from_fn(|l| v269_[l % 4]);
        let g0_: [f64; 8] = ::core::array::from_fn(|l| g0_[l / 1 % 2]);
        let g1_: [f64; 8] = ::core::array::from_fn(|l| g1_[l / 2 % 2 * 2 + l % 2]);
        let g4_: [f64; 8] = ::core::array::from_fn(|l| g4_[l / 4 % 2 * 4 + l % 4]);
        let margin1_: [f64; 8] = ::core::array::from_fn(|l| margin1_[l % 2]);
        let margin2_: [f64; 8] = ::core::array::from_fn(|l| margin2_[l % 4]);
        let mut margin_ = [0.0; 8];
        let valid2_: [f64; 8] = ::core::array::from_fn(|l| valid2_[l % 4]);
        let mut valid_ = [0.0; 8];
        let error2_: [f64; 8] = ::core::array::from_fn(|l| error2_[l % 4]);
        let mut error_ = [0.0; 8];
        for l in 0..8 {
            let c3 = c3_[l];
            let s3 = s3_[l];
            let t_32 = 0.3563018052345346 + 0.32884560730175577 * c3;
            let t_33 = 0.32884560730175577 * s3;
            let v170 = v170_[l];
            let v172 = v172_[l];
            let v210 = v210_[l];
            let ([c2, s2], m5) = ::dh_robot::runtime::lanes::pair(
                -t_32,
                t_33,
                v170,
                -t_33,
                -t_32,
                v172,
            );
            let g5 = ::dh_robot::runtime::lanes::angle(s2, c2);
            let c1 = c1_[l];
            let s1 = s1_[l];
            let v242 = v242_[l];
            let v243 = v243_[l];
            let v262 = v262_[l];
            let v265 = v265_[l];
            let v267 = v267_[l];
            let v268 = v268_[l];
            let v269 = v269_[l];
            let t_34 = v242 - 0.32884560730175577 * (c3 * c2 - s3 * s2)
                - 0.3563018052345346 * c2;
            let t_35 = v243 + 0.32884560730175577 * (c3 * s2 + s3 * c2)
                + 0.3563018052345346 * s2;
            let r6 = (c1 * t_34 + v262 - v267 - t[0][3]).abs()
                + (s1 * t_34 - v265 - v268 - t[1][3]).abs()
                + (0.07499859575170878 - t_35 - v269 - t[2][3]).abs();
            let g0 = g0_[l];
            let g1 = g1_[l];
            let g4 = g4_[l];
            let margin1 = margin1_[l];
            let margin2 = margin2_[l];
            let valid2 = valid2_[l];
            let error2 = error2_[l];
            margin_[l] = ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(
                    ::dh_robot::runtime::lanes::lesser(m0, margin1),
                    margin2,
                ),
                m5,
            );
            valid_[l] = e0 * valid2;
            error_[l] = error2 + r6;
            q[0][l] = g0;
            q[1][l] = g5;
            q[3][l] = ::dh_robot::runtime::lanes::wrap(g1 - g4 - g5);
        }
        *valid = valid_;
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for Ur5 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c234 - s6 * s234;
        let t_3 = c6c5 * s234 + s6 * c234;
        let t_4 = t_2 * c1 + c6s5 * s1;
        let t_5 = t_2 * s1 - c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 - c5 * s1;
        let t_7 = s1 * s5c234 + c5 * c1;
        let t_8 = s234 * 0.09465 - 0.39225 * c23 - 0.425 * c2;
        let t_9 = c234 * 0.09465 + 0.39225 * s23 + 0.425 * s2 - 0.089459
            + s5s234 * 0.0823;
        [
            [
                t_4,
                -(t_3 * t_7 - t_5 * s5s234),
                -t_6,
                c1 * t_8 + s1 * 0.10915 - t_6 * 0.0823,
            ],
            [
                t_5,
                -(t_4 * s5s234 - t_3 * t_6),
                -t_7,
                s1 * t_8 - c1 * 0.10915 - t_7 * 0.0823,
            ],
            [t_3, -(t_5 * t_6 - t_4 * t_7), -s5s234, -t_9],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1] + q[2] + q[3], q[4], q[5], q[1] + q[2], q[1]];
        let ([s1, s234, s5, s6, s23, s2], [c1, c234, c5, c6, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        let s234c5 = s234 * c5;
        let t_2 = c1c234 * c5 + s1 * s5;
        let t_3 = s1c234 * c5 - c1 * s5;
        let s234s5 = s234 * s5;
        let t_4 = s1 * c5 - c1c234 * s5;
        let t_5 = c1 * c5 + s1c234 * s5;
        let t_6 = s5 * 0.0823;
        let t_7 = c5 * 0.0823 + 0.10915;
        let t_8 = c234 * t_6 - s234 * 0.09465;
        let t_9 = s234 * t_6 + c234 * 0.09465;
        let t_10 = t_8 + 0.39225 * c23;
        let t_11 = t_9 + 0.39225 * s23;
        let t_12 = t_10 + 0.425 * c2;
        let t_13 = t_11 + 0.425 * s2;
        let t_14 = c1 * t_12 - s1 * t_7;
        let t_15 = s1 * t_12 + c1 * t_7;
        (
            [
                [t_2 * c6 - c1s234 * s6, -(c1s234 * c6 + t_2 * s6), t_4, -t_14],
                [t_3 * c6 - s1s234 * s6, -(s1s234 * c6 + t_3 * s6), -t_5, -t_15],
                [
                    s234c5 * c6 + c234 * s6,
                    c234 * c6 - s234c5 * s6,
                    -s234s5,
                    -(t_13 - 0.089459),
                ],
            ],
            [
                [t_15, c1 * t_13, c1 * t_11, c1 * t_9, -t_2 * 0.0823, 0.0],
                [-t_14, s1 * t_13, s1 * t_11, s1 * t_9, -t_3 * 0.0823, 0.0],
                [0.0, -t_12, -t_10, -t_8, -s234c5 * 0.0823, 0.0],
                [0.0, s1, s1, s1, c1s234, t_4],
                [0.0, -c1, -c1, -c1, s1s234, -t_5],
                [1.0, 0.0, 0.0, 0.0, -c234, -s234s5],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, 8, f64> for Ur5 {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 8> {
        Ur5::inverse(self, target)
    }
}
