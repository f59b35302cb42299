//! Reference frames in which the Jacobian's columns can be written, exactly and in the prime field of the identity test.

use crate::algebra::{Element, FieldPoint, Transform, dot};
use crate::chain::{Chain, Convention};
use crate::kinematics::Kinematics;

/// A frame of the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ReferenceFrame {
    /// The base.
    Base,
    /// The frame of a row of the table, counted from 1; 0 is the frame before the first row.
    Link(usize),
    /// The tool.
    Tool,
}

impl ReferenceFrame {
    /// The frame whose z is the axis of a joint, its origin a point of it.
    pub fn of_joint(chain: &Chain, joint: usize) -> ReferenceFrame {
        let row = chain.joints.get(joint).map_or(0, |j| j.row);
        ReferenceFrame::Link(match chain.convention {
            Convention::Modified => row + 1,
            Convention::Standard => row,
        })
    }

    /// Base, all frames, tool.
    pub(super) fn all(n: usize) -> Vec<ReferenceFrame> {
        let links = (0..=n).map(ReferenceFrame::Link);
        std::iter::once(ReferenceFrame::Base).chain(links).chain([ReferenceFrame::Tool]).collect()
    }
}

/// NumericFrame `b` seen from frame `a`.
pub(in crate::kinematics) fn relative_transform(k: &Kinematics, a: ReferenceFrame, b: ReferenceFrame) -> Transform {
    if a > b {
        return relative_transform(k, b, a).inverse();
    }
    let n = k.len();
    let between = |i, j| k.transform(i, j).unwrap_or_else(Transform::identity);
    match (a, b) {
        (ReferenceFrame::Link(i), ReferenceFrame::Link(j)) => between(i, j),
        (ReferenceFrame::Base, ReferenceFrame::Link(j)) => k.base().times(&between(0, j)),
        (ReferenceFrame::Link(i), ReferenceFrame::Tool) => between(i, n).times(k.tool()),
        (ReferenceFrame::Base, ReferenceFrame::Tool) => k.pose(),
        _ => Transform::identity(),
    }
}

/// Three elements.
pub(super) type Triple = [Element; 3];

/// A frame in the base: columns of its rotation, and its origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct NumericFrame {
    pub(super) axes: [Triple; 3],
    pub(super) origin: Triple,
}

impl NumericFrame {
    fn of(t: &Transform, at: &FieldPoint) -> NumericFrame {
        let value = |i: usize, j: usize| at.value(&t.entry(i, j));
        NumericFrame {
            axes: std::array::from_fn(|j| std::array::from_fn(|i| value(i, j))),
            origin: std::array::from_fn(|i| value(i, 3)),
        }
    }

    fn times(&self, other: &NumericFrame) -> NumericFrame {
        let turn = |v: &Triple| -> Triple {
            std::array::from_fn(|i| (0..3).fold(Element::ZERO, |sum, j| sum.plus(self.axes[j][i].times(v[j]))))
        };
        let moved = turn(&other.origin);
        NumericFrame {
            axes: other.axes.each_ref().map(turn),
            origin: std::array::from_fn(|i| moved[i].plus(self.origin[i])),
        }
    }

    /// Components of a vector along the axes.
    pub(super) fn components(&self, v: &Triple) -> Triple {
        self.axes.each_ref().map(|a| dot(a, v))
    }
}

/// All frames in the base, at a point: in the order of [`ReferenceFrame::all`].
pub(super) fn frames(k: &Kinematics, at: &FieldPoint) -> Vec<NumericFrame> {
    let base = NumericFrame::of(&Transform::identity(), at);
    let mut frame = NumericFrame::of(k.base(), at);
    let mut list = vec![base, frame];
    for i in 1..=k.len() {
        if let Some(link) = k.link(i) {
            frame = frame.times(&NumericFrame::of(link, at));
        }
        list.push(frame);
    }
    list.push(frame.times(&NumericFrame::of(k.tool(), at)));
    list
}
