use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
}

fn main() {}
