//! Lookup tables for the letters, signs and commands of printed formulas.

use crate::render::formula::greek::GREEK;

/// Functions by their spellings.
pub(super) fn function(word: &str) -> Option<&'static str> {
    Some(match word {
        "cos" | "Cos" => "cos",
        "sin" | "Sin" => "sin",
        "tan" | "tg" => "tan",
        "atan2" | "arctan2" | "Atan2" | "ATAN2" | "Arctan2" => "atan2",
        "atan" | "arctan" => "atan",
        "acos" | "arccos" => "acos",
        "asin" | "arcsin" => "asin",
        "sqrt" => "sqrt",
        "Rot" => "Rot",
        "Trans" => "Trans",
        "inv" => "inv",
        "det" => "det",
        _ => return None,
    })
}

/// The name of a Greek letter's command, variants included.
pub(super) fn greek_command(command: &str) -> Option<&'static str> {
    let name = command.strip_prefix("var").unwrap_or(command);
    GREEK.iter().find(|g| g.0 == name).map(|g| g.0)
}

/// What a raised or lowered character is on the line, and whether it is raised.
pub(super) fn script(c: char) -> Option<(char, bool)> {
    Some(match c {
        '₀'..='₉' => (char::from_digit(u32::from(c) - 0x2080, 10)?, false),
        '₋' => ('-', false),
        '₊' => ('+', false),
        'ᵢ' => ('i', false),
        'ⱼ' => ('j', false),
        'ₙ' => ('n', false),
        'ₑ' => ('e', false),
        'ₓ' => ('x', false),
        '⁰' | '⁴'..='⁹' => (char::from_digit(u32::from(c) - 0x2070, 10)?, true),
        '¹' => ('1', true),
        '²' => ('2', true),
        '³' => ('3', true),
        '⁻' => ('-', true),
        '⁺' => ('+', true),
        'ⁱ' => ('i', true),
        'ⁿ' => ('n', true),
        'ᵇ' => ('b', true),
        'ᵀ' => ('T', true),
        _ => return None,
    })
}

/// Relations in the notation of claims, by their command or sign.
pub(super) fn relation(word: &str) -> Option<&'static str> {
    Some(match word {
        "=" | "equiv" | "triangleq" | "≡" => "=",
        "ne" | "neq" | "≠" => "!=",
        "approx" | "simeq" | "cong" | "≈" | "~" => "~",
        "lt" | "<" => "<",
        "gt" | ">" => ">",
        "le" | "leq" | "leqslant" | "≤" => "<=",
        "ge" | "geq" | "geqslant" | "≥" => ">=",
        _ => return None,
    })
}

/// Commands that leave no trace in a formula.
pub(super) const SILENT: [&str; 30] = [
    "left",
    "right",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "limits",
    "nolimits",
    "nonumber",
    "notag",
    "hline",
    "hfill",
    "mid",
    "rm",
    "it",
    "bf",
    "allowbreak",
    "nobreak",
    "null",
];

/// Commands whose argument is no formula.
pub(super) const IGNORED: [&str; 9] = ["tag", "label", "ref", "eqref", "color", "vspace", "hspace", "phantom", "cline"];

/// Commands that only change the looks of their argument.
pub(super) const LOOKS: [&str; 13] = [
    "mathbf",
    "boldsymbol",
    "bm",
    "mathit",
    "mathsf",
    "hat",
    "bar",
    "vec",
    "tilde",
    "widehat",
    "overline",
    "underline",
    "mathbb",
];

/// Environments of displayed formulas.
pub(super) const DISPLAYS: [&str; 9] =
    ["equation", "align", "gather", "multline", "eqnarray", "displaymath", "math", "alignat", "flalign"];

/// Environments that are matrices.
pub(super) const MATRICES: [&str; 8] =
    ["matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "smallmatrix", "array"];
