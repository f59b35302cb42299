//! All real roots of the determinant, from its values.

use super::super::arcs::{Arc, Bracket, MAX_DEPTH, Search};
use super::super::bernstein::{Nodes, sin_cos_series};
use super::super::math::sqrt;
use super::super::{List, TrigPoly};
use super::dialytic::Dialytic;

/// A polynomial known to be smaller than this (relative) all over an arc has lost too many digits there, and is interpolated anew.
const FLAT: f64 = 1e-6;
/// So often at most: a root of higher order is flat at every scale.
const MAX_NODES: usize = 8;
/// Smallest relative limit for roots that only touch.
const TOUCH: f64 = 1e-9;

/// The determinant as a polynomial of degree `D` in the hidden angle, from values at `K > 2 D + 2` angles; `C = 2 D + 1`.
pub(super) struct Determinant<const D: usize, const C: usize, const K: usize> {
    polynomial: TrigPoly<D>,
    /// The rounding error of its coefficients, relative to the sum of their absolute values; or else the next higher harmonics.
    pub(super) noise: f64,
    /// The largest, over all angles, of the smallest pivots: zero for a determinant that vanishes everywhere.
    pub(super) regularity: f64,
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
    /// Was that the most that is allowed? Then roots next to one of high order may be missing.
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

    pub(super) fn new(dialytic: &Dialytic) -> Self {
        let mut regularity = 0.0f64;
        let values = Self::CIRCLE.map(|at| {
            let (value, pivot) = dialytic.determinant(at);
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
    pub(super) fn each_root(&self, dialytic: &Dialytic, mut found: impl FnMut([f64; 2], Root)) -> Effort {
        let touch = TOUCH.max(10.0 * self.noise);
        let size = self.polynomial.size();
        // Roots that the polynomial itself may refine, and roots of arcs that were computed anew.
        let (mut plain, mut fresh) = (Search::<C>::new(size, touch), Search::<C>::new(size, touch));
        let mut count = 0;
        // Arcs, with the size and the error of their coefficients.
        let mut stack = List::<(Arc<C>, [f64; 2]), { MAX_DEPTH + 1 }>::new();
        for arc in self.polynomial.on_arcs() {
            stack.push((arc, [size, 0.0]));
            while let Some((mut arc, [mut scale, mut error])) = stack.pop() {
                let largest = |arc: &Arc<C>| arc.b.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                if largest(&arc) < FLAT * scale && count < MAX_NODES {
                    count += 1;
                    error = Self::interpolate(dialytic, &mut arc);
                    scale = largest(&arc);
                }
                let search = if scale == size { &mut plain } else { &mut fresh };
                search.rescale(scale, touch, error.max(10.0 * self.noise * scale));
                if !search.settle(&arc) {
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
        Effort { determinants: count * C, exhausted: count == MAX_NODES }
    }

    /// Computes the coefficients on an arc from the determinant itself, and estimates their error.
    fn interpolate(dialytic: &Dialytic, arc: &mut Arc<C>) -> f64 {
        let [d0, d1] = arc.ends;
        let mut error = 0.0f64;
        let mut values = [0.0; C];
        for (k, (value, x)) in values.iter_mut().zip(&Self::NODES.at).enumerate() {
            let d = [d0[0] + x * (d1[0] - d0[0]), d0[1] + x * (d1[1] - d0[1])];
            let square = d[0] * d[0] + d[1] * d[1];
            let at = [(d[0] * d[0] - d[1] * d[1]) / square, 2.0 * d[0] * d[1] / square];
            *value = dialytic.determinant(at).0;
            if k % 4 == 0 {
                // Rounding differs with the order of elimination.
                error = error.max((*value - dialytic.determinant_again(at)).abs());
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
