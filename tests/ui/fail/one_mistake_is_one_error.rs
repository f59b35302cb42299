use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
    let a2: length = 431.8mm;

    | joint | alpha  | a | d | theta | range |
    |-------|--------|---|---|-------|-------|
    |   1   | 0      | 0 | 0 | q1    | -     |
    |   2   | 0      | a2 | 1 0 | q2    | -     |
}

fn main() {
    // The functions are there in spite of the mistake, so that it stays the only error.
    let arm = Arm { a2: 0.5 };
    let pose: dh_robot::nalgebra::IsometryMatrix3<f64> = arm.forward(&[0.0; 2]);
    let _ = (Arm::DOF, pose, arm.frames(&[0.0; 2]), arm.jacobian(&[0.0; 2]), arm.inverse(&pose));
}
