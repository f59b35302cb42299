//! The arm of an example in numbers: its pose, its solutions, ranges and distances.

use super::given;
use crate::algebra::{Point, Poly, Rational, Symbol, Transform};
use crate::chain::{AngleCell, Chain, Coordinate, Elementary, Handle, Nominal, Quantity, Role, Task};
use crate::kinematics::Kinematics;
use crate::program::{Inverse, Naming, Shortfall};
use dh_kernels::pose::{self, Pose};
use std::f64::consts::TAU;
use std::rc::Rc;

/// Degrees of the example's joints, one after the other; awkward enough to be in general position.
const DEGREES: [i64; 8] = [20, -35, 50, 40, -60, 75, 30, -25];

/// Degrees of variable `k` in general position.
pub(super) fn generic_degrees(k: usize) -> f64 {
    DEGREES[k % DEGREES.len()] as f64
}

/// The arm in numbers.
pub(super) struct Arm {
    pub(super) chain: Chain,
    pub(super) inverse: Rc<Inverse>,
    pose: Transform,
}

/// One solution.
pub(super) struct Found {
    pub(super) q: Vec<f64>,
    pub(super) in_range: bool,
    pub(super) free: bool,
    /// Which root each step took.
    pub(super) branch: Vec<usize>,
}

/// Why a pose has no solution.
pub(super) enum Missed {
    /// Joint values were found, but they lead elsewhere: the arm has too few joints for poses of all kinds.
    NotOnTask,
    /// A step asks for more than the arm has.
    Short(Shortfall),
    /// The equations do not say.
    Unknown,
}

impl Arm {
    /// The arm with its nominal values, solved along the plan that the steps tell.
    pub(super) fn new(chain: &Chain, inverse: Rc<Inverse>) -> Arm {
        let chain = concrete(chain);
        let pose = Kinematics::new(&chain).pose();
        Arm { chain, inverse, pose }
    }

    /// What the roots of a step are called, and the step.
    pub(super) fn naming(&self, step: usize) -> Option<(usize, Naming)> {
        self.namings().into_iter().find(|n| n.0 == step)
    }

    /// The steps whose roots have names, in the order of shoulder, elbow, wrist.
    pub(super) fn namings(&self) -> Vec<(usize, Naming)> {
        let choices = self.inverse.body.result().map_or(&[][..], |r| &r.branch);
        let mut list: Vec<(usize, Naming)> = choices.iter().filter_map(|c| Some((c.step, c.name?))).collect();
        list.sort_by_key(|(_, n)| n.indicator as u8);
        list
    }

    pub(super) fn dof(&self) -> usize {
        self.chain.dof()
    }

    pub(super) fn is_revolute(&self, k: usize) -> bool {
        matches!(self.chain.joints.get(k).map(|j| j.coordinate), Some(Coordinate::Angle(_)))
    }

    /// Can whole turns be added to variable `k`?
    fn wraps(&self, k: usize) -> bool {
        self.is_revolute(k) && self.chain.is_direct()
    }

    pub(super) fn range(&self, k: usize) -> Option<(f64, f64)> {
        let (low, high) = self.chain.joints.get(k)?.range.as_ref()?;
        Some((given::bound(low), given::bound(high)))
    }

    fn contains(&self, k: usize, x: f64) -> bool {
        self.range(k).is_none_or(|(low, high)| x >= low - 1e-9 && x <= high + 1e-9)
    }

    /// Values in general position: within the ranges where there are some.
    pub(super) fn generic(&self) -> Vec<f64> {
        let value = |k: usize| {
            let x = if self.is_revolute(k) {
                (DEGREES[k % DEGREES.len()] as f64).to_radians()
            } else {
                slide(self.inverse.plan.axes.length_scale)
            };
            match self.range(k).filter(|_| !self.contains(k, x)) {
                Some((low, high)) => low + 0.4 * (high - low),
                None => x,
            }
        };
        (0..self.dof()).map(value).collect()
    }

    /// Zero, or the middle of the range where zero is not in it.
    pub(super) fn rest(&self) -> Vec<f64> {
        let value = |k: usize| match self.range(k).filter(|_| !self.contains(k, 0.0)) {
            Some((low, high)) => (low + high) / 2.0,
            None => 0.0,
        };
        (0..self.dof()).map(value).collect()
    }

    fn drive(&self, k: usize, j: usize) -> f64 {
        self.chain.drive.get(k).and_then(|row| row.get(j)).map_or(0.0, |p| self.evaluate(p, &[]))
    }

    /// A formula at joint coordinates.
    pub(super) fn evaluate(&self, p: &Poly, x: &[f64]) -> f64 {
        self.evaluate_with(p, x, &|_| None)
    }

    /// The same, where some symbols have values of their own.
    pub(super) fn evaluate_with(&self, p: &Poly, x: &[f64], known: &dyn Fn(Symbol) -> Option<f64>) -> f64 {
        p.evaluate(&Point {
            symbol: &|s| known(s).unwrap_or_else(|| self.value(Handle::Length(s), Coordinate::Length(s), x)),
            angle: &|v| self.value(Handle::Angle(v), Coordinate::Angle(v), x),
        })
    }

    /// A joint coordinate or a parameter.
    fn value(&self, handle: Handle, coordinate: Coordinate, x: &[f64]) -> f64 {
        let joint = self.chain.joints.iter().position(|j| j.coordinate == coordinate).and_then(|k| x.get(k));
        joint.copied().unwrap_or_else(|| self.chain.nominal(handle))
    }

    /// An elementary motion at joint coordinates.
    pub(super) fn motion(&self, motion: &Elementary, x: &[f64]) -> Pose {
        match motion {
            Elementary::Translate(axis, length) => {
                let mut t = pose::IDENTITY;
                t[axis % 3][3] = self.evaluate(length, x);
                t
            }
            Elementary::Rotate(axis, angle) => {
                let value = |v| self.value(Handle::Angle(v), Coordinate::Angle(v), x);
                let moving: f64 = angle.terms.iter().map(|(v, k)| f64::from(*k) * value(*v)).sum();
                given::turn(*axis, moving + angle.constant.radians())
            }
        }
    }

    pub(super) fn numbers(&self, t: &Transform, x: &[f64]) -> Pose {
        std::array::from_fn(|i| std::array::from_fn(|j| self.evaluate(&t.entry(i, j), x)))
    }

    fn shift(&self, k: usize) -> f64 {
        self.chain.joints.get(k).map_or(0.0, |j| given::shift(&self.chain, &j.shift))
    }

    /// Joint coordinates of the variables.
    pub(super) fn coordinates(&self, q: &[f64]) -> Vec<f64> {
        (0..self.dof())
            .map(|k| self.shift(k) + q.iter().enumerate().map(|(j, q)| self.drive(k, j) * q).sum::<f64>())
            .collect()
    }

    /// Variables of the joint coordinates.
    fn variables(&self, x: &[f64]) -> Vec<f64> {
        let n = self.dof();
        let mut m: Vec<Vec<f64>> = (0..n)
            .map(|k| {
                let x = x.get(k).copied().unwrap_or(0.0) - self.shift(k);
                (0..n).map(|j| self.drive(k, j)).chain([x]).collect()
            })
            .collect();
        for i in 0..n {
            let pivot = (i..n).max_by(|a, b| m[*a][i].abs().total_cmp(&m[*b][i].abs())).unwrap_or(i);
            m.swap(i, pivot);
            let head = m[i].clone();
            for (k, row) in m.iter_mut().enumerate() {
                let factor = row[i] / head[i];
                if k != i && factor.is_finite() {
                    row.iter_mut().zip(&head).for_each(|(x, h)| *x -= factor * h);
                }
            }
        }
        let q = |k: usize| m[k][n] / m[k][k];
        (0..n).map(|k| if self.wraps(k) { self.normal(k, q(k)) } else { q(k) }).collect()
    }

    /// An angle in (-pi, pi], shifted by whole turns into the range where that fits.
    fn normal(&self, k: usize, x: f64) -> f64 {
        let angle = x.sin().atan2(x.cos());
        let Some((low, high)) = self.range(k) else { return angle };
        let near = |turns: f64| angle + turns * TAU;
        [0.0, 1.0, -1.0, 2.0, -2.0]
            .map(near)
            .into_iter()
            .find(|x| *x >= low - 1e-9 && *x <= high + 1e-9)
            .unwrap_or(angle)
    }

    pub(super) fn forward(&self, q: &[f64]) -> Pose {
        self.numbers(&self.pose, &self.coordinates(q))
    }

    /// How far a pose misses what the task asks for.
    fn misses(&self, a: &Pose, b: &Pose) -> f64 {
        let counts = |i: usize, j: usize| match self.chain.settings.task {
            Task::Pose => true,
            Task::Position => j == 3,
            Task::Axis => j >= 2,
            Task::Planar => i < 2 && (j == 0 || j == 3),
        };
        let all = (0..3).flat_map(|i| (0..4).map(move |j| (i, j)));
        all.filter(|(i, j)| counts(*i, *j)).map(|(i, j)| (a[i][j] - b[i][j]).abs()).fold(0.0, f64::max)
    }

    /// All solutions, greatest first value first, and the greatest error.
    pub(super) fn solve(&self, goal: &Pose, q: &[f64]) -> (Vec<Found>, f64, Missed) {
        let length_scale = self.inverse.plan.axes.length_scale;
        let mut target = *goal;
        for row in &mut target {
            row[3] /= length_scale;
        }
        let x = self.coordinates(q);
        let known = self.inverse.plan.knowledge.known.iter().take(self.inverse.plan.given);
        let given: Vec<f64> = known
            .map(|k| {
                let value = |(c, (j, x)): (&i8, (usize, &f64))| {
                    f64::from(*c) * if self.is_revolute(j) { *x } else { x / length_scale }
                };
                k.form.iter().zip(x.iter().enumerate()).map(value).sum()
            })
            .collect();
        let (mut found, mut worst): (Vec<Found>, f64) = (Vec::new(), 0.0);
        let attempt = self.inverse.attempt(&self.chain, &target, &given, &|_| ([1.0, 0.0], 0.0));
        let missed = match attempt.shortfall {
            Some(s) if s.is_distance && attempt.candidates.is_empty() => Missed::Short(s),
            _ if self.inverse.plan.rank_deficient => Missed::NotOnTask,
            Some(s) if s.needs > s.has => Missed::Short(s),
            _ => Missed::Unknown,
        };
        for candidate in attempt.candidates {
            let y: Vec<f64> = (0..self.dof())
                .map(|k| {
                    let x = candidate.x.get(k).copied().unwrap_or(f64::NAN);
                    if self.is_revolute(k) { x.sin().atan2(x.cos()) } else { x * length_scale }
                })
                .collect();
            let q = self.variables(&y);
            let error = self.misses(&self.forward(&q), goal);
            let known = found.iter().any(|f| f.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-6));
            if error < 1e-6 * (1.0 + length_scale) && !known {
                worst = worst.max(error);
                let in_range = (0..self.dof()).all(|k| self.contains(k, q[k]));
                found.push(Found { q, in_range, free: !candidate.free.is_empty(), branch: candidate.branch });
            }
        }
        found.sort_by(|a, b| {
            let order = a.q.iter().zip(&b.q).map(|(a, b)| b.total_cmp(a)).find(|o| o.is_ne());
            order.unwrap_or(std::cmp::Ordering::Equal)
        });
        (found, worst, missed)
    }

    /// Sum of squared differences, whole turns taken off.
    pub(super) fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).enumerate().map(|(k, (a, b))| self.distance_of(k, *a, *b).powi(2)).sum()
    }

    /// How far variable `k` moves between two values, whole turns taken off.
    pub(super) fn distance_of(&self, k: usize, a: f64, b: f64) -> f64 {
        let d = a - b;
        if self.wraps(k) { d.sin().atan2(d.cos()) } else { d }
    }
}

/// A quarter of the length scale, rounded down to one digit.
pub(super) fn slide(length_scale: f64) -> f64 {
    let unit = 10f64.powf((length_scale / 4.0).log10().floor());
    (length_scale / 4.0 / unit).floor() * unit
}

/// The arm with every parameter fixed: nominal values, 1 for lengths and 30 degrees for angles without one.
fn concrete(chain: &Chain) -> Chain {
    let mut chain = chain.clone();
    for p in &mut chain.parameters {
        let quantity = match p.handle {
            Handle::Length(_) => Quantity::Length,
            Handle::Angle(_) => Quantity::Angle,
        };
        if let Role::Field(value) = &p.role {
            let assumed = match quantity {
                Quantity::Length => Nominal::Length(Rational::ONE),
                Quantity::Angle => {
                    Nominal::Angle(AngleCell { half_turns: Rational::new(1, 6), ..AngleCell::default() })
                }
            };
            p.role = Role::Constant(value.clone().unwrap_or(assumed));
        }
    }
    chain
}
