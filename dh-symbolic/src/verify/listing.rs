//! The lines of a checked derivation in the order of its text, as data and as `dh check` prints them.

use crate::verify::Claims;
use crate::verify::check::{Report, Verdict};
#[cfg(feature = "documents")]
use crate::verify::document::DocumentClaims;
use crate::verify::language::{Derivation, Place, Statement};
use crate::verify::report::line_details;
use std::fmt::{self, Write};

/// What was found about a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Finding {
    /// Nothing is claimed: a name or a value.
    Definition,
    /// It holds for all values of the variables.
    Proven,
    /// It holds where conditions are met, which the details name.
    ProvenWhere,
    /// It holds at the given values, to the printed digits.
    Agrees,
    /// It does not hold; the details give the difference or the repair.
    Wrong,
    /// It cannot be read, means nothing, or cannot be decided.
    Unclear,
}

impl Finding {
    fn of(verdict: &Verdict) -> Finding {
        match verdict {
            Verdict::Noted => Finding::Definition,
            Verdict::Proven(w) if w.is_everywhere() => Finding::Proven,
            Verdict::Proven(_) => Finding::ProvenWhere,
            Verdict::Agrees => Finding::Agrees,
            Verdict::Wrong(_) => Finding::Wrong,
            Verdict::NotUnderstood(..) => Finding::Unclear,
        }
    }

    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            Finding::Definition => "definition",
            Finding::Proven | Finding::ProvenWhere | Finding::Agrees => "proven",
            Finding::Wrong => "wrong",
            Finding::Unclear => "unclear",
        }
    }
}

/// A line of a derivation with what was found about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckedLine {
    /// Its number in the text, from 1; 0 where it stands nowhere.
    pub line: usize,
    /// What was found.
    pub finding: Finding,
    /// The line as it was understood.
    pub text: String,
    /// What is to be said about it, one line of text each: carets under what is wrong (in the columns of `text`), the difference or the
    /// repair, conditions.
    pub details: Vec<String>,
}

/// The claims of `prove` blocks, in the order of the text.
pub fn claim_lines(report: &Report, claims: &Claims) -> Vec<CheckedLine> {
    let line = |place: &Place| claims.place(place).map_or(0, crate::diagnostic::Place::line);
    lines(report, &claims.derivation, line)
}

/// The lines of a document that say something about the robot, as they were understood, in the order of the text.
#[cfg(feature = "documents")]
pub fn document_lines(report: &Report, document: &DocumentClaims) -> Vec<CheckedLine> {
    lines(report, &document.derivation, |place| document.line(place))
}

fn lines(report: &Report, d: &Derivation, number: impl Fn(&Place) -> usize) -> Vec<CheckedLine> {
    let mut out = Vec::new();
    for (line, verdict) in d.lines.iter().zip(&report.verdicts) {
        let (text, mut details) = match &line.statement {
            // a name that the reader of documents made up
            Statement::Free(..) => continue,
            // an `at` line repeats the values before it
            Statement::At(settings) => {
                let new = settings.last().map_or(line.place.clone(), |s| s.place.start..line.place.end);
                (d.text(&new), Vec::new())
            }
            _ => line_details(report, d, line, verdict),
        };
        if matches!(verdict, Verdict::Agrees) {
            details.push("for the given values, to the printed digits".into());
        }
        out.push(CheckedLine { line: number(&line.place), finding: Finding::of(verdict), text, details });
    }
    // a document may use a name before it says what it means
    out.sort_by_key(|line| line.line);
    out
}

/// What `dh check` prints: every claim with its verdict behind the number of its line in the file, then how many there are of
/// each kind.
pub fn check_text(report: &Report, claims: &Claims) -> String {
    let lines = claim_lines(report, claims);
    format!("{}{}\n", printed(&lines), Counts(&lines))
}

/// The same for a document: every line that says something about the robot, as it was understood.
#[cfg(feature = "documents")]
pub fn document_text(report: &Report, document: &DocumentClaims) -> String {
    let reading = match document.theta_is_variable {
        Some(true) => "      theta_i is read as the variable q_i: so more lines of this document hold\n",
        Some(false) => "      theta_i is read as the angle of the table, offset included\n",
        None => "",
    };
    let rows: Vec<String> = report.jacobian_rows.iter().map(ToString::to_string).collect();
    let jacobian = match report.jacobian_rows.as_slice() {
        [1, 2, 3, 4, 5, 6] => String::new(),
        _ => {
            format!("      J stands for the rows {} of the Jacobian (1 to 3 linear, 4 to 6 angular)\n", rows.join(", "))
        }
    };
    let prose = if document.prose == 1 { "line" } else { "lines" };
    let lines = document_lines(report, document);
    format!("{reading}{jacobian}{}{}; {} {prose} of prose\n", printed(&lines), Counts(&lines), document.prose)
}

fn printed(lines: &[CheckedLine]) -> String {
    let mut out = String::new();
    for line in lines {
        let number = if line.line > 0 { line.line.to_string() } else { String::new() };
        let _ = writeln!(out, "{number:>4}  {:<7} {}", line.finding.word(), line.text);
        for detail in &line.details {
            let _ = writeln!(out, "              {detail}");
        }
    }
    out
}

/// How many lines there are of each kind.
struct Counts<'a>(&'a [CheckedLine]);

impl fmt::Display for Counts<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |finding| self.0.iter().filter(|line| line.finding == finding).count();
        let all = self.0.len();
        write!(f, "{all} formula{}, {} proven", if all == 1 { "" } else { "s" }, count(Finding::Proven))?;
        for (finding, how) in [(Finding::ProvenWhere, "under a condition"), (Finding::Agrees, "for given values")] {
            match count(finding) {
                0 => {}
                n => write!(f, ", {n} proven {how}")?,
            }
        }
        write!(f, ", {} wrong, {} unclear", count(Finding::Wrong), count(Finding::Unclear))?;
        match count(Finding::Definition) {
            0 => Ok(()),
            1 => write!(f, ", 1 definition"),
            n => write!(f, ", {n} definitions"),
        }
    }
}
