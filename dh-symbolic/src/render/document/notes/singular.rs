//! Singular configurations: the determinant of the Jacobian, derived block by block, and what each factor says.

use super::{Block, Equation, Math, NotesWriter, Phrase, Sign, Span, Text, row_width};
use crate::algebra::{AngleVar, Factor as Atom, Poly};
use crate::chain::{Coordinate, Handle, Role};
use crate::kinematics::Kinematics;
use crate::kinematics::analysis::singular::{
    self, Degeneracy, Determinant, DeterminantFactor, Open, ReferenceFrame, Region, Singular, singular,
};

/// A factor with more terms than this gets a name.
const LONGEST: usize = 24;

impl NotesWriter<'_> {
    pub(super) fn singular(&mut self, kinematics: &Kinematics) {
        let n = self.chain.dof();
        if n == 0 || super::forward::terms(&kinematics.pose()) > self.options.terms {
            return;
        }
        self.heading(1, Phrase::Singular);
        let held: Vec<Math> = self.chain.chosen().iter().map(|(joint, _)| self.coordinate(*joint)).collect();
        match held.as_slice() {
            [] => {}
            [one] => self.say(Phrase::SingularHeld, vec![one.clone()]),
            all => self.say(Phrase::SingularAllHeld, vec![Math::list(all)]),
        }
        match singular(self.chain, kinematics) {
            Singular::Determinant(d) => self.determinant(&d),
            Singular::Everywhere => self.say(Phrase::SingularEverywhere, vec![]),
            Singular::TooLong(size) => self.say(Phrase::SingularTooLong, vec![Math::number(size)]),
            Singular::NotSquare if n > 6 => self.say(Phrase::SingularWide, vec![Math::number(n)]),
            Singular::NotSquare => self.say(Phrase::SingularTall, vec![Math::number(n)]),
            Singular::Gram(value, positive) => {
                self.say(Phrase::SingularGram, vec![Math::number(n)]);
                let j = || Math::Letter('J');
                let product = Math::Row(vec![j().above(Math::word("T")), Math::Sign(Sign::Thin), j()]);
                let left = Math::call("det", vec![product]);
                let right = self.notation.typeset(&self.group(&value));
                self.display(left, right);
                self.say(if positive { Phrase::SingularNever } else { Phrase::SingularGramWhere }, vec![]);
            }
        }
    }

    /// A joint's variable.
    pub(super) fn coordinate(&self, joint: usize) -> Math {
        match self.chain.joints.get(joint).map(|j| j.coordinate) {
            Some(Coordinate::Angle(v)) => self.notation.angle(v),
            Some(Coordinate::Length(s)) => self.notation.symbol(s),
            None => Math::number(0),
        }
    }

    fn determinant(&mut self, d: &Determinant) {
        let counted = self.counted(d);
        if let Some(text) = counted {
            self.blocks.push(Block::Paragraph(text));
        }
        let place = |s: ReferenceFrame| Span::Plain(self.stand(s));
        let text =
            Text::fill(self.words(Phrase::SingularWritten), vec![place(d.point), place(d.linear), place(d.angular)]);
        self.blocks.push(Block::Paragraph(text));
        let (rows, columns) = shown(d);
        self.blocks_of(d, &rows, &columns);
        self.whole(d);
        self.zeros(d);
        if let Some(value) = singular::coupling(self.chain).filter(|p| !p.is_one()) {
            let factor = self.notation.typeset(&self.group(&value));
            self.say(Phrase::SingularMotors, vec![factor]);
        }
    }

    /// Which motions count, where it is not all six.
    fn counted(&self, d: &Determinant) -> Option<Text> {
        if d.open.is_empty() {
            return None;
        }
        if d.open == [Open::Roll] {
            return Some(Text::from(self.words(Phrase::SingularAxis)));
        }
        let axes = ["x", "y", "z"];
        let counts = |o: &Open| !d.open.contains(o);
        let list = |make: fn(usize) -> Open| -> Vec<Span> {
            let kept: Vec<Math> = (0..3)
                .filter(|k| counts(&make(*k)))
                .map(|k| Math::Letter(axes[k].chars().next().unwrap_or('x')))
                .collect();
            super::inverse::listed(&kept)
        };
        let (prismatic, revolute) = (list(Open::Translation), list(Open::Rotation));
        let phrase = match (prismatic.is_empty(), revolute.is_empty()) {
            (false, false) => Phrase::SingularOnly,
            (false, true) => Phrase::SingularOnlySlides,
            _ => Phrase::SingularOnlyTurns,
        };
        let mut lists = [prismatic, revolute].into_iter().filter(|l| !l.is_empty());
        let mut out = Vec::new();
        for (i, words) in self.words(phrase).split("{}").enumerate() {
            if i > 0 {
                out.extend(lists.next().unwrap_or_default());
            }
            if !words.is_empty() {
                out.push(Span::Plain(words.to_string()));
            }
        }
        Some(Text(out))
    }

    /// "frame 4", "the tool".
    fn stand(&self, s: ReferenceFrame) -> String {
        let number = |i: usize| self.words(Phrase::Frame).replace("{}", &i.to_string());
        match s {
            ReferenceFrame::Link(i) => number(i),
            ReferenceFrame::Tool if self.chain.tool.is_empty() => number(self.chain.links.len()),
            ReferenceFrame::Base if self.chain.base.is_empty() => number(0),
            ReferenceFrame::Tool => self.words(Phrase::FrameOfTool).to_string(),
            ReferenceFrame::Base => self.words(Phrase::FrameOfBase).to_string(),
        }
    }

    /// The matrix with its zeros, and the determinants of its larger blocks.
    fn blocks_of(&mut self, d: &Determinant, rows: &[usize], columns: &[usize]) {
        let entry = |r: usize, c: usize| d.columns.get(c).map_or_else(Poly::zero, |x| x[r].clone());
        let inside = |r: usize, c: usize| d.blocks.iter().any(|b| b.rows.contains(&r) && b.columns.contains(&c));
        let mut star = false;
        let mut cells: Vec<Vec<Math>> = Vec::new();
        for r in rows {
            let mut row = Vec::new();
            for c in columns {
                let p = entry(*r, *c);
                row.push(if p.is_zero() || inside(*r, *c) {
                    self.notation.typeset(&self.group(&p))
                } else {
                    star = true;
                    Math::Letter('∗')
                });
            }
            cells.push(row);
        }
        let wide = row_width(&cells) > self.options.width;
        if wide {
            // Entries of large blocks get names.
            for (row, r) in cells.iter_mut().zip(rows) {
                for (cell, c) in row.iter_mut().zip(columns) {
                    let large =
                        d.blocks.iter().any(|b| b.rows.len() > 1 && b.rows.contains(r) && b.columns.contains(c));
                    if large && !entry(*r, *c).is_zero() {
                        *cell = Math::Letter('m').below(Math::number(format!("{}{}", r + 1, c + 1)));
                    }
                }
            }
        }
        self.display(Math::Letter('M'), Math::Matrix(cells));
        if star {
            self.say(Phrase::SingularStars, vec![Math::Letter('∗')]);
        } else if d.blocks.len() > 1 {
            self.say(Phrase::SingularBlocks, vec![]);
        }
        let large = d.blocks.iter().filter(|b| b.rows.len() > 1 && b.columns.iter().all(|c| columns.contains(c)));
        let mut list: Vec<Equation> = Vec::new();
        for b in large {
            let m: Vec<Vec<Math>> = b
                .rows
                .iter()
                .map(|r| b.columns.iter().map(|c| self.notation.typeset(&self.group(&entry(*r, *c)))).collect())
                .collect();
            let value = singular::minor(d, b);
            let short = value.terms().len() <= LONGEST;
            let fits = row_width(&m) <= self.options.width;
            if fits && short {
                let left = Math::Row(vec![Math::word("det"), Math::Sign(Sign::Thin), Math::Matrix(m)]);
                list.push(self.equation(left, self.factored(&value)));
            }
        }
        if !list.is_empty() {
            self.blocks.push(Block::Equations(list));
        }
    }

    /// A formula as a product of its factors.
    fn factored(&self, p: &Poly) -> Math {
        let (number, list) = p.factors();
        let list: Vec<DeterminantFactor> = list
            .into_iter()
            .map(|(value, power)| DeterminantFactor { value, power, moves: false, meaning: None })
            .collect();
        self.multiplied(&number, &list, &[]).0
    }

    /// number * factor * factor ..., long factors by name: their names and indices.
    fn multiplied(
        &self,
        number: &crate::algebra::Rational,
        factors: &[DeterminantFactor],
        long: &[usize],
    ) -> (Math, Vec<(Math, usize)>) {
        use crate::render::formula::expression::{Expression, Summand};
        let mut names = Vec::new();
        let mut parts: Vec<Expression> = Vec::new();
        if !number.abs().is_one() {
            parts.push(Expression::Number(number.abs()));
        }
        let mut negative = number.is_negative();
        let mut tail = Vec::new();
        for (i, f) in factors.iter().enumerate() {
            if long.contains(&i) {
                let name = match long.len() {
                    1 => Math::Letter('Δ'),
                    _ => Math::Letter('Δ').below(Math::number(names.len() + 1)),
                };
                tail.push(if f.power == 1 { name.clone() } else { name.clone().above(Math::number(f.power)) });
                names.push((name, i));
                continue;
            }
            let mut value = self.group(&f.value);
            // One summand with a minus: the sign goes to the front.
            if let Expression::Sum(list) = &value
                && let [Summand { negative: true, value: inner }] = list.as_slice()
            {
                negative ^= f.power % 2 == 1;
                value = inner.clone();
            }
            match (value, f.power) {
                (Expression::Product(list), 1) => parts.extend(list),
                (value, 1) => parts.push(value),
                (value, n) => parts.push(Expression::Power(Box::new(value), n)),
            }
        }
        let product = match (parts.len(), tail.is_empty()) {
            (0, true) => Expression::Number(number.abs()),
            (1, _) => parts.remove(0),
            _ => Expression::Product(parts),
        };
        let mut row = Vec::new();
        if negative {
            row.push(Math::Sign(Sign::Negative));
        }
        if !matches!(&product, Expression::Product(list) if list.is_empty()) {
            let bare = product.needs_brackets() && (negative || !tail.is_empty());
            let typeset = self.notation.typeset(&product);
            row.push(if bare { typeset.in_brackets() } else { typeset });
        }
        row.extend(tail);
        (Math::Row(row), names)
    }

    fn whole(&mut self, d: &Determinant) {
        let terms = |f: &DeterminantFactor| f.value.terms().len();
        let long: Vec<usize> =
            d.factors.iter().enumerate().filter(|(_, f)| terms(f) > LONGEST).map(|(i, _)| i).collect();
        let (right, names) = self.multiplied(&d.number, &d.factors, &long);
        let left = Math::Row(vec![Math::word("det"), Math::Sign(Sign::Thin), Math::Letter('J')]);
        self.say(Phrase::SingularProduct, vec![]);
        let lines = right.lines(self.options.width);
        self.number += 1;
        self.blocks.push(Block::Equations(vec![Equation { left, right: lines, number: Some(self.number) }]));
        let all: Vec<_> = d.factors.iter().map(|f| self.group(&f.value)).collect();
        self.tell_new(Phrase::With, &all);
        for (name, i) in names {
            let count = d.factors.get(i).map_or(0, terms);
            let text =
                Text::fill(self.words(Phrase::SingularLong), vec![Span::Math(name), Span::Plain(count.to_string())]);
            self.blocks.push(Block::Paragraph(text));
        }
    }

    fn zeros(&mut self, d: &Determinant) {
        let moving: Vec<&DeterminantFactor> = d.factors.iter().filter(|f| f.moves).collect();
        if moving.is_empty() {
            self.say(Phrase::SingularNever, vec![]);
            return;
        }
        let centre = self.wrist_centre(d);
        let items: Vec<Text> =
            moving.into_iter().filter(|f| f.value.terms().len() <= LONGEST).map(|f| self.zero(f, centre)).collect();
        if !items.is_empty() {
            self.say(Phrase::SingularWhere, vec![]);
            self.blocks.push(Block::List(items));
        }
    }

    /// The point of the columns, if the last three joints turn about it.
    fn wrist_centre(&self, d: &Determinant) -> Option<ReferenceFrame> {
        let n = d.joints.len();
        let last = d.columns.get(n.checked_sub(3)?..n)?;
        (n >= 6 && last.iter().all(|c| c.iter().take(3).all(Poly::is_zero))).then_some(d.point)
    }

    fn zero(&self, f: &DeterminantFactor, centre: Option<ReferenceFrame>) -> Text {
        let mut out: Vec<Span> =
            vec![Span::Math(Math::equation(self.notation.typeset(&self.group(&f.value)), Math::number(0)))];
        if let Some(roots) = self.roots(&f.value) {
            out.push(Span::Plain(self.words(Phrase::SingularThat).to_string()));
            out.extend(roots);
        }
        let stop = Span::Plain(self.words(Phrase::Stop).to_string());
        let Some(meaning) = f.meaning else {
            out.push(stop);
            return Text(out);
        };
        out.push(Span::Plain(self.words(Phrase::Colon).to_string()));
        let joint = |j: usize| Span::Plain((j + 1).to_string());
        let point = |s: ReferenceFrame| {
            let same = centre.is_some_and(|c| c == s);
            let phrase = if same { Phrase::WristCentre } else { Phrase::OriginOf };
            Span::Plain(self.words(phrase).replace("{}", &self.stand(s)))
        };
        let (phrase, pieces) = match meaning.kind {
            Degeneracy::Parallel(i, j) => (Phrase::KindParallel, vec![joint(i), joint(j)]),
            Degeneracy::Axes(i, j, k) => (Phrase::KindAxes, vec![joint(i), joint(j), joint(k)]),
            Degeneracy::Stretched(i, j, s) => (Phrase::KindStretched, vec![joint(i), joint(j), point(s)]),
            Degeneracy::OnAxis(s, i) => (Phrase::KindOnAxis, vec![point(s), joint(i)]),
            Degeneracy::InPlane(s, i, j) => (Phrase::KindInPlane, vec![point(s), joint(i), joint(j)]),
            Degeneracy::Coplanar(i, j, k) => (Phrase::KindCoplanar, vec![joint(i), joint(j), joint(k)]),
        };
        out.extend(Text::fill(self.words(phrase), pieces).0);
        let place = meaning.place.map(|p| match p {
            Region::Wrist => Phrase::PlaceWrist,
            Region::Elbow => Phrase::PlaceElbow,
            Region::Shoulder => Phrase::PlaceShoulder,
        });
        if let Some(place) = place {
            out.push(Span::Plain(self.words(place).to_string()));
        }
        out.push(stop);
        Text(out)
    }

    /// Where a factor of one turning joint vanishes: a cos + b sin + c = 0.
    fn roots(&self, p: &Poly) -> Option<Vec<Span>> {
        let is_joint = |v: &AngleVar| self.chain.joints.iter().any(|j| j.coordinate == Coordinate::Angle(*v));
        let mine: Vec<AngleVar> = p.angles().into_iter().filter(is_joint).collect();
        let prismatic =
            self.chain.joints.iter().any(|j| matches!(j.coordinate, Coordinate::Length(s) if p.has_symbol(s)));
        let ([v], false) = (mine.as_slice(), prismatic) else { return None };
        let trig = |f: &Atom| matches!(f, Atom::Cos(t) | Atom::Sin(t) if t.iter().any(|(w, _)| w == v));
        let [mut a, mut b, mut c] = [Poly::zero(), Poly::zero(), Poly::zero()];
        for (m, value) in p.collect(trig) {
            match m.factors().next() {
                Some(Atom::Cos(t)) if t == [(*v, 1)] => a = value,
                Some(Atom::Sin(t)) if t == [(*v, 1)] => b = value,
                None => c = value,
                _ => return None,
            }
        }
        let name = self.notation.angle(*v);
        let either = |left: Math, [x, y]: [f64; 2], places: usize| {
            let or = Span::Plain(self.words(Phrase::Or).to_string());
            let turn = |degrees: f64| match places {
                0 => self.exact(degrees as i64),
                _ => self.notation.decimal_angle(degrees.to_radians(), places),
            };
            vec![Span::Math(Math::equation(left, turn(x))), or, Span::Math(turn(y))]
        };
        if !c.is_zero() {
            let ((a, b), c) = self.nominal(&a).zip(self.nominal(&b)).zip(self.nominal(&c))?;
            let (middle, width) = (b.atan2(a), (-c / a.hypot(b)).acos());
            let degrees = |x: f64| x.sin().atan2(x.cos()).to_degrees();
            return width.is_finite().then(|| either(name, [degrees(middle + width), degrees(middle - width)], 2));
        }
        if a.is_zero() {
            return Some(either(name, [0.0, 180.0], 0));
        }
        if b.is_zero() {
            return Some(either(name, [90.0, -90.0], 0));
        }
        // tan = -a/b
        let formula = [-&a, b.clone()].map(|p| self.notation.typeset(&self.group(&p)));
        let first = Math::equation(name, Math::call("atan2", formula.to_vec()));
        let Some((a, b)) = self.nominal(&a).zip(self.nominal(&b)) else {
            let or = Span::Plain(self.words(Phrase::OrHalfTurn).to_string());
            return Some(vec![Span::Math(first), or, Span::Math(self.exact(180))]);
        };
        let degrees = (-a).atan2(b).to_degrees();
        let other = if degrees > 0.0 { degrees - 180.0 } else { degrees + 180.0 };
        Some(either(first, [degrees, other], 2))
    }

    /// Whole degrees, typeset.
    pub(super) fn exact(&self, degrees: i64) -> Math {
        let half_turns = crate::algebra::Rational::new(degrees, 180).unwrap_or(crate::algebra::Rational::ZERO);
        let (negative, m) = self.notation.exact_angle(&half_turns);
        if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m }
    }

    /// The value with nominal parameters, where all have one.
    pub(super) fn nominal(&self, p: &Poly) -> Option<f64> {
        let known = self.chain.parameters.iter().all(|q| {
            let occurs = match q.handle {
                Handle::Length(s) => p.has_symbol(s),
                Handle::Angle(v) => p.has_angle(v),
            };
            !occurs || !matches!(q.role, Role::Field(None))
        });
        let at = crate::algebra::Point {
            symbol: &|s| self.chain.nominal(Handle::Length(s)),
            angle: &|v| self.chain.nominal(Handle::Angle(v)),
        };
        known.then(|| p.evaluate(&at))
    }
}

/// Rows and columns to show: without the motions left out of account, where each of them is a row of its own.
fn shown(d: &Determinant) -> (Vec<usize>, Vec<usize>) {
    let n = d.joints.len();
    let all = 0..d.columns.len();
    let single = |c: usize| d.blocks.iter().find(|b| b.columns == [c]).and_then(|b| b.rows.first().copied());
    let open: Option<Vec<usize>> = (n..d.columns.len()).map(single).collect();
    let apart = |rows: &Vec<usize>| {
        let zero =
            |c: &[Poly; 6], own: bool| c.iter().enumerate().all(|(r, p)| rows.contains(&r) == own || p.is_zero());
        d.columns.iter().skip(n).all(|c| zero(c, true)) || d.columns.iter().take(n).all(|c| zero(c, false))
    };
    match open.filter(apart) {
        Some(rows) => (all.filter(|r| !rows.contains(r)).collect(), (0..n).collect()),
        None => (all.clone().collect(), all.collect()),
    }
}
