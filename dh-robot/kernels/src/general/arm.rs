//! The arm of the general elimination: six joints, lengths over its length scale.

use super::super::chain::NumericChain;
use super::super::elementary::wrapped;
use super::super::pose::{Pose, slide};
use super::choice::Choice;

/// A six-joint arm without usable structure.
#[derive(Clone, Copy, Debug)]
pub struct General6R {
    /// With lengths over the length scale.
    pub(super) arm: NumericChain<6>,
    pub(super) length_scale: f64,
    /// The best choices first.
    pub(super) choices: [Choice; 3],
}

impl General6R {
    /// The arm `Rz(q1) C1 ... Rz(q6) C6` with the constant transforms `links`. `choices` are the best of
    /// [`rank`](super::rank); the second and third one are only used where the first one meets a degenerate root.
    pub fn new(links: &[Pose; 6], choices: [Choice; 3]) -> Self {
        Self::with_prismatic(links, &[false; 6], choices)
    }

    /// The same with `Tz(q)` instead of `Rz(q)` where `prismatic`: one joint, or two neighbours in the closed loop (1 and 6 are neighbours
    /// too). Other arms have no usable choice.
    pub fn with_prismatic(links: &[Pose; 6], prismatic: &[bool; 6], choices: [Choice; 3]) -> Self {
        let mut arm = NumericChain { links: shortened(links), prismatic: *prismatic };
        let length_scale = arm.length_scale();
        for link in &mut arm.links {
            *link = shrunk(link, length_scale);
        }
        Self { arm, length_scale, choices }
    }

    /// The arm with lengths over its length scale.
    pub(super) fn scaled_arm(&self) -> &NumericChain<6> {
        &self.arm
    }

    /// A joint vector with lengths over the length scale.
    pub(super) fn scaled(&self, q: &[f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.prismatic[j] { q[j] / self.length_scale } else { q[j] })
    }

    /// A target with lengths over the length scale.
    pub(super) fn scaled_target(&self, target: &Pose) -> Pose {
        shrunk(target, self.length_scale)
    }

    /// The same joint vector with angles in (-pi, pi].
    pub(super) fn wrapped(&self, q: [f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.prismatic[j] { q[j] } else { wrapped(q[j]) })
    }
}

/// The same links with every frame moved along its own axis to where the frame before is nearest.
///
/// Axes that are parallel but for a ten-thousandth of a radian (calibrated arms) have their common normal a hundred metres away, and a table
/// goes there and back. No joint sees the difference.
fn shortened(links: &[Pose; 6]) -> [Pose; 6] {
    let mut out = *links;
    for i in 1..6 {
        let [before, after] = [out[i - 1], out[i]];
        let by = -(before[0][2] * before[0][3] + before[1][2] * before[1][3] + before[2][2] * before[2][3]);
        out[i - 1] = slide(&before, by);
        out[i] = after;
        out[i][2][3] -= by;
    }
    out
}

/// A pose with lengths over the length scale`.
fn shrunk(pose: &Pose, length_scale: f64) -> Pose {
    pose.map(|[a, b, c, d]| [a, b, c, d / length_scale])
}
