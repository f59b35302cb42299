//! Analysis of a whole arm from its exact transforms: singular configurations and workspace.

pub mod reach;
pub mod singular;
