//! Straight-line programs for forward kinematics and Jacobian, proven equal to the exact formulas.
//!
//! **In:** a [`Chain`]. **Out:** a [`Program`]: hash-consed instructions with named outputs, found by a
//! search over the ways in which the products can be associated, and proven equal to the product of link transforms.
//!
//! **Never here:** tokens, prose, robots' names.

mod angle_sums;
mod cost;
mod fold;
mod forward;
mod graph;
mod identity;
mod interpret;
mod inverse;
mod jacobian;
mod links;
mod proof;
mod vector;

pub use cost::Cost;
pub use graph::{Graph, Node, Value};
pub use identity::test_identities;
pub use interpret::Inputs;
pub(crate) use inverse::sides;
pub use inverse::{
    Batched, BatchedSolve, Choice, Distance, Indicator, Instruction, InterpretedRun, InterpretedSolution, Inverse,
    Item, Loop, Mirror, Naming, Report, Residual, Sequence, Shortfall, Solve, TOLERANCE, What, Yield,
};
pub use proof::{Disproof, prove_frames, prove_jacobian, prove_pose};

use crate::algebra::LinearAngle;
use crate::chain::{Chain, Elementary};
use crate::kinematics::{Kinematics, Segment, blocks};

/// Instructions with their outputs.
#[derive(Clone, Debug)]
pub struct Program {
    /// The instructions.
    pub graph: Graph,
    /// The outputs, in the order that the function states.
    pub outputs: Vec<Value>,
}

/// The three forward programs of a robot.
#[derive(Clone, Debug)]
pub struct Forward {
    /// Pose: x, y, z columns, then the position: 12 outputs.
    pub pose: Program,
    /// One pose per row: 12 outputs each.
    pub frames: Program,
    /// Pose (12 outputs), then per actuator 6: linear, angular.
    pub jacobian: Program,
}

impl Forward {
    /// Searches the cheapest programs and proves each against the product of link transforms: all of them by values in a prime
    /// field, and the pose by its normal form too where that has no more than some hundred terms.
    ///
    /// # Errors
    /// Where a program differs from the product: a defect of this crate, never of the table.
    pub fn derive(chain: &Chain) -> Result<Forward, Disproof> {
        let blocks = blocks(chain);
        let kinematics = Kinematics::new(chain);
        let pose = forward::pose(chain, &blocks);
        let frames = forward::frames(chain, &blocks);
        let jacobian = jacobian::jacobian(chain, &blocks);
        let forward = Forward { pose, frames, jacobian };
        test_identities(&forward, chain, &kinematics)?;
        if turns_in_a_row(&blocks) <= SHORT {
            prove_pose(&forward.pose, &kinematics)?;
        }
        Ok(forward)
    }

    /// Proves every program by normal forms, however long that takes.
    ///
    /// # Errors
    /// Where a program differs from the product.
    pub fn prove(&self, chain: &Chain) -> Result<(), Disproof> {
        let kinematics = Kinematics::new(chain);
        prove_pose(&self.pose, &kinematics)?;
        prove_frames(&self.frames, &kinematics)?;
        prove_jacobian(&self.jacobian, chain, &kinematics)
    }
}

/// Up to this many turns the normal form of a pose is short: a term has one factor of each, so there are at most 2^6 times the
/// number of lengths.
const SHORT: usize = 6;

/// Turns on the way from base to tip that double the number of terms: all but constant ones by quarter turns.
fn turns_in_a_row(blocks: &[Segment]) -> usize {
    let doubles = |angle: &LinearAngle| {
        !angle.terms.is_empty() || angle.constant.steps_of_15_degrees().is_none_or(|steps| steps % 6 != 0)
    };
    let exits = |e: &&Elementary| matches!(e, Elementary::Rotate(_, angle) if doubles(angle));
    blocks.iter().map(|b| usize::from(doubles(&b.turn.0)) + b.exit.iter().filter(exits).count()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::samples::{PUMA, UR5, chain};
    use crate::chain::tests::revolute_chain;

    fn counts(chain: &Chain) -> [(usize, usize, usize); 2] {
        let f = Forward::derive(chain).unwrap_or_else(|e| panic!("{e}"));
        f.prove(chain).unwrap_or_else(|e| panic!("{e}"));
        [&f.pose, &f.jacobian].map(|p| {
            let c = Cost::of(&p.graph, &p.outputs);
            (c.multiplications, c.additions, c.sincos)
        })
    }

    #[test]
    fn counts_of_known_arms() {
        // Without the flange: what the published hand counts are for.
        let panda = [
            (0, "0", "0.333", 0),
            (-90, "0", "0", 0),
            (90, "0", "0.316", 0),
            (90, "0.0825", "0", 0),
            (-90, "-0.0825", "0.384", 0),
            (90, "0", "0", 0),
            (90, "0.088", "0", 0),
        ];
        let got = [counts(&chain(PUMA)), counts(&chain(UR5)), counts(&revolute_chain(Convention::Modified, &panda))];
        insta::assert_debug_snapshot!(got);
    }
}
