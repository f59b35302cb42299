//! Splits a run of formulas into statements: rows, parts of rows, sides of relations.

use super::brackets::top_level;
use super::layout::{Item, ItemKind};

/// `A = B = C` as pieces of paper.
#[derive(Clone)]
pub(super) struct Statement {
    pub(super) sides: Vec<Vec<Item>>,
    pub(super) relations: Vec<&'static str>,
    pub(super) line: usize,
    /// The line as printed.
    pub(super) raw: String,
    /// Found between sentences.
    pub(super) loose: bool,
    /// Marked as a formula all the same.
    pub(super) marked: bool,
}

/// Rows of aligned formulas; one that begins with a sign or a relation continues the row before.
pub(super) fn rows(items: Vec<Item>) -> Vec<Vec<Item>> {
    let mut rows: Vec<Vec<Item>> = vec![Vec::new()];
    for item in items {
        match item.kind {
            ItemKind::Break => rows.push(Vec::new()),
            ItemKind::Tab | ItemKind::Empty if item.is_bare() => {}
            _ => {
                if let Some(row) = rows.last_mut() {
                    row.push(item);
                }
            }
        }
    }
    let mut out: Vec<Vec<Item>> = Vec::new();
    for row in rows.into_iter().filter(|r| r.iter().any(|i| i.kind != ItemKind::Gap)) {
        let first = row.iter().find(|i| i.kind != ItemKind::Gap).map(|i| &i.kind);
        let relates = top_level(&row).any(|i| matches!(i.kind, ItemKind::Relation(_)));
        let sign = matches!(first, Some(ItemKind::Mark('+' | '-' | '*') | ItemKind::PlusMinus | ItemKind::MinusPlus));
        let continues = matches!(first, Some(ItemKind::Relation(_))) || sign && !relates;
        match out.last_mut() {
            Some(last) if continues => last.extend(row.into_iter().filter(|i| i.kind != ItemKind::Gap)),
            _ => out.push(row),
        }
    }
    out
}

/// A row cut at commas, words and wide gaps; parts without a relation take the right side of the part that follows.
pub(super) fn pieces(row: &[Item], loose: bool) -> Vec<Statement> {
    let mut parts: Vec<Vec<Item>> = vec![Vec::new()];
    let mut depth = 0;
    for item in row {
        depth += match item.kind {
            ItemKind::Mark('(' | '[' | '{') => 1,
            ItemKind::Mark(')' | ']' | '}') => -1,
            _ => 0,
        };
        let fresh = parts.len() > 1 && parts.last().is_some_and(Vec::is_empty);
        match &item.kind {
            ItemKind::Mark(',' | ';') if depth == 0 => parts.push(Vec::new()),
            ItemKind::Gap | ItemKind::Text(_) if depth == 0 => {
                // `A = B \qquad C`, or the room before an equals sign
                parts.push(Vec::new());
            }
            ItemKind::Relation(_) if fresh => {
                parts.pop();
                if let Some(l) = parts.last_mut() {
                    l.push(item.clone());
                }
            }
            _ => {
                if let Some(l) = parts.last_mut() {
                    l.push(item.clone());
                }
            }
        }
    }
    let mut out: Vec<Statement> = Vec::new();
    let mut heads: Vec<Vec<Item>> = Vec::new();
    for mut part in parts.into_iter().filter(|p| !p.is_empty()) {
        without_comment(&mut part);
        while part.last().is_some_and(|i| i.is('.') || i.is(':') || i.kind == ItemKind::Empty) {
            part.pop();
        }
        let statement = sides(&part);
        if statement.relations.is_empty() {
            // `theta_4 = A or B`: the same left side
            match out.last() {
                Some(before) if before.sides.len() == 2 && part.len() > 1 && is_angle_function(&part) => {
                    let first = before.sides.first().cloned().unwrap_or_default();
                    out.push(Statement { sides: vec![first, part], relations: before.relations.clone(), ..statement });
                }
                _ => heads.push(part),
            }
            continue;
        }
        for head in heads.drain(..) {
            if !loose && statement.sides.len() == 2 && matches!(head.as_slice(), [only] if only.name().is_some()) {
                let mut copy = statement.clone();
                if let Some(first) = copy.sides.first_mut() {
                    *first = head;
                }
                out.push(copy);
            }
        }
        out.push(statement);
    }
    out
}

/// `\theta_1 = 0 (X_0 // X_1)`: what stands in the brackets says why.
fn without_comment(part: &mut Vec<Item>) {
    if !part.last().is_some_and(|i| i.is(')')) {
        return;
    }
    let Some(open) = (0..part.len()).find(|k| super::brackets::closing(part, *k) == Some(part.len() - 1)) else {
        return;
    };
    let inner = part.get(open..).unwrap_or_default();
    let parallel =
        inner.windows(2).any(|w| w[0].is('/') && w[1].is('/')) || inner.iter().any(|i| i.name() == Some("parallel"));
    if parallel && open > 0 {
        part.truncate(open);
    }
}

fn is_angle_function(part: &[Item]) -> bool {
    part.iter().any(|i| matches!(i.name(), Some("atan2" | "acos" | "asin" | "atan")))
}

fn sides(part: &[Item]) -> Statement {
    let line = part.first().map_or(0, |i| i.line);
    let mut s = Statement {
        sides: vec![Vec::new()],
        relations: Vec::new(),
        line,
        raw: String::new(),
        loose: false,
        marked: false,
    };
    let mut depth = 0;
    for item in part {
        depth += match item.kind {
            ItemKind::Mark('(' | '[' | '{') => 1,
            ItemKind::Mark(')' | ']' | '}') => -1,
            _ => 0,
        };
        match item.kind {
            ItemKind::Relation(r) if depth == 0 => {
                s.relations.push(r);
                s.sides.push(Vec::new());
            }
            _ => {
                if let Some(side) = s.sides.last_mut() {
                    side.push(item.clone());
                }
            }
        }
    }
    s
}
