//! Closed-form kinematics of serial robots, generated from a Denavit-Hartenberg table.
#![cfg_attr(not(any(test, feature = "std")), no_std)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "dh-robot needs elementary functions: turn on its feature `std` (on by default), \
     or for `no_std` its feature `libm`: dh-robot = { version = \"0.1\", default-features = false, features = [\"libm\"] }"
);

/// Declares every module only where elementary functions exist, so that the message above is the only error without them.
macro_rules! modules {
    ($($(#[$attribute:meta])* $visibility:vis mod $name:ident;)*) => {
        $($(#[$attribute])* #[cfg(any(feature = "std", feature = "libm"))] $visibility mod $name;)*
    };
}

modules! {
    pub mod atan2;
    mod branch;
    mod free;
    /// Numeric kernels for generated code.
    #[doc(hidden)]
    pub mod ik;
    mod joint;
    pub mod math;
    pub mod pose;
    mod real;
    mod robot;
    pub mod sincos;
    mod solution;
    mod solutions;
    mod why;
}

pub use dh_macro::dh_robot;
pub use nalgebra;

#[cfg(any(feature = "std", feature = "libm"))]
pub use {
    branch::{Branch, Elbow, Shoulder, Wrist},
    free::{FreeJoints, FreeJointsIter},
    joint::{Joint, JointKind},
    real::Real,
    robot::{ForwardKinematics, InverseKinematics, Jacobian, Robot},
    solution::Solution,
    solutions::Solutions,
    why::Why,
};
