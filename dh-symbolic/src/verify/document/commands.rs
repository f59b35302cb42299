//! LaTeX commands: what comes after a backslash.

use super::layout::{Item, ItemKind, rows};
use super::reader::Reader;
use super::tables::{IGNORED, LOOKS, MATRICES, SILENT, function, greek_command, relation};

impl Reader<'_> {
    /// The text of an argument.
    fn raw(&mut self) -> String {
        self.take_while(char::is_whitespace);
        if self.peek() != Some('{') {
            return String::new();
        }
        self.at += 1;
        let mut depth = 1;
        let mut out = String::new();
        while let Some(c) = self.peek() {
            self.at += 1;
            depth += match c {
                '{' => 1,
                '}' => -1,
                _ => 0,
            };
            if depth == 0 {
                break;
            }
            out.push(c);
        }
        out
    }

    /// After a backslash; true where an environment ends.
    pub(super) fn command(&mut self, stop: Option<char>) -> bool {
        self.at += 1;
        let name = self.take_while(|c| c.is_ascii_alphabetic());
        if name.is_empty() {
            let c = self.peek().unwrap_or(' ');
            self.at += 1;
            match c {
                '\\' => {
                    self.take_while(|c| c == '*');
                    self.push(ItemKind::Break);
                }
                '{' | '}' => self.push(ItemKind::Mark(c)),
                '|' => self.push(ItemKind::Mark('|')),
                _ => self.spaced = true,
            }
            return false;
        }
        // \arctan2( is the function of two arguments
        if matches!(name.as_str(), "arctan" | "atan") && self.peek() == Some('2') {
            let next: String = self.text[self.at + 1..].iter().take(6).map(|t| t.0).collect();
            if next.trim_start().starts_with(['(', '[', '{']) || next.starts_with("\\left") {
                self.at += 1;
                self.push(ItemKind::Name("atan2".into()));
                return false;
            }
        }
        if let Some(word) = greek_command(&name).or_else(|| function(&name).filter(|f| *f != "sqrt")) {
            self.push(ItemKind::Name(word.to_string()));
        } else if let Some(r) = relation(&name) {
            self.push(ItemKind::Relation(r));
        } else if IGNORED.contains(&name.as_str()) {
            self.raw();
        } else if LOOKS.contains(&name.as_str()) {
            let inner = self.argument();
            match <[Item; 1]>::try_from(inner) {
                Ok([only]) => self.push(only.kind),
                Err(more) => self.push(ItemKind::Group(more)),
            }
        } else if name == "left" && self.opens_brace() {
            self.braces += 1;
        } else if name == "right" && self.braces > 0 && self.peek() == Some('.') {
            self.at += 1;
            self.braces -= 1;
        } else if !SILENT.contains(&name.as_str()) {
            return self.other_command(&name, stop);
        } else if (name == "left" || name == "right") && self.peek() == Some('.') {
            self.at += 1;
        }
        false
    }

    /// `\{` or `.` after `\left`, with `\right.` at its end: a brace before several rows. It is taken then.
    fn opens_brace(&mut self) -> bool {
        let rest: String = self.text[self.at..].iter().take(8).map(|t| t.0).collect();
        let length = [r"\{", r"\lbrace"].iter().find(|b| rest.starts_with(**b)).map(|b| b.len());
        let Some(length) = length else { return false };
        let mut depth = 1usize;
        let mut k = self.at + length;
        while let Some(t) = self.text.get(k) {
            if t.0 == '\\' {
                let word: String = self.text[k + 1..].iter().take(6).map(|t| t.0).collect();
                // not \leftarrow and the like
                let is = |mark: &str| {
                    word.starts_with(mark) && !word[mark.len()..].starts_with(|c: char| c.is_ascii_alphabetic())
                };
                depth = if is("left") {
                    depth + 1
                } else if is("right") {
                    depth - 1
                } else {
                    depth
                };
                if depth == 0 {
                    let closes = self.text.get(k + 6).is_some_and(|t| t.0 == '.');
                    self.at += if closes { length } else { 0 };
                    return closes;
                }
                k += 1;
            }
            k += 1;
        }
        false
    }

    /// Does an equation with rows of possibilities begin here: `x = \begin{cases}`?
    fn after_equals(&self) -> bool {
        self.out
            .iter()
            .rev()
            .find(|i| i.kind != ItemKind::Tab)
            .is_some_and(|i| matches!(i.kind, ItemKind::Relation("=")))
    }

    fn other_command(&mut self, name: &str, stop: Option<char>) -> bool {
        match name {
            "frac" | "dfrac" | "tfrac" => {
                let (top, below) = (self.argument(), self.argument());
                self.push(ItemKind::Fraction(top, below));
            }
            "sqrt" => {
                let inner = self.argument();
                self.push(ItemKind::Root(inner));
            }
            "cdot" | "times" | "ast" => self.push(ItemKind::Mark('*')),
            "pm" => self.push(ItemKind::PlusMinus),
            "mp" => self.push(ItemKind::MinusPlus),
            "partial" => self.push(ItemKind::Name("partial".into())),
            "dot" => {
                let inner = self.argument();
                self.push(ItemKind::Dotted(inner));
            }
            "circ" | "degree" => self.push(ItemKind::Degree),
            "dots" | "ldots" | "cdots" | "vdots" | "ddots" => self.push(ItemKind::Dots),
            "quad" | "qquad" | "to" | "rightarrow" | "Rightarrow" | "implies" | "Leftrightarrow" | "iff" => {
                self.push(ItemKind::Gap);
            }
            "text" | "textrm" | "textit" | "textbf" | "mbox" => {
                let words = self.raw();
                self.push(match function(words.trim()) {
                    Some(f) => ItemKind::Name(f.into()),
                    None => ItemKind::Text(words.trim().to_string()),
                });
            }
            "mathrm" | "operatorname" | "texttt" | "mathop" => {
                let word = self.raw();
                let word = word.trim().trim_start_matches("\\,").replace("\\_", "_");
                self.push(match function(&word) {
                    Some(f) => ItemKind::Name(f.into()),
                    None if matches!(word.as_str(), "or" | "and" | "where" | "with") => ItemKind::Text(word),
                    None => ItemKind::Name(word),
                });
            }
            "begin" => {
                let environment = self.raw();
                let plain = environment.trim_end_matches('*');
                let rows_of_brace = self.braces > 0 && plain == "array";
                if plain == "cases" && self.after_equals() || rows_of_brace && self.after_equals() {
                    if rows_of_brace {
                        self.raw();
                    }
                    let inner = self.group('\0');
                    self.push(ItemKind::Cases(rows(inner)));
                } else if rows_of_brace {
                    self.raw();
                } else if MATRICES.contains(&plain) {
                    if plain == "array" {
                        self.raw();
                    }
                    let inner = self.group('\0');
                    if plain == "vmatrix" {
                        self.push(ItemKind::Name("det".into()));
                    }
                    self.push(ItemKind::Matrix(rows(inner)));
                }
            }
            "end" => {
                let environment = self.raw();
                let name = environment.trim_end_matches('*');
                return stop == Some('\0') && (name == "cases" || MATRICES.contains(&name));
            }
            other => self.push(ItemKind::Name(other.to_string())),
        }
        false
    }
}
