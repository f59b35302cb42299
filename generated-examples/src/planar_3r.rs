//! The planar RRR arm in the standard convention.
//!
//! Source: slides on forward kinematics, example RRR (symbols `l1`, `l2`, `l3`). 5 and 2 fit the numbers worked out in the slides on
//! inverse kinematics; `l3 = 1` is ours.

use dh_robot::dh_robot;

dh_robot! {
    /// Three links in a plane, every frame at the far end of its link.
    pub struct Planar3r;

    convention = standard;
    task = planar;
    let l1: length = 5;
    let l2: length = 2;
    let l3: length = 1;

    | joint | theta | d | a  | alpha |
    |-------|-------|---|----|-------|
    |   1   | q1    | 0 | l1 |   0   |
    |   2   | q2    | 0 | l2 |   0   |
    |   3   | q3    | 0 | l3 |   0   |
}
