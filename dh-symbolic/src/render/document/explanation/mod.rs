//! Explains a plan of the inverse kinematics: for every step its exact equations, its solution and where they come from.
//!
//! **In:** a [`Plan`]. **Out:** [`Explanation`]: typeset formulas per step, still without prose. `notes` tells it as a derivation,
//! `plan` as a summary and a flow chart.

mod names;
mod places;
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
use places::Written;
pub(crate) use solution::Solution;

/// A plan with names for everything in it.
pub(crate) struct Explanation<'a> {
    pub(crate) plan: &'a Plan,
    notation: Notation,
    order: Order,
    /// Where the planner's frames stand among those of the table.
    places: Vec<places::PlannedFrame>,
    /// Frames between which the given pose leads: the base or frame 0, the tool or the last frame.
    ends: [Frame; 2],
    /// Number of rows of the table.
    rows: usize,
    /// Letters for intermediate results that no name of the chain has.
    letters: Vec<char>,
    /// Parameters: what a formula may be divided by.
    lengths: Vec<Symbol>,
    /// Known poses in order of first use.
    pub(crate) poses: Vec<PoseName>,
    /// The steps.
    pub(crate) steps: Vec<StepExplanation>,
}

/// One step.
pub(crate) struct StepExplanation {
    /// Its number in the plan, from 0: steps that find nothing but what the task leaves open are not told.
    pub(crate) index: usize,
    /// Entries of known poses in its equations, in order.
    pub(crate) symbols: Vec<Symbol>,
    /// Its name in the literature.
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
    /// Frames that the sources name.
    frames: Vec<Frame>,
}

impl<'a> Explanation<'a> {
    /// Names everything in a plan. `notation` has the names of the chain.
    pub(crate) fn new(chain: &Chain, plan: &'a Plan, notation: &Notation) -> Explanation<'a> {
        let rows = chain.links.len();
        let ends = [
            if chain.base.is_empty() { Frame::Row(0) } else { Frame::Base },
            if chain.tool.is_empty() { Frame::Row(rows) } else { Frame::Tool },
        ];
        let mut explanation = Explanation {
            plan,
            notation: names::notation(chain, plan, notation),
            order: Order::of(chain),
            places: places::places(chain, &plan.axes),
            ends,
            rows,
            letters: solution::LETTERS.into_iter().filter(|c| names::is_free(chain, &c.to_string())).collect(),
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
        let mut steps = plan.steps.clone();
        let told = told(plan);
        let mut number = 0;
        steps.retain(|_| {
            number += 1;
            told.contains(&(number - 1))
        });
        let written = explanation.written(&mut steps);
        explanation.name_poses(chain, &written);
        for (i, step) in steps.iter().enumerate() {
            let explained = explanation.step(i, step, &steps, &told);
            explanation.steps.push(explained);
        }
        explanation
    }

    /// Rewrites the equations in poses between frames of the table, as far as they are no longer there; which poses occur then, in
    /// order of first use: index in the plan's list, frames.
    fn written(&self, steps: &mut [Step]) -> Vec<(usize, Frame, Frame)> {
        let mut out: Vec<(usize, Frame, Frame)> = Vec::new();
        for index in used_poses(self.plan, steps) {
            let Some(pose) = self.plan.knowledge.poses.get(index) else { continue };
            let own: Vec<Symbol> = pose.symbols().collect();
            let Some((left, right)) = self.places.get(pose.left).zip(self.places.get(pose.right)) else { continue };
            let formulas: Vec<&Poly> = steps
                .iter()
                .flat_map(|s| &s.collected)
                .flat_map(|c| c.values())
                .filter(|p| own.iter().any(|s| p.has_symbol(*s)))
                .collect();
            let mut best: Option<(usize, Written)> = None;
            for (l, r) in left.views.iter().flat_map(|l| right.views.iter().map(move |r| (l, r))) {
                let written = Written::new(pose, l, r);
                let terms: Option<usize> = formulas.iter().map(|p| Some(written.translate(p)?.terms().len())).sum();
                if let Some(terms) = terms.filter(|n| best.as_ref().is_none_or(|b| *n < b.0)) {
                    best = Some((terms, written));
                }
            }
            let Some((_, written)) = best else { continue };
            // A pose between the same frames that has a letter already.
            let known = out.iter().find(|x| (x.1, x.2) == (written.left, written.right)).copied();
            let twin = known.and_then(|x| self.plan.knowledge.poses.get(x.0));
            for p in steps.iter_mut().flat_map(|s| &mut s.collected).flat_map(|c| c.values_mut()) {
                if !own.iter().any(|s| p.has_symbol(*s)) {
                    continue;
                }
                let mut value = written.translate(p).unwrap_or_else(|| p.clone());
                if let Some(twin) = twin {
                    let list: Vec<Symbol> = twin.symbols().collect();
                    let other = |s: Symbol| own.iter().position(|x| *x == s).and_then(|i| list.get(i)).copied();
                    value = value.substitute_symbols(|s| other(s).map(Poly::symbol));
                }
                *p = value;
            }
            if twin.is_none() {
                out.push((index, written.left, written.right));
            }
        }
        for s in steps.iter_mut() {
            for c in &mut s.collected {
                c.retain(|_, p| !p.is_zero());
            }
        }
        out
    }

    fn step(&self, number: usize, step: &Step, steps: &[Step], told: &[usize]) -> StepExplanation {
        let step = &rows::without_repeats(step);
        let rows = rows::rows(self, step);
        let solution = solution::solution(self, number + 1, step, &rows);
        let symbols: Vec<Symbol> = step.collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
        let earlier: Vec<Symbol> = steps
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
        let (sources, frames) = self.sources(&step.equations);
        let entry = |s: &Symbol| self.plan.knowledge.poses.iter().any(|k| k.symbols().any(|x| x == *s));
        let mut entries: Vec<Symbol> = symbols.iter().copied().filter(entry).collect();
        entries.sort_unstable();
        entries.dedup();
        StepExplanation {
            index: told.get(number).copied().unwrap_or(number),
            symbols: entries,
            words: step.words(),
            unknown: step.unknown.iter().map(|f| self.unknown(f)).collect(),
            sums: step.unknown.iter().filter_map(|f| self.sum(f)).collect(),
            sources,
            frames,
            equations,
            solution,
            roots: step.roots,
            new_poses,
            new_extras,
            needs: self.needs(step, &symbols, told),
            expressions: rows.iter().flat_map(rows::Row::expressions).collect(),
        }
    }

    /// Earlier steps that this one builds on: through sines and cosines in its coefficients, or through known poses.
    fn needs(&self, step: &Step, symbols: &[Symbol], told: &[usize]) -> Vec<usize> {
        let mut joints: Vec<usize> = Vec::new();
        let used = self.plan.knowledge.poses.iter().filter(|k| k.symbols().any(|s| symbols.contains(&s)));
        for pose in used {
            let links = &self.plan.axes.links;
            let outside = links.get(..pose.left).unwrap_or(&[]).iter().chain(links.get(pose.right..).unwrap_or(&[]));
            joints.extend(outside.filter_map(|h| h.joint));
        }
        let known = |k: usize| self.plan.knowledge.known.get(k);
        (0..told.len())
            .filter(|i| {
                let plan = told.get(*i).and_then(|k| self.plan.steps.get(*k));
                let Some(s) = plan.filter(|s| s.before < step.before) else { return false };
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
            let known = self.plan.knowledge.known.iter().filter(|k| k.is_angle).find(|k| k.symbols.contains(&s))?;
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

/// The steps that a reader needs: those that find joints, and those whose results occur in their equations.
fn told(plan: &Plan) -> Vec<usize> {
    let real = |s: &Step| s.unknown.iter().any(|f| f.iter().take(plan.axes.real).any(|k| *k != 0));
    let mut needed: Vec<bool> = plan.steps.iter().map(real).collect();
    for i in (0..plan.steps.len()).rev() {
        if !needed[i] {
            continue;
        }
        let symbols: Vec<Symbol> =
            plan.steps[i].collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
        for (k, s) in plan.steps.iter().enumerate().take(i) {
            let finds = plan.knowledge.known.get(s.before..s.before + s.unknown.len()).unwrap_or_default();
            needed[k] |= finds.iter().any(|f| f.symbols.iter().any(|x| symbols.contains(x)));
        }
    }
    (0..needed.len()).filter(|i| needed[*i]).collect()
}

/// Known poses that occur in the equations, in order of first use: indices in the plan's list.
fn used_poses(plan: &Plan, steps: &[Step]) -> Vec<usize> {
    let mut used: Vec<usize> = Vec::new();
    for s in steps.iter().flat_map(|s| &s.collected).flat_map(|c| c.values()).flat_map(Poly::symbols) {
        let pose = plan.knowledge.poses.iter().position(|k| k.symbols().any(|x| x == s));
        used.extend(pose.filter(|i| !used.contains(i)));
    }
    used
}
