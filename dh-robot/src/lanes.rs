//! The fast way of generated inverses: all branches of a plan side by side, without a jump.
//!
//! Every step solves its equation for all branches found so far, in plain loops over arrays that the compiler turns into vector
//! instructions. How far each result is from a degenerate one is kept beside it; where anything is near, or where forward
//! kinematics does not confirm a branch, the robust way (`inverse::solve`) takes over. So speed costs no safety.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

#[cfg(test)]
use crate::Joint;
use crate::{Branch, Real, Solution, Solutions};

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
    let i = 1.0 / det;
    let size = a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2;
    (unit((c1 * b2 - c2 * b1) * i, (a1 * c2 - a2 * c1) * i), det.abs() - FIRM * (size + FIRM))
}

/// Cosine and sine that are known but for rounding: one step of Newton's method for `1/sqrt(x^2 + y^2)` makes the sum of their squares
/// 1. Where they are no cosine and sine, the result is none either, and is not confirmed.
#[inline(always)]
#[must_use]
pub fn unit(x: f64, y: f64) -> [f64; 2] {
    let h = 1.5 - 0.5 * (x * x + y * y);
    [x * h, y * h]
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

/// `Joint::normalize` without a jump, for an angle in (-pi, pi] and a range that one turn at most leads into: `least` at most pi,
/// `greatest` at least -pi.
#[inline(always)]
#[must_use]
pub fn into_range(x: f64, least: f64, greatest: f64) -> f64 {
    let turn = core::f64::consts::TAU;
    let (least, greatest) = (least - <f64 as Real>::RANGE_TOLERANCE, greatest + <f64 as Real>::RANGE_TOLERANCE);
    let up = (x < least) & (x + turn <= greatest);
    let down = (x > greatest) & (x - turn >= least);
    x + if up { turn } else { 0.0 } - if down { turn } else { 0.0 }
}

/// Collects the confirmed branches into `out`, which is empty; false, and nothing collected, where a lane that counts is near a
/// degenerate one or is not confirmed, or where no lane counts.
///
/// `valid` is 1 for lanes that exist, `margin` and `error` as above, `q` joint by joint, for `f64` in its range if it can be.
#[inline(always)]
#[must_use]
pub fn collect<T: Real, const N: usize, const M: usize, const L: usize>(
    valid: &[f64; L],
    margin: &[f64; L],
    error: &[f64; L],
    q: &[[f64; L]; N],
    branches: &[Branch; L],
    out: &mut Solutions<T, N, M>,
) -> bool {
    // The sum is NaN if anything is, and the comparison then fails.
    let (mut doubt, mut any) = (0.0, 0.0);
    for l in 0..L {
        let fine = (margin[l] > 0.0) & (error[l] <= CONFIRMED);
        doubt += if fine { 0.0 } else { valid[l] };
        any += valid[l];
    }
    if !(doubt == 0.0 && any > 0.0) {
        return false;
    }
    let joints = out.joints();
    for l in 0..L {
        if valid[l] > 0.0 {
            let mut solution = Solution::new(core::array::from_fn(|k| T::of(q[k][l])), branches[l]);
            // A narrower scalar rounds, which can lead across an end of the range.
            if size_of::<T>() < size_of::<f64>() {
                for (joint, x) in joints.iter().zip(&mut solution.q) {
                    *x = joint.normalize(*x);
                }
            }
            out.push(solution);
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;

    #[test]
    fn a_nearly_unit_vector_becomes_one() {
        let [x, y] = unit(0.6 * (1.0 + 1e-9), 0.8 * (1.0 + 1e-9));
        assert!((x - 0.6).abs() < 1e-15 && (y - 0.8).abs() < 1e-15);
        let [x, y] = unit(0.6, 0.7);
        assert!((x * x + y * y - 1.0).abs() > 1e-3, "no cosine and sine must not become one");
    }

    #[test]
    fn angles_go_into_the_range_as_joints_bring_them() {
        for (least, greatest) in [(-2.5, 2.5), (-4.0, 0.8), (-0.8, 4.0), (-5.0, 5.0), (PI, 6.0), (-7.0, -PI), (-0.5, 9.0)] {
            let joint = Joint::revolute("q1").with_range(least, greatest);
            for k in -999..=1000 {
                let x = f64::from(k) * 1e-3 * PI;
                assert_eq!(into_range(x, least, greatest), joint.normalize(x), "{x} into {least}..={greatest}");
            }
        }
    }

    #[test]
    fn doubt_leaves_everything_to_the_robust_way() {
        static JOINTS: [Joint; 1] = [Joint::revolute("q1")];
        let count = |valid, margin, error| {
            let mut out = Solutions::<f64, 1, 2>::new(&JOINTS);
            let done = collect(&valid, &margin, &error, &[[0.1, 0.2]], &[Branch::ANY; 2], &mut out);
            done.then_some(out.len())
        };
        assert_eq!(count([1.0, 1.0], [0.1, 0.1], [0.0, 0.0]), Some(2));
        assert_eq!(count([1.0, 0.0], [0.1, 0.1], [0.0, f64::NAN]), Some(1));
        assert_eq!(count([1.0, 1.0], [0.1, -0.1], [0.0, 0.0]), None);
        assert_eq!(count([1.0, 1.0], [0.1, 0.1], [0.0, f64::NAN]), None);
        assert_eq!(count([1.0, 1.0], [0.1, f64::NAN], [0.0, 0.0]), None);
        assert_eq!(count([0.0, 0.0], [0.1, 0.1], [0.0, 0.0]), None);
    }
}
