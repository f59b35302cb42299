//! What is left when no equation has one or two unknowns: the general elimination, and coordinates that are free everywhere.

use super::super::axes::Axes;
use super::super::known::Knowledge;
use super::super::pool::rates;
use super::super::sample::joint_vectors;
use super::super::span::{Form, Span};
use super::super::step::{Step, StepKind};
use super::{Ranked, Search};

impl Search<'_> {
    /// The general elimination takes what is open at once: up to six coordinates, of which one may slide, or two that are neighbours in
    /// the loop. Fewer than six are filled up with joints that have to come out as zero.
    pub(super) fn general(&mut self) -> bool {
        let open: Vec<usize> = (0..self.axes.count()).filter(|k| !self.knowledge.has(&self.axes, *k)).collect();
        let slides: Vec<usize> = (0..open.len()).filter(|i| !self.axes.turns(open[*i])).collect();
        let fits = match slides.as_slice() {
            [] | [_] => true,
            [i, j] => j - i == 1 || (*i == 0 && *j == 5),
            _ => false,
        };
        if open.is_empty() || open.len() > 6 || !fits || always_free(&self.axes, &self.knowledge).is_some() {
            return false;
        }
        let unknown: Vec<Form> = open.iter().map(|k| self.unit(*k)).collect();
        let before = self.knowledge.known.len();
        let step = Step { kind: StepKind::General, unknown, equations: vec![], collected: vec![], roots: 16, before };
        self.take(Some(Ranked { rank: (0, 0, 0), step }))
    }

    /// An arm that is singular everywhere: one coordinate of those that move the tool in the same way is chosen.
    pub(super) fn choose(&mut self) -> bool {
        let Some(k) = always_free(&self.axes, &self.knowledge) else { return false };
        let form = self.unit(k);
        let before = self.knowledge.known.len();
        let step = Step {
            kind: StepKind::Choose,
            unknown: vec![form],
            equations: vec![],
            collected: vec![],
            roots: 1,
            before,
        };
        self.take(Some(Ranked { rank: (0, 0, 0), step }))
    }
}

/// A coordinate that can be chosen at will at every generic configuration, given what is known.
fn always_free(axes: &Axes, knowledge: &Knowledge) -> Option<usize> {
    let x = joint_vectors(axes, 1, 0).pop()?;
    let open: Vec<usize> = (0..axes.count()).filter(|k| !knowledge.has(axes, *k)).collect();
    let rates = rates(axes, &x);
    let column = |k: usize| {
        let s = &rates[k];
        vec![s[2][1], s[0][2], s[1][0], s[0][3], s[1][3], s[2][3]]
    };
    // What a task leaves open (virtual coordinates) is open anyway: of dependent coordinates a real one is chosen.
    let mut rank = Span::default();
    let mut last = None;
    for k in open.iter().filter(|k| **k >= axes.real).chain(open.iter().filter(|k| **k < axes.real)) {
        if !rank.add(&column(*k)) {
            last = Some(*k);
        }
    }
    last.filter(|k| *k < axes.real)
}
