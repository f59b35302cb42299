//! Formulas on several lines of text, with brackets drawn around matrices.

use super::inline::{line, math};
use super::width;
use crate::render::formula::math::Math;

/// Lines of a picture and the line that stands on the equals sign.
pub(in crate::render) struct Picture {
    pub(in crate::render) lines: Vec<String>,
    pub(in crate::render) middle: usize,
}

/// A formula with its matrices drawn.
pub(in crate::render) fn picture(m: &Math) -> Picture {
    let pieces = m.clone().flatten();
    let mut out = Picture { lines: vec![String::new()], middle: 0 };
    let mut run: Vec<Math> = Vec::new();
    for p in pieces {
        match p {
            Math::Matrix(rows) => {
                let text = line(&std::mem::take(&mut run));
                out = beside(out, Picture { lines: vec![text], middle: 0 });
                out = beside(out, matrix(&rows));
            }
            other => run.push(other),
        }
    }
    let text = line(&run);
    beside(out, Picture { lines: vec![text], middle: 0 })
}

/// Two pictures side by side, their middle lines level.
pub(in crate::render) fn beside(a: Picture, b: Picture) -> Picture {
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
