// What `dh_robot!` makes of src/stanford.rs. Made by `cargo regen`; do not edit.

/// The Stanford arm: its third joint slides.
///
/// Denavit-Hartenberg parameters, standard (theta, d, a, alpha of one link); lengths in m:
///
/// | joint | theta | d | a | alpha | range |
/// |---|---|---|---|---|---|
/// | q1 | q1 | d1 | 0 | -90 deg | -170.0 to 170.0 deg |
/// | q2 | q2 | d2 | 0 | 90 deg | -170.0 to 170.0 deg |
/// | q3 | -90 deg | q3 | a3 | 0 | 0.3048 to 1.27 |
/// | q4 | q4 | 0 | 0 | -90 deg | -170.0 to 170.0 deg |
/// | q5 | q5 | 0 | 0 | 90 deg | -90.0 to 90.0 deg |
/// | q6 | q6 | 0 | 0 | 0 | -170.0 to 170.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stanford;
impl ::core::default::Default for Stanford {
    fn default() -> Self {
        Stanford
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Stanford {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::prismatic("q3").with_range(0.3048, 1.27),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-2.9670597283903604, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-1.5707963267948966, 1.5707963267948966),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-2.9670597283903604, 2.9670597283903604),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 36 multiplications, 16 additions, 5 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[1], q[0], q[5], q[4], q[3]];
        let ([s2, s1, s6, s5, s4], [c2, c1, c6, c5, c4]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = q[2] * s2;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c6c5 * s4 + s6 * c4;
        let t_3 = c6c5 * c4 - s6 * s4;
        let t_4 = c2 * t_2 - s2 * c6s5;
        let t_5 = s2 * t_2 + c2 * c6s5;
        let t_6 = c1 * t_4 + s1 * t_3;
        let t_7 = s1 * t_4 - c1 * t_3;
        let s5s4 = s5 * s4;
        let s5c4 = s5 * c4;
        let t_8 = c2 * s5s4 + s2 * c5;
        let t_9 = s2 * s5s4 - c2 * c5;
        let t_10 = c1 * t_8 + s1 * s5c4;
        let t_11 = s1 * t_8 - c1 * s5c4;
        ::dh_robot::pose::from_entries(
            [
                [t_6, -(t_5 * t_11 - t_7 * t_9), t_10],
                [t_7, -(t_6 * t_9 - t_5 * t_10), t_11],
                [-t_5, t_7 * t_10 - t_6 * t_11, -t_9],
            ],
            [
                t * c1 - 0.13369999999999999 * s1,
                t * s1 + 0.13369999999999999 * c1,
                q[2] * c2 + 0.412,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 45 multiplications, 21 additions, 5 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = s1 * 0.154;
        let t_2 = c1 * 0.154;
        let c1c2 = c1 * c2;
        let s1c2 = s1 * c2;
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let t_3 = 0.412 + c2 * q[2];
        let t_4 = t - c1s2 * q[2] - s1 * 0.0203;
        let t_5 = t_2 + s1s2 * q[2] - c1 * 0.0203;
        let s2s4 = s2 * s4;
        let t_6 = c1c2 * s4 + s1 * c4;
        let t_7 = s1c2 * s4 - c1 * c4;
        let s2c4 = s2 * c4;
        let t_8 = s1 * s4 - c1c2 * c4;
        let t_9 = c1 * s4 + s1c2 * c4;
        let t_10 = t_6 * c5 - c1s2 * s5;
        let t_11 = t_7 * c5 - s1s2 * s5;
        let t_12 = s2s4 * c5 + c2 * s5;
        let t_13 = c1s2 * c5 + t_6 * s5;
        let t_14 = s1s2 * c5 + t_7 * s5;
        let t_15 = c2 * c5 - s2s4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, 0.0, -s1], [s1, 0.0, c1], [0.0, -1.0, 0.0]],
                [0.0, 0.0, 0.412],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c2, -s1, c1s2], [s1c2, c1, s1s2], [-s2, 0.0, c2]],
                [-t, t_2, 0.412],
            ),
            ::dh_robot::pose::from_entries(
                [[s1, c1c2, c1s2], [-c1, s1c2, s1s2], [0.0, -s2, c2]],
                [-t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[t_6, -c1s2, -t_8], [t_7, -s1s2, t_9], [-s2s4, -c2, -s2c4]],
                [-t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [[t_10, -t_8, t_13], [t_11, t_9, t_14], [-t_12, -s2c4, t_15]],
                [-t_4, t_5, t_3],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_10 * c6 - t_8 * s6, -(t_8 * c6 + t_10 * s6), t_13],
                    [t_11 * c6 + t_9 * s6, t_9 * c6 - t_11 * s6, t_14],
                    [-(t_12 * c6 + s2c4 * s6), -(s2c4 * c6 - t_12 * s6), t_15],
                ],
                [-t_4, t_5, t_3],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 26 multiplications, 8 additions, 4 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1], q[3], q[4]];
        let ([s1, s2, s4, s5], [c1, c2, c4, c5]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let c2c4 = c2 * c4;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        let t = c2 * s4s5 + s2 * c5;
        let t_2 = s2 * q[2];
        let t_3 = c2 * q[2];
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [
                    -(s1 * t_2 + c1 * 0.13369999999999999),
                    c1 * t_2 - s1 * 0.13369999999999999,
                    0.0,
                    0.0,
                    0.0,
                    1.0,
                ],
                [c1 * t_3, s1 * t_3, -t_2, -s1, c1, 0.0],
                [c1s2, s1s2, c2, 0.0, 0.0, 0.0],
                [0.0, 0.0, 0.0, c1s2, s1s2, c2],
                [0.0, 0.0, 0.0, c1 * c2c4 - s1 * s4, s1 * c2c4 + c1 * s4, -s2 * c4],
                [
                    0.0,
                    0.0,
                    0.0,
                    c1 * t + s1 * c4s5,
                    s1 * t - c1 * c4s5,
                    -(s2 * s4s5 - c2 * c5),
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 44 multiplications, 18 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 6],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 6>,
    ) {
        let angles = [q[0], q[1], q[3], q[4], q[5]];
        let ([s1, s2, s4, s5, s6], [c1, c2, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c1s2 = c1 * s2;
        let s1s2 = s1 * s2;
        let c2c4 = c2 * c4;
        let s2c4 = s2 * c4;
        let t = c1 * c2c4 - s1 * s4;
        let t_2 = s1 * c2c4 + c1 * s4;
        let s4s5 = s4 * s5;
        let c4s5 = c4 * s5;
        let t_3 = c2 * s4s5 + s2 * c5;
        let t_4 = s2 * s4s5 - c2 * c5;
        let t_5 = c1 * t_3 + s1 * c4s5;
        let t_6 = s1 * t_3 - c1 * c4s5;
        let t_7 = t_2 * t_4 - s2c4 * t_6;
        let t_8 = s2c4 * t_5 - t * t_4;
        let t_9 = t * t_6 - t_2 * t_5;
        let t_10 = s2 * q[2];
        let t_11 = c2 * q[2];
        let t_12 = c1 * t_10 - s1 * 0.13369999999999999;
        let t_13 = s1 * t_10 + c1 * 0.13369999999999999;
        (
            ::dh_robot::pose::from_entries(
                [
                    [-(t_7 * c6 - t * s6), t * c6 + t_7 * s6, t_5],
                    [-(t_8 * c6 - t_2 * s6), t_2 * c6 + t_8 * s6, t_6],
                    [t_9 * c6 - s2c4 * s6, -(s2c4 * c6 + t_9 * s6), -t_4],
                ],
                [t_12, t_13, t_11 + 0.412],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_13, t_12, 0.0, 0.0, 0.0, 1.0],
                    [c1 * t_11, s1 * t_11, -t_10, -s1, c1, 0.0],
                    [c1s2, s1s2, c2, 0.0, 0.0, 0.0],
                    [0.0, 0.0, 0.0, c1s2, s1s2, c2],
                    [0.0, 0.0, 0.0, t, t_2, -s2c4],
                    [0.0, 0.0, 0.0, t_5, t_6, -t_4],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for Stanford {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Stanford {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Stanford::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Stanford::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Stanford {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Stanford::jacobian(self, q)
    }
}
