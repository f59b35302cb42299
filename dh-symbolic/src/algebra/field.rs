//! Evaluation of formulas in a prime field, to test identities whose normal form would be too long to expand.
//!
//! p = 2^61 - 465 is a prime with p = 23 modulo 24, so that 2 and 3 have square roots, and the circle has its rational
//! parametrisation: cos = (1 - t^2) / (1 + t^2), sin = 2 t / (1 + t^2). Two different formulas of degree D agree at a random point with
//! probability at most D / p (Schwartz 1980; Zippel 1979): below 1e-15 for D = 2000, below 1e-60 at four points.

use super::{AngleVar, Factor, LinearAngle, Poly, Rational, Symbol};

const P: u64 = 2_305_843_009_213_693_487;
const ROOT_2: u64 = 1_986_480_468_971_546_878;
const ROOT_3: u64 = 1_111_797_624_405_771_273;

/// An element of the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element(u64);

impl Element {
    /// 0.
    pub const ZERO: Element = Element(0);
    /// 1.
    pub const ONE: Element = Element(1);

    /// Sum.
    #[must_use]
    pub fn plus(self, other: Element) -> Element {
        let x = self.0 + other.0;
        Element(if x >= P { x - P } else { x })
    }

    /// Negative.
    #[must_use]
    pub fn negative(self) -> Element {
        Element(if self.0 == 0 { 0 } else { P - self.0 })
    }

    /// Product.
    #[must_use]
    pub fn times(self, other: Element) -> Element {
        Element((u128::from(self.0) * u128::from(other.0) % u128::from(P)) as u64)
    }

    /// A power.
    #[must_use]
    pub fn power(self, mut n: u64) -> Element {
        let (mut x, mut base) = (Element::ONE, self);
        while n > 0 {
            if n & 1 == 1 {
                x = x.times(base);
            }
            base = base.times(base);
            n >>= 1;
        }
        x
    }

    /// 1 / self; 0 for 0.
    #[must_use]
    pub fn inverse(self) -> Element {
        self.power(P - 2)
    }

    fn of_rational(x: &Rational) -> Element {
        let (n, d) = x.modulo(P);
        if d == 1 { Element(n) } else { Element(n).times(Element(d).inverse()) }
    }
}

/// A point: a value for every symbol, a place on the circle for every angle.
#[derive(Clone, Copy, Debug)]
pub struct FieldPoint {
    seed: u64,
}

impl FieldPoint {
    /// The point number `n` of a fixed sequence.
    pub fn new(n: u64) -> FieldPoint {
        FieldPoint { seed: n.wrapping_mul(0xd134_2543_de82_ef95).wrapping_add(0x1234_5678_9abc_def1) }
    }

    /// SplitMix64 of the seed and a key.
    fn random(&self, key: u64) -> Element {
        let mut z = self.seed ^ key.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Element(((z ^ (z >> 31)) % (P - 2)) + 1)
    }

    /// Value of a symbol.
    pub fn symbol(&self, s: Symbol) -> Element {
        self.random(1 + u64::from(s.0))
    }

    /// (cos, sin) of an angle.
    fn angle(&self, v: AngleVar) -> (Element, Element) {
        let t = self.random(1 << 32 | u64::from(v.group) << 8 | u64::from(v.index));
        let square = t.times(t);
        let scale = Element::ONE.plus(square).inverse();
        (Element::ONE.plus(square.negative()).times(scale), t.plus(t).times(scale))
    }

    /// (cos, sin) of an integer combination.
    fn cos_sin_of_sum(&self, terms: &[(AngleVar, i8)]) -> (Element, Element) {
        let (mut c, mut s) = (Element::ONE, Element::ZERO);
        for (v, k) in terms {
            let (a, b) = self.angle(*v);
            let b = if *k < 0 { b.negative() } else { b };
            for _ in 0..k.unsigned_abs() {
                (c, s) = (c.times(a).plus(s.times(b).negative()), s.times(a).plus(c.times(b)));
            }
        }
        (c, s)
    }

    /// (cos, sin) of an angle sum; `None` where its constant part is no multiple of 15 degrees.
    pub fn cos_sin(&self, angle: &LinearAngle) -> Option<(Element, Element)> {
        let (c, s) = self.cos_sin_of_sum(&angle.terms);
        if angle.constant.is_zero() {
            return Some((c, s));
        }
        let (a, b) = angle.constant.cos_sin()?;
        let (a, b) = (self.value(&a), self.value(&b));
        Some((c.times(a).plus(s.times(b).negative()), s.times(a).plus(c.times(b))))
    }

    /// The value of a formula.
    pub fn value(&self, p: &Poly) -> Element {
        p.terms().iter().fold(Element::ZERO, |sum, (m, c)| {
            let term = m.factors().fold(Element::of_rational(c), |x, f| {
                x.times(match f {
                    Factor::Root(2) => Element(ROOT_2),
                    Factor::Root(_) => Element(ROOT_3),
                    Factor::Power(s, n) => self.symbol(s).power(u64::from(n)),
                    Factor::Cos(t) => self.cos_sin_of_sum(&t).0,
                    Factor::Sin(t) => self.cos_sin_of_sum(&t).1,
                })
            });
            sum.plus(term)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Angle, Ring};

    #[test]
    fn identities_hold_and_others_do_not() {
        let mut ring = Ring::new();
        let q = ring.angle("q1");
        let r = ring.angle_parallel_to(q, "q2");
        let at = FieldPoint::new(3);
        let ((c, s), (d, t)) = (Poly::cos_sin(q), Poly::cos_sin(r));
        let sum = Poly::harmonic(&[(q, 1), (r, 1)], false);
        let product = at.value(&c).times(at.value(&d)).plus(at.value(&s).times(at.value(&t)).negative());
        assert_eq!(at.value(&sum), product);
        assert_ne!(at.value(&sum), at.value(&c));
        for n in 0..24 {
            let (a, b) = Angle::degrees(&Rational::int(15 * n)).cos_sin().unwrap();
            let (x, y) = (at.value(&a), at.value(&b));
            assert_eq!(x.times(x).plus(y.times(y)), Element::ONE);
        }
        let third = Poly::constant(Rational::new(-1, 3).unwrap());
        assert_eq!(at.value(&third).times(Element(3)), Element::ONE.negative());
    }
}
