// What `dh_robot!` makes of src/cobra600.rs. Made by `cargo regen`; do not edit.

/// Adept Cobra 600: the second twist of half a turn points the quill down.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | 1 | q1 | 387mm | 325mm | 0 | -50deg..=50deg |
/// | 2 | q2 | 0 | 275mm | 180deg | -88deg..=88deg |
/// | 3 | 0 | q3 | 0 | 0 | 0mm..=210mm |
/// | 4 | q4 | 0 | 0 | 0 | -1turn..=1turn |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// ⎡ c₁₂₋₄   s₁₂₋₄   0  a₁c₁ + a₂c₁₂ ⎤
/// ⎢ s₁₂₋₄  −c₁₂₋₄   0  a₁s₁ + a₂s₁₂ ⎥
/// ⎣ 0       0      −1  d₁ − q₃      ⎦
///
/// where c₁ = cos q₁, s₁ = sin q₁, c₁₂ = cos(q₁ + q₂), s₁₂ = sin(q₁ + q₂),
///      c₁₂₋₄ = cos(q₁ + q₂ − q₄), s₁₂₋₄ = sin(q₁ + q₂ − q₄), a₁ = 0.325, d₁ = 0.387,
///      a₂ = 0.275
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cobra600;
impl ::core::default::Default for Cobra600 {
    fn default() -> Self {
        Cobra600
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Cobra600 {
    /// Number of joints.
    pub const DOF: usize = 4;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 4] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-0.8726646259971648, 0.8726646259971648),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-1.53588974175501, 1.53588974175501),
        ::dh_robot::Joint::prismatic("q3").with_range(0.0, 0.21),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-6.283185307179586, 6.283185307179586),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 4 multiplications, 5 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms; equation (8) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[0] + q[1] - q[3], q[0] + q[1], q[0]];
        let ([s12m4, s12, s1], [c12m4, c12, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        ::dh_robot::pose::from_entries(
            [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
            [0.275 * c12 + 0.325 * c1, 0.275 * s12 + 0.325 * s1, -(q[2] - 0.387)],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 4 multiplications, 5 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 4],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        let angles = [q[0], q[0] + q[1], q[0] + q[1] - q[3]];
        let ([s1, s12, s12m4], [c1, c12, c12m4]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c1 * 0.325;
        let t_3 = s1 * 0.325;
        let t_4 = t_2 + 0.275 * c12;
        let t_5 = t_3 + 0.275 * s12;
        let t_6 = 0.387 - q[2];
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [t_2, t_3, 0.387],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, s12, 0.0], [s12, -c12, 0.0], [0.0, 0.0, -1.0]],
                [t_4, t_5, 0.387],
            ),
            ::dh_robot::pose::from_entries(
                [[c12, s12, 0.0], [s12, -c12, 0.0], [0.0, 0.0, -1.0]],
                [t_4, t_5, t_6],
            ),
            ::dh_robot::pose::from_entries(
                [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
                [t_4, t_5, t_6],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (9) of the robot's notes.
    ///
    /// Cost: 4 multiplications, 3 additions, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        let angles = [q[0] + q[1], q[0]];
        let ([s12, s1], [c12, c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = 0.275 * c12;
        let t_3 = 0.275 * s12;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [-(t_3 + 0.325 * s1), t_2 + 0.325 * c1, 0.0, 0.0, 0.0, 1.0],
                [-t_3, t_2, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 4 multiplications, 5 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 4>,
    ) {
        let angles = [q[0] + q[1] - q[3], q[0] + q[1], q[0]];
        let ([s12m4, s12, s1], [c12m4, c12, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = 0.275 * c12;
        let t_3 = 0.275 * s12;
        let t_4 = t_2 + 0.325 * c1;
        let t_5 = t_3 + 0.325 * s1;
        (
            ::dh_robot::pose::from_entries(
                [[c12m4, s12m4, 0.0], [s12m4, -c12m4, 0.0], [0.0, 0.0, -1.0]],
                [t_4, t_5, -(q[2] - 0.387)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_5, t_4, 0.0, 0.0, 0.0, 1.0],
                    [-t_3, t_2, 0.0, 0.0, 0.0, 1.0],
                    [0.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, 0.0, 0.0, -1.0],
                ]),
            ),
        )
    }
    /// [`forward`](Self::forward) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn forward_batch(
        &self,
        q: &[[f64; 4]],
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
        q: &[[f64; 4]],
        jacobians: &mut [::dh_robot::nalgebra::SMatrix<f64, 6, 4>],
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
        q: &[f64; 4],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        let (pose, jacobian) = self.forward_and_jacobian(q);
        ::dh_robot::velocity::in_axes_of(&pose, &jacobian)
    }
    /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.
    #[inline]
    #[must_use]
    pub fn jacobian_dot(
        &self,
        q: &[f64; 4],
        speeds: &[f64; 4],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        ::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)
    }
    /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn manipulability(&self, q: &[f64; 4]) -> f64 {
        ::dh_robot::velocity::manipulability(&self.jacobian(q))
    }
    /// The smallest singular value of the Jacobian, in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn smallest_singular_value(&self, q: &[f64; 4]) -> f64 {
        ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))
    }
    /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and
    /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).
    #[inline]
    #[must_use]
    pub fn solve_velocity(
        &self,
        q: &[f64; 4],
        twist: &::dh_robot::nalgebra::Vector6<f64>,
    ) -> ::dh_robot::velocity::JointSpeeds<f64, 4> {
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 0.987)
    }
}
impl ::dh_robot::Robot<4, f64> for Cobra600 {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 4] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<4, f64> for Cobra600 {
    #[inline]
    fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Cobra600::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 4]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        Cobra600::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<4, f64> for Cobra600 {
    #[inline]
    fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        Cobra600::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 4>,
    ) {
        Cobra600::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Cobra600 {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 2;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 0.987;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q3`: a linear equation (a d + b = 0, one value).
    /// 2. `q1 + q2 - q4`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 3. `q2`: the law of cosines (a cos + b sin = c, two values).
    /// 4. `q1`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 4, 2> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 2]; 4];
        let mut valid = [0.0; 2];
        if !self.all_branches(&frame, &mut q, &mut valid) {
            return self.inverse_with_work(target).0;
        }
        if valid == [1.0; 2] {
            let at = |branch: usize| ::dh_robot::runtime::batched::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                branch,
            );
            return ::dh_robot::Solutions::full(&Self::JOINTS, [at(0), at(1)]);
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
        q: &[f64; 4],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 4>, ::dh_robot::Why<f64>> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 4],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        let mut found = [[0.0; 2]; 4];
        let mut valid = [0.0; 2];
        if self.all_branches(&frame, &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 4, 2> = ::dh_robot::runtime::batched::collect(
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
            4,
            2,
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
    ) -> ::dh_robot::Solutions<f64, 4, 2> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 4],
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
        solutions: &mut [::dh_robot::Solutions<f64, 4, 2>],
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
        q: &[[f64; 4]],
        solutions: &mut [::core::result::Result<
            ::dh_robot::Solution<f64, 4>,
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
    ) -> (::dh_robot::Solutions<f64, 4, 2>, f64) {
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
        solution: &::dh_robot::Solution<f64, 4>,
    ) -> ::core::option::Option<[f64; 4]> {
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [
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
    fn unknowns(&self, q: &[f64; 4]) -> [f64; 8] {
        [(q[2]) / Self::LENGTH_SCALE, q[0] + q[1] - q[3], q[1], q[0], 0.0, 0.0, 0.0, 0.0]
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        sample: &::dh_robot::runtime::Sample,
        found: &mut dyn FnMut([f64; 4], ::dh_robot::Branch, ::dh_robot::runtime::Path),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let path = ::dh_robot::runtime::Path::START;
        let t_2 = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
        let t_3 = t_2 - 0.3397962776479236;
        // Step 1: q3 from a linear equation.
        let q3_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            -1.0,
            -(t[2][3] - 0.39209726443769),
            sample.tolerance,
        );
        if !q3_roots.is_regular() {
            attempt.note(q3_roots.outcome, &path, "q3", Self::LENGTH_SCALE, "m");
        }
        let path = if q3_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[2]))
        } else {
            path
        };
        for (q3_root, &q3_scaled) in q3_roots
            .or_if_free(sample.length(0))
            .iter()
            .enumerate()
        {
            let q3 = q3_scaled * Self::LENGTH_SCALE;
            let t_4 = q3_scaled * (0.78419452887538 - q3_scaled);
            // Step 2: q1 + q2 - q4 from sine and cosine.
            let q1_plus_q2_minus_q4_roots = ::dh_robot::runtime::solve_pair(
                1.0,
                0.0,
                t[0][0],
                0.0,
                1.0,
                t[0][1],
                sample.tolerance,
            );
            if !q1_plus_q2_minus_q4_roots.is_regular() {
                attempt
                    .note(
                        q1_plus_q2_minus_q4_roots.outcome,
                        &path,
                        "q1 + q2 - q4",
                        1.0,
                        "",
                    );
            }
            let path = if q1_plus_q2_minus_q4_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[0, 1, 3]))
            } else {
                path
            };
            for (q1_plus_q2_minus_q4_root, &[c12m4, s12m4]) in q1_plus_q2_minus_q4_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let q1_plus_q2_minus_q4 = ::dh_robot::runtime::atan2(s12m4, c12m4);
                // Step 3: q2 from the law of cosines.
                let q2_roots = ::dh_robot::runtime::solve_sincos(
                    0.18348972303573616,
                    0.0,
                    t_4 + t_3,
                    sample.tolerance,
                );
                if !q2_roots.is_regular() {
                    attempt
                        .note_law(
                            q2_roots.outcome,
                            &path,
                            "elbow q2",
                            [-(t_4 - 0.3397962776479236), t_4 + t_3],
                            false,
                            Self::LENGTH_SCALE,
                            "m",
                        );
                }
                if path.is_chosen() {
                    attempt.see(2, &path, [0.18348972303573616, 0.0, t_4 + t_3]);
                }
                let path = if q2_roots.is_free() {
                    attempt.choose(2, &path, ::dh_robot::FreeJoints::of(&[1]))
                } else {
                    path
                };
                for (q2_root, &[c2, s2]) in q2_roots
                    .or_if_free(sample.angle(2))
                    .iter()
                    .enumerate()
                {
                    let path = path.root(2, q2_root);
                    let q2 = ::dh_robot::runtime::atan2(s2, c2);
                    let t_5 = 0.32928064842958465 + 0.27862208713272546 * c2;
                    let t_6 = 0.27862208713272546 * s2;
                    // Step 4: q1 from sine and cosine.
                    let q1_roots = ::dh_robot::runtime::solve_pair(
                        t_5,
                        -t_6,
                        t[0][3],
                        t_6,
                        t_5,
                        t[1][3],
                        sample.tolerance,
                    );
                    if !q1_roots.is_regular() {
                        attempt.note(q1_roots.outcome, &path, "q1", 1.0, "");
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
                        let q1 = ::dh_robot::runtime::atan2(s1, c1);
                        let branch = ::dh_robot::Branch::ANY
                            .with_step(0, q2_root)
                            .with_elbow(
                                if q2_root == 0 {
                                    ::dh_robot::Elbow::Up
                                } else {
                                    ::dh_robot::Elbow::Down
                                },
                            );
                        found(
                            [q1, q2, q3, -q1_plus_q2_minus_q4 + q2 + q1],
                            branch,
                            path,
                        );
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
    ) -> (::dh_robot::Solutions<f64, 4, 2>, ::dh_robot::Work) {
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
            rank_deficient: true,
            given: [::core::option::Option::None; 4],
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
    const BRANCHES: [::dh_robot::Branch; 2] = {
        let mut all = [::dh_robot::Branch::ANY; 2];
        let mut branch = 0;
        while branch < 2 {
            let q2_root = branch / 1 % 2;
            all[branch] = ::dh_robot::Branch::ANY
                .with_step(0, q2_root)
                .with_elbow(
                    if q2_root == 0 {
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
        q: &mut [[f64; 2]; 4],
        valid: &mut [f64; 2],
    ) -> bool {
        let t_2 = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
        let t_3 = t_2 - 0.3397962776479236;
        let constant_error = (0.0 - t[2][1]).abs() + (0.0 - t[0][2]).abs()
            + (0.0 - t[1][2]).abs() + (-1.0 - t[2][2]).abs();
        // Step 1: q3 from a linear equation.
        let (q3_scaled, q3_margin) = ::dh_robot::runtime::batched::linear(
            -1.0,
            -(t[2][3] - 0.39209726443769),
        );
        let q3 = q3_scaled * Self::LENGTH_SCALE;
        let q3_error = (0.39209726443769 - q3_scaled - t[2][3]).abs();
        // Step 2: q1 + q2 - q4 from sine and cosine.
        let [c12m4, s12m4] = ::dh_robot::runtime::batched::unit(t[0][0], t[0][1]);
        let q1_plus_q2_minus_q4 = ::dh_robot::runtime::batched::angle(s12m4, c12m4);
        let q1_plus_q2_minus_q4_error = (s12m4 - t[0][1]).abs()
            + (-c12m4 - t[1][1]).abs();
        // Step 3: q2 from the law of cosines.
        let ([c2_first, s2_first, c2_second, s2_second], q2_valid, q2_margin) = ::dh_robot::runtime::batched::sincos(
            0.18348972303573616,
            0.0,
            q3_scaled * (0.78419452887538 - q3_scaled) + t_3,
        );
        let all_c2 = [c2_first, c2_second];
        let all_s2 = [s2_first, s2_second];
        let all_q2 = ::dh_robot::runtime::batched::angles(
            &[s2_first, s2_second],
            &[c2_first, c2_second],
        );
        let all_q2: [f64; 2] = ::core::array::from_fn(|branch| all_q2[branch / 1 % 2]);
        let mut all_margin = [0.0; 2];
        let mut all_valid = [0.0; 2];
        let mut all_error = [0.0; 2];
        for branch in 0..2 {
            let c2 = all_c2[branch];
            let s2 = all_s2[branch];
            let t_4 = 0.32928064842958465 + 0.27862208713272546 * c2;
            let t_5 = 0.27862208713272546 * s2;
            // Step 4: q1 from sine and cosine.
            let ([c1, s1], q1_margin) = ::dh_robot::runtime::batched::pair(
                t_4,
                -t_5,
                t[0][3],
                t_5,
                t_4,
                t[1][3],
            );
            let q1 = ::dh_robot::runtime::batched::angle(s1, c1);
            let t_6 = 0.27862208713272546 * (c2 * c1 - s2 * s1)
                + 0.32928064842958465 * c1;
            let t_7 = 0.27862208713272546 * (c2 * s1 + s2 * c1)
                + 0.32928064842958465 * s1;
            let q1_error = (t_6 - t[0][3]).abs() + (t_7 - t[1][3]).abs();
            let q2 = all_q2[branch];
            // How far the branch is from the target.
            all_margin[branch] = ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(q3_margin, q2_margin),
                q1_margin,
            );
            all_valid[branch] = q2_valid;
            all_error[branch] = constant_error + q3_error + q1_plus_q2_minus_q4_error
                + q1_error;
            q[0][branch] = q1;
            q[1][branch] = q2;
            q[2][branch] = q3;
            q[3][branch] = ::dh_robot::runtime::batched::wrap(
                -q1_plus_q2_minus_q4 + q2 + q1,
            );
        }
        *valid = all_valid;
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<4> for Cobra600 {
    #[inline]
    fn forward(&self, q: &[f64; 4]) -> ::dh_robot::runtime::Pose {
        let angles = [q[0] + q[1] - q[3], q[0] + q[1], q[0]];
        let ([s12m4, s12, s1], [c12m4, c12, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        [
            [c12m4, s12m4, 0.0, 0.275 * c12 + 0.325 * c1],
            [s12m4, -c12m4, 0.0, 0.275 * s12 + 0.325 * s1],
            [0.0, 0.0, -1.0, -(q[2] - 0.387)],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (::dh_robot::runtime::Pose, [[f64; 4]; 6]) {
        let angles = [q[0] + q[1] - q[3], q[0] + q[1], q[0]];
        let ([s12m4, s12, s1], [c12m4, c12, c1]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = 0.275 * c12;
        let t_3 = 0.275 * s12;
        let t_4 = t_2 + 0.325 * c1;
        let t_5 = t_3 + 0.325 * s1;
        (
            [
                [c12m4, s12m4, 0.0, t_4],
                [s12m4, -c12m4, 0.0, t_5],
                [0.0, 0.0, -1.0, -(q[2] - 0.387)],
            ],
            [
                [-t_5, -t_3, 0.0, 0.0],
                [t_4, t_2, 0.0, 0.0],
                [0.0, 0.0, -1.0, 0.0],
                [0.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, 0.0],
                [1.0, 1.0, 0.0, -1.0],
            ],
        )
    }
    fn unit(&self) -> &'static str {
        "m"
    }
}
impl ::dh_robot::InverseKinematics<4, f64> for Cobra600 {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 4, 2>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Cobra600::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 4],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 4>, ::dh_robot::Why<f64>> {
        Cobra600::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Cobra600 {
    type Joints = ::dh_robot::runtime::Joints<4>;
}
