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
            0.30000000000000004,
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
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        GantryWrist::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl GantryWrist {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 2;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 0.30000000000000004;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
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
        let frame = match ::dh_robot::runtime::frame_of(target, Self::LENGTH_SCALE) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 2]; 6];
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
        let mut found = [[0.0; 2]; 6];
        let mut valid = [0.0; 2];
        if self.all_branches(&frame, &mut found, &mut valid) {
            let list: ::dh_robot::Solutions<_, 6, 2> = ::dh_robot::runtime::batched::collect(
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
    ) -> ::dh_robot::Solutions<f64, 6, 2> {
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
        solutions: &mut [::dh_robot::Solutions<f64, 6, 2>],
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
    ) -> (::dh_robot::Solutions<f64, 6, 2>, f64) {
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
        [
            (q[0]) / Self::LENGTH_SCALE,
            (q[1]) / Self::LENGTH_SCALE,
            (q[2]) / Self::LENGTH_SCALE,
            q[5],
            q[3],
            q[4],
            0.0,
            0.0,
        ]
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
        let t_2 = t[0][0] * 0.8660254037844386 - t[0][1] * 0.5;
        let t_3 = t[2][0] * 0.8660254037844386 - t[2][1] * 0.5;
        let t_4 = t[0][0] * 0.5 + t[0][1] * 0.8660254037844386;
        let t_5 = t[2][0] * 0.5 + t[2][1] * 0.8660254037844386;
        let t_6 = t[1][3] - t[1][2] * 0.6666666666666666 - 0.3333333333333333;
        // Step 1: q1 from a linear equation.
        let q1_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            1.0,
            -(t[2][3] - t[2][2] * 0.6666666666666666),
            sample.tolerance,
        );
        if !q1_roots.is_regular() {
            attempt.note(q1_roots.outcome, &path, "q1", Self::LENGTH_SCALE, "m");
        }
        let path = if q1_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[0]))
        } else {
            path
        };
        for (q1_root, &q1_scaled) in q1_roots
            .or_if_free(sample.length(0))
            .iter()
            .enumerate()
        {
            let q1 = q1_scaled * Self::LENGTH_SCALE;
            // Step 2: q2 from a linear equation.
            let q2_roots = ::dh_robot::runtime::solve_quadratic(
                0.0,
                -1.0,
                t[0][3] - t[0][2] * 0.6666666666666666,
                sample.tolerance,
            );
            if !q2_roots.is_regular() {
                attempt.note(q2_roots.outcome, &path, "q2", Self::LENGTH_SCALE, "m");
            }
            let path = if q2_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[1]))
            } else {
                path
            };
            for (q2_root, &q2_scaled) in q2_roots
                .or_if_free(sample.length(1))
                .iter()
                .enumerate()
            {
                let q2 = q2_scaled * Self::LENGTH_SCALE;
                // Step 3: q3 from a linear equation.
                let q3_roots = ::dh_robot::runtime::solve_quadratic(
                    0.0,
                    -1.0,
                    t_6,
                    sample.tolerance,
                );
                if !q3_roots.is_regular() {
                    attempt.note(q3_roots.outcome, &path, "q3", Self::LENGTH_SCALE, "m");
                }
                let path = if q3_roots.is_free() {
                    attempt.choose(2, &path, ::dh_robot::FreeJoints::of(&[2]))
                } else {
                    path
                };
                for (q3_root, &q3_scaled) in q3_roots
                    .or_if_free(sample.length(2))
                    .iter()
                    .enumerate()
                {
                    let q3 = q3_scaled * Self::LENGTH_SCALE;
                    // Step 4: q6 from a ratio of sine and cosine.
                    let q6_roots = ::dh_robot::runtime::solve_sincos(
                        -(t[1][0] * 0.5 + t[1][1] * 0.8660254037844386),
                        -(t[1][0] * 0.8660254037844386 - t[1][1] * 0.5),
                        0.0,
                        sample.tolerance,
                    );
                    if !q6_roots.is_regular() {
                        attempt.note(q6_roots.outcome, &path, "wrist q6", 1.0, "");
                    }
                    if path.is_chosen() {
                        attempt
                            .see(
                                3,
                                &path,
                                [
                                    -(t[1][0] * 0.5 + t[1][1] * 0.8660254037844386),
                                    -(t[1][0] * 0.8660254037844386 - t[1][1] * 0.5),
                                    0.0,
                                ],
                            );
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
                        let path = path.root(3, q6_root);
                        let q6 = ::dh_robot::runtime::atan2(s6, c6);
                        // Step 5: q4 from sine and cosine.
                        let q4_roots = ::dh_robot::runtime::solve_pair(
                            0.0,
                            1.0,
                            -(t_3 * s6 + t_5 * c6),
                            -1.0,
                            0.0,
                            -(t_2 * s6 + t_4 * c6),
                            sample.tolerance,
                        );
                        if !q4_roots.is_regular() {
                            attempt.note(q4_roots.outcome, &path, "q4", 1.0, "");
                        }
                        let path = if q4_roots.is_free() {
                            attempt.choose(4, &path, ::dh_robot::FreeJoints::of(&[3]))
                        } else {
                            path
                        };
                        for (q4_root, &[c4, s4]) in q4_roots
                            .or_if_free(sample.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q4 = ::dh_robot::runtime::atan2(s4, c4);
                            // Step 6: q5 from sine and cosine.
                            let q5_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                c6 * (t_3 * c4 + t_2 * s4) - s6 * (t_5 * c4 + t_4 * s4),
                                0.0,
                                -1.0,
                                t[2][2] * c4 + t[0][2] * s4,
                                sample.tolerance,
                            );
                            if !q5_roots.is_regular() {
                                attempt.note(q5_roots.outcome, &path, "q5", 1.0, "");
                            }
                            let path = if q5_roots.is_free() {
                                attempt.choose(5, &path, ::dh_robot::FreeJoints::of(&[4]))
                            } else {
                                path
                            };
                            for (q5_root, &[c5, s5]) in q5_roots
                                .or_if_free(sample.angle(5))
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
                                found([q1, q2, q3, q4, q5, q6], branch, path);
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
    ) -> (::dh_robot::Solutions<f64, 6, 2>, ::dh_robot::Work) {
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
    const BRANCHES: [::dh_robot::Branch; 2] = {
        let mut all = [::dh_robot::Branch::ANY; 2];
        let mut branch = 0;
        while branch < 2 {
            let q6_root = branch / 1 % 2;
            all[branch] = ::dh_robot::Branch::ANY
                .with_step(0, q6_root)
                .with_wrist(
                    if q6_root == 0 {
                        ::dh_robot::Wrist::NoFlip
                    } else {
                        ::dh_robot::Wrist::Flip
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
        q: &mut [[f64; 2]; 6],
        valid: &mut [f64; 2],
    ) -> bool {
        let t_2 = t[0][0] * 0.8660254037844386 - t[0][1] * 0.5;
        let t_3 = t[2][0] * 0.8660254037844386 - t[2][1] * 0.5;
        let t_4 = t[0][0] * 0.5 + t[0][1] * 0.8660254037844386;
        let t_5 = t[2][0] * 0.5 + t[2][1] * 0.8660254037844386;
        let t_6 = t[1][3] - t[1][2] * 0.6666666666666666 - 0.3333333333333333;
        let mut all_margin = [0.0; 1];
        let mut all_valid = [0.0; 1];
        let mut all_error = [0.0; 1];
        // Step 1: q1 from a linear equation.
        let (q1_scaled, q1_margin) = ::dh_robot::runtime::batched::linear(
            1.0,
            -(t[2][3] - t[2][2] * 0.6666666666666666),
        );
        let q1 = q1_scaled * Self::LENGTH_SCALE;
        // Step 2: q2 from a linear equation.
        let (q2_scaled, q2_margin) = ::dh_robot::runtime::batched::linear(
            -1.0,
            t[0][3] - t[0][2] * 0.6666666666666666,
        );
        let q2 = q2_scaled * Self::LENGTH_SCALE;
        // Step 3: q3 from a linear equation.
        let (q3_scaled, q3_margin) = ::dh_robot::runtime::batched::linear(-1.0, t_6);
        let q3 = q3_scaled * Self::LENGTH_SCALE;
        let t_7 = 0.3333333333333333 + q3_scaled;
        // Step 4: q6 from a ratio of sine and cosine.
        let ([c6, s6], q6_margin) = ::dh_robot::runtime::batched::half_turn([
            [
                -(t[1][0] * 0.5 + t[1][1] * 0.8660254037844386),
                -(t[1][0] * 0.8660254037844386 - t[1][1] * 0.5),
            ],
        ]);
        let q6 = ::dh_robot::runtime::batched::angle(s6, c6);
        let t_8 = 0.8660254037844386 * c6 - 0.5 * s6;
        let t_9 = 0.5 * c6 + 0.8660254037844386 * s6;
        // Step 5: q4 from sine and cosine.
        let [c4, s4] = ::dh_robot::runtime::batched::unit(
            t_2 * s6 + t_4 * c6,
            -(t_3 * s6 + t_5 * c6),
        );
        let q4 = ::dh_robot::runtime::batched::angle(s4, c4);
        let t_10 = s4 * t_8;
        let t_11 = c4 * t_8;
        // Step 6: q5 from sine and cosine.
        let [c5, s5] = ::dh_robot::runtime::batched::unit(
            c6 * (t_3 * c4 + t_2 * s4) - s6 * (t_5 * c4 + t_4 * s4),
            -(t[2][2] * c4 + t[0][2] * s4),
        );
        let q5 = ::dh_robot::runtime::batched::angle(s5, c5);
        let t_12 = t_9 * c5;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let q5_error = (-(s4 * t_12 - t_11) - t[0][1]).abs()
            + (-t_9 * s5 - t[1][1]).abs() + (-(c4 * t_12 + t_10) - t[2][1]).abs()
            + (-s4s5 - t[0][2]).abs() + (c5 - t[1][2]).abs() + (-c4s5 - t[2][2]).abs()
            + (q2_scaled - 0.6666666666666666 * s4s5 - t[0][3]).abs()
            + (t_7 + 0.6666666666666666 * c5 - t[1][3]).abs()
            + (q1_scaled - 0.6666666666666666 * c4s5 - t[2][3]).abs();
        let branch = 0;
        // How far the branch is from the target.
        all_margin[branch] = ::dh_robot::runtime::batched::lesser(
            ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(q1_margin, q2_margin),
                q3_margin,
            ),
            q6_margin,
        );
        all_valid[branch] = 1.0;
        all_error[branch] = q5_error;
        // The mirrored half differs by signs.
        let q6_second = ::dh_robot::runtime::batched::opposite(q6);
        let q4_second = ::dh_robot::runtime::batched::opposite(q4);
        let q5_second = ::dh_robot::runtime::batched::negative(q5);
        q[0][branch] = q1;
        q[1][branch] = q2;
        q[2][branch] = q3;
        q[3][branch] = q4;
        q[4][branch] = q5;
        q[5][branch] = q6;
        q[0][branch + 1] = q1;
        q[1][branch + 1] = q2;
        q[2][branch + 1] = q3;
        q[3][branch + 1] = q4_second;
        q[4][branch + 1] = q5_second;
        q[5][branch + 1] = q6_second;
        *valid = ::core::array::from_fn(|branch| all_valid[branch % 1]);
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
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
impl ::dh_robot::InverseKinematics<6, f64> for GantryWrist {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 6, 2>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        GantryWrist::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        GantryWrist::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for GantryWrist {
    type Joints = ::dh_robot::runtime::Joints<6>;
}
