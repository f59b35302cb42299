//! Formulas as Typst.

use crate::render::formula::math::{Math, Script, Sign};

/// A string literal.
pub(super) fn string(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// A formula, without dollar signs. Pieces are separated by spaces: letters that touch would be a word.
pub fn math(m: &Math) -> String {
    match m {
        Math::Row(list) => list.iter().map(math).filter(|t| !t.is_empty()).collect::<Vec<_>>().join(" "),
        Math::Letter(c) => c.to_string(),
        Math::Word(w) => match w.as_str() {
            "cos" | "sin" | "tan" | "det" => w.clone(),
            _ => format!("op({})", string(w)),
        },
        Math::Number(n) => n.clone(),
        Math::Sign(s) => match s {
            Sign::Plus => "+",
            Sign::Minus => "-",
            Sign::Negative => "-",
            Sign::Equals => "=",
            Sign::Times => "thin",
            Sign::Comma => "\\,",
            Sign::AtMost => "<=",
            Sign::Degree => "degree",
            Sign::PlusMinus | Sign::Either => "plus.minus",
            Sign::Arrow => "->",
            Sign::Apply => "",
            Sign::Thin => "thin",
            Sign::Wide => "wide",
            Sign::Prime => "prime",
            Sign::Dots => "\\, dots \\,",
        }
        .to_string(),
        // Escaped: a bracket may close on another line.
        Math::Open(c) | Math::Close(c) => format!("\\{c}"),
        Math::Script(s) => script(s),
        Math::Fraction(n, d) => {
            let small = n.glyphs() + d.glyphs() < 6;
            format!("{}(frac({}, {}))", if small { "inline" } else { "display" }, math(n), math(d))
        }
        Math::Root(x) => format!("sqrt({})", math(x)),
        Math::Dot(x) => format!("dot({})", math(x)),
        Math::Matrix(rows) => {
            let rows: Vec<String> = rows.iter().map(|r| r.iter().map(math).collect::<Vec<_>>().join(", ")).collect();
            format!("mat({})", rows.join("; "))
        }
    }
}

fn script(s: &Script) -> String {
    let base = math(&s.base);
    if s.before_sup.is_none() && s.before_sub.is_none() {
        let mut out = if matches!(s.base, Math::Row(_)) { format!("({base})") } else { base };
        for (mark, corner) in [('_', &s.sub), ('^', &s.sup)] {
            if let Some(m) = corner {
                out.push_str(&format!("{mark}({})", math(m)));
            }
        }
        return out;
    }
    let corners = [("tl", &s.before_sup), ("bl", &s.before_sub), ("br", &s.sub), ("tr", &s.sup)];
    let list: Vec<String> =
        corners.iter().filter_map(|(name, corner)| corner.as_ref().map(|m| format!("{name}: {}", math(m)))).collect();
    format!("attach({base}, {})", list.join(", "))
}
