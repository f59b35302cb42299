//! Brackets among the pieces of a formula: what closes what, what stands outside of all.

use super::layout::{Item, ItemKind};

pub(super) fn matrix_alone(inner: &[Item]) -> Option<&Vec<Vec<Vec<Item>>>> {
    match inner {
        [Item { kind: ItemKind::Matrix(rows), .. }] => Some(rows),
        _ => None,
    }
}

pub(super) fn depth_change(item: &Item) -> i32 {
    match item.kind {
        ItemKind::Mark('(' | '[' | '{') => 1,
        ItemKind::Mark(')' | ']' | '}') => -1,
        _ => 0,
    }
}

/// The place of the bracket that closes the one at `open`.
pub(super) fn closing(items: &[Item], open: usize) -> Option<usize> {
    let mut depth = 0;
    for (k, item) in items.iter().enumerate().skip(open) {
        depth += depth_change(item);
        if depth == 0 {
            return Some(k);
        }
    }
    None
}

/// The pieces outside of all brackets.
pub(super) fn top_level(items: &[Item]) -> impl Iterator<Item = &Item> {
    let mut depth = 0;
    items.iter().filter(move |i| {
        depth += depth_change(i);
        depth == 0
    })
}

pub(super) fn separator_places(items: &[Item]) -> Vec<usize> {
    let mut depth = 0;
    let mut out = Vec::new();
    for (k, item) in items.iter().enumerate() {
        depth += depth_change(item);
        if depth == 0 && (item.is(',') || item.is(';')) {
            out.push(k);
        }
    }
    out
}

/// How a piece is called in a message.
pub(super) fn describe(item: &Item) -> String {
    match &item.kind {
        ItemKind::Mark(c) => format!("`{c}`"),
        ItemKind::Name(n) | ItemKind::Number(n) | ItemKind::Text(n) => format!("`{n}`"),
        ItemKind::PlusMinus | ItemKind::MinusPlus => "a sign ±".into(),
        ItemKind::Cases(_) => "a list of cases".into(),
        ItemKind::Dots => "`...`".into(),
        ItemKind::Empty => "an index without a letter".into(),
        ItemKind::Degree => "a degree sign without a number".into(),
        _ => "this".into(),
    }
}
