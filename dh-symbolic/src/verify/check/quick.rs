//! Formulas to numbers at one point, quickly: the sieve through which candidates for a mend go before they are proven.

use super::Evaluator;
use super::functions::{axis, axis_argument, joints_of};
use super::number::Written;
use super::point::{Numbers, wrapped};
use super::value::Value;
use crate::verify::language::{Expr, ExprKind};
use std::collections::BTreeMap;

/// A value at a point.
#[derive(Clone, Debug)]
pub(super) enum Quick {
    Scalar(f64),
    Angle(f64),
    /// Columns, entries by rows.
    Matrix(usize, Vec<f64>),
}

impl Quick {
    /// Are two values the same up to rounding?
    pub(super) fn is_near(&self, other: &Quick) -> bool {
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * x.abs().max(y.abs()).max(1.0);
        match (self, other) {
            (Quick::Scalar(x), Quick::Scalar(y)) => near(*x, *y),
            (Quick::Angle(x), Quick::Angle(y)) => wrapped(x - y).abs() < 1e-9,
            (Quick::Scalar(x), Quick::Angle(y)) | (Quick::Angle(y), Quick::Scalar(x)) => near(*x, *y),
            (Quick::Matrix(c, m), Quick::Matrix(d, n)) => {
                c == d && m.len() == n.len() && m.iter().zip(n).all(|(x, y)| near(*x, *y))
            }
            _ => false,
        }
    }
}

/// One point, and what is already known there.
pub(super) struct Sieve {
    numbers: Numbers,
    names: BTreeMap<String, Option<Quick>>,
    calls: BTreeMap<(usize, usize), Option<Quick>>,
}

impl Sieve {
    pub(super) fn new(numbers: Numbers) -> Sieve {
        Sieve { numbers, names: BTreeMap::new(), calls: BTreeMap::new() }
    }

    pub(super) fn value(&self, v: &Value) -> Quick {
        match v {
            Value::Scalar(x) => Quick::Scalar(self.numbers.ratio(x)),
            Value::Angle(t) => Quick::Angle(self.numbers.turn(t)),
            Value::Matrix(m) => Quick::Matrix(m.columns, m.entries.iter().map(|x| self.numbers.ratio(x)).collect()),
        }
    }

    /// The value of a formula; `None` where it has none.
    pub(super) fn evaluate(&mut self, e: &Expr, on: &mut Evaluator<'_>) -> Option<Quick> {
        match &e.kind {
            ExprKind::Number(text) => {
                let w = Written::read(text)?;
                let x = w.value.to_f64();
                match w.unit.as_str() {
                    "" => Some(Quick::Scalar(x)),
                    "deg" => Some(Quick::Angle(x.to_radians())),
                    _ => self.slowly(e, on),
                }
            }
            ExprKind::Name(name) => {
                if let Some(v) = self.names.get(name) {
                    return v.clone();
                }
                let v = on.name(name).ok().map(|v| self.value(&v));
                self.names.insert(name.clone(), v.clone());
                v
            }
            ExprKind::Negative(inner) => Some(scaled(self.evaluate(inner, on)?, -1.0)),
            ExprKind::Sum(terms) => {
                let mut sum: Option<Quick> = None;
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
                let mut product: Option<Quick> = None;
                for (divided, f) in factors {
                    let v = self.evaluate(f, on)?;
                    let v = match (divided, v) {
                        (false, v) => v,
                        (true, Quick::Scalar(x) | Quick::Angle(x)) => Quick::Scalar(1.0 / x),
                        _ => return None,
                    };
                    product = Some(match product {
                        None => v,
                        Some(p) => multiplied(p, v)?,
                    });
                }
                product
            }
            ExprKind::Power(base, n) => match self.evaluate(base, on)? {
                Quick::Scalar(x) | Quick::Angle(x) => Some(Quick::Scalar(x.powi(*n))),
                Quick::Matrix(..) => self.slowly(e, on),
            },
            ExprKind::Matrix(columns, entries) => {
                let mut out = Vec::with_capacity(entries.len());
                for x in entries {
                    match self.evaluate(x, on)? {
                        Quick::Scalar(x) | Quick::Angle(x) => out.push(x),
                        Quick::Matrix(..) => return None,
                    }
                }
                Some(Quick::Matrix(*columns, out))
            }
            ExprKind::Field(..) => self.slowly(e, on),
            ExprKind::Call(name, arguments) => self.call(name, arguments, e, on),
        }
    }

    fn call(
        &mut self,
        name: &str,
        arguments: &[(Option<String>, Expr)],
        e: &Expr,
        on: &mut Evaluator<'_>,
    ) -> Option<Quick> {
        let plain: Vec<&Expr> = arguments.iter().map(|a| &a.1).collect();
        let number = |q: Quick| match q {
            Quick::Scalar(x) | Quick::Angle(x) => Some(x),
            Quick::Matrix(..) => None,
        };
        let turn = |q: Quick| match q {
            Quick::Angle(x) => Some(x),
            Quick::Scalar(0.0) => Some(0.0),
            _ => None,
        };
        match (name, plain.as_slice()) {
            ("cos" | "sin" | "c" | "s", [x]) if joints_of(x).is_none() => {
                let x = turn(self.evaluate(x, on)?)?;
                Some(Quick::Scalar(if name.starts_with('c') { x.cos() } else { x.sin() }))
            }
            ("sqrt", [x]) => Some(Quick::Scalar(number(self.evaluate(x, on)?)?.sqrt())),
            ("atan2", [y, x]) => {
                let y = number(self.evaluate(y, on)?)?;
                Some(Quick::Angle(y.atan2(number(self.evaluate(x, on)?)?)))
            }
            ("Rx" | "Ry" | "Rz" | "rx" | "ry" | "rz", [x]) => Some(rotation(axis(name), turn(self.evaluate(x, on)?)?)),
            ("Rot", [a, x]) => Some(rotation(axis_argument(a)?, turn(self.evaluate(x, on)?)?)),
            ("Tx" | "Ty" | "Tz" | "tx" | "ty" | "tz", [x]) => {
                let mut p = [0.0; 3];
                p[axis(name)] = number(self.evaluate(x, on)?)?;
                Some(translation(p))
            }
            ("Trans", [x, y, z]) => {
                let mut p = [0.0; 3];
                for (p, e) in p.iter_mut().zip([x, y, z]) {
                    *p = number(self.evaluate(e, on)?)?;
                }
                Some(translation(p))
            }
            ("T", [i, j]) => {
                let number = |e: &Expr| match &e.kind {
                    ExprKind::Number(text) => text.parse::<usize>().ok(),
                    _ => None,
                };
                let key = (number(i)?, number(j)?);
                if let Some(v) = self.calls.get(&key) {
                    return v.clone();
                }
                let v = self.slowly(e, on);
                self.calls.insert(key, v.clone());
                v
            }
            _ => self.slowly(e, on),
        }
    }

    /// By way of the exact value.
    fn slowly(&mut self, e: &Expr, on: &mut Evaluator<'_>) -> Option<Quick> {
        let roots = on.roots.len();
        let v = on.evaluate(e).ok()?;
        if on.roots.len() > roots {
            // a new root has no number yet
            return None;
        }
        Some(self.value(&v))
    }
}

fn scaled(q: Quick, k: f64) -> Quick {
    match q {
        Quick::Scalar(x) => Quick::Scalar(k * x),
        Quick::Angle(x) => Quick::Angle(k * x),
        Quick::Matrix(c, m) => Quick::Matrix(c, m.into_iter().map(|x| k * x).collect()),
    }
}

fn added(a: Quick, b: Quick) -> Option<Quick> {
    match (a, b) {
        (Quick::Scalar(x), Quick::Scalar(y)) => Some(Quick::Scalar(x + y)),
        (Quick::Matrix(c, m), Quick::Matrix(d, n)) if c == d && m.len() == n.len() => {
            Some(Quick::Matrix(c, m.iter().zip(&n).map(|(x, y)| x + y).collect()))
        }
        (Quick::Angle(x), Quick::Angle(y) | Quick::Scalar(y)) | (Quick::Scalar(x), Quick::Angle(y)) => {
            Some(Quick::Angle(x + y))
        }
        _ => None,
    }
}

fn multiplied(a: Quick, b: Quick) -> Option<Quick> {
    match (a, b) {
        (Quick::Scalar(x), Quick::Scalar(y)) => Some(Quick::Scalar(x * y)),
        (Quick::Angle(x), Quick::Scalar(y)) | (Quick::Scalar(x), Quick::Angle(y)) => Some(Quick::Angle(x * y)),
        (Quick::Angle(x), Quick::Angle(y)) => Some(Quick::Scalar(x * y)),
        (Quick::Matrix(c, m), Quick::Scalar(x) | Quick::Angle(x))
        | (Quick::Scalar(x) | Quick::Angle(x), Quick::Matrix(c, m)) => Some(scaled(Quick::Matrix(c, m), x)),
        (Quick::Matrix(c, m), Quick::Matrix(d, n)) => {
            if c == 0 || d == 0 || n.len() != c * d {
                return None;
            }
            let product = m.chunks(c).flat_map(|row| {
                (0..d)
                    .map(|j| {
                        row.iter().enumerate().map(|(k, x)| x * n.get(k * d + j).copied().unwrap_or(f64::NAN)).sum()
                    })
                    .collect::<Vec<f64>>()
            });
            Some(Quick::Matrix(d, product.collect()))
        }
    }
}

fn rotation(i: usize, x: f64) -> Quick {
    let mut m = vec![0.0; 16];
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    for (at, v) in
        [(15, 1.0), (5 * i, 1.0), (5 * j, x.cos()), (5 * k, x.cos()), (4 * j + k, -x.sin()), (4 * k + j, x.sin())]
    {
        m[at] = v;
    }
    Quick::Matrix(4, m)
}

fn translation(p: [f64; 3]) -> Quick {
    let mut m = vec![0.0; 16];
    for (i, x) in p.into_iter().enumerate() {
        m[5 * i] = 1.0;
        m[4 * i + 3] = x;
    }
    m[15] = 1.0;
    Quick::Matrix(4, m)
}
