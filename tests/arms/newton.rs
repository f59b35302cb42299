//! A second opinion on solution sets: damped Newton steps from many starts, on the plain product of matrices. It shares nothing with
//! the planner, the kernels or the driver.

use dh_symbolic::chain::Task;
use dh_tests::naive::{Arm, Matrix};

/// What a solver needs to know beside the arm.
pub(super) struct Problem<'a> {
    pub(super) arm: &'a Arm,
    pub(super) task: Task,
    pub(super) target: Matrix,
    pub(super) reach: f64,
    /// The joints whose values are given.
    pub(super) frozen: &'a [usize],
}

impl Problem<'_> {
    /// Differences to the target that the task asks for, entry by entry, and their slopes by the joints.
    fn rows(&self, q: &[f64]) -> Vec<(f64, Vec<f64>)> {
        let (pose, columns) = (self.arm.pose(q), self.arm.jacobian_from_axes(q));
        let mut rows = Vec::new();
        let mut add = |i: usize, j: usize| {
            let slope = |(k, c): (usize, &[f64; 6])| {
                if self.frozen.contains(&k) {
                    return 0.0;
                }
                let (a, b) = ((i + 1) % 3, (i + 2) % 3);
                if j == 3 { c[i] / self.reach } else { c[3 + a] * pose[b][j] - c[3 + b] * pose[a][j] }
            };
            let scale = if j == 3 { self.reach } else { 1.0 };
            rows.push(((self.target[i][j] - pose[i][j]) / scale, columns.iter().enumerate().map(slope).collect()));
        };
        for i in 0..3 {
            match self.task {
                Task::Pose => (0..4).for_each(|j| add(i, j)),
                Task::Position => add(i, 3),
                Task::Axis => [2, 3].into_iter().for_each(|j| add(i, j)),
                Task::Planar => {
                    if i < 2 {
                        [0, 1, 3].into_iter().for_each(|j| add(i, j));
                    }
                }
            }
        }
        rows
    }

    /// The largest difference.
    pub(super) fn miss(&self, q: &[f64]) -> f64 {
        self.rows(q).iter().fold(0.0, |m, r| if r.0.abs() <= m { m } else { r.0.abs() })
    }

    /// The normal matrix of the slopes, slides measured in reaches.
    fn normal(&self, rows: &[(f64, Vec<f64>)], n: usize) -> Vec<Vec<f64>> {
        (0..n).map(|a| (0..n).map(|b| rows.iter().map(|r| r.1[a] * r.1[b]).sum()).collect()).collect()
    }

    /// The smallest singular value of the slopes: zero at singular poses.
    pub(super) fn margin(&self, q: &[f64], slides: &[bool]) -> f64 {
        let mut rows = self.rows(q);
        for row in &mut rows {
            for (x, slides) in row.1.iter_mut().zip(slides) {
                *x *= if *slides { self.reach } else { 1.0 };
            }
        }
        let free: Vec<usize> = (0..q.len()).filter(|k| !self.frozen.contains(k)).collect();
        for row in &mut rows {
            row.1 = free.iter().map(|k| row.1[*k]).collect();
        }
        least_singular_value(rows.into_iter().map(|r| r.1).collect(), free.len())
    }

    /// Walks to a solution, or nowhere.
    pub(super) fn solve(&self, mut q: Vec<f64>) -> Option<Vec<f64>> {
        let n = q.len();
        let square = |rows: &[(f64, Vec<f64>)]| rows.iter().map(|r| r.0 * r.0).sum::<f64>();
        let mut damping = 1e-2;
        let mut rows = self.rows(&q);
        for _ in 0..60 {
            let now = square(&rows);
            if now < 1e-24 {
                return Some(q);
            }
            let mut m = self.normal(&rows, n);
            for (k, row) in m.iter_mut().enumerate() {
                row[k] += damping * now.max(1e-16) + 1e-14;
            }
            let right: Vec<f64> = (0..n).map(|k| rows.iter().map(|r| r.1[k] * r.0).sum()).collect();
            let step = gauss(m, right);
            let next: Vec<f64> = q.iter().zip(&step).map(|(x, d)| x + d).collect();
            let there = self.rows(&next);
            if square(&there) < now {
                (q, rows, damping) = (next, there, damping * 0.2);
            } else {
                damping = (damping * 8.0).max(1e-6);
            }
        }
        None
    }
}

/// Solves a symmetric positive system by elimination.
fn gauss(mut m: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        for i in k + 1..n {
            let f = m[i][k] / m[k][k];
            for j in k..n {
                m[i][j] -= f * m[k][j];
            }
            b[i] -= f * b[k];
        }
    }
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| m[k][j] * b[j]).sum();
        b[k] = (b[k] - sum) / m[k][k];
    }
    b
}

/// The smallest singular value of a matrix of `n` columns, by one-sided rotations (Hestenes, 1958), which square nothing.
fn least_singular_value(mut m: Vec<Vec<f64>>, n: usize) -> f64 {
    let dot = |m: &[Vec<f64>], p: usize, q: usize| m.iter().map(|row| row[p] * row[q]).sum::<f64>();
    for _ in 0..30 {
        let mut turned = false;
        for p in 0..n {
            for q in p + 1..n {
                let (a, b, c) = (dot(&m, p, p), dot(&m, q, q), dot(&m, p, q));
                if c.abs() <= 1e-16 * (a * b).sqrt() || c.abs() < 1e-300 {
                    continue;
                }
                turned = true;
                let zeta = (b - a) / (2.0 * c);
                let t = 1f64.copysign(zeta) / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
                let cos = 1.0 / (1.0 + t * t).sqrt();
                for row in &mut m {
                    let (x, y) = (row[p], row[q]);
                    (row[p], row[q]) = (cos * (x - t * y), cos * (t * x + y));
                }
            }
        }
        if !turned {
            break;
        }
    }
    (0..n).map(|k| dot(&m, k, k).sqrt()).fold(f64::INFINITY, f64::min)
}
