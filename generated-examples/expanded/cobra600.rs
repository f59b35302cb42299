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
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Cobra600 {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 2;
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
        let frame = match ::dh_robot::runtime::frame_of(target, 0.987) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 2]; 4];
        let mut valid = [0.0; 2];
        if !self.lanes(&frame, &mut q, &mut valid) {
            return self.robust(target);
        }
        if valid == [1.0; 2] {
            let at = |l: usize| ::dh_robot::runtime::lanes::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                l,
            );
            return ::dh_robot::Solutions::full(&Self::JOINTS, [at(0), at(1)]);
        }
        ::dh_robot::runtime::lanes::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        pick: ::dh_robot::runtime::Pick,
        found: &mut dyn FnMut([f64; 4], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
        let t_3 = t_2 - 0.3397962776479236;
        let q3_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            -1.0,
            -(t[2][3] - 0.39209726443769),
            1e-11,
        );
        if !q3_roots.is_regular() {
            attempt.note(q3_roots.outcome, free, "q3", 0.987, "m");
        }
        let free = if q3_roots.is_free() {
            free.union(::dh_robot::FreeJoints::of(&[2]))
        } else {
            free
        };
        for (q3_root, &q3_scaled) in q3_roots
            .or_if_free(pick.length(0))
            .iter()
            .enumerate()
        {
            let q3 = q3_scaled * 0.987;
            let t_4 = q3_scaled * (0.78419452887538 - q3_scaled);
            let q1_plus_q2_minus_q4_roots = ::dh_robot::runtime::solve_pair(
                1.0,
                0.0,
                t[0][0],
                0.0,
                1.0,
                t[0][1],
                1e-11,
            );
            if !q1_plus_q2_minus_q4_roots.is_regular() {
                attempt
                    .note(
                        q1_plus_q2_minus_q4_roots.outcome,
                        free,
                        "q1 + q2 - q4",
                        1.0,
                        "",
                    );
            }
            let free = if q1_plus_q2_minus_q4_roots.is_free() {
                free.union(::dh_robot::FreeJoints::of(&[0, 1, 3]))
            } else {
                free
            };
            for (q1_plus_q2_minus_q4_root, &[c12m4, s12m4]) in q1_plus_q2_minus_q4_roots
                .or_if_free(pick.angle(1))
                .iter()
                .enumerate()
            {
                let q1_plus_q2_minus_q4 = ::dh_robot::runtime::atan2(s12m4, c12m4);
                let q2_roots = ::dh_robot::runtime::solve_sincos(
                    0.18348972303573616,
                    0.0,
                    t_4 + t_3,
                    1e-11,
                );
                if !q2_roots.is_regular() {
                    attempt
                        .note_law(
                            q2_roots.outcome,
                            free,
                            "elbow q2",
                            [-(t_4 - 0.3397962776479236), t_4 + t_3],
                            false,
                            0.987,
                            "m",
                        );
                }
                let free = if q2_roots.is_free() {
                    free.union(::dh_robot::FreeJoints::of(&[1]))
                } else {
                    free
                };
                for (q2_root, &[c2, s2]) in q2_roots
                    .or_if_free(pick.angle(2))
                    .iter()
                    .enumerate()
                {
                    let q2 = ::dh_robot::runtime::atan2(s2, c2);
                    let t_5 = 0.32928064842958465 + 0.27862208713272546 * c2;
                    let t_6 = 0.27862208713272546 * s2;
                    let q1_roots = ::dh_robot::runtime::solve_pair(
                        t_5,
                        -t_6,
                        t[0][3],
                        t_6,
                        t_5,
                        t[1][3],
                        1e-11,
                    );
                    if !q1_roots.is_regular() {
                        attempt.note(q1_roots.outcome, free, "q1", 1.0, "");
                    }
                    let free = if q1_roots.is_free() {
                        free.union(::dh_robot::FreeJoints::of(&[0]))
                    } else {
                        free
                    };
                    for (q1_root, &[c1, s1]) in q1_roots
                        .or_if_free(pick.angle(3))
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
                            free,
                        );
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
    ) -> ::dh_robot::Solutions<f64, 4, 2> {
        let frame = match ::dh_robot::runtime::frame_of(target, 0.987) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 0.987,
            few: true,
            given: [::core::option::Option::None; 4],
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 0.987),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    const BRANCHES: [::dh_robot::Branch; 2] = {
        let mut all = [::dh_robot::Branch::ANY; 2];
        let mut l = 0;
        while l < 2 {
            let q2_root = l / 1 % 2;
            all[l] = ::dh_robot::Branch::ANY
                .with_step(0, q2_root)
                .with_elbow(
                    if q2_root == 0 {
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
        q: &mut [[f64; 2]; 4],
        valid: &mut [f64; 2],
    ) -> bool {
        let t_2 = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
        let t_3 = t_2 - 0.3397962776479236;
        let r0 = (0.0 - t[2][1]).abs() + (0.0 - t[0][2]).abs() + (0.0 - t[1][2]).abs()
            + (-1.0 - t[2][2]).abs();
        let (q3_scaled, m0) = ::dh_robot::runtime::lanes::linear(
            -1.0,
            -(t[2][3] - 0.39209726443769),
        );
        let q3_scaled = q3_scaled;
        let g0 = q3_scaled * 0.987;
        let r1 = (0.39209726443769 - q3_scaled - t[2][3]).abs();
        let [c12m4, s12m4] = ::dh_robot::runtime::lanes::unit(t[0][0], t[0][1]);
        let g1 = ::dh_robot::runtime::lanes::angle(s12m4, c12m4);
        let r2 = (s12m4 - t[0][1]).abs() + (-c12m4 - t[1][1]).abs();
        let ([x2, y2, z2, w2], e2, m2) = ::dh_robot::runtime::lanes::sincos(
            0.18348972303573616,
            0.0,
            q3_scaled * (0.78419452887538 - q3_scaled) + t_3,
        );
        let c2_ = [x2, z2];
        let s2_ = [y2, w2];
        let g2_ = ::dh_robot::runtime::lanes::angles(&[y2, w2], &[x2, z2]);
        let g2_: [f64; 2] = ::core::array::from_fn(|l| g2_[l / 1 % 2]);
        let mut margin_ = [0.0; 2];
        let mut valid_ = [0.0; 2];
        let mut error_ = [0.0; 2];
        for l in 0..2 {
            let c2 = c2_[l];
            let s2 = s2_[l];
            let t_4 = 0.32928064842958465 + 0.27862208713272546 * c2;
            let t_5 = 0.27862208713272546 * s2;
            let ([c1, s1], m3) = ::dh_robot::runtime::lanes::pair(
                t_4,
                -t_5,
                t[0][3],
                t_5,
                t_4,
                t[1][3],
            );
            let g3 = ::dh_robot::runtime::lanes::angle(s1, c1);
            let t_6 = 0.27862208713272546 * (c2 * c1 - s2 * s1)
                + 0.32928064842958465 * c1;
            let t_7 = 0.27862208713272546 * (c2 * s1 + s2 * c1)
                + 0.32928064842958465 * s1;
            let r4 = (t_6 - t[0][3]).abs() + (t_7 - t[1][3]).abs();
            let g2 = g2_[l];
            margin_[l] = ::dh_robot::runtime::lanes::lesser(
                ::dh_robot::runtime::lanes::lesser(m0, m2),
                m3,
            );
            valid_[l] = e2;
            error_[l] = r0 + r1 + r2 + r4;
            q[0][l] = g3;
            q[1][l] = g2;
            q[2][l] = g0;
            q[3][l] = ::dh_robot::runtime::lanes::wrap(-g1 + g2 + g3);
        }
        *valid = valid_;
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
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
impl ::dh_robot::InverseKinematics<4, 2, f64> for Cobra600 {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 4, 2> {
        Cobra600::inverse(self, target)
    }
}
