//! Random arms of many classes, seeded: the inverse there and back at random and special poses, and complete beside a search from many
//! starts. Forward kinematics is the plain product throughout.

mod classes;
mod compiled;

mod newton;
mod once;
mod self_motions;
mod shrinking;
mod stress;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use classes::{CLASSES, table};
use compiled::{Compiled, Found};
use dh_symbolic::planner::StepKind;
use dh_tests::sample::Random;
use newton::Problem;

/// Tables of each class, and joint vectors of each table.
const ARMS: u64 = 3;
const POSES: usize = 6;
/// Starts of the search for every solution of one random pose of each arm.
const STARTS: usize = 30;
/// Singular values of the slopes below this: a singular pose, where solutions may be self-motions.
const SINGULAR: f64 = 1e-6;
/// Share of the poses whose own joint vector need not be told apart at higher singularities.
const UNTOLD: f64 = 0.01;

fn apart(arm: &Compiled, reach: f64, k: usize, a: f64, b: f64) -> f64 {
    let d = a - b;
    if arm.slides[k] { d.abs() / reach } else { (d - TAU * (d / TAU).round()).abs() }
}

/// The same joint values, up to whole turns?
fn same(arm: &Compiled, reach: f64, a: &[f64], b: &[f64], tolerance: f64) -> bool {
    (0..a.len()).all(|k| apart(arm, reach, k, a[k], b[k]) < tolerance)
}

/// Joint values: a third random, a third of multiples of 90 degrees, a third mixed.
fn joints(arm: &Compiled, reach: f64, kind: usize, random: &mut Random) -> Vec<f64> {
    let special = [0.0, FRAC_PI_2, -FRAC_PI_2, PI];
    let one = |slides: &bool| {
        let (x, y) = (random.signed(), random.signed());
        match (kind == 0 || kind == 2 && y > 0.0, slides) {
            (true, true) => x * reach,
            (true, false) => x * PI,
            (false, true) => (x * 4.0).round() / 4.0 * reach,
            (false, false) => special[((x + 1.0) * 2.0) as usize % 4],
        }
    };
    arm.slides.iter().map(one).collect()
}

struct Judge {
    poses: usize,
    untold: Vec<String>,
}

impl Judge {
    /// Everything that a solution set must be, seen from the joint values that made the pose.
    fn pose(&mut self, arm: &Compiled, problem: &Problem<'_>, q: &[f64], found: &Found, name: &str) {
        self.poses += 1;
        let reach = problem.reach;
        assert!(!found.q.is_empty(), "{name}: nothing found ({})", found.why);
        for (i, solution) in found.q.iter().enumerate() {
            assert!(problem.miss(solution) < 1e-8, "{name}: {solution:?} misses by {:.1e}", problem.miss(solution));
            assert!(
                !found.q[..i].iter().any(|other| same(arm, reach, solution, other, 1e-9)),
                "{name}: {solution:?} twice"
            );
            let regular = problem.margin(solution, &arm.slides) > 1e-4;
            assert!(!regular || found.free[i].is_empty(), "{name}: {solution:?} is regular, not free");
        }
        let margin = problem.margin(q, &arm.slides);
        if margin > SINGULAR {
            let tolerance = (1e-9 / margin).clamp(1e-6, 1e-2);
            let there = found.q.iter().any(|s| same(arm, reach, s, q, tolerance));
            assert!(there, "{name}: not among {:?}, margin {margin:.1e}", found.q);
        } else {
            let agrees = |(s, free): (&Vec<f64>, &dh_robot::FreeJoints)| {
                (0..q.len()).all(|k| free.contains(k) || apart(arm, reach, k, s[k], q[k]) < 1e-3)
            };
            if !found.q.iter().zip(&found.free).any(agrees) {
                self.untold.push(format!("{name}: {:?} {:?}", found.q, found.free));
            }
        }
    }
}

/// The search for all solutions: what it finds must have been found.
fn complete(arm: &Compiled, problem: &Problem<'_>, q: &[f64], found: &Found, random: &mut Random, name: &str) -> usize {
    let reach = problem.reach;
    let mut seen = 0;
    for _ in 0..STARTS {
        let mut start = joints(arm, reach, 0, random);
        for k in problem.frozen {
            start[*k] = q[*k];
        }
        let Some(x) = problem.solve(start) else { continue };
        let margin = problem.margin(&x, &arm.slides);
        if margin < 1e-4 {
            continue;
        }
        seen += 1;
        assert!(found.q.iter().any(|s| same(arm, reach, s, &x, 1e-5)), "{name}: {x:?} is missing, margin {margin:.1e}");
    }
    seen
}

/// One in `of` of the classes, so that the tests share the time.
fn classes(part: usize, of: usize) {
    let mut judge = Judge { poses: 0, untold: Vec::new() };
    let mut confirmed = 0;
    for (index, class) in CLASSES.iter().enumerate().filter(|(i, _)| i % of == part) {
        for seed in 0..ARMS {
            let mut random = Random::new(1000 * (index as u64 + 1) + seed);
            (0..20).for_each(|_| _ = random.signed());
            let text = table(class, &mut || random.signed());
            let arm = Compiled::new(&text).unwrap_or_else(|r| panic!("{class}: refused: {r:?}\n{text}"));
            let general = arm.inverse.plan.steps.iter().any(|s| s.kind == StepKind::General);
            let reach = arm.inverse.plan.axes.length_scale;
            // The general elimination takes its time in a build for tests.
            for pose in 0..if general { 2 } else { POSES } {
                let q = joints(&arm, reach, pose % 3, &mut random);
                let target = arm.arm.pose(&q);
                let name = format!("{class}, arm {seed}, {q:?}\n{text}");
                let frozen = &arm.spec.settings.redundant[..];
                let problem = Problem { arm: &arm.arm, task: arm.spec.settings.task, target, reach, frozen };
                let found = arm.invert(&target, &q);
                judge.pose(&arm, &problem, &q, &found, &name);
                if pose == 0 {
                    confirmed += complete(&arm, &problem, &q, &found, &mut random, &name);
                }
            }
        }
    }
    assert!(confirmed > 50, "the search from many starts found {confirmed} solutions only");
    let most = (UNTOLD * judge.poses as f64).ceil() as usize;
    assert!(judge.untold.len() <= most, "{} of {}: {}", judge.untold.len(), judge.poses, judge.untold.join("\n"));
}

#[test]
fn random_arms_are_inverted_completely_a() {
    classes(0, 2);
}

#[test]
fn random_arms_are_inverted_completely_b() {
    classes(1, 2);
}

/// Minutes in a release build: `cargo test --release -p dh-tests --test main a_long_run -- --ignored --nocapture`. `CLASS` (a part of a class name), `SEEDS` (`0..3`), `POSES` (40)
/// and `VERBOSE` choose.
#[test]
#[ignore = "counts instead of judging, and takes its time"]
fn a_long_run_over_all_classes() {
    let var = |name: &str| std::env::var(name).ok();
    let seeds =
        var("SEEDS").and_then(|s| s.split_once("..").map(|(a, b)| a.parse().unwrap_or(0)..b.parse().unwrap_or(3)));
    let poses = var("POSES").and_then(|p| p.parse().ok()).unwrap_or(40);
    stress::run(&var("CLASS").unwrap_or_default(), seeds.unwrap_or(0..3), poses, var("VERBOSE").is_some());
}
