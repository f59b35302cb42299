//! Figures: the arm with its frames, all postures of a pose, the workspace of planar arms.
//!
//! **In:** a chain with numbers, joint values. **Out:** a [`Drawing`]: lines, areas and labels in the plane, which
//! [`html::svg`](super::html::svg) and [`latex::tikz`](super::latex::tikz) print.

mod arm;
mod camera;
mod drawing;
mod posture;
#[cfg(test)]
mod tests;
mod workspace;

pub use arm::{arm, postures};
pub use drawing::{Color, Drawing, Pen, Shape};
pub(super) use drawing::{LETTER, tenths};
pub use posture::Posture;
pub use workspace::{Ring, Rings, rings, workspace};
