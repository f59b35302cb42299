//! The RRRP SCARA of the slides.
//!
//! Source: slides on forward kinematics, example RRRP (symbols `a1`, `a2`, `d1`, `d2`; the numbers are ours).

use dh_robot::dh_robot;

dh_robot! {
    /// A SCARA with its quill in the last joint.
    pub struct ScaraRrrp;

    convention = modified;
    let a1: length = 0.4m;
    let a2: length = 0.3m;
    let d1: length = 0.5m;
    let d2: length = 0.1m;

    | joint | alpha | a  | d  | theta |
    |-------|-------|----|----|-------|
    |   1   |   0   | 0  | d1 | q1    |
    |   2   |   0   | a1 | d2 | q2    |
    |   3   |   0   | a2 | 0  | q3    |
    |   4   |   0   | 0  | q4 | 0     |
}
