//! Evaluates functions and matrix entries: `T(0,6).px`, `subst(...)` and the like.

use super::Evaluator;
use super::ratio::{Ratio, dot};
use super::refusal::{At, Understood, refuse};
use super::value::{Matrix, Turn, Value};
use crate::algebra::{Rational, Transform};
use crate::verify::language::{Expr, ExprKind, Place};

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
            ("J", [k]) => {
                let (k, j) = (self.frame(k)?, self.jacobian());
                self.part_of_jacobian(&j, 1..=j.rows(), k, place)
            }
            ("J", [i, k]) => {
                let (i, k, j) = (self.frame(i)?, self.frame(k)?, self.jacobian());
                self.part_of_jacobian(&j, i..=i, k, place)
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
                    // tan(t/2) = sin t/(1 + cos t)
                    None if turn.sides.is_empty()
                        && let Some(twice) = turn.times(&Rational::int(2))
                        && let Some((c, s)) = self.cos_sin(&twice).at(place)? =>
                    {
                        let below = c.plus(&Ratio::int(1), &mut self.work).at(place)?;
                        Ok(Value::Scalar(s.over(&below, &mut self.work).at(place)?))
                    }
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
            ("det", [e]) => {
                let m = self.matrix(e)?;
                if m.rows() != m.columns || m.columns > 6 {
                    return refuse(&e.place, format!("the determinant of a {} matrix is not formed", m.shape()));
                }
                Ok(Value::Scalar(m.determinant(&mut self.work).at(place)?))
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
            ("rows", [e, list @ ..]) if !list.is_empty() => {
                let m = self.matrix(e)?;
                let mut entries = Vec::new();
                for k in list {
                    let n = self.frame(k)?;
                    if n == 0 || n > m.rows() {
                        return refuse(&k.place, format!("a {} matrix has no row {n}", m.shape()));
                    }
                    entries.extend((0..m.columns).map(|j| m.at(n - 1, j)));
                }
                Ok(Value::Matrix(Matrix { columns: m.columns, entries }))
            }
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
        "J" => "J(column) or J(row, column)",
        "c" | "s" | "cos" | "sin" | "tan" | "sqrt" | "acos" | "asin" | "atan" | "inv" | "det" | "norm2" => {
            "one argument"
        }
        "atan2" => "atan2(y, x)",
        "dot" | "cross" => "two columns",
        "diff" => "diff(formula, variable)",
        "rows" => "rows(matrix, 1, 2, 6)",
        "Rot" => "Rot(x, angle)",
        "Trans" => "Trans(x, y, z)",
        "Rx" | "Ry" | "Rz" | "rx" | "ry" | "rz" => "one angle",
        "Tx" | "Ty" | "Tz" | "tx" | "ty" | "tz" => "one length",
        _ => return format!("unknown function `{name}`; for a product write `*`"),
    };
    format!("`{name}` with {count} arguments: expected {wanted}")
}
