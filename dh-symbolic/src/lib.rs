//! Compiler from Denavit-Hartenberg tables to closed-form kinematics, as a library: exact symbolic transforms and Jacobians, plans of
//! the inverse, lecture notes, checked derivations, code.
//!
//! The macro `dh_robot!` of the crate `dh-robot` and the command `dh` are made of it. On its own it serves whoever wants formulas, not
//! code: begin with [`Robot`].
//!
//! ```
//! use dh_symbolic::{NotesOptions, Robot};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # macro_rules! include_str { ($file:literal) => { std::include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")) } }
//! let puma = Robot::parse(include_str!("puma560.dh"))?;       // or all errors, each with line, column and help
//!
//! let t = puma.transform(0, 6);                                // exact
//! println!("{t}");                                             // drawn, grouped as in a textbook
//! let px = t.entry(0, 3);
//! assert_eq!(px.to_string(), "c₁(a₂c₂ + a₃c₂₃ − d₄s₂₃) − d₃s₁");
//! assert_eq!(px.latex(), r"c_1(a_2c_2 + a_3c_{23} - d_4s_{23}) - d_3s_1");
//! assert_eq!(px.diff("q1"), -t.entry(1, 3));                   // equality is decided, not estimated
//!
//! let elbow = puma.transform(1, 3).eval(&[("q2", 0.3), ("q3", 0.5), ("a2", 0.5)])?;
//! assert!((elbow[0][3] - 0.5 * 0.3_f64.cos()).abs() < 1e-15);
//!
//! puma.check("T(1,3).px = a2*c2")?;                            // a line of a hand derivation, proven
//! assert_eq!(puma.plan()?.max_solutions(), 8);                 // how the arm is inverted
//! println!("{}", puma.notes(&NotesOptions::default()));        // a lecture note
//! # Ok(())
//! # }
//! ```
//!
//! The table is described in the documentation of `dh-robot`. All lengths are in the table's unit, all angles in radians.
//!
//! What this page lists is the API. Hidden modules are public for the workspace's own tests and generated examples; they change without
//! notice.
//!
//! # Features
//!
//! - `documents`: [`Robot`] and all that it writes. The macro does without.
//! - `import`: tables from other descriptions of arms, [`import`].
//! - `cli` (on by default): the `dh` command, `Robot::expand`; with `documents`. A library that needs neither takes
//!   `default-features = false, features = ["documents"]`.
//!
//! # Inside
//!
//! Folders are stages, in alphabetical order: `algebra`, `chain`, `kinematics`, `planner`, `program`, `render`, `verify`. A stage uses
//! those before it and none after. `robot` is the door to all of them.

#[doc(hidden)]
pub mod algebra;
#[doc(hidden)]
pub mod chain;
#[doc(hidden)]
pub mod diagnostic;
#[cfg(feature = "import")]
pub mod import;
#[doc(hidden)]
pub mod kinematics;
#[doc(hidden)]
pub mod planner;
#[doc(hidden)]
pub mod program;
#[doc(hidden)]
pub mod render;
#[cfg(feature = "documents")]
mod robot;
#[doc(hidden)]
pub mod verify;

#[doc(hidden)]
pub mod pipeline;

#[doc(hidden)]
pub use pipeline::expand;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub use render::document::mdbook;
#[cfg(feature = "documents")]
pub use render::document::{Document, Format, InversePlan, Options as NotesOptions, Part, PlanStep};
#[cfg(feature = "documents")]
pub use render::{Language, Style, Transforms};
#[cfg(feature = "documents")]
pub use robot::{
    Checked, CheckedLine, Comparison, EvalError, ExportOptions, Finding, Formula, Matrix, Mistake, Robot, TableError,
};
