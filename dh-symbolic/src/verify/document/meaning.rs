//! Translates a printed formula into the notation of claims: explicit products, round brackets, letters with their meaning.

use super::Word;
use super::brackets::{closing, describe, matrix_alone, separator_places, top_level};
use super::layout::{Item, ItemKind};
use super::letter::{Letter, field, index_text};
use super::names::{DocumentNames, Unknown};
use super::tables::function;
use super::transforms;

/// Deepest nesting of brackets.
const DEPTH: usize = 40;

pub(super) type Read<T> = Result<T, Unknown>;

pub(super) fn refuse<T>(why: impl Into<String>) -> Read<T> {
    Err(Unknown { why: why.into(), name: None })
}

/// A whole formula.
pub(super) fn formula(items: &[Item], names: &DocumentNames<'_>) -> Read<Vec<Word>> {
    let mut w = Translator { items, at: 0, names, depth: 0, out: Vec::new() };
    w.sum()?;
    match w.peek() {
        None => Ok(w.out),
        Some(item) => refuse(format!("{} does not belong here", describe(item))),
    }
}

pub(super) struct Translator<'a> {
    pub(super) items: &'a [Item],
    pub(super) at: usize,
    pub(super) names: &'a DocumentNames<'a>,
    depth: usize,
    out: Vec<Word>,
}

impl<'a> Translator<'a> {
    pub(super) fn peek(&self) -> Option<&'a Item> {
        self.items.get(self.at)
    }

    fn line(&self) -> usize {
        self.peek().or(self.items.last()).map_or(0, |i| i.line)
    }

    pub(super) fn put(&mut self, words: &str) {
        let line = self.line();
        self.out.extend(words.split_whitespace().map(|w| Word::new(w, line)));
    }

    fn take(&mut self, mark: char) -> bool {
        let hit = self.peek().is_some_and(|i| i.is(mark) && i.is_bare());
        self.at += usize::from(hit);
        hit
    }

    /// Another formula in the middle of this one.
    pub(super) fn inner(&mut self, items: &'a [Item]) -> Read<()> {
        if items.is_empty() {
            return refuse("something is missing here");
        }
        let depth = self.depth + 1;
        if depth > DEPTH {
            return refuse(format!("brackets nested more than {DEPTH} deep"));
        }
        let mut w = Translator { items, at: 0, names: self.names, depth, out: std::mem::take(&mut self.out) };
        let done = w.sum();
        let rest = w.peek();
        self.out = std::mem::take(&mut w.out);
        done?;
        rest.map_or(Ok(()), |item| refuse(format!("{} does not belong here", describe(item))))
    }

    /// A sign, also one of two.
    fn sign(&mut self) -> Option<&'static str> {
        let sign = match self.peek().filter(|i| i.is_bare())?.kind {
            ItemKind::Mark('+') => "+",
            ItemKind::Mark('-') => "-",
            ItemKind::PlusMinus => "±",
            ItemKind::MinusPlus => "∓",
            _ => return None,
        };
        self.at += 1;
        Some(sign)
    }

    fn sum(&mut self) -> Read<()> {
        while let Some(sign) = self.sign() {
            if sign != "+" {
                self.put(sign);
            }
        }
        self.product()?;
        while let Some(sign) = self.sign() {
            self.put(sign);
            self.product()?;
        }
        Ok(())
    }

    fn product(&mut self) -> Read<()> {
        self.factor(false)?;
        loop {
            if self.take('*') {
                self.put("*");
                self.factor(false)?;
            } else if self.take('/') {
                self.put("/");
                self.factor(true)?;
            } else if self.peek().is_some_and(starts_factor) {
                self.put("*");
                self.factor(false)?;
            } else if self.peek().is_some_and(|i| i.kind == ItemKind::Dots) {
                self.dots()?;
            } else {
                return Ok(());
            }
        }
    }

    /// `T(0,1) T(1,2) ... T(5,6)`: the transforms between those that are written.
    fn dots(&mut self) -> Read<()> {
        let frames = |words: &[Word]| match words {
            [t, open, i, _, j, close] if t.token.text == "T" && open.token.is("(") && close.token.is(")") => {
                Some((i.token.text.parse::<usize>().ok()?, j.token.text.parse::<usize>().ok()?))
            }
            _ => None,
        };
        let before = self.out.len().checked_sub(6).and_then(|k| frames(&self.out[k..]));
        self.at += 1;
        let here = self.out.len();
        self.put("*");
        self.factor(false)?;
        let after = self.out.get(here + 1..here + 7).and_then(frames);
        let (Some((_, from)), Some((to, _))) = (before, after) else {
            return refuse("`...` between other things than transforms of neighbouring frames");
        };
        if from > to {
            return refuse("`...` between transforms that do not follow each other");
        }
        if from < to {
            let line = self.line();
            let between = ["*", "T", "(", &from.to_string(), ",", &to.to_string(), ")"].map(|w| Word::new(w, line));
            self.out.splice(here..here, between);
        }
        Ok(())
    }

    pub(super) fn factor(&mut self, divisor: bool) -> Read<()> {
        let Some(item) = self.peek() else { return refuse("the formula ends too early") };
        match &item.kind {
            ItemKind::Number(n) => self.number(item, n),
            ItemKind::Name(name) => self.name(item, name),
            ItemKind::Group(inner) => {
                if let Some(only) = matrix_alone(inner) {
                    self.matrix(only)?;
                } else {
                    self.put("(");
                    self.inner(inner)?;
                    self.put(")");
                }
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Fraction(top, below) if is_partial(top) && is_partial(below) => {
                self.put("diff (");
                self.inner(top.get(1..).unwrap_or_default())?;
                self.put(",");
                self.inner(below.get(1..).unwrap_or_default())?;
                self.put(")");
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Dotted(inner) => {
                // \dot\theta_1 is the velocity of theta_1
                let mut inner = inner.clone();
                if item.sub.is_none() && matches!(inner.as_slice(), [only] if is_all_joints(only)) {
                    // \dot q: the velocities of all joints
                    let all = self.names.velocities();
                    self.put(&all);
                    self.at += 1;
                    return self.power(item.sup.as_deref());
                }
                if let [only] = inner.as_mut_slice()
                    && only.sub.is_none()
                {
                    only.sub.clone_from(&item.sub);
                }
                let words = formula(&inner, self.names)?;
                let text: Vec<String> = words.into_iter().map(|w| w.token.text).collect();
                let velocity = self.names.velocity(&text.join(" "));
                self.put(&velocity);
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Fraction(top, below) => {
                self.put(if divisor { "( (" } else { "(" });
                self.inner(top)?;
                self.put(") / (");
                self.inner(below)?;
                self.put(if divisor { ") )" } else { ")" });
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Root(inner) => {
                self.put("sqrt (");
                self.inner(inner)?;
                self.put(")");
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Matrix(rows) => {
                self.matrix(rows)?;
                self.at += 1;
                self.power(item.sup.as_deref())
            }
            ItemKind::Mark('-') => {
                self.at += 1;
                self.put("-");
                self.factor(divisor)
            }
            ItemKind::Mark('|') => self.absolute(),
            ItemKind::Mark('(' | '[' | '{') => self.bracket(),
            _ => refuse(format!("{} does not belong here", describe(item))),
        }
    }

    pub(super) fn number(&mut self, item: &'a Item, text: &str) -> Read<()> {
        let next = self.items.get(self.at + 1);
        // 0T6
        if let Some(t) = next
            && t.name() == Some("T")
            && !t.spaced
            && t.before_sup.is_none()
            && let (Ok(i), Some(sub)) = (text.parse::<usize>(), t.sub.as_deref())
            && let Some(j) = index_text(sub)
        {
            let meaning = transforms::between(&i.to_string(), &j, self.names)?;
            self.put(&meaning);
            self.at += 2;
            return self.after_transform(t.sup.as_deref());
        }
        let degrees = next.is_some_and(|i| i.kind == ItemKind::Degree);
        self.put(&if degrees { format!("{text}deg") } else { text.to_string() });
        self.at += 1 + usize::from(degrees);
        self.power(item.sup.as_deref())
    }

    fn matrix(&mut self, rows: &'a [Vec<Vec<Item>>]) -> Read<()> {
        self.put("[");
        for (i, row) in rows.iter().enumerate() {
            if i > 0 {
                self.put(";");
            }
            for (j, cell) in row.iter().enumerate() {
                if j > 0 {
                    self.put(",");
                }
                self.inner(cell)?;
            }
        }
        self.put("]");
        Ok(())
    }

    /// `|x|`, the root of a square.
    fn absolute(&mut self) -> Read<()> {
        let rest = self.items.get(self.at + 1..).unwrap_or_default();
        let Some(length) = rest.iter().position(|i| i.is('|')) else { return refuse("`|` does not belong here") };
        let inner = rest.get(..length).unwrap_or_default();
        if matches!(inner, [only] if only.name() == Some("J") || matches!(only.kind, ItemKind::Matrix(_))) {
            self.put("det (");
            self.inner(inner)?;
            self.put(")");
        } else {
            self.put("sqrt ( (");
            self.inner(inner)?;
            self.put(") ^ 2 )");
        }
        self.at += length + 2;
        self.power(rest.get(length).and_then(|i| i.sup.as_deref()))
    }

    /// From an opening bracket to its closing one.
    fn bracket(&mut self) -> Read<()> {
        let open = self.at;
        let Some(close) = closing(self.items, open) else { return refuse("a bracket is not closed") };
        let inner = self.items.get(open + 1..close).unwrap_or_default();
        let square = self.items.get(open).is_some_and(|i| i.is('['));
        let separators = top_level(inner).any(|i| i.is(';') || i.is(','));
        self.put(if square && separators { "[" } else { "(" });
        let mut start = 0;
        let marks = separator_places(inner);
        for k in marks.iter().copied().chain([inner.len()]) {
            self.inner(inner.get(start..k).unwrap_or_default())?;
            if k < inner.len() {
                if !square {
                    return refuse("a list in brackets where a formula is needed");
                }
                self.put(if inner.get(k).is_some_and(|i| i.is(';')) { ";" } else { "," });
            }
            start = k + 1;
        }
        self.put(if square && separators { "]" } else { ")" });
        self.at = close + 1;
        let sup = self.items.get(close).and_then(|i| i.sup.as_deref());
        self.power(sup)
    }

    /// `^2`, `^{-1}`, `^T`.
    pub(super) fn power(&mut self, sup: Option<&[Item]>) -> Read<()> {
        let Some(sup) = sup else { return self.field() };
        let text = index_text(sup).unwrap_or_default();
        match text.as_str() {
            "T" | "t" => self.put(". t"),
            _ if text.parse::<i32>().is_ok() => match text.strip_prefix('-') {
                Some(n) => self.put(&format!("^ - {n}")),
                None => self.put(&format!("^ {text}")),
            },
            _ => return refuse(format!("an exponent `{text}`")),
        }
        self.field()
    }

    /// `.px` after a matrix.
    fn field(&mut self) -> Read<()> {
        while self.peek().is_some_and(|i| i.is('.') && !i.spaced) {
            let Some(next) = self.items.get(self.at + 1).filter(|n| !n.spaced) else { return Ok(()) };
            let Some(letter) = Letter::of(next) else { return Ok(()) };
            self.put(&format!(". {}{}", letter.stem, letter.index));
            self.at += 2;
        }
        Ok(())
    }

    /// After a transform: its power, and the entry that is meant.
    fn after_transform(&mut self, sup: Option<&[Item]>) -> Read<()> {
        self.power(sup)?;
        if let Some(next) = self.peek()
            && next.before_sup.is_none()
            && let Some(letter) = Letter::of(next)
            && let Some(field) = field(&letter.stem, &letter.index).filter(|f| f != "p")
        {
            self.put(&format!(". {field}"));
            self.at += 1;
        }
        Ok(())
    }

    fn name(&mut self, item: &'a Item, name: &'a str) -> Read<()> {
        if let Some(f) = function(name) {
            self.at += 1;
            return self.call(item, f);
        }
        if let Some((axis, rotation)) = transforms::motion(item)
            && self.items.get(self.at + 1).is_some_and(|n| n.is('('))
        {
            return self.motion(axis, rotation);
        }
        // T(0,6)
        if matches!(name, "T" | "A" | "J") && item.is_bare() && self.items.get(self.at + 1).is_some_and(|n| n.is('(')) {
            let Some(close) = closing(self.items, self.at + 1) else { return refuse("a bracket is not closed") };
            let inner = self.items.get(self.at + 2..close).and_then(index_text);
            let Some(inner) = inner else { return refuse("expected the numbers of frames") };
            self.put(&format!("{name} ( {} )", inner.replace(',', " , ")));
            self.at = close + 1;
            return self.after_transform(self.items.get(close).and_then(|i| i.sup.as_deref()));
        }
        if let Some(found) = transforms::read(item, self.names) {
            let found = found?;
            self.put(&found.meaning);
            self.at += 1;
            let rest = found.power;
            let Some(rest) = rest else { return self.after_transform(None) };
            return match index_text(&rest).as_deref() {
                Some("-1") => {
                    self.put("^ - 1");
                    self.after_transform(None)
                }
                _ => {
                    self.put(". t");
                    self.after_transform(None)
                }
            };
        }
        // c theta_1
        if matches!(name, "c" | "s")
            && item.sub.is_none()
            && let Some(next) = self.items.get(self.at + 1)
            && let Some(letter) = Letter::of(next)
            && self.names.is_angle(&letter)
        {
            let angle = self.names.meaning(&letter)?;
            self.put(&format!("{} ( {angle} )", if name == "c" { "cos" } else { "sin" }));
            self.at += 2;
            let sup = item.sup.as_deref().or(next.sup.as_deref());
            return self.power(sup);
        }
        let Some(letter) = Letter::of(item) else { return refuse(format!("an index of `{name}` that is no index")) };
        let meaning = self.names.meaning(&letter)?;
        self.at += 1;
        // the square of a vector
        let square = item.sup.as_deref().and_then(index_text).is_some_and(|t| t == "2");
        if square && meaning.ends_with(". p") {
            self.put(&format!("norm2 ( {meaning} )"));
            return Ok(());
        }
        self.put(&meaning);
        self.power(item.sup.as_deref())
    }
}

/// Does it begin with the sign of a partial derivative, with one quantity after it?
fn is_partial(items: &[Item]) -> bool {
    items.first().is_some_and(|i| i.name() == Some("partial") && i.is_bare()) && items.len() > 1
}

/// The letter q or theta without an index: the column of all joint variables.
fn is_all_joints(item: &Item) -> bool {
    item.sub.is_none() && item.before_sup.is_none() && matches!(item.name(), Some("q" | "theta" | "Theta"))
}

/// Does a factor begin here?
fn starts_factor(item: &Item) -> bool {
    match &item.kind {
        ItemKind::Number(_) | ItemKind::Name(_) | ItemKind::Group(_) | ItemKind::Fraction(..) | ItemKind::Root(_) => {
            true
        }
        ItemKind::Matrix(_) | ItemKind::Dotted(_) => true,
        ItemKind::Mark(c) => matches!(c, '(' | '[' | '{'),
        _ => false,
    }
}
