//! What a document says beside this arm: of other arms, of frames and functions that have no meaning here, of quantities that it leaves free.

use super::layout::{Item, ItemKind};
use super::letter::Letter;
use super::meaning::formula;
use super::names::DocumentNames;
use super::pieces::Statement;
use super::tables::function;
use super::transforms;
use super::values::{is_foreign, is_number, text};
use super::{Sheet, Word};
use crate::algebra::{Point, Poly};
use crate::chain::{Chain, Convention, Handle, Nominal, Role};
use std::collections::{BTreeMap, BTreeSet};

/// Statements about other arms that make a document one about several arms.
const SEVERAL: usize = 3;

/// What is known of a document before its statements are read one by one.
#[derive(Default)]
pub(super) struct Census {
    /// Letters without a meaning in the table: in how many statements they stand.
    unknown: BTreeMap<String, usize>,
    /// Letters that stand alone on one side of an equation.
    defined: BTreeSet<String>,
    /// Those that are equal to something of the arm.
    concrete: BTreeSet<String>,
    /// Quantities of the table that are said to have other values.
    mismatches: BTreeSet<String>,
    /// Statements with frames or rows that the table does not have.
    foreign: usize,
}

impl Census {
    /// Takes note of a statement.
    pub(super) fn count(&mut self, s: &Statement, names: &DocumentNames<'_>) {
        let mut all: Vec<String> = s.unknown_letters(names).iter().map(Letter::own).collect();
        all.sort();
        all.dedup();
        for name in all {
            *self.unknown.entry(name).or_default() += 1;
        }
        let alone = |side: &Vec<Item>| match side.as_slice() {
            [only] if only.sup.is_none() => Letter::of(only).map(|l| l.own()),
            _ => None,
        };
        // `l_1 = l_2` and `l_1 > l_2` say what is compared, not what it is
        let compared = s.sides.iter().all(|side| alone(side).is_some_and(|l| l.contains('_')));
        if s.sides.len() > 1 && s.relations.contains(&"=") && !compared {
            self.defined.extend(s.sides.iter().filter_map(alone));
            let known = |side: &Vec<Item>| {
                let mut all = Vec::new();
                letters(side, &mut all);
                all.iter().any(|l| names.meaning(l).is_ok())
            };
            if s.sides.iter().any(known) {
                self.concrete.extend(s.sides.iter().filter_map(alone));
            }
        }
        // an angle psi of which the cosine is given
        if let [function, only] = s.sides.first().map_or(&[][..], Vec::as_slice)
            && function.name().is_some_and(|n| matches!(n, "cos" | "sin" | "tan"))
        {
            self.defined.extend(Letter::of(only).map(|l| l.own()));
        }
        if let Ok(sides) = s.words(names) {
            if let Some((name, false)) = s.parameter_value(&sides, names) {
                self.mismatches.insert(name);
            }
            self.foreign += usize::from(sides.iter().any(|w| is_foreign(w, names)));
        }
    }

    /// Is the document about other arms too?
    fn has_others(&self) -> bool {
        let length = |n: &str| n.starts_with(['l', 'L', 'a', 'd']) && n.as_bytes().get(1) == Some(&b'_');
        let missing = |(n, k): (&String, &usize)| length(n) && *k >= SEVERAL && !self.defined.contains(n);
        self.mismatches.len() > 1 || self.foreign >= SEVERAL || self.unknown.iter().any(missing)
    }

    /// Gives what was found to the names.
    pub(super) fn tell(self, names: &mut DocumentNames<'_>) {
        names.has_others = self.has_others();
        names.definable = self.defined;
        names.concrete = self.concrete;
    }
}

/// All letters of a formula.
fn letters(items: &[Item], out: &mut Vec<Letter>) {
    for (k, item) in items.iter().enumerate() {
        match &item.kind {
            // c alpha, c(alpha): the cosine
            ItemKind::Name(n)
                if matches!(n.as_str(), "c" | "s" | "C" | "S")
                    && item.sub.is_none()
                    && items
                        .get(k + 1)
                        .is_some_and(|i| i.is('(') || matches!(i.kind, ItemKind::Name(_) | ItemKind::Group(_))) => {}
            ItemKind::Name(n) => {
                let mark = matches!(n.as_str(), "partial" | "prime" | "T" | "A" | "R" | "P" | "J" | "?");
                if !mark && function(n).is_none() && transforms::motion(item).is_none() {
                    out.extend(Letter::of(item));
                }
            }
            ItemKind::Group(inner) | ItemKind::Root(inner) | ItemKind::Dotted(inner) => letters(inner, out),
            ItemKind::Fraction(top, below) => {
                letters(top, out);
                letters(below, out);
            }
            ItemKind::Matrix(rows) | ItemKind::Cases(rows) => {
                rows.iter().flatten().for_each(|cell| letters(cell, out));
            }
            _ => {}
        }
    }
}

impl Statement {
    /// Letters without a meaning, each once.
    pub(super) fn unknown_letters(&self, names: &DocumentNames<'_>) -> Vec<Letter> {
        let mut all = Vec::new();
        self.sides.iter().for_each(|s| letters(s, &mut all));
        let mut out: Vec<Letter> = Vec::new();
        for l in all {
            if !l.is_general() && names.meaning(&l).is_err() && !out.contains(&l) {
                out.push(l);
            }
        }
        out
    }

    /// Does the right side speak of row i, whichever it is?
    pub(super) fn is_of_any_row(&self) -> bool {
        let mut all = Vec::new();
        letters(self.sides.last().map_or(&[][..], Vec::as_slice), &mut all);
        all.iter().any(Letter::is_general)
    }

    /// `Q_i = R_x(\alpha_{i-1}) ...`: a name for something of any row.
    pub(super) fn names_any_row(&self, names: &DocumentNames<'_>) -> bool {
        let [left, _] = self.sides.as_slice() else { return false };
        let [only] = left.as_slice() else { return false };
        let letter = Letter::of(only).filter(|l| l.is_general() && names.meaning(l).is_err());
        letter.is_some() && transforms::read(only, names).is_none() && self.is_of_any_row()
    }

    /// Points of frames, functions without a formula, frames without a transform, questions: nothing about this arm.
    pub(super) fn is_elsewhere(&self, names: &DocumentNames<'_>) -> bool {
        let point = |i: &Item| {
            i.name() == Some("P")
                && i.before_sup.is_some()
                && i.before_sub.is_none()
                && i.sub.is_none()
                && i.sup.is_none()
        };
        let question = |s: &Vec<Item>| matches!(s.as_slice(), [only] if only.is('?'));
        let frames = |i: &Item| transforms::has_unknown_frame(i, names);
        self.sides.iter().flatten().any(|i| point(i) || frames(i))
            || self.sides.iter().any(|s| question(s) || is_bare_function(s))
    }

    /// Is it about another arm, by letters or frames without a meaning here? Then what it defines has none either.
    pub(super) fn is_about_others(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) -> bool {
        if !names.has_others {
            return false;
        }
        let unknown = self.unknown_letters(names);
        let own = self.defined(names);
        let length = |l: &Letter| matches!(l.stem.as_str(), "l" | "L" | "a" | "d") && !l.index.is_empty();
        let missing = |l: &Letter| length(l) && !names.definable.contains(&l.own());
        let alien = |l: &Letter| names.aliens.contains(&l.own()) || missing(l);
        let mut about = unknown.iter().any(|l| own.as_ref() != Some(l) && alien(l));
        // a number for a letter of another arm
        about |= own.as_ref().is_some_and(|l| names.aliens.contains(&l.own()))
            && self.sides.iter().skip(1).all(|s| formula(s, names).is_ok_and(|w| is_number(&w)));
        about |= self.sides.iter().filter_map(|s| formula(s, names).ok()).any(|w| is_foreign(&w, names));
        if about {
            names.aliens.extend(unknown.iter().map(Letter::own));
            sheet.remark(&self.raw, self.line);
            unknown.iter().for_each(|l| self.release(l, names, sheet));
        }
        about
    }

    /// `alpha_1 = 0`, `a_1 = a_3 = 0`: a quantity of the table, and whether the table says so too. `None` for other statements, and for
    /// quantities without a number in the table.
    pub(super) fn parameter_value(&self, sides: &[Vec<Word>], names: &DocumentNames<'_>) -> Option<(String, bool)> {
        let (last, all) = sides.split_last()?;
        if !is_number(last) || self.relations.iter().any(|r| *r != "=") {
            return None;
        }
        let value = number(last)?;
        let mut found = None;
        for side in all {
            let [only] = side.as_slice() else { return None };
            let known = table_number(names.chain, &only.token.text)?;
            let same = (known - value).abs() <= 1e-9 * known.abs().max(1.0);
            if !same || found.is_none() {
                found = Some((only.token.text.clone(), same));
            }
        }
        found
    }

    /// A number for a quantity that is a symbol in the table, by the name of its cell: `a_1 = 30` where this is l1.
    pub(super) fn gives_symbol(&self, sides: &[Vec<Word>], names: &DocumentNames<'_>) -> bool {
        let Some((last, all)) = sides.split_last() else { return false };
        let declared = |n: &str| {
            names.chain.parameters.iter().any(|p| p.declared && p.name == n && matches!(p.role, Role::Field(None)))
        };
        let of_cell = |n: &str| cell(names.chain, n).is_some();
        // one declared quantity alone is given a value; several are a case
        let symbolic = |s: &Vec<Word>| matches!(s.as_slice(), [only] if of_cell(&only.token.text) && table_number(names.chain, &only.token.text).is_none() || all.len() > 1 && declared(&only.token.text));
        let parameter =
            |s: &Vec<Word>| matches!(s.as_slice(), [only] if of_cell(&only.token.text) || declared(&only.token.text));
        is_number(last) && all.iter().all(parameter) && all.iter().any(symbolic)
    }

    /// The link transform of the other convention, from its four motions.
    pub(super) fn is_other_convention(&self, sides: &[Vec<Word>], names: &DocumentNames<'_>) -> bool {
        let first = |s: &Vec<Word>| {
            let has = |m: &str| s.iter().any(|w| w.token.text == m);
            let all = ["Rx", "Tx", "Rz", "Tz"].into_iter().all(has) && s.iter().any(|w| w.token.text.ends_with("_i"));
            let head = s.iter().find(|w| matches!(w.token.text.as_str(), "Rx" | "Tx" | "Rz" | "Tz"))?;
            all.then(|| head.token.text.ends_with('z'))
        };
        let standard = names.chain.convention == Convention::Standard;
        sides.iter().filter_map(first).any(|z_first| z_first != standard)
    }

    /// `R(\alpha, \beta) = ...`: the letters on which an unknown function depends are free from here on. What is left is the rest.
    pub(super) fn frees_arguments(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) -> Option<Statement> {
        let [head, open, inner @ .., close] = self.sides.first()?.as_slice() else { return None };
        let function =
            head.name().is_some() && open.is('(') && close.is(')') && formula(self.sides.first()?, names).is_err();
        let parts: Vec<&[Item]> = inner.split(|i| i.is(',')).collect();
        let angle = |p: &&[Item]| match p {
            [only] => Letter::of(only).filter(|l| names.is_angle(l) && l.index.is_empty()),
            _ => None,
        };
        let list: Vec<Letter> = parts.iter().filter_map(angle).collect();
        if !function || list.is_empty() || list.len() != parts.len() || self.sides.len() < 2 {
            return None;
        }
        for l in &list {
            let free = names.meaning(l).is_ok_and(|name| names.free.contains(&name));
            if !free {
                self.free(l, names, sheet);
            }
        }
        let mut rest = self.clone();
        rest.sides.remove(0);
        rest.relations.remove(0);
        Some(rest)
    }

    /// Nothing but letters without a meaning in the table: `a \cos\theta + b \sin\theta = c`.
    pub(super) fn is_abstract(&self, names: &DocumentNames<'_>) -> bool {
        let mut all = Vec::new();
        self.sides.iter().for_each(|s| letters(s, &mut all));
        let own = |l: &Letter| {
            names.generic.contains(&l.own())
                || is_plain(l, names) && names.meaning(l).map_or(true, |n| names.free.contains(&n))
        };
        !all.is_empty() && all.iter().all(own)
    }

    /// Is it said for any quantities? It is, if the document nowhere says what its letters are in this arm, or if what it says does not fit.
    pub(super) fn is_law(&self, names: &DocumentNames<'_>) -> bool {
        let unknown = self.unknown_letters(names);
        names.learnt.laws.contains(&self.line) || !unknown.iter().any(|l| names.concrete.contains(&l.own()))
    }

    /// A letter becomes a quantity of its own.
    pub(super) fn free(&self, letter: &Letter, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let kind = if names.is_angle(letter) { "angle" } else { "length" };
        let name = names.give(letter, false);
        sheet.put(["let", &name, ":", kind].iter().map(|w| Word::new(w, self.line)).collect());
        names.free.insert(name);
    }

    /// At the end of a document, letters that nothing defines are free; a letter that stands alone on the right has the value of the left.
    pub(super) fn tell_free(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) -> bool {
        let unknown = self.unknown_letters(names);
        if unknown.is_empty() || !unknown.iter().all(|l| is_plain(l, names)) || self.relations.iter().any(|r| *r != "=")
        {
            return false;
        }
        if self.is_abstract(names) {
            names.generic.extend(unknown.iter().map(Letter::own));
        }
        let alone_in = |side: usize, other: usize| {
            let [only] = self.sides.get(side)?.as_slice() else { return None };
            let letter = Letter::of(only).filter(|l| only.sup.is_none() && unknown.contains(l))?;
            let mut rest = Vec::new();
            letters(self.sides.get(other)?, &mut rest);
            (self.sides.len() == 2 && !rest.contains(&letter)).then_some(letter)
        };
        let leads = alone_in(0, 1);
        let alone = if leads.is_some() { leads.clone() } else { alone_in(1, 0) };
        for l in unknown.iter().filter(|l| alone.as_ref() != Some(l)) {
            self.free(l, names, sheet);
        }
        match alone {
            Some(letter) => {
                let mut turned = self.clone();
                if leads.is_none() {
                    turned.sides.reverse();
                }
                turned.define(&letter, names, sheet);
            }
            None => self.tell_now(names, sheet),
        }
        true
    }

    /// `A = B = k_1 c_1 - k_2 s_1`: coefficients without a meaning are what stands at their places before.
    pub(super) fn gives_coefficients(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let [.., before, last] = self.sides.as_slice() else { return };
        let (old, new) = (terms(before), terms(last));
        if old.len() != new.len() || old.len() < 2 {
            return;
        }
        let key = |items: &[Item]| formula(items, names).ok().map(|w| text(&w));
        let mut found: Vec<(Letter, Vec<Word>)> = Vec::new();
        for (minus, term) in &new {
            let unknown = |i: &&Item| i.sup.is_none() && Letter::of(i).is_some_and(|l| names.meaning(&l).is_err());
            let [letter] = term.iter().filter(unknown).collect::<Vec<_>>()[..] else { return };
            let Some(letter) = Letter::of(letter) else { return };
            let rest: Vec<Item> = term.iter().filter(|i| !unknown(i)).cloned().collect();
            let Some(rest) = key(&rest) else { return };
            let value = old.iter().find_map(|(sign, t)| {
                let place = (0..t.len()).find(|k| key(&t[*k..=*k]).as_ref() == Some(&rest))?;
                let left: Vec<Item> = t.iter().enumerate().filter(|(k, _)| *k != place).map(|x| x.1.clone()).collect();
                let words = formula(&left, names).ok()?;
                let minus = (sign != minus).then(|| Word::new("-", self.line));
                let open = [Word::new("(", self.line)];
                Some(minus.into_iter().chain(open).chain(words).chain([Word::new(")", self.line)]).collect::<Vec<_>>())
            });
            let Some(value) = value else { return };
            found.push((letter, value));
        }
        for (letter, value) in found {
            let name = names.give(&letter, false);
            let head = ["let", &name, "="].map(|w| Word::new(w, self.line));
            sheet.put(head.into_iter().chain(value).collect());
            self.release(&letter, names, sheet);
        }
    }
}

/// A letter without an index, such as people take for any quantity.
fn is_plain(l: &Letter, names: &DocumentNames<'_>) -> bool {
    let single = l.stem.len() == 1 && l.frame.is_empty() && l.primes == 0;
    l.index.is_empty() && (single || names.is_angle(l))
}

/// The terms of a sum with their signs.
fn terms(side: &[Item]) -> Vec<(bool, Vec<Item>)> {
    let mut out = vec![(false, Vec::new())];
    let mut depth = 0;
    for item in side {
        depth += super::brackets::depth_change(item);
        let sign = depth == 0 && (item.is('+') || item.is('-'));
        match out.last_mut() {
            Some(last) if sign && last.1.is_empty() => last.0 ^= item.is('-'),
            _ if sign => out.push((item.is('-'), Vec::new())),
            Some(last) => last.1.push(item.clone()),
            None => {}
        }
    }
    out
}

/// `f(\theta_1, ..., \theta_n)`, `f^{-1}(T)`: a function without a formula.
fn is_bare_function(side: &[Item]) -> bool {
    let [name, open, .., close] = side else { return false };
    let letter = matches!(name.name(), Some("f" | "g" | "h" | "F")) && name.sub.is_none();
    letter && open.is('(') && close.is(')') && super::brackets::closing(side, 1) == Some(side.len() - 1)
}

pub(super) fn number(words: &[Word]) -> Option<f64> {
    let (sign, w) = match words {
        [w] => (1.0, w),
        [m, w] if m.token.is("-") => (-1.0, w),
        _ => return None,
    };
    let t = w.token.text.as_str();
    let x = match t.strip_suffix("deg") {
        Some(d) => d.parse::<f64>().ok()?.to_radians(),
        None => t.parse().ok()?,
    };
    Some(sign * x)
}

/// A cell of the table by its name: an angle, or a length.
enum Cell<'a> {
    Angle(&'a crate::algebra::LinearAngle),
    Length(&'a Poly),
}

fn cell<'a>(chain: &'a Chain, name: &str) -> Option<Cell<'a>> {
    if chain.parameters.iter().any(|p| p.declared && p.name == name) {
        return None;
    }
    let at = name.find(|c: char| c.is_ascii_digit())?;
    let (stem, n) = (&name[..at], name[at..].parse::<usize>().ok()?);
    let ahead = usize::from(chain.convention == Convention::Modified);
    let own = |k: usize| chain.links.get(k.checked_sub(1)?);
    Some(match stem {
        "alpha" => Cell::Angle(&own(n + ahead)?.alpha),
        "a" => Cell::Length(&own(n + ahead)?.a),
        "d" => Cell::Length(&own(n)?.d),
        _ => return None,
    })
}

/// The number that the table has there; `None` where it has none.
pub(super) fn table_number(chain: &Chain, name: &str) -> Option<f64> {
    let constant = |s: crate::algebra::Symbol| {
        let p = chain.parameters.iter().find(|p| p.handle == Handle::Length(s));
        match p.map(|p| &p.role) {
            Some(Role::Constant(Nominal::Length(x))) => x.to_f64(),
            _ => f64::NAN,
        }
    };
    let x = match cell(chain, name)? {
        Cell::Angle(a) if a.terms.is_empty() => a.constant.radians(),
        Cell::Angle(_) => return None,
        Cell::Length(p) => p.evaluate(&Point { symbol: &constant, angle: &|_| f64::NAN }),
    };
    x.is_finite().then_some(x)
}
