//! Two equations in the cosine and sine of one angle, solved by Cramer's rule.

use super::elementary::sqrt;
use super::least_squares::solve_many;
use super::list::List;
use super::roots::{Angles, Outcome};
use super::tolerance::{BLUR, CONTRADICTION, RANK};

/// The angle with `a1 cos t + b1 sin t = c1` and `a2 cos t + b2 sin t = c2`, by Cramer's rule and normalised.
///
/// - Independent equations: one root. Its norm before normalising must be one; where it is off by more than
///   [`CONTRADICTION`] (the equations have no common angle), [`Outcome::OutOfReach`] carries the norm as
///   `needed`, and 1 as `available`.
/// - Dependent equations (relative to their size, see [`RANK`]): what [`solve_many`] does, two roots at most.
/// - All coefficients at most `tol` (absolute, in their unit), or equations without a common angle and no larger than [`BLUR`]:
///   [`Outcome::Free`], no root.
#[inline]
pub fn solve_pair(a1: f64, b1: f64, c1: f64, a2: f64, b2: f64, c2: f64, tol: f64) -> Angles<2> {
    let det = a1 * b2 - a2 * b1;
    let size = a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2;
    // |det| / size is the ratio of the two singular values, up to a factor of two.
    if !(size > tol * tol && det.abs() > RANK * size) {
        return solve_many(&[[a1, b1, c1], [a2, b2, c2]], tol);
    }
    let (x, y) = (c1 * b2 - c2 * b1, a1 * c2 - a2 * c1);
    let norm = sqrt(x * x + y * y);
    let off = norm - det.abs();
    // The error of the norm grows with the condition number, size / |det|.
    if !(off.abs() <= CONTRADICTION * size) {
        if size <= BLUR * BLUR && c1 * c1 + c2 * c2 <= BLUR * BLUR {
            return Angles::none(Outcome::Free);
        }
        return Angles::none(Outcome::OutOfReach { needed: norm / det.abs(), available: 1.0 });
    }
    if norm <= RANK * size {
        return solve_many(&[[a1, b1, c1], [a2, b2, c2]], tol);
    }
    let scale = 1f64.copysign(det) / norm;
    let mut roots = List::new();
    roots.push([x * scale, y * scale]);
    Angles { roots, outcome: Outcome::Regular }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Rng;

    #[test]
    fn random_pairs_give_back_the_angle() {
        let mut rng = Rng::new(2);
        for _ in 0..2000 {
            let [a1, b1, a2, b2] = [(); 4].map(|()| rng.symmetric());
            let (s, c) = rng.angle().sin_cos();
            let found = solve_pair(a1, b1, a1 * c + b1 * s, a2, b2, a2 * c + b2 * s, 1e-12);
            assert_eq!((found.len(), found.outcome), (1, Outcome::Regular));
            let condition = (a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2) / (a1 * b2 - a2 * b1).abs();
            assert!((found[0][0] - c).hypot(found[0][1] - s) < 1e-15 * condition);
        }
    }

    #[test]
    fn dependent_pair_is_one_equation_with_two_roots() {
        let found = solve_pair(1.0, 2.0, 0.5, -2.0, -4.0, -1.0, 1e-12);
        assert_eq!(found.len(), 2);
        for r in &found {
            assert!((r[0] + 2.0 * r[1] - 0.5).abs() < 1e-14);
        }
        let found = solve_pair(0.0, 0.0, 0.0, 3.0, 4.0, 5.0, 1e-12);
        assert_eq!((found.len(), found.outcome), (1, Outcome::Touching));
    }

    #[test]
    fn contradictions_and_free_angles_are_told_apart() {
        assert!(matches!(solve_pair(1.0, 0.0, 0.9, 0.0, 1.0, 0.9, 1e-12).outcome, Outcome::OutOfReach { .. }));
        assert!(matches!(solve_pair(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1e-12).outcome, Outcome::OutOfReach { .. }));
        assert!(matches!(solve_pair(0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1e-12).outcome, Outcome::OutOfReach { .. }));
        assert!(solve_pair(0.0, 1e-14, 0.0, 0.0, 0.0, 1e-14, 1e-12).is_free());
        assert!(solve_pair(f64::NAN, 1.0, 0.0, 0.0, 1.0, 0.0, 1e-12).is_empty());
    }

    #[test]
    fn small_equations_that_contradict_each_other_say_nothing() {
        let contradiction = |size: f64, right: f64| solve_pair(size, 0.0, right, 0.0, size, right, 1e-12).outcome;
        assert_eq!(contradiction(1e-5, 3e-5), Outcome::Free);
        assert!(matches!(contradiction(1e-3, 3e-3), Outcome::OutOfReach { .. }));
        assert!(matches!(contradiction(1e-5, 1e-3), Outcome::OutOfReach { .. }));
    }
}
