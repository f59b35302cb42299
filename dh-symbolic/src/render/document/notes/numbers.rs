//! The steps of the inverse in numbers, on the way to one solution: what a reader checks with a pocket calculator.

use super::arm::{Arm, Found};
use super::{Block, Math, NotesWriter, Phrase, Span, Text};
use crate::algebra::{Poly, Symbol};
use crate::chain::Elementary;
use crate::planner::JointCombination;
use crate::program::{Indicator, Naming};
use crate::render::document::explanation::{Explanation, StepExplanation};
use crate::render::document::frames::{Frame, decimal};
use dh_kernels::pose::{self, Pose};

/// Roots that differ by less are one.
const SAME: f64 = 1e-6;

/// The example on its way to one solution.
struct Run<'a> {
    arm: &'a Arm,
    explanation: &'a Explanation<'a>,
    /// Entries of known poses.
    values: &'a [(Symbol, f64)],
    /// Joint coordinates.
    x: &'a [f64],
    solution: &'a Found,
}

impl NotesWriter<'_> {
    /// One item for each step: the entries of known poses in its equations, its letters, its roots; for the chosen solution, which is so
    /// far from the joint values that the example began with.
    pub(super) fn in_numbers(&mut self, arm: &Arm, found: &[Found], (chosen, apart): (usize, f64)) {
        let Some(solution) = found.get(chosen) else { return };
        let plan = &arm.inverse.plan;
        let explanation = Explanation::new(self.chain, plan, &self.notation);
        let x = arm.coordinates(&solution.q);
        let Some(values) = pose_values(&explanation, arm, &x, None) else { return };
        let run = Run { arm, explanation: &explanation, values: &values, x: &x, solution };
        let items: Vec<Text> =
            explanation.steps.iter().enumerate().map(|(i, s)| self.step_in_numbers(&run, i, s)).collect();
        let pieces = vec![Span::Plain((chosen + 1).to_string())];
        if apart > SAME {
            let list = (0..arm.dof()).map(|k| self.value_of(arm, k, solution.q[k], 0)).collect();
            self.tell(Phrase::InNumbersAt, list);
        }
        let single = found.len() < 2 || explanation.steps.iter().all(|s| s.roots < 2);
        let phrase = if single { Phrase::InNumbers } else { Phrase::InNumbersOf };
        self.blocks.push(Block::Paragraph(Text::fill(self.words(phrase), if single { vec![] } else { pieces })));
        self.blocks.push(Block::List(items));
    }

    fn step_in_numbers(&self, run: &Run<'_>, i: usize, step: &StepExplanation) -> Text {
        let Run { arm, explanation, values, x, solution } = *run;
        let at = |p: &Poly| arm.evaluate_with(p, x, &|s| values.iter().find(|v| v.0 == s).map(|v| v.1));
        let digits = self.options.digits + 1;
        let mut list: Vec<Math> = Vec::new();
        for s in &step.symbols {
            let value = significant(at(&Poly::symbol(*s)), digits);
            list.push(Math::equation(explanation.notation().symbol(*s), value));
        }
        for (name, q) in &step.solution.letters {
            list.push(Math::equation(name.clone(), significant(at(&q.top) / at(&q.below), digits)));
        }
        let mut text = Text::from(self.words(Phrase::StepTitle).replace("{}", &(i + 1).to_string()));
        let between = self.words(Phrase::Between);
        for (k, m) in list.into_iter().enumerate() {
            if k > 0 {
                text.0.push(Span::Plain(between.into()));
            }
            text.0.push(Span::Math(m));
        }
        if text.0.len() > 1 {
            text.0.push(Span::Plain(self.words(Phrase::Then).into()));
        }
        let plan = &arm.inverse.plan;
        let forms = plan.steps.get(step.index).map_or(&[][..], |s| &s.unknown);
        let mut said = false;
        for (form, name) in forms.iter().zip(&step.unknown).filter(|(f, _)| is_real(f, plan.axes.real)) {
            let (taken, turns) = combined(arm, form, x);
            if std::mem::replace(&mut said, true) {
                text.0.push(Span::Plain(between.into()));
            }
            text.0.push(Span::Math(Math::equation(name.clone(), self.plain_value(arm, taken, turns))));
            let apart = |y: &f64| {
                let d = y - taken;
                (if turns { d.sin().atan2(d.cos()) } else { d }).abs() > SAME * (1.0 + taken.abs())
            };
            let wrapped = |y: f64| if turns { y.sin().atan2(y.cos()) } else { y };
            let mut other: Vec<f64> = step.solution.roots.values(&at).into_iter().map(wrapped).filter(apart).collect();
            other.dedup_by(|a, b| (*a - *b).abs() < SAME);
            let named = arm.naming(step.index).map(|n| self.words(side(n, &solution.branch)).to_string());
            let mut remarks: Vec<Vec<Span>> = named.into_iter().map(|w| vec![Span::Plain(w)]).collect();
            if let [other] = other.as_slice() {
                let value = self.plain_value(arm, *other, turns);
                remarks.push(Text::fill(self.words(Phrase::OtherRoot), vec![Span::Math(value)]).0);
            }
            if !remarks.is_empty() {
                let [open, between, close] =
                    [Phrase::RemarkOpen, Phrase::Then, Phrase::RemarkClose].map(|p| self.words(p));
                text.0.push(Span::Plain(open.into()));
                for (k, r) in remarks.into_iter().enumerate() {
                    if k > 0 {
                        text.0.push(Span::Plain(between.into()));
                    }
                    text.0.extend(r);
                }
                text.0.push(Span::Plain(close.into()));
            }
        }
        text.0.push(Span::Plain(self.words(Phrase::Stop).into()));
        text
    }

    /// "left, up, no flip": which sides of shoulder, elbow and wrist a solution takes.
    pub(super) fn branch(&self, arm: &Arm, branch: &[usize]) -> String {
        let sides: Vec<&str> = arm.namings().iter().map(|n| self.words(side(*n, branch))).collect();
        sides.join(self.words(Phrase::Between))
    }
}

/// The word for the root that a branch takes.
fn side(naming: (usize, Naming), branch: &[usize]) -> Phrase {
    let (step, n) = naming;
    let root = |step: usize| branch.get(step).copied().unwrap_or(0);
    let turned = n.flipped_by.is_some_and(|k| root(k) == 1);
    let first = (root(step) == n.first) != turned;
    match (n.indicator, first) {
        (Indicator::Shoulder, true) => Phrase::ShoulderLeft,
        (Indicator::Shoulder, false) => Phrase::ShoulderRight,
        (Indicator::Elbow, true) => Phrase::ElbowUp,
        (Indicator::Elbow, false) => Phrase::ElbowDown,
        (Indicator::Wrist, true) => Phrase::WristNoFlip,
        (Indicator::Wrist, false) => Phrase::WristFlip,
    }
}

fn is_real(form: &JointCombination, real: usize) -> bool {
    form.iter().skip(real).all(|k| *k == 0)
}

/// The value of a combination of coordinates, and whether it turns.
pub(super) fn combined(arm: &Arm, form: &JointCombination, x: &[f64]) -> (f64, bool) {
    let sum: f64 = form.iter().zip(x).map(|(k, x)| f64::from(*k) * x).sum();
    let turns = form.iter().position(|k| *k != 0).is_some_and(|k| arm.is_revolute(k));
    (if turns { sum.sin().atan2(sum.cos()) } else { sum }, turns)
}

/// The entries of the known poses, of those with one of these symbols only.
pub(super) fn pose_values(
    explanation: &Explanation<'_>,
    arm: &Arm,
    x: &[f64],
    only: Option<&[Symbol]>,
) -> Option<Vec<(Symbol, f64)>> {
    let mut values = Vec::new();
    for pose in explanation.poses.iter().filter(|p| only.is_none_or(|list| explanation.has_entry(p, list))) {
        let (left, right) = (seen(explanation, arm, pose.left, x)?, seen(explanation, arm, pose.right, x)?);
        values.extend(explanation.values(pose, &pose::compose(&pose::inverse(&left), &right)));
    }
    Some(values)
}

/// A frame seen from frame 0, in numbers.
pub(super) fn seen(explanation: &Explanation<'_>, arm: &Arm, frame: Frame, x: &[f64]) -> Option<Pose> {
    let product = |list: &[Elementary]| list.iter().fold(pose::IDENTITY, |t, e| pose::compose(&t, &arm.motion(e, x)));
    Some(match frame {
        Frame::Row(n) => (0..n.min(arm.chain.links.len()))
            .fold(pose::IDENTITY, |t, i| pose::compose(&t, &product(&arm.chain.link_factors(i)))),
        Frame::Base => pose::inverse(&product(&arm.chain.base)),
        Frame::Tool => {
            let last = seen(explanation, arm, Frame::Row(arm.chain.links.len()), x)?;
            pose::compose(&last, &product(&arm.chain.tool))
        }
        primed => {
            let d = explanation.definition(primed)?;
            let motion = product(&d.factors);
            if d.to == primed {
                pose::compose(&seen(explanation, arm, d.from, x)?, &motion)
            } else {
                pose::compose(&seen(explanation, arm, d.to, x)?, &pose::inverse(&motion))
            }
        }
    })
}

/// A number with so many digits that count.
pub(super) fn significant(x: f64, digits: usize) -> Math {
    if x.abs() < 1e-12 {
        return Math::number(0);
    }
    let ahead = x.abs().log10().floor() as i64;
    let places = (digits as i64 - 1 - ahead).clamp(0, 15);
    decimal(x, places as usize)
}
