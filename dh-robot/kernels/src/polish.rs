//! Moves an approximate joint vector onto its target: damped Newton steps on the full pose, or on a part of it.

use super::drive::Drive;
use super::elementary::{atan2, sqrt};
use super::pose::{Pose, rotation_between};
use super::tolerance::{BLURRED, NEAR, POLISHED, SAME, VALLEY};
use super::vector::{cross, dot, norm};

/// Most steps back to the floor of a bent valley.
const BACK: usize = 4;

/// What polishing must know of an arm.
pub trait Kinematics<const N: usize> {
    /// The pose of the last frame (or tool) in the base.
    fn forward(&self, q: &[f64; N]) -> Pose;

    /// The pose, and the geometric Jacobian: rows 0..3 linear, at the origin of that frame, rows 3..6 angular, in base axes.
    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, [[f64; N]; 6]);

    /// The unit of lengths, for reports that name it.
    #[inline]
    fn unit(&self) -> &'static str {
        ""
    }

    /// The coupled drive, where a whole turn of a row is not a whole number of actuator turns.
    #[inline]
    fn drive(&self) -> Option<Drive<N>> {
        None
    }
}

/// What an arm is asked for.
#[derive(Clone, Copy, Debug)]
pub enum TaskTarget {
    /// The whole pose.
    Pose(Pose),
    /// The position alone.
    Position([f64; 3]),
    /// The position and the direction (a unit vector) of the last z axis.
    Axis([f64; 3], [f64; 3]),
    /// x, y and the angle about z, of an arm that moves in the plane.
    Planar(f64, f64, f64),
}

impl TaskTarget {
    /// How many numbers it asks for.
    pub fn dimensions(&self) -> usize {
        match self {
            Self::Pose(_) => 6,
            Self::Axis(..) => 5,
            Self::Position(_) | Self::Planar(..) => 3,
        }
    }

    /// What is missing from `pose` to the target: position over the length scale` (rows 0..3) and rotation in radians (rows 3..6), in
    /// base axes. Rows that the task doesn't ask for are zero.
    pub fn error(&self, pose: &Pose, length_scale: f64) -> [f64; 6] {
        let p = [pose[0][3], pose[1][3], pose[2][3]];
        let miss =
            |t: [f64; 3]| [(t[0] - p[0]) / length_scale, (t[1] - p[1]) / length_scale, (t[2] - p[2]) / length_scale];
        match self {
            Self::Pose(target) => {
                let m = miss([target[0][3], target[1][3], target[2][3]]);
                let r = rotation_between(pose, target);
                [m[0], m[1], m[2], r[0], r[1], r[2]]
            }
            Self::Position(target) => {
                let m = miss(*target);
                [m[0], m[1], m[2], 0.0, 0.0, 0.0]
            }
            Self::Axis(target, direction) => {
                let m = miss(*target);
                let z = [pose[0][2], pose[1][2], pose[2][2]];
                let mut v = cross(z, *direction);
                let (sin, cos) = (norm(v), dot(z, *direction));
                if sin > 0.0 {
                    let factor = atan2(sin, cos) / sin;
                    v = v.map(|x| x * factor);
                } else if cos < 0.0 {
                    // Opposite directions: half a turn about any normal, here about the frame's x axis.
                    v = [pose[0][0], pose[1][0], pose[2][0]].map(|x| x * core::f64::consts::PI);
                }
                [m[0], m[1], m[2], v[0], v[1], v[2]]
            }
            Self::Planar(x, y, phi) => {
                let (s, c) = super::elementary::sin_cos(*phi);
                let (ps, pc) = (pose[1][0], pose[0][0]);
                [
                    (x - p[0]) / length_scale,
                    (y - p[1]) / length_scale,
                    0.0,
                    0.0,
                    0.0,
                    atan2(s * pc - c * ps, c * pc + s * ps),
                ]
            }
        }
    }

    /// Entry by entry, without angles: position over the length scale` (three entries), then the rotation's nine, each less the target's. Entries that
    /// the task doesn't ask for are zero.
    pub fn difference(&self, pose: &Pose, length_scale: f64) -> [f64; 12] {
        let mut out = [0.0; 12];
        let mut set = |i: usize, j: usize, target: f64| {
            let (place, scale) = if j == 3 { (i, length_scale) } else { (3 + 3 * j + i, 1.0) };
            out[place] = (pose[i][j] - target) / scale;
        };
        match self {
            Self::Pose(t) => (0..12).for_each(|k| set(k % 3, k / 3, t[k % 3][k / 3])),
            Self::Position(p) => (0..3).for_each(|i| set(i, 3, p[i])),
            Self::Axis(p, z) => (0..3).for_each(|i| {
                set(i, 3, p[i]);
                set(i, 2, z[i]);
            }),
            Self::Planar(x, y, phi) => {
                let (s, c) = super::elementary::sin_cos(*phi);
                set(0, 3, *x);
                set(1, 3, *y);
                set(0, 0, c);
                set(1, 0, s);
            }
        }
        out
    }

    /// The rows of the Jacobian that belong to [`TaskTarget::error`], scaled like it.
    pub fn rows<const N: usize>(&self, pose: &Pose, mut j: [[f64; N]; 6], length_scale: f64) -> [[f64; N]; 6] {
        for row in &mut j[..3] {
            for x in row {
                *x /= length_scale;
            }
        }
        match self {
            Self::Pose(_) => {}
            Self::Position(_) => j[3..].fill([0.0; N]),
            Self::Axis(..) => {
                // A turn about the axis itself doesn't count.
                for i in 0..N {
                    let along = pose[0][2] * j[3][i] + pose[1][2] * j[4][i] + pose[2][2] * j[5][i];
                    for k in 0..3 {
                        j[3 + k][i] -= pose[k][2] * along;
                    }
                }
            }
            Self::Planar(..) => j[2..5].fill([0.0; N]),
        }
        j
    }
}

/// What polishing ended with.
#[derive(Clone, Copy, Debug)]
pub struct Polished {
    /// Distance to the target's position, over the length scale.
    pub position: f64,
    /// Angle to the target's orientation, in radians.
    pub rotation: f64,
    /// Steps taken.
    pub steps: usize,
}

impl Polished {
    /// Whether the arm reaches its target within `tol`, in position (over the length scale) and rotation (rad); `false` for NaN.
    pub fn reaches(&self, tol: f64) -> bool {
        self.position <= tol && self.rotation <= tol
    }
}

/// Improves `q` by at most `steps` damped Newton steps towards `task`; `length_scale` is a length of the arm's size.
///
/// Nothing is computed but one forward kinematics where `q` is exact already. `q` never gets worse.
pub fn polish<const N: usize>(
    arm: &impl Kinematics<N>,
    q: &mut [f64; N],
    task: &TaskTarget,
    length_scale: f64,
    steps: usize,
) -> Polished {
    polish_to(arm, q, task, length_scale, steps, POLISHED)
}

/// The same, content with a residual of `goal` (position over the length scale, and radians).
pub fn polish_to<const N: usize>(
    arm: &impl Kinematics<N>,
    q: &mut [f64; N],
    task: &TaskTarget,
    length_scale: f64,
    steps: usize,
    goal: f64,
) -> Polished {
    let (error, taken) = levenberg_marquardt(
        q,
        steps,
        goal,
        |q| task.error(&arm.forward(q), length_scale),
        |q| {
            let (pose, j) = arm.forward_and_jacobian(q);
            task.rows(&pose, j, length_scale)
        },
    );
    let norm = |e: &[f64]| sqrt(e.iter().map(|x| x * x).sum());
    Polished { position: norm(&error[..3]), rotation: norm(&error[3..]), steps: taken }
}

/// Whether two joint vectors that both reach a target are the same solution, up to whole turns and rounding.
///
/// Near a double root, polishing ends anywhere within the square root of its tolerance (and near a root of higher order, still farther
/// away). What lies between two such ends reaches the task too; what lies between two solutions doesn't.
pub fn same_solution<const N: usize>(
    arm: &impl Kinematics<N>,
    task: &TaskTarget,
    length_scale: f64,
    p: &[f64; N],
    q: &[f64; N],
) -> bool {
    let mut apart = 0.0f64;
    let mut step = [0.0; N];
    let mut way: [f64; N] = core::array::from_fn(|i| q[i] - p[i]);
    if let Some(drive) = arm.drive() {
        way = drive.shortest(way);
    }
    for i in 0..N {
        let (s, c) = super::elementary::sin_cos(way[i]);
        if c < 0.0 || s.abs() > NEAR {
            return false;
        }
        apart = apart.max(s.abs());
        step[i] = s;
    }
    if apart <= SAME {
        return true;
    }
    let mut middle = *p;
    for i in 0..N {
        middle[i] += 0.5 * step[i];
    }
    // As well as the two ends do: near a root that was not polished to the last digit, what lies between is no better.
    let miss = |x: &[f64; N]| task.error(&arm.forward(x), length_scale).iter().fold(0.0f64, |m, e| m.max(e.abs()));
    let enough = 4.0 * miss(p).max(miss(q)) + BLURRED;
    // The way between them may be bent: steps that are damped so much that they don't lead along it lead back to it.
    for _ in 0..BACK {
        if miss(&middle) <= enough {
            return true;
        }
        let (pose, j) = arm.forward_and_jacobian(&middle);
        let error = task.error(&pose, length_scale);
        let back = solve_damped(&task.rows(&pose, j, length_scale), &error, VALLEY * VALLEY);
        for i in 0..N {
            middle[i] += back[i];
        }
    }
    miss(&middle) <= enough
}

/// Drives `error(q)` to zero in the sense of least squares; `jacobian` is minus its derivative. Gives back the last error and
/// the number of steps taken.
///
/// A step solves `(J^T J + m I) dq = J^T e` with `m` proportional to `|e|^2` (Yamashita and Fukushima, 2001; for arms
/// Sugihara, 2011): far away and near singularities it is short and safe, near a solution it is Newton's, and it
/// converges quadratically also where solutions form a curve. A step that doesn't help is halved in length by more damping.
/// Ends when `|e| <= goal`, when nothing helps any more, or after `steps`.
pub fn levenberg_marquardt<const N: usize, const M: usize>(
    q: &mut [f64; N],
    steps: usize,
    goal: f64,
    error: impl Fn(&[f64; N]) -> [f64; M],
    jacobian: impl Fn(&[f64; N]) -> [[f64; N]; M],
) -> ([f64; M], usize) {
    /// Damping of a first step whose error is 1.
    const FIRST: f64 = 1e-2;
    /// Tries with more and more damping before giving up.
    const TRIES: usize = 12;
    /// Steps after which slow progress means a multiple root.
    const PATIENCE: usize = 6;
    /// Square of an error below which a step that doesn't help much is rounding noise.
    const FLOOR: f64 = 1e-26;
    /// Square of an error below which a step that leads away gets a second chance.
    const BENT: f64 = 1e-8;
    let square = |e: &[f64; M]| e.iter().map(|x| x * x).sum::<f64>();
    let mut e = error(q);
    let mut now = square(&e);
    let mut weight = FIRST;
    for taken in 0..steps {
        if !(now > goal * goal && now < f64::INFINITY) {
            return (e, taken);
        }
        let j = jacobian(q);
        let mut helped = false;
        for attempt in 0..TRIES {
            let step = solve_damped(&j, &e, weight * now);
            let mut next = *q;
            for i in 0..N {
                next[i] += step[i];
            }
            let e_next = error(&next);
            let then = square(&e_next);
            if then < now {
                // A full reduction is what Newton promises; then trust it more.
                weight = if then < 0.25 * now { weight * 0.1 } else { weight };
                helped = then < 0.25 * now || now > FLOOR;
                let before = now;
                (*q, e, now) = (next, e_next, then);
                // Towards a root of order n, Newton's steps are too short by the factor n.
                if taken >= PATIENCE && then > 1e-4 * before {
                    for _ in 0..3 {
                        let mut next = *q;
                        for i in 0..N {
                            next[i] += step[i];
                        }
                        let e_next = error(&next);
                        let then = square(&e_next);
                        if !(then < now) {
                            break;
                        }
                        (*q, e, now) = (next, e_next, then);
                    }
                }
                break;
            }
            // A good step along a bent valley leads away from the target by more than is left; steps that don't go along it lead back.
            if attempt == 0 && now < BENT {
                let (mut e_next, mut then) = (e_next, then);
                for _ in 0..BACK {
                    let back = solve_damped(&jacobian(&next), &e_next, (weight * then).max(VALLEY * VALLEY));
                    for i in 0..N {
                        next[i] += back[i];
                    }
                    e_next = error(&next);
                    then = square(&e_next);
                    if then < 0.9 * now {
                        break;
                    }
                }
                if then < 0.9 * now {
                    (*q, e, now) = (next, e_next, then);
                    helped = true;
                    break;
                }
            }
            if now <= FLOOR {
                break;
            }
            weight = if weight < 1e-6 { 1e-4 } else { weight * 6.0 };
        }
        if !helped {
            return (e, taken);
        }
    }
    (e, steps)
}

/// Minimises `|J x - e|^2 + m |x|^2`: rows are turned one after the other into a triangle (Givens rotations), so that small singular
/// values keep their digits.
fn solve_damped<const N: usize, const M: usize>(j: &[[f64; N]; M], e: &[f64; M], m: f64) -> [f64; N] {
    let mut r = [[0.0; N]; N];
    let mut x = [0.0; N];
    let damping = sqrt(m);
    for i in 0..N {
        r[i][i] = damping;
    }
    for (row, &right) in j.iter().zip(e) {
        let (mut row, mut right) = (*row, right);
        for i in 0..N {
            if row[i] == 0.0 {
                continue;
            }
            let h = sqrt(r[i][i] * r[i][i] + row[i] * row[i]);
            let (c, s) = (r[i][i] / h, row[i] / h);
            for k in i..N {
                (r[i][k], row[k]) = (c * r[i][k] + s * row[k], c * row[k] - s * r[i][k]);
            }
            (x[i], right) = (c * x[i] + s * right, c * right - s * x[i]);
        }
    }
    // A pivot below rounding noise belongs to a direction that doesn't move the arm: leave that direction alone.
    let mut largest = 0.0f64;
    for i in 0..N {
        largest = largest.max(r[i][i].abs());
    }
    for i in (0..N).rev() {
        for k in i + 1..N {
            x[i] -= r[i][k] * x[k];
        }
        x[i] = if r[i][i].abs() > 1e-13 * largest { x[i] / r[i][i] } else { 0.0 };
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::NumericChain;
    use crate::testing::{Rng, general_6r, random_pose};

    #[test]
    fn nearby_start_converges_to_the_generating_joints() {
        let arm = general_6r();
        let mut rng = Rng::new(7);
        for _ in 0..200 {
            let truth = [(); 6].map(|()| rng.angle());
            let target = arm.forward(&truth);
            let mut q = truth.map(|x| x + 1e-4 * rng.symmetric());
            let done = polish(&arm, &mut q, &TaskTarget::Pose(target), arm.length_scale(), 8);
            assert!(done.reaches(1e-13), "{done:?}");
        }
    }

    #[test]
    fn exact_start_is_left_alone() {
        let arm = general_6r();
        let mut q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
        let before = q;
        let done = polish(&arm, &mut q, &TaskTarget::Pose(arm.forward(&before)), arm.length_scale(), 5);
        assert_eq!((done.steps, q), (0, before));
    }

    #[test]
    fn singular_start_still_converges() {
        // Stretched out planar arm (two of three joints suffice): J has rank one less at the start.
        let mut link = crate::pose::IDENTITY;
        link[0][3] = 1.0;
        let arm = NumericChain { links: [link; 3], prismatic: [false; 3] };
        let mut q = [0.0; 3];
        let done = polish(&arm, &mut q, &TaskTarget::Position([2.0, 0.5, 0.0]), 3.0, 50);
        assert!(done.reaches(1e-12), "{done:?}");
    }

    #[test]
    fn redundant_and_partial_tasks_converge() {
        let mut rng = Rng::new(8);
        let arm = NumericChain { links: [(); 7].map(|()| random_pose(&mut rng)), prismatic: [false; 7] };
        for _ in 0..100 {
            let truth = [(); 7].map(|()| rng.angle());
            let pose = arm.forward(&truth);
            let p = [pose[0][3], pose[1][3], pose[2][3]];
            for task in [
                TaskTarget::Pose(pose),
                TaskTarget::Position(p),
                TaskTarget::Axis(p, [pose[0][2], pose[1][2], pose[2][2]]),
            ] {
                let mut q = truth.map(|x| x + 0.02 * rng.symmetric());
                let done = polish(&arm, &mut q, &task, arm.length_scale(), 60);
                assert!(done.reaches(1e-12), "{done:?}");
            }
        }
    }

    #[test]
    fn planar_task_wraps_its_angle() {
        let mut link = crate::pose::IDENTITY;
        link[0][3] = 1.0;
        let arm = NumericChain { links: [link; 3], prismatic: [false; 3] };
        let truth = [1.0, 1.0, 1.1];
        let pose = arm.forward(&truth);
        for turns in [-1.0, 0.0, 2.0] {
            let task = TaskTarget::Planar(pose[0][3], pose[1][3], 3.1 + turns * core::f64::consts::TAU);
            let mut q = [1.1, 0.9, 1.15];
            assert!(polish(&arm, &mut q, &task, 3.0, 20).reaches(1e-13));
            assert!(q.iter().zip(&truth).all(|(a, b)| (a - b).abs() < 1e-12));
        }
    }

    #[test]
    fn an_unreachable_target_gets_no_worse_and_says_so() {
        let arm = general_6r();
        let mut q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
        let mut target = arm.forward(&q);
        target[0][3] += 100.0;
        let done = polish(&arm, &mut q, &TaskTarget::Pose(target), arm.length_scale(), 20);
        assert!(!done.reaches(1e-6) && q.iter().all(|x| x.is_finite()));
    }

    #[test]
    fn bad_numbers_end_at_once() {
        let arm = general_6r();
        let mut q = [f64::NAN; 6];
        let done = polish(&arm, &mut q, &TaskTarget::Pose(random_pose(&mut Rng::new(1))), 1.0, 20);
        assert!(done.steps == 0 && !done.reaches(1.0));
    }

    #[test]
    fn a_double_root_in_a_bent_valley_is_reached() {
        // A full Newton step halves the first error's root and leaves a larger second error, which the next step removes.
        let error = |q: &[f64; 2]| [-q[0] * q[0], 8.0 * q[0] * q[0] - q[1]];
        let jacobian = |q: &[f64; 2]| [[2.0 * q[0], 0.0], [-16.0 * q[0], 1.0]];
        let mut q = [1e-5, 8e-10];
        let (e, steps) = levenberg_marquardt(&mut q, 12, 1e-15, error, jacobian);
        assert!(e.iter().all(|e| e.abs() < 1e-13), "{e:?} after {steps}");
    }

    #[test]
    fn small_singular_values_keep_their_digits() {
        // Two rows that differ by 1e-9: their squares are the same number.
        let x = solve_damped(&[[1.0, 1.0], [1.0, 1.0 + 1e-9]], &[2.0, 2.0 + 1e-9], 0.0);
        assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-6), "{x:?}");
    }
}
