//! Newton steps on two equations in two unknowns: removes the rounding of an elimination.

/// Polishing steps; four are enough from 1e-3 away, some more next to a fold.
const STEPS: usize = 12;

/// An unknown that can be moved by a small step.
pub(super) trait Unknown: Copy {
    /// The unknown after a step (radians, or the unit of length).
    fn moved(self, by: f64) -> Self;
}

impl Unknown for f64 {
    #[inline]
    fn moved(self, by: f64) -> Self {
        self + by
    }
}

impl Unknown for [f64; 2] {
    #[inline]
    fn moved(self, by: f64) -> Self {
        // By twice the arctangent of by / 2: the difference is of third order, and the norm stays 1.
        let h = 0.5 * by;
        let inverse = 1.0 / (1.0 + h * h);
        let (c, s) = ((1.0 - h * h) * inverse, 2.0 * h * inverse);
        [self[0] * c - self[1] * s, self[0] * s + self[1] * c]
    }
}

/// Improves `(x, y)`; `system` gives two values and their derivatives `[value, by x, by y]`. Returns the least residual, the larger of the
/// two absolute values. Where the derivatives are singular the steps are those of least squares with a little damping.
#[inline]
pub(super) fn polish_pair<X: Unknown, Y: Unknown>(
    x: &mut X,
    y: &mut Y,
    goal: f64,
    system: impl Fn(X, Y) -> [[f64; 3]; 2],
) -> f64 {
    let mut now = system(*x, *y);
    let residual = |e: &[[f64; 3]; 2]| e[0][0].abs().max(e[1][0].abs());
    let mut best = residual(&now);
    let mut at = (*x, *y);
    for _ in 0..STEPS {
        if best <= goal {
            break;
        }
        let [[e, ex, ey], [f, fx, fy]] = now;
        // (J^T J + m) step = -J^T r, with m of the order of the residual's square.
        let m = 1e-3 * (e * e + f * f);
        let (a, b, c) = (ex * ex + fx * fx + m, ex * ey + fx * fy, ey * ey + fy * fy + m);
        let (g, h) = (ex * e + fx * f, ey * e + fy * f);
        let det = a * c - b * b;
        // Cramer's rule on J itself, where it is regular, loses less than the normal equations.
        let plain = ex * fy - ey * fx;
        let (dx, dy) = if plain * plain > 1e-6 * a * c {
            ((ey * f - fy * e) / plain, (fx * e - ex * f) / plain)
        } else if det > 0.0 {
            ((b * h - c * g) / det, (b * g - a * h) / det)
        } else {
            break;
        };
        (at.0, at.1) = (at.0.moved(dx), at.1.moved(dy));
        let next = system(at.0, at.1);
        let before = residual(&now);
        now = next;
        if residual(&next) < best {
            best = residual(&next);
            (*x, *y) = at;
        } else if before <= 1e3 * goal || !(residual(&next) < 1e3 * best) {
            // Rounding noise, or on the way to nowhere. (One bad step is normal where the equations bend.)
            break;
        }
    }
    best
}
