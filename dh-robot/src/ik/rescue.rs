//! The last resort at degenerate poses: solve a neighbour and walk back, or look from many starting points.
//!
//! At a singular pose an elimination may lose its rank, and closed-form steps may find their angle free. Neither says that there is no
//! solution. What is found here is verified like everything else, but nothing proves that it is everything.

use super::list::List;
use super::math::{floor, sin_cos, sqrt};
use super::polish::{Kinematics, Task, polish, same_solution};
use super::pose::{IDENTITY, Pose, compose, turn};
use super::tolerance::REACHED;

/// Polishing steps from a neighbour, or from anywhere.
const STEPS: usize = 40;

/// Adds `q` to `known` if it can be polished onto `task` and is new there. Does it reach the task?
pub fn add_polished<const N: usize, const R: usize>(
    arm: &impl Kinematics<N>,
    task: &Task,
    reach: f64,
    mut q: [f64; N],
    steps: usize,
    known: &mut List<[f64; N], R>,
) -> bool {
    let reached = polish(arm, &mut q, task, reach, steps).reaches(REACHED);
    if reached && !known.iter().any(|p| same_solution(arm, task, reach, p, &q)) {
        known.push(q);
    }
    reached
}

/// Solves poses near `target` and polishes their solutions onto `target` itself; what is new goes to `known`.
///
/// Solutions that are regular at `target` have exactly one neighbour each, and double ones have two on one of two opposite sides: so the
/// neighbours lie on both sides, at two distances.
pub fn solve_nearby<const N: usize, const R: usize>(
    arm: &impl Kinematics<N>,
    target: &Pose,
    reach: f64,
    mut solve: impl FnMut(&Pose) -> List<[f64; N], R>,
    known: &mut List<[f64; N], R>,
) {
    let task = Task::Pose(*target);
    for distance in [1e-3, -1e-3, 2e-5, -2e-5] {
        for &q in &solve(&displaced(target, reach, distance)) {
            add_polished(arm, &task, reach, q, STEPS, known);
        }
    }
}

/// A pose near `pose`, in a direction that nothing in an arm is parallel to.
fn displaced(pose: &Pose, reach: f64, distance: f64) -> Pose {
    let mut small = IDENTITY;
    for (row, direction) in small.iter_mut().zip([0.536, -0.711, 0.455]) {
        row[3] = direction * distance * reach;
    }
    for angle in [0.731, -0.459, 0.505] {
        let (s, c) = sin_cos(angle * distance);
        // About z; then the axes change places, and after three changes each of them was z.
        small = turn(&small, [c, s]).map(|[x, y, z, p]| [y, z, x, p]);
    }
    compose(pose, &small)
}

/// Looks for solutions of `task` from `starts` starting points that fill the joint space evenly, and adds what is new to `known`;
/// stops when `known` holds `enough`. `slides` tells the prismatic joints, whose starting points lie within `reach` on both sides of zero.
pub fn solve_from_everywhere<const N: usize, const R: usize>(
    arm: &impl Kinematics<N>,
    slides: &[bool; N],
    task: &Task,
    reach: f64,
    starts: usize,
    enough: usize,
    known: &mut List<[f64; N], R>,
) {
    for k in 0..starts {
        if known.len() >= enough.min(R) {
            return;
        }
        let mut q = [0.0; N];
        for (j, q) in q.iter_mut().enumerate() {
            // Multiples of square roots of primes, modulo one: evenly distributed, and the same on every machine.
            let prime = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0][j % 8];
            let x = (k + 1) as f64 * sqrt(prime);
            let centred = 2.0 * (x - floor(x)) - 1.0;
            *q = centred * if slides[j] { reach } else { core::f64::consts::PI };
        }
        let reached = polish(arm, &mut q, task, reach, STEPS).reaches(REACHED);
        if reached {
            for (q, slides) in q.iter_mut().zip(slides) {
                if !slides {
                    *q = super::math::wrapped(*q);
                }
            }
            if !known.iter().any(|p| same_solution(arm, task, reach, p, &q)) {
                known.push(q);
            }
        }
    }
}
