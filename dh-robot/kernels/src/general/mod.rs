//! The general six-axis arm, all joints turning or one of them sliding: all of its up to sixteen solutions, whatever its constants.
//!
//! ```text
//! arm         six joints, lengths over the length scale, links shortened
//! conformal   what a rigid transform does to an axis: fourteen numbers, linear in the sine and cosine of every joint
//! closure     the loop, cut at a joint: 14 equations in 5 angles; two of them eliminated linearly, 6 equations are left
//! dialytic    those six as a 12 x 12 matrix in one angle, whose determinant vanishes at solutions
//! attempt     determinant -> trigonometric polynomial of degree 8 -> roots -> null vectors -> polished joint vectors
//! solve       one attempt after another, until all roots are accounted for; neighbours of singular poses
//! pairs       arms with two parallel neighbours and two neighbours that meet: a polynomial of degree 8 or 4 without any matrix
//! budget      how much of that may be computed for one target
//! choice      which joint plays which part
//! ranking     the best choices; found once per arm
//! ```
//!
//! The method is Raghavan and Roth's (*Inverse kinematics of the general 6R manipulator and related linkages*, 1993), with half-angle
//! tangents replaced by sines and cosines throughout. That makes no angle special, and it removes the
//! extraneous factor `(1 + x^2)^4` of their determinant: the harmonics 9 to 12 vanish, and their size shows the rounding error.

mod arm;
mod attempt;
mod budget;
mod choice;
mod closure;
mod conformal;
mod determinant;
mod dialytic;
mod pairs;
mod ranking;
mod solve;
mod solve_pairs;

pub use arm::General6R;
pub use budget::Budget;
pub use choice::Choice;
pub use ranking::{Ranked, rank};
pub use solve::{Solved, solve_general};

#[cfg(test)]
mod tests;
