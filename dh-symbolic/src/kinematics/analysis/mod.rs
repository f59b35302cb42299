//! What follows from the exact transforms about a whole arm: its singular poses and its workspace.

pub mod reach;
pub mod singular;
