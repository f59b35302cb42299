//! An RRR arm with intersecting axes 1 and 2.
//!
//! Source: slides on forward kinematics, example RRR with a1 = 0 (only a picture is given: a right angle between axes 1 and 2 and a
//! parallel third axis). The numbers are ours.

use dh_robot::dh_robot;

dh_robot! {
    /// An arm whose first two axes intersect: a shoulder that turns and tilts, and an elbow.
    pub struct RrrIntersecting;

    convention = modified;
    task = position;
    let d2: length = 0.15m;
    let l2: length = 0.5m;
    let l3: length = 0.4m;
    tool = tx(l3);

    | joint | alpha  | a  | d  | theta |
    |-------|--------|----|----|-------|
    |   1   |   0    | 0  | 0  | q1    |
    |   2   | -90deg | 0  | d2 | q2    |
    |   3   |   0    | l2 | 0  | q3    |
}
