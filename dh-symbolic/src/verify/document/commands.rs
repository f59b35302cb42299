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
        } else if !SILENT.contains(&name.as_str()) {
            return self.other_command(&name, stop);
        } else if (name == "left" || name == "right") && self.peek() == Some('.') {
            self.at += 1;
        }
        false
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
            "pm" | "mp" => self.push(ItemKind::PlusMinus),
            "circ" | "degree" => self.push(ItemKind::Degree),
            "dots" | "ldots" | "cdots" | "vdots" | "ddots" => self.push(ItemKind::Dots),
            "quad" | "qquad" | "to" | "rightarrow" | "Rightarrow" | "implies" | "Leftrightarrow" | "iff" => {
                self.push(ItemKind::Gap);
            }
            "text" | "textrm" | "textit" | "textbf" | "mbox" => {
                let words = self.raw();
                self.push(ItemKind::Text(words.trim().to_string()));
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
                if MATRICES.contains(&plain) {
                    if plain == "array" {
                        self.raw();
                    }
                    let inner = self.group('\0');
                    self.push(ItemKind::Matrix(rows(inner)));
                }
            }
            "end" => {
                let environment = self.raw();
                return stop == Some('\0') && MATRICES.contains(&environment.trim_end_matches('*'));
            }
            other => self.push(ItemKind::Name(other.to_string())),
        }
        false
    }
}
