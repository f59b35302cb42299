use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    redundant = q8;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
}

fn main() {}
