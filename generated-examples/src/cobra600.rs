//! A SCARA that is sold: the Adept Cobra 600.
//!
//! Source: Corke's Robotics Toolbox, `Cobra600.py`.

use dh_robot::dh_robot;

dh_robot! {
    /// Adept Cobra 600: the second twist of half a turn points the quill down.
    pub struct Cobra600;

    convention = standard;

    | joint | theta | d     | a     | alpha  | range          |
    |-------|-------|-------|-------|--------|----------------|
    |   1   | q1    | 387mm | 325mm |   0    | -50deg..=50deg |
    |   2   | q2    | 0     | 275mm | 180deg | -88deg..=88deg |
    |   3   | 0     | q3    | 0     |   0    | 0mm..=210mm    |
    |   4   | q4    | 0     | 0     |   0    | -1turn..=1turn |
}
