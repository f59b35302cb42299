//! The distance from the target to the reachable set of a rank-deficient arm, for `Why::NotOnTask`.

use super::verifier::Verifier;
use crate::{Real, Why, math};
use dh_kernels::{Kinematics, polish};

/// Starts of the search for the nearest pose, where the plan led to none.
const STARTS: usize = 12;
/// A smaller miss means a target close to the reachable set, whichever step found that out (radians, or lengths over the length scale).
const NEAR: f64 = 0.05;
/// Steps of each.
const STEPS: usize = 40;

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// By how much the arm misses the target at its nearest pose; `why` itself where that reports a smaller distance.
    ///
    /// (Steps with contradicting equations report numbers that mean nothing to a user.)
    #[cold]
    pub(super) fn distance_to_task(&mut self, why: &Why<f64>) -> Option<Why<f64>> {
        let gap = match *why {
            Why::OutOfReach { needs, has, unit, .. } if !unit.is_empty() => {
                (needs - has).abs() / self.setting.length_scale
            }
            _ => f64::INFINITY,
        };
        // Beside a singular pose a short distance may be missing, for a small tilt.
        if !self.nearest.is_finite() && (gap.is_infinite() || gap < NEAR) {
            for start in 1..=STARTS {
                let mut q = self.start(start);
                let polished = polish(self.arm, &mut q, self.task, self.setting.length_scale, STEPS);
                let miss = polished.position.max(polished.rotation);
                if miss < self.nearest {
                    (self.nearest, self.best) = (miss, q);
                }
            }
        }
        if !self.nearest.is_finite() || self.nearest > gap.max(NEAR) {
            return (gap.is_finite()).then_some(*why);
        }
        self.miss_of_best()
    }

    /// By how much the nearest joint vector that was found misses the target.
    pub(super) fn miss_of_best(&self) -> Option<Why<f64>> {
        if !self.nearest.is_finite() {
            return None;
        }
        let e = self.task.error(&self.arm.forward(&self.best), self.setting.length_scale);
        let size = |v: &[f64]| math::sqrt(v.iter().map(|x| x * x).sum::<f64>());
        let (position, rotation) = (size(&e[..3]), size(&e[3..]));
        Some(if rotation >= position {
            Why::NotOnTask { what: "its orientation", by: rotation, unit: "rad" }
        } else {
            Why::NotOnTask { what: "its position", by: position * self.setting.length_scale, unit: self.arm.unit() }
        })
    }
}
