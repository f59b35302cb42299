//! Points of self-motions, and which of them lie on the same one.

use super::cells::{Cells, Event};
use super::path::Path;
use crate::{Branch, FreeJoints};
use dh_kernels::{Blank, List};

/// Most points.
pub(super) const NODES: usize = 48;

/// A candidate behind a free unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<const N: usize> {
    pub(super) q: [f64; N],
    pub(super) branch: Branch,
    pub(super) path: Path,
    /// The value of the free unknown.
    pub(super) angle: f64,
    /// The cell in which that value lies; none where it is a cut.
    pub(super) cell: Option<usize>,
    /// Joints that differ at another value of the free unknown.
    pub(super) moved: FreeJoints,
}

impl<const N: usize> Blank for Node<N> {
    const BLANK: Self =
        Node { q: [0.0; N], branch: Branch::ANY, path: Path::START, angle: 0.0, cell: None, moved: FreeJoints::NONE };
}

/// The points.
pub(super) struct Sheets<const N: usize>(List<Node<N>, NODES>);

impl<const N: usize> core::ops::Deref for Sheets<N> {
    type Target = [Node<N>];

    fn deref(&self) -> &[Node<N>] {
        &self.0
    }
}

impl<const N: usize> Sheets<N> {
    pub(super) fn new() -> Self {
        Sheets(List::new())
    }

    pub(super) fn push(&mut self, node: Node<N>) {
        self.0.push(node);
    }

    /// Notes which joints another point of a known sheet has moved.
    pub(super) fn compare(&mut self, other: &Node<N>, differ: impl Fn(&[f64; N], &[f64; N]) -> FreeJoints) {
        let known = self.0.iter_mut().find(|n| n.path == other.path && n.cell == other.cell);
        if let Some(n) = known {
            n.moved = n.moved.union(differ(&n.q, &other.q));
        }
    }

    /// Whether a cell contains a point.
    pub(super) fn covers(&self, cell: usize) -> bool {
        self.iter().any(|n| n.cell == Some(cell))
    }

    /// For every point the first one of the same self-motion.
    pub(super) fn joined(&self, cells: &Cells) -> [u8; NODES] {
        let mut groups: [u8; NODES] = core::array::from_fn(|i| i as u8);
        for i in 0..self.len() {
            for j in 0..i {
                if groups[i] == groups[j] {
                    continue;
                }
                // Two points between cuts meet each other, or do not.
                let between = self[i].cell.is_some() && self[j].cell.is_some();
                if self.meet(&self[i], &self[j], cells) || !between && self.meet(&self[j], &self[i], cells) {
                    let (from, to) = (groups[i].max(groups[j]), groups[i].min(groups[j]));
                    for g in groups.iter_mut().filter(|g| **g == from) {
                        *g = to;
                    }
                }
            }
        }
        groups
    }

    /// Whether two points lie on one sheet, or on two that meet at a cut.
    fn meet(&self, a: &Node<N>, b: &Node<N>, cells: &Cells) -> bool {
        let (Some(x), y) = (a.cell, b.cell) else { return false };
        let Some(y) = y else {
            // A point on a cut: what passes through it.
            return cells.cuts.iter().any(|cut| {
                let here = (cut.angle - b.angle).abs() < 1e-6 || cells.cuts.is_empty();
                let same = match cut.event {
                    Event::Crossing => cut.is_on(&a.path) && cut.is_on(&b.path),
                    _ => {
                        cut.is_on(&a.path) && cut.is_on(&b.path) && a.path.without(cut.step) == b.path.without(cut.step)
                    }
                };
                here && same && cells.touches(x, cut.angle)
            }) || a.path == b.path && cells.touches(x, b.angle);
        };
        if a.path == b.path {
            return x == y || cells.rough || self.neighbours(x, y, cells);
        }
        if cells.rough {
            return self.differ_where_one_is_missing(a, b);
        }
        // The two roots of a step, beside a fold of it.
        x == y
            && cells.cuts.iter().any(|cut| {
                cut.event != Event::Crossing
                    && cut.is_on(&a.path)
                    && a.path.without(cut.step) == b.path.without(cut.step)
                    && cells.touches(x, cut.angle)
            })
    }

    fn neighbours(&self, x: usize, y: usize, cells: &Cells) -> bool {
        cells.cuts.iter().any(|c| c.event == Event::Fold && cells.touches(x, c.angle) && cells.touches(y, c.angle))
    }

    /// Two paths that differ in one step and are both missing at some angle: their roots met on the way there.
    fn differ_where_one_is_missing(&self, a: &Node<N>, b: &Node<N>) -> bool {
        let alike = (0..16).any(|step| a.path.without(step) == b.path.without(step));
        let here = |path: &Path, angle: f64| self.iter().any(|n| n.path == *path && n.angle == angle);
        alike && self.iter().any(|n| !here(&a.path, n.angle) && !here(&b.path, n.angle))
    }
}
