//! The general arm with a spherical wrist, all in symbols: Pieper's problem.
//!
//! Source: slides on inverse kinematics, Pieper's method. No symbol has a nominal value, so the type has no `Default`.

use dh_robot::dh_robot;

dh_robot! {
    /// Six revolute joints of which the last three axes meet: all twists and lengths are open.
    pub struct Pieper;

    convention = modified;
    let alpha1: angle;
    let alpha2: angle;
    let alpha3: angle;
    let alpha4: angle;
    let alpha5: angle;
    let a1: length;
    let a2: length;
    let a3: length;
    let d2: length;
    let d3: length;
    let d4: length;

    | joint | alpha  | a  | d  | theta |
    |-------|--------|----|----|-------|
    |   1   |   0    | 0  | 0  | q1    |
    |   2   | alpha1 | a1 | d2 | q2    |
    |   3   | alpha2 | a2 | d3 | q3    |
    |   4   | alpha3 | a3 | d4 | q4    |
    |   5   | alpha4 | 0  | 0  | q5    |
    |   6   | alpha5 | 0  | 0  | q6    |
}
