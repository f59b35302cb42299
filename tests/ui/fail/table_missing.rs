use dh_robot::dh_robot;

dh_robot! {
    pub struct Arm;

    convention = modified;
}

fn main() {}
