//! Which names may be declared in a table.

use super::number::is_unit;
use crate::diagnostic::{Error, Place};
use proc_macro2::Ident;

/// Number of a joint variable: 2 for `q2`, and for `θ2`, which can be no other name. `q0` gives 0; more than four digits are no
/// variable.
pub(super) fn variable_number(name: &str) -> Option<usize> {
    let digits = name.strip_prefix('q').or_else(|| name.strip_prefix('θ').map(|d| d.trim_start_matches('_')))?;
    let fine = !digits.is_empty() && digits.len() <= 4 && digits.bytes().all(|b| b.is_ascii_digit());
    if fine && (digits == "0" || !digits.starts_with('0')) { digits.parse().ok() } else { None }
}

const KEYWORDS: &[&str] = &[
    "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "Self", "static", "struct",
    "super", "trait", "true", "try", "type", "typeof", "union", "unsafe", "unsized", "use", "virtual", "where",
    "while", "yield",
];
/// Functions of the generated type.
const FUNCTIONS: &[&str] = &["default", "forward", "frames", "inverse", "jacobian"];
/// Words of the table.
const WORDS: &[&str] = &["approx", "fixed", "pi", "prove"];
/// Types that the generated code names.
const TYPES: &[&str] = &["bool", "char", "f32", "f64", "i8", "i16", "i32", "i64", "isize", "str", "u8", "usize"];

/// Whether this name may be declared with `let`.
pub(super) fn check_parameter(name: &Ident) -> Result<(), Error> {
    let text = name.to_string();
    let place = Place::at(name.span());
    let wrong = |message: String| Err(Error::new(place, message));
    if !text.is_ascii() {
        return wrong(format!("`{text}`: names are written in ASCII letters"));
    }
    if text.starts_with("r#") || KEYWORDS.contains(&text.as_str()) {
        return wrong(format!("`{text}` is a keyword of Rust, and a symbol becomes a field"));
    }
    if text.starts_with('_') || text.contains("__") || text.len() > 40 {
        return wrong("a name starts with a letter, has no `__`, and at most 40 letters".to_string());
    }
    if variable_number(&text).is_some() || text == "q" {
        return wrong(format!("`{text}` is the name of a joint variable"));
    }
    if WORDS.contains(&text.as_str()) || is_unit(&text) {
        return wrong(format!("`{text}` has a meaning in the table already"));
    }
    if FUNCTIONS.contains(&text.as_str()) {
        return wrong(format!("`{text}` is a function of the generated type"));
    }
    Ok(())
}

/// `c1`, `s23`: in a `prove` block these are the cosine and sine of joint angles.
pub(super) fn is_cosine_or_sine(name: &str) -> bool {
    name.strip_prefix(['c', 's']).is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// Whether the struct may have this name.
pub(super) fn check_type(name: &Ident) -> Result<(), Error> {
    let text = name.to_string();
    if text.starts_with("r#") || KEYWORDS.contains(&text.as_str()) || TYPES.contains(&text.as_str()) {
        return Err(Error::new(Place::at(name.span()), format!("a robot cannot be called `{text}`")));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables() {
        let list = [("q1", Some(1)), ("q12", Some(12)), ("q0", Some(0)), ("q01", None), ("q", None), ("q2a", None)];
        for (name, number) in list {
            assert_eq!(variable_number(name), number, "{name}");
        }
    }

    #[test]
    fn reserved_names() {
        let fine = |name: &str| check_parameter(&Ident::new(name, proc_macro2::Span::call_site())).is_ok();
        for name in ["a2", "d", "l_1", "upper_arm", "L1", "c1"] {
            assert!(fine(name), "{name}");
        }
        for name in ["q1", "pi", "mm", "forward", "fn", "_", "_x", "λ", "a__b", "m"] {
            assert!(!fine(name), "{name}");
        }
    }
}
