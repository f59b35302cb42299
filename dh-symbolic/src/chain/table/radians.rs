//! Angles in radians: since they are inexact (except 0), they must say `approx`, and a rounded multiple of 15 degrees is an error.

use super::number::Number;
use crate::algebra::{Angle, Rational};
use crate::diagnostic::{Error, Place};

/// Refuses radians that do not say `approx`, and rounded forms of exact angles. `approximate`: the place of the word `approx`, and
/// whether a minus stands behind it.
pub(super) fn check(n: &Number, written: &str, place: Place, approximate: Option<(Place, bool)>) -> Result<(), Error> {
    /// As near to a multiple of 15 degrees as this, in radians, an angle looks like one: 1.57 does (and whatever else is rounded to
    /// two digits), 1.3 does not.
    const NEAR: f64 = 5e-3;
    /// As near as this it is one, however many digits are written.
    const EQUAL: f64 = 1e-9;
    if n.value.is_zero() && approximate.is_none() {
        return Ok(());
    }
    let x = n.value.to_f64();
    let steps = (x * 12.0 / std::f64::consts::PI).round();
    let miss = (x - steps * std::f64::consts::PI / 12.0).abs();
    // Calibrated arms have angles like 1.570320019: near, but no rounded pi/2. A rounded one misses by less than its last digit.
    // Nothing but 0 rounds to 0, so small angles are what they say.
    let near = miss < NEAR && steps != 0.0;
    if miss < EQUAL || (near && (approximate.is_none() || miss <= n.last_digit.to_f64())) {
        let negative = approximate.is_some_and(|(_, negative)| negative);
        let spelling = exact_spelling(&Rational::int(if negative { -steps as i64 } else { steps as i64 }));
        return Err(match approximate {
            Some((word, _)) => {
                Error::new(word.to(place), "this looks like an exact angle, written as a rounded number")
                    .help(format!("write {spelling}, or give more digits if it is another angle"))
            }
            None => Error::new(place, "radians are never exact").help(format!("write {spelling}")),
        });
    }
    if approximate.is_none() {
        let text = format!("radians are never exact: say `approx {written}`");
        return Err(Error::new(place, text).help("or write the angle in degrees"));
    }
    Ok(())
}

/// Which unit a number in the place of an angle is likely to have: what to write instead.
pub(super) fn unit_of(word: &str) -> String {
    let Ok(x) = word.replace('_', "").parse::<f64>() else { return format!("give it a unit: `{word}deg`") };
    let steps = (x * 12.0 / std::f64::consts::PI).round();
    let whole = x == x.round();
    if !whole && steps != 0.0 && (x - steps * std::f64::consts::PI / 12.0).abs() < 5e-3 {
        return format!("in radians this is {}", exact_spelling(&Rational::int(steps as i64)));
    }
    // No angle of a robot is beyond a turn or two.
    if whole || x > 13.0 {
        return format!("write `{word}deg`");
    }
    format!("write `approx {word}rad` if these are radians, `{word}deg` if these are degrees")
}

/// "`90deg` or `pi/2`": a number of 15-degree steps.
fn exact_spelling(steps: &Rational) -> String {
    if steps.is_zero() {
        return "`0`".into();
    }
    let degrees = steps * &Rational::int(15);
    let angle = Angle::degrees(&degrees);
    match angle.factor().to_small() {
        Some((1, 1)) => format!("`{degrees}deg` or `pi`"),
        Some((-1, 1)) => format!("`{degrees}deg` or `-pi`"),
        Some((n, 1)) => format!("`{degrees}deg` or `{n}*pi`"),
        Some((1, d)) => format!("`{degrees}deg` or `pi/{d}`"),
        Some((-1, d)) => format!("`{degrees}deg` or `-pi/{d}`"),
        Some((n, d)) => format!("`{degrees}deg` or `{n}*pi/{d}`"),
        None => format!("`{degrees}deg`"),
    }
}
