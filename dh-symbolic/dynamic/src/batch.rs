//! Many poses at once: side by side in the lanes of the interpreter, and on all cores.

use std::thread;

use dh_robot::{Branch, FreeJoints, SolutionView, Why};

use crate::straight::{Straight, StraightNumbers};
use crate::{DynamicArm, Target};

/// Poses side by side.
const LANES: usize = 16;
/// Poses for which it is worth while to start a thread.
const PER_THREAD: usize = 256;

/// Solutions of many targets.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch {
    /// Joint values: target by target, `most` solutions each, not a number where there is none.
    pub q: Vec<f64>,
    /// The number of solutions of each target.
    pub count: Vec<u8>,
    /// Branch and free joints of each solution, in the order of `q`.
    pub names: Vec<(Branch, FreeJoints)>,
    /// The targets without a solution, in order, and why.
    pub refused: Vec<(usize, Why)>,
    /// Most solutions of a target.
    pub most: usize,
}

/// What one thread fills.
struct Part<'a> {
    start: usize,
    q: &'a mut [f64],
    count: &'a mut [u8],
    names: &'a mut [(Branch, FreeJoints)],
    refused: Vec<(usize, Why)>,
}

impl Part<'_> {
    /// Keeps a solution of a target, as long as there is room.
    fn keep(&mut self, (target, most): (usize, usize), solution: SolutionView<'_, f64>) {
        let k = usize::from(self.count[target]);
        if k < most {
            let place = target * most + k;
            let n = solution.q.len();
            self.q[place * n..(place + 1) * n].copy_from_slice(solution.q);
            self.names[place] = (solution.branch, solution.free);
            self.count[target] += 1;
        }
    }
}

/// How many threads are used: all cores if not said, never more than there is work for.
fn threads(asked: Option<usize>, poses: usize) -> usize {
    let useful = poses.div_ceil(PER_THREAD);
    if useful <= 1 {
        // Asking for the number of cores takes longer than a pose.
        return 1;
    }
    asked.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from)).clamp(1, useful)
}

impl DynamicArm {
    /// All solutions of `n` targets, on `threads` threads (all cores if `None`). `target` gives a target and the values of the joints that
    /// the caller chooses. Each target stands for itself: one that is not finite spoils its own result only.
    pub fn inverse_batch<'t>(
        &self,
        n: usize,
        target: impl Fn(usize) -> (Target, &'t [f64]) + Sync,
        threads: Option<usize>,
    ) -> Batch {
        let most = self.max_solutions();
        self.in_parts(n, most, threads, |part, length| {
            let Some((arm, solver)) = self.solving() else { return };
            let targets: Vec<(Target, &[f64])> = (part.start..part.start + length).map(&target).collect();
            let mut refused = Vec::new();
            let start = part.start;
            solver.batch(arm, &targets, &mut |i, solution| part.keep((i, most), solution), &mut |i, why| {
                refused.push((start + i, why));
            });
            part.refused = refused;
        })
    }

    /// [`inverse_near`](Self::inverse_near) of `n` targets: one solution each, that continues from the joint values that `target` gives last.
    pub fn inverse_near_batch<'t>(
        &self,
        n: usize,
        target: impl Fn(usize) -> (Target, &'t [f64], &'t [f64]) + Sync,
        threads: Option<usize>,
    ) -> Batch {
        self.in_parts(n, 1, threads, |part, length| {
            for i in 0..length {
                let (target, given, from) = target(part.start + i);
                let mut q = from.to_vec();
                match self.inverse_near(&target, given, &mut q) {
                    Ok((branch, free)) => part.keep((i, 1), SolutionView { q: &q, branch, free }),
                    Err(why) => part.refused.push((part.start + i, why)),
                }
            }
        })
    }

    fn in_parts(
        &self,
        n: usize,
        most: usize,
        asked: Option<usize>,
        work: impl Fn(&mut Part<'_>, usize) + Sync,
    ) -> Batch {
        let dof = self.dof();
        let mut batch = Batch {
            q: vec![f64::NAN; n * most * dof],
            count: vec![0; n],
            names: vec![(Branch::ANY, FreeJoints::NONE); n * most],
            refused: Vec::new(),
            most,
        };
        if n == 0 || most == 0 {
            return batch;
        }
        let each = n.div_ceil(threads(asked, n));
        let q = batch.q.chunks_mut(each * most * dof);
        let names = batch.names.chunks_mut(each * most);
        let parts = batch.count.chunks_mut(each).zip(q).zip(names).enumerate();
        let mut parts: Vec<Part<'_>> = parts
            .map(|(k, ((count, q), names))| Part { start: k * each, q, count, names, refused: Vec::new() })
            .collect();
        let run = |part: &mut Part<'_>| {
            let length = part.count.len();
            work(part, length);
        };
        match parts.as_mut_slice() {
            [one] => run(one),
            many => thread::scope(|scope| {
                for part in many {
                    scope.spawn(|| run(part));
                }
            }),
        }
        batch.refused = parts.into_iter().flat_map(|part| part.refused).collect();
        batch
    }

    /// The poses at joint values, a vector of joints after the other: 4x4 matrices by rows into `poses`.
    ///
    /// As many as the shorter slice holds; one that is not finite spoils its own result only.
    pub fn forward_batch(&self, q: &[f64], poses: &mut [f64], threads: Option<usize>) {
        let program = &self.model.pose;
        self.straight_batch(program, &self.numbers.pose, q, (poses, 16), threads, &|k| pose_entry(k, 0));
    }

    /// The poses of all link frames at joint values: for each vector of joints as many 4x4 matrices by rows as there are joints.
    ///
    /// As many as the shorter slice holds.
    pub fn frames_batch(&self, q: &[f64], frames: &mut [f64], threads: Option<usize>) {
        let rows: Vec<usize> = self.model.chain.joints.iter().map(|joint| 12 * joint.row).collect();
        let entry = |k: usize| pose_entry(k % 16, rows[k / 16]);
        self.straight_batch(&self.model.frames, &self.numbers.frames, q, (frames, 16 * self.dof()), threads, &entry);
    }

    /// The Jacobians at joint values, 6 rows with a column for each joint: three linear, then three angular velocities per joint speed, in
    /// base axes, at the origin of the last frame (or tool).
    ///
    /// As many as the shorter slice holds.
    pub fn jacobian_batch(&self, q: &[f64], jacobians: &mut [f64], threads: Option<usize>) {
        let n = self.dof();
        let entry = |k: usize| Entry::Output(12 + 6 * (k % n) + k / n);
        self.straight_batch(&self.model.jacobian, &self.numbers.jacobian, q, (jacobians, 6 * n), threads, &entry);
    }

    fn straight_batch(
        &self,
        program: &Straight,
        numbers: &StraightNumbers,
        q: &[f64],
        (out, size): (&mut [f64], usize),
        asked: Option<usize>,
        entry: &(dyn Fn(usize) -> Entry + Sync),
    ) {
        let dof = self.dof();
        let n = (q.len() / dof.max(1)).min(out.len() / size.max(1));
        if n == 0 {
            return;
        }
        let entries: Vec<Entry> = (0..size).map(entry).collect();
        let each = n.div_ceil(threads(asked, n));
        let run = |q: &[f64], out: &mut [f64]| {
            if q.len() == dof {
                self.lanes::<1>(program, numbers, (q, out), &entries);
            } else {
                self.lanes::<LANES>(program, numbers, (q, out), &entries);
            }
        };
        let parts = q[..n * dof].chunks(each * dof).zip(out[..n * size].chunks_mut(each * size));
        if each == n {
            parts.for_each(|(q, out)| run(q, out));
        } else {
            thread::scope(|scope| {
                for (q, out) in parts {
                    scope.spawn(|| run(q, out));
                }
            });
        }
    }

    fn lanes<const L: usize>(
        &self,
        program: &Straight,
        numbers: &StraightNumbers,
        (q, out): (&[f64], &mut [f64]),
        entries: &[Entry],
    ) {
        let (dof, size) = (self.dof(), entries.len());
        let mut x = program.space::<L>(numbers);
        let mut lanes = vec![[0.0; L]; dof];
        for (q, out) in q.chunks(L * dof).zip(out.chunks_mut(L * size)) {
            for (lane, q) in q.chunks(dof).enumerate() {
                for (to, q) in lanes.iter_mut().zip(q) {
                    to[lane] = *q;
                }
            }
            program.run(numbers, &self.numbers.coordinates.at(&lanes), &mut x);
            for (k, entry) in entries.iter().enumerate() {
                let values = match entry {
                    Entry::Output(i) => program.output(*i, &x),
                    Entry::Constant(value) => [*value; L],
                };
                for (out, value) in out.chunks_mut(size).zip(values) {
                    out[k] = value;
                }
            }
        }
    }
}

/// An entry of a matrix: an output of a program, or always the same.
#[derive(Clone, Copy)]
enum Entry {
    Output(usize),
    Constant(f64),
}

/// Entry number `k` of a 4x4 matrix by rows, whose columns are outputs from `first` on.
fn pose_entry(k: usize, first: usize) -> Entry {
    match (k / 4, k % 4) {
        (3, 3) => Entry::Constant(1.0),
        (3, _) => Entry::Constant(0.0),
        (i, j) => Entry::Output(first + 3 * j + i),
    }
}
