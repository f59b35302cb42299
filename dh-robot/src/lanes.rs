//! The fast way of generated inverses: all branches of a plan side by side, without a jump.
//!
//! Every step solves its equation for all branches found so far, in plain loops over arrays that the compiler turns into vector
//! instructions. How far each result is from a degenerate one is kept beside it; where anything is near, or where forward
//! kinematics does not confirm a branch, the robust way (`inverse::solve`) takes over. So speed costs no safety.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

use crate::{Branch, Joint, Real, Solution, Solutions};

/// Largest difference between an entry of the target and of a branch's forward kinematics (rotation, or position over reach) that the
/// fast way accepts: some hundred times the rounding of a regular pose.
pub const CONFIRMED: f64 = 1e-12;
/// Relative distance of a discriminant from zero below which the robust way decides.
const CLEAR: f64 = 1e-7;
/// Size of coefficients (rotation, or length over reach) below which the robust way decides.
const FIRM: f64 = 1e-5;

/// `a cos u + b sin u = 0`: cosine and sine of one root (the other is half a turn away), and a margin that is negative where the
/// equation is nearly empty.
#[inline(always)]
#[must_use]
pub fn half_turn(a: f64, b: f64) -> ([f64; 2], f64) {
    let h2 = a * a + b * b;
    let h = 1.0 / crate::math::sqrt(h2);
    // The same order as `ik::solve_sincos`: (-b, a) first.
    ([-b * h, a * h], h2 - FIRM * FIRM)
}

/// `a cos u + b sin u = c`: both roots, whether they are real (1; 0 if they clearly are not), and a margin.
#[inline(always)]
#[must_use]
pub fn sincos(a: f64, b: f64, c: f64) -> ([f64; 4], f64, f64) {
    let h2 = a * a + b * b;
    let g = h2 - c * c;
    let margin = (g.abs() - CLEAR * h2).min(h2 - FIRM * FIRM);
    // What is doubtful counts as real, so that the robust way decides.
    let real = if g > 0.0 || !(margin > 0.0) { 1.0 } else { 0.0 };
    let r = crate::math::sqrt(g.max(0.0));
    let i = 1.0 / h2;
    let (ac, bc, ar, br) = (a * c, b * c, a * r, b * r);
    ([(ac - br) * i, (bc + ar) * i, (ac + br) * i, (bc - ar) * i], real, margin)
}

/// Two equations `a cos u + b sin u = c`: cosine and sine, and a margin.
#[inline(always)]
#[must_use]
pub fn pair(a1: f64, b1: f64, c1: f64, a2: f64, b2: f64, c2: f64) -> ([f64; 2], f64) {
    let det = a1 * b2 - a2 * b1;
    let (x, y) = (c1 * b2 - c2 * b1, a1 * c2 - a2 * c1);
    let h = det.signum() / crate::math::sqrt(x * x + y * y);
    let size = a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2;
    ([x * h, y * h], det.abs() - FIRM * (size + FIRM))
}

/// `a d + b = 0`.
#[inline(always)]
#[must_use]
pub fn linear(a: f64, b: f64) -> (f64, f64) {
    (-b / a, a.abs() - FIRM)
}

/// An angle between -2 pi and 2 pi, or twice that, brought into (-pi, pi].
#[inline(always)]
#[must_use]
pub fn wrap(x: f64) -> f64 {
    let turn = core::f64::consts::TAU;
    let x = if x > core::f64::consts::PI { x - turn } else { x };
    if x <= -core::f64::consts::PI { x + turn } else { x }
}

/// Collects the confirmed branches; `None` where a lane that counts is near a degenerate one or is not confirmed, or where no lane counts.
///
/// `valid` is 1 for lanes that exist, `margin` and `error` as above, `q` joint by joint.
#[inline(always)]
#[must_use]
pub fn collect<T: Real, const N: usize, const M: usize, const L: usize>(
    joints: &'static [Joint<T>; N],
    valid: &[f64; L],
    margin: &[f64; L],
    error: &[f64; L],
    q: &[[f64; L]; N],
    branch: impl Fn(usize) -> Branch,
) -> Option<Solutions<T, N, M>> {
    // The sum is NaN if anything is, and the comparison then fails.
    let (mut doubt, mut any) = (0.0, 0.0);
    for l in 0..L {
        let fine = margin[l] > 0.0 && error[l] <= CONFIRMED;
        doubt += if fine { 0.0 } else { valid[l] };
        any += valid[l];
    }
    if !(doubt == 0.0 && any > 0.0) {
        return None;
    }
    let mut out = Solutions::new(joints);
    for l in 0..L {
        if valid[l] > 0.0 {
            let mut solution = Solution::new(core::array::from_fn(|k| T::of(q[k][l])), branch(l));
            for (joint, x) in joints.iter().zip(&mut solution.q) {
                if joint.range.is_some() {
                    *x = joint.normalize(*x);
                }
            }
            out.push(solution);
        }
    }
    Some(out)
}
