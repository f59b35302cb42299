//! One equation `a cos t + b sin t = c`: the workhorse of closed-form inverse kinematics.

use super::elementary::sqrt;
use super::list::List;
use super::roots::{Angles, Outcome};
use super::tolerance::{BLUR, BOUNDARY, DOUBLE, GRAZING};

/// All angles with `a cos t + b sin t = c`.
///
/// With `h = sqrt(a^2 + b^2)` and `r = sqrt(h^2 - c^2)` they are
///
/// ```text
/// cos t = (a c -+ b r) / h^2,    sin t = (b c +- a r) / h^2,
/// ```
///
/// the first solution being `atan2(b, a) + acos(c / h)` without its loss of digits near the boundary (Paul, *Robot
/// Manipulators*, 1981, section 3.4 gives the form by `atan2`). `r^2` is formed as `(h - |c|)(h + |c|)`.
///
/// - `h` and `|c|` at most `tol`: [`Outcome::Free`], no root. `tol` is absolute, in the unit of the coefficients: take
///   [`ZERO`](super::tolerance::ZERO) times the size of the terms that made them.
/// - `h` at most `tol`, `|c|` above it, or `|c|` larger than `h` by more than [`BOUNDARY`] and `tol` (relative):
///   [`Outcome::OutOfReach`] with `needed = |c|`, `available = h`; input that isn't finite ends here too. [`Outcome::Free`] if neither
///   exceeds [`BLUR`].
/// - `|c|` within [`BOUNDARY`] above `h`, or within [`DOUBLE`] or the square of `tol` below: one root, [`Outcome::Touching`].
/// - otherwise two roots, [`Outcome::Regular`], or [`Outcome::Touching`] within [`GRAZING`].
#[inline]
pub fn solve_sincos(a: f64, b: f64, c: f64, tol: f64) -> Angles<2> {
    let h = sqrt(a * a + b * b);
    let needed = c.abs();
    if h <= tol && needed <= tol {
        return Angles::none(Outcome::Free);
    }
    let gap = h - needed;
    // Written so that NaN ends here.
    if !(h > tol && gap >= -BOUNDARY.max(tol) * h && h < f64::INFINITY) {
        if h <= BLUR && needed <= BLUR {
            return Angles::none(Outcome::Free);
        }
        return Angles::none(Outcome::OutOfReach { needed, available: h });
    }
    let inverse = 1.0 / h;
    let (ua, ub) = (a * inverse, b * inverse);
    let mut roots = List::new();
    if gap <= DOUBLE.max(tol * tol) * h {
        let sign = 1f64.copysign(c);
        roots.push([sign * ua, sign * ub]);
        return Angles { roots, outcome: Outcome::Touching };
    }
    let uc = c * inverse;
    let r = sqrt(gap * (h + needed)) * inverse;
    roots.push([ua * uc - ub * r, ub * uc + ua * r]);
    roots.push([ua * uc + ub * r, ub * uc - ua * r]);
    Angles { roots, outcome: if gap <= GRAZING * h { Outcome::Touching } else { Outcome::Regular } }
}

/// The angle, up to half a turn, of two equations `a cos t + b sin t = 0` that hold together: by the one with the larger coefficients.
///
/// On an arm with fewer joints than its task has dimensions such equations say the same, but not where one of them vanishes: the
/// first joint of a five-axis arm follows from the direction of its tool, and from its position where the tool points straight down.
#[inline]
pub fn solve_half_turn(p: [f64; 2], q: [f64; 2], tol: f64) -> Angles<2> {
    let [a, b] = if p[0] * p[0] + p[1] * p[1] >= q[0] * q[0] + q[1] * q[1] { p } else { q };
    solve_sincos(a, b, 0.0, tol)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Rng;

    fn residual(a: f64, b: f64, c: f64, root: [f64; 2]) -> f64 {
        (a * root[0] + b * root[1] - c).abs() / (a.abs() + b.abs() + c.abs())
    }

    #[test]
    fn random_equations_give_back_the_angle() {
        let mut rng = Rng::new(1);
        for _ in 0..2000 {
            let (a, b, t) = (rng.symmetric() * 3.0, rng.symmetric() * 3.0, rng.angle());
            let c = a * t.cos() + b * t.sin();
            let found = solve_sincos(a, b, c, 1e-12);
            assert_eq!(found.len(), 2);
            for &root in &found {
                assert!(residual(a, b, c, root) < 1e-15);
                assert!((root[0].hypot(root[1]) - 1.0).abs() < 1e-15);
            }
            let nearest = found.iter().map(|r| (r[0] - t.cos()).hypot(r[1] - t.sin())).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-7, "{nearest}");
        }
    }

    #[test]
    fn the_firmer_of_two_equations_decides() {
        let direct = solve_sincos(0.3, -0.4, 0.0, 1e-12);
        for weak in [[0.0, 0.0], [1e-17, 1e-17], [0.03, -0.04]] {
            for found in [solve_half_turn([0.3, -0.4], weak, 1e-12), solve_half_turn(weak, [0.3, -0.4], 1e-12)] {
                assert_eq!(found.roots.as_slice(), direct.roots.as_slice());
            }
        }
        assert!(solve_half_turn([0.0; 2], [0.0; 2], 1e-12).is_free());
        assert!(solve_half_turn([f64::NAN; 2], [0.0; 2], 1e-12).is_empty());
    }

    #[test]
    fn boundary_is_one_root() {
        for c in [5.0, -5.0, 5.0 * (1.0 + 1e-15), 5.0 * (1.0 - 1e-16), 5.0 * (1.0 + 5e-10)] {
            let found = solve_sincos(3.0, 4.0, c, 1e-12);
            assert_eq!((found.len(), found.outcome), (1, Outcome::Touching));
            assert!(residual(3.0, 4.0, c, found[0]) < 1e-9);
        }
        assert_eq!(solve_sincos(3.0, 4.0, 5.0 * (1.0 - 1e-12), 1e-12).len(), 2);
    }

    #[test]
    fn out_of_reach_reports_the_two_lengths() {
        let found = solve_sincos(3.0, 4.0, -6.0, 1e-12);
        assert_eq!((found.len(), found.outcome), (0, Outcome::OutOfReach { needed: 6.0, available: 5.0 }));
        let found = solve_sincos(0.0, 1e-14, 0.5, 1e-12);
        assert!(matches!(found.outcome, Outcome::OutOfReach { .. }));
    }

    #[test]
    fn free_angle_takes_the_representative() {
        let found = solve_sincos(1e-14, 0.0, -1e-13, 1e-12);
        assert!(found.is_free() && found.is_empty());
        assert_eq!(found.or_if_free([0.0, 1.0]).as_ref(), &[[0.0, 1.0]]);
    }

    #[test]
    fn bad_numbers_give_nothing() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for (a, b, c) in [(bad, 1.0, 0.5), (1.0, bad, 0.5), (1.0, 1.0, bad)] {
                let found = solve_sincos(a, b, c, 1e-12);
                assert!(found.is_empty() && !found.is_free());
            }
        }
    }
}
