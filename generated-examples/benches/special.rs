//! Times inverses at special poses, and counts the jumps of paths through them: `cargo bench -p generated-examples --bench special`.
//!
//! For each arm and set: the median and the greatest time of `inverse` and of `inverse_near` (from 1 mrad away), in microseconds and, for the
//! greatest, in units of six calls of the standard library's `sin_cos`; how many poses have no solution that stands for the joints they were made
//! from; and how many of the paths through a singular pose jump by more than 0.1 rad. Each time is the least of three.

#![allow(clippy::print_stdout)] // a benchmark prints its table

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::hint::black_box;
use std::time::Instant;

use dh_robot::FreeJoints;
use dh_robot::nalgebra::IsometryMatrix3;
use generated_examples::{cobra600, crx10ia, kuka_kr6_r700, panda, puma560, stanford, ur5};

type Pose = IsometryMatrix3<f64>;
type Near = fn(&Pose, &[f64], &[f64]) -> Option<Vec<f64>>;
type Solutions = Vec<(Vec<f64>, FreeJoints)>;

/// A small generator of random numbers, the same in every run (SplitMix64).
struct Random(u64);

impl Random {
    /// Uniform in [-1, 1).
    fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2.0_f64.powi(-52) - 1.0
    }
}

/// An arm as functions of slices. Times are seconds.
struct Case {
    name: &'static str,
    joints: usize,
    /// The joint that the caller gives.
    given: Option<usize>,
    /// A joint that slides, and the middle of its range.
    slides: Option<(usize, f64)>,
    /// Joints and the values at which the arm is singular.
    singular: &'static [(usize, f64)],
    forward: fn(&[f64]) -> Pose,
    time: fn(&Pose, &[f64]) -> f64,
    time_near: fn(&Pose, &[f64], &[f64]) -> f64,
    inverse: fn(&Pose, &[f64]) -> Solutions,
    near: Near,
}

fn array<const N: usize>(q: &[f64]) -> [f64; N] {
    std::array::from_fn(|k| q[k])
}

/// The least time of three calls.
fn least<O>(call: impl Fn() -> O) -> f64 {
    let time = || {
        let start = Instant::now();
        black_box(call());
        start.elapsed().as_secs_f64()
    };
    time().min(time()).min(time())
}

macro_rules! case {
    ($name:literal, $robot:ty, $n:literal, $given:expr, $slides:expr, $singular:expr, |$q:ident| ($($value:expr)?)) => {
        Case {
            name: $name,
            joints: $n,
            given: $given,
            slides: $slides,
            singular: $singular,
            forward: |q| <$robot>::default().forward(&array::<$n>(q)),
            time: |t, $q| {
                let robot = <$robot>::default();
                let _ = $q;
                least(|| black_box(&robot).inverse(black_box(t) $(, $value)?))
            },
            time_near: |t, $q, from| {
                let (robot, from) = (<$robot>::default(), array::<$n>(from));
                let _ = $q;
                least(|| black_box(&robot).inverse_near(black_box(t) $(, $value)?, &from))
            },
            inverse: |t, $q| {
                let _ = $q;
                <$robot>::default().inverse(t $(, $value)?).iter().map(|s| (s.q.to_vec(), s.free)).collect()
            },
            near: |t, $q, from| {
                let _ = $q;
                let found = <$robot>::default().inverse_near(t $(, $value)?, &array::<$n>(from));
                found.ok().map(|s| s.q.to_vec())
            },
        }
    };
}

fn cases() -> [Case; 7] {
    const PUMA_ELBOW: f64 = -1.523_818_410_446_813_6;
    const KR6_ELBOW: f64 = -1.475_198_208_131_056_2;
    [
        case!("PUMA 560", puma560::Puma560, 6, None, None, &[(4, 0.0), (2, PUMA_ELBOW)], |q| ()),
        case!("KR 6", kuka_kr6_r700::KukaKr6R700, 6, None, None, &[(4, 0.0), (2, KR6_ELBOW)], |q| ()),
        case!("UR5", ur5::Ur5, 6, None, None, &[(4, 0.0), (2, 0.0)], |q| ()),
        case!("Panda, q7 given", panda::Panda, 7, Some(6), None, &[], |q| (q[6])),
        case!("Stanford", stanford::Stanford, 6, None, Some((2, 0.5)), &[(4, 0.0)], |q| ()),
        case!("SCARA", cobra600::Cobra600, 4, None, Some((2, 0.1)), &[(1, 0.0)], |q| ()),
        case!("CRX-10iA", crx10ia::Crx10ia, 6, None, None, &[(4, 0.0), (2, -FRAC_PI_2)], |q| ()),
    ]
}

fn wrapped(x: f64) -> f64 {
    x - TAU * (x / TAU).round()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| wrapped(x - y).abs()).fold(0.0, f64::max)
}

impl Case {
    fn random(&self, r: &mut Random) -> Vec<f64> {
        let mut q: Vec<f64> = (0..self.joints).map(|_| PI * r.signed()).collect();
        if let Some((k, middle)) = self.slides {
            q[k] = middle * (1.0 + 0.5 * r.signed());
        }
        q
    }

    fn quarters(&self, r: &mut Random) -> Vec<f64> {
        let mut q: Vec<f64> = (0..self.joints).map(|_| FRAC_PI_2 * (2.0 * r.signed()).round()).collect();
        if let Some((k, middle)) = self.slides {
            q[k] = middle;
        }
        q
    }

    /// All singular joints at their values, or one of them.
    fn singular(&self, r: &mut Random, all: bool) -> Vec<f64> {
        let mut q = self.random(r);
        let one = (10.0 * r.signed().abs()) as usize % self.singular.len().max(1);
        for (i, (k, value)) in self.singular.iter().enumerate() {
            if all || i == one {
                q[*k] = *value;
            }
        }
        q
    }

    fn beside(&self, q: &[f64], size: f64, r: &mut Random) -> Vec<f64> {
        let moved = |(k, x): (usize, &f64)| if self.given == Some(k) { *x } else { x + size * r.signed() };
        q.iter().enumerate().map(moved).collect()
    }

    /// The sets of joint vectors, with their names.
    fn sets(&self) -> Vec<(String, Vec<Vec<f64>>)> {
        let mut r = Random(42);
        let mut sets = vec![
            ("random".to_string(), (0..5000).map(|_| self.random(&mut r)).collect::<Vec<_>>()),
            ("quarter turns".to_string(), (0..1000).map(|_| self.quarters(&mut r)).collect()),
            ("one joint singular".to_string(), (0..300).map(|_| self.singular(&mut r, false)).collect()),
            ("all singular".to_string(), (0..300).map(|_| self.singular(&mut r, true)).collect()),
        ];
        for exponent in [-3, -5, -7, -9, -11] {
            let near = |r: &mut Random, k: usize| match k % 3 {
                0 => self.quarters(r),
                n => self.singular(r, n == 1),
            };
            let size = 10_f64.powi(exponent);
            let set = (0..300).map(|k| {
                let q = near(&mut r, k);
                self.beside(&q, size, &mut r)
            });
            sets.push((format!("1e{exponent} beside"), set.collect()));
        }
        sets
    }

    /// How many of the paths through a singular pose jump, of how many.
    fn jumps(&self) -> (usize, usize) {
        let mut r = Random(7);
        let paths = if self.singular.is_empty() { 0 } else { 300 };
        let jumps = (0..paths).filter(|_| {
            let q = self.singular(&mut r, false);
            let still = |k: usize| self.given == Some(k) || self.slides.is_some_and(|s| s.0 == k);
            let speed: Vec<f64> = (0..q.len()).map(|k| if still(k) { 0.0 } else { r.signed() }).collect();
            let at = |t: f64| -> Vec<f64> { q.iter().zip(&speed).map(|(a, b)| a + t * b).collect() };
            let mut joints = at(-0.3);
            (-59..=60).any(|k| {
                let x = at(0.005 * f64::from(k));
                let Some(next) = (self.near)(&(self.forward)(&x), &x, &joints) else { return true };
                let jump = apart(&next, &joints) > 0.1;
                joints = next;
                jump
            })
        });
        (jumps.count(), paths)
    }
}

/// The median and the greatest.
fn summary(mut times: Vec<f64>) -> [f64; 2] {
    times.sort_by(f64::total_cmp);
    [times[times.len() / 2], times[times.len() - 1]].map(|x| 1e6 * x)
}

fn main() {
    let mut r = Random(3);
    let data: Vec<[f64; 6]> = (0..20_000).map(|_| std::array::from_fn(|_| PI * r.signed())).collect();
    let pass = || data.iter().for_each(|q| _ = black_box(black_box(q).map(f64::sin_cos)));
    let unit = 1e6 * least(pass) / data.len() as f64;
    println!("S = {:.0} ns", 1e3 * unit);
    for case in cases() {
        for (name, set) in case.sets() {
            let poses: Vec<Pose> = set.iter().map(|q| (case.forward)(q)).collect();
            let times = set.iter().zip(&poses).map(|(q, t)| (case.time)(t, q)).collect();
            let away: Vec<Vec<f64>> = set.iter().map(|q| case.beside(q, 1e-3, &mut r)).collect();
            let near = set.iter().zip(&poses).zip(&away).map(|((q, t), from)| (case.time_near)(t, q, from)).collect();
            let stands_for = |(s, free): &(Vec<f64>, FreeJoints), q: &[f64]| {
                (0..q.len()).all(|k| free.contains(k) || wrapped(s[k] - q[k]).abs() < 1e-4)
            };
            let missing =
                set.iter().zip(&poses).filter(|(q, t)| !(case.inverse)(t, q).iter().any(|s| stands_for(s, q))).count();
            let [[median, most], [median_near, most_near]] = [summary(times), summary(near)];
            println!(
                "{:16} {name:20} inverse {median:8.2} us, at most {most:8.2} ({:5.0} S); near {median_near:6.2} us, at most {most_near:7.2} ({:4.0} S); missing {missing} of {}",
                case.name,
                most / unit,
                most_near / unit,
                set.len()
            );
        }
        let (jumps, paths) = case.jumps();
        println!("{:16} paths through singular poses: {jumps} of {paths} jump", case.name);
    }
}
