//! Figures: the arm with its frames, all postures of a pose, the workspace of planar arms.
//!
//! **In:** a chain with numbers, joint values. **Out:** a [`Drawing`]: lines, areas and labels in the plane, which [`svg`] and
//! [`tikz`] print.

mod arm;
mod camera;
mod drawing;
mod posture;
pub mod svg;
#[cfg(test)]
mod tests;
pub mod tikz;
mod workspace;

pub use arm::{arm, postures};
pub use drawing::{Color, Drawing, Pen, Shape};
pub use posture::Posture;
pub use workspace::{Ring, Rings, rings, workspace};
