//! Documents: lecture notes, plans and figures of a robot, and the interactive page.
//!
//! [`notes`](mod@notes) and [`plan`] write a [`Document`] once; it is printed as [`text`], [`latex`], [`markdown`], [`typst`]
//! or [`html`]. `explanation` words the steps of the inverse, [`figure`] draws, [`mod@page`] makes the interactive page.

mod content;
mod explanation;
pub mod figure;
mod format;
mod frames;
pub mod html;
pub mod latex;
pub mod markdown;
#[cfg(feature = "cli")]
pub mod mdbook;
pub mod notes;
pub mod page;
pub mod plan;
pub mod text;
pub mod typst;

pub use content::{Block, Document, Equation, Figure, Span, Text};
pub use format::Format;
pub use notes::{Options, Part, notes};
pub use page::page;
pub use plan::{InversePlan, PlanStep};
