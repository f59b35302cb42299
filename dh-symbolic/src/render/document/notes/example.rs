//! A worked example: joint values or a pose, the pose in numbers, all joint vectors that the plan finds for it, which of them
//! are in range, and the closest one to where the arm is.

use super::arm::{Arm, Found, Missed};
use super::given;
use super::{Block, Math, NotesWriter, Phrase, Sign, Span, Text};
use crate::algebra::Transform;
use crate::chain::{Chain, Handle, MotionSpec, Role, Task};
use crate::kinematics::Kinematics;
use crate::program::Inverse;
use crate::render::document::frames::{Frame, decimal};
use dh_kernels::pose::{self, Pose};
use std::rc::Rc;

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

/// A pose of the arm, its solutions, and the one whose way is followed in numbers.
pub(super) struct Sample {
    pub(super) arm: Arm,
    /// Joint values that the pose is made of, or that are given with it.
    pub(super) q: Vec<f64>,
    /// Where the arm is.
    pub(super) near: Vec<f64>,
    pub(super) goal: Pose,
    pub(super) found: Vec<Found>,
    worst: f64,
    missed: Missed,
    /// Index of the solution that is followed.
    pub(super) chosen: usize,
}

impl Sample {
    /// Solves the arm at the pose that the options of a note ask for.
    pub(super) fn new(chain: &Chain, inverse: Rc<Inverse>, start: &Start) -> Sample {
        let arm = Arm::new(chain, inverse);
        let fill = |given: &[Option<f64>], other: Vec<f64>| -> Vec<f64> {
            other.into_iter().enumerate().map(|(k, x)| given.get(k).copied().flatten().unwrap_or(x)).collect()
        };
        let q = fill(&start.at, arm.generic());
        let near = fill(&start.near, arm.rest());
        let goal = match &start.pose {
            Some(list) => list.iter().map(given::matrix).fold(pose::IDENTITY, |a, b| pose::compose(&a, &b)),
            None => arm.forward(&q),
        };
        let (found, worst, missed) = arm.solve(&goal, &q);
        let close = if start.pose.is_some() { &near } else { &q };
        let distance = |f: &Found| arm.distance(&f.q, close);
        let chosen = (0..found.len()).min_by(|a, b| distance(&found[*a]).total_cmp(&distance(&found[*b])));
        let chosen = chosen.unwrap_or(0);
        Sample { arm, q, near, goal, found, worst, missed, chosen }
    }

    /// The same with other names for the arm's joint angles.
    pub(super) fn seen_as(self, arm: Arm) -> Sample {
        Sample { arm, ..self }
    }

    /// The pose between the first and the last frame of the table.
    pub(super) fn inner(&self) -> Pose {
        inner(&self.arm, &self.goal)
    }
}

/// A pose without base and tool.
fn inner(arm: &Arm, goal: &Pose) -> Pose {
    let k = Kinematics::new(&arm.chain);
    let constant = |t: &Transform| arm.numbers(t, &[]);
    let inner = pose::compose(&pose::inverse(&constant(k.base())), goal);
    pose::compose(&inner, &pose::inverse(&constant(k.tool())))
}

impl NotesWriter<'_> {
    /// Appends the example; nothing where the arm has no inverse or no solution to show.
    pub(super) fn example(&mut self, start: &Start) {
        if !self.chain.settings.ik || self.chain.dof() == 0 {
            return;
        }
        let Ok(inverse) = &*self.solved() else { return };
        let Sample { arm, q, near, goal, found, worst, missed, chosen } =
            Sample::new(self.chain, inverse.clone(), start);
        if found.is_empty() && start.pose.is_none() {
            return;
        }
        self.heading(1, Phrase::Example);
        self.assumed();
        match &start.pose {
            Some(list) => {
                self.say(Phrase::ExampleGiven, vec![]);
                self.goal(&arm, &goal, Some(self.motions(list)));
                let chosen: Vec<Math> =
                    self.chain.settings.redundant.iter().map(|k| self.value_of(&arm, *k, q[*k], 2)).collect();
                if !chosen.is_empty() {
                    self.say(Phrase::ExampleChosen, vec![Math::list(&chosen)]);
                }
            }
            None => {
                let list = (0..arm.dof()).map(|k| self.value_of(&arm, k, q[k], 0)).collect();
                self.tell(Phrase::ExamplePose, list);
                self.goal(&arm, &goal, None);
            }
        }
        self.inner(&arm, &goal);
        self.solutions(&arm, &found, worst, &missed);
        let list: Vec<Vec<f64>> = found.iter().map(|f| arm.coordinates(&f.q)).collect();
        self.postures(&Kinematics::new(self.chain), &list);
        self.tree(&arm, &found);
        let apart = found.get(chosen).map_or(0.0, |f| if start.pose.is_some() { 1.0 } else { arm.distance(&f.q, &q) });
        self.in_numbers(&arm, &found, (chosen, apart));
        self.choice(&arm, &found, &near);
    }

    /// What parameters without a value are taken as.
    fn assumed(&mut self) {
        let free: Vec<Math> = self
            .chain
            .parameters
            .iter()
            .filter(|p| matches!(p.role, Role::Field(None)))
            .filter(|p| super::table::is_used(self.chain, p))
            .map(|p| {
                let name = crate::render::formula::quantities::parameter(&self.notation, p);
                let value = match p.handle {
                    Handle::Length(_) => Math::number(1),
                    Handle::Angle(_) => self.exact(30),
                };
                Math::equation(name, value)
            })
            .collect();
        self.tell(Phrase::ExampleValues, free);
    }

    /// theta1 or, where the actuators are not the joints, q1.
    fn variable(&self, arm: &Arm, k: usize) -> Math {
        let plain = arm.chain.is_direct() && self.chain.joints.get(k).is_some_and(|j| j.shift.is_zero());
        if plain { self.coordinate(k) } else { Math::Letter('q').below(Math::number(k + 1)) }
    }

    /// A value of a step.
    pub(super) fn plain_value(&self, arm: &Arm, x: f64, turns: bool) -> Math {
        if turns { self.notation.decimal_angle(x, self.angle_places()) } else { decimal(x, self.places(arm)) }
    }

    fn number_of(&self, arm: &Arm, k: usize, x: f64, places: usize) -> Math {
        if arm.is_revolute(k) { self.notation.decimal_angle(x, places) } else { entry(x, self.places(arm)) }
    }

    pub(super) fn value_of(&self, arm: &Arm, k: usize, x: f64, places: usize) -> Math {
        // Whole degrees without decimals.
        let whole = (x.to_degrees() - x.to_degrees().round()).abs() < 1e-9;
        let places = if whole { places } else { places.max(self.angle_places()) };
        Math::equation(self.variable(arm, k), self.number_of(arm, k, x, places))
    }

    /// Places of angles in degrees.
    fn angle_places(&self) -> usize {
        self.options.digits.saturating_sub(2)
    }

    /// Places of lengths, from the size of the arm.
    fn places(&self, arm: &Arm) -> usize {
        let digits = self.options.digits as f64;
        (digits - arm.inverse.plan.axes.length_scale.log10().floor()).clamp(0.0, digits + 2.0) as usize
    }

    /// The pose, as far as the task asks for it.
    fn goal(&mut self, arm: &Arm, goal: &Pose, product: Option<Math>) {
        let length = self.places(arm);
        let matrix = self.numbers(goal, length);
        self.display_product(Math::Letter('G'), product, matrix);
        let p: Vec<Math> = goal.iter().map(|r| decimal(r[3], length)).collect();
        let vector = |list: Vec<Math>| Math::Matrix(list.into_iter().map(|m| vec![m]).collect());
        let named = |letter: char, right: Math| (Math::Letter(letter), right);
        let (phrase, list) = match self.chain.settings.task {
            Task::Pose => return,
            Task::Position => (Phrase::ExamplePosition, vec![named('p', vector(p))]),
            Task::Axis => {
                let z = goal.iter().map(|r| decimal(r[2], self.options.digits)).collect();
                (Phrase::ExampleAxis, vec![named('p', vector(p)), named('z', vector(z))])
            }
            Task::Planar => {
                let phi = self.notation.decimal_angle(goal[1][0].atan2(goal[0][0]), self.angle_places());
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
            r.iter()
                .enumerate()
                .map(|(j, x)| entry(*x, if j == 3 { length } else { self.options.digits }))
                .collect::<Vec<Math>>()
        };
        let mut rows: Vec<Vec<Math>> = t.iter().map(row).collect();
        rows.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        Math::Matrix(rows)
    }

    /// D_x(830) R_z(35 degrees).
    fn motions(&self, list: &[MotionSpec]) -> Math {
        let factor = |m: &MotionSpec| {
            let (letter, axis, value) = match m {
                // The pose of an example is given by numbers.
                MotionSpec::Pose(_) => return Math::Row(vec![]),
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
    fn inner(&mut self, arm: &Arm, goal: &Pose) {
        if self.chain.settings.task != Task::Pose || (self.chain.base.is_empty() && self.chain.tool.is_empty()) {
            return;
        }
        let inner = inner(arm, goal);
        self.say(Phrase::WithoutBaseAndTool, vec![]);
        let matrix = self.numbers(&inner, self.places(arm));
        let n = self.chain.links.len();
        self.display_product(self.notation.transform(Frame::Row(0), Frame::Row(n)), None, matrix);
    }

    fn solutions(&mut self, arm: &Arm, found: &[Found], worst: f64, missed: &Missed) {
        if found.is_empty() {
            self.missed(arm, missed);
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
        let branches = found.len() > 1 && !arm.namings().is_empty();
        if branches {
            header.push(self.words(Phrase::Configuration).into());
        }
        if ranges {
            header.push(self.words(Phrase::InRange).into());
        }
        let row = |(i, f): (usize, &Found)| {
            let mut row = vec![Text(vec![Span::Plain((i + 1).to_string())])];
            row.extend(
                f.q.iter().enumerate().map(|(k, x)| Text::from(self.number_of(arm, k, *x, self.angle_places()))),
            );
            if branches {
                row.push(self.branch(arm, &f.branch).into());
            }
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

    /// The reason if there is no solution.
    fn missed(&mut self, arm: &Arm, missed: &Missed) {
        self.say(Phrase::ExampleNone, vec![]);
        match missed {
            Missed::Unknown => {}
            Missed::NotOnTask => self.say(Phrase::ExampleNotOnTask, vec![]),
            Missed::Short(s) => {
                let phrase = match (s.is_distance, s.needs > s.has) {
                    (true, true) => Phrase::ExampleTooFar,
                    (true, false) => Phrase::ExampleTooNear,
                    (false, _) => Phrase::ExampleBeyond,
                };
                let size = |x: f64| match s.is_distance {
                    true => decimal(x * arm.inverse.plan.axes.length_scale, self.places(arm)),
                    false => decimal(x, 4),
                };
                let pieces = vec![Math::number(s.step + 1), Math::word(&s.unknowns), size(s.needs), size(s.has)];
                self.say(phrase, pieces);
            }
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
