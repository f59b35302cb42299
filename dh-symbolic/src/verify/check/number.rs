//! Numbers as written: digits, unit, and how they were rounded.

use super::Evaluator;
use super::ratio::Ratio;
use super::refusal::{Understood, refuse};
use super::scope::radians;
use super::value::{Turn, Value};
use crate::algebra::{Angle, Rational};
use crate::verify::language::Place;

/// Most digits of a number, and its largest exponent: others are no quantities of robots, and would only cost time.
const DIGITS: usize = 40;
const POWER: i32 = 30;

/// A number as written.
pub(super) struct Written {
    pub(super) value: Rational,
    pub(super) unit: String,
    /// Digits after the point, exponent taken into account; `None` where no point is written.
    pub(super) decimals: Option<i32>,
}

impl Written {
    pub(super) fn read(text: &str) -> Option<Written> {
        let text: String = text.chars().filter(|c| *c != '_').collect();
        let digit = |i: usize| text.as_bytes().get(i).is_some_and(u8::is_ascii_digit);
        let mut end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        if text[end..].starts_with(['e', 'E']) {
            let sign = usize::from(text[end + 1..].starts_with(['-', '+']));
            if digit(end + 1 + sign) {
                end += 1 + sign;
                while digit(end) {
                    end += 1;
                }
            }
        }
        let (digits, unit) = text.split_at(end);
        let (mantissa, power) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
        if mantissa.len() > DIGITS + 1 || power.parse::<i32>().map_or(true, |p| p.abs() > POWER) {
            return None;
        }
        let decimals = digits.split_once('.').map(|(_, tail)| {
            let (fraction, power) = tail.split_once(['e', 'E']).unwrap_or((tail, "0"));
            i32::try_from(fraction.len()).unwrap_or(0) - power.parse::<i32>().unwrap_or(0)
        });
        Some(Written { value: Rational::from_decimal(digits)?, unit: unit.to_string(), decimals })
    }
}

/// Metres in a unit of length.
pub(super) fn metres(unit: &str) -> Option<Rational> {
    let (n, d) = match unit {
        "m" => (1, 1),
        "dm" => (1, 10),
        "cm" => (1, 100),
        "mm" => (1, 1000),
        "um" => (1, 1_000_000),
        "in" => (254, 10_000),
        "ft" => (3048, 10_000),
        _ => return None,
    };
    Rational::new(n, d)
}

impl Evaluator<'_> {
    pub(super) fn number(&mut self, text: &str, place: &Place) -> Understood<Value> {
        let Some(Written { value, unit, .. }) = Written::read(text) else {
            let short: String = text.chars().take(30).collect();
            return refuse(
                place,
                format!("`{short}` is no number with at most {DIGITS} digits and an exponent up to {POWER}"),
            );
        };
        Ok(match unit.as_str() {
            "" => Value::Scalar(Ratio::number(value)),
            "deg" => Value::Angle(Turn::constant(Angle::degrees(&value))),
            "turn" => Value::Angle(Turn::constant(Angle::half_turns(&value * &Rational::int(2)))),
            "rad" if value.is_zero() => Value::Angle(Turn::constant(Angle::ZERO)),
            "rad" => Value::Angle(Turn::constant(radians(value.to_f64()))),
            _ => match (metres(&unit), self.chain.settings.unit.metres.recip()) {
                (Some(m), Some(per_metre)) => Value::Scalar(Ratio::number(&(&value * &m) * &per_metre)),
                _ => {
                    return refuse(
                        place,
                        format!("unknown unit `{unit}`; lengths: m, cm, mm, in; angles: deg, rad, turn"),
                    );
                }
            },
        })
    }
}
