//! The letters and signs of a document, read as pieces of formulas: indices go to the letter that carries them.

use super::layout::{Item, ItemKind};
use super::names::DocumentNames;
use super::tables::{function, relation, script};
use crate::render::formula::greek;

/// Deepest nesting of groups.
const DEPTH: usize = 40;

/// Reads formulas.
pub(super) fn items(text: &[(char, usize)], plain: bool, names: &DocumentNames<'_>) -> Vec<Item> {
    nested(text, plain, names, 0)
}

fn nested(text: &[(char, usize)], plain: bool, names: &DocumentNames<'_>, depth: usize) -> Vec<Item> {
    let mut reader = Reader { text, at: 0, plain, names, depth, braces: 0, out: Vec::new(), spaced: false };
    if depth <= DEPTH {
        reader.run(None);
    }
    reader.out
}

pub(super) struct Reader<'a> {
    pub(super) text: &'a [(char, usize)],
    pub(super) at: usize,
    plain: bool,
    names: &'a DocumentNames<'a>,
    depth: usize,
    /// Braces over several rows that are open: `\left\{ ... \right.`
    pub(super) braces: usize,
    pub(super) out: Vec<Item>,
    pub(super) spaced: bool,
}

impl Reader<'_> {
    pub(super) fn peek(&self) -> Option<char> {
        self.text.get(self.at).map(|t| t.0)
    }

    fn line(&self) -> usize {
        self.text.get(self.at).or(self.text.last()).map_or(0, |t| t.1)
    }

    pub(super) fn push(&mut self, kind: ItemKind) {
        let mut item = Item::new(kind, self.line(), std::mem::take(&mut self.spaced));
        if let Some(last) = self.out.last()
            && last.kind == ItemKind::Empty
            && item.carries()
            && let Some(empty) = self.out.pop()
        {
            item.before_sub = empty.sub;
            item.before_sup = empty.sup;
            item.spaced |= empty.spaced;
        }
        self.out.push(item);
    }

    pub(super) fn take_while(&mut self, fits: impl Fn(char) -> bool) -> String {
        let mut word = String::new();
        while let Some(c) = self.peek().filter(|c| fits(*c)) {
            word.push(c);
            self.at += 1;
        }
        word
    }

    /// Reads up to the closing brace, or to `\end` of an environment, or to the end.
    fn run(&mut self, stop: Option<char>) {
        while let Some(c) = self.peek() {
            if Some(c) == stop {
                self.at += 1;
                return;
            }
            match c {
                '\\' => {
                    if self.command(stop) {
                        return;
                    }
                }
                '\n' if self.plain => {
                    self.at += 1;
                    self.push(ItemKind::Break);
                }
                _ if c.is_whitespace() => {
                    self.spaced = true;
                    self.at += 1;
                }
                '{' if !self.plain => {
                    self.at += 1;
                    let inner = self.group('}');
                    // {\rm atan2}
                    match inner.as_slice() {
                        [only] if only.is_bare() && only.name().is_some_and(|n| function(n).is_some()) => {
                            self.push(only.kind.clone());
                        }
                        [] => self.push(ItemKind::Empty),
                        _ => self.push(ItemKind::Group(inner)),
                    }
                }
                '}' if !self.plain => self.at += 1,
                '^' | '_' => {
                    self.at += 1;
                    let index = self.argument();
                    self.index(index, c == '^');
                }
                '&' if !self.plain => {
                    self.at += 1;
                    self.push(ItemKind::Tab);
                }
                '\'' | '′' => {
                    self.at += 1;
                    if let Some(last) = self.out.last_mut() {
                        last.primes += 1;
                    }
                }
                '√' => {
                    self.at += 1;
                    let inner = self.argument();
                    self.push(ItemKind::Root(inner));
                }
                '%' => {
                    self.take_while(|c| c != '\n');
                }
                _ if script(c).is_some() => self.raised(c),
                _ if c.is_ascii_digit()
                    || c == '.' && self.text.get(self.at + 1).is_some_and(|t| t.0.is_ascii_digit()) =>
                {
                    self.number();
                }
                _ if c.is_ascii_alphabetic() && self.plain => self.word(),
                _ if c.is_ascii_alphabetic() && self.unmarked_function() => {}
                _ => {
                    self.at += 1;
                    self.sign(c);
                }
            }
        }
    }

    /// `atan2(`, `cos(`, `Atan2[` without a backslash in a marked formula.
    fn unmarked_function(&mut self) -> bool {
        let letter = |t: Option<&(char, usize)>| t.is_some_and(|t| t.0.is_ascii_alphabetic());
        let before = self.at.checked_sub(1).and_then(|k| self.text.get(k));
        if letter(before) {
            return false;
        }
        let rest: String = self.text[self.at..].iter().take(8).map(|t| t.0).collect();
        let word: String = rest.chars().take_while(char::is_ascii_alphanumeric).collect();
        let word =
            if word.ends_with('2') { word.as_str() } else { word.trim_end_matches(|c: char| c.is_ascii_digit()) };
        if word.len() < 3 || function(word).is_none() || matches!(word, "Rot" | "Trans") {
            return false;
        }
        self.at += word.len();
        self.push(ItemKind::Name(function(word).unwrap_or_default().to_string()));
        true
    }

    fn sign(&mut self, c: char) {
        let ink = match c {
            '−' | '–' | '-' => ItemKind::Mark('-'),
            '·' | '×' | '*' | '⋅' | '∙' => ItemKind::Mark('*'),
            '±' => ItemKind::PlusMinus,
            '∓' => ItemKind::MinusPlus,
            '°' => ItemKind::Degree,
            '…' | '⋯' => ItemKind::Dots,
            '【' => ItemKind::Mark('['),
            '】' => ItemKind::Mark(']'),
            '（' => ItemKind::Mark('('),
            '）' => ItemKind::Mark(')'),
            '，' | '、' => ItemKind::Mark(','),
            '；' => ItemKind::Mark(';'),
            '。' => ItemKind::Mark('.'),
            c if relation(c.encode_utf8(&mut [0; 4])).is_some() => {
                relation(c.encode_utf8(&mut [0; 4])).map_or(ItemKind::Gap, ItemKind::Relation)
            }
            c if greek::name(c).is_some() => ItemKind::Name(greek::name(c).unwrap_or_default().to_string()),
            c if c.is_ascii_alphabetic() => ItemKind::Name(c.to_string()),
            c => ItemKind::Mark(c),
        };
        self.push(ink);
        if greek::name(c).is_some() || c.is_ascii_alphabetic() {
            self.digits_below();
        }
    }

    fn number(&mut self) {
        let mut text = self.take_while(|c| c.is_ascii_digit() || c == '.');
        if let Some(head) = text.strip_suffix('.') {
            text = head.to_string();
            self.at -= 1;
        }
        if text.starts_with('.') {
            text.insert(0, '0');
        }
        let digits = text;
        if self.plain {
            let from = self.at;
            let unit = self.take_while(|c| c.is_ascii_alphabetic());
            if matches!(unit.as_str(), "mm" | "cm" | "m" | "deg" | "in") {
                self.push(ItemKind::Number(format!("{digits}{unit}")));
                return;
            }
            self.at = from;
        }
        self.push(ItemKind::Number(digits));
    }

    /// A run of letters in plain text: a word that is known, or letters side by side.
    fn word(&mut self) {
        let rest: String = self.text[self.at..].iter().map(|t| t.0).take(40).collect();
        let known = self.names.longest(&rest);
        let run = rest.chars().take_while(char::is_ascii_alphabetic).count();
        let axis =
            run == 2 && rest[1..].starts_with(['x', 'y', 'z']) && !rest[2..].starts_with(|c: char| c.is_ascii_digit());
        let length = match known {
            Some(n) => n,
            // p_x
            None if axis => {
                let line = self.line();
                self.at += 2;
                self.push(ItemKind::Name(rest[..1].to_string()));
                self.index(vec![Item::new(ItemKind::Name(rest[1..2].to_string()), line, false)], false);
                return;
            }
            None if run == 1 || rest.chars().take(run).all(|c| "abcdlpqrsxyzTJLRP".contains(c)) => 1,
            None => run,
        };
        let word: String = rest.chars().take(length).collect();
        self.at += length;
        self.push(ItemKind::Name(word));
        self.digits_below();
    }

    /// Digits right after a letter are its index: nobody writes a number after a letter for a product.
    fn digits_below(&mut self) {
        let line = self.line();
        let digits = self.take_while(|c| c.is_ascii_digit());
        if !digits.is_empty() {
            self.index(vec![Item::new(ItemKind::Number(digits), line, false)], false);
        }
    }

    /// Raised or lowered characters.
    fn raised(&mut self, first: char) {
        let up = script(first).is_some_and(|s| s.1);
        let line = self.line();
        let mut run: Vec<(char, usize)> = Vec::new();
        while let Some(c) = self.peek() {
            match script(c) {
                Some((plain, above)) if above == up => run.push((plain, line)),
                None if c == '′' && !run.is_empty() => run.push((c, line)),
                _ => break,
            }
            self.at += 1;
        }
        let inner = nested(&run, false, self.names, self.depth + 1);
        // a raised number before a letter, after room or a sign, belongs to the letter
        let ahead = up && self.peek().is_some_and(|c| c.is_ascii_alphabetic());
        let apart = self.spaced || self.out.last().is_none_or(|l| !l.carries() || l.is('(') || l.is('['));
        if ahead && apart {
            self.push(ItemKind::Empty);
        }
        self.index(inner, up);
    }

    /// Puts indices to the last piece; to nothing, where there is none that can carry them.
    fn index(&mut self, inner: Vec<Item>, up: bool) {
        if up && matches!(inner.as_slice(), [only] if only.kind == ItemKind::Degree) {
            self.push(ItemKind::Degree);
            return;
        }
        let primes = inner.iter().filter(|i| i.name() == Some("prime")).count();
        let free = |i: &Item| if up { i.sup.is_none() } else { i.sub.is_none() };
        let apart = self.spaced && self.plain;
        let fits =
            !apart && self.out.last().is_some_and(|l| l.carries() && free(l) || l.kind == ItemKind::Empty && free(l));
        if !fits {
            self.push(ItemKind::Empty);
        }
        let Some(last) = self.out.last_mut() else { return };
        if up && primes > 0 && primes == inner.len() {
            last.primes += primes;
        } else if up {
            last.sup = Some(inner);
        } else {
            last.sub = Some(inner);
        }
    }

    /// What stands in braces, as pieces of its own.
    pub(super) fn group(&mut self, close: char) -> Vec<Item> {
        self.depth += 1;
        if self.depth > DEPTH {
            self.at = self.text.len();
            return Vec::new();
        }
        let outer = std::mem::take(&mut self.out);
        self.run(Some(close));
        self.depth -= 1;
        self.spaced = false;
        std::mem::replace(&mut self.out, outer)
    }

    /// One argument: a group or a single piece.
    pub(super) fn argument(&mut self) -> Vec<Item> {
        self.depth += 1;
        if self.depth > DEPTH {
            self.at = self.text.len();
        }
        let argument = self.bare_argument();
        self.depth -= 1;
        argument
    }

    fn bare_argument(&mut self) -> Vec<Item> {
        self.take_while(char::is_whitespace);
        if self.peek() == Some('(') && self.plain {
            let mut depth = 0;
            let close = self.text[self.at..].iter().position(|t| {
                depth += i32::from(t.0 == '(') - i32::from(t.0 == ')');
                depth == 0
            });
            let end = close.map_or(self.text.len(), |k| self.at + k);
            let inner = nested(self.text.get(self.at + 1..end).unwrap_or_default(), true, self.names, self.depth + 1);
            self.at = (end + 1).min(self.text.len());
            return inner;
        }
        if self.peek() == Some('{') {
            self.at += 1;
            return self.group('}');
        }
        let line = self.line();
        let Some(c) = self.peek() else { return Vec::new() };
        if self.plain && (c.is_ascii_alphanumeric() || greek::name(c).is_some()) {
            let outer = std::mem::take(&mut self.out);
            match c {
                _ if c.is_ascii_digit() => {
                    let digits = self.take_while(|c| c.is_ascii_digit());
                    self.push(ItemKind::Number(digits));
                }
                _ if c.is_ascii_alphabetic() => {
                    let name = self.take_while(|c| c.is_ascii_alphabetic());
                    self.push(ItemKind::Name(name));
                }
                _ => {
                    self.at += 1;
                    self.sign(c);
                }
            }
            while let Some(c) = self.peek().filter(|c| script(*c).is_some_and(|s| !s.1)) {
                self.raised(c);
            }
            return std::mem::replace(&mut self.out, outer);
        }
        if c == '\\' {
            let outer = std::mem::take(&mut self.out);
            self.command(None);
            return std::mem::replace(&mut self.out, outer);
        }
        self.at += 1;
        let mut inner = Vec::new();
        if c.is_ascii_digit() {
            inner.push(Item::new(ItemKind::Number(c.to_string()), line, false));
        } else {
            let outer = std::mem::take(&mut self.out);
            self.sign(c);
            inner = std::mem::replace(&mut self.out, outer);
        }
        inner
    }
}
