//! Output: formulas, code and documents.
//!
//! **In:** chains, plans, programs. **Out:** text and tokens.
//!
//! [`formula`] turns algebra into typeset formulas; [`code`] prints programs as Rust and JavaScript; [`document`] writes lecture notes,
//! figures and the interactive page (feature `documents`). Code may use formulas, documents may use both.
//!
//! **Never here:** decisions about kinematics.

pub mod code;
#[cfg(feature = "documents")]
pub mod document;
pub mod formula;
mod language;
pub mod refusal;

pub use code::rustdoc;
#[cfg(feature = "documents")]
pub use document::{Document, Format, InversePlan, Options, Part, notes, page};
pub use formula::{Style, Transforms};
pub use language::Language;
