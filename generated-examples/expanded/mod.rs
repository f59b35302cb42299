// Made by `cargo regen`; do not edit.

pub mod planar_2r;
pub mod planar_3r;
pub mod planar_3r_craig;
pub mod rpr;
pub mod rrr_intersecting;
pub mod wafer_prrr;
pub mod scara_rrrp;
pub mod rp;
pub mod rp_parallel;
pub mod leg_wheel;
pub mod puma560;
pub mod six_axis_chain;
pub mod cup_arm;
pub mod pieper;
pub mod ur5;
pub mod kuka_kr6_r700;
pub mod stanford;
pub mod cobra600;
pub mod panda;
pub mod youbot;
pub mod gantry_wrist;
pub mod crx10ia;
pub mod polar_offset_wrist;
