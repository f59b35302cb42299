//! Ways to write the same things.
use dh_robot::dh_robot;

dh_robot! {
    struct Free;
    convention = standard;
    unit = mm;
    ik = none;
    let w = pi/2;
    let l = 3cm;
    /// A doc comment of the field.
    let k: number = 2;
    | d | theta | alpha | a |
    | -30.0 | q1 - 90deg | -w | 1_000 |
    | 1e-05 | 08deg | 1turn/12 | 12in + 1e3mm - 1e-3m |
    | 0.4318m + 1in | -(q2) + 0.25turn | approx -1.3849rad | -l/2 + 10mm |
    | q3 + 0.05 | -3*pi/4 | 2pi/3 | k*l |
    | l - 30mm | 0 | 101.25deg | 0 |
    tool = tz(206) * ry(90deg);
}

dh_robot! {
    pub(crate) struct OneLine; convention = modified; ik = none; | joint | theta | d | a | alpha | | shoulder | q1 | 0 | 0 | 0 | | 2 | q2 | 0 | 1 | 0 |
}

fn main() {
    assert_eq!(OneLine::JOINTS.map(|j| (j.name, j.label)), [("q1", "shoulder"), ("q2", "")]);
    let _ = (Free::default().forward(&[0.0; 3]), OneLine::default().forward(&[0.0; 2]));
}
