//! The UR5: three parallel axes, and a wrist whose axes do not meet.
//!
//! Source: Corke's Robotics Toolbox, `UR5.py` (the maker's parameters).

use dh_robot::dh_robot;

dh_robot! {
    /// Universal Robots UR5.
    pub struct Ur5;

    convention = standard;

    | joint | theta | d         | a         | alpha  | range            |
    |-------|-------|-----------|-----------|--------|------------------|
    |   1   | q1    | 89.459mm  | 0         |  90deg | -360deg..=360deg |
    |   2   | q2    | 0         | -425mm    |   0    | -360deg..=360deg |
    |   3   | q3    | 0         | -392.25mm |   0    | -180deg..=180deg |
    |   4   | q4    | 109.15mm  | 0         |  90deg | -360deg..=360deg |
    |   5   | q5    | 94.65mm   | 0         | -90deg | -360deg..=360deg |
    |   6   | q6    | 82.3mm    | 0         |   0    | -360deg..=360deg |
}
