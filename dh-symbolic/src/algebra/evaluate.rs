//! Numeric evaluation of a formula at a point, the only use of floating point in the algebra.

use super::{AngleVar, Factor, Poly, Symbol};

/// Values for symbols and angles (radians).
pub struct Point<'a> {
    /// Value of a symbol.
    pub symbol: &'a dyn Fn(Symbol) -> f64,
    /// Value of an angle in radians.
    pub angle: &'a dyn Fn(AngleVar) -> f64,
}

impl Poly {
    /// The value at a point.
    pub fn evaluate(&self, at: &Point<'_>) -> f64 {
        let angle_sum = |t: &[(AngleVar, i8)]| t.iter().map(|(v, k)| f64::from(*k) * (at.angle)(*v)).sum::<f64>();
        let term = |(m, c): &(super::Monomial, super::Rational)| {
            m.factors().fold(c.to_f64(), |x, f| {
                x * match f {
                    Factor::Root(n) => f64::from(n).sqrt(),
                    Factor::Power(s, n) => (at.symbol)(s).powi(n as i32),
                    Factor::Cos(t) => angle_sum(&t).cos(),
                    Factor::Sin(t) => angle_sum(&t).sin(),
                }
            })
        };
        // The empty sum of floats is -0.0.
        self.terms().iter().map(term).sum::<f64>() + 0.0
    }
}
