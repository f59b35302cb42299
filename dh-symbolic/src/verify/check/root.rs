//! Square roots: symbols whose squares are known.

use super::Evaluator;
use super::ratio::{Ratio, Trouble, Worked};
use crate::algebra::{Factor, Poly, Rational};

impl Evaluator<'_> {
    /// The square root that is not negative.
    pub(super) fn root(&mut self, x: &Ratio) -> Worked<Ratio> {
        let x = self.reduce(x)?;
        if let Some(r) = x.as_rational().and_then(|x| root_of_number(&x)) {
            return Ok(r.into());
        }
        if let Some(known) = self.roots.iter().find(|r| r.radicand == x) {
            return Ok(Poly::symbol(known.symbol).into());
        }
        let inner = if x.den.is_one() {
            self.ring.text(&x.num)
        } else {
            format!("({})/({})", self.ring.text(&x.num), self.ring.text(&x.den))
        };
        let symbol = self.ring.symbol(&format!("sqrt({inner})"));
        self.roots.push(super::Root { symbol, radicand: x });
        Ok(Poly::symbol(symbol).into())
    }

    /// Puts the radicand in place of squares of roots, newest root first.
    pub(super) fn reduce(&mut self, x: &Ratio) -> Worked<Ratio> {
        let mut out = x.clone();
        for i in (0..self.roots.len()).rev() {
            let super::Root { symbol, radicand } = self.roots[i].clone();
            for top in [true, false] {
                let p = if top { &out.num } else { &out.den };
                let half = p.degree(symbol) / 2;
                if half == 0 {
                    continue;
                }
                let mut sum = Poly::zero();
                for (m, c) in p.collect(|f| matches!(f, Factor::Power(s, _) if *s == symbol)) {
                    let n = m.exponent(symbol);
                    let squares = self.work.power(&radicand.num, n / 2)?;
                    let rest = self.work.power(&radicand.den, half - n / 2)?;
                    let part = self.work.times(&c, &Poly::power(symbol, n % 2))?;
                    let part = self.work.times(&part, &squares)?;
                    sum = &sum + &self.work.times(&part, &rest)?;
                }
                let scale = self.work.power(&radicand.den, half)?;
                out = if top {
                    Ratio::new(sum, self.work.times(&out.den, &scale)?)?
                } else if sum.is_zero() {
                    return Err(Trouble::DivisionByZero);
                } else {
                    Ratio::new(self.work.times(&out.num, &scale)?, sum)?
                };
            }
        }
        Ok(out)
    }
}

/// The exact root of a positive rational, where it lies in Q(sqrt 2, sqrt 3).
fn root_of_number(x: &Rational) -> Option<Poly> {
    let (n, d) = x.to_small()?;
    // sqrt(n/d) = sqrt(n d)/d
    let mut rest = n.checked_mul(d).filter(|m| *m >= 0)?;
    if rest == 0 {
        return Some(Poly::zero());
    }
    let mut outside = 1i64;
    let mut p = 2i64;
    while p * p <= rest && p < 100_000 {
        while rest % (p * p) == 0 {
            rest /= p * p;
            outside *= p;
        }
        p += 1;
    }
    let root = match rest {
        1 => Poly::one(),
        2 => Poly::sqrt2(),
        3 => Poly::sqrt3(),
        6 => &Poly::sqrt2() * &Poly::sqrt3(),
        _ => return None,
    };
    Some(root.scale(&Rational::new(outside, d)?))
}
