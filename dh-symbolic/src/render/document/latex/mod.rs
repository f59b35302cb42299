//! LaTeX: formulas for any document, and whole notes that compile with amsmath alone.

mod formula;
pub mod tikz;

use formula::escape;
pub use formula::math;

use crate::render::document::{Block, Document, Equation, Figure, Span, Text};
use crate::render::formula::text::width;

/// The note as a document.
pub fn document(d: &Document) -> String {
    let chinese = d.language == "zh";
    let class = if chinese { "ctexart" } else { "article" };
    let figures = if d.blocks.iter().any(|b| matches!(b, Block::Figure(_))) { "\\usepackage{tikz}\n" } else { "" };
    let subtitle = d.subtitle.as_ref().map_or(String::new(), |s| format!("\\\\[1ex] \\large {}", escape(s)));
    let mut out = if d.fragment {
        let packages = if figures.is_empty() { "amsmath" } else { "amsmath and tikz" };
        format!("% Needs {packages}.\n\\setcounter{{MaxMatrixCols}}{{20}}\n")
    } else {
        format!(
            "\\documentclass[a4paper,11pt]{{{class}}}\n\\usepackage{{amsmath}}\n{figures}\\usepackage[margin=25mm]{{geometry}}\n\
         \\setcounter{{MaxMatrixCols}}{{20}}\n\\allowdisplaybreaks\n\\setlength{{\\parindent}}{{0pt}}\n\
         \\setlength{{\\parskip}}{{0.5em}}\n\\title{{{}{subtitle}}}\n\\author{{}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n",
            escape(&d.title)
        )
    };
    out.push_str(&body(d));
    if !d.fragment {
        out.push_str("\n\\end{document}\n");
    }
    out
}

/// The blocks without what a document has before and after them.
pub(super) fn body(d: &Document) -> String {
    let mut out = String::new();
    let mut drawn = 0;
    let mut before: Option<&Block> = None;
    for b in &d.blocks {
        // an empty line before a display would end its paragraph, with too much room above
        let display = matches!(b, Block::Equations(_));
        if !(display && matches!(before, Some(Block::Paragraph(_)))) {
            out.push('\n');
        }
        if let Block::Figure(f) = b {
            drawn += 1;
            out.push_str(&figure(f, &format!("fig:{}-{drawn}", slug(&d.title))));
        } else {
            out.push_str(&block(b));
        }
        before = Some(b);
    }
    out
}

fn block(b: &Block) -> String {
    match b {
        Block::Heading(1, t) => format!("\\section{{{}}}\n", text(t)),
        Block::Heading(_, t) => format!("\\subsection{{{}}}\n", text(t)),
        Block::Paragraph(t) => format!("{}\n", text(t)),
        Block::Equations(list) => {
            format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", aligned(list, true))
        }
        Block::Table(header, rows) => {
            let line = |r: &[Text]| format!("{} \\\\\n", r.iter().map(text).collect::<Vec<_>>().join(" & "));
            let size = match table_width(header, rows) {
                0..72 => "",
                72..86 => "\\small\\setlength{\\tabcolsep}{4pt}\n",
                86..104 => "\\footnotesize\\setlength{\\tabcolsep}{3pt}\n",
                _ => "\\scriptsize\\setlength{\\tabcolsep}{3pt}\n",
            };
            format!(
                "\\begin{{center}}\n{size}\\begin{{tabular}}{{{}}}\n\\hline\n{}\\hline\n{}\\hline\n\\end{{tabular}}\n\\end{{center}}\n",
                "c".repeat(header.len()),
                line(header),
                rows.iter().map(|r| line(r)).collect::<String>()
            )
        }
        Block::List(items) => {
            let items: String = items.iter().map(|t| format!("\\item {}\n", text(t))).collect();
            format!("\\begin{{itemize}}\n{items}\\end{{itemize}}\n")
        }
        Block::Figure(f) => figure(f, "fig:figure"),
        Block::Code(_, code) => format!("\\begin{{verbatim}}\n{}\n\\end{{verbatim}}\n", code.trim_end()),
    }
}

/// Letters of a line of the table, with some room between its columns.
fn table_width(header: &[Text], rows: &[Vec<Text>]) -> usize {
    let cell = |r: &[Text], j: usize| r.get(j).map_or(0, |t| width(&super::text::text(t)));
    let column = |j: usize| rows.iter().map(|r| cell(r, j)).chain([cell(header, j)]).max().unwrap_or(0) + 2;
    (0..header.len()).map(column).sum()
}

/// A float with its caption and a label.
fn figure(f: &Figure, label: &str) -> String {
    format!(
        "\\begin{{figure}}[htbp]\n\\centering\n{}\\caption{{{}}}\n\\label{{{label}}}\n\\end{{figure}}\n",
        tikz::picture(&f.drawing),
        text(&f.caption)
    )
}

/// The last word of a title, fit for a label.
fn slug(title: &str) -> String {
    let word = |t: &str| t.chars().filter(char::is_ascii_alphanumeric).collect::<String>().to_lowercase();
    title.split_whitespace().map(word).rfind(|w| !w.is_empty() && w != "of").unwrap_or_else(|| "arm".into())
}

/// Rows of an `aligned` or `align*` environment.
pub(super) fn aligned(list: &[Equation], tags: bool) -> String {
    let mut rows = Vec::new();
    for e in list {
        for (i, line) in e.right.iter().enumerate() {
            let tag = match e.number {
                Some(n) if tags && i + 1 == e.right.len() => format!(" \\tag{{{n}}}"),
                _ => String::new(),
            };
            rows.push(match i {
                0 => format!("  {} &= {}{tag}", math(&e.left), math(line)),
                _ => format!("  &\\quad {{}}{}{tag}", math(line)),
            });
        }
    }
    rows.join(" \\\\\n")
}

/// Running text.
pub fn text(t: &Text) -> String {
    t.0.iter()
        .map(|s| match s {
            Span::Plain(words) => escape(words),
            Span::Code(words) => format!("\\texttt{{{}}}", escape(words)),
            Span::Math(m) => format!("${}$", math(m)),
        })
        .collect()
}
