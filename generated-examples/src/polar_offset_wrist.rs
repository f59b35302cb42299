//! A polar arm (two turns and a telescope) with an offset wrist: no closed form in steps, and a joint that slides.
//!
//! Source: made for this collection, after the Unimate's layout; the wrist's axes don't meet, so that the general elimination has to
//! do with a prismatic joint.

use dh_robot::dh_robot;

dh_robot! {
    /// A polar arm with a wrist whose three axes have no common point.
    pub struct PolarOffsetWrist;

    convention = modified;

    | joint | alpha  | a    | d          | theta | range            |
    |-------|--------|------|------------|-------|------------------|
    |   1   |   0    | 0    | 600mm      | q1    | -150deg..=150deg |
    |   2   | -90deg | 0    | 120mm      | q2    | -120deg..= 60deg |
    |   3   |  90deg | 50mm | q3         | 0     |  400mm..=1100mm  |
    |   4   |   0    | 0    | 100mm      | q4    | -180deg..=180deg |
    |   5   | -90deg | 30mm | 0          | q5    | -110deg..=110deg |
    |   6   |  90deg | 80mm | 90mm       | q6    | -180deg..=180deg |
}
