//! The arm of the youBot: five joints.
//!
//! Source: the ARTE library of Gil (`robots/KUKA/YouBot/parameters.m`).

use dh_robot::dh_robot;

dh_robot! {
    /// KUKA youBot arm: five joints, so the task is a point and a direction.
    pub struct Youbot;

    convention = standard;
    task = axis;

    | joint | theta      | d       | a     | alpha  | range                |
    |-------|------------|---------|-------|--------|----------------------|
    |   1   | q1         | 147mm   | 33mm  |  90deg | -169deg..=169deg     |
    |   2   | q2 + 90deg | 0       | 155mm |   0    |  -65deg..= 90deg     |
    |   3   | q3         | 0       | 135mm |   0    | -151deg..=146deg     |
    |   4   | q4 - 90deg | 0       | 0     | -90deg | -102deg..=102deg     |
    |   5   | q5         | 217.5mm | 0     |   0    | -167deg..=167deg     |
}
