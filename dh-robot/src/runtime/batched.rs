//! The fast path of generated inverses: all branches of a plan side by side, without conditional jumps.
//!
//! Every step solves its equation for all branches found so far, in plain loops over arrays that the compiler turns into vector
//! instructions. How far each result is from a degenerate one is kept beside it; where anything is near, or where forward
//! kinematics does not confirm a branch, the fallback path (`inverse::solve`) takes over. So speed costs no safety.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

mod angles;

pub use angles::{angle, angles};

use crate::{Branch, FreeJoints, Joint, Real, Solution, Solutions};

/// Largest difference between an entry of the target and of a branch's forward kinematics (rotation, or position over the length scale) that the
/// fast path accepts: some hundred times the rounding of a regular pose.
pub const CONFIRMED: f64 = 1e-12;
/// Relative distance of a discriminant from zero below which the fallback path decides.
const CLEAR: f64 = 1e-7;
/// The same where the target is rounded to 6e-8.
const CLEAR_SINGLE: f64 = 2e-5;
/// Size of coefficients (rotation, or length over the length scale) below which the fallback path decides.
const FIRM: f64 = 1e-5;

/// `a cos u + b sin u = 0`: cosine and sine of one root (the other is half a turn away), and a margin that is negative where the
/// equation is nearly empty. Of several such equations the one with the largest coefficients counts.
#[inline(always)]
#[must_use]
pub fn half_turn<const R: usize>(rows: [[f64; 2]; R]) -> ([f64; 2], f64) {
    let (mut a, mut b, mut h2) = (0.0, 0.0, -1.0);
    for [x, y] in rows {
        let size = x * x + y * y;
        let larger = size > h2;
        (a, b, h2) = (if larger { x } else { a }, if larger { y } else { b }, if larger { size } else { h2 });
    }
    let h = 1.0 / crate::math::sqrt(h2);
    // The same order as `dh_kernels::solve_sincos`: (-b, a) first.
    ([-b * h, a * h], h2 - FIRM * FIRM)
}

/// `a cos u + b sin u = c`: both roots, whether they are real (1; 0 if they clearly are not), and a margin.
#[inline(always)]
#[must_use]
pub fn sincos(a: f64, b: f64, c: f64) -> ([f64; 4], f64, f64) {
    sincos_apart(a, b, c, CLEAR)
}

/// The same for targets in `f32`: they are rounded to 6e-8, so a stretched arm is out of reach by some times as much.
#[inline(always)]
#[must_use]
pub fn sincos_single(a: f64, b: f64, c: f64) -> ([f64; 4], f64, f64) {
    sincos_apart(a, b, c, CLEAR_SINGLE)
}

#[inline(always)]
fn sincos_apart(a: f64, b: f64, c: f64, clear: f64) -> ([f64; 4], f64, f64) {
    let h2 = a * a + b * b;
    let g = h2 - c * c;
    let margin = (g.abs() - clear * h2).min(h2 - FIRM * FIRM);
    // What is doubtful counts as real, so that the fallback path decides.
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

/// Cosine and sine of an angle for which any value does.
#[inline(always)]
#[must_use]
pub fn chosen_angle() -> [f64; 2] {
    [1.0, 0.0]
}

/// A length for which any value does.
#[inline(always)]
#[must_use]
pub fn chosen_length() -> f64 {
    0.0
}

/// An angle between -3 pi and 3 pi brought into (-pi, pi].
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

/// The same angle with its vector turned round.
#[inline(always)]
#[must_use]
pub fn opposite(x: f64) -> f64 {
    // Up to EPSILON the sum is rounded to pi; beyond, the difference is rounded to more than -pi.
    x + if x > f64::EPSILON { -core::f64::consts::PI } else { core::f64::consts::PI }
}

/// The negative of an angle in (-pi, pi]; pi stays.
#[inline(always)]
#[must_use]
pub fn negative(x: f64) -> f64 {
    if x < core::f64::consts::PI { -x } else { x }
}

/// pi less an angle in (-pi, pi].
#[inline(always)]
#[must_use]
pub fn supplement(x: f64) -> f64 {
    wrap(core::f64::consts::PI - x)
}

/// The lesser of two margins.
#[inline(always)]
#[must_use]
pub fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Whether there is a branch that counts (`valid` is 1), and each such branch is clear of degenerate ones and confirmed.
#[inline(always)]
#[must_use]
pub fn confirmed<const L: usize>(valid: &[f64; L], margin: &[f64; L], error: &[f64; L]) -> bool {
    // The sum is NaN if anything is, and the comparison then fails.
    let (mut doubt, mut any) = (0.0, 0.0);
    for l in 0..L {
        let fine = (margin[l] > 0.0) & (error[l] <= CONFIRMED);
        doubt += if fine { 0.0 } else { valid[l] };
        any += valid[l];
    }
    doubt == 0.0 && any > 0.0
}

/// The solution of a branch. `q` goes joint by joint, for `f64` in its range if it can be.
#[inline(always)]
#[must_use]
pub fn solution<T: Real, const N: usize, const L: usize>(
    joints: &[Joint<T>; N],
    q: &[[f64; L]; N],
    branches: &[Branch; L],
    branch: usize,
) -> Solution<T, N> {
    let mut solution = Solution::new(core::array::from_fn(|k| T::of(q[k][branch])), branches[branch]);
    // A narrower scalar rounds, which can lead across an end of the range.
    if size_of::<T>() < size_of::<f64>() {
        for (joint, x) in joints.iter().zip(&mut solution.q) {
            *x = joint.normalize(*x);
        }
    }
    solution
}

/// The solutions of the branches that count.
#[must_use]
pub fn collect<T: Real, const N: usize, const M: usize, const L: usize>(
    joints: &'static [Joint<T>; N],
    valid: &[f64; L],
    q: &[[f64; L]; N],
    branches: &[Branch; L],
) -> Solutions<T, N, M> {
    let mut out = Solutions::new(joints);
    for l in 0..L {
        if valid[l] > 0.0 {
            out.push(solution(joints, q, branches, l));
        }
    }
    out
}

/// The same where any value does for some joints.
#[must_use]
pub fn collect_free<T: Real, const N: usize, const M: usize, const L: usize>(
    joints: &'static [Joint<T>; N],
    valid: &[f64; L],
    q: &[[f64; L]; N],
    branches: &[Branch; L],
    free: FreeJoints,
) -> Solutions<T, N, M> {
    let mut out = Solutions::new(joints);
    for l in 0..L {
        if valid[l] > 0.0 {
            out.push(solution(joints, q, branches, l).with_free(free));
        }
    }
    out
}

/// Whether the values of free joints are in range.
#[must_use]
pub fn free_in_range<T: Real, const N: usize, const M: usize>(list: &Solutions<T, N, M>) -> bool {
    let joints = list.joints();
    list.iter().all(|s| (0..N).all(|k| !s.free.contains(k) || joints[k].contains(s.q[k])))
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
        for (least, greatest) in
            [(-2.5, 2.5), (-4.0, 0.8), (-0.8, 4.0), (-5.0, 5.0), (PI, 6.0), (-7.0, -PI), (-0.5, 9.0)]
        {
            let joint = Joint::revolute("q1").with_range(least, greatest);
            for k in -999..=1000 {
                let x = f64::from(k) * 1e-3 * PI;
                assert_eq!(into_range(x, least, greatest), joint.normalize(x), "{x} into {least}..={greatest}");
            }
        }
    }

    #[test]
    fn doubt_leaves_everything_to_the_fallback_path() {
        let sure = |valid, margin, error| confirmed(&valid, &margin, &error);
        assert!(sure([1.0, 1.0], [0.1, 0.1], [0.0, 0.0]));
        assert!(sure([1.0, 0.0], [0.1, 0.1], [0.0, f64::NAN]));
        assert!(!sure([1.0, 1.0], [0.1, -0.1], [0.0, 0.0]));
        assert!(!sure([1.0, 1.0], [0.1, 0.1], [0.0, f64::NAN]));
        assert!(!sure([1.0, 1.0], [0.1, f64::NAN], [0.0, 0.0]));
        assert!(!sure([1.0, 1.0], [0.1, 0.1], [0.0, 1e-9]));
        assert!(!sure([0.0, 0.0], [0.1, 0.1], [0.0, 0.0]));
    }

    #[test]
    fn branches_that_count_are_collected_in_their_order() {
        static JOINTS: [Joint; 1] = [Joint::revolute("q1")];
        let q = [[0.1, 0.2, 0.3]];
        let out: Solutions<f64, 1, 3> = collect(&JOINTS, &[1.0, 0.0, 1.0], &q, &[Branch::ANY; 3]);
        assert_eq!(out.iter().map(|s| s.q[0]).collect::<Vec<_>>(), [0.1, 0.3]);
    }

    #[test]
    fn changes_of_an_angle_stay_between_half_turns() {
        for x in [-3.0, -1.5, -0.0, 0.0, 1e-17, f64::EPSILON, f64::EPSILON.next_up(), 1.5, 3.0, PI] {
            for (got, cosine, sine) in [(opposite(x), -1.0, -1.0), (negative(x), 1.0, -1.0), (supplement(x), -1.0, 1.0)]
            {
                assert!(got > -PI && got <= PI, "{x}: {got}");
                assert!((got.cos() - cosine * x.cos()).abs() < 1e-15 && (got.sin() - sine * x.sin()).abs() < 1e-15);
            }
        }
    }
}
