//! Arms whose Denavit-Hartenberg table is read while the program runs: the kinematics of `dh_robot!` without a compiler run.
//!
//! The table is derived and proven as the macro does it; instead of Rust code the programs become flat lists of instructions that are interpreted.
//! Kernels, the search at singular poses, verification and reasons are those of `dh-robot`, so that the answers are the same.
//!
//! ```
//! use dh_dynamic::DynamicArm;
//! use dh_robot::Arm;
//!
//! let arm = DynamicArm::parse(
//!     "pub struct Planar;
//!      convention = modified;  task = position;
//!      let l1: length = 1m;  let l2: length = 0.6m;  tool = tx(l2);
//!      | alpha | a  | d | theta |
//!      | 0     | 0  | 0 | q1    |
//!      | 0     | l1 | 0 | q2    |",
//! )?;
//! let target = arm.forward(&[0.3, 0.5]).expect("two joints");
//! let mut found = Vec::new();
//! arm.inverse(&target, &[], &mut |solution| found.push(solution.q.to_vec()));
//! assert_eq!(found.len(), 2);
//! assert!(found.iter().any(|q| (q[0] - 0.3).abs() < 1e-12 && (q[1] - 0.5).abs() < 1e-12));
//!
//! let longer = arm.with_parameters(&[("l1", 1.1)]).expect("a field");
//! assert!((longer.forward(&[0.0, 0.0]).expect("two joints").translation.x - 1.7).abs() < 1e-15);
//! # Ok::<(), dh_symbolic::TableError>(())
//! ```
//!
//! Numbers are `f64`, whatever `scalar` the table asks for.

mod actuators;
mod arm;
mod batch;
mod batched;
mod intern;
mod model;
mod plan;
mod solver;
mod straight;
mod tape;
mod target;
mod values;

pub use arm::{DynamicArm, Parameter};
pub use batch::Batch;
pub use target::Target;
