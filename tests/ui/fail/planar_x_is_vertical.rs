use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    task = planar;
    tool = tx(0.2) * ry(-90deg);

    | alpha | a   | d | theta |
    |-------|-----|---|-------|
    | 0     | 0   | 0 | q1    |
    | 0     | 0.3 | 0 | q2    |
    | 0     | 0.2 | 0 | q3    |
}

fn main() {}
