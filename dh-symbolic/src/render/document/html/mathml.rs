//! Formulas as MathML.

use crate::render::formula::math::{Math, Script, Sign};

/// Text without special meaning.
pub(in crate::render) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A formula as MathML, without the `math` element.
pub fn math(m: &Math) -> String {
    match m {
        Math::Row(list) => format!("<mrow>{}</mrow>", list.iter().map(math).collect::<String>()),
        Math::Letter(c) => format!("<mi>{}</mi>", escape(&c.to_string())),
        // A name of one letter would come out italic.
        Math::Word(w) => format!("<mi mathvariant=\"normal\">{}</mi>", escape(w)),
        Math::Number(n) => format!("<mn>{}</mn>", escape(n)),
        Math::Sign(s) => match s {
            Sign::Plus => "<mo>+</mo>",
            Sign::Minus => "<mo>−</mo>",
            Sign::Negative => "<mo form=\"prefix\">−</mo>",
            Sign::Equals => "<mo>=</mo>",
            Sign::Times => "<mspace width=\"0.17em\"/>",
            Sign::Comma => "<mo separator=\"true\">,</mo>",
            Sign::AtMost => "<mo>≤</mo>",
            Sign::Degree => "<mi mathvariant=\"normal\">°</mi>",
            Sign::PlusMinus => "<mo>±</mo>",
            Sign::Either => "<mo form=\"prefix\">±</mo>",
            Sign::Arrow => "<mo>→</mo>",
            Sign::Apply => "<mo>&#x2061;</mo><mspace width=\"0.17em\"/>",
            Sign::Thin => "<mspace width=\"0.17em\"/>",
            Sign::Wide => "<mspace width=\"2em\"/>",
            Sign::Prime => "<mo>′</mo>",
            Sign::Dots => "<mo>,</mo><mo>…</mo><mo>,</mo>",
        }
        .to_string(),
        Math::Open(c) => format!("<mo stretchy=\"false\" form=\"prefix\">{c}</mo>"),
        Math::Close(c) => format!("<mo stretchy=\"false\" form=\"postfix\">{c}</mo>"),
        Math::Script(s) => script(s),
        Math::Fraction(n, d) => {
            let large = n.glyphs() + d.glyphs() >= 6;
            format!("<mfrac displaystyle=\"{large}\">{}{}</mfrac>", math(n), math(d))
        }
        Math::Root(x) => format!("<msqrt>{}</msqrt>", math(x)),
        Math::Dot(x) => format!("<mover accent=\"true\">{}<mo>&#x2D9;</mo></mover>", math(x)),
        Math::Matrix(rows) => {
            let rows: String = rows
                .iter()
                .map(|r| {
                    let cells: String = r.iter().map(|c| format!("<mtd>{}</mtd>", math(c))).collect();
                    format!("<mtr>{cells}</mtr>")
                })
                .collect();
            format!("<mrow><mo>[</mo><mtable>{rows}</mtable><mo>]</mo></mrow>")
        }
    }
}

fn script(s: &Script) -> String {
    let base = math(&s.base);
    let corner = |m: &Option<Math>| m.as_ref().map_or("<mrow/>".to_string(), math);
    match (&s.before_sub, &s.before_sup, &s.sub, &s.sup) {
        (None, None, Some(sub), None) => format!("<msub>{base}{}</msub>", math(sub)),
        (None, None, None, Some(sup)) => format!("<msup>{base}{}</msup>", math(sup)),
        (None, None, _, _) => format!("<msubsup>{base}{}{}</msubsup>", corner(&s.sub), corner(&s.sup)),
        _ => format!(
            "<mmultiscripts>{base}{}{}<mprescripts/>{}{}</mmultiscripts>",
            corner(&s.sub),
            corner(&s.sup),
            corner(&s.before_sub),
            corner(&s.before_sup)
        ),
    }
}
