use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    let high: length = 1m;
    let rail: pose = tz(high);
    let gripper: pose = rail * ry(90deg);
    let rail: pose;
    let gripper: length = 1m;
    let q1: pose;
    let hand: poes;

    | joint | alpha  | a | d | theta |
    |-------|--------|---|---|-------|
    |   1   | 0      | 0 | 0 | q1    |
}

fn main() {}
