//! Variables of a formula: putting others in their place, and derivatives by them.

use super::Evaluator;
use super::ratio::{Ratio, Worked};
use super::refusal::{At, Understood, refuse};
use super::value::{Matrix, Turn, Value};
use crate::algebra::{AngleVar, Factor, LinearAngle, Poly, Rational, Symbol};
use crate::verify::language::{Expr, Place};

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
                [Factor::Power(s, 1)] => Some(Variable::Symbol(*s, c.is_one())),
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

/// One variable in terms of what replaces it.
struct Replacement {
    symbols: Vec<(Symbol, Ratio)>,
    angles: Vec<(AngleVar, LinearAngle)>,
}

impl Evaluator<'_> {
    pub(super) fn derivative(&mut self, e: &Expr, v: &Expr, place: &Place) -> Understood<Value> {
        let by = self.variable(v)?;
        let value = self.evaluate(e)?;
        match value {
            Value::Scalar(x) => Ok(Value::Scalar(self.slope(&x, &by, self.roots.len()).at(place)?)),
            Value::Matrix(m) => {
                let roots = self.roots.len();
                let entries = m.entries.iter().map(|x| self.slope(x, &by, roots)).collect::<Worked<_>>().at(place)?;
                Ok(Value::Matrix(Matrix { columns: m.columns, entries }))
            }
            Value::Angle(t) => Ok(Value::Scalar(self.slope_of_angle(&t, &by).at(place)?)),
        }
    }

    /// The derivative of a number; only the first `roots` roots are known to depend on anything.
    fn slope(&mut self, x: &Ratio, by: &Variable, roots: usize) -> Worked<Ratio> {
        let own = |p: &Poly| match by {
            Variable::Symbol(s, _) => p.derivative_by_symbol(*s),
            Variable::Angle(v, _) => p.derivative_by_angle(*v),
        };
        let quotient = |d: &dyn Fn(&Poly) -> Poly, w: &mut super::ratio::Work| {
            let top = &w.times(&d(&x.num), &x.den)? - &w.times(&x.num, &d(&x.den))?;
            Ratio::new(top, w.times(&x.den, &x.den)?)
        };
        let mut sum =
            quotient(&own, &mut self.work)?.times(&Ratio::int(if by.positive() { 1 } else { -1 }), &mut self.work)?;
        for i in 0..roots {
            let Some(super::Root { symbol, radicand }) = self.roots.get(i).cloned() else { continue };
            if !x.num.has_symbol(symbol) && !x.den.has_symbol(symbol) {
                continue;
            }
            // (sqrt r)' = r' / (2 sqrt r); roots inside of r are older
            let inner = self.slope(&radicand, by, i)?;
            let twice = Ratio::from(Poly::symbol(symbol)).times(&Ratio::int(2), &mut self.work)?;
            let by_root = quotient(&|p: &Poly| p.derivative_by_symbol(symbol), &mut self.work)?;
            let part = by_root.times(&inner.over(&twice, &mut self.work)?, &mut self.work)?;
            sum = sum.plus(&part, &mut self.work)?;
        }
        Ok(sum)
    }

    /// The derivative of an angle, in radians.
    fn slope_of_angle(&mut self, t: &Turn, by: &Variable) -> Worked<Ratio> {
        let mut sum = match by {
            Variable::Angle(v, _) => {
                let own = t.terms.iter().find(|x| x.0 == *v).map_or(Rational::ZERO, |x| x.1.clone());
                Ratio::number(own)
            }
            Variable::Symbol(..) => Ratio::zero(),
        };
        let roots = self.roots.len();
        for (x, y, minus) in &t.sides {
            // atan2(y, x)' = (x y' - y x')/(x^2 + y^2)
            let (dx, dy) = (self.slope(x, by, roots)?, self.slope(y, by, roots)?);
            let left = x.times(&dy, &mut self.work)?;
            let right = y.times(&dx, &mut self.work)?;
            let top = left.minus(&right, &mut self.work)?;
            let norm = self.norm(x, y)?;
            let norm = self.reduce(&norm)?;
            let part = top.over(&norm, &mut self.work)?;
            sum = if *minus { sum.minus(&part, &mut self.work)? } else { sum.plus(&part, &mut self.work)? };
        }
        Ok(sum)
    }

    /// The one variable that a name stands for.
    fn variable(&mut self, e: &Expr) -> Understood<Variable> {
        let v = self.evaluate(e)?;
        match variable_of(&v) {
            Some(v) => Ok(v),
            None => refuse(&e.place, "this is no single variable"),
        }
    }

    pub(super) fn substitution(&mut self, arguments: &[(Option<String>, Expr)], place: &Place) -> Understood<Value> {
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
        for (m, c) in p.collect(|f| matches!(f, Factor::Power(s, _) if is_hit(*s))) {
            let mut part = Ratio::from(c);
            for (s, x) in symbols {
                part = part.times(&x.power(m.exponent(*s), &mut self.work)?, &mut self.work)?;
            }
            sum = sum.plus(&part, &mut self.work)?;
        }
        Ok(sum)
    }
}
