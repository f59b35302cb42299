//! The PRRR wafer robot.
//!
//! Source: slides on forward kinematics, example PRRR (symbols `a2`, `a3`, `d2`, `d3`, `d4`; the numbers are ours).

use dh_robot::dh_robot;

dh_robot! {
    /// A wafer robot: a lift and a planar arm.
    pub struct WaferPrrr;

    convention = modified;
    let a2: length = 250mm;
    let a3: length = 200mm;
    let d2: length = 100mm;
    let d3: length = 20mm;
    let d4: length = 30mm;

    | joint | alpha | a  | d  | theta | range       |
    |-------|-------|----|----|-------|-------------|
    |   1   |   0   | 0  | q1 | 0     | 0mm..=300mm |
    |   2   |   0   | 0  | d2 | q2    | -1turn..=1turn |
    |   3   |   0   | a2 | d3 | q3    | -1turn..=1turn |
    |   4   |   0   | a3 | d4 | q4    | -1turn..=1turn |
}
