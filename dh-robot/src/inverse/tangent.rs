//! The direction in joint space in which a self-motion leaves a solution.

use super::Setting;
use super::verifier::Verifier;
use crate::{Real, Solution};
use dh_kernels::{Kinematics, Pose, TaskTarget};

/// The direction of a solution's self-motion: joint speeds that keep the tool where `task` asks for it, the largest of them 1 (radians, or lengths
/// over the length scale). `None` at a solution without free joints. Of several motions it is one that moves free joints only.
pub fn self_motion<T: Real, const N: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: impl Fn(&Pose) -> TaskTarget,
    solution: &Solution<T, N>,
) -> Option<[T; N]> {
    if solution.free.is_empty() {
        return None;
    }
    let q = solution.q.map(T::to_f64);
    let task = task(&arm.forward(&q));
    let verifier: Verifier<'_, _, T, N, 1> = Verifier::new(arm, setting, &task);
    let motions = verifier.motions(&q);
    let within = |v: &&[f64; N]| (0..N).all(|k| solution.free.contains(k) || v[k].abs() < 1e-6);
    let motion =
        motions.list.iter().take(motions.len).find(within).or(motions.list.first().filter(|_| motions.len > 0))?;
    let unit = |k: usize| if setting.joints[k].is_revolute() { 1.0 } else { setting.length_scale };
    Some(core::array::from_fn(|k| T::of(motion[k] * unit(k))))
}
