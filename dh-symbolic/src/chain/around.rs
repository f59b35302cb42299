//! Poses that the program sets at run time (a gripper that changes, a rail): what they leave of `base` and `tool` for formulas.
//!
//! The arm of all formulas ends at the nearest such pose. What lies beyond is multiplied at run time. One exception: where the inverse is given
//! a point (`task = position`), the point is a part of the arm, with coordinates that are parameters.

use super::{Chain, Elementary, MotionSpec};

/// A pose that the program sets.
#[derive(Clone, Debug)]
pub struct PoseField {
    /// Name of the field.
    pub name: String,
    /// Its nominal value.
    pub nominal: Option<Vec<Elementary>>,
}

/// A factor of `base` or `tool` beyond the arm of the formulas.
#[derive(Clone, Debug)]
pub enum Factor {
    /// A constant motion.
    Motion(Elementary),
    /// A pose that the program sets: its index in [`Chain::poses`].
    Pose(usize),
}

/// The names of the coordinates that the tool's point has in the last frame, where they are parameters.
pub(super) const POINT: [&str; 3] = ["tool_x", "tool_y", "tool_z"];

impl Chain {
    /// Whether the program sets poses, so that the arm of the formulas is only a part of the robot.
    pub fn is_part(&self) -> bool {
        !self.before.is_empty() || !self.after.is_empty() || !self.poses.is_empty()
    }

    /// Whether a parameter is a coordinate of the tool's point, which comes from the poses that the program sets.
    pub fn is_of_point(&self, name: &str) -> bool {
        self.point().is_some_and(|point| point.iter().any(|p| p == name))
    }

    /// The parameters that hold the tool's point in the last frame, where the task is a position beyond a pose that the program sets.
    pub fn point(&self) -> Option<[String; 3]> {
        let list: Vec<String> = self.parameters.iter().filter(|p| p.of_point).map(|p| p.name.clone()).collect();
        list.try_into().ok()
    }

    /// The names of the poses that formulas leave out.
    pub fn left_out(&self) -> Vec<&str> {
        let poses = self.before.iter().chain(&self.after).filter_map(|f| match f {
            Factor::Pose(i) => self.poses.get(*i).map(|p| p.name.as_str()),
            Factor::Motion(_) => None,
        });
        let mut names: Vec<&str> = poses.collect();
        names.dedup();
        names
    }
}

/// `base` as what formulas leave out and what they contain.
pub(super) fn split_base(list: &[MotionSpec]) -> (&[MotionSpec], &[MotionSpec]) {
    list.split_at(list.iter().rposition(|m| matches!(m, MotionSpec::Pose(_))).map_or(0, |i| i + 1))
}

/// `tool` as what formulas contain and what they leave out.
pub(super) fn split_tool(list: &[MotionSpec]) -> (&[MotionSpec], &[MotionSpec]) {
    list.split_at(list.iter().position(|m| matches!(m, MotionSpec::Pose(_))).unwrap_or(list.len()))
}
