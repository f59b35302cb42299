use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 0      | 0    | 0.3  | q1 |
    | -90deg | 0    | 0    | q2 |
    | 90deg  | 0    | 0.4  | q3 |
    | -90deg | 0    | 0    | q4 |
    | 90deg  | 0    | 0.4  | q5 |
    | -90deg | 0    | 0    | q6 |
    | 90deg  | 0    | 0.1  | q7 |
}

fn main() {}
