use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    let gripper: pose;
    let high: length = 1m;
    base = high;
    tool = tz(50mm) * griper * gripper(2);

    | joint | alpha  | a | d | theta |
    |-------|--------|---|---|-------|
    |   1   | 0      | 0 | 0 | q1    |
}

fn main() {}
