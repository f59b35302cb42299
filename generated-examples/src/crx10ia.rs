//! The FANUC CRX-10iA, a collaborative arm whose wrist axes don't meet in a point.
//!
//! Source: Abbes and Poisson, Geometric approach for inverse kinematics of the FANUC CRX collaborative robot (Robotics 13, 2024), which
//! has a pose with sixteen solutions. Base at the height of axis 2.

use dh_robot::dh_robot;

dh_robot! {
    /// FANUC CRX-10iA.
    pub struct Crx10ia;

    convention = modified;

    | joint | alpha  | a     | d      | theta      | range            |
    |-------|--------|-------|--------|------------|------------------|
    |   1   |   0    | 0     | 0      | q1         | -180deg..=180deg |
    |   2   | -90deg | 0     | 0      | q2 - 90deg | -180deg..=180deg |
    |   3   |   0    | 540mm | 0      | q3         | -270deg..=270deg |
    |   4   | -90deg | 0     | 540mm  | q4         | -190deg..=190deg |
    |   5   |  90deg | 0     | -150mm | q5         | -180deg..=180deg |
    |   6   | -90deg | 0     | 160mm  | q6         | -190deg..=190deg |
}
