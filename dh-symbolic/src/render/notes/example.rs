//! A worked example: a joint vector, its pose, and all joint vectors that the plan finds for it.

use super::{Block, Math, Phrase, Sign, Span, Text, Writer};
use crate::algebra::{Point, Rational, Transform};
use crate::chain::{AngleCell, Chain, Coordinate, Handle, Quantity, Role, Task, Value};
use crate::planner::{self, Plan, kernels::pose::Pose};
use crate::program::Inverse;

/// Degrees of the example's joints, one after the other; awkward enough to be in general position.
const DEGREES: [i64; 8] = [20, -35, 50, 40, -60, 75, 30, -25];

impl Writer<'_> {
    /// Appends the example; nothing where the task leaves freedom, or the arm has no solution to show.
    pub(super) fn example(&mut self, plan: Plan) {
        if self.chain.task != Task::Pose || plan.axes.count() != self.chain.dof() {
            return;
        }
        let chain = concrete(self.chain);
        let Ok(plan) = planner::search(&chain) else { return };
        let x: Vec<f64> = (0..chain.dof())
            .map(|k| {
                let degrees = DEGREES[k % DEGREES.len()];
                // A slide goes a quarter of the arm's reach.
                if plan.axes.turns(k) { (degrees as f64).to_radians() } else { slide(plan.axes.reach) }
            })
            .collect();
        let kinematics = crate::kinematics::Kinematics::new(&chain);
        let pose = |x: &[f64]| numbers(&chain, &plan, &kinematics.pose(), x);
        let goal = pose(&x);
        let reach = plan.axes.reach;
        let mut target: Pose = goal;
        for row in &mut target {
            row[3] /= reach;
        }
        let given: Vec<f64> = plan
            .knowledge
            .known
            .iter()
            .take(plan.given)
            .map(|k| k.form.iter().zip(&x).map(|(k, x)| f64::from(*k) * x).sum())
            .collect();
        let inverse = Inverse::derive(&chain, plan.clone());
        let mut found: Vec<Vec<f64>> = Vec::new();
        let mut worst = 0.0f64;
        for candidate in inverse.solve(&chain, &target, &given) {
            let y: Vec<f64> = (0..chain.dof())
                .map(|k| {
                    let value = candidate.x.get(k).copied().unwrap_or(f64::NAN);
                    if plan.axes.turns(k) { value.sin().atan2(value.cos()) } else { value * reach }
                })
                .collect();
            let error = difference(&pose(&y), &goal);
            let known = found.iter().any(|z| z.iter().zip(&y).all(|(a, b)| (a - b).abs() < 1e-6));
            if error < 1e-6 * (1.0 + reach) && !known {
                worst = worst.max(error);
                found.push(y);
            }
        }
        found.sort_by(|a, b| {
            a.iter().zip(b).map(|(a, b)| b.total_cmp(a)).find(|o| o.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
        });
        if !found.is_empty() {
            self.tell_example(&x, &goal, &found, worst);
        }
    }

    fn tell_example(&mut self, x: &[f64], goal: &Pose, found: &[Vec<f64>], worst: f64) {
        self.heading(2, Phrase::Example);
        let free: Vec<Math> = self
            .chain
            .parameters
            .iter()
            .filter(|p| matches!(p.role, Role::Field(None)))
            .filter(|p| crate::render::quantities::is_used(self.chain, p))
            .map(|p| {
                let name = crate::render::quantities::parameter(&self.notation, p);
                let value = match p.handle {
                    Handle::Length(_) => Math::number(1),
                    Handle::Angle(_) => Math::Row(vec![Math::number(30), Math::Sign(Sign::Degree)]),
                };
                Math::equation(name, value)
            })
            .collect();
        self.tell(Phrase::ExampleValues, free);
        let names: Vec<Math> = self
            .chain
            .joints
            .iter()
            .map(|j| match j.coordinate {
                Coordinate::Angle(v) => self.notation.angle(v),
                Coordinate::Length(s) => self.notation.symbol(s),
            })
            .collect();
        let turns: Vec<bool> = self.chain.joints.iter().map(|j| matches!(j.coordinate, Coordinate::Angle(_))).collect();
        let value = |k: usize, x: f64, places: usize| {
            if turns.get(k) == Some(&true) {
                Math::Row(vec![decimal(x.to_degrees(), places), Math::Sign(Sign::Degree)])
            } else {
                decimal(x, 4)
            }
        };
        let list: Vec<Math> =
            names.iter().zip(x).enumerate().map(|(k, (n, x))| Math::equation(n.clone(), value(k, *x, 0))).collect();
        self.tell(Phrase::ExamplePose, list);
        let mut rows: Vec<Vec<Math>> = goal.iter().map(|r| r.iter().map(|x| decimal(*x, 4)).collect()).collect();
        rows.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        self.display(Math::Letter('G'), Math::Matrix(rows));
        let exponent = worst.max(1e-12).log10().ceil() as i32;
        let bound = Math::number(10).above(Math::Row(vec![Math::Sign(Sign::Negative), Math::number(-exponent)]));
        match found.len() {
            1 => self.say(Phrase::ExampleSolution, vec![bound]),
            n => self.say(Phrase::ExampleSolutions, vec![Math::number(n), bound]),
        }
        let header: Vec<Text> = std::iter::once(Text::default()).chain(names.into_iter().map(Text::from)).collect();
        let rows = found
            .iter()
            .enumerate()
            .map(|(i, y)| {
                let number = Text(vec![Span::Plain((i + 1).to_string())]);
                let cells = y.iter().enumerate().map(|(k, y)| Text::from(value(k, *y, 2)));
                std::iter::once(number).chain(cells).collect()
            })
            .collect();
        self.blocks.push(Block::Table(header, rows));
    }
}

/// A quarter of the reach, rounded down to one digit.
fn slide(reach: f64) -> f64 {
    let unit = 10f64.powf((reach / 4.0).log10().floor());
    (reach / 4.0 / unit).floor() * unit
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
                Quantity::Length => Value::Length(Rational::ONE),
                Quantity::Angle => Value::Angle(AngleCell { half_turns: Rational::new(1, 6), ..AngleCell::default() }),
            };
            p.role = Role::Constant(value.clone().unwrap_or(assumed));
        }
    }
    chain
}

fn numbers(chain: &Chain, plan: &Plan, t: &Transform, x: &[f64]) -> Pose {
    let place = |c: Coordinate| plan.axes.coordinates.iter().position(|d| *d == c).and_then(|k| x.get(k)).copied();
    let point = Point {
        symbol: &|s| place(Coordinate::Length(s)).unwrap_or_else(|| chain.nominal(Handle::Length(s))),
        angle: &|v| place(Coordinate::Angle(v)).unwrap_or_else(|| chain.nominal(Handle::Angle(v))),
    };
    std::array::from_fn(|i| std::array::from_fn(|j| t.entry(i, j).evaluate(&point)))
}

fn difference(a: &Pose, b: &Pose) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// A number with some places, no minus before zero.
pub(super) fn decimal(x: f64, places: usize) -> Math {
    let text = format!("{x:.places$}");
    let zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
    match text.strip_prefix('-') {
        Some(rest) if zero => Math::number(rest),
        Some(rest) => Math::Row(vec![Math::Sign(Sign::Negative), Math::number(rest)]),
        None => Math::Number(text),
    }
}
