//! The derivation of the inverse kinematics, step by step along the plan that the code follows.

use super::{Block, Equation, Math, Phrase, Sign, Span, Text, Writer};
use crate::algebra::Transform;
use crate::chain::Task;
use crate::planner::Slot;
use crate::program::Inverse;
use crate::render::document::explanation::{Explanation, Source, StepExplanation};
use crate::render::document::frames::Frame;
use crate::render::{Language, refusal};

impl Writer<'_> {
    pub(super) fn inverse(&mut self) {
        if !self.chain.ik || self.chain.dof() == 0 {
            return;
        }
        self.heading(1, Phrase::Inverse);
        let plan = match Inverse::of(self.chain) {
            Ok(inverse) => inverse.plan,
            Err(refusal) => {
                self.say(Phrase::NoInverse, vec![]);
                let reasons = refusal::remarks(self.chain, &refusal, self.options.language);
                self.blocks.push(Block::List(reasons.iter().map(|r| Text::with_code(&r.sentences())).collect()));
                return;
            }
        };
        let explanation = Explanation::new(self.chain, &plan, &self.notation);
        self.wanted(&explanation);
        for (i, step) in explanation.steps.iter().enumerate() {
            self.step(&explanation, i + 1, step);
        }
        let differences = explanation.differences();
        if !differences.is_empty() {
            self.say(Phrase::Differences, vec![]);
            let list = differences.into_iter().map(|(l, r)| self.equation(l, r)).collect();
            self.blocks.push(Block::Equations(list));
        }
        match plan.max_solutions {
            1 => self.say(Phrase::TotalOne, vec![]),
            n => self.say(Phrase::Total, vec![Math::number(n)]),
        }
    }

    /// What is given, and in which frames.
    fn wanted(&mut self, explanation: &Explanation<'_>) {
        let axes = &explanation.plan.axes;
        let (start, end) = (&axes.start, &axes.end);
        let whole = explanation.between(0, axes.hops.len());
        let mut product = Vec::new();
        let minus_one = || Math::Row(vec![Math::Sign(Sign::Negative), Math::number(1)]);
        let goal = Math::Letter('G');
        let mut shown: Vec<(Math, &Transform)> = Vec::new();
        if *start != Transform::identity() {
            let name = Math::Letter('B');
            product.extend([name.clone().above(minus_one()), Math::Sign(Sign::Thin)]);
            shown.push((name, start));
        }
        product.push(goal);
        if *end != Transform::identity() {
            let name = Math::Letter('E');
            product.extend([Math::Sign(Sign::Thin), name.clone().above(minus_one())]);
            shown.push((name, end));
        }
        let r = Math::Letter('r').below(Math::Row(vec![Math::Letter('i'), Math::Letter('j')]));
        self.say(Phrase::Wanted, vec![Math::equation(whole, Math::Row(product)), r, Math::Letter('p')]);
        for (name, t) in shown {
            self.transform(name, None, t, None);
        }
        if explanation.moved {
            let from = if self.chain.base.is_empty() { Frame::Row(0) } else { Frame::Base };
            let frames = [Frame::Primed(0), from].map(|f| self.notation.frame(f)).to_vec();
            self.say(Phrase::StartIsMoved, [frames, vec![Math::Letter('B')]].concat());
        }
        let open = |k| vec![explanation.coordinate(k)];
        match self.chain.task {
            Task::Pose => {}
            Task::Axis => self.say(Phrase::TaskAxis, open(self.chain.dof())),
            Task::Position => self.say(Phrase::TaskPosition, vec![]),
            Task::Planar if axes.coordinates.len() > axes.real => {
                self.say(Phrase::TaskPlanar, open(self.chain.dof()));
            }
            Task::Planar => self.say(Phrase::TaskInPlane, vec![]),
        }
        let i = || Math::Letter('i');
        if self.chain.convention == crate::chain::Convention::Standard {
            let before = Math::Row(vec![i(), Math::Sign(Sign::Minus), Math::number(1)]);
            self.say(Phrase::FramesStandard, vec![i(), before, i()]);
        }
        let primed = explanation.primed();
        if !primed.is_empty() {
            let phrase = match self.chain.convention {
                crate::chain::Convention::Standard => Phrase::PrimedStandard,
                crate::chain::Convention::Modified => Phrase::PrimedModified,
            };
            self.say(phrase, vec![i().above(Math::Sign(Sign::Prime)), i()]);
        }
        match explanation.end {
            Some(end @ Frame::Tool) => self.say(Phrase::EndIsTool, vec![self.notation.frame(end)]),
            Some(end) => {
                let own = self.notation.frame(Frame::Row(self.chain.links.len()));
                self.say(Phrase::EndIsShifted, vec![self.notation.frame(end), own]);
            }
            None => {}
        }
        let given: Vec<Math> = self.chain.chosen().iter().map(|(joint, _)| self.coordinate(*joint)).collect();
        if !given.is_empty() {
            self.say(Phrase::Given, vec![Math::list(&given)]);
        }
    }

    fn step(&mut self, explanation: &Explanation<'_>, number: usize, step: &StepExplanation) {
        let mut title = Text::from(self.words(Phrase::StepTitle).replace("{}", &number.to_string()));
        title.0.extend(listed(&step.unknown));
        let colon = if self.options.language == Language::Chinese { "，" } else { " from " };
        title.0.push(Span::Plain(format!("{colon}{}", self.options.language.of(step.words.name))));
        self.blocks.push(Block::Heading(2, title));
        self.poses(explanation, step);
        if !step.equations.is_empty() {
            self.sources(step);
            let list: Vec<Equation> = step.equations.iter().map(|(l, r)| self.equation(l.clone(), r.clone())).collect();
            self.blocks.push(Block::Equations(list));
            let extras = step.new_extras.iter().map(|(l, r)| Math::equation(l.clone(), r.clone())).collect();
            self.tell(Phrase::Where, extras);
            self.tell_new_with(explanation, &step.expressions);
        }
        if !step.sums.is_empty() {
            let sums = step.sums.iter().map(|(l, r)| Math::equation(l.clone(), r.clone())).collect();
            self.tell(Phrase::Sum, sums);
        }
        self.solution(step);
    }

    /// The given pose brought back over what is known.
    fn poses(&mut self, explanation: &Explanation<'_>, step: &StepExplanation) {
        for i in &step.new_poses {
            let Some(pose) = explanation.poses.get(*i) else { continue };
            if let Some(product) = &pose.product {
                self.say(Phrase::KnownPose, vec![]);
                self.display(pose.matrix.clone(), product.clone());
                self.say(Phrase::WithEntries, pose.entries.to_vec());
            }
        }
    }

    fn sources(&mut self, step: &StepExplanation) {
        for source in &step.sources {
            let (phrase, list, of) = match source {
                Source::Elements(list, of) if list.len() == 1 => (Phrase::Element, list, of),
                Source::Elements(list, of) => (Phrase::Elements, list, of),
                Source::InverseElements(list, of) if list.len() == 1 => (Phrase::ElementOfInverse, list, of),
                Source::InverseElements(list, of) => (Phrase::ElementsOfInverse, list, of),
                Source::Distance(a, b) => {
                    self.say(Phrase::DistanceOf, vec![a.clone(), b.clone()]);
                    continue;
                }
                Source::Across(slides) => {
                    self.say(Phrase::AcrossSlides, slides.to_vec());
                    continue;
                }
                Source::Bridge(slides, turns) => {
                    self.say(Phrase::BridgeOfSlides, slides.iter().chain(turns).cloned().collect());
                    continue;
                }
            };
            let elements: Vec<String> = list.iter().map(|(i, j)| format!("({i}, {j})")).collect();
            let pieces = vec![Span::Plain(elements.join(", ")), Span::Math(of.clone())];
            self.blocks.push(Block::Paragraph(Text::fill(self.words(phrase), pieces)));
        }
    }

    fn solution(&mut self, step: &StepExplanation) {
        let s = &step.solution;
        let first = step.unknown.first().cloned().unwrap_or(Math::number(0));
        let second = step.unknown.get(1).cloned().unwrap_or(first.clone());
        let tangent = |m: &Math| {
            Math::Row(vec![
                Math::word("tan"),
                Math::Sign(Sign::Apply),
                Math::Fraction(Box::new(Math::number(1)), Box::new(Math::number(2))),
                m.clone(),
            ])
        };
        match step.words.sentence {
            Some((sentence, slots)) => {
                let piece = |slot: &Slot| match slot {
                    Slot::First => first.clone(),
                    Slot::Second => second.clone(),
                    Slot::Roots => Math::number(step.roots),
                    Slot::HalfTangent => tangent(&first),
                    Slot::NamedHalfTangent => Math::equation(Math::Letter('t'), tangent(&first)),
                };
                let pieces = slots.iter().map(|slot| Span::Math(piece(slot))).collect();
                self.blocks.push(Block::Paragraph(Text::fill(self.options.language.of(sentence), pieces)));
            }
            None => {
                let solved = s.formulas.iter().all(|f| step.equations.contains(f));
                if !solved {
                    self.say(Phrase::Hence, vec![]);
                    let all = s.abbreviations.iter().chain(&s.formulas);
                    let list = all.map(|(l, r)| self.equation(l.clone(), r.clone())).collect();
                    self.blocks.push(Block::Equations(list));
                }
                self.fate(step, first);
            }
        }
    }

    /// How many solutions, and where there are none or too many.
    fn fate(&mut self, step: &StepExplanation, unknown: Math) {
        let s = &step.solution;
        let mut text = match step.roots {
            1 => Text::from(self.words(Phrase::OneSolution)),
            n => Text::fill(self.words(Phrase::Solutions), vec![Span::Plain(n.to_string())]),
        };
        let space = if self.options.language == Language::Chinese { "" } else { " " };
        let mut add = |more: Text| {
            text.0.push(Span::Plain(space.to_string()));
            text.0.extend(more.0);
        };
        if s.second {
            add(Text::from(self.words(Phrase::SecondInstead)));
        }
        if let Some(radicand) = &s.radicand {
            add(Text::fill(self.words(Phrase::NoneWhere), vec![Span::Math(radicand.clone())]));
        }
        match s.degenerate.as_slice() {
            [] => {}
            [only] => {
                let pieces = vec![Span::Math(only.clone()), Span::Math(unknown)];
                add(Text::fill(self.words(Phrase::FreeWhereOne), pieces));
            }
            more => {
                let mut pieces = Text::fill(self.words(Phrase::FreeWhere), vec![]).0;
                pieces.clear();
                let mut halves = self.words(Phrase::FreeWhere).split("{}");
                pieces.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
                pieces.extend(listed(more));
                pieces.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
                pieces.push(Span::Math(unknown));
                pieces.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
                pieces.retain(|p| !matches!(p, Span::Plain(t) if t.is_empty()));
                add(Text(pieces));
            }
        }
        text.0.retain(|p| !matches!(p, Span::Plain(t) if t.is_empty()));
        self.blocks.push(Block::Paragraph(text));
    }

    /// Tells abbreviations in the names of a explanation.
    fn tell_new_with(
        &mut self,
        explanation: &Explanation<'_>,
        expressions: &[crate::render::formula::expression::Expression],
    ) {
        let plain = std::mem::replace(&mut self.notation, explanation.notation().clone());
        self.tell_new(Phrase::With, expressions);
        self.notation = plain;
    }
}

/// a, b, c.
pub(super) fn listed(list: &[Math]) -> Vec<Span> {
    let mut out = Vec::new();
    for (i, m) in list.iter().enumerate() {
        if i > 0 {
            out.push(Span::Plain(", ".into()));
        }
        out.push(Span::Math(m.clone()));
    }
    out
}
