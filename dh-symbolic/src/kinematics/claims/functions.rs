//! Functions and entries: what `T(0,6).px`, `subst(...)` and the like stand for.

use super::Evaluator;
use super::evaluate::{At, Understood, refuse};
use super::ratio::{Ratio, Worked, dot};
use super::value::{Matrix, Turn, Value};
use crate::algebra::{AngleVar, LinearAngle, Poly, Rational, Symbol, Transform};
use crate::chain::claim::{Expr, ExprKind, Place};

/// An entry, a part, or the transpose of a matrix.
pub(super) fn field(v: &Value, name: &str) -> Result<Value, String> {
    let Value::Matrix(m) = v else { return Err(format!("{} has no `.{name}`", v.what())) };
    let axis = |letter: &str| ["x", "y", "z"].iter().position(|a| *a == letter);
    let rotation = m.is(4, 4) || m.is(3, 3);
    let place = m.is(4, 4);
    if name == "t" {
        return Ok(Value::Matrix(m.transposed()));
    }
    if let Some(i) = axis(name) {
        if rotation {
            return Ok(Value::Matrix(m.block(3, i..i + 1)));
        }
        if m.columns == 1 && i < m.rows() {
            return Ok(Value::Scalar(m.at(i, 0)));
        }
    }
    if let (Some(i), true) = (name.strip_prefix('p').and_then(axis), place) {
        return Ok(Value::Scalar(m.at(i, 3)));
    }
    if let (Some(digits), true) = (name.strip_prefix('r'), rotation)
        && let [i @ b'1'..=b'3', j @ b'1'..=b'3'] = digits.as_bytes()
    {
        return Ok(Value::Scalar(m.at(usize::from(i - b'1'), usize::from(j - b'1'))));
    }
    match name {
        "p" if place => Ok(Value::Matrix(m.block(3, 3..4))),
        "R" if rotation => Ok(Value::Matrix(m.block(3, 0..3))),
        _ => Err(format!("a {} matrix has no `.{name}`", m.shape())),
    }
}

/// One variable in terms of what replaces it.
struct Replacement {
    symbols: Vec<(Symbol, Ratio)>,
    angles: Vec<(AngleVar, LinearAngle)>,
}

impl Evaluator<'_> {
    pub(super) fn call(
        &mut self,
        name: &str,
        arguments: &[(Option<String>, Expr)],
        place: &Place,
    ) -> Understood<Value> {
        if name == "subst" {
            return self.substitution(arguments, place);
        }
        if arguments.iter().any(|a| a.0.is_some()) {
            return refuse(place, format!("`{name}` takes no named arguments"));
        }
        let plain: Vec<&Expr> = arguments.iter().map(|a| &a.1).collect();
        match (name, plain.as_slice()) {
            ("T", [i, j]) => {
                let (i, j) = (self.frame(i)?, self.frame(j)?);
                self.transform(i, j, place)
            }
            ("A", [i]) => {
                let n = self.frame(i)?;
                self.transform(n.saturating_sub(1), n, place)
            }
            ("c" | "s", [e]) => {
                let turn = match joints_of(e) {
                    Some(numbers) => {
                        let mut sum = Turn::constant(crate::algebra::Angle::ZERO);
                        for (minus, n) in numbers {
                            let t = self.joint_angle(n).or_else(|why| refuse(&e.place, why))?;
                            sum = sum.plus(&if minus { t.negated() } else { t });
                        }
                        sum
                    }
                    None => {
                        let v = self.evaluate(e)?;
                        self.turn(v, &e.place)?
                    }
                };
                self.sine_or_cosine(&turn, name == "s", place)
            }
            ("cos" | "sin" | "tan", [e]) => {
                let v = self.evaluate(e)?;
                let turn = self.turn(v, &e.place)?;
                if name != "tan" {
                    return self.sine_or_cosine(&turn, name == "sin", place);
                }
                match self.cos_sin(&turn).at(place)? {
                    Some((c, s)) => Ok(Value::Scalar(s.over(&c, &mut self.work).at(place)?)),
                    None => refuse(place, "only whole multiples of an angle have a tangent here"),
                }
            }
            ("cos", [u, v]) => {
                let (u, v) = (self.unit_column(u)?, self.unit_column(v)?);
                let x = dot(u.entries.iter().zip(&v.entries), &mut self.work).at(place)?;
                Ok(Value::Scalar(x))
            }
            ("sqrt", [e]) => {
                let x = self.number_of(e)?;
                Ok(Value::Scalar(self.root(&x).at(place)?))
            }
            ("atan2", [y, x]) => {
                let (y, x) = (self.number_of(y)?, self.number_of(x)?);
                Ok(Value::Angle(Turn::atan2(y, x)))
            }
            ("atan", [e]) => {
                let x = self.number_of(e)?;
                Ok(Value::Angle(Turn::atan2(x, Ratio::int(1))))
            }
            ("acos" | "asin", [e]) => {
                let x = self.number_of(e)?;
                let square = x.times(&x, &mut self.work).at(place)?;
                let rest = Ratio::int(1).minus(&square, &mut self.work).at(place)?;
                let other = self.root(&rest).at(place)?;
                Ok(Value::Angle(if name == "acos" { Turn::atan2(other, x) } else { Turn::atan2(x, other) }))
            }
            ("Rx" | "Ry" | "Rz" | "rx" | "ry" | "rz", [e]) => {
                let v = self.evaluate(e)?;
                let turn = self.turn(v, &e.place)?;
                self.rotation(axis(name), &turn, place)
            }
            ("Rot", [a, e]) => {
                let Some(i) = axis_argument(a) else { return refuse(&a.place, "expected the axis x, y or z") };
                let v = self.evaluate(e)?;
                let turn = self.turn(v, &e.place)?;
                self.rotation(i, &turn, place)
            }
            ("Tx" | "Ty" | "Tz" | "tx" | "ty" | "tz", [e]) => {
                let x = self.number_of(e)?;
                let entry = |i: usize| if i == axis(name) { x.clone() } else { Ratio::zero() };
                Ok(Value::Matrix(translation([entry(0), entry(1), entry(2)])))
            }
            ("Trans", [x, y, z]) => {
                let entries = [self.number_of(x)?, self.number_of(y)?, self.number_of(z)?];
                Ok(Value::Matrix(translation(entries)))
            }
            ("inv", [e]) => {
                let m = self.matrix(e)?;
                Ok(Value::Matrix(self.inverse(&m, place)?))
            }
            ("norm2", [e]) => {
                let m = self.matrix(e)?;
                Ok(Value::Scalar(dot(m.entries.iter().zip(&m.entries), &mut self.work).at(place)?))
            }
            ("dot", [u, v]) => {
                let (u, v) = (self.column(u)?, self.column(v)?);
                Ok(Value::Scalar(dot(u.entries.iter().zip(&v.entries), &mut self.work).at(place)?))
            }
            ("cross", [u, v]) => {
                let (u, v) = (self.column(u)?, self.column(v)?);
                let mut entries = Vec::new();
                for i in 0..3 {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    let left = u.at(j, 0).times(&v.at(k, 0), &mut self.work).at(place)?;
                    let right = u.at(k, 0).times(&v.at(j, 0), &mut self.work).at(place)?;
                    entries.push(left.minus(&right, &mut self.work).at(place)?);
                }
                Ok(Value::Matrix(Matrix { columns: 1, entries }))
            }
            ("diff", [e, v]) => self.derivative(e, v, place),
            _ => refuse(place, unknown_function(name, plain.len())),
        }
    }

    fn number_of(&mut self, e: &Expr) -> Understood<Ratio> {
        let v = self.evaluate(e)?;
        self.scalar(v, &e.place)
    }

    fn matrix(&mut self, e: &Expr) -> Understood<Matrix> {
        match self.evaluate(e)? {
            Value::Matrix(m) => Ok(m),
            v => refuse(&e.place, format!("{} stands where a matrix is needed", v.what())),
        }
    }

    fn column(&mut self, e: &Expr) -> Understood<Matrix> {
        match self.evaluate(e)? {
            Value::Matrix(m) if m.is(3, 1) => Ok(m),
            v => refuse(&e.place, format!("{} stands where a 3x1 column is needed", v.what())),
        }
    }

    fn unit_column(&mut self, e: &Expr) -> Understood<Matrix> {
        let m = self.column(e)?;
        let length = dot(m.entries.iter().zip(&m.entries), &mut self.work).at(&e.place)?;
        let length = self.reduce(&length).at(&e.place)?;
        if length == Ratio::int(1) {
            Ok(m)
        } else {
            refuse(&e.place, "this is no unit vector: the cosine of an angle between axes needs two")
        }
    }

    fn sine_or_cosine(&mut self, turn: &Turn, sine: bool, place: &Place) -> Understood<Value> {
        match self.cos_sin(turn).at(place)? {
            Some((c, s)) => Ok(Value::Scalar(if sine { s } else { c })),
            None => refuse(
                place,
                "only whole multiples of an angle have a sine here; for half an angle use its tangent u = sin(t)/(1 + cos(t))",
            ),
        }
    }

    fn rotation(&mut self, i: usize, turn: &Turn, place: &Place) -> Understood<Value> {
        let Some((c, s)) = self.cos_sin(turn).at(place)? else {
            return refuse(place, "only whole multiples of an angle have a sine here");
        };
        let mut m = Matrix::identity(4);
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for (row, column, x) in [(j, j, c.clone()), (k, k, c), (j, k, s.negated()), (k, j, s)] {
            if let Some(entry) = m.entries.get_mut(4 * row + column) {
                *entry = x;
            }
        }
        Ok(Value::Matrix(m))
    }

    /// The number of a frame, as written.
    fn frame(&mut self, e: &Expr) -> Understood<usize> {
        match &e.kind {
            ExprKind::Number(text) if text.bytes().all(|b| b.is_ascii_digit()) && text.len() <= 3 => {
                Ok(text.parse().unwrap_or(usize::MAX))
            }
            _ => refuse(&e.place, "expected the number of a frame"),
        }
    }

    fn transform(&mut self, i: usize, j: usize, place: &Place) -> Understood<Value> {
        if let Some(m) = self.transforms.get(&(i, j)) {
            return Ok(Value::Matrix(m.clone()));
        }
        let Some(t) = self.kinematics.transform(i, j) else {
            return refuse(place, format!("there is no T({i},{j}): the frames are 0 to {}", self.chain.links.len()));
        };
        let m = Matrix::from_transform(&t);
        self.transforms.insert((i, j), m.clone());
        Ok(Value::Matrix(m))
    }

    fn derivative(&mut self, e: &Expr, v: &Expr, place: &Place) -> Understood<Value> {
        let by = self.variable(v)?;
        let value = self.evaluate(e)?;
        let roots: Vec<Symbol> = self.roots.iter().map(|r| r.symbol).collect();
        let mut one = |x: &Ratio| -> Understood<Ratio> {
            if roots.iter().any(|s| x.num.has_symbol(*s) || x.den.has_symbol(*s)) {
                return refuse(place, "the derivative of a square root is not formed");
            }
            let d = |p: &Poly| match by {
                Variable::Symbol(s, _) => p.derivative_by_symbol(s),
                Variable::Angle(v, _) => p.derivative_by_angle(v),
            };
            let w = &mut self.work;
            let top = &w.times(&d(&x.num), &x.den).at(place)? - &w.times(&x.num, &d(&x.den)).at(place)?;
            let sign = Rational::int(if by.positive() { 1 } else { -1 });
            Ratio::new(top.scale(&sign), w.times(&x.den, &x.den).at(place)?).at(place)
        };
        match value {
            Value::Scalar(x) => Ok(Value::Scalar(one(&x)?)),
            Value::Matrix(m) => {
                let entries = m.entries.iter().map(&mut one).collect::<Understood<_>>()?;
                Ok(Value::Matrix(Matrix { columns: m.columns, entries }))
            }
            Value::Angle(_) => refuse(place, "the derivative of an angle is not formed"),
        }
    }

    /// The one variable that a name stands for.
    fn variable(&mut self, e: &Expr) -> Understood<Variable> {
        let v = self.evaluate(e)?;
        match variable_of(&v) {
            Some(v) => Ok(v),
            None => refuse(&e.place, "this is no single variable"),
        }
    }

    fn substitution(&mut self, arguments: &[(Option<String>, Expr)], place: &Place) -> Understood<Value> {
        let Some(((None, formula), rest)) = arguments.split_first() else {
            return refuse(place, "write `subst(formula, q2 = 0, ...)`");
        };
        let mut r = Replacement { symbols: Vec::new(), angles: Vec::new() };
        for (label, e) in rest {
            let Some(label) = label else { return refuse(&e.place, "write `name = value`") };
            let old = self.name(label).or_else(|why| refuse(&e.place, why))?;
            let Some(variable) = variable_of(&old) else {
                return refuse(
                    &e.place,
                    format!("`{label}` is no single variable, so nothing can be put in its place"),
                );
            };
            let new = self.evaluate(e)?;
            match variable {
                Variable::Symbol(s, positive) => {
                    let x = self.scalar(new, &e.place)?;
                    r.symbols.push((s, if positive { x } else { x.negated() }));
                }
                Variable::Angle(v, rest) => {
                    let new = self.turn(new, &e.place)?;
                    let radians = if new.sides.is_empty() {
                        Some(self.scalar(Value::Angle(new.clone()), &e.place)?)
                    } else {
                        None
                    };
                    let linear = if new.sides.is_empty() { new.plus(&rest.negated()).to_linear() } else { None };
                    let Some(linear) = linear else {
                        return refuse(
                            &e.place,
                            "only whole multiples of angles, and constants, can be put in place of an angle",
                        );
                    };
                    let own = self.ring.angle_name(v).to_string();
                    if let (Some(s), Some(x)) = (self.ring.find_symbol(&own), radians) {
                        r.symbols.push((s, x));
                    }
                    let linear = self.exact(linear);
                    r.angles.push((v, linear));
                }
            }
        }
        let value = self.evaluate(formula)?;
        self.replace(&value, &r, place)
    }

    fn replace(&mut self, v: &Value, r: &Replacement, place: &Place) -> Understood<Value> {
        Ok(match v {
            Value::Scalar(x) => Value::Scalar(self.replace_in(x, r, 0).at(place)?),
            Value::Matrix(m) => {
                let entries = m.entries.iter().map(|x| self.replace_in(x, r, 0)).collect::<Worked<_>>().at(place)?;
                Value::Matrix(Matrix { columns: m.columns, entries })
            }
            Value::Angle(t) => {
                let mut out = Turn::constant(t.constant.clone());
                for (v, k) in &t.terms {
                    let part = match r.angles.iter().find(|a| a.0 == *v) {
                        Some((_, new)) => Turn::linear(new),
                        None => Turn::var(*v),
                    };
                    out = out.plus(&part.times(k).unwrap_or(part));
                }
                for (x, y, minus) in &t.sides {
                    let sides = Turn::atan2(self.replace_in(y, r, 0).at(place)?, self.replace_in(x, r, 0).at(place)?);
                    out = out.plus(&if *minus { sides.negated() } else { sides });
                }
                Value::Angle(out)
            }
        })
    }

    /// Roots take part: their radicands are replaced too.
    fn replace_in(&mut self, x: &Ratio, r: &Replacement, from: usize) -> Worked<Ratio> {
        let mut symbols = r.symbols.clone();
        for i in from..self.roots.len() {
            let super::Root { symbol, radicand } = self.roots[i].clone();
            if x.num.has_symbol(symbol) || x.den.has_symbol(symbol) {
                let new = self.replace_in(&radicand, r, self.roots.len())?;
                symbols.push((symbol, self.root(&new)?));
            }
        }
        let angles = |v: AngleVar| r.angles.iter().find(|a| a.0 == v).map(|a| a.1.clone());
        let turned = |p: &Poly| p.substitute_angles(angles).unwrap_or_else(|| p.clone());
        let x = if r.angles.is_empty() { x.clone() } else { Ratio::new(turned(&x.num), turned(&x.den))? };
        if symbols.iter().all(|s| s.1.as_poly().is_some()) {
            let value = |s: Symbol| symbols.iter().find(|t| t.0 == s).and_then(|t| t.1.as_poly()).cloned();
            return x.map(|p| p.substitute_symbols(value));
        }
        let (num, den) = (self.put_ratios(&x.num, &symbols)?, self.put_ratios(&x.den, &symbols)?);
        num.over(&den, &mut self.work)
    }

    fn put_ratios(&mut self, p: &Poly, symbols: &[(Symbol, Ratio)]) -> Worked<Ratio> {
        let mut sum = Ratio::zero();
        let is_hit = |s: Symbol| symbols.iter().any(|t| t.0 == s);
        for (m, c) in p.collect(|f| matches!(f, crate::algebra::Factor::Power(s, _) if is_hit(*s))) {
            let mut part = Ratio::from(c);
            for (s, x) in symbols {
                part = part.times(&x.power(m.exponent(*s), &mut self.work)?, &mut self.work)?;
            }
            sum = sum.plus(&part, &mut self.work)?;
        }
        Ok(sum)
    }
}

/// A single variable behind a value.
pub(super) enum Variable {
    /// The symbol; `false`: the value is its negative.
    Symbol(Symbol, bool),
    /// The angle, and what is added to it.
    Angle(AngleVar, Turn),
}

impl Variable {
    fn positive(&self) -> bool {
        !matches!(self, Variable::Symbol(_, false))
    }
}

pub(super) fn variable_of(v: &Value) -> Option<Variable> {
    match v {
        Value::Scalar(x) => match x.as_poly()?.terms() {
            [(m, c)] if c.abs().is_one() => match m.factors().collect::<Vec<_>>().as_slice() {
                [crate::algebra::Factor::Power(s, 1)] => Some(Variable::Symbol(*s, c.is_one())),
                _ => None,
            },
            _ => None,
        },
        Value::Angle(t) if t.sides.is_empty() => match t.terms.as_slice() {
            [(v, k)] if k.is_one() => Some(Variable::Angle(*v, Turn::constant(t.constant.clone()))),
            _ => None,
        },
        _ => None,
    }
}

/// `2-3` as joints with signs; `None` where the formula is more than bare small numbers.
pub(super) fn joints_of(e: &Expr) -> Option<Vec<(bool, usize)>> {
    let one = |e: &Expr| match &e.kind {
        ExprKind::Number(text) if text.len() <= 3 => text.parse::<usize>().ok().filter(|n| *n > 0),
        _ => None,
    };
    match &e.kind {
        ExprKind::Number(_) => Some(vec![(false, one(e)?)]),
        ExprKind::Sum(terms) => terms
            .iter()
            .map(|(minus, t)| match &t.kind {
                ExprKind::Negative(inner) => Some((!minus, one(inner)?)),
                _ => Some((*minus, one(t)?)),
            })
            .collect(),
        _ => None,
    }
}

/// 0, 1, 2 by the last letter of `Rx`, `Ty`, ...
pub(super) fn axis(name: &str) -> usize {
    match name.as_bytes().last() {
        Some(b'y') => 1,
        Some(b'z') => 2,
        _ => 0,
    }
}

pub(super) fn axis_argument(e: &Expr) -> Option<usize> {
    match &e.kind {
        ExprKind::Name(n) if matches!(n.as_str(), "x" | "y" | "z") => Some(axis(n)),
        _ => None,
    }
}

fn translation([x, y, z]: [Ratio; 3]) -> Matrix {
    let mut m = Matrix::from_transform(&Transform::identity());
    for (i, v) in [x, y, z].into_iter().enumerate() {
        if let Some(entry) = m.entries.get_mut(4 * i + 3) {
            *entry = v;
        }
    }
    m
}

fn unknown_function(name: &str, count: usize) -> String {
    let wanted = match name {
        "T" => "T(i,j)",
        "A" => "A(i)",
        "c" | "s" | "cos" | "sin" | "tan" | "sqrt" | "acos" | "asin" | "atan" | "inv" | "norm2" => "one argument",
        "atan2" => "atan2(y, x)",
        "dot" | "cross" => "two columns",
        "diff" => "diff(formula, variable)",
        "Rot" => "Rot(x, angle)",
        "Trans" => "Trans(x, y, z)",
        "Rx" | "Ry" | "Rz" | "rx" | "ry" | "rz" => "one angle",
        "Tx" | "Ty" | "Tz" | "tx" | "ty" | "tz" => "one length",
        _ => return format!("unknown function `{name}`; for a product write `*`"),
    };
    format!("`{name}` with {count} arguments: expected {wanted}")
}
