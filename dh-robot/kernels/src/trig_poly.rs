//! Real trigonometric polynomials in one angle: arithmetic and evaluation. Their roots are found in `trig_roots.rs`.

/// `constant + sum_k cos[k-1] cos(k t) + sin[k-1] sin(k t)`, `k = 1..=D`.
///
/// The Fourier basis is the well-conditioned one for real angles, all of which are alike in it: the half-angle
/// polynomial in `tan(t/2)` that textbooks use puts half a turn at infinity and loses digits near it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrigPoly<const D: usize> {
    /// The mean.
    pub constant: f64,
    /// Coefficients of the cosines, the first harmonic first.
    pub cos: [f64; D],
    /// Coefficients of the sines.
    pub sin: [f64; D],
}

impl<const D: usize> TrigPoly<D> {
    /// The polynomial that is zero everywhere.
    pub const ZERO: Self = Self { constant: 0.0, cos: [0.0; D], sin: [0.0; D] };

    /// The sum of the absolute values of all coefficients: an upper bound of the polynomial's size.
    #[inline]
    pub fn size(&self) -> f64 {
        let mut sum = self.constant.abs();
        for k in 0..D {
            sum += self.cos[k].abs() + self.sin[k].abs();
        }
        sum
    }

    /// The value and the derivative at the angle with `[cos t, sin t]`.
    #[inline]
    pub fn value_and_slope(&self, at: [f64; 2]) -> (f64, f64) {
        let [value, slope, _] = self.value_slope_bend(at);
        (value, slope)
    }

    /// The value and the first two derivatives at the angle with `[cos t, sin t]`.
    #[inline]
    pub(super) fn value_slope_bend(&self, [c, s]: [f64; 2]) -> [f64; 3] {
        // Powers of cos t + i sin t by halves, so that they don't wait for each other.
        let (mut re, mut im) = ([c; D], [s; D]);
        for k in 1..D {
            // Indices count from 0: entry k is harmonic k + 1 = half + rest.
            let half = k.div_ceil(2);
            let (h, l) = (half - 1, k - half);
            re[k] = re[h] * re[l] - im[h] * im[l];
            im[k] = re[h] * im[l] + im[h] * re[l];
        }
        let (mut value, mut slope, mut bend) = (self.constant, 0.0, 0.0);
        for k in 0..D {
            let (along, across) =
                (self.cos[k] * re[k] + self.sin[k] * im[k], self.sin[k] * re[k] - self.cos[k] * im[k]);
            let harmonic = (k + 1) as f64;
            value += along;
            slope += harmonic * across;
            bend -= harmonic * harmonic * along;
        }
        [value, slope, bend]
    }

    /// The sum of two polynomials, the second one multiplied by `factor`.
    #[inline]
    #[must_use]
    pub fn plus(&self, other: &Self, factor: f64) -> Self {
        let mut out = *self;
        out.constant += factor * other.constant;
        for k in 0..D {
            out.cos[k] += factor * other.cos[k];
            out.sin[k] += factor * other.sin[k];
        }
        out
    }

    /// The product, as a polynomial of degree `P`, which must be the sum of the two degrees or more.
    #[inline]
    #[must_use]
    pub fn times<const E: usize, const P: usize>(&self, other: &TrigPoly<E>) -> TrigPoly<P> {
        const { assert!(D + E <= P, "the product has a higher degree") };
        let mut out = TrigPoly::<P>::ZERO;
        out.constant = self.constant * other.constant;
        for k in 0..D {
            out.cos[k] += self.cos[k] * other.constant;
            out.sin[k] += self.sin[k] * other.constant;
        }
        for l in 0..E {
            out.cos[l] += self.constant * other.cos[l];
            out.sin[l] += self.constant * other.sin[l];
        }
        for k in 0..D {
            for l in 0..E {
                let (a, b) = (0.5 * self.cos[k], 0.5 * self.sin[k]);
                let (c, d) = (other.cos[l], other.sin[l]);
                // Harmonics k + l + 2 and k - l of the two factors (indices count from 0).
                out.cos[k + l + 1] += a * c - b * d;
                out.sin[k + l + 1] += b * c + a * d;
                let (difference_cos, difference_sin) = (a * c + b * d, b * c - a * d);
                if k > l {
                    out.cos[k - l - 1] += difference_cos;
                    out.sin[k - l - 1] += difference_sin;
                } else if k < l {
                    out.cos[l - k - 1] += difference_cos;
                    out.sin[l - k - 1] -= difference_sin;
                } else {
                    out.constant += difference_cos;
                }
            }
        }
        out
    }
}

impl TrigPoly<1> {
    /// `constant + cos cos(t) + sin sin(t)`.
    #[inline]
    pub const fn linear(constant: f64, cos: f64, sin: f64) -> Self {
        Self { constant, cos: [cos], sin: [sin] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{Rng, random_trig_poly};

    #[test]
    fn value_and_slope_agree_with_the_sum_of_cosines_and_sines() {
        let mut rng = Rng::new(20);
        let p: TrigPoly<5> = random_trig_poly(&mut rng);
        for _ in 0..50 {
            let t = rng.angle();
            let (mut value, mut slope) = (p.constant, 0.0);
            for k in 1..=5 {
                let (s, c) = (k as f64 * t).sin_cos();
                value += p.cos[k - 1] * c + p.sin[k - 1] * s;
                slope += k as f64 * (p.sin[k - 1] * c - p.cos[k - 1] * s);
            }
            let (v, d) = p.value_and_slope([t.cos(), t.sin()]);
            assert!((v - value).abs() < 1e-14 && (d - slope).abs() < 1e-13);
        }
    }

    #[test]
    fn products_and_sums_hold_at_every_angle() {
        let mut rng = Rng::new(21);
        let (a, b): (TrigPoly<2>, TrigPoly<3>) = (random_trig_poly(&mut rng), random_trig_poly(&mut rng));
        let (ab, ba): (TrigPoly<6>, TrigPoly<5>) = (a.times(&b), b.times(&a));
        let twice = a.plus(&a, 1.0);
        for _ in 0..50 {
            let t = rng.angle();
            let at = [t.cos(), t.sin()];
            let product = a.value_and_slope(at).0 * b.value_and_slope(at).0;
            assert!((ab.value_and_slope(at).0 - product).abs() < 1e-14);
            assert!((ba.value_and_slope(at).0 - product).abs() < 1e-14);
            assert!((twice.value_and_slope(at).0 - 2.0 * a.value_and_slope(at).0).abs() < 1e-14);
        }
    }
}
