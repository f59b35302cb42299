//! Errors of the library's public interface: mistakes in a table with their places, names without values.

use crate::diagnostic::Errors;
use std::fmt;

/// Everything that is wrong with a table or a claim. `Display` draws each mistake with its line and carets below it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableError {
    mistakes: Vec<Mistake>,
    drawing: String,
}

/// One mistake in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Line, from 1; 0 where the text as a whole is meant.
    pub line: usize,
    /// Column of its first letter, from 1; 0 where the text as a whole is meant.
    pub column: usize,
    /// Letters to underline, all on that line; 0 where the text as a whole is meant.
    pub length: usize,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

impl TableError {
    pub(super) fn new(errors: &Errors, text: &str, name: &str) -> TableError {
        let mistakes = errors.in_order().into_iter().map(|e| {
            let (line, column, length) = e.place.on_first_line(text).unwrap_or_default();
            let column = if line > 0 { column + 1 } else { 0 };
            Mistake { line, column, length, message: e.message.clone(), help: e.help.clone() }
        });
        TableError { mistakes: mistakes.collect(), drawing: errors.draw(text, name) }
    }

    /// Something that must not happen, whatever the table says.
    pub(super) fn defect(what: &str) -> TableError {
        let message = format!("{what}; this is a defect of dh-symbolic");
        let drawing = format!("error: {message}\n");
        TableError { mistakes: vec![Mistake { line: 0, column: 0, length: 0, message, help: None }], drawing }
    }

    /// The mistakes in the order of the text.
    pub fn mistakes(&self) -> &[Mistake] {
        &self.mistakes
    }
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.drawing)
    }
}

impl std::error::Error for TableError {}

/// Why a formula has no number.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EvalError {
    /// Names in the formula that have no value, neither here nor in the table.
    Missing(Vec<String>),
    /// A value was given to a name that the robot does not have.
    Unknown(String),
}

impl fmt::Display for EvalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EvalError::Missing(names) => write!(f, "no value for {}", names.join(", ")),
            EvalError::Unknown(name) => write!(f, "the robot has no `{name}`"),
        }
    }
}

impl std::error::Error for EvalError {}
