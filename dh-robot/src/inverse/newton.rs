//! Damped Newton steps that bring a candidate of the plan onto its target, counted against the bounds of a call.

use super::work::Work;
use crate::math::sqrt;
use dh_kernels::{Kinematics, TaskTarget};

/// Moves `q` onto the target by at most `steps` Newton steps and gives back by how much it misses in the end; ends where the miss is below
/// `goal`, or where steps do not help. `q` never gets worse.
pub(super) fn newton<const N: usize>(
    arm: &impl Kinematics<N>,
    task: &TaskTarget,
    length_scale: f64,
    q: &mut [f64; N],
    steps: usize,
    goal: f64,
    work: &mut Work,
) -> f64 {
    let (miss, taken) = dh_kernels::newton(arm, task, length_scale, q, steps.min(work.steps_left()), goal);
    work.steps += taken as u32;
    work.evaluations += taken as u32 + 1;
    miss
}

/// The length of a joint motion.
pub(super) fn length<const N: usize>(v: &[f64; N]) -> f64 {
    sqrt(v.iter().map(|x| x * x).sum())
}
