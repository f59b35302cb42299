//! Which joints are free at a solution: the motions of the arm that leave the target reached.

use super::Verifier;
use crate::ik::Kinematics;
use crate::{FreeJoints, Real};

/// A pivot below this (position over reach, rotation in rad, per rad or reach) counts as zero: a singular pose.
const SINGULAR: f64 = 1e-7;
/// Length of the trial step along a motion.
const STEP: f64 = 0.05;

/// Motions that leave the task alone to first order: a basis, each with its largest entry 1.
struct Motions<const N: usize> {
    list: [[f64; N]; N],
    len: usize,
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// The joints that take part in motions which keep the target reached; none at a regular solution, and none where a
    /// singular solution stands alone (the arm stretched out). With `exact` the latter isn't looked into.
    pub(super) fn free_joints(&mut self, q: &[f64; N], exact: bool) -> FreeJoints {
        let motions = self.motions(q);
        let mut free = FreeJoints::NONE;
        for v in motions.list.iter().take(motions.len) {
            if exact {
                for k in (0..N).filter(|k| v[*k].abs() > 1e-6) {
                    free = free.with(k);
                }
            } else {
                free = free.union(self.moved_along(q, v));
            }
        }
        free
    }

    /// The joints that moved after a step along a motion and back onto the target.
    fn moved_along(&mut self, q: &[f64; N], v: &[f64; N]) -> FreeJoints {
        let reach = self.setting.reach;
        let unit: [f64; N] =
            core::array::from_fn(|k| if self.setting.joints[k].is_revolute() { STEP } else { STEP * reach });
        for sign in [1.0, -1.0] {
            let mut x: [f64; N] = core::array::from_fn(|k| q[k] + sign * unit[k] * v[k]);
            if !crate::ik::polish(self.arm, &mut x, self.task, reach, 60).reaches(self.tolerance) {
                continue;
            }
            let moved = |k: usize| (x[k] - q[k]).abs() / unit[k];
            if (0..N).any(|k| moved(k) > 0.1) {
                return (0..N).filter(|k| moved(*k) > 1e-3).fold(FreeJoints::NONE, FreeJoints::with);
            }
        }
        FreeJoints::NONE
    }

    /// The null space of the task's Jacobian, by Gauss-Jordan elimination with full pivoting.
    fn motions(&self, q: &[f64; N]) -> Motions<N> {
        let reach = self.setting.reach;
        let (pose, j) = self.arm.forward_and_jacobian(q);
        let mut j = self.task.rows(&pose, j, reach);
        for row in &mut j {
            for k in 0..N {
                if !self.setting.joints[k].is_revolute() {
                    row[k] *= reach;
                }
            }
        }
        let mut pivot = [usize::MAX; 6];
        for r in 0..6 {
            let mut best = (0.0, 0, 0);
            for (i, row) in j.iter().enumerate().skip(r) {
                for (k, x) in row.iter().enumerate() {
                    if x.abs() > best.0 && !pivot.contains(&k) {
                        best = (x.abs(), i, k);
                    }
                }
            }
            let (size, i, k) = best;
            if size < SINGULAR {
                break;
            }
            j.swap(r, i);
            pivot[r] = k;
            let lead = j[r];
            for (i, row) in j.iter_mut().enumerate() {
                let factor = row[k] / lead[k];
                if i != r && factor != 0.0 {
                    for (x, y) in row.iter_mut().zip(&lead) {
                        *x -= factor * y;
                    }
                }
            }
        }
        let mut motions = Motions { list: [[0.0; N]; N], len: 0 };
        for k in (0..N).filter(|k| !pivot.contains(k) && self.setting.given.is_none_or(|g| g.0 != *k)) {
            let mut v = [0.0; N];
            v[k] = 1.0;
            for (p, row) in pivot.iter().zip(&j) {
                if let Some(x) = v.get_mut(*p) {
                    *x = -row[k] / row[*p];
                }
            }
            let size = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            motions.list[motions.len] = v.map(|x| x / size);
            motions.len += 1;
        }
        motions
    }
}
