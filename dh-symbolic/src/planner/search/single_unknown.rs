//! Steps with one unknown: asks every kind of step for ways to find one combination of joints.

use super::super::known::Basis;
use super::super::scalar::Equation;
use super::super::steps::{Offer, Row, SingleUnknown, StepKind};
use super::super::subspace::JointCombination;
use super::{Search, best};

impl Search<'_> {
    pub(super) fn one_unknown(&mut self, virtual_too: bool) -> bool {
        let mut found: Option<Offer> = None;
        for (rest, families) in self.open_groups(1) {
            let mut forms = self.unknowns(&rest, &families);
            // Real coordinates were tried before.
            forms.retain(|f| virtual_too == self.is_virtual(f));
            let equations = if forms.is_empty() { Vec::new() } else { self.equations(&families) };
            for form in forms {
                for offer in self.offers(&form, &equations) {
                    found = best(found, offer);
                }
            }
        }
        self.take(found)
    }

    /// The ways to find one combination.
    fn offers(&mut self, form: &JointCombination, equations: &[Equation]) -> Vec<Offer> {
        let mut rows: Vec<Row> = Vec::new();
        for &equation in equations {
            let p = self.write(&equation);
            if let Some(collected) = self.knowledge.collect(&self.axes, &p, std::slice::from_ref(form))
                && collected.keys().any(|k| k[0] != Basis::One)
                && !rows.iter().any(|r| r.collected == collected)
            {
                rows.push(Row { equation, collected });
            }
        }
        let scene = self.scene();
        // An equation that follows from what is known already has no slope where it holds.
        let samples = scene.samples(2, 0);
        rows.retain(|r| samples.iter().all(|s| r.gradient([form], s)[0].abs() > 1e-6));
        let is_angle = form.iter().position(|k| *k != 0).is_none_or(|k| self.axes.is_revolute(k));
        let at = SingleUnknown { scene, form, is_angle, rows };
        StepKind::ALL.iter().flat_map(|kind| kind.for_one_unknown(&at)).collect()
    }
}
