//! Closed-form kinematics of serial robots, generated from a Denavit-Hartenberg table.
#![cfg_attr(not(feature = "std"), no_std)]

pub use dh_macro::dh_robot;
pub use nalgebra;
