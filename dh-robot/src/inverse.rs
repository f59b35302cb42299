//! What every generated inverse shares: candidates in, verified solutions out.
//!
//! A candidate is put through forward kinematics; one that misses the target by more than rounding is polished; one that still
//! misses is dropped. Where the closed form degenerates at a pose and nothing is left, nearby poses are solved and their solutions
//! moved onto the target.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

use crate::ik::{Kinematics, Outcome, Pose, Task, polish, pose};
use crate::{Branch, FreeJoints, Joint, Real, Solution, Solutions, Why};

/// Residual (position over reach, rotation in rad) up to which a candidate is taken as it is: rounding of a chain of seven links.
const EXACT: f64 = 1e-13;
/// Residual up to which a polished candidate is a solution.
const REACHED: f64 = 1e-10;
/// The same for arms with fewer joints than the task has dimensions: their targets are rounded off what the arm can do.
const REACHED_FEW: f64 = 1e-9;
/// The same for `f32`, whose targets are rounded to 6e-8.
const REACHED_SINGLE: f64 = 2e-6;
/// Joint vectors nearer than this in every joint are one solution (rad, or table units over reach).
const SAME: f64 = 1e-6;

/// What the closed form reports beside its candidates.
#[derive(Clone, Copy, Debug)]
pub struct Attempt {
    /// Some step left its unknown free.
    pub degenerate: bool,
    why: Why<f64>,
}

impl Default for Attempt {
    fn default() -> Self {
        Attempt::new()
    }
}

impl Attempt {
    /// Nothing to report.
    #[inline]
    #[must_use]
    pub fn new() -> Self {
        Attempt { degenerate: false, why: Why::NoSolution }
    }

    /// Notes how a step without roots ended. `scale` turns the numbers of its equation into `unit`.
    #[cold]
    pub fn note(&mut self, outcome: Outcome, step: &'static str, scale: f64, unit: &'static str) {
        match outcome {
            Outcome::OutOfReach { needed, available } => {
                let why = Why::OutOfReach { step, needs: needed * scale, has: available * scale, unit };
                self.why = self.why.or_nearer(why);
            }
            Outcome::NoRealRoot => self.why = self.why.or_nearer(Why::NoRealRoot { step }),
            Outcome::Free => self.degenerate = true,
            Outcome::Regular | Outcome::Touching => {}
        }
    }

    /// The same for a law of cosines `square - constant = a cos u + b sin u`, where `square` is a squared distance and `rest` the left side,
    /// in units of the reach: reports distances.
    #[cold]
    pub fn note_distance(&mut self, outcome: Outcome, step: &'static str, square: f64, rest: f64, reach: f64, unit: &'static str) {
        let Outcome::OutOfReach { available, .. } = outcome else { return self.note(outcome, step, 1.0, unit) };
        let limit = (square - rest + if rest > 0.0 { available } else { -available }).max(0.0);
        let (needs, has) = (crate::math::sqrt(square) * reach, crate::math::sqrt(limit) * reach);
        self.why = self.why.or_nearer(Why::OutOfReach { step, needs, has, unit });
    }
}

/// What a generated inverse knows of its arm.
#[derive(Clone, Copy, Debug)]
pub struct Setting<T: 'static, const N: usize> {
    /// The joints.
    pub joints: &'static [Joint<T>; N],
    /// Sum of the link lengths, in table units.
    pub reach: f64,
    /// Fewer joints than the task has dimensions?
    pub few: bool,
}

/// Runs the closed form on a target and verifies what it finds.
///
/// `frame` is the target with lengths over the reach, `task` what of it counts. `candidates` calls its second argument with every
/// candidate: joint values in table units, branch, joints left free.
pub fn solve<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &Task,
    frame: &Pose,
    candidates: impl Fn(&Pose, &mut dyn FnMut([f64; N], Branch, FreeJoints)) -> Attempt,
) -> Solutions<T, N, M> {
    let tolerance = if T::EPSILON > T::of(1e-10) {
        REACHED_SINGLE
    } else if setting.few {
        REACHED_FEW
    } else {
        REACHED
    };
    let mut out = Solutions::<T, N, M>::new(setting.joints);
    let mut nearest = f64::INFINITY;
    let mut count = 0_usize;
    let attempt = candidates(frame, &mut |q, branch, free| {
        count += 1;
        let miss = accept(arm, setting, task, q, branch, free, tolerance, &mut out);
        nearest = nearest.min(miss);
    });
    if out.is_empty() && (attempt.degenerate || count > 0) {
        rescue(arm, setting, task, frame, &candidates, tolerance, &mut out);
    }
    if out.is_empty() {
        out.refuse(convert(attempt.why));
        if nearest.is_finite() {
            let by = T::of(nearest);
            out.refuse(if setting.few {
                Why::NotOnTask { what: "the arm's joints", by, unit: "" }
            } else {
                Why::NotVerified { error: by }
            });
        }
    }
    out
}

fn convert<T: Real>(why: Why<f64>) -> Why<T> {
    match why {
        Why::OutOfReach { step, needs, has, unit } => {
            Why::OutOfReach { step, needs: T::of(needs), has: T::of(has), unit }
        }
        Why::NoRealRoot { step } => Why::NoRealRoot { step },
        _ => Why::NoSolution,
    }
}

/// Verifies one candidate; gives back by how much it misses.
#[inline]
#[allow(clippy::too_many_arguments)] // one call, in this file
fn accept<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &Task,
    mut q: [f64; N],
    branch: Branch,
    free: FreeJoints,
    tolerance: f64,
    out: &mut Solutions<T, N, M>,
) -> f64 {
    let norm = |e: [f64; 6]| e.iter().fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() });
    let mut miss = norm(task.error(&arm.forward(&q), setting.reach));
    if !(miss <= EXACT) {
        if !(miss < 0.5) {
            return miss;
        }
        let polished = polish(arm, &mut q, task, setting.reach, 12);
        miss = polished.position.max(polished.rotation);
        if !polished.reaches(tolerance) {
            return miss;
        }
    }
    let free = if free.is_empty() { free } else { moving(arm, &q, setting.reach, free) };
    let solution = Solution::new(q.map(T::of), branch).with_free(free);
    out.insert(solution, T::of(SAME));
    miss
}

/// The joints that take part in the motions which leave the pose as it is.
#[cold]
fn moving<const N: usize>(arm: &impl Kinematics<N>, q: &[f64; N], reach: f64, found: FreeJoints) -> FreeJoints {
    // Gauss-Jordan with full pivoting; columns without a pivot span the motions that do nothing.
    let (_, mut j) = arm.forward_and_jacobian(q);
    for row in &mut j[..3] {
        for x in row.iter_mut() {
            *x /= reach;
        }
    }
    let mut pivot = [usize::MAX; 6];
    for r in 0..6 {
        let mut best = (0.0, 0, 0);
        for (i, row) in j.iter().enumerate().skip(r) {
            for (k, x) in row.iter().enumerate() {
                if x.abs() > best.0 && !pivot.contains(&k) {
                    best = (x.abs(), i, k);
                }
            }
        }
        let (size, i, k) = best;
        if size < 1e-7 {
            break;
        }
        j.swap(r, i);
        pivot[r] = k;
        let lead = j[r];
        for (i, row) in j.iter_mut().enumerate() {
            let factor = row[k] / lead[k];
            if i != r && factor != 0.0 {
                for (x, y) in row.iter_mut().zip(&lead) {
                    *x -= factor * y;
                }
            }
        }
    }
    let mut free = FreeJoints::NONE;
    for k in (0..N).filter(|k| !pivot.contains(k)) {
        // A joint that moves nothing because it is given does not count as free.
        let alone = pivot.iter().zip(&j).all(|(p, row)| *p == usize::MAX || row[k].abs() < 1e-6);
        if !alone || found.contains(k) {
            free = free.with(k);
        }
        for (p, row) in pivot.iter().zip(&j) {
            if *p != usize::MAX && row[k].abs() > 1e-6 {
                free = free.with(*p);
            }
        }
    }
    if free.is_empty() { found } else { free }
}

/// Solves poses near the target and moves their solutions onto it.
#[cold]
fn rescue<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &Task,
    frame: &Pose,
    candidates: &impl Fn(&Pose, &mut dyn FnMut([f64; N], Branch, FreeJoints)) -> Attempt,
    tolerance: f64,
    out: &mut Solutions<T, N, M>,
) {
    // Small motions in directions of no special kind.
    const MOTIONS: [[f64; 6]; 6] = [
        [0.31, -0.77, 0.52, 0.63, 0.29, -0.71],
        [-0.83, 0.21, 0.47, -0.37, 0.88, 0.24],
        [0.59, 0.67, -0.43, 0.19, -0.53, 0.79],
        [-0.27, -0.61, -0.73, -0.91, -0.17, -0.41],
        [0.91, -0.13, 0.37, 0.43, 0.71, 0.57],
        [-0.49, 0.83, -0.23, 0.77, -0.67, 0.11],
    ];
    for size in [1e-4, 1e-2] {
        for motion in &MOTIONS {
            let near = moved(frame, motion, size);
            candidates(&near, &mut |mut q, branch, free| {
                let polished = polish(arm, &mut q, task, setting.reach, 60);
                if polished.reaches(tolerance) {
                    let free = moving(arm, &q, setting.reach, free);
                    let solution = Solution::new(q.map(T::of), branch).with_free(free);
                    out.insert(solution, T::of(1e-3));
                }
            });
        }
        if !out.is_empty() {
            return;
        }
    }
}

/// A pose after a small motion.
fn moved(frame: &Pose, motion: &[f64; 6], size: f64) -> Pose {
    let mut t = pose::IDENTITY;
    for axis in 0..3 {
        let angle = motion[axis] * size;
        let (s, c) = (angle, 1.0 - 0.5 * angle * angle);
        let h = 1.0 / crate::math::sqrt(s * s + c * c);
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut r = pose::IDENTITY;
        r[j][j] = c * h;
        r[k][k] = c * h;
        r[j][k] = -s * h;
        r[k][j] = s * h;
        t = pose::compose(&t, &r);
    }
    let mut out = pose::compose(frame, &t);
    for i in 0..3 {
        out[i][3] = frame[i][3] + motion[3 + i] * size;
    }
    out
}

/// A target pose in `f64` with lengths over the reach; orthonormal, if it was rounded.
///
/// # Errors
/// Numbers that are not finite, a matrix that is no rotation.
pub fn frame_of<T: Real>(target: &nalgebra::IsometryMatrix3<T>, reach: f64) -> Result<Pose, Why<T>> {
    crate::pose::check(target)?;
    let r = target.rotation.matrix();
    let mut wide = crate::pose::from_entries(
        core::array::from_fn(|i| core::array::from_fn(|j| r[(i, j)].to_f64())),
        core::array::from_fn(|i| target.translation.vector[i].to_f64()),
    );
    if crate::pose::rotation_deviation(wide.rotation.matrix()) > 1e-14 {
        wide = crate::pose::orthonormalized(&wide);
    }
    let r = wide.rotation.matrix();
    Ok(core::array::from_fn(|i| {
        core::array::from_fn(|j| if j < 3 { r[(i, j)] } else { wide.translation.vector[i] / reach })
    }))
}

/// The same pose with lengths in table units: what the task compares with.
#[must_use]
pub fn in_units(frame: &Pose, reach: f64) -> Pose {
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { frame[i][j] } else { frame[i][3] * reach }))
}

/// A pose of generated forward kinematics as the kernels want it.
#[must_use]
#[inline]
pub fn to_pose(t: &nalgebra::IsometryMatrix3<f64>) -> Pose {
    let (r, p) = (t.rotation.matrix(), &t.translation.vector);
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { r[(i, j)] } else { p[i] }))
}

/// A frame at a point with a given z axis; x is any perpendicular direction.
#[must_use]
pub fn frame_of_axis(p: [f64; 3], z: [f64; 3]) -> Pose {
    // The coordinate axis that is farthest from z.
    let k = (0..3).fold(0, |b, i| if z[i].abs() < z[b].abs() { i } else { b });
    let mut e = [0.0; 3];
    e[k] = 1.0;
    let y = pose::cross(z, e);
    let h = 1.0 / crate::math::sqrt(pose::dot(y, y));
    let y = y.map(|v| v * h);
    let x = pose::cross(y, z);
    core::array::from_fn(|i| [x[i], y[i], z[i], p[i]])
}

/// The frame of a planar arm's tool at (x, y) with its x axis at the angle `phi`: the rotation at zero, `zero`, turned about z. The
/// height is left to the plan.
#[must_use]
pub fn frame_of_plane(p: [f64; 2], phi: f64, zero: [[f64; 3]; 3]) -> Pose {
    let (s, c) = crate::math::sin_cos(phi - crate::math::atan2(zero[1][0], zero[0][0]));
    core::array::from_fn(|i| {
        core::array::from_fn(|j| match (i, j) {
            (0, 0..3) => c * zero[0][j] - s * zero[1][j],
            (1, 0..3) => s * zero[0][j] + c * zero[1][j],
            (2, 0..3) => zero[2][j],
            (0 | 1, _) => p[i],
            _ => 0.0,
        })
    })
}
