use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
    |   2   | 90degrees | 0 | 0 | q2    | -     |
}

fn main() {}
