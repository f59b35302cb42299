//! Translates one step of a plan: the coefficients of its equations, the call of its kernel, and its report where it has no root.

use super::ir::{Distance, Report, Solve};
use super::lower::{Lower, Pose};
use crate::algebra::{Poly, Symbol};
use crate::planner::{Argument, Coefficient, Collected, Knowledge, KnownPose};
use crate::program::graph::{Value, ZERO};

impl Lower<'_> {
    /// Step number `step` for the target `w`.
    pub(super) fn step(&mut self, w: Pose, number: usize) -> (Solve, Report) {
        let plan = self.plan;
        let step = &plan.steps[number];
        for pose in poses_of(&step.collected, &plan.knowledge) {
            self.bind_pose(w, &pose, step.before);
        }
        let finds: Vec<usize> = (step.before..step.before + step.unknown.len()).collect();
        let equations: Vec<Vec<Value>> = if step.is_elimination() {
            self.general(w, step)
        } else {
            step.collected.iter().map(|c| self.row(&step.kind.columns(), c)).collect()
        };
        let axes = &plan.axes;
        let is_angle = finds.first().is_some_and(|k| plan.knowledge.known[*k].is_angle);
        let value = |c: &Coefficient| match *c {
            Coefficient::Plus(row, place) => equations[row][place],
            Coefficient::Minus(row, place) => -equations[row][place],
            Coefficient::Zero => ZERO,
        };
        let mut call = step.kind.call(equations.len(), is_angle).map(&value);
        for argument in &mut call.arguments {
            if let Argument::Elimination { prismatic, .. } = argument {
                for (prismatic, form) in prismatic.iter_mut().zip(&step.unknown) {
                    *prismatic = form.iter().position(|k| *k != 0).is_some_and(|k| !axes.is_revolute(k));
                }
            }
        }
        let distance = step.reach_limit(plan).and_then(|limit| {
            let rest = *equations.first()?.get(2)?;
            Some(Distance { base: self.formula(&limit.base), rest: -rest, grows: limit.grows })
        });
        let names: Vec<String> = step.unknown.iter().map(|f| plan.knowledge.form_name(axes, f)).collect();
        let report = Report {
            step: number,
            indicator: plan.indicator(number),
            unknowns: names.join(", "),
            is_length: step.measures_length(),
            distance,
        };
        let name = step.words().name.english;
        (Solve { step: number, equations, call, finds, name }, report)
    }
}

/// The known poses that occur in some equations.
fn poses_of(collected: &[Collected], knowledge: &Knowledge) -> Vec<KnownPose> {
    let mut symbols: Vec<Symbol> = collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
    symbols.sort_unstable();
    symbols.dedup();
    let used = |k: &KnownPose| k.symbols().any(|s| symbols.binary_search(&s).is_ok());
    knowledge.poses.iter().filter(|k| used(k)).cloned().collect()
}
