//! Damped Newton steps, bounded in number, that bring a candidate of the plan onto its target.

use super::polish::{Kinematics, TaskTarget};

/// Damping of a step: this times the square of the error, and no less than the floor.
const DAMPING: f64 = 1e-2;
/// Least damping (the square of a singular value). Motions whose singular value is far below its root are left alone.
const FLOOR: f64 = 1e-15;
/// Steps one after the other that do not help, or little.
const PATIENCE: usize = 4;
/// Longest step (rad, or table units) of a joint on its way into a box.
const LONGEST: f64 = 1.0;
/// Factor between the damping of a step that led away and its repetition.
const HARDER: f64 = 1e2;

/// By how much a joint vector misses its target: the largest entry of the error (position over the length scale, rotation in radians).
fn size(error: &[f64; 6]) -> f64 {
    // What is not a number is kept.
    error.iter().fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() })
}

/// The step of least length that removes `error`, as far as the damping lets it: `J^T (J J^T + m)^-1 e`.
fn damped_step<const N: usize>(j: &[[f64; N]; 6], error: &[f64; 6], damping: f64) -> [f64; N] {
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

/// Moves `q` onto the target by at most `steps` Newton steps; gives back by how much it misses in the end, and how many steps were taken. Ends
/// where the miss is below `goal`, or where steps do not help. `q` never gets worse.
pub fn newton<const N: usize>(
    arm: &impl Kinematics<N>,
    task: &TaskTarget,
    length_scale: f64,
    q: &mut [f64; N],
    steps: usize,
    goal: f64,
) -> (f64, usize) {
    let (pose, j) = arm.forward_and_jacobian(q);
    let mut error = task.error(&pose, length_scale);
    let mut j = task.rows(&pose, j, length_scale);
    let mut now = size(&error);
    let mut harder = 1.0;
    let mut failed = 0;
    for taken in 0..steps {
        if !(now > goal && now < f64::INFINITY) {
            return (now, taken);
        }
        let damping = (DAMPING * harder * now * now).max(FLOOR * harder);
        let step = damped_step(&j, &error, damping);
        let next: [f64; N] = core::array::from_fn(|k| q[k] + step[k]);
        let (pose, slopes) = arm.forward_and_jacobian(&next);
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
            return (now, taken + 1);
        }
    }
    (now, steps)
}

/// Moves `q` onto the target and into a box at once, where a self-motion leaves room for both; gives back by how much it misses the target in the
/// end, and how many steps were taken. `wish` is the way from joint values to the nearest ones in the box: of it, every step takes what the
/// target leaves alone.
pub fn newton_into<const N: usize>(
    arm: &impl Kinematics<N>,
    task: &TaskTarget,
    length_scale: f64,
    q: &mut [f64; N],
    steps: usize,
    goal: f64,
    wish: impl Fn(&[f64; N]) -> [f64; N],
) -> (f64, usize) {
    for taken in 0..=steps {
        let (pose, j) = arm.forward_and_jacobian(q);
        let mut error = task.error(&pose, length_scale);
        let now = size(&error);
        let way = wish(q);
        if taken == steps || !(now < f64::INFINITY) || now <= goal && way == [0.0; N] {
            return (now, taken);
        }
        let j = task.rows(&pose, j, length_scale);
        for (e, row) in error.iter_mut().zip(&j) {
            *e -= row.iter().zip(&way).map(|(j, w)| j * w).sum::<f64>();
        }
        let step = damped_step(&j, &error, (DAMPING * now * now).max(FLOOR));
        let longest = way.iter().zip(&step).fold(0.0_f64, |m, (w, s)| m.max((w + s).abs()));
        let part = if longest > LONGEST { LONGEST / longest } else { 1.0 };
        for k in 0..N {
            q[k] += part * (way[k] + step[k]);
        }
    }
    (f64::INFINITY, steps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NumericChain, pose};

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
    fn of_a_self_motion_the_part_in_a_box_is_found() {
        let arm = NumericChain { links: planar(), prismatic: [false; 3] };
        let target = TaskTarget::Position([1.2, 0.9, 0.0]);
        let (least, greatest) = ([-0.5, 0.2, 0.1], [0.5, 2.5, 2.0]);
        // Beyond a limit the way leads a little behind it.
        let wish = |q: &[f64; 3]| {
            core::array::from_fn(|k| {
                let outside = q[k] < least[k] || q[k] > greatest[k];
                if outside { q[k].clamp(least[k] + 0.05, greatest[k] - 0.05) - q[k] } else { 0.0 }
            })
        };
        let mut q = [0.5, 0.5, -0.5];
        let (miss, _) = newton_into(&arm, &target, 3.0, &mut q, 30, 1e-12, wish);
        assert!(miss <= 1e-12 && wish(&q) == [0.0; 3], "{miss} {q:?}");
    }

    #[test]
    fn a_stretched_arm_is_brought_onto_its_target_and_one_out_of_reach_ends() {
        let arm = NumericChain { links: planar(), prismatic: [false; 3] };
        let mut q = [0.01, 0.0, -0.02];
        let target = TaskTarget::Position([2.9, 0.3, 0.0]);
        assert!(newton(&arm, &target, 3.0, &mut q, 20, 1e-14).0 < 1e-12);
        let out = TaskTarget::Position([3.5, 0.0, 0.0]);
        let (miss, taken) = newton(&arm, &out, 3.0, &mut q, 20, 1e-14);
        assert!(miss > 0.1 && taken <= 20);
    }
}
