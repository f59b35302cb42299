use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha  | d | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
}

fn main() {}
