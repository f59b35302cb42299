//! Any number of equations in the cosine and sine of one angle, solved by least squares.

use super::elementary::sqrt;
use super::list::List;
use super::one_equation::solve_sincos;
use super::roots::{Angles, Outcome};
use super::tolerance::{BLUR, CONTRADICTION, RANK};

/// The angle with `a cos t + b sin t = c` for every row `[a, b, c]`.
///
/// The rows are rotated by Givens rotations into `[r11 r12 g1; 0 r22 g2]` (a triangular factor, so that the condition is not squared),
/// and that 2 x 2 triangle is diagonalised. Rows are used as they are: scale them to comparable sizes, so that the error of each
/// is about the same.
///
/// - Rank 2: one root (normalised), [`Outcome::Regular`]; rows that contradict each other by more than [`CONTRADICTION`]
///   (relative) give [`Outcome::OutOfReach`] with the residual as `needed` and the size of the rows as `available`.
/// - Rank 1 (second singular value below [`RANK`] times the first): the one equation that is left, up to two roots.
/// - Nothing above `tol` (absolute), or a contradiction between rows no larger than [`BLUR`]: [`Outcome::Free`].
pub fn solve_many<const M: usize>(rows: &[[f64; 3]; M], tol: f64) -> Angles<2> {
    // Triangle by Givens rotations: rows (p, q, g) and (0, r, h), and what is left of the right-hand sides.
    let ([mut p, mut q, mut g], [mut r, mut h]) = ([0.0; 3], [0.0; 2]);
    let mut rest = 0.0;
    for &[mut a, mut b, mut c] in rows {
        let n = sqrt(p * p + a * a);
        if n > 0.0 {
            let (co, si) = (p / n, a / n);
            (p, a) = (n, 0.0);
            (q, b) = (co * q + si * b, co * b - si * q);
            (g, c) = (co * g + si * c, co * c - si * g);
        }
        let n = sqrt(r * r + b * b);
        if n > 0.0 {
            let (co, si) = (r / n, b / n);
            (r, b) = (n, 0.0);
            (h, c) = (co * h + si * c, co * c - si * h);
        }
        // NaN in a row stays visible in one of the sums.
        rest += c * c + a + b;
    }
    let rest = sqrt(rest);
    // Larger singular value and its right singular vector (x, y), from the symmetric 2 x 2 matrix of the triangle.
    let (m11, m12, m22) = (p * p, p * q, q * q + r * r);
    let half = 0.5 * (m11 - m22);
    let root = sqrt(half * half + m12 * m12);
    let first = sqrt(0.5 * (m11 + m22) + root);
    if first <= tol {
        let needed = sqrt(g * g + h * h + rest * rest);
        return Angles::none(if needed <= tol {
            Outcome::Free
        } else {
            Outcome::OutOfReach { needed, available: first }
        });
    }
    if !(first < f64::INFINITY && rest < f64::INFINITY) {
        return Angles::none(Outcome::OutOfReach { needed: f64::NAN, available: first });
    }
    let blurred = first <= BLUR && g * g + h * h + rest * rest <= BLUR * BLUR;
    let none = |outcome: Outcome| Angles::none(if blurred { Outcome::Free } else { outcome });
    let contradiction = |residual: f64| none(Outcome::OutOfReach { needed: residual, available: first });
    if !(rest <= CONTRADICTION * (first + sqrt(g * g + h * h))) {
        return contradiction(rest);
    }
    let det = p * r;
    if det.abs() <= RANK * first * first {
        // (x, y) = eigenvector of [m11 m12; m12 m22] for the larger eigenvalue, from the row without cancellation.
        let (x, y) = if half >= 0.0 { (half + root, m12) } else { (m12, root - half) };
        let n = sqrt(x * x + y * y);
        // `root` is zero only for two equal singular values, which is not rank one.
        let (x, y) = (x / n, y / n);
        // Left singular vector: the triangle times (x, y), over the singular value.
        let (u, v) = ((p * x + q * y) / first, r * y / first);
        if !((u * h - v * g).abs() <= CONTRADICTION * (first + sqrt(g * g + h * h))) {
            return contradiction((u * h - v * g).abs());
        }
        return solve_sincos(x, y, (u * g + v * h) / first, RANK);
    }
    let s = h / r;
    let c = (g - q * s) / p;
    let norm = sqrt(c * c + s * s);
    // A norm that is off by `d` leaves a residual between d times the smaller and d times the larger singular value.
    if !(norm > RANK && (norm - 1.0).abs() * det.abs() <= CONTRADICTION * first * first) {
        return none(Outcome::OutOfReach { needed: norm, available: 1.0 });
    }
    let mut roots = List::new();
    roots.push([c / norm, s / norm]);
    Angles { roots, outcome: Outcome::Regular }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Rng;

    #[test]
    fn six_consistent_rows_give_back_the_angle() {
        let mut rng = Rng::new(3);
        for _ in 0..2000 {
            let (s, c) = rng.angle().sin_cos();
            let rows: [[f64; 3]; 6] = [(); 6].map(|()| {
                let (a, b) = (rng.symmetric(), rng.symmetric());
                [a, b, a * c + b * s]
            });
            let found = solve_many(&rows, 1e-12);
            assert_eq!((found.len(), found.outcome), (1, Outcome::Regular));
            assert!((found[0][0] - c).hypot(found[0][1] - s) < 1e-13);
        }
    }

    #[test]
    fn nearly_dependent_rows_keep_their_digits() {
        // Singular values 1 and 1e-6: normal equations would lose all but four digits.
        let (s, c) = 0.7f64.sin_cos();
        let rows = [[1.0, 1.0, c + s], [1.0, 1.0 + 1e-6, c + s + 1e-6 * s], [0.0, 0.0, 0.0]];
        let found = solve_many(&rows, 1e-12);
        assert_eq!(found.len(), 1);
        assert!((found[0][0] - c).hypot(found[0][1] - s) < 1e-9);
    }

    #[test]
    fn copies_of_one_row_give_two_roots() {
        for k in [1.0, -1.0, 0.0] {
            let found = solve_many(&[[0.3, 0.4, 0.1], [0.6, 0.8, 0.2], [-0.3 * k, -0.4 * k, -0.1 * k]], 1e-12);
            assert_eq!(found.len(), 2);
            for r in &found {
                assert!((0.3 * r[0] + 0.4 * r[1] - 0.1).abs() < 1e-15);
            }
        }
        for row in [[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, -2.0, 0.5]] {
            assert_eq!(solve_many(&[row; 2], 1e-12).len(), 2);
        }
    }

    #[test]
    fn contradictions_are_found() {
        assert!(solve_many(&[[1.0, 0.0, 0.5], [1.0, 0.0, -0.5]], 1e-12).is_empty());
        assert!(solve_many(&[[1.0, 0.0, 0.6], [0.0, 1.0, 0.8], [1.0, 1.0, 0.2]], 1e-12).is_empty());
        assert!(solve_many(&[[1.0, 0.0, f64::NAN], [0.0, 1.0, 0.8]], 1e-12).is_empty());
        assert!(solve_many(&[[0.0, 0.0, 0.0]; 4], 1e-12).is_free());
    }
}
