//! Numeric kernels that generated inverse kinematics calls: one solvable equation, or system, per file.
//!
//! What comes in: coefficients that generated code has evaluated, plain `f64` numbers and arrays. What goes out: every
//! real solution, in lists of fixed capacity, with a word about why there are none or too many. Angles are pairs
//! `[cos, sin]` on the way; they become numbers only at the end of a solution.
//!
//! Never here: heap, recursion, panics, `nalgebra`, knowledge of a particular robot.
//! These files depend on each other and on the elementary functions in `math.rs` alone, so that the compiler (`dh-symbolic`)
//! runs the very same kernels while it checks a plan.
//!
//! Programs use the crate `dh-robot`, which calls these kernels; they are no stable interface.
//!
//! All tolerances have names and stand in [`tolerance`].

#![cfg_attr(not(any(test, feature = "std")), no_std)]
#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

mod arcs;
mod bernstein;
mod bilinear;
mod chain;
mod drive;
mod found;
pub mod general;
mod lengths;
mod list;
mod many;
mod math;
mod newton2;
mod pair;
mod polish;
pub mod pose;
mod rescue;
mod sincos;
mod status;
pub mod tolerance;
mod trig_poly;
mod trig_roots;

pub use bilinear::{AnglePair, solve_bilinear, solve_bilinear_choosing};
pub use chain::Chain;
pub use drive::Drive;
pub use found::{Angles, Found, Outcome};
pub use general::solve_general;
pub use lengths::{
    LengthAngle, solve_length_and_angle, solve_length_squared_and_angle, solve_length_squared_and_angle_choosing,
    solve_quadratic, solve_two_lengths,
};
pub use list::{Blank, List};
pub use many::solve_many;
pub use pair::{solve_pair, solve_turn};
pub use polish::{Kinematics, Polished, Task, levenberg_marquardt, polish, polish_to, same_solution};
pub use pose::Pose;
pub use rescue::{add_polished, solve_from_everywhere, solve_nearby};
pub use sincos::{solve_half_turn, solve_sincos};
pub use status::Status;
pub use trig_poly::TrigPoly;
pub use trig_roots::solve_second_harmonic;

#[cfg(test)]
mod testing;
