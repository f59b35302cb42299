//! The JavaScript backend: the same straight-line programs as the Rust backend prints, for the interactive page.
//!
//! [`script`] is a whole program: kernels written by hand ([`RUNTIME`]) and a class `Arm` with `forward`, `frames`, `jacobian` and
//! `inverse` of the one robot. Poses are the upper three rows `[R | p]` as lists; angles in radians, lengths in the table's unit.

mod arm;
mod candidates;
mod text;

pub use arm::class;
pub(in crate::render) use text::string;

use crate::chain::{Chain, Scalar, Settings};
use crate::planner::Refusal;
use crate::program::{Disproof, Forward, Inverse};

/// The kernels that every arm shares.
pub const RUNTIME: [&str; 3] =
    [include_str!("runtime/kernels.js"), include_str!("runtime/roots.js"), include_str!("runtime/solve.js")];

/// How the page finds the joints that reach a pose.
#[derive(Clone, Debug)]
pub enum Solver {
    /// By the plan: all solutions.
    Closed(Box<Inverse>),
    /// A kernel of the plan is not ported (that of the general six-axis arm): by Newton's method from many starts.
    Numeric,
    /// The same, because there is no plan for this reason.
    Refused(Refusal),
    /// The table asks for no inverse.
    Unwanted,
}

impl Solver {
    /// The solver of an arm.
    pub fn of(chain: &Chain) -> Solver {
        if !chain.settings.ik {
            return Solver::Unwanted;
        }
        match Inverse::of(chain) {
            Ok(inverse) if inverse.body.solves().iter().any(|s| s.call.kernel.javascript.is_none()) => Solver::Numeric,
            Ok(inverse) => Solver::Closed(Box::new(inverse)),
            Err(refusal) => Solver::Refused(refusal),
        }
    }
}

/// Kernels and class of a robot: a script that defines `Arm`.
///
/// # Errors
/// Where a program differs from the product of the link transforms: a defect of this crate.
pub fn script(chain: &Chain) -> Result<String, Disproof> {
    let chain = chain.with(Settings { scalar: Scalar::F64, ..chain.settings.clone() });
    let forward = Forward::derive(&chain)?;
    Ok(format!("\"use strict\";\n{}\n{}", RUNTIME.join("\n"), class(&chain, &forward, &Solver::of(&chain))))
}
