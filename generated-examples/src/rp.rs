//! The RP arm.
//!
//! Source: slides on inverse kinematics, subspace of the RP arm.

use dh_robot::dh_robot;

dh_robot! {
    /// Turn and slide: a point in polar coordinates.
    pub struct Rp;

    convention = modified;

    | joint | alpha  | a | d  | theta |
    |-------|--------|---|----|-------|
    |   1   |   0    | 0 | 0  | q1    |
    |   2   | -90deg | 0 | q2 | 0     |
}
