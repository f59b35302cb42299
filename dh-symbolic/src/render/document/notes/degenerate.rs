//! Where the equations of a step leave its unknown free: looked for among the poses of the arm, and tried out there.
//!
//! A remark about such poses is only made where there is one, and where the unknown can be moved at it without moving the tool.

use super::arm::Arm;
use super::numbers::{pose_values, seen};
use crate::algebra::{Poly, Symbol};
use crate::chain::Task;
use crate::planner::JointCombination;
use crate::render::document::explanation::{Explanation, StepExplanation};
use crate::render::document::frames::Frame;

/// Joint vectors from which such a pose is looked for.
const STARTS: usize = 6;
/// Newton steps from each.
const STEPS: usize = 14;
/// Size of a residual that counts as zero (lengths over the length scale).
const ZERO: f64 = 1e-9;
/// How far the unknown is moved.
const APART: f64 = 0.3;

/// Is there a pose at which all these coefficients vanish, and is the unknown free there, with what the steps before have found?
pub(super) fn is_free(arm: &Arm, explanation: &Explanation<'_>, step: &StepExplanation) -> bool {
    let coefficients = &step.solution.coefficients;
    let plan = &arm.inverse.plan;
    let Some((form, before)) = plan.steps.get(step.index).and_then(|s| Some((s.unknown.first()?, s.before))) else {
        return false;
    };
    let n = arm.dof();
    let length_scale = plan.axes.length_scale;
    let symbols: Vec<Symbol> = coefficients.iter().flat_map(Poly::symbols).collect();
    // Values of the same size whatever the unit of lengths is.
    let sizes: Vec<f64> = coefficients.iter().map(|p| length_scale.powi(degree(arm, p))).collect();
    let vanish = |x: &[f64]| -> Option<Vec<f64>> {
        let values = pose_values(explanation, arm, x, Some(&symbols))?;
        let known = |s: Symbol| values.iter().find(|v| v.0 == s).map(|v| v.1);
        Some(coefficients.iter().zip(&sizes).map(|(p, size)| arm.evaluate_with(p, x, &known) / size).collect())
    };
    let rows: Vec<&JointCombination> = plan.knowledge.known.iter().take(before).map(|k| &k.form).collect();
    let combination = |f: &JointCombination, x: &[f64]| -> f64 {
        let scale = |k: usize| if arm.is_revolute(k) { 1.0 } else { length_scale };
        f.iter().zip(x).enumerate().map(|(k, (c, x))| f64::from(*c) * x / scale(k)).sum()
    };
    let state = |x: &[f64]| -> Option<Vec<f64>> {
        let mut out = task(arm, explanation, x)?;
        out.extend(rows.iter().map(|f| combination(f, x)));
        Some(out)
    };
    (0..STARTS).any(|k| {
        let start: Vec<f64> = (0..n)
            .map(|j| {
                let x = 2.6 * ((1.7 + j as f64) * (2.3 + k as f64) * 1.3).sin();
                if arm.is_revolute(j) { x } else { 0.3 * x * length_scale }
            })
            .collect();
        let Some(x) = newton(arm, &start, &vanish) else { return false };
        let Some(here) = state(&x) else { return false };
        let moved = |sign: f64| {
            let goal = combination(form, &x) + sign * APART;
            let residual = |y: &[f64]| -> Option<Vec<f64>> {
                let mut out: Vec<f64> = state(y)?.iter().zip(&here).map(|(a, b)| a - b).collect();
                out.push(combination(form, y) - goal);
                Some(out)
            };
            newton(arm, &x, &residual).is_some()
        };
        moved(1.0) || moved(-1.0)
    })
}

/// The power of a length that the formula is.
fn degree(arm: &Arm, p: &Poly) -> i32 {
    let is_length = |s: Symbol| arm.chain.parameters.iter().any(|q| q.handle == crate::chain::Handle::Length(s));
    let sliding = |s: Symbol| arm.chain.joints.iter().any(|j| j.coordinate == crate::chain::Coordinate::Length(s));
    let place = |s: Symbol| arm.inverse.plan.knowledge.poses.iter().any(|k| k.p.contains(&s) || k.back.contains(&s));
    let square = |s: Symbol| arm.inverse.plan.knowledge.poses.iter().any(|k| k.square == s);
    let power = |s: Symbol, n: u32| {
        let n = i32::try_from(n).unwrap_or(0);
        if square(s) {
            2 * n
        } else if is_length(s) || sliding(s) || place(s) {
            n
        } else {
            0
        }
    };
    let terms = p.terms().iter().map(|(m, _)| p.symbols().into_iter().map(|s| power(s, m.exponent(s))).sum::<i32>());
    terms.max().unwrap_or(0)
}

/// What the task asks of the tool, lengths over the length scale.
fn task(arm: &Arm, explanation: &Explanation<'_>, x: &[f64]) -> Option<Vec<f64>> {
    let [from, to] = explanation.whole();
    let t = seen(explanation, arm, to, x)?;
    let t = match from {
        Frame::Base => {
            dh_kernels::pose::compose(&dh_kernels::pose::inverse(&seen(explanation, arm, Frame::Base, x)?), &t)
        }
        _ => t,
    };
    let length_scale = arm.inverse.plan.axes.length_scale;
    let mut out = Vec::new();
    for (i, row) in t.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            let counts = match arm.chain.settings.task {
                Task::Pose => true,
                Task::Position => j == 3,
                Task::Axis => j >= 2,
                Task::Planar => i < 2 && (j == 0 || j == 3),
            };
            if counts {
                out.push(if j == 3 { value / length_scale } else { *value });
            }
        }
    }
    Some(out)
}

/// A zero of a residual near a joint vector, by damped least squares with slopes from differences.
fn newton(arm: &Arm, start: &[f64], residual: &dyn Fn(&[f64]) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
    let length_scale = arm.inverse.plan.axes.length_scale;
    let n = start.len();
    let unit = |k: usize| if arm.is_revolute(k) { 1.0 } else { length_scale };
    let mut x = start.to_vec();
    for _ in 0..STEPS {
        let r = residual(&x)?;
        if r.iter().all(|v| v.abs() < ZERO) {
            return Some(x);
        }
        let h = 1e-6;
        let mut slopes: Vec<Vec<f64>> = Vec::with_capacity(n);
        for k in 0..n {
            let mut y = x.clone();
            y[k] += h * unit(k);
            slopes.push(residual(&y)?.iter().zip(&r).map(|(a, b)| (a - b) / h).collect());
        }
        // (J^T J + damping) d = -J^T r
        let size: f64 = r.iter().map(|v| v * v).sum::<f64>();
        let damping = (1e-3 * size).min(1e-2) + 1e-14;
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
        let mut m: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let mut row: Vec<f64> = (0..n).map(|j| dot(&slopes[i], &slopes[j])).collect();
                row[i] += damping;
                row.push(-dot(&slopes[i], &r));
                row
            })
            .collect();
        solve(&mut m);
        for (k, value) in x.iter_mut().enumerate() {
            let d = m[k][n];
            if !d.is_finite() {
                return None;
            }
            *value += d.clamp(-0.7, 0.7) * unit(k);
        }
    }
    residual(&x).filter(|r| r.iter().all(|v| v.abs() < ZERO)).map(|_| x)
}

/// Gauss and Jordan: the last column becomes the solution.
fn solve(m: &mut [Vec<f64>]) {
    let n = m.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|a, b| m[*a][i].abs().total_cmp(&m[*b][i].abs())).unwrap_or(i);
        m.swap(i, pivot);
        let head = m[i].clone();
        for (k, row) in m.iter_mut().enumerate() {
            let factor = row[i] / head[i];
            if k != i {
                row.iter_mut().zip(&head).for_each(|(x, h)| *x -= factor * h);
            }
        }
        let own = head[i];
        m[i].iter_mut().for_each(|x| *x /= own);
    }
}
