//! Compares two values in the normal form; where a square root or an angle leaves a sign open, finds the condition.

use super::ratio::{Ratio, Worked};
use super::refusal::{At, Understood, refuse};
use super::value::{Matrix, Turn, Value};
use super::{Condition, Evaluator};
use crate::algebra::{Factor, Monomial, Poly, Rational, Symbol};
use crate::chain::{Handle, Nominal, Role};
use crate::verify::language::Place;

/// The result of comparing two numbers or angles.
pub(super) enum Outcome {
    /// Equal, under these conditions.
    Same(Vec<Condition>),
    /// Not equal: the first, the second, and their difference, after the table's numbers were put in where that was needed.
    Differs(Box<[Ratio; 3]>),
    /// Two angles that are not equal: a formula that would be zero if they were.
    Turned(Ratio),
    /// Two angles that differ by half a turn.
    Opposite,
    /// The normal form cannot tell.
    Open(String),
}

/// Two values brought to one form.
pub(super) enum Pair {
    Scalars(Ratio, Ratio),
    Turns(Turn, Turn),
    Matrices(Matrix, Matrix),
}

impl Evaluator<'_> {
    /// Brings two values to one form.
    pub(super) fn pair(&mut self, a: Value, b: Value, place: &Place) -> Understood<Pair> {
        Ok(match (a, b) {
            (Value::Matrix(m), Value::Matrix(n)) => {
                let (m, n) = (without_translation(m, &n), n);
                let n = without_translation(n, &m);
                let (m, n) = match (m, n) {
                    (m, n) if m.is(3, 1) && n.is(4, 1) => (m.homogeneous(), n),
                    (m, n) if m.is(4, 1) && n.is(3, 1) => (m, n.homogeneous()),
                    same => same,
                };
                if !m.is(n.rows(), n.columns) {
                    return refuse(place, format!("a {} and a {} matrix cannot be equal", m.shape(), n.shape()));
                }
                Pair::Matrices(m, n)
            }
            (Value::Matrix(m), Value::Scalar(x)) if x.is_zero() => Pair::Matrices(m.clone(), zeros(&m)),
            (Value::Scalar(x), Value::Matrix(m)) if x.is_zero() => Pair::Matrices(zeros(&m), m),
            (Value::Matrix(m), v) | (v, Value::Matrix(m)) => {
                return refuse(place, format!("a {} matrix and {} cannot be equal", m.shape(), v.what()));
            }
            (Value::Angle(t), Value::Angle(u)) => Pair::Turns(t, u),
            (Value::Angle(t), Value::Scalar(x)) if x.is_zero() => {
                Pair::Turns(t, Turn::constant(crate::algebra::Angle::ZERO))
            }
            (Value::Scalar(x), Value::Angle(t)) if x.is_zero() => {
                Pair::Turns(Turn::constant(crate::algebra::Angle::ZERO), t)
            }
            (a, b) => Pair::Scalars(self.scalar(a, place)?, self.scalar(b, place)?),
        })
    }

    /// Puts exact numbers in place of the symbols that numeric cells and constants gave rise to.
    pub(super) fn with_numbers(&self, x: &Ratio) -> Worked<Ratio> {
        let value = |s: Symbol| {
            let p = self.chain.parameters.iter().find(|p| p.handle == Handle::Length(s))?;
            match &p.role {
                Role::Constant(Nominal::Length(x)) => Some(Poly::constant(x.clone())),
                _ => None,
            }
        };
        x.map(|p| p.substitute_symbols(value))
    }

    pub(super) fn compare_scalars(&mut self, a: &Ratio, b: &Ratio, place: &Place) -> Understood<Outcome> {
        if a == b {
            return Ok(Outcome::Same(vec![]));
        }
        let difference = a.minus(b, &mut self.work).at(place)?;
        let reduced = self.reduce(&difference).at(place)?;
        if reduced.is_zero() {
            return Ok(Outcome::Same(vec![]));
        }
        let numeric = self.with_numbers(&reduced).at(place)?;
        let numeric = self.reduce(&numeric).at(place)?;
        if numeric.is_zero() {
            return Ok(Outcome::Same(vec![]));
        }
        if let Some(balance) = self.up_to_sign(&numeric).at(place)? {
            return Ok(match self.positivity(balance.value, false).at(place)? {
                Sign::Positive => Outcome::Same(vec![]),
                Sign::Depends(c) => Outcome::Same(vec![c]),
                Sign::Negative => Outcome::Differs(Box::new([a.clone(), b.clone(), numeric])),
            });
        }
        if self.is_zero_in_numbers(&numeric) {
            return Ok(Outcome::Open("both sides agree in numbers, but the normal form cannot prove it".into()));
        }
        // the book's letters where they say it as shortly
        if reduced.num.terms().len() <= numeric.num.terms().len() {
            return Ok(Outcome::Differs(Box::new([a.clone(), b.clone(), reduced])));
        }
        let (a, b) = (self.with_numbers(a).at(place)?, self.with_numbers(b).at(place)?);
        Ok(Outcome::Differs(Box::new([a, b, numeric])))
    }

    /// `A m + B n` with products m, n of roots: it is zero exactly if m/n = -B/A, where that is not negative. Gives m, n and -B/A.
    fn up_to_sign(&mut self, x: &Ratio) -> Worked<Option<Balance>> {
        let roots: Vec<super::Root> = self.roots.iter().filter(|r| x.num.has_symbol(r.symbol)).cloned().collect();
        let parts = x.num.collect(|f| matches!(f, Factor::Power(s, _) if roots.iter().any(|r| r.symbol == *s)));
        let [(n, b), (m, a)] = parts.as_slice() else { return Ok(None) };
        // A^2 m^2 = B^2 n^2
        let mut sides = [Ratio::from(self.work.times(a, a)?), Ratio::from(self.work.times(b, b)?)];
        for (side, powers) in sides.iter_mut().zip([m, n]) {
            for r in &roots {
                let square = r.radicand.power(powers.exponent(r.symbol), &mut self.work)?;
                *side = side.times(&square, &mut self.work)?;
            }
        }
        let [left, right] = &sides;
        let difference = left.minus(right, &mut self.work)?;
        if !self.reduce(&difference)?.is_zero() {
            return Ok(None);
        }
        Ok(Some(Balance { m: m.clone(), n: n.clone(), value: Ratio::new(-b, a.clone())? }))
    }

    /// Puts `n value` in place of `m`.
    fn balanced(&mut self, x: &Ratio, balance: &Balance) -> Worked<Ratio> {
        let roots: Vec<Symbol> = self.roots.iter().map(|r| r.symbol).collect();
        let mut parts = [Ratio::zero(), Ratio::zero()];
        for (part, p) in parts.iter_mut().zip([&x.num, &x.den]) {
            for (powers, c) in p.collect(|f| matches!(f, Factor::Power(s, _) if roots.contains(s))) {
                let own = if powers == balance.m { balance.n.clone() } else { powers.clone() };
                let mut term = Ratio::from(self.work.times(&Poly::term(own, Rational::ONE), &c)?);
                if powers == balance.m {
                    term = term.times(&balance.value, &mut self.work)?;
                }
                *part = part.plus(&term, &mut self.work)?;
            }
        }
        let [num, den] = parts;
        num.over(&den, &mut self.work)
    }

    /// Is a formula that is to be positive (`strict`) or at least zero so by itself? Even powers and roots are.
    fn positivity(&mut self, x: Ratio, strict: bool) -> Worked<Sign> {
        let roots: Vec<Symbol> = self.roots.iter().map(|r| r.symbol).collect();
        let mut number = Rational::ONE;
        let mut odd: Vec<(Poly, u32)> = Vec::new();
        for p in [&x.num, &x.den] {
            let (k, factors) = p.factors();
            number = &number * &k;
            for (f, n) in factors {
                let is_root = matches!(f.terms(), [(m, _)] if m.factors().all(|a| matches!(a, Factor::Power(s, _) if roots.contains(&s)) || matches!(a, Factor::Root(_))));
                if is_root || f.is_sum_of_squares() {
                    continue;
                }
                match odd.iter_mut().find(|o| o.0 == f) {
                    Some(o) => o.1 += n,
                    None => odd.push((f, n)),
                }
            }
        }
        let rest = odd.iter().filter(|o| o.1 % 2 == 1).fold(Poly::one(), |p, o| &p * &o.0);
        let rest = if number.is_negative() { -&rest } else { rest };
        Ok(match rest.as_rational() {
            Some(x) if x.is_negative() => Sign::Negative,
            Some(_) => Sign::Positive,
            None => Sign::Depends(Condition { formula: rest, strict }),
        })
    }

    /// Angles are compared modulo a whole turn.
    pub(super) fn compare_turns(&mut self, a: &Turn, b: &Turn, place: &Place) -> Understood<Outcome> {
        let difference = a.plus(&b.negated());
        if difference.is_zero() {
            return Ok(Outcome::Same(vec![]));
        }
        if difference.sides.is_empty() {
            if difference.terms.is_empty() {
                let turns = difference.constant.factor() * &Rational::HALF;
                if turns.to_i64().is_some() {
                    return Ok(Outcome::Same(vec![]));
                }
            }
            return Ok(Outcome::Turned(self.scalar(Value::Angle(difference), place)?));
        }
        let Some((x, y)) = self.direction(&difference).at(place)? else {
            return refuse(place, "only whole multiples of angles can be compared with an atan2");
        };
        let (mut x, y) = (self.reduce(&x).at(place)?, self.reduce(&y).at(place)?);
        let mut conditions = Vec::new();
        let y = self.with_numbers(&y).at(place)?;
        let y = self.reduce(&y).at(place)?;
        if !y.is_zero() {
            let Some(balance) = self.up_to_sign(&y).at(place)? else {
                if self.is_zero_in_numbers(&y) {
                    return Ok(Outcome::Open(
                        "both angles agree in numbers, but the normal form cannot prove it".into(),
                    ));
                }
                return Ok(Outcome::Turned(y));
            };
            match self.positivity(balance.value.clone(), false).at(place)? {
                Sign::Positive => {}
                Sign::Depends(c) => conditions.push(c),
                Sign::Negative => return Ok(Outcome::Opposite),
            }
            let known = self.balanced(&x, &balance).at(place)?;
            x = self.reduce(&known).at(place)?;
        }
        // |x| is the product of the sides' lengths; x itself may be one of their squares
        for (p, q, _) in &difference.sides {
            let norm = self.norm(p, q).at(place)?;
            let norm = self.reduce(&norm).at(place)?;
            let ratio = x.over(&norm, &mut self.work).at(place)?;
            if matches!(self.positivity(ratio, true).at(place)?, Sign::Positive) {
                return Ok(Outcome::Same(conditions));
            }
        }
        Ok(match self.positivity(x, true).at(place)? {
            Sign::Positive => Outcome::Same(conditions),
            Sign::Negative => Outcome::Opposite,
            Sign::Depends(c) => {
                if !conditions.contains(&c) {
                    conditions.push(c);
                }
                Outcome::Same(conditions)
            }
        })
    }
}

/// Products of roots whose ratio is known: m = n value.
struct Balance {
    m: Monomial,
    n: Monomial,
    value: Ratio,
}

enum Sign {
    Positive,
    Negative,
    Depends(Condition),
}

/// The rotation of a transform without translation, where the other side is 3x3.
pub(super) fn without_translation(m: Matrix, other: &Matrix) -> Matrix {
    let pure = m.is_homogeneous() && other.is(3, 3) && (0..3).all(|i| m.at(i, 3).is_zero());
    if pure { m.block(3, 0..3) } else { m }
}

fn zeros(m: &Matrix) -> Matrix {
    Matrix { columns: m.columns, entries: m.entries.iter().map(|_| Ratio::zero()).collect() }
}
