//! Frames that columns of the Jacobian can be written in, exact and in the prime field.

use crate::algebra::{Element, FieldPoint, Transform};
use crate::chain::{Chain, Convention};
use crate::kinematics::Kinematics;

/// A frame of the arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stand {
    /// The base.
    Base,
    /// The frame of a row of the table, counted from 1; 0 is the frame before the first row.
    Link(usize),
    /// The tool.
    Tool,
}

impl Stand {
    /// The frame whose z is the axis of a joint, its origin a point of it.
    pub fn of_joint(chain: &Chain, joint: usize) -> Stand {
        let row = chain.joints.get(joint).map_or(0, |j| j.row);
        Stand::Link(match chain.convention {
            Convention::Modified => row + 1,
            Convention::Standard => row,
        })
    }

    /// Base, all frames, tool.
    pub(super) fn all(n: usize) -> Vec<Stand> {
        let links = (0..=n).map(Stand::Link);
        std::iter::once(Stand::Base).chain(links).chain([Stand::Tool]).collect()
    }
}

/// Frame `b` seen from frame `a`.
pub(in crate::kinematics) fn seen(k: &Kinematics, a: Stand, b: Stand) -> Transform {
    if a > b {
        return seen(k, b, a).inverse();
    }
    let n = k.len();
    let between = |i, j| k.transform(i, j).unwrap_or_else(Transform::identity);
    match (a, b) {
        (Stand::Link(i), Stand::Link(j)) => between(i, j),
        (Stand::Base, Stand::Link(j)) => k.base().times(&between(0, j)),
        (Stand::Link(i), Stand::Tool) => between(i, n).times(k.tool()),
        (Stand::Base, Stand::Tool) => k.pose(),
        _ => Transform::identity(),
    }
}

/// Three elements.
pub(super) type Triple = [Element; 3];

/// A frame in the base: columns of its rotation, and its origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) axes: [Triple; 3],
    pub(super) origin: Triple,
}

impl Frame {
    fn of(t: &Transform, at: &FieldPoint) -> Frame {
        let value = |i: usize, j: usize| at.value(&t.entry(i, j));
        Frame {
            axes: std::array::from_fn(|j| std::array::from_fn(|i| value(i, j))),
            origin: std::array::from_fn(|i| value(i, 3)),
        }
    }

    fn times(&self, other: &Frame) -> Frame {
        let turn = |v: &Triple| -> Triple {
            std::array::from_fn(|i| (0..3).fold(Element::ZERO, |sum, j| sum.plus(self.axes[j][i].times(v[j]))))
        };
        let moved = turn(&other.origin);
        Frame { axes: other.axes.each_ref().map(turn), origin: std::array::from_fn(|i| moved[i].plus(self.origin[i])) }
    }

    /// Components of a vector along the axes.
    pub(super) fn components(&self, v: &Triple) -> Triple {
        self.axes.each_ref().map(|a| dot(a, v))
    }
}

pub(super) fn dot(a: &Triple, b: &Triple) -> Element {
    (0..3).fold(Element::ZERO, |sum, i| sum.plus(a[i].times(b[i])))
}

pub(super) fn cross(a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].times(b[k]).plus(a[k].times(b[j]).negative())
    })
}

pub(super) fn minus(a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| a[i].plus(b[i].negative()))
}

/// All frames in the base, at a point: in the order of [`Stand::all`].
pub(super) fn frames(k: &Kinematics, at: &FieldPoint) -> Vec<Frame> {
    let base = Frame::of(&Transform::identity(), at);
    let mut frame = Frame::of(k.base(), at);
    let mut list = vec![base, frame];
    for i in 1..=k.len() {
        if let Some(link) = k.link(i) {
            frame = frame.times(&Frame::of(link, at));
        }
        list.push(frame);
    }
    list.push(frame.times(&Frame::of(k.tool(), at)));
    list
}
