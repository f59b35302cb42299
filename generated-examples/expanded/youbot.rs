// What `dh_robot!` makes of src/youbot.rs. Made by `cargo regen`; do not edit.

/// KUKA youBot arm: five joints, so the task is a point and a direction.
///
/// Denavit-Hartenberg table, standard convention (theta, d, a and alpha of one link); bare lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | 1 | q1 | 147mm | 33mm | 90deg | -169deg..=169deg |
/// | 2 | q2 + 90deg | 0 | 155mm | 0 | -65deg..=90deg |
/// | 3 | q3 | 0 | 135mm | 0 | -151deg..=146deg |
/// | 4 | q4 - 90deg | 0 | 0 | -90deg | -102deg..=102deg |
/// | 5 | q5 | 217.5mm | 0 | 0 | -167deg..=167deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// ⎡ c₁c₂₃₄c₅ − s₁s₅  −c₁c₂₃₄s₅ − s₁c₅  −c₁s₂₃₄  c₁(a₁ − a₂s₂ − a₃s₂₃ − d₅s₂₃₄) ⎤
/// ⎢ s₁c₂₃₄c₅ + c₁s₅   c₁c₅ − s₁c₂₃₄s₅  −s₁s₂₃₄  s₁(a₁ − a₂s₂ − a₃s₂₃ − d₅s₂₃₄) ⎥
/// ⎣ s₂₃₄c₅           −s₂₃₄s₅            c₂₃₄    d₁ + a₂c₂ + a₃c₂₃ + d₅c₂₃₄     ⎦
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 5; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      c₂₃₄ = cos(q₂ + q₃ + q₄), s₂₃₄ = sin(q₂ + q₃ + q₄), a₁ = 0.033, d₁ = 0.147, a₂ = 0.155,
///      a₃ = 0.135, d₅ = 0.2175
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Youbot;
impl ::core::default::Default for Youbot {
    fn default() -> Self {
        Youbot
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Youbot {
    /// Number of joints.
    pub const DOF: usize = 5;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 5] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.949606435870417, 2.949606435870417),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-1.1344640137963142, 1.5707963267948966),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-2.6354471705114375, 2.548180707911721),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-1.7802358370342162, 1.7802358370342162),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-2.9146998508305306, 2.9146998508305306),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 22 multiplications, 12 additions, 5 sine-cosine pairs. Proven equal to the product of the link transforms; equation (10) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        let t_2 = s234 * 0.2175 + 0.135 * s23 + 0.155 * s2 - 0.033;
        ::dh_robot::pose::from_entries(
            [
                [c5c234 * c1 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234 * c1],
                [c5c234 * s1 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234 * s1],
                [c5 * s234, -s5 * s234, c234],
            ],
            [-c1 * t_2, -s1 * t_2, c234 * 0.2175 + 0.135 * c23 + 0.155 * c2 + 0.147],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 35 multiplications, 15 additions, 5 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 5],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 5] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4]];
        let ([s1, s2, s23, s234, s5], [c1, c2, c23, c234, c5]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c1 * 0.033;
        let t_3 = s1 * 0.033;
        let t_4 = 0.155 * s2;
        let t_5 = t_2 - c1 * t_4;
        let t_6 = t_3 - s1 * t_4;
        let t_7 = 0.147 + 0.155 * c2;
        let t_8 = 0.135 * s23;
        let t_9 = t_5 - c1 * t_8;
        let t_10 = t_6 - s1 * t_8;
        let t_11 = t_7 + 0.135 * c23;
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [t_2, t_3, 0.147],
            ),
            ::dh_robot::pose::from_entries(
                [[-c1 * s2, -c1 * c2, s1], [-s1 * s2, -s1 * c2, -c1], [c2, -s2, 0.0]],
                [t_5, t_6, t_7],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [-c1 * s23, -c1 * c23, s1],
                    [-s1 * s23, -s1 * c23, -c1],
                    [c23, -s23, 0.0],
                ],
                [t_9, t_10, t_11],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c234, -s1, -c1s234], [s1c234, c1, -s1s234], [s234, 0.0, c234]],
                [t_9, t_10, t_11],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [c1c234 * c5 - s1 * s5, -(s1 * c5 + c1c234 * s5), -c1s234],
                    [s1c234 * c5 + c1 * s5, c1 * c5 - s1c234 * s5, -s1s234],
                    [s234 * c5, -s234 * s5, c234],
                ],
                [t_9 - c1s234 * 0.2175, t_10 - s1s234 * 0.2175, t_11 + c234 * 0.2175],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (11) of the robot's notes.
    ///
    /// Cost: 16 multiplications, 7 additions, 4 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 5> {
        let angles = [q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s234, s1, s23, s2], [c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = s234 * 0.2175;
        let t_3 = c234 * 0.2175;
        let t_4 = t_2 + 0.135 * s23;
        let t_5 = t_3 + 0.135 * c23;
        let t_6 = t_4 + 0.155 * s2;
        let t_7 = t_5 + 0.155 * c2;
        let t_8 = t_6 - 0.033;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_8, -c1 * t_8, 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_7, -s1 * t_7, -t_6, s1, -c1, 0.0],
                [-c1 * t_5, -s1 * t_5, -t_4, s1, -c1, 0.0],
                [-c1 * t_3, -s1 * t_3, -t_2, s1, -c1, 0.0],
                [0.0, 0.0, 0.0, -s234 * c1, -s234 * s1, c234],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 28 multiplications, 12 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 5],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 5>,
    ) {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        let s234c1 = s234 * c1;
        let s234s1 = s234 * s1;
        let t_2 = s234 * 0.2175;
        let t_3 = c234 * 0.2175;
        let t_4 = t_2 + 0.135 * s23;
        let t_5 = t_3 + 0.135 * c23;
        let t_6 = t_4 + 0.155 * s2;
        let t_7 = t_5 + 0.155 * c2;
        let t_8 = t_6 - 0.033;
        let t_9 = c1 * t_8;
        let t_10 = s1 * t_8;
        (
            ::dh_robot::pose::from_entries(
                [
                    [c5c234 * c1 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234c1],
                    [c5c234 * s1 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234s1],
                    [c5 * s234, -s5 * s234, c234],
                ],
                [-t_9, -t_10, t_7 + 0.147],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_10, -t_9, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_7, -s1 * t_7, -t_6, s1, -c1, 0.0],
                    [-c1 * t_5, -s1 * t_5, -t_4, s1, -c1, 0.0],
                    [-c1 * t_3, -s1 * t_3, -t_2, s1, -c1, 0.0],
                    [0.0, 0.0, 0.0, -s234c1, -s234s1, c234],
                ]),
            ),
        )
    }
    /// [`forward`](Self::forward) of every joint vector: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn forward_batch(
        &self,
        q: &[[f64; 5]],
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
        q: &[[f64; 5]],
        jacobians: &mut [::dh_robot::nalgebra::SMatrix<f64, 6, 5>],
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
        q: &[f64; 5],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 5> {
        let (pose, jacobian) = self.forward_and_jacobian(q);
        ::dh_robot::velocity::in_axes_of(&pose, &jacobian)
    }
    /// The time derivative of [`jacobian`](Self::jacobian) (base axes) while the joints move with `speeds`, exact.
    #[inline]
    #[must_use]
    pub fn jacobian_dot(
        &self,
        q: &[f64; 5],
        speeds: &[f64; 5],
    ) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 5> {
        ::dh_robot::velocity::jacobian_dot(&self.jacobian(q), speeds)
    }
    /// Product of the Jacobian's singular values (Yoshikawa 1985), in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn manipulability(&self, q: &[f64; 5]) -> f64 {
        ::dh_robot::velocity::manipulability(&self.jacobian(q))
    }
    /// The smallest singular value of the Jacobian, in its units; zero at singular poses.
    #[inline]
    #[must_use]
    pub fn smallest_singular_value(&self, q: &[f64; 5]) -> f64 {
        ::dh_robot::velocity::smallest_singular_value(&self.jacobian(q))
    }
    /// Joint speeds for a velocity of the last frame (or tool): linear, then angular, in base axes. Damped near singular poses, and
    /// the result says so; see [`solve_velocity`](::dh_robot::velocity::solve_velocity).
    #[inline]
    #[must_use]
    pub fn solve_velocity(
        &self,
        q: &[f64; 5],
        twist: &::dh_robot::nalgebra::Vector6<f64>,
    ) -> ::dh_robot::velocity::JointSpeeds<f64, 5> {
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 0.6875)
    }
}
impl ::dh_robot::Robot<5, f64> for Youbot {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 5] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<5, f64> for Youbot {
    #[inline]
    fn forward(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Youbot::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 5]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 5] {
        Youbot::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<5, f64> for Youbot {
    #[inline]
    fn jacobian(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 5> {
        Youbot::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 5],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 5>,
    ) {
        Youbot::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Youbot {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 4;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 0.6875;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// Plan:
    /// 1. `q1`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 2. `q2 + q3 + q4`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 3. `q3`: the law of cosines (a cos + b sin = c, two values).
    /// 4. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 5. `q5`: a free choice (free at every pose: 0 is taken).
    #[must_use]
    pub fn inverse(
        &self,
        target: (
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        ),
    ) -> ::dh_robot::Solutions<f64, 5, 4> {
        let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];
        if !p.iter().all(|x: &f64| x.is_finite()) {
            return ::dh_robot::Solutions::none(
                &Self::JOINTS,
                ::dh_robot::Why::NotFinite,
            );
        }
        let z = match ::dh_robot::runtime::direction([
            target.1.x.into(),
            target.1.y.into(),
            target.1.z.into(),
        ]) {
            ::core::result::Result::Ok(z) => z,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let frame = ::dh_robot::runtime::frame_of_axis(
            p.map(|x| x / Self::LENGTH_SCALE),
            z,
        );
        let mut q = [[0.0; 4]; 5];
        let mut valid = [0.0; 4];
        if !self.all_branches(&frame, &mut q, &mut valid) {
            return self.inverse_with_work(target).0;
        }
        let list = ::dh_robot::runtime::batched::collect_free(
            &Self::JOINTS,
            &valid,
            &q,
            &Self::BRANCHES,
            ::dh_robot::FreeJoints::of(&[4]),
        );
        if !::dh_robot::runtime::batched::free_in_range(&list) {
            return self.inverse_with_work(target).0;
        }
        list
    }
    /// The solution that continues from the joint values `q`: the one of least travel, and on a self-motion (at a singular pose) the
    /// point of it nearest to `q`. Angles are shifted by whole turns towards `q`, within the ranges where that is possible; a solution out
    /// of range is given only if none is in range, or if it continues from `q` within 0.2 rad.
    ///
    /// # Errors
    /// The reason why no joint values reach the target.
    pub fn inverse_near(
        &self,
        target: (
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        ),
        q: &[f64; 5],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 5>, ::dh_robot::Why<f64>> {
        let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];
        if !p.iter().all(|x: &f64| x.is_finite()) {
            return ::core::result::Result::Err(::dh_robot::Why::NotFinite);
        }
        let z = match ::dh_robot::runtime::direction([
            target.1.x.into(),
            target.1.y.into(),
            target.1.z.into(),
        ]) {
            ::core::result::Result::Ok(z) => z,
            ::core::result::Result::Err(why) => return ::core::result::Result::Err(why),
        };
        let frame = ::dh_robot::runtime::frame_of_axis(
            p.map(|x| x / Self::LENGTH_SCALE),
            z,
        );
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 5],
        };
        let task = ::dh_robot::runtime::TaskTarget::Axis(p, z);
        let unknowns = self.unknowns(&q.map(f64::from));
        ::dh_robot::runtime::solve_near::<
            _,
            5,
            4,
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
        target: (
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        ),
    ) -> ::dh_robot::Solutions<f64, 5, 4> {
        let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];
        if !p.iter().all(|x: &f64| x.is_finite()) {
            return ::dh_robot::Solutions::none(
                &Self::JOINTS,
                ::dh_robot::Why::NotFinite,
            );
        }
        let z = match ::dh_robot::runtime::direction([
            target.1.x.into(),
            target.1.y.into(),
            target.1.z.into(),
        ]) {
            ::core::result::Result::Ok(z) => z,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let frame = ::dh_robot::runtime::frame_of_axis(
            p.map(|x| x / Self::LENGTH_SCALE),
            z,
        );
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 5],
        };
        let task = ::dh_robot::runtime::TaskTarget::Axis(p, z);
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
        targets: &[(
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        )],
        solutions: &mut [::dh_robot::Solutions<f64, 5, 4>],
    ) {
        for (target, to) in targets.iter().zip(solutions) {
            *to = self.inverse(*target);
        }
    }
    /// [`inverse_near`](Self::inverse_near) of every target, from the joint values `q` of the same place: as many as the shorter slice holds; what lies beyond stays as it is. Each stands for itself: one that is not finite spoils its own
    /// result only.
    #[inline]
    pub fn inverse_near_batch(
        &self,
        targets: &[(
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        )],
        q: &[[f64; 5]],
        solutions: &mut [::core::result::Result<
            ::dh_robot::Solution<f64, 5>,
            ::dh_robot::Why<f64>,
        >],
    ) {
        for ((target, q), to) in targets.iter().zip(q).zip(solutions) {
            *to = self.inverse_near(*target, q);
        }
    }
    /// The direction in which the arm can move at a solution with free joints while its target stays reached: joint speeds, the largest of
    /// them 1 (or the arm's size, for a length). `None` at an isolated solution.
    #[must_use]
    pub fn self_motion(
        &self,
        solution: &::dh_robot::Solution<f64, 5>,
    ) -> ::core::option::Option<[f64; 5]> {
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [
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
            |t| ::dh_robot::runtime::TaskTarget::Axis(
                [t[0][3], t[1][3], t[2][3]],
                [t[0][2], t[1][2], t[2][2]],
            ),
            solution,
        )
    }
    /// The plan's unknowns at joint values.
    fn unknowns(&self, q: &[f64; 5]) -> [f64; 8] {
        [q[0], q[1] + q[2] + q[3], q[2], q[1], q[4], 0.0, 0.0, 0.0]
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        sample: &::dh_robot::runtime::Sample,
        found: &mut dyn FnMut([f64; 5], ::dh_robot::Branch, ::dh_robot::runtime::Path),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let path = ::dh_robot::runtime::Path::START;
        let t_2 = t[2][3] - 0.21381818181818182;
        let t_3 = t_2 * t_2;
        let t_4 = t_2 * t[2][2] * 2.0;
        // Step 1: q1 from a ratio of sine and cosine.
        let q1_roots = ::dh_robot::runtime::solve_half_turn(
            [-t[1][2], t[0][2]],
            [-t[1][3], t[0][3]],
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
            let t_5 = t[0][3] * c1 + t[1][3] * s1;
            let t_6 = t[0][3] * s1 - t[1][3] * c1;
            let t_7 = t[0][2] * c1 + t[1][2] * s1;
            let t_8 = t_5 * 2.0;
            let t_9 = 0.31636363636363635 - t_6 * (t[0][2] * s1 - t[1][2] * c1) * 2.0;
            let t_10 = 0.048 * (t_8 - 0.048)
                - (t_5 * t_5 + t_6 * t_6 + t_3 - 0.08938842975206612);
            let t_11 = 0.31636363636363635 * (t_7 * (0.096 - t_8) + t_9 - t_4) - t_10;
            let t_12 = t_5 - 0.048;
            // Step 2: q2 + q3 + q4 from sine and cosine.
            let q2_plus_q3_plus_q4_roots = ::dh_robot::runtime::solve_pair(
                0.0,
                -1.0,
                t_7,
                1.0,
                0.0,
                t[2][2],
                sample.tolerance,
            );
            if !q2_plus_q3_plus_q4_roots.is_regular() {
                attempt
                    .note(
                        q2_plus_q3_plus_q4_roots.outcome,
                        &path,
                        "q2 + q3 + q4",
                        1.0,
                        "",
                    );
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
                let q2_plus_q3_plus_q4 = ::dh_robot::runtime::atan2(s234, c234);
                let t_13 = t_2 - 0.31636363636363635 * c234;
                // Step 3: q3 from the law of cosines.
                let q3_roots = ::dh_robot::runtime::solve_sincos(
                    0.08854214876033059,
                    0.0,
                    t_11,
                    sample.tolerance,
                );
                if !q3_roots.is_regular() {
                    attempt
                        .note_law(
                            q3_roots.outcome,
                            &path,
                            "elbow q3",
                            [0.08938842975206612, t_11],
                            false,
                            Self::LENGTH_SCALE,
                            "m",
                        );
                }
                if path.is_chosen() {
                    attempt.see(2, &path, [0.08854214876033059, 0.0, t_11]);
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
                    let path = path.root(2, q3_root);
                    let q3 = ::dh_robot::runtime::atan2(s3, c3);
                    let t_14 = 0.19636363636363638 * s3;
                    let t_15 = 0.22545454545454546 + 0.19636363636363638 * c3;
                    // Step 4: q2 from sine and cosine.
                    let q2_roots = ::dh_robot::runtime::solve_many(
                        &[
                            [-t_14, -t_15, t_12 + 0.31636363636363635 * s234],
                            [t_15, -t_14, t_13],
                            [t_15, -t_14, t_13],
                        ],
                        sample.tolerance,
                    );
                    if !q2_roots.is_regular() {
                        attempt.note(q2_roots.outcome, &path, "q2", 1.0, "");
                    }
                    let path = if q2_roots.is_free() {
                        attempt.choose(3, &path, ::dh_robot::FreeJoints::of(&[1]))
                    } else {
                        path
                    };
                    for (q2_root, &[c2, s2]) in q2_roots
                        .or_if_free(sample.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let q2 = ::dh_robot::runtime::atan2(s2, c2);
                        // Step 5: q5 from a free choice.
                        let q5_roots = ::dh_robot::runtime::solve_sincos(
                            0.0,
                            0.0,
                            0.0,
                            sample.tolerance,
                        );
                        if !q5_roots.is_regular() {
                            attempt.note(q5_roots.outcome, &path, "q5", 1.0, "");
                        }
                        let path = if q5_roots.is_free() {
                            attempt.choose(4, &path, ::dh_robot::FreeJoints::of(&[4]))
                        } else {
                            path
                        };
                        for (q5_root, &[c5, s5]) in q5_roots
                            .or_if_free(sample.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let q5 = ::dh_robot::runtime::atan2(s5, c5);
                            let branch = ::dh_robot::Branch::ANY
                                .with_step(0, q1_root)
                                .with_shoulder(
                                    if q1_root == 0 {
                                        ::dh_robot::Shoulder::Left
                                    } else {
                                        ::dh_robot::Shoulder::Right
                                    },
                                )
                                .with_step(1, q3_root)
                                .with_elbow(
                                    if q3_root == 0 {
                                        ::dh_robot::Elbow::Up
                                    } else {
                                        ::dh_robot::Elbow::Down
                                    },
                                );
                            found(
                                [q1, q2, q3, q2_plus_q3_plus_q4 - q3 - q2, q5],
                                branch,
                                path,
                            );
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
        target: (
            ::dh_robot::nalgebra::Point3<f64>,
            ::dh_robot::nalgebra::UnitVector3<f64>,
        ),
    ) -> (::dh_robot::Solutions<f64, 5, 4>, ::dh_robot::Work) {
        let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];
        if !p.iter().all(|x: &f64| x.is_finite()) {
            return (
                ::dh_robot::Solutions::none(&Self::JOINTS, ::dh_robot::Why::NotFinite),
                ::dh_robot::Work::NONE,
            );
        }
        let z = match ::dh_robot::runtime::direction([
            target.1.x.into(),
            target.1.y.into(),
            target.1.z.into(),
        ]) {
            ::core::result::Result::Ok(z) => z,
            ::core::result::Result::Err(why) => {
                return (
                    ::dh_robot::Solutions::none(&Self::JOINTS, why),
                    ::dh_robot::Work::NONE,
                );
            }
        };
        let frame = ::dh_robot::runtime::frame_of_axis(
            p.map(|x| x / Self::LENGTH_SCALE),
            z,
        );
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            length_scale: Self::LENGTH_SCALE,
            rank_deficient: true,
            given: [::core::option::Option::None; 5],
        };
        let task = ::dh_robot::runtime::TaskTarget::Axis(p, z);
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
    const BRANCHES: [::dh_robot::Branch; 4] = {
        let mut all = [::dh_robot::Branch::ANY; 4];
        let mut branch = 0;
        while branch < 4 {
            let q1_root = branch / 1 % 2;
            let q3_root = branch / 2 % 2;
            all[branch] = ::dh_robot::Branch::ANY
                .with_step(0, q1_root)
                .with_shoulder(
                    if q1_root == 0 {
                        ::dh_robot::Shoulder::Left
                    } else {
                        ::dh_robot::Shoulder::Right
                    },
                )
                .with_step(1, q3_root)
                .with_elbow(
                    if q3_root == 0 {
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
        q: &mut [[f64; 4]; 5],
        valid: &mut [f64; 4],
    ) -> bool {
        let t_2 = t[2][3] - 0.21381818181818182;
        let t_3 = t_2 * t_2;
        let t_4 = t_2 * t[2][2] * 2.0;
        // Step 1: q1 from a ratio of sine and cosine.
        let ([c1_first, s1_first], q1_margin) = ::dh_robot::runtime::batched::half_turn([
            [-t[1][2], t[0][2]],
            [-t[1][3], t[0][3]],
        ]);
        let all_c1 = [c1_first, -c1_first];
        let all_s1 = [s1_first, -s1_first];
        let all_q1 = ::dh_robot::runtime::batched::angles(
            &[s1_first, -s1_first],
            &[c1_first, -c1_first],
        );
        let mut all_q2_plus_q3_plus_q4 = [0.0; 2];
        let mut all_t_13 = [0.0; 2];
        let mut all_t_16 = [0.0; 2];
        let mut all_t_14 = [0.0; 2];
        let mut all_t_15 = [0.0; 2];
        let mut q3_pairs = [[0.0; 4]; 2];
        let mut all_margin_1 = [0.0; 2];
        let mut all_valid_1 = [0.0; 2];
        let mut all_error_1 = [0.0; 2];
        for branch in 0..2 {
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let t_5 = t[0][3] * c1 + t[1][3] * s1;
            let t_6 = t[0][3] * s1 - t[1][3] * c1;
            let t_7 = t[0][2] * c1 + t[1][2] * s1;
            let t_8 = t_5 * 2.0;
            let t_9 = 0.31636363636363635 - t_6 * (t[0][2] * s1 - t[1][2] * c1) * 2.0;
            let t_10 = 0.048 * (t_8 - 0.048)
                - (t_5 * t_5 + t_6 * t_6 + t_3 - 0.08938842975206612);
            let t_11 = 0.31636363636363635 * (t_7 * (0.096 - t_8) + t_9 - t_4) - t_10;
            let t_12 = t_5 - 0.048;
            // Step 2: q2 + q3 + q4 from sine and cosine.
            let [c234, s234] = ::dh_robot::runtime::batched::unit(t[2][2], -t_7);
            let q2_plus_q3_plus_q4 = ::dh_robot::runtime::batched::angle(s234, c234);
            all_q2_plus_q3_plus_q4[branch] = q2_plus_q3_plus_q4;
            let t_13 = 0.31636363636363635 * s234;
            let t_14 = 0.31636363636363635 * c234;
            let t_15 = t_2 - t_14;
            all_t_13[branch] = t_13;
            let t_16 = t_12 + t_13;
            all_t_16[branch] = t_16;
            all_t_14[branch] = t_14;
            all_t_15[branch] = t_15;
            let q2_plus_q3_plus_q4_error = (-c1 * s234 - t[0][2]).abs()
                + (-s1 * s234 - t[1][2]).abs() + (c234 - t[2][2]).abs();
            // Step 3: q3 from the law of cosines.
            let ([c3_first, s3_first, c3_second, s3_second], q3_valid, q3_margin) = ::dh_robot::runtime::batched::sincos(
                0.08854214876033059,
                0.0,
                t_11,
            );
            q3_pairs[0][branch] = c3_first;
            q3_pairs[1][branch] = s3_first;
            q3_pairs[0][branch + 2] = c3_second;
            q3_pairs[1][branch + 2] = s3_second;
            all_margin_1[branch] = q3_margin;
            all_valid_1[branch] = q3_valid;
            all_error_1[branch] = q2_plus_q3_plus_q4_error;
        }
        let all_q3 = ::dh_robot::runtime::batched::angles(&q3_pairs[1], &q3_pairs[0]);
        q[2] = ::core::array::from_fn(|branch| all_q3[branch / 2 % 2 * 2 + branch % 2]);
        let all_c3 = q3_pairs[0];
        let all_s3 = q3_pairs[1];
        let all_t_16: [f64; 4] = ::core::array::from_fn(|branch| all_t_16[branch % 2]);
        let all_t_15: [f64; 4] = ::core::array::from_fn(|branch| all_t_15[branch % 2]);
        let mut all_q2 = [0.0; 4];
        let all_c1: [f64; 4] = ::core::array::from_fn(|branch| all_c1[branch % 2]);
        let all_s1: [f64; 4] = ::core::array::from_fn(|branch| all_s1[branch % 2]);
        let all_t_13: [f64; 4] = ::core::array::from_fn(|branch| all_t_13[branch % 2]);
        let all_t_14: [f64; 4] = ::core::array::from_fn(|branch| all_t_14[branch % 2]);
        let mut all_margin_2 = [0.0; 4];
        let mut all_error_2 = [0.0; 4];
        for branch in 0..4 {
            let s3 = all_s3[branch];
            let c3 = all_c3[branch];
            let t_17 = 0.19636363636363638 * s3;
            let t_18 = 0.22545454545454546 + 0.19636363636363638 * c3;
            let t_16 = all_t_16[branch];
            let t_15 = all_t_15[branch];
            // Step 4: q2 from sine and cosine.
            let ([c2, s2], q2_margin) = ::dh_robot::runtime::batched::pair(
                -t_17,
                -t_18,
                t_16,
                t_18,
                -t_17,
                t_15,
            );
            let q2 = ::dh_robot::runtime::batched::angle(s2, c2);
            all_q2[branch] = q2;
            let q2_in_range = q2;
            q[1][branch] = q2_in_range;
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let t_13 = all_t_13[branch];
            let t_14 = all_t_14[branch];
            let t_19 = t_13 + 0.19636363636363638 * (c3 * s2 + s3 * c2)
                + 0.22545454545454546 * s2;
            let t_20 = t_14 + 0.19636363636363638 * (c3 * c2 - s3 * s2)
                + 0.22545454545454546 * c2;
            let t_21 = 0.048 - t_19;
            let q2_error = (c1 * t_21 - t[0][3]).abs() + (s1 * t_21 - t[1][3]).abs()
                + (0.21381818181818182 + t_20 - t[2][3]).abs();
            all_margin_2[branch] = q2_margin;
            all_error_2[branch] = q2_error;
        }
        // Step 5: q5 from a free choice.
        let [c5_first, s5_first] = ::dh_robot::runtime::batched::chosen_angle();
        let all_c5 = [c5_first, c5_first, c5_first, c5_first];
        let all_s5 = [s5_first, s5_first, s5_first, s5_first];
        let q5 = ::dh_robot::runtime::batched::angle(s5_first, c5_first);
        let all_q1: [f64; 4] = ::core::array::from_fn(|branch| all_q1[branch / 1 % 2]);
        let all_q2_plus_q3_plus_q4: [f64; 4] = ::core::array::from_fn(|branch| {
            all_q2_plus_q3_plus_q4[branch % 2]
        });
        let all_q3: [f64; 4] = ::core::array::from_fn(|branch| {
            all_q3[branch / 2 % 2 * 2 + branch % 2]
        });
        let all_margin_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_margin_1[branch % 2]
        });
        let mut all_margin = [0.0; 4];
        let all_valid_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_valid_1[branch % 2]
        });
        let mut all_valid = [0.0; 4];
        let all_error_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_error_1[branch % 2]
        });
        let mut all_error = [0.0; 4];
        for branch in 0..4 {
            let q1 = all_q1[branch];
            let q2_plus_q3_plus_q4 = all_q2_plus_q3_plus_q4[branch];
            let q3 = all_q3[branch];
            let q2 = all_q2[branch];
            let margin_1 = all_margin_1[branch];
            let margin_2 = all_margin_2[branch];
            let valid_1 = all_valid_1[branch];
            let error_1 = all_error_1[branch];
            let error_2 = all_error_2[branch];
            // How far the branch is from the target.
            all_margin[branch] = ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(q1_margin, margin_1),
                margin_2,
            );
            all_valid[branch] = valid_1;
            all_error[branch] = error_1 + error_2;
            q[0][branch] = q1;
            q[3][branch] = ::dh_robot::runtime::batched::wrap(
                q2_plus_q3_plus_q4 - q3 - q2,
            );
            q[4][branch] = q5;
        }
        *valid = all_valid;
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<5> for Youbot {
    #[inline]
    fn forward(&self, q: &[f64; 5]) -> ::dh_robot::runtime::Pose {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        let t_2 = s234 * 0.2175 + 0.135 * s23 + 0.155 * s2 - 0.033;
        [
            [c5c234 * c1 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234 * c1, -c1 * t_2],
            [c5c234 * s1 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234 * s1, -s1 * t_2],
            [
                c5 * s234,
                -s5 * s234,
                c234,
                c234 * 0.2175 + 0.135 * c23 + 0.155 * c2 + 0.147,
            ],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 5],
    ) -> (::dh_robot::runtime::Pose, [[f64; 5]; 6]) {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        let s234c1 = s234 * c1;
        let s234s1 = s234 * s1;
        let t_2 = s234 * 0.2175;
        let t_3 = c234 * 0.2175;
        let t_4 = t_2 + 0.135 * s23;
        let t_5 = t_3 + 0.135 * c23;
        let t_6 = t_4 + 0.155 * s2;
        let t_7 = t_5 + 0.155 * c2;
        let t_8 = t_6 - 0.033;
        let t_9 = c1 * t_8;
        let t_10 = s1 * t_8;
        (
            [
                [c5c234 * c1 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234c1, -t_9],
                [c5c234 * s1 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234s1, -t_10],
                [c5 * s234, -s5 * s234, c234, t_7 + 0.147],
            ],
            [
                [t_10, -c1 * t_7, -c1 * t_5, -c1 * t_3, 0.0],
                [-t_9, -s1 * t_7, -s1 * t_5, -s1 * t_3, 0.0],
                [0.0, -t_6, -t_4, -t_2, 0.0],
                [0.0, s1, s1, s1, -s234c1],
                [0.0, -c1, -c1, -c1, -s234s1],
                [1.0, 0.0, 0.0, 0.0, c234],
            ],
        )
    }
    fn unit(&self) -> &'static str {
        "m"
    }
}
impl ::dh_robot::InverseKinematics<5, f64> for Youbot {
    type Target = (
        ::dh_robot::nalgebra::Point3<f64>,
        ::dh_robot::nalgebra::UnitVector3<f64>,
    );
    type Solutions = ::dh_robot::Solutions<f64, 5, 4>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Youbot::inverse(self, *target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 5],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 5>, ::dh_robot::Why<f64>> {
        Youbot::inverse_near(self, *target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Youbot {
    type Joints = ::dh_robot::runtime::Joints<5>;
}
