use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1 - q2 | -     |
    |   2   | 0      | 1 | 0 | 2*q2 - 2*q1 | -     |
}

fn main() {}
