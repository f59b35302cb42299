//! Numeric kernels that generated inverse kinematics calls: one solvable equation, or system, per file.
//!
//! What comes in: coefficients that generated code has evaluated, plain `f64` numbers and arrays. What goes out: every
//! real solution, in lists of fixed capacity, with a word about why there are none or too many. Angles are pairs
//! `[cos, sin]` on the way; they become numbers only at the end of a solution.
//!
//! Never here: heap, recursion, panics, `nalgebra`, knowledge of a particular robot.
//! These files depend on each other and on the elementary functions in `elementary.rs` alone, so that the compiler (`dh-symbolic`)
//! runs the very same kernels while it checks a plan.
//!
//! Programs use the crate `dh-robot`, which calls these kernels; they are no stable interface.
//!
//! Tolerances that several kernels share stand in [`tolerance`]; one that a single file needs stands in that file, with its reason.

#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

mod bernstein;
mod bilinear;
mod chain;
mod drive;
mod elementary;
pub mod general;
mod least_squares;
mod lengths;
mod list;
mod multistart;
mod newton;
mod newton_pair;
mod one_equation;
mod polish;
pub mod pose;
mod root_isolation;
mod roots;
mod status;
pub mod tolerance;
mod trig_poly;
mod trig_roots;
mod two_equations;
pub mod vector;

pub use bilinear::{AnglePair, solve_bilinear_choosing};
pub use chain::NumericChain;
pub use drive::Drive;
pub use general::{Budget, solve_general};
pub use least_squares::solve_many;
pub use lengths::{LengthAngle, solve_length_squared_and_angle_choosing, solve_quadratic};
pub use list::{Blank, List};
use multistart::beside;
pub use multistart::{solve_from_everywhere, solve_nearby};
pub use newton::{newton, newton_into};
pub use one_equation::{solve_half_turn, solve_sincos};
pub use polish::{Kinematics, Polished, TaskTarget, levenberg_marquardt, polish, polish_to, same_solution};
pub use pose::Pose;
pub use roots::{Angles, Outcome, Roots};
pub use status::Status;
pub use trig_poly::TrigPoly;
pub use trig_roots::solve_second_harmonic;
pub use two_equations::solve_pair;

#[cfg(test)]
mod testing;
