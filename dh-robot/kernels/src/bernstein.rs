//! Trigonometric polynomials on an arc, in Bernstein form: the tables that lead there, and how to halve an arc.
//!
//! Let `d(t) = (cos(t/2), sin(t/2))`. A trigonometric polynomial of degree `D` is a form of degree `n = 2 D` in `d`. On an arc
//! from `t0` to `t1` (shorter than a turn) write `d = u d0 + v d1` with `u, v >= 0`; then
//!
//! ```text
//! p = |d|^-n sum_j binomial(n, j) b_j u^(n-j) v^j.
//! ```
//!
//! The coefficients `b_j` bound `p`, their signs vary at least as often as `p` has roots on the arc and by an even number more
//! (Descartes; variation diminishing), and halving the arc is de Casteljau's algorithm: sums of neighbours, without any loss of digits.

/// Largest degree of a trigonometric polynomial whose roots can be found.
pub(super) const MAX_DEGREE: usize = 12;
/// Number of Bernstein coefficients of that degree.
pub(super) const MAX_COEFFICIENTS: usize = 2 * MAX_DEGREE + 1;

/// The circle is cut into this many equal arcs.
pub(super) const ARCS: usize = 4;

/// The middle of the first arc, in radians. No multiple of 15 degrees, where the roots of real arms like to be, is an end or a
/// middle of an arc: such roots work too, but cost a few more halvings.
const FIRST_MIDDLE: f64 = 0.131;

/// Sine and cosine by their series, for constants (the ordinary functions can't run at compile time).
pub(super) const fn sin_cos_series(x: f64) -> (f64, f64) {
    let (mut sin, mut cos, mut term) = (0.0, 0.0, 1.0);
    let mut k = 0;
    while k < 40 {
        match k % 4 {
            0 => cos += term,
            1 => sin += term,
            2 => cos -= term,
            _ => sin -= term,
        }
        k += 1;
        term = term * x / k as f64;
    }
    (sin, cos)
}

/// What leads from Fourier coefficients to Bernstein coefficients, for degree `D`.
pub(super) struct Tables {
    /// `(cos k m, sin k m)` for the middle `m` of the first arc, `k = 1..`.
    pub(super) turn: [(f64, f64); MAX_DEGREE],
    /// Bernstein coefficients `j = 0..=D` of `cos(k t)` on an arc around zero, `k = 1..`; they are even in `j <-> n - j`.
    pub(super) cos: [[f64; MAX_DEGREE + 1]; MAX_DEGREE],
    /// Those of `sin(k t)`; they are odd.
    pub(super) sin: [[f64; MAX_DEGREE + 1]; MAX_DEGREE],
    /// Those of the constant 1.
    pub(super) one: [f64; MAX_DEGREE + 1],
    /// `(cos(t/2), sin(t/2))` at the arcs' ends; the last one is minus the first.
    pub(super) ends: [[f64; 2]; ARCS + 1],
}

impl Tables {
    pub(super) const fn new(degree: usize) -> Self {
        let mut tables = Self {
            turn: [(0.0, 0.0); MAX_DEGREE],
            cos: [[0.0; MAX_DEGREE + 1]; MAX_DEGREE],
            sin: [[0.0; MAX_DEGREE + 1]; MAX_DEGREE],
            one: [0.0; MAX_DEGREE + 1],
            ends: [[0.0; 2]; ARCS + 1],
        };
        let half_arc = core::f64::consts::PI / ARCS as f64;
        let mut k = 0;
        while k <= degree {
            // exp(i k t) = z^(D+k) conj(z)^(D-k) with z = exp(i t/2) = u z0 + v z1, z1 = conj(z0) = exp(i half_arc / 2).
            let (s, c) = sin_cos_series(0.5 * half_arc);
            let mut re = [0.0; MAX_COEFFICIENTS];
            let mut im = [0.0; MAX_COEFFICIENTS];
            re[0] = 1.0;
            let mut count = 0;
            while count < 2 * degree {
                // One more factor: u (c - i y) + v (c + i y), with y = s, or -s for the conjugate.
                let y = if count < degree + k { s } else { -s };
                let mut j = count + 1;
                loop {
                    let (r, i) = (re[j], im[j]);
                    let (mut new_r, mut new_i) = (r * c + i * y, i * c - r * y);
                    if j > 0 {
                        let (r, i) = (re[j - 1], im[j - 1]);
                        new_r += r * c - i * y;
                        new_i += i * c + r * y;
                    }
                    (re[j], im[j]) = (new_r, new_i);
                    if j == 0 {
                        break;
                    }
                    j -= 1;
                }
                count += 1;
            }
            let mut binomial = 1.0;
            let mut j = 0;
            while j <= degree {
                if k == 0 {
                    tables.one[j] = re[j] / binomial;
                } else {
                    tables.cos[k - 1][j] = re[j] / binomial;
                    tables.sin[k - 1][j] = im[j] / binomial;
                }
                binomial = binomial * (2 * degree - j) as f64 / (j + 1) as f64;
                j += 1;
            }
            if k > 0 {
                let (s, c) = sin_cos_series(k as f64 * FIRST_MIDDLE);
                tables.turn[k - 1] = (c, s);
            }
            k += 1;
        }
        let mut arc = 0;
        while arc <= ARCS {
            let angle = FIRST_MIDDLE + (2 * arc) as f64 * half_arc - half_arc;
            let (s, c) = sin_cos_series(0.5 * angle);
            tables.ends[arc] = [c, s];
            arc += 1;
        }
        tables
    }
}

/// Interpolation at Chebyshev's points of an arc: what gives Bernstein coefficients for values, where no global polynomial is exact enough.
pub(super) struct Nodes<const C: usize> {
    /// The parameters of the points, between 0 and 1.
    pub(super) at: [f64; C],
    /// Row `j` times the values (each over `|d|^-n`) is the coefficient `b_j`.
    pub(super) inverse: [[f64; C]; C],
}

impl<const C: usize> Nodes<C> {
    pub(super) const fn new() -> Self {
        let n = C - 1;
        let mut at = [0.0; C];
        // Rows [Bernstein polynomials at a node | unit matrix], to be reduced by Gauss and Jordan with row pivots.
        let mut left = [[0.0; C]; C];
        let mut inverse = [[0.0; C]; C];
        let mut k = 0;
        while k < C {
            let (_, c) = sin_cos_series(core::f64::consts::PI * (2 * k + 1) as f64 / (2 * C) as f64);
            let x = 0.5 - 0.5 * c;
            at[k] = x;
            inverse[k][k] = 1.0;
            let mut binomial = 1.0;
            let mut j = 0;
            while j <= n {
                let mut product = binomial;
                let mut i = 0;
                while i < n {
                    product *= if i < j { x } else { 1.0 - x };
                    i += 1;
                }
                left[k][j] = product;
                binomial = binomial * (n - j) as f64 / (j + 1) as f64;
                j += 1;
            }
            k += 1;
        }
        let mut k = 0;
        while k < C {
            let mut row = k;
            let mut r = k + 1;
            while r < C {
                if left[r][k].abs() > left[row][k].abs() {
                    row = r;
                }
                r += 1;
            }
            (left[k], left[row]) = (left[row], left[k]);
            (inverse[k], inverse[row]) = (inverse[row], inverse[k]);
            let pivot = left[k][k];
            let mut j = 0;
            while j < C {
                left[k][j] /= pivot;
                inverse[k][j] /= pivot;
                j += 1;
            }
            let mut r = 0;
            while r < C {
                let factor = if r == k { 0.0 } else { left[r][k] };
                let mut j = 0;
                while j < C {
                    left[r][j] -= factor * left[k][j];
                    inverse[r][j] -= factor * inverse[k][j];
                    j += 1;
                }
                r += 1;
            }
            k += 1;
        }
        Self { at, inverse }
    }
}

/// Halves an arc of degree `C - 1`: `b` becomes its second half, and the first half is returned. The new end is the vector
/// `(d0 + d1) / 2`, not normalised.
#[inline]
pub(super) fn halve<const C: usize>(b: &mut [f64; C]) -> [f64; C] {
    let mut left = [0.0; C];
    let n = C - 1;
    left[0] = b[0];
    for r in 1..=n {
        // After step r, b[j] for j <= n - r are the averages over r + 1 neighbours, and later entries belong to the second half.
        for j in 0..=n - r {
            b[j] = 0.5 * (b[j] + b[j + 1]);
        }
        left[r] = b[0];
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_agree_with_the_functions() {
        for x in [0.0, 0.131, -0.5, 1.5, 3.3] {
            let (s, c) = sin_cos_series(x);
            assert!((s - x.sin()).abs() < 1e-15 && (c - x.cos()).abs() < 1e-15);
        }
    }

    #[test]
    fn values_at_the_nodes_give_back_the_coefficients() {
        const NODES: Nodes<17> = Nodes::new();
        let b: [f64; 17] = core::array::from_fn(|j| ((j * j * 7 + 3) % 11) as f64 - 5.0);
        let values = NODES.at.map(|x| {
            let mut w = b;
            for n in (1..17).rev() {
                for j in 0..n {
                    w[j] += x * (w[j + 1] - w[j]);
                }
            }
            w[0]
        });
        for j in 0..17 {
            let back: f64 = NODES.inverse[j].iter().zip(&values).map(|(a, b)| a * b).sum();
            assert!((back - b[j]).abs() < 1e-9, "{j}: {back}");
        }
    }

    #[test]
    fn halves_are_the_same_polynomial() {
        let value = |b: &[f64], x: f64| {
            let mut b = b.to_vec();
            while b.len() > 1 {
                b = b.windows(2).map(|w| w[0] * (1.0 - x) + w[1] * x).collect();
            }
            b[0]
        };
        let mut whole = [0.0; 7];
        for (j, b) in whole.iter_mut().enumerate() {
            *b = ((j * j * 7 + 3) % 11) as f64 - 5.0;
        }
        let mut right = whole;
        let left = halve(&mut right);
        for x in [0.0, 0.3, 1.0] {
            assert!((value(&left, x) - value(&whole, 0.5 * x)).abs() < 1e-13);
            assert!((value(&right, x) - value(&whole, 0.5 + 0.5 * x)).abs() < 1e-13);
        }
    }
}
