// What `dh_robot!` makes of src/youbot.rs. Made by `cargo regen`; do not edit.

/// KUKA youBot arm: five joints, so the task is a point and a direction.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | d1 | a1 | 90 deg | -169.0 to 169.0 deg |
/// | q2 | q2 + 90 deg | 0 | a2 | 0 | -65.0 to 90.0 deg |
/// | q3 | q3 | 0 | a3 | 0 | -151.0 to 146.0 deg |
/// | q4 | q4 - 90 deg | 0 | 0 | -90 deg | -102.0 to 102.0 deg |
/// | q5 | q5 | d5 | 0 | 0 | -167.0 to 167.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Youbot;
impl ::core::default::Default for Youbot {
    fn default() -> Self {
        Youbot
    }
}
#[allow(clippy::all, clippy::pedantic)]
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
    /// Cost: 22 multiplications, 13 additions, 5 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[4], q[1] + q[2] + q[3], q[1] + q[2], q[1], q[0]];
        let ([s5, s234, s23, s2, s1], [c5, c234, c23, c2, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.2175 * s234 + 0.135 * s23 + 0.155 * s2 - 0.033;
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        ::dh_robot::pose::from_entries(
            [
                [c1 * c5c234 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234 * c1],
                [s1 * c5c234 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234 * s1],
                [c5 * s234, -s5 * s234, c234],
            ],
            [-t * c1, -t * s1, 0.2175 * c234 + 0.135 * c23 + 0.155 * c2 + 0.147],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 35 multiplications, 16 additions, 5 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 5],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 5] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4]];
        let ([s1, s2, s23, s234, s5], [c1, c2, c23, c234, c5]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c1 * 0.033;
        let t_2 = s1 * 0.033;
        let t_3 = 0.155 * s2;
        let t_4 = t - c1 * t_3;
        let t_5 = t_2 - s1 * t_3;
        let t_6 = 0.147 + 0.155 * c2;
        let t_7 = 0.135 * s23;
        let t_8 = t_4 - c1 * t_7;
        let t_9 = t_5 - s1 * t_7;
        let t_10 = t_6 + 0.135 * c23;
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [t, t_2, 0.147],
            ),
            ::dh_robot::pose::from_entries(
                [[-c1 * s2, -c1 * c2, s1], [-s1 * s2, -s1 * c2, -c1], [c2, -s2, 0.0]],
                [t_4, t_5, t_6],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [-c1 * s23, -c1 * c23, s1],
                    [-s1 * s23, -s1 * c23, -c1],
                    [c23, -s23, 0.0],
                ],
                [t_8, t_9, t_10],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c234, -s1, -c1s234], [s1c234, c1, -s1s234], [s234, 0.0, c234]],
                [t_8, t_9, t_10],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [c1c234 * c5 - s1 * s5, -(s1 * c5 + c1c234 * s5), -c1s234],
                    [s1c234 * c5 + c1 * s5, c1 * c5 - s1c234 * s5, -s1s234],
                    [s234 * c5, -s234 * s5, c234],
                ],
                [t_8 - c1s234 * 0.2175, t_9 - s1s234 * 0.2175, t_10 + c234 * 0.2175],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 16 multiplications, 8 additions, 4 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 5]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 5> {
        let angles = [q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s234, s1, s23, s2], [c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = s234 * 0.2175;
        let t_2 = c234 * 0.2175;
        let t_3 = t + 0.135 * s23;
        let t_4 = t_2 + 0.135 * c23;
        let t_5 = t_3 + 0.155 * s2;
        let t_6 = t_4 + 0.155 * c2;
        let t_7 = t_5 - 0.033;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_7, -c1 * t_7, 0.0, 0.0, 0.0, 1.0],
                [-c1 * t_6, -s1 * t_6, -t_5, s1, -c1, 0.0],
                [-c1 * t_4, -s1 * t_4, -t_3, s1, -c1, 0.0],
                [-c1 * t_2, -s1 * t_2, -t, s1, -c1, 0.0],
                [0.0, 0.0, 0.0, -s234 * c1, -s234 * s1, c234],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 28 multiplications, 13 additions, 5 sine-cosine pairs.
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
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c5c234 = c5 * c234;
        let s5c234 = s5 * c234;
        let s234c1 = s234 * c1;
        let s234s1 = s234 * s1;
        let t = s234 * 0.2175;
        let t_2 = c234 * 0.2175;
        let t_3 = t + 0.135 * s23;
        let t_4 = t_2 + 0.135 * c23;
        let t_5 = t_3 + 0.155 * s2;
        let t_6 = t_4 + 0.155 * c2;
        let t_7 = t_5 - 0.033;
        let t_8 = c1 * t_7;
        let t_9 = s1 * t_7;
        (
            ::dh_robot::pose::from_entries(
                [
                    [c5c234 * c1 - s5 * s1, -(c1 * s5c234 + c5 * s1), -s234c1],
                    [c5c234 * s1 + s5 * c1, -(s1 * s5c234 - c5 * c1), -s234s1],
                    [c5 * s234, -s5 * s234, c234],
                ],
                [-t_8, -t_9, t_6 + 0.147],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_9, -t_8, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_6, -s1 * t_6, -t_5, s1, -c1, 0.0],
                    [-c1 * t_4, -s1 * t_4, -t_3, s1, -c1, 0.0],
                    [-c1 * t_2, -s1 * t_2, -t, s1, -c1, 0.0],
                    [0.0, 0.0, 0.0, -s234c1, -s234s1, c234],
                ]),
            ),
        )
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
}
