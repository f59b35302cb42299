//! Six equations in three joints as a 12 x 12 matrix in one of them (Raghavan and Roth's dialytic elimination).
//!
//! Each equation is bilinear in `(1, cos x, sin x)` and `(1, cos y, sin y)`, with coefficients linear in the cosine and sine of the hidden
//! angle. Times `cos(x/2)` and `sin(x/2)` it becomes two linear equations in the twelve unknowns
//!
//! ```text
//! (cos 3x/2, sin 3x/2, cos x/2, sin x/2) x (1, cos y, sin y),
//! ```
//!
//! which have a solution other than zero only where the determinant vanishes. If the joint of `y` slides, `(1, y, y^2)` does as well.

use super::super::elementary::{sin_cos, sqrt};
use super::super::vector::{dot, norm};
use super::super::{Blank, List};
use super::choice::Choice;
use super::closure::{Closure, EQUATIONS, monomials, unit};
use super::determinant::Eliminant;

/// Rows and columns of the matrix.
const SIZE: usize = 2 * EQUATIONS;
/// A square matrix, row by row.
type Matrix = [[f64; SIZE]; SIZE];

/// The six equations as functions of the hidden angle, `constant + cos C + sin S`, and from them the matrix.
pub(super) struct Dialytic {
    /// For each equation the coefficients of `1`, `2 cos x` and `2 sin x`, each by the single joint's three monomials.
    parts: [[[f64; 9]; EQUATIONS]; 3],
    /// Whether the single joint is prismatic.
    prismatic: bool,
}

/// What is known at a root of the determinant.
#[derive(Clone, Copy)]
pub(super) struct Refined {
    /// The hidden angle.
    pub(super) hidden: [f64; 2],
    /// The angle that doubles and the value of the single joint.
    pub(super) others: [[f64; 2]; 2],
    /// The size of the last step, in radians: small where the root is a simple one.
    pub(super) step: f64,
    /// The squared distance of the null vector (of length one) from any that angles can make: zero for solutions.
    pub(super) misfit: f64,
}

impl Blank for Refined {
    const BLANK: Self = Self { hidden: [0.0; 2], others: [[0.0; 2]; 2], step: 0.0, misfit: 0.0 };
}

impl Refined {
    /// A step of the eigenvalue iteration that should have ended, but didn't, is larger.
    const SETTLED: f64 = 1e-6;
    /// A null vector that misses the form of a solution by more (squared) belongs to none.
    const MISFIT: f64 = 1e-3;

    /// Whether the iteration has converged.
    pub(super) fn settled(&self) -> bool {
        self.step < Self::SETTLED
    }

    /// Whether the null vector has the form of a solution.
    pub(super) fn fits(&self) -> bool {
        self.misfit < Self::MISFIT
    }
}

impl Dialytic {
    pub(super) fn new(closure: &Closure, choice: Choice) -> Self {
        let [hidden, double, single] = choice.middle().map(|i| [9, 3, 1][i]);
        let mut parts = [[[0.0; 9]; EQUATIONS]; 3];
        for (h, part) in parts.iter_mut().enumerate() {
            for (row, equation) in part.iter_mut().zip(&closure.equations) {
                for y in 0..3 {
                    let at = |x: usize| equation[hidden * h + double * x + single * y];
                    (row[y], row[3 + y], row[6 + y]) = (at(0), 0.5 * at(1), 0.5 * at(2));
                }
            }
        }
        Self { parts, prismatic: closure.prismatic[2 + choice.middle()[2]] }
    }

    /// The matrix at a hidden angle `[cos, sin]`.
    #[inline]
    fn at(&self, [c, s]: [f64; 2]) -> Matrix {
        self.matrix([1.0, c, s])
    }

    /// The matrix for three factors of the constant part, that of the cosine and that of the sine.
    #[inline]
    fn matrix(&self, [one, c, s]: [f64; 3]) -> Matrix {
        let [constant, cos, sin] = &self.parts;
        let mut out = [[0.0; SIZE]; SIZE];
        for r in 0..EQUATIONS {
            let (constant, cos, sin) = (&constant[r], &cos[r], &sin[r]);
            let mut row = [0.0; 9];
            let mut k = 0;
            while k < 9 {
                row[k] = one * constant[k] + c * cos[k] + s * sin[k];
                k += 1;
            }
            // (one + 2 cos cos x + 2 sin sin x) times cos(x/2), then times sin(x/2).
            let [a, b, e, p, q, t, u, v, w] = row;
            out[2 * r] = [p, q, t, u, v, w, a + p, b + q, e + t, u, v, w];
            out[2 * r + 1] = [-u, -v, -w, p, q, t, u, v, w, a - p, b - q, e - t];
        }
        out
    }

    /// The derivative of the matrix by the hidden angle, times a vector.
    fn slope_times(&self, [c, s]: [f64; 2], x: &[f64; SIZE]) -> [f64; SIZE] {
        let slope = self.matrix([0.0, -s, c]);
        let mut out = [0.0; SIZE];
        for r in 0..SIZE {
            for k in 0..SIZE {
                out[r] += slope[r][k] * x[k];
            }
        }
        out
    }

    /// Improves a root of the determinant by Newton's method for nonlinear eigenvalues, and gives the other two middle angles at it.
    ///
    /// With a null vector `x` the step solves `M y = M' x`: then `y` is the better null vector and `(c.x) / (c.y)` the step back, for any
    /// `c`; here `c = x`.
    pub(super) fn refined(&self, mut at: [f64; 2], steps: usize) -> Refined {
        // Not orthogonal to any null vector of the form above.
        let mut x = [1.0, 0.3, 0.2, 0.5, -0.7, 0.4, 0.9, 0.1, -0.3, 0.8, 0.6, -0.2];
        let mut step = f64::INFINITY;
        for k in 0..=steps {
            let lu = Lu::new(self.at(at));
            if k == 0 {
                // Inverse iteration from any right-hand side, twice.
                for _ in 0..2 {
                    x = normalised(&lu.solve(&x));
                }
            }
            let y = lu.solve(&self.slope_times(at, &x));
            let along = dot(x, y);
            let by = -1.0 / along;
            if !(by.abs() < 0.5) {
                break;
            }
            x = normalised(&y);
            let (s, c) = sin_cos(by);
            at = [at[0] * c - at[1] * s, at[0] * s + at[1] * c];
            step = by.abs();
            if step < 1e-9 {
                break;
            }
        }
        let (others, misfit) = values(&x, self.prismatic);
        Refined { hidden: at, others, step, misfit }
    }

    /// The number of null vectors at this hidden angle, within rounding of a double root.
    pub(super) fn nullity(&self, at: [f64; 2]) -> usize {
        self.pivots(at).iter().filter(|p| !(**p > 1e-7)).count()
    }

    /// Whether the determinant vanishes at this hidden angle exactly to this order.
    pub(super) fn vanishes_to(&self, at: [f64; 2], order: usize) -> bool {
        let size = |by: f64| {
            let (s, c) = sin_cos(by);
            let (above, _) = self.value([at[0] * c - at[1] * s, at[0] * s + at[1] * c]);
            let (below, _) = self.value([at[0] * c + at[1] * s, at[1] * c - at[0] * s]);
            above.abs() + below.abs()
        };
        // Twice as far away it is 2^order times as large; the next order would give twice that.
        let ratio = size(4e-3) / (size(2e-3) * (1u64 << order.min(60)) as f64);
        ratio > 0.75 && ratio < 1.5
    }

    /// The solutions at a hidden angle with two null vectors: two joint vectors may share the angle. None, if the null vectors are the
    /// complex pair of a phantom.
    ///
    /// A combination `a A + b B` of the two null vectors, as 4 x 3 matrices, has rank one where all its 2 x 2 minors vanish. These
    /// are quadratics in `a : b` with the same roots; the largest one is solved.
    pub(super) fn pair(&self, at: [f64; 2]) -> List<Refined, 2> {
        let lu = Lu::new(self.at(at));
        let mut a = [1.0, 0.3, 0.2, 0.5, -0.7, 0.4, 0.9, 0.1, -0.3, 0.8, 0.6, -0.2];
        let mut b = [0.2, -0.4, 1.0, 0.1, 0.6, 0.8, -0.5, 0.9, 0.3, -0.6, 0.7, 0.4];
        for _ in 0..3 {
            a = normalised(&lu.solve(&a));
            b = lu.solve(&b);
            let along = dot(a, b);
            for (b, a) in b.iter_mut().zip(&a) {
                *b -= along * a;
            }
            b = normalised(&b);
        }
        let mut best = [0.0; 3];
        let size = |q: &[f64; 3]| q.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for i in 0..4 {
            for j in 0..i {
                for (k, l) in [(0, 1), (0, 2), (1, 2)] {
                    let [p, q, r, s] = [3 * i + k, 3 * j + l, 3 * i + l, 3 * j + k];
                    let minor = [
                        a[p] * a[q] - a[r] * a[s],
                        a[p] * b[q] + b[p] * a[q] - a[r] * b[s] - b[r] * a[s],
                        b[p] * b[q] - b[r] * b[s],
                    ];
                    if size(&minor) > size(&best) {
                        best = minor;
                    }
                }
            }
        }
        let mut pair = List::new();
        let [aa, ab, bb] = best;
        let discriminant = ab * ab - 4.0 * aa * bb;
        // A double combination is left to the general treatment.
        if discriminant > 1e-12 * size(&best) * size(&best) {
            let q = -0.5 * (ab + sqrt(discriminant).copysign(ab));
            for (x, y) in [(q, aa), (bb, q)] {
                let mut v = a;
                for (v, b) in v.iter_mut().zip(&b) {
                    *v = *v * x + b * y;
                }
                let (others, misfit) = values(&normalised(&v), self.prismatic);
                pair.push(Refined { hidden: at, others, step: 0.0, misfit });
            }
        }
        pair
    }

    /// The absolute pivots of complete pivoting, over the first one: a cheap picture of the singular values.
    pub(super) fn pivots(&self, at: [f64; 2]) -> [f64; SIZE] {
        let mut m = self.at(at);
        let mut pivots = [0.0; SIZE];
        for k in 0..SIZE {
            let (mut row, mut column, mut best) = (k, k, 0.0);
            for r in k..SIZE {
                let (entries, mut c) = (&m[r], k);
                while c < SIZE {
                    if entries[c].abs() > best {
                        (row, column, best) = (r, c, entries[c].abs());
                    }
                    c += 1;
                }
            }
            pivots[k] = best;
            if best == 0.0 {
                break;
            }
            m.swap(k, row);
            for r in &mut m {
                r.swap(k, column);
            }
            let top = m[k];
            for r in &mut m[k + 1..] {
                subtract(r, r[k] / top[k], &top, k);
            }
        }
        let first = pivots[0];
        if first > 0.0 { pivots.map(|p| p / first) } else { pivots }
    }
}

impl Eliminant for Dialytic {
    const FLAT: f64 = 1e-6;
    const MOST: usize = 8;

    /// The determinant, and the smallest pivot on the way.
    fn value(&self, at: [f64; 2]) -> (f64, f64) {
        determinant(self.at(at))
    }

    /// From columns in the opposite order.
    fn again(&self, at: [f64; 2]) -> f64 {
        let mut m = self.at(at);
        for row in &mut m {
            // Six exchanges: the sign stays.
            row.reverse();
        }
        determinant(m).0
    }
}

/// The angle `x` and the value `y` of a null vector (of length one) `(cos 3x/2, sin 3x/2, cos x/2, sin x/2) x (1, cos y, sin y)`, in the
/// sense of least squares, and the squared distance of the vector from that form. `(1, y, y^2)` for a joint that slides.
fn values(v: &[f64; SIZE], prismatic: bool) -> ([[f64; 2]; 2], f64) {
    let (mut one, mut cos, mut sin) = (0.0, 0.0, 0.0);
    for i in 0..4 {
        one += v[3 * i] * v[3 * i];
        cos += v[3 * i] * v[3 * i + 1];
        sin += v[3 * i] * v[3 * i + 2];
    }
    let y = match (prismatic, one > 0.0) {
        (_, false) => [1.0, 0.0],
        (true, _) => [cos / one, 0.0],
        (false, _) => unit([cos, sin]),
    };
    let g = monomials(y, prismatic);
    let length = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    let g = g.map(|g| g / length);
    let [a, b, c, d] = [0, 3, 6, 9].map(|i| v[i] * g[0] + v[i + 1] * g[1] + v[i + 2] * g[2]);
    // x = 3x/2 - x/2
    let x = unit([a * c + b * d, b * c - a * d]);
    // From (cos x/2, sin x/2) = (p, r), up to a factor, follows (cos 3x/2, sin 3x/2).
    let (p, r) = (0.5 * (c + x[0] * a + x[1] * b), 0.5 * (d - x[1] * a + x[0] * b));
    let form = [x[0] * p - x[1] * r, x[1] * p + x[0] * r, p, r];
    let mut misfit = 0.0;
    for i in 0..4 {
        for k in 0..3 {
            let miss = v[3 * i + k] - form[i] * g[k];
            misfit += miss * miss;
        }
    }
    ([x, y], misfit)
}

fn normalised(x: &[f64; SIZE]) -> [f64; SIZE] {
    let norm = norm(*x);
    x.map(|x| x / norm)
}

/// Subtracts a multiple of one row from another, from a column on. (Macros run unoptimised, where `for` costs more than the sum.)
#[inline(always)]
fn subtract(row: &mut [f64; SIZE], factor: f64, other: &[f64; SIZE], from: usize) {
    let mut c = from;
    while c < SIZE {
        row[c] -= factor * other[c];
        c += 1;
    }
}

/// The determinant by Gaussian elimination with row pivots, and the smallest pivot.
fn determinant(mut m: Matrix) -> (f64, f64) {
    let (mut product, mut least) = (1.0, f64::INFINITY);
    for k in 0..SIZE {
        let mut row = k;
        for r in k + 1..SIZE {
            if m[r][k].abs() > m[row][k].abs() {
                row = r;
            }
        }
        if row != k {
            m.swap(k, row);
            product = -product;
        }
        let top = m[k];
        product *= top[k];
        least = least.min(top[k].abs());
        if top[k] == 0.0 {
            break;
        }
        let inverse = 1.0 / top[k];
        for r in &mut m[k + 1..] {
            subtract(r, r[k] * inverse, &top, k + 1);
        }
    }
    (product, least)
}

/// A factorised matrix.
struct Lu {
    m: Matrix,
    order: [usize; SIZE],
}

impl Lu {
    fn new(mut m: Matrix) -> Self {
        let mut order = core::array::from_fn(|i| i);
        for k in 0..SIZE {
            let mut row = k;
            for r in k + 1..SIZE {
                if m[r][k].abs() > m[row][k].abs() {
                    row = r;
                }
            }
            m.swap(k, row);
            order.swap(k, row);
            // A pivot that vanished by rounding is as good as a tiny one: the solution becomes a null vector.
            if m[k][k].abs() < 1e-18 {
                m[k][k] = 1e-18;
            }
            let top = m[k];
            let inverse = 1.0 / top[k];
            for r in &mut m[k + 1..] {
                r[k] *= inverse;
                subtract(r, r[k], &top, k + 1);
            }
        }
        Self { m, order }
    }

    fn solve(&self, b: &[f64; SIZE]) -> [f64; SIZE] {
        let mut x = self.order.map(|i| b[i]);
        for r in 0..SIZE {
            for c in 0..r {
                x[r] -= self.m[r][c] * x[c];
            }
        }
        for r in (0..SIZE).rev() {
            for c in r + 1..SIZE {
                x[r] -= self.m[r][c] * x[c];
            }
            x[r] /= self.m[r][r];
        }
        x
    }
}
