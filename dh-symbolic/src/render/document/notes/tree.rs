//! The solutions of the example as a tree: which value each step found after which.

use super::arm::{Arm, Found};
use super::numbers::combined;
use super::{Block, Math, NotesWriter, Phrase, Span, Text};
use crate::planner::JointCombination;
use crate::render::document::explanation::Explanation;

/// Values that differ by less are the same branch.
const SAME: f64 = 1e-6;

impl NotesWriter<'_> {
    /// A table in the order of the steps; what equals the cell above, with all cells before it, is left empty.
    pub(super) fn tree(&mut self, arm: &Arm, found: &[Found]) {
        let real = |f: &JointCombination| f.iter().skip(arm.inverse.plan.axes.real).all(|k| *k == 0);
        let explanation = Explanation::new(self.chain, &arm.inverse.plan, &self.notation);
        let told = explanation.steps.iter().filter_map(|s| arm.inverse.plan.steps.get(s.index));
        let forms: Vec<&JointCombination> = told.clone().flat_map(|s| &s.unknown).collect();
        let several = told.clone().any(|s| s.roots > 1);
        if found.len() < 3 || !several || forms.len() < 2 || !forms.iter().all(|f| real(f)) {
            return;
        }
        let names: Vec<Math> = explanation.steps.iter().flat_map(|s| s.unknown.iter().cloned()).collect();
        let value = |form: &JointCombination, x: &[f64]| combined(arm, form, x);
        let mut rows: Vec<(Vec<(f64, bool)>, usize)> = found
            .iter()
            .enumerate()
            .map(|(i, f)| {
                let x = arm.coordinates(&f.q);
                (forms.iter().map(|form| value(form, &x)).collect(), i + 1)
            })
            .collect();
        rows.sort_by(|a, b| {
            let differ = |x: &(f64, bool), y: &(f64, bool)| {
                if (x.0 - y.0).abs() < SAME { None } else { Some(y.0.total_cmp(&x.0)) }
            };
            let order = a.0.iter().zip(&b.0).find_map(|(x, y)| differ(x, y));
            order.unwrap_or(a.1.cmp(&b.1))
        });
        let mut cells: Vec<Vec<Text>> = Vec::new();
        let mut above: Option<&[(f64, bool)]> = None;
        for (values, number) in &rows {
            let mut same = true;
            let mut row = Vec::new();
            for (k, (x, turns)) in values.iter().enumerate() {
                same &= above.and_then(|a| a.get(k)).is_some_and(|y| (x - y.0).abs() < SAME);
                row.push(match same {
                    true => Text::default(),
                    false => Text::from(self.plain_value(arm, *x, *turns)),
                });
            }
            row.push(Text(vec![Span::Plain(number.to_string())]));
            cells.push(row);
            above = Some(values);
        }
        let mut header: Vec<Text> = names.into_iter().map(Text::from).collect();
        header.push(self.words(Phrase::TreeSolution).into());
        self.say(Phrase::Tree, vec![]);
        self.blocks.push(Block::Table(header, cells));
    }
}
