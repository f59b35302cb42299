//! A gantry with a spherical wrist.
//!
//! Source: made for this collection (the twists of a gantry in Craig's convention; the last joint's zero is 30 degrees off).

use dh_robot::dh_robot;

dh_robot! {
    /// Three slides at right angles, and a spherical wrist.
    pub struct GantryWrist;

    convention = modified;

    | joint | alpha  | a | d     | theta      |
    |-------|--------|---|-------|------------|
    |   1   |   0    | 0 | q1    | 90deg      |
    |   2   |  90deg | 0 | q2    | 90deg      |
    |   3   |  90deg | 0 | q3    | 0          |
    |   4   |   0    | 0 | 100mm | q4         |
    |   5   |  90deg | 0 | 0     | q5         |
    |   6   | -90deg | 0 | 200mm | q6 + 30deg |
}
