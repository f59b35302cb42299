//! A worked example: joint values or a pose, the pose in numbers, all joint vectors that the plan finds for it, which of them
//! are in range, and the closest one to where the arm is.

use super::given;
use super::{Block, Math, Phrase, Sign, Span, Text, Writer};
use crate::algebra::{Point, Poly, Rational, Transform};
use crate::chain::{AngleCell, Chain, Coordinate, Handle, MotionSpec, Quantity, Role, Task, Value};
use crate::kinematics::Kinematics;
use crate::planner::kernels::pose::{self, Pose};
use crate::planner::{self, Plan};
use crate::program::Inverse;
use crate::render::style::{Frame, decimal};
use std::f64::consts::TAU;

/// Degrees of the example's joints, one after the other; awkward enough to be in general position.
const DEGREES: [i64; 8] = [20, -35, 50, 40, -60, 75, 30, -25];

/// Degrees of variable `k` in general position.
pub(super) fn generic_degrees(k: usize) -> f64 {
    DEGREES[k % DEGREES.len()] as f64
}

/// What the example starts from.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// Values of the variables that were given.
    at: Vec<Option<f64>>,
    /// The pose as a product of motions.
    pose: Option<Vec<MotionSpec>>,
    /// Where the arm is.
    near: Vec<Option<f64>>,
}

impl Start {
    /// The value that was given for a variable.
    pub(super) fn value(&self, k: usize) -> Option<f64> {
        self.at.get(k).copied().flatten()
    }

    /// Reads the options of a note.
    ///
    /// # Errors
    /// What is wrong with their texts.
    pub(super) fn read(chain: &Chain, options: &super::Options) -> Result<Start, String> {
        let values = |what: &str, text: &Option<String>| match text {
            Some(text) => given::joints(chain, what, text),
            None => Ok(vec![None; chain.dof()]),
        };
        Ok(Start {
            at: values("--at", &options.at)?,
            pose: options.pose.as_ref().map(|text| given::motions(chain, "--pose", text)).transpose()?,
            near: values("--near", &options.near)?,
        })
    }
}

/// The arm in numbers.
pub(super) struct Arm {
    pub(super) chain: Chain,
    pub(super) plan: Plan,
    pose: Transform,
}

/// One solution.
pub(super) struct Found {
    pub(super) q: Vec<f64>,
    in_range: bool,
    free: bool,
}

impl Arm {
    fn new(chain: &Chain) -> Option<Arm> {
        let chain = concrete(chain);
        let plan = planner::search(&chain).ok()?;
        let pose = Kinematics::new(&chain).pose();
        Some(Arm { chain, plan, pose })
    }

    fn dof(&self) -> usize {
        self.chain.dof()
    }

    pub(super) fn turns(&self, k: usize) -> bool {
        matches!(self.chain.joints.get(k).map(|j| j.coordinate), Some(Coordinate::Angle(_)))
    }

    /// Can whole turns be added to variable `k`?
    fn wraps(&self, k: usize) -> bool {
        self.turns(k) && self.chain.is_direct()
    }

    fn range(&self, k: usize) -> Option<(f64, f64)> {
        let (low, high) = self.chain.joints.get(k)?.range.as_ref()?;
        Some((given::bound(low), given::bound(high)))
    }

    fn contains(&self, k: usize, x: f64) -> bool {
        self.range(k).is_none_or(|(low, high)| x >= low - 1e-9 && x <= high + 1e-9)
    }

    /// Values in general position: within the ranges where there are some.
    fn generic(&self) -> Vec<f64> {
        let value = |k: usize| {
            let x = if self.turns(k) {
                (DEGREES[k % DEGREES.len()] as f64).to_radians()
            } else {
                slide(self.plan.axes.reach)
            };
            match self.range(k).filter(|_| !self.contains(k, x)) {
                Some((low, high)) => low + 0.4 * (high - low),
                None => x,
            }
        };
        (0..self.dof()).map(value).collect()
    }

    /// Zero, or the middle of the range where zero is not in it.
    fn rest(&self) -> Vec<f64> {
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
    fn evaluate(&self, p: &Poly, x: &[f64]) -> f64 {
        let joint = |c: Coordinate| self.chain.joints.iter().position(|j| j.coordinate == c).and_then(|k| x.get(k));
        p.evaluate(&Point {
            symbol: &|s| joint(Coordinate::Length(s)).copied().unwrap_or_else(|| self.chain.nominal(Handle::Length(s))),
            angle: &|v| joint(Coordinate::Angle(v)).copied().unwrap_or_else(|| self.chain.nominal(Handle::Angle(v))),
        })
    }

    fn numbers(&self, t: &Transform, x: &[f64]) -> Pose {
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

    fn forward(&self, q: &[f64]) -> Pose {
        self.numbers(&self.pose, &self.coordinates(q))
    }

    /// How far a pose misses what the task asks for.
    fn misses(&self, a: &Pose, b: &Pose) -> f64 {
        let counts = |i: usize, j: usize| match self.chain.task {
            Task::Pose => true,
            Task::Position => j == 3,
            Task::Axis => j >= 2,
            Task::Planar => i < 2 && (j == 0 || j == 3),
        };
        let all = (0..3).flat_map(|i| (0..4).map(move |j| (i, j)));
        all.filter(|(i, j)| counts(*i, *j)).map(|(i, j)| (a[i][j] - b[i][j]).abs()).fold(0.0, f64::max)
    }

    /// All solutions, greatest first value first, and the greatest error.
    fn solve(&self, goal: &Pose, q: &[f64]) -> (Vec<Found>, f64) {
        let reach = self.plan.axes.reach;
        let mut target = *goal;
        for row in &mut target {
            row[3] /= reach;
        }
        let x = self.coordinates(q);
        let known = self.plan.knowledge.known.iter().take(self.plan.given);
        let given: Vec<f64> = known
            .map(|k| {
                let value =
                    |(c, (j, x)): (&i8, (usize, &f64))| f64::from(*c) * if self.turns(j) { *x } else { x / reach };
                k.form.iter().zip(x.iter().enumerate()).map(value).sum()
            })
            .collect();
        let inverse = Inverse::derive(&self.chain, self.plan.clone());
        let (mut found, mut worst): (Vec<Found>, f64) = (Vec::new(), 0.0);
        for candidate in inverse.solve(&self.chain, &target, &given) {
            let y: Vec<f64> = (0..self.dof())
                .map(|k| {
                    let x = candidate.x.get(k).copied().unwrap_or(f64::NAN);
                    if self.turns(k) { x.sin().atan2(x.cos()) } else { x * reach }
                })
                .collect();
            let q = self.variables(&y);
            let error = self.misses(&self.forward(&q), goal);
            let known = found.iter().any(|f| f.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-6));
            if error < 1e-6 * (1.0 + reach) && !known {
                worst = worst.max(error);
                let in_range = (0..self.dof()).all(|k| self.contains(k, q[k]));
                found.push(Found { q, in_range, free: !candidate.free.is_empty() });
            }
        }
        found.sort_by(|a, b| {
            let order = a.q.iter().zip(&b.q).map(|(a, b)| b.total_cmp(a)).find(|o| o.is_ne());
            order.unwrap_or(std::cmp::Ordering::Equal)
        });
        (found, worst)
    }

    /// Sum of squared differences, whole turns taken off.
    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        let one = |(k, (a, b)): (usize, (&f64, &f64))| {
            let d = a - b;
            if self.wraps(k) { d.sin().atan2(d.cos()).powi(2) } else { d * d }
        };
        a.iter().zip(b).enumerate().map(one).sum()
    }
}

impl Writer<'_> {
    /// Appends the example; nothing where the arm has no inverse or no solution to show.
    pub(super) fn example(&mut self, start: &Start) {
        if !self.chain.ik || self.chain.dof() == 0 {
            return;
        }
        let Some(arm) = Arm::new(self.chain) else { return };
        let fill = |given: &[Option<f64>], other: Vec<f64>| -> Vec<f64> {
            other.into_iter().enumerate().map(|(k, x)| given.get(k).copied().flatten().unwrap_or(x)).collect()
        };
        let q = fill(&start.at, arm.generic());
        let near = fill(&start.near, arm.rest());
        let goal = match &start.pose {
            Some(list) => list.iter().map(given::matrix).fold(pose::IDENTITY, |a, b| pose::compose(&a, &b)),
            None => arm.forward(&q),
        };
        let (found, worst) = arm.solve(&goal, &q);
        if found.is_empty() && start.pose.is_none() {
            return;
        }
        self.heading(1, Phrase::Example);
        self.assumed();
        match &start.pose {
            Some(list) => {
                self.say(Phrase::ExampleGiven, vec![]);
                self.goal(&arm, &goal, Some(self.motions(list)));
                if let Some(k) = self.chain.redundant {
                    self.say(Phrase::ExampleChosen, vec![self.value_of(&arm, k, q[k], 2)]);
                }
            }
            None => {
                let list = (0..arm.dof()).map(|k| self.value_of(&arm, k, q[k], 0)).collect();
                self.tell(Phrase::ExamplePose, list);
                self.goal(&arm, &goal, None);
            }
        }
        self.without_constants(&arm, &goal);
        self.solutions(&arm, &found, worst);
        let list: Vec<Vec<f64>> = found.iter().map(|f| arm.coordinates(&f.q)).collect();
        self.postures(&Kinematics::new(self.chain), &list);
        self.tree(&arm, &found);
        self.choice(&arm, &found, &near);
    }

    /// What parameters without a value are taken as.
    fn assumed(&mut self) {
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
                    Handle::Angle(_) => self.exact(30),
                };
                Math::equation(name, value)
            })
            .collect();
        self.tell(Phrase::ExampleValues, free);
    }

    /// theta1 or, where the motors are not the joints, q1.
    fn variable(&self, arm: &Arm, k: usize) -> Math {
        let plain = arm.chain.is_direct() && self.chain.joints.get(k).is_some_and(|j| j.shift.is_zero());
        if plain { self.coordinate(k) } else { Math::Letter('q').below(Math::number(k + 1)) }
    }

    /// A value of a step.
    pub(super) fn plain_value(&self, arm: &Arm, x: f64, turns: bool) -> Math {
        if turns { self.notation.decimal_angle(x, 2) } else { decimal(x, self.places(arm)) }
    }

    fn number_of(&self, arm: &Arm, k: usize, x: f64, places: usize) -> Math {
        if arm.turns(k) { self.notation.decimal_angle(x, places) } else { entry(x, self.places(arm)) }
    }

    fn value_of(&self, arm: &Arm, k: usize, x: f64, places: usize) -> Math {
        // Whole degrees without decimals.
        let whole = (x.to_degrees() - x.to_degrees().round()).abs() < 1e-9;
        let places = if whole { places } else { places.max(2) };
        Math::equation(self.variable(arm, k), self.number_of(arm, k, x, places))
    }

    /// Places of lengths, from the size of the arm.
    fn places(&self, arm: &Arm) -> usize {
        (4.0 - arm.plan.axes.reach.log10().floor()).clamp(0.0, 6.0) as usize
    }

    /// The pose, as far as the task asks for it.
    fn goal(&mut self, arm: &Arm, goal: &Pose, product: Option<Math>) {
        let length = self.places(arm);
        let matrix = self.numbers(goal, length);
        self.display_product(Math::Letter('G'), product, matrix);
        let p: Vec<Math> = goal.iter().map(|r| decimal(r[3], length)).collect();
        let vector = |list: Vec<Math>| Math::Matrix(list.into_iter().map(|m| vec![m]).collect());
        let named = |letter: char, right: Math| (Math::Letter(letter), right);
        let (phrase, list) = match self.chain.task {
            Task::Pose => return,
            Task::Position => (Phrase::ExamplePosition, vec![named('p', vector(p))]),
            Task::Axis => {
                let z = goal.iter().map(|r| decimal(r[2], 4)).collect();
                (Phrase::ExampleAxis, vec![named('p', vector(p)), named('z', vector(z))])
            }
            Task::Planar => {
                let phi = self.notation.decimal_angle(goal[1][0].atan2(goal[0][0]), 2);
                let names = ['x', 'y'].into_iter().zip(p).map(|(n, v)| named(n, v));
                (Phrase::ExamplePlanar, names.chain([named('φ', phi)]).collect())
            }
        };
        self.say(phrase, vec![]);
        let list = list.into_iter().map(|(l, r)| super::Equation { left: l, right: vec![r], number: None }).collect();
        self.blocks.push(Block::Equations(list));
    }

    fn numbers(&self, t: &Pose, length: usize) -> Math {
        let row = |r: &[f64; 4]| {
            r.iter().enumerate().map(|(j, x)| entry(*x, if j == 3 { length } else { 4 })).collect::<Vec<Math>>()
        };
        let mut rows: Vec<Vec<Math>> = t.iter().map(row).collect();
        rows.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        Math::Matrix(rows)
    }

    /// D_x(830) R_z(35 degrees).
    fn motions(&self, list: &[MotionSpec]) -> Math {
        let factor = |m: &MotionSpec| {
            let (letter, axis, value) = match m {
                MotionSpec::Translate(axis, x) => {
                    let x = given::length(x);
                    let text = Math::number(x.abs());
                    ('D', axis, if x < 0.0 { Math::Row(vec![Math::Sign(Sign::Negative), text]) } else { text })
                }
                MotionSpec::Rotate(axis, angle) => {
                    let value = match &angle.approx {
                        None => {
                            let (negative, m) = self.notation.exact_angle(angle.exact().factor());
                            if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m }
                        }
                        Some(_) => self.notation.decimal_angle(angle.radians(), 4),
                    };
                    ('R', axis, value)
                }
            };
            let name = Math::Letter(letter).below(Math::Letter(['x', 'y', 'z'][axis % 3]));
            Math::Row(vec![name, value.in_brackets()])
        };
        super::side_by_side(list.iter().map(factor).collect())
    }

    /// The pose between the first and the last frame, where base or tool is more than that.
    fn without_constants(&mut self, arm: &Arm, goal: &Pose) {
        let (base, tool) = (!self.chain.base.is_empty(), !self.chain.tool.is_empty());
        if self.chain.task != Task::Pose || !(base || tool) {
            return;
        }
        let k = Kinematics::new(&arm.chain);
        let constant = |t: &Transform| arm.numbers(t, &[]);
        let inner = pose::compose(&pose::inverse(&constant(k.base())), goal);
        let inner = pose::compose(&inner, &pose::inverse(&constant(k.tool())));
        let n = self.chain.links.len();
        let inverse = |m: Math| m.above(Math::Row(vec![Math::Sign(Sign::Negative), Math::number(1)]));
        let mut product = vec![Math::Letter('G')];
        if base {
            product.insert(0, inverse(self.notation.transform(Frame::Base, Frame::Row(0))));
        }
        if tool {
            product.push(inverse(self.notation.transform(Frame::Row(n), Frame::Tool)));
        }
        self.say(Phrase::ExampleInner, vec![]);
        let matrix = self.numbers(&inner, self.places(arm));
        self.display_product(
            self.notation.transform(Frame::Row(0), Frame::Row(n)),
            Some(super::side_by_side(product)),
            matrix,
        );
    }

    fn solutions(&mut self, arm: &Arm, found: &[Found], worst: f64) {
        if found.is_empty() {
            self.say(Phrase::ExampleNone, vec![]);
            return;
        }
        let exponent = worst.max(1e-12).log10().ceil() as i32;
        let bound = Math::number(10).above(Math::Row(vec![Math::Sign(Sign::Negative), Math::number(-exponent)]));
        match found.len() {
            1 => self.say(Phrase::ExampleSolution, vec![bound]),
            n => self.say(Phrase::ExampleSolutions, vec![Math::number(n), bound]),
        }
        let ranges = (0..arm.dof()).any(|k| arm.range(k).is_some());
        let mut header = vec![Text::default()];
        header.extend((0..arm.dof()).map(|k| Text::from(self.variable(arm, k))));
        if ranges {
            header.push(self.words(Phrase::InRange).into());
        }
        let row = |(i, f): (usize, &Found)| {
            let mut row = vec![Text(vec![Span::Plain((i + 1).to_string())])];
            row.extend(f.q.iter().enumerate().map(|(k, x)| Text::from(self.number_of(arm, k, *x, 2))));
            if ranges {
                row.push(self.words(if f.in_range { Phrase::Yes } else { Phrase::No }).into());
            }
            row
        };
        let rows = found.iter().enumerate().map(row).collect();
        self.blocks.push(Block::Table(header, rows));
        let free: Vec<String> =
            found.iter().enumerate().filter(|(_, f)| f.free).map(|(i, _)| (i + 1).to_string()).collect();
        if !free.is_empty() {
            let pieces = vec![Span::Plain(free.join(", "))];
            self.blocks.push(Block::Paragraph(Text::fill(self.words(Phrase::ExampleFree), pieces)));
        }
    }

    /// The closest solution, and the closest one in range where that is another.
    fn choice(&mut self, arm: &Arm, found: &[Found], near: &[f64]) {
        if found.len() < 2 {
            return;
        }
        let closest = |only: bool| {
            let list = found.iter().enumerate().filter(|(_, f)| f.in_range || !only);
            list.min_by(|a, b| arm.distance(&a.1.q, near).total_cmp(&arm.distance(&b.1.q, near))).map(|(i, _)| i + 1)
        };
        let Some(best) = closest(false) else { return };
        let list: Vec<Math> = (0..arm.dof()).map(|k| self.value_of(arm, k, near[k], 0)).collect();
        let mut text = Text::default();
        let mut halves = self.words(Phrase::ExampleClosest).split("{}");
        text.0.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
        text.0.extend(super::inverse::listed(&list));
        text.0.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
        text.0.push(Span::Plain(best.to_string()));
        text.0.push(Span::Plain(halves.next().unwrap_or_default().to_string()));
        match closest(true) {
            Some(other) if other != best => {
                text.0.extend(
                    Text::fill(self.words(Phrase::ExampleClosestInRange), vec![Span::Plain(other.to_string())]).0,
                );
            }
            None => text.0.push(Span::Plain(self.words(Phrase::ExampleNoneInRange).to_string())),
            Some(_) => {}
        }
        text.0.retain(|s| !matches!(s, Span::Plain(t) if t.is_empty()));
        self.blocks.push(Block::Paragraph(text));
    }
}

/// A number; 0 and 1 without decimals where they are meant.
fn entry(x: f64, places: usize) -> Math {
    let whole = x.round();
    if (x - whole).abs() < 1e-12 && whole.abs() <= 1.0 { decimal(whole, 0) } else { decimal(x, places) }
}

/// A quarter of the reach, rounded down to one digit.
pub(super) fn slide(reach: f64) -> f64 {
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
