//! Markdown with LaTeX formulas between dollar signs, as code hosts and notebooks show it.

use super::latex;
use super::{Block, Document, Span, Text};

/// The note as Markdown.
pub fn document(d: &Document) -> String {
    let mut out = head(d);
    out.push_str(&body(d));
    out
}

/// The blocks without what a document has before them.
pub(super) fn body(d: &Document) -> String {
    d.blocks.iter().map(|b| format!("\n{}", block(b))).collect()
}

/// The note with links to its figures, which are files beside it.
pub(super) fn linked(d: &Document, stem: &str) -> (String, Vec<(String, String)>) {
    let mut out = head(d);
    let mut files = Vec::new();
    for b in &d.blocks {
        out.push('\n');
        match b {
            Block::Figure(f) => {
                let name = format!("{stem}-{}.svg", files.len() + 1);
                let caption = text(&f.caption);
                out.push_str(&format!("![{}]({name})\n\n*{caption}*\n", f.word));
                files.push((name, super::html::svg::element(&f.drawing, &super::text::text(&f.caption))));
            }
            other => out.push_str(&block(other)),
        }
    }
    (out, files)
}

/// Title and subtitle.
fn head(d: &Document) -> String {
    let subtitle = d.subtitle.as_ref().map_or(String::new(), |s| format!("\n*{}*\n", escape(s)));
    format!("# {}\n{subtitle}", d.title)
}

fn block(b: &Block) -> String {
    match b {
        Block::Heading(level, t) => format!("{} {}\n", "#".repeat(usize::from(*level) + 1), text(t)),
        Block::Paragraph(t) => format!("{}\n", text(t)),
        Block::Equations(list) => match list.as_slice() {
            [only] if only.right.len() == 1 => {
                let right = only.right.first().map(latex::math).unwrap_or_default();
                let tag = only.number.map_or(String::new(), |n| format!(" \\tag{{{n}}}"));
                format!("$$\n{} = {right}{tag}\n$$\n", latex::math(&only.left))
            }
            _ => {
                let numbers: Vec<String> = list.iter().filter_map(|e| e.number).map(|n| n.to_string()).collect();
                let tag = match (numbers.first(), numbers.last()) {
                    (Some(a), Some(b)) if a == b => format!(" \\tag{{{a}}}"),
                    (Some(a), Some(b)) => format!(" \\tag{{{a}-{b}}}"),
                    _ => String::new(),
                };
                let rows = latex::aligned(list, false);
                format!("$$\n\\begin{{aligned}}\n{rows}\n\\end{{aligned}}{tag}\n$$\n")
            }
        },
        Block::Table(header, rows) => {
            let line = |r: &[Text]| format!("| {} |\n", r.iter().map(text).collect::<Vec<_>>().join(" | "));
            let rule = format!("|{}\n", "---|".repeat(header.len()));
            format!("{}{rule}{}", line(header), rows.iter().map(|r| line(r)).collect::<String>())
        }
        Block::List(items) => items.iter().map(|t| format!("- {}\n", text(t))).collect(),
        Block::Figure(f) => super::html::figure(f),
        Block::Code(language, code) => format!("```{language}\n{}\n```\n", code.trim_end()),
    }
}

fn text(t: &Text) -> String {
    t.0.iter()
        .map(|s| match s {
            Span::Plain(words) => escape(words),
            Span::Code(words) => format!("`{words}`"),
            Span::Math(m) => format!("${}$", latex::math(m)),
        })
        .collect()
}

fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if matches!(c, '\\' | '`' | '*' | '_' | '|' | '<' | '$') {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
