//! Evaluates formulas to exact values.

use super::Evaluator;
use super::number::Written;
use super::ratio::{Ratio, Worked};
use super::refusal::{At, Understood, refuse};
use super::value::{Matrix, Turn, Value};
use crate::algebra::{Angle, LinearAngle, Poly, Rational};
use crate::verify::language::{Expr, ExprKind, Place};

impl Evaluator<'_> {
    pub(super) fn evaluate(&mut self, e: &Expr) -> Understood<Value> {
        match &e.kind {
            ExprKind::Number(text) => self.number(text, &e.place),
            ExprKind::Name(name) => self.name(name).or_else(|why| refuse(&e.place, why)),
            ExprKind::Negative(inner) => Ok(match self.evaluate(inner)? {
                Value::Scalar(x) => Value::Scalar(x.negated()),
                Value::Angle(t) => Value::Angle(t.negated()),
                Value::Matrix(m) => Value::Matrix(m.negated()),
            }),
            ExprKind::Sum(terms) => {
                let mut sum: Option<Value> = None;
                for (minus, term) in terms {
                    let mut v = self.evaluate(term)?;
                    if *minus {
                        v = match v {
                            Value::Scalar(x) => Value::Scalar(x.negated()),
                            Value::Angle(t) => Value::Angle(t.negated()),
                            Value::Matrix(m) => Value::Matrix(m.negated()),
                        };
                    }
                    sum = Some(match sum {
                        None => v,
                        Some(s) => self.add(s, v, &term.place)?,
                    });
                }
                Ok(sum.unwrap_or_else(|| Value::Scalar(Ratio::zero())))
            }
            ExprKind::Product(factors) => {
                let mut product: Option<Value> = None;
                for (divided, factor) in factors {
                    let v = self.evaluate(factor)?;
                    product = Some(match product {
                        None => v,
                        Some(p) if *divided => self.divide(p, v, &factor.place)?,
                        Some(p) => self.multiply(p, v, &factor.place)?,
                    });
                }
                Ok(product.unwrap_or_else(|| Value::Scalar(Ratio::int(1))))
            }
            ExprKind::Power(base, n) => {
                let v = self.evaluate(base)?;
                self.power(v, *n, &e.place)
            }
            ExprKind::Field(inner, field) => {
                let v = self.evaluate(inner)?;
                super::functions::field(&v, field).or_else(|why| refuse(&e.place, why))
            }
            ExprKind::Matrix(columns, entries) => {
                let mut out = Vec::with_capacity(entries.len());
                for entry in entries {
                    match self.evaluate(entry)? {
                        Value::Matrix(m) => {
                            return refuse(&entry.place, format!("a {} matrix inside a matrix", m.shape()));
                        }
                        v => out.push(self.scalar(v, &entry.place)?),
                    }
                }
                Ok(Value::Matrix(Matrix { columns: *columns, entries: out }))
            }
            ExprKind::Call(name, arguments) => self.call(name, arguments, &e.place),
        }
    }

    /// A value as a number; an angle counts as the number of its radians, which is independent of its sine.
    pub(super) fn scalar(&mut self, v: Value, place: &Place) -> Understood<Ratio> {
        match v {
            Value::Scalar(x) => Ok(x),
            Value::Angle(t) if !t.sides.is_empty() => {
                refuse(place, "an angle given by its sides stands where a number is needed")
            }
            Value::Angle(t) => Ok(self.radians_of(&t)),
            Value::Matrix(m) => refuse(place, format!("a {} matrix stands where a number is needed", m.shape())),
        }
    }

    /// A value as an angle.
    pub(super) fn turn(&mut self, v: Value, place: &Place) -> Understood<Turn> {
        match v {
            Value::Angle(t) => Ok(t),
            Value::Scalar(x) if x.is_zero() => Ok(Turn::constant(Angle::ZERO)),
            Value::Scalar(x) if x.as_rational().is_some() => refuse(place, "an angle needs a unit: `90deg`, `pi/2`"),
            v => refuse(place, format!("{} stands where an angle is needed", v.what())),
        }
    }

    fn add(&mut self, a: Value, b: Value, place: &Place) -> Understood<Value> {
        Ok(match (a, b) {
            (Value::Matrix(m), Value::Matrix(n)) => {
                if !m.is(n.rows(), n.columns) {
                    return refuse(
                        place,
                        format!("the sum of a {} and a {} matrix does not exist", m.shape(), n.shape()),
                    );
                }
                Value::Matrix(m.plus(&n, &mut self.work).at(place)?)
            }
            (Value::Angle(t), Value::Angle(u)) => Value::Angle(t.plus(&u)),
            (Value::Angle(t), Value::Scalar(x)) | (Value::Scalar(x), Value::Angle(t)) if x.is_zero() => Value::Angle(t),
            (Value::Matrix(m), v) | (v, Value::Matrix(m)) => {
                return refuse(place, format!("the sum of a {} matrix and {} does not exist", m.shape(), v.what()));
            }
            (a, b) => {
                let (a, b) = (self.scalar(a, place)?, self.scalar(b, place)?);
                Value::Scalar(a.plus(&b, &mut self.work).at(place)?)
            }
        })
    }

    fn multiply(&mut self, a: Value, b: Value, place: &Place) -> Understood<Value> {
        Ok(match (a, b) {
            (Value::Matrix(m), Value::Matrix(n)) => {
                let n = if m.is(4, 4) && n.is(3, 1) { n.homogeneous() } else { n };
                // Rx(90deg) * T(3,6).R
                let m = super::compare::without_translation(m, &n);
                let n = super::compare::without_translation(n, &m);
                if m.columns != n.rows() {
                    return refuse(
                        place,
                        format!("the product of a {} and a {} matrix does not exist", m.shape(), n.shape()),
                    );
                }
                Value::Matrix(m.times(&n, &mut self.work).at(place)?)
            }
            (Value::Matrix(m), v) | (v, Value::Matrix(m)) => {
                let x = self.scalar(v, place)?;
                Value::Matrix(m.scaled(&x, &mut self.work).at(place)?)
            }
            (Value::Angle(t), Value::Scalar(x)) | (Value::Scalar(x), Value::Angle(t)) if x.as_rational().is_some() => {
                let k = x.as_rational().unwrap_or(Rational::ZERO);
                match t.times(&k) {
                    Some(t) => Value::Angle(t),
                    None => return refuse(place, "only a whole multiple of such an angle can be formed"),
                }
            }
            (a, b) => {
                let (a, b) = (self.scalar(a, place)?, self.scalar(b, place)?);
                Value::Scalar(a.times(&b, &mut self.work).at(place)?)
            }
        })
    }

    fn divide(&mut self, a: Value, b: Value, place: &Place) -> Understood<Value> {
        let by = self.scalar(b, place)?;
        let one_over = Ratio::int(1).over(&by, &mut self.work).at(place)?;
        self.multiply(a, Value::Scalar(one_over), place)
    }

    fn power(&mut self, v: Value, n: i32, place: &Place) -> Understood<Value> {
        match v {
            Value::Matrix(m) if m.rows() != m.columns => {
                refuse(place, format!("the power of a {} matrix does not exist", m.shape()))
            }
            Value::Matrix(m) => {
                let m = if n < 0 { self.inverse(&m, place)? } else { m };
                let one = Matrix::identity(m.columns);
                let p = (0..n.unsigned_abs()).try_fold(one, |p, _| p.times(&m, &mut self.work)).at(place)?;
                Ok(Value::Matrix(p))
            }
            v => {
                let x = self.scalar(v, place)?;
                let p = x.power(n.unsigned_abs(), &mut self.work).at(place)?;
                let p = if n < 0 { Ratio::int(1).over(&p, &mut self.work).at(place)? } else { p };
                Ok(Value::Scalar(p))
            }
        }
    }

    pub(super) fn inverse(&mut self, m: &Matrix, place: &Place) -> Understood<Matrix> {
        match m.inverse(&mut self.work).at(place)? {
            Some(inverse) => Ok(inverse),
            None => refuse(place, format!("the inverse of a {} matrix is not formed", m.shape())),
        }
    }

    /// Radians of an angle without sides, in symbols of their own: one per angle variable, and pi.
    fn radians_of(&mut self, t: &Turn) -> Ratio {
        let mut sum = Poly::zero();
        for (v, k) in &t.terms {
            let name = self.ring.angle_name(*v).to_string();
            sum = &sum + &Poly::symbol(self.ring.symbol(&name)).scale(k);
        }
        if !t.constant.is_zero() {
            sum = &sum + &Poly::symbol(self.ring.symbol("pi")).scale(t.constant.factor());
        }
        sum.into()
    }

    /// Cosine and sine; `None` where a factor of an angle is no small whole number.
    pub(super) fn cos_sin(&mut self, t: &Turn) -> Worked<Option<(Ratio, Ratio)>> {
        let Some((x, y)) = self.direction(t)? else { return Ok(None) };
        if t.sides.is_empty() {
            return Ok(Some((x, y)));
        }
        let mut length = Ratio::int(1);
        for (a, b, _) in &t.sides {
            let norm = self.norm(a, b)?;
            length = length.times(&self.root(&norm)?, &mut self.work)?;
        }
        Ok(Some((x.over(&length, &mut self.work)?, y.over(&length, &mut self.work)?)))
    }

    pub(super) fn norm(&mut self, x: &Ratio, y: &Ratio) -> Worked<Ratio> {
        x.times(x, &mut self.work)?.plus(&y.times(y, &mut self.work)?, &mut self.work)
    }

    /// A vector (x, y) that points where the angle does.
    pub(super) fn direction(&mut self, t: &Turn) -> Worked<Option<(Ratio, Ratio)>> {
        let Some(linear) = t.to_linear() else { return Ok(None) };
        let Some((c, s)) = self.exact(linear).cos_sin() else { return Ok(None) };
        let (mut x, mut y): (Ratio, Ratio) = (c.into(), s.into());
        for (a, b, minus) in &t.sides {
            let b = if *minus { b.negated() } else { b.clone() };
            let w = &mut self.work;
            let next = x.times(a, w)?.minus(&y.times(&b, w)?, w)?;
            y = x.times(&b, w)?.plus(&y.times(a, w)?, w)?;
            x = next;
        }
        Ok(Some((x, y)))
    }

    /// The same angle with a constant that has an exact sine: others become angles with a name, `21.8deg`.
    pub(super) fn exact(&mut self, mut a: LinearAngle) -> LinearAngle {
        if a.constant.steps_of_15_degrees().is_some() {
            return a;
        }
        let degrees = a.constant.to_degrees();
        let negative = degrees.is_negative();
        let size = Angle::degrees(&degrees.abs());
        let known = self.constants.iter().find(|c| c.1 == size).map(|c| c.0);
        let v = known.unwrap_or_else(|| {
            let name = match Written::read(&format!("{}", degrees.abs().to_f64())) {
                Some(w) if w.value == degrees.abs() => format!("{}deg", degrees.abs().to_f64()),
                _ => format!("{:.4}deg", degrees.abs().to_f64()),
            };
            let v = self.ring.angle(&name);
            self.constants.push((v, size));
            v
        });
        a.terms.push((v, if negative { -1 } else { 1 }));
        a.constant = Angle::ZERO;
        a
    }
}
