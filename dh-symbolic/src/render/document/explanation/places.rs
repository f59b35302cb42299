//! Where the planner's frames stand among those of the table, and its known poses and elements as the table's frames see them.
//!
//! The planner's frames stand on the joint axes, right behind the motion of each joint and behind the shift along the axis. A document
//! uses the frames of the table wherever the equations are as short there; other frames have primes and are defined by the constant
//! motion that joins them to a frame of the table.

use crate::algebra::{LinearAngle, Poly, Rational, Ring, Symbol, Transform, dot};
use crate::chain::{Chain, Coordinate, Elementary};
use crate::planner::{Axes, Equation, FrameScalar, Item, KnownPose};
use crate::render::document::frames::Frame;

/// A frame that a pose may be seen from or lead to, and the constant motion to it from the planner's frame.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub(super) frame: Frame,
    motion: Transform,
    /// Which parts of the planner's frame this one shares; the rest is left open by the task.
    shares: Shares,
}

/// What a frame has in common with another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shares {
    All,
    /// All but the height of the origin.
    NoHeight,
    /// The origin and the z axis.
    ZAxis,
    /// The origin.
    Origin,
}

/// What a frame with primes is.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    /// Where the motion begins,
    pub(crate) from: Frame,
    /// and where it ends.
    pub(crate) to: Frame,
    /// The motion, in order.
    pub(crate) factors: Vec<Elementary>,
}

/// A frame of the planner.
#[derive(Clone, Debug)]
pub(super) struct PlannedFrame {
    /// In which frames its elements may be written, the most welcome first; the last one is the frame itself.
    pub(super) views: Vec<View>,
    /// What the frame itself is, where it is none of the table.
    pub(super) definition: Option<Definition>,
    /// A frame with this origin.
    origin: Frame,
}

impl PlannedFrame {
    /// A frame with this origin, one of these where there is one.
    pub(super) fn origin(&self, used: &[Frame]) -> Frame {
        let here = |v: &&View| v.motion.p.iter().all(Poly::is_zero) && v.shares != Shares::NoHeight;
        self.views.iter().filter(here).find(|v| used.contains(&v.frame)).map_or(self.origin, |v| v.frame)
    }

    /// The frame itself.
    pub(super) fn own(&self) -> Frame {
        self.views.last().map_or(Frame::Row(0), |v| v.frame)
    }
}

/// A frame of the table on the way from a frame of the planner, forwards or backwards.
struct Mark {
    frame: Frame,
    /// From the planner's frame to this one.
    motion: Transform,
    /// The same, or its inverse where the mark stands behind, as elementary motions.
    factors: Vec<Elementary>,
    shares: Shares,
}

/// All frames of the planner, from the first to the last one.
pub(super) fn places(chain: &Chain, axes: &Axes) -> Vec<PlannedFrame> {
    let mut taken: Vec<Frame> = Vec::new();
    (0..axes.places.len()).map(|k| place(chain, axes, k, &mut taken)).collect()
}

fn place(chain: &Chain, axes: &Axes, k: usize, taken: &mut Vec<Frame>) -> PlannedFrame {
    let at = axes.places.get(k).copied().unwrap_or(0);
    let (before, behind) = axes.items.split_at(at.min(axes.items.len()));
    let (forward, backward) = (forward(chain, axes, behind), backward(chain, axes, before));
    let origin = |own: Frame| {
        let here = |m: &&Mark| m.motion.p.iter().all(Poly::is_zero) && m.shares != Shares::NoHeight;
        forward
            .iter()
            .chain(&backward)
            .find(here)
            .map_or_else(|| before_turn(chain, axes, before).unwrap_or(own), |m| m.frame)
    };
    let view = |m: &Mark| View { frame: m.frame, motion: m.motion.clone(), shares: m.shares };
    let same = |m: &&Mark| m.motion == Transform::identity() && m.shares == Shares::All;
    if let Some(mark) = forward.iter().chain(&backward).find(same) {
        return PlannedFrame { views: vec![view(mark)], definition: None, origin: origin(mark.frame) };
    }
    let mut views: Vec<View> = forward.iter().chain(&backward).map(view).collect();
    let (mut own, mut definition) = (Frame::Row(0), None);
    if let Some((mark, ahead)) = forward.first().map(|m| (m, true)).or(backward.first().map(|m| (m, false))) {
        taken.push(mark.frame);
        let primes = taken.iter().filter(|f| **f == mark.frame).count();
        own = mark.frame.primed(u8::try_from(primes).unwrap_or(u8::MAX));
        let (from, to) = if ahead { (own, mark.frame) } else { (mark.frame, own) };
        definition = Some(Definition { from, to, factors: mark.factors.clone() });
    }
    views.push(View { frame: own, motion: Transform::identity(), shares: Shares::All });
    PlannedFrame { views, definition, origin: origin(own) }
}

/// The frame of the table at an item, under the name that it has in this chain.
fn marked(chain: &Chain, item: &Item) -> Option<Frame> {
    match item {
        Item::Frame(i) => Some(Frame::Row(*i)),
        Item::Base if !chain.base.is_empty() => Some(Frame::Base),
        Item::Tool if !chain.tool.is_empty() => Some(Frame::Tool),
        _ => None,
    }
}

/// Frames ahead, up to the next joint.
fn forward(chain: &Chain, axes: &Axes, items: &[Item]) -> Vec<Mark> {
    let (mut motion, mut factors, mut shares) = (Transform::identity(), Vec::new(), Shares::All);
    let mut out = Vec::new();
    for item in items {
        match item {
            Item::Constant(e) => {
                motion = motion.times(&e.transform());
                factors.push(e.clone());
            }
            // The height that a task in the plane leaves open.
            Item::Joint(j) if *j >= axes.real && !axes.is_revolute(*j) => {
                shares = Shares::NoHeight;
                factors.extend(virtual_motion(axes, *j));
            }
            Item::Joint(_) => break,
            mark => {
                let frame = marked(chain, mark);
                out.extend(frame.map(|frame| Mark { frame, motion: motion.clone(), factors: factors.clone(), shares }));
            }
        }
    }
    out
}

/// Frames behind, back to the joint before.
fn backward(chain: &Chain, axes: &Axes, items: &[Item]) -> Vec<Mark> {
    let (mut motion, mut factors) = (Transform::identity(), Vec::new());
    let mut turns = 0;
    let mut out = Vec::new();
    for item in items.iter().rev() {
        match item {
            Item::Constant(e) => {
                motion = e.transform().times(&motion);
                factors.insert(0, e.clone());
            }
            Item::Joint(j) if *j >= axes.real && axes.is_revolute(*j) => {
                turns += 1;
                factors.splice(0..0, virtual_motion(axes, *j));
            }
            Item::Joint(_) => break,
            mark => {
                let shares = [Shares::All, Shares::ZAxis].get(turns).copied().unwrap_or(Shares::Origin);
                // Of turns that are open only the point counts about which they turn.
                let back = if turns == 0 { motion.inverse() } else { Transform::identity() };
                let mark = marked(chain, mark).or((turns > 0 && *mark == Item::Tool).then(|| last_row(chain)));
                out.extend(mark.map(|frame| Mark { frame, motion: back, factors: factors.clone(), shares }));
                if turns > 0 {
                    break;
                }
            }
        }
    }
    out
}

fn last_row(chain: &Chain) -> Frame {
    Frame::Row(chain.links.len())
}

fn virtual_motion(axes: &Axes, joint: usize) -> Option<Elementary> {
    Some(match axes.coordinates.get(joint)? {
        Coordinate::Angle(v) => Elementary::Rotate(2, LinearAngle::var(*v)),
        Coordinate::Length(s) => Elementary::Translate(2, Poly::symbol(*s)),
    })
}

/// A frame in front of the last turn that has the same origin as what stands right behind it.
fn before_turn(chain: &Chain, axes: &Axes, items: &[Item]) -> Option<Frame> {
    let [rest @ .., Item::Joint(j)] = items else { return None };
    let still = |m: &Mark| m.motion.p.iter().all(Poly::is_zero) && m.shares == Shares::All;
    axes.is_revolute(*j).then(|| backward(chain, axes, rest).into_iter().find(still).map(|m| m.frame)).flatten()
}

/// A pair of frames in which a known pose is written.
#[derive(Clone, Debug)]
pub(super) struct Written {
    pub(super) left: Frame,
    pub(super) right: Frame,
    /// What the planner's symbols are in those of the pose as written; `None` where they have no meaning there.
    values: Vec<(Symbol, Option<Poly>)>,
}

impl Written {
    /// The planner's pose between two frames, from one view of each: the symbols keep their place and get a new meaning.
    pub(super) fn new(pose: &KnownPose, left: &View, right: &View) -> Written {
        // M = C T X, with the planner's pose M and the pose T as written.
        let (c, x) = (&left.motion, right.motion.inverse());
        let t = pose.transform();
        let m = c.times(&t).times(&x);
        let mut values = Vec::new();
        let column = |j: usize| match right.shares {
            Shares::All | Shares::NoHeight => true,
            Shares::ZAxis => j == 2,
            Shares::Origin => false,
        };
        let row = |i: usize| match left.shares {
            Shares::All | Shares::NoHeight => true,
            Shares::ZAxis => i == 2,
            Shares::Origin => false,
        };
        let height = left.shares == Shares::NoHeight;
        for (i, (symbols, entries)) in pose.r.iter().zip(m.r).enumerate() {
            let list = symbols.iter().zip(entries).enumerate();
            values.extend(list.map(|(j, (s, value))| (*s, (row(i) && column(j)).then_some(value))));
        }
        for (i, (s, value)) in pose.p.iter().zip(m.p).enumerate() {
            values.push((*s, (row(i) && !(height && i == 2)).then_some(value)));
        }
        // The other end: M^-1 = X^-1 T^-1 C^-1.
        let a = c.inverse().p;
        let back_t: [Poly; 3] = pose.back.map(Poly::symbol);
        let across: [Poly; 3] = std::array::from_fn(|j| &dot(&t.column(j), &a) + &back_t[j]);
        for (j, s) in pose.back.iter().enumerate() {
            let value = &dot(&right.motion.r[j], &across) + &right.motion.p[j];
            values.push((*s, (column(j) && !height).then_some(value)));
        }
        // |R x + p - a|^2
        let two = Rational::int(2);
        let square = &(&Poly::symbol(pose.square) + &dot(&x.p, &x.p)) + &dot(&a, &a);
        let crossed = &(&dot(&back_t, &x.p) + &dot(&a, &t.p)) + &dot(&a, &t.rotate(&x.p));
        values.push((pose.square, (!height).then(|| &square - &crossed.scale(&two))));
        Written { left: left.frame, right: right.frame, values }
    }

    /// A formula of the planner in the symbols of the pose as written.
    pub(super) fn translate(&self, p: &Poly) -> Option<Poly> {
        let changed = |s: &Symbol| self.values.iter().find(|v| v.0 == *s);
        let symbols = p.symbols();
        if symbols.iter().any(|s| changed(s).is_some_and(|v| v.1.is_none())) {
            return None;
        }
        let moves = |s: &Symbol| changed(s).is_some_and(|v| v.1.as_ref() != Some(&Poly::symbol(*s)));
        if !symbols.iter().any(moves) {
            return Some(p.clone());
        }
        Some(p.substitute_symbols(|s| changed(&s).and_then(|v| v.1.clone())))
    }

    /// The element of the pose as written that a scalar of the planner's pose is, up to its sign and a constant; `None` where it is
    /// made of several.
    fn element(&self, pose: &KnownPose, scalar: FrameScalar) -> Option<FrameScalar> {
        let symbol = match scalar {
            FrameScalar::Rotation(i, j) => *pose.r.get(usize::from(i))?.get(usize::from(j))?,
            FrameScalar::Position(i) => *pose.p.get(usize::from(i))?,
            FrameScalar::Back(i) => *pose.back.get(usize::from(i))?,
            _ => return None,
        };
        let value = self.values.iter().find(|v| v.0 == symbol)?.1.as_ref()?;
        let own: Vec<Symbol> = pose.symbols().collect();
        let mut found = value.terms().iter().filter(|(m, _)| own.iter().any(|s| m.exponent(*s) > 0));
        let (m, c) = found.next()?;
        let single = found.next().is_none() && c.abs().is_one() && m.factors().count() == 1;
        let index = own.iter().position(|s| m.exponent(*s) == 1).filter(|_| single)?;
        Some(match index {
            0..9 => FrameScalar::Rotation((index / 3) as u8, (index % 3) as u8),
            9..12 => FrameScalar::Position((index - 9) as u8),
            12..15 => FrameScalar::Back((index - 12) as u8),
            _ => return None,
        })
    }
}

/// Which element of the transform between which frames an equation takes: the first pair of views where it is a single one.
pub(super) fn source(ring: &Ring, a: &[View], b: &[View], e: &Equation) -> Option<(Frame, Frame, FrameScalar)> {
    let mut ring = ring.clone();
    let mut symbol = |name: String| ring.symbol(&format!("{name} of a source"));
    let pose = KnownPose {
        left: e.a,
        right: e.b,
        r: std::array::from_fn(|i| std::array::from_fn(|j| symbol(format!("r{i}{j}")))),
        p: std::array::from_fn(|i| symbol(format!("p{i}"))),
        back: std::array::from_fn(|i| symbol(format!("b{i}"))),
        square: symbol("pp".into()),
    };
    let mut pairs = a.iter().flat_map(|l| b.iter().map(move |r| (l, r)));
    pairs.find_map(|(l, r)| {
        let written = Written::new(&pose, l, r);
        written.element(&pose, e.scalar).map(|scalar| (l.frame, r.frame, scalar))
    })
}
