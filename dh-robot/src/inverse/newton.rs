//! Damped Newton steps, bounded in number, that bring a candidate of the plan onto its target.

use super::work::Work;
use crate::math::sqrt;
use dh_kernels::{Kinematics, TaskTarget};

/// Damping of a step: this times the square of the error, and no less than the floor.
const DAMPING: f64 = 1e-2;
/// Least damping (the square of a singular value). Motions whose singular value is far below its root are left alone.
const FLOOR: f64 = 1e-15;
/// Steps one after the other that do not help, or little.
const PATIENCE: usize = 4;
/// Factor between the damping of a step that led away and its repetition.
const HARDER: f64 = 1e2;

/// By how much a joint vector misses its target: the largest entry of the error (position over the length scale, rotation in radians).
pub(super) fn size(error: &[f64; 6]) -> f64 {
    // What is not a number is kept.
    error.iter().fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() })
}

/// The step of least length that removes `error`, as far as the damping lets it: `J^T (J J^T + m)^-1 e`.
pub(super) fn damped_step<const N: usize>(j: &[[f64; N]; 6], error: &[f64; 6], damping: f64) -> [f64; N] {
    let mut a = [[0.0; 6]; 6];
    for r in 0..6 {
        for c in 0..=r {
            let mut sum = 0.0;
            for k in 0..N {
                sum += j[r][k] * j[c][k];
            }
            a[r][c] = sum;
        }
        a[r][r] += damping;
    }
    // L D L^T in place: the multipliers below the diagonal.
    let (mut pivots, mut inverses) = ([0.0; 6], [0.0; 6]);
    for c in 0..6 {
        let mut row = [0.0; 6];
        let mut pivot = a[c][c];
        for k in 0..c {
            row[k] = a[c][k] * pivots[k];
            pivot -= a[c][k] * row[k];
        }
        let inverse = if pivot > 0.1 * damping { 1.0 / pivot } else { 0.0 };
        for r in c + 1..6 {
            let mut sum = a[r][c];
            for k in 0..c {
                sum -= a[r][k] * row[k];
            }
            a[r][c] = sum * inverse;
        }
        (pivots[c], inverses[c]) = (pivot, inverse);
    }
    let mut y = *error;
    for r in 0..6 {
        for c in 0..r {
            y[r] -= a[r][c] * y[c];
        }
    }
    for (y, inverse) in y.iter_mut().zip(&inverses) {
        *y *= inverse;
    }
    for r in (0..6).rev() {
        for c in r + 1..6 {
            y[r] -= a[c][r] * y[c];
        }
    }
    core::array::from_fn(|k| (0..6).map(|r| j[r][k] * y[r]).sum())
}

/// Moves `q` onto the target by at most `steps` Newton steps and gives back by how much it misses in the end; ends where the miss is below
/// `goal`, or where steps do not help. `q` never gets worse.
pub(super) fn newton<const N: usize>(
    arm: &impl Kinematics<N>,
    task: &TaskTarget,
    length_scale: f64,
    q: &mut [f64; N],
    steps: usize,
    goal: f64,
    work: &mut Work,
) -> f64 {
    let (pose, j) = arm.forward_and_jacobian(q);
    work.evaluations += 1;
    let mut error = task.error(&pose, length_scale);
    let mut j = task.rows(&pose, j, length_scale);
    let mut now = size(&error);
    let mut harder = 1.0;
    let mut failed = 0;
    for _ in 0..steps {
        if !(now > goal && now < f64::INFINITY) || work.is_used_up() {
            return now;
        }
        work.steps += 1;
        let damping = (DAMPING * harder * now * now).max(FLOOR * harder);
        let step = damped_step(&j, &error, damping);
        let next: [f64; N] = core::array::from_fn(|k| q[k] + step[k]);
        let (pose, slopes) = arm.forward_and_jacobian(&next);
        work.evaluations += 1;
        let there = task.error(&pose, length_scale);
        let then = size(&there);
        if then < now {
            let slow = then > 0.5 * now;
            (*q, error, j, now) = (next, there, task.rows(&pose, slopes, length_scale), then);
            failed = if slow { failed + 1 } else { 0 };
            harder = (1e-2 * harder).max(1.0);
        } else {
            failed += 1;
            harder *= HARDER;
        }
        if failed > PATIENCE || failed > 0 && now < 1e-14 {
            break;
        }
    }
    now
}

/// The length of a joint motion.
pub(super) fn length<const N: usize>(v: &[f64; N]) -> f64 {
    sqrt(v.iter().map(|x| x * x).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dh_kernels::{NumericChain, pose};

    fn planar() -> [pose::Pose; 3] {
        let mut link = pose::IDENTITY;
        link[0][3] = 1.0;
        [link; 3]
    }

    #[test]
    fn a_step_solves_what_can_be_solved() {
        let j = [[2.0, 1.0, 0.5], [0.0, 3.0, 0.1], [0.0, 0.0, 1.5], [0.0; 3], [0.0; 3], [0.0; 3]];
        let wanted = [0.3, -0.2, 0.7];
        let mut error = [0.0; 6];
        for r in 0..6 {
            error[r] = (0..3).map(|k| j[r][k] * wanted[k]).sum();
        }
        let step = damped_step(&j, &error, 1e-15);
        assert!(step.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-12), "{step:?}");
    }

    #[test]
    fn a_stretched_arm_is_brought_onto_its_target_and_one_out_of_reach_ends() {
        let arm = NumericChain { links: planar(), prismatic: [false; 3] };
        let mut work = Work::new(Work::CLOSED_FORM);
        let mut q = [0.01, 0.0, -0.02];
        let target = TaskTarget::Position([2.9, 0.3, 0.0]);
        assert!(newton(&arm, &target, 3.0, &mut q, 20, 1e-14, &mut work) < 1e-12);
        let out = TaskTarget::Position([3.5, 0.0, 0.0]);
        let before = work.steps;
        assert!(newton(&arm, &out, 3.0, &mut q, 20, 1e-14, &mut work) > 0.1);
        assert!(work.steps - before <= 20);
    }
}
