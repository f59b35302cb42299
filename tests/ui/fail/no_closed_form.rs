use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | alpha | a | d | theta |
    |-------|---|---|-------|
    | 20deg  | 0.1  | 0.2  | q1 |
    | 40deg  | 0.3  | 0.1  | q2 |
    | -50deg | 0.2  | 0.15 | q3 |
    | 70deg  | 0.12 | 0.22 | q4 |
    | 35deg  | 0.17 | 0.3  | q5 |
}

fn main() {}
