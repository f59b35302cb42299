//! The RPR arm of the slides.
//!
//! Source: slides on forward kinematics, example RPR (symbol `l2`; 0.4 m is ours).

use dh_robot::dh_robot;

dh_robot! {
    /// Turn, slide, turn: the slide moves across the first axis and the third joint turns about the slide's direction.
    pub struct Rpr;

    convention = modified;
    let l2: length = 0.4m;

    | joint | alpha | a | d  | theta |
    |-------|-------|---|----|-------|
    |   1   |   0   | 0 | 0  | q1    |
    |   2   | 90deg | 0 | q2 | 0     |
    |   3   |   0   | 0 | l2 | q3    |
}
