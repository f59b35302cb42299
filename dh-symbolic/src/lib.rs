//! Compiler from Denavit-Hartenberg tables to closed-form kinematics.
//!
//! Folders are stages, in alphabetical order: `algebra`, `chain`, `kinematics`, `planner`, `program`, `render`, `verify`. A stage uses
//! those before it and none after.
//!
//! # Features
//!
//! - `documents` (on by default): notes, figures, the interactive page with its JavaScript, and the checker's reading of LaTeX and
//!   Markdown. The macro does without.
//! - `cli`: the `dh` command.

pub mod algebra;
pub mod chain;
pub mod diagnostic;
pub mod kinematics;
pub mod planner;
pub mod program;
pub mod render;
pub mod verify;

pub mod pipeline;

pub use pipeline::expand;
