//! The null space of the task's Jacobian at a solution, and the joints that are free there.

use super::verifier::Verifier;
use crate::{FreeJoints, Real};
use dh_kernels::Kinematics;

/// A pivot below this (position over the length scale, rotation in rad, per rad or length scale) counts as zero: a singular pose.
const SINGULAR: f64 = 1e-7;
/// The same for a target in `f32`: rounding moves a double root by the square root of 6e-8 and some more.
const SINGULAR_SINGLE: f64 = 1e-3;
/// Length of the first trial step along a motion that isn't straight (rad, or length scales): long enough to tell a curve of solutions from a
/// double one.
const FIRST: f64 = 0.05;
/// Length of the further steps, and their number.
const STRIDE: f64 = 0.25;
const FOLLOWED: usize = 8;
/// A step along a curve that loses more than the rest of its length on the way back to the target leads nowhere.
const KEPT: f64 = 0.4;
/// Steps along a straight motion.
const STRAIGHT: [f64; 3] = [0.9, -2.2, 1.7];
/// Steps along several motions at once, of no special length.
const OBLIQUE: [f64; 3] = [0.41, -0.57, 0.33];

/// Motions that leave the task alone to first order: a basis, each with its largest entry 1; in rad and length scales.
pub(super) struct Motions<const N: usize> {
    pub(super) list: [[f64; N]; N],
    pub(super) len: usize,
    /// The product of the pivots that do not count as zero: it vanishes where the null space gains a dimension.
    pub(super) volume: f64,
}

impl<const N: usize> Motions<N> {
    /// Directions to try: the basis, then sums and differences of two of it, since where curves of solutions cross none of them need go
    /// in a direction of the basis.
    pub(super) fn directions(&self) -> impl Iterator<Item = [f64; N]> + '_ {
        let basis = self.list.iter().take(self.len);
        let pairs = (0..self.len).flat_map(|i| (0..i).flat_map(move |j| [(i, j, 1.0), (i, j, -1.0)]));
        basis.copied().chain(pairs.filter_map(|(i, j, sign)| {
            let both: [f64; N] = core::array::from_fn(|k| self.list[i][k] + sign * self.list[j][k]);
            let size = both.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            (size > 1e-6).then(|| both.map(|x| x / size))
        }))
    }
}

/// What is free at a singular solution.
pub(super) struct Freedom {
    /// The joints that take part in motions which keep the target reached; none where the solution is isolated (the arm
    /// stretched out).
    pub(super) joints: FreeJoints,
    /// Whether each of the motions can be followed without end, all joints at constant rates.
    pub(super) straight: bool,
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Whether the null space is empty: every motion of the arm moves the tool.
    #[inline]
    pub(super) fn is_regular(&self, q: &[f64; N]) -> bool {
        self.motions(q).len == 0
    }

    /// What is free at a solution.
    pub(super) fn freedom(&self, q: &[f64; N]) -> Freedom {
        let motions = self.motions(q);
        let mut freedom = Freedom { joints: FreeJoints::NONE, straight: true };
        for (i, v) in motions.directions().enumerate() {
            if i < motions.len || freedom.joints.is_empty() {
                self.add_motion(q, &v, &mut freedom);
            }
        }
        if motions.len > 1 && !freedom.joints.is_empty() {
            // On a two-dimensional self-motion some joints may be at rest at `q` only. (A smaller null space away from `q`: curves that cross there.)
            let oblique = self.oblique(q, &motions);
            if self.motions(&oblique).len == motions.len {
                let way = self.apart(q, &oblique);
                freedom.joints = (0..N).filter(|k| way[*k].abs() > 1e-3).fold(freedom.joints, FreeJoints::with);
            }
        }
        freedom
    }

    /// A generic point of the self-motion that `motions` begin at `q`; `q` itself where there is none.
    fn oblique(&self, q: &[f64; N], motions: &Motions<N>) -> [f64; N] {
        let mut way = [0.0; N];
        for (v, size) in motions.list.iter().take(motions.len).zip(OBLIQUE) {
            way = core::array::from_fn(|k| way[k] + size * v[k]);
        }
        let kept = |x: &[f64; N]| self.apart(q, x).iter().zip(&way).all(|(d, v)| (d - v).abs() < 0.2);
        self.step(q, &way, 1.0).filter(kept).unwrap_or(*q)
    }

    /// A step in a direction, and back onto the target, as near as `q` is.
    pub(super) fn step(&self, q: &[f64; N], way: &[f64; N], stride: f64) -> Option<[f64; N]> {
        let level = self.level(q);
        let mut next = self.moved_by(q, way, stride);
        self.brought_back(&mut next, 60, level).then_some(next)
    }

    /// The direction in which a curve goes on at `x`, after a step; its largest entry is 1.
    pub(super) fn onward(&self, x: &[f64; N], step: &[f64; N]) -> Option<[f64; N]> {
        let way = self.within_motions(x, step);
        let size = way.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        (size > 1e-6).then(|| way.map(|x| x / size))
    }

    /// Notes the joints that move along a motion.
    fn add_motion(&self, q: &[f64; N], v: &[f64; N], freedom: &mut Freedom) {
        let level = self.level(q);
        let moved = if STRAIGHT.iter().all(|t| self.miss(&self.moved_by(q, v, *t)) <= level) {
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
                let Some(next) = self.step(&x, &way, stride) else { break };
                let step = self.apart(&x, &next);
                if !step.iter().any(|d| d.abs() > KEPT * stride) {
                    break;
                }
                free = (0..N).filter(|k| step[*k].abs() > 1e-3 * stride).fold(free, FreeJoints::with);
                let Some(onward) = self.onward(&next, &step) else { break };
                (x, way) = (next, onward);
            }
        }
        free
    }

    /// The null space of the task's Jacobian, by Gauss-Jordan elimination with full pivoting.
    pub(super) fn motions(&self, q: &[f64; N]) -> Motions<N> {
        let length_scale = self.setting.length_scale;
        let (pose, j) = self.arm.forward_and_jacobian(q);
        let mut j = self.task.rows(&pose, j, length_scale);
        for row in &mut j {
            for k in 0..N {
                if !self.setting.joints[k].is_revolute() {
                    row[k] *= length_scale;
                }
            }
        }
        let singular = if T::EPSILON > T::of(1e-10) { SINGULAR_SINGLE } else { SINGULAR };
        let (mut pivot, mut used) = ([usize::MAX; 6], [false; N]);
        let mut volume = 1.0;
        for r in 0..6 {
            let mut best = (0.0, 0, 0);
            for (i, row) in j.iter().enumerate().skip(r) {
                for (k, (x, used)) in row.iter().zip(&used).enumerate() {
                    if !used && x.abs() > best.0 {
                        best = (x.abs(), i, k);
                    }
                }
            }
            let (size, i, k) = best;
            if size < singular {
                break;
            }
            volume *= size;
            j.swap(r, i);
            (pivot[r], used[k]) = (k, true);
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
        let mut motions = Motions { list: [[0.0; N]; N], len: 0, volume };
        for k in (0..N).filter(|k| !used[*k] && self.setting.given[*k].is_none()) {
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
