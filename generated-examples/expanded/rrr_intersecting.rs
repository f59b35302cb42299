// What `dh_robot!` makes of src/rrr_intersecting.rs. Made by `cargo regen`; do not edit.

/// An arm whose first two axes intersect: a shoulder that turns and tilts, and an elbow.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | 0 | q1 | any |
/// | q2 | -90 deg | 0 | d2 | q2 | any |
/// | q3 | 0 | l2 | 0 | q3 | any |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RrrIntersecting {
    /// `d2` in m.
    pub d2: f64,
    /// `l2` in m.
    pub l2: f64,
    /// `l3` in m.
    pub l3: f64,
}
impl ::core::default::Default for RrrIntersecting {
    fn default() -> Self {
        RrrIntersecting {
            d2: 0.15,
            l2: 0.5,
            l3: 0.4,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl RrrIntersecting {
    /// Number of joints.
    pub const DOF: usize = 3;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 3] = [
        ::dh_robot::Joint::revolute("q1"),
        ::dh_robot::Joint::revolute("q2"),
        ::dh_robot::Joint::revolute("q3"),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 12 multiplications, 5 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[1] + q[2], q[1], q[0]];
        let ([s23, s2, s1], [c23, c2, c1]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.l3 * c23 + self.l2 * c2;
        ::dh_robot::pose::from_entries(
            [[c23 * c1, -s23 * c1, -s1], [c23 * s1, -s23 * s1, c1], [-s23, -c23, 0.0]],
            [
                t * c1 - self.d2 * s1,
                t * s1 + self.d2 * c1,
                -(self.l3 * s23 + self.l2 * s2),
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 14 multiplications, 3 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 3],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        let angles = [q[0], q[1], q[1] + q[2]];
        let ([s1, s2, s23], [c1, c2, c23]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = s1 * self.d2;
        let t_2 = c1 * self.d2;
        let t_3 = c2 * self.l2;
        [
            ::dh_robot::pose::from_entries(
                [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [[c1 * c2, -c1 * s2, -s1], [s1 * c2, -s1 * s2, c1], [-s2, -c2, 0.0]],
                [-t, t_2, 0.0],
            ),
            ::dh_robot::pose::from_entries(
                [
                    [c1 * c23, -c1 * s23, -s1],
                    [s1 * c23, -s1 * s23, c1],
                    [-s23, -c23, 0.0],
                ],
                [-(t - c1 * t_3), t_2 + s1 * t_3, -s2 * self.l2],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 12 multiplications, 5 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        let angles = [q[1] + q[2], q[0], q[1]];
        let ([s23, s1, s2], [c23, c1, c2]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = c23 * self.l3;
        let t_2 = s23 * self.l3;
        let t_3 = t + self.l2 * c2;
        let t_4 = t_2 + self.l2 * s2;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [
                    -(s1 * t_3 + c1 * self.d2),
                    c1 * t_3 - s1 * self.d2,
                    0.0,
                    0.0,
                    0.0,
                    1.0,
                ],
                [-c1 * t_4, -s1 * t_4, -t_3, -s1, c1, 0.0],
                [-c1 * t_2, -s1 * t_2, -t, -s1, c1, 0.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 16 multiplications, 5 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 3],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 3>,
    ) {
        let angles = [q[1] + q[2], q[0], q[1]];
        let ([s23, s1, s2], [c23, c1, c2]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = c23 * self.l3;
        let t_2 = s23 * self.l3;
        let t_3 = t + self.l2 * c2;
        let t_4 = t_2 + self.l2 * s2;
        let t_5 = c1 * t_3 - s1 * self.d2;
        let t_6 = s1 * t_3 + c1 * self.d2;
        (
            ::dh_robot::pose::from_entries(
                [
                    [c23 * c1, -s23 * c1, -s1],
                    [c23 * s1, -s23 * s1, c1],
                    [-s23, -c23, 0.0],
                ],
                [t_5, t_6, -t_4],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [-t_6, t_5, 0.0, 0.0, 0.0, 1.0],
                    [-c1 * t_4, -s1 * t_4, -t_3, -s1, c1, 0.0],
                    [-c1 * t_2, -s1 * t_2, -t, -s1, c1, 0.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<3, f64> for RrrIntersecting {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 3] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<3, f64> for RrrIntersecting {
    #[inline]
    fn forward(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        RrrIntersecting::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 3]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 3] {
        RrrIntersecting::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<3, f64> for RrrIntersecting {
    #[inline]
    fn jacobian(&self, q: &[f64; 3]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 3> {
        RrrIntersecting::jacobian(self, q)
    }
}
