//! Names in an explanation: frames on the axes, poses that are known, unknowns, where an equation comes from.

use super::Explanation;
use super::places::{self, Definition, View};
use crate::algebra::{AngleVar, Symbol};
use crate::chain::{Chain, Coordinate};
use crate::planner::{Equation, FrameScalar, KnownPose, Plan};
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Trig;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::{Name, Notation};

/// Letters for known poses after the target's, which is r and p. M is the matrix of the singular configurations.
const LETTERS: [&str; 8] = ["u", "v", "w", "h", "f", "n", "o", "e"];

/// A known pose that some step uses.
pub(crate) struct PoseName {
    /// Index in the plan's list.
    pub(super) index: usize,
    /// The frames that it leads from and to.
    pub(crate) left: Frame,
    pub(crate) right: Frame,
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

/// Does no name of the chain begin with this letter, in either case?
pub(super) fn is_free(chain: &Chain, letter: &str) -> bool {
    let names = chain.parameters.iter().map(|p| &p.name).chain(chain.joints.iter().map(|j| &j.name));
    !names.map(|n| Name::of(n).stem).any(|stem| stem.eq_ignore_ascii_case(letter))
}

/// A product of matrices.
fn side_by_side(factors: Vec<Math>) -> Math {
    let mut row = Vec::new();
    for f in factors {
        if !row.is_empty() {
            row.push(Math::Sign(Sign::Thin));
        }
        row.push(f);
    }
    Math::Row(row)
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

    /// Views of a frame of the planner, those first in which poses are written.
    fn views(&self, link: usize, left: bool) -> Vec<View> {
        let Some(place) = self.places.get(link) else { return Vec::new() };
        let used = |v: &View| {
            self.poses.iter().any(|p| match left {
                true => p.left == v.frame,
                false => p.right == v.frame,
            })
        };
        let (mut first, rest): (Vec<View>, Vec<View>) = place.views.iter().cloned().partition(used);
        first.extend(rest);
        first
    }

    /// What the frames with primes are that occur in poses or equations, in order.
    pub(crate) fn definitions(&self) -> Vec<&Definition> {
        let mut used: Vec<Frame> = self.poses.iter().flat_map(|p| [p.left, p.right]).collect();
        for step in &self.steps {
            used.extend(step.frames.iter().copied());
        }
        let own = |p: &&places::PlannedFrame| used.contains(&p.own());
        self.places.iter().filter(own).filter_map(|p| p.definition.as_ref()).collect()
    }

    /// What a frame with primes is.
    pub(crate) fn definition(&self, frame: Frame) -> Option<&Definition> {
        self.places.iter().filter(|p| p.own() == frame).find_map(|p| p.definition.as_ref())
    }

    /// Is one of these symbols an entry of the pose, or made of its entries?
    pub(crate) fn has_entry(&self, pose: &PoseName, list: &[Symbol]) -> bool {
        self.plan.knowledge.poses.get(pose.index).is_some_and(|k| k.symbols().any(|s| list.contains(&s)))
    }

    /// The entries of a known pose and what is made of them, from its value.
    pub(crate) fn values(&self, pose: &PoseName, t: &[[f64; 4]; 3]) -> Vec<(Symbol, f64)> {
        let Some(k) = self.plan.knowledge.poses.get(pose.index) else { return Vec::new() };
        let column = |j: usize| t.iter().filter_map(move |row| row.get(j)).copied();
        let dot = |a: usize, b: usize| -> f64 { column(a).zip(column(b)).map(|(x, y)| x * y).sum() };
        let mut out: Vec<(Symbol, f64)> = Vec::new();
        for (symbols, row) in k.r.iter().zip(t) {
            out.extend(symbols.iter().copied().zip(row.iter().copied()));
        }
        out.extend(k.p.iter().copied().zip(column(3)));
        out.extend(k.back.iter().enumerate().map(|(j, s)| (*s, -dot(j, 3))));
        out.push((k.square, dot(3, 3)));
        out
    }

    /// The frames between which the given pose leads.
    pub(crate) fn whole(&self) -> [Frame; 2] {
        self.ends
    }

    /// Gives letters to the known poses that steps use, in order of first use.
    pub(super) fn name_poses(&mut self, chain: &Chain, written: &[(usize, Frame, Frame)]) {
        let taken = self.notation.style.taken.clone();
        let free = |l: &&&str| is_free(chain, l) && !l.chars().all(|c| taken.contains(&c));
        let mut letters = LETTERS.iter().filter(free).copied();
        for (index, left, right) in written {
            let Some(pose) = self.plan.knowledge.poses.get(*index).cloned() else { continue };
            let whole = [*left, *right] == self.ends;
            let letter = if whole { None } else { letters.next().or(Some("y")) };
            self.rename(&pose, letter, *index, [*left, *right]);
        }
    }

    /// The product of known transforms that a pose between two frames is.
    fn product(&self, [left, right]: [Frame; 2]) -> Math {
        let n = Frame::Row(self.rows);
        let inverse = |m: Math| m.above(Math::Row(vec![Math::Sign(Sign::Negative), Math::number(1)]));
        let mut factors = Vec::new();
        if left != Frame::Row(0) {
            factors.push(inverse(self.notation.transform(Frame::Row(0), left)));
        }
        // A pose with the same end that begins at frame 0 has a letter perhaps.
        let known = self.poses.iter().find(|p| p.left == Frame::Row(0) && p.right == right && left != p.left);
        if let Some(known) = known.filter(|p| p.product.is_some()) {
            factors.push(known.matrix.clone());
            return side_by_side(factors);
        }
        factors.push(self.notation.transform(Frame::Row(0), n));
        match right {
            Frame::Tool => factors.push(self.notation.transform(n, Frame::Tool)),
            Frame::PrimedTool(_) if self.ends[1] == Frame::Tool => {
                factors.push(self.notation.transform(n, Frame::Tool));
                factors.push(inverse(self.notation.transform(right, Frame::Tool)));
            }
            right if right == n => {}
            right => factors.push(inverse(self.notation.transform(right, n))),
        }
        side_by_side(factors)
    }

    fn rename(&mut self, pose: &KnownPose, own: Option<&str>, index: usize, [left, right]: [Frame; 2]) {
        let (r, p) = (own.unwrap_or("r"), own.unwrap_or("p"));
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
        let capital = own.and_then(|l| l.chars().next()).map(|c| c.to_ascii_uppercase());
        let matrix = Math::Letter(capital.unwrap_or('G'));
        let product = own.map(|_| self.product([left, right]));
        let entries = [letter(r).below(Math::Row(vec![Math::Letter('i'), Math::Letter('j')])), letter(p)];
        self.poses.push(PoseName { index, left, right, matrix, product, extras, entries });
    }

    /// The coordinate of a link's joint.
    fn joint_of(&self, link: usize) -> Math {
        let joint = self.plan.axes.links.get(link).and_then(|h| h.joint);
        joint.map_or(Math::number(0), |k| self.coordinate(k))
    }

    /// Where equations come from, those of one transform together; and the frames that this names.
    pub(super) fn sources(&self, equations: &[Equation]) -> (Vec<Source>, Vec<Frame>) {
        let mut out: Vec<([Frame; 2], Source)> = Vec::new();
        for e in equations {
            let joints = |links: [usize; 2]| links.map(|h| self.joint_of(h));
            let other = match e.scalar {
                FrameScalar::Distance => {
                    let used: Vec<Frame> = self.poses.iter().flat_map(|p| [p.left, p.right]).collect();
                    let ends = [e.a, e.b].map(|k| self.places.get(k).map_or(Frame::Row(0), |p| p.origin(&used)));
                    let [a, b] = ends.map(|f| self.notation.frame(f));
                    out.push((ends, Source::Distance(a, b)));
                    continue;
                }
                FrameScalar::Across(j) => Some(Source::Across(joints([e.a - 1, usize::from(j)]))),
                FrameScalar::Bridge(i, j) => {
                    let slides = joints([i, j].map(usize::from));
                    Some(Source::Bridge(slides, joints([e.a, e.b - 1])))
                }
                _ => None,
            };
            if let Some(source) = other {
                out.push((self.ends, source));
                continue;
            }
            let own = [e.a, e.b].map(|k| self.places.get(k).map_or(Frame::Row(0), places::PlannedFrame::own));
            let ring = &self.plan.knowledge.ring;
            let found = places::source(ring, &self.views(e.a, true), &self.views(e.b, false), e);
            let (a, b, scalar) = found.unwrap_or((own[0], own[1], e.scalar));
            let (element, inverse) = match scalar {
                FrameScalar::Rotation(i, j) => ((usize::from(i) + 1, usize::from(j) + 1), false),
                FrameScalar::Back(i) => ((usize::from(i) + 1, 4), true),
                FrameScalar::Position(i) => ((usize::from(i) + 1, 4), false),
                _ => continue,
            };
            let same = out.iter_mut().filter(|x| x.0 == [a, b]).find_map(|x| match &mut x.1 {
                Source::Elements(list, _) if !inverse => Some(list),
                Source::InverseElements(list, _) if inverse => Some(list),
                _ => None,
            });
            match same {
                Some(list) => list.push(element),
                None => {
                    let (of, list) = (self.notation.transform(a, b), vec![element]);
                    let source = if inverse { Source::InverseElements(list, of) } else { Source::Elements(list, of) };
                    out.push(([a, b], source));
                }
            }
        }
        let frames = out.iter().flat_map(|x| x.0).collect();
        (out.into_iter().map(|x| x.1).collect(), frames)
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
