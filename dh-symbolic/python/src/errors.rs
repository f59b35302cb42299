//! Errors as Python's exceptions: mistakes of a table with their drawing, targets without a solution with the reason.

use dh_robot::Why;
use dh_symbolic::import::Problem;
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

create_exception!(
    dhkin,
    TableError,
    PyValueError,
    "Everything that is wrong with a table or a claim, drawn with its lines.\n\n\
     `mistakes` is a list of tuples (line, column, message, help); line and column count from 1, and are 0 where the text as a whole is meant."
);
create_exception!(dhkin, Unreachable, PyValueError, "No joint values reach a target; the message says why.");

/// A mistake as Python gets it: line, column, message, help.
type Mistake = (usize, usize, String, Option<String>);

fn raise(py: Python<'_>, drawing: String, mistakes: Vec<Mistake>) -> PyErr {
    let raised = TableError::new_err(drawing);
    match raised.value(py).setattr("mistakes", mistakes) {
        Ok(()) => raised,
        Err(other) => other,
    }
}

/// Mistakes of a table, or of lines of a derivation.
pub(crate) fn table(py: Python<'_>, error: &dh_symbolic::TableError) -> PyErr {
    let mistakes = error.mistakes().iter().map(|m| (m.line, m.column, m.message.clone(), m.help.clone()));
    raise(py, error.to_string(), mistakes.collect())
}

/// What is wrong with a file that a table is made of.
pub(crate) fn imported(py: Python<'_>, problem: &Problem, text: &str, file: &str) -> PyErr {
    let (line, column) = problem.at.unwrap_or_default();
    raise(py, problem.draw(text, file), vec![(line, column, problem.message.clone(), problem.help.clone())])
}

/// A target without a solution.
pub(crate) fn unreachable(why: &Why) -> PyErr {
    Unreachable::new_err(why.to_string())
}
