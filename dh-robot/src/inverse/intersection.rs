//! Intersections of self-motions: a curve of solutions may have points at which another curve begins.
//!
//! The plan does not see them: the value of a free joint at which a later step becomes free too is not among the values that are tried.
//! (With the wrist centre on the second axis, joints 2 and 5 turn together, and where joint 5 passes zero, joints 4 and 6 may turn.) So
//! each curve is followed, and where the null space gains a dimension, a step is taken along it.

use super::verifier::Verifier;
use crate::{Branch, Real};
use dh_kernels::Kinematics;

/// Length of the steps along a curve (rad, or length scales), and their number: a whole turn and a little more.
const STRIDE: f64 = 0.3;
const FOLLOWED: usize = 22;
/// A volume this much smaller than one of its neighbours may have a zero beside it.
const DIP: f64 = 0.6;
/// Steps of a golden section from twice `STRIDE` to 1e-9, and its ratio.
const GOLDEN: usize = 42;
const RATIO: f64 = 0.618_033_988_749_894_8;
/// Length of the step along a direction that becomes free.
const ASIDE: f64 = 0.4;

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Finds the curves that cross the known curves of solutions.
    pub(super) fn take_intersections(&mut self) {
        for i in 0..M {
            let Some(known) = self.out.get(i) else { return };
            let p = known.q.map(T::to_f64);
            if known.free.is_empty() {
                continue;
            }
            // Away from `p`, where curves may cross already.
            for v in self.motions(&p).directions() {
                let Some(q) = self.step(&p, &v, ASIDE) else { continue };
                let motions = self.motions(&q);
                for way in motions.list.iter().take(motions.len) {
                    self.follow(&q, *way, motions.len);
                }
            }
        }
    }

    /// Follows the curve that leaves `p` in a direction, once round, and looks for points with one more free direction.
    fn follow(&mut self, p: &[f64; N], way: [f64; N], dim: usize) {
        let (mut x, mut way) = (*p, way);
        let (mut before, mut here) = (0.0_f64, self.gap(p, dim));
        for _ in 0..FOLLOWED {
            let Some(next) = self.step(&x, &way, STRIDE) else { return };
            let there = self.gap(&next, dim);
            if here <= before.min(there) && here < DIP * before.max(there) {
                self.take_dip(&x, &way, dim);
            }
            let Some(onward) = self.onward(&next, &self.apart(&x, &next)) else { return };
            (x, way, before, here) = (next, onward, here, there);
        }
    }

    /// How far a point of a self-motion of `dim` dimensions is from one more free direction; 0 where it has one.
    fn gap(&self, x: &[f64; N], dim: usize) -> f64 {
        let motions = self.motions(x);
        if motions.len > dim { 0.0 } else { motions.volume }
    }

    /// Takes solutions beside the point near `x` that has one more free direction, if there is one.
    fn take_dip(&mut self, x: &[f64; N], way: &[f64; N], dim: usize) {
        let at = |t: f64| self.step(x, way, t).map_or(f64::INFINITY, |x| self.gap(&x, dim));
        let (mut a, mut b) = (-STRIDE, STRIDE);
        let (mut low, mut high) = (b - RATIO * (b - a), a + RATIO * (b - a));
        let (mut at_low, mut at_high) = (at(low), at(high));
        for _ in 0..GOLDEN {
            if at_low < at_high {
                (b, high, at_high) = (high, low, at_low);
                low = b - RATIO * (b - a);
                at_low = at(low);
            } else {
                (a, low, at_low) = (low, high, at_high);
                high = a + RATIO * (b - a);
                at_high = at(high);
            }
        }
        let Some(y) = self.step(x, way, if at_low < at_high { low } else { high }) else { return };
        let motions = self.motions(&y);
        if motions.len <= dim {
            return;
        }
        for v in motions.directions() {
            for aside in [ASIDE, -ASIDE] {
                if let Some(z) = self.step(&y, &v, aside) {
                    self.take_singular(z, Branch::ANY);
                }
            }
        }
    }
}
