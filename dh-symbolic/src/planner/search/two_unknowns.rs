//! Steps with two unknowns: two equations, each linear in the sines and cosines of both angles, or with a length in place of one angle.

use std::rc::Rc;

use super::super::known::{Basis, Collected};
use super::super::scalar::Equation;
use super::super::steps::{Offer, Row, StepKind, TwoUnknowns};
use super::super::subspace::{JointCombination, numbers};
use super::{Search, best};
use crate::algebra::Poly;

impl Search<'_> {
    pub(super) fn two_unknowns(&mut self, virtual_too: bool) -> bool {
        let mut found: Option<Offer> = None;
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
                if let Some(offer) = self.pair_offer(pair, &polys) {
                    found = best(found, offer);
                }
            }
        }
        self.take(found)
    }

    /// Independent unknowns: a slide before an angle, two of a kind in either order once. Where real coordinates were tried before, one of
    /// them at least is virtual.
    fn pairs(&self, forms: &[JointCombination], virtual_too: bool) -> Vec<[JointCombination; 2]> {
        let is_angle = |f: &JointCombination| f.iter().position(|k| *k != 0).is_some_and(|i| self.axes.is_revolute(i));
        let mut pairs = Vec::new();
        for (i, first) in forms.iter().enumerate() {
            for (j, second) in forms.iter().enumerate() {
                let ordered = if is_angle(first) == is_angle(second) { i < j } else { !is_angle(first) };
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

    fn pair_offer(&self, pair: &[JointCombination; 2], polys: &[(Equation, Rc<Poly>)]) -> Option<Offer> {
        let fits = |c: &Collected| {
            c.keys().all(|k| {
                matches!(k[0], Basis::One | Basis::Cos(1) | Basis::Sin(1) | Basis::Power(1 | 2))
                    && matches!(k[1], Basis::One | Basis::Cos(1) | Basis::Sin(1))
            })
        };
        let rows: Vec<Row> = polys
            .iter()
            .filter_map(|(equation, p)| {
                let collected = self.knowledge.collect(&self.axes, p, pair).filter(|c| fits(c))?;
                Some(Row { equation: *equation, collected })
            })
            .collect();
        if rows.len() < 2 {
            return None;
        }
        let scene = self.scene();
        let samples = scene.samples(2, 0);
        let slopes: Vec<Vec<[f64; 2]>> =
            rows.iter().map(|r| samples.iter().map(|s| r.gradient([&pair[0], &pair[1]], s)).collect()).collect();
        let sizes: Vec<usize> = rows.iter().map(|r| scene.size(r)).collect();
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
        let (_, i, j) = best?;
        let prismatic = pair[0].iter().position(|k| *k != 0).is_some_and(|i| !self.axes.is_revolute(i));
        let at = TwoUnknowns { scene, pair, prismatic, rows: [&rows[i], &rows[j]] };
        StepKind::ALL.iter().find_map(|kind| kind.for_two_unknowns(&at))
    }
}
