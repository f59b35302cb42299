//! Which joints are free at a solution: the motions of the arm that leave the target reached.

use super::verifier::Verifier;
use crate::ik::Kinematics;
use crate::{FreeJoints, Real};

/// A pivot below this (position over reach, rotation in rad, per rad or reach) counts as zero: a singular pose.
const SINGULAR: f64 = 1e-7;
/// Length of the first trial step along a motion that isn't straight (rad, or reach): long enough to tell a curve of solutions from a
/// double one.
const FIRST: f64 = 0.05;
/// Length of the further steps, and their number.
const STRIDE: f64 = 0.25;
const FOLLOWED: usize = 8;
/// A step along a curve that loses more than the rest of its length on the way back to the target leads nowhere.
const KEPT: f64 = 0.4;
/// Steps along a straight motion.
const STRAIGHT: [f64; 3] = [0.9, -2.2, 1.7];

/// Motions that leave the task alone to first order: a basis, each with its largest entry 1; in rad and reach.
pub(super) struct Motions<const N: usize> {
    pub(super) list: [[f64; N]; N],
    pub(super) len: usize,
}

/// What is free at a singular solution.
pub(super) struct Freedom {
    /// The joints that take part in motions which keep the target reached; none where the solution stands alone (the arm
    /// stretched out).
    pub(super) joints: FreeJoints,
    /// Each of the motions can be followed as far as one likes, all joints at constant rates.
    pub(super) straight: bool,
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Does every motion of the arm move the target?
    #[inline]
    pub(super) fn is_regular(&self, q: &[f64; N]) -> bool {
        self.motions(q).len == 0
    }

    /// What is free at a solution.
    pub(super) fn freedom(&self, q: &[f64; N]) -> Freedom {
        let motions = self.motions(q);
        let mut freedom = Freedom { joints: FreeJoints::NONE, straight: true };
        for v in motions.list.iter().take(motions.len) {
            self.add_motion(q, v, &mut freedom);
        }
        if freedom.joints.is_empty() && motions.len > 1 {
            // Where curves of solutions cross, none of them need go in a direction of the basis.
            for i in 0..motions.len {
                for j in 0..i {
                    for sign in [1.0, -1.0] {
                        let both: [f64; N] =
                            core::array::from_fn(|k| motions.list[i][k] + sign * motions.list[j][k]);
                        let size = both.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                        if size > 1e-6 {
                            self.add_motion(q, &both.map(|x| x / size), &mut freedom);
                        }
                    }
                }
            }
        }
        freedom
    }

    /// Notes the joints that move along a motion.
    fn add_motion(&self, q: &[f64; N], v: &[f64; N], freedom: &mut Freedom) {
        let moved = if STRAIGHT.iter().all(|t| self.miss(&self.moved_by(q, v, *t)) <= self.tolerance) {
            (0..N).filter(|k| v[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with)
        } else {
            let moved = self.moved_along(q, v);
            freedom.straight &= moved.is_empty();
            moved
        };
        freedom.joints = freedom.joints.union(moved);
    }

    /// The joints that move along the curve of solutions which a motion begins; none if there is no such curve.
    fn moved_along(&self, q: &[f64; N], v: &[f64; N]) -> FreeJoints {
        let mut free = FreeJoints::NONE;
        for sign in [1.0, -1.0] {
            let mut x = *q;
            let mut way = v.map(|v| sign * v);
            for stride in core::iter::once(FIRST).chain([STRIDE; FOLLOWED]) {
                let mut next = self.moved_by(&x, &way, stride);
                if !self.brought_back(&mut next, 60).reaches(self.tolerance) {
                    break;
                }
                let step = self.apart(&x, &next);
                if !step.iter().any(|d| d.abs() > KEPT * stride) {
                    break;
                }
                free = (0..N).filter(|k| step[*k].abs() > 1e-3 * stride).fold(free, FreeJoints::with);
                x = next;
                way = self.within_motions(&x, &step);
                let size = way.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                if !(size > 1e-6) {
                    break;
                }
                way = way.map(|x| x / size);
            }
        }
        free
    }

    /// The null space of the task's Jacobian, by Gauss-Jordan elimination with full pivoting.
    pub(super) fn motions(&self, q: &[f64; N]) -> Motions<N> {
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
