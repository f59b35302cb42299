//! Names in an explanation: frames on the axes, poses that are known, unknowns, where an equation comes from.

use super::Explanation;
use crate::algebra::{AngleVar, Symbol, Transform};
use crate::chain::{Chain, Convention, Coordinate, Elementary, Task};
use crate::planner::{Equation, KnownPose, Plan, Scalar, constant_height};
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Trig;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::{Name, Notation};

/// Letters for known poses after the target's, which is r and p. M is the matrix of the singular configurations.
const LETTERS: [&str; 8] = ["u", "v", "w", "h", "f", "n", "o", "l"];

/// A known pose that some step uses.
pub(crate) struct PoseName {
    /// Index in the plan's list.
    index: usize,
    /// The matrix, a capital letter.
    pub(crate) matrix: Math,
    /// What it is: the target with known motions taken off on the left and on the right; `None` for the target itself.
    pub(crate) product: Option<Math>,
    /// What else of it is used, with its meaning: the squared length of the position, the position seen from the other end.
    pub(super) extras: Vec<(Symbol, Math, Math)>,
    /// Name of its direction cosines and its position, with indices i, j.
    pub(crate) entries: [Math; 2],
}

/// Where equations come from.
pub(crate) enum Source {
    /// Elements (row, column) of a transform between two frames.
    Elements(Vec<(usize, usize)>, Math),
    /// Elements of its inverse.
    InverseElements(Vec<(usize, usize)>, Math),
    /// The squared distance of two frames' origins.
    Distance(Math, Math),
    /// The component of the way around the loop across two sliding joints.
    Across([Math; 2]),
    /// The same, where the way between two turning joints is taken apart along their axes.
    Bridge([Math; 2], [Math; 2]),
}

/// The chain's names and those of the plan.
pub(super) fn notation(chain: &Chain, plan: &Plan, base: &Notation) -> Notation {
    let ring = &plan.knowledge.ring;
    let mut notation = base.clone();
    notation.extend(&Notation::of_ring(ring));
    for (k, coordinate) in plan.axes.coordinates.iter().enumerate().skip(chain.joints.len()) {
        let name = Name { stem: ["psi", "phi", "chi"][k % 3].into(), index: String::new() };
        match coordinate {
            Coordinate::Angle(v) => notation.rename_angle(*v, name),
            Coordinate::Length(s) => notation.rename_symbol(*s, Name { stem: "z".into(), index: String::new() }),
        }
    }
    notation
}

/// The motions before frame 0 of the table: the base; where the task is in a plane, the target's height is 0.
fn to_frame_0(chain: &Chain) -> Transform {
    let height = constant_height(chain).filter(|_| chain.task == Task::Planar);
    let down = height.map(|h| Elementary::Translate(2, -&h));
    down.iter().chain(&chain.base).fold(Transform::identity(), |t, e| t.times(&e.transform()))
}

/// A weighted sum of names.
pub(super) fn weighted(pieces: impl Iterator<Item = (i8, Math)>) -> Math {
    let mut row = Vec::new();
    for (w, name) in pieces {
        match (row.is_empty(), w < 0) {
            (true, true) => row.push(Math::Sign(Sign::Negative)),
            (true, false) => {}
            (false, negative) => row.push(Math::Sign(if negative { Sign::Minus } else { Sign::Plus })),
        }
        if w.unsigned_abs() != 1 {
            row.push(Math::number(w.unsigned_abs()));
        }
        row.push(name);
    }
    Math::Row(row)
}

impl Explanation<'_> {
    /// The angles of a form with their factors; empty for a sliding joint.
    pub(super) fn angles(&self, form: &[i8]) -> Vec<(AngleVar, i8)> {
        let mut list: Vec<(AngleVar, i8)> = form
            .iter()
            .zip(&self.plan.axes.coordinates)
            .filter(|(k, _)| **k != 0)
            .filter_map(|(k, c)| match c {
                Coordinate::Angle(v) => Some((*v, *k)),
                Coordinate::Length(_) => None,
            })
            .collect();
        list.sort_unstable();
        list
    }

    /// theta3, theta234, d3.
    pub(super) fn unknown(&self, form: &[i8]) -> Math {
        let angles = self.angles(form);
        match angles.as_slice() {
            [] => {
                let length = form.iter().zip(&self.plan.axes.coordinates).find(|(k, _)| **k != 0);
                match length {
                    Some((_, Coordinate::Length(s))) => self.notation.symbol(*s),
                    _ => Math::number(0),
                }
            }
            [(v, 1)] => self.notation.angle(*v),
            _ => self.notation.angle_sum(&angles),
        }
    }

    /// theta234 and theta2 + theta3 + theta4.
    pub(super) fn sum(&self, form: &[i8]) -> Option<(Math, Math)> {
        let angles = self.angles(form);
        (angles.len() > 1).then(|| (self.notation.angle_sum(&angles), self.notation.combination(&angles)))
    }

    /// The name of a coordinate.
    pub(crate) fn coordinate(&self, k: usize) -> Math {
        match self.plan.axes.coordinates.get(k) {
            Some(Coordinate::Angle(v)) => self.notation.angle(*v),
            Some(Coordinate::Length(s)) => self.notation.symbol(*s),
            None => Math::number(0),
        }
    }

    pub(super) fn plan_pose(&self, i: usize) -> Option<&KnownPose> {
        self.plan.knowledge.poses.get(self.poses.get(i)?.index)
    }

    /// A frame of the axes: the number of the joint before it; with a prime where it is not the frame of the table but before the
    /// shift along the axis (modified convention), or after it (standard).
    fn frame(&self, hop: usize) -> (usize, bool) {
        let hops = &self.plan.axes.hops;
        let before = hops.get(..hop).unwrap_or(hops);
        let joints = before.iter().filter(|h| h.joint.is_some()).count();
        let shifted = before.last().is_some_and(|h| h.joint.is_none());
        // A tool translation isn't part of the frame's own shift.
        let own = !(self.end.is_some() && hop + 1 == hops.len());
        let will_shift = own && !before.is_empty() && hops.get(hop).is_some_and(|h| h.joint.is_none());
        (joints, if self.modified { will_shift && !shifted } else { shifted })
    }

    fn frame_at(&self, hop: usize) -> Frame {
        if let Some(end) = self.end.filter(|_| hop == self.plan.axes.hops.len()) {
            return end;
        }
        match self.frame(hop) {
            (0, false) if self.moved => Frame::Primed(0),
            (joint, true) => Frame::Primed(joint),
            (joint, false) => Frame::Row(joint),
        }
    }

    pub(super) fn frame_name(&self, hop: usize) -> Math {
        self.notation.frame(self.frame_at(hop))
    }

    /// The transform between two frames of the axes.
    pub(crate) fn between(&self, a: usize, b: usize) -> Math {
        self.notation.transform(self.frame_at(a), self.frame_at(b))
    }

    /// Numbers of the joints for which a primed frame occurs in the plan's equations or poses.
    pub(crate) fn primed(&self) -> Vec<usize> {
        let equations = self.plan.steps.iter().flat_map(|s| &s.equations).flat_map(|e| [e.a, e.b]);
        let poses = (0..self.poses.len()).filter_map(|i| self.plan_pose(i)).flat_map(|k| [k.left, k.right]);
        let inside = |hop: &usize| self.end.is_none() || *hop < self.plan.axes.hops.len();
        let mut list: Vec<usize> =
            equations.chain(poses).filter(inside).map(|hop| self.frame(hop)).filter(|f| f.1).map(|f| f.0).collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// The last frame, where a virtual joint or the tool's own shift leads to it.
    fn end_of(&self, chain: &Chain) -> Option<Frame> {
        let axes = &self.plan.axes;
        let last = axes.hops.last()?;
        if last.joint.is_some_and(|j| j >= axes.real) {
            return Some(Frame::Tool);
        }
        let link = chain.links.last()?;
        let own = match link.joint.and_then(|j| chain.joints.get(j)).map(|j| j.coordinate) {
            Some(Coordinate::Length(s)) => link.d != crate::algebra::Poly::symbol(s),
            _ => !link.d.is_zero(),
        };
        if last.joint.is_some() || own || !self.modified || chain.tool.is_empty() {
            return None;
        }
        let whole = axes.end == crate::algebra::Transform::identity();
        Some(if whole { Frame::Tool } else { Frame::Primed(chain.links.len()) })
    }

    /// Gives letters to the known poses that steps use, in order of first use.
    pub(super) fn name_poses(&mut self, chain: &Chain) {
        self.modified = chain.convention == Convention::Modified;
        self.end = self.end_of(chain);
        self.moved = self.plan.axes.start != to_frame_0(chain);
        let mut used: Vec<usize> = Vec::new();
        for step in &self.plan.steps {
            for c in &step.collected {
                for s in c.values().flat_map(crate::algebra::Poly::symbols) {
                    let pose = self.plan.knowledge.poses.iter().position(|k| k.symbols().any(|x| x == s));
                    if let Some(i) = pose.filter(|i| !used.contains(i)) {
                        used.push(i);
                    }
                }
            }
        }
        let hops = self.plan.axes.hops.len();
        let taken = |letter: &str| {
            let names = chain.parameters.iter().map(|p| Name::of(&p.name).stem);
            names.chain(chain.joints.iter().map(|j| Name::of(&j.name).stem)).any(|stem| stem == letter)
        };
        let mut letters = LETTERS.iter().filter(|l| !taken(l)).copied();
        for index in used {
            let Some(pose) = self.plan.knowledge.poses.get(index).cloned() else { continue };
            let whole = pose.left == 0 && pose.right == hops;
            let (r, p) = if whole { ("r", "p") } else { letters.next().map_or(("y", "y"), |l| (l, l)) };
            self.rename(&pose, r, p, index, whole);
        }
    }

    fn rename(&mut self, pose: &KnownPose, r: &str, p: &str, index: usize, whole: bool) {
        let name = |stem: &str, index: String| Name { stem: stem.into(), index };
        for (i, row) in pose.r.iter().enumerate() {
            for (j, s) in row.iter().enumerate() {
                self.notation.rename_symbol(*s, name(r, format!("{}{}", i + 1, j + 1)));
            }
        }
        let axes = ["x", "y", "z"];
        for (i, s) in pose.p.iter().enumerate() {
            self.notation.rename_symbol(*s, name(p, axes[i % 3].into()));
        }
        let letter = |stem: &str| Math::Letter(stem.chars().next().unwrap_or('p'));
        let squared = letter(p).above(Math::number(2));
        self.notation.set_symbol(pose.square, squared.clone());
        let mut extras = Vec::new();
        let [x, y, z] = ['x', 'y', 'z'].map(|a| letter(p).below(Math::Letter(a)).above(Math::number(2)));
        let plus = || Math::Sign(Sign::Plus);
        extras.push((pose.square, squared, Math::Row(vec![x, plus(), y, plus(), z])));
        for j in 0..3 {
            let Some(s) = pose.back.get(j).copied() else { continue };
            let back = letter(p).below(Math::Letter(['x', 'y', 'z'][j])).above(Math::Sign(Sign::Prime));
            self.notation.set_symbol(s, back.clone());
            let mut row = Vec::new();
            for (i, axis) in ['x', 'y', 'z'].into_iter().enumerate() {
                row.push(Math::Sign(if i == 0 { Sign::Negative } else { Sign::Minus }));
                row.push(letter(r).below(Math::number(format!("{}{}", i + 1, j + 1))));
                row.push(letter(p).below(Math::Letter(axis)));
            }
            extras.push((s, back, Math::Row(row)));
        }
        let matrix = if whole {
            self.between(0, self.plan.axes.hops.len())
        } else {
            Math::Letter(r.chars().next().map_or('U', |c| c.to_ascii_uppercase()))
        };
        let product = (!whole).then(|| {
            let hops = self.plan.axes.hops.len();
            let mut row = Vec::new();
            let inverse = |m: Math| {
                let minus_one = Math::Row(vec![Math::Sign(Sign::Negative), Math::number(1)]);
                m.above(minus_one)
            };
            if pose.left > 0 {
                row.extend([inverse(self.between(0, pose.left)), Math::Sign(Sign::Thin)]);
            }
            row.push(self.between(0, hops));
            if pose.right < hops {
                row.extend([Math::Sign(Sign::Thin), inverse(self.between(pose.right, hops))]);
            }
            Math::Row(row)
        });
        let entries = [letter(r).below(Math::Row(vec![Math::Letter('i'), Math::Letter('j')])), letter(p)];
        self.poses.push(PoseName { index, matrix, product, extras, entries });
    }

    /// The coordinate of a hop's joint.
    fn joint_of(&self, hop: usize) -> Math {
        let joint = self.plan.axes.hops.get(hop).and_then(|h| h.joint);
        joint.map_or(Math::number(0), |k| self.coordinate(k))
    }

    /// Where equations come from, those of one transform together.
    pub(super) fn sources(&self, equations: &[Equation]) -> Vec<Source> {
        let mut out: Vec<(usize, usize, Source)> = Vec::new();
        for e in equations {
            let (element, inverse) = match e.scalar {
                Scalar::Rotation(i, j) => ((usize::from(i) + 1, usize::from(j) + 1), false),
                Scalar::Position(i) => ((usize::from(i) + 1, 4), false),
                Scalar::Back(i) => ((usize::from(i) + 1, 4), true),
                Scalar::Distance => {
                    let source = Source::Distance(self.frame_name(e.a), self.frame_name(e.b));
                    out.push((e.a, e.b, source));
                    continue;
                }
                Scalar::Across(j) => {
                    out.push((e.a, e.b, Source::Across([e.a - 1, usize::from(j)].map(|h| self.joint_of(h)))));
                    continue;
                }
                Scalar::Bridge(i, j) => {
                    let slides = [i, j].map(|h| self.joint_of(usize::from(h)));
                    out.push((e.a, e.b, Source::Bridge(slides, [e.a, e.b - 1].map(|h| self.joint_of(h)))));
                    continue;
                }
            };
            let same = out.iter_mut().filter(|x| x.0 == e.a && x.1 == e.b).find_map(|x| match &mut x.2 {
                Source::Elements(list, _) if !inverse => Some(list),
                Source::InverseElements(list, _) if inverse => Some(list),
                _ => None,
            });
            match same {
                Some(list) => list.push(element),
                None => {
                    let of = self.between(e.a, e.b);
                    let list = vec![element];
                    let source = if inverse { Source::InverseElements(list, of) } else { Source::Elements(list, of) };
                    out.push((e.a, e.b, source));
                }
            }
        }
        out.into_iter().map(|x| x.2).collect()
    }
}

impl Notation {
    /// A sum of angles under one letter: theta234.
    pub(super) fn angle_sum(&self, angles: &[(AngleVar, i8)]) -> Math {
        let trig = self.trig(&Trig { angles: angles.to_vec(), sine: false });
        let letter = match angles.first().map(|(v, _)| self.angle(*v)) {
            Some(Math::Script(s)) => s.base,
            Some(m @ Math::Letter(_)) => m,
            _ => Math::Letter('θ'),
        };
        match trig {
            Math::Script(s) if s.base == Math::Letter('c') => match s.sub {
                Some(index) => letter.below(index),
                None => letter,
            },
            _ => self.combination(angles).in_brackets(),
        }
    }
}
