//! Formulas: from the normal form of algebra to textbook notation.
//!
//! A polynomial is grouped into an [`expression::Expression`] in the textbook's shape ([`grouping`]), gets its names ([`notation`])
//! and becomes typeset [`math`] ([`typeset`](notation::Notation::typeset)). [`text`] prints that with Unicode, [`plain`] as one
//! types it.

pub mod expression;
pub(crate) mod greek;
pub mod grouping;
pub mod math;
pub(in crate::render) mod name;
pub mod notation;
pub mod plain;
pub(crate) mod products;
pub(crate) mod quantities;
pub(crate) mod style;
pub mod text;
pub(crate) mod typeset;

pub use style::{Style, Transforms};
