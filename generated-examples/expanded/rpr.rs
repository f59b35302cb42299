// What `dh_robot!` makes of src/rpr.rs. Made by `cargo regen`; do not edit.

/// Turn, slide, turn: the slide moves across the first axis and the third joint turns about the slide's direction.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in m:
///
/// | joint | alpha | a | d | theta |
/// |---|---|---|---|---|
/// | 1 | 0 | 0 | 0 | q1 |
/// | 2 | 90deg | 0 | q2 | 0 |
/// | 3 | 0 | 0 | l2 | q3 |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// ⎡ c₁c₃  −c₁s₃   s₁   s₁(l₂ + q₂) ⎤
/// ⎢ s₁c₃  −s₁s₃  −c₁  −c₁(l₂ + q₂) ⎥
/// ⎣ s₃     c₃     0    0           ⎦
///
/// where c₁ = cos q₁, s₁ = sin q₁, c₃ = cos q₃, s₃ = sin q₃
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rpr {
    /// `l2` in m, nominally 0.4.
    pub l2: f64,
}
impl ::core::default::Default for Rpr {
    fn default() -> Self {
        Rpr { l2: 0.4 }
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Rpr {
    /// Number of joints.
    pub const DOF: usize = 3;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 3] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::prismatic("q2"),
        ::dh_robot::Joint::revolute("q3"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 6 multiplications, 1 addition, 2 sine-cosine pairs. Proven equal to the product of the link transforms; equation (6) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = self.l2 + q[1];
        ::dh_robot::pose::from_entries(
            [[c3 * c1, -s3 * c1, s1], [c3 * s1, -s3 * s1, -c1], [s3, c3, 0.0]],
            [s1 * t_2, -c1 * t_2, 0.0],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 8 multiplications, 2 additions, 2 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 3],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        let angles = [q[0], q[2]];
        let ([s1, s3], [c1, c3]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = s1 * q[1];
        let t_3 = c1 * q[1];
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [t_2, -t_3, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c3, -c1 * s3, s1], [s1 * c3, -s1 * s3, -c1], [s3, c3, 0.0]],
                [t_2 + s1 * self.l2, -(t_3 + c1 * self.l2), 0.0],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (7) of the robot's notes.
    ///
    /// Cost: 2 multiplications, 1 addition, 1 sine-cosine pair.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = self.l2 + q[1];
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [c1 * t_2, s1 * t_2, 0.0, 0.0, 0.0, 1.0],
                [s1, -c1, 0.0, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, s1, -c1, 0.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 6 multiplications, 1 addition, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 3>,
    ) {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = self.l2 + q[1];
        let t_3 = s1 * t_2;
        let t_4 = c1 * t_2;
        (
            ::dh_robot::pose::from_entries(
                [[c3 * c1, -s3 * c1, s1], [c3 * s1, -s3 * s1, -c1], [s3, c3, 0.0]],
                [t_3, -t_4, 0.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                    [s1, -c1, 0.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, s1, -c1, 0.0],
                ]),
            ),
        )
    }
    /// [`forward`](Self::forward) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn forward_batch(
        &self,
        q: &[[f64; 3]],
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
        q: &[[f64; 3]],
        jacobians: &mut [::dh_robot::nalgebra::SMatrix<f64, 6, 3>],
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
        q: &[f64; 3],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let (pose, jacobian) = self.forward_and_jacobian(q);
        ::dh_robot::velocity::in_axes_of(&pose, &jacobian)
    }
    /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.
    #[inline]
    #[must_use]
    pub fn jacobian_dot(
        &self,
        q: &[f64; 3],
        speeds: &[f64; 3],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        ::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)
    }
    /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn manipulability(&self, q: &[f64; 3]) -> f64 {
        ::dh_robot::velocity::manipulability(&self.jacobian(q))
    }
    /// The smallest singular value of the Jacobian, in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn smallest_singular_value(&self, q: &[f64; 3]) -> f64 {
        ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))
    }
    /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and
    /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).
    #[inline]
    #[must_use]
    pub fn solve_velocity(
        &self,
        q: &[f64; 3],
        twist: &::dh_robot::nalgebra::Vector6<f64>,
    ) -> ::dh_robot::velocity::JointSpeeds<f64, 3> {
        ::dh_robot::velocity::solve_velocity(
            &self.jacobian(q),
            twist,
            0.40452000000000005,
        )
    }
}
impl ::dh_robot::Robot<3, f64> for Rpr {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 3] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<3, f64> for Rpr {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Rpr::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 3]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        Rpr::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<3, f64> for Rpr {
    #[inline]
    fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        Rpr::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 3>,
    ) {
        Rpr::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Rpr {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 1;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CROSSING_SHEETS;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 0.40452000000000005;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q2`: a linear equation (a d + b = 0, one value).
    /// 2. `q1`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 3. `q3`: sine and cosine (two equations a cos + b sin = c, one value).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 3, 1> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 1]; 3];
        let mut valid = [0.0; 1];
        if !self.all_branches(&frame, &mut q, &mut valid) {
            return self.inverse_with_work(target).0;
        }
        if valid == [1.0; 1] {
            let at = |branch: usize| ::dh_robot::runtime::batched::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                branch,
            );
            return ::dh_robot::Solutions::full(&Self::JOINTS, [at(0)]);
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
        q: &[f64; 3],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 3>, ::dh_robot::Why<f64>> {
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 3],
        };
        let task = ::dh_robot::runtime::TaskTarget::Pose(
            ::dh_robot::runtime::in_units(&frame, Self::LENGTH_SCALE),
        );
        let mut found = [[0.0; 1]; 3];
        let mut valid = [0.0; 1];
        if self.all_branches(&frame, &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 3, 1> = ::dh_robot::runtime::batched::collect(
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
            3,
            1,
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
    ) -> ::dh_robot::Solutions<f64, 3, 1> {
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
            given: [::core::option::Option::None; 3],
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
        solutions: &mut [::dh_robot::Solutions<f64, 3, 1>],
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
        q: &[[f64; 3]],
        solutions: &mut [::core::result::Result<
            ::dh_robot::Solution<f64, 3>,
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
    ) -> (::dh_robot::Solutions<f64, 3, 1>, f64) {
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
        solution: &::dh_robot::Solution<f64, 3>,
    ) -> ::core::option::Option<[f64; 3]> {
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [
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
    fn unknowns(&self, q: &[f64; 3]) -> [f64; 8] {
        [(q[1]) / Self::LENGTH_SCALE, q[0], q[2], 0.0, 0.0, 0.0, 0.0, 0.0]
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        sample: &::dh_robot::runtime::Sample,
        found: &mut dyn FnMut([f64; 3], ::dh_robot::Branch, ::dh_robot::runtime::Path),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let path = ::dh_robot::runtime::Path::START;
        let t_2 = self.l2 * Self::PER_LENGTH;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        // Step 1: q2 from a linear equation.
        let q2_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            -1.0,
            t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
            sample.tolerance,
        );
        if !q2_roots.is_regular() {
            attempt.note(q2_roots.outcome, &path, "q2", Self::LENGTH_SCALE, "m");
        }
        let path = if q2_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[1]))
        } else {
            path
        };
        for (q2_root, &q2_scaled) in q2_roots
            .or_if_free(sample.length(0))
            .iter()
            .enumerate()
        {
            let q2 = q2_scaled * Self::LENGTH_SCALE;
            // Step 2: q1 from sine and cosine.
            let q1_roots = ::dh_robot::runtime::solve_pair(
                0.0,
                1.0,
                t[0][2],
                -1.0,
                0.0,
                t[1][2],
                sample.tolerance,
            );
            if !q1_roots.is_regular() {
                attempt.note(q1_roots.outcome, &path, "q1", 1.0, "");
            }
            let path = if q1_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[0]))
            } else {
                path
            };
            for (q1_root, &[c1, s1]) in q1_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let q1 = ::dh_robot::runtime::atan2(s1, c1);
                // Step 3: q3 from sine and cosine.
                let q3_roots = ::dh_robot::runtime::solve_pair(
                    1.0,
                    0.0,
                    t[0][0] * c1 + t[1][0] * s1,
                    0.0,
                    -1.0,
                    t[0][1] * c1 + t[1][1] * s1,
                    sample.tolerance,
                );
                if !q3_roots.is_regular() {
                    attempt.note(q3_roots.outcome, &path, "q3", 1.0, "");
                }
                let path = if q3_roots.is_free() {
                    attempt.choose(2, &path, ::dh_robot::FreeJoints::of(&[2]))
                } else {
                    path
                };
                for (q3_root, &[c3, s3]) in q3_roots
                    .or_if_free(sample.angle(2))
                    .iter()
                    .enumerate()
                {
                    let q3 = ::dh_robot::runtime::atan2(s3, c3);
                    let branch = ::dh_robot::Branch::ANY;
                    found([q1, q2, q3], branch, path);
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
    ) -> (::dh_robot::Solutions<f64, 3, 1>, ::dh_robot::Work) {
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
            given: [::core::option::Option::None; 3],
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
    const BRANCHES: [::dh_robot::Branch; 1] = {
        let mut all = [::dh_robot::Branch::ANY; 1];
        let mut branch = 0;
        while branch < 1 {
            all[branch] = ::dh_robot::Branch::ANY;
            branch += 1;
        }
        all
    };
    /// The plan for all branches at once: joint values, and which branches are real; false where the fallback path has to decide.
    #[inline]
    fn all_branches(
        &self,
        t: &::dh_robot::runtime::Pose,
        q: &mut [[f64; 1]; 3],
        valid: &mut [f64; 1],
    ) -> bool {
        let t_2 = self.l2 * Self::PER_LENGTH;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        let mut all_margin = [0.0; 1];
        let mut all_valid = [0.0; 1];
        let mut all_error = [0.0; 1];
        let constant_error = (0.0 - t[2][2]).abs() + (0.0 - t[2][3]).abs();
        // Step 1: q2 from a linear equation.
        let (q2_scaled, q2_margin) = ::dh_robot::runtime::batched::linear(
            -1.0,
            t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
        );
        let q2 = q2_scaled * Self::LENGTH_SCALE;
        let t_4 = t_2 + q2_scaled;
        // Step 2: q1 from sine and cosine.
        let [c1, s1] = ::dh_robot::runtime::batched::unit(-t[1][2], t[0][2]);
        let q1 = ::dh_robot::runtime::batched::angle(s1, c1);
        let q1_error = (s1 - t[0][2]).abs() + (-c1 - t[1][2]).abs()
            + (s1 * t_4 - t[0][3]).abs() + (-c1 * t_4 - t[1][3]).abs();
        // Step 3: q3 from sine and cosine.
        let [c3, s3] = ::dh_robot::runtime::batched::unit(
            t[0][0] * c1 + t[1][0] * s1,
            -(t[0][1] * c1 + t[1][1] * s1),
        );
        let q3 = ::dh_robot::runtime::batched::angle(s3, c3);
        let q3_error = (-c1 * s3 - t[0][1]).abs() + (-s1 * s3 - t[1][1]).abs()
            + (c3 - t[2][1]).abs();
        let branch = 0;
        // How far the branch is from the target.
        all_margin[branch] = q2_margin;
        all_valid[branch] = 1.0;
        all_error[branch] = constant_error + q1_error + q3_error;
        q[0][branch] = q1;
        q[1][branch] = q2;
        q[2][branch] = q3;
        *valid = all_valid;
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<3> for Rpr {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::runtime::Pose {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = self.l2 + q[1];
        [
            [c3 * c1, -s3 * c1, s1, s1 * t_2],
            [c3 * s1, -s3 * s1, -c1, -c1 * t_2],
            [s3, c3, 0.0, 0.0],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (::dh_robot::runtime::Pose, [[f64; 3]; 6]) {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::runtime::sincos_batch(&angles);
        let t_2 = self.l2 + q[1];
        let t_3 = s1 * t_2;
        let t_4 = c1 * t_2;
        (
            [
                [c3 * c1, -s3 * c1, s1, t_3],
                [c3 * s1, -s3 * s1, -c1, -t_4],
                [s3, c3, 0.0, 0.0],
            ],
            [
                [t_4, s1, 0.0],
                [t_3, -c1, 0.0],
                [0.0, 0.0, 0.0],
                [0.0, 0.0, s1],
                [0.0, 0.0, -c1],
                [1.0, 0.0, 0.0],
            ],
        )
    }
    fn unit(&self) -> &'static str {
        "m"
    }
}
impl ::dh_robot::InverseKinematics<3, f64> for Rpr {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 3, 1>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Rpr::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 3],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 3>, ::dh_robot::Why<f64>> {
        Rpr::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Rpr {
    type Joints = ::dh_robot::runtime::Joints<3>;
}
