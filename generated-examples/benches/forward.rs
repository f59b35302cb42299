//! Times forward kinematics and Jacobians in units of six calls of the standard library's `sin_cos`: `cargo bench -p
//! generated-examples`, and with `RUSTFLAGS="-C target-cpu=native"`.
//!
//! Every repetition times all rows one after the other; a ratio is taken within the repetition, and the median over the
//! repetitions is printed. So a machine that is slow for a while does no harm.

#![allow(clippy::print_stdout)] // a benchmark prints its table

use std::cell::RefCell;
use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;

use dh_robot::nalgebra::{IsometryMatrix3, Matrix4};
use generated_examples::{kuka_kr6_r700, panda, puma560, ur5};

const REPETITIONS: usize = 61;
const CALLS: usize = 4096;

/// One thing to time: a name and a pass over the data.
struct Row<'a>(String, Box<dyn Fn() + 'a>);

/// Times every row in every repetition and prints the medians: nanoseconds per call, and relative to the first row.
fn run(rows: &[Row<'_>]) {
    let mut times = vec![Vec::with_capacity(REPETITIONS); rows.len()];
    for repetition in 0..=REPETITIONS {
        for (Row(_, pass), times) in rows.iter().zip(&mut times) {
            let start = Instant::now();
            pass();
            // The first repetition warms up.
            if repetition > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e9 / CALLS as f64);
            }
        }
    }
    for (Row(name, _), own) in rows.iter().zip(&times) {
        let ratios = own.iter().zip(&times[0]).map(|(a, b)| a / b).collect();
        println!("{name:44} {:8.1} ns {:8.3} S", median(own.clone()), median(ratios));
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Random joint vectors within half a turn, the same in every run (xorshift, Marsaglia 2003).
fn joint_vectors<const N: usize>() -> Vec<[f64; N]> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut uniform = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        ((state >> 11) as f64 * (2.0_f64).powi(-52) - 1.0) * PI
    };
    (0..CALLS).map(|_| std::array::from_fn(|_| uniform())).collect()
}

/// A pass that calls `f` for every item; neither argument nor result is known to the compiler.
fn pass<'a, I, O>(name: &str, data: &'a [I], f: impl Fn(&I) -> O + 'a) -> Row<'a> {
    let run = move || {
        for item in data {
            black_box(f(black_box(item)));
        }
    };
    Row(name.to_string(), Box::new(run))
}

/// A pass that calls `f` once with all items.
fn batch<'a, I, O: Clone + 'a>(name: &str, data: &'a [I], zero: O, f: impl Fn(&[I], &mut [O]) + 'a) -> Row<'a> {
    let results = RefCell::new(vec![zero; data.len()]);
    let run = move || {
        f(black_box(data), &mut results.borrow_mut());
        black_box(&results);
    };
    Row(name.to_string(), Box::new(run))
}

/// The PUMA 560 by hand: a product of 4x4 matrices, sines and cosines of the twists known.
fn puma_by_hand(q: &[f64; 6]) -> Matrix4<f64> {
    // sine and cosine of alpha, a, d
    const LINKS: [[f64; 4]; 6] = [
        [0.0, 1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.4318, 0.15005],
        [-1.0, 0.0, 0.0203, 0.4318],
        [1.0, 0.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0, 0.0],
    ];
    let mut pose = Matrix4::identity();
    for ([sa, ca, a, d], q) in LINKS.into_iter().zip(q) {
        let (s, c) = q.sin_cos();
        #[rustfmt::skip]
        let link = Matrix4::new(
            c, -s, 0.0, a,
            s * ca, c * ca, -sa, -sa * d,
            s * sa, c * sa, ca, ca * d,
            0.0, 0.0, 0.0, 1.0,
        );
        pose *= link;
    }
    pose
}

fn main() {
    let (six, seven) = (joint_vectors::<6>(), joint_vectors::<7>());
    let (puma, ur5, kuka, panda) = (puma560::Puma560::default(), ur5::Ur5, kuka_kr6_r700::KukaKr6R700, panda::Panda);
    let apart = puma.forward(&six[0]).to_homogeneous() - puma_by_hand(&six[0]);
    assert!(apart.abs().max() < 1e-14, "both compute the same");
    run(&[
        pass("6 x std sin_cos", &six, |q| q.map(f64::sin_cos)),
        pass("PUMA 560 by hand, 4x4 matrices", &six, puma_by_hand),
        pass("PUMA 560 forward", &six, |q| puma.forward(q)),
        pass("PUMA 560 forward_and_jacobian", &six, |q| puma.forward_and_jacobian(q)),
        pass("PUMA 560 jacobian", &six, |q| puma.jacobian(q)),
        pass("PUMA 560 frames", &six, |q| puma.frames(q)),
        batch("PUMA 560 forward_batch", &six, IsometryMatrix3::identity(), |q, to| puma.forward_batch(q, to)),
        pass("UR5 forward", &six, |q| ur5.forward(q)),
        pass("UR5 forward_and_jacobian", &six, |q| ur5.forward_and_jacobian(q)),
        pass("KUKA KR 6 R700 forward", &six, |q| kuka.forward(q)),
        pass("KUKA KR 6 R700 forward_and_jacobian", &six, |q| kuka.forward_and_jacobian(q)),
        pass("Panda forward", &seven, |q| panda.forward(q)),
        pass("Panda forward_and_jacobian", &seven, |q| panda.forward_and_jacobian(q)),
        batch("Panda forward_batch", &seven, IsometryMatrix3::identity(), |q, to| panda.forward_batch(q, to)),
    ]);
}
