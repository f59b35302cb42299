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
#[allow(clippy::all, clippy::pedantic)]
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
    /// Cost: 35 multiplications, 21 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
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
        let ([s1, s2, s23, s234, s5, s6], [c1, c2, c23, c234, c5, c6]) = ::dh_robot::sincos::sincos_batch(
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
    /// origin of the last frame (or tool).
    ///
    /// Cost: 37 multiplications, 15 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2] + q[3], q[4], q[1] + q[2], q[1]];
        let ([s1, s234, s5, s23, s2], [c1, c234, c5, c23, c2]) = ::dh_robot::sincos::sincos_batch(
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
        let ([s1, s234, s5, s6, s23, s2], [c1, c234, c5, c6, c23, c2]) = ::dh_robot::sincos::sincos_batch(
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
#[allow(clippy::all, clippy::pedantic)]
impl Ur5 {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// Plan:
    /// 1. `q1`: a cos + b sin = c: two values.
    /// 2. `q6`: a cos + b sin = 0: two values half a turn apart.
    /// 3. `q5`: two equations in its sine and cosine: one value.
    /// 4. `q2 + q3 + q4`: two equations in its sine and cosine: one value.
    /// 5. `q3`: a cos + b sin = c: two values.
    /// 6. `q2`: two equations in its sine and cosine: one value.
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::inverse::frame_of(target, 1.192809) {
            Ok(frame) => frame,
            Err(why) => return ::dh_robot::Solutions::none(&Self::JOINTS, why),
        };
        if let Some(solutions) = self.lanes(&frame) {
            return solutions;
        }
        let setting = ::dh_robot::inverse::Setting {
            joints: &Self::JOINTS,
            reach: 1.192809,
            few: false,
        };
        let task = ::dh_robot::ik::Task::Pose(
            ::dh_robot::inverse::in_units(&frame, 1.192809),
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
        let t_2 = t[0][3] - t[0][2] * 0.06899679663718164;
        let t_3 = t[1][3] - t[1][2] * 0.06899679663718164;
        let t_4 = t[2][3] - t[2][2] * 0.06899679663718164;
        let t_5 = t_4 - 0.07499859575170878;
        let r0 = ::dh_robot::ik::solve_sincos(-t_3, t_2, 0.09150668715611636, 1e-11);
        if r0.roots.is_empty() {
            attempt.note(r0.outcome, "q1", 1.192809, "m");
        }
        let free = if r0.is_free() {
            attempt.degenerate = true;
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (i0, &[c1, s1]) in r0.or_if_free([1.0, 0.0]).iter().enumerate() {
            let a0 = ::dh_robot::math::atan2(s1, c1);
            let t_6 = t_2 * c1 + t_3 * s1;
            let t_7 = t_2 * s1 - t_3 * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let r1 = ::dh_robot::ik::solve_sincos(-t_11, -t_9, 0.0, 1e-11);
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
                let t_13 = t_8 * c6 - t_10 * s6;
                let t_14 = t[2][0] * c6 - t[2][1] * s6;
                let t_15 = t_8 * s6 + t_10 * c6;
                let t_16 = (t[2][0] * s6 + t[2][1] * c6) * 0.07935050791870282;
                let t_17 = t_6 + t_15 * 0.07935050791870282;
                let t_18 = t_7 + (t_9 * s6 + t_11 * c6) * 0.07935050791870282;
                let t_19 = t_4 + t_16;
                let t_20 = t_16 + t_5;
                let t_21 = t_17 * t_17 + t_18 * t_18 + t_20 * t_20 - 0.2434638836493361;
                let r2 = ::dh_robot::ik::solve_pair(
                    0.0,
                    -1.0,
                    -(t_9 * c6 - t_11 * s6),
                    -1.0,
                    0.0,
                    -(t[0][2] * s1 - t[1][2] * c1),
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
                    let t_22 = 0.09150668715611636 * (t_14 * s5 + t[2][2] * c5);
                    let r3 = ::dh_robot::ik::solve_pair(
                        1.0,
                        0.0,
                        t_13 * c5 - t_12 * s5,
                        0.0,
                        -1.0,
                        t_15,
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
                            0.23433656705012487,
                            0.0,
                            t_21,
                            1e-11,
                        );
                        if r4.roots.is_empty() {
                            attempt.note(r4.outcome, "q3", 1.192809, "m");
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
                            let t_23 = 0.3563018052345346 + 0.32884560730175577 * c3;
                            let t_24 = 0.32884560730175577 * s3;
                            let r5 = ::dh_robot::ik::solve_many(
                                &[
                                    [
                                        -t_23,
                                        t_24,
                                        t_17 - 0.09150668715611636 * (t_13 * s5 + t_12 * c5),
                                    ],
                                    [-t_24, -t_23, -(t_22 - t_20)],
                                    [-t_24, -t_23, t_19 - t_22 - 0.07499859575170878],
                                ],
                                1e-11,
                            );
                            if r5.roots.is_empty() {
                                attempt.note(r5.outcome, "q2", 1.192809, "m");
                            }
                            let free = if r5.is_free() {
                                attempt.degenerate = true;
                                free.union(::dh_robot::FreeJoints::of(&[1]))
                            } else {
                                free
                            };
                            for (i5, &[c2, s2]) in r5
                                .or_if_free([1.0, 0.0])
                                .iter()
                                .enumerate()
                            {
                                let a5 = ::dh_robot::math::atan2(s2, c2);
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
                                found([a0, a5, a4, a3 - a4 - a5, a2, a1], branch, free);
                            }
                        }
                    }
                }
            }
        }
        attempt
    }
    /// The plan for all branches at once; `None` where the robust way has to decide.
    #[inline]
    fn lanes(
        &self,
        t: &::dh_robot::ik::Pose,
    ) -> Option<::dh_robot::Solutions<f64, 6, 8>> {
        let t_2 = t[0][3] - t[0][2] * 0.06899679663718164;
        let t_3 = t[1][3] - t[1][2] * 0.06899679663718164;
        let t_4 = t[2][3] - t[2][2] * 0.06899679663718164;
        let t_5 = t_4 - 0.07499859575170878;
        let mut m0 = [0.0; 1];
        let mut f0 = [[0.0; 2]; 2];
        let mut e0 = [0.0; 1];
        for l in 0..1 {
            let ([x, y, z, w], e, m) = ::dh_robot::lanes::sincos(
                -t_3,
                t_2,
                0.09150668715611636,
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
        let mut v46_ = [0.0; 2];
        let mut v49_ = [0.0; 2];
        let mut v52_ = [0.0; 2];
        let mut v55_ = [0.0; 2];
        let mut v58_ = [0.0; 2];
        let mut v61_ = [0.0; 2];
        let mut v64_ = [0.0; 2];
        let mut v67_ = [0.0; 2];
        let mut v261_ = [0.0; 2];
        let mut v264_ = [0.0; 2];
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
            v52_[l] = t_8;
            v55_[l] = t_9;
            v58_[l] = t_10;
            v61_[l] = t_11;
            v64_[l] = t_12;
            v67_[l] = t[0][2] * s1 - t[1][2] * c1;
            v261_[l] = t_13;
            v264_[l] = t_14;
        }
        let mut m1 = [0.0; 2];
        let mut f1 = [[0.0; 4]; 2];
        for l in 0..2 {
            let v61 = v61_[l];
            let v55 = v55_[l];
            let ([x, y], m) = ::dh_robot::lanes::half_turn(-v61, -v55);
            f1[0][l] = x;
            f1[1][l] = y;
            f1[0][l + 2] = -x;
            f1[1][l + 2] = -y;
            m1[l] = m;
        }
        let c6_ = f1[0];
        let s6_ = f1[1];
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
        let mut v92_ = [0.0; 4];
        let mut v93_ = [0.0; 4];
        let mut v94_ = [0.0; 4];
        let mut v101_ = [0.0; 4];
        let mut v108_ = [0.0; 4];
        let mut v110_ = [0.0; 4];
        let mut v179_ = [0.0; 4];
        let mut v190_ = [0.0; 4];
        for l in 0..4 {
            let v46 = v46_[l % 2];
            let v49 = v49_[l % 2];
            let v52 = v52_[l % 2];
            let v55 = v55_[l % 2];
            let v58 = v58_[l % 2];
            let v61 = v61_[l % 2];
            let c6 = c6_[l];
            let s6 = s6_[l];
            let t_15 = v52 * c6 - v58 * s6;
            let t_16 = t[2][0] * c6 - t[2][1] * s6;
            let t_17 = v52 * s6 + v58 * c6;
            let t_18 = (t[2][0] * s6 + t[2][1] * c6) * 0.07935050791870282;
            let t_19 = v46 + t_17 * 0.07935050791870282;
            let t_20 = v49 + (v55 * s6 + v61 * c6) * 0.07935050791870282;
            let t_21 = t_4 + t_18;
            let t_22 = t_18 + t_5;
            let t_23 = t_19 * t_19 + t_20 * t_20 + t_22 * t_22 - 0.2434638836493361;
            v92_[l] = t_15;
            v93_[l] = v55 * c6 - v61 * s6;
            v94_[l] = t_16;
            v101_[l] = t_17;
            v108_[l] = t_19;
            v110_[l] = t_21;
            v179_[l] = t_22;
            v190_[l] = t_23;
        }
        let mut m2 = [0.0; 4];
        let mut f2 = [[0.0; 4]; 2];
        for l in 0..4 {
            let v93 = v93_[l];
            let v67 = v67_[l % 2];
            let ([x, y], m) = ::dh_robot::lanes::pair(0.0, -1.0, -v93, -1.0, 0.0, -v67);
            f2[0][l] = x;
            f2[1][l] = y;
            m2[l] = m;
        }
        let c5_ = f2[0];
        let s5_ = f2[1];
        let g2: [f64; 4] = ::dh_robot::atan2_batch(&f2[1], &f2[0]);
        let mut v139_ = [0.0; 4];
        let mut v154_ = [0.0; 4];
        let mut v191_ = [0.0; 4];
        let mut v207_ = [0.0; 4];
        let mut v208_ = [0.0; 4];
        let mut v219_ = [0.0; 4];
        let mut v222_ = [0.0; 4];
        let mut v227_ = [0.0; 4];
        let mut v230_ = [0.0; 4];
        for l in 0..4 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let v64 = v64_[l % 2];
            let c6 = c6_[l];
            let v92 = v92_[l];
            let v94 = v94_[l];
            let v108 = v108_[l];
            let v110 = v110_[l];
            let v179 = v179_[l];
            let c5 = c5_[l];
            let s5 = s5_[l];
            let t_24 = 0.09150668715611636 * (v94 * s5 + t[2][2] * c5);
            let c6c5 = c6 * c5;
            let c6s5 = c6 * s5;
            let s1c6s5 = s1 * c6s5;
            let c1c6s5 = c1 * c6s5;
            let s1c5 = s1 * c5;
            let c1c5 = c1 * c5;
            v139_[l] = v92 * c5 - v64 * s5;
            v154_[l] = v108 - 0.09150668715611636 * (v92 * s5 + v64 * c5);
            v191_[l] = t_24 - v179;
            v207_[l] = v110 - t_24 - 0.07499859575170878;
            v208_[l] = c6c5;
            v219_[l] = s1c6s5;
            v222_[l] = c1c6s5;
            v227_[l] = s1c5;
            v230_[l] = c1c5;
        }
        let mut m3 = [0.0; 4];
        let mut f3 = [[0.0; 4]; 2];
        for l in 0..4 {
            let v139 = v139_[l];
            let v101 = v101_[l];
            let ([x, y], m) = ::dh_robot::lanes::pair(1.0, 0.0, v139, 0.0, -1.0, v101);
            f3[0][l] = x;
            f3[1][l] = y;
            m3[l] = m;
        }
        let c234_ = f3[0];
        let s234_ = f3[1];
        let g3: [f64; 4] = ::dh_robot::atan2_batch(&f3[1], &f3[0]);
        let mut v217_ = [0.0; 4];
        let mut v220_ = [0.0; 4];
        let mut v223_ = [0.0; 4];
        let mut v225_ = [0.0; 4];
        let mut v228_ = [0.0; 4];
        let mut v231_ = [0.0; 4];
        let mut v234_ = [0.0; 4];
        let mut v237_ = [0.0; 4];
        let mut v240_ = [0.0; 4];
        let mut v241_ = [0.0; 4];
        let mut v242_ = [0.0; 4];
        let mut v266_ = [0.0; 4];
        let mut v267_ = [0.0; 4];
        let mut v268_ = [0.0; 4];
        for l in 0..4 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let s6 = s6_[l];
            let s5 = s5_[l];
            let v208 = v208_[l];
            let v219 = v219_[l];
            let v222 = v222_[l];
            let v227 = v227_[l];
            let v230 = v230_[l];
            let c234 = c234_[l];
            let s234 = s234_[l];
            let t_25 = v208 * c234 - s6 * s234;
            let t_26 = v208 * s234 + s6 * c234;
            let t_27 = c1 * t_25 + v219;
            let t_28 = s1 * t_25 - v222;
            let s5c234 = s5 * c234;
            let s5s234 = s5 * s234;
            let t_29 = c1 * s5c234 - v227;
            let t_30 = s1 * s5c234 + v230;
            let t_31 = 0.07935050791870282 * s234;
            let t_32 = 0.07935050791870282 * c234;
            let t_33 = 0.06899679663718164 * t_29;
            let t_34 = 0.06899679663718164 * t_30;
            let t_35 = 0.06899679663718164 * s5s234;
            v217_[l] = t_26;
            v220_[l] = t_27;
            v223_[l] = t_28;
            v225_[l] = s5s234;
            v228_[l] = t_29;
            v231_[l] = t_30;
            v234_[l] = t_26 * t_30 - t_28 * s5s234;
            v237_[l] = t_27 * s5s234 - t_26 * t_29;
            v240_[l] = t_28 * t_29 - t_27 * t_30;
            v241_[l] = t_31;
            v242_[l] = t_32;
            v266_[l] = t_33;
            v267_[l] = t_34;
            v268_[l] = t_35;
        }
        let mut m4 = [0.0; 4];
        let mut f4 = [[0.0; 8]; 2];
        let mut e4 = [0.0; 4];
        for l in 0..4 {
            let v190 = v190_[l];
            let ([x, y, z, w], e, m) = ::dh_robot::lanes::sincos(
                0.23433656705012487,
                0.0,
                v190,
            );
            f4[0][l] = x;
            f4[1][l] = y;
            f4[0][l + 4] = z;
            f4[1][l + 4] = w;
            m4[l] = m;
            e4[l] = e;
        }
        let c3_ = f4[0];
        let s3_ = f4[1];
        let g4: [f64; 8] = ::dh_robot::atan2_batch(&f4[1], &f4[0]);
        let mut v204_ = [0.0; 8];
        let mut v206_ = [0.0; 8];
        for l in 0..8 {
            let c3 = c3_[l];
            let s3 = s3_[l];
            let t_36 = 0.3563018052345346 + 0.32884560730175577 * c3;
            let t_37 = 0.32884560730175577 * s3;
            v204_[l] = t_36;
            v206_[l] = t_37;
        }
        let mut m5 = [0.0; 8];
        let mut f5 = [[0.0; 8]; 2];
        for l in 0..8 {
            let v204 = v204_[l];
            let v206 = v206_[l];
            let v154 = v154_[l % 4];
            let v191 = v191_[l % 4];
            let v207 = v207_[l % 4];
            let ([x, y], m) = ::dh_robot::lanes::pair(
                -v204,
                v206,
                v154,
                -v206,
                -v204,
                -v191,
            );
            f5[0][l] = x;
            f5[1][l] = y;
            m5[l] = m;
        }
        let c2_ = f5[0];
        let s2_ = f5[1];
        let g5: [f64; 8] = ::dh_robot::atan2_batch(&f5[1], &f5[0]);
        let mut v269_ = [0.0; 8];
        let mut v270_ = [0.0; 8];
        let mut v271_ = [0.0; 8];
        for l in 0..8 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let c3 = c3_[l];
            let s3 = s3_[l];
            let v241 = v241_[l % 4];
            let v242 = v242_[l % 4];
            let v261 = v261_[l % 2];
            let v264 = v264_[l % 2];
            let v266 = v266_[l % 4];
            let v267 = v267_[l % 4];
            let v268 = v268_[l % 4];
            let c2 = c2_[l];
            let s2 = s2_[l];
            let t_38 = v241 - 0.32884560730175577 * (c3 * c2 - s3 * s2)
                - 0.3563018052345346 * c2;
            let t_39 = v242 + 0.32884560730175577 * (c3 * s2 + s3 * c2)
                + 0.3563018052345346 * s2;
            v269_[l] = c1 * t_38 + v261 - v266;
            v270_[l] = s1 * t_38 - v264 - v267;
            v271_[l] = 0.07499859575170878 - t_39 - v268;
        }
        let mut error = [0.0; 8];
        for l in 0..8 {
            let v220 = v220_[l % 4];
            let v223 = v223_[l % 4];
            let v217 = v217_[l % 4];
            let v234 = v234_[l % 4];
            let v237 = v237_[l % 4];
            let v240 = v240_[l % 4];
            let v228 = v228_[l % 4];
            let v231 = v231_[l % 4];
            let v225 = v225_[l % 4];
            let v269 = v269_[l];
            let v270 = v270_[l];
            let v271 = v271_[l];
            error[l] = (v220 - t[0][0]).abs() + (v223 - t[1][0]).abs()
                + (v217 - t[2][0]).abs() + (-v234 - t[0][1]).abs()
                + (-v237 - t[1][1]).abs() + (-v240 - t[2][1]).abs()
                + (-v228 - t[0][2]).abs() + (-v231 - t[1][2]).abs()
                + (-v225 - t[2][2]).abs() + (v269 - t[0][3]).abs()
                + (v270 - t[1][3]).abs() + (v271 - t[2][3]).abs();
        }
        let valid: [f64; 8] = ::core::array::from_fn(|l| {
            1.0 * e0[l % 1 % 1] * e4[l % 4 % 4]
        });
        let margin: [f64; 8] = ::core::array::from_fn(|l| {
            1.0_f64
                .min(m0[l % 1 % 1])
                .min(m1[l % 2 % 2])
                .min(m2[l % 4 % 4])
                .min(m3[l % 4 % 4])
                .min(m4[l % 4 % 4])
                .min(m5[l % 8 % 8])
        });
        let q: [[f64; 8]; 6] = [
            ::core::array::from_fn(|l| g0[l / 1 % 2 * 1 + l % 1]),
            ::core::array::from_fn(|l| g5[l % 8]),
            ::core::array::from_fn(|l| g4[l / 4 % 2 * 4 + l % 4]),
            ::core::array::from_fn(|l| ::dh_robot::lanes::wrap(
                g3[l % 4] - g4[l / 4 % 2 * 4 + l % 4] - g5[l % 8],
            )),
            ::core::array::from_fn(|l| g2[l % 4]),
            ::core::array::from_fn(|l| g1[l / 2 % 2 * 2 + l % 2]),
        ];
        ::dh_robot::lanes::collect(
            &Self::JOINTS,
            &valid,
            &margin,
            &error,
            &q,
            |l| {
                let i0 = l / 1 % 2;
                let i1 = l / 2 % 2;
                let i4 = l / 4 % 2;
                ::dh_robot::Branch::ANY
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
                    )
            },
        )
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl ::dh_robot::ik::Kinematics<6> for Ur5 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::ik::Pose {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
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
    ) -> (::dh_robot::ik::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1] + q[2] + q[3], q[4], q[5], q[1] + q[2], q[1]];
        let ([s1, s234, s5, s6, s23, s2], [c1, c234, c5, c6, c23, c2]) = ::dh_robot::sincos::sincos_batch(
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
