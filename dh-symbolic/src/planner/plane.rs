//! The condition of `task = planar`: the tool of the arm turns about the base's z axis only.

use crate::algebra::{Poly, Transform};
use crate::chain::{Chain, Coordinate};
use crate::kinematics::Kinematics;

/// The tool's height, if no joint changes it.
pub(crate) fn constant_height(chain: &Chain) -> Option<Poly> {
    let pose = Kinematics::new(chain).pose();
    let height = &pose.p[2];
    (!chain.joints.iter().any(|j| moves(height, &j.coordinate))).then(|| height.clone())
}

/// An arm with the pose of its tool, seen by a task in the plane.
pub(super) struct Plane<'a> {
    chain: &'a Chain,
    pose: Transform,
}

impl Plane<'_> {
    /// Forms the pose.
    pub(super) fn new(chain: &Chain) -> Plane<'_> {
        Plane { chain, pose: Kinematics::new(chain).pose() }
    }

    /// The joints that tilt the tool.
    pub(super) fn tilting_joints(&self) -> Vec<usize> {
        let tilts = |c: &Coordinate| self.pose.r[2].iter().any(|entry| moves(entry, c));
        let joints = self.chain.joints.iter().enumerate();
        joints.filter(|(_, j)| tilts(&j.coordinate)).map(|(k, _)| k).collect()
    }

    /// Whether the tool's x axis is always parallel to z, so that it has no angle about z.
    pub(super) fn is_upright(&self) -> bool {
        self.pose.r[0][0].is_zero() && self.pose.r[1][0].is_zero()
    }
}

fn moves(entry: &Poly, coordinate: &Coordinate) -> bool {
    match coordinate {
        Coordinate::Length(s) => entry.symbols().contains(s),
        Coordinate::Angle(v) => entry.angles().contains(v),
    }
}
