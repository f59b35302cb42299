use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    ik = none;
    ik = none;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
}

fn main() {}
