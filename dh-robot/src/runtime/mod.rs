//! Runtime support for generated code only: not a stable interface, it changes with the macro from version to version.

mod around;
pub mod batched;
pub mod packed;
mod slices;

pub use around::{Around, rigid, rotation, translation};
pub use slices::{HasJoints, Joints, OverSlices};

pub use crate::inverse::{
    Attempt, Path, Sample, Setting, direction, frame_of, frame_of_axis, frame_of_plane, in_units, nearest, self_motion,
    solve, solve_bounded, solve_near, to_pose,
};
pub use crate::math::{atan2, sin_cos};
pub use crate::sincos::sincos_batch;
pub use dh_kernels::{
    Drive, Kinematics, Pose, TaskTarget, solve_bilinear_choosing, solve_general, solve_half_turn,
    solve_length_squared_and_angle_choosing, solve_many, solve_pair, solve_quadratic, solve_second_harmonic,
    solve_sincos,
};
