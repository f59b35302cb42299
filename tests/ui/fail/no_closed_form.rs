use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 20deg  | 0.1  | 0.2  | q1 |
    | 40deg  | 0.3  | q2   | 10deg |
    | -50deg | 0.2  | 0.15 | q3 |
    | 70deg  | 0.12 | 0.22 | q4 |
    | 35deg  | 0.17 | q5   | 25deg |
    | 65deg  | 0.07 | 0.3  | q6 |
}

fn main() {}
