//! What is wrong with an imported file: one message with its line.

use std::fmt::Write;

/// A mistake in a file, or a question that the file leaves open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Line and column, from 1; `None` where no line is to blame.
    pub at: Option<(usize, usize)>,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Problem {
    /// A problem of the file as a whole.
    pub fn new(message: impl Into<String>) -> Problem {
        Problem { at: None, message: message.into(), help: None }
    }

    /// A problem at a line and column, from 1.
    pub fn at(place: (usize, usize), message: impl Into<String>) -> Problem {
        Problem { at: Some(place), message: message.into(), help: None }
    }

    /// Adds what to do about it.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Problem {
        self.help = Some(text.into());
        self
    }

    /// `arm.urdf:12:3`, or the name of the file alone.
    pub fn place(&self, file: &str) -> String {
        match self.at {
            Some((line, column)) => format!("{file}:{line}:{column}"),
            None => file.to_string(),
        }
    }

    /// The problem as a terminal shows it: message, `file:line:column`, the line with a caret. `source` is the text of the file.
    pub fn draw(&self, source: &str, file: &str) -> String {
        let mut out = format!("error: {}\n", self.message);
        let line = self.at.and_then(|(line, column)| Some((line, column, source.lines().nth(line.checked_sub(1)?)?)));
        let margin = " ".repeat(self.at.map_or(1, |(line, _)| line.to_string().len()));
        let _ = writeln!(out, "{margin}--> {}", self.place(file));
        if let Some((number, column, text)) = line {
            let indent: String =
                text.chars().take(column.saturating_sub(1)).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
            // A long line (a file without line breaks) is shown around the place only.
            let (shown, indent) = if text.chars().count() > 200 {
                let start = column.saturating_sub(40);
                (text.chars().skip(start).take(120).collect::<String>(), " ".repeat(column.saturating_sub(1 + start)))
            } else {
                (text.to_string(), indent)
            };
            let _ = writeln!(out, "{margin} |\n{number} | {shown}\n{margin} | {indent}^");
        }
        if let Some(help) = &self.help {
            let _ = writeln!(out, "help: {help}");
        }
        out
    }
}
