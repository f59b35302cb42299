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
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl Rpr {
    /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.
    pub const MAX_SOLUTIONS: usize = 1;
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
        let frame = match ::dh_robot::runtime::frame_of(target, 0.40452000000000005) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let mut q = [[0.0; 1]; 3];
        let mut valid = [0.0; 1];
        if !self.lanes(&frame, &mut q, &mut valid) {
            return self.robust(target);
        }
        if valid == [1.0; 1] {
            let at = |l: usize| ::dh_robot::runtime::lanes::solution(
                &Self::JOINTS,
                &q,
                &Self::BRANCHES,
                l,
            );
            return ::dh_robot::Solutions::full(&Self::JOINTS, [at(0)]);
        }
        ::dh_robot::runtime::lanes::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)
    }
    /// Runs the plan: calls `found` with every candidate.
    fn candidates(
        &self,
        t: &::dh_robot::runtime::Pose,
        pick: ::dh_robot::runtime::Pick,
        found: &mut dyn FnMut([f64; 3], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::runtime::Attempt {
        let mut attempt = ::dh_robot::runtime::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = self.l2 * 2.472065658063878;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        let q2_roots = ::dh_robot::runtime::solve_quadratic(
            0.0,
            -1.0,
            t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
            1e-11,
        );
        if !q2_roots.is_regular() {
            attempt.note(q2_roots.outcome, free, "q2", 0.40452000000000005, "m");
        }
        let free = if q2_roots.is_free() {
            free.union(::dh_robot::FreeJoints::of(&[1]))
        } else {
            free
        };
        for (q2_root, &q2_scaled) in q2_roots
            .or_if_free(pick.length(0))
            .iter()
            .enumerate()
        {
            let q2 = q2_scaled * 0.40452000000000005;
            let q1_roots = ::dh_robot::runtime::solve_pair(
                0.0,
                1.0,
                t[0][2],
                -1.0,
                0.0,
                t[1][2],
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
                .or_if_free(pick.angle(1))
                .iter()
                .enumerate()
            {
                let q1 = ::dh_robot::runtime::atan2(s1, c1);
                let q3_roots = ::dh_robot::runtime::solve_pair(
                    1.0,
                    0.0,
                    t[0][0] * c1 + t[1][0] * s1,
                    0.0,
                    -1.0,
                    t[0][1] * c1 + t[1][1] * s1,
                    1e-11,
                );
                if !q3_roots.is_regular() {
                    attempt.note(q3_roots.outcome, free, "q3", 1.0, "");
                }
                let free = if q3_roots.is_free() {
                    free.union(::dh_robot::FreeJoints::of(&[2]))
                } else {
                    free
                };
                for (q3_root, &[c3, s3]) in q3_roots
                    .or_if_free(pick.angle(2))
                    .iter()
                    .enumerate()
                {
                    let q3 = ::dh_robot::runtime::atan2(s3, c3);
                    let branch = ::dh_robot::Branch::ANY;
                    found([q1, q2, q3], branch, free);
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
    ) -> ::dh_robot::Solutions<f64, 3, 1> {
        let frame = match ::dh_robot::runtime::frame_of(target, 0.40452000000000005) {
            ::core::result::Result::Ok(frame) => frame,
            ::core::result::Result::Err(why) => {
                return ::dh_robot::Solutions::none(&Self::JOINTS, why);
            }
        };
        let setting = ::dh_robot::runtime::Setting {
            joints: &Self::JOINTS,
            reach: 0.40452000000000005,
            few: true,
            given: [::core::option::Option::None; 3],
        };
        let task = ::dh_robot::runtime::Task::Pose(
            ::dh_robot::runtime::in_units(&frame, 0.40452000000000005),
        );
        ::dh_robot::runtime::solve(
            self,
            setting,
            &task,
            &frame,
            |frame, pick, found| self.candidates(frame, pick, found),
        )
    }
    const BRANCHES: [::dh_robot::Branch; 1] = {
        let mut all = [::dh_robot::Branch::ANY; 1];
        let mut l = 0;
        while l < 1 {
            all[l] = ::dh_robot::Branch::ANY;
            l += 1;
        }
        all
    };
    /// The plan for all branches at once: joint values, and which branches are real; false where the robust way has to decide.
    #[inline]
    fn lanes(
        &self,
        t: &::dh_robot::runtime::Pose,
        q: &mut [[f64; 1]; 3],
        valid: &mut [f64; 1],
    ) -> bool {
        let t_2 = self.l2 * 2.472065658063878;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        let mut margin_ = [0.0; 1];
        let mut valid_ = [0.0; 1];
        let mut error_ = [0.0; 1];
        let r0 = (0.0 - t[2][2]).abs() + (0.0 - t[2][3]).abs();
        let (q2_scaled, m0) = ::dh_robot::runtime::lanes::linear(
            -1.0,
            t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
        );
        let q2_scaled = q2_scaled;
        let g0 = q2_scaled * 0.40452000000000005;
        let t_4 = t_2 + q2_scaled;
        let [c1, s1] = ::dh_robot::runtime::lanes::unit(-t[1][2], t[0][2]);
        let g1 = ::dh_robot::runtime::lanes::angle(s1, c1);
        let r2 = (s1 - t[0][2]).abs() + (-c1 - t[1][2]).abs()
            + (s1 * t_4 - t[0][3]).abs() + (-c1 * t_4 - t[1][3]).abs();
        let [c3, s3] = ::dh_robot::runtime::lanes::unit(
            t[0][0] * c1 + t[1][0] * s1,
            -(t[0][1] * c1 + t[1][1] * s1),
        );
        let g2 = ::dh_robot::runtime::lanes::angle(s3, c3);
        let r3 = (-c1 * s3 - t[0][1]).abs() + (-s1 * s3 - t[1][1]).abs()
            + (c3 - t[2][1]).abs();
        let l = 0;
        margin_[l] = m0;
        valid_[l] = 1.0;
        error_[l] = r0 + r2 + r3;
        q[0][l] = g1;
        q[1][l] = g0;
        q[2][l] = g2;
        *valid = valid_;
        ::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)
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
impl ::dh_robot::InverseKinematics<3, 1, f64> for Rpr {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 3, 1> {
        Rpr::inverse(self, target)
    }
}
