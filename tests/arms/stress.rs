//! A long run over random arms of all classes at random, special, singular and nearly singular poses, which counts what goes wrong.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::Range;

use dh_symbolic::planner::StepKind;
use dh_tests::sample::Random;

use super::classes::{CLASSES, table};
use super::compiled::{Compiled, Found};
use super::newton::Problem;

/// Distances from singular values.
const OFFSETS: [f64; 10] = [0.0, 1e-2, -1e-3, 1e-4, 1e-5, -1e-6, 1e-7, 1e-8, -1e-9, 1e-12];
/// Starts of the search for all solutions of a pose.
const STARTS: usize = 6;

/// What was counted.
#[derive(Default)]
pub(super) struct Tally {
    counts: BTreeMap<&'static str, usize>,
    verbose: bool,
}

impl Tally {
    fn count(&mut self, what: &'static str, text: impl FnOnce() -> String) {
        let n = self.counts.entry(what).or_default();
        *n += 1;
        if self.verbose && *n <= 400 {
            eprintln!("{what}: {}\n", text());
        }
    }
}

/// One pose of one arm.
struct Case<'a> {
    arm: &'a Compiled,
    problem: Problem<'a>,
    found: Found,
    name: String,
}

/// What a singular solution looks like from around it.
struct Around {
    /// Joints that move among the solutions nearby.
    moves: Vec<bool>,
}

impl Case<'_> {
    fn apart(&self, a: &[f64], b: &[f64]) -> f64 {
        (0..a.len()).map(|k| self.apart_at(k, a, b)).fold(0.0, f64::max)
    }

    fn apart_at(&self, k: usize, a: &[f64], b: &[f64]) -> f64 {
        let d = a[k] - b[k];
        if self.arm.slides[k] { d.abs() / self.problem.reach } else { (d - TAU * (d / TAU).round()).abs() }
    }

    fn margin(&self, q: &[f64]) -> f64 {
        self.problem.margin(q, &self.arm.slides)
    }

    fn unit(&self, k: usize) -> f64 {
        if self.arm.slides[k] { self.problem.reach } else { 1.0 }
    }

    /// The solutions near a singular one, and those near them, and so on.
    fn around(&self, q: &[f64], random: &mut Random) -> Around {
        let mut moves = vec![false; q.len()];
        let mut at = q.to_vec();
        let mut failed = 0;
        for _ in 0..60 {
            let start = |k: usize| {
                let free = !self.problem.frozen.contains(&k);
                at[k] + if free { 0.12 * self.unit(k) * random.signed() } else { 0.0 }
            };
            let landed = self.problem.solve((0..q.len()).map(start).collect());
            let Some(x) = landed.filter(|x| (0.02..0.3).contains(&self.apart(x, &at)) && self.margin(x) < 1e-5) else {
                failed += 1;
                if failed > 14 {
                    break;
                }
                continue;
            };
            (0..q.len()).for_each(|k| moves[k] |= self.apart_at(k, &x, q) > 0.01);
            at = x;
        }
        Around { moves }
    }

    /// Is a solution (regular, alone, or on a self-motion) among what was found?
    fn known(&self, q: &[f64], random: &mut Random, tally: &mut Tally) {
        let margin = self.margin(q);
        let near = self.found.q.iter().map(|s| self.apart(s, q)).fold(f64::INFINITY, f64::min);
        let text = |what: &str| {
            format!(
                "{what} {q:?} nearest {near:.1e} margin {margin:.1e} found {:?} {:?}\n{}",
                self.found.q, self.found.free, self.name
            )
        };
        if near < (1e-12 / margin).clamp(3e-6, 1e-2) {
            return;
        }
        if margin > 1e-4 {
            tally.count("missed regular", || text("regular"));
            return;
        }
        let covers = |(s, f): (&Vec<f64>, &dh_robot::FreeJoints)| {
            (0..q.len()).all(|k| f.contains(k) || self.apart_at(k, s, q) < 5e-3)
        };
        if self.found.q.iter().zip(&self.found.free).any(covers) {
            return;
        }
        let around = self.around(q, random);
        if !around.moves.contains(&true) {
            if near > 5e-3 {
                let what = if margin > 1e-7 { "missed nearly singular" } else { "missed singular" };
                tally.count(what, || text(what));
            }
            return;
        }
        let represents = |s: &Vec<f64>, free: &dyn Fn(usize) -> bool| {
            (0..q.len()).all(|k| around.moves[k] && free(k) || self.apart_at(k, s, q) < 5e-3)
        };
        let mut all = self.found.q.iter().zip(&self.found.free);
        if all.clone().any(|(s, f)| represents(s, &|k| f.contains(k))) {
            return;
        }
        if all.any(|(s, _)| represents(s, &|_| true)) {
            tally.count("free not named", || text(&format!("moves {:?}", around.moves)));
        } else {
            tally.count("self-motion missed", || text(&format!("moves {:?}", around.moves)));
        }
    }

    fn judge(&self, q: &[f64], random: &mut Random, tally: &mut Tally) {
        tally.count("poses", String::new);
        let Found { q: found, free, why } = &self.found;
        if found.is_empty() {
            tally.count("empty", || format!("{q:?} margin {:.1e} {why}\n{}", self.margin(q), self.name));
            return;
        }
        for (i, s) in found.iter().enumerate() {
            if s.iter().any(|x| !x.is_finite()) {
                tally.count("not a number", || format!("{s:?}\n{}", self.name));
                continue;
            }
            let miss = self.problem.miss(s);
            if miss > 1e-9 {
                tally.count("wrong", || format!("{q:?}: {s:?} misses by {miss:.1e}\n{}", self.name));
            } else if miss > 1e-11 {
                tally.count("inexact", || {
                    format!("{q:?}: {s:?} misses by {miss:.1e} margin {:.1e}\n{}", self.margin(s), self.name)
                });
            }
            for (j, other) in found[..i].iter().enumerate() {
                let d = self.apart(s, other);
                let middle = |t: f64| -> Vec<f64> {
                    (0..s.len())
                        .map(|k| {
                            let d = other[k] - s[k];
                            s[k] + t * if self.arm.slides[k] { d } else { d - TAU * (d / TAU).round() }
                        })
                        .collect()
                };
                let singular = || self.margin(q) < 1e-13 && self.apart(s, q) < 5e-3 && self.apart(other, q) < 5e-3;
                if d < 1e-6 || free[i].is_empty() && free[j].is_empty() && singular() {
                    tally.count("twice", || format!("{d:.1e} {s:?} {other:?} at {q:?} {:?}\n{}", &free[i], self.name));
                } else if d > 0.01 && [0.3, 0.5, 0.85].iter().all(|t| self.problem.miss(&middle(*t)) < 1e-9) {
                    tally.count("self-motion twice", || {
                        format!("{d:.1e} {s:?} {other:?} {:?}\n{}", &free[i], self.name)
                    });
                }
            }
            // Between the tolerance of the inverse and that of this search a motion is free to the one and not to the other.
            let margin = self.margin(s);
            if (1e-12..1e-6).contains(&margin) {
                continue;
            }
            if !free[i].is_empty() {
                if !self.around(s, random).moves.contains(&true) {
                    tally.count("free but alone", || {
                        format!("{q:?}: {s:?} {:?} {:.1e}\n{}", free[i], self.margin(s), self.name)
                    });
                }
            } else if margin < 1e-6 && self.around(s, random).moves.contains(&true) {
                tally.count("alone but free", || format!("{q:?}: {s:?}\n{}", self.name));
            }
        }
        self.known(q, random, tally);
        for _ in 0..STARTS {
            let start =
                |k: usize| if self.problem.frozen.contains(&k) { q[k] } else { PI * self.unit(k) * random.signed() };
            if let Some(x) = self.problem.solve((0..q.len()).map(start).collect()) {
                self.known(&x, random, tally);
            }
        }
    }
}

/// Joint values of many kinds.
fn poses(arm: &Compiled, reach: f64, count: usize, random: &mut Random) -> Vec<(String, Vec<f64>)> {
    let special = [0.0, FRAC_PI_2, -FRAC_PI_2, PI];
    let n = arm.slides.len();
    let mut all = Vec::new();
    let unit = |k: usize| if arm.slides[k] { reach } else { 1.0 };
    let any = |random: &mut Random| -> Vec<f64> {
        (0..n).map(|k| random.signed() * if arm.slides[k] { reach } else { PI }).collect()
    };
    let quarter = |k: usize, angle: bool, random: &mut Random| {
        let x = random.signed();
        if arm.slides[k] {
            (x * 4.0).round() / 4.0 * reach
        } else {
            special[((x + 1.0) * 2.0) as usize % 4] - if angle { arm.shifts[k] } else { 0.0 }
        }
    };
    for i in 0..count {
        let offset = OFFSETS[i % OFFSETS.len()];
        match i % 8 {
            0 => all.push(("random".to_string(), any(random))),
            // All special, in joint variables or in the table's angles; then beside that.
            1 | 2 => all.push(("special".into(), (0..n).map(|k| quarter(k, i % 8 == 1, random)).collect())),
            3 => {
                let q = (0..n).map(|k| quarter(k, true, random) + offset * unit(k) * random.signed());
                all.push((format!("beside special {offset:e}"), q.collect()));
            }
            4 => {
                let near = |k: usize, r: &mut Random| {
                    let o = OFFSETS[((r.signed() + 1.0) * 5.0) as usize % 10];
                    quarter(k, true, r) + o * unit(k)
                };
                all.push(("each beside special".into(), (0..n).map(|k| near(k, random)).collect()));
            }
            5 => {
                let mut q = any(random);
                for k in 0..n {
                    if random.signed() > -0.3 {
                        q[k] = quarter(k, true, random);
                    }
                }
                all.push(("mixed".into(), q));
            }
            _ => {
                let mut q = any(random);
                for k in 0..n {
                    if random.signed() > 0.4 {
                        q[k] = quarter(k, true, random);
                    }
                }
                let first = ((random.signed() + 1.0) * 0.5 * n as f64) as usize % n;
                let second =
                    (first + 1 + ((random.signed() + 1.0) * 0.5 * (n - 1) as f64) as usize % (n - 1).max(1)) % n;
                let mut name = "singular".to_string();
                let Some(x) = singular(arm, reach, &q, first, random) else { continue };
                if i % 8 == 7 && second != first {
                    // Off the first singularity there is a value of another joint for the second one.
                    q[first] = x + 0.4 * unit(first);
                    if let Some(y) = singular(arm, reach, &q, second, random) {
                        name += " twice";
                        q[second] =
                            y + OFFSETS[i / 8 % 10] * unit(second) * if random.signed() > 0.0 { 1.0 } else { 0.3 };
                    }
                }
                let offset = OFFSETS[(i / 8 + i / 80) % 10];
                q[first] = x + offset * unit(first);
                all.push((format!("{name} {offset:e}"), q));
            }
        }
    }
    all
}

/// A value of joint `k` at which the arm is singular.
fn singular(arm: &Compiled, reach: f64, q: &[f64], k: usize, random: &mut Random) -> Option<f64> {
    let target = arm.arm.pose(q);
    let problem =
        Problem { arm: &arm.arm, task: arm.spec.settings.task, target, reach, frozen: &arm.spec.settings.redundant };
    let range = if arm.slides[k] { reach } else { PI };
    let margin = |x: f64| {
        let mut q = q.to_vec();
        q[k] = x;
        let target = arm.arm.pose(&q);
        let problem = Problem { arm: &arm.arm, target, ..problem };
        problem.margin(&q, &arm.slides)
    };
    let at = |i: usize| range * (i as f64 / 24.0 - 1.0);
    let values: Vec<f64> = (0..48).map(|i| margin(at(i))).collect();
    let start = ((random.signed() + 1.0) * 24.0) as usize;
    for i in 0..48 {
        let i = (start + i) % 48;
        let (before, after) = (values[(i + 47) % 48], values[(i + 1) % 48]);
        if values[i] > before || values[i] > after || values[i] > 0.1 || before < 1e-9 || after < 1e-9 {
            continue;
        }
        let (mut a, mut b) = (at(i) - range / 24.0, at(i) + range / 24.0);
        for _ in 0..110 {
            let (x, y) = (b - 0.618_034 * (b - a), a + 0.618_034 * (b - a));
            if margin(x) < margin(y) { b = y } else { a = x }
        }
        let x = 0.5 * (a + b);
        if margin(x) < 1e-10 {
            return Some(x);
        }
    }
    None
}

/// Runs the seeds of the classes whose name contains `class`, and prints the counts of each.
pub(super) fn run(class: &str, seeds: Range<u64>, count: usize, verbose: bool) {
    let mut total = BTreeMap::<&str, usize>::new();
    for (index, name) in CLASSES.iter().enumerate().filter(|(_, c)| c.contains(class)) {
        let mut tally = Tally { verbose, ..Tally::default() };
        let clock = std::time::Instant::now();
        for seed in seeds.clone() {
            let mut random = Random::new(1000 * (index as u64 + 1) + seed);
            (0..20).for_each(|_| _ = random.signed());
            let text = table(name, &mut || random.signed());
            let Ok(arm) = Compiled::new(&text) else {
                tally.count("no plan", || text.clone());
                continue;
            };
            let general = arm.inverse.plan.steps.iter().any(|s| s.kind == StepKind::General);
            let reach = arm.inverse.plan.axes.length_scale;
            for (kind, q) in poses(&arm, reach, if general { count.div_ceil(4) } else { count }, &mut random) {
                let target = arm.arm.pose(&q);
                let problem = Problem {
                    arm: &arm.arm,
                    task: arm.spec.settings.task,
                    target,
                    reach,
                    frozen: &arm.spec.settings.redundant,
                };
                let found = arm.invert(&target, &q);
                let steps: Vec<_> = arm.inverse.plan.steps.iter().map(|s| format!("{:?}", s.kind)).collect();
                let name = format!("{name}, seed {seed}, {kind}, {}, {q:?}\n{text}", steps.join(" "));
                Case { arm: &arm, problem, found, name }.judge(&q, &mut random, &mut tally);
            }
        }
        let counts: Vec<String> = tally.counts.iter().map(|(k, n)| format!("{k} {n}")).collect();
        eprintln!("{name}: {} ({:.1} s)", counts.join(", "), clock.elapsed().as_secs_f64());
        tally.counts.iter().for_each(|(k, n)| *total.entry(k).or_default() += n);
    }
    eprintln!("{total:?}");
}
