//! The derivation of the inverse kinematics, step by step along the plan that the code follows.

use super::arm::Arm;
use super::degenerate;
use super::{Block, Equation, Math, NotesWriter, Phrase, Sign, Span, Text, side_by_side};
use crate::chain::{Elementary, Task};
use crate::planner::Slot;
use crate::render::document::explanation::{Explanation, Source, StepExplanation};
use crate::render::document::frames::Frame;
use crate::render::{Language, refusal};

impl NotesWriter<'_> {
    pub(super) fn inverse(&mut self) {
        if !self.chain.settings.ik || self.chain.dof() == 0 {
            return;
        }
        self.heading(1, Phrase::Inverse);
        let solved = self.solved();
        let inverse = match &*solved {
            Ok(inverse) => inverse,
            Err(refusal) => {
                self.say(Phrase::NoInverse, vec![]);
                let reasons = refusal::remarks(self.chain, refusal, self.options.language);
                self.blocks.push(Block::List(reasons.iter().map(|r| Text::with_code(&r.sentences())).collect()));
                return;
            }
        };
        let plan = &inverse.plan;
        let arm = Arm::new(self.chain, inverse.clone());
        let mut explanation = Explanation::new(self.chain, plan, &self.notation);
        // A remark about poses where an unknown is free needs such a pose.
        let true_remarks: Vec<bool> = explanation
            .steps
            .iter()
            .map(|s| !s.solution.degenerate.is_empty() && degenerate::is_free(&arm, &explanation, s))
            .collect();
        for (step, stays) in explanation.steps.iter_mut().zip(true_remarks) {
            step.solution.degenerate.retain(|_| stays);
        }
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
        let goal = Math::Letter('G');
        let r = Math::Letter('r').below(Math::Row(vec![Math::Letter('i'), Math::Letter('j')]));
        let [from, to] = explanation.whole();
        let given = Math::equation(self.notation.transform(from, to), goal.clone());
        self.say(Phrase::Wanted, vec![given, r, Math::Letter('p')]);
        self.without_constants(explanation.whole());
        let open = |k| vec![explanation.coordinate(k)];
        match self.chain.settings.task {
            Task::Pose => {}
            Task::Axis => self.say(Phrase::TaskAxis, open(self.chain.dof())),
            Task::Position => self.say(Phrase::TaskPosition, vec![]),
            Task::Planar if axes.coordinates.len() > axes.real => {
                self.say(Phrase::TaskPlanar, open(self.chain.dof()));
            }
            Task::Planar => self.say(Phrase::TaskInPlane, vec![]),
        }
        let definitions = explanation.definitions();
        if !definitions.is_empty() {
            self.say(Phrase::PrimedFrames, vec![]);
            let list = definitions.into_iter().map(|d| {
                let factors = d.factors.iter().map(|f| self.motion(explanation.notation(), f)).collect();
                let left = self.notation.transform(d.from, d.to);
                Equation { left, right: vec![side_by_side(factors)], number: None }
            });
            let list = list.collect();
            self.blocks.push(Block::Equations(list));
        }
        let given: Vec<Math> = self.chain.chosen().iter().map(|(joint, _)| self.coordinate(*joint)).collect();
        if !given.is_empty() {
            self.say(Phrase::Given, vec![Math::list(&given)]);
        }
    }

    /// The transform of the table's frames in terms of the given pose, where there is a base or a tool.
    fn without_constants(&mut self, [from, to]: [Frame; 2]) {
        let n = Frame::Row(self.chain.links.len());
        if [from, to] == [Frame::Row(0), n] {
            return;
        }
        let inverse = |m: Math| m.above(Math::Row(vec![Math::Sign(Sign::Negative), Math::number(1)]));
        let mut product = vec![Math::Letter('G')];
        if from != Frame::Row(0) {
            product.insert(0, inverse(self.notation.transform(from, Frame::Row(0))));
        }
        if to != n {
            product.push(inverse(self.notation.transform(n, to)));
        }
        self.say(Phrase::WithoutBaseAndTool, vec![]);
        self.display(self.notation.transform(Frame::Row(0), n), side_by_side(product));
    }

    /// R_z(theta1), D_x(a2).
    pub(super) fn motion(&self, notation: &crate::render::formula::notation::Notation, motion: &Elementary) -> Math {
        let (letter, axis, argument) = match motion {
            Elementary::Translate(axis, length) => ('D', axis, notation.typeset(&self.group(length))),
            Elementary::Rotate(axis, angle) => {
                let mut row = vec![notation.combination(&angle.terms)];
                if !angle.constant.is_zero() {
                    let (negative, m) = notation.exact_angle(angle.constant.factor());
                    let sign = match (angle.terms.is_empty(), negative) {
                        (true, true) => Some(Sign::Negative),
                        (true, false) => None,
                        (false, true) => Some(Sign::Minus),
                        (false, false) => Some(Sign::Plus),
                    };
                    row.extend(sign.map(Math::Sign));
                    row.push(m);
                }
                ('R', axis, Math::Row(row))
            }
        };
        let name = Math::Letter(letter).below(Math::Letter(['x', 'y', 'z'][axis % 3]));
        Math::Row(vec![name, argument.in_brackets()])
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
            let mut text = Text::fill(self.words(phrase), pieces);
            if let Some(n) = self.number_of_equation(of) {
                let place = text.0.iter().position(|s| *s == Span::Math(of.clone())).map_or(text.0.len(), |i| i + 1);
                text.0.insert(place, Span::Plain(format!(" ({n})")));
            }
            self.blocks.push(Block::Paragraph(text));
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
                // What the equations say already is not said again.
                let same = |a: &(Math, Math), b: &(Math, Math)| {
                    let flat = |m: &Math| m.clone().flatten();
                    flat(&a.0) == flat(&b.0) && flat(&a.1) == flat(&b.1)
                };
                let solved = s.formulas.iter().all(|f| step.equations.iter().any(|e| same(e, f)));
                if !solved {
                    if let Some(why) = step.words.why.filter(|_| self.options.why) {
                        let why = self.options.language.of(why).into();
                        self.blocks.push(Block::Paragraph(why));
                    }
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
