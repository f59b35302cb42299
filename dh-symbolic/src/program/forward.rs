//! Programs for the pose and for every link frame.
//!
//! The pose is built from the tip towards the base (a short vector is turned by one block at a time: 4 multiplications and 2
//! additions each), two columns that way and the third as their cross product where that is cheaper. All choices are
//! tried and counted; see [`pose`].

use super::graph::{Graph, Value};
use super::links::link_by_link;
use super::vector::{V3, identity, turn_columns, unit};
use super::{Cost, Program};
use crate::algebra::Poly;
use crate::chain::Chain;
use crate::kinematics::{AngleSum, Piece, Segment};

/// Turns a vector from the frame after block `n - 1` (that is, block n's frame, or the tool's) into the base.
pub(super) fn to_base(g: &mut Graph, blocks: &[Segment], v: V3) -> V3 {
    blocks.iter().rev().fold(v, |v, b| {
        let v = g.turn_by(&b.exit, v);
        g.turn_z(&b.turn, v)
    })
}

/// Sum of the pieces of a block from the last one to piece `first`, on top of `tip`, which stands in the frame after the block's
/// whole turn. Pieces with one turn are added before they are turned.
pub(super) fn lever(g: &mut Graph, block: &Segment, first: usize, tip: V3) -> V3 {
    let mut groups: Vec<(AngleSum, V3)> = vec![(block.turn.clone(), tip)];
    for Piece { turn, v } in block.pieces[first.min(block.pieces.len())..].iter().rev() {
        let v = g.vector(v);
        match groups.iter_mut().find(|x| x.0 == *turn) {
            Some(group) => group.1 = g.plus(group.1, v),
            None => groups.push((turn.clone(), v)),
        }
    }
    let zero = [super::graph::ZERO; 3];
    let mut sum = zero;
    for (turn, v) in groups {
        if v != zero {
            let turned = g.turn_z(&turn, v);
            sum = g.plus(sum, turned);
        }
    }
    sum
}

/// Position of the tip in the frame of the first block.
fn tip(g: &mut Graph, blocks: &[Segment]) -> V3 {
    blocks.iter().rev().fold([super::graph::ZERO; 3], |tip, block| {
        let inner = g.turn_by(&block.exit, tip);
        lever(g, block, 0, inner)
    })
}

/// The blocks without the shift of the last one along its own axis, and that shift: where the axis is a column of the pose anyway, the
/// shift is that column times a length.
fn without_last_shift(blocks: &[Segment]) -> Option<(Vec<Segment>, Poly)> {
    let mut rest = blocks.to_vec();
    let last = rest.last_mut().filter(|b| b.exit.is_empty())?;
    let shift: Poly = last.pieces.iter().map(|p| p.v[2].clone()).sum();
    for piece in &mut last.pieces {
        piece.v[2] = Poly::zero();
    }
    (!shift.is_zero()).then_some((rest, shift))
}

/// Which column comes from the other two; `None`: all three are built from the tip.
pub(super) const COLUMN_CHOICES: [Option<usize>; 4] = [Some(1), Some(0), Some(2), None];

/// The three columns of the rotation from the tip, one of them as a cross product.
pub(super) fn columns_from_tip(g: &mut Graph, blocks: &[Segment], crossed: Option<usize>) -> [V3; 3] {
    let mut columns = [[super::graph::ZERO; 3]; 3];
    for k in (0..3).filter(|k| Some(*k) != crossed) {
        columns[k] = to_base(g, blocks, unit(k));
    }
    if let Some(k) = crossed {
        columns[k] = g.cross(columns[(k + 1) % 3], columns[(k + 2) % 3]);
    }
    columns
}

/// The columns after a block's turn and its constant turns, from the columns before it.
pub(super) fn columns_forward(
    g: &mut Graph,
    turn: &AngleSum,
    exit: &[crate::chain::Elementary],
    m: [V3; 3],
) -> [V3; 3] {
    let cs = g.cos_sin(&turn.0);
    let m = turn_columns(g, 2, cs, m);
    exit.iter().fold(m, |m, e| match e {
        crate::chain::Elementary::Rotate(axis, angle) => {
            let cs = g.cos_sin(angle);
            turn_columns(g, *axis, cs, m)
        }
        crate::chain::Elementary::Translate(..) => m,
    })
}

fn outputs(columns: [V3; 3], p: V3) -> Vec<Value> {
    [columns[0], columns[1], columns[2], p].concat()
}

/// The cheapest program for the pose.
pub(super) fn pose(chain: &Chain, blocks: &[Segment]) -> Program {
    let mut best: Option<(usize, Program)> = None;
    let mut offer = |graph: Graph, columns: [V3; 3], p: V3| {
        let program = Program { graph, outputs: outputs(columns, p) }.share_angle_sums();
        let weight = Cost::of(&program.graph, &program.outputs).weight();
        if best.as_ref().is_none_or(|b| weight < b.0) {
            best = Some((weight, program));
        }
    };
    let split = without_last_shift(blocks);
    for choice in 0..=COLUMN_CHOICES.len() {
        let mut g = Graph::new(chain);
        let columns = match COLUMN_CHOICES.get(choice) {
            Some(crossed) => columns_from_tip(&mut g, blocks, *crossed),
            None => blocks.iter().fold(identity(), |m, b| columns_forward(&mut g, &b.turn, &b.exit, m)),
        };
        if let Some((rest, shift)) = &split {
            let mut g = g.clone();
            let start = tip(&mut g, rest);
            let length = g.polynomial(shift);
            let along = g.times(length, columns[2]);
            let p = g.plus(start, along);
            offer(g, columns, p);
        }
        let p = tip(&mut g, blocks);
        offer(g, columns, p);
    }
    for shifts in [Shifts::Turned, Shifts::AlongColumns] {
        let mut g = Graph::new(chain);
        let walk = outwards(&mut g, blocks, shifts);
        offer(g, walk.columns, walk.tip);
    }
    let mut g = Graph::new(chain);
    let ((columns, p), _) = link_by_link(&mut g, chain);
    offer(g, columns, p);
    best.map_or_else(|| Program { graph: Graph::new(chain), outputs: Vec::new() }, |b| b.1)
}

/// Every link frame, from the base outwards.
pub(super) fn frames(chain: &Chain, blocks: &[Segment]) -> Program {
    let mut g = Graph::new(chain);
    let mut all = vec![Vec::new(); chain.links.len()];
    let walk = outwards(&mut g, blocks, Shifts::Turned);
    for (block, frame) in blocks.iter().zip(&walk.blocks) {
        for mark in &block.frames {
            let columns = columns_forward(&mut g, &mark.turn, &mark.exit, frame.columns);
            all[mark.row] = outputs(columns, frame.origins[mark.pieces]);
        }
    }
    Program { graph: g, outputs: all.concat() }.share_angle_sums()
}

/// The way from the base to the tip.
pub(super) struct Walk {
    /// Every block.
    pub(super) blocks: Vec<BlockFrame>,
    /// Columns of the tool's frame.
    pub(super) columns: [V3; 3],
    /// Its origin.
    pub(super) tip: V3,
}

/// A block on the way.
pub(super) struct BlockFrame {
    /// Columns of its frame before its turns.
    pub(super) columns: [V3; 3],
    /// Origins after 0, 1, 2, ... of its pieces.
    pub(super) origins: Vec<V3>,
}

/// How a shift inside a block gets into the base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shifts {
    /// It is turned into the block's frame first.
    Turned,
    /// The block's columns are turned, as the textbook multiplies.
    AlongColumns,
}

/// Walks from the base to the tip.
pub(super) fn outwards(g: &mut Graph, blocks: &[Segment], shifts: Shifts) -> Walk {
    let mut walk = Walk { blocks: Vec::new(), columns: identity(), tip: [super::graph::ZERO; 3] };
    for block in blocks {
        let mut origins = vec![walk.tip];
        for piece in &block.pieces {
            let v = g.vector(&piece.v);
            let (v, columns) = match shifts {
                Shifts::Turned => (g.turn_z(&piece.turn, v), walk.columns),
                Shifts::AlongColumns => (v, columns_forward(g, &piece.turn, &[], walk.columns)),
            };
            for (x, column) in v.into_iter().zip(columns) {
                let part = g.times(x, column);
                walk.tip = g.plus(walk.tip, part);
            }
            origins.push(walk.tip);
        }
        walk.blocks.push(BlockFrame { columns: walk.columns, origins });
        walk.columns = columns_forward(g, &block.turn, &block.exit, walk.columns);
    }
    walk
}
