//! Explains a plan of the inverse kinematics: for every step its exact equations, its solution and where they come from.
//!
//! **In:** a [`Plan`]. **Out:** [`Explanation`]: typeset formulas per step, still without prose. `notes` tells it as a derivation,
//! `plan` as a summary and a flow chart.

mod names;
mod rows;
mod solution;
#[cfg(test)]
mod tests;

use crate::algebra::{Poly, Symbol};
use crate::chain::Chain;
use crate::planner::{JointCombination, Plan, Step, Words};
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Expression;
use crate::render::formula::grouping::Order;
use crate::render::formula::math::Math;
use crate::render::formula::notation::Notation;
pub(crate) use names::{PoseName, Source};
pub(crate) use solution::Solution;

/// A plan with names for everything in it.
pub(crate) struct Explanation<'a> {
    pub(crate) plan: &'a Plan,
    notation: Notation,
    order: Order,
    /// Does the table follow the modified convention?
    modified: bool,
    /// What the last frame is called, where it is no frame of the table.
    pub(crate) end: Option<Frame>,
    /// Is the first frame another one than frame 0 of the table? It is called 0' then.
    pub(crate) moved: bool,
    /// Parameters: what a formula may be divided by.
    lengths: Vec<Symbol>,
    /// Known poses in order of first use.
    pub(crate) poses: Vec<PoseName>,
    /// The steps.
    pub(crate) steps: Vec<StepExplanation>,
}

/// One step.
pub(crate) struct StepExplanation {
    /// What people call it.
    pub(crate) words: Words,
    /// The unknowns: angles, sums of angles, lengths.
    pub(crate) unknown: Vec<Math>,
    /// Sums of angles among them, written out.
    pub(crate) sums: Vec<(Math, Math)>,
    /// Where the equations come from.
    pub(crate) sources: Vec<Source>,
    /// The equations: left and right side.
    pub(crate) equations: Vec<(Math, Math)>,
    /// How they are solved.
    pub(crate) solution: Solution,
    /// Most solutions of this step.
    pub(crate) roots: usize,
    /// Known poses that occur here first: indices into the explanation's list.
    pub(crate) new_poses: Vec<usize>,
    /// Meaning of what occurs here first besides their elements.
    pub(crate) new_extras: Vec<(Math, Math)>,
    /// Earlier steps whose results occur here.
    pub(crate) needs: Vec<usize>,
    /// Sines and cosines in the equations, for the legend.
    pub(crate) expressions: Vec<Expression>,
}

impl<'a> Explanation<'a> {
    /// Names everything in a plan. `notation` has the names of the chain.
    pub(crate) fn new(chain: &Chain, plan: &'a Plan, notation: &Notation) -> Explanation<'a> {
        let mut explanation = Explanation {
            plan,
            notation: names::notation(chain, plan, notation),
            order: Order::of(chain),
            modified: false,
            end: None,
            moved: false,
            lengths: chain
                .parameters
                .iter()
                .filter_map(|p| match p.handle {
                    crate::chain::Handle::Length(s) => Some(s),
                    crate::chain::Handle::Angle(_) => None,
                })
                .collect(),
            poses: Vec::new(),
            steps: Vec::new(),
        };
        explanation.name_poses(chain);
        for (i, step) in plan.steps.iter().enumerate() {
            let explained = explanation.step(i, step);
            explanation.steps.push(explained);
        }
        explanation
    }

    fn step(&self, number: usize, step: &Step) -> StepExplanation {
        let step = &rows::without_repeats(step);
        let rows = rows::rows(self, step);
        let solution = solution::solution(self, number + 1, step, &rows);
        let symbols: Vec<Symbol> = step.collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
        let earlier: Vec<Symbol> = self
            .plan
            .steps
            .iter()
            .take(number)
            .flat_map(|s| &s.collected)
            .flat_map(|c| c.values().flat_map(Poly::symbols))
            .collect();
        let occurs =
            |i: usize, list: &[Symbol]| self.plan_pose(i).is_some_and(|k| k.symbols().any(|s| list.contains(&s)));
        let new_poses = (0..self.poses.len()).filter(|i| occurs(*i, &symbols) && !occurs(*i, &earlier)).collect();
        let extras = self.poses.iter().flat_map(|p| &p.extras);
        let new_extras = extras
            .filter(|(s, ..)| symbols.contains(s) && !earlier.contains(s))
            .map(|(_, left, right)| (left.clone(), right.clone()))
            .collect();
        let mut equations: Vec<(Math, Math)> = rows.iter().map(|r| r.sides(self)).collect();
        if let (Some(name), Some(first)) = (&solution.right, equations.first_mut()) {
            let right = std::mem::replace(&mut first.1, name.clone());
            equations.push((name.clone(), right));
        }
        StepExplanation {
            words: step.words(),
            unknown: step.unknown.iter().map(|f| self.unknown(f)).collect(),
            sums: step.unknown.iter().filter_map(|f| self.sum(f)).collect(),
            sources: self.sources(&step.equations),
            equations,
            solution,
            roots: step.roots,
            new_poses,
            new_extras,
            needs: self.needs(step, &symbols),
            expressions: rows.iter().flat_map(rows::Row::expressions).collect(),
        }
    }

    /// Earlier steps that this one builds on: through sines and cosines in its coefficients, or through known poses.
    fn needs(&self, step: &Step, symbols: &[Symbol]) -> Vec<usize> {
        let mut joints: Vec<usize> = Vec::new();
        let used = self.plan.knowledge.poses.iter().filter(|k| k.symbols().any(|s| symbols.contains(&s)));
        for pose in used {
            let hops = &self.plan.axes.hops;
            let outside = hops.get(..pose.left).unwrap_or(&[]).iter().chain(hops.get(pose.right..).unwrap_or(&[]));
            joints.extend(outside.filter_map(|h| h.joint));
        }
        let known = |k: usize| self.plan.knowledge.known.get(k);
        (0..self.plan.steps.len())
            .filter(|i| {
                let Some(s) = self.plan.steps.get(*i).filter(|s| s.before < step.before) else { return false };
                (s.before..s.before + s.unknown.len()).filter_map(known).any(|k| {
                    k.symbols.iter().any(|x| symbols.contains(x))
                        || joints.iter().any(|j| k.form.get(*j).is_some_and(|c| *c != 0))
                })
            })
            .collect()
    }

    /// Joints that are differences of what the steps found: left and right sides.
    pub(crate) fn differences(&self) -> Vec<(Math, Math)> {
        let known = &self.plan.knowledge.known;
        let forms: Vec<JointCombination> = known.iter().map(|k| k.form.clone()).collect();
        let mut out = Vec::new();
        for k in 0..self.plan.axes.real {
            let mut unit = vec![0i8; self.plan.axes.count()];
            if let Some(x) = unit.get_mut(k) {
                *x = 1;
            }
            if forms.contains(&unit) {
                continue;
            }
            let Some(weights) = crate::planner::combination(&unit, &forms) else { continue };
            let mut pieces: Vec<(i8, &JointCombination)> =
                weights.iter().copied().zip(&forms).filter(|(w, _)| *w != 0).collect();
            pieces.sort_by_key(|(w, f)| (*w < 0, f.iter().position(|k| *k != 0)));
            let pieces = pieces.into_iter().map(|(w, f)| (w, self.unknown(f)));
            out.push((self.unknown(&unit), names::weighted(pieces)));
        }
        out
    }

    /// A formula of the plan in reading order: known sines and cosines are sines and cosines again.
    fn group(&self, p: &Poly) -> Expression {
        self.order.group(&self.plain(p))
    }

    /// Known sines and cosines as harmonics.
    fn plain(&self, p: &Poly) -> Poly {
        p.substitute_symbols(|s| {
            let known = self.plan.knowledge.known.iter().filter(|k| k.turns).find(|k| k.symbols.contains(&s))?;
            let trig = self.angles(&known.form);
            Some(Poly::harmonic(&trig, known.symbols.first() != Some(&s)))
        })
    }

    fn typeset(&self, p: &Poly) -> Math {
        self.notation.typeset(&self.group(p))
    }

    /// The notation of the explanation.
    pub(crate) fn notation(&self) -> &Notation {
        &self.notation
    }
}
