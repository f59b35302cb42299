use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    unit = miles;
    let a2: lenght;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 90     | 0 | 0 | q1    | -160..=160        |
    |   2   | -90deg | 431.8deg | 0 | q2 | 160deg..=-160deg |
    |   3   | 0 | a3 | -0.4f32 | q2 | - |
    |   4   | 0 | 0 | 0 | - |
}

fn main() {}
