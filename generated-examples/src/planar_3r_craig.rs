//! The planar RRR arm in Craig's convention.
//!
//! Source: slides on forward kinematics, example RRR, and slides on inverse kinematics (symbols `l1`, `l2`). 5 and 2 fit the numbers
//! worked out there.

use dh_robot::dh_robot;

dh_robot! {
    /// Three links in a plane, every frame on the axis of its joint; the last link is not in the table.
    pub struct Planar3rCraig;

    convention = modified;
    task = planar;
    let l1: length = 5;
    let l2: length = 2;

    | joint | alpha | a  | d | theta |
    |-------|-------|----|---|-------|
    |   1   |   0   | 0  | 0 | q1    |
    |   2   |   0   | l1 | 0 | q2    |
    |   3   |   0   | l2 | 0 | q3    |
}
