//! Every example robot: one module each, which holds the macro call and the source of its numbers.
//!
//! Read [`planar_2r`] first, then [`puma560`]. What the macro made of each table stands, formatted, in `expanded/`, its
//! lecture notes in `notes/`; `cargo regen` writes both and `cargo regen --check` compares.

pub mod corpus;
pub mod source;

/// Declares the robots' modules and the two lists of them, so that a robot is named once.
macro_rules! robots {
    ($($module:ident $name:ident $dof:literal)*) => {
        $(pub mod $module;)*

        /// The modules that hold a robot.
        pub const ROBOTS: &[&str] = &[$(stringify!($module)),*];

        /// Calls a macro with every robot: `module Type joints`, one after the other.
        #[macro_export]
        macro_rules! for_every_robot {
            ($go:path) => { $go! { $($module $name $dof)* } };
        }
    };
}

robots! {
    planar_2r Planar2r 2
    planar_3r Planar3r 3
    planar_3r_craig Planar3rCraig 3
    rpr Rpr 3
    rrr_intersecting RrrIntersecting 3
    wafer_prrr WaferPrrr 4
    scara_rrrp ScaraRrrp 4
    rp Rp 2
    rp_parallel RpParallel 2
    leg_wheel LegWheel 2
    puma560 Puma560 6
    six_axis_chain SixAxisChain 6
    cup_arm CupArm 6
    pieper Pieper 6
    ur5 Ur5 6
    kuka_kr6_r700 KukaKr6R700 6
    stanford Stanford 6
    cobra600 Cobra600 4
    panda Panda 7
    youbot Youbot 5
    gantry_wrist GantryWrist 6
    crx10ia Crx10ia 6
    polar_offset_wrist PolarOffsetWrist 6
}
