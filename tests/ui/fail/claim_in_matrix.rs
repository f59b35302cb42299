use dh_robot::dh_robot;

dh_robot! {
    pub struct Puma560;

    convention = modified;
    let a2: length = 431.8mm;
    let a3: length = 20.3mm;
    let d3: length = 150.05mm;
    let d4: length = 431.8mm;

    | joint | alpha  | a  | d  | theta |
    |-------|--------|----|----|-------|
    |   1   |   0    | 0  | 0  | q1    |
    |   2   | -90deg | 0  | 0  | q2    |
    |   3   |   0    | a2 | d3 | q3    |
    |   4   | -90deg | a3 | d4 | q4    |
    |   5   |  90deg | 0  | 0  | q5    |
    |   6   | -90deg | 0  | 0  | q6    |

    prove {
        T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, c23, 0, -a2*s2; 0, 0, 0, 1];
        T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
        T(0,6).r11 = c1*(c23*(c4*c5*c6 - s4*s5) - s23*s5*c5) + s1*(s4*c5*c6 + c4*s6);
        T(0,6).pz = a3*s23 - d4;
    }
}

fn main() {
    // the type is there all the same
    let _ = Puma560::DOF;
}
