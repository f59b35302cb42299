//! HTML with MathML: a page that needs no script and no network.

mod mathml;
pub mod svg;

pub(super) use mathml::escape;
pub use mathml::math;

use crate::render::document::{Block, Document, Equation, Figure, Span, Text};

/// The note as a page.
pub fn document(d: &Document) -> String {
    let subtitle = d.subtitle.as_ref().map_or(String::new(), |s| format!("<p>{}</p>\n", escape(s)));
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{}</h1>\n{subtitle}",
        d.language,
        escape(&d.title),
        escape(&d.title)
    );
    out.push_str(&body(d));
    out.push_str("</body>\n</html>\n");
    out
}

const STYLE: &str = "body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; font-family: serif; line-height: 1.5; }\n\
table.data { border-collapse: collapse; margin: 1rem auto; border-block: 1px solid; }\n\
table.data th { border-bottom: 1px solid; }\ntable.data th, table.data td { padding: 0.2rem 0.8rem; text-align: center; }\n\
div.display { margin: 1rem 0; }\n\
figure { margin: 1.5rem 0; text-align: center; }\nfigure svg { max-width: 100%; height: auto; }\nfigcaption { font-size: 0.9em; }\n";

/// Styles of the columns left of the relation, right of it, and of numbers. They stand at each cell: a book brings its own style
/// sheet, which knows nothing of ours and may use the same names for something else (mdBook floats what is called `left`).
const LEFT: &str = "text-align: right; padding-inline: 0.12em";
const RIGHT: &str = "text-align: left; padding-inline: 0.12em";
const NUMBER: &str = "padding-inline-start: 3em";

/// The blocks without the page around them.
pub(super) fn body(d: &Document) -> String {
    d.blocks.iter().map(block).collect()
}

/// A block as HTML.
pub(super) fn block(b: &Block) -> String {
    match b {
        Block::Heading(level, t) => format!("<h{0}>{1}</h{0}>\n", level + 1, text(t)),
        Block::Paragraph(t) => format!("<p>{}</p>\n", text(t)),
        Block::Equations(list) => equations(list),
        Block::Table(header, rows) => {
            let line = |r: &[Text], tag: &str| {
                let cells: String = r.iter().map(|t| format!("<{tag}>{}</{tag}>", text(t))).collect();
                format!("<tr>{cells}</tr>\n")
            };
            let body: String = rows.iter().map(|r| line(r, "td")).collect();
            format!("<table class=\"data\">\n{}{body}</table>\n", line(header, "th"))
        }
        Block::List(items) => {
            let items: String = items.iter().map(|t| format!("<li>{}</li>\n", text(t))).collect();
            format!("<ul>\n{items}</ul>\n")
        }
        Block::Figure(f) => figure(f),
        Block::Code(_, code) => format!("<pre><code>{}</code></pre>\n", escape(code)),
    }
}

/// A drawing with its caption, as an element without empty lines.
pub(super) fn figure(f: &Figure) -> String {
    let title = crate::render::document::text::text(&f.caption);
    let drawing = svg::element(&f.drawing, &title);
    format!("<figure>\n{drawing}<figcaption>{}</figcaption>\n</figure>\n", text(&f.caption))
}

fn equations(list: &[Equation]) -> String {
    let mut rows = String::new();
    for e in list {
        for (i, line) in e.right.iter().enumerate() {
            let (left, sign) = match i {
                0 => (math(&e.left), "<mo>=</mo>"),
                _ => (String::new(), "<mspace width=\"2em\"/>"),
            };
            let number = match e.number {
                Some(n) if i + 1 == e.right.len() => format!("<mtext>({n})</mtext>"),
                _ => String::new(),
            };
            rows.push_str(&format!(
                "<mtr><mtd style=\"{LEFT}\">{left}</mtd><mtd style=\"{RIGHT}\">{sign}{}</mtd><mtd style=\"{NUMBER}\">{number}</mtd></mtr>\n",
                math(line)
            ));
        }
    }
    format!(
        "<div class=\"display\" style=\"overflow-x: auto\"><math display=\"block\"><mtable displaystyle=\"true\">\n{rows}</mtable></math></div>\n"
    )
}

/// Running text as HTML.
pub(super) fn text(t: &Text) -> String {
    t.0.iter()
        .map(|s| match s {
            Span::Plain(words) => escape(words),
            Span::Code(words) => format!("<code>{}</code>", escape(words)),
            Span::Math(m) => format!("<math>{}</math>", math(m)),
        })
        .collect()
}
