//! All real roots of a trigonometric polynomial, by halving arcs in Bernstein form.
//!
//! Why not eigenvalues of the companion matrix: it finds complex roots too, at a cost of `(2 D)^3`, and near double roots it cannot
//! tell a pair of real angles from a pair of complex ones. Here, an arc is thrown away only when its Bernstein coefficients prove
//! that there is no root, halved while there may be several, and its root is bracketed as soon as there is exactly one.

use super::bernstein::{ARCS, MAX_COEFFICIENTS, MAX_DEGREE, Tables, halve};
use super::found::{Angles, Found, Outcome};
use super::list::List;
use super::math::sqrt;
use super::tolerance::TOUCH;
use super::trig_poly::TrigPoly;

/// Arcs are not halved more often than this: 2 pi / 4 / 2^24 is a ten-millionth of a radian.
const MAX_DEPTH: usize = 24;
/// Two touching roots nearer than this are one that was seen from two arcs.
const SAME_TOUCH: f64 = 1e-6;

/// An arc on which roots are still to be looked for.
#[derive(Clone, Copy)]
struct Arc<const C: usize> {
    /// Bernstein coefficients; entries after `2 D` are not used.
    b: [f64; C],
    /// Its ends as half-angle vectors (not of unit length).
    ends: [[f64; 2]; 2],
    depth: usize,
}

impl<const C: usize> Default for Arc<C> {
    fn default() -> Self {
        Self { b: [0.0; C], ends: [[0.0; 2]; 2], depth: 0 }
    }
}

/// An arc with exactly one root.
#[derive(Clone, Copy, Default)]
struct Bracket {
    /// Its ends as half-angle vectors.
    ends: [[f64; 2]; 2],
    /// First negative, then positive?
    rising: bool,
    /// The approximate root as `[cos, sin]`.
    at: [f64; 2],
    /// Sine of the last step that led there.
    last: f64,
}

/// What a search knows and has found.
struct Search<const C: usize, F> {
    /// An extremum that misses zero by less is a double root.
    touch: f64,
    /// An extremum beyond zero by less isn't beyond zero.
    noise: f64,
    /// An arc whose coefficients are all smaller is a root of higher order.
    nothing: f64,
    /// Arcs with one root. More than `2 D < C` of them would be an artefact of rounding.
    brackets: List<Bracket, C>,
    /// Called with every touching root.
    touching: F,
}

impl<const C: usize, F> Search<C, F> {
    /// Notes that the arc has exactly one root between the parameters `low` and `high`, probably near `x`.
    #[inline]
    fn bracket(&mut self, arc: &Arc<C>, low: f64, high: f64, x: f64, rising: bool) {
        let ends = [between(&arc.ends, low), between(&arc.ends, high)];
        self.brackets.push(Bracket { ends, rising, at: point(&arc.ends, x), last: 0.0 });
    }
}

/// What the coefficients of an arc say.
enum Verdict {
    /// No root.
    Empty,
    /// Exactly one, and the ends have opposite signs.
    One,
    /// Several, or perhaps a double one.
    Unclear,
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
        let marked: Found<([f64; 2], bool), R> = self.marked_roots(zero, TOUCH);
        let mut roots = List::new();
        for &(root, _) in &marked {
            roots.push(root);
        }
        Angles { roots, outcome: marked.outcome }
    }

    /// [`TrigPoly::roots`], each with a mark: does it only touch zero (within `touch`, relative to the sum of all coefficients)?
    pub(super) fn marked_roots<const R: usize>(&self, zero: f64, touch: f64) -> Found<([f64; 2], bool), R> {
        const { assert!(2 * D <= R, "a trigonometric polynomial of degree D has up to 2 D roots") };
        let size = self.size();
        if size <= zero {
            return Found::none(Outcome::Free);
        }
        if !(size < f64::INFINITY) {
            return Found::none(Outcome::NoRealRoot);
        }
        let mut roots = List::<([f64; 2], bool), R>::new();
        let mut touching = List::<[f64; 2], R>::new();
        self.each_root(touch, |root, touches| {
            if !touches {
                roots.push((root, false));
            } else if !touching.iter().any(|t| near(*t, root)) {
                touching.push(root);
            }
        });
        for &t in &touching {
            roots.push((t, true));
        }
        let outcome = match (roots.is_empty(), touching.is_empty()) {
            (true, _) => Outcome::NoRealRoot,
            (false, true) => Outcome::Regular,
            (false, false) => Outcome::Touching,
        };
        Found { roots, outcome }
    }

    /// Calls `found` with every real root, and whether it only touches zero (within `touch`, relative).
    pub(super) fn each_root(&self, touch: f64, mut found: impl FnMut([f64; 2], bool)) {
        // Storage for 2 D + 1 coefficients, in a few sizes.
        match D {
            1 => self.each_root_in::<3>(touch, &mut found),
            2 => self.each_root_in::<5>(touch, &mut found),
            3 | 4 => self.each_root_in::<9>(touch, &mut found),
            5..=8 => self.each_root_in::<17>(touch, &mut found),
            _ => self.each_root_in::<MAX_COEFFICIENTS>(touch, &mut found),
        }
    }

    /// [`TrigPoly::each_root`] with `C >= 2 D + 1`.
    fn each_root_in<const C: usize>(&self, touch: f64, found: &mut impl FnMut([f64; 2], bool)) {
        let n = 2 * D;
        let scale = self.size();
        let mut search = Search::<C, _> {
            touch: touch * scale,
            noise: 1e-15 * scale,
            nothing: 1e-14 * scale,
            brackets: List::new(),
            touching: |at| found(at, true),
        };
        let mut arcs = [[0.0; C]; ARCS];
        self.on_arcs(&mut arcs);
        // One arc's last coefficient is the next one's first: they must not differ, or a root could fall in between.
        for i in 0..ARCS {
            arcs[(i + 1) % ARCS][0] = arcs[i][n];
        }
        for i in 0..ARCS {
            let arc = Arc { b: arcs[i], ends: [Self::TABLES.ends[i], Self::TABLES.ends[i + 1]], depth: 0 };
            if !self.settle(&arc, &mut search) {
                self.halve_until_settled(arc, &mut search);
            }
        }
        let mut brackets = search.brackets;
        self.refine(brackets.as_mut_slice());
        for bracket in &brackets {
            found(bracket.at, false);
        }
    }

    /// Finds the roots in an arc by halving it as often as needed.
    #[inline(never)] // Keeps the stack of arcs away from the many polynomials that don't need it.
    fn halve_until_settled<const C: usize, F: FnMut([f64; 2])>(&self, arc: Arc<C>, search: &mut Search<C, F>) {
        let mut stack = List::<Arc<C>, MAX_DEPTH>::new();
        let mut current = Some(arc);
        while let Some(mut arc) = current {
            let left = halve(&mut arc.b, 2 * D);
            let [d0, d1] = arc.ends;
            let middle = [0.5 * (d0[0] + d1[0]), 0.5 * (d0[1] + d1[1])];
            let depth = arc.depth + 1;
            let right = Arc { b: arc.b, ends: [middle, d1], depth };
            let left = Arc { b: left, ends: [d0, middle], depth };
            current = match (self.settle(&left, search), self.settle(&right, search)) {
                (true, true) => stack.pop(),
                (true, false) => Some(right),
                (false, true) => Some(left),
                (false, false) => {
                    // Never full: one arc waits at each depth.
                    stack.push(right);
                    Some(left)
                }
            };
        }
    }

    /// Notes the roots in an arc, if they can be told; answers `false` if it must be halved.
    #[inline]
    fn settle<const C: usize, F: FnMut([f64; 2])>(&self, arc: &Arc<C>, search: &mut Search<C, F>) -> bool {
        let (n, b) = (2 * D, &arc.b);
        match verdict(b, n, search.touch) {
            Verdict::Empty => return true,
            Verdict::One => {
                search.bracket(arc, 0.0, 1.0, crossing(b, n), b[0] < 0.0);
                return true;
            }
            Verdict::Unclear => {}
        }
        if self.by_extremum(arc, search) {
            return true;
        }
        let small = b.iter().take(n + 1).all(|b| b.abs() <= search.nothing);
        if small || arc.depth >= MAX_DEPTH {
            // A root of higher order, or as good as one.
            (search.touching)(point(&arc.ends, 0.5));
            if (b[0] < 0.0) != (b[n] < 0.0) {
                search.bracket(arc, 0.0, 1.0, 0.5, b[0] < 0.0);
            }
            return true;
        }
        false
    }

    /// Bernstein coefficients on all arcs.
    #[inline]
    fn on_arcs<const C: usize>(&self, arcs: &mut [[f64; C]; ARCS]) {
        // Fourier coefficients around the middle of the first arc; a quarter turn to the next middle exchanges them.
        let (mut cos, mut sin) = ([0.0; MAX_DEGREE], [0.0; MAX_DEGREE]);
        for k in 0..D {
            let (c, s) = Self::TABLES.turn[k];
            cos[k] = self.cos[k] * c + self.sin[k] * s;
            sin[k] = self.sin[k] * c - self.cos[k] * s;
        }
        for arc in arcs {
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
                arc[j] = even[j] + odd[j];
                arc[2 * D - j] = even[j] - odd[j];
            }
        }
    }

    /// Moves the starting points of all brackets onto their roots.
    fn refine(&self, brackets: &mut [Bracket]) {
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

    /// Handles an arc on which the polynomial bends one way only, so that there is one extremum at most; answers `false` if it doesn't.
    #[inline]
    fn by_extremum<const C: usize, F: FnMut([f64; 2])>(&self, arc: &Arc<C>, search: &mut Search<C, F>) -> bool {
        let (n, b) = (2 * D, &arc.b);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for j in 0..n - 1 {
            let bend = b[j] - 2.0 * b[j + 1] + b[j + 2];
            (least, most) = (least.min(bend), most.max(bend));
        }
        if least < 0.0 && most > 0.0 {
            return false;
        }
        let (first, last) = (b[1] - b[0], b[n] - b[n - 1]);
        let crosses = (b[0] < 0.0) != (b[n] < 0.0);
        if (first < 0.0) == (last < 0.0) {
            // Monotone.
            if crosses {
                search.bracket(arc, 0.0, 1.0, crossing(b, n), b[0] < 0.0);
                return true;
            }
            // The extremum of a touching polynomial may sit on the end itself, where rounding puts it on the wrong side.
            let flat = 1e-4 * (most - least).abs().max(least.abs());
            if b[0].abs() <= search.touch && first.abs() <= flat {
                (search.touching)(point(&arc.ends, 0.0));
            }
            if b[n].abs() <= search.touch && last.abs() <= flat {
                (search.touching)(point(&arc.ends, 1.0));
            }
            return true;
        }
        let x = extremum(b, n);
        let at = point(&arc.ends, x);
        let value = self.value_and_slope(at).0;
        if crosses {
            // One root, on the side where the signs differ.
            let left = (value < 0.0) != (b[0] < 0.0);
            let (low, high) = if left { (0.0, x) } else { (x, 1.0) };
            search.bracket(arc, low, high, 0.5 * (low + high), b[0] < 0.0);
            if value.abs() <= search.touch {
                (search.touching)(at);
            }
        } else if (value < 0.0) != (b[0] < 0.0) && value.abs() > search.noise {
            // Two roots. Start where the parabola through extremum and ends crosses zero.
            let reach = |end: f64| sqrt((value / (value - end)).clamp(0.0, 1.0));
            search.bracket(arc, 0.0, x, x - x * reach(b[0]), b[0] < 0.0);
            search.bracket(arc, x, 1.0, x + (1.0 - x) * reach(b[n]), value < 0.0);
        } else if value.abs() <= search.touch {
            (search.touching)(at);
        }
        true
    }
}

/// The half-angle vector at parameter `x` of an arc.
#[inline]
fn between([d0, d1]: &[[f64; 2]; 2], x: f64) -> [f64; 2] {
    [d0[0] + x * (d1[0] - d0[0]), d0[1] + x * (d1[1] - d0[1])]
}

/// The square as a complex number: from the half-angle vector to the angle's, with the square of its length.
#[inline]
fn square(d: [f64; 2]) -> [f64; 2] {
    [d[0] * d[0] - d[1] * d[1], 2.0 * d[0] * d[1]]
}

/// The angle at parameter `x` of an arc, as `[cos, sin]`.
#[inline]
fn point(ends: &[[f64; 2]; 2], x: f64) -> [f64; 2] {
    let d = between(ends, x);
    let inverse = 1.0 / (d[0] * d[0] + d[1] * d[1]);
    square(d).map(|x| x * inverse)
}

/// Counts the changes of sign; coefficients within `touch` of zero may have either sign and are counted both ways.
#[inline]
fn verdict<const C: usize>(b: &[f64; C], n: usize, touch: f64) -> Verdict {
    let (mut least, mut most) = (b[0], b[0]);
    let mut changes = 0;
    let mut negative = b[0] < 0.0;
    let mut sure = b[0].abs() > touch;
    for &x in b.iter().take(n + 1).skip(1) {
        (least, most) = (least.min(x), most.max(x));
        if (x < 0.0) != negative {
            changes += 1;
            negative = !negative;
        }
        sure &= x.abs() > touch;
    }
    if least > touch || most < -touch {
        return Verdict::Empty;
    }
    if changes == 1 && sure {
        return Verdict::One;
    }
    if sure {
        return Verdict::Unclear;
    }
    // Worst case: an uncertain coefficient opposes its predecessor.
    let (mut worst, mut sign) = (0, 0.0f64);
    for &x in b.iter().take(n + 1) {
        let s = if x.abs() <= touch { if sign == 0.0 { 0.0 } else { -sign } } else { 1f64.copysign(x) };
        if s * sign < 0.0 {
            worst += 1;
        }
        sign = s;
    }
    if worst == 1 && (b[0] < 0.0) != (b[n] < 0.0) && b[0].abs() > touch { Verdict::One } else { Verdict::Unclear }
}

/// Where the control polygon of an arc with one change of sign crosses zero.
#[inline]
fn crossing<const C: usize>(b: &[f64; C], n: usize) -> f64 {
    let negative = b[0] < 0.0;
    for j in 0..n {
        if (b[j + 1] < 0.0) != negative {
            let x = (j as f64 + b[j] / (b[j] - b[j + 1])) / n as f64;
            return if x > 0.0 && x < 1.0 { x } else { 0.5 };
        }
    }
    0.5
}

/// The parameter of the only extremum of the Bernstein polynomial `b`: the root of its derivative, which is monotone.
fn extremum<const C: usize>(b: &[f64; C], n: usize) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let (first, last) = (b[1] - b[0], b[n] - b[n - 1]);
    let falls = first < 0.0;
    let mut x = first / (first - last);
    for _ in 0..60 {
        // De Casteljau down to three points: first and second derivative, up to factors n and n (n - 1).
        let mut w = *b;
        for r in 1..n - 1 {
            for j in 0..=n - r {
                w[j] += x * (w[j + 1] - w[j]);
            }
        }
        let (d0, d1) = (w[1] - w[0], w[2] - w[1]);
        let slope = d0 + x * (d1 - d0);
        if slope == 0.0 {
            return x;
        }
        if (slope < 0.0) == falls {
            low = x;
        } else {
            high = x;
        }
        let newton = x - slope / ((d1 - d0) * (n - 1) as f64);
        if (newton - x).abs() < 1e-9 {
            return newton.clamp(low, high);
        }
        x = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    x
}

/// Are two points of the unit circle one touching root?
fn near(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < SAME_TOUCH
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::testing::{Rng, random_trig_poly};
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
