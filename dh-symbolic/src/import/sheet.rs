//! The text of a table: head, settings, and rows in columns.

use crate::chain::Convention;
use std::fmt::Write;

/// A table that is to be written. Cells and settings are text as the table's language has it.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    /// Lines of the doc comment.
    pub(super) docs: Vec<String>,
    /// Name of the struct.
    pub(super) name: String,
    pub(super) convention: Convention,
    /// `unit = ...`, where it is not metres.
    pub(super) unit: Option<&'static str>,
    /// Products of motions; empty for none.
    pub(super) base: String,
    pub(super) tool: String,
    /// More settings, `redundant = q3`.
    pub(super) settings: Vec<String>,
    pub(super) rows: Vec<SheetRow>,
}

/// A row.
#[derive(Clone, Debug, Default)]
pub(super) struct SheetRow {
    pub(super) alpha: String,
    pub(super) a: String,
    pub(super) d: String,
    pub(super) theta: String,
    pub(super) range: String,
    /// What the joint is called where it comes from.
    pub(super) label: String,
}

impl Sheet {
    /// The text.
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        for line in &self.docs {
            let _ = writeln!(out, "/// {}", one_line(line));
        }
        let convention = match self.convention {
            Convention::Standard => "standard",
            Convention::Modified => "modified",
        };
        let _ = writeln!(out, "pub struct {};\n\nconvention = {convention};", self.name);
        if let Some(unit) = self.unit {
            let _ = writeln!(out, "unit = {unit};");
        }
        for (name, value) in [("base", &self.base), ("tool", &self.tool)] {
            if !value.is_empty() {
                let _ = writeln!(out, "{name} = {value};");
            }
        }
        for setting in &self.settings {
            let _ = writeln!(out, "{setting};");
        }
        out.push('\n');
        let ranges = self.rows.iter().any(|r| !matches!(r.range.as_str(), "" | "-"));
        let mut lines: Vec<Vec<&str>> = vec![match self.convention {
            Convention::Modified => vec!["joint", "alpha", "a", "d", "theta"],
            Convention::Standard => vec!["joint", "theta", "d", "a", "alpha"],
        }];
        let name = |(i, row): (usize, &SheetRow)| label(&row.label).unwrap_or_else(|| (i + 1).to_string());
        let numbers: Vec<String> = self.rows.iter().enumerate().map(name).collect();
        for (row, number) in self.rows.iter().zip(&numbers) {
            lines.push(match self.convention {
                Convention::Modified => vec![number, &row.alpha, &row.a, &row.d, &row.theta],
                Convention::Standard => vec![number, &row.theta, &row.d, &row.a, &row.alpha],
            });
        }
        if ranges {
            for (i, line) in lines.iter_mut().enumerate() {
                let range = i.checked_sub(1).and_then(|i| self.rows.get(i)).map_or("range", |r| r.range.as_str());
                line.push(if range.is_empty() { "-" } else { range });
            }
        }
        let columns = lines.first().map_or(0, Vec::len);
        let width = |c: usize| lines.iter().map(|l| l[c].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        for (i, line) in lines.iter().enumerate() {
            let cells: Vec<String> = line.iter().zip(&widths).map(|(cell, w)| format!(" {cell:<w$} ")).collect();
            let _ = writeln!(out, "|{}|", cells.join("|"));
            if i == 0 {
                let rule: Vec<String> = widths.iter().map(|w| "-".repeat(w + 2)).collect();
                let _ = writeln!(out, "|{}|", rule.join("|"));
            }
        }
        out
    }
}

/// Text that ends no comment early.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>().trim().to_string()
}

/// What a row is called, as a cell: a word, or a text in quotes. `None` for no name.
fn label(name: &str) -> Option<String> {
    let name: String = one_line(name).chars().filter(|c| !matches!(c, '"' | '\\' | '|')).take(60).collect();
    let word = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !["let", "struct", "pub"].contains(&name.as_str());
    match name.as_str() {
        "" => None,
        _ if word => Some(name),
        _ => Some(format!("\"{name}\"")),
    }
}

/// A name of a type, from any text: `ur5e_robot` becomes `Ur5eRobot`.
pub(super) fn type_name(text: &str) -> String {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty());
    let capital = |word: &str| {
        let (first, rest) = word.split_at(1);
        first.to_ascii_uppercase() + rest
    };
    let name: String = words.map(capital).collect();
    match name.chars().next() {
        None => "Arm".into(),
        Some(c) if c.is_ascii_digit() => format!("Arm{name}"),
        _ if name == "Self" => "SelfArm".into(),
        _ => name.chars().take(60).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_types() {
        for (text, name) in
            [("ur5e_robot", "Ur5eRobot"), ("", "Arm"), ("3r", "Arm3r"), ("KR 6-R900", "KR6R900"), ("机械臂", "Arm")]
        {
            assert_eq!(type_name(text), name);
        }
    }
}
