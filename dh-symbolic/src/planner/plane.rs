//! What `task = planar` asks of an arm: that its tool turns about the base's z axis only.

use crate::algebra::Poly;
use crate::chain::{Chain, Coordinate};
use crate::kinematics::Kinematics;

/// The tool's height, if no joint changes it.
pub(crate) fn constant_height(chain: &Chain) -> Option<Poly> {
    let pose = Kinematics::new(chain).pose();
    let height = &pose.p[2];
    (!chain.joints.iter().any(|j| moves(height, &j.coordinate))).then(|| height.clone())
}

/// The joints that tilt the tool.
pub fn tilting_joints(chain: &Chain) -> Vec<usize> {
    let pose = Kinematics::new(chain).pose();
    let tilts = |c: &Coordinate| pose.r[2].iter().any(|entry| moves(entry, c));
    (0..chain.dof()).filter(|k| chain.joints.get(*k).is_some_and(|j| tilts(&j.coordinate))).collect()
}

/// Does the tool's x axis always stand along z, so that it has no angle about z?
pub fn is_upright(chain: &Chain) -> bool {
    let pose = Kinematics::new(chain).pose();
    pose.r[0][0].is_zero() && pose.r[1][0].is_zero()
}

fn moves(entry: &Poly, coordinate: &Coordinate) -> bool {
    match coordinate {
        Coordinate::Length(s) => entry.symbols().contains(s),
        Coordinate::Angle(v) => entry.angles().contains(v),
    }
}
