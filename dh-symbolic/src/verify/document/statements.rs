//! Turns the statements of a document into lines of a derivation: definitions, given values, claims.

use super::layout::ItemKind;
use super::letter::Letter;
use super::meaning::{formula, top_level};
use super::names::{Names, Unknown};
use super::pieces::{Statement, pieces, rows};
use super::reader::items;
use super::regions::Region;
use super::transforms;
use super::{Sheet, Word};

/// Reads a stretch of formulas.
pub(super) fn read(region: &Region, names: &mut Names<'_>, sheet: &mut Sheet) {
    let items = items(&region.text, region.plain, names);
    for row in rows(items) {
        for mut statement in pieces(&row, region.loose) {
            let raw: String =
                region.text.iter().filter(|t| t.1 == statement.line && t.0 != '\n').map(|t| t.0).collect();
            statement.loose = region.loose;
            statement.marked = !region.plain;
            statement.raw = raw.trim().trim_start_matches('&').trim().to_string();
            statement.tell(names, sheet);
        }
    }
}

/// What still waits for a name when the document ends is not understood.
pub(super) fn finish(names: &mut Names<'_>, sheet: &mut Sheet) {
    for (statement, unknown) in std::mem::take(&mut sheet.waiting) {
        if statement.defined(names).is_some() {
            statement.define_late(unknown, sheet);
        } else {
            statement.partly(unknown, names, sheet);
        }
    }
}

/// Lines that may wait for a name.
const MOST_WAITING: usize = 60;

/// Is a formula nothing but numbers, one of them with decimals, or a number that no formula comes out as by itself?
fn is_measured(words: &[Word]) -> bool {
    let number = |w: &Word| w.token.text.starts_with(|c: char| c.is_ascii_digit());
    let mark = |w: &Word| "[](),;-+".contains(w.token.text.as_str());
    let large = matches!(words, [w] if w.token.text.parse::<u32>().is_ok_and(|n| n > 1));
    words.iter().all(|w| number(w) || mark(w))
        && (large || words.iter().any(|w| number(w) && w.token.text.contains('.')))
}

/// Is it one number, with its sign?
pub(super) fn is_number(words: &[Word]) -> bool {
    let rest = if words.first().is_some_and(|w| w.token.is("-")) { &words[1..] } else { words };
    matches!(rest, [w] if w.token.text.starts_with(|c: char| c.is_ascii_digit()))
}

pub(super) fn text(words: &[Word]) -> String {
    words.iter().map(|w| w.token.text.as_str()).collect::<Vec<_>>().join(" ")
}

impl Statement {
    /// The words of all sides.
    pub(super) fn words(&self, names: &Names<'_>) -> Result<Vec<Vec<Word>>, Unknown> {
        self.sides.iter().map(|s| formula(s, names)).collect()
    }

    /// The single letter on the left, if it has no meaning yet.
    pub(super) fn defined(&self, names: &Names<'_>) -> Option<Letter> {
        let first = match self.sides.first()?.as_slice() {
            [only] if only.sup.is_none() && only.before_sub.is_none() => Letter::of(only)?,
            _ => return None,
        };
        let free = names.meaning(&first).is_err() && transforms::read(self.sides.first()?.first()?, names).is_none();
        (free && self.relations.first() == Some(&"=") && !first.is_general()).then_some(first)
    }

    pub(super) fn tell(&self, names: &mut Names<'_>, sheet: &mut Sheet) {
        if self.is_condition(names) {
            return;
        }
        if self.is_legend(names) || self.is_index() || self.is_pattern() {
            sheet.mark(self.line);
            return;
        }
        if self.names_entries(names) {
            sheet.mark(self.line);
            if self.sides.len() == 2 {
                return;
            }
            // T = A B = [names]: the product is still a claim
            let mut rest = self.clone();
            rest.sides.pop();
            rest.relations.pop();
            return rest.tell(names, sheet);
        }
        if self.gives_pose(names, sheet) {
            sheet.mark(self.line);
            return;
        }
        if let Some(unknown) = self.missing(names).filter(|_| sheet.waiting.len() < MOST_WAITING) {
            sheet.waiting.push((self.clone(), unknown));
            return;
        }
        self.tell_now(names, sheet);
    }

    /// A name that a later line may define.
    fn missing(&self, names: &Names<'_>) -> Option<Unknown> {
        let skipped = usize::from(self.defined(names).is_some());
        let parts = self.sides.iter().skip(skipped).flat_map(|s| {
            let mut depth = 0;
            let halves = s.split(move |i| {
                depth += i32::from(i.is('(') || i.is('[')) - i32::from(i.is(')') || i.is(']'));
                depth == 0 && i.kind == ItemKind::PlusMinus
            });
            halves.filter(|h| !h.is_empty())
        });
        parts.filter_map(|p| formula(p, names).err()).find(|u| u.name.is_some())
    }

    fn tell_now(&self, names: &mut Names<'_>, sheet: &mut Sheet) {
        if let Some(letter) = self.defined(names) {
            return self.define(&letter, names, sheet);
        }
        if let Some((plain, common)) = self.signed_side(names) {
            return plain.tell_in(common, names, sheet);
        }
        if self.sides.iter().any(|s| top_level(s).any(|i| i.kind == ItemKind::PlusMinus)) {
            return self.both_signs(names, sheet);
        }
        match self.words(names) {
            Ok(sides) => self.claim(sides, names, sheet),
            Err(unknown) => self.partly(unknown, names, sheet),
        }
    }

    /// A side that is not understood is left out; the others are still compared.
    fn partly(&self, unknown: Unknown, names: &mut Names<'_>, sheet: &mut Sheet) {
        let good: Vec<Vec<Word>> = self.sides.iter().filter_map(|s| formula(s, names).ok()).collect();
        if good.len() < 2 && self.loose && !(self.marked && unknown.name.is_none()) {
            return;
        }
        sheet.refuse(&self.raw, self.line, unknown.why);
        if good.len() >= 2 && self.relations.iter().all(|r| *r == "=") {
            self.claim(good, names, sheet);
        }
    }

    pub(super) fn rest_claim(
        &self,
        words: Vec<Vec<Word>>,
        relations: &[&'static str],
        names: &mut Names<'_>,
        sheet: &mut Sheet,
    ) {
        let s = Statement { relations: relations.to_vec(), ..self.clone() };
        s.claim(words, names, sheet);
    }

    /// `theta = atan2(±y, x)` or `atan2(y, ±x)`, as `theta = atan2(y, x)`, and the function that both signs have in common.
    fn signed_side(&self, names: &Names<'_>) -> Option<(Statement, &'static str)> {
        let [left, right] = self.sides.as_slice() else { return None };
        let angle = formula(left, names).ok().filter(|w| names.variable(&text(w)) == Some(true));
        let [function, open, ..] = right.as_slice() else { return None };
        let whole = super::meaning::closing(right, 1) == Some(right.len() - 1);
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
    fn tell_in(&self, function: &str, names: &mut Names<'_>, sheet: &mut Sheet) {
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

    /// `theta = A ± B` and `or`: the cosine of the distance from the middle is the same for both.
    fn both_signs(&self, names: &mut Names<'_>, sheet: &mut Sheet) {
        let refuse = |sheet: &mut Sheet, why: &str| {
            sheet.refuse(&self.raw, self.line, why.into());
        };
        let [left, right] = self.sides.as_slice() else { return refuse(sheet, "± in a chain of equations") };
        let mut depth = 0;
        let cut = right.iter().position(|i| {
            depth += i32::from(i.is('(') || i.is('[')) - i32::from(i.is(')') || i.is(']'));
            depth == 0 && i.kind == ItemKind::PlusMinus
        });
        let Some(cut) = cut else { return refuse(sheet, "± on the left side") };
        let (middle, apart) = (right.get(..cut).unwrap_or_default(), right.get(cut + 1..).unwrap_or_default());
        let angle = formula(left, names).ok().filter(|w| names.variable(&text(w)) == Some(true));
        let middle = if middle.is_empty() { Ok(Vec::new()) } else { formula(middle, names) };
        let (Ok(middle), Ok(apart)) = (middle, formula(apart, names)) else {
            return match self
                .sides
                .iter()
                .find_map(|s| s.split(|i| i.kind == ItemKind::PlusMinus).find_map(|p| formula(p, names).err()))
            {
                Some(unknown) => refuse(sheet, &unknown.why),
                None => refuse(sheet, "this ± is not understood"),
            };
        };
        let word = |t: &str| Word::new(t, self.line);
        let mut line = Vec::new();
        match (angle, formula(left, names)) {
            (Some(angle), _) => {
                line.extend([word("cos"), word("(")]);
                line.extend(angle);
                if !middle.is_empty() {
                    line.push(word("-"));
                    line.push(word("("));
                    line.extend(middle);
                    line.push(word(")"));
                }
                line.extend([word(")"), word("="), word("cos"), word("(")]);
                line.extend(apart);
                line.push(word(")"));
            }
            (None, Ok(value)) => {
                // x = a ± b: (x - a)^2 = b^2
                line.push(word("("));
                line.extend(value);
                if !middle.is_empty() {
                    line.extend([word("-"), word("(")]);
                    line.extend(middle);
                    line.push(word(")"));
                }
                line.extend([word(")"), word("^"), word("2"), word("="), word("(")]);
                line.extend(apart);
                line.extend([word(")"), word("^"), word("2")]);
            }
            (None, Err(unknown)) => return refuse(sheet, &unknown.why),
        }
        sheet.put(line);
    }

    /// A value that is given, or a claim.
    fn claim(&self, sides: Vec<Vec<Word>>, names: &mut Names<'_>, sheet: &mut Sheet) {
        if let [left, right] = sides.as_slice()
            && self.relations.first() == Some(&"=")
            && is_number(right)
            && self.is_given(left, right, names, sheet)
        {
            return;
        }
        for s in &sides {
            declare_general(s, sheet);
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

/// Quantities of any row get a name of their own before they are used.
pub(super) fn declare_general(words: &[Word], sheet: &mut Sheet) {
    for w in words {
        let t = w.token.text.as_str();
        let kind = match t.split_once('_') {
            Some(("alpha" | "theta", i)) if i.starts_with(['i', 'j', 'k', 'n']) => "angle",
            Some(("a" | "d", i)) if i.starts_with(['i', 'j', 'k', 'n']) => "length",
            _ => continue,
        };
        let known = sheet.tokens.windows(2).any(|p| matches!(p, [a, b] if a.text == "let" && b.text == t));
        if !known {
            sheet.put(["let", t, ":", kind].iter().map(|x| Word::new(x, w.line)).collect());
        }
    }
}
