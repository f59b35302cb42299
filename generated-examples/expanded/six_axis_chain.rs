// What `dh_robot!` makes of src/six_axis_chain.rs. Made by `cargo regen`; do not edit.

/// A chain of six axes of which the second, third and fourth are parallel.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha |
/// |---|---|---|---|---|
/// | 1 | q1 | 0 | 0 | 90deg |
/// | 2 | q2 | 0 | a2 | 0 |
/// | 3 | q3 | 0 | a3 | 0 |
/// | 4 | q4 | 0 | a4 | -90deg |
/// | 5 | q5 | 0 | 0 | 90deg |
/// | 6 | q6 | 0 | 0 | 0 |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁(c₂₃₄c₅c₆ − s₂₃₄s₆) − s₁s₅c₆
/// r₂₁ = s₁(c₂₃₄c₅c₆ − s₂₃₄s₆) + c₁s₅c₆
/// r₃₁ = s₂₃₄c₅c₆ + c₂₃₄s₆
/// r₁₂ = −c₁(c₂₃₄c₅s₆ + s₂₃₄c₆) + s₁s₅s₆
/// r₂₂ = −s₁(c₂₃₄c₅s₆ + s₂₃₄c₆) − c₁s₅s₆
/// r₃₂ = c₂₃₄c₆ − s₂₃₄c₅s₆
/// r₁₃ = c₁c₂₃₄s₅ + s₁c₅
/// r₂₃ = s₁c₂₃₄s₅ − c₁c₅
/// r₃₃ = s₂₃₄s₅
/// px  = c₁(a₂c₂ + a₃c₂₃ + a₄c₂₃₄)
/// py  = s₁(a₂c₂ + a₃c₂₃ + a₄c₂₃₄)
/// pz  = a₂s₂ + a₃s₂₃ + a₄s₂₃₄
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      c₂₃₄ = cos(q₂ + q₃ + q₄), s₂₃₄ = sin(q₂ + q₃ + q₄)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixAxisChain {
    /// `a2` in m, nominally 0.5.
    pub a2: f64,
    /// `a3` in m, nominally 0.4.
    pub a3: f64,
    /// `a4` in m, nominally 0.2.
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
#[allow(unused, clippy::all, clippy::pedantic)]
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
    /// Cost: 30 multiplications, 15 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
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
        let t_4 = t_2 * c1 - c6s5 * s1;
        let t_5 = t_2 * s1 + c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 + c5 * s1;
        let t_7 = s1 * s5c234 - c5 * c1;
        let t_8 = c234 * self.a4 + self.a3 * c23 + self.a2 * c2;
        ::dh_robot::pose::from_entries(
            [
                [t_4, t_3 * t_7 - t_5 * s5s234, t_6],
                [t_5, t_4 * s5s234 - t_3 * t_6, t_7],
                [t_3, t_5 * t_6 - t_4 * t_7, s5s234],
            ],
            [c1 * t_8, s1 * t_8, s234 * self.a4 + self.a3 * s23 + self.a2 * s2],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 46 multiplications, 18 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4], q[5]];
        let ([s1, s2, s23, s234, s5, s6], [c1, c2, c23, c234, c5, c6]) = ::dh_robot::runtime::sincos_batch(
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
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 22 multiplications, 8 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
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
    /// Cost: 38 multiplications, 15 additions, 6 sine-cosine pairs.
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
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
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
        ::dh_robot::velocity::solve_velocity(
            &self.jacobian(q),
            twist,
            1.1159566801270322,
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
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        SixAxisChain::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl SixAxisChain {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 1.1159566801270322;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
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
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 8]; 6];
        let mut valid = [0.0; 8];
        if !self.all_branches(&frame, &mut q, &mut valid) {
            return self.inverse_with_work(target).0;
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
        let mut found = [[0.0; 8]; 6];
        let mut valid = [0.0; 8];
        if self.all_branches(&frame, &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 6, 8> = ::dh_robot::runtime::batched::collect(
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
        let t_2 = self.a4 * Self::PER_LENGTH;
        let t_3 = self.a2 * Self::PER_LENGTH;
        let t_4 = self.a3 * Self::PER_LENGTH;
        let t_5 = t_3 * t_3 + t_4 * t_4;
        // Step 1: q1 from a ratio of sine and cosine.
        let q1_roots = ::dh_robot::runtime::solve_sincos(
            -t[1][3],
            t[0][3],
            0.0,
            sample.tolerance,
        );
        if !q1_roots.is_regular() {
            attempt
                .note(q1_roots.outcome, &path, "shoulder q1", Self::LENGTH_SCALE, "m");
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
            let t_6 = t[0][3] * c1 + t[1][3] * s1;
            let t_7 = t[0][0] * c1 + t[1][0] * s1;
            let t_8 = t[0][1] * c1 + t[1][1] * s1;
            let t_9 = t[0][2] * c1 + t[1][2] * s1;
            // Step 2: q2 + q3 + q4 from a ratio of sine and cosine.
            let q2_plus_q3_plus_q4_roots = ::dh_robot::runtime::solve_sincos(
                -t[2][2],
                t_9,
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
                attempt.see(1, &path, [-t[2][2], t_9, 0.0]);
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
                // Step 3: q5 from sine and cosine.
                let q5_roots = ::dh_robot::runtime::solve_pair(
                    -1.0,
                    0.0,
                    -(t[0][2] * s1 - t[1][2] * c1),
                    0.0,
                    1.0,
                    t_9 * c234 + t[2][2] * s234,
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
                    let t_10 = t[0][2] * s5;
                    let t_11 = t[1][2] * s5;
                    let t_12 = t[2][2] * s5;
                    let t_13 = t_9 * s5;
                    // Step 4: q6 from sine and cosine.
                    let q6_roots = ::dh_robot::runtime::solve_many(
                        &[
                            [c234c5, -s234, t_7],
                            [-s234, -c234c5, t_8],
                            [s5, 0.0, -(t[0][0] * s1 - t[1][0] * c1)],
                            [0.0, -s5, -(t[0][1] * s1 - t[1][1] * c1)],
                        ],
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
                        let t_14 = t[0][3]
                            - (c5 * (t[0][0] * c6 - t[0][1] * s6) + t_10) * t_2;
                        let t_15 = t[1][3]
                            - (c5 * (t[1][0] * c6 - t[1][1] * s6) + t_11) * t_2;
                        let t_16 = t[2][3]
                            - (c5 * (t[2][0] * c6 - t[2][1] * s6) + t_12) * t_2;
                        // Step 5: q3 from the law of cosines.
                        let q3_roots = ::dh_robot::runtime::solve_sincos(
                            2.0 * t_3 * t_4,
                            0.0,
                            t_14 * t_14 + t_15 * t_15 + t_16 * t_16 - t_5,
                            sample.tolerance,
                        );
                        if !q3_roots.is_regular() {
                            attempt
                                .note_law(
                                    q3_roots.outcome,
                                    &path,
                                    "elbow q3",
                                    [t_5, t_14 * t_14 + t_15 * t_15 + t_16 * t_16 - t_5],
                                    false,
                                    Self::LENGTH_SCALE,
                                    "m",
                                );
                        }
                        if path.is_chosen() {
                            attempt
                                .see(
                                    4,
                                    &path,
                                    [
                                        2.0 * t_3 * t_4,
                                        0.0,
                                        t_14 * t_14 + t_15 * t_15 + t_16 * t_16 - t_5,
                                    ],
                                );
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
                            let t_17 = t_3 + t_4 * c3;
                            let t_18 = t_4 * s3;
                            // Step 6: q2 from sine and cosine.
                            let q2_roots = ::dh_robot::runtime::solve_pair(
                                t_17,
                                -t_18,
                                t_6 - t_2 * (c5 * (t_7 * c6 - t_8 * s6) + t_13),
                                t_18,
                                t_17,
                                t_16,
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
                                        if q1_root == 1 {
                                            ::dh_robot::Shoulder::Left
                                        } else {
                                            ::dh_robot::Shoulder::Right
                                        },
                                    )
                                    .with_step(1, q2_plus_q3_plus_q4_root)
                                    .with_wrist(
                                        if q2_plus_q3_plus_q4_root == 1 {
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
    /// Which root each step takes in each branch.
    const BRANCHES: [::dh_robot::Branch; 8] = {
        let mut all = [::dh_robot::Branch::ANY; 8];
        let mut branch = 0;
        while branch < 8 {
            let q1_root = branch / 1 % 2;
            let q2_plus_q3_plus_q4_root = branch / 2 % 2;
            let q3_root = branch / 4 % 2;
            all[branch] = ::dh_robot::Branch::ANY
                .with_step(0, q1_root)
                .with_shoulder(
                    if q1_root == 1 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                )
                .with_step(1, q2_plus_q3_plus_q4_root)
                .with_wrist(
                    if q2_plus_q3_plus_q4_root == 1 {
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
            branch += 1;
        }
        all
    };
    /// The plan for all branches at once: joint values, and which branches are real; false where the fallback path has to decide.
    #[inline]
    fn all_branches(
        &self,
        t: &::dh_robot::runtime::Pose,
        q: &mut [[f64; 8]; 6],
        valid: &mut [f64; 8],
    ) -> bool {
        let t_2 = self.a4 * Self::PER_LENGTH;
        let t_3 = self.a2 * Self::PER_LENGTH;
        let t_4 = self.a3 * Self::PER_LENGTH;
        let t_5 = t_3 * t_3 + t_4 * t_4;
        // Step 1: q1 from a ratio of sine and cosine.
        let ([c1_first, s1_first], q1_margin) = ::dh_robot::runtime::batched::half_turn([
            [-t[1][3], t[0][3]],
        ]);
        let all_c1 = [c1_first, -c1_first];
        let all_s1 = [s1_first, -s1_first];
        let all_q1 = ::dh_robot::runtime::batched::angles(
            &[s1_first, -s1_first],
            &[c1_first, -c1_first],
        );
        let mut all_t_6 = [0.0; 2];
        let mut all_t_7 = [0.0; 2];
        let mut all_t_10 = [0.0; 2];
        let mut all_t_8 = [0.0; 2];
        let mut all_t_11 = [0.0; 2];
        let mut all_t_9 = [0.0; 2];
        let mut all_t_12 = [0.0; 2];
        let mut q2_plus_q3_plus_q4_pairs = [[0.0; 4]; 2];
        let mut all_margin_1 = [0.0; 2];
        for branch in 0..2 {
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let t_6 = t[0][3] * c1 + t[1][3] * s1;
            let t_7 = t[0][0] * c1 + t[1][0] * s1;
            let t_8 = t[0][1] * c1 + t[1][1] * s1;
            let t_9 = t[0][2] * c1 + t[1][2] * s1;
            all_t_6[branch] = t_6;
            all_t_7[branch] = t_7;
            let t_10 = t[0][0] * s1 - t[1][0] * c1;
            all_t_10[branch] = t_10;
            all_t_8[branch] = t_8;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            all_t_11[branch] = t_11;
            all_t_9[branch] = t_9;
            let t_12 = t[0][2] * s1 - t[1][2] * c1;
            all_t_12[branch] = t_12;
            // Step 2: q2 + q3 + q4 from a ratio of sine and cosine.
            let ([c234_first, s234_first], q2_plus_q3_plus_q4_margin) = ::dh_robot::runtime::batched::half_turn([
                [-t[2][2], t_9],
            ]);
            q2_plus_q3_plus_q4_pairs[0][branch] = c234_first;
            q2_plus_q3_plus_q4_pairs[1][branch] = s234_first;
            q2_plus_q3_plus_q4_pairs[0][branch + 2] = -c234_first;
            q2_plus_q3_plus_q4_pairs[1][branch + 2] = -s234_first;
            all_margin_1[branch] = q2_plus_q3_plus_q4_margin;
        }
        let all_q2_plus_q3_plus_q4 = ::dh_robot::runtime::batched::angles(
            &q2_plus_q3_plus_q4_pairs[1],
            &q2_plus_q3_plus_q4_pairs[0],
        );
        let all_c234 = q2_plus_q3_plus_q4_pairs[0];
        let all_s234 = q2_plus_q3_plus_q4_pairs[1];
        let all_t_9: [f64; 4] = ::core::array::from_fn(|branch| all_t_9[branch % 2]);
        let mut all_t_13 = [0.0; 4];
        let mut all_t_14 = [0.0; 4];
        let all_t_12: [f64; 4] = ::core::array::from_fn(|branch| all_t_12[branch % 2]);
        let mut all_q5 = [0.0; 4];
        let all_c1: [f64; 4] = ::core::array::from_fn(|branch| all_c1[branch % 2]);
        let all_s1: [f64; 4] = ::core::array::from_fn(|branch| all_s1[branch % 2]);
        let all_t_7: [f64; 4] = ::core::array::from_fn(|branch| all_t_7[branch % 2]);
        let all_t_10: [f64; 4] = ::core::array::from_fn(|branch| all_t_10[branch % 2]);
        let all_t_8: [f64; 4] = ::core::array::from_fn(|branch| all_t_8[branch % 2]);
        let all_t_11: [f64; 4] = ::core::array::from_fn(|branch| all_t_11[branch % 2]);
        let mut all_q6 = [0.0; 4];
        let all_t_6: [f64; 4] = ::core::array::from_fn(|branch| all_t_6[branch % 2]);
        let mut all_t_21 = [0.0; 4];
        let mut all_t_23 = [0.0; 4];
        let mut q3_pairs = [[0.0; 8]; 2];
        let mut all_q3 = [0.0; 8];
        let mut all_margin_2 = [0.0; 4];
        let mut all_valid_2 = [0.0; 4];
        let mut all_error_2 = [0.0; 4];
        for branch in 0..4 {
            let t_9 = all_t_9[branch];
            let c234 = all_c234[branch];
            let s234 = all_s234[branch];
            let t_13 = c234 * t_2;
            let t_14 = s234 * t_2;
            all_t_13[branch] = t_13;
            all_t_14[branch] = t_14;
            let t_12 = all_t_12[branch];
            // Step 3: q5 from sine and cosine.
            let [c5, s5] = ::dh_robot::runtime::batched::unit(
                t_12,
                t_9 * c234 + t[2][2] * s234,
            );
            let q5 = ::dh_robot::runtime::batched::angle(s5, c5);
            all_q5[branch] = q5;
            let q5_in_range = q5;
            q[4][branch] = q5_in_range;
            q[4][branch + 4] = q5_in_range;
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let c234c5 = c234 * c5;
            let t_15 = t[0][2] * s5;
            let t_16 = t[1][2] * s5;
            let t_17 = t[2][2] * s5;
            let t_18 = t_9 * s5;
            let c234s5 = c234 * s5;
            let q5_error = (c1 * c234s5 + s1 * c5 - t[0][2]).abs()
                + (s1 * c234s5 - c1 * c5 - t[1][2]).abs() + (s234 * s5 - t[2][2]).abs();
            let t_7 = all_t_7[branch];
            let t_10 = all_t_10[branch];
            let t_8 = all_t_8[branch];
            let t_11 = all_t_11[branch];
            // Step 4: q6 from sine and cosine.
            let ([c6, s6], q6_margin) = ::dh_robot::runtime::batched::pair(
                c234c5,
                -s234,
                t_7,
                -s234,
                -c234c5,
                t_8,
            );
            let q6 = ::dh_robot::runtime::batched::angle(s6, c6);
            all_q6[branch] = q6;
            let q6_in_range = q6;
            q[5][branch] = q6_in_range;
            q[5][branch + 4] = q6_in_range;
            let t_6 = all_t_6[branch];
            let t_19 = t[0][3] - (c5 * (t[0][0] * c6 - t[0][1] * s6) + t_15) * t_2;
            let t_20 = t[1][3] - (c5 * (t[1][0] * c6 - t[1][1] * s6) + t_16) * t_2;
            let t_21 = t[2][3] - (c5 * (t[2][0] * c6 - t[2][1] * s6) + t_17) * t_2;
            let c5c6 = c5 * c6;
            let s5c6 = s5 * c6;
            let t_22 = c234 * c5c6 - s234 * s6;
            all_t_21[branch] = t_21;
            let t_23 = t_6 - t_2 * (c5 * (t_7 * c6 - t_8 * s6) + t_18);
            all_t_23[branch] = t_23;
            let q6_error = (c1 * t_22 - s1 * s5c6 - t[0][0]).abs()
                + (s1 * t_22 + c1 * s5c6 - t[1][0]).abs()
                + (s234 * c5c6 + c234 * s6 - t[2][0]).abs();
            // Step 5: q3 from the law of cosines.
            let ([c3_first, s3_first, c3_second, s3_second], q3_valid, q3_margin) = ::dh_robot::runtime::batched::sincos(
                2.0 * t_3 * t_4,
                0.0,
                t_19 * t_19 + t_20 * t_20 + t_21 * t_21 - t_5,
            );
            q3_pairs[0][branch] = c3_first;
            q3_pairs[1][branch] = s3_first;
            q3_pairs[0][branch + 4] = c3_second;
            q3_pairs[1][branch + 4] = s3_second;
            let q3 = ::dh_robot::runtime::batched::angle(s3_first, c3_first);
            all_q3[branch] = q3;
            let q3_second = ::dh_robot::runtime::batched::angle(s3_second, c3_second);
            all_q3[branch + 4] = q3_second;
            let q3_in_range = q3;
            q[2][branch] = q3_in_range;
            let q3_second_in_range = q3_second;
            q[2][branch + 4] = q3_second_in_range;
            all_margin_2[branch] = ::dh_robot::runtime::batched::lesser(
                q6_margin,
                q3_margin,
            );
            all_valid_2[branch] = q3_valid;
            all_error_2[branch] = q5_error + q6_error;
        }
        let all_c3 = q3_pairs[0];
        let all_s3 = q3_pairs[1];
        let all_t_21: [f64; 8] = ::core::array::from_fn(|branch| all_t_21[branch % 4]);
        let all_t_23: [f64; 8] = ::core::array::from_fn(|branch| all_t_23[branch % 4]);
        let all_c1: [f64; 8] = ::core::array::from_fn(|branch| all_c1[branch % 4]);
        let all_s1: [f64; 8] = ::core::array::from_fn(|branch| all_s1[branch % 4]);
        let all_t_13: [f64; 8] = ::core::array::from_fn(|branch| all_t_13[branch % 4]);
        let all_t_14: [f64; 8] = ::core::array::from_fn(|branch| all_t_14[branch % 4]);
        let all_q1: [f64; 8] = ::core::array::from_fn(|branch| all_q1[branch / 1 % 2]);
        let all_q2_plus_q3_plus_q4: [f64; 8] = ::core::array::from_fn(|branch| {
            all_q2_plus_q3_plus_q4[branch / 2 % 2 * 2 + branch % 2]
        });
        let all_q3: [f64; 8] = ::core::array::from_fn(|branch| {
            all_q3[branch / 4 % 2 * 4 + branch % 4]
        });
        let all_margin_1: [f64; 8] = ::core::array::from_fn(|branch| {
            all_margin_1[branch % 2]
        });
        let all_margin_2: [f64; 8] = ::core::array::from_fn(|branch| {
            all_margin_2[branch % 4]
        });
        let mut all_margin = [0.0; 8];
        let all_valid_2: [f64; 8] = ::core::array::from_fn(|branch| {
            all_valid_2[branch % 4]
        });
        let mut all_valid = [0.0; 8];
        let all_error_2: [f64; 8] = ::core::array::from_fn(|branch| {
            all_error_2[branch % 4]
        });
        let mut all_error = [0.0; 8];
        for branch in 0..8 {
            let c3 = all_c3[branch];
            let s3 = all_s3[branch];
            let t_24 = t_3 + t_4 * c3;
            let t_25 = t_4 * s3;
            let t_21 = all_t_21[branch];
            let t_23 = all_t_23[branch];
            // Step 6: q2 from sine and cosine.
            let ([c2, s2], q2_margin) = ::dh_robot::runtime::batched::pair(
                t_24,
                -t_25,
                t_23,
                t_25,
                t_24,
                t_21,
            );
            let q2 = ::dh_robot::runtime::batched::angle(s2, c2);
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let t_13 = all_t_13[branch];
            let t_14 = all_t_14[branch];
            let t_26 = t_13 + t_4 * (c3 * c2 - s3 * s2) + t_3 * c2;
            let q2_error = (c1 * t_26 - t[0][3]).abs() + (s1 * t_26 - t[1][3]).abs()
                + (t_14 + t_4 * (c3 * s2 + s3 * c2) + t_3 * s2 - t[2][3]).abs();
            let q1 = all_q1[branch];
            let q2_plus_q3_plus_q4 = all_q2_plus_q3_plus_q4[branch];
            let q3 = all_q3[branch];
            let margin_1 = all_margin_1[branch];
            let margin_2 = all_margin_2[branch];
            let valid_2 = all_valid_2[branch];
            let error_2 = all_error_2[branch];
            // How far the branch is from the target.
            all_margin[branch] = ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(
                    ::dh_robot::runtime::batched::lesser(q1_margin, margin_1),
                    margin_2,
                ),
                q2_margin,
            );
            all_valid[branch] = valid_2;
            all_error[branch] = error_2 + q2_error;
            q[0][branch] = q1;
            q[1][branch] = q2;
            q[3][branch] = ::dh_robot::runtime::batched::wrap(
                q2_plus_q3_plus_q4 - q3 - q2,
            );
        }
        *valid = all_valid;
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for SixAxisChain {
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
        let t_4 = t_2 * c1 - c6s5 * s1;
        let t_5 = t_2 * s1 + c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_6 = c1 * s5c234 + c5 * s1;
        let t_7 = s1 * s5c234 - c5 * c1;
        let t_8 = c234 * self.a4 + self.a3 * c23 + self.a2 * c2;
        [
            [t_4, t_3 * t_7 - t_5 * s5s234, t_6, c1 * t_8],
            [t_5, t_4 * s5s234 - t_3 * t_6, t_7, s1 * t_8],
            [
                t_3,
                t_5 * t_6 - t_4 * t_7,
                s5s234,
                s234 * self.a4 + self.a3 * s23 + self.a2 * s2,
            ],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
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
impl ::dh_robot::InverseKinematics<6, f64> for SixAxisChain {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 6, 8>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        SixAxisChain::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        SixAxisChain::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for SixAxisChain {
    type Joints = ::dh_robot::runtime::Joints<6>;
}
