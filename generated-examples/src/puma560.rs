//! The PUMA 560: six revolute joints, spherical wrist.
//!
//! Source: slides on forward kinematics (the table in symbols); numbers and ranges from Corke's Robotics Toolbox, `Puma560.py`.

use dh_robot::dh_robot;

dh_robot! {
    /// Unimation PUMA 560, frames after Craig.
    pub struct Puma560;

    convention = modified;
    let a2: length = 431.8mm;
    let a3: length = 20.3mm;
    let d3: length = 150.05mm;
    let d4: length = 431.8mm;

    | joint | alpha  | a  | d  | theta | range            |
    |-------|--------|----|----|-------|------------------|
    |   1   |   0    | 0  | 0  | q1    | -160deg..=160deg |
    |   2   | -90deg | 0  | 0  | q2    | -225deg..= 45deg |
    |   3   |   0    | a2 | d3 | q3    |  -45deg..=225deg |
    |   4   | -90deg | a3 | d4 | q4    | -110deg..=170deg |
    |   5   |  90deg | 0  | 0  | q5    | -100deg..=100deg |
    |   6   | -90deg | 0  | 0  | q6    | -266deg..=266deg |
}
