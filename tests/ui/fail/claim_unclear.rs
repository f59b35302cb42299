use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;

    | joint | alpha | a  | d | theta |
    |-------|-------|----|---|-------|
    |   1   | 0     | 0  | 0 | q1    |
    |   2   | 0     | 1m | 0 | q2    |

    prove {
        T(0,2).px = l1*c1;
        T(0,2).py = s1 s2;
        T(0,3).px = 0;
        T(0,2).R = [c12, -s12; s12, c12];
        c1 = cos(30);
    }
}

fn main() {}
