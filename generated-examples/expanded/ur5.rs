// What `dh_robot!` makes of src/ur5.rs. Made by `cargo regen`; do not edit.

/// Universal Robots UR5.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | d1 | 0 | 90 deg | -360.0 to 360.0 deg |
/// | q2 | q2 | 0 | -a2 | 0 | -360.0 to 360.0 deg |
/// | q3 | q3 | 0 | -a3 | 0 | -180.0 to 180.0 deg |
/// | q4 | q4 | d4 | 0 | 90 deg | -360.0 to 360.0 deg |
/// | q5 | q5 | d5 | 0 | -90 deg | -360.0 to 360.0 deg |
/// | q6 | q6 | d6 | 0 | 0 | -360.0 to 360.0 deg |
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
    /// Cost: 36 multiplications, 22 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[1] + q[2], q[1], q[0]];
        let ([s6, s5, s234, s23, s2, s1], [c6, c5, c234, c23, c2, c1]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.0823 * s5;
        let t_2 = 0.0823 * c5 + 0.10915;
        let t_3 = t * c234 - 0.09465 * s234 + 0.39225 * c23 + 0.425 * c2;
        let t_4 = t * s234 + 0.09465 * c234 + 0.39225 * s23 + 0.425 * s2 - 0.089459;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_5 = c234 * c6c5 - s6 * s234;
        let t_6 = s234 * c6c5 + s6 * c234;
        let t_7 = c1 * t_5 + s1 * c6s5;
        let t_8 = s1 * t_5 - c1 * c6s5;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_9 = c1 * s5c234 - c5 * s1;
        let t_10 = s1 * s5c234 + c5 * c1;
        ::dh_robot::pose::from_entries(
            [
                [t_7, -(t_6 * t_10 - t_8 * s5s234), -t_9],
                [t_8, -(t_7 * s5s234 - t_6 * t_9), -t_10],
                [t_6, -(t_8 * t_9 - t_7 * t_10), -s5s234],
            ],
            [-(t_3 * c1 - t_2 * s1), -(t_3 * s1 + t_2 * c1), -t_4],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 50 multiplications, 25 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[1] + q[2] + q[3], q[4], q[5]];
        let ([s1, s2, s23, s234, s5, s6], [c1, c2, c23, c234, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = 0.425 * c2;
        let t_2 = c1 * t;
        let t_3 = s1 * t;
        let t_4 = 0.089459 - 0.425 * s2;
        let t_5 = 0.39225 * c23;
        let t_6 = t_2 + c1 * t_5;
        let t_7 = t_3 + s1 * t_5;
        let t_8 = t_4 - 0.39225 * s23;
        let t_9 = t_6 - s1 * 0.10915;
        let t_10 = t_7 + c1 * 0.10915;
        let c1c234 = c1 * c234;
        let s1c234 = s1 * c234;
        let c1s234 = c1 * s234;
        let s1s234 = s1 * s234;
        let t_11 = t_9 - c1s234 * 0.09465;
        let t_12 = t_10 - s1s234 * 0.09465;
        let t_13 = t_8 - c234 * 0.09465;
        let s234c5 = s234 * c5;
        let t_14 = c1c234 * c5 + s1 * s5;
        let t_15 = s1c234 * c5 - c1 * s5;
        let s234s5 = s234 * s5;
        let t_16 = s1 * c5 - c1c234 * s5;
        let t_17 = c1 * c5 + s1c234 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, s1], [s1, 0.0, -c1], [0.0, 1.0, 0.0]],
                [0.0, 0.0, 0.089459],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, s1], [s1 * c2, -s1 * s2, -c1], [s2, c2, 0.0]],
                [-t_2, -t_3, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c23, -c1 * s23, s1], [s1 * c23, -s1 * s23, -c1], [s23, c23, 0.0]],
                [-t_6, -t_7, t_8],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c234, s1, c1s234], [s1c234, -c1, s1s234], [s234, 0.0, -c234]],
                [-t_9, -t_10, t_8],
            ),
            ::dh_robot::pose::from_entries(
                [[t_14, -c1s234, t_16], [t_15, -s1s234, -t_17], [s234c5, c234, -s234s5]],
                [-t_11, -t_12, t_13],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_14 * c6 - c1s234 * s6, -(c1s234 * c6 + t_14 * s6), t_16],
                    [t_15 * c6 - s1s234 * s6, -(s1s234 * c6 + t_15 * s6), -t_17],
                    [s234c5 * c6 + c234 * s6, c234 * c6 - s234c5 * s6, -s234s5],
                ],
                [
                    -(t_11 - t_16 * 0.0823),
                    -(t_12 + t_17 * 0.0823),
                    t_13 - s234s5 * 0.0823,
                ],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 34 multiplications, 16 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s5, s234, s1, s23, s2], [c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let s5c234 = s5 * c234;
        let t = s5 * 0.0823;
        let t_2 = c5 * 0.0823;
        let t_3 = t_2 + 0.10915;
        let t_4 = c234 * t - s234 * 0.09465;
        let t_5 = s234 * t + c234 * 0.09465;
        let t_6 = t_4 + 0.39225 * c23;
        let t_7 = t_5 + 0.39225 * s23;
        let t_8 = t_6 + 0.425 * c2;
        let t_9 = t_7 + 0.425 * s2;
        let t_10 = c234 * t_2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [s1 * t_8 + c1 * t_3, -(c1 * t_8 - s1 * t_3), 0.0, 0.0, 0.0, 1.0],
                [c1 * t_9, s1 * t_9, -t_8, s1, -c1, 0.0],
                [c1 * t_7, s1 * t_7, -t_6, s1, -c1, 0.0],
                [c1 * t_5, s1 * t_5, -t_4, s1, -c1, 0.0],
                [
                    -(c1 * t_10 + s1 * t),
                    -(s1 * t_10 - c1 * t),
                    -s234 * t_2,
                    s234 * c1,
                    s234 * s1,
                    -c234,
                ],
                [
                    0.0,
                    0.0,
                    0.0,
                    -(c1 * s5c234 - c5 * s1),
                    -(s1 * s5c234 + c5 * c1),
                    -s5 * s234,
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 50 multiplications, 24 additions, 6 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[5], q[4], q[1] + q[2] + q[3], q[0], q[1] + q[2], q[1]];
        let ([s6, s5, s234, s1, s23, s2], [c6, c5, c234, c1, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t = c6c5 * c234 - s6 * s234;
        let t_2 = c6c5 * s234 + s6 * c234;
        let t_3 = t * c1 + c6s5 * s1;
        let t_4 = t * s1 - c6s5 * c1;
        let s5c234 = s5 * c234;
        let s5s234 = s5 * s234;
        let t_5 = c1 * s5c234 - c5 * s1;
        let t_6 = s1 * s5c234 + c5 * c1;
        let t_7 = s5 * 0.0823;
        let t_8 = c5 * 0.0823;
        let t_9 = t_8 + 0.10915;
        let t_10 = c234 * t_7 - s234 * 0.09465;
        let t_11 = s234 * t_7 + c234 * 0.09465;
        let t_12 = t_10 + 0.39225 * c23;
        let t_13 = t_11 + 0.39225 * s23;
        let t_14 = t_12 + 0.425 * c2;
        let t_15 = t_13 + 0.425 * s2;
        let t_16 = c1 * t_14 - s1 * t_9;
        let t_17 = s1 * t_14 + c1 * t_9;
        let t_18 = c234 * t_8;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_3, -(t_2 * t_6 - t_4 * s5s234), -t_5],
                    [t_4, -(t_3 * s5s234 - t_2 * t_5), -t_6],
                    [t_2, -(t_4 * t_5 - t_3 * t_6), -s5s234],
                ],
                [-t_16, -t_17, -(t_15 - 0.089459)],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [t_17, -t_16, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_15, s1 * t_15, -t_14, s1, -c1, 0.0],
                    [c1 * t_13, s1 * t_13, -t_12, s1, -c1, 0.0],
                    [c1 * t_11, s1 * t_11, -t_10, s1, -c1, 0.0],
                    [
                        -(c1 * t_18 + s1 * t_7),
                        -(s1 * t_18 - c1 * t_7),
                        -s234 * t_8,
                        s234 * c1,
                        s234 * s1,
                        -c234,
                    ],
                    [0.0, 0.0, 0.0, -t_5, -t_6, -s5s234],
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
