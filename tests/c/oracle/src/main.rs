//! Makes cases for `check.c` (`cases ARM [time]`), and prints what the Rust functions give for cases on standard input (`ARM [with] [time]`).
//!
//! Shares nothing with the exported crates but the tables: results are taken apart here with nalgebra's own functions.

use dh_robot::nalgebra::{IsometryMatrix3, Matrix4, Point3, SMatrix, Unit, Vector3};
use dh_robot::{Real, Solution, Solutions, Why};
use std::io::{Read, Write};
use std::time::Instant;

mod arms {
    include!(concat!(env!("OUT_DIR"), "/arms.rs"));
}

/// What a task's target is, in numbers and in Rust's types.
trait Target<T>: Sized {
    /// How many numbers.
    const LENGTH: usize;
    fn read(numbers: &[T]) -> Result<Self, Why<T>>;
}

impl<T: Real> Target<T> for IsometryMatrix3<T> {
    const LENGTH: usize = 16;
    fn read(numbers: &[T]) -> Result<Self, Why<T>> {
        dh_robot::pose::from_matrix(&Matrix4::from_row_slice(numbers))
    }
}

impl<T: Real> Target<T> for Point3<T> {
    const LENGTH: usize = 3;
    fn read(numbers: &[T]) -> Result<Self, Why<T>> {
        Ok(Point3::from_slice(numbers))
    }
}

impl<T: Real> Target<T> for (T, T, T) {
    const LENGTH: usize = 3;
    fn read(n: &[T]) -> Result<Self, Why<T>> {
        Ok((n[0], n[1], n[2]))
    }
}

impl<T: Real> Target<T> for (Point3<T>, Unit<Vector3<T>>) {
    const LENGTH: usize = 6;
    fn read(n: &[T]) -> Result<Self, Why<T>> {
        Ok((Point3::from_slice(&n[..3]), Unit::new_unchecked(Vector3::from_column_slice(&n[3..]))))
    }
}

/// Numbers as their bits; all that are not numbers are one.
fn numbers<T: Real>(out: &mut impl Write, name: &str, list: impl IntoIterator<Item = T>) {
    write!(out, "{name}").unwrap();
    for x in list {
        let x = x.to_f64();
        if x.is_nan() { write!(out, " nan").unwrap() } else { write!(out, " {:016x}", x.to_bits()).unwrap() }
    }
    writeln!(out).unwrap();
}

fn rows<T: Real>(pose: &IsometryMatrix3<T>) -> Vec<T> {
    by_rows(&pose.to_homogeneous())
}

fn by_rows<T: Real, const R: usize, const C: usize>(m: &SMatrix<T, R, C>) -> Vec<T> {
    (0..R).flat_map(|i| (0..C).map(move |j| m[(i, j)])).collect()
}

fn solution<T: Real, const N: usize>(out: &mut impl Write, s: &Solution<T, N>) {
    numbers(out, "  q", s.q);
    let b = s.branch;
    let named = |name: Option<i32>| name.map_or(0, |k| k + 1);
    let first = b.step(0).map_or(-1, |k| k as i32);
    let free = s.free.iter().fold(0_u32, |bits, joint| bits | 1 << joint);
    writeln!(
        out,
        "  {:016x} {b}; {} {} {} {first}; free {free:x}",
        b.to_bits(),
        named(b.shoulder().map(|s| s as i32)),
        named(b.elbow().map(|s| s as i32)),
        named(b.wrist().map(|s| s as i32)),
    )
    .unwrap();
}

fn why<T: Real>(out: &mut impl Write, why: &Why<T>) {
    let code = match why {
        Why::Solved => 0,
        Why::NoSolution => 1,
        Why::NotFinite => 2,
        Why::NotARotation { .. } => 3,
        Why::NotAUnitVector { .. } => 4,
        Why::OutOfReach { .. } => 5,
        Why::NoRealRoot { .. } => 6,
        Why::NotOnTask { .. } => 7,
        Why::NotVerified { .. } => 8,
        Why::OutOfRange { .. } => 9,
        _ => -1,
    };
    writeln!(out, "  why {code}: {why}").unwrap();
}

fn solutions<T: Real, const N: usize, const M: usize>(out: &mut impl Write, name: &str, all: &Solutions<T, N, M>) {
    writeln!(out, "{name} {}", all.len()).unwrap();
    all.iter().for_each(|s| solution(out, s));
    why(out, &all.why());
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Random, right-angled and nearly right-angled joint values.
fn joint_values(random: &mut Random, case: usize, n: usize) -> Vec<f64> {
    let right = |random: &mut Random| (random.signed() * 2.5).round() * std::f64::consts::FRAC_PI_2;
    let one = |_| match case % 4 {
        0 | 1 => random.signed() * std::f64::consts::PI,
        2 => right(random),
        _ => right(random) + random.signed() * 1e-7,
    };
    (0..n).map(one).collect()
}

/// A target made bad in one of several ways.
fn spoil(target: &mut [f64], how: usize, random: &mut Random) {
    let last = target.len() - 1;
    match how {
        0 => target[0] = f64::NAN,
        1 => target[last] = f64::INFINITY,
        2 => target[0] = 1e300,
        3 => target[last] = -1e300,
        4 => target.iter_mut().for_each(|x| *x = 0.0),
        5 => target.iter_mut().take(3).for_each(|x| *x *= 1.01),
        6 => target.iter_mut().for_each(|x| *x = -*x),
        7 => target[last] += 1e-3,
        8 => target.iter_mut().skip(3).step_by(4).for_each(|x| *x *= 50.0),
        9 => target.iter_mut().take(3).for_each(|x| *x *= 50.0),
        10 => target[last] += 1e-9,
        11 => target.iter_mut().for_each(|x| *x = f64::from_bits(random.bits())),
        _ => target[last / 2] += 1e-8,
    }
}

macro_rules! arm {
    ($module:ident $name:ident $scalar:ident $n:literal $given:expr, [$($field:ident)*], $nominal:expr, $target:ty, $of_pose:expr, $solve:tt) => {
        mod $module {
            use super::*;
            use crate::arms::$module::$name as Arm;
            type F = $scalar;
            #[allow(dead_code)]
            type Goal = $target;
            const GIVEN: &[usize] = &$given;

            /// The nominal arm, or one with other parameters (those of `check.c`).
            #[allow(unused)]
            fn robot(with: bool) -> Arm {
                let (mut robot, mut k): (Arm, F) = ($nominal, 0.0);
                $(k += 1.0; if with { robot.$field += 0.0078125 * k; })*
                robot
            }

            /// Cases of every kind, or regular ones alone.
            pub fn cases(regular: bool) {
                let (robot, mut random) = (robot(false), Random(7));
                let mut out = std::io::stdout().lock();
                for case in 0..480 {
                    let mut q: Vec<f64> = joint_values(&mut random, if regular { 0 } else { case }, $n).iter().map(|x| f64::from(*x as F)).collect();
                    let short: [F; $n] = std::array::from_fn(|i| q[i] as F);
                    let m: Vec<F> = rows(&robot.forward(&short));
                    let of_pose: fn(&[F]) -> Vec<F> = $of_pose;
                    let mut target: Vec<f64> = of_pose(&m).iter().map(|x| f64::from(*x)).collect();
                    let given: Vec<f64> = GIVEN.iter().map(|k| q[*k]).collect();
                    if !regular && case >= 300 {
                        spoil(&mut target, case % 13, &mut random);
                    }
                    if !regular && case % 60 == 59 {
                        q[0] = f64::NAN;
                    }
                    let near = q.iter().map(|x| x + if case % 2 == 0 { 0.0 } else { 0.01 });
                    let all: Vec<f64> = near.chain(target).chain(given).collect();
                    let bits: Vec<String> = all.iter().map(|x| format!("{:016x}", x.to_bits())).collect();
                    writeln!(out, "{}", bits.join(" ")).unwrap();
                }
            }

            fn read() -> Vec<([F; $n], Vec<F>, Vec<F>)> {
                let mut text = String::new();
                std::io::stdin().read_to_string(&mut text).unwrap();
                text.lines()
                    .map(|line| {
                        let bits = line.split_whitespace().map(|w| f64::from_bits(u64::from_str_radix(w, 16).unwrap()) as F);
                        let all: Vec<F> = bits.collect();
                        let (q, rest) = all.split_at($n);
                        let (target, given) = rest.split_at(rest.len() - GIVEN.len());
                        (std::array::from_fn(|i| q[i]), target.to_vec(), given.to_vec())
                    })
                    .collect()
            }

            pub fn run(with: bool, time: bool) {
                let (robot, cases) = (robot(with), read());
                if time {
                    return times(&robot, &cases);
                }
                let mut out = std::io::BufWriter::new(std::io::stdout().lock());
                for (q, _, _) in &cases {
                    numbers(&mut out, "forward", rows(&robot.forward(q)));
                    numbers(&mut out, "frames", robot.frames(q).iter().flat_map(rows));
                    numbers(&mut out, "jacobian", by_rows(&robot.jacobian(q)));
                    let (pose, jacobian) = robot.forward_and_jacobian(q);
                    numbers(&mut out, "both", rows(&pose));
                    numbers(&mut out, "and", by_rows(&jacobian));
                    let inside = Arm::JOINTS.iter().zip(q).all(|(joint, x)| joint.contains(*x));
                    writeln!(out, "in range {}", u8::from(inside)).unwrap();
                }
                numbers(&mut out, "forward_batch", cases.iter().flat_map(|case| rows(&robot.forward(&case.0))));
                numbers(&mut out, "jacobian_batch", cases.iter().flat_map(|case| by_rows(&robot.jacobian(&case.0))));
                arm!(@inverse robot cases out $solve);
            }

            fn times(robot: &Arm, cases: &[([F; $n], Vec<F>, Vec<F>)]) {
                let q: Vec<[F; $n]> = cases.iter().map(|case| case.0).collect();
                let mut poses = vec![IsometryMatrix3::identity(); q.len()];
                let mut jacobians = vec![SMatrix::<F, 6, $n>::zeros(); q.len()];
                time("forward", q.len(), |i| poses[i] = std::hint::black_box(robot).forward(&q[i]));
                time("frames", q.len(), |i| { std::hint::black_box(std::hint::black_box(robot).frames(&q[i])); });
                time("jacobian", q.len(), |i| jacobians[i] = std::hint::black_box(robot).jacobian(&q[i]));
                time("forward_batch", q.len(), |i| if i == 0 { std::hint::black_box(robot).forward_batch(&q, &mut poses) });
                std::hint::black_box((&poses, &jacobians));
                arm!(@time robot cases $solve);
            }
        }
    };
    (@inverse $own:ident $cases:ident $out:ident []) => {};
    (@inverse $own:ident $cases:ident $out:ident [|$robot:ident, $t:ident, $g:ident, $q:ident| $inverse:expr, $near:expr]) => {
        let $robot = &$own;
        let mut batch = Vec::new();
        for ($q, target, $g) in &$cases {
            let _ = $g;
            let goal = Goal::read(&target[..Goal::LENGTH]);
            let all = match &goal {
                Ok($t) => $inverse,
                Err(why) => Solutions::none(&Arm::JOINTS, *why),
            };
            solutions(&mut $out, "inverse", &all);
            let near = match &goal { Ok($t) => $near, Err(why) => Err(*why) };
            writeln!($out, "near {}", u8::from(near.is_ok())).unwrap();
            match &near {
                Ok(found) => { solution(&mut $out, found); why(&mut $out, &Why::<F>::Solved) }
                Err(reason) => why(&mut $out, reason),
            }
            batch.push(all);
        }
        batch.iter().for_each(|all| solutions(&mut $out, "batch", all));
    };
    (@time $own:ident $cases:ident []) => {};
    (@time $own:ident $cases:ident [|$robot:ident, $t:ident, $g:ident, $q:ident| $inverse:expr, $near:expr]) => {
        // Rust's own form of the target, as a Rust program has it.
        let goals: Vec<_> = $cases.iter().map(|case| (Goal::read(&case.1), &case.2, &case.0)).collect();
        let $robot = std::hint::black_box($own);
        let mut into = Solutions::new(&Arm::JOINTS);
        time("inverse", goals.len(), |i| {
            let (goal, $g, $q) = &goals[i];
            if let Ok($t) = goal { into = $inverse; std::hint::black_box(&into); }
            let _ = ($g, $q);
        });
        time("near", goals.len(), |i| {
            let (goal, $g, $q) = &goals[i];
            if let Ok($t) = goal { _ = std::hint::black_box($near); }
            let _ = $g;
        });
    };
}

/// The least time of a call in some rounds over all cases, in nanoseconds.
fn time(name: &str, count: usize, mut call: impl FnMut(usize)) {
    let mut least = f64::INFINITY;
    for _ in 0..40 {
        let start = Instant::now();
        (0..count).for_each(&mut call);
        least = least.min(start.elapsed().as_nanos() as f64 / count as f64);
    }
    println!("{name} {least:.1}");
}

arm!(puma560 Puma560 f64 6 [], [a2 a3 d3 d4], Arm::default(), IsometryMatrix3<f64>, |m| m.to_vec(),
    [|robot, t, given, q| robot.inverse(t), robot.inverse_near(t, q)]);
arm!(ur5 Ur5 f64 6 [], [d1 a2 a3 d4 d5 d6], Arm::default(), IsometryMatrix3<f64>, |m| m.to_vec(),
    [|robot, t, given, q| robot.inverse(t), robot.inverse_near(t, q)]);
arm!(iiwa7 Iiwa7 f64 7 [2], [], Arm::default(), IsometryMatrix3<f64>, |m| m.to_vec(),
    [|robot, t, given, q| robot.inverse(t, given[0]), robot.inverse_near(t, given[0], q)]);
arm!(rail_arm RailArm f64 8 [0, 7], [], Arm::default(), IsometryMatrix3<f64>, |m| m.to_vec(),
    [|robot, t, given, q| robot.inverse(t, [given[0], given[1]]), robot.inverse_near(t, [given[0], given[1]], q)]);
arm!(planar3 Planar3 f64 3 [], [], Arm { l1: 0.25, long: 0.5, l3: 0.75 }, (f64, f64, f64), |m| vec![m[3], m[7], m[4].atan2(m[0])],
    [|robot, t, given, q| robot.inverse(*t), robot.inverse_near(*t, q)]);
arm!(wrist32 Wrist32 f32 6 [], [a2], Arm::default(), IsometryMatrix3<f32>, |m| m.to_vec(),
    [|robot, t, given, q| robot.inverse(t), robot.inverse_near(t, q)]);
arm!(slider Slider f64 3 [], [], Arm::default(), Point3<f64>, |m| vec![m[3], m[7], m[11]],
    [|robot, t, given, q| robot.inverse(t), robot.inverse_near(t, q)]);
arm!(youbot Youbot f64 5 [], [], Arm::default(), (Point3<f64>, Unit<Vector3<f64>>), |m| vec![m[3], m[7], m[11], m[2], m[6], m[10]],
    [|robot, t, given, q| robot.inverse(*t), robot.inverse_near(*t, q)]);
arm!(one_joint OneJoint f64 1 [], [], Arm::default(), Point3<f64>, |m| vec![m[3]],
    []);

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let has = |word: &str| words.iter().any(|w| w == word);
    let (with, clock) = (has("with"), has("time"));
    macro_rules! choose {
        ($($module:ident)*) => {
            $(if has(stringify!($module)) {
                return if has("cases") { $module::cases(clock) } else { $module::run(with, clock) };
            })*
        };
    }
    choose!(puma560 ur5 iiwa7 rail_arm planar3 wrist32 slider youbot one_joint);
    panic!("no such arm: {words:?}");
}
