//! Names split into a letter or word and an index: a2, theta3, L_tool, px.

use super::math::{Math, Sign};
use crate::render::formula::greek;

/// A name: a letter or word, and an index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// One letter, a Greek letter's name, or a word.
    pub stem: String,
    /// What stands below: digits mostly.
    pub index: String,
}

impl Name {
    /// Splits `a2`, `theta3`, `a2_2`, `L_tool`, `px`.
    pub fn of(text: &str) -> Name {
        let split = |stem: &str, index: String| Name { stem: stem.to_string(), index };
        let cut = text.find(|c: char| c.is_ascii_digit() || c == '_').unwrap_or(text.len());
        let (stem, tail) = text.split_at(cut);
        let index = tail.trim_matches('_').replace('_', ",");
        if stem.is_empty() {
            return split(text, String::new());
        }
        if index.is_empty() && stem.len() == 2 && stem.ends_with(['x', 'y', 'z']) {
            return split(&stem[..1], stem[1..].to_string());
        }
        split(stem, index)
    }

    /// A stem with an index.
    pub(in crate::render) fn with_index(stem: &str, index: String) -> Name {
        Name { stem: stem.to_string(), index }
    }

    /// As typeset.
    pub fn math(&self) -> Math {
        let greek = greek::letter(&self.stem);
        let mut letters = self.stem.chars();
        let base = match (greek, letters.next(), letters.next()) {
            (Some(c), _, _) | (None, Some(c), None) => Math::Letter(c),
            _ => Math::Word(self.stem.clone()),
        };
        if self.index.is_empty() { base } else { base.below(index(&self.index)) }
    }
}

/// An index: digits, `2,3`, `i−1`, a letter or a word.
fn index(text: &str) -> Math {
    let mut row = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let kind = |c: char| (c.is_ascii_digit(), c.is_alphabetic());
        let same = |c: char| kind(c) == kind(first) && !matches!(first, ',' | '−');
        let end = rest.char_indices().find(|(i, c)| *i > 0 && !same(*c)).map_or(rest.len(), |(i, _)| i);
        let (part, tail) = rest.split_at(end);
        row.push(match first {
            ',' => Math::Sign(Sign::Comma),
            '−' => Math::Sign(Sign::Minus),
            c if c.is_ascii_digit() => Math::number(part),
            c if part.chars().count() == 1 => Math::Letter(c),
            _ => Math::word(part),
        });
        rest = tail;
    }
    if row.len() == 1 { row.remove(0) } else { Math::Row(row) }
}
