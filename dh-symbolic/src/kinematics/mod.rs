//! What follows for every chain: link transforms, their products, the geometric Jacobian, all as exact formulas.
//!
//! **In:** a [`Chain`](crate::chain::Chain). **Out:** [`Kinematics`]: T(i, j) in the normal form, and the reference that generated
//! programs are proven against.
//!
//! **Never here:** how to compute fast (that is `program`), how to print.

#[cfg(feature = "documents")]
pub mod analysis;
mod forward;
mod jacobian;
mod segments;

pub use forward::Kinematics;
pub use jacobian::jacobian;
pub use segments::{Block, BlockJoint, FrameMark, Piece, Wave, blocks};
