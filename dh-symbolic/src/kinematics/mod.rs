//! Forward kinematics as exact formulas: link transforms, their products and the geometric Jacobian of a chain.
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
pub use segments::{AngleSum, BlockJoint, FrameMark, Piece, Segment, blocks};
