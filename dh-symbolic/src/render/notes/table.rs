//! The table, the values of its parameters, the coupling of the motors.

use super::{Block, Equation, Math, Phrase, Sign, Span, Text, Writer};
use crate::algebra::{Angle, LinearAngle, Poly, Rational};
use crate::chain::{AngleCell, Bound, Convention, Coordinate, Elementary, Handle, Link, Parameter, Role, Value};
use crate::render::notation::Notation;
use crate::render::typeset::{decimal, number};

impl Writer<'_> {
    pub(super) fn table(&mut self) {
        self.heading(1, Phrase::Parameters);
        let i = || Math::Letter('i');
        let of = |letter: char, index: Math| Math::Letter(letter).below(index);
        let before = || Math::Row(vec![i(), Math::Sign(Sign::Minus), Math::number(1)]);
        let after = Math::Row(vec![i(), Math::Sign(Sign::Plus), Math::number(1)]);
        let mut header: Vec<Math> = match self.chain.convention {
            Convention::Modified => {
                self.say(Phrase::Modified, vec![i(), i(), i()]);
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
    fn angle(&self, angle: &LinearAngle) -> Math {
        let mut row = vec![self.notation.combination(&angle.terms)];
        let degrees = angle.constant.to_degrees();
        if !angle.constant.is_zero() {
            row.push(Math::Sign(match (degrees.is_negative(), angle.terms.is_empty()) {
                (true, true) => Sign::Negative,
                (true, false) => Sign::Minus,
                (false, true) => Sign::Thin,
                (false, false) => Sign::Plus,
            }));
            row.push(number(&degrees.abs()));
            row.push(Math::Sign(Sign::Degree));
        } else if angle.terms.is_empty() {
            row.push(Math::number(0));
        }
        Math::Row(row.into_iter().filter(|m| *m != Math::Sign(Sign::Thin)).collect())
    }

    fn range(&self, link: &Link) -> Text {
        let Some(joint) = link.joint.and_then(|j| self.chain.joints.get(j)) else {
            return self.words(Phrase::Fixed).into();
        };
        let Some((low, high)) = &joint.range else { return Text::default() };
        Math::Row(vec![Math::Open('['), bound(low), Math::Sign(Sign::Comma), bound(high), Math::Close(']')]).into()
    }

    /// Nominal values, by kind.
    fn values(&mut self) {
        let mut lengths = Vec::new();
        let mut angles = Vec::new();
        let mut free = Vec::new();
        for p in self.chain.parameters.iter().filter(|p| self.is_used(p)) {
            let name = self.parameter(p);
            match value(p) {
                Some(v) => {
                    let list = if matches!(p.handle, Handle::Length(_)) { &mut lengths } else { &mut angles };
                    list.push(Math::equation(name, v));
                }
                None => free.push(name),
            }
        }
        for (phrase, list) in [(Phrase::Lengths, lengths), (Phrase::Angles, angles), (Phrase::Free, free)] {
            if !list.is_empty() {
                let unit = Span::Plain(self.chain.unit.name.to_string());
                let mut text = Text::fill(self.words(phrase), vec![unit]);
                text.0.extend(Text::join(list.into_iter().map(Text::from), ", ").0);
                self.blocks.push(Block::Paragraph(text));
            }
        }
    }

    fn parameter(&self, p: &Parameter) -> Math {
        match p.handle {
            Handle::Length(s) => self.notation.symbol(s),
            Handle::Angle(v) => self.notation.angle(v),
        }
    }

    /// Joint coordinates as functions of the motors, where they are not the same.
    fn coupling(&mut self) {
        let mut ring = self.chain.ring.clone();
        let motors: Vec<Poly> = (1..=self.chain.dof()).map(|k| Poly::symbol(ring.symbol(&format!("q{k}")))).collect();
        let notation = Notation::of_ring(&ring);
        let mut list = Vec::new();
        for (k, (joint, line)) in self.chain.joints.iter().zip(&self.chain.drive).enumerate() {
            let direct = line.iter().enumerate().all(|(j, p)| if j == k { p.is_one() } else { p.is_zero() });
            if direct && joint.shift.is_zero() {
                continue;
            }
            let left = match joint.coordinate {
                Coordinate::Angle(v) => self.notation.angle(v),
                Coordinate::Length(s) => self.notation.symbol(s),
            };
            let moving: Poly = line.iter().zip(&motors).map(|(p, q)| p * q).sum();
            let mut row = vec![notation.typeset(&self.group(&moving))];
            shift(&joint.shift, self, &mut row);
            list.push((left, Math::Row(row)));
        }
        if !list.is_empty() {
            self.say(Phrase::Coupled, vec![]);
            let list: Vec<Equation> = list.into_iter().map(|(left, right)| self.equation(left, right)).collect();
            self.blocks.push(Block::Equations(list));
        }
    }

    /// Does the parameter occur in the robot's formulas?
    fn is_used(&self, p: &Parameter) -> bool {
        let chain = self.chain;
        let moves = || chain.base.iter().chain(&chain.tool).cloned();
        let mut factors = (0..chain.links.len()).flat_map(|i| chain.link_factors(i)).chain(moves());
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
}

fn push_sign(row: &mut Vec<Math>, negative: bool) {
    match (row.is_empty(), negative) {
        (true, true) => row.push(Math::Sign(Sign::Negative)),
        (true, false) => {}
        (false, true) => row.push(Math::Sign(Sign::Minus)),
        (false, false) => row.push(Math::Sign(Sign::Plus)),
    }
}

/// Appends the constant of a joint angle.
fn shift(cell: &AngleCell, w: &Writer<'_>, row: &mut Vec<Math>) {
    for (i, k) in &cell.symbols {
        if let Some(p) = w.chain.parameters.get(*i) {
            push_sign(row, *k < 0);
            if k.unsigned_abs() != 1 {
                row.push(Math::number(k.unsigned_abs()));
            }
            row.push(w.parameter(p));
        }
    }
    let number = AngleCell { symbols: Vec::new(), ..cell.clone() };
    if !number.is_zero() {
        let (negative, value) = constant_angle(&number);
        push_sign(row, negative);
        row.push(value);
    }
}

/// A length or angle with its sign, as typeset.
fn value(p: &Parameter) -> Option<Math> {
    let value = match &p.role {
        Role::Field(v) => v.as_ref()?,
        Role::Constant(v) => v,
    };
    let (negative, m) = match value {
        Value::Length(x) => (x.is_negative(), length(&x.abs())),
        Value::Angle(cell) => constant_angle(cell),
    };
    Some(if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m })
}

/// Sign and magnitude of an angle without declared angles: degrees where it is exact, else radians.
fn constant_angle(cell: &AngleCell) -> (bool, Math) {
    match &cell.approx {
        None => degrees(&cell.exact()),
        Some(x) if cell.exact().is_zero() => radians(x),
        Some(_) => {
            let x = cell.radians();
            (x < 0.0, Math::Row(vec![Math::number(x.abs()), Math::Sign(Sign::Thin), Math::word("rad")]))
        }
    }
}

/// Digits, where the number has finitely many.
fn length(x: &Rational) -> Math {
    decimal(x).map_or_else(|| number(x), Math::Number)
}

fn degrees(angle: &Angle) -> (bool, Math) {
    let x = angle.to_degrees();
    (x.is_negative(), Math::Row(vec![number(&x.abs()), Math::Sign(Sign::Degree)]))
}

fn radians(x: &Rational) -> (bool, Math) {
    let digits = decimal(&x.abs()).map_or_else(|| number(&x.abs()), Math::Number);
    (x.is_negative(), Math::Row(vec![digits, Math::Sign(Sign::Thin), Math::word("rad")]))
}

fn bound(b: &Bound) -> Math {
    let (negative, m) = match b {
        Bound::HalfTurns(x) => degrees(&Angle::half_turns(x.clone())),
        Bound::Radians(x) => radians(x),
        Bound::Length(x) => (x.is_negative(), length(&x.abs())),
    };
    if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m }
}
