//! Rational multiples of pi, and their exact sines and cosines where these lie in Q(sqrt 2, sqrt 3).

use super::{Poly, Rational};

/// An exact angle: a rational multiple of pi.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle {
    half_turns: Rational,
}

impl Angle {
    /// The angle zero.
    pub const ZERO: Angle = Angle { half_turns: Rational::ZERO };

    /// `x * pi` radians.
    pub fn half_turns(x: Rational) -> Angle {
        Angle { half_turns: x }
    }

    /// Degrees.
    pub fn degrees(x: &Rational) -> Angle {
        Angle { half_turns: x * &Rational::new(1, 180).unwrap_or(Rational::ZERO) }
    }

    /// The factor of pi.
    pub fn factor(&self) -> &Rational {
        &self.half_turns
    }

    /// The angle in degrees.
    pub fn to_degrees(&self) -> Rational {
        &self.half_turns * &Rational::int(180)
    }

    /// The angle in radians, rounded once.
    pub fn radians(&self) -> f64 {
        match self.half_turns.to_small() {
            // pi/2, pi/3, ...: one rounding of pi times a small integer, then one division
            Some((n, d)) => std::f64::consts::PI * n as f64 / d as f64,
            None => std::f64::consts::PI * self.half_turns.to_f64(),
        }
    }

    /// Is this the angle zero (not merely a whole turn)?
    pub fn is_zero(&self) -> bool {
        self.half_turns.is_zero()
    }

    /// Sum.
    #[must_use]
    pub fn plus(&self, other: &Angle) -> Angle {
        Angle { half_turns: &self.half_turns + &other.half_turns }
    }

    /// A multiple.
    #[must_use]
    pub fn times(&self, factor: &Rational) -> Angle {
        Angle { half_turns: &self.half_turns * factor }
    }

    /// Number of 15-degree steps modulo a whole turn, where the angle is a whole number of them.
    pub fn steps_of_15_degrees(&self) -> Option<usize> {
        let n = (&self.half_turns * &Rational::int(12)).to_i64()?;
        usize::try_from(n.rem_euclid(24)).ok()
    }

    /// Exact (cosine, sine); `None` unless the angle is a multiple of 15 degrees.
    pub fn cos_sin(&self) -> Option<(Poly, Poly)> {
        let n = self.steps_of_15_degrees()?;
        // sin(n * 15 deg) = cos((n - 6) * 15 deg)
        Some((cosine_of_step(n), cosine_of_step((n + 18) % 24)))
    }
}

/// cos(15 deg * n) for n in 0..24.
fn cosine_of_step(n: usize) -> Poly {
    // Fold into the first quadrant: cos(360 - x) = cos x, cos(180 - x) = -cos x.
    let n = if n > 12 { 24 - n } else { n };
    let (n, negative) = if n > 6 { (12 - n, true) } else { (n, false) };
    let half = Rational::HALF;
    let quarter = &half * &half;
    let (r2, r3) = (Poly::sqrt2(), Poly::sqrt3());
    let value = match n {
        0 => Poly::one(),
        1 => (&(&r2 * &r3) + &r2).scale(&quarter),
        2 => r3.scale(&half),
        3 => r2.scale(&half),
        4 => Poly::constant(half),
        5 => (&(&r2 * &r3) - &r2).scale(&quarter),
        _ => Poly::zero(),
    };
    if negative { -&value } else { value }
}
