//! The checker of hand derivations: from the lines of a `prove` block or of a document to verdicts.
//!
//! **In:** a [`Chain`](crate::chain::Chain) and claims about it. **Out:** a [`Report`](check::Report) with one verdict per line, and its
//! wording.
//!
//! [`language`] says how a line is written and reads it; `prove_block` takes the lines from the macro's tokens, `document` from LaTeX,
//! Markdown or plain text (feature `documents`); [`check`](mod@check) decides; [`report`] words the verdicts, `errata` makes a page of
//! them.

pub mod check;
#[cfg(feature = "documents")]
pub mod document;
#[cfg(feature = "documents")]
pub mod errata;
pub mod language;
mod prove_block;
pub mod report;

pub use prove_block::Claims;
