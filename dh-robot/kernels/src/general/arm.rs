//! The arm of the general elimination: six joints, lengths over its reach.

use super::super::chain::Chain;
use super::super::elementary::wrapped;
use super::super::pose::{Pose, slide};
use super::choice::Choice;

/// A six-joint arm without usable structure.
#[derive(Clone, Copy, Debug)]
pub struct General6R {
    /// With lengths over the reach.
    pub(super) arm: Chain<6>,
    pub(super) reach: f64,
    /// The best choices first.
    pub(super) choices: [Choice; 3],
}

impl General6R {
    /// The arm `Rz(q1) C1 ... Rz(q6) C6` with the constant transforms `links`. `choices` are the best of
    /// [`rank`](super::rank); the second and third one are only used where the first one meets a degenerate root.
    pub fn new(links: &[Pose; 6], choices: [Choice; 3]) -> Self {
        Self::with_slides(links, &[false; 6], choices)
    }

    /// The same with `Tz(q)` instead of `Rz(q)` where `slides`: one joint, or two neighbours in the closed loop (1 and 6 are neighbours
    /// too). Other arms have no usable choice.
    pub fn with_slides(links: &[Pose; 6], slides: &[bool; 6], choices: [Choice; 3]) -> Self {
        let mut arm = Chain { links: shortened(links), slides: *slides };
        let reach = arm.reach();
        for link in &mut arm.links {
            *link = shrunk(link, reach);
        }
        Self { arm, reach, choices }
    }

    /// The arm with lengths over its reach.
    pub(super) fn scaled_arm(&self) -> &Chain<6> {
        &self.arm
    }

    /// A joint vector with lengths over the reach.
    pub(super) fn scaled(&self, q: &[f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.slides[j] { q[j] / self.reach } else { q[j] })
    }

    /// A target with lengths over the reach.
    pub(super) fn scaled_target(&self, target: &Pose) -> Pose {
        shrunk(target, self.reach)
    }

    /// The same joint vector with angles in (-pi, pi].
    pub(super) fn wrapped(&self, q: [f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.slides[j] { q[j] } else { wrapped(q[j]) })
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

/// A pose with lengths over `reach`.
fn shrunk(pose: &Pose, reach: f64) -> Pose {
    pose.map(|[a, b, c, d]| [a, b, c, d / reach])
}
