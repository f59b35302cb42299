//! Formulas to numbers at one point, straight from the table: products of 4x4 matrices of floats, `atan2`, `sqrt` and the like.
//!
//! Nothing here goes through the normal form, so that what the algebra says can be held against it.

mod arithmetic;
mod jacobian;
mod matrix;

use super::Evaluator;
use super::functions::{axis, axis_argument, joints_of};
use super::number::Written;
use super::point::{Numbers, wrapped};
use super::scope::{is_number_without_cell, numbered};
use super::value::Value;
use crate::chain::{Chain, Convention, Elementary, Handle};
use crate::verify::language::{Expr, ExprKind};
use arithmetic::{added, multiplied, scaled};
use matrix::{Rows, identity, rotation, translation};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Deepest nesting of definitions within definitions.
const DEPTH: usize = 200;
/// Step of a numeric derivative.
const STEP: f64 = 1e-3;

/// A value at a point.
#[derive(Clone, Debug)]
pub(super) enum Direct {
    Scalar(f64),
    /// Radians.
    Angle(f64),
    Matrix(Rows),
}

/// What a name that the derivation gives stands for.
#[derive(Clone)]
pub(super) enum Meaning<'a> {
    /// `let K = ...;`
    Formula(&'a Expr),
    /// `let x: length;`: a quantity of its own.
    Free(Value),
    /// A definition that is tried in place of the written one.
    Tried(Rc<Expr>),
}

impl Direct {
    /// Are two values the same, up to a part of their size? Angles modulo a whole turn.
    pub(super) fn is_near(&self, other: &Direct, part: f64) -> bool {
        let near = |x: f64, y: f64| (x - y).abs() <= part * x.abs().max(y.abs()).max(1.0);
        match (self, other) {
            (Direct::Scalar(x), Direct::Scalar(y)) => near(*x, *y),
            (Direct::Angle(x), Direct::Angle(y)) => wrapped(x - y).abs() < part,
            (Direct::Scalar(x), Direct::Angle(y)) | (Direct::Angle(y), Direct::Scalar(x)) => near(*x, *y),
            // every entry is zero
            (Direct::Matrix(m), Direct::Scalar(0.0)) | (Direct::Scalar(0.0), Direct::Matrix(m)) => {
                m.cells.iter().all(|x| x.abs() <= part)
            }
            (Direct::Matrix(m), Direct::Matrix(n)) => {
                let (m, n) = (m.beside(n), n.beside(m));
                m.columns == n.columns && m.cells.len() == n.cells.len() && {
                    let size = m.cells.iter().chain(&n.cells).fold(1.0, |s: f64, x| s.max(x.abs()));
                    m.cells.iter().zip(&n.cells).all(|(x, y)| (x - y).abs() <= part * size)
                }
            }
            _ => false,
        }
    }

    pub(super) fn is_finite(&self) -> bool {
        match self {
            Direct::Scalar(x) | Direct::Angle(x) => x.is_finite(),
            Direct::Matrix(m) => m.cells.iter().all(|x| x.is_finite()),
        }
    }

    fn number(self) -> Option<f64> {
        match self {
            Direct::Scalar(x) | Direct::Angle(x) => Some(x),
            Direct::Matrix(_) => None,
        }
    }

    /// As an angle: of bare numbers only 0 is one.
    fn turn(self) -> Option<f64> {
        match self {
            Direct::Angle(x) => Some(x),
            Direct::Scalar(0.0) => Some(0.0),
            _ => None,
        }
    }

    fn matrix(self) -> Option<Rows> {
        match self {
            Direct::Matrix(m) => Some(m),
            _ => None,
        }
    }
}

/// One point, and what is already known there.
pub(super) struct Spot {
    pub(super) numbers: Numbers,
    names: BTreeMap<String, Option<Direct>>,
    /// T(0, k) for k = 0, 1, ...
    frames: Vec<Rows>,
    depth: usize,
}

impl Spot {
    pub(super) fn new(numbers: Numbers) -> Spot {
        Spot { numbers, names: BTreeMap::new(), frames: Vec::new(), depth: 0 }
    }

    /// An exact value in numbers.
    pub(super) fn value(&self, v: &Value) -> Direct {
        match v {
            Value::Scalar(x) => Direct::Scalar(self.numbers.ratio(x)),
            Value::Angle(t) => Direct::Angle(self.numbers.turn(t)),
            Value::Matrix(m) => Direct::Matrix(Rows {
                columns: m.columns,
                cells: m.entries.iter().map(|x| self.numbers.ratio(x)).collect(),
            }),
        }
    }

    /// The value of a formula; `None` where it has none.
    pub(super) fn evaluate(&mut self, e: &Expr, on: &Evaluator<'_>) -> Option<Direct> {
        match &e.kind {
            ExprKind::Number(text) => written(text, on),
            ExprKind::Name(name) => self.name(name, on),
            ExprKind::Negative(inner) => Some(scaled(self.evaluate(inner, on)?, -1.0)),
            ExprKind::Sum(terms) => {
                let mut sum: Option<Direct> = None;
                for (minus, t) in terms {
                    let v = scaled(self.evaluate(t, on)?, if *minus { -1.0 } else { 1.0 });
                    sum = Some(match sum {
                        None => v,
                        Some(s) => added(s, v)?,
                    });
                }
                sum
            }
            ExprKind::Product(factors) => {
                let mut product: Option<Direct> = None;
                for (divided, f) in factors {
                    let v = self.evaluate(f, on)?;
                    let v = if *divided { Direct::Scalar(1.0 / v.number()?) } else { v };
                    product = Some(match product {
                        None => v,
                        Some(p) => multiplied(p, v)?,
                    });
                }
                product
            }
            ExprKind::Power(base, n) => match self.evaluate(base, on)? {
                Direct::Scalar(x) | Direct::Angle(x) => Some(Direct::Scalar(x.powi(*n))),
                Direct::Matrix(m) => m.power(*n).map(Direct::Matrix),
            },
            ExprKind::Matrix(columns, entries) => {
                let mut cells = Vec::with_capacity(entries.len());
                for x in entries {
                    cells.push(self.evaluate(x, on)?.number()?);
                }
                Some(Direct::Matrix(Rows { columns: *columns, cells }))
            }
            ExprKind::Field(inner, field) => self.evaluate(inner, on)?.matrix()?.field(field),
            ExprKind::Call(name, arguments) => self.call(name, arguments, on),
        }
    }

    fn name(&mut self, name: &str, on: &Evaluator<'_>) -> Option<Direct> {
        if let Some(v) = self.names.get(name) {
            return v.clone();
        }
        let v = self.meaning(name, on);
        self.names.insert(name.to_string(), v.clone());
        v
    }

    fn meaning(&mut self, name: &str, on: &Evaluator<'_>) -> Option<Direct> {
        if let Some((_, meaning)) = on.meanings.iter().rev().find(|(n, _)| n == name) {
            return match meaning {
                Meaning::Free(v) => Some(self.value(v)),
                Meaning::Formula(e) => self.inside(e, on),
                Meaning::Tried(e) => self.inside(e, on),
            };
        }
        self.known(name, on).or_else(|| {
            let (first, rest) = name.split_at_checked(1).filter(|s| matches!(s.0, "c" | "s") && !s.1.is_empty())?;
            let angle = self.abbreviated(rest, on)?;
            Some(Direct::Scalar(if first == "c" { angle.cos() } else { angle.sin() }))
        })
    }

    /// A definition within a definition.
    fn inside(&mut self, e: &Expr, on: &Evaluator<'_>) -> Option<Direct> {
        self.depth += 1;
        let v = if self.depth > DEPTH { None } else { self.evaluate(e, on) };
        self.depth -= 1;
        v
    }

    /// Forgets what names are.
    pub(super) fn forget_names(&mut self) {
        self.names.clear();
    }

    /// The angle behind c23, sa2, cphi.
    fn abbreviated(&mut self, rest: &str, on: &Evaluator<'_>) -> Option<f64> {
        if rest.bytes().all(|b| b.is_ascii_digit() || b == b'_') {
            let parts: Vec<&str> = if rest.contains('_') {
                rest.split('_').collect()
            } else {
                rest.split("").filter(|d| !d.is_empty()).collect()
            };
            let mut sum = 0.0;
            for n in parts {
                sum += self.joint_angle(n.parse().ok()?, on)?;
            }
            return Some(sum);
        }
        let long = match rest.strip_prefix('a') {
            Some(digits) if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) => {
                format!("alpha{digits}")
            }
            _ => rest.to_string(),
        };
        let own = on.meanings.iter().any(|(n, _)| *n == long);
        let value = if own { self.name(&long, on) } else { self.known(&long, on) };
        match value? {
            Direct::Angle(x) => Some(x),
            _ => None,
        }
    }

    fn joint_angle(&mut self, n: usize, on: &Evaluator<'_>) -> Option<f64> {
        match self.known(&format!("q{n}"), on)? {
            Direct::Angle(x) => Some(x),
            _ => None,
        }
    }

    /// Names that mean something without any `let` in the derivation, except c23 and the like.
    fn known(&mut self, name: &str, on: &Evaluator<'_>) -> Option<Direct> {
        let chain = on.chain;
        let handle = |h: Handle| match h {
            Handle::Length(s) => Direct::Scalar(self.numbers.symbol(s)),
            Handle::Angle(v) => Direct::Angle(self.numbers.angle(v)),
        };
        if let Some(p) = chain.parameters.iter().find(|p| p.declared && p.name == name) {
            return Some(handle(p.handle));
        }
        match name {
            "pi" => return Some(Direct::Angle(std::f64::consts::PI)),
            "base" => return Some(Direct::Matrix(self.product(&chain.base))),
            "tool" => return Some(Direct::Matrix(self.product(&chain.tool))),
            "J" => return Some(Direct::Matrix(self.jacobian(on)?)),
            "Jv" => return Some(Direct::Matrix(self.whole_jacobian(chain)?.some_rows(&[0, 1, 2])?)),
            "Jw" => return Some(Direct::Matrix(self.whole_jacobian(chain)?.some_rows(&[3, 4, 5])?)),
            "I3" => return Some(Direct::Matrix(identity(3))),
            "I4" => return Some(Direct::Matrix(identity(4))),
            _ => {}
        }
        if let Some(p) = chain.parameters.iter().find(|p| is_number_without_cell(p, name)) {
            return Some(handle(p.handle));
        }
        let (prefix, number) = numbered(name)?;
        let own = number.checked_sub(1);
        let ahead = usize::from(chain.convention == Convention::Modified);
        let row = |k: Option<usize>| chain.links.get(k?);
        Some(match prefix {
            "q" => {
                let x = *self.numbers.actuators(chain)?.get(own?)?;
                if matches!(on.joints.get(own?)?, Value::Angle(_)) { Direct::Angle(x) } else { Direct::Scalar(x) }
            }
            "theta" => Direct::Angle(self.numbers.linear(&row(own)?.theta)),
            "d" => Direct::Scalar(self.numbers.evaluate(&row(own)?.d)),
            "a" => Direct::Scalar(self.numbers.evaluate(&row((number + ahead).checked_sub(1))?.a)),
            "alpha" => Direct::Angle(self.numbers.linear(&row((number + ahead).checked_sub(1))?.alpha)),
            _ => return None,
        })
    }

    fn product(&self, factors: &[Elementary]) -> Rows {
        factors.iter().fold(identity(4), |t, f| match f {
            Elementary::Translate(axis, x) => {
                let mut p = [0.0; 3];
                p[*axis] = self.numbers.evaluate(x);
                t.times(&translation(p))
            }
            Elementary::Rotate(axis, a) => t.times(&rotation(*axis, self.numbers.linear(a))),
        })
    }

    /// T(i, j).
    fn transform(&mut self, i: usize, j: usize, chain: &Chain) -> Option<Rows> {
        if self.frames.is_empty() {
            let mut t = identity(4);
            self.frames.push(t.clone());
            for row in 0..chain.links.len() {
                t = t.times(&self.product(&chain.link_factors(row)));
                self.frames.push(t.clone());
            }
        }
        if i > chain.links.len() || j > chain.links.len() {
            return None;
        }
        // between neighbours directly: no rounding from the rows before
        let (low, high) = (i.min(j), i.max(j));
        let t = if low == 0 {
            self.frames.get(high)?.clone()
        } else {
            (low..high).fold(identity(4), |t, row| t.times(&self.product(&chain.link_factors(row))))
        };
        Some(if i > j { t.rigid_inverse() } else { t })
    }

    fn call(&mut self, name: &str, arguments: &[(Option<String>, Expr)], on: &Evaluator<'_>) -> Option<Direct> {
        if name == "subst" {
            return self.substituted(arguments, on);
        }
        let plain: Vec<&Expr> = arguments.iter().map(|a| &a.1).collect();
        let index = |e: &Expr| match &e.kind {
            ExprKind::Number(text) => text.parse::<usize>().ok(),
            _ => None,
        };
        Some(match (name, plain.as_slice()) {
            ("T", [i, j]) => Direct::Matrix(self.transform(index(i)?, index(j)?, on.chain)?),
            ("A", [i]) => Direct::Matrix(self.transform(index(i)?.checked_sub(1)?, index(i)?, on.chain)?),
            ("J", [k]) => {
                let (j, k) = (self.jacobian(on)?, index(k)?.checked_sub(1)?);
                let cells = (0..j.rows()).map(|i| j.get(i, k)).collect::<Option<_>>()?;
                Direct::Matrix(Rows { columns: 1, cells })
            }
            ("J", [i, k]) => {
                Direct::Scalar(self.jacobian(on)?.get(index(i)?.checked_sub(1)?, index(k)?.checked_sub(1)?)?)
            }
            ("c" | "s", [e]) if joints_of(e).is_some() => {
                let mut sum = 0.0;
                for (minus, n) in joints_of(e)? {
                    let x = self.joint_angle(n, on)?;
                    sum += if minus { -x } else { x };
                }
                Direct::Scalar(if name == "c" { sum.cos() } else { sum.sin() })
            }
            ("c" | "s" | "cos" | "sin" | "tan", [e]) => {
                let x = self.evaluate(e, on)?.turn()?;
                Direct::Scalar(match name {
                    "tan" => x.tan(),
                    "c" | "cos" => x.cos(),
                    _ => x.sin(),
                })
            }
            ("sqrt", [e]) => {
                let x = self.evaluate(e, on)?.number()?;
                // zero up to rounding
                Direct::Scalar(if x < 0.0 && x > -1e-13 { 0.0 } else { x.sqrt() })
            }
            ("atan2", [y, x]) => {
                let y = self.evaluate(y, on)?.number()?;
                Direct::Angle(y.atan2(self.evaluate(x, on)?.number()?))
            }
            ("atan", [e]) => Direct::Angle(self.evaluate(e, on)?.number()?.atan()),
            ("acos", [e]) => Direct::Angle(unit(self.evaluate(e, on)?.number()?).acos()),
            ("asin", [e]) => Direct::Angle(unit(self.evaluate(e, on)?.number()?).asin()),
            ("Rx" | "Ry" | "Rz" | "rx" | "ry" | "rz", [e]) => {
                Direct::Matrix(rotation(axis(name), self.evaluate(e, on)?.turn()?))
            }
            ("Rot", [a, e]) => Direct::Matrix(rotation(axis_argument(a)?, self.evaluate(e, on)?.turn()?)),
            ("Tx" | "Ty" | "Tz" | "tx" | "ty" | "tz", [e]) => {
                let mut p = [0.0; 3];
                p[axis(name)] = self.evaluate(e, on)?.number()?;
                Direct::Matrix(translation(p))
            }
            ("Trans", [x, y, z]) => {
                let mut p = [0.0; 3];
                for (p, e) in p.iter_mut().zip([x, y, z]) {
                    *p = self.evaluate(e, on)?.number()?;
                }
                Direct::Matrix(translation(p))
            }
            ("inv", [e]) => Direct::Matrix(self.evaluate(e, on)?.matrix()?.inverse()?),
            ("det", [e]) => Direct::Scalar(self.evaluate(e, on)?.matrix()?.determinant()?),
            ("norm2", [e]) => {
                let m = self.evaluate(e, on)?.matrix()?;
                Direct::Scalar(m.cells.iter().map(|x| x * x).sum())
            }
            ("dot" | "cos", [u, v]) => {
                let (u, v) = (self.evaluate(u, on)?.matrix()?, self.evaluate(v, on)?.matrix()?);
                Direct::Scalar(u.cells.iter().zip(&v.cells).map(|(x, y)| x * y).sum())
            }
            ("cross", [u, v]) => {
                let (u, v) = (self.evaluate(u, on)?.matrix()?, self.evaluate(v, on)?.matrix()?);
                let cells = (0..3).map(|i| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    Some(u.get(j, 0)? * v.get(k, 0)? - u.get(k, 0)? * v.get(j, 0)?)
                });
                Direct::Matrix(Rows { columns: 1, cells: cells.collect::<Option<_>>()? })
            }
            ("diff", [e, v]) => self.slope(e, v, on)?,
            ("rows", [e, list @ ..]) => {
                let rows = list.iter().map(|k| index(k)?.checked_sub(1)).collect::<Option<Vec<usize>>>()?;
                Direct::Matrix(self.evaluate(e, on)?.matrix()?.some_rows(&rows)?)
            }
            _ => return None,
        })
    }

    /// The slope of a formula by a variable, from values on both sides.
    fn slope(&mut self, e: &Expr, by: &Expr, on: &Evaluator<'_>) -> Option<Direct> {
        let ExprKind::Name(name) = &by.kind else { return None };
        let mut sum: Option<Direct> = None;
        for (steps, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
            let numbers = on.moved(&self.numbers, name, |x| x + steps * STEP)?;
            let mut there = Spot { depth: self.depth + 1, ..Spot::new(numbers) };
            let v = if there.depth > DEPTH { None } else { there.evaluate(e, on) };
            let part = scaled(v?, weight / (12.0 * STEP));
            sum = Some(match sum {
                None => part,
                Some(s) => added(s, part)?,
            });
        }
        match sum? {
            Direct::Angle(x) => Some(Direct::Scalar(x)),
            v => Some(v),
        }
    }

    /// `subst(e, q2 = 0, ...)`: the formula at another point.
    fn substituted(&mut self, arguments: &[(Option<String>, Expr)], on: &Evaluator<'_>) -> Option<Direct> {
        let ((_, formula), rest) = arguments.split_first()?;
        let mut numbers = self.numbers.clone();
        for (label, e) in rest {
            let new = self.evaluate(e, on)?.number()?;
            numbers = on.moved(&numbers, label.as_ref()?, |_| new)?;
        }
        let mut there = Spot { depth: self.depth + 1, ..Spot::new(numbers) };
        if there.depth > DEPTH { None } else { there.evaluate(formula, on) }
    }
}

/// A number with its unit.
fn written(text: &str, on: &Evaluator<'_>) -> Option<Direct> {
    let w = Written::read(text)?;
    let x = w.value.to_f64();
    Some(match w.unit.as_str() {
        "" => Direct::Scalar(x),
        "deg" => Direct::Angle(x.to_radians()),
        "rad" => Direct::Angle(x),
        "turn" => Direct::Angle(x * std::f64::consts::TAU),
        unit => Direct::Scalar(x * super::number::metres(unit)?.to_f64() / on.metre()),
    })
}

/// A cosine that is one up to rounding.
fn unit(x: f64) -> f64 {
    if x.abs() > 1.0 && x.abs() < 1.0 + 1e-13 { x.signum() } else { x }
}
