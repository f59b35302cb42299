//! The plain product, link by link: the textbook's formula, for tables in which nothing else is cheaper (turns by constant angles in the
//! middle of links, mostly).

use super::graph::{Graph, ZERO};
use super::vector::{V3, identity, turn_columns};
use crate::chain::{Chain, Convention, Elementary};

/// Columns and origin of a frame.
pub(super) type LinkFrame = ([V3; 3], V3);

/// The pose of the tool, and per joint its axis and a point on it.
pub(super) fn link_by_link(g: &mut Graph, chain: &Chain) -> (LinkFrame, Vec<(V3, V3)>) {
    let mut now = step(g, (identity(), [ZERO; 3]), &chain.base);
    let mut axes = Vec::with_capacity(chain.joints.len());
    for (row, link) in chain.links.iter().enumerate() {
        let before = now;
        now = step(g, now, &chain.link_factors(row));
        if link.joint.is_some() {
            let (columns, origin) = if chain.convention == Convention::Modified { now } else { before };
            axes.push((columns[2], origin));
        }
    }
    (step(g, now, &chain.tool), axes)
}

/// A frame times the matrix of some factors.
fn step(g: &mut Graph, (m, origin): LinkFrame, factors: &[Elementary]) -> LinkFrame {
    let mut link: LinkFrame = (identity(), [ZERO; 3]);
    for factor in factors {
        match factor {
            Elementary::Translate(axis, length) => {
                let length = g.polynomial(length);
                let shift = g.times(length, link.0[*axis]);
                link.1 = g.plus(link.1, shift);
            }
            Elementary::Rotate(axis, angle) => {
                let cs = g.cos_sin(angle);
                link.0 = turn_columns(g, *axis, cs, link.0);
            }
        }
    }
    let mut apply = |v: V3| {
        v.into_iter().zip(m).fold([ZERO; 3], |sum, (x, column)| {
            let part = g.times(x, column);
            g.plus(sum, part)
        })
    };
    let (columns, shift) = (link.0.map(&mut apply), apply(link.1));
    (columns, g.plus(shift, origin))
}
