//! Plain text: indices as Unicode subscripts, matrices with drawn brackets and aligned columns.

use super::document::{Block, Document, Equation, Span, Text};
use super::math::{Math, Script, Sign};

/// The note as plain text.
pub fn document(d: &Document) -> String {
    let mut out = format!("{}\n{}\n", d.title, "═".repeat(width(&d.title)));
    for block in &d.blocks {
        out.push('\n');
        out.push_str(&self::block(block));
    }
    out
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

/// A formula on one line.
pub fn math(m: &Math) -> String {
    piece(m).text
}

/// A formula with its matrices drawn, on several lines.
pub fn display(m: &Math) -> String {
    picture(m).lines.iter().map(|l| format!("{}\n", l.trim_end())).collect()
}

/// Columns that a line takes; Chinese and other full-width letters take two.
fn width(line: &str) -> usize {
    line.chars().map(columns).sum()
}

fn columns(c: char) -> usize {
    match u32::from(c) {
        0x1100..=0x115f | 0x2e80..=0xa4cf | 0xac00..=0xd7a3 | 0xf900..=0xfaff | 0xfe30..=0xfe4f | 0xff00..=0xff60 => 2,
        _ => 1,
    }
}

/// Breaks at spaces.
fn wrap(line: &str, limit: usize, indent: &str) -> String {
    let mut out = String::new();
    let mut used = 0;
    for word in line.split(' ') {
        let w = width(word);
        if used > 0 && used + 1 + w > limit {
            out.push('\n');
            out.push_str(indent);
            used = 0;
        } else if used > 0 {
            out.push(' ');
            used += 1;
        }
        out.push_str(word);
        used += w;
    }
    out
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
        Math::Letter(_) | Math::Word(_) | Math::Number(_) | Math::Script(_) | Math::Root(_) | Math::Fraction(..)
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
            '′' => Some('′'),
            'i' => Some('ⁱ'),
            'n' => Some('ⁿ'),
            'b' => Some('ᵇ'),
            _ => None,
        })
        .collect()
}

/// Lines of a picture and the line that stands on the equals sign.
struct Picture {
    lines: Vec<String>,
    middle: usize,
}

/// A formula with its matrices drawn.
fn picture(m: &Math) -> Picture {
    let pieces = m.clone().flatten();
    let mut out = Picture { lines: vec![String::new()], middle: 0 };
    let mut run: Vec<Math> = Vec::new();
    for p in pieces {
        match p {
            Math::Matrix(rows) => {
                let text = row(&std::mem::take(&mut run)).text;
                out = beside(out, Picture { lines: vec![text], middle: 0 });
                out = beside(out, matrix(&rows));
            }
            other => run.push(other),
        }
    }
    let text = row(&run).text;
    beside(out, Picture { lines: vec![text], middle: 0 })
}

fn beside(a: Picture, b: Picture) -> Picture {
    let above = a.middle.max(b.middle);
    let below = (a.lines.len() - a.middle).max(b.lines.len() - b.middle);
    let pad = a.lines.iter().map(|l| width(l)).max().unwrap_or(0);
    let line = |p: &Picture, i: usize| (i + p.middle).checked_sub(above).and_then(|k| p.lines.get(k)).cloned();
    let lines = (0..above + below)
        .map(|i| {
            let (left, right) = (line(&a, i).unwrap_or_default(), line(&b, i).unwrap_or_default());
            if right.is_empty() {
                left
            } else {
                format!("{left}{}{right}", " ".repeat(pad.saturating_sub(width(&left))))
            }
        })
        .collect();
    Picture { lines, middle: above }
}

fn matrix(rows: &[Vec<Math>]) -> Picture {
    let cells: Vec<Vec<String>> = rows.iter().map(|r| r.iter().map(math).collect()).collect();
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    let mut lines = vec![String::new(); cells.len()];
    for j in 0..columns {
        // Signs hang to the left of what they belong to.
        let signed = cells.iter().any(|r| r.get(j).is_some_and(|c| c.starts_with('−')));
        let column: Vec<String> = cells
            .iter()
            .map(|r| {
                let cell = r.get(j).map_or("", String::as_str);
                if signed && !cell.starts_with('−') { format!(" {cell}") } else { cell.to_string() }
            })
            .collect();
        let wide = column.iter().map(|c| width(c)).max().unwrap_or(0);
        for (line, cell) in lines.iter_mut().zip(column) {
            if j > 0 {
                line.push_str("  ");
            }
            line.push_str(&cell);
            line.push_str(&" ".repeat(wide - width(&cell)));
        }
    }
    let n = lines.len();
    let lines = lines
        .into_iter()
        .enumerate()
        .map(|(i, l)| {
            let (open, close) = match (i, n) {
                (_, 1) => ('[', ']'),
                (0, _) => ('⎡', '⎤'),
                (i, n) if i + 1 == n => ('⎣', '⎦'),
                _ => ('⎢', '⎥'),
            };
            format!("{open} {l} {close}")
        })
        .collect();
    Picture { lines, middle: n.saturating_sub(1) / 2 }
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
