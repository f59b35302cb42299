//! The planner of the inverse kinematics: chooses equations and the order in which they are solved.
//!
//! **In:** a [`Chain`](crate::chain::Chain). **Out:** a [`Plan`]: steps, each with the equations it uses, the unknown, the number of
//! branches and what happens when it degenerates; or the reasons why there is none.
//!
//! The way: the [`pool`] of all scalar equations between any two frames of the arm is sorted by the joint combinations that each
//! depends on. As long as something is unknown, `search` takes the cheapest equations with one unknown combination (or two
//! equations with two unknowns); what they give is known from then on. No arm is recognised by name.
//!
//! **Never here:** tokens; prose but for what each kind of step is called (`steps`). Reasons are data; `render` words them.

mod axes;
mod bound;
mod equation;
mod known;
mod mobility;
mod plane;
pub mod pool;
mod prismatic;
mod random;
mod refusal;
mod sample;
mod scalar;
mod search;
mod step;
mod steps;
mod structure;
mod subspace;

pub use axes::{Axes, Item, LinkTransform};
pub(crate) use axes::{generic_parameter, numeric};
pub use known::{Basis, Collected, Knowledge, Known, KnownPose};
pub use mobility::Mobility;
pub use refusal::{MOST_OPEN_JOINTS, Refusal};
pub(crate) use sample::joint_vectors;
pub use scalar::{Equation, FrameScalar};
pub use search::search;
pub use step::{Plan, Step};
pub use steps::{
    Argument, BatchedKernel, BatchedRoots, Call, Coefficient, Kernel, KernelRoots, ReachLimit, Representative, Slot,
    StepKind, Unknown, Wording, Words,
};
pub use structure::{NeighbourAxes, Neighbours, Structure};
pub use subspace::{JointCombination, combination};
