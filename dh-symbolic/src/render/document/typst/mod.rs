//! Typst: notes that compile without packages.

mod formula;

pub use formula::math;
use formula::string;

use crate::render::document::{Block, Document, Equation, Span, Text};

/// The note as a document.
pub fn document(d: &Document) -> String {
    let setup = "#set math.mat(delim: \"[\", row-gap: 0.5em, column-gap: 1em)\n#show math.equation: set block(breakable: true)\n";
    let subtitle = d.subtitle.as_ref().map_or(String::new(), |s| format!("#align(center)[{}]\n", escape(s)));
    let mut out = if d.fragment {
        setup.to_string()
    } else {
        format!(
            "#set document(title: {})\n#set page(paper: \"a4\", margin: 25mm)\n#set text(lang: \"{}\")\n\
         {setup}\n#align(center, text(17pt)[{}])\n{subtitle}",
            string(&d.title),
            d.language,
            escape(&d.title)
        )
    };
    out.push_str(&body(d));
    out
}

/// The blocks without what a document has before them.
pub(super) fn body(d: &Document) -> String {
    d.blocks.iter().map(|b| format!("\n{}", block(b))).collect()
}

fn block(b: &Block) -> String {
    match b {
        Block::Heading(level, t) => format!("{} {}\n", "=".repeat(usize::from(*level)), text(t)),
        Block::Paragraph(t) => format!("{}\n", text(t)),
        Block::Equations(list) => equations(list),
        Block::Table(header, rows) => {
            let cells = |r: &[Text]| r.iter().map(|t| format!("[{}]", text(t))).collect::<Vec<_>>().join(", ");
            let body: String = rows.iter().map(|r| format!("  {},\n", cells(r))).collect();
            format!(
                "#align(center, table(\n  columns: {}, align: center, stroke: none,\n  table.hline(), table.header({}), table.hline(),\n{body}  table.hline(),\n))\n",
                header.len(),
                cells(header)
            )
        }
        Block::List(items) => items.iter().map(|t| format!("- {}\n", text(t))).collect(),
        Block::Figure(f) => {
            let svg = crate::render::document::html::svg::element(&f.drawing, "");
            let width = f.drawing.size[0].min(450.0);
            format!(
                "#figure(\n  image(bytes({}), format: \"svg\", width: {width:.0}pt),\n  caption: [{}],\n)\n",
                string(&svg),
                text(&f.caption)
            )
        }
        Block::Code(language, code) => format!("```{language}\n{}\n```\n", code.trim_end()),
    }
}

fn equations(list: &[Equation]) -> String {
    let mut out = String::new();
    // A run without numbers is one aligned display; a numbered equation stands alone.
    let mut run: Vec<String> = Vec::new();
    let flush = |run: &mut Vec<String>, out: &mut String| {
        if !run.is_empty() {
            out.push_str(&format!("$ {} $\n", run.join(" \\\n  ")));
            run.clear();
        }
    };
    for e in list {
        let mut rows = Vec::new();
        for (i, line) in e.right.iter().enumerate() {
            rows.push(match i {
                0 => format!("{} &= {}", math(&e.left), math(line)),
                _ => format!("&quad {}", math(line)),
            });
        }
        match e.number {
            None => run.extend(rows),
            Some(n) => {
                flush(&mut run, &mut out);
                out.push_str(&format!(
                    "#math.equation(block: true, numbering: _ => [({n})], $ {} $)\n",
                    rows.join(" \\\n  ")
                ));
            }
        }
    }
    flush(&mut run, &mut out);
    out
}

fn text(t: &Text) -> String {
    t.0.iter()
        .map(|s| match s {
            Span::Plain(words) => escape(words),
            Span::Code(words) => format!("#raw({})", string(words)),
            Span::Math(m) => format!("${}$", math(m).trim()),
        })
        .collect()
}

fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if matches!(c, '\\' | '#' | '$' | '*' | '_' | '`' | '<' | '>' | '@' | '[' | ']' | '~' | '/') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
