//! Names: which may be declared, and which was meant.

use crate::diagnostic::{Error, Place};
use proc_macro2::Ident;

/// The candidate that the text was probably meant to be: at most two slips (a letter left out, put in, changed, or two
/// neighbours swapped), and fewer slips than half its length.
pub(super) fn suggestion<'a>(text: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let most = (text.chars().count() / 2).min(2);
    candidates
        .into_iter()
        .map(|c| (distance(&text.to_lowercase(), c), c))
        .filter(|(d, _)| *d <= most)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

/// A word for a message: control characters escaped, no longer than 40 letters.
pub(super) fn shown(word: &str) -> String {
    let end = if word.chars().count() > 40 { "..." } else { "" };
    let start: String = word.chars().take(40).collect();
    format!("{}{end}", start.escape_debug())
}

/// Number of slips between two words (optimal string alignment); words longer than 40 letters are far from all others.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(41).collect(), b.chars().take(41).collect());
    if a.len() > 40 || b.len() > 40 {
        return usize::MAX;
    }
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = change.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// Number of a joint variable: 2 for `q2`. `q0` gives 0; more than four digits are no variable.
pub(super) fn variable_number(name: &str) -> Option<usize> {
    let digits = name.strip_prefix('q')?;
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

/// May this name be declared with `let`?
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
    if WORDS.contains(&text.as_str()) || super::number::is_unit(&text) {
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

/// May the struct have this name?
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
    fn slips_are_counted() {
        let pairs = [("tehta", "theta", 1), ("theta", "theta", 0), ("alfa", "alpha", 2), ("", "ab", 2)];
        for (a, b, d) in pairs {
            assert_eq!(distance(a, b), d, "{a} {b}");
        }
        let columns = ["joint", "alpha", "a", "d", "theta", "range"];
        assert_eq!(suggestion("tehta", columns), Some("theta"));
        assert_eq!(suggestion("Alpha", columns), Some("alpha"));
        assert_eq!(suggestion("b", columns), None, "one letter is not enough to guess from");
    }

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
