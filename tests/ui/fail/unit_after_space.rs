use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
    |   2   | 0      | 0.5 m | 0 | q2    | -     |
}

fn main() {}
