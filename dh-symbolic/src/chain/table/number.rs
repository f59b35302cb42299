//! Literals: exact digits and a unit.

use super::spelling::{shown, suggestion};
use crate::algebra::Rational;
use crate::chain::LengthUnit;
use crate::diagnostic::{Error, Place};
use proc_macro2::{Literal, TokenTree};

/// What the suffix of a number says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    /// No suffix.
    None,
    /// So many metres.
    Length(Rational),
    /// So many times pi.
    HalfTurns(Rational),
    /// Radians: no rational multiple of pi.
    Radians,
}

/// A literal, read exactly.
#[derive(Clone, Debug)]
pub(super) struct Number {
    /// The digits.
    pub(super) value: Rational,
    /// The suffix.
    pub(super) unit: Unit,
    /// One unit of the last digit that is written.
    pub(super) last_digit: Rational,
    /// How many digits it takes to write it without exponent: what arithmetic with it costs.
    pub(super) digits: usize,
}

/// Units of length: name, and metres as a fraction.
const LENGTHS: [(&str, i64, i64); 5] =
    [("m", 1, 1), ("cm", 1, 100), ("mm", 1, 1000), ("in", 254, 10_000), ("ft", 3048, 10_000)];
/// Units of angle: name, and multiples of pi as a fraction. `rad` stands apart.
/// `º` stands for the degree sign, which is no letter to Rust (see `diagnostic::lex`).
const ANGLES: [(&str, i64, i64); 5] = [("deg", 1, 180), ("turn", 2, 1), ("pi", 1, 1), ("º", 1, 180), ("π", 1, 1)];
/// What people write instead.
const OTHER_NAMES: [(&str, &str); 19] = [
    ("d", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("grad", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("r", "rad"),
    ("rev", "turn"),
    ("turns", "turn"),
    ("meter", "m"),
    ("meters", "m"),
    ("metre", "m"),
    ("metres", "m"),
    ("inch", "in"),
    ("inches", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("um", "mm"),
    ("µm", "mm"),
];

fn fraction(num: i64, den: i64) -> Rational {
    Rational::new(num, den).unwrap_or(Rational::ZERO)
}

/// The unit of length of this name.
pub(super) fn length_unit(name: &str) -> Option<LengthUnit> {
    LENGTHS.iter().find(|u| u.0 == name).map(|u| LengthUnit { name: u.0, metres: fraction(u.1, u.2) })
}

/// Whether this is the name of a unit.
pub(super) fn is_unit(name: &str) -> bool {
    unit(name).is_some()
}

/// The unit of this name.
pub(super) fn unit(name: &str) -> Option<Unit> {
    let angle = || ANGLES.iter().find(|u| u.0 == name).map(|u| Unit::HalfTurns(fraction(u.1, u.2)));
    match name {
        "" => Some(Unit::None),
        "rad" => Some(Unit::Radians),
        _ => length_unit(name).map(|u| Unit::Length(u.metres)).or_else(angle),
    }
}

/// The name of a unit.
pub(super) fn unit_name(unit: &Unit) -> String {
    let of = |list: &[(&str, i64, i64)], x: &Rational| {
        list.iter().find(|u| fraction(u.1, u.2) == *x).map_or("", |u| u.0).to_string()
    };
    match unit {
        Unit::None => String::new(),
        Unit::Length(metres) => of(&LENGTHS, metres),
        Unit::HalfTurns(x) => of(&ANGLES, x),
        Unit::Radians => "rad".into(),
    }
}

/// `unit = ...` with an unknown name.
pub(super) fn unknown_length_unit(name: &str, place: Place) -> Error {
    let error =
        Error::new(place, format!("unknown unit `{}`; the table's unit is one of m, cm, mm, in, ft", shown(name)));
    match closest_unit(name) {
        Some(u) if length_unit(u).is_some() => error.help(format!("did you mean `{u}`?")),
        _ => error,
    }
}

fn closest_unit(name: &str) -> Option<&'static str> {
    if let Some((_, u)) = OTHER_NAMES.iter().find(|(n, _)| *n == name) {
        return Some(u);
    }
    let all = LENGTHS.iter().map(|u| u.0).chain(ANGLES.iter().map(|u| u.0)).chain(["rad"]);
    suggestion(name, all)
}

/// Splits `431.8mm` into digits (with exponent) and suffix.
fn split(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |mut i: usize| {
        while bytes.get(i).is_some_and(|b| b.is_ascii_digit() || *b == b'_') {
            i += 1;
        }
        i
    };
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if text.get(end + 1 + sign..exponent).is_some_and(|e| e.bytes().any(|b| b.is_ascii_digit())) {
            end = exponent;
        }
    }
    (text.get(..end).unwrap_or(""), text.get(end..).unwrap_or(""))
}

/// Reads a literal. `declared` says whether a name has been declared (for `2l1`).
pub(super) fn read(literal: &Literal, declared: &dyn Fn(&str) -> bool) -> Result<Number, Error> {
    let place = Place::of(&TokenTree::Literal(literal.clone()));
    let text = literal.to_string();
    if !text.starts_with(|c: char| c.is_ascii_digit()) {
        return Err(Error::new(place, "a number was expected here").help("write a number with its unit: `431.8mm`"));
    }
    let (digits, suffix) = split(&text);
    if digits == "0" && suffix.starts_with(['x', 'b', 'o']) && suffix.len() > 1 && !is_unit(suffix) {
        return Err(Error::new(place, "numbers are decimal here"));
    }
    let value = Rational::from_decimal(digits)
        .ok_or_else(|| Error::new(place, "this number has too many digits, or its exponent is beyond 400"))?;
    let last_digit = last_digit(digits).unwrap_or(Rational::ZERO);
    let Some(unit) = unit(suffix) else { return Err(unknown(digits, suffix, place, declared)) };
    if let Unit::HalfTurns(_) | Unit::Radians = unit
        && value > Rational::int(1_000_000)
    {
        return Err(Error::new(place, "this angle is beyond all reason"));
    }
    let exponent = digits.split(['e', 'E']).nth(1).and_then(|e| e.replace('_', "").parse::<i32>().ok()).unwrap_or(0);
    Ok(Number { value, unit, last_digit, digits: digits.len() + exponent.unsigned_abs() as usize })
}

fn unknown(digits: &str, suffix: &str, place: Place, declared: &dyn Fn(&str) -> bool) -> Error {
    let error = Error::new(
        place,
        format!("unknown unit `{}`; lengths: m, cm, mm, in, ft; angles: deg, rad, turn", shown(suffix)),
    );
    if declared(suffix) {
        return error.help(format!("a product is written with `*`: `{digits}*{suffix}`"));
    }
    let rust_type = |kinds: &str| {
        suffix.starts_with(|c: char| kinds.contains(c)) && suffix[1..].bytes().all(|b| b.is_ascii_digit())
    };
    match closest_unit(suffix) {
        Some(u) => error.help(format!("did you mean `{digits}{u}`?")),
        None if rust_type("fui") => error.help(format!("`{suffix}` is a type of Rust; numbers here are exact")),
        None => error,
    }
}

/// One unit of the last digit written: 1/10000 for `1.5708`.
fn last_digit(digits: &str) -> Option<Rational> {
    let (mantissa, exponent) = match digits.find(['e', 'E']) {
        Some(i) => (digits.get(..i)?, digits.get(i + 1..)?.replace('_', "").parse::<i64>().ok()?),
        None => (digits, 0),
    };
    let fraction = mantissa.split_once('.').map_or(0, |(_, f)| f.bytes().filter(u8::is_ascii_digit).count());
    Rational::from_decimal(&format!("1e{}", exponent - i64::try_from(fraction).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Result<Number, String> {
        read(&text.parse().expect("a literal"), &|name| name == "l1").map_err(|e| {
            let help = e.help.unwrap_or_default();
            format!("{}|{help}", e.message)
        })
    }

    #[test]
    fn digits_are_exact() {
        let value = |text: &str| {
            let n = number(text).unwrap_or_else(|e| panic!("{text}: {e}"));
            (n.value.to_string(), n.unit)
        };
        let mm = Unit::Length(fraction(1, 1000));
        assert_eq!(value("431.8mm"), ("2159/5".into(), mm.clone()));
        assert_eq!(value("1e-3mm"), ("1/1000".into(), mm.clone()));
        assert_eq!(value("1_000.5mm"), ("2001/2".into(), mm));
        assert_eq!(value("08deg"), ("8".into(), Unit::HalfTurns(fraction(1, 180))));
        assert_eq!(value("2pi"), ("2".into(), Unit::HalfTurns(Rational::ONE)));
        assert_eq!(value("1."), ("1".into(), Unit::None));
        assert_eq!(value("1e-05rad").1, Unit::Radians);
    }

    #[test]
    fn units_get_a_suggestion() {
        let help = |text: &str| number(text).expect_err("no unit").split_once('|').map(|x| x.1.to_string());
        assert_eq!(help("90degrees").as_deref(), Some("did you mean `90deg`?"));
        assert_eq!(help("3mmm").as_deref(), Some("did you mean `3mm`?"));
        assert_eq!(help("0.4f32").as_deref(), Some("`f32` is a type of Rust; numbers here are exact"));
        assert_eq!(help("2l1").as_deref(), Some("a product is written with `*`: `2*l1`"));
        assert!(number("0x10").is_err() && number("1e401").is_err() && number("'a'").is_err());
    }

    #[test]
    fn the_last_digit() {
        let last = |text: &str| number(text).expect("a number").last_digit.to_string();
        assert_eq!((last("1.5708rad"), last("12"), last("1.5e-3")), ("1/10000".into(), "1".into(), "1/10000".into()));
    }
}
