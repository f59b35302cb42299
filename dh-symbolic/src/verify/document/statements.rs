//! Turns the statements of a document into lines of a derivation: definitions, given values, claims.

use super::layout::{Item, ItemKind};
use super::letter::Letter;
use super::meaning::formula;
use super::names::{DocumentNames, Unknown};
use super::others::Census;
use super::pieces::{Statement, pieces, rows};
use super::reader::items;
use super::regions::LONGEST;
use super::regions::Region;
use super::transforms;
use super::values::{
    declare_general, declare_velocities, is_foreign, is_general_value, is_instance, is_measured, is_number,
    is_numeric_equation, text,
};
use super::{Sheet, Word};

/// Reads a stretch of formulas.
pub(super) fn read(region: &Region, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
    if region.text.len() > LONGEST {
        let line = region.text.first().map_or(0, |t| t.1);
        let raw: String = region.text.iter().take(100).map(|t| t.0).collect();
        return sheet.refuse(raw.trim(), line, format!("more than {LONGEST} characters without an end: not read"));
    }
    let items = items(&region.text, region.plain, names);
    let mut before: Vec<Item> = Vec::new();
    let mut any = false;
    for row in rows(items) {
        let parts = pieces(&row, region.loose);
        any |= !parts.is_empty();
        // laws of mechanics side by side
        let general = parts.iter().any(Statement::is_general);
        for mut statement in parts {
            for side in &mut statement.sides {
                *side = prepared(std::mem::take(side), names);
            }
            // `= B` in a display of its own continues the one before
            let general_row = statement.is_of_any_row();
            if let Some(first) = statement.sides.first_mut().filter(|s| s.is_empty()) {
                let last = match (before.is_empty(), general_row) {
                    (false, _) => &before,
                    (true, true) => &names.last_general,
                    (true, false) => &names.last_side,
                };
                first.clone_from(last);
            }
            before = statement.sides.last().cloned().unwrap_or_default();
            // what is said of any row goes on with what is said of any row
            names.last_general.clone_from(&before);
            if !statement.is_of_any_row() {
                names.last_side.clone_from(&before);
            }
            let raw: String =
                region.text.iter().filter(|t| t.1 == statement.line && t.0 != '\n').map(|t| t.0).collect();
            statement.loose = region.loose;
            statement.marked = !region.plain;
            statement.raw = raw.trim().trim_start_matches('&').trim().to_string();
            if general {
                sheet.remark(&statement.raw, statement.line);
            } else {
                statement.tell(names, sheet);
            }
        }
    }
    // an equation inside of braces, say
    if !any && !region.plain && !region.loose && region.text.iter().any(|t| t.0 == '=') {
        let line = region.text.first().map_or(0, |t| t.1);
        let raw: String = region.text.iter().take(LONGEST).map(|t| t.0).collect();
        sheet.refuse(raw.trim(), line, "no equation is found in this formula".into());
    }
}

/// Looks through a document before its statements are told one by one.
pub(super) fn census(regions: &[Region], names: &mut DocumentNames<'_>) {
    let mut census = Census::default();
    for region in regions.iter().filter(|r| r.text.len() <= LONGEST) {
        for row in rows(items(&region.text, region.plain, names)) {
            for mut statement in pieces(&row, region.loose) {
                for side in &mut statement.sides {
                    *side = prepared(std::mem::take(side), names);
                }
                census.count(&statement, names);
            }
        }
    }
    census.tell(names);
}

/// Without lists of variables behind letters, and without the word ORG behind a point.
fn prepared(side: Vec<Item>, names: &DocumentNames<'_>) -> Vec<Item> {
    let side = super::unapplied::unapplied(side, names);
    let is = |i: Option<&Item>, n: &str| i.is_some_and(|i| i.name() == Some(n) && i.is_bare());
    let mut out: Vec<Item> = Vec::with_capacity(side.len());
    let mut at = 0;
    while let Some(item) = side.get(at) {
        let origin = is(side.get(at), "O") && is(side.get(at + 1), "R") && is(side.get(at + 2), "G");
        if origin && out.last().is_some_and(|i| i.name() == Some("P")) {
            at += 3;
            continue;
        }
        out.push(item.clone());
        at += 1;
    }
    out
}

/// What still waits for a name when the document ends is not understood.
pub(super) fn finish(names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
    // one definition may follow from another
    let mut left = std::mem::take(&mut sheet.waiting).into_iter().collect::<std::collections::VecDeque<_>>();
    while let Some((statement, unknown)) = left.pop_front() {
        if statement.missing(names).is_none() {
            statement.tell_now(names, sheet);
        } else if statement.marked && statement.tell_free(names, sheet) {
            left.extend(std::mem::take(&mut sheet.waiting));
        } else if statement.defined(names).is_some() {
            statement.define_late(unknown, sheet);
        } else {
            statement.partly(unknown, names, sheet);
        }
    }
}

/// Lines that may wait for a name.
const MOST_WAITING: usize = 60;

impl Statement {
    /// The words of all sides.
    pub(super) fn words(&self, names: &DocumentNames<'_>) -> Result<Vec<Vec<Word>>, Unknown> {
        self.sides.iter().map(|s| formula(s, names)).collect()
    }

    /// The single letter on the left, if it has no meaning yet.
    pub(super) fn defined(&self, names: &DocumentNames<'_>) -> Option<Letter> {
        let first = match self.sides.first()?.as_slice() {
            [only] if only.sup.is_none() && only.before_sub.is_none() => Letter::of(only)?,
            _ => return None,
        };
        let open = match names.meaning(&first) {
            // what is left free, or defined for a law in general, may be said of this arm later
            Ok(name) => names.free.contains(&name) || names.generic.contains(&first.own()) && !self.is_abstract(names),
            Err(_) => true,
        };
        let free = open && transforms::read(self.sides.first()?.first()?, names).is_none();
        (free && self.relations.first() == Some(&"=") && !first.is_general()).then_some(first)
    }

    pub(super) fn tell(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        if self.is_condition(names) {
            self.take_condition(names);
            if self.marked {
                sheet.remark(&self.raw, self.line);
            }
            return;
        }
        if self.is_legend(names)
            || self.names_any_row(names)
            || self.is_index()
            || self.is_pattern()
            || self.is_general()
            || self.is_velocity_law()
        {
            return sheet.remark(&self.raw, self.line);
        }
        if let Some(rest) = self.frees_arguments(names, sheet) {
            sheet.remark(&self.raw, self.line);
            if rest.sides.len() > 1 {
                rest.tell(names, sheet);
            } else {
                names.last_side = rest.sides.into_iter().next_back().unwrap_or_default();
            }
            return;
        }
        if self.is_elsewhere(names) {
            sheet.remark(&self.raw, self.line);
            return self.understood_sides(names, sheet);
        }
        if let Some(rest) = self.without_singular() {
            if rest.sides.len() < 2 {
                return sheet.remark(&self.raw, self.line);
            }
            return rest.tell(names, sheet);
        }
        if self.names_entries(names) {
            sheet.remark(&self.raw, self.line);
            if self.sides.len() == 2 {
                return;
            }
            // T = A B = [names]: the product is still a claim
            let mut rest = self.clone();
            let last = self.sides.last().is_some_and(|s| self.is_matrix_of_names(s, names));
            let gone = if last { self.sides.len() - 1 } else { 1 };
            rest.sides.remove(gone);
            rest.relations.remove(gone - 1);
            return rest.tell(names, sheet);
        }
        if self.gives_pose(names) || self.defines_frame(names) {
            return sheet.remark(&self.raw, self.line);
        }
        if self.sides.iter().flatten().any(|i| matches!(i.kind, ItemKind::Cases(_))) {
            if self.is_about_others(names, sheet) {
                return;
            }
            return self.cases(names, sheet);
        }
        if self.gives_function(names, sheet) {
            return;
        }
        // a number for a letter that an equation before it defines
        if let Some(letter) = self.defined(names)
            && self.sides.len() == 2
            && self.words(names).is_ok_and(|_| true)
            && (names.seen.contains(&letter.own())
                || sheet.waiting.iter().any(|w| w.1.name.as_ref() == Some(&letter.own())))
            && self.sides.get(1).is_some_and(|s| formula(s, names).is_ok_and(|w| is_number(&w)))
        {
            return sheet.remark(&self.raw, self.line);
        }
        let own = self.defined(names);
        let met = self.unknown_letters(names).into_iter().filter(|l| own.as_ref() != Some(l));
        let met: Vec<String> = met.map(|l| l.own()).collect();
        names.seen.extend(met);
        if self.is_about_others(names, sheet) {
            return;
        }
        if self.is_case(names) || self.loose && names.elsewhere.contains(&self.line) {
            return sheet.remark(&self.raw, self.line);
        }
        if let Some(letter) = self.renewed(names) {
            return self.define(&letter, names, sheet);
        }
        self.gives_coefficients(names, sheet);
        if self.marked && self.is_abstract(names) && self.is_law(names) && self.tell_free(names, sheet) {
            return;
        }
        if let Some(unknown) = self.missing(names).filter(|_| sheet.waiting.len() < MOST_WAITING) {
            sheet.waiting.push((self.clone(), unknown));
            sheet.waited.insert(self.line);
            return;
        }
        self.tell_now(names, sheet);
    }

    /// A name that a later line may define.
    fn missing(&self, names: &DocumentNames<'_>) -> Option<Unknown> {
        let skipped = usize::from(self.defined(names).is_some());
        let parts = self.sides.iter().skip(skipped).flat_map(|s| {
            let mut depth = 0;
            let halves = s.split(move |i| {
                depth += i32::from(i.is('(') || i.is('[')) - i32::from(i.is(')') || i.is(']'));
                depth == 0 && matches!(i.kind, ItemKind::PlusMinus | ItemKind::MinusPlus)
            });
            halves.filter(|h| !h.is_empty())
        });
        parts.filter_map(|p| formula(p, names).err()).find(|u| u.name.is_some())
    }

    pub(super) fn tell_now(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        if let Some(letter) = self.defined(names) {
            return self.define(&letter, names, sheet);
        }
        if let Some((plain, common)) = self.signed_side(names) {
            return plain.tell_in(common, names, sheet);
        }
        if let Some(line) = self.both_signs(names) {
            return sheet.put(line);
        }
        match self.words(names) {
            Ok(sides) => self.claim(sides, names, sheet),
            Err(unknown) => self.partly(unknown, names, sheet),
        }
    }

    /// What is left of a chain with something unknown is still compared.
    fn understood_sides(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let good: Vec<Vec<Word>> = self.sides.iter().filter_map(|s| formula(s, names).ok()).collect();
        if good.len() >= 2 && self.relations.iter().all(|r| *r == "=") {
            self.claim(good, names, sheet);
        }
    }

    /// A side that is not understood is left out; the others are still compared.
    fn partly(&self, unknown: Unknown, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let good: Vec<Vec<Word>> = self.sides.iter().filter_map(|s| formula(s, names).ok()).collect();
        if good.len() < 2 && self.loose && !(self.marked && unknown.name.is_none()) {
            return;
        }
        sheet.refuse(&self.raw, self.line, unknown.why);
        self.understood_sides(names, sheet);
    }

    pub(super) fn rest_claim(
        &self,
        words: Vec<Vec<Word>>,
        relations: &[&'static str],
        names: &mut DocumentNames<'_>,
        sheet: &mut Sheet,
    ) {
        let s = Statement { relations: relations.to_vec(), ..self.clone() };
        s.claim(words, names, sheet);
    }

    /// `theta = atan2(±y, x)` or `atan2(y, ±x)`, as `theta = atan2(y, x)`, and the function that both signs have in common.
    fn signed_side(&self, names: &DocumentNames<'_>) -> Option<(Statement, &'static str)> {
        let [left, right] = self.sides.as_slice() else { return None };
        let angle = formula(left, names).ok().filter(|w| names.variable(&text(w)) == Some(true));
        let [function, open, ..] = right.as_slice() else { return None };
        let whole = super::brackets::closing(right, 1) == Some(right.len() - 1);
        let at = right.iter().position(|i| i.kind == ItemKind::PlusMinus)?;
        let common = match right.get(at.checked_sub(1)?) {
            Some(i) if i.is('(') && at == 2 => "cos",
            Some(i) if i.is(',') => "sin",
            _ => return None,
        };
        let mut plain = self.clone();
        plain.sides.get_mut(1)?.remove(at);
        let fits = function.name() == Some("atan2") && open.is('(') && whole && angle.is_some();
        fits.then_some((plain, common))
    }

    /// A function of both sides.
    fn tell_in(&self, function: &str, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        match self.words(names) {
            Ok(sides) => {
                let word = |t: &str| Word::new(t, self.line);
                let inside = |side: Vec<Word>| [vec![word(function), word("(")], side, vec![word(")")]].concat();
                let sides: Vec<Vec<Word>> = sides.into_iter().map(inside).collect();
                self.claim(sides, names, sheet);
            }
            Err(unknown) => self.partly(unknown, names, sheet),
        }
    }

    /// `theta = A ± B`: the cosine of the distance from the middle is the same for both. `None` where ± stands elsewhere: then each sign
    /// is looked at.
    fn both_signs(&self, names: &DocumentNames<'_>) -> Option<Vec<Word>> {
        let [left, right] = self.sides.as_slice() else { return None };
        let mut signs =
            self.sides.iter().flatten().filter(|i| matches!(i.kind, ItemKind::PlusMinus | ItemKind::MinusPlus));
        signs.next().filter(|_| signs.next().is_none())?;
        let mut depth = 0;
        let mut ends = right.iter().enumerate().filter(|(_, i)| {
            depth += i32::from(i.is('(') || i.is('[')) - i32::from(i.is(')') || i.is(']'));
            depth == 0 && (i.is('+') || i.is('-') || matches!(i.kind, ItemKind::PlusMinus | ItemKind::MinusPlus))
        });
        let cut = ends.find(|(_, i)| matches!(i.kind, ItemKind::PlusMinus | ItemKind::MinusPlus))?.0;
        let end = ends.next().map_or(right.len(), |e| e.0);
        // A ± B - C is (A - C) ± B
        let middle = [right.get(..cut)?, right.get(end..)?].concat();
        let apart = formula(right.get(cut + 1..end)?, names).ok()?;
        let left = formula(left, names).ok()?;
        let middle = if middle.is_empty() { Vec::new() } else { formula(&middle, names).ok()? };
        let word = |t: &str| Word::new(t, self.line);
        let turns = names.variable(&text(&left)) == Some(true);
        let (open, close) = if turns { ("cos (", ") ") } else { ("(", ") ^ 2") };
        let words = |t: &str| t.split_whitespace().map(word).collect::<Vec<_>>();
        let mut line = words(open);
        line.extend(left);
        if !middle.is_empty() {
            line.extend([word("-"), word("(")]);
            line.extend(middle);
            line.push(word(")"));
        }
        line.extend(words(close));
        line.push(word("="));
        line.extend(words(open));
        line.extend(apart);
        line.extend(words(close));
        Some(line)
    }

    /// `theta = A where ..., B where ...`: rows of possibilities.
    fn cases(&self, names: &DocumentNames<'_>, sheet: &mut Sheet) {
        let line = (|| {
            let [left, right] = self.sides.as_slice() else { return Err("cases in a chain of equations".to_string()) };
            let [Item { kind: ItemKind::Cases(rows), .. }] = right.as_slice() else {
                return Err("cases inside of a formula".to_string());
            };
            let why = |u: Unknown| u.why;
            let left = formula(left, names).map_err(why)?;
            let word = |t: &str| Word::new(t, self.line);
            let mut line = Vec::new();
            for row in rows {
                let value = row.first().filter(|v| !v.is_empty()).ok_or("an empty case")?;
                let commas = value.iter().rev().take_while(|i| i.is(',')).count();
                let value: Vec<Item> = value.iter().take(value.len() - commas).cloned().collect();
                if !line.is_empty() {
                    line.push(word("or"));
                }
                line.extend(left.iter().cloned());
                line.push(word("="));
                line.extend(formula(&value, names).map_err(why)?);
                let plain =
                    |i: &&Item| !matches!(i.kind, ItemKind::Text(_) | ItemKind::Gap) && !i.is(',') && !i.is('.');
                let condition: Vec<Item> = row.iter().skip(1).flatten().filter(plain).cloned().collect();
                if condition.is_empty() {
                    continue;
                }
                let at = condition
                    .iter()
                    .position(|i| matches!(i.kind, ItemKind::Relation(_)))
                    .ok_or("a condition without a relation")?;
                let Some(ItemKind::Relation(relation)) = condition.get(at).map(|i| &i.kind) else { continue };
                line.push(word("if"));
                line.extend(formula(&condition[..at], names).map_err(why)?);
                line.extend(relation.chars().map(|c| word(&c.to_string())));
                line.extend(formula(&condition[at + 1..], names).map_err(why)?);
            }
            Ok(line)
        })();
        match line {
            Ok(line) => sheet.put(line),
            Err(why) => sheet.refuse(&self.raw, self.line, why),
        }
    }

    /// A value that is given, or a claim.
    fn claim(&self, sides: Vec<Vec<Word>>, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        if let [left, right] = sides.as_slice()
            && self.relations.first() == Some(&"=")
            && is_number(right)
            && self.is_given(left, right, names, sheet)
        {
            return;
        }
        if let [left, right] = sides.as_slice()
            && self.relations.first() == Some(&"=")
            && (is_general_value(left, right)
                || is_numeric_equation(left, right)
                || names.values.is_empty() && is_instance(left, right))
        {
            return sheet.remark(&self.raw, self.line);
        }
        let other = names.has_others && matches!(self.parameter_value(&sides, names), Some((_, false)));
        if other || self.gives_symbol(&sides, names) || self.is_other_convention(&sides, names) {
            return sheet.remark(&self.raw, self.line);
        }
        if sides.iter().any(|s| is_foreign(s, names)) {
            return sheet.remark(&self.raw, self.line);
        }
        for s in &sides {
            declare_general(s, sheet);
            declare_velocities(s, sheet);
        }
        if let Some(both) = self.under_conditions(&sides, names) {
            return both.into_iter().for_each(|line| sheet.put(line));
        }
        let measured: Vec<bool> = sides.iter().map(|s| !names.values.is_empty() && is_measured(s)).collect();
        let mut line: Vec<Word> = Vec::new();
        for (k, side) in sides.into_iter().enumerate() {
            if k > 0 {
                let written = self.relations.get(k - 1).copied().unwrap_or("=");
                let near = measured.get(k - 1..=k).is_some_and(|pair| pair.contains(&true));
                let relation = if written == "=" && near { "~" } else { written };
                for c in relation.chars() {
                    line.push(Word::new(&c.to_string(), self.line));
                }
            }
            line.extend(side);
        }
        sheet.put(line);
    }
}
