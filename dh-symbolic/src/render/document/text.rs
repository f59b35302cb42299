//! Documents as plain text of at most 100 columns.

use super::{Block, Document, Equation, Span, Text};
use crate::render::formula::text::picture::{Picture, beside, picture};
use crate::render::formula::text::{columns, math, width};

/// The note as plain text.
pub fn document(d: &Document) -> String {
    let mut out = format!("{}\n{}\n", d.title, "═".repeat(width(&d.title)));
    if let Some(subtitle) = &d.subtitle {
        out.push_str(&format!("\n{}\n", wrap(subtitle, 100, "")));
    }
    out.push_str(&body(d));
    out
}

/// The blocks without what a document has before them.
pub(super) fn body(d: &Document) -> String {
    d.blocks.iter().map(|b| format!("\n{}", block(b))).collect()
}

fn block(b: &Block) -> String {
    match b {
        Block::Heading(level, t) => {
            let line = text(t);
            let rule = if *level == 1 { "─" } else { "╌" };
            format!("{line}\n{}\n", rule.repeat(width(&line)))
        }
        Block::Paragraph(t) => format!("{}\n", wrap(&text(t), 100, "")),
        Block::Equations(list) => equations(list),
        Block::Table(header, rows) => table(header, rows),
        Block::List(items) => items.iter().map(|t| format!("• {}\n", wrap(&text(t), 98, "  "))).collect(),
        Block::Figure(f) => format!("{}\n", wrap(&format!("[{}] {}", f.word, text(&f.caption)), 100, "  ")),
        Block::Code(_, code) => code.lines().map(|l| format!("    {l}\n")).collect(),
    }
}

/// Running text.
pub fn text(t: &Text) -> String {
    t.0.iter()
        .map(|s| match s {
            Span::Plain(words) | Span::Code(words) => words.clone(),
            Span::Math(m) => math(m),
        })
        .collect()
}

/// Breaks at spaces, and between letters that take two columns.
fn wrap(line: &str, limit: usize, indent: &str) -> String {
    let mut words: Vec<(bool, String)> = Vec::new(); // after a space?
    let mut fresh = true;
    let mut spaced = false;
    for c in line.chars() {
        let wide = columns(c) == 2;
        match c {
            ' ' => (fresh, spaced) = (true, true),
            _ => {
                // No line begins with a closing mark.
                let joins = !fresh && !wide || "，。；：、）".contains(c);
                match words.last_mut().filter(|_| joins) {
                    Some(word) => word.1.push(c),
                    None => words.push((spaced, c.to_string())),
                }
                (fresh, spaced) = (wide, false);
            }
        }
    }
    let (mut out, mut used) = (String::new(), 0);
    for (spaced, word) in words {
        let w = width(&word);
        if used > 0 && used + usize::from(spaced) + w > limit {
            out.push('\n');
            out.push_str(indent);
            used = 0;
        } else if used > 0 && spaced {
            out.push(' ');
            used += 1;
        }
        out.push_str(&word);
        used += w;
    }
    out
}

fn equations(list: &[Equation]) -> String {
    let lefts: Vec<String> = list.iter().map(|e| math(&e.left)).collect();
    let pad = lefts.iter().map(|l| width(l)).max().unwrap_or(0);
    let mut out = String::new();
    for (e, left) in list.iter().zip(lefts) {
        for (i, line) in e.right.iter().enumerate() {
            let head =
                if i == 0 { format!("  {left}{} = ", " ".repeat(pad - width(&left))) } else { " ".repeat(pad + 5) };
            let drawn = beside(Picture { lines: vec![head], middle: 0 }, picture(line));
            for (k, l) in drawn.lines.iter().enumerate() {
                out.push_str(l.trim_end());
                if let (0, Some(n)) = (i, e.number.filter(|_| k == drawn.middle)) {
                    out.push_str(&format!("    ({n})"));
                }
                out.push('\n');
            }
        }
    }
    out
}

fn table(header: &[Text], rows: &[Vec<Text>]) -> String {
    let head: Vec<String> = header.iter().map(text).collect();
    let body: Vec<Vec<String>> = rows.iter().map(|r| r.iter().map(text).collect()).collect();
    let wide: Vec<usize> = (0..head.len())
        .map(|j| std::iter::once(&head).chain(&body).filter_map(|r| r.get(j)).map(|c| width(c)).max().unwrap_or(0))
        .collect();
    let line = |cells: &[String]| {
        let padded: Vec<String> =
            cells.iter().zip(&wide).map(|(c, w)| format!("{c}{}", " ".repeat(w.saturating_sub(width(c))))).collect();
        format!("  {}", padded.join("  ")).trim_end().to_string() + "\n"
    };
    let rule: usize = wide.iter().sum::<usize>() + 2 * wide.len().saturating_sub(1);
    let mut out = line(&head);
    out.push_str(&format!("  {}\n", "─".repeat(rule)));
    body.iter().for_each(|r| out.push_str(&line(r)));
    out
}
