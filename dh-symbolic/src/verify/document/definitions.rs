//! Statements that define something and claim nothing: legends, names of matrix entries, definitions, given values.

use super::layout::{Item, ItemKind};
use super::letter::Letter;
use super::meaning::formula;
use super::names::{DocumentNames, Unknown};
use super::pieces::Statement;
use super::transforms;
use super::values::{declare_general, is_number, text};
use super::{Sheet, Word};

impl Statement {
    /// `{}^0_6T = G` with a letter G without a meaning: G is that transform, and r_{11} and p_x are its entries from here on.
    pub(super) fn gives_pose(&self, names: &mut DocumentNames<'_>) -> bool {
        let [left, right] = self.sides.as_slice() else { return false };
        let ([transform], [given]) = (left.as_slice(), right.as_slice()) else { return false };
        let Some(letter) = Letter::of(given).filter(|l| l.stem == "G" && l.index.is_empty()) else { return false };
        let Some((from, to)) = transforms::ends(transform).filter(|_| names.meaning(&letter).is_err()) else {
            return false;
        };
        let Ok(pose) = transforms::between(&from, &to, names) else { return false };
        names.bind(letter, pose.clone());
        names.say_pose(pose);
        true
    }

    /// `{}^{4'}_4T = D_z(d_4)`: a frame beside those of the table.
    pub(super) fn defines_frame(&self, names: &mut DocumentNames<'_>) -> bool {
        let ([transform], [right]) =
            (self.sides.first().map_or(&[][..], Vec::as_slice), self.sides.get(1..).unwrap_or(&[]))
        else {
            return false;
        };
        if transforms::ends(transform).is_none_or(|(i, j)| !i.ends_with('\'') && !j.ends_with('\'')) {
            return false;
        }
        let Ok(words) = formula(right, names) else { return false };
        let Some((label, seen)) = transforms::defined(transform, &text(&words), names) else { return false };
        names.say_frame(label, seen);
        true
    }

    /// `cos psi = E` with an angle psi without a meaning: psi is the angle with this cosine.
    pub(super) fn gives_function(&self, names: &mut DocumentNames<'_>, sheet: &mut Sheet) -> bool {
        let [left, right] = self.sides.as_slice() else { return false };
        let inverse = match left.first().and_then(Item::name) {
            Some("cos") => "acos",
            Some("sin") => "asin",
            Some("tan") => "atan",
            _ => return false,
        };
        let argument = match left.as_slice() {
            [_, only] => only,
            [_, open, only, close] if open.is('(') && close.is(')') => only,
            _ => return false,
        };
        let Some(letter) = Letter::of(argument).filter(|l| names.is_angle(l) && names.meaning(l).is_err()) else {
            return false;
        };
        let Ok(value) = formula(right, names) else { return false };
        if is_number(&value) || self.relations.first() != Some(&"=") {
            return false;
        }
        declare_general(&value, sheet);
        let name = names.give(&letter, false);
        let word = |t: &str| Word::new(t, self.line);
        let mut line = vec![word("let"), word(&name), word("="), word(inverse), word("(")];
        line.extend(value);
        line.push(word(")"));
        sheet.put(line);
        self.release(&letter, names, sheet);
        true
    }

    /// Lines that waited for a name.
    pub(super) fn release(&self, letter: &Letter, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let own = letter.own();
        let (ready, others): (Vec<_>, Vec<_>) =
            std::mem::take(&mut sheet.waiting).into_iter().partition(|w| w.1.name.as_ref() == Some(&own));
        sheet.waiting = others;
        ready.into_iter().for_each(|w| w.0.tell(names, sheet));
    }

    /// Derivatives by time and sums over forces: mechanics in general, nothing of this robot.
    pub(super) fn is_general(&self) -> bool {
        let name = |i: &Item, n: &str| i.name() == Some(n);
        let by_time = |i: &Item| matches!(&i.kind, ItemKind::Fraction(t, b) if t.first().is_some_and(|i| name(i, "d")) && b.first().is_some_and(|i| name(i, "d")));
        self.sides.iter().flatten().any(|i| by_time(i) || name(i, "int") || name(i, "sum"))
    }

    /// `\dot x = J \dot q`: what J is for, with the velocities of a pose that has no letters of its own.
    pub(super) fn is_velocity_law(&self) -> bool {
        let whole = |i: &Item| matches!(&i.kind, ItemKind::Dotted(inner) if i.sub.is_none() && matches!(inner.as_slice(), [only] if only.sub.is_none() && matches!(only.name(), Some("x" | "X" | "p" | "P" | "r" | "y" | "xi"))));
        let jacobian = |i: &Item| i.name() == Some("J");
        self.sides.iter().flatten().any(whole) && self.sides.iter().flatten().any(jacobian)
    }

    /// `det J = E = 0`: where the arm is singular. What it says of J is the rest.
    pub(super) fn without_singular(&self) -> Option<Statement> {
        let zero = |s: &Vec<Item>| matches!(s.as_slice(), [Item { kind: ItemKind::Number(n), .. }] if n == "0");
        let first = self.sides.first()?;
        let determinant = first.first().is_some_and(|i| i.name() == Some("det") || i.is('|'));
        if !determinant || !self.sides.last().is_some_and(zero) || self.relations.last() != Some(&"=") {
            return None;
        }
        let mut rest = self.clone();
        rest.sides.pop();
        rest.relations.pop();
        Some(rest)
    }

    /// A matrix with places that do not matter: `∗`.
    pub(super) fn is_pattern(&self) -> bool {
        let star = |cell: &Vec<Item>| matches!(cell.as_slice(), [only] if only.is('∗') || only.is('*'));
        let in_matrix = |i: &Item| matches!(&i.kind, ItemKind::Matrix(rows) if rows.iter().flatten().any(star));
        let in_brackets = |s: &Vec<Item>| {
            s.windows(3).any(|w| w[1].is('∗') && "[,;".contains(mark(&w[0])) && "],;".contains(mark(&w[2])))
        };
        self.sides.iter().any(|s| s.iter().any(in_matrix) || in_brackets(s))
    }

    /// In a sentence, `s_5 = 0` is a condition and no claim, and so is `theta_3 = atan2(-d_4, a_3)`.
    pub(super) fn is_condition(&self, names: &DocumentNames<'_>) -> bool {
        let (Some(left), Some(right)) = (self.sides.first(), self.sides.get(1)) else { return false };
        let signed = |i: &Item| matches!(i.kind, ItemKind::PlusMinus | ItemKind::MinusPlus);
        if !self.loose || self.sides.iter().flatten().any(signed) {
            return false;
        }
        // lengths of the table among themselves
        let of_table = |w: &Word| {
            let declared = names.chain.parameters.iter().any(|p| p.declared && p.name == w.token.text);
            declared || !w.token.text.starts_with(|c: char| c.is_ascii_alphabetic())
        };
        if let Ok(sides) = self.words(names)
            && !is_number(sides.last().map_or(&[][..], Vec::as_slice))
            && sides.iter().all(|s| s.len() == 1)
            && sides.iter().flatten().all(of_table)
            && sides.first() != sides.get(1)
        {
            return true;
        }
        let number = matches!(right.as_slice(), [Item { kind: ItemKind::Number(_), .. }]);
        if number && matches!(left.as_slice(), [only] if only.is_bare() && matches!(only.name(), Some("x" | "y"))) {
            return true;
        }
        // beta = 0 of an angle that is no joint's
        let angle = match left.as_slice() {
            [only] if only.is_bare() => Letter::of(only).filter(|l| names.is_angle(l) && l.index.is_empty()),
            _ => None,
        };
        if angle.is_some_and(|l| names.is_given(&l) || names.meaning(&l).is_err())
            && formula(right, names).is_ok_and(|w| is_number(&w))
        {
            return true;
        }
        let zero =
            self.sides.len() == 2 && matches!(right.as_slice(), [Item { kind: ItemKind::Number(n), .. }] if n == "0");
        let Ok(variable) = formula(left, names) else { return false };
        let variable = names.variable(&text(&variable)).is_some();
        let fixed = formula(right, names).is_ok_and(|w| {
            w.len() > 2
                && !w
                    .iter()
                    .any(|w| w.token.text.starts_with(['q', 'T', 'J', 'c', 's']) || w.token.text.starts_with("theta"))
        });
        zero && !variable || variable && fixed
    }

    /// `i = 1, ..., 6`.
    pub(super) fn is_index(&self) -> bool {
        let one = |s: &Vec<Item>| matches!(s.as_slice(), [only] if matches!(only.name(), Some("i" | "j" | "k" | "n")) && only.is_bare());
        self.sides.first().is_some_and(one)
    }

    /// `c_i = cos theta_i`, `c_2 = cos q_2`.
    pub(super) fn is_legend(&self, names: &mut DocumentNames<'_>) -> bool {
        // cos theta_i = c theta_i = c_i
        let short = |s: &Vec<Item>| matches!(s.as_slice(), [only] if Letter::of(only).is_some_and(|l| l.is_general() && matches!(l.stem.as_str(), "c" | "s")));
        if self.sides.len() > 2 && self.sides.iter().any(short) {
            return true;
        }
        let [left, right] = self.sides.as_slice() else { return false };
        let ([short], [function, angle, ..]) = (left.as_slice(), right.as_slice()) else { return false };
        let (Some(short), Some(f)) = (Letter::of(short), function.name()) else { return false };
        if let (ItemKind::Mark('('), "c" | "s", "cos" | "sin") = (&angle.kind, short.stem.as_str(), f) {
            // c_{23} = cos(q_2 + theta_3): each of these angles is meant by its index
            let list: Vec<Letter> = right.iter().skip(2).filter_map(Letter::of).collect();
            let joined: String = list.iter().map(|l| l.index.as_str()).collect();
            if list.len() > 1
                && joined == short.index
                && list.iter().all(|l| matches!(l.stem.as_str(), "q" | "theta" | "t"))
            {
                list.iter().for_each(|l| names.say_angle(&l.index, l.stem != "q"));
                return false;
            }
        }
        let angle = match angle.kind {
            ItemKind::Mark('(') if right.len() == 4 => right.get(2),
            _ if right.len() == 2 => Some(angle),
            _ => None,
        };
        let Some(angle) = angle.and_then(Letter::of) else { return false };
        let fits = matches!((short.stem.as_str(), f), ("c", "cos") | ("s", "sin")) && short.index == angle.index;
        let single = short.is_general() || short.index.parse::<usize>().is_ok();
        if !(fits && single && matches!(angle.stem.as_str(), "q" | "theta" | "t")) {
            return false;
        }
        names.say_angle(&short.index, angle.stem != "q");
        true
    }

    /// A matrix of names on the right: each is from now on that entry of the left side.
    ///
    /// In `M = [names] = B` too.
    pub(super) fn names_entries(&self, names: &mut DocumentNames<'_>) -> bool {
        if let [first, middle, _] = self.sides.as_slice()
            && let [Item { kind: ItemKind::Matrix(_), .. }] = middle.as_slice()
        {
            let mut head = self.clone();
            head.sides = vec![first.clone(), middle.clone()];
            head.relations.truncate(1);
            if head.names_entries(names) {
                return true;
            }
        }
        let Some([Item { kind: ItemKind::Matrix(rows), .. }]) = self.sides.last().map(Vec::as_slice) else {
            return self.names_entries_in_brackets(names);
        };
        let cells: Vec<Vec<&[Item]>> = rows.iter().map(|r| r.iter().map(Vec::as_slice).collect()).collect();
        self.bind_entries(&cells, names)
    }

    /// Is it a matrix of nothing but names of entries? In brackets of plain text, it stands last.
    pub(super) fn is_matrix_of_names(&self, side: &[Item], names: &DocumentNames<'_>) -> bool {
        let entry = |cell: &Vec<Item>| match cell.as_slice() {
            [only] => Letter::of(only).is_some_and(|l| names.meaning(&l).is_ok_and(|m| m.contains(" . "))),
            _ => false,
        };
        match side {
            [Item { kind: ItemKind::Matrix(rows), .. }] => rows.iter().flatten().filter(|c| entry(c)).count() >= 9,
            _ => true,
        }
    }

    /// The same for `[a, b; c, d]` of plain text.
    fn names_entries_in_brackets(&self, names: &mut DocumentNames<'_>) -> bool {
        let Some([open, inner @ .., close]) = self.sides.last().map(Vec::as_slice) else { return false };
        if !open.is('[') || !close.is(']') {
            return false;
        }
        let rows: Vec<Vec<&[Item]>> = inner.split(|i| i.is(';')).map(|r| r.split(|i| i.is(',')).collect()).collect();
        self.bind_entries(&rows, names)
    }

    fn bind_entries(&self, rows: &[Vec<&[Item]>], names: &mut DocumentNames<'_>) -> bool {
        let Some(first) = self.sides.first() else { return false };
        let letters: Vec<(usize, usize, Letter)> = rows
            .iter()
            .enumerate()
            .flat_map(|(i, r)| r.iter().enumerate().map(move |(j, c)| (i, j, *c)))
            .filter_map(|(i, j, c)| match c {
                [only] if only.sup.is_none() && only.before_sub.is_none() => Some((i, j, Letter::of(only)?)),
                _ => None,
            })
            .collect();
        let count = rows.iter().map(Vec::len).sum::<usize>();
        let jacobian = matches!(first.as_slice(), [only] if only.name() == Some("J"));
        if jacobian && letters.len() == count && letters.iter().all(|l| l.2.stem == "J") {
            return true;
        }
        let transform = rows.len() >= 3 && rows.iter().all(|r| r.len() == 4 || r.len() == 3);
        let nameable = |l: &Letter| {
            matches!(
                l.stem.as_str(),
                "r" | "p"
                    | "m"
                    | "n"
                    | "o"
                    | "a"
                    | "t"
                    | "x"
                    | "y"
                    | "z"
                    | "g"
                    | "h"
                    | "u"
                    | "v"
                    | "w"
                    | "px"
                    | "py"
                    | "pz"
            ) && !l.is_general()
                && names.meaning(l).map_or(true, |m| {
                    m.contains(" . ")
                        || l.stem == "a" && !l.index.is_empty() && l.index.chars().all(|c| "xyz".contains(c))
                })
        };
        if !transform || letters.len() < 9 || !letters.iter().all(|l| nameable(&l.2)) {
            return false;
        }
        let Ok(whole) = formula(first, names) else { return false };
        let whole = text(&whole);
        for (i, j, letter) in letters {
            let field = if j == 3 {
                format!("p{}", ["x", "y", "z"].get(i).unwrap_or(&"x"))
            } else {
                format!("r{}{}", i + 1, j + 1)
            };
            names.bind(letter, format!("{whole} . {field}"));
        }
        true
    }

    pub(super) fn define(&self, letter: &Letter, names: &mut DocumentNames<'_>, sheet: &mut Sheet) {
        let rest = Statement {
            sides: self.sides.get(1..).unwrap_or_default().to_vec(),
            relations: self.relations.get(1..).unwrap_or_default().to_vec(),
            ..self.clone()
        };
        let words = match rest.words(names) {
            Ok(words) => words,
            Err(unknown) => {
                if !self.loose || self.marked {
                    sheet.refuse(&self.raw, self.line, unknown.why);
                }
                return;
            }
        };
        let Some(first) = words.first() else { return };
        let matrix = first.iter().any(|w| matches!(w.token.text.as_str(), "T" | "A" | "inv" | "[" | "base" | "tool"))
            && !first.iter().any(|w| w.token.is("."));
        if self.loose && !matrix && is_number(first) {
            return;
        }
        if super::values::is_foreign(first, names) {
            names.aliens.insert(letter.own());
            sheet.remark(&self.raw, self.line);
            return self.release(letter, names, sheet);
        }
        declare_general(first, sheet);
        let name = names.give(letter, matrix);
        let mut line = vec![Word::new("let", self.line), Word::new(&name, self.line), Word::new("=", self.line)];
        line.extend(first.iter().cloned());
        sheet.put(line);
        self.release(letter, names, sheet);
        if words.len() > 1 {
            self.rest_claim(words, &rest.relations, names, sheet);
        }
    }

    pub(super) fn define_late(&self, unknown: Unknown, sheet: &mut Sheet) {
        if !self.loose {
            sheet.refuse(&self.raw, self.line, unknown.why);
        }
    }

    pub(super) fn is_given(
        &self,
        left: &[Word],
        right: &[Word],
        names: &mut DocumentNames<'_>,
        sheet: &mut Sheet,
    ) -> bool {
        let name = text(left);
        let value = text(right);
        let declared = names.chain.parameters.iter().any(|p| p.name == name && p.declared);
        if let Some([only]) = self.sides.first().map(Vec::as_slice)
            && let Some(letter) = Letter::of(only)
            && names.say_size(&letter, &value)
        {
            sheet.remark(&self.raw, self.line);
            return true;
        }
        let moves = names.variable(&name);
        if moves.is_none() && !declared {
            return false;
        }
        if moves == Some(true) && !(value.contains("deg") || value == "0") {
            // an angle without a unit: a value that nothing can be compared with
            sheet.remark(&self.raw, self.line);
            return true;
        }
        names.values.retain(|v| v.0 != name);
        names.values.push((name, value));
        let mut line = vec![Word::new("at", self.line)];
        for (k, (n, v)) in names.values.iter().enumerate() {
            if k > 0 {
                line.push(Word::new(",", self.line));
            }
            for w in [n.as_str(), "="].into_iter().chain(v.split(' ')) {
                line.push(Word::new(w, self.line));
            }
        }
        sheet.put(line);
        true
    }
}

fn mark(item: &Item) -> char {
    match item.kind {
        ItemKind::Mark(c) => c,
        _ => ' ',
    }
}
