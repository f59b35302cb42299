//! Functions of constants in cells: `sqrt(2)`, `0.3*cos(30deg)`, `atan(49.75/250)`, `atan2(5mm, 12mm)`.
//!
//! Values that are rational, and angles that are multiples of 15 degrees, stay exact; all others are taken to the sixteen digits of a
//! floating-point number.

use super::scope::Scope;
use super::sum::{AngleUnit, Sum, Term};
use crate::algebra::Rational;
use crate::diagnostic::{Error, Place};
use std::f64::consts::PI;

/// Their names.
const NAMES: [&str; 8] = ["sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2"];

/// Whether there is a function of this name.
pub(super) fn is_function(name: &str) -> bool {
    NAMES.contains(&name)
}

/// The value of an argument.
enum Constant {
    /// A number, or a product of so many lengths.
    Number(Rational, usize),
    /// An angle: half turns and radians.
    Angle(Rational, Rational),
}

/// The value of a function. `place`: where the call stands.
pub(super) fn apply(name: &str, place: Place, arguments: &[Sum], scope: &Scope) -> Result<Sum, Error> {
    let values = arguments.iter().map(|sum| constant(sum, place, scope)).collect::<Result<Vec<_>, _>>()?;
    let wants = |text: &str| Err(Error::new(place, format!("`{name}` takes {text}")));
    let number = |factor: Rational, lengths: usize| {
        let mut term = Term::number(factor, place, format!("{name}(...)"));
        (term.lengths, term.literal_length) = (lengths, lengths > 0);
        Ok(Sum::of(term))
    };
    match (name, values.as_slice()) {
        ("sqrt", [Constant::Number(x, lengths)]) if lengths % 2 == 0 => {
            let root = x.to_f64().sqrt();
            if x.is_negative() || !root.is_finite() {
                return wants("a number that is not negative");
            }
            number(exact_root(x).map_or_else(|| approximate(root, place), Ok)?, lengths / 2)
        }
        ("sqrt", _) => wants("a number, or a product of two lengths"),
        ("sin" | "cos" | "tan", [Constant::Angle(turns, radians)]) => {
            let angle = turns.to_f64() * PI + radians.to_f64();
            if name == "tan" && angle.cos().abs() < 1e-12 {
                return wants("an angle other than a right one");
            }
            let value = match name {
                "sin" => angle.sin(),
                "cos" => angle.cos(),
                _ => angle.tan(),
            };
            // The rational values: 0, 1/2, 1.
            let halves = (value * 2.0).round();
            if radians.is_zero() && (value * 2.0 - halves).abs() < 1e-14 {
                return number(&Rational::int(halves as i64) * &Rational::HALF, 0);
            }
            number(approximate(value, place)?, 0)
        }
        ("sin" | "cos" | "tan", _) => wants("an angle: `30deg`, `pi/6`"),
        ("asin" | "acos" | "atan", [Constant::Number(x, 0)]) => {
            let x = x.to_f64();
            let value = match name {
                "asin" => x.asin(),
                "acos" => x.acos(),
                _ => x.atan(),
            };
            if value.is_nan() { wants("a number from -1 to 1") } else { angle(value, place, name) }
        }
        ("asin" | "acos" | "atan", _) => {
            wants("one number without unit: `atan(5/12)`; of two lengths: `atan2(5mm, 12mm)`")
        }
        ("atan2", [Constant::Number(y, m), Constant::Number(x, n)]) if m == n || y.is_zero() || x.is_zero() => {
            if y.is_zero() && x.is_zero() {
                return wants("two numbers that are not both 0");
            }
            angle(y.to_f64().atan2(x.to_f64()), place, name)
        }
        _ => wants("two numbers, or two lengths: `atan2(5mm, 12mm)`"),
    }
}

fn constant(sum: &Sum, place: Place, scope: &Scope) -> Result<Constant, Error> {
    let (mut number, mut lengths) = (Rational::ZERO, None);
    let (mut turns, mut radians, mut angular) = (Rational::ZERO, Rational::ZERO, false);
    for t in &sum.terms {
        let (x, fields) = scope.fold_constants(&t.factor, &t.names);
        if !fields.is_empty() || t.variable.is_some() || matches!(t.angle, Some(AngleUnit::Declared(_))) {
            return Err(Error::new(t.place, "a function takes constants only")
                .help("declare its value: `let beta: angle;` is a field of the struct"));
        }
        match t.angle {
            Some(AngleUnit::Pi) => turns = &turns + &x,
            Some(_) => radians = &radians + &x,
            None if x.is_zero() => continue,
            None => {
                number = &number + &x;
                if lengths.replace(t.lengths).is_some_and(|n| n != t.lengths) {
                    return Err(Error::new(place, "a number and a length are added here"));
                }
                continue;
            }
        }
        angular = true;
    }
    match (angular, lengths) {
        (true, Some(_)) => Err(Error::new(place, "an angle and a number are added here")),
        (true, None) => Ok(Constant::Angle(turns, radians)),
        (false, lengths) => Ok(Constant::Number(number, lengths.unwrap_or(0))),
    }
}

/// A number to all digits of a float.
fn approximate(x: f64, place: Place) -> Result<Rational, Error> {
    let negative = x < 0.0;
    let value = Rational::from_decimal(&format!("{:e}", x.abs())).filter(|_| x.is_finite());
    let value = value.ok_or_else(|| Error::new(place, "this value is beyond all reason"))?;
    Ok(if negative { &value * &Rational::int(-1) } else { value })
}

/// An angle in radians, exact where it is a multiple of 15 degrees.
fn angle(x: f64, place: Place, name: &str) -> Result<Sum, Error> {
    let steps = (x * 12.0 / PI).round();
    let exact = (x - steps * PI / 12.0).abs() < 1e-14;
    let factor = if exact { Rational::new(steps as i64, 12).unwrap_or(Rational::ZERO) } else { approximate(x, place)? };
    let mut term = Term::number(factor, place, format!("{name}(...)"));
    term.angle = Some(if exact { AngleUnit::Pi } else { AngleUnit::Radian });
    Ok(Sum::of(term))
}

/// The root of a fraction of two squares.
fn exact_root(x: &Rational) -> Option<Rational> {
    let (n, d) = x.to_small()?;
    let root = |k: i64| {
        let r = (k as f64).sqrt().round() as i64;
        (r.checked_mul(r)? == k).then_some(r)
    };
    Rational::new(root(n)?, root(d)?)
}
