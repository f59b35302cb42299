//! From expressions to typeset mathematics: brackets, signs, fractions, names.

use super::expression::Expression;
use super::math::{Math, Sign};
use super::notation::Notation;
use crate::algebra::Rational;

/// Brackets from the inside out.
const BRACKETS: [(char, char); 3] = [('(', ')'), ('[', ']'), ('{', '}')];

impl Notation {
    /// The expression as typeset.
    pub fn typeset(&self, e: &Expression) -> Math {
        match e {
            Expression::Number(x) => number(x),
            Expression::Root(n) => Math::Root(Box::new(Math::number(n))),
            Expression::Symbol(s) => self.symbol(*s),
            Expression::Trig(w) => self.trig(w),
            Expression::Power(base, n) => self.power(base, *n),
            Expression::Product(factors) => self.product(factors),
            Expression::Sum(list) if list.is_empty() => Math::number(0),
            Expression::Sum(list) => {
                let mut row = Vec::new();
                for s in list {
                    match (row.is_empty(), s.negative) {
                        (true, false) => {}
                        (true, true) => row.push(Math::Sign(Sign::Negative)),
                        (false, negative) => row.push(Math::Sign(if negative { Sign::Minus } else { Sign::Plus })),
                    }
                    row.push(if s.value.needs_brackets() { self.bracket(&s.value) } else { self.typeset(&s.value) });
                }
                Math::Row(row)
            }
        }
    }

    fn bracket(&self, e: &Expression) -> Math {
        let (open, close) = BRACKETS[e.depth() % BRACKETS.len()];
        Math::Row(vec![Math::Open(open), self.typeset(e), Math::Close(close)])
    }

    fn power(&self, base: &Expression, n: u32) -> Math {
        let exponent = Math::number(n);
        if base.needs_brackets() {
            return Math::Row(vec![self.bracket(base).above(exponent)]);
        }
        match (base, self.typeset(base)) {
            // c alpha^2 would square the angle
            (Expression::Trig(_), Math::Row(row)) => match row.split_first() {
                Some((letter @ Math::Letter(_), rest)) => {
                    let mut row = vec![letter.clone().above(exponent)];
                    row.extend(rest.iter().cloned());
                    Math::Row(row)
                }
                Some((name @ Math::Word(_), rest)) => {
                    let mut row = vec![name.clone().above(exponent)];
                    row.extend(rest.iter().cloned());
                    Math::Row(row)
                }
                _ => Math::Row(row).in_brackets().above(exponent),
            },
            (_, plain) => plain.above(exponent),
        }
    }

    fn product(&self, factors: &[Expression]) -> Math {
        let mut row: Vec<Math> = Vec::new();
        let mut rest = factors;
        // number and root make one fraction: sqrt(2)/2
        if let [Expression::Number(x), Expression::Root(n), tail @ ..] = factors {
            row.push(rooted(x, *n));
            rest = tail;
        }
        let mut loose = false;
        for f in rest {
            let piece = if f.needs_brackets() { self.bracket(f) } else { self.typeset(f) };
            let wordy = is_wordy(&piece);
            if (wordy || loose) && !row.is_empty() && !matches!(f, Expression::Sum(_)) {
                row.push(Math::Sign(Sign::Times));
            }
            loose = wordy;
            row.push(piece);
        }
        Math::Row(row)
    }

    /// Sign and magnitude of an exact angle, in half turns.
    pub(in crate::render) fn exact_angle(&self, half_turns: &Rational) -> (bool, Math) {
        let x = half_turns.abs();
        if !self.style.radians {
            let degrees = number(&(&x * &Rational::int(180)));
            return (half_turns.is_negative(), Math::Row(vec![degrees, Math::Sign(Sign::Degree)]));
        }
        let pi = Math::Letter('π');
        let m = match (x.is_zero(), x.to_small()) {
            (true, _) => Math::number(0),
            (_, Some((1, 1))) => pi,
            (_, Some((n, 1))) => Math::Row(vec![Math::number(n), pi]),
            (_, Some((1, d))) => Math::Fraction(Box::new(pi), Box::new(Math::number(d))),
            (_, Some((n, d))) => {
                Math::Fraction(Box::new(Math::Row(vec![Math::number(n), pi])), Box::new(Math::number(d)))
            }
            (_, None) => Math::Row(vec![number(&x), pi]),
        };
        (half_turns.is_negative(), m)
    }
}

/// Would a neighbour run into this piece?
fn is_wordy(piece: &Math) -> bool {
    match piece {
        Math::Word(_) => true,
        Math::Script(s) => is_wordy(&s.base),
        Math::Row(list) => list.first().is_some_and(is_wordy),
        _ => false,
    }
}

/// A number that is not negative: an integer, a decimal, a fraction.
pub(in crate::render) fn number(x: &Rational) -> Math {
    let text = x.to_string();
    match text.split_once('/') {
        None => Math::Number(text),
        Some((n, d)) if d.len() > 1 => match decimal(x) {
            Some(short) => Math::Number(short),
            None => Math::Fraction(Box::new(Math::number(n)), Box::new(Math::number(d))),
        },
        Some((n, d)) => Math::Fraction(Box::new(Math::number(n)), Box::new(Math::number(d))),
    }
}

fn rooted(x: &Rational, root: u8) -> Math {
    let sign = Math::Root(Box::new(Math::number(root)));
    let text = x.to_string();
    let (n, d) = text.split_once('/').unwrap_or((&text, "1"));
    let top = if n == "1" { sign } else { Math::Row(vec![Math::number(n), sign]) };
    if d == "1" { top } else { Math::Fraction(Box::new(top), Box::new(Math::number(d))) }
}

/// A finite decimal, digit by digit; `None` where there is none.
pub(crate) fn decimal(x: &Rational) -> Option<String> {
    let (n, d) = x.to_small()?;
    let (mut left, mut places, mut scale) = (d, 0usize, 1i128);
    let (mut twos, mut fives) = (0u32, 0u32);
    while left % 2 == 0 {
        left /= 2;
        twos += 1;
    }
    while left % 5 == 0 {
        left /= 5;
        fives += 1;
    }
    if left != 1 || twos.max(fives) > 18 {
        return None;
    }
    for _ in 0..twos.max(fives) {
        scale *= 10;
        places += 1;
    }
    let digits = (i128::from(n).unsigned_abs() * (scale as u128) / (d.unsigned_abs() as u128)).to_string();
    let sign = if n < 0 { "-" } else { "" };
    if places == 0 {
        return Some(format!("{sign}{digits}"));
    }
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    Some(format!("{sign}{whole}.{fraction}"))
}
