//! Functions and elementary motions with their arguments, in brackets or without: `\cos\theta_1`, `\operatorname{Atan2}(y, x)`, `R_x(\alpha)`.

use super::brackets::{closing, separator_places};
use super::layout::{Item, ItemKind};
use super::letter::{Letter, index_text};
use super::meaning::{Read, Translator, refuse};

impl<'a> Translator<'a> {
    pub(super) fn motion(&mut self, axis: char, rotation: Option<bool>) -> Read<()> {
        let open = self.at + 1;
        let Some(close) = closing(self.items, open) else { return refuse("a bracket is not closed") };
        let inner = self.items.get(open + 1..close).unwrap_or_default();
        let angle = |i: &Item| i.kind == ItemKind::Degree || Letter::of(i).is_some_and(|l| self.names.is_angle(&l));
        let turns = rotation.unwrap_or_else(|| inner.iter().any(angle));
        self.put(&format!("{}{axis} (", if turns { "R" } else { "T" }));
        self.inner(inner)?;
        self.put(")");
        self.at = close + 1;
        self.power(self.items.get(close).and_then(|i| i.sup.as_deref()))
    }

    /// The arguments of a function, in brackets or without.
    pub(super) fn call(&mut self, item: &'a Item, f: &str) -> Read<()> {
        let sup = item.sup.as_deref().and_then(index_text);
        let f = match (sup.as_deref(), f) {
            (Some("-1"), "cos") => "acos",
            (Some("-1"), "sin") => "asin",
            (Some("-1"), "tan") => "atan",
            _ => f,
        };
        let power = item.sup.as_deref().filter(|_| sup.as_deref() != Some("-1"));
        self.put(&format!("{f} ("));
        match self.peek() {
            Some(next) if f == "det" && next.is('[') => self.factor(false)?,
            Some(next) if next.is('(') || next.is('[') || next.is('{') => {
                let Some(close) = closing(self.items, self.at) else { return refuse("a bracket is not closed") };
                let inner = self.items.get(self.at + 1..close).unwrap_or_default();
                self.arguments(inner)?;
                self.at = close + 1;
                self.put(")");
                let after = self.items.get(close).and_then(|i| i.sup.as_deref());
                return self.power(power.or(after));
            }
            Some(Item { kind: ItemKind::Group(inner), .. }) => {
                let bracketed = inner.first().is_some_and(|i| i.is('(')) && closing(inner, 0) == Some(inner.len() - 1);
                let inner = if bracketed { inner.get(1..inner.len() - 1).unwrap_or_default() } else { inner };
                self.arguments(inner)?;
                self.at += 1;
            }
            _ if f == "det" => self.factor(false)?,
            _ => self.bare_argument()?,
        }
        self.put(")");
        self.power(power)
    }

    fn arguments(&mut self, inner: &'a [Item]) -> Read<()> {
        let mut start = 0;
        for k in separator_places(inner).into_iter().chain([inner.len()]) {
            self.inner(inner.get(start..k).unwrap_or_default())?;
            if k < inner.len() {
                self.put(",");
            }
            start = k + 1;
        }
        Ok(())
    }

    /// `\cos 35^\circ`, `\sin 2\theta_1`, `\cos\theta_1`.
    fn bare_argument(&mut self) -> Read<()> {
        if let Some(item) = self.peek()
            && let ItemKind::Number(n) = &item.kind
        {
            self.number(item, n)?;
            if !self.peek().is_some_and(|i| Letter::of(i).is_some_and(|l| self.names.is_angle(&l))) {
                return Ok(());
            }
            self.put("*");
        }
        let Some(item) = self.peek() else { return refuse("the argument of a function is missing") };
        if matches!(item.kind, ItemKind::Fraction(..) | ItemKind::Root(_)) {
            return self.factor(false);
        }
        let Some(letter) = Letter::of(item) else { return refuse("the argument of a function is missing") };
        let meaning = self.names.meaning(&letter)?;
        self.put(&meaning);
        self.at += 1;
        Ok(())
    }
}
