//! The workspace section of the notes: the poses of arms with few joints, the annulus of planar arms.

use super::given;
use super::{Block, Equation, Math, NotesWriter, Phrase, Sign, Span, Text, name};
use crate::algebra::Poly;
use crate::chain::Bound;
use crate::kinematics::Kinematics;
use crate::kinematics::analysis::reach::{self, Length, Planar, TurnAndSlide};
use crate::render::document::frames::{Frame, decimal};
use std::f64::consts::TAU;

impl NotesWriter<'_> {
    pub(super) fn workspace(&mut self, kinematics: &Kinematics) {
        let n = self.chain.dof();
        if n == 0 || super::forward::terms(&kinematics.pose()) > self.options.terms {
            return;
        }
        let planar = reach::planar(self.chain, kinematics);
        if n >= 6 && planar.is_none() {
            return;
        }
        self.heading(1, Phrase::Workspace);
        if n < 6 {
            self.subspace(kinematics);
        }
        if let Some(planar) = planar {
            self.ring(&planar);
        }
    }

    /// Which poses the arm has.
    fn subspace(&mut self, kinematics: &Kinematics) {
        let n = Math::number(self.chain.dof());
        self.say(Phrase::Subspace, vec![n.clone(), n]);
        if let Some(arm) = reach::turn_and_slide(self.chain, kinematics) {
            self.turn_and_slide(kinematics, &arm);
            return;
        }
        let common = reach::common(self.chain, kinematics);
        let mut list: Vec<Equation> = Vec::new();
        // Entries of one value in one line.
        let mut values: Vec<(&Poly, Vec<Math>)> = Vec::new();
        for ((i, j), p) in &common.fixed {
            let named = name(*i, *j, None);
            match values.iter_mut().find(|v| v.0 == p) {
                Some(v) => v.1.push(named),
                None => values.push((p, vec![named])),
            }
        }
        for (p, names) in values {
            let Some((first, others)) = names.split_first() else { continue };
            let value = self.notation.typeset(&self.group(p));
            let right = others.iter().rev().fold(value, |right, n| Math::equation(n.clone(), right));
            list.push(Equation { left: first.clone(), right: vec![right], number: None });
        }
        for ((i, j), (k, l), negative) in &common.same {
            let mut right = vec![name(*k, *l, None)];
            if *negative {
                right.insert(0, Math::Sign(Sign::Negative));
            }
            list.push(self.equation(name(*i, *j, None), Math::Row(right)));
        }
        if !list.is_empty() {
            self.say(Phrase::SubspaceEntries, vec![]);
            self.blocks.push(Block::Equations(list));
        }
    }

    /// The pose of a turning and sliding arm in x and y.
    fn turn_and_slide(&mut self, kinematics: &Kinematics, arm: &TurnAndSlide) {
        let (x, y) = (|| Math::Letter('x'), || Math::Letter('y'));
        let squared = |m: Math| m.above(Math::number(2));
        let sum = || Math::Row(vec![squared(x()), Math::Sign(Sign::Plus), squared(y())]);
        let k = self.notation.typeset(&self.group(&arm.constant));
        let none = arm.constant.is_zero();
        let radicand = if none {
            sum()
        } else {
            let squared = self.notation.typeset(&self.group(&arm.constant.square()));
            Math::Row(vec![sum(), Math::Sign(Sign::Minus), squared])
        };
        let root = Math::Root(Box::new(radicand));
        // D = root: the slide.
        let slide = self.notation.symbol(arm.slide);
        let mut right = vec![root.clone()];
        if !arm.shift.is_zero() {
            let shift = self.notation.typeset(&self.group(&arm.shift));
            right.extend([Math::Sign(Sign::Minus), shift.in_brackets()]);
        }
        if arm.negative {
            right = vec![Math::Sign(Sign::Negative), Math::Row(right).in_brackets()];
            if arm.shift.is_zero() {
                right = vec![Math::Sign(Sign::Negative), root.clone()];
            }
        }
        let d = Math::Row(right);
        let over = |top: Math| Math::Fraction(Box::new(top), Box::new(if none { root.clone() } else { sum() }));
        let minus = |m: Math| Math::Row(vec![Math::Sign(Sign::Negative), m]);
        // c = (A x + B y) / r^2, s = (A y - B x) / r^2
        let (mut c, mut s, mut minus_s);
        let minus_c;
        if none {
            (c, s) = if arm.along { (over(x()), over(y())) } else { (over(y()), minus(over(x()))) };
            (minus_c, minus_s) =
                if arm.along { (minus(over(x())), minus(over(y()))) } else { (minus(over(y())), over(x())) };
        } else {
            let row =
                |a: Math, p: Math, sign: Sign, b: Math, q: Math| over(Math::Row(vec![p, a, Math::Sign(sign), q, b]));
            let r = root.clone();
            (c, s) = if arm.along {
                (row(r.clone(), x(), Sign::Plus, y(), k.clone()), row(r, y(), Sign::Minus, x(), k.clone()))
            } else {
                (row(x(), k.clone(), Sign::Plus, r.clone(), y()), row(y(), k.clone(), Sign::Minus, r, x()))
            };
            (minus_c, minus_s) = (minus(c.clone()), minus(s.clone()));
        }
        let trig = |sine: bool| crate::render::formula::expression::Trig { angles: vec![(arm.angle, 1)], sine };
        let names = [self.notation.trig(&trig(false)), self.notation.trig(&trig(true))];
        let list = vec![
            self.equation(slide, d),
            self.equation(names[0].clone(), c.clone()),
            self.equation(names[1].clone(), s.clone()),
        ];
        self.say(Phrase::SubspaceTurn, vec![x(), y()]);
        self.blocks.push(Block::Equations(list));
        if !none {
            // Fractions of this size stay names in the matrix.
            (c, s) = (names[0].clone(), names[1].clone());
            minus_s = minus(names[1].clone());
        }
        let minus_c = if none { minus_c } else { minus(names[0].clone()) };
        let pose = kinematics.pose();
        let (cosine, sine) = Poly::cos_sin(arm.angle);
        let (less_cosine, less_sine) = (-&cosine, -&sine);
        let entry = |i: usize, j: usize| -> Math {
            let p = pose.entry(i, j);
            match (i, j) {
                (0, 3) => x(),
                (1, 3) => y(),
                _ if p == cosine => c.clone(),
                _ if p == sine => s.clone(),
                _ if p == less_cosine => minus_c.clone(),
                _ if p == less_sine => minus_s.clone(),
                _ => self.notation.typeset(&self.group(&p)),
            }
        };
        let mut rows: Vec<Vec<Math>> = (0..3).map(|i| (0..4).map(|j| entry(i, j)).collect()).collect();
        rows.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        let from = if self.chain.base.is_empty() { Frame::Row(0) } else { Frame::Base };
        let to = if self.chain.tool.is_empty() { Frame::Row(self.chain.links.len()) } else { Frame::Tool };
        self.say(Phrase::SubspaceMatrix, vec![]);
        self.display(self.notation.transform(from, to), Math::Matrix(rows));
    }

    /// The ring that a planar arm reaches, and where its last link can point anywhere.
    fn ring(&mut self, arm: &Planar) {
        let n = arm.links.len();
        let names: Vec<Math> = arm.links.iter().map(|l| self.link_length(l)).collect();
        let all: Vec<usize> = (0..n).filter(|i| arm.links.get(*i).is_some_and(|l| !l.square.is_zero())).collect();
        let lengths: Vec<Math> = all.iter().filter_map(|i| names.get(*i).cloned()).collect();
        let values: Option<Vec<f64>> = arm.links.iter().map(|l| self.nominal(&l.square).map(f64::sqrt)).collect();
        let mut text = Text::default();
        for (i, words) in self.words(Phrase::RingLinks).split("{}").enumerate() {
            if i > 0 {
                text.0.extend(super::inverse::listed(&lengths));
            }
            text.0.push(Span::Plain(words.to_string()));
        }
        self.blocks.push(Block::Paragraph(text));
        let rho = Math::Letter('ρ');
        self.say(Phrase::RingReach, vec![rho.clone()]);
        let (outer, inner) = self.bounds(&names, values.as_deref(), &all);
        let mut list = vec![
            self.equation(Math::word("max").clone(), outer.clone()),
            self.equation(Math::word("min"), inner.clone()),
        ];
        for (e, letter) in list.iter_mut().zip(["max", "min"]) {
            e.left = rho.clone().below(Math::word(letter));
        }
        self.blocks.push(Block::Equations(list));
        if all.len() == 2 {
            self.say(Phrase::RingTwo, vec![]);
        }
        self.dexterous(arm, &names, values.as_deref());
        self.limits(arm, values.as_deref(), &all);
    }

    /// Outer and inner radius of these links.
    fn bounds(&self, names: &[Math], values: Option<&[f64]>, links: &[usize]) -> (Math, Math) {
        let named = |i: &usize| names.get(*i).cloned().unwrap_or(Math::number(0));
        let value = |i: &usize| values.and_then(|v| v.get(*i)).copied();
        let sum = |list: &[usize], first: Option<usize>| {
            let mut row = Vec::new();
            for i in first.iter().chain(list) {
                if !row.is_empty() {
                    row.push(Math::Sign(if first.is_some() { Sign::Minus } else { Sign::Plus }));
                }
                row.push(named(i));
            }
            Math::Row(row)
        };
        let with_value = |m: Math, x: Option<f64>| match x {
            Some(x) => Math::equation(m, self.length_value(x)),
            None => m,
        };
        let total: Option<f64> = links.iter().map(value).sum();
        let outer = with_value(sum(links, None), total);
        let longest = links.iter().copied().max_by(|a, b| {
            let x = |i: &usize| value(i).unwrap_or(0.0);
            x(a).total_cmp(&x(b)).then(b.cmp(a))
        });
        let (Some(longest), Some(total)) = (longest.filter(|i| value(i).is_some()), total) else {
            let inner = match links {
                [] => Math::number(0),
                [only] => named(only),
                [_, _] => between_bars(sum(links.get(1..).unwrap_or(&[]), links.first().copied())),
                more => {
                    let twice: Vec<Math> = more.iter().map(|i| Math::Row(vec![Math::number(2), named(i)])).collect();
                    let most = Math::call("max", twice);
                    let outer = Math::Letter('ρ').below(Math::word("max"));
                    let difference = Math::Row(vec![most, Math::Sign(Sign::Minus), outer]);
                    Math::call("max", vec![Math::number(0), difference])
                }
            };
            return (outer, inner);
        };
        let least = 2.0 * value(&longest).unwrap_or(0.0) - total;
        let inner = match links {
            _ if least <= 1e-12 * total => Math::number(0),
            [first, rest @ ..] if rest.len() == 1 => with_value(between_bars(sum(rest, Some(*first))), Some(least)),
            _ => {
                let others: Vec<usize> = links.iter().copied().filter(|i| *i != longest).collect();
                with_value(sum(&others, Some(longest)), Some(least))
            }
        };
        (outer, inner)
    }

    fn length_value(&self, x: f64) -> Math {
        let rounded = format!("{x:.6}");
        let short = rounded.trim_end_matches('0').trim_end_matches('.');
        Math::number(short)
    }

    fn link_length(&self, l: &Length) -> Math {
        match &l.plain {
            Some(p) => {
                let m = self.notation.typeset(&self.group(p));
                let negative = self.nominal(p).is_some_and(|x| x < 0.0);
                if negative { between_bars(m) } else { m }
            }
            None => Math::Root(Box::new(self.notation.typeset(&self.group(&l.square)))),
        }
    }

    /// Where the last link can point in every direction.
    fn dexterous(&mut self, arm: &Planar, names: &[Math], values: Option<&[f64]>) {
        let Some((last, before)) = arm.links.split_last() else { return };
        let index: Vec<usize> =
            (0..before.len()).filter(|i| before.get(*i).is_some_and(|l| !l.square.is_zero())).collect();
        if last.square.is_zero() {
            self.say(Phrase::DexterousAll, vec![]);
            return;
        }
        let name = names.last().cloned().unwrap_or(Math::number(0));
        if index.len() == 1 {
            // One link before: a circle about the point lies on a circle only where both are the same.
            let one = index.first().and_then(|i| names.get(*i)).cloned().unwrap_or(Math::number(0));
            let same = values.and_then(|v| Some((v.get(*index.first()?)?, v.last()?)));
            match same {
                Some((a, b)) if (a - b).abs() < 1e-12 * (a + b) => self.say(Phrase::DexterousPoint, vec![]),
                Some(_) => self.say(Phrase::DexterousNone, vec![one, name]),
                None => self.say(Phrase::DexterousTwo, vec![one, name]),
            }
            return;
        }
        let (outer, inner) = self.bounds(names, values, &index);
        let (big, small) = (Math::Letter('R'), Math::Letter('r'));
        self.say(Phrase::Dexterous, vec![]);
        let list = vec![self.equation(big.clone(), outer), self.equation(small.clone(), inner)];
        self.blocks.push(Block::Equations(list));
        let rho = || Math::Letter('ρ');
        let less = |a: Math, b: Math| Math::Row(vec![a, Math::Sign(Sign::AtMost), b]);
        let plus = |a: Math, sign: Sign, b: Math| Math::Row(vec![a, Math::Sign(sign), b]);
        let first = less(rho(), plus(big, Sign::Minus, name.clone()));
        let second = less(plus(small.clone(), Sign::Plus, name.clone()), rho());
        let third = less(rho(), plus(name, Sign::Minus, small));
        self.say(Phrase::DexterousWhere, vec![first, second, third]);
        let Some(v) = values else { return };
        let value = |i: &usize| v.get(*i).copied().unwrap_or(0.0);
        let total: f64 = index.iter().map(value).sum();
        let longest = index.iter().map(value).fold(0.0, f64::max);
        let (big, small) = (total, (2.0 * longest - total).max(0.0));
        let last = v.last().copied().unwrap_or(0.0);
        // The ring from small + last to big - last, and the disc of radius last - small.
        let (from, to, disc) = (small + last, big - last, last - small);
        let mut parts = Vec::new();
        if from <= to && disc < from {
            let range = [from, to].map(|x| self.length_value(x));
            let [from, to] = range;
            parts.push(Math::Row(vec![from, Math::Sign(Sign::AtMost), rho(), Math::Sign(Sign::AtMost), to]));
        }
        if disc >= 0.0 && to >= 0.0 {
            let least = if disc >= from { to } else { disc.min(to) };
            parts.push(less(rho(), self.length_value(least)));
        }
        match parts.len() {
            0 => self.say(Phrase::DexterousEmpty, vec![]),
            1 => self.say(Phrase::DexterousNumbers, parts),
            _ => self.say(Phrase::DexterousNumbersTwo, parts),
        }
    }

    /// What the joint ranges leave.
    fn limits(&mut self, arm: &Planar, values: Option<&[f64]>, links: &[usize]) {
        let range = |k: &usize| {
            let (low, high) = self.chain.joints.get(*k)?.range.as_ref()?;
            let free = match (low, high) {
                (Bound::HalfTurns(_) | Bound::Radians(_), _) => given::bound(high) - given::bound(low) >= TAU - 1e-9,
                _ => false,
            };
            (!free).then_some((given::bound(low), given::bound(high)))
        };
        let limited: Vec<Math> =
            arm.turning.iter().filter(|k| range(k).is_some()).map(|k| Math::number(k + 1)).collect();
        if !limited.is_empty() {
            let mut pieces = Vec::new();
            for (i, words) in self.words(Phrase::RingLimited).split("{}").enumerate() {
                if i > 0 {
                    pieces.extend(super::inverse::listed(&limited));
                }
                pieces.push(Span::Plain(words.to_string()));
            }
            self.blocks.push(Block::Paragraph(Text(pieces)));
        }
        // Two links: the distance depends on the elbow alone.
        let elbow = arm.turning.get(1).and_then(range).filter(|_| links == [0, 1] && self.chain.is_direct());
        if let (Some((low, high)), Some([a, b, ..])) = (elbow, values) {
            let at = |t: f64| (a * a + b * b + 2.0 * a * b * t.cos()).max(0.0).sqrt();
            let crosses = |t: f64| {
                let turns = ((low - t) / TAU).ceil();
                t + turns * TAU <= high
            };
            let (x, y) = (at(low), at(high));
            let most = if crosses(0.0) { a + b } else { x.max(y) };
            let least = if crosses(TAU / 2.0) { (a - b).abs() } else { x.min(y) };
            let numbers = [least, most].map(|x| decimal(x, 4)).to_vec();
            self.say(Phrase::RingElbow, numbers);
        }
        for k in &arm.sliding {
            let Some((low, high)) = self.chain.joints.get(*k).and_then(|j| j.range.as_ref()) else { continue };
            let list = vec![Math::number(k + 1), self.length_value(given::bound(high) - given::bound(low))];
            self.say(Phrase::RingHeight, list);
        }
    }
}

/// |m|.
fn between_bars(m: Math) -> Math {
    Math::Row(vec![Math::Open('|'), m, Math::Close('|')])
}
