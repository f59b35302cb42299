//! Exact rational numbers: machine integers while they fit, big integers behind them.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::fmt;

/// An exact rational number in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Repr);

/// `Small` whenever both parts fit, so equality of representations is equality of numbers.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Small(i64, i64),
    Big(Box<(BigInt, BigInt)>),
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        if let (Ok(x), Ok(y)) = (u64::try_from(a), u64::try_from(b)) {
            return u128::from(gcd64(x, y));
        }
        (a, b) = (b, a % b);
    }
    a
}

fn gcd64(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl Rational {
    /// Zero.
    pub const ZERO: Rational = Rational(Repr::Small(0, 1));
    /// One.
    pub const ONE: Rational = Rational(Repr::Small(1, 1));
    /// One half.
    pub const HALF: Rational = Rational(Repr::Small(1, 2));

    /// `num / den`; `None` where `den` is zero.
    pub fn new(num: i64, den: i64) -> Option<Rational> {
        (den != 0).then(|| Rational::from_i128(i128::from(num), i128::from(den)))
    }

    /// An integer.
    pub const fn int(n: i64) -> Rational {
        if n == i64::MIN { Rational(Repr::Small(n + 1, 1)) } else { Rational(Repr::Small(n, 1)) }
    }

    fn from_i128(num: i128, den: i128) -> Rational {
        let g = gcd(num.unsigned_abs(), den.unsigned_abs());
        let g = if g == 0 { 1 } else { g };
        // Both are below 2^127 in absolute value: they come from products of two i64 and a sum of two such products.
        let (mut n, mut d) = (num / g as i128, den / g as i128);
        if d < 0 {
            (n, d) = (-n, -d);
        }
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Rational(Repr::Small(n, d)),
            _ => Rational(Repr::Big(Box::new((BigInt::from(n), BigInt::from(d))))),
        }
    }

    fn from_big(num: BigInt, den: BigInt) -> Rational {
        let g = num.gcd(&den);
        let (mut n, mut d) = if g.is_zero() { (num, BigInt::one()) } else { (num / &g, den / &g) };
        if d.is_negative() {
            (n, d) = (-n, -d);
        }
        match (n.to_i64(), d.to_i64()) {
            (Some(n), Some(d)) if n != i64::MIN => Rational(Repr::Small(n, d)),
            _ => Rational(Repr::Big(Box::new((n, d)))),
        }
    }

    fn parts(&self) -> (BigInt, BigInt) {
        match &self.0 {
            Repr::Small(n, d) => (BigInt::from(*n), BigInt::from(*d)),
            Repr::Big(b) => (b.0.clone(), b.1.clone()),
        }
    }

    /// Reads decimal digits exactly: `12`, `0.4318`, `1_000.5`, `1e-3`. `None` where the text is no such number, or has more than
    /// 400 digits or an exponent beyond 400 (such numbers are no lengths of robots, and would only cost time).
    pub fn from_decimal(text: &str) -> Option<Rational> {
        let clean: String = text.chars().filter(|c| *c != '_').collect();
        let (mantissa, exponent) = match clean.find(['e', 'E']) {
            Some(i) => (&clean[..i], clean[i + 1..].parse::<i32>().ok()?),
            None => (clean.as_str(), 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        let fine = !whole.is_empty() && digits.len() <= 400 && digits.bytes().all(|b| b.is_ascii_digit());
        if !fine || exponent.unsigned_abs() > 400 {
            return None;
        }
        let power = exponent - i32::try_from(fraction.len()).ok()?;
        let n = BigInt::parse_bytes(digits.as_bytes(), 10)?;
        let scale = BigInt::from(10).pow(power.unsigned_abs());
        Some(if power >= 0 { Rational::from_big(n * scale, BigInt::one()) } else { Rational::from_big(n, scale) })
    }

    /// Is this zero?
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Repr::Small(0, _))
    }

    /// Is this one?
    pub fn is_one(&self) -> bool {
        matches!(self.0, Repr::Small(1, 1))
    }

    /// Is this below zero?
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Small(n, _) => *n < 0,
            Repr::Big(b) => b.0.is_negative(),
        }
    }

    /// The value as a machine integer, where it is one.
    pub fn to_i64(&self) -> Option<i64> {
        match &self.0 {
            Repr::Small(n, 1) => Some(*n),
            _ => None,
        }
    }

    /// Numerator and denominator, where both are machine integers.
    pub fn to_small(&self) -> Option<(i64, i64)> {
        match &self.0 {
            Repr::Small(n, d) => Some((*n, *d)),
            Repr::Big(_) => None,
        }
    }

    /// (numerator, denominator) modulo a prime below 2^63.
    pub(super) fn modulo(&self, p: u64) -> (u64, u64) {
        match &self.0 {
            Repr::Small(n, d) => {
                let n = i128::from(*n).rem_euclid(i128::from(p));
                (n as u64, *d as u64 % p)
            }
            Repr::Big(b) => {
                let p = BigInt::from(p);
                (b.0.mod_floor(&p).to_u64().unwrap_or(0), b.1.mod_floor(&p).to_u64().unwrap_or(1))
            }
        }
    }

    /// The absolute value.
    pub fn abs(&self) -> Rational {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// 1 / self; `None` for zero.
    pub fn recip(&self) -> Option<Rational> {
        match &self.0 {
            Repr::Small(0, _) => None,
            Repr::Small(n, d) => Some(Rational::from_i128(i128::from(*d), i128::from(*n))),
            Repr::Big(b) => Some(Rational::from_big(b.1.clone(), b.0.clone())),
        }
    }

    /// The greatest integer not above this number.
    pub fn floor(&self) -> Rational {
        let (n, d) = self.parts();
        Rational::from_big(n.div_floor(&d), BigInt::one())
    }

    /// The nearest `f64` (correctly rounded).
    pub fn to_f64(&self) -> f64 {
        const EXACT: i64 = 1 << 53;
        if let Repr::Small(n, d) = &self.0
            && n.abs() <= EXACT
            && *d <= EXACT
        {
            return *n as f64 / *d as f64;
        }
        let (n, d) = self.parts();
        // A quotient of 66 bits or more with a sticky last bit rounds as the exact quotient does.
        let shift = (66 + d.bits() as i64 - n.bits() as i64).max(0) as u64;
        let (q, r) = (n << shift).div_rem(&d);
        let sticky = if r.is_zero() { BigInt::zero() } else { r.signum() };
        let q = (q << 1u32) + sticky;
        let mut value = q.to_f64().unwrap_or(f64::NAN);
        let mut left = shift + 1;
        while left > 0 {
            let step = left.min(1000) as i32;
            value *= 2f64.powi(-step);
            left -= step as u64;
        }
        value
    }
}

impl From<i64> for Rational {
    fn from(n: i64) -> Rational {
        Rational::int(n)
    }
}

impl<'a> std::ops::Add<&'a Rational> for &Rational {
    type Output = Rational;
    fn add(self, other: &'a Rational) -> Rational {
        match (&self.0, &other.0) {
            (Repr::Small(a, b), Repr::Small(c, d)) => {
                let (a, b, c, d) = (i128::from(*a), i128::from(*b), i128::from(*c), i128::from(*d));
                if b == d { Rational::from_i128(a + c, b) } else { Rational::from_i128(a * d + c * b, b * d) }
            }
            _ => {
                let ((a, b), (c, d)) = (self.parts(), other.parts());
                Rational::from_big(&a * &d + &c * &b, b * d)
            }
        }
    }
}

impl<'a> std::ops::Sub<&'a Rational> for &Rational {
    type Output = Rational;
    fn sub(self, other: &'a Rational) -> Rational {
        self + &(-other)
    }
}

impl<'a> std::ops::Mul<&'a Rational> for &Rational {
    type Output = Rational;
    fn mul(self, other: &'a Rational) -> Rational {
        match (&self.0, &other.0) {
            (Repr::Small(a, 1), Repr::Small(c, 1)) => match a.checked_mul(*c) {
                Some(n) if n != i64::MIN => Rational(Repr::Small(n, 1)),
                _ => Rational::from_i128(i128::from(*a) * i128::from(*c), 1),
            },
            (Repr::Small(a, b), Repr::Small(c, d)) => {
                Rational::from_i128(i128::from(*a) * i128::from(*c), i128::from(*b) * i128::from(*d))
            }
            _ => {
                let ((a, b), (c, d)) = (self.parts(), other.parts());
                Rational::from_big(a * c, b * d)
            }
        }
    }
}

impl std::ops::Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Repr::Small(n, d) => Rational(Repr::Small(-n, *d)),
            Repr::Big(b) => Rational::from_big(-b.0.clone(), b.1.clone()),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Rational) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Rational) -> Ordering {
        match (&self.0, &other.0) {
            (Repr::Small(a, b), Repr::Small(c, d)) => {
                (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)))
            }
            _ => {
                let ((a, b), (c, d)) = (self.parts(), other.parts());
                (a * d).cmp(&(c * b))
            }
        }
    }
}

impl fmt::Display for Rational {
    /// `3`, `-2/5`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (n, d) = self.parts();
        if d.is_one() { write!(f, "{n}") } else { write!(f, "{n}/{d}") }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
