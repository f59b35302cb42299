//! The equations the planner considers: which scalar (an entry, a distance, a dot product) of which pair of frames.

use super::axes::Axes;
use super::known::Knowledge;

/// Which scalar of a pair of transforms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FrameScalar {
    /// Direction cosine (row, column).
    Rotation(u8, u8),
    /// Component of the position.
    Position(u8),
    /// Component of the position of the first origin in the second frame.
    Back(u8),
    /// Squared distance of the origins.
    Distance,
    /// Component of the position across two sliding axes: the one that frame `a` stands on, and that of this link.
    Across(u8),
    /// The same for the slides of two links, where the way from the turning axis of link `a` to that of link `b - 1` is taken apart along
    /// these axes, so that neither angle occurs.
    Bridge(u8, u8),
}

/// An equation of the pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Equation {
    /// First frame.
    pub a: usize,
    /// Second frame.
    pub b: usize,
    /// Which scalar.
    pub scalar: FrameScalar,
}

/// The frames up to which, and from which on, the target is brought back over known joints for this equation.
pub(super) fn fold(axes: &Axes, knowledge: &Knowledge, e: &Equation) -> (usize, usize) {
    (knowledge.prefix(axes).min(e.a), knowledge.suffix(axes).max(e.b))
}
