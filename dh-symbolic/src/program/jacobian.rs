//! One program for pose and geometric Jacobian.
//!
//! The linear column of a turning joint is z x r with r the lever from the joint to the tip. In the joint's own block that is
//! (-r_y, r_x, 0), free of cost; the levers are partial sums of the position, so nothing is subtracted. What remains is to turn
//! columns and axes into the base, and there are several ways: one block at a time from the tip, along columns that are known
//! anyway, or as a multiple of an axis. The cheapest is taken column by column.

use super::forward::{COLUMN_CHOICES, Shifts, columns_forward, columns_from_tip, lever, outwards, to_base};
use super::graph::{Graph, Value, ZERO};
use super::links::link_by_link;
use super::vector::{V3, identity, unit};
use super::{Cost, Program};
use crate::chain::{Chain, Coordinate, Joint};
use crate::kinematics::Segment;

/// How the rotation and the joint axes are found.
#[derive(Clone, Copy, Debug)]
enum Way {
    /// Columns from the tip (one crossed), axes from the tip.
    Tip(Option<usize>),
    /// All frames from the base.
    Base,
    /// Axes from the tip; the columns of the last block's frame from the last two axes by a cross product, then the last turn.
    Axes,
}

/// Columns of every block's frame in the base, as far as this order of evaluation computes them.
struct Known {
    pose: [V3; 3],
    /// z of each block.
    axis: Vec<V3>,
    /// x and y of each block, where known.
    plane: Vec<Option<[V3; 2]>>,
    /// x and y of each block after its whole turn, where known.
    turned: Vec<Option<[V3; 2]>>,
}

fn known(g: &mut Graph, blocks: &[Segment], way: Way) -> Option<Known> {
    let n = blocks.len();
    match way {
        Way::Tip(crossed) => Some(Known {
            pose: columns_from_tip(g, blocks, crossed),
            axis: (0..n).map(|b| to_base(g, &blocks[..b], unit(2))).collect(),
            plane: vec![None; n],
            turned: vec![None; n],
        }),
        Way::Base => {
            let mut m = identity();
            let mut k = Known { pose: m, axis: Vec::new(), plane: Vec::new(), turned: Vec::new() };
            for b in blocks {
                k.axis.push(m[2]);
                k.plane.push(Some([m[0], m[1]]));
                let after = columns_forward(g, &b.turn, &[], m);
                k.turned.push(Some([after[0], after[1]]));
                m = columns_forward(g, &b.turn, &b.exit, m);
            }
            k.pose = m;
            Some(k)
        }
        Way::Axes => {
            if n < 2 {
                return None;
            }
            let axis: Vec<V3> = (0..n).map(|b| to_base(g, &blocks[..b], unit(2))).collect();
            // x of the last block's frame before its turn is perpendicular to both axes only if the turn between is a
            // quarter turn about x: then x = z_before x z_last up to sign, found by testing on the block's own constant turn.
            let [exit] = blocks[n - 2].exit.as_slice() else { return None };
            let crate::chain::Elementary::Rotate(0, angle) = exit else { return None };
            let quarter = angle.terms.is_empty().then(|| angle.constant.steps_of_15_degrees()).flatten()?;
            let (before, last) = (axis[n - 2], axis[n - 1]);
            // Rx(90): z_last = -y_before', so x = z_before x ... ; with z_last = -y, z_before = y_new: y_new x z_new = x.
            let (x, y) = match quarter {
                6 => (g.cross(before, last), before),
                18 => (g.cross(last, before), before.map(|v| -v)),
                _ => return None,
            };
            let after = columns_forward(g, &blocks[n - 1].turn, &[], [x, y, last]);
            let pose = columns_forward(g, &blocks[n - 1].turn, &blocks[n - 1].exit, [x, y, last]);
            let (mut plane, mut turned) = (vec![None; n], vec![None; n]);
            plane[n - 1] = Some([x, y]);
            turned[n - 1] = Some([after[0], after[1]]);
            // The frame before the last one, after its turn: x is the same, y follows from the quarter turn.
            turned[n - 2] = Some([x, if quarter == 6 { last.map(|v| -v) } else { last }]);
            Some(Known { pose, axis, plane, turned })
        }
    }
}

/// A linear column before it is brought to the base.
struct Local {
    block: usize,
    joint: usize,
    /// In the block's frame.
    v: V3,
    /// The same in the frame after the block's whole turn, where the lever was one vector there.
    turned: Option<V3>,
}

/// The ways to bring a column to the base.
fn candidates(g: &mut Graph, blocks: &[Segment], k: &Known, column: &Local) -> Vec<(Graph, V3)> {
    let (b, v) = (column.block, column.v);
    let mut all = Vec::new();
    let mut from_tip = g.clone();
    let w = to_base(&mut from_tip, &blocks[..b], v);
    all.push((from_tip, w));
    let nonzero: Vec<usize> = (0..3).filter(|i| v[*i].node != ZERO.node).collect();
    if let [i] = nonzero.as_slice() {
        // A multiple of one axis.
        let mut scaled = g.clone();
        let axis = match (*i, &k.plane[b]) {
            (2, _) => k.axis[b],
            (_, Some(plane)) => plane[*i],
            _ => to_base(&mut scaled, &blocks[..b], unit(*i)),
        };
        let w = scaled.times(v[*i], axis);
        all.push((scaled, w));
    }
    if let (Some(v), Some(plane)) = (column.turned, k.turned[b]) {
        let mut along = g.clone();
        let (x, y) = (along.times(v[0], plane[0]), along.times(v[1], plane[1]));
        let w = along.plus(x, y);
        all.push((along, w));
    }
    if let Some(plane) = k.plane[b].filter(|_| nonzero.len() > 1) {
        let mut along = g.clone();
        let mut w = [ZERO; 3];
        for (i, axis) in [plane[0], plane[1], k.axis[b]].into_iter().enumerate() {
            let part = along.times(v[i], axis);
            w = along.plus(w, part);
        }
        all.push((along, w));
    }
    all
}

/// The lever of a joint in the frame after the block's whole turn; `None` where some of its shifts are turned by less.
fn lever_after_turn(g: &mut Graph, block: &Segment, first: usize, tip: V3) -> Option<V3> {
    let pieces = block.pieces.get(first..)?;
    let along_axis = |p: &crate::kinematics::Piece| p.v[0].is_zero() && p.v[1].is_zero();
    if !pieces.iter().all(|p| p.turn == block.turn || along_axis(p)) {
        return None;
    }
    Some(pieces.iter().fold(tip, |sum, p| {
        let v = g.vector(&p.v);
        g.plus(sum, v)
    }))
}

fn build(chain: &Chain, blocks: &[Segment], way: Way) -> Option<Program> {
    let mut g = Graph::new(chain);
    let k = known(&mut g, blocks, way)?;
    let mut columns: Vec<[V3; 2]> = vec![[[ZERO; 3]; 2]; chain.dof()];
    // Tip in the frame of each block, from the last block on; columns per joint in the block's frame.
    let mut tip = [ZERO; 3];
    let mut local: Vec<Local> = Vec::new();
    for (b, block) in blocks.iter().enumerate().rev() {
        let inner = g.turn_by(&block.exit, tip);
        for joint in block.joints.iter().rev() {
            let signed = |v: Value| if joint.opposite { -v } else { v };
            if joint.revolute {
                let r = lever(&mut g, block, joint.pieces, inner);
                let turned =
                    lever_after_turn(&mut g, block, joint.pieces, inner).map(|w| [signed(-w[1]), signed(w[0]), ZERO]);
                local.push(Local { block: b, joint: joint.joint, v: [signed(-r[1]), signed(r[0]), ZERO], turned });
                columns[joint.joint][1] = k.axis[b].map(signed);
            } else {
                columns[joint.joint][0] = k.axis[b].map(signed);
            }
        }
        tip = lever(&mut g, block, 0, inner);
    }
    let mut outputs: Vec<Value> = [k.pose[0], k.pose[1], k.pose[2], tip].concat();
    outputs.extend(columns.iter().flat_map(|c| c[1]));
    for column in local {
        let mut best: Option<(usize, Graph, V3)> = None;
        for (candidate, w) in candidates(&mut g, blocks, &k, &column) {
            let mut all = outputs.clone();
            all.extend(w);
            let weight = Cost::of(&candidate, &all).weight();
            if best.as_ref().is_none_or(|x| weight < x.0) {
                best = Some((weight, candidate, w));
            }
        }
        if let Some((_, graph, w)) = best {
            g = graph;
            outputs.extend(w);
            columns[column.joint][0] = w;
        }
    }
    let mut outputs: Vec<Value> = outputs[..12].to_vec();
    outputs.extend(motor_columns(&mut g, chain, &columns));
    Some(Program { graph: g, outputs })
}

/// The textbook's way: all frames from the base, block by block or (`None`) link by link, and z x (tip - origin) for a joint that
/// turns.
fn textbook(chain: &Chain, blocks: &[Segment], shifts: Option<Shifts>) -> Program {
    let mut g = Graph::new(chain);
    let mut axes: Vec<(V3, V3)> = vec![([ZERO; 3], [ZERO; 3]); chain.dof()];
    let (pose, tip) = match shifts {
        Some(shifts) => {
            let walk = outwards(&mut g, blocks, shifts);
            for (block, frame) in blocks.iter().zip(&walk.blocks) {
                for joint in &block.joints {
                    let z = frame.columns[2].map(|v| if joint.opposite { -v } else { v });
                    // Shifts along the axis lead to another point on it, nearer to the tip.
                    let shifts = block.pieces[joint.pieces..].iter();
                    let along = shifts.take_while(|p| p.v[0].is_zero() && p.v[1].is_zero()).count();
                    axes[joint.joint] = (z, frame.origins[joint.pieces + along]);
                }
            }
            (walk.columns, walk.tip)
        }
        None => {
            let (pose, found) = link_by_link(&mut g, chain);
            axes = found;
            pose
        }
    };
    let column = |g: &mut Graph, joint: &Joint, (z, origin): (V3, V3)| match joint.coordinate {
        Coordinate::Angle(_) => {
            let r = g.minus(tip, origin);
            [g.cross(z, r), z]
        }
        Coordinate::Length(_) => [z, [ZERO; 3]],
    };
    let columns: Vec<[V3; 2]> =
        chain.joints.iter().zip(axes).map(|(joint, axis)| column(&mut g, joint, axis)).collect();
    let mut outputs: Vec<Value> = [pose[0], pose[1], pose[2], tip].concat();
    outputs.extend(motor_columns(&mut g, chain, &columns));
    Program { graph: g, outputs }
}

/// Columns per actuator: J_q = J_x * drive.
fn motor_columns(g: &mut Graph, chain: &Chain, columns: &[[V3; 2]]) -> Vec<Value> {
    if chain.is_direct() {
        return columns.iter().flat_map(|c| c.concat()).collect();
    }
    let mut all = Vec::new();
    for actuator in 0..chain.dof() {
        let mut sum = [[ZERO; 3]; 2];
        for (joint, column) in columns.iter().enumerate() {
            let k = g.polynomial(&chain.drive[joint][actuator]);
            for part in 0..2 {
                let scaled = g.times(k, column[part]);
                sum[part] = g.plus(sum[part], scaled);
            }
        }
        all.extend(sum.concat());
    }
    all
}

/// The cheapest program for pose and Jacobian.
pub(super) fn jacobian(chain: &Chain, blocks: &[Segment]) -> Program {
    let ways = COLUMN_CHOICES.into_iter().map(Way::Tip).chain([Way::Base, Way::Axes]);
    let mut best: Option<(usize, Program)> = None;
    let built = ways
        .filter_map(|way| build(chain, blocks, way))
        .chain([Some(Shifts::Turned), Some(Shifts::AlongColumns), None].map(|shifts| textbook(chain, blocks, shifts)));
    for program in built.map(Program::share_angle_sums) {
        let weight = Cost::of(&program.graph, &program.outputs).weight();
        if best.as_ref().is_none_or(|b| weight < b.0) {
            best = Some((weight, program));
        }
    }
    best.map_or_else(|| Program { graph: Graph::new(chain), outputs: Vec::new() }, |b| b.1)
}
