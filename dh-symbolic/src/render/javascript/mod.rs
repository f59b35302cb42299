//! The JavaScript backend: the same straight-line programs as the Rust backend prints, for the interactive page.
//!
//! [`script`] is a whole program: kernels written by hand ([`RUNTIME`]) and a class `Arm` with `forward`, `frames`, `jacobian` and
//! `inverse` of the one robot. Poses are the upper three rows `[R | p]` as lists; angles in radians, lengths in the table's unit.

mod arm;
mod candidates;
mod text;

pub use arm::class;
pub(in crate::render) use text::string;

use crate::chain::{Chain, Scalar};
use crate::planner::{self, StepKind};
use crate::program::{Disproof, Forward, Inverse};

/// The kernels that every arm shares.
pub const RUNTIME: [&str; 3] = [include_str!("kernels.js"), include_str!("roots.js"), include_str!("solve.js")];

/// How the page finds the joints that reach a pose.
#[derive(Clone, Debug)]
pub enum Solver {
    /// By the plan: all solutions.
    Closed(Box<Inverse>),
    /// The plan is the elimination of the general six-axis arm, which is not ported: by Newton's method from many starts.
    Numeric,
    /// There is no plan: the same.
    Unplanned,
    /// The table asks for no inverse.
    Unwanted,
}

impl Solver {
    /// The solver of an arm.
    pub fn of(chain: &Chain) -> Solver {
        if !chain.ik {
            return Solver::Unwanted;
        }
        if chain.dof() > 6 + usize::from(chain.redundant.is_some()) {
            return Solver::Unplanned;
        }
        let Ok(plan) = planner::search(chain) else { return Solver::Unplanned };
        if plan.steps.iter().any(|s| s.kind == StepKind::General) {
            return Solver::Numeric;
        }
        let inverse = Inverse::derive(chain, plan);
        if inverse.check(chain, SAMPLES).is_err() { Solver::Unplanned } else { Solver::Closed(Box::new(inverse)) }
    }
}

/// Sample poses that a plan must solve before it is printed.
const SAMPLES: usize = 6;

/// Kernels and class of a robot: a script that defines `Arm`.
///
/// # Errors
/// Where a program differs from the product of the link transforms: a defect of this crate.
pub fn script(chain: &Chain) -> Result<String, Disproof> {
    let chain = Chain { scalar: Scalar::F64, ..chain.clone() };
    let forward = Forward::derive(&chain)?;
    Ok(format!("\"use strict\";\n{}\n{}", RUNTIME.join("\n"), class(&chain, &forward, &Solver::of(&chain))))
}
