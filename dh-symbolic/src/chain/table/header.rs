//! The header of a table as books and data sheets write it: `α(i-1)`, `a [mm]`, `Link`.

use super::number::{self, Unit};
use super::origin::Column;
use proc_macro2::{Delimiter, TokenTree};

/// A header cell that names a column.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Heading {
    /// The column.
    pub(super) column: Column,
    /// Whether it shows the index i-1, as tables of the modified convention do in alpha and a.
    pub(super) previous: bool,
    /// The unit of bare numbers in the column.
    pub(super) unit: Option<Unit>,
}

/// Other names of the columns, in small letters.
const NAMES: [(&str, Column); 24] = [
    ("alpha", Column::Alpha),
    ("α", Column::Alpha),
    ("a", Column::A),
    ("d", Column::D),
    ("theta", Column::Theta),
    ("θ", Column::Theta),
    ("ϑ", Column::Theta),
    ("joint", Column::Joint),
    ("joints", Column::Joint),
    ("jointi", Column::Joint),
    ("link", Column::Joint),
    ("links", Column::Joint),
    ("linki", Column::Joint),
    ("i", Column::Joint),
    ("j", Column::Joint),
    ("n", Column::Joint),
    ("row", Column::Joint),
    ("no", Column::Joint),
    ("nr", Column::Joint),
    ("#", Column::Joint),
    ("frame", Column::Joint),
    ("axis", Column::Joint),
    ("range", Column::Range),
    ("ranges", Column::Range),
];

/// Indices that say which link is meant: of the row, and of the row before.
const OWN: [&str; 5] = ["", "i", "j", "n", "k"];
const PREVIOUS: [&str; 4] = ["i-1", "j-1", "n-1", "k-1"];

/// Reads a header cell; `None` where it names no column.
pub(super) fn read(tokens: &[TokenTree]) -> Option<Heading> {
    let (tokens, unit) = match tokens.split_last() {
        Some((TokenTree::Group(group), rest)) if !rest.is_empty() => match unit_of(&group.stream().to_string()) {
            Some(unit) if group.delimiter() != Delimiter::None => (rest, Some(unit)),
            _ => (tokens, None),
        },
        _ => (tokens, None),
    };
    let mut word = String::new();
    for token in tokens {
        word += &token.to_string();
    }
    // TeX's dollars, backslashes, braces and lowered indices.
    word.retain(|c| !c.is_whitespace() && !matches!(c, '$' | '\\' | '{' | '}' | '(' | ')' | '[' | ']'));
    let word = word.to_lowercase();
    let found = NAMES.iter().filter_map(|(name, column)| Some((*column, word.strip_prefix(name)?)));
    let with_index = |(column, rest): (Column, &str)| {
        let index = rest.trim_start_matches('_');
        let previous = PREVIOUS.contains(&index);
        (previous || OWN.contains(&index)).then_some((column, previous))
    };
    let (column, previous) = found.filter_map(with_index).next()?;
    let fits = matches!(
        (&unit, column),
        (None, _)
            | (Some(Unit::Length(_)), Column::A | Column::D)
            | (Some(Unit::HalfTurns(_) | Unit::Radians), Column::Alpha | Column::Theta | Column::Range)
    );
    fits.then_some(Heading { column, previous, unit })
}

/// `mm`, `deg`, `rad`.
fn unit_of(text: &str) -> Option<Unit> {
    let text = text.trim();
    match text {
        "°" | "º" | "degree" | "degrees" => number::unit("deg"),
        "radians" => number::unit("rad"),
        "" => None,
        _ => number::unit(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_of_books() {
        let read = |text: &str| {
            let tokens: Vec<TokenTree> =
                text.parse::<proc_macro2::TokenStream>().expect("tokens").into_iter().collect();
            read(&tokens).map(|h| (h.column, h.previous, h.unit.is_some()))
        };
        for (text, column, previous, unit) in [
            ("alpha", Column::Alpha, false, false),
            ("α", Column::Alpha, false, false),
            ("alpha(i-1)", Column::Alpha, true, false),
            ("alpha_{i-1}", Column::Alpha, true, false),
            ("$a_{i-1}$", Column::A, true, false),
            ("a [mm]", Column::A, false, true),
            ("alpha (deg)", Column::Alpha, false, true),
            ("θ_i", Column::Theta, false, false),
            ("theta(i)", Column::Theta, false, false),
            ("D", Column::D, false, false),
            ("A", Column::A, false, false),
            ("Link", Column::Joint, false, false),
            ("i", Column::Joint, false, false),
            ("d_i [m]", Column::D, false, true),
            ("range [deg]", Column::Range, false, true),
        ] {
            assert_eq!(read(text), Some((column, previous, unit)), "{text}");
        }
        for text in ["tehta", "a [deg]", "theta (mm)", "b", "alpha2", "d + 1"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
