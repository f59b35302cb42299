//! Formulas as LaTeX.

use crate::render::formula::greek;
use crate::render::formula::math::{Math, Script, Sign};

/// Text without special meaning.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '~' => out.push_str("\\textasciitilde{}"),
            '^' => out.push_str("\\textasciicircum{}"),
            _ => out.push(c),
        }
    }
    out
}

/// A formula, without dollar signs.
pub fn math(m: &Math) -> String {
    let mut out = String::new();
    write(m, &mut out);
    out
}

/// Appends a command or letter; a space where it would run into the command before.
fn push(out: &mut String, text: &str) {
    let command = out.rfind('\\').is_some_and(|i| {
        let name = &out[i + 1..];
        !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic())
    });
    if command && text.starts_with(|c: char| c.is_ascii_alphabetic()) {
        out.push(' ');
    }
    out.push_str(text);
}

fn write(m: &Math, out: &mut String) {
    match m {
        Math::Row(list) => list.iter().for_each(|x| write(x, out)),
        Math::Letter('∗') => push(out, "\\ast"),
        Math::Letter('Δ') => push(out, "\\Delta"),
        Math::Letter('∂') => push(out, "\\partial"),
        // The plain commands draw older forms of these two.
        Math::Letter(c @ ('ε' | 'φ')) => push(out, &format!("\\var{}", greek::name(*c).unwrap_or_default())),
        Math::Letter(c) => match greek::name(*c) {
            Some(name) => push(out, &format!("\\{name}")),
            None => push(out, &c.to_string()),
        },
        Math::Word(w) => match w.as_str() {
            "cos" | "sin" | "tan" | "det" => push(out, &format!("\\{w}")),
            "atan2" => push(out, "\\operatorname{atan2}"),
            _ => push(out, &format!("\\mathrm{{{}}}", escape(w))),
        },
        Math::Number(n) => push(out, n),
        Math::Sign(s) => push(
            out,
            match s {
                Sign::Plus => " + ",
                Sign::Minus => " - ",
                Sign::Negative => "-",
                Sign::Equals => " = ",
                Sign::Times => "\\,",
                Sign::Comma => ",",
                Sign::AtMost => " \\le ",
                Sign::Degree => "^{\\circ}",
                Sign::PlusMinus => " \\pm ",
                Sign::Either => "\\pm ",
                Sign::Arrow => " \\to ",
                Sign::Apply => "",
                Sign::Thin => "\\,",
                Sign::Wide => "\\qquad ",
                Sign::Dots => ",\\dots,",
                Sign::Prime => "\\prime ",
            },
        ),
        Math::Open(c) => push(out, if *c == '{' { "\\{" } else { bracket(*c) }),
        Math::Close(c) => push(out, if *c == '}' { "\\}" } else { bracket(*c) }),
        Math::Script(s) => script(s, out),
        Math::Fraction(n, d) => {
            // Numbers stay small beside their formula.
            let small = n.glyphs() + d.glyphs() < 6;
            push(out, &format!("\\{}frac{{{}}}{{{}}}", if small { "t" } else { "d" }, math(n), math(d)));
        }
        Math::Root(x) => push(out, &format!("\\sqrt{{{}}}", math(x))),
        Math::Dot(x) => push(out, &format!("\\dot{{{}}}", math(x))),
        Math::Matrix(rows) => {
            let rows: Vec<String> = rows.iter().map(|r| r.iter().map(math).collect::<Vec<_>>().join(" & ")).collect();
            push(out, &format!("\\begin{{bmatrix}} {} \\end{{bmatrix}}", rows.join(" \\\\ ")));
        }
    }
}

fn bracket(c: char) -> &'static str {
    match c {
        '(' => "(",
        ')' => ")",
        '[' => "[",
        ']' => "]",
        _ => "|",
    }
}

fn script(s: &Script, out: &mut String) {
    let index = |mark: char, m: &Option<Math>, out: &mut String| {
        if let Some(m) = m {
            let text = math(m);
            out.push(mark);
            if text.len() == 1 { out.push_str(&text) } else { out.push_str(&format!("{{{text}}}")) }
        }
    };
    if s.before_sup.is_some() || s.before_sub.is_some() {
        push(out, "{}");
        index('^', &s.before_sup, out);
        index('_', &s.before_sub, out);
    }
    match &s.base {
        Math::Row(_) => push(out, &format!("{{{}}}", math(&s.base))),
        base => write(base, out),
    }
    index('_', &s.sub, out);
    index('^', &s.sup, out);
}
