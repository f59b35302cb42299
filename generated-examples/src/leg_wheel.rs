//! The leg-wheel robot: two motors that share a joint.
//!
//! Source: slides on forward kinematics, actuator space (theta = phi1, r = p (phi2 - phi1); 20 mm is ours).

use dh_robot::dh_robot;

dh_robot! {
    /// A leg that is a wheel: both motors turn the leg, their difference drives the rack by a pinion of radius `p`.
    pub struct LegWheel;

    convention = modified;
    let p: length = 20mm;

    | joint | alpha  | a | d             | theta |
    |-------|--------|---|---------------|-------|
    |   1   |   0    | 0 | 0             | q1    |
    |   2   | -90deg | 0 | p * (q2 - q1) | 0     |
}
