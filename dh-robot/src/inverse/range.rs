//! Where a continuum of solutions passes through the ranges of the joints, its representative is taken there.

use super::verifier::Verifier;
use crate::Real;
use dh_kernels::Kinematics;

/// Steps along a continuum (rad, or reach), and how many on each side: a whole turn.
const STEP: f64 = 0.02;
const STEPS: u16 = 314;

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Moves representatives that are out of range along their continuum, no farther than needed, where one motion leads along it at
    /// constant rates.
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

    fn inside(&self, q: &[f64; N]) -> bool {
        self.setting.joints.iter().zip(q).all(|(joint, x)| joint.contains(joint.normalize(T::of(*x))))
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
