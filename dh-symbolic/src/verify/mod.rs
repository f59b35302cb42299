//! The checker of hand derivations: from the lines of a `prove` block or of a document to verdicts.
//!
//! **In:** a [`Chain`](crate::chain::Chain) and claims about it. **Out:** a [`Report`](check::Report) with one verdict per line, and its
//! wording.
//!
//! [`language`] says how a line is written and reads it; `prove_block` takes the lines from the macro's tokens, `document` from LaTeX,
//! Markdown or plain text (feature `documents`); [`check`](mod@check) decides; [`report`] words the verdicts, [`listing`] puts them in
//! the order of the text, `errata` makes a page of them.

pub mod check;
#[cfg(feature = "documents")]
pub mod document;
#[cfg(feature = "documents")]
pub mod errata;
pub mod language;
pub mod listing;
mod prove_block;
pub mod report;

pub use prove_block::Claims;

/// How often a document is read at most, if each reading shows that some letter changes its meaning.
#[cfg(feature = "documents")]
const READINGS: usize = 8;

/// Reads a document and checks what it says.
///
/// Where the angle of a row is `q2 - 90deg`, documents mean by theta_2 either that angle or the variable q2. What the document itself makes
/// true decides: the reading under which fewer of its lines are wrong, the table's angle if both are as good.
#[cfg(feature = "documents")]
pub fn judge(chain: &crate::chain::Chain, text: &str) -> (document::DocumentClaims, check::Report) {
    let judged = |variable| {
        let mut learnt = document::Learnt::default();
        for _ in 1..READINGS {
            let (paper, differs) = document::DocumentClaims::read_as(chain, text, variable, &learnt);
            let mut report = check::check(chain, &paper.derivation);
            if !paper.learn(&report, &mut learnt) {
                paper.forgive(&mut report);
                return (paper, report, differs);
            }
        }
        let (paper, differs) = document::DocumentClaims::read_as(chain, text, variable, &learnt);
        let mut report = check::check(chain, &paper.derivation);
        paper.forgive(&mut report);
        (paper, report, differs)
    };
    let (mut paper, mut report, differs) = judged(false);
    if differs {
        let (other, found, _) = judged(true);
        let is_variable = found.wrong() < report.wrong();
        if is_variable {
            (paper, report) = (other, found);
        }
        paper.theta_is_variable = Some(is_variable);
    }
    (paper, report)
}
