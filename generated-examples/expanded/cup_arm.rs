// What `dh_robot!` makes of src/cup_arm.rs. Made by `cargo regen`; do not edit.

/// The arm that grasps a cup, in millimetres, on its stand and with its gripper.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in mm:
///
/// | joint | alpha | a | d | theta |
/// |---|---|---|---|---|
/// | 1 | 0 | 0 | 0 | q1 |
/// | 2 | -90deg | -30 | 0 | q2 |
/// | 3 | 0 | 340 | 0 | q3 |
/// | 4 | -90deg | -40 | 338 | q4 |
/// | 5 | 90deg | 0 | 0 | q5 |
/// | 6 | -90deg | 0 | 0 | q6 |
///
/// `base = tz(373mm);`
///
/// `tool = tz(206mm)*ry(90deg)*rz(180deg);`
///
/// Pose of the tool in the base, rotation and translation:
///
/// ```text
/// r₁₁ = −c₁(c₂₃c₄s₅ + s₂₃c₅) − s₁s₄s₅
/// r₂₁ = −s₁(c₂₃c₄s₅ + s₂₃c₅) + c₁s₄s₅
/// r₃₁ = s₂₃c₄s₅ − c₂₃c₅
/// r₁₂ = c₁[c₂₃(c₄c₅s₆ + s₄c₆) − s₂₃s₅s₆] + s₁(s₄c₅s₆ − c₄c₆)
/// r₂₂ = s₁[c₂₃(c₄c₅s₆ + s₄c₆) − s₂₃s₅s₆] − c₁(s₄c₅s₆ − c₄c₆)
/// r₃₂ = −s₂₃(c₄c₅s₆ + s₄c₆) − c₂₃s₅s₆
/// r₁₃ = c₁[c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆] + s₁(s₄c₅c₆ + c₄s₆)
/// r₂₃ = s₁[c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆] − c₁(s₄c₅c₆ + c₄s₆)
/// r₃₃ = −s₂₃(c₄c₅c₆ − s₄s₆) − c₂₃s₅c₆
/// px  = c₁[a₁ + a₂c₂ + c₂₃(a₃ − tz·c₄s₅) − s₂₃(d₄ + tz·c₅)] − tz·s₁s₄s₅
/// py  = s₁[a₁ + a₂c₂ + c₂₃(a₃ − tz·c₄s₅) − s₂₃(d₄ + tz·c₅)] + tz·c₁s₄s₅
/// pz  = bz − a₂s₂ − s₂₃(a₃ − tz·c₄s₅) − c₂₃(d₄ + tz·c₅)
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 4, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      a₁ = −30, a₂ = 340, a₃ = −40, d₄ = 338, bz = 373, tz = 206
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CupArm;
impl ::core::default::Default for CupArm {
    fn default() -> Self {
        CupArm
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl CupArm {
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
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in mm.
    ///
    /// Cost: 44 multiplications, 24 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms; equation (15) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_2 = s5c4 * c23 + c5 * s23;
        let t_3 = s5c4 * s23 - c5 * c23;
        let t_4 = t_2 * c1 + s5s4 * s1;
        let t_5 = t_2 * s1 - s5s4 * c1;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_6 = c4 * c6c5 - s6 * s4;
        let t_7 = s4 * c6c5 + s6 * c4;
        let t_8 = c23 * t_6 - s23 * c6s5;
        let t_9 = s23 * t_6 + c23 * c6s5;
        let t_10 = c1 * t_8 + s1 * t_7;
        let t_11 = s1 * t_8 - c1 * t_7;
        let t_12 = s5 * 206.0;
        let t_13 = c5 * 206.0 + 338.0;
        let t_14 = s4 * t_12;
        let t_15 = 40.0 + c4 * t_12;
        let t_16 = 30.0 + c23 * t_15 + s23 * t_13 - 340.0 * c2;
        ::dh_robot::pose::from_entries(
            [
                [-t_4, t_3 * t_11 - t_5 * t_9, t_10],
                [-t_5, t_4 * t_9 - t_3 * t_10, t_11],
                [t_3, -(t_5 * t_10 - t_4 * t_11), -t_9],
            ],
            [
                -(c1 * t_16 + s1 * t_14),
                -(s1 * t_16 - c1 * t_14),
                s23 * t_15 - c23 * t_13 - 340.0 * s2 + 373.0,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 54 multiplications, 26 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[3], q[4], q[5]];
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = c1 * 30.0;
        let t_3 = s1 * 30.0;
        let t_4 = 340.0 * c2;
        let t_5 = t_2 - c1 * t_4;
        let t_6 = t_3 - s1 * t_4;
        let t_7 = 373.0 - 340.0 * s2;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let t_8 = t_5 + c1c23 * 40.0 + c1s23 * 338.0;
        let t_9 = t_6 + s1c23 * 40.0 + s1s23 * 338.0;
        let t_10 = t_7 + s23 * 40.0 - c23 * 338.0;
        let s23c4 = s23 * c4;
        let t_11 = c1c23 * c4 + s1 * s4;
        let t_12 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_13 = s1 * c4 - c1c23 * s4;
        let t_14 = c1 * c4 + s1c23 * s4;
        let t_15 = t_11 * c5 - c1s23 * s5;
        let t_16 = t_12 * c5 - s1s23 * s5;
        let t_17 = s23c4 * c5 + c23 * s5;
        let t_18 = c1s23 * c5 + t_11 * s5;
        let t_19 = s1s23 * c5 + t_12 * s5;
        let t_20 = c23 * c5 - s23c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 373.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, -s1], [s1 * c2, -s1 * s2, c1], [-s2, -c2, 0.0]],
                [-t_2, -t_3, 373.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c23, -c1s23, -s1], [s1c23, -s1s23, c1], [-s23, -c23, 0.0]],
                [-t_5, -t_6, t_7],
            ),
            ::dh_robot::pose::from_entries(
                [[t_11, t_13, -c1s23], [t_12, -t_14, -s1s23], [-s23c4, s23s4, -c23]],
                [-t_8, -t_9, t_10],
            ),
            ::dh_robot::pose::from_entries(
                [[t_15, -t_18, -t_13], [t_16, -t_19, t_14], [-t_17, -t_20, -s23s4]],
                [-t_8, -t_9, t_10],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_15 * c6 + t_13 * s6, t_13 * c6 - t_15 * s6, -t_18],
                    [t_16 * c6 - t_14 * s6, -(t_14 * c6 + t_16 * s6), -t_19],
                    [-(t_17 * c6 - s23s4 * s6), s23s4 * c6 + t_17 * s6, -t_20],
                ],
                [-t_8, -t_9, t_10],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (mm per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (16) of the robot's notes.
    ///
    /// Cost: 50 multiplications, 20 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let s23c4 = s23 * c4;
        let t_2 = c1c23 * c4 + s1 * s4;
        let t_3 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_4 = s1 * c4 - c1c23 * s4;
        let t_5 = c1 * c4 + s1c23 * s4;
        let t_6 = s5 * 206.0;
        let t_7 = c5 * 206.0 + 338.0;
        let t_8 = s4 * t_6;
        let t_9 = c4 * t_6 + 40.0;
        let t_10 = c23 * t_9 + s23 * t_7;
        let t_11 = s23 * t_9 - c23 * t_7;
        let t_12 = t_10 - 340.0 * c2;
        let t_13 = t_11 - 340.0 * s2;
        let t_14 = t_12 + 30.0;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_14 - c1 * t_8, -(c1 * t_14 + s1 * t_8), 0.0, 0.0, 0.0, 1.0],
                [c1 * t_13, s1 * t_13, t_12, -s1, c1, 0.0],
                [c1 * t_11, s1 * t_11, t_10, -s1, c1, 0.0],
                [-t_4 * t_6, t_5 * t_6, -s23s4 * t_6, -c1s23, -s1s23, -c23],
                [
                    -(t_2 * c5 - c1s23 * s5) * 206.0,
                    -(t_3 * c5 - s1s23 * s5) * 206.0,
                    (s23c4 * c5 + c23 * s5) * 206.0,
                    -t_4,
                    t_5,
                    -s23s4,
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    -(c1s23 * c5 + t_2 * s5),
                    -(s1s23 * c5 + t_3 * s5),
                    -(c23 * c5 - s23c4 * s5),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 62 multiplications, 27 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[5], q[1]];
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let s23c4 = s23 * c4;
        let t_2 = c1c23 * c4 + s1 * s4;
        let t_3 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_4 = s1 * c4 - c1c23 * s4;
        let t_5 = c1 * c4 + s1c23 * s4;
        let t_6 = t_2 * c5 - c1s23 * s5;
        let t_7 = t_3 * c5 - s1s23 * s5;
        let t_8 = s23c4 * c5 + c23 * s5;
        let t_9 = c1s23 * c5 + t_2 * s5;
        let t_10 = s1s23 * c5 + t_3 * s5;
        let t_11 = c23 * c5 - s23c4 * s5;
        let t_12 = s5 * 206.0;
        let t_13 = c5 * 206.0 + 338.0;
        let t_14 = s4 * t_12;
        let t_15 = c4 * t_12 + 40.0;
        let t_16 = c23 * t_15 + s23 * t_13;
        let t_17 = s23 * t_15 - c23 * t_13;
        let t_18 = t_16 - 340.0 * c2;
        let t_19 = t_17 - 340.0 * s2;
        let t_20 = t_18 + 30.0;
        let t_21 = c1 * t_20 + s1 * t_14;
        let t_22 = s1 * t_20 - c1 * t_14;
        (
            ::dh_robot::pose::from_entries(
                [
                    [-t_9, -(t_4 * c6 - t_6 * s6), t_6 * c6 + t_4 * s6],
                    [-t_10, t_5 * c6 + t_7 * s6, t_7 * c6 - t_5 * s6],
                    [-t_11, -(s23s4 * c6 + t_8 * s6), -(t_8 * c6 - s23s4 * s6)],
                ],
                [-t_21, -t_22, t_19 + 373.0],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_22, -t_21, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_19, s1 * t_19, t_18, -s1, c1, 0.0],
                    [c1 * t_17, s1 * t_17, t_16, -s1, c1, 0.0],
                    [-t_4 * t_12, t_5 * t_12, -s23s4 * t_12, -c1s23, -s1s23, -c23],
                    [-t_6 * 206.0, -t_7 * 206.0, t_8 * 206.0, -t_4, t_5, -s23s4],
                    [0.0, 0.0, 0.0, -t_9, -t_10, -t_11],
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
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 954.0)
    }
}
impl ::dh_robot::Robot<6, f64> for CupArm {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for CupArm {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        CupArm::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        CupArm::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for CupArm {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        CupArm::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        CupArm::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl CupArm {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::CLOSED_FORM;
    /// The sum of the arm's lengths, in mm: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 954.0;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 2. `q3`: the law of cosines (a cos + b sin = c, two values).
    /// 3. `q2`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 4. `q4`: a ratio of sine and cosine (a cos + b sin = 0, two values half a turn apart).
    /// 5. `q5`: sine and cosine (two equations a cos + b sin = c, one value).
    /// 6. `q6`: sine and cosine (two equations a cos + b sin = c, one value).
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
        [q[0], q[2], q[1], q[3], q[4], q[5], 0.0, 0.0]
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
        let t_2 = t[2][3] - 0.39098532494758914 - t[2][0] * 0.2159329140461216;
        let t_3 = t_2 * t_2;
        // Step 1: q1 from a ratio of sine and cosine.
        let q1_roots = ::dh_robot::runtime::solve_sincos(
            -(t[1][3] - t[1][0] * 0.2159329140461216),
            t[0][3] - t[0][0] * 0.2159329140461216,
            0.0,
            sample.tolerance,
        );
        if !q1_roots.is_regular() {
            attempt
                .note(q1_roots.outcome, &path, "shoulder q1", Self::LENGTH_SCALE, "mm");
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
            let t_4 = t[0][2] * c1 + t[1][2] * s1;
            let t_5 = t[0][2] * s1 - t[1][2] * c1;
            let t_6 = t[0][1] * c1 + t[1][1] * s1;
            let t_7 = t[0][1] * s1 - t[1][1] * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][3] * c1 + t[1][3] * s1 - 0.2159329140461216 * t_8;
            let t_11 = t[0][3] * s1 - t[1][3] * c1 - 0.2159329140461216 * t_9;
            let t_12 = 0.031446540880503145 * (0.031446540880503145 + t_10 * 2.0);
            let t_13 = t_12 + t_3 + t_10 * t_10 + t_11 * t_11 - 0.25430164946006883;
            let t_14 = t_10 + 0.031446540880503145;
            // Step 2: q3 from the law of cosines.
            let q3_roots = ::dh_robot::runtime::solve_sincos(
                -0.02988630020788559,
                -0.2525392367566332,
                t_13,
                sample.tolerance,
            );
            if !q3_roots.is_regular() {
                attempt
                    .note_law(
                        q3_roots.outcome,
                        &path,
                        "elbow q3",
                        [0.25430164946006883, t_13],
                        false,
                        Self::LENGTH_SCALE,
                        "mm",
                    );
            }
            if path.is_chosen() {
                attempt.see(1, &path, [-0.02988630020788559, -0.2525392367566332, t_13]);
            }
            let path = if q3_roots.is_free() {
                attempt.choose(1, &path, ::dh_robot::FreeJoints::of(&[2]))
            } else {
                path
            };
            for (q3_root, &[c3, s3]) in q3_roots
                .or_if_free(sample.angle(1))
                .iter()
                .enumerate()
            {
                let path = path.root(1, q3_root);
                let q3 = ::dh_robot::runtime::atan2(s3, c3);
                let t_15 = 0.35639412997903563 - 0.041928721174004195 * c3
                    - 0.35429769392033544 * s3;
                // Step 3: q2 from sine and cosine.
                let q2_roots = ::dh_robot::runtime::solve_pair(
                    -t_14,
                    t_2,
                    -t_15,
                    t_2,
                    t_14,
                    -(c3 * 0.35429769392033544 - 0.041928721174004195 * s3),
                    sample.tolerance,
                );
                if !q2_roots.is_regular() {
                    attempt.note(q2_roots.outcome, &path, "q2", 1.0, "");
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
                    let q2 = ::dh_robot::runtime::atan2(s2, c2);
                    let t_16 = c3 * c2 - s3 * s2;
                    let t_17 = c3 * s2 + s3 * c2;
                    let t_18 = t_4 * t_16 - t[2][2] * t_17;
                    let t_19 = t_4 * t_17 + t[2][2] * t_16;
                    let t_20 = t_6 * t_16 - t[2][1] * t_17;
                    let t_21 = t_6 * t_17 + t[2][1] * t_16;
                    let t_22 = t_8 * t_16 - t[2][0] * t_17;
                    // Step 4: q4 from a ratio of sine and cosine.
                    let q4_roots = ::dh_robot::runtime::solve_sincos(
                        -t_9,
                        t_22,
                        0.0,
                        sample.tolerance,
                    );
                    if !q4_roots.is_regular() {
                        attempt.note(q4_roots.outcome, &path, "wrist q4", 1.0, "");
                    }
                    if path.is_chosen() {
                        attempt.see(3, &path, [-t_9, t_22, 0.0]);
                    }
                    let path = if q4_roots.is_free() {
                        attempt.choose(3, &path, ::dh_robot::FreeJoints::of(&[3]))
                    } else {
                        path
                    };
                    for (q4_root, &[c4, s4]) in q4_roots
                        .or_if_free(sample.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let path = path.root(3, q4_root);
                        let q4 = ::dh_robot::runtime::atan2(s4, c4);
                        let t_23 = t_18 * c4 + t_5 * s4;
                        let t_24 = t_20 * c4 + t_7 * s4;
                        // Step 5: q5 from sine and cosine.
                        let q5_roots = ::dh_robot::runtime::solve_pair(
                            0.0,
                            -1.0,
                            t_22 * c4 + t_9 * s4,
                            1.0,
                            0.0,
                            -(t_8 * t_17 + t[2][0] * t_16),
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
                            // Step 6: q6 from sine and cosine.
                            let q6_roots = ::dh_robot::runtime::solve_pair(
                                1.0,
                                0.0,
                                t_23 * c5 - t_19 * s5,
                                0.0,
                                -1.0,
                                -(t_24 * c5 - t_21 * s5),
                                sample.tolerance,
                            );
                            if !q6_roots.is_regular() {
                                attempt.note(q6_roots.outcome, &path, "q6", 1.0, "");
                            }
                            let path = if q6_roots.is_free() {
                                attempt.choose(5, &path, ::dh_robot::FreeJoints::of(&[5]))
                            } else {
                                path
                            };
                            for (q6_root, &[c6, s6]) in q6_roots
                                .or_if_free(sample.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let q6 = ::dh_robot::runtime::atan2(s6, c6);
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
                                        if (q3_root == 1) == (q1_root == 0) {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(2, q4_root)
                                    .with_wrist(
                                        if q4_root == 0 {
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
            let q3_root = branch / 2 % 2;
            let q4_root = branch / 4 % 2;
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
                    if (q3_root == 1) == (q1_root == 0) {
                        ::dh_robot::Elbow::Up
                    } else {
                        ::dh_robot::Elbow::Down
                    },
                )
                .with_step(2, q4_root)
                .with_wrist(
                    if q4_root == 0 {
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
        q: &mut [[f64; 8]; 6],
        valid: &mut [f64; 8],
    ) -> bool {
        let t_2 = t[2][3] - 0.39098532494758914 - t[2][0] * 0.2159329140461216;
        let t_3 = t_2 * t_2;
        // Step 1: q1 from a ratio of sine and cosine.
        let ([c1_first, s1_first], q1_margin) = ::dh_robot::runtime::batched::half_turn([
            [
                -(t[1][3] - t[1][0] * 0.2159329140461216),
                t[0][3] - t[0][0] * 0.2159329140461216,
            ],
        ]);
        let all_c1 = [c1_first, -c1_first];
        let all_s1 = [s1_first, -s1_first];
        let all_q1 = ::dh_robot::runtime::batched::angles(
            &[s1_first, -s1_first],
            &[c1_first, -c1_first],
        );
        let mut all_t_4 = [0.0; 2];
        let mut all_t_5 = [0.0; 2];
        let mut all_t_6 = [0.0; 2];
        let mut all_t_7 = [0.0; 2];
        let mut all_t_8 = [0.0; 2];
        let mut all_t_9 = [0.0; 2];
        let mut all_t_14 = [0.0; 2];
        let mut q3_pairs = [[0.0; 4]; 2];
        let mut all_margin_1 = [0.0; 2];
        let mut all_valid_1 = [0.0; 2];
        for branch in 0..2 {
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let t_4 = t[0][2] * c1 + t[1][2] * s1;
            let t_5 = t[0][2] * s1 - t[1][2] * c1;
            let t_6 = t[0][1] * c1 + t[1][1] * s1;
            let t_7 = t[0][1] * s1 - t[1][1] * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][3] * c1 + t[1][3] * s1 - 0.2159329140461216 * t_8;
            let t_11 = t[0][3] * s1 - t[1][3] * c1 - 0.2159329140461216 * t_9;
            let t_12 = 0.031446540880503145 * (0.031446540880503145 + t_10 * 2.0);
            let t_13 = t_12 + t_3 + t_10 * t_10 + t_11 * t_11 - 0.25430164946006883;
            let t_14 = t_10 + 0.031446540880503145;
            all_t_4[branch] = t_4;
            all_t_5[branch] = t_5;
            all_t_6[branch] = t_6;
            all_t_7[branch] = t_7;
            all_t_8[branch] = t_8;
            all_t_9[branch] = t_9;
            all_t_14[branch] = t_14;
            // Step 2: q3 from the law of cosines.
            let ([c3_first, s3_first, c3_second, s3_second], q3_valid, q3_margin) = ::dh_robot::runtime::batched::sincos(
                -0.02988630020788559,
                -0.2525392367566332,
                t_13,
            );
            q3_pairs[0][branch] = c3_first;
            q3_pairs[1][branch] = s3_first;
            q3_pairs[0][branch + 2] = c3_second;
            q3_pairs[1][branch + 2] = s3_second;
            all_margin_1[branch] = q3_margin;
            all_valid_1[branch] = q3_valid;
        }
        let all_q3 = ::dh_robot::runtime::batched::angles(&q3_pairs[1], &q3_pairs[0]);
        q[2] = ::core::array::from_fn(|branch| all_q3[branch / 2 % 2 * 2 + branch % 2]);
        let all_c3 = q3_pairs[0];
        let all_s3 = q3_pairs[1];
        let all_t_14: [f64; 4] = ::core::array::from_fn(|branch| all_t_14[branch % 2]);
        let all_t_4: [f64; 4] = ::core::array::from_fn(|branch| all_t_4[branch % 2]);
        let all_t_6: [f64; 4] = ::core::array::from_fn(|branch| all_t_6[branch % 2]);
        let all_t_8: [f64; 4] = ::core::array::from_fn(|branch| all_t_8[branch % 2]);
        let all_t_9: [f64; 4] = ::core::array::from_fn(|branch| all_t_9[branch % 2]);
        let all_t_5: [f64; 4] = ::core::array::from_fn(|branch| all_t_5[branch % 2]);
        let all_t_7: [f64; 4] = ::core::array::from_fn(|branch| all_t_7[branch % 2]);
        let all_c1: [f64; 4] = ::core::array::from_fn(|branch| all_c1[branch % 2]);
        let all_s1: [f64; 4] = ::core::array::from_fn(|branch| all_s1[branch % 2]);
        let all_q1: [f64; 4] = ::core::array::from_fn(|branch| all_q1[branch / 1 % 2]);
        let all_margin_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_margin_1[branch % 2]
        });
        let mut all_margin = [0.0; 4];
        let all_valid_1: [f64; 4] = ::core::array::from_fn(|branch| {
            all_valid_1[branch % 2]
        });
        let mut all_valid = [0.0; 4];
        let mut all_error = [0.0; 4];
        for branch in 0..4 {
            let c3 = all_c3[branch];
            let s3 = all_s3[branch];
            let t_15 = 0.35639412997903563 - 0.041928721174004195 * c3
                - 0.35429769392033544 * s3;
            let t_14 = all_t_14[branch];
            // Step 3: q2 from sine and cosine.
            let ([c2, s2], q2_margin) = ::dh_robot::runtime::batched::pair(
                -t_14,
                t_2,
                -t_15,
                t_2,
                t_14,
                -(c3 * 0.35429769392033544 - 0.041928721174004195 * s3),
            );
            let q2 = ::dh_robot::runtime::batched::angle(s2, c2);
            let t_4 = all_t_4[branch];
            let t_6 = all_t_6[branch];
            let t_8 = all_t_8[branch];
            let t_16 = c3 * c2 - s3 * s2;
            let t_17 = c3 * s2 + s3 * c2;
            let t_18 = t_4 * t_16 - t[2][2] * t_17;
            let t_19 = t_4 * t_17 + t[2][2] * t_16;
            let t_20 = t_6 * t_16 - t[2][1] * t_17;
            let t_21 = t_6 * t_17 + t[2][1] * t_16;
            let t_22 = t_8 * t_16 - t[2][0] * t_17;
            let t_23 = 0.35639412997903563 * c2;
            let t_24 = 0.35639412997903563 * s2;
            let t_9 = all_t_9[branch];
            // Step 4: q4 from a ratio of sine and cosine.
            let ([c4, s4], q4_margin) = ::dh_robot::runtime::batched::half_turn([
                [-t_9, t_22],
            ]);
            let q4 = ::dh_robot::runtime::batched::angle(s4, c4);
            let t_5 = all_t_5[branch];
            let t_7 = all_t_7[branch];
            let t_25 = t_18 * c4 + t_5 * s4;
            let t_26 = t_20 * c4 + t_7 * s4;
            // Step 5: q5 from sine and cosine.
            let [c5, s5] = ::dh_robot::runtime::batched::unit(
                -(t_8 * t_17 + t[2][0] * t_16),
                -(t_22 * c4 + t_9 * s4),
            );
            let q5 = ::dh_robot::runtime::batched::angle(s5, c5);
            let c1 = all_c1[branch];
            let s1 = all_s1[branch];
            let c4s5 = c4 * s5;
            let s4s5 = s4 * s5;
            let t_27 = t_16 * c4s5 + t_17 * c5;
            let t_28 = 0.2159329140461216 * s5;
            let t_29 = 0.35429769392033544 + 0.2159329140461216 * c5;
            let t_30 = s4 * t_28;
            let t_31 = 0.041928721174004195 + c4 * t_28;
            let t_32 = 0.031446540880503145 + t_16 * t_31 + t_17 * t_29 - t_23;
            let q5_error = (-(c1 * t_27 + s1 * s4s5) - t[0][0]).abs()
                + (-(s1 * t_27 - c1 * s4s5) - t[1][0]).abs()
                + (t_17 * c4s5 - t_16 * c5 - t[2][0]).abs()
                + (-(c1 * t_32 + s1 * t_30) - t[0][3]).abs()
                + (-(s1 * t_32 - c1 * t_30) - t[1][3]).abs()
                + (0.39098532494758914 + t_17 * t_31 - t_16 * t_29 - t_24 - t[2][3])
                    .abs();
            // Step 6: q6 from sine and cosine.
            let [c6, s6] = ::dh_robot::runtime::batched::unit(
                t_25 * c5 - t_19 * s5,
                t_26 * c5 - t_21 * s5,
            );
            let q6 = ::dh_robot::runtime::batched::angle(s6, c6);
            let c5c6 = c5 * c6;
            let s5c6 = s5 * c6;
            let t_33 = c4 * c5c6 - s4 * s6;
            let t_34 = s4 * c5c6 + c4 * s6;
            let t_35 = t_16 * t_33 - t_17 * s5c6;
            let q6_error = (c1 * t_35 + s1 * t_34 - t[0][2]).abs()
                + (s1 * t_35 - c1 * t_34 - t[1][2]).abs()
                + (-(t_17 * t_33 + t_16 * s5c6) - t[2][2]).abs();
            let q1 = all_q1[branch];
            let margin_1 = all_margin_1[branch];
            let valid_1 = all_valid_1[branch];
            // How far the branch is from the target.
            all_margin[branch] = ::dh_robot::runtime::batched::lesser(
                ::dh_robot::runtime::batched::lesser(
                    ::dh_robot::runtime::batched::lesser(q1_margin, margin_1),
                    q2_margin,
                ),
                q4_margin,
            );
            all_valid[branch] = valid_1;
            all_error[branch] = q5_error + q6_error;
            // The mirrored half differs by signs.
            let q4_second = ::dh_robot::runtime::batched::opposite(q4);
            let q5_second = ::dh_robot::runtime::batched::negative(q5);
            let q6_second = ::dh_robot::runtime::batched::opposite(q6);
            q[0][branch] = q1;
            q[1][branch] = q2;
            q[3][branch] = q4;
            q[4][branch] = q5;
            q[5][branch] = q6;
            q[0][branch + 4] = q1;
            q[1][branch + 4] = q2;
            q[3][branch + 4] = q4_second;
            q[4][branch + 4] = q5_second;
            q[5][branch + 4] = q6_second;
        }
        *valid = ::core::array::from_fn(|branch| all_valid[branch % 4]);
        ::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for CupArm {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_2 = s5c4 * c23 + c5 * s23;
        let t_3 = s5c4 * s23 - c5 * c23;
        let t_4 = t_2 * c1 + s5s4 * s1;
        let t_5 = t_2 * s1 - s5s4 * c1;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_6 = c4 * c6c5 - s6 * s4;
        let t_7 = s4 * c6c5 + s6 * c4;
        let t_8 = c23 * t_6 - s23 * c6s5;
        let t_9 = s23 * t_6 + c23 * c6s5;
        let t_10 = c1 * t_8 + s1 * t_7;
        let t_11 = s1 * t_8 - c1 * t_7;
        let t_12 = s5 * 206.0;
        let t_13 = c5 * 206.0 + 338.0;
        let t_14 = s4 * t_12;
        let t_15 = 40.0 + c4 * t_12;
        let t_16 = 30.0 + c23 * t_15 + s23 * t_13 - 340.0 * c2;
        [
            [-t_4, t_3 * t_11 - t_5 * t_9, t_10, -(c1 * t_16 + s1 * t_14)],
            [-t_5, t_4 * t_9 - t_3 * t_10, t_11, -(s1 * t_16 - c1 * t_14)],
            [
                t_3,
                -(t_5 * t_10 - t_4 * t_11),
                -t_9,
                s23 * t_15 - c23 * t_13 - 340.0 * s2 + 373.0,
            ],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::runtime::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[5], q[1]];
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let s23c4 = s23 * c4;
        let t_2 = c1c23 * c4 + s1 * s4;
        let t_3 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_4 = s1 * c4 - c1c23 * s4;
        let t_5 = c1 * c4 + s1c23 * s4;
        let t_6 = t_2 * c5 - c1s23 * s5;
        let t_7 = t_3 * c5 - s1s23 * s5;
        let t_8 = s23c4 * c5 + c23 * s5;
        let t_9 = c1s23 * c5 + t_2 * s5;
        let t_10 = s1s23 * c5 + t_3 * s5;
        let t_11 = c23 * c5 - s23c4 * s5;
        let t_12 = s5 * 206.0;
        let t_13 = c5 * 206.0 + 338.0;
        let t_14 = s4 * t_12;
        let t_15 = c4 * t_12 + 40.0;
        let t_16 = c23 * t_15 + s23 * t_13;
        let t_17 = s23 * t_15 - c23 * t_13;
        let t_18 = t_16 - 340.0 * c2;
        let t_19 = t_17 - 340.0 * s2;
        let t_20 = t_18 + 30.0;
        let t_21 = c1 * t_20 + s1 * t_14;
        let t_22 = s1 * t_20 - c1 * t_14;
        (
            [
                [-t_9, -(t_4 * c6 - t_6 * s6), t_6 * c6 + t_4 * s6, -t_21],
                [-t_10, t_5 * c6 + t_7 * s6, t_7 * c6 - t_5 * s6, -t_22],
                [-t_11, -(s23s4 * c6 + t_8 * s6), -(t_8 * c6 - s23s4 * s6), t_19 + 373.0],
            ],
            [
                [t_22, c1 * t_19, c1 * t_17, -t_4 * t_12, -t_6 * 206.0, 0.0],
                [-t_21, s1 * t_19, s1 * t_17, t_5 * t_12, -t_7 * 206.0, 0.0],
                [0.0, t_18, t_16, -s23s4 * t_12, t_8 * 206.0, 0.0],
                [0.0, -s1, -s1, -c1s23, -t_4, -t_9],
                [0.0, c1, c1, -s1s23, t_5, -t_10],
                [1.0, 0.0, 0.0, -c23, -s23s4, -t_11],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, f64> for CupArm {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 6, 8>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        CupArm::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        CupArm::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for CupArm {
    type Joints = ::dh_robot::runtime::Joints<6>;
}
