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
    /// Cost: 6 multiplications, 1 addition, 2 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
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
        let ([s1, s3], [c1, c3]) = ::dh_robot::sincos::sincos_batch(&angles);
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
    /// origin of the last frame (or tool).
    ///
    /// Cost: 2 multiplications, 1 addition, 1 sine-cosine pair.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let angles = [q[0]];
        let ([s1], [c1]) = ::dh_robot::sincos::sincos_batch(&angles);
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
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
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
    /// Plan:
    /// 1. `q2`: a linear equation.
    /// 2. `q1`: two equations in its sine and cosine: one value.
    /// 3. `q3`: two equations in its sine and cosine: one value.
    #[must_use]
    pub fn inverse(
        &self,
        target: &::dh_robot::nalgebra::IsometryMatrix3<f64>,
    ) -> ::dh_robot::Solutions<f64, 3, 1> {
        let frame = match ::dh_robot::inverse::frame_of(target, 0.40452000000000005) {
            Ok(frame) => frame,
            Err(why) => return ::dh_robot::Solutions::none(&Self::JOINTS, why),
        };
        let mut solutions = ::dh_robot::Solutions::new(&Self::JOINTS);
        if self.lanes(&frame, &mut solutions) {
            return solutions;
        }
        let setting = ::dh_robot::inverse::Setting {
            joints: &Self::JOINTS,
            reach: 0.40452000000000005,
            few: true,
            given: None,
        };
        let task = ::dh_robot::ik::Task::Pose(
            ::dh_robot::inverse::in_units(&frame, 0.40452000000000005),
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
        found: &mut dyn FnMut([f64; 3], ::dh_robot::Branch, ::dh_robot::FreeJoints),
    ) -> ::dh_robot::inverse::Attempt {
        let mut attempt = ::dh_robot::inverse::Attempt::new();
        let free = ::dh_robot::FreeJoints::NONE;
        let t_2 = self.l2 * 2.472065658063878;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        let r0 = ::dh_robot::ik::solve_quadratic(
            0.0,
            -1.0,
            t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
            1e-11,
        );
        if r0.roots.is_empty() {
            attempt.note(r0.outcome, free, "q2", 0.40452000000000005, "m");
        }
        let free = if r0.is_free() {
            attempt.degenerate = true;
            free.union(::dh_robot::FreeJoints::of(&[1]))
        } else {
            free
        };
        for (i0, &q2) in r0.or_if_free(pick.length(0)).iter().enumerate() {
            let a0 = q2 * 0.40452000000000005;
            let r1 = ::dh_robot::ik::solve_pair(
                0.0,
                1.0,
                t[0][2],
                -1.0,
                0.0,
                t[1][2],
                1e-11,
            );
            if r1.roots.is_empty() {
                attempt.note(r1.outcome, free, "q1", 1.0, "");
            }
            let free = if r1.is_free() {
                attempt.degenerate = true;
                free.union(::dh_robot::FreeJoints::of(&[0]))
            } else {
                free
            };
            for (i1, &[c1, s1]) in r1.or_if_free(pick.angle(1)).iter().enumerate() {
                let a1 = ::dh_robot::math::atan2(s1, c1);
                let r2 = ::dh_robot::ik::solve_pair(
                    1.0,
                    0.0,
                    t[0][0] * c1 + t[1][0] * s1,
                    0.0,
                    -1.0,
                    t[0][1] * c1 + t[1][1] * s1,
                    1e-11,
                );
                if r2.roots.is_empty() {
                    attempt.note(r2.outcome, free, "q3", 1.0, "");
                }
                let free = if r2.is_free() {
                    attempt.degenerate = true;
                    free.union(::dh_robot::FreeJoints::of(&[2]))
                } else {
                    free
                };
                for (i2, &[c3, s3]) in r2.or_if_free(pick.angle(2)).iter().enumerate() {
                    let a2 = ::dh_robot::math::atan2(s3, c3);
                    let branch = ::dh_robot::Branch::ANY;
                    found([a1, a0, a2], branch, free);
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
        solutions: &mut ::dh_robot::Solutions<f64, 3, 1>,
    ) -> bool {
        let t_2 = self.l2 * 2.472065658063878;
        let t_3 = t[0][2] * (t[0][3] - t[0][2] * t_2)
            + t[1][2] * (t[1][3] - t[1][2] * t_2);
        let mut f0 = [[0.0; 1]; 2];
        let mut m0 = [0.0; 1];
        for l in 0..1 {
            let (x, m) = ::dh_robot::lanes::linear(
                -1.0,
                t_3 + t[2][2] * (t[2][3] - t[2][2] * t_2),
            );
            f0[0][l] = x;
            f0[1][l] = x;
            m0[l] = m;
        }
        let q2_ = f0[0];
        let g0: [f64; 1] = f0[0].map(|d| d * 0.40452000000000005);
        let mut v91_ = [0.0; 1];
        for l in 0..1 {
            let q2 = q2_[l];
            let t_4 = t_2 + q2;
            v91_[l] = t_4;
        }
        let mut f1 = [[0.0; 1]; 2];
        for l in 0..1 {
            let [x, y] = ::dh_robot::lanes::unit(-t[1][2], t[0][2]);
            f1[0][l] = x;
            f1[1][l] = y;
        }
        let c1_ = f1[0];
        let s1_ = f1[1];
        let g1: [f64; 1] = ::dh_robot::atan2_batch(&f1[1], &f1[0]);
        let mut v51_ = [0.0; 1];
        let mut v57_ = [0.0; 1];
        let mut v92_ = [0.0; 1];
        let mut v93_ = [0.0; 1];
        for l in 0..1 {
            let v91 = v91_[l];
            let c1 = c1_[l];
            let s1 = s1_[l];
            v51_[l] = t[0][0] * c1 + t[1][0] * s1;
            v57_[l] = t[0][1] * c1 + t[1][1] * s1;
            v92_[l] = s1 * v91;
            v93_[l] = c1 * v91;
        }
        let mut f2 = [[0.0; 1]; 2];
        for l in 0..1 {
            let v51 = v51_[l];
            let v57 = v57_[l];
            let [x, y] = ::dh_robot::lanes::unit(v51, -v57);
            f2[0][l] = x;
            f2[1][l] = y;
        }
        let c3_ = f2[0];
        let s3_ = f2[1];
        let g2: [f64; 1] = ::dh_robot::atan2_batch(&f2[1], &f2[0]);
        let mut v89_ = [0.0; 1];
        let mut v90_ = [0.0; 1];
        for l in 0..1 {
            let c1 = c1_[l];
            let s1 = s1_[l];
            let c3 = c3_[l];
            let s3 = s3_[l];
            v89_[l] = c1 * s3;
            v90_[l] = s1 * s3;
        }
        let mut error = [0.0; 1];
        for l in 0..1 {
            let v89 = v89_[l];
            let v90 = v90_[l];
            let c3 = c3_[l];
            let s1 = s1_[l];
            let c1 = c1_[l];
            let v92 = v92_[l];
            let v93 = v93_[l];
            error[l] = (-v89 - t[0][1]).abs() + (-v90 - t[1][1]).abs()
                + (c3 - t[2][1]).abs() + (s1 - t[0][2]).abs() + (-c1 - t[1][2]).abs()
                + (0.0 - t[2][2]).abs() + (v92 - t[0][3]).abs() + (-v93 - t[1][3]).abs()
                + (0.0 - t[2][3]).abs();
        }
        let valid: [f64; 1] = ::core::array::from_fn(|l| 1.0);
        let margin: [f64; 1] = ::core::array::from_fn(|l| 1.0_f64.min(m0[l % 1 % 1]));
        let q: [[f64; 1]; 3] = [
            ::core::array::from_fn(|l| g1[l % 1]),
            ::core::array::from_fn(|l| g0[l % 1]),
            ::core::array::from_fn(|l| g2[l % 1]),
        ];
        const BRANCHES: [::dh_robot::Branch; 1] = {
            let mut all = [::dh_robot::Branch::ANY; 1];
            let mut l = 0;
            while l < 1 {
                all[l] = ::dh_robot::Branch::ANY;
                l += 1;
            }
            all
        };
        ::dh_robot::lanes::collect(&valid, &margin, &error, &q, &BRANCHES, solutions)
    }
}
#[allow(unused, clippy::all, clippy::pedantic)]
impl ::dh_robot::ik::Kinematics<3> for Rpr {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::ik::Pose {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
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
    ) -> (::dh_robot::ik::Pose, [[f64; 3]; 6]) {
        let angles = [q[2], q[0]];
        let ([s3, s1], [c3, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
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
}
impl ::dh_robot::InverseKinematics<3, 1, f64> for Rpr {
    type Target = ::dh_robot::nalgebra::IsometryMatrix3<f64>;
    fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<f64, 3, 1> {
        Rpr::inverse(self, target)
    }
}
