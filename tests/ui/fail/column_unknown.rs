use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha  | a | d | tehta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
}

fn main() {}
