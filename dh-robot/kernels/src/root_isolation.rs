//! Isolation of real roots on arcs, by halving in Bernstein form: needs the coefficients of `bernstein.rs` and nothing else.

use super::bernstein::halve;
use super::elementary::sqrt;
use super::list::{Blank, List};

/// Arcs are not halved more often than this: a quarter turn over 2^24 is a ten-millionth of a radian.
pub(super) const MAX_DEPTH: usize = 24;

/// An arc on which roots are still to be looked for.
#[derive(Clone, Copy)]
pub(super) struct Arc<const C: usize> {
    /// Bernstein coefficients, of degree `C - 1`.
    pub(super) b: [f64; C],
    /// Its ends as half-angle vectors (not of unit length).
    pub(super) ends: [[f64; 2]; 2],
    /// How often it was halved.
    pub(super) depth: usize,
}

impl<const C: usize> Blank for Arc<C> {
    const BLANK: Self = Self { b: [0.0; C], ends: [[0.0; 2]; 2], depth: 0 };
}

/// An arc with exactly one root.
#[derive(Clone, Copy)]
pub(super) struct Bracket {
    /// Its ends as half-angle vectors.
    pub(super) ends: [[f64; 2]; 2],
    /// Whether it is first negative, then positive.
    pub(super) rising: bool,
    /// The approximate root as `[cos, sin]`.
    pub(super) at: [f64; 2],
    /// Sine of the last step that led there.
    pub(super) last: f64,
}

impl Blank for Bracket {
    const BLANK: Self = Self { ends: [[0.0; 2]; 2], rising: false, at: [0.0; 2], last: 0.0 };
}

/// What a search knows and has found.
pub(super) struct Search<const C: usize> {
    /// An extremum that misses zero by less is a double root.
    pub(super) touch: f64,
    /// An extremum beyond zero by less isn't beyond zero.
    pub(super) noise: f64,
    /// An extremum that misses zero by more certainly isn't a root, only near one.
    pub(super) doubt: f64,
    /// An arc whose coefficients are all smaller is a root of higher order.
    pub(super) nothing: f64,
    /// Arcs with one root. More than the degree of them would be an artefact of rounding.
    pub(super) brackets: List<Bracket, C>,
    /// Roots that only touch, each once; `true` where rounding may hide two roots or none, `false` for near misses.
    pub(super) touching: List<([f64; 2], bool), C>,
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

impl<const C: usize> Search<C> {
    /// A search among coefficients of this size, with a relative limit for touching.
    pub(super) fn new(scale: f64, touch: f64) -> Self {
        let mut search =
            Self { touch: 0.0, noise: 0.0, doubt: 0.0, nothing: 0.0, brackets: List::new(), touching: List::new() };
        search.rescale(scale, touch, 0.0);
        search
    }

    /// Changes the size that tolerances refer to, and the error (absolute) of coefficients.
    pub(super) fn rescale(&mut self, scale: f64, touch: f64, error: f64) {
        self.touch = error.max(touch * scale);
        self.noise = 1e-15 * scale;
        self.doubt = error.max(1e-14 * scale);
        self.nothing = error.max(1e-14 * scale);
    }

    /// Finds the roots in an arc, by halving it as often as needed.
    #[inline]
    pub(super) fn arc(&mut self, arc: &Arc<C>) {
        if !self.settle(arc) {
            self.halve_until_settled(*arc);
        }
    }

    #[inline(never)] // Keeps the stack of arcs away from the many polynomials that don't need it.
    fn halve_until_settled(&mut self, arc: Arc<C>) {
        let mut stack = List::<Arc<C>, MAX_DEPTH>::new();
        let mut current = Some(arc);
        while let Some(arc) = current {
            let [left, right] = self.halves(&arc);
            current = match (self.settle(&left), self.settle(&right)) {
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

    /// Both halves of an arc.
    #[inline]
    pub(super) fn halves(&self, arc: &Arc<C>) -> [Arc<C>; 2] {
        let mut b = arc.b;
        let left = halve(&mut b);
        let [d0, d1] = arc.ends;
        let middle = [0.5 * (d0[0] + d1[0]), 0.5 * (d0[1] + d1[1])];
        let depth = arc.depth + 1;
        [Arc { b: left, ends: [d0, middle], depth }, Arc { b, ends: [middle, d1], depth }]
    }

    /// Records the roots in an arc if they can be isolated; returns `false` if the arc must be halved.
    #[inline]
    pub(super) fn settle(&mut self, arc: &Arc<C>) -> bool {
        let (n, b) = (C - 1, &arc.b);
        match verdict(b, self.touch) {
            Verdict::Empty => return true,
            Verdict::One => {
                self.bracket(arc, 0.0, 1.0, crossing(b), b[0] < 0.0);
                return true;
            }
            Verdict::Unclear => {}
        }
        if self.by_extremum(arc) {
            return true;
        }
        let small = b.iter().all(|b| b.abs() <= self.nothing);
        if small || arc.depth >= MAX_DEPTH {
            // A root of higher order, or as good as one.
            self.touches(point(&arc.ends, 0.5), 0.0);
            if (b[0] < 0.0) != (b[n] < 0.0) {
                self.bracket(arc, 0.0, 1.0, 0.5, b[0] < 0.0);
            }
            return true;
        }
        false
    }

    /// Handles an arc on which the polynomial bends one way only, so that there is one extremum at most; answers `false` if it doesn't.
    #[inline]
    fn by_extremum(&mut self, arc: &Arc<C>) -> bool {
        let (n, b) = (C - 1, &arc.b);
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
                self.bracket(arc, 0.0, 1.0, crossing(b), b[0] < 0.0);
                return true;
            }
            // The extremum of a touching polynomial may sit on the end itself, where rounding puts it on the wrong side.
            let flat = 1e-4 * (most - least).abs().max(least.abs());
            if b[0].abs() <= self.touch && first.abs() <= flat {
                self.touches(point(&arc.ends, 0.0), b[0]);
            }
            if b[n].abs() <= self.touch && last.abs() <= flat {
                self.touches(point(&arc.ends, 1.0), b[n]);
            }
            return true;
        }
        let (x, value) = extremum(b);
        if crosses {
            // One root, on the side where the signs differ.
            let left = (value < 0.0) != (b[0] < 0.0);
            let (low, high) = if left { (0.0, x) } else { (x, 1.0) };
            self.bracket(arc, low, high, 0.5 * (low + high), b[0] < 0.0);
            if value.abs() <= self.touch {
                self.touches(point(&arc.ends, x), value);
            }
        } else if (value < 0.0) != (b[0] < 0.0) && value.abs() > self.noise {
            // Two roots. Start where the parabola through extremum and ends crosses zero.
            let reach = |end: f64| sqrt((value / (value - end)).clamp(0.0, 1.0));
            self.bracket(arc, 0.0, x, x - x * reach(b[0]), b[0] < 0.0);
            self.bracket(arc, x, 1.0, x + (1.0 - x) * reach(b[n]), value < 0.0);
        } else if value.abs() <= self.touch {
            self.touches(point(&arc.ends, x), value);
        }
        true
    }

    /// Notes that the arc has exactly one root between the parameters `low` and `high`, probably near `x`.
    #[inline]
    fn bracket(&mut self, arc: &Arc<C>, low: f64, high: f64, x: f64, rising: bool) {
        let ends = [between(&arc.ends, low), between(&arc.ends, high)];
        self.brackets.push(Bracket { ends, rising, at: point(&arc.ends, x), last: 0.0 });
    }

    /// Notes a root that touches within `value`, unless it was seen from another arc.
    pub(super) fn touches(&mut self, at: [f64; 2], value: f64) {
        /// Two touching roots nearer than this are one.
        const SAME: f64 = 1e-6;
        let doubtful = value.abs() <= self.doubt;
        for (t, known) in self.touching.as_mut_slice() {
            if (t[0] - at[0]).abs() + (t[1] - at[1]).abs() < SAME {
                *known |= doubtful;
                return;
            }
        }
        self.touching.push((at, doubtful));
    }
}

/// The half-angle vector at parameter `x` of an arc.
#[inline]
pub(super) fn between([d0, d1]: &[[f64; 2]; 2], x: f64) -> [f64; 2] {
    [d0[0] + x * (d1[0] - d0[0]), d0[1] + x * (d1[1] - d0[1])]
}

/// The square as a complex number: from the half-angle vector to the angle's, with the square of its length.
#[inline]
pub(super) fn square(d: [f64; 2]) -> [f64; 2] {
    [d[0] * d[0] - d[1] * d[1], 2.0 * d[0] * d[1]]
}

/// The angle at parameter `x` of an arc, as `[cos, sin]`.
#[inline]
pub(super) fn point(ends: &[[f64; 2]; 2], x: f64) -> [f64; 2] {
    let d = between(ends, x);
    let inverse = 1.0 / (d[0] * d[0] + d[1] * d[1]);
    square(d).map(|x| x * inverse)
}

/// Counts the changes of sign; coefficients within `touch` of zero may have either sign and are counted both ways.
#[inline]
fn verdict<const C: usize>(b: &[f64; C], touch: f64) -> Verdict {
    let n = C - 1;
    let (mut least, mut most) = (b[0], b[0]);
    let mut changes = 0;
    let mut negative = b[0] < 0.0;
    let mut sure = b[0].abs() > touch;
    for &x in b.iter().skip(1) {
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
    for &x in b.iter() {
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
fn crossing<const C: usize>(b: &[f64; C]) -> f64 {
    let n = C - 1;
    let negative = b[0] < 0.0;
    for j in 0..n {
        if (b[j + 1] < 0.0) != negative {
            let x = (j as f64 + b[j] / (b[j] - b[j + 1])) / n as f64;
            return if x > 0.0 && x < 1.0 { x } else { 0.5 };
        }
    }
    0.5
}

/// The parameter and the value of the only extremum of the Bernstein polynomial `b`: the root of its derivative, which is monotone.
fn extremum<const C: usize>(b: &[f64; C]) -> (f64, f64) {
    let n = C - 1;
    let (mut low, mut high) = (0.0, 1.0);
    let (first, last) = (b[1] - b[0], b[n] - b[n - 1]);
    let falls = first < 0.0;
    let mut x = first / (first - last);
    let mut value = b[0];
    for _ in 0..60 {
        // De Casteljau down to three points: value, first and second derivative, the latter up to factors n and n (n - 1).
        let mut w = *b;
        for r in 1..n - 1 {
            for j in 0..=n - r {
                w[j] += x * (w[j + 1] - w[j]);
            }
        }
        let (d0, d1) = (w[1] - w[0], w[2] - w[1]);
        let slope = d0 + x * (d1 - d0);
        value = w[0] + x * (d0 + slope);
        if slope == 0.0 {
            break;
        }
        if (slope < 0.0) == falls {
            low = x;
        } else {
            high = x;
        }
        let newton = x - slope / ((d1 - d0) * (n - 1) as f64);
        // The value's error is the square of the parameter's.
        if (newton - x).abs() < 1e-9 {
            break;
        }
        x = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
    }
    (x, value)
}
