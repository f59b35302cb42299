//! Formulas on one line, with Unicode indices.

use crate::render::formula::math::{Math, Script, Sign};

/// A formula on one line.
pub fn math(m: &Math) -> String {
    piece(m).text
}

/// A row of pieces on one line.
pub(super) fn line(list: &[Math]) -> String {
    row(list).text
}

/// Text of a formula, and whether a factor that follows would run into it.
struct Piece {
    text: String,
    open_end: bool,
}

fn piece(m: &Math) -> Piece {
    let plain = |text: String| Piece { text, open_end: false };
    match m {
        Math::Row(list) => row(list),
        Math::Letter(c) => plain(c.to_string()),
        Math::Word(w) => Piece { text: w.clone(), open_end: true },
        Math::Number(n) => plain(n.clone()),
        Math::Sign(s) => plain(sign(*s).to_string()),
        Math::Open(c) | Math::Close(c) => plain(c.to_string()),
        Math::Script(s) => script(s),
        Math::Fraction(n, d) => {
            let side = |m: &Math, product: bool| {
                let pieces = m.clone().flatten();
                let sum = pieces.iter().any(|p| matches!(p, Math::Sign(Sign::Plus | Sign::Minus | Sign::PlusMinus)));
                let factors = pieces.iter().filter(|p| !matches!(p, Math::Sign(_))).count();
                if sum || (product && factors > 1) { format!("({})", math(m)) } else { math(m) }
            };
            plain(format!("{}/{}", side(n, false), side(d, true)))
        }
        Math::Root(x) => match &**x {
            Math::Number(_) | Math::Letter(_) => plain(format!("√{}", math(x))),
            _ => plain(format!("√({})", math(x))),
        },
        Math::Dot(x) => plain(format!("{}\u{307}", math(x))),
        Math::Matrix(rows) => {
            let lines: Vec<String> = rows.iter().map(|r| r.iter().map(math).collect::<Vec<_>>().join(", ")).collect();
            plain(format!("[{}]", lines.join("; ")))
        }
    }
}

fn sign(s: Sign) -> &'static str {
    match s {
        Sign::Plus => " + ",
        Sign::Minus => " − ",
        Sign::Negative => "−",
        Sign::Equals => " = ",
        Sign::Times => "·",
        Sign::Comma => ", ",
        Sign::AtMost => " ≤ ",
        Sign::Degree => "°",
        Sign::PlusMinus => " ± ",
        Sign::Either => "±",
        Sign::Arrow => " → ",
        Sign::Apply | Sign::Thin => " ",
        Sign::Wide => "    ",
        Sign::Dots => ", …, ",
        Sign::Prime => "′",
    }
}

fn is_factor(m: &Math) -> bool {
    matches!(
        m,
        Math::Letter(_)
            | Math::Word(_)
            | Math::Number(_)
            | Math::Script(_)
            | Math::Root(_)
            | Math::Dot(_)
            | Math::Fraction(..)
    )
}

fn row(list: &[Math]) -> Piece {
    let (mut out, mut open_end) = (String::new(), false);
    for (i, m) in list.iter().enumerate() {
        let p = piece(m);
        let neighbour = i > 0 && !matches!(list.get(i - 1), Some(Math::Sign(_) | Math::Open(_)))
            || list.get(i + 1).is_some_and(|n| !matches!(n, Math::Sign(_) | Math::Close(_)));
        if matches!(m, Math::Fraction(..)) && neighbour {
            out.push_str(&format!("({})", p.text));
        } else {
            let starts_factor = is_factor(m) || matches!(m, Math::Row(r) if r.first().is_some_and(is_factor));
            if open_end && starts_factor && i > 0 && !out.ends_with([' ', '·']) {
                out.push('·');
            }
            out.push_str(&p.text);
        }
        open_end = p.open_end;
    }
    Piece { text: out, open_end }
}

fn script(s: &Script) -> Piece {
    let mut out = String::new();
    let mut open_end = false;
    if let Some(m) = &s.before_sup {
        out.push_str(&superscript(&math(m)).unwrap_or_else(|| format!("({})", math(m))));
    }
    let base = math(&s.base);
    open_end |= base.chars().count() > 1 && !base.ends_with(')');
    out.push_str(&base);
    for m in [&s.sub, &s.before_sub].into_iter().flatten() {
        let text = math(m);
        match subscript(&text) {
            Some(down) => out.push_str(&down),
            None => {
                let compact: String = text.chars().filter(|c| *c != ' ').collect();
                let digits = compact.starts_with(|c: char| c.is_ascii_digit());
                let tie = if digits || matches!(compact.as_str(), "x" | "y" | "z") { "" } else { "_" };
                out.push_str(&format!("{tie}{}", compact.replace(',', "_").replace('−', "-")));
                open_end = true;
            }
        }
    }
    if let Some(m) = &s.sup {
        match superscript(&math(m)) {
            Some(up) => out.push_str(&up),
            None => {
                out.push_str(&format!("^{}", math(m)));
                open_end = true;
            }
        }
    }
    Piece { text: out, open_end }
}

fn subscript(text: &str) -> Option<String> {
    text.chars()
        .filter(|c| *c != ' ')
        .map(|c| match c {
            '0'..='9' => char::from_u32(0x2080 + c.to_digit(10)?),
            '−' => Some('₋'),
            '′' => Some('′'),
            '+' => Some('₊'),
            'i' => Some('ᵢ'),
            'j' => Some('ⱼ'),
            'n' => Some('ₙ'),
            'e' => Some('ₑ'),
            _ => None,
        })
        .collect()
}

fn superscript(text: &str) -> Option<String> {
    text.chars()
        .filter(|c| *c != ' ')
        .map(|c| match c {
            '1' => Some('¹'),
            '2' => Some('²'),
            '3' => Some('³'),
            '0'..='9' => char::from_u32(0x2070 + c.to_digit(10)?),
            '−' => Some('⁻'),
            'T' => Some('ᵀ'),
            '′' => Some('′'),
            'i' => Some('ⁱ'),
            'n' => Some('ⁿ'),
            'b' => Some('ᵇ'),
            _ => None,
        })
        .collect()
}
