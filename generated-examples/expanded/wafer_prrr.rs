// What `dh_robot!` makes of src/wafer_prrr.rs. Made by `cargo regen`; do not edit.

/// A wafer robot: a lift and a planar arm.
///
/// Denavit-Hartenberg parameters, modified, after Craig (alpha and a of the link before); lengths in m:
///
/// | joint | alpha | a | d | theta | range |
/// |---|---|---|---|---|---|
/// | q1 | 0 | 0 | q1 | 0 | 0.0 to 0.3 |
/// | q2 | 0 | 0 | d2 | q2 | -360.0 to 360.0 deg |
/// | q3 | 0 | a2 | d3 | q3 | -360.0 to 360.0 deg |
/// | q4 | 0 | a3 | d4 | q4 | -360.0 to 360.0 deg |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaferPrrr {
    /// `a2` in m.
    pub a2: f64,
    /// `a3` in m.
    pub a3: f64,
    /// `d2` in m.
    pub d2: f64,
    /// `d3` in m.
    pub d3: f64,
    /// `d4` in m.
    pub d4: f64,
}
impl ::core::default::Default for WaferPrrr {
    fn default() -> Self {
        WaferPrrr {
            a2: 0.25,
            a3: 0.2,
            d2: 0.1,
            d3: 0.02,
            d4: 0.03,
        }
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl WaferPrrr {
    /// Number of joints.
    pub const DOF: usize = 4;
    /// Kind, range and name of every joint.
    pub const JOINTS: [::dh_robot::Joint<f64>; 4] = [
        ::dh_robot::Joint::prismatic("q1").with_range(0.0, 0.3),
        ::dh_robot::Joint::revolute("q2")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q3")
            .with_range(-6.283185307179586, 6.283185307179586),
        ::dh_robot::Joint::revolute("q4")
            .with_range(-6.283185307179586, 6.283185307179586),
    ];
    /// Pose of the last frame (with the tool) in the base; angles in radians, lengths in m.
    ///
    /// Cost: 4 multiplications, 8 additions, 3 sine-cosine pairs. Proven equal to the product of the link transforms.
    #[inline]
    #[must_use]
    pub fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        let angles = [q[1] + q[2] + q[3], q[1] + q[2], q[1]];
        let ([s234, s23, s2], [c234, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        ::dh_robot::pose::from_entries(
            [[c234, -s234, 0.0], [s234, c234, 0.0], [0.0, 0.0, 1.0]],
            [
                self.a3 * c23 + self.a2 * c2,
                self.a3 * s23 + self.a2 * s2,
                q[0] + self.d2 + self.d4 + self.d3,
            ],
        )
    }
    /// Pose of every moving link's frame in the base, without the tool.
    ///
    /// Cost: 4 multiplications, 8 additions, 3 sine-cosine pairs.
    #[must_use]
    pub fn frames(
        &self,
        q: &[f64; 4],
    ) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        let angles = [q[1], q[1] + q[2], q[1] + q[2] + q[3]];
        let ([s2, s23, s234], [c2, c23, c234]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = q[0] + self.d2;
        let t_2 = c2 * self.a2;
        let t_3 = s2 * self.a2;
        let t_4 = t + self.d3;
        [
            ::dh_robot::pose::from_entries(
                [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, q[0]],
            ),
            ::dh_robot::pose::from_entries(
                [[c2, -s2, 0.0], [s2, c2, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, t],
            ),
            ::dh_robot::pose::from_entries(
                [[c23, -s23, 0.0], [s23, c23, 0.0], [0.0, 0.0, 1.0]],
                [t_2, t_3, t_4],
            ),
            ::dh_robot::pose::from_entries(
                [[c234, -s234, 0.0], [s234, c234, 0.0], [0.0, 0.0, 1.0]],
                [t_2 + c23 * self.a3, t_3 + s23 * self.a3, t_4 + self.d4],
            ),
        ]
    }
    /// Geometric Jacobian: rows 0..3 linear (m per radian, or 1 for a sliding joint), rows 3..6 angular; base axes, at the
    /// origin of the last frame (or tool).
    ///
    /// Cost: 4 multiplications, 3 additions, 2 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        let angles = [q[1] + q[2], q[1]];
        let ([s23, s2], [c23, c2]) = ::dh_robot::sincos::sincos_batch(&angles);
        let t = self.a3 * c23;
        let t_2 = self.a3 * s23;
        ::dh_robot::nalgebra::SMatrix::from_data(
            ::dh_robot::nalgebra::ArrayStorage([
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                [-(t_2 + self.a2 * s2), t + self.a2 * c2, 0.0, 0.0, 0.0, 1.0],
                [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ]),
        )
    }
    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian) together, for little more than one of them.
    ///
    /// Cost: 4 multiplications, 8 additions, 3 sine-cosine pairs.
    #[inline]
    #[must_use]
    pub fn forward_and_jacobian(
        &self,
        q: &[f64; 4],
    ) -> (
        ::dh_robot::nalgebra::IsometryMatrix3<f64>,
        ::dh_robot::nalgebra::SMatrix<f64, 6, 4>,
    ) {
        let angles = [q[1] + q[2] + q[3], q[1] + q[2], q[1]];
        let ([s234, s23, s2], [c234, c23, c2]) = ::dh_robot::sincos::sincos_batch(
            &angles,
        );
        let t = self.a3 * c23;
        let t_2 = self.a3 * s23;
        let t_3 = t + self.a2 * c2;
        let t_4 = t_2 + self.a2 * s2;
        (
            ::dh_robot::pose::from_entries(
                [[c234, -s234, 0.0], [s234, c234, 0.0], [0.0, 0.0, 1.0]],
                [t_3, t_4, self.d4 + self.d3 + self.d2 + q[0]],
            ),
            ::dh_robot::nalgebra::SMatrix::from_data(
                ::dh_robot::nalgebra::ArrayStorage([
                    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                    [-t_4, t_3, 0.0, 0.0, 0.0, 1.0],
                    [-t_2, t, 0.0, 0.0, 0.0, 1.0],
                    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
                ]),
            ),
        )
    }
}
impl ::dh_robot::Robot<4, f64> for WaferPrrr {
    fn joints(&self) -> &'static [::dh_robot::Joint<f64>; 4] {
        &Self::JOINTS
    }
}
impl ::dh_robot::ForwardKinematics<4, f64> for WaferPrrr {
    #[inline]
    fn forward(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::IsometryMatrix3<f64> {
        WaferPrrr::forward(self, q)
    }
    #[inline]
    fn frames(&self, q: &[f64; 4]) -> [::dh_robot::nalgebra::IsometryMatrix3<f64>; 4] {
        WaferPrrr::frames(self, q)
    }
}
impl ::dh_robot::Jacobian<4, f64> for WaferPrrr {
    #[inline]
    fn jacobian(&self, q: &[f64; 4]) -> ::dh_robot::nalgebra::SMatrix<f64, 6, 4> {
        WaferPrrr::jacobian(self, q)
    }
}
