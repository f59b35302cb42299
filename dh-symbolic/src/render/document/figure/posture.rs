//! The positions of an arm's frames, links and joints at given joint values, for drawing.

use super::camera::{V3, distance, dot, plus};
use crate::algebra::{Point, Transform};
use crate::chain::{Chain, Convention, Coordinate, Handle, Role};
use crate::kinematics::Kinematics;
use dh_kernels::pose::{Pose, compose};

/// The frames of an arm at some joint values.
#[derive(Clone, Debug)]
pub struct Posture {
    /// The frame before the first row, then that of every row.
    pub frames: Vec<Pose>,
    /// The tool's frame.
    pub tip: Pose,
    modified: bool,
    /// Of every row: its joint, and whether that slides.
    joints: Vec<Option<(usize, bool)>>,
}

/// What a bar stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BarPart {
    /// From the floor to the first frame.
    Base,
    /// Length of the link in this row.
    Length(usize),
    /// Offset along the axis in this row.
    Offset(usize),
    /// From the last frame to the tool.
    Tool,
}

/// A straight piece of an arm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bar {
    pub(super) ends: [V3; 2],
    pub(super) part: BarPart,
    /// Does it get longer as a joint slides?
    pub(super) prismatic: bool,
}

/// A joint in space.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    pub(super) joint: usize,
    pub(super) prismatic: bool,
    pub(super) at: V3,
    pub(super) along: V3,
}

pub(super) fn origin(t: &Pose) -> V3 {
    column(t, 3)
}

pub(super) fn column(t: &Pose, j: usize) -> V3 {
    std::array::from_fn(|i| t[i][j])
}

impl Posture {
    /// The arm at joint coordinates `x` (the angles and lengths of the moving cells). Fields without a value are 1, or 30 degrees.
    pub fn at(chain: &Chain, kinematics: &Kinematics, x: &[f64]) -> Posture {
        let place = |c: Coordinate| chain.joints.iter().position(|j| j.coordinate == c).and_then(|k| x.get(k)).copied();
        let known = |handle: Handle| {
            let open = chain.parameters.iter().any(|p| p.handle == handle && p.role == Role::Field(None));
            match handle {
                Handle::Length(_) if open => 1.0,
                Handle::Angle(_) if open => std::f64::consts::FRAC_PI_6,
                _ => chain.nominal(handle),
            }
        };
        let point = Point {
            symbol: &|s| place(Coordinate::Length(s)).unwrap_or_else(|| known(Handle::Length(s))),
            angle: &|v| place(Coordinate::Angle(v)).unwrap_or_else(|| known(Handle::Angle(v))),
        };
        let number = |t: &Transform| -> Pose {
            std::array::from_fn(|i| std::array::from_fn(|j| t.entry(i, j).evaluate(&point)))
        };
        let mut frames = vec![number(kinematics.base())];
        for link in (1..=kinematics.len()).filter_map(|i| kinematics.link(i)) {
            let last = frames.last().copied().unwrap_or(dh_kernels::pose::IDENTITY);
            frames.push(compose(&last, &number(link)));
        }
        let last = frames.last().copied().unwrap_or(dh_kernels::pose::IDENTITY);
        let prismatic = |k: usize| chain.joints.get(k).is_some_and(|j| matches!(j.coordinate, Coordinate::Length(_)));
        Posture {
            frames,
            tip: compose(&last, &number(kinematics.tool())),
            modified: chain.convention == Convention::Modified,
            joints: chain.links.iter().map(|l| l.joint.map(|k| (k, prismatic(k)))).collect(),
        }
    }

    /// Nothing but the tool's frame.
    pub(super) fn tip_alone(&self) -> Posture {
        Posture { frames: vec![self.tip], joints: Vec::new(), ..self.clone() }
    }

    /// Is there anything behind the last frame?
    pub(super) fn has_tool(&self) -> bool {
        self.frames.last().is_some_and(|last| distance(origin(last), origin(&self.tip)) > 1e-9)
    }

    /// All points that matter.
    pub(super) fn points(&self) -> Vec<V3> {
        std::iter::once([0.0; 3]).chain(self.bars().iter().flat_map(|b| b.ends)).chain([origin(&self.tip)]).collect()
    }

    /// The straight pieces, without those of no length.
    pub(super) fn bars(&self) -> Vec<Bar> {
        let mut bars = Vec::new();
        if let Some(first) = self.frames.first() {
            bars.push(Bar { ends: [[0.0; 3], origin(first)], part: BarPart::Base, prismatic: false });
        }
        for (row, pair) in self.frames.windows(2).enumerate() {
            let [before, after] = pair else { continue };
            let (across, along) = self.pieces(before, after);
            let prismatic = self.joints.get(row).copied().flatten().is_some_and(|(_, prismatic)| prismatic);
            let length = Bar { ends: across, part: BarPart::Length(row), prismatic: false };
            let offset = Bar { ends: along, part: BarPart::Offset(row), prismatic };
            bars.extend(if self.modified { [length, offset] } else { [offset, length] });
        }
        if let Some(last) = self.frames.last() {
            bars.push(Bar { ends: [origin(last), origin(&self.tip)], part: BarPart::Tool, prismatic: false });
        }
        bars.retain(|b| distance(b.ends[0], b.ends[1]) > 1e-9);
        bars
    }

    /// The row's way along x, and along z.
    fn pieces(&self, before: &Pose, after: &Pose) -> ([V3; 2], [V3; 2]) {
        let (a, b) = (origin(before), origin(after));
        let axis = column(if self.modified { after } else { before }, 2);
        let d = dot(plus(b, a, -1.0), axis);
        if self.modified {
            let corner = plus(b, axis, -d);
            ([a, corner], [corner, b])
        } else {
            let corner = plus(a, axis, d);
            ([corner, b], [a, corner])
        }
    }

    /// The joints, each in the middle of its row's way along z.
    pub(super) fn axes(&self) -> Vec<Axis> {
        let rows = self.frames.windows(2).zip(&self.joints);
        rows.filter_map(|(pair, joint)| {
            let ([before, after], (joint, prismatic)) = (pair, (*joint)?) else { return None };
            let (_, [from, to]) = self.pieces(before, after);
            let along = column(if self.modified { after } else { before }, 2);
            Some(Axis { joint, prismatic, at: plus(from, plus(to, from, -1.0), 0.5), along })
        })
        .collect()
    }

    /// Does the whole arm lie in a horizontal plane, with all axes upright or in it?
    pub(super) fn is_flat(&self) -> bool {
        let size = self.points().iter().map(|p| distance(*p, [0.0; 3])).fold(1e-9, f64::max);
        let level = self.points().iter().all(|p| p[2].abs() < 1e-9 * size);
        level
            && self
                .axes()
                .iter()
                .all(|a| if a.prismatic { a.along[2].abs() < 1e-9 } else { a.along[2].abs() > 1.0 - 1e-9 })
    }
}
