//! The Panda: seven joints, so that one is free.
//!
//! Source: documentation of the Franka control interface, as in Corke's Robotics Toolbox, `Panda.py`.

use dh_robot::dh_robot;

dh_robot! {
    /// Franka Emika Panda; the caller chooses the last joint.
    pub struct Panda;

    convention = modified;
    redundant = q7;

    | joint | alpha  | a       | d     | theta | range                |
    |-------|--------|---------|-------|-------|----------------------|
    |   1   |   0    | 0       | 333mm | q1    | -166deg..=166deg     |
    |   2   | -90deg | 0       | 0     | q2    | -101deg..=101deg     |
    |   3   |  90deg | 0       | 316mm | q3    | -166deg..=166deg     |
    |   4   |  90deg | 82.5mm  | 0     | q4    | -176deg..= -4deg     |
    |   5   | -90deg | -82.5mm | 384mm | q5    | -166deg..=166deg     |
    |   6   |  90deg | 0       | 0     | q6    |   -1deg..=215deg     |
    |   7   |  90deg | 88mm    | 107mm | q7    | -166deg..=166deg     |
}
