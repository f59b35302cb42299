//! The Stanford arm.
//!
//! Source: Paul, Robot Manipulators (1981), as in Corke's Robotics Toolbox, `Stanford.py` (with its offset `a3`).

use dh_robot::dh_robot;

dh_robot! {
    /// The Stanford arm: its third joint slides.
    pub struct Stanford;

    convention = standard;

    | joint | theta  | d     | a      | alpha  | range             |
    |-------|--------|-------|--------|--------|-------------------|
    |   1   | q1     | 412mm | 0      | -90deg | -170deg..=170deg  |
    |   2   | q2     | 154mm | 0      |  90deg | -170deg..=170deg  |
    |   3   | -90deg | q3    | 20.3mm |   0    | 304.8mm..=1270mm  |
    |   4   | q4     | 0     | 0      | -90deg | -170deg..=170deg  |
    |   5   | q5     | 0     | 0      |  90deg |  -90deg..= 90deg  |
    |   6   | q6     | 0     | 0      |   0    | -170deg..=170deg  |
}
