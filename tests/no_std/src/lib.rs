//! A program without the standard library: it has a panic handler of its own, so that the compiler refuses it if anything it
//! depends on links std.
//!
//! `cargo build --manifest-path tests/no_std/Cargo.toml --target-dir target/no_std`
#![no_std]
#![forbid(unsafe_code)]

use dh_robot::atan2::atan2_batch;
use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::sincos::sincos_batch;
use dh_robot::{Branch, Joint, Real, Solution, Solutions, pose};

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
