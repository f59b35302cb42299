//! Formulas of the chapter as they are typed in its source: `r = (k_1 @c2 + k_2 @s2)2a + k_3`, read into typeset mathematics.
//!
//! Letters, digits, `+ - = ,`, brackets, `_x`, `^{..}`, `\theta`, `\cos`, `\atan2`, `\frac{..}{..}`, `\sqrt{..}`, `\mat{a & b; c & d}`;
//! `@name` asks for a name of the arm (its second joint angle may be called q2), `#0` is a formula that is handed over.

use crate::render::formula::greek;
use crate::render::formula::math::{Math, Sign};

/// Reads a formula; what cannot be read stands there as a word, so that a slip is seen (and found by the tests).
pub(super) fn formula(text: &str, name: &dyn Fn(&str) -> Option<Math>, pieces: &[Math]) -> Math {
    let mut reader = Reader { rest: text, name, pieces };
    reader.row(&[])
}

struct Reader<'a> {
    rest: &'a str,
    name: &'a dyn Fn(&str) -> Option<Math>,
    pieces: &'a [Math],
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn next(&mut self) -> Option<char> {
        let c = self.peek()?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    fn take_while(&mut self, fits: impl Fn(char) -> bool) -> String {
        let end = self.rest.find(|c| !fits(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word.to_string()
    }

    /// Pieces up to the end or one of these characters, which is left.
    fn row(&mut self, ends: &[char]) -> Math {
        let mut list: Vec<Math> = Vec::new();
        while let Some(c) = self.peek().filter(|c| !ends.contains(c)) {
            match c {
                ' ' => {
                    self.next();
                }
                '_' | '^' => {
                    self.next();
                    let index = self.index();
                    let base = list.pop().unwrap_or(Math::Row(vec![]));
                    list.push(if c == '_' { base.below(index) } else { base.above(index) });
                }
                '-' => {
                    self.next();
                    let first = match list.last() {
                        None | Some(Math::Open(_)) => true,
                        Some(Math::Sign(s)) => {
                            matches!(s, Sign::Equals | Sign::Comma | Sign::Wide | Sign::Thin | Sign::AtMost)
                        }
                        _ => false,
                    };
                    list.push(Math::Sign(if first { Sign::Negative } else { Sign::Minus }));
                }
                _ => list.push(self.piece(c)),
            }
        }
        if list.len() == 1 { list.remove(0) } else { Math::Row(list) }
    }

    fn index(&mut self) -> Math {
        match self.peek() {
            Some('{') => self.group(),
            Some(c) => self.piece(c),
            None => Math::Row(vec![]),
        }
    }

    fn group(&mut self) -> Math {
        self.next();
        let inner = self.row(&['}']);
        self.next();
        inner
    }

    fn piece(&mut self, c: char) -> Math {
        match c {
            '{' => return self.group(),
            '0'..='9' => return Math::Number(self.take_while(|c| c.is_ascii_digit() || c == '.')),
            '\\' => {
                self.next();
                return self.command();
            }
            '@' => {
                self.next();
                let word = self.take_while(|c| c.is_ascii_alphanumeric());
                return (self.name)(&word).unwrap_or_else(|| Math::word(&format!("@{word}")));
            }
            '#' => {
                self.next();
                let digit = self.take_while(|c| c.is_ascii_digit());
                let piece = digit.parse::<usize>().ok().and_then(|i| self.pieces.get(i)).cloned();
                return piece.unwrap_or_else(|| Math::word(&format!("#{digit}")));
            }
            _ => {}
        }
        self.next();
        match c {
            '+' => Math::Sign(Sign::Plus),
            '=' => Math::Sign(Sign::Equals),
            ',' => Math::Sign(Sign::Comma),
            '\'' => Math::Sign(Sign::Prime),
            '(' | '[' => Math::Open(c),
            ')' | ']' => Math::Close(c),
            c => Math::Letter(c),
        }
    }

    fn command(&mut self) -> Math {
        let word = self.take_while(|c| c.is_ascii_alphabetic());
        match word.as_str() {
            "cos" | "sin" | "tan" | "det" => {
                let name = Math::word(&word);
                // an argument without brackets
                if self.peek() == Some('(') { name } else { Math::Row(vec![name, Math::Sign(Sign::Apply)]) }
            }
            "atan" => {
                self.next();
                Math::word("atan2")
            }
            "frac" => {
                let (above, below) = (self.index(), self.index());
                Math::Fraction(Box::new(above), Box::new(below))
            }
            "sqrt" => Math::Root(Box::new(self.index())),
            "pm" => Math::Sign(Sign::PlusMinus),
            "either" => Math::Sign(Sign::Either),
            "le" => Math::Sign(Sign::AtMost),
            "to" => Math::Sign(Sign::Arrow),
            "wide" => Math::Sign(Sign::Wide),
            "thin" => Math::Sign(Sign::Thin),
            "deg" => Math::Sign(Sign::Degree),
            "dots" => Math::Sign(Sign::Dots),
            "mat" => {
                self.next();
                let mut rows = vec![Vec::new()];
                loop {
                    let cell = self.row(&['&', ';', '}']);
                    if let Some(row) = rows.last_mut() {
                        row.push(cell);
                    }
                    match self.next() {
                        Some('&') => {}
                        Some(';') => rows.push(Vec::new()),
                        _ => return Math::Matrix(rows),
                    }
                }
            }
            other => match greek::letter(other) {
                Some(c) => Math::Letter(c),
                None => Math::word(other),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::formula::text::math;

    #[test]
    fn what_is_typed_is_typeset() {
        let name = |word: &str| (word == "c2").then(|| Math::Letter('c').below(Math::number(2)));
        let show = |text: &str| math(&formula(text, &name, &[Math::Letter('x')]));
        assert_eq!(show("r = (k_1 @c2 + k_2)2#0 - k_3^2"), "r = (k₁c₂ + k₂)2x − k₃²");
        assert_eq!(show("u = \\tan\\frac{\\theta_3}{2}"), "u = tan (θ₃/2)");
        assert_eq!(show("-a + (-b)"), "−a + (−b)");
        assert_eq!(show("\\atan2(y,x) \\pm \\sqrt{1 - c^2}"), "atan2(y, x) ± √(1 − c²)");
    }
}
