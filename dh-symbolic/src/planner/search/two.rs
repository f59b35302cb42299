//! Steps with two unknowns: two equations, each linear in the sines and cosines of both, or with a length in the place of one.

use std::rc::Rc;

use super::super::known::{Collected, Part};
use super::super::sample::Sample;
use super::super::scalar::Equation;
use super::super::span::{Form, numbers};
use super::super::step::{Step, StepKind};
use super::{Ranked, Search};
use crate::algebra::Poly;

impl Search<'_> {
    pub(super) fn two_unknowns(&mut self, virtual_too: bool) -> bool {
        let mut best: Option<Ranked> = None;
        for (rest, families) in self.open_groups(2) {
            let pairs = self.pairs(&self.unknowns(&rest, &families), virtual_too);
            if pairs.is_empty() {
                continue;
            }
            let equations = self.equations(&families);
            if equations.len() < 2 {
                continue;
            }
            let polys: Vec<(Equation, Rc<Poly>)> = equations.into_iter().map(|e| (e, self.write(&e))).collect();
            for pair in &pairs {
                if let Some(option) = self.pair_option(pair, &polys)
                    && best.as_ref().is_none_or(|b| option.rank < b.rank)
                {
                    best = Some(option);
                }
            }
        }
        self.take(best)
    }

    /// Independent unknowns: a slide before an angle, two of a kind in either order once. Where real coordinates were tried before, one of
    /// them at least is virtual.
    fn pairs(&self, forms: &[Form], virtual_too: bool) -> Vec<[Form; 2]> {
        let turns = |f: &Form| f.iter().position(|k| *k != 0).is_some_and(|i| self.axes.turns(i));
        let mut pairs = Vec::new();
        for (i, first) in forms.iter().enumerate() {
            for (j, second) in forms.iter().enumerate() {
                let ordered = if turns(first) == turns(second) { i < j } else { !turns(first) };
                if !ordered || virtual_too != (self.is_virtual(first) || self.is_virtual(second)) {
                    continue;
                }
                let mut both = self.knowledge.span.clone();
                if both.add(&numbers(first)) && both.add(&numbers(second)) {
                    pairs.push([first.clone(), second.clone()]);
                }
            }
        }
        pairs
    }

    fn pair_option(&self, pair: &[Form; 2], polys: &[(Equation, Rc<Poly>)]) -> Option<Ranked> {
        let fits = |c: &Collected| {
            c.keys().all(|k| {
                matches!(k[0], Part::One | Part::Cos(1) | Part::Sin(1) | Part::Power(1 | 2))
                    && matches!(k[1], Part::One | Part::Cos(1) | Part::Sin(1))
            })
        };
        let rows: Vec<(Equation, Collected)> = polys
            .iter()
            .filter_map(|(e, p)| self.knowledge.collect(&self.axes, p, pair).filter(|c| fits(c)).map(|c| (*e, c)))
            .collect();
        if rows.len() < 2 {
            return None;
        }
        let slide = pair[0].iter().position(|k| *k != 0).is_some_and(|i| !self.axes.turns(i));
        let samples = self.samples(2, 0);
        let slopes: Vec<Vec<[f64; 2]>> =
            rows.iter().map(|r| samples.iter().map(|s| gradient(&r.1, pair, s)).collect()).collect();
        let sizes: Vec<usize> = rows.iter().map(|r| self.size(r)).collect();
        let mut best: Option<(usize, usize, usize)> = None;
        for i in 0..rows.len() {
            for j in i + 1..rows.len() {
                let mut both = slopes[i].iter().zip(&slopes[j]);
                let independent = both.all(|(a, b)| (a[0] * b[1] - a[1] * b[0]).abs() > 1e-5);
                let total = sizes[i] + sizes[j];
                if independent && best.is_none_or(|b| total < b.0) {
                    best = Some((total, i, j));
                }
            }
        }
        let (total, i, j) = best?;
        let (kind, roots) = if slide {
            (StepKind::SlideAndTurn, 8)
        } else {
            (StepKind::Bilinear, self.bilinear_roots(&rows[i].1, &rows[j].1))
        };
        Some(Ranked {
            rank: (7 + roots, total, 0),
            step: Step {
                kind,
                unknown: pair.to_vec(),
                equations: vec![rows[i].0, rows[j].0],
                collected: vec![rows[i].1.clone(), rows[j].1.clone()],
                roots,
                before: self.knowledge.known.len(),
            },
        })
    }

    /// Bound of the solutions of a bilinear pair: 8; 4 where both coefficient pairs of one angle are turned into each other by a
    /// quarter turn (then its elimination is a square sum with a common factor, Pieper's quartic), or where one equation lacks an
    /// angle's products.
    fn bilinear_roots(&self, a: &Collected, b: &Collected) -> usize {
        let get = |c: &Collected, u: Part, v: Part| c.get(&vec![u, v]).cloned().unwrap_or_default();
        let parts = [Part::One, Part::Cos(1), Part::Sin(1)];
        for swap in [false, true] {
            let at = |c: &Collected, u: Part, v: Part| if swap { get(c, v, u) } else { get(c, u, v) };
            let row = |c: &Collected, u: Part| parts.map(|v| at(c, u, v));
            let (ca, sa, cb, sb) =
                (row(a, Part::Cos(1)), row(a, Part::Sin(1)), row(b, Part::Cos(1)), row(b, Part::Sin(1)));
            // cb = k sa, sb = -k ca: all cross products vanish.
            let proportional = (0..3).all(|i| (0..3).all(|j| &cb[i] * &ca[j] == -&(&sb[j] * &sa[i])));
            if proportional {
                return 4;
            }
            let plain = |c: &Collected| parts[1..].iter().all(|u| parts[1..].iter().all(|v| at(c, *u, *v).is_zero()));
            if plain(a) && plain(b) {
                return 4;
            }
        }
        8
    }
}

/// Slopes of an equation by the two unknowns at a sample.
pub(super) fn gradient(c: &Collected, pair: &[Form; 2], s: &Sample<'_>) -> [f64; 2] {
    let angle = |f: &Form| f.iter().zip(&s.x).map(|(k, x)| f64::from(*k) * x).sum::<f64>();
    let (u, v) = (angle(&pair[0]), angle(&pair[1]));
    let part = |p: Part, x: f64| match p {
        Part::One => (1.0, 0.0),
        Part::Cos(n) => ((f64::from(n) * x).cos(), -f64::from(n) * (f64::from(n) * x).sin()),
        Part::Sin(n) => ((f64::from(n) * x).sin(), f64::from(n) * (f64::from(n) * x).cos()),
        Part::Power(n) => (x.powi(i32::from(n)), f64::from(n) * x.powi(i32::from(n) - 1)),
    };
    let mut g = [0.0; 2];
    for (key, p) in c {
        let k = s.evaluate(p);
        let (a, b) = (part(key[0], u), part(key[1], v));
        g[0] += k * a.1 * b.0;
        g[1] += k * a.0 * b.1;
    }
    g
}
