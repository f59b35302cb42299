//! The path of a candidate through the plan: the root taken at every step, and the steps whose unknown was free and took a sampled value.

use crate::FreeJoints;
use dh_kernels::Blank;

/// Bits of a root's number.
const BITS: u32 = 2;

/// The roots and samples that led to a candidate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Path {
    /// The joints that the free unknowns move.
    pub joints: FreeJoints,
    /// The steps that were free, a bit each.
    pub free: u16,
    /// The number of each step's root.
    roots: u32,
}

impl Path {
    /// Before the first step.
    pub const START: Self = Self { joints: FreeJoints::NONE, free: 0, roots: 0 };

    /// A step was free; its unknown moves these joints.
    #[inline]
    #[must_use]
    pub fn choose(mut self, step: usize, joints: FreeJoints) -> Self {
        self.free |= 1 << (step & 15);
        self.joints = self.joints.union(joints);
        self
    }

    /// A step took one of its roots.
    #[inline]
    #[must_use]
    pub fn root(mut self, step: usize, number: usize) -> Self {
        self.roots |= (number as u32 & 3) << (BITS * (step as u32 & 15));
        self
    }

    /// Whether a step was free.
    #[inline]
    #[must_use]
    pub fn is_chosen(&self) -> bool {
        self.free != 0
    }

    /// The first step that was free.
    pub(super) fn first_free(&self) -> Option<usize> {
        (self.free != 0).then(|| self.free.trailing_zeros() as usize)
    }

    /// The same path up to a step, that step left out.
    pub(super) fn before(mut self, step: usize) -> Self {
        self.roots &= (1_u32 << (BITS * step as u32).min(31)) - 1;
        self.free &= (1_u16 << step.min(15)) - 1;
        self.joints = FreeJoints::NONE;
        self
    }

    /// The same path without the root of one step.
    pub(super) fn without(mut self, step: usize) -> Self {
        self.roots &= !(3 << (BITS * (step as u32 & 15)));
        self
    }
}

/// An equation `a cos u + b sin u = c` that a step had, behind a free unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SinCosEquation {
    /// The step.
    pub(super) step: usize,
    /// The path that led to it.
    pub(super) path: Path,
    /// a, b, c.
    pub(super) coefficients: [f64; 3],
}

impl Blank for SinCosEquation {
    const BLANK: Self = Self { step: 0, path: Path::START, coefficients: [0.0; 3] };
}

impl Blank for Path {
    const BLANK: Self = Self::START;
}
