//! The planar arm with two links: the table to read first.
//!
//! Source: slides on inverse kinematics, workspace of the RR arm (symbols `l1`, `l2`; the lengths are ours).

use dh_robot::dh_robot;

dh_robot! {
    /// Two links in a plane, with as many solutions as an elbow has sides.
    pub struct Planar2r;

    convention = modified;
    task = position;
    let l1: length = 1m;
    let l2: length = 0.6m;
    tool = tx(l2);

    | joint | alpha | a  | d | theta |
    |-------|-------|----|---|-------|
    |   1   |   0   | 0  | 0 | q1    |
    |   2   |   0   | l1 | 0 | q2    |
}
