use dh_robot::dh_robot;

dh_robot! {}

fn main() {}
