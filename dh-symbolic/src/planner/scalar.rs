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
    /// Component of the position across two prismatic axes: that of frame `a`, and that of this link.
    Across(u8),
    /// The same for the prismatic joints of two links, where the displacement from the revolute axis of link `a` to that of link `b - 1` is decomposed along
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
