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

    prove {
        T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, -c23, 0, -a2*s2; 0, 0, 0, 1];
        T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
        T(0,6).r11 = c1*(c23*(c4*c5*c6 - s4*s6) - s23*s5*c6) + s1*(s4*c5*c6 + c4*s6);
    }
}
