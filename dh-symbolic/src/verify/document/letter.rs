//! Prints letters with their indices as text.

use super::layout::{Item, ItemKind};

/// A letter with its indices as text.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Letter {
    pub(super) stem: String,
    pub(super) index: String,
    /// Raised before it.
    pub(super) frame: String,
    pub(super) primes: usize,
}

impl Letter {
    pub(super) fn of(item: &Item) -> Option<Letter> {
        let text = |part: &Option<Vec<Item>>| part.as_ref().map_or(Some(String::new()), |p| index_text(p));
        Some(Letter {
            stem: item.name()?.to_string(),
            index: text(&item.sub)?,
            frame: text(&item.before_sup)?,
            primes: item.primes,
        })
    }

    /// As a name of the notation of claims that no table takes: `K_2`, `r_11_1`.
    pub(super) fn own(&self) -> String {
        let mut name = self.stem.clone();
        for part in [&self.index, &self.frame] {
            if !part.is_empty() {
                name.push('_');
                name.extend(part.chars().filter(|c| c.is_ascii_alphanumeric()));
            }
        }
        name + &"_prime".repeat(self.primes.min(3))
    }

    /// Does the index speak of any row, `i`, and not of a certain one?
    pub(super) fn is_general(&self) -> bool {
        matches!(self.index.as_str(), "i" | "i-1" | "i+1" | "j" | "k" | "n")
    }
}

/// An index as text without room; `None` where it is more than letters, digits and signs.
pub(super) fn index_text(items: &[Item]) -> Option<String> {
    let mut out = String::new();
    for item in items {
        match &item.kind {
            ItemKind::Number(n) => out.push_str(n),
            ItemKind::Name(n) => out.push_str(n),
            ItemKind::Text(n) => out.push_str(&n.replace(' ', "")),
            ItemKind::Mark(c @ (',' | '+' | '-')) => out.push(*c),
            ItemKind::Group(inner) => out.push_str(&index_text(inner)?),
            _ => return None,
        }
        if let Some(sub) = &item.sub {
            out.push_str(&index_text(sub)?);
        }
        out.push_str(&"'".repeat(item.primes));
    }
    Some(out)
}

/// The name of a quantity of any row.
pub(super) fn general(stem: &str, index: &str) -> String {
    format!("{stem}_{}", index.replace('-', "m").replace('+', "p"))
}

/// r11, px: the entry of a transform that such a letter names.
pub(super) fn field(stem: &str, index: &str) -> Option<String> {
    let digits = index.replace(',', "");
    match (stem, digits.as_bytes()) {
        ("r", [b'1'..=b'3', b'1'..=b'3']) => Some(format!("r{digits}")),
        ("p", [b'x' | b'y' | b'z']) => Some(format!("p{digits}")),
        ("p", []) => Some("p".into()),
        ("px" | "py" | "pz", []) => Some(stem.into()),
        _ => None,
    }
}
