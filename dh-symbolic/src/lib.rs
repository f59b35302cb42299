//! Compiler from Denavit-Hartenberg tables to closed-form kinematics.

pub mod algebra;
pub mod chain;
pub mod diagnostic;
mod greek;
pub mod kinematics;
pub mod planner;
pub mod program;
pub mod render;

pub mod pipeline;

pub use pipeline::expand;
