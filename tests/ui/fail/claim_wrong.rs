use dh_robot::dh_robot;

dh_robot! {
    pub struct Planar;

    convention = modified;
    ik = none;
    let l1: length;

    | joint | alpha  | a  | d | theta | range |
    |-------|--------|----|---|-------|-------|
    |   1   | 0      | 0  | 0 | q1    | -     |
    |   2   | 0      | l1 | 0 | q2    | -     |

    prove {
        T(0,2).px = l1*c1;
        T(0,2).py = l1*s12;
        T(0,2).r11 = c12;
    }
}

fn main() {}
