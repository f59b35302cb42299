//! `T(\theta_1)`, `f_1(\theta_3)`: on what a letter depends is said in brackets after it, and is no factor.

use super::brackets::closing;
use super::layout::{Item, ItemKind};
use super::letter::Letter;
use super::names::DocumentNames;
use super::tables::function;
use super::transforms;

/// The same without lists of joint variables behind transforms and behind names of the document.
pub(super) fn unapplied(items: Vec<Item>, names: &DocumentNames<'_>) -> Vec<Item> {
    let mut out: Vec<Item> = Vec::with_capacity(items.len());
    let mut at = 0;
    while let Some(item) = items.get(at) {
        let mut item = item.clone();
        if let ItemKind::Matrix(rows) = &mut item.kind {
            for cell in rows.iter_mut().flatten() {
                *cell = unapplied(std::mem::take(cell), names);
            }
        }
        out.push(item);
        at += 1;
        let applied = out.last().is_some_and(|i| takes_arguments(i, names));
        if let Some(close) = applied.then(|| arguments(&items, at, names)).flatten() {
            // {}^0_1T(\theta_1)^{-1}
            if let (Some(last), Some(end)) = (out.last_mut(), items.get(close))
                && last.sup.is_none()
            {
                last.sup.clone_from(&end.sup);
            }
            at = close + 1;
        }
    }
    out
}

fn takes_arguments(item: &Item, names: &DocumentNames<'_>) -> bool {
    let Some(name) = item.name().filter(|n| function(n).is_none() && transforms::motion(item).is_none()) else {
        return false;
    };
    if matches!(name, "T" | "A" | "R" | "P" | "J" | "p" | "r") {
        return true;
    }
    let Some(letter) = Letter::of(item) else { return false };
    if matches!(name, "c" | "s" | "C" | "S") && letter.index.is_empty() {
        return false;
    }
    // lengths and angles of the table are factors
    names.is_given(&letter) || names.meaning(&letter).is_err()
}

/// The closing bracket of a list of nothing but joint variables.
fn arguments(items: &[Item], open: usize, names: &DocumentNames<'_>) -> Option<usize> {
    items.get(open).filter(|i| i.is('('))?;
    let close = closing(items, open)?;
    let inner = items.get(open + 1..close).filter(|i| !i.is_empty())?;
    let variable = |i: &Item| {
        i.kind == ItemKind::Dots
            || Letter::of(i).is_some_and(|l| {
                let bare =
                    l.index.is_empty() && matches!(l.stem.as_str(), "q" | "theta" | "alpha" | "beta" | "gamma" | "phi");
                bare || names.is_angle(&l) || l.stem == "q" || l.stem == "d" && !l.index.is_empty()
            })
    };
    let mut parts = inner.split(|i| i.is(','));
    // R(\alpha, \beta, \gamma): angles of their own, which `frees_arguments` looks at
    let euler = |i: &Item| i.is_bare() && matches!(i.name(), Some("alpha" | "beta" | "gamma" | "phi" | "psi"));
    let rotation = open.checked_sub(1).and_then(|k| items.get(k)).is_some_and(|i| i.name() == Some("R"));
    if rotation && inner.iter().filter(|i| euler(i)).count() > 1 {
        return None;
    }
    parts.all(|p| matches!(p, [only] if variable(only))).then_some(close)
}
