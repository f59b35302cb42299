//! A formula as it is meant to be read: sums, products and brackets in a chosen order, still made of the ring's symbols.

use crate::algebra::{AngleVar, Poly, Rational, Symbol};

/// A formula in reading order. It expands to exactly one [`Poly`]; many expressions expand to the same one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// A number that is not negative.
    Number(Rational),
    /// The square root of a small number (2, 3 or 6).
    Root(u8),
    /// A length, a sliding variable or an entry of a pose.
    Symbol(Symbol),
    /// A sine or cosine.
    Trig(Trig),
    /// A power with an exponent of 2 or more.
    Power(Box<Expression>, u32),
    /// A product of two or more factors.
    Product(Vec<Expression>),
    /// A sum; a negated formula is a sum of one negative summand. The empty sum is 0.
    Sum(Vec<Summand>),
}

/// One summand with its sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summand {
    /// Is it subtracted?
    pub negative: bool,
    /// What is added or subtracted.
    pub value: Expression,
}

/// The sine or cosine of an integer combination of angles.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Trig {
    /// The angles with their factors, in order; not empty.
    pub angles: Vec<(AngleVar, i8)>,
    /// Sine (or cosine)?
    pub sine: bool,
}

impl Expression {
    /// 0.
    pub fn zero() -> Expression {
        Expression::Sum(Vec::new())
    }

    /// The polynomial that the expression stands for: everything multiplied out.
    pub fn expand(&self) -> Poly {
        match self {
            Expression::Number(x) => Poly::constant(x.clone()),
            Expression::Root(2) => Poly::sqrt2(),
            Expression::Root(3) => Poly::sqrt3(),
            Expression::Root(_) => &Poly::sqrt2() * &Poly::sqrt3(),
            Expression::Symbol(s) => Poly::symbol(*s),
            Expression::Trig(w) => Poly::harmonic(&w.angles, w.sine),
            Expression::Power(base, n) => base.expand().pow(*n),
            Expression::Product(factors) => factors.iter().fold(Poly::one(), |p, f| &p * &f.expand()),
            Expression::Sum(list) => list
                .iter()
                .map(|s| {
                    let p = s.value.expand();
                    if s.negative { -&p } else { p }
                })
                .sum(),
        }
    }

    /// Is this 0?
    pub fn is_zero(&self) -> bool {
        matches!(self, Expression::Sum(list) if list.is_empty())
    }

    /// Calls `visit` for every leaf (number, root, symbol, sine or cosine), in reading order.
    pub fn leaves<'a>(&'a self, visit: &mut dyn FnMut(&'a Expression)) {
        match self {
            Expression::Power(base, _) => base.leaves(visit),
            Expression::Product(factors) => factors.iter().for_each(|f| f.leaves(visit)),
            Expression::Sum(list) => list.iter().for_each(|s| s.value.leaves(visit)),
            leaf => visit(leaf),
        }
    }

    /// Levels of brackets: 0 for a sum of plain products.
    pub fn depth(&self) -> usize {
        match self {
            Expression::Power(base, _) => base.depth() + usize::from(base.needs_brackets()),
            Expression::Product(factors) => {
                factors.iter().map(|f| f.depth() + usize::from(f.needs_brackets())).max().unwrap_or(0)
            }
            Expression::Sum(list) => list.iter().map(|s| s.value.depth()).max().unwrap_or(0),
            _ => 0,
        }
    }

    /// Must this stand in brackets as a factor?
    pub fn needs_brackets(&self) -> bool {
        matches!(self, Expression::Sum(list) if !list.is_empty())
    }
}
