//! Recovery of exact angles and lengths from rounded numbers: 1.571 is 90 degrees, 0.08499999999 is 0.085.

use super::Rounding;
use std::f64::consts::PI;

/// How far a number may be from an exact one that is taken instead.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Radians.
    pub(super) angle: f64,
    /// Lengths, metres.
    pub(super) length: f64,
    /// Lengths that are the noise of floating-point numbers.
    pub(super) noise: f64,
    /// Sum of all lengths of the arm.
    pub(super) reach: f64,
}

/// Angles that are taken as exact whatever is asked: a table cannot tell them apart.
const SAME_ANGLE: f64 = 1e-9;

impl Limits {
    /// Limits for an arm of this reach.
    pub(super) fn new(rounding: Rounding, reach: f64) -> Limits {
        let (angle, length) = match rounding {
            Rounding::AsWritten => (SAME_ANGLE, 0.0),
            Rounding::Near => (1e-3, 1e-5),
            Rounding::Far => (1e-2, 1e-4),
        };
        let noise = 1e-13 * reach;
        Limits { angle, length: (length * reach).max(noise), noise, reach }
    }

    /// Limits where only noise is rounded, and what the turning of parts of the arm by up to `turned` radians did to them.
    pub(super) fn fine(&self, turned: f64) -> Limits {
        let noise = Limits::new(Rounding::AsWritten, self.reach);
        Limits { angle: noise.angle.max(2.0 * turned), ..noise }
    }

    /// An angle, and how far it is from what was read.
    pub(super) fn angle(&self, x: f64) -> Angle {
        let steps = (x * 12.0 / PI).round();
        let rest = x - steps * PI / 12.0;
        if rest.abs() <= self.angle {
            return Angle { steps: steps as i64, rest: 0.0 };
        }
        // Near an exact angle the difference is written: a table refuses 1.5707rad, as a rounded number.
        if rest.abs() < 0.02 {
            return Angle { steps: steps as i64, rest };
        }
        Angle { steps: 0, rest: x }
    }

    /// A length: 0 and short decimals are recovered.
    pub(super) fn length(&self, x: f64) -> f64 {
        if x.abs() <= self.length {
            return 0.0;
        }
        for digits in 0..10 {
            let short = decimal(x, digits);
            if (x - short).abs() <= self.noise {
                return short;
            }
        }
        x
    }
}

/// The nearest decimal with so many digits behind the point, as it would be read.
fn decimal(x: f64, digits: i32) -> f64 {
    let text = format!("{x:.*}", digits.unsigned_abs() as usize);
    let value = text.parse().unwrap_or(x);
    if value == 0.0 { 0.0 } else { value }
}

/// An angle: steps of 15 degrees and radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Angle {
    pub(super) steps: i64,
    pub(super) rest: f64,
}

impl Angle {
    pub(super) fn radians(self) -> f64 {
        self.steps as f64 * PI / 12.0 + self.rest
    }

    pub(super) fn is_zero(self) -> bool {
        self.steps == 0 && self.rest == 0.0
    }

    pub(super) fn is_exact(self) -> bool {
        self.rest == 0.0
    }

    /// In (-180, 180] degrees.
    #[must_use]
    pub(super) fn folded(self) -> Angle {
        let steps = self.steps.rem_euclid(24);
        Angle { steps: if steps > 12 { steps - 24 } else { steps }, rest: self.rest }
    }

    /// As a table writes it: `90deg`, `approx 0.3rad`, `-90deg + approx 0.0012rad`, `55deg`.
    pub(super) fn text(self) -> String {
        let whole = self.rest.to_degrees();
        if self.steps == 0 && self.rest != 0.0 && (whole * 2.0 - (whole * 2.0).round()).abs() < 1e-9 {
            return format!("{}deg", (whole * 2.0).round() / 2.0);
        }
        let exact = format!("{}deg", self.steps * 15);
        match (self.steps, self.rest) {
            (0, 0.0) => "0".into(),
            (_, 0.0) => exact,
            (0, rest) => format!("approx {}rad", number(rest)),
            (_, rest) if rest < 0.0 => format!("{exact} - approx {}rad", number(-rest)),
            (_, rest) => format!("{exact} + approx {}rad", number(rest)),
        }
    }
}

/// A number without exponent, so that it reads back as the same.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 { "0".into() } else { format!("{x}") }
}

/// A number for people: the digits that the file is likely to have had.
pub(super) fn shown(x: f64) -> String {
    for digits in 0..9 {
        let short = decimal(x, digits);
        if (x - short).abs() <= 1e-12 * x.abs().max(1e-3) {
            return number(short);
        }
    }
    number(decimal(x, 9))
}

#[cfg(test)]
#[allow(clippy::approx_constant)] // angles as files write them
mod tests {
    use super::*;

    #[test]
    fn angles_are_recovered() {
        let near = Limits::new(Rounding::Near, 1.0);
        for (x, text) in [
            (1.5708, "90deg"),
            (1.571, "90deg"),
            (-3.14159, "-180deg"),
            (0.785398, "45deg"),
            (1.0, "approx 1rad"),
            (1.573, "90deg + approx 0.002203673205103396rad"),
            (55f64.to_radians(), "55deg"),
            (5e-4, "0"),
        ] {
            assert_eq!(near.angle(x).text(), text, "{x}");
        }
        let written = Limits::new(Rounding::AsWritten, 1.0);
        assert!(written.angle(1.5708).text().starts_with("90deg + approx 0.00000367320510"));
        assert_eq!(written.angle(std::f64::consts::FRAC_PI_2 + 1e-12).text(), "90deg");
        assert_eq!(Angle { steps: -12, rest: 0.0 }.folded().text(), "180deg");
    }

    #[test]
    fn lengths_are_recovered() {
        let near = Limits::new(Rounding::Near, 1.0);
        for (x, y) in [(0.085, 0.085), (0.1 + 0.2, 0.3), (3e-6, 0.0), (0.123_456, 0.123_456), (-0.03, -0.03)] {
            assert_eq!(near.length(x), y, "{x}");
        }
        let written = Limits::new(Rounding::AsWritten, 1.0);
        assert_eq!((written.length(3e-6), written.length(0.4250001)), (3e-6, 0.4250001));
        assert_eq!(written.length(1e-17), 0.0);
    }
}
