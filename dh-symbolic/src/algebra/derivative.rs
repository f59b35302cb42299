//! Partial derivatives of formulas, by a symbol or by an angle.

use super::{AngleVar, Factor, Monomial, Poly, Rational, Symbol};

impl Poly {
    /// d/ds.
    #[must_use]
    pub fn derivative_by_symbol(&self, s: Symbol) -> Poly {
        self.terms()
            .iter()
            .filter(|(m, _)| m.exponent(s) > 0)
            .map(|(m, c)| {
                let n = m.exponent(s);
                let rest = m.filter(|f| !matches!(f, Factor::Power(x, _) if *x == s));
                &Poly::term(rest, c * &Rational::int(i64::from(n))) * &Poly::power(s, n - 1)
            })
            .sum()
    }

    /// d/dv, per radian.
    #[must_use]
    pub fn derivative_by_angle(&self, v: AngleVar) -> Poly {
        self.terms().iter().filter(|(m, _)| m.has_angle(v)).map(|(m, c)| derivative_of_term(m, c, v)).sum()
    }
}

/// At most one factor of a monomial holds the angle: there is one harmonic per group.
fn derivative_of_term(m: &Monomial, c: &Rational, v: AngleVar) -> Poly {
    let holds = |f: &Factor| match f {
        Factor::Cos(t) | Factor::Sin(t) => t.iter().any(|(x, _)| *x == v),
        _ => false,
    };
    let rest = Poly::term(m.filter(|f| !holds(f)), c.clone());
    let factor =
        |t: &[(AngleVar, i8)]| Rational::int(t.iter().find(|(x, _)| *x == v).map_or(0, |(_, k)| i64::from(*k)));
    m.factors()
        .find(holds)
        .map(|f| match f {
            Factor::Cos(t) => (&rest * &Poly::harmonic(&t, true)).scale(&-&factor(&t)),
            Factor::Sin(t) => (&rest * &Poly::harmonic(&t, false)).scale(&factor(&t)),
            _ => Poly::zero(),
        })
        .unwrap_or_default()
}
