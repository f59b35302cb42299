//! Numeric search at singular poses: solves neighbouring poses and walks back, or starts from many joint vectors.
//!
//! At a singular pose an elimination may lose its rank, and closed-form steps may find their angle free. Neither says that there is no
//! solution. What is found here is verified like everything else, but nothing proves that it is everything.

use super::elementary::{floor, sin_cos, sqrt};
use super::list::List;
use super::polish::{Kinematics, TaskTarget, polish, same_solution};
use super::pose::{IDENTITY, Pose, compose, turn};
use super::tolerance::REACHED;

/// Polishing steps from a neighbour, or from anywhere.
const STEPS: usize = 40;

/// Solves poses near `target` and hands on their solutions, to be polished onto `target` itself. `solve` also returns whether its
/// solutions are all there are; neighbours in further directions are only asked where those in the first one seldom know.
///
/// Solutions that are regular at `target` have exactly one neighbour each, and double ones have two on one of two opposite sides: so the
/// neighbours lie on both sides, at two distances.
pub fn solve_nearby<const N: usize, const R: usize>(
    target: &Pose,
    length_scale: f64,
    solve: impl Fn(&Pose) -> (List<[f64; N], R>, bool),
    mut found: impl FnMut([f64; N]),
) {
    let mut complete = 0;
    for direction in DIRECTIONS {
        for distance in [1e-3, -1e-3, 2e-5, -2e-5] {
            let (solutions, all) = solve(&displaced(target, length_scale, direction, distance));
            for &q in &solutions {
                found(q);
            }
            complete += usize::from(all);
        }
        if complete >= ENOUGH {
            return;
        }
    }
}

/// Neighbours that know all their solutions, at least, for a pose that doesn't.
const ENOUGH: usize = 2;

/// Directions (turns about z, x, y; ways along x, y, z) that nothing in an arm is parallel to.
const DIRECTIONS: [[f64; 6]; 3] = [
    [0.731, -0.459, 0.505, 0.536, -0.711, 0.455],
    [-0.387, -0.822, 0.418, -0.673, 0.349, 0.652],
    [0.618, 0.337, -0.711, 0.287, 0.583, -0.760],
];

/// A pose at a distance from `pose` in the first of the directions.
pub(crate) fn beside(pose: &Pose, length_scale: f64, distance: f64) -> Pose {
    displaced(pose, length_scale, DIRECTIONS[0], distance)
}

/// A pose near `pose`.
fn displaced(pose: &Pose, length_scale: f64, direction: [f64; 6], distance: f64) -> Pose {
    let [turns @ .., x, y, z] = direction;
    let mut small = IDENTITY;
    for (row, way) in small.iter_mut().zip([x, y, z]) {
        row[3] = way * distance * length_scale;
    }
    for angle in turns {
        let (s, c) = sin_cos(angle * distance);
        // About z; then the axes change places, and after three changes each of them was z.
        small = turn(&small, [c, s]).map(|[x, y, z, p]| [y, z, x, p]);
    }
    compose(pose, &small)
}

/// Looks for solutions of `task` from `starts` starting points that fill the joint space evenly, and adds what is new to `known`;
/// stops when `known` holds `enough`. `prismatic` marks the prismatic joints, whose starting points lie within `length_scale` on both sides of zero.
pub fn solve_from_everywhere<const N: usize, const R: usize>(
    arm: &impl Kinematics<N>,
    prismatic: &[bool; N],
    task: &TaskTarget,
    length_scale: f64,
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
            *q = centred * if prismatic[j] { length_scale } else { core::f64::consts::PI };
        }
        let reached = polish(arm, &mut q, task, length_scale, STEPS).reaches(REACHED);
        if reached {
            for (q, prismatic) in q.iter_mut().zip(prismatic) {
                if !prismatic {
                    *q = super::elementary::wrapped(*q);
                }
            }
            if !known.iter().any(|p| same_solution(arm, task, length_scale, p, &q)) {
                known.push(q);
            }
        }
    }
}
