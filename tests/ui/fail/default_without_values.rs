use dh_robot::dh_robot;

dh_robot! {
    #[derive(Debug, Default)]
    pub struct Arm;

    convention = modified;
    let a2: length = 431.8mm;
    let a3: length;

    | joint | alpha  | a  | d  | theta | range |
    |-------|--------|----|----|-------|-------|
    |   1   | 0      | a2 | a3 | q1    | -     |
}

fn main() {}
