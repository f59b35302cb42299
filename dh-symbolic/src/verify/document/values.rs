//! What the words of a side of an equation are: numbers, given values, quantities of any row or of another arm.

use super::names::DocumentNames;
use super::{Sheet, Word};
use crate::verify::language::TokenKind;

/// Is a formula nothing but numbers, one of them with decimals, or a number that no formula comes out as by itself?
pub(super) fn is_measured(words: &[Word]) -> bool {
    let number = |w: &Word| w.token.text.starts_with(|c: char| c.is_ascii_digit());
    let mark = |w: &Word| "[](),;-+".contains(w.token.text.as_str());
    let large = matches!(words, [w] if w.token.text.parse::<u32>().is_ok_and(|n| n > 1));
    words.iter().all(|w| number(w) || mark(w))
        && (large || words.iter().any(|w| number(w) && has_decimals(&w.token.text)))
}

/// Is it one number, with its sign?
pub(super) fn is_number(words: &[Word]) -> bool {
    let rest = if words.first().is_some_and(|w| w.token.is("-")) { &words[1..] } else { words };
    matches!(rest, [w] if w.token.text.starts_with(|c: char| c.is_ascii_digit()))
}

pub(super) fn text(words: &[Word]) -> String {
    words.iter().map(|w| w.token.text.as_str()).collect::<Vec<_>>().join(" ")
}

/// Quantities of any row get a name of their own before they are used.
pub(super) fn declare_general(words: &[Word], sheet: &mut Sheet) {
    for w in words {
        let t = w.token.text.as_str();
        let kind = match t.split_once('_') {
            Some(("alpha" | "theta", i)) if i.starts_with(['i', 'j', 'k', 'n']) => "angle",
            Some(("a" | "d", i)) if i.starts_with(['i', 'j', 'k', 'n']) => "length",
            _ => continue,
        };
        if sheet.general.insert(t.to_string()) {
            sheet.put(["let", t, ":", kind].iter().map(|x| Word::new(x, w.line)).collect());
        }
    }
}

/// Velocities of joints get a name of their own before they are used.
pub(super) fn declare_velocities(words: &[Word], sheet: &mut Sheet) {
    for w in words {
        let t = w.token.text.as_str();
        if t.starts_with('q') && t.ends_with("_dot") && sheet.general.insert(t.to_string()) {
            sheet.put(["let", t, ":", "length"].iter().map(|x| Word::new(x, w.line)).collect());
        }
    }
}

/// Does a formula name frames or rows that the table does not have? Then it speaks of another arm.
pub(super) fn is_foreign(words: &[Word], names: &DocumentNames<'_>) -> bool {
    let n = names.chain.links.len();
    let number = |w: &Word| w.token.text.parse::<usize>().ok();
    let frames = words.windows(5).any(|w| {
        w[0].token.text == "T" && w[1].token.is("(") && [&w[2], &w[4]].iter().any(|k| number(k).is_some_and(|k| k > n))
    });
    frames
        || words.iter().any(|w| {
            let t = w.token.text.as_str();
            let at = t.find(|c: char| c.is_ascii_digit()).unwrap_or(t.len());
            let (stem, digits) = t.split_at(at);
            let declared = names.chain.parameters.iter().any(|p| p.declared && p.name == t);
            !declared
                && matches!(stem, "a" | "d" | "alpha" | "theta" | "q")
                && digits.parse::<usize>().is_ok_and(|k| k > n)
        })
}

/// `-0.344 u^2 + u - 0.391 = 0`: an equation in numbers, which says at which values it holds.
pub(super) fn is_numeric_equation(left: &[Word], right: &[Word]) -> bool {
    let rounded = |w: &Word| w.token.text.split_once('.').is_some_and(|(_, d)| d.len() >= 4);
    let letter = |w: &Word| w.token.kind == TokenKind::Name;
    text(right) == "0" && left.iter().any(rounded) && left.iter().any(letter)
}

/// `a_n = 0`: the convention for the last frame of any arm.
pub(super) fn is_general_value(left: &[Word], right: &[Word]) -> bool {
    let general = |w: &Word| {
        let (stem, index) = w.token.text.split_once('_').unwrap_or_default();
        matches!(stem, "a" | "d" | "alpha" | "theta") && index.starts_with(['i', 'j', 'k', 'n'])
    };
    matches!(left, [only] if general(only)) && is_number(right)
}

/// A measured number that a formula of the joints is said to have: true at one pose, and no identity.
pub(super) fn is_instance(left: &[Word], right: &[Word]) -> bool {
    let exact = |w: &[Word]| !w.iter().any(|w| has_decimals(&w.token.text) || w.token.text.ends_with("deg"));
    let measured = |w: &[Word]| (is_measured(w) || is_number(w)) && !exact(w);
    let of_table = |w: &Word| {
        let t = w.token.text.as_str();
        let digits = t.trim_start_matches(|c: char| c.is_ascii_alphabetic() || c == '_');
        let stem = &t[..t.len() - digits.len()];
        w.token.kind != TokenKind::Name
            || matches!(stem.trim_end_matches('_'), "a" | "d" | "alpha" | "l" | "L" | "pi" | "sqrt")
    };
    let [formula, number] = if measured(right) { [left, right] } else { [right, left] };
    measured(number) && !formula.iter().all(of_table)
}

/// Does a number have decimals? `2.0` is the whole number 2.
pub(super) fn has_decimals(text: &str) -> bool {
    text.contains('.') && !text.ends_with(".0")
}
