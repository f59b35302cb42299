use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    task = planar;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 0     | 0   | 0   | q1 |
    | 90deg | 0.3 | 0.1 | q2 |
    | 0     | 0.2 | 0   | q3 |
}

fn main() {}
