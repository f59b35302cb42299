//! Writing it down: code and notes.
//!
//! **In:** chains, plans, programs. **Out:** text and tokens.
//!
//! Formulas go from the normal form to an [`expression::Expression`] in the textbook's shape ([`grouping`]), get their names
//! ([`notation`]) and become typeset [`math`] ([`typeset`](notation::Notation::typeset)), which stands in a [`document`] and
//! is printed as [`text`], [`latex`], [`markdown`], [`typst`] or [`html`]. [`figure`] draws; [`javascript`] and [`mod@page`] make the
//! interactive page.
//!
//! **Never here:** decisions about kinematics.

pub mod document;
pub mod errata;
pub mod expression;
pub mod figure;
mod format;
mod frames;
pub mod grouping;
pub mod html;
pub mod javascript;
mod language;
pub mod latex;
pub mod markdown;
pub mod math;
#[cfg(feature = "cli")]
pub mod mdbook;
mod name;
pub mod notation;
pub mod notes;
pub mod page;
pub mod plain;
pub mod plan;
mod quantities;
pub mod refusal;
pub mod rust;
mod rustdoc;
mod story;
mod style;
pub mod text;
mod typeset;
pub mod typst;
pub mod verdict;

pub use document::Document;
pub use format::Format;
pub use language::Language;
pub use notes::{Options, Part, notes};
pub use page::page;
pub use plan::plan;
pub use rustdoc::rustdoc;
pub use style::{Style, Transforms};
