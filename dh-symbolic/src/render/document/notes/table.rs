//! The table, the values of its parameters, the coupling of the actuators.

use super::{Block, Equation, Math, NotesWriter, Phrase, Sign, Span, Text};
use crate::algebra::LinearAngle;
use crate::chain::{Bound, Chain, Convention, Elementary, Handle, Link, Parameter};
use crate::render::formula::notation::Notation;
use crate::render::formula::quantities::{length, parameter, radians, relations, value};

impl NotesWriter<'_> {
    pub(super) fn table(&mut self) {
        self.heading(1, Phrase::Parameters);
        let i = || Math::Letter('i');
        let of = |letter: char, index: Math| Math::Letter(letter).below(index);
        let before = || Math::Row(vec![i(), Math::Sign(Sign::Minus), Math::number(1)]);
        let after = Math::Row(vec![i(), Math::Sign(Sign::Plus), Math::number(1)]);
        let mut header: Vec<Math> = match self.chain.convention {
            Convention::Modified => {
                self.say(Phrase::Modified, vec![i(), i(), i(), before(), of('α', before()), of('a', before())]);
                vec![of('α', before()), of('a', before()), of('d', i()), of('θ', i())]
            }
            Convention::Standard => {
                self.say(Phrase::Standard, vec![i(), i(), after]);
                vec![of('θ', i()), of('d', i()), of('a', i()), of('α', i())]
            }
        };
        header.insert(0, i());
        let mut header: Vec<Text> = header.into_iter().map(Text::from).collect();
        let ranges = self.chain.joints.iter().any(|j| j.range.is_some());
        if ranges {
            header.push(self.words(Phrase::Range).into());
        }
        let rows = self
            .chain
            .links
            .iter()
            .enumerate()
            .map(|(k, link)| {
                let mut row: Vec<Text> = vec![Math::number(k + 1).into()];
                row.extend(self.cells(link).into_iter().map(Text::from));
                if ranges {
                    row.push(self.range(link));
                }
                row
            })
            .collect();
        self.blocks.push(Block::Table(header, rows));
        self.values();
        self.coupling();
    }

    fn cells(&self, link: &Link) -> [Math; 4] {
        let length = |p| self.notation.typeset(&self.group(p));
        let [alpha, a, d, theta] = [self.angle(&link.alpha), length(&link.a), length(&link.d), self.angle(&link.theta)];
        match self.chain.convention {
            Convention::Modified => [alpha, a, d, theta],
            Convention::Standard => [theta, d, a, alpha],
        }
    }

    /// theta2 - 90 degrees.
    pub(super) fn angle(&self, angle: &LinearAngle) -> Math {
        let mut row = vec![self.notation.combination(&angle.terms)];
        if !angle.constant.is_zero() {
            let (negative, value) = self.notation.exact_angle(angle.constant.factor());
            row.push(Math::Sign(match (negative, angle.terms.is_empty()) {
                (true, true) => Sign::Negative,
                (true, false) => Sign::Minus,
                (false, true) => Sign::Thin,
                (false, false) => Sign::Plus,
            }));
            row.push(value);
        } else if angle.terms.is_empty() {
            row.push(Math::number(0));
        }
        let empty = |m: &Math| *m == Math::Sign(Sign::Thin) || *m == Math::Row(vec![]);
        row.retain(|m| !empty(m));
        if row.len() == 1 { row.remove(0) } else { Math::Row(row) }
    }

    fn range(&self, link: &Link) -> Text {
        let Some(joint) = link.joint.and_then(|j| self.chain.joints.get(j)) else {
            return self.words(Phrase::Fixed).into();
        };
        let Some((low, high)) = &joint.range else { return Text::default() };
        let range = Math::Row(vec![
            Math::Open('['),
            bound(&self.notation, low),
            Math::Sign(Sign::Comma),
            bound(&self.notation, high),
            Math::Close(']'),
        ]);
        let mut text = Text::from(range);
        if matches!((low, high), (Bound::Length(_), _) | (_, Bound::Length(_))) {
            text.0.push(Span::Plain(format!(" {}", self.chain.settings.unit.name)));
        }
        text
    }

    /// Nominal values, by kind.
    fn values(&mut self) {
        let mut lengths = Vec::new();
        let mut angles = Vec::new();
        let mut free = Vec::new();
        for p in self.chain.parameters.iter().filter(|p| is_used(self.chain, p)) {
            let name = parameter(&self.notation, p);
            match value(&self.notation, p) {
                Some(v) => {
                    let list = if matches!(p.handle, Handle::Length(_)) { &mut lengths } else { &mut angles };
                    list.push(Math::equation(name, v));
                }
                None => free.push(name),
            }
        }
        for (phrase, list) in [(Phrase::Lengths, lengths), (Phrase::Angles, angles), (Phrase::Free, free)] {
            if !list.is_empty() {
                let unit = Span::Plain(self.chain.settings.unit.name.to_string());
                let mut text = Text::fill(self.words(phrase), vec![unit]);
                text.0.extend(Text::join(list.into_iter().map(Text::from), ", ").0);
                self.blocks.push(Block::Paragraph(text));
            }
        }
    }

    /// Joint coordinates as functions of the actuators, where they are not the same.
    fn coupling(&mut self) {
        let relations = relations(self.chain, &self.notation, &self.order);
        if !relations.is_empty() {
            self.say(Phrase::Coupled, vec![]);
            let list: Vec<Equation> = relations.into_iter().map(|(left, right)| self.equation(left, right)).collect();
            self.blocks.push(Block::Equations(list));
        }
    }
}

/// Does the parameter occur in the robot's formulas?
pub(super) fn is_used(chain: &Chain, p: &Parameter) -> bool {
    let constant = chain.base.iter().chain(&chain.tool).cloned();
    let mut factors = (0..chain.links.len()).flat_map(|i| chain.link_factors(i)).chain(constant);
    match p.handle {
        Handle::Length(s) => {
            factors.any(|e| matches!(e, Elementary::Translate(_, l) if l.has_symbol(s)))
                || chain.drive.iter().flatten().any(|l| l.has_symbol(s))
        }
        Handle::Angle(v) => {
            let place = chain.parameters.iter().position(|x| x.handle == p.handle);
            factors.any(|e| matches!(e, Elementary::Rotate(_, a) if a.terms.iter().any(|(w, _)| *w == v)))
                || chain.joints.iter().any(|j| j.shift.symbols.iter().any(|(i, _)| Some(*i) == place))
        }
    }
}

/// A bound of a range, as typeset.
fn bound(notation: &Notation, b: &Bound) -> Math {
    let (negative, m) = match b {
        Bound::HalfTurns(x) => notation.exact_angle(x),
        Bound::Radians(x) => radians(x),
        Bound::Length(x) => (x.is_negative(), length(&x.abs())),
    };
    if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m }
}
