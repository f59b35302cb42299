//! Targets near singular configurations: how many each solver loses, how wrong its answers are, and how long it takes.

use std::f64::consts::PI;

use crate::arms::Singular as At;
use crate::peer::Peer;
use crate::{Arm, Ours, Pose, Quality, Random, Visit, baseline, median, quality};

/// How far the joint is from its singular value, in radians.
const OFFSETS: [f64; 4] = [0.0, 1e-9, 1e-6, 1e-3];
/// Heads of the columns.
pub const NAMES: [&str; 8] =
    ["wrist 0", "wrist 1e-9", "wrist 1e-6", "wrist 1e-3", "elbow 0", "elbow 1e-9", "elbow 1e-6", "elbow 1e-3"];
/// Poses of a set.
const POSES: usize = 1000;

/// Poses that are timed, and repetitions of which the median is taken.
const TIMED: usize = 100;
const REPETITIONS: usize = 5;

/// Time of a pose on average, in S.
fn time<const N: usize>(peer: &dyn Peer<N>, targets: &[Pose], random: &mut Random) -> f64 {
    let angles: Vec<[f64; 6]> = (0..10_000).map(|_| std::array::from_fn(|_| random.uniform() * PI)).collect();
    let ratio = |_| peer.pass(targets) / targets.len() as f64 / (baseline(&angles) / angles.len() as f64);
    median((0..REPETITIONS).map(ratio).collect())
}

/// Prints the rows of the second table: `lost / solutions per pose / worst error / time in S`.
pub struct Singular;

impl Visit for Singular {
    fn arm<R: Arm<N>, const N: usize>(
        &mut self,
        title: &str,
        robot: &R,
        peers: &[Box<dyn Peer<N>>],
        singular: At,
    ) {
        if singular == [None; 2] {
            return;
        }
        let ours = Ours(robot);
        let mut all: Vec<&dyn Peer<N>> = vec![&ours];
        all.extend(peers.iter().map(AsRef::as_ref));
        for peer in all {
            let mut cells = Vec::new();
            for place in singular {
                let Some((joint, value)) = place else {
                    cells.extend(vec!["-".to_string(); OFFSETS.len()]);
                    continue;
                };
                for offset in OFFSETS {
                    let mut random = Random(11);
                    let targets: Vec<Pose> = (0..POSES)
                        .map(|_| {
                            let mut q = random.joints(robot);
                            // Both ways of being straight: the singular value, and half a turn from it.
                            let other = random.uniform() < 0.0 && joint == 4;
                            q[joint] = value + offset + if other { PI } else { 0.0 };
                            robot.forward(&q)
                        })
                        .collect();
                    let Quality { solutions, lost, worst } = quality(robot, peer, &targets);
                    let time = time(peer, &targets[..TIMED], &mut random);
                    cells.push(format!("{lost} / {solutions:.2} / {worst:.0e} / {time:.0}"));
                }
            }
            println!("| {title} | {} | {} |", peer.name(), cells.join(" | "));
        }
    }
}
