//! A program without the standard library: it has a panic handler of its own, so that the compiler refuses it if anything it
//! depends on links std.
//!
//! `cargo build --manifest-path tests/no_std/Cargo.toml --target-dir target/no_std`
#![no_std]
#![forbid(unsafe_code)]

use dh_robot::atan2::atan2_batch;
use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::sincos::sincos_batch;
use dh_robot::{Branch, Joint, Real, Solution, Solutions, dh_robot, pose};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

/// A planar crank: the kernels and types in use, for a scalar.
fn crank<T: Real>(target: &IsometryMatrix3<T>, joints: &'static [Joint<T>; 1]) -> Solutions<T, 1, 1> {
    let mut solutions = Solutions::new(joints);
    if let Err(why) = pose::check(target) {
        solutions.refuse(why);
        return solutions;
    }
    let [angle] = atan2_batch(&[target.translation.y], &[target.translation.x]);
    let ([sine], [cosine]) = sincos_batch(&[angle]);
    if sine * sine + cosine * cosine > T::zero() {
        solutions.insert(Solution::new([angle], Branch::ANY), T::RANGE_TOLERANCE);
    }
    solutions.within_range()
}

static DOUBLE: [Joint<f64>; 1] = [Joint::revolute("q1")];
static SINGLE: [Joint<f32>; 1] = [Joint::revolute("q1").with_range(-1.0, 1.0)];

/// The same in double precision.
pub fn double(target: &IsometryMatrix3<f64>) -> Option<[f64; 1]> {
    crank(target, &DOUBLE).closest_to(&[0.0]).map(|solution| solution.q)
}

/// The same in single precision.
pub fn single(target: &IsometryMatrix3<f32>) -> Option<[f32; 1]> {
    crank(target, &SINGLE).toward(&[0.0]).map(|solution| solution.q)
}

dh_robot! {
    /// A PUMA 560 in double precision.
    pub struct Double;

    convention = modified;
    let a2: length = 431.8mm;

    | joint | alpha  | a      | d        | theta |
    |-------|--------|--------|----------|-------|
    |   1   |   0    | 0      | 0        | q1    |
    |   2   | -90deg | 0      | 0        | q2    |
    |   3   |   0    | a2     | 150.05mm | q3    |
    |   4   | -90deg | 20.3mm | 431.8mm  | q4    |
    |   5   |  90deg | 0      | 0        | q5    |
    |   6   | -90deg | 0      | 0        | q6    |
}

dh_robot! {
    /// A SCARA in single precision.
    pub struct Single;

    convention = standard;
    scalar = f32;

    | joint | theta | d     | a     | alpha  | range          |
    |-------|-------|-------|-------|--------|----------------|
    |   1   | q1    | 387mm | 325mm |   0    | -50deg..=50deg |
    |   2   | q2    | 0     | 275mm | 180deg | -88deg..=88deg |
    |   3   | 0     | q3    | 0     |   0    | 0mm..=210mm    |
    |   4   | q4    | 0     | 0     |   0    | -1turn..=1turn |
}

/// How many solutions there are for the pose at some joint values, and the first Jacobian entry.
pub fn double_there_and_back(q: &[f64; 6]) -> (usize, f64) {
    let robot = Double::default();
    (robot.inverse(&robot.forward(q)).len(), robot.jacobian(q)[(0, 0)])
}

/// The same in single precision.
pub fn single_there_and_back(q: &[f32; 4]) -> (usize, f32) {
    (Single.inverse(&Single.forward(q)).within_range().len(), Single.jacobian(q)[(0, 0)])
}
