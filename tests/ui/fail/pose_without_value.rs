use dh_robot::dh_robot;

dh_robot! {
    #[derive(Default)]
    pub struct Arm;

    convention = modified;
    let gripper: pose;
    tool = gripper;

    | joint | alpha  | a | d | theta |
    |-------|--------|---|---|-------|
    |   1   | 0      | 0 | 0 | q1    |
}

fn main() {}
