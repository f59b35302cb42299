//! Numbers for everything a plan knows, at a joint vector that solves it: for choosing well-conditioned equations and for checks.

use super::axes::{Axes, generic_parameter};
use super::known::Knowledge;
use crate::algebra::{AngleVar, Point, Poly, Symbol};
use crate::chain::{Chain, Coordinate, Handle};
use dh_kernels::pose;

/// Values at one joint vector; lengths over the length scale.
pub(super) struct Sample<'a> {
    chain: &'a Chain,
    axes: &'a Axes,
    /// Joint coordinates.
    pub(super) x: Vec<f64>,
    values: Vec<(Symbol, f64)>,
}

impl<'a> Sample<'a> {
    /// Values of all known symbols at `x`.
    pub(super) fn new(chain: &'a Chain, axes: &'a Axes, knowledge: &Knowledge, x: Vec<f64>) -> Sample<'a> {
        let mut values = Vec::new();
        let frames = axes.frames_number(&x);
        for k in &knowledge.poses {
            // M(left, right): what the known pose equals at a solution.
            let t = pose::compose(&pose::inverse(&frames[k.left]), &frames[k.right]);
            for i in 0..3 {
                for j in 0..3 {
                    values.push((k.r[i][j], t[i][j]));
                }
                values.push((k.p[i], t[i][3]));
                values.push((k.back[i], -(0..3).map(|m| t[m][i] * t[m][3]).sum::<f64>()));
            }
            values.push((k.square, (0..3).map(|m| t[m][3] * t[m][3]).sum()));
        }
        for known in &knowledge.known {
            let [c, s] = known.value(&x);
            values.push((known.symbols[0], c));
            values.push((known.symbols[1], s));
        }
        Sample { chain, axes, x, values }
    }

    /// The value of a formula.
    pub(super) fn evaluate(&self, p: &Poly) -> f64 {
        let symbol = |s: Symbol| {
            if let Some((_, v)) = self.values.iter().find(|v| v.0 == s) {
                return *v;
            }
            if let Some(i) = self.axes.coordinates.iter().position(|c| *c == Coordinate::Length(s)) {
                return self.x[i];
            }
            generic_parameter(self.chain, Handle::Length(s)) / self.axes.length_scale
        };
        let angle = |v: AngleVar| match self.axes.index_of_angle(v) {
            Some(i) => self.x[i],
            None => generic_parameter(self.chain, Handle::Angle(v)),
        };
        p.evaluate(&Point { symbol: &symbol, angle: &angle })
    }
}

/// Joint vectors at which plans are judged: generic ones first, then special ones (all joints at multiples of a quarter turn).
pub(crate) fn joint_vectors(axes: &Axes, generic: usize, special: usize) -> Vec<Vec<f64>> {
    let mut random = super::random::Random::new(11);
    let n = axes.count();
    let mut all: Vec<Vec<f64>> = (0..generic).map(|_| (0..n).map(|_| 2.7 * random.next()).collect()).collect();
    for _ in 0..special {
        let quarter = |r: f64| (r * 2.0).round() * std::f64::consts::FRAC_PI_2;
        all.push((0..n).map(|k| if axes.is_revolute(k) { quarter(random.next()) } else { random.next() }).collect());
    }
    all
}
