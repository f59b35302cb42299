//! The RP arm whose axes are parallel.
//!
//! Source: slides on forward kinematics, RP arm of the quiz (symbol `a1`; 0.5 m is ours).

use dh_robot::dh_robot;

dh_robot! {
    /// Turn and slide along the same direction.
    pub struct RpParallel;

    convention = modified;
    let a1: length = 0.5m;

    | joint | alpha | a  | d  | theta |
    |-------|-------|----|----|-------|
    |   1   |   0   | 0  | 0  | q1    |
    |   2   |   0   | a1 | q2 | 0     |
}
