//! All real roots of a trigonometric polynomial, by halving arcs in Bernstein form.
//!
//! Why not eigenvalues of the companion matrix: it finds complex roots too, at a cost of `(2 D)^3`, and near double roots it cannot
//! tell a pair of real angles from a pair of complex ones. Here, an arc is thrown away only when its Bernstein coefficients prove
//! that there is no root, halved while there may be several, and its root is bracketed as soon as there is exactly one.

use super::bernstein::{ARCS, MAX_DEGREE, Tables};
use super::list::{Blank, List};
use super::root_isolation::{Arc, Bracket, Search, between, point, square};
use super::roots::{Angles, Outcome, Roots};
use super::tolerance::TOUCH;
use super::trig_poly::TrigPoly;

/// Whether two roots are nearly one. (Cosines and sines within 1e-4: what [`super::tolerance::GRAZING`] is for a single equation.)
fn close(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 2e-4
}

/// All roots of `constant + cos[0] cos t + cos[1] cos 2t + sin[0] sin t + sin[1] sin 2t`; `tol` is the size below which every angle is one.
pub fn solve_second_harmonic(constant: f64, cos: [f64; 2], sin: [f64; 2], tol: f64) -> Angles<4> {
    TrigPoly::<2> { constant, cos, sin }.roots(tol)
}

impl<const D: usize> TrigPoly<D> {
    const TABLES: Tables = {
        assert!(D >= 1 && D <= MAX_DEGREE, "degree of a trigonometric polynomial out of range");
        Tables::new(D)
    };

    /// All real roots in a turn, as `[cos, sin]`; `R` must be `2 D` or more.
    ///
    /// Roots of any closeness are found as long as rounding doesn't hide their number. An extremum that misses zero by less than
    /// [`TOUCH`] (relative to the sum of all coefficients) counts as a double root, is returned once, and makes the outcome
    /// [`Outcome::Touching`]. Wherever the polynomial vanishes to higher order, it is returned once or a few times, near the root.
    ///
    /// - All coefficients together at most `zero` (absolute): [`Outcome::Free`], no root.
    /// - [`Outcome::NoRealRoot`], also for coefficients that aren't finite.
    pub fn roots<const R: usize>(&self, zero: f64) -> Angles<R> {
        let marked: Roots<([f64; 2], bool), R> = self.marked_roots(zero, TOUCH);
        let mut roots = List::new();
        for &(root, _) in &marked {
            roots.push(root);
        }
        Angles { roots, outcome: marked.outcome }
    }

    /// [`TrigPoly::roots`], each marked if it only touches zero (within `touch`, relative to the sum of all coefficients).
    pub(super) fn marked_roots<const R: usize>(&self, zero: f64, touch: f64) -> Roots<([f64; 2], bool), R> {
        const { assert!(2 * D <= R, "a trigonometric polynomial of degree D has up to 2 D roots") };
        let size = self.size();
        if size <= zero {
            return Roots::none(Outcome::Free);
        }
        if !(size < f64::INFINITY) {
            return Roots::none(Outcome::NoRealRoot);
        }
        let mut roots = List::new();
        // 2 D + 1 coefficients, spelled out because a constant can't be computed from D.
        match D {
            1 => self.each_root::<3>(touch, |root| _ = roots.push(root)),
            2 => self.each_root::<5>(touch, |root| _ = roots.push(root)),
            3 => self.each_root::<7>(touch, |root| _ = roots.push(root)),
            4 => self.each_root::<9>(touch, |root| _ = roots.push(root)),
            5 => self.each_root::<11>(touch, |root| _ = roots.push(root)),
            6 => self.each_root::<13>(touch, |root| _ = roots.push(root)),
            7 => self.each_root::<15>(touch, |root| _ = roots.push(root)),
            8 => self.each_root::<17>(touch, |root| _ = roots.push(root)),
            9 => self.each_root::<19>(touch, |root| _ = roots.push(root)),
            10 => self.each_root::<21>(touch, |root| _ = roots.push(root)),
            11 => self.each_root::<23>(touch, |root| _ = roots.push(root)),
            _ => self.each_root::<25>(touch, |root| _ = roots.push(root)),
        }
        // Touching roots come last.
        let outcome = match roots.last() {
            None => Outcome::NoRealRoot,
            Some((_, false)) if roots.iter().enumerate().any(|(i, r)| roots[..i].iter().any(|s| close(r.0, s.0))) => {
                Outcome::Touching
            }
            Some((_, false)) => Outcome::Regular,
            Some((_, true)) => Outcome::Touching,
        };
        Roots { roots, outcome }
    }

    /// Calls `found` with every real root, and whether it only touches zero; `C = 2 D + 1`.
    fn each_root<const C: usize>(&self, touch: f64, mut found: impl FnMut(([f64; 2], bool))) {
        let mut search = Search::<C>::new(self.size(), touch);
        for arc in &self.on_arcs() {
            search.arc(arc);
        }
        self.refine(search.brackets.as_mut_slice());
        for bracket in &search.brackets {
            found((bracket.at, false));
        }
        for &(at, _) in &search.touching {
            found((at, true));
        }
    }

    /// The arcs that make up the circle, with their coefficients.
    #[inline]
    pub(super) fn on_arcs<const C: usize>(&self) -> [Arc<C>; ARCS] {
        let mut arcs = [Arc::BLANK; ARCS];
        // Fourier coefficients around the middle of the first arc; a quarter turn to the next middle exchanges them.
        let (mut cos, mut sin) = ([0.0; MAX_DEGREE], [0.0; MAX_DEGREE]);
        for k in 0..D {
            let (c, s) = Self::TABLES.turn[k];
            cos[k] = self.cos[k] * c + self.sin[k] * s;
            sin[k] = self.sin[k] * c - self.cos[k] * s;
        }
        for (i, arc) in arcs.iter_mut().enumerate() {
            arc.ends = [Self::TABLES.ends[i], Self::TABLES.ends[i + 1]];
            let (mut even, mut odd) = ([0.0; MAX_DEGREE + 1], [0.0; MAX_DEGREE + 1]);
            for j in 0..=D {
                even[j] = self.constant * Self::TABLES.one[j];
            }
            for k in 0..D {
                for j in 0..=D {
                    even[j] += cos[k] * Self::TABLES.cos[k][j];
                    odd[j] += sin[k] * Self::TABLES.sin[k][j];
                }
                (cos[k], sin[k]) = match k % 4 {
                    0 => (sin[k], -cos[k]),
                    1 => (-cos[k], -sin[k]),
                    2 => (-sin[k], cos[k]),
                    _ => (cos[k], sin[k]),
                };
            }
            for j in 0..=D {
                arc.b[j] = even[j] + odd[j];
                arc.b[2 * D - j] = even[j] - odd[j];
            }
        }
        // One arc's last coefficient is the next one's first: they must not differ, or a root could fall in between.
        for i in 0..ARCS {
            arcs[(i + 1) % ARCS].b[0] = arcs[i].b[2 * D];
        }
        arcs
    }

    /// Moves the starting points of all brackets onto their roots.
    pub(super) fn refine(&self, brackets: &mut [Bracket]) {
        // Three of Halley's steps (the error is cubed each time) are enough for nearly all roots. All roots together, without
        // a branch, so that none waits for another.
        for _ in 0..3 {
            for bracket in &mut *brackets {
                let at = bracket.at;
                let [value, slope, bend] = self.value_slope_bend(at);
                // Half the step is a / b; it is taken as twice the arctangent of that.
                let (a, b) = (-value * slope, 2.0 * slope * slope - value * bend);
                let (aa, bb) = (a * a, b * b);
                let inverse = 1.0 / (aa + bb);
                let (c, s) = ((bb - aa) * inverse, 2.0 * a * b * inverse);
                bracket.at = [at[0] * c - at[1] * s, at[0] * s + at[1] * c];
                bracket.last = s;
            }
        }
        for bracket in brackets {
            let at = bracket.at;
            let [from, to] = bracket.ends.map(square);
            let inside = from[0] * at[1] - from[1] * at[0] >= 0.0 && at[0] * to[1] - at[1] * to[0] >= 0.0;
            let ahead = from[0] * at[0] + from[1] * at[1] > 0.0;
            if !(inside && ahead && bracket.last.abs() < 1e-6) {
                bracket.at = self.bracketed(bracket);
            }
        }
    }

    /// The root in a bracket, by Newton's method that never leaves it.
    #[inline(never)]
    fn bracketed(&self, bracket: &Bracket) -> [f64; 2] {
        let [d0, d1] = bracket.ends;
        let area = 2.0 * (d0[0] * d1[1] - d0[1] * d1[0]);
        let (mut low, mut high, mut x) = (0.0, 1.0, 0.5);
        for _ in 0..60 {
            let d = between(&bracket.ends, x);
            let inverse = 1.0 / (d[0] * d[0] + d[1] * d[1]);
            let at = square(d).map(|x| x * inverse);
            let (value, slope) = self.value_and_slope(at);
            if value == 0.0 {
                return at;
            }
            if (value > 0.0) == bracket.rising {
                high = x;
            } else {
                low = x;
            }
            // dt/dx = 2 (d0 x d1) / |d|^2
            let newton = x - value / (slope * area * inverse);
            // The error after a Newton step is about the square of the step. (A step that small may leave the bracket by rounding.)
            if (newton - x).abs() < 1e-9 {
                x = newton.clamp(low, high);
                break;
            }
            x = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if high - low < 1e-16 {
                break;
            }
        }
        point(&bracket.ends, x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{Rng, random_trig_poly};
    use core::f64::consts::PI;

    /// The polynomial with the given roots: a product of `sin((t - a)/2) sin((t - b)/2)`.
    fn with_roots<const D: usize>(pairs: &[(f64, f64); D]) -> TrigPoly<D> {
        let mut p = TrigPoly::<D>::ZERO;
        p.constant = 1.0;
        for &(a, b) in pairs {
            let factor = TrigPoly::<1>::linear(((a - b) / 2.0).cos(), -((a + b) / 2.0).cos(), -((a + b) / 2.0).sin());
            let product: TrigPoly<24> = TrigPoly::<D>::times::<1, 24>(&p, &factor);
            p.constant = product.constant;
            p.cos.copy_from_slice(&product.cos[..D]);
            p.sin.copy_from_slice(&product.sin[..D]);
        }
        p
    }

    fn distance(root: &[f64; 2], t: f64) -> f64 {
        (root[1] * t.cos() - root[0] * t.sin()).atan2(root[0] * t.cos() + root[1] * t.sin()).abs()
    }

    /// Sign changes on a fine grid, by the naive sum.
    fn sign_changes<const D: usize>(p: &TrigPoly<D>) -> usize {
        let steps = 20_000;
        let value = |i: usize| {
            let t = 2.0 * PI * (i as f64 + 0.123) / steps as f64;
            p.value_and_slope([t.cos(), t.sin()]).0 >= 0.0
        };
        (0..steps).filter(|&i| value(i) != value(i + 1)).count()
    }

    fn count_matches<const D: usize, const R: usize>(seed: u64, rounds: usize) {
        let mut rng = Rng::new(seed);
        for _ in 0..rounds {
            let p: TrigPoly<D> = random_trig_poly(&mut rng);
            let found = p.roots::<R>(0.0);
            assert!(found.outcome == Outcome::Regular || found.outcome == Outcome::NoRealRoot);
            for root in &found {
                let value = p.value_and_slope(*root).0.abs() / p.size();
                assert!(value < 1e-14, "{value} {D} {found:?}");
                assert!((root[0].hypot(root[1]) - 1.0).abs() < 1e-15);
            }
            // The grid may miss a narrow pair, the solver must not.
            let grid = sign_changes(&p);
            assert!(found.len() >= grid && found.len().is_multiple_of(2), "{} < {grid}", found.len());
            assert!(found.len() - grid <= 2);
        }
    }

    #[test]
    fn random_polynomials_lose_no_root() {
        count_matches::<1, 2>(30, 100);
        count_matches::<2, 4>(31, 100);
        count_matches::<4, 8>(32, 100);
        count_matches::<8, 16>(33, 50);
        count_matches::<12, 24>(34, 25);
    }

    #[test]
    fn sixteen_given_roots_come_back() {
        let mut rng = Rng::new(35);
        for _ in 0..500 {
            let pairs: [(f64, f64); 8] = [(); 8].map(|()| (rng.angle(), rng.angle()));
            let found = with_roots(&pairs).roots::<16>(0.0);
            assert!(found.len() == 16, "{}", found.len());
            for t in pairs.iter().flat_map(|&(a, b)| [a, b]) {
                // Neighbours make a root ill-conditioned, not lost.
                assert!(found.iter().any(|r| distance(r, t) < 1e-3));
            }
        }
    }

    #[test]
    fn special_angles_are_no_special_case() {
        for k in 0..48 {
            let t = f64::from(k) * PI / 24.0;
            for pairs in [[(t, t + PI), (t + PI / 2.0, t - PI / 2.0)], [(t, 0.3), (t + PI / 12.0, t + 3.0)]] {
                let found = with_roots(&pairs).roots::<4>(0.0);
                assert_eq!((found.len(), found.outcome), (4, Outcome::Regular));
            }
        }
    }

    #[test]
    fn close_pairs_are_two_roots_until_rounding_hides_them() {
        let mut rng = Rng::new(36);
        for gap in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            for _ in 0..200 {
                let t = rng.angle();
                let p = with_roots(&[(t, t + gap), (t + 2.0, t - 1.5), (t + 1.0, t - 2.5)]);
                let found = p.roots::<6>(0.0);
                assert_eq!(found.len(), 6, "{gap}");
                assert!(found.iter().any(|r| distance(r, t) < 1e-2 * gap + 1e-9 / gap * 1e-6));
            }
        }
    }

    #[test]
    fn a_double_root_is_returned_once_and_named() {
        let mut rng = Rng::new(37);
        for lift in [0.0, 1e-16, -1e-16, 1e-12] {
            for i in 0..200 {
                let t = if i < 48 { f64::from(i) * PI / 24.0 } else { rng.angle() };
                let mut p = with_roots(&[(t, t), (t + 2.0, t - 1.5), (t + 1.0, t + 1.0)]);
                p.constant += lift * p.size();
                let found = p.roots::<6>(0.0);
                let close = found.iter().filter(|r| distance(r, t) < 1e-5).count();
                // Rounding may turn a double root into two.
                assert!(close == 1 || close == 2, "{lift} {t}: {close}");
                assert!(found.iter().any(|r| distance(r, t + 1.0) < 1e-5));
                assert!(found.len() >= 4 && found.len() <= 6);
            }
        }
    }

    #[test]
    fn double_roots_on_the_ends_of_arcs_are_not_lost() {
        for end in TrigPoly::<2>::TABLES.ends {
            let t = 2.0 * end[1].atan2(end[0]);
            for shift in [0.0, 1e-16, -1e-15, 3e-14, 1e-9, -1e-9] {
                let found = with_roots(&[(t + shift, t + shift), (t + 1.0, t + 1.7)]).roots::<4>(0.0);
                assert!(found.iter().any(|r| distance(r, t) < 1e-5), "{t} {shift}");
                let found = with_roots(&[(t + shift, t + 3.0), (t + 1.0, t + 1.7)]).roots::<4>(0.0);
                assert!(found.len() == 4, "{t} {shift} {}", found.len());
            }
        }
    }

    #[test]
    fn roots_of_higher_order_are_found_nearby() {
        for t in [0.0, 0.4, 1.0, PI] {
            let found = with_roots(&[(t, t), (t, t + 1.0)]).roots::<4>(0.0);
            assert!(found.iter().any(|r| distance(r, t) < 1e-3) && found.iter().any(|r| distance(r, t + 1.0) < 1e-9));
            let found = with_roots(&[(t, t), (t, t)]).roots::<4>(0.0);
            assert!(found.iter().any(|r| distance(r, t) < 2e-2) && found.len() <= 4);
        }
    }

    #[test]
    fn polynomials_without_roots_and_without_anything() {
        let p = TrigPoly::<2> { constant: 3.0, cos: [1.0, 0.5], sin: [0.5, 0.2] };
        assert_eq!(p.roots::<4>(0.0).outcome, Outcome::NoRealRoot);
        assert_eq!(TrigPoly::<3>::ZERO.roots::<6>(0.0).outcome, Outcome::Free);
        assert!(TrigPoly::<1>::linear(1e-13, 0.0, -1e-13).roots::<2>(1e-12).is_free());
        assert!(TrigPoly::<1>::linear(f64::NAN, 1.0, 1.0).roots::<2>(1e-12).is_empty());
        assert!(TrigPoly::<1>::linear(0.0, 1.0, f64::INFINITY).roots::<2>(1e-12).is_empty());
    }

    #[test]
    fn degree_may_be_lower_than_declared() {
        let mut p = TrigPoly::<8>::ZERO;
        (p.constant, p.cos[0]) = (0.5, 1.0);
        let found = p.roots::<16>(0.0);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|r| (r[0] + 0.5).abs() < 1e-15));
    }
}
