//! Times the generated inverses against other crates in one run: `cargo run --release` in this folder; see the README.
//!
//! S is the time of six `f64::sin_cos` calls. Every repetition times S, the generated inverse and each peer one after the other
//! (CPU time of this process); a ratio is taken within the repetition, and the median over the repetitions is printed. So
//! the table says little about the machine, and other load on it does little harm.

mod arms;
#[cfg(feature = "ik-geo")]
mod ik_geo;
mod locked;
mod peer;
mod sets;

use std::hint::black_box;

use cpu_time::ProcessTime;
use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{ForwardKinematics, InverseKinematics, Jacobian};

use peer::{Answer, Peer};

/// A target pose.
pub type Pose = IsometryMatrix3<f64>;

/// Poses of a table of times, where a solver is fast.
const POSES: usize = 10_000;
/// Repetitions of which the median is taken.
const REPETITIONS: usize = 15;
/// Rotation entries and metres up to which an answer counts as a solution.
const EXACT: f64 = 1e-6;

/// What a robot needs to be in the tables.
pub trait Arm<const N: usize>:
    ForwardKinematics<N> + Jacobian<N> + InverseKinematics<N, Target = Pose>
{
}

impl<const N: usize, A> Arm<N> for A where
    A: ForwardKinematics<N> + Jacobian<N> + InverseKinematics<N, Target = Pose>
{
}

/// Uniform in [-1, 1), the same in every run (SplitMix64).
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2.0_f64.powi(-52) - 1.0
    }

    /// Joint values: angles in (-pi, pi), lengths in the joint's range; the one value of a joint that is locked.
    pub fn joints<const N: usize>(&mut self, robot: &impl ForwardKinematics<N>) -> [f64; N] {
        robot.joints().each_ref().map(|joint| match joint.range {
            Some((least, greatest)) if !joint.is_revolute() || least == greatest => {
                least + (greatest - least) * 0.5 * (self.uniform() + 1.0)
            }
            _ => self.uniform() * std::f64::consts::PI,
        })
    }
}

/// The generated inverse in the shape of a peer.
pub struct Ours<'a, R>(pub &'a R);

impl<R: Arm<N>, const N: usize> Peer<N> for Ours<'_, R> {
    fn name(&self) -> String {
        "generated".into()
    }

    fn pass(&self, targets: &[Pose]) -> f64 {
        let start = ProcessTime::now();
        for target in targets {
            black_box(&self.0.inverse(black_box(target)));
        }
        start.elapsed().as_secs_f64()
    }

    fn answers(&self, target: &Pose) -> Vec<Answer<N>> {
        self.0.inverse(target).iter().map(|s| Answer { q: s.q, claimed: true }).collect()
    }
}

/// How the answers of a solver to a set of targets are.
pub struct Quality {
    /// Distinct exact solutions of a pose, on average.
    pub solutions: f64,
    /// Poses without an exact solution.
    pub lost: usize,
    /// The worst error of anything given as a solution.
    pub worst: f64,
}

/// Puts the answers through forward kinematics.
pub fn quality<const N: usize>(robot: &impl ForwardKinematics<N>, peer: &dyn Peer<N>, targets: &[Pose]) -> Quality {
    let (mut count, mut lost, mut worst) = (0, 0, 0.0_f64);
    for target in targets {
        let mut exact: Vec<[f64; N]> = Vec::new();
        for answer in peer.answers(target) {
            let reached = robot.forward(&answer.q);
            let turned = (reached.rotation.matrix() - target.rotation.matrix()).abs().max();
            let error = turned.max((reached.translation.vector - target.translation.vector).abs().max());
            if answer.claimed {
                worst = worst.max(error);
            }
            let same = |known: &[f64; N]| {
                let mut pairs = robot.joints().iter().zip(known.iter().zip(&answer.q));
                pairs.all(|(joint, (a, b))| joint.difference(*a, *b) < 1e-6)
            };
            if error < EXACT && !exact.iter().any(same) {
                exact.push(answer.q);
            }
        }
        count += exact.len();
        lost += usize::from(exact.is_empty());
    }
    Quality { solutions: count as f64 / targets.len() as f64, lost, worst }
}

/// Seconds of six `sin_cos` calls for each of the angles.
fn baseline(angles: &[[f64; 6]]) -> f64 {
    let start = ProcessTime::now();
    for q in angles {
        black_box(black_box(q).map(f64::sin_cos));
    }
    start.elapsed().as_secs_f64()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The rows of one arm in the table of times.
fn times<R: Arm<N>, const N: usize>(title: &str, robot: &R, peers: &[Box<dyn Peer<N>>]) {
    let mut random = Random(7);
    let targets: Vec<Pose> = (0..POSES).map(|_| robot.forward(&random.joints(robot))).collect();
    let angles: Vec<[f64; 6]> =
        (0..POSES).map(|_| std::array::from_fn(|_| random.uniform() * std::f64::consts::PI)).collect();
    let ours = Ours(robot);
    let mut all: Vec<&dyn Peer<N>> = vec![&ours];
    all.extend(peers.iter().map(AsRef::as_ref));
    let mut ratios = vec![Vec::new(); all.len()];
    // Searches take milliseconds: fewer poses for them.
    let counts: Vec<usize> = all
        .iter()
        .map(|peer| {
            let each = peer.pass(&targets[..10]) / 10.0;
            ((0.1 / each) as usize).clamp(20, POSES)
        })
        .collect();
    for _ in 0..REPETITIONS {
        let s = baseline(&angles) / POSES as f64;
        for ((peer, count), ratios) in all.iter().zip(&counts).zip(&mut ratios) {
            ratios.push(peer.pass(&targets[..*count]) / *count as f64 / s);
        }
    }
    for ((peer, count), ratios) in all.iter().zip(counts).zip(ratios) {
        let Quality { solutions, lost, worst } = quality(robot, *peer, &targets[..count]);
        let x = median(ratios);
        let digits = if x < 100.0 { 2 } else { 0 };
        println!("| {title} | {} | {x:.digits$} | {solutions:.2} | {worst:.0e} | {lost} of {count} |", peer.name());
    }
}

fn main() {
    // A solver that panics has no answer there; the tables say so, one line per pose would not.
    std::panic::set_hook(Box::new(|_| ()));
    println!("| arm | solver | x S | solutions per pose | worst error | poses without a solution |");
    println!("|---|---|---:|---:|---:|---:|");
    arms::every(&mut Times);
    println!();
    println!("| arm | solver | {} |", sets::NAMES.join(" | "));
    println!("|---|---|{}", "---|".repeat(sets::NAMES.len()));
    arms::every(&mut sets::Singular);
}

/// Something to do with every arm.
pub trait Visit {
    /// One arm, the solvers of it, and where it is singular.
    fn arm<R: Arm<N>, const N: usize>(
        &mut self,
        title: &str,
        robot: &R,
        peers: &[Box<dyn Peer<N>>],
        singular: arms::Singular,
    );
}

struct Times;

impl Visit for Times {
    fn arm<R: Arm<N>, const N: usize>(
        &mut self,
        title: &str,
        robot: &R,
        peers: &[Box<dyn Peer<N>>],
        _: arms::Singular,
    ) {
        times(title, robot, peers);
    }
}
