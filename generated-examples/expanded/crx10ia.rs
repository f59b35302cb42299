// What `dh_robot!` makes of src/crx10ia.rs. Made by `cargo regen`; do not edit.

/// FANUC CRX-10iA.
///
/// Denavit-Hartenberg table, modified convention (Craig: alpha and a of the link before); bare lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | 1 | 0 | 0 | 0 | q1 | -180deg..=180deg |
/// | 2 | -90deg | 0 | 0 | q2 - 90deg | -180deg..=180deg |
/// | 3 | 0 | 540mm | 0 | q3 | -270deg..=270deg |
/// | 4 | -90deg | 0 | 540mm | q4 | -190deg..=190deg |
/// | 5 | 90deg | 0 | -150mm | q5 | -180deg..=180deg |
/// | 6 | -90deg | 0 | 160mm | q6 | -190deg..=190deg |
///
/// Pose of the last frame in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁[s₂₃(c₄c₅c₆ − s₄s₆) + c₂₃s₅c₆] + s₁(s₄c₅c₆ + c₄s₆)
/// r₂₁ = s₁[s₂₃(c₄c₅c₆ − s₄s₆) + c₂₃s₅c₆] − c₁(s₄c₅c₆ + c₄s₆)
/// r₃₁ = c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆
/// r₁₂ = −c₁[s₂₃(c₄c₅s₆ + s₄c₆) + c₂₃s₅s₆] − s₁(s₄c₅s₆ − c₄c₆)
/// r₂₂ = −s₁[s₂₃(c₄c₅s₆ + s₄c₆) + c₂₃s₅s₆] + c₁(s₄c₅s₆ − c₄c₆)
/// r₃₂ = −c₂₃(c₄c₅s₆ + s₄c₆) + s₂₃s₅s₆
/// r₁₃ = −c₁(s₂₃c₄s₅ − c₂₃c₅) − s₁s₄s₅
/// r₂₃ = −s₁(s₂₃c₄s₅ − c₂₃c₅) + c₁s₄s₅
/// r₃₃ = −c₂₃c₄s₅ − s₂₃c₅
/// px  = c₁[a₂s₂ + s₂₃(d₅s₄ − d₆c₄s₅) + c₂₃(d₄ + d₆c₅)] − s₁(d₅c₄ + d₆s₄s₅)
/// py  = s₁[a₂s₂ + s₂₃(d₅s₄ − d₆c₄s₅) + c₂₃(d₄ + d₆c₅)] + c₁(d₅c₄ + d₆s₄s₅)
/// pz  = a₂c₂ + c₂₃(d₅s₄ − d₆c₄s₅) − s₂₃(d₄ + d₆c₅)
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 4, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      a₂ = 0.54, d₄ = 0.54, d₅ = −0.15, d₆ = 0.16
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crx10ia;
impl ::core::default::Default for Crx10ia {
    fn default() -> Self {
        Crx10ia
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Crx10ia {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-3.141592653589793, 3.141592653589793),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-3.141592653589793, 3.141592653589793),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-4.71238898038469, 4.71238898038469),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-3.316125578789226, 3.316125578789226),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-3.141592653589793, 3.141592653589793),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-3.316125578789226, 3.316125578789226),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 45 multiplications, 23 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms; equation (12) of the robot's notes.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * s23 + c6s5 * c23;
        let t_5 = t_2 * c23 - c6s5 * s23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = s23 * s5c4 - c5 * c23;
        let t_9 = c23 * s5c4 + c5 * s23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = s4 * 0.15;
        let t_13 = c4 * 0.15;
        let t_14 = s23 * t_12 - c23 * 0.54 - 0.54 * s2;
        ::dh_robot::pose::from_entries(
            [
                [t_6, -(t_5 * t_11 - t_7 * t_9), -t_10],
                [t_7, -(t_6 * t_9 - t_5 * t_10), -t_11],
                [t_5, -(t_7 * t_10 - t_6 * t_11), -t_9],
            ],
            [
                -(c1 * t_14 - s1 * t_13 + t_10 * 0.16),
                -(s1 * t_14 + c1 * t_13 + t_11 * 0.16),
                -(c23 * t_12 + s23 * 0.54 - 0.54 * c2 + t_9 * 0.16),
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 55 multiplications, 26 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[3], q[4], q[5]];
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let t_2 = 0.54 * s2;
        let t_3 = 0.54 * c2;
        let t_4 = c1 * t_2;
        let t_5 = s1 * t_2;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let t_6 = t_4 + c1c23 * 0.54;
        let t_7 = t_5 + s1c23 * 0.54;
        let t_8 = t_3 - s23 * 0.54;
        let c23c4 = c23 * c4;
        let t_9 = c1s23 * c4 + s1 * s4;
        let t_10 = s1s23 * c4 - c1 * s4;
        let c23s4 = c23 * s4;
        let t_11 = s1 * c4 - c1s23 * s4;
        let t_12 = c1 * c4 + s1s23 * s4;
        let t_13 = t_6 + t_11 * 0.15;
        let t_14 = t_7 - t_12 * 0.15;
        let t_15 = t_8 - c23s4 * 0.15;
        let t_16 = t_9 * c5 + c1c23 * s5;
        let t_17 = t_10 * c5 + s1c23 * s5;
        let t_18 = c23c4 * c5 - s23 * s5;
        let t_19 = c1c23 * c5 - t_9 * s5;
        let t_20 = s1c23 * c5 - t_10 * s5;
        let t_21 = s23 * c5 + c23c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * s2, c1 * c2, -s1], [s1 * s2, s1 * c2, c1], [c2, -s2, 0.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1s23, c1c23, -s1], [s1s23, s1c23, c1], [c23, -s23, 0.0]],
                [t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[t_9, t_11, c1c23], [t_10, -t_12, s1c23], [c23c4, -c23s4, -s23]],
                [t_6, t_7, t_8],
            ),
            ::dh_robot::pose::from_entries(
                [[t_16, t_19, -t_11], [t_17, t_20, t_12], [t_18, -t_21, c23s4]],
                [t_13, t_14, t_15],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_16 * c6 + t_11 * s6, t_11 * c6 - t_16 * s6, t_19],
                    [t_17 * c6 - t_12 * s6, -(t_12 * c6 + t_17 * s6), t_20],
                    [t_18 * c6 - c23s4 * s6, -(c23s4 * c6 + t_18 * s6), -t_21],
                ],
                [t_13 + t_19 * 0.16, t_14 + t_20 * 0.16, t_15 - t_21 * 0.16],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool); equation (13) of the robot's notes.
    ///
    /// Cost: 53 multiplications, 21 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let s23s4 = s23 * s4;
        let c23s4 = c23 * s4;
        let t_2 = c1 * s23s4 - s1 * c4;
        let t_3 = s1 * s23s4 + c1 * c4;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t_4 = s23 * c4s5 - c23 * c5;
        let t_5 = c23 * c4s5 + s23 * c5;
        let t_6 = c1 * t_4 + s1 * s4s5;
        let t_7 = s1 * t_4 - c1 * s4s5;
        let t_8 = s5 * 0.16;
        let t_9 = c5 * 0.16 + 0.54;
        let t_10 = c4 * t_8 + s4 * 0.15;
        let t_11 = s4 * t_8 - c4 * 0.15;
        let t_12 = s23 * t_10 - c23 * t_9;
        let t_13 = c23 * t_10 + s23 * t_9;
        let t_14 = t_12 - 0.54 * s2;
        let t_15 = t_13 - 0.54 * c2;
        let t_16 = s23 * t_11;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_14 - c1 * t_11, -(c1 * t_14 + s1 * t_11), 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_15, -s1 * t_15, t_14, -s1, c1, 0.0],
                [-c1 * t_13, -s1 * t_13, t_12, -s1, c1, 0.0],
                [
                    c1 * t_16 - s1 * t_10,
                    s1 * t_16 + c1 * t_10,
                    c23 * t_11,
                    c1 * c23,
                    s1 * c23,
                    -s23,
                ],
                [
                    (c23s4 * t_7 - t_3 * t_5) * 0.16,
                    (t_2 * t_5 - c23s4 * t_6) * 0.16,
                    (t_3 * t_6 - t_2 * t_7) * 0.16,
                    t_2,
                    t_3,
                    c23s4,
                ],
                [0.0, 0.0, 0.0, -t_6, -t_7, -t_5],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 65 multiplications, 27 additions, 6 sine-cosine pairs.
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
        let s23s4 = s23 * s4;
        let c23s4 = c23 * s4;
        let t_2 = c1 * s23s4 - s1 * c4;
        let t_3 = s1 * s23s4 + c1 * c4;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t_4 = s23 * c4s5 - c23 * c5;
        let t_5 = c23 * c4s5 + s23 * c5;
        let t_6 = c1 * t_4 + s1 * s4s5;
        let t_7 = s1 * t_4 - c1 * s4s5;
        let t_8 = c23s4 * t_7 - t_3 * t_5;
        let t_9 = t_2 * t_5 - c23s4 * t_6;
        let t_10 = t_3 * t_6 - t_2 * t_7;
        let t_11 = s5 * 0.16;
        let t_12 = c5 * 0.16 + 0.54;
        let t_13 = c4 * t_11 + s4 * 0.15;
        let t_14 = s4 * t_11 - c4 * 0.15;
        let t_15 = s23 * t_13 - c23 * t_12;
        let t_16 = c23 * t_13 + s23 * t_12;
        let t_17 = t_15 - 0.54 * s2;
        let t_18 = t_16 - 0.54 * c2;
        let t_19 = c1 * t_17 + s1 * t_14;
        let t_20 = s1 * t_17 - c1 * t_14;
        let t_21 = s23 * t_14;
        (
            ::dh_robot::pose::from_entries(
                [
                    [-(t_8 * c6 + t_2 * s6), -(t_2 * c6 - t_8 * s6), -t_6],
                    [-(t_9 * c6 + t_3 * s6), -(t_3 * c6 - t_9 * s6), -t_7],
                    [-(t_10 * c6 + c23s4 * s6), -(c23s4 * c6 - t_10 * s6), -t_5],
                ],
                [-t_19, -t_20, -t_18],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_20, -t_19, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_18, -s1 * t_18, t_17, -s1, c1, 0.0],
                    [-c1 * t_16, -s1 * t_16, t_15, -s1, c1, 0.0],
                    [
                        c1 * t_21 - s1 * t_13,
                        s1 * t_21 + c1 * t_13,
                        c23 * t_14,
                        c1 * c23,
                        s1 * c23,
                        -s23,
                    ],
                    [t_8 * 0.16, t_9 * 0.16, t_10 * 0.16, t_2, t_3, c23s4],
                    [0.0, 0.0, 0.0, -t_6, -t_7, -t_5],
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
        ::dh_robot::velocity::solve_velocity(&self.jacobian(q), twist, 1.39)
    }
}
impl ::dh_robot::Robot<6, f64> for Crx10ia {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Crx10ia {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Crx10ia::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Crx10ia::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Crx10ia {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Crx10ia::jacobian(self, q)
    }
    #[inline]
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        Crx10ia::forward_and_jacobian(self, q)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Crx10ia {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 16;
    /// What one call of [`inverse`](Self::inverse) or [`inverse_near`](Self::inverse_near) computes at most, at any pose.
    pub const MAX_WORK: ::dh_robot::Work = ::dh_robot::Work::ELIMINATION;
    /// The sum of the arm's lengths, in m: equations are solved for lengths over it, so that one tolerance fits all.
    const LENGTH_SCALE: f64 = 1.39;
    /// What a length is multiplied by.
    const PER_LENGTH: f64 = 1.0 / Self::LENGTH_SCALE;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// A rotation that lost digits (in a file with six decimals, say) is accepted up to
    /// [`Real::ROTATION_TOLERANCE`](::dh_robot::Real::ROTATION_TOLERANCE) and the nearest exact one taken.
    ///
    /// Plan:
    /// 1. `q1`, `q2`, `q3`, `q4`, `q5`, `q6`: the general elimination (Raghavan and Roth) (a polynomial of degree 16).
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 16> {
        self.inverse_with_work(target).0
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
        let unknowns = self.unknowns(&q.map(f64::from));
        ::dh_robot::runtime::solve_near::<
            _,
            6,
            16,
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
    ) -> ::dh_robot::Solutions<f64, 6, 16> {
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
        solutions: &mut [::dh_robot::Solutions<f64, 6, 16>],
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
    ) -> (::dh_robot::Solutions<f64, 6, 16>, f64) {
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
        [q[0], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
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
        // Step 1: q1, q2, q3, q4, q5, q6 from the general elimination (Raghavan and Roth).
        let joints_roots = ::dh_robot::runtime::solve_general(
            &[
                [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0, 0.0, 0.0]],
                [
                    [0.0, 1.0, 0.0, 0.0],
                    [-1.0, 0.0, 0.0, -0.3884892086330936],
                    [0.0, 0.0, 1.0, 0.0],
                ],
                [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0, 0.0, 0.0]],
                [
                    [1.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, -1.0, 0.0],
                    [0.0, 1.0, 0.0, 0.3884892086330936],
                ],
                [
                    [1.0, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 1.0, 0.0],
                    [0.0, -1.0, 0.0, -0.10791366906474821],
                ],
                [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
            ],
            &[
                [t[0][0], t[0][1], t[0][2], t[0][3] - t[0][2] * 0.11510791366906477],
                [t[1][0], t[1][1], t[1][2], t[1][3] - t[1][2] * 0.11510791366906477],
                [t[2][0], t[2][1], t[2][2], t[2][3] - t[2][2] * 0.11510791366906477],
            ],
            &[false, false, false, false, false, false],
            [72, 31, 35],
            sample.budget(),
        );
        if !joints_roots.is_regular() {
            attempt.note(joints_roots.outcome, &path, "q1, q2, q3, q4, q5, q6", 1.0, "");
        }
        let path = if joints_roots.is_free() {
            attempt.choose(0, &path, ::dh_robot::FreeJoints::of(&[0, 1, 2, 3, 4, 5]))
        } else {
            path
        };
        for (
            joints_root,
            &[[c1,
            s1,
            ],
            [c2,
            s2,
            ],
            [c3,
            s3,
            ],
            [c4,
            s4,
            ],
            [c5,
            s5,
            ],
            [c6,
            s6,
            ],
            ],
        ) in joints_roots.or_if_free([[1.0, 0.0]; 6]).iter().enumerate() {
            let path = path.root(0, joints_root);
            let q1 = ::dh_robot::runtime::atan2(s1, c1);
            let q2 = ::dh_robot::runtime::atan2(s2, c2);
            let q3 = ::dh_robot::runtime::atan2(s3, c3);
            let q4 = ::dh_robot::runtime::atan2(s4, c4);
            let q5 = ::dh_robot::runtime::atan2(s5, c5);
            let q6 = ::dh_robot::runtime::atan2(s6, c6);
            let branch = ::dh_robot::Branch::ANY.with_step(0, joints_root);
            found([q1, q2, q3, q4, q5, q6], branch, path);
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
    ) -> (::dh_robot::Solutions<f64, 6, 16>, ::dh_robot::Work) {
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
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::runtime::Kinematics<6> for Crx10ia {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::runtime::Pose {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::runtime::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * s23 + c6s5 * c23;
        let t_5 = t_2 * c23 - c6s5 * s23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = s23 * s5c4 - c5 * c23;
        let t_9 = c23 * s5c4 + c5 * s23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = s4 * 0.15;
        let t_13 = c4 * 0.15;
        let t_14 = s23 * t_12 - c23 * 0.54 - 0.54 * s2;
        [
            [
                t_6,
                -(t_5 * t_11 - t_7 * t_9),
                -t_10,
                -(c1 * t_14 - s1 * t_13 + t_10 * 0.16),
            ],
            [
                t_7,
                -(t_6 * t_9 - t_5 * t_10),
                -t_11,
                -(s1 * t_14 + c1 * t_13 + t_11 * 0.16),
            ],
            [
                t_5,
                -(t_7 * t_10 - t_6 * t_11),
                -t_9,
                -(c23 * t_12 + s23 * 0.54 - 0.54 * c2 + t_9 * 0.16),
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
        let s23s4 = s23 * s4;
        let c23s4 = c23 * s4;
        let t_2 = c1 * s23s4 - s1 * c4;
        let t_3 = s1 * s23s4 + c1 * c4;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t_4 = s23 * c4s5 - c23 * c5;
        let t_5 = c23 * c4s5 + s23 * c5;
        let t_6 = c1 * t_4 + s1 * s4s5;
        let t_7 = s1 * t_4 - c1 * s4s5;
        let t_8 = c23s4 * t_7 - t_3 * t_5;
        let t_9 = t_2 * t_5 - c23s4 * t_6;
        let t_10 = t_3 * t_6 - t_2 * t_7;
        let t_11 = s5 * 0.16;
        let t_12 = c5 * 0.16 + 0.54;
        let t_13 = c4 * t_11 + s4 * 0.15;
        let t_14 = s4 * t_11 - c4 * 0.15;
        let t_15 = s23 * t_13 - c23 * t_12;
        let t_16 = c23 * t_13 + s23 * t_12;
        let t_17 = t_15 - 0.54 * s2;
        let t_18 = t_16 - 0.54 * c2;
        let t_19 = c1 * t_17 + s1 * t_14;
        let t_20 = s1 * t_17 - c1 * t_14;
        let t_21 = s23 * t_14;
        (
            [
                [-(t_8 * c6 + t_2 * s6), -(t_2 * c6 - t_8 * s6), -t_6, -t_19],
                [-(t_9 * c6 + t_3 * s6), -(t_3 * c6 - t_9 * s6), -t_7, -t_20],
                [-(t_10 * c6 + c23s4 * s6), -(c23s4 * c6 - t_10 * s6), -t_5, -t_18],
            ],
            [
                [t_20, -c1 * t_18, -c1 * t_16, c1 * t_21 - s1 * t_13, t_8 * 0.16, 0.0],
                [-t_19, -s1 * t_18, -s1 * t_16, s1 * t_21 + c1 * t_13, t_9 * 0.16, 0.0],
                [0.0, t_17, t_15, c23 * t_14, t_10 * 0.16, 0.0],
                [0.0, -s1, -s1, c1 * c23, t_2, -t_6],
                [0.0, c1, c1, s1 * c23, t_3, -t_7],
                [1.0, 0.0, 0.0, -s23, c23s4, -t_5],
            ],
        )
    }
}
impl ::dh_robot::InverseKinematics<6, f64> for Crx10ia {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    type Solutions = ::dh_robot::Solutions<f64, 6, 16>;
    fn inverse(&self, target: &Self::Target) -> Self::Solutions {
        Crx10ia::inverse(self, target)
    }
    fn inverse_near(
        &self,
        target: &Self::Target,
        q: &[f64; 6],
    ) -> ::core::result::Result<::dh_robot::Solution<f64, 6>, ::dh_robot::Why<f64>> {
        Crx10ia::inverse_near(self, target, q)
    }
}
impl ::dh_robot::runtime::HasJoints<f64> for Crx10ia {
    type Joints = ::dh_robot::runtime::Joints<6>;
}
