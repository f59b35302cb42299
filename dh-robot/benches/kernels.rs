//! Times the batched kernels against the standard library's functions: `cargo bench -p dh-robot`, and with
//! `RUSTFLAGS="-C target-cpu=native"`.
//!
//! Every repetition times all rows one after the other; a ratio is taken within the repetition, and the median over the
//! repetitions is printed. So a machine that is slow for a while does no harm.

#![allow(clippy::print_stdout)] // a benchmark prints its table

use std::hint::black_box;
use std::time::Instant;

use dh_robot::Real;
use dh_robot::atan2::atan2_batch;
use dh_robot::math;
use dh_robot::sincos::sincos_batch;

const REPETITIONS: usize = 41;
const CALLS: usize = 10_000;

/// One thing to time: its name, the row it is compared with, and a pass over the data.
struct Row<'a> {
    name: String,
    baseline: usize,
    pass: Box<dyn Fn() + 'a>,
}

/// Times every row in every repetition and prints the medians: nanoseconds per call, and relative to the baseline.
fn run(rows: &[Row<'_>]) {
    let mut times = vec![Vec::with_capacity(REPETITIONS); rows.len()];
    for row in rows {
        (row.pass)();
    }
    for _ in 0..REPETITIONS {
        for (row, times) in rows.iter().zip(&mut times) {
            let start = Instant::now();
            (row.pass)();
            times.push(start.elapsed().as_secs_f64() * 1e9 / CALLS as f64);
        }
    }
    for (row, own) in rows.iter().zip(&times) {
        let ratios = own.iter().zip(&times[row.baseline]).map(|(a, b)| a / b).collect();
        println!("{:36} {:8.1} ns {:8.3} x", row.name, median(own.clone()), median(ratios));
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Uniform in [-1, 1), the same in every run (xorshift, Marsaglia 2003).
fn uniform(state: &mut u64) -> f64 {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 11) as f64 * (2.0_f64).powi(-52) - 1.0
}

/// Random joint vectors within a turn.
fn joint_vectors<T: Real, const N: usize>() -> Vec<[T; N]> {
    let mut state = 88_172_645_463_325_252;
    (0..CALLS).map(|_| core::array::from_fn(|_| T::of(uniform(&mut state) * core::f64::consts::PI))).collect()
}

/// A pass that calls `f` for every item; neither argument nor result is known to the compiler.
fn pass<'a, I, O>(data: &'a [I], f: impl Fn(&I) -> O + 'a) -> Box<dyn Fn() + 'a> {
    Box::new(move || {
        for item in data {
            black_box(f(black_box(item)));
        }
    })
}

fn sines<T: Real, const N: usize>(scalar: &str) {
    let data = joint_vectors::<T, N>();
    run(&[
        Row { name: format!("{N} x std sin_cos, {scalar}"), baseline: 0, pass: pass(&data, |q| q.map(math::sin_cos)) },
        Row { name: format!("sincos_batch of {N}, {scalar}"), baseline: 0, pass: pass(&data, |q| sincos_batch(q)) },
    ]);
}

fn angles<T: Real, const N: usize>(scalar: &str) {
    let (y, x) = (joint_vectors::<T, N>(), joint_vectors::<T, N>());
    let data: Vec<_> = y.into_iter().zip(x.into_iter().rev()).collect();
    let one_by_one = |(y, x): &([T; N], [T; N])| -> [T; N] { core::array::from_fn(|i| nalgebra_atan2(y[i], x[i])) };
    run(&[
        Row { name: format!("{N} x std atan2, {scalar}"), baseline: 0, pass: pass(&data, one_by_one) },
        Row {
            name: format!("atan2_batch of {N}, {scalar}"),
            baseline: 0,
            pass: pass(&data, |(y, x)| atan2_batch(y, x)),
        },
    ]);
}

/// The standard library's function, without the care for -pi that `math::atan2` adds.
fn nalgebra_atan2<T: Real>(y: T, x: T) -> T {
    dh_robot::nalgebra::RealField::atan2(y, x)
}

fn main() {
    sines::<f64, 1>("f64");
    sines::<f64, 2>("f64");
    sines::<f64, 4>("f64");
    sines::<f64, 6>("f64");
    sines::<f64, 7>("f64");
    sines::<f64, 8>("f64");
    sines::<f32, 6>("f32");
    sines::<f32, 7>("f32");
    angles::<f64, 1>("f64");
    angles::<f64, 2>("f64");
    angles::<f64, 4>("f64");
    angles::<f64, 6>("f64");
    angles::<f64, 16>("f64");
    angles::<f64, 8>("f64");
    angles::<f32, 8>("f32");
}
