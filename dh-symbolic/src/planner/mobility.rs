//! Mobility of an arm: the rank of its task Jacobian, and the dimension of the displacement group that its joints generate.

use super::axes::Axes;
use super::pool::rates;
use super::sample::joint_vectors;
use super::subspace::Subspace;
use crate::chain::{Chain, Task};
use dh_kernels::pose::{self, Pose};
use dh_kernels::vector::cross;

/// Ranks at a generic configuration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// Dimensions of the task.
    pub task: usize,
    /// Dimensions that the arm's joints move the tool through: fewer than its joints where it is singular everywhere.
    pub rank: usize,
    /// Dimensions that the smallest group of motions holding all its joints moves the tool through: 4 for the pose of a SCARA, 2 for the
    /// position of a planar arm.
    pub orbit: usize,
}

/// Angular and linear velocity at the origin, in base axes.
type Twist = [f64; 6];

impl Mobility {
    /// Measures an arm.
    pub fn new(chain: &Chain, axes: &Axes) -> Mobility {
        let chosen: Vec<usize> = chain.chosen().into_iter().map(|(k, _)| k).collect();
        Mobility::of_joints(chain, axes, &chosen)
    }

    /// Measures an arm some of whose joints are fixed.
    pub(super) fn of_joints(chain: &Chain, axes: &Axes, still: &[usize]) -> Mobility {
        let x = joint_vectors(axes, 1, 0).pop().unwrap_or_default();
        let twists: Vec<Twist> = rates(axes, &x)
            .into_iter()
            .enumerate()
            .filter(|(k, _)| *k < axes.real && !still.contains(k))
            .map(|(_, s)| [s[2][1], s[0][2], s[1][0], s[0][3], s[1][3], s[2][3]])
            .collect();
        let mut tool = *axes.frames_number(&x).last().unwrap_or(&pose::IDENTITY);
        if chain.settings.task == Task::Pose {
            tool = pose::compose(&tool, &super::numeric(chain, &axes.end, axes.length_scale));
        }
        let rank = |twists: &[Twist]| {
            let mut span = Subspace::default();
            twists.iter().filter(|t| span.add(&seen(chain.settings.task, t, &tool))).count()
        };
        let task = match chain.settings.task {
            Task::Pose => 6,
            Task::Position | Task::Planar => 3,
            Task::Axis => 5,
        };
        Mobility { task, rank: rank(&twists), orbit: rank(&algebra(&twists)) }
    }

    /// Whether every neighbourhood of a reachable pose contains unreachable ones.
    pub fn misses_its_task(&self) -> bool {
        self.rank < self.task
    }

    /// Whether different configurations may reach the same pose at some poses only, where sheets of the reachable set cross.
    pub fn has_crossings(&self) -> bool {
        self.rank < self.orbit
    }
}

/// A basis of the smallest space of twists that holds these and with any two their commutator.
fn algebra(twists: &[Twist]) -> Vec<Twist> {
    let mut span = Subspace::default();
    let mut basis: Vec<Twist> = twists.iter().filter(|t| span.add(&t[..])).copied().collect();
    let mut next = 0;
    while next < basis.len() {
        for i in 0..next {
            let c = commutator(&basis[i], &basis[next]);
            let size = c.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            if size > 1e-6 && span.add(&c.map(|x| x / size)) {
                basis.push(c.map(|x| x / size));
            }
        }
        next += 1;
    }
    basis
}

fn commutator(a: &Twist, b: &Twist) -> Twist {
    let (w, v) = ([a[0], a[1], a[2]], [a[3], a[4], a[5]]);
    let (x, u) = ([b[0], b[1], b[2]], [b[3], b[4], b[5]]);
    let (wx, wu, vx) = (cross(w, x), cross(w, u), cross(v, x));
    [wx[0], wx[1], wx[2], wu[0] + vx[0], wu[1] + vx[1], wu[2] + vx[2]]
}

/// What the task sees of a twist of the tool.
fn seen(task: Task, t: &Twist, tool: &Pose) -> Vec<f64> {
    let w = [t[0], t[1], t[2]];
    let p = cross(w, [tool[0][3], tool[1][3], tool[2][3]]);
    let v = [t[3] + p[0], t[4] + p[1], t[5] + p[2]];
    let z = cross(w, [tool[0][2], tool[1][2], tool[2][2]]);
    match task {
        Task::Pose => [v, w].concat(),
        Task::Position => v.to_vec(),
        Task::Axis => [v, z].concat(),
        Task::Planar => vec![v[0], v[1], w[2]],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    fn mobility(rows: &[(i64, &str, &str, i64)], task: Task) -> (usize, usize, usize) {
        let mut chain = revolute_chain(Convention::Standard, rows);
        chain.settings.task = task;
        let m = Mobility::new(&chain, &Axes::new(&chain));
        (m.task, m.rank, m.orbit)
    }

    #[test]
    fn ranks_of_simple_arms() {
        let planar = [(0, "1", "0", 0), (0, "0.8", "0", 0), (0, "0.5", "0", 0)];
        assert_eq!(mobility(&planar[..2], Task::Position), (3, 2, 2));
        assert_eq!(mobility(&planar[..2], Task::Pose), (6, 2, 3));
        assert_eq!(mobility(&planar, Task::Pose), (6, 3, 3));
        assert_eq!(mobility(&planar, Task::Planar), (3, 3, 3));
        let elbow = [(90, "0", "0.4", 0), (0, "0.4", "0", 0), (0, "0.3", "0", 0)];
        assert_eq!(mobility(&elbow, Task::Position), (3, 3, 3));
        assert_eq!(mobility(&elbow, Task::Pose), (6, 3, 6));
        let wrist = [(90, "0", "0", 0), (-90, "0", "0", 0), (0, "0", "0.1", 0), (0, "0", "0", 0)];
        assert_eq!(mobility(&wrist, Task::Pose), (6, 3, 3), "the last two joints are one");
        let five = [(90, "0", "0.3", 0), (0, "0.4", "0", 0), (0, "0.3", "0", 0), (90, "0", "0", 0), (0, "0", "0.2", 0)];
        assert_eq!(mobility(&five, Task::Axis), (5, 4, 5), "the last joint turns about the tool's axis");
        assert_eq!(mobility(&five, Task::Pose), (6, 5, 6));
    }
}
