use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    calibrated;

    | joint | alpha  | a | d | theta |
    |-------|--------|---|---|-------|
    |   1   | 0      | 0 | 0 | q1    |
}

fn main() {}
