//! Canonical polynomials: sorted terms, no zero coefficients; ring operations.

use super::{AngleVar, Factor, Monomial, Rational, Symbol};

/// A formula in normal form. Two formulas are equal as functions exactly if their `Poly` are equal.
#[derive(Clone, PartialEq, Eq, Hash, Default, Debug)]
pub struct Poly {
    terms: Vec<(Monomial, Rational)>,
}

impl Poly {
    /// 0.
    pub fn zero() -> Poly {
        Poly { terms: Vec::new() }
    }

    /// 1.
    pub fn one() -> Poly {
        Poly::constant(Rational::ONE)
    }

    /// A rational number.
    pub fn constant(x: Rational) -> Poly {
        Poly::term(Monomial::one(), x)
    }

    /// One term.
    pub fn term(m: Monomial, x: Rational) -> Poly {
        if x.is_zero() { Poly::zero() } else { Poly { terms: vec![(m, x)] } }
    }

    /// The square root of 2.
    pub fn sqrt2() -> Poly {
        Poly::term(Monomial::root(2), Rational::ONE)
    }

    /// The square root of 3.
    pub fn sqrt3() -> Poly {
        Poly::term(Monomial::root(3), Rational::ONE)
    }

    /// A symbol to a power.
    pub fn power(s: Symbol, exponent: u32) -> Poly {
        Poly::term(Monomial::power(s, exponent), Rational::ONE)
    }

    /// cos (or sin) of an integer combination of angles *of one group*.
    pub fn harmonic(terms: &[(AngleVar, i8)], sine: bool) -> Poly {
        match Monomial::harmonic(terms, sine) {
            Some((m, flip)) => Poly::term(m, if flip { Rational::int(-1) } else { Rational::ONE }),
            None if sine => Poly::zero(),
            None => Poly::one(),
        }
    }

    /// Sorts and merges.
    pub fn from_terms(mut raw: Vec<(Monomial, Rational)>) -> Poly {
        if raw.len() > 1 {
            raw.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        }
        let mut terms: Vec<(Monomial, Rational)> = Vec::with_capacity(raw.len());
        for (m, c) in raw {
            match terms.last_mut() {
                Some(last) if last.0 == m => last.1 = &last.1 + &c,
                _ => {
                    if terms.last().is_some_and(|t| t.1.is_zero()) {
                        terms.pop();
                    }
                    terms.push((m, c));
                }
            }
        }
        if terms.last().is_some_and(|t| t.1.is_zero()) {
            terms.pop();
        }
        Poly { terms }
    }

    /// The terms in canonical order.
    pub fn terms(&self) -> &[(Monomial, Rational)] {
        &self.terms
    }

    /// Is this 0?
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Is this 1?
    pub fn is_one(&self) -> bool {
        self.as_rational().is_some_and(|x| x.is_one())
    }

    /// The value, where no symbol, angle or root occurs.
    pub fn as_rational(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::ZERO),
            [(m, c)] if m.is_one() => Some(c.clone()),
            _ => None,
        }
    }

    /// Product with a number.
    #[must_use]
    pub fn scale(&self, x: &Rational) -> Poly {
        if x.is_zero() {
            return Poly::zero();
        }
        if x.is_one() {
            return self.clone();
        }
        Poly { terms: self.terms.iter().map(|(m, c)| (m.clone(), c * x)).collect() }
    }

    /// a b + c d + ..., put together once.
    #[must_use]
    pub fn sum_of_products<'a>(pairs: impl Iterator<Item = (&'a Poly, &'a Poly)>) -> Poly {
        let mut raw = Vec::new();
        for (a, b) in pairs {
            a.multiply_into(b, &mut raw);
        }
        Poly::from_terms(raw)
    }

    /// Appends the terms of the product, in no order.
    fn multiply_into(&self, other: &Poly, raw: &mut Vec<(Monomial, Rational)>) {
        if self.is_one() {
            return raw.extend_from_slice(&other.terms);
        }
        if other.is_one() {
            return raw.extend_from_slice(&self.terms);
        }
        raw.reserve(self.terms.len() * other.terms.len());
        for (m, c) in &self.terms {
            for (n, d) in &other.terms {
                m.multiply_into(n, c * d, raw);
            }
        }
    }

    /// A non-negative power.
    #[must_use]
    pub fn pow(&self, n: u32) -> Poly {
        (0..n).fold(Poly::one(), |p, _| &p * self)
    }

    /// Does the angle occur?
    pub fn has_angle(&self, v: AngleVar) -> bool {
        self.terms.iter().any(|(m, _)| m.has_angle(v))
    }

    /// Does the symbol occur?
    pub fn has_symbol(&self, s: Symbol) -> bool {
        self.terms.iter().any(|(m, _)| m.exponent(s) > 0)
    }

    /// The angles that occur, in order.
    pub fn angles(&self) -> Vec<AngleVar> {
        let mut found = Vec::new();
        for (m, _) in &self.terms {
            for f in m.factors() {
                if let Factor::Cos(t) | Factor::Sin(t) = f {
                    found.extend(t.into_iter().map(|(v, _)| v));
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The symbols that occur, in order.
    pub fn symbols(&self) -> Vec<Symbol> {
        let mut found = Vec::new();
        for (m, _) in &self.terms {
            for f in m.factors() {
                if let Factor::Power(s, _) = f {
                    found.push(s);
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Highest power of a symbol.
    pub fn degree(&self, s: Symbol) -> u32 {
        self.terms.iter().map(|(m, _)| m.exponent(s)).max().unwrap_or(0)
    }

    /// Coefficients with respect to the factors that `chosen` picks: pairs (product of chosen factors, coefficient), in order.
    pub fn collect(&self, mut chosen: impl FnMut(&Factor) -> bool) -> Vec<(Monomial, Poly)> {
        let mut parts: Vec<(Monomial, Vec<(Monomial, Rational)>)> = Vec::new();
        for (m, c) in &self.terms {
            let key = m.filter(&mut chosen);
            let rest = m.filter(|f| !chosen(f));
            match parts.binary_search_by(|p| p.0.cmp(&key)) {
                Ok(i) => parts[i].1.push((rest, c.clone())),
                Err(i) => parts.insert(i, (key, vec![(rest, c.clone())])),
            }
        }
        parts.into_iter().map(|(m, t)| (m, Poly::from_terms(t))).collect()
    }
}

impl<'a> std::ops::Add<&'a Poly> for &Poly {
    type Output = Poly;
    fn add(self, other: &'a Poly) -> Poly {
        let (a, b) = (&self.terms, &other.terms);
        let mut terms = Vec::with_capacity(a.len() + b.len());
        let (mut i, mut j) = (0, 0);
        while i < a.len() && j < b.len() {
            match a[i].0.cmp(&b[j].0) {
                std::cmp::Ordering::Less => {
                    terms.push(a[i].clone());
                    i += 1;
                }
                std::cmp::Ordering::Greater => {
                    terms.push(b[j].clone());
                    j += 1;
                }
                std::cmp::Ordering::Equal => {
                    let c = &a[i].1 + &b[j].1;
                    if !c.is_zero() {
                        terms.push((a[i].0.clone(), c));
                    }
                    i += 1;
                    j += 1;
                }
            }
        }
        terms.extend_from_slice(&a[i..]);
        terms.extend_from_slice(&b[j..]);
        Poly { terms }
    }
}

impl<'a> std::ops::Sub<&'a Poly> for &Poly {
    type Output = Poly;
    fn sub(self, other: &'a Poly) -> Poly {
        self + &(-other)
    }
}

impl std::ops::Neg for &Poly {
    type Output = Poly;
    fn neg(self) -> Poly {
        Poly { terms: self.terms.iter().map(|(m, c)| (m.clone(), -c)).collect() }
    }
}

impl<'a> std::ops::Mul<&'a Poly> for &Poly {
    type Output = Poly;
    fn mul(self, other: &'a Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly::zero();
        }
        if self.is_one() {
            return other.clone();
        }
        if other.is_one() {
            return self.clone();
        }
        let mut raw = Vec::new();
        self.multiply_into(other, &mut raw);
        Poly::from_terms(raw)
    }
}

impl std::iter::Sum for Poly {
    fn sum<I: Iterator<Item = Poly>>(iter: I) -> Poly {
        let mut raw = Vec::new();
        for p in iter {
            raw.extend(p.terms);
        }
        Poly::from_terms(raw)
    }
}
