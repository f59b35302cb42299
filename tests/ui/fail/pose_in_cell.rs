use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    let gripper: pose;
    let high: length = 2 * gripper;
    tool = gripper;

    | joint | alpha  | a             | d       | theta        |
    |-------|--------|---------------|---------|--------------|
    |   1   | 0      | 0             | gripper | q1           |
    |   2   | 0      | 2*gripper + 1 | 0       | q2 - gripper |
}

fn main() {
    let _ = Arm { high: 1.0, gripper: dh_robot::nalgebra::IsometryMatrix3::identity() };
}
