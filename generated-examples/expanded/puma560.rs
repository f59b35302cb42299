// What `dh_robot!` makes of src/puma560.rs. Made by `cargo regen`; do not edit.

/// Unimation PUMA 560, frames after Craig.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | 0 | q1 | -160.0 to 160.0 deg |
/// | q2 | -90 deg | 0 | 0 | q2 | -225.0 to 45.0 deg |
/// | q3 | 0 | a2 | d3 | q3 | -45.0 to 225.0 deg |
/// | q4 | -90 deg | a3 | d4 | q4 | -110.0 to 170.0 deg |
/// | q5 | 90 deg | 0 | 0 | q5 | -100.0 to 100.0 deg |
/// | q6 | -90 deg | 0 | 0 | q6 | -266.0 to 266.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Puma560 {
    /// `a2` in m.
    pub a2: f64,
    /// `a3` in m.
    pub a3: f64,
    /// `d3` in m.
    pub d3: f64,
    /// `d4` in m.
    pub d4: f64,
}
impl ::core::default::Default for Puma560 {
    fn default() -> Self {
        Puma560 {
            a2: 0.4318,
            a3: 0.0203,
            d3: 0.15005,
            d4: 0.4318,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl Puma560 {
    /// Number of joints.
    pub const DOF: usize = 6;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 6] = [
        ::dh_robot::Joint::revolute("q1")
            .with_range(-2.792526803190927, 2.792526803190927),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-3.9269908169872414, 0.7853981633974483),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-0.7853981633974483, 3.9269908169872414),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-1.9198621771937623, 2.9670597283903604),
        ::dh_robot::Joint::revolute("q5")
            .with_range(-1.7453292519943295, 1.7453292519943295),
        ::dh_robot::Joint::revolute("q6")
            .with_range(-4.642575810304916, 4.642575810304916),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 40 multiplications, 20 additions, 6 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[3], q[1] + q[2], q[1], q[0], q[5], q[4]];
        let ([s4, s23, s2, s1, s6, s5], [c4, c23, c2, c1, c6, c5]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = self.a3 * c23 - self.d4 * s23 + self.a2 * c2;
        let c6c5 = c6 * c5;
        let c6s5 = c6 * s5;
        let t_2 = c4 * c6c5 - s4 * s6;
        let t_3 = s4 * c6c5 + c4 * s6;
        let t_4 = c23 * t_2 - s23 * c6s5;
        let t_5 = s23 * t_2 + c23 * c6s5;
        let t_6 = c1 * t_4 + s1 * t_3;
        let t_7 = s1 * t_4 - c1 * t_3;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t_8 = c23 * c4s5 + s23 * c5;
        let t_9 = s23 * c4s5 - c23 * c5;
        let t_10 = c1 * t_8 + s1 * s4s5;
        let t_11 = s1 * t_8 - c1 * s4s5;
        ::dh_robot::pose::from_entries(
            [
                [t_6, t_5 * t_11 - t_7 * t_9, -t_10],
                [t_7, t_6 * t_9 - t_5 * t_10, -t_11],
                [-t_5, -(t_7 * t_10 - t_6 * t_11), t_9],
            ],
            [
                t * c1 - self.d3 * s1,
                t * s1 + self.d3 * c1,
                -(self.a3 * s23 + self.d4 * c23 + self.a2 * s2),
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 54 multiplications, 25 additions, 6 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 6],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        let angles = [q[0], q[1], q[1] + q[2], q[3], q[4], q[5]];
        let ([s1, s2, s23, s4, s5, s6], [c1, c2, c23, c4, c5, c6]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = c2 * self.a2;
        let t_2 = s2 * self.a2;
        let t_3 = c1 * t - s1 * self.d3;
        let t_4 = s1 * t + c1 * self.d3;
        let c1c23 = c1 * c23;
        let s1c23 = s1 * c23;
        let c1s23 = c1 * s23;
        let s1s23 = s1 * s23;
        let t_5 = t_3 + c1c23 * self.a3 - c1s23 * self.d4;
        let t_6 = t_4 + s1c23 * self.a3 - s1s23 * self.d4;
        let t_7 = t_2 + s23 * self.a3 + c23 * self.d4;
        let s23c4 = s23 * c4;
        let t_8 = c1c23 * c4 + s1 * s4;
        let t_9 = s1c23 * c4 - c1 * s4;
        let s23s4 = s23 * s4;
        let t_10 = s1 * c4 - c1c23 * s4;
        let t_11 = c1 * c4 + s1c23 * s4;
        let t_12 = t_8 * c5 - c1s23 * s5;
        let t_13 = t_9 * c5 - s1s23 * s5;
        let t_14 = s23c4 * c5 + c23 * s5;
        let t_15 = c1s23 * c5 + t_8 * s5;
        let t_16 = s1s23 * c5 + t_9 * s5;
        let t_17 = c23 * c5 - s23c4 * s5;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, -s1], [s1 * c2, -s1 * s2, c1], [-s2, -c2, 0.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1c23, -c1s23, -s1], [s1c23, -s1s23, c1], [-s23, -c23, 0.0]],
                [t_3, t_4, -t_2],
            ),
            ::dh_robot::pose::from_entries(
                [[t_8, t_10, -c1s23], [t_9, -t_11, -s1s23], [-s23c4, s23s4, -c23]],
                [t_5, t_6, -t_7],
            ),
            ::dh_robot::pose::from_entries(
                [[t_12, -t_15, -t_10], [t_13, -t_16, t_11], [-t_14, -t_17, -s23s4]],
                [t_5, t_6, -t_7],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [t_12 * c6 + t_10 * s6, t_10 * c6 - t_12 * s6, -t_15],
                    [t_13 * c6 - t_11 * s6, -(t_11 * c6 + t_13 * s6), -t_16],
                    [-(t_14 * c6 - s23s4 * s6), s23s4 * c6 + t_14 * s6, -t_17],
                ],
                [t_5, t_6, -t_7],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 32 multiplications, 13 additions, 5 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        let angles = [q[0], q[1] + q[2], q[3], q[4], q[1]];
        let ([s1, s23, s4, s5, s2], [c1, c23, c4, c5, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let c23s4 = c23 * s4;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t = c23 * c4s5 + s23 * c5;
        let t_2 = c23 * self.a3 - s23 * self.d4;
        let t_3 = s23 * self.a3 + c23 * self.d4;
        let t_4 = t_2 + self.a2 * c2;
        let t_5 = t_3 + self.a2 * s2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [
                    -(s1 * t_4 + c1 * self.d3),
                    c1 * t_4 - s1 * self.d3,
                    0.0,
                    0.0,
                    0.0,
                    1.0,
                ],
                [-c1 * t_5, -s1 * t_5, -t_4, -s1, c1, 0.0],
                [-c1 * t_3, -s1 * t_3, -t_2, -s1, c1, 0.0],
                [0.0, 0.0, 0.0, -c1 * s23, -s1 * s23, -c23],
                [0.0, 0.0, 0.0, c1 * c23s4 - s1 * c4, s1 * c23s4 + c1 * c4, -s23 * s4],
                [
                    0.0,
                    0.0,
                    0.0,
                    -(c1 * t + s1 * s4s5),
                    -(s1 * t - c1 * s4s5),
                    s23 * c4s5 - c23 * c5,
                ],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 50 multiplications, 22 additions, 6 sine-cosine pairs.
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
        let c23s4 = c23 * s4;
        let s23s4 = s23 * s4;
        let t = c1 * c23s4 - s1 * c4;
        let t_2 = s1 * c23s4 + c1 * c4;
        let c4s5 = c4 * s5;
        let s4s5 = s4 * s5;
        let t_3 = c23 * c4s5 + s23 * c5;
        let t_4 = s23 * c4s5 - c23 * c5;
        let t_5 = c1 * t_3 + s1 * s4s5;
        let t_6 = s1 * t_3 - c1 * s4s5;
        let t_7 = s23s4 * t_6 - t_2 * t_4;
        let t_8 = t * t_4 - s23s4 * t_5;
        let t_9 = t_2 * t_5 - t * t_6;
        let t_10 = c23 * self.a3 - s23 * self.d4;
        let t_11 = s23 * self.a3 + c23 * self.d4;
        let t_12 = t_10 + self.a2 * c2;
        let t_13 = t_11 + self.a2 * s2;
        let t_14 = c1 * t_12 - s1 * self.d3;
        let t_15 = s1 * t_12 + c1 * self.d3;
        (
            ::dh_robot::pose::from_entries(
                [
                    [t_7 * c6 - t * s6, -(t * c6 + t_7 * s6), -t_5],
                    [t_8 * c6 - t_2 * s6, -(t_2 * c6 + t_8 * s6), -t_6],
                    [-(t_9 * c6 - s23s4 * s6), s23s4 * c6 + t_9 * s6, t_4],
                ],
                [t_14, t_15, -t_13],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_15, t_14, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_13, -s1 * t_13, -t_12, -s1, c1, 0.0],
                    [-c1 * t_11, -s1 * t_11, -t_10, -s1, c1, 0.0],
                    [0.0, 0.0, 0.0, -c1 * s23, -s1 * s23, -c23],
                    [0.0, 0.0, 0.0, t, t_2, -s23s4],
                    [0.0, 0.0, 0.0, -t_5, -t_6, t_4],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<6, f64> for Puma560 {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 6] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<6, f64> for Puma560 {
    #[inline]
    fn forward(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        Puma560::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 6]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 6] {
        Puma560::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<6, f64> for Puma560 {
    #[inline]
    fn jacobian(&self, q: &[f64; 6]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 6> {
        Puma560::jacobian(self, q)
    }
}
