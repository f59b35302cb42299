//! All real roots of the determinant, from its values.

use super::super::bernstein::{Nodes, sin_cos_series};
use super::super::elementary::sqrt;
use super::super::root_isolation::{Arc, Bracket, MAX_DEPTH, Search, point};
use super::super::{List, TrigPoly};

/// The same for an arc on which the polynomial seems to touch zero.
const LOW: f64 = 1e-2;
/// So often at most.
const AGAIN: usize = 4;
/// A function whose relative measure is smaller than this everywhere vanishes identically.
const SINGULAR: f64 = 1e-11;
/// Relative rounding error of a function above which its roots mean nothing.
const ALL_NOISE: f64 = 1e-4;
/// Softer limits of the same two quantities: low precision, but not lost.
const BLURRED: f64 = 1e-7;
const FAINT: f64 = 1e-9;
/// Slope (relative) of a root that is certainly a simple one.
const STEEP: f64 = 1e-3;
/// Smallest relative limit for roots that only touch.
const TOUCH: f64 = 1e-9;

/// A function of the hidden angle `[cos, sin]` that vanishes at solutions.
pub(super) trait Eliminant {
    /// A polynomial known to be smaller than this (relative) all over an arc has lost too many digits there, and is interpolated anew.
    const FLAT: f64;
    /// So often at most: a root of higher order is flat at every scale.
    const MOST: usize;

    /// Its value, and a relative measure of how far it is from vanishing everywhere (for a matrix, the smallest pivot).
    fn value(&self, at: [f64; 2]) -> (f64, f64);

    /// The same value with other rounding errors.
    fn again(&self, at: [f64; 2]) -> f64;
}

/// The angle between two half-angle vectors where a function changes its sign, by bisection and regula falsi (the Illinois
/// variant) in turn.
pub(super) fn crossing(function: &impl Eliminant, ends: &[[f64; 2]; 2]) -> [f64; 2] {
    let value = |x: f64| function.value(point(ends, x)).0;
    let (mut low, mut high) = ((0.0, value(0.0)), (1.0, value(1.0)));
    if (low.1 < 0.0) == (high.1 < 0.0) {
        return point(ends, 0.5);
    }
    for k in 0..40 {
        let secant = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
        let x = if k % 3 == 2 || !(secant > low.0 && secant < high.0) { 0.5 * (low.0 + high.0) } else { secant };
        let y = value(x);
        if (y < 0.0) == (low.1 < 0.0) {
            low = (x, y);
            high.1 *= 0.5;
        } else {
            high = (x, y);
            low.1 *= 0.5;
        }
        if high.0 - low.0 < 1e-13 || y == 0.0 {
            break;
        }
    }
    point(ends, 0.5 * (low.0 + high.0))
}

/// The determinant as a polynomial of degree `D` in the hidden angle, from values at `K > 2 D + 2` angles; `C = 2 D + 1`.
pub(super) struct Determinant<const D: usize, const C: usize, const K: usize> {
    polynomial: TrigPoly<D>,
    /// The rounding error of its coefficients, relative to the sum of their absolute values; or else the next higher harmonics.
    noise: f64,
    /// The largest, over all angles, of the smallest pivots: zero for a determinant that vanishes everywhere.
    regularity: f64,
}

/// Kinds of roots.
#[derive(Clone, Copy)]
pub(super) enum Root {
    /// The determinant changes its sign between two half-angle vectors, once.
    Crossing([[f64; 2]; 2]),
    /// It comes so near to zero that rounding hides whether there are two roots or none.
    Doubtful,
    /// It comes near to zero, but stays clear of it by more than rounding.
    NearMiss,
}

/// What finding the roots took.
pub(super) struct Effort {
    /// Determinants computed.
    pub(super) determinants: usize,
    /// Whether that was the most that is allowed; roots next to one of high order may then be missing.
    pub(super) exhausted: bool,
}

impl<const D: usize, const C: usize, const K: usize> Determinant<D, C, K> {
    const NODES: Nodes<C> = Nodes::new();

    /// Cosine and sine of the sample angles.
    const CIRCLE: [[f64; 2]; K] = {
        assert!(C == 2 * D + 1 && K > C + 2);
        let mut circle = [[0.0; 2]; K];
        let mut j = 0;
        while j < K {
            // Between -pi and pi, where the series is good.
            let turns = j as f64 / K as f64;
            let turns = if 2 * j > K { turns - 1.0 } else { turns };
            let (s, c) = sin_cos_series(2.0 * core::f64::consts::PI * turns);
            circle[j] = [c, s];
            j += 1;
        }
        circle
    };

    pub(super) fn new(function: &impl Eliminant) -> Self {
        let mut regularity = 0.0f64;
        let values = Self::CIRCLE.map(|at| {
            let (value, pivot) = function.value(at);
            regularity = regularity.max(pivot);
            value
        });
        let mut polynomial = TrigPoly::<D>::ZERO;
        let mut noise = 0.0f64;
        let scale = 2.0 / K as f64;
        for k in 0..=D + 1 {
            let (mut cos, mut sin) = (0.0, 0.0);
            for (j, value) in values.iter().enumerate() {
                let [c, s] = Self::CIRCLE[j * k % K];
                cos += value * c;
                sin += value * s;
            }
            if k == 0 {
                polynomial.constant = 0.5 * scale * cos;
            } else if k <= D {
                (polynomial.cos[k - 1], polynomial.sin[k - 1]) = (scale * cos, scale * sin);
            } else {
                noise = noise.max(scale * cos.abs().max(sin.abs()));
            }
        }
        let size = polynomial.size();
        Self { polynomial, noise: if size > 0.0 { noise / size } else { 1.0 }, regularity }
    }

    /// Calls `found` with every real root of the determinant, or what may be one.
    ///
    /// Where the polynomial is so small that its coefficients don't determine it (several roots lie close together), the
    /// determinant is evaluated again at points of that arc alone.
    pub(super) fn each_root<E: Eliminant>(&self, function: &E, mut found: impl FnMut([f64; 2], Root)) -> Effort {
        let touch = TOUCH.max(10.0 * self.noise);
        let size = self.polynomial.size();
        // Roots that the polynomial itself may refine, and roots of arcs that were computed anew.
        let (mut plain, mut fresh) = (Search::<C>::new(size, touch), Search::<C>::new(size, touch));
        let (mut count, mut again) = (0, 0);
        // Arcs, with the size and the error of their coefficients.
        let mut stack = List::<(Arc<C>, [f64; 2]), { MAX_DEPTH + 1 }>::new();
        for arc in self.polynomial.on_arcs() {
            stack.push((arc, [size, 0.0]));
            while let Some((mut arc, [mut scale, mut error])) = stack.pop() {
                let largest = |arc: &Arc<C>| arc.b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                if largest(&arc) < E::FLAT * scale && count < E::MOST {
                    count += 1;
                    error = Self::interpolate(function, &mut arc);
                    scale = largest(&arc);
                }
                let search = if scale == size { &mut plain } else { &mut fresh };
                search.rescale(scale, touch, error.max(10.0 * self.noise * scale));
                let known = (search.brackets.len(), search.touching.len());
                let settled = search.settle(&arc);
                if settled && search.touching.len() > known.1 && largest(&arc) < LOW * scale && again < AGAIN {
                    // What seems to touch may be several roots, told apart by better coefficients.
                    while search.brackets.len() > known.0 {
                        search.brackets.pop();
                    }
                    search.touching.pop();
                    again += 1;
                    error = Self::interpolate(function, &mut arc);
                    stack.push((arc, [largest(&arc), error]));
                } else if !settled {
                    let [left, right] = search.halves(&arc);
                    stack.push((right, [scale, error]));
                    stack.push((left, [scale, error]));
                }
            }
        }
        self.polynomial.refine(plain.brackets.as_mut_slice());
        for search in [&plain, &fresh] {
            for &Bracket { at, ends, .. } in &search.brackets {
                found(at, Root::Crossing(ends));
            }
            for &(at, doubtful) in &search.touching {
                found(at, if doubtful { Root::Doubtful } else { Root::NearMiss });
            }
        }
        Effort { determinants: (count + again) * C, exhausted: count == E::MOST }
    }

    /// Whether the function neither vanishes everywhere nor drowns in rounding errors.
    pub(super) fn means_something(&self) -> bool {
        self.noise < ALL_NOISE && self.regularity > SINGULAR
    }

    /// Whether the function has lost so many digits that another elimination is needed.
    pub(super) fn is_blurred(&self) -> bool {
        !(self.noise < BLURRED && self.regularity > FAINT)
    }

    /// Whether the polynomial is so flat at a root that it may be a multiple one, or next to others.
    pub(super) fn is_flat(&self, at: [f64; 2]) -> bool {
        self.polynomial.value_and_slope(at).1.abs() < STEEP * self.polynomial.size()
    }

    /// The multiplicity of a root, from values as near to it as rounding allows: others may be next to it.
    pub(super) fn order(&self, function: &impl Eliminant, [c, s]: [f64; 2]) -> usize {
        let value = |by: f64| function.value([c - by * s, s + by * c]).0.abs();
        let visible = 10.0 * (self.noise + 1e-16) * self.polynomial.size();
        let mut ratio = 0.0;
        for by in [1e-6, 4e-5, 2e-3] {
            let near = value(by) + value(-by);
            ratio = (value(2.0 * by) + value(-2.0 * by)) / near;
            if near > visible {
                break;
            }
        }
        // Twice as far away a root of order n is 2^n times as large.
        (1..D).find(|n| ratio < 1.41 * (1u64 << n) as f64).unwrap_or(D)
    }

    /// Computes the coefficients on an arc from the determinant itself, and estimates their error.
    fn interpolate(function: &impl Eliminant, arc: &mut Arc<C>) -> f64 {
        let [d0, d1] = arc.ends;
        let mut error = 0.0f64;
        let mut values = [0.0; C];
        for (k, (value, x)) in values.iter_mut().zip(&Self::NODES.at).enumerate() {
            let d = [d0[0] + x * (d1[0] - d0[0]), d0[1] + x * (d1[1] - d0[1])];
            let square = d[0] * d[0] + d[1] * d[1];
            let at = [(d[0] * d[0] - d[1] * d[1]) / square, 2.0 * d[0] * d[1] / square];
            *value = function.value(at).0;
            if k % 4 == 0 {
                // Rounding differs with the order of elimination.
                error = error.max((*value - function.again(at)).abs());
            }
            // |d|^n, with n = 2 D
            for _ in 0..D {
                *value *= square;
            }
        }
        let mut amplification = 0.0f64;
        for (b, row) in arc.b.iter_mut().zip(&Self::NODES.inverse) {
            *b = row.iter().zip(&values).map(|(a, b)| a * b).sum();
            amplification = amplification.max(row.iter().map(|a| a * a).sum());
        }
        // Three standard deviations.
        3.0 * error * sqrt(amplification)
    }
}
