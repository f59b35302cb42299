//! The simple six-axis chain: three parallel axes.
//!
//! Source: slides on D-H modelling (symbols `a2`, `a3`, `a4`; the numbers are ours).

use dh_robot::dh_robot;

dh_robot! {
    /// A chain of six axes of which the second, third and fourth are parallel.
    pub struct SixAxisChain;

    convention = standard;
    let a2: length = 0.5m;
    let a3: length = 0.4m;
    let a4: length = 0.2m;

    | joint | theta | d | a  | alpha  |
    |-------|-------|---|----|--------|
    |   1   | q1    | 0 | 0  |  90deg |
    |   2   | q2    | 0 | a2 |   0    |
    |   3   | q3    | 0 | a3 |   0    |
    |   4   | q4    | 0 | a4 | -90deg |
    |   5   | q5    | 0 | 0  |  90deg |
    |   6   | q6    | 0 | 0  |   0    |
}
