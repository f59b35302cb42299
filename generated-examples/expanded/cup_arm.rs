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
/// `tool = tz(206mm);`
///
/// Pose of the tool in the base, rotation and translation:
///
/// ```text
/// r₁₁ = c₁[c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆] + s₁(s₄c₅c₆ + c₄s₆)
/// r₂₁ = s₁[c₂₃(c₄c₅c₆ − s₄s₆) − s₂₃s₅c₆] − c₁(s₄c₅c₆ + c₄s₆)
/// r₃₁ = −s₂₃(c₄c₅c₆ − s₄s₆) − c₂₃s₅c₆
/// r₁₂ = −c₁[c₂₃(c₄c₅s₆ + s₄c₆) − s₂₃s₅s₆] − s₁(s₄c₅s₆ − c₄c₆)
/// r₂₂ = −s₁[c₂₃(c₄c₅s₆ + s₄c₆) − s₂₃s₅s₆] + c₁(s₄c₅s₆ − c₄c₆)
/// r₃₂ = s₂₃(c₄c₅s₆ + s₄c₆) + c₂₃s₅s₆
/// r₁₃ = −c₁(c₂₃c₄s₅ + s₂₃c₅) − s₁s₄s₅
/// r₂₃ = −s₁(c₂₃c₄s₅ + s₂₃c₅) + c₁s₄s₅
/// r₃₃ = s₂₃c₄s₅ − c₂₃c₅
/// px  = −c₁[a₁ − a₂c₂ + c₂₃(a₃ + tz·c₄s₅) + s₂₃(d₄ + tz·c₅)] − tz·s₁s₄s₅
/// py  = −s₁[a₁ − a₂c₂ + c₂₃(a₃ + tz·c₄s₅) + s₂₃(d₄ + tz·c₅)] + tz·c₁s₄s₅
/// pz  = bz − a₂s₂ + s₂₃(a₃ + tz·c₄s₅) − c₂₃(d₄ + tz·c₅)
///
/// where cᵢ = cos qᵢ, sᵢ = sin qᵢ, i = 1, 2, 4, 5, 6; c₂₃ = cos(q₂ + q₃), s₂₃ = sin(q₂ + q₃),
///      a₁ = 30, a₂ = 340, a₃ = 40, d₄ = 338, bz = 373, tz = 206
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
    /// Cost: 41 multiplications, 23 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * c23 - c6s5 * s23;
        let t_5 = t_2 * s23 + c6s5 * c23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = c23 * s5c4 + c5 * s23;
        let t_9 = s23 * s5c4 - c5 * c23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = 30.0 + c23 * 40.0 + s23 * 338.0 - 340.0 * c2;
        let t_13 = s23 * 40.0 - c23 * 338.0 - 340.0 * s2 + 373.0 + t_9 * 206.0;
        ::dh_robot::pose::from_entries(
            [
                [t_6, t_5 * t_11 - t_7 * t_9, -t_10],
                [t_7, t_6 * t_9 - t_5 * t_10, -t_11],
                [-t_5, -(t_7 * t_10 - t_6 * t_11), t_9],
            ],
            [-(c1 * t_12 + t_10 * 206.0), -(s1 * t_12 + t_11 * 206.0), t_13],
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
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
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
    /// origin of the last frame (or tool).
    ///
    /// Cost: 50 multiplications, 20 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::sincos::sincos_batch(
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
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::sincos::sincos_batch(
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
                    [t_6 * c6 + t_4 * s6, t_4 * c6 - t_6 * s6, -t_9],
                    [t_7 * c6 - t_5 * s6, -(t_5 * c6 + t_7 * s6), -t_10],
                    [-(t_8 * c6 - s23s4 * s6), s23s4 * c6 + t_8 * s6, -t_11],
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
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl CupArm {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 8;
    /// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.
    ///
    /// Plan:
    /// 1. `q1`: a cos + b sin = 0: two values half a turn apart.
    /// 2. `q3`: a cos + b sin = c: two values.
    /// 3. `q2`: two equations in its sine and cosine: one value.
    /// 4. `q4`: a cos + b sin = 0: two values half a turn apart.
    /// 5. `q5`: two equations in its sine and cosine: one value.
    /// 6. `q6`: two equations in its sine and cosine: one value.
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 6, 8> {
        let frame = match ::dh_robot::inverse::frame_of(target, 954.0) {
            Ok(frame) => frame,
            Err(why) => return ::dh_robot::Solutions::none(&Self::JOINTS, why),
        };
        let mut solutions = ::dh_robot::Solutions::new(&Self::JOINTS);
        if self.lanes(&frame, &mut solutions) {
            return solutions;
        }
        let setting = ::dh_robot::inverse::Setting {
            joints: &Self::JOINTS,
            reach: 954.0,
            few: false,
            given: None,
        };
        let task = ::dh_robot::ik::Task::Pose(
            ::dh_robot::inverse::in_units(&frame, 954.0),
        );
        ::dh_robot::inverse::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::ik::Pose,
        pick: ::dh_robot::inverse::Pick,
        found: &mut dyn FnMut([f64; 6], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::inverse::Attempt {
        let mut attempt = ::dh_robot::inverse::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = t[0][3] - t[0][2] * 0.2159329140461216;
        let t_3 = t[1][3] - t[1][2] * 0.2159329140461216;
        let t_4 = t[2][3] - t[2][2] * 0.2159329140461216 - 0.39098532494758914;
        let t_5 = t_4 * t_4;
        let r0 = ::dh_robot::ik::solve_sincos(-t_3, t_2, 0.0, 1e-11);
        if r0.roots.is_empty() {
            attempt.note(r0.outcome, free, "shoulder q1", 954.0, "mm");
        }
        let free = if r0.is_free() {
            attempt.degenerate = true;
            free.union(::dh_robot::FreeJoints::of(&[0]))
        } else {
            free
        };
        for (i0, &[c1, s1]) in r0.or_if_free(pick.angle(0)).iter().enumerate() {
            let a0 = ::dh_robot::math::atan2(s1, c1);
            let t_6 = t_2 * c1 + t_3 * s1;
            let t_7 = t_2 * s1 - t_3 * c1;
            let t_8 = t[0][0] * c1 + t[1][0] * s1;
            let t_9 = t[0][0] * s1 - t[1][0] * c1;
            let t_10 = t[0][1] * c1 + t[1][1] * s1;
            let t_11 = t[0][1] * s1 - t[1][1] * c1;
            let t_12 = t[0][2] * c1 + t[1][2] * s1;
            let t_13 = t[0][2] * s1 - t[1][2] * c1;
            let t_14 = 0.031446540880503145 * (0.031446540880503145 + t_6 * 2.0);
            let t_15 = t_6 + 0.031446540880503145;
            let r1 = ::dh_robot::ik::solve_sincos(
                -0.02988630020788559,
                -0.2525392367566332,
                t_14 + t_5 + t_6 * t_6 + t_7 * t_7 - 0.25430164946006883,
                1e-11,
            );
            if r1.roots.is_empty() {
                attempt
                    .note_distance(
                        r1.outcome,
                        free,
                        "elbow q3",
                        t_5 + t_6 * t_6 + t_7 * t_7,
                        t_14 + t_5 + t_6 * t_6 + t_7 * t_7 - 0.25430164946006883,
                        954.0,
                        "mm",
                    );
            }
            let free = if r1.is_free() {
                attempt.degenerate = true;
                free.union(::dh_robot::FreeJoints::of(&[2]))
            } else {
                free
            };
            for (i1, &[c3, s3]) in r1.or_if_free(pick.angle(1)).iter().enumerate() {
                let a1 = ::dh_robot::math::atan2(s3, c3);
                let t_16 = 0.35639412997903563 - 0.041928721174004195 * c3
                    - 0.35429769392033544 * s3;
                let r2 = ::dh_robot::ik::solve_pair(
                    -t_15,
                    t_4,
                    -t_16,
                    t_4,
                    t_15,
                    -(c3 * 0.35429769392033544 - 0.041928721174004195 * s3),
                    1e-11,
                );
                if r2.roots.is_empty() {
                    attempt.note(r2.outcome, free, "q2", 954.0, "mm");
                }
                let free = if r2.is_free() {
                    attempt.degenerate = true;
                    free.union(::dh_robot::FreeJoints::of(&[1]))
                } else {
                    free
                };
                for (i2, &[c2, s2]) in r2.or_if_free(pick.angle(2)).iter().enumerate() {
                    let a2 = ::dh_robot::math::atan2(s2, c2);
                    let t_17 = c3 * c2 - s3 * s2;
                    let t_18 = c3 * s2 + s3 * c2;
                    let t_19 = t_8 * t_17 - t[2][0] * t_18;
                    let t_20 = t_8 * t_18 + t[2][0] * t_17;
                    let t_21 = t_10 * t_17 - t[2][1] * t_18;
                    let t_22 = t_10 * t_18 + t[2][1] * t_17;
                    let t_23 = t_12 * t_17 - t[2][2] * t_18;
                    let r3 = ::dh_robot::ik::solve_sincos(-t_13, t_23, 0.0, 1e-11);
                    if r3.roots.is_empty() {
                        attempt.note(r3.outcome, free, "wrist q4", 1.0, "");
                    }
                    let free = if r3.is_free() {
                        attempt.degenerate = true;
                        free.union(::dh_robot::FreeJoints::of(&[3]))
                    } else {
                        free
                    };
                    for (i3, &[c4, s4]) in r3
                        .or_if_free(pick.angle(3))
                        .iter()
                        .enumerate()
                    {
                        let a3 = ::dh_robot::math::atan2(s4, c4);
                        let t_24 = t_19 * c4 + t_9 * s4;
                        let t_25 = t_21 * c4 + t_11 * s4;
                        let r4 = ::dh_robot::ik::solve_pair(
                            0.0,
                            -1.0,
                            t_23 * c4 + t_13 * s4,
                            1.0,
                            0.0,
                            -(t_12 * t_18 + t[2][2] * t_17),
                            1e-11,
                        );
                        if r4.roots.is_empty() {
                            attempt.note(r4.outcome, free, "q5", 1.0, "");
                        }
                        let free = if r4.is_free() {
                            attempt.degenerate = true;
                            free.union(::dh_robot::FreeJoints::of(&[4]))
                        } else {
                            free
                        };
                        for (i4, &[c5, s5]) in r4
                            .or_if_free(pick.angle(4))
                            .iter()
                            .enumerate()
                        {
                            let a4 = ::dh_robot::math::atan2(s5, c5);
                            let r5 = ::dh_robot::ik::solve_pair(
                                1.0,
                                0.0,
                                t_24 * c5 - t_20 * s5,
                                0.0,
                                -1.0,
                                t_25 * c5 - t_22 * s5,
                                1e-11,
                            );
                            if r5.roots.is_empty() {
                                attempt.note(r5.outcome, free, "q6", 1.0, "");
                            }
                            let free = if r5.is_free() {
                                attempt.degenerate = true;
                                free.union(::dh_robot::FreeJoints::of(&[5]))
                            } else {
                                free
                            };
                            for (i5, &[c6, s6]) in r5
                                .or_if_free(pick.angle(5))
                                .iter()
                                .enumerate()
                            {
                                let a5 = ::dh_robot::math::atan2(s6, c6);
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
                                    .with_elbow(
                                        if i1 == 0 {
                                            ::dh_robot::Elbow::Up
                                        } else {
                                            ::dh_robot::Elbow::Down
                                        },
                                    )
                                    .with_step(2, i3)
                                    .with_wrist(
                                        if i3 == 0 {
                                            ::dh_robot::Wrist::NoFlip
                                        } else {
                                            ::dh_robot::Wrist::Flip
                                        },
                                    );
                                found([a0, a2, a1, a3, a4, a5], branch, free);
                            }
                        }
                    }
                }
            }
        }
        attempt
    }
    /// The plan for all branches at once; false where the robust way has to decide.
    #[inline]
    fn lanes(
        &self,
        t: &::dh_robot::ik::Pose,
        solutions: &mut ::dh_robot::Solutions<f64, 6, 8>,
    ) -> bool {
        let t_2 = t[0][3] - t[0][2] * 0.2159329140461216;
        let t_3 = t[1][3] - t[1][2] * 0.2159329140461216;
        let t_4 = t[2][3] - t[2][2] * 0.2159329140461216 - 0.39098532494758914;
        let t_5 = t_4 * t_4;
        let mut f0 = [[0.0; 2]; 2];
        let mut m0 = [0.0; 1];
        for l in 0..1 {
            let ([x, y], m) = ::dh_robot::lanes::half_turn(-t_3, t_2);
            f0[0][l] = x;
            f0[1][l] = y;
            f0[0][l + 1] = -x;
            f0[1][l + 1] = -y;
            m0[l] = m;
        }
        let c1_ = f0[0];
        let s1_ = f0[1];
        let half: [f64; 1] = ::dh_robot::atan2_batch(
            &::core::array::from_fn(|l| f0[1][l]),
            &::core::array::from_fn(|l| f0[0][l]),
        );
        let g0: [f64; 2] = ::core::array::from_fn(|k| {
            if k < 1 {
                half[k]
            } else if half[k - 1] > 0.0 {
                half[k - 1] - ::core::f64::consts::PI
            } else {
                half[k - 1] + ::core::f64::consts::PI
            }
        });
        let mut v53_ = [0.0; 2];
        let mut v56_ = [0.0; 2];
        let mut v59_ = [0.0; 2];
        let mut v62_ = [0.0; 2];
        let mut v65_ = [0.0; 2];
        let mut v68_ = [0.0; 2];
        let mut v94_ = [0.0; 2];
        let mut v95_ = [0.0; 2];
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
            let t_13 = t[0][2] * s1 - t[1][2] * c1;
            let t_14 = 0.031446540880503145 * (0.031446540880503145 + t_6 * 2.0);
            let t_15 = t_6 + 0.031446540880503145;
            v53_[l] = t_8;
            v56_[l] = t_9;
            v59_[l] = t_10;
            v62_[l] = t_11;
            v65_[l] = t_12;
            v68_[l] = t_13;
            v94_[l] = t_14 + t_5 + t_6 * t_6 + t_7 * t_7 - 0.25430164946006883;
            v95_[l] = t_15;
        }
        let mut f1 = [[0.0; 4]; 2];
        let mut m1 = [0.0; 2];
        let mut e1 = [0.0; 2];
        for l in 0..2 {
            let v94 = v94_[l];
            let ([x, y, z, w], e, m) = ::dh_robot::lanes::sincos(
                -0.02988630020788559,
                -0.2525392367566332,
                v94,
            );
            f1[0][l] = x;
            f1[1][l] = y;
            f1[0][l + 2] = z;
            f1[1][l + 2] = w;
            m1[l] = m;
            e1[l] = e;
        }
        let c3_ = f1[0];
        let s3_ = f1[1];
        let g1: [f64; 4] = ::dh_robot::atan2_batch(&f1[1], &f1[0]);
        let mut v104_ = [0.0; 4];
        let mut v107_ = [0.0; 4];
        for l in 0..4 {
            let c3 = c3_[l];
            let s3 = s3_[l];
            let t_16 = 0.35639412997903563 - 0.041928721174004195 * c3
                - 0.35429769392033544 * s3;
            v104_[l] = t_16;
            v107_[l] = c3 * 0.35429769392033544 - 0.041928721174004195 * s3;
        }
        let mut f2 = [[0.0; 4]; 2];
        let mut m2 = [0.0; 4];
        for l in 0..4 {
            let v95 = v95_[l % 2];
            let v104 = v104_[l];
            let v107 = v107_[l];
            let ([x, y], m) = ::dh_robot::lanes::pair(-v95, t_4, -v104, t_4, v95, -v107);
            f2[0][l] = x;
            f2[1][l] = y;
            m2[l] = m;
        }
        let c2_ = f2[0];
        let s2_ = f2[1];
        let g2: [f64; 4] = ::dh_robot::atan2_batch(&f2[1], &f2[0]);
        let mut v125_ = [0.0; 4];
        let mut v128_ = [0.0; 4];
        let mut v131_ = [0.0; 4];
        let mut v134_ = [0.0; 4];
        let mut v137_ = [0.0; 4];
        let mut v140_ = [0.0; 4];
        let mut v143_ = [0.0; 4];
        let mut v146_ = [0.0; 4];
        let mut v305_ = [0.0; 4];
        let mut v306_ = [0.0; 4];
        let mut v307_ = [0.0; 4];
        for l in 0..4 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let v53 = v53_[l % 2];
            let v59 = v59_[l % 2];
            let v65 = v65_[l % 2];
            let c3 = c3_[l];
            let s3 = s3_[l];
            let c2 = c2_[l];
            let s2 = s2_[l];
            let t_17 = c3 * c2 - s3 * s2;
            let t_18 = c3 * s2 + s3 * c2;
            let t_19 = v53 * t_17 - t[2][0] * t_18;
            let t_20 = v53 * t_18 + t[2][0] * t_17;
            let t_21 = v59 * t_17 - t[2][1] * t_18;
            let t_22 = v59 * t_18 + t[2][1] * t_17;
            let t_23 = v65 * t_17 - t[2][2] * t_18;
            let t_24 = 0.041928721174004195 * t_17 + 0.35429769392033544 * t_18
                - 0.35639412997903563 * c2;
            let t_25 = 0.041928721174004195 * t_18 - 0.35429769392033544 * t_17
                - 0.35639412997903563 * s2;
            let t_26 = 0.031446540880503145 + t_24;
            let t_27 = c1 * t_26;
            let t_28 = s1 * t_26;
            let t_29 = 0.39098532494758914 + t_25;
            v125_[l] = t_17;
            v128_[l] = t_18;
            v131_[l] = t_19;
            v134_[l] = t_20;
            v137_[l] = t_21;
            v140_[l] = t_22;
            v143_[l] = t_23;
            v146_[l] = v65 * t_18 + t[2][2] * t_17;
            v305_[l] = t_27;
            v306_[l] = t_28;
            v307_[l] = t_29;
        }
        let mut f3 = [[0.0; 8]; 2];
        let mut m3 = [0.0; 4];
        for l in 0..4 {
            let v68 = v68_[l % 2];
            let v143 = v143_[l];
            let ([x, y], m) = ::dh_robot::lanes::half_turn(-v68, v143);
            f3[0][l] = x;
            f3[1][l] = y;
            f3[0][l + 4] = -x;
            f3[1][l + 4] = -y;
            m3[l] = m;
        }
        let c4_ = f3[0];
        let s4_ = f3[1];
        let half: [f64; 4] = ::dh_robot::atan2_batch(
            &::core::array::from_fn(|l| f3[1][l]),
            &::core::array::from_fn(|l| f3[0][l]),
        );
        let g3: [f64; 8] = ::core::array::from_fn(|k| {
            if k < 4 {
                half[k]
            } else if half[k - 4] > 0.0 {
                half[k - 4] - ::core::f64::consts::PI
            } else {
                half[k - 4] + ::core::f64::consts::PI
            }
        });
        let mut v174_ = [0.0; 8];
        let mut v180_ = [0.0; 8];
        let mut v186_ = [0.0; 8];
        for l in 0..8 {
            let v56 = v56_[l % 2];
            let v62 = v62_[l % 2];
            let v68 = v68_[l % 2];
            let v131 = v131_[l % 4];
            let v137 = v137_[l % 4];
            let v143 = v143_[l % 4];
            let c4 = c4_[l];
            let s4 = s4_[l];
            let t_30 = v131 * c4 + v56 * s4;
            let t_31 = v137 * c4 + v62 * s4;
            v174_[l] = t_30;
            v180_[l] = t_31;
            v186_[l] = v143 * c4 + v68 * s4;
        }
        let mut f4 = [[0.0; 8]; 2];
        for l in 0..8 {
            let v186 = v186_[l];
            let v146 = v146_[l % 4];
            let [x, y] = ::dh_robot::lanes::unit(-v146, -v186);
            f4[0][l] = x;
            f4[1][l] = y;
        }
        let c5_ = f4[0];
        let s5_ = f4[1];
        let g4: [f64; 8] = ::dh_robot::atan2_batch(&f4[1], &f4[0]);
        let mut v217_ = [0.0; 8];
        let mut v223_ = [0.0; 8];
        let mut v278_ = [0.0; 8];
        let mut v281_ = [0.0; 8];
        let mut v284_ = [0.0; 8];
        let mut v311_ = [0.0; 8];
        let mut v312_ = [0.0; 8];
        let mut v313_ = [0.0; 8];
        for l in 0..8 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let v125 = v125_[l % 4];
            let v128 = v128_[l % 4];
            let v134 = v134_[l % 4];
            let v140 = v140_[l % 4];
            let c4 = c4_[l];
            let s4 = s4_[l];
            let v174 = v174_[l];
            let v180 = v180_[l];
            let v305 = v305_[l % 4];
            let v306 = v306_[l % 4];
            let v307 = v307_[l % 4];
            let c5 = c5_[l];
            let s5 = s5_[l];
            let c4s5 = c4 * s5;
            let s4s5 = s4 * s5;
            let t_32 = v125 * c4s5 + v128 * c5;
            let t_33 = v128 * c4s5 - v125 * c5;
            let t_34 = c1 * t_32 + s1 * s4s5;
            let t_35 = s1 * t_32 - c1 * s4s5;
            v217_[l] = v174 * c5 - v134 * s5;
            v223_[l] = v180 * c5 - v140 * s5;
            v278_[l] = t_33;
            v281_[l] = t_34;
            v284_[l] = t_35;
            v311_[l] = v305 + 0.2159329140461216 * t_34;
            v312_[l] = v306 + 0.2159329140461216 * t_35;
            v313_[l] = v307 + 0.2159329140461216 * t_33;
        }
        let mut f5 = [[0.0; 8]; 2];
        for l in 0..8 {
            let v217 = v217_[l];
            let v223 = v223_[l];
            let [x, y] = ::dh_robot::lanes::unit(v217, -v223);
            f5[0][l] = x;
            f5[1][l] = y;
        }
        let c6_ = f5[0];
        let s6_ = f5[1];
        let g5: [f64; 8] = ::dh_robot::atan2_batch(&f5[1], &f5[0]);
        let mut v264_ = [0.0; 8];
        let mut v267_ = [0.0; 8];
        let mut v270_ = [0.0; 8];
        for l in 0..8 {
            let c1 = c1_[l % 2];
            let s1 = s1_[l % 2];
            let v125 = v125_[l % 4];
            let v128 = v128_[l % 4];
            let c4 = c4_[l];
            let s4 = s4_[l];
            let c5 = c5_[l];
            let s5 = s5_[l];
            let c6 = c6_[l];
            let s6 = s6_[l];
            let c5c6 = c5 * c6;
            let s5c6 = s5 * c6;
            let t_36 = c4 * c5c6 - s4 * s6;
            let t_37 = s4 * c5c6 + c4 * s6;
            let t_38 = v125 * t_36 - v128 * s5c6;
            v264_[l] = v128 * t_36 + v125 * s5c6;
            v267_[l] = c1 * t_38 + s1 * t_37;
            v270_[l] = s1 * t_38 - c1 * t_37;
        }
        let mut error = [0.0; 8];
        for l in 0..8 {
            let v267 = v267_[l];
            let v270 = v270_[l];
            let v264 = v264_[l];
            let v281 = v281_[l];
            let v284 = v284_[l];
            let v278 = v278_[l];
            let v311 = v311_[l];
            let v312 = v312_[l];
            let v313 = v313_[l];
            error[l] = (v267 - t[0][0]).abs() + (v270 - t[1][0]).abs()
                + (-v264 - t[2][0]).abs() + (-v281 - t[0][2]).abs()
                + (-v284 - t[1][2]).abs() + (v278 - t[2][2]).abs()
                + (-v311 - t[0][3]).abs() + (-v312 - t[1][3]).abs()
                + (v313 - t[2][3]).abs();
        }
        let valid: [f64; 8] = ::core::array::from_fn(|l| 1.0 * e1[l % 2 % 2]);
        let margin: [f64; 8] = ::core::array::from_fn(|l| {
            1.0_f64
                .min(m0[l % 1 % 1])
                .min(m1[l % 2 % 2])
                .min(m2[l % 4 % 4])
                .min(m3[l % 4 % 4])
        });
        let q: [[f64; 8]; 6] = [
            ::core::array::from_fn(|l| g0[l / 1 % 2 * 1 + l % 1]),
            ::core::array::from_fn(|l| g2[l % 4]),
            ::core::array::from_fn(|l| g1[l / 2 % 2 * 2 + l % 2]),
            ::core::array::from_fn(|l| g3[l / 4 % 2 * 4 + l % 4]),
            ::core::array::from_fn(|l| g4[l % 8]),
            ::core::array::from_fn(|l| g5[l % 8]),
        ];
        const BRANCHES: [::dh_robot::Branch; 8] = {
            let mut all = [::dh_robot::Branch::ANY; 8];
            let mut l = 0;
            while l < 8 {
                let i0 = l / 1 % 2;
                let i1 = l / 2 % 2;
                let i3 = l / 4 % 2;
                all[l] = ::dh_robot::Branch::ANY
                    .with_step(0, i0)
                    .with_shoulder(
                        if i0 == 0 {
                            ::dh_robot::Shoulder::Left
                        } else {
                            ::dh_robot::Shoulder::Right
                        },
                    )
                    .with_step(1, i1)
                    .with_elbow(
                        if i1 == 0 {
                            ::dh_robot::Elbow::Up
                        } else {
                            ::dh_robot::Elbow::Down
                        },
                    )
                    .with_step(2, i3)
                    .with_wrist(
                        if i3 == 0 {
                            ::dh_robot::Wrist::NoFlip
                        } else {
                            ::dh_robot::Wrist::Flip
                        },
                    );
                l += 1;
            }
            all
        };
        ::dh_robot::lanes::collect(&valid, &margin, &error, &q, &BRANCHES, solutions)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::ik::Kinematics<6> for CupArm {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::ik::Pose {
        let angles = [q[5], q[4], q[3], q[1] + q[2], q[0], q[1]];
        let ([s6, s5, s4, s23, s1, s2], [c6, c5, c4, c23, c1, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * c4 - s6 * s4;
        let t_3 = c6c5 * s4 + s6 * c4;
        let t_4 = t_2 * c23 - c6s5 * s23;
        let t_5 = t_2 * s23 + c6s5 * c23;
        let t_6 = t_4 * c1 + t_3 * s1;
        let t_7 = t_4 * s1 - t_3 * c1;
        let s5c4 = s5 * c4;
        let s5s4 = s5 * s4;
        let t_8 = c23 * s5c4 + c5 * s23;
        let t_9 = s23 * s5c4 - c5 * c23;
        let t_10 = c1 * t_8 + s1 * s5s4;
        let t_11 = s1 * t_8 - c1 * s5s4;
        let t_12 = 30.0 + c23 * 40.0 + s23 * 338.0 - 340.0 * c2;
        let t_13 = s23 * 40.0 - c23 * 338.0 - 340.0 * s2 + 373.0 + t_9 * 206.0;
        [
            [t_6, t_5 * t_11 - t_7 * t_9, -t_10, -(c1 * t_12 + t_10 * 206.0)],
            [t_7, t_6 * t_9 - t_5 * t_10, -t_11, -(s1 * t_12 + t_11 * 206.0)],
            [-t_5, -(t_7 * t_10 - t_6 * t_11), t_9, t_13],
        ]
    }
    fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (::dh_robot::ik::Pose, [[f64; 6]; 6]) {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[5], q[1]];
        let ([s1, s23, s4, s5, s6, s2], [c1, c23, c4, c5, c6, c2]) = ::dh_robot::sincos::sincos_batch(
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
                [t_6 * c6 + t_4 * s6, t_4 * c6 - t_6 * s6, -t_9, -t_21],
                [t_7 * c6 - t_5 * s6, -(t_5 * c6 + t_7 * s6), -t_10, -t_22],
                [-(t_8 * c6 - s23s4 * s6), s23s4 * c6 + t_8 * s6, -t_11, t_19 + 373.0],
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
impl ::dh_robot::InverseKinematics<6, 8, f64> for CupArm {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 6, 8> {
        CupArm::inverse(self, target)
    }
}
