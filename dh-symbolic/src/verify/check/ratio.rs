//! Quotients of formulas, with a budget of work: a line of a derivation may not cost seconds.

use crate::algebra::{Poly, Rational};

/// Products of terms that one line may cost: some tenths of a second where a macro runs unoptimised. A full PUMA product costs a few
/// thousand.
const BUDGET: u64 = 400_000;

/// Greatest multiple of an angle that may arise; the normal form is exact up to 127.
const ORDER: u32 = 100;

/// And a whole derivation.
const TOTAL: u64 = 4_000_000;

/// What is left of the budget.
#[derive(Clone, Debug)]
pub(super) struct Work {
    left: u64,
    later: u64,
}

/// The budget is spent, or a division by zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Trouble {
    TooLarge,
    DivisionByZero,
}

impl Trouble {
    pub(super) fn why(self) -> &'static str {
        match self {
            Trouble::TooLarge => "this formula grows too large when it is multiplied out",
            Trouble::DivisionByZero => "a division by zero",
        }
    }
}

pub(super) type Worked<T> = Result<T, Trouble>;

impl Work {
    pub(super) fn new() -> Work {
        Work { left: BUDGET, later: TOTAL }
    }

    /// The next line begins: it has its own budget, as long as the total lasts.
    pub(super) fn renew(&mut self) {
        self.later += self.left;
        self.left = BUDGET.min(self.later);
        self.later -= self.left;
    }

    fn spend(&mut self, cost: u64) -> Worked<()> {
        self.left = self.left.checked_sub(cost).ok_or(Trouble::TooLarge)?;
        Ok(())
    }

    /// The power of a formula.
    pub(super) fn power(&mut self, p: &Poly, n: u32) -> Worked<Poly> {
        (0..n).try_fold(Poly::one(), |x, _| self.times(&x, p))
    }

    /// The product of two formulas.
    pub(super) fn times(&mut self, a: &Poly, b: &Poly) -> Worked<Poly> {
        let (n, m) = (a.terms().len() as u64, b.terms().len() as u64);
        // two harmonics of one group become two terms
        let doublings = if n > 1 && m > 1 { common_groups(a, b) } else { 0 };
        let cost = n.saturating_mul(m) << doublings.min(12);
        self.spend(cost)?;
        let order = |p: &Poly| p.terms().iter().map(|(m, _)| u32::from(m.order())).max().unwrap_or(0);
        if order(a) + order(b) > ORDER {
            return Err(Trouble::TooLarge);
        }
        Ok(a * b)
    }
}

fn common_groups(a: &Poly, b: &Poly) -> usize {
    let groups = |p: &Poly| {
        let mut g: Vec<u16> = p.angles().into_iter().map(|v| v.group()).collect();
        g.dedup();
        g
    };
    let (g, h) = (groups(a), groups(b));
    g.iter().filter(|x| h.contains(x)).count()
}

/// `num / den`; `den` is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// Numerator.
    pub num: Poly,
    /// Denominator.
    pub den: Poly,
}

impl From<Poly> for Ratio {
    fn from(num: Poly) -> Ratio {
        Ratio { num, den: Poly::one() }
    }
}

impl Ratio {
    pub(super) fn zero() -> Ratio {
        Poly::zero().into()
    }

    pub(super) fn int(n: i64) -> Ratio {
        Poly::int(n).into()
    }

    pub(super) fn number(x: Rational) -> Ratio {
        Poly::constant(x).into()
    }

    /// `num / den`, with the simplest cases cancelled.
    pub(super) fn new(num: Poly, den: Poly) -> Worked<Ratio> {
        if den.is_zero() {
            return Err(Trouble::DivisionByZero);
        }
        if let Some(x) = den.as_rational().and_then(|x| x.recip()) {
            return Ok(num.scale(&x).into());
        }
        if num.is_zero() {
            return Ok(Ratio::zero());
        }
        match proportion(&num, &den) {
            Some(x) => Ok(Ratio::number(x)),
            None => Ok(Ratio { num, den }),
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        self.num.is_zero()
    }

    /// The formula, where nothing is divided by.
    pub(super) fn as_poly(&self) -> Option<&Poly> {
        self.den.is_one().then_some(&self.num)
    }

    pub(super) fn as_rational(&self) -> Option<Rational> {
        self.as_poly()?.as_rational()
    }

    pub(super) fn negated(&self) -> Ratio {
        Ratio { num: -&self.num, den: self.den.clone() }
    }

    pub(super) fn plus(&self, other: &Ratio, w: &mut Work) -> Worked<Ratio> {
        w.spend((self.num.terms().len() + other.num.terms().len()) as u64 / 8)?;
        if self.den == other.den {
            return Ratio::new(&self.num + &other.num, self.den.clone());
        }
        let (a, b) = (w.times(&self.num, &other.den)?, w.times(&other.num, &self.den)?);
        Ratio::new(&a + &b, w.times(&self.den, &other.den)?)
    }

    pub(super) fn minus(&self, other: &Ratio, w: &mut Work) -> Worked<Ratio> {
        self.plus(&other.negated(), w)
    }

    pub(super) fn times(&self, other: &Ratio, w: &mut Work) -> Worked<Ratio> {
        if self.num == other.den {
            return Ratio::new(other.num.clone(), self.den.clone());
        }
        if self.den == other.num {
            return Ratio::new(self.num.clone(), other.den.clone());
        }
        Ratio::new(w.times(&self.num, &other.num)?, w.times(&self.den, &other.den)?)
    }

    pub(super) fn over(&self, other: &Ratio, w: &mut Work) -> Worked<Ratio> {
        if other.is_zero() {
            return Err(Trouble::DivisionByZero);
        }
        self.times(&Ratio { num: other.den.clone(), den: other.num.clone() }, w)
    }

    pub(super) fn power(&self, n: u32, w: &mut Work) -> Worked<Ratio> {
        (0..n).try_fold(Ratio::int(1), |p, _| p.times(self, w))
    }

    /// Applies a substitution to both parts.
    pub(super) fn map(&self, f: impl Fn(&Poly) -> Poly) -> Worked<Ratio> {
        Ratio::new(f(&self.num), f(&self.den))
    }
}

/// x with a = x b, where b is not zero.
pub(super) fn proportion(a: &Poly, b: &Poly) -> Option<Rational> {
    let (first, other) = (a.terms().first()?, b.terms().first()?);
    if a.terms().len() != b.terms().len() || first.0 != other.0 {
        return None;
    }
    let x = &first.1 * &other.1.recip()?;
    (b.scale(&x) == *a).then_some(x)
}

/// Sum of products.
pub(super) fn dot<'a>(pairs: impl Iterator<Item = (&'a Ratio, &'a Ratio)>, w: &mut Work) -> Worked<Ratio> {
    let mut sum = Ratio::zero();
    for (a, b) in pairs {
        if !a.is_zero() && !b.is_zero() {
            sum = sum.plus(&a.times(b, w)?, w)?;
        }
    }
    Ok(sum)
}
