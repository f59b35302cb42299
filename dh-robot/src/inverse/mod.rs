//! The numeric part of every generated inverse: candidates of the closed form in, verified solutions out.
//!
//! A candidate is put through forward kinematics; one that misses the target by more than rounding is polished; one that still
//! misses is dropped. Where the closed form degenerates at a pose, `rescue` looks for the solutions it lost. Solutions that a
//! self-motion of the arm connects (`connectivity`) count as one, and one point of each self-motion is kept.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

mod attempt;
mod cells;
mod connectivity;
mod fallback;
mod frame;
mod intersection;
mod near;
mod newton;
mod null_space;
mod path;
mod range;
mod rescue;
mod self_motion;
mod sheets;
mod tangent;
mod task_distance;
mod verifier;
mod work;

pub use attempt::{Attempt, Sample};
pub use fallback::solve as solve_bounded;
pub use frame::{direction, frame_of, frame_of_axis, frame_of_plane, in_units, to_pose};
pub use near::{nearest, solve_near};
pub use path::Path;
pub use tangent::self_motion;
pub use work::Work;

use crate::{Branch, Joint, Real, Solutions, Why};
use dh_kernels::{Kinematics, Pose, TaskTarget};
use verifier::Verifier;

/// What a generated inverse knows of its arm.
#[derive(Clone, Copy, Debug)]
pub struct Setting<T: 'static, const N: usize> {
    /// The joints.
    pub joints: &'static [Joint<T>; N],
    /// Sum of the link lengths, in table units.
    pub length_scale: f64,
    /// Whether the arm reaches fewer dimensions than the task has.
    pub rank_deficient: bool,
    /// The values of the joints that the caller gives.
    pub given: [Option<f64>; N],
}

/// Runs the closed form on a target and verifies what it finds.
///
/// `frame` is the target with lengths over the length scale, `task` what of it counts. `candidates` runs the plan with a choice of values for
/// free unknowns, and calls its last argument with every candidate: joint values in table units, branch, joints left free.
pub fn solve<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &TaskTarget,
    frame: &Pose,
    candidates: impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) -> Solutions<T, N, M> {
    let mut verifier = Verifier::new(arm, setting, task);
    if let Some(why) = too_far(arm, setting.length_scale, frame) {
        verifier.out.refuse(why);
        return verifier.out;
    }
    let attempt =
        candidates(frame, &Sample::FIRST.thorough(), &mut |q, branch, path| verifier.take(q, branch, path.joints));
    let status = attempt.status;
    if status.degenerate || verifier.lost || status.lost || status.doubt && verifier.out.is_empty() {
        rescue::rescue(&mut verifier, frame, &attempt, &candidates);
    }
    verifier.move_into_ranges();
    if verifier.out.is_empty() {
        let why = if setting.rank_deficient { verifier.distance_to_task(&attempt.why) } else { None };
        let why = why.unwrap_or_else(|| {
            let nearest = verifier.nearest;
            let missed = if nearest.is_finite() { Why::NotVerified { error: nearest } } else { Why::NoSolution };
            attempt.why.or_nearer(missed)
        });
        verifier.out.refuse(convert(why));
    }
    verifier.out
}

/// A distance, in length scales, whose squares say nothing any more. No arm is moved there.
const OUT_OF_HAND: f64 = 1e12;

/// The reason why a target is refused whose position is out of hand.
fn too_far<T: Real, const N: usize>(arm: &impl Kinematics<N>, length_scale: f64, frame: &Pose) -> Option<Why<T>> {
    let far = frame.iter().fold(0.0_f64, |m, row| m.max(row[3].abs()));
    (far > OUT_OF_HAND).then(|| Why::OutOfReach {
        step: "the target",
        needs: T::of(far * length_scale),
        has: T::of(OUT_OF_HAND * length_scale),
        unit: arm.unit(),
    })
}

fn convert<T: Real>(why: Why<f64>) -> Why<T> {
    match why {
        Why::OutOfReach { step, needs, has, unit } => {
            Why::OutOfReach { step, needs: T::of(needs), has: T::of(has), unit }
        }
        Why::NoRealRoot { step } => Why::NoRealRoot { step },
        Why::NotOnTask { what, by, unit } => Why::NotOnTask { what, by: T::of(by), unit },
        Why::NotVerified { error } => Why::NotVerified { error: T::of(error) },
        _ => Why::NoSolution,
    }
}
