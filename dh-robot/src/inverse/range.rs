//! Joint ranges on self-motions: the point that represents a self-motion is moved into the ranges where it passes through them.

use super::verifier::Verifier;
use crate::Real;
use dh_kernels::Kinematics;

/// Steps along a self-motion (rad, or length scales), and how many on each side: a whole turn.
const STEP: f64 = 0.02;
const STEPS: u16 = 314;
/// Distance kept from a limit (rad, or table units).
const EDGE: f64 = 0.01;

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Moves representatives that are out of range along their self-motion, no farther than needed, where that is one motion at
    /// constant joint rates.
    pub(super) fn move_into_ranges(&mut self) {
        for i in 0..self.out.len() {
            let Some(solution) = self.out.get(i).filter(|s| !s.free.is_empty()) else { continue };
            let q = solution.q.map(T::to_f64);
            if !self.inside(&q)
                && let Some(moved) = self.moved_inside(&q)
                && let Some(solution) = self.out.get_mut(i)
            {
                for ((x, joint), place) in moved.iter().zip(self.setting.joints).zip(&mut solution.q) {
                    *place = joint.normalize(T::of(*x));
                }
            }
        }
    }

    pub(super) fn inside(&self, q: &[f64; N]) -> bool {
        self.setting.joints.iter().zip(q).all(|(joint, x)| joint.contains(joint.normalize(T::of(*x))))
    }

    /// The same by arithmetic: along a motion at constant rates each joint is in range at certain stretches, whose ends are tried.
    pub(super) fn keep_in_ranges(&mut self) {
        for i in 0..self.out.len() {
            let Some(solution) = self.out.get(i).filter(|s| !s.free.is_empty()) else { continue };
            let q = solution.q.map(T::to_f64);
            if self.inside(&q) {
                continue;
            }
            let motions = self.motions(&q);
            let Some(v) = motions.list.first().filter(|_| motions.len == 1) else { continue };
            let mut best: Option<(f64, [f64; N])> = None;
            for (k, joint) in self.setting.joints.iter().enumerate() {
                let Some((least, greatest)) = joint.range.filter(|_| v[k].abs() > 1e-6) else { continue };
                let unit = if joint.is_revolute() { 1.0 } else { self.setting.length_scale };
                let inset = EDGE.min(0.25 * (greatest - least).to_f64());
                for end in [least.to_f64() + inset, greatest.to_f64() - inset] {
                    for turn in if joint.is_revolute() { [0.0, 1.0, -1.0] } else { [0.0; 3] } {
                        let t = (end - q[k] + turn * core::f64::consts::TAU) / (v[k] * unit);
                        let moved = self.moved_by(&q, v, t);
                        if best.is_none_or(|(s, _)| t.abs() < s) && self.inside(&moved) {
                            best = Some((t.abs(), moved));
                        }
                    }
                }
            }
            let found = best.filter(|(_, moved)| self.miss(moved) <= self.tolerance);
            if let (Some((_, moved)), Some(solution)) = (found, self.out.get_mut(i)) {
                for ((x, joint), place) in moved.iter().zip(self.setting.joints).zip(&mut solution.q) {
                    *place = joint.normalize(T::of(*x));
                }
            }
        }
    }

    #[cold]
    fn moved_inside(&self, q: &[f64; N]) -> Option<[f64; N]> {
        let motions = self.motions(q);
        let v = motions.list.first().filter(|_| motions.len == 1)?;
        (1..=STEPS)
            .flat_map(|k| [1.0, -1.0].map(|sign| sign * STEP * f64::from(k)))
            .map(|t| self.moved_by(q, v, t))
            .find(|moved| self.inside(moved) && self.miss(moved) <= self.tolerance)
    }
}
