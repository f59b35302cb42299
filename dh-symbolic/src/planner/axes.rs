//! The arm as the planner sees it: revolute and prismatic axes with constant transforms between them, exact and in numbers.
//!
//! Frames lie on the joint axes, before and after the shift d along each axis, since the point where neighbouring axes meet is
//! one of the two. A task that leaves something open becomes virtual joints: the turn about the tool's axis for `axis`, three turns
//! about the tool's point for `position`, a translation along z for `planar` where joints change the height.

use std::sync::OnceLock;

use super::plane;
use crate::algebra::{Angle, AngleVar, LinearAngle, Poly, Rational, Ring, Transform, dot};
use crate::chain::{Chain, Coordinate, Elementary, Handle, Task};
use dh_kernels::pose::{self, Pose};

/// One link, from a frame to the next: a constant transform, then perhaps a joint.
#[derive(Clone, Debug)]
pub struct LinkTransform {
    /// The constant transform.
    pub before: Transform,
    /// Its value, lengths over the length scale.
    pub number: Pose,
    /// The joint after it.
    pub joint: Option<usize>,
}

/// The axes of an arm, virtual ones included.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Link transforms from frame 0 on; frame k is reached by links 0..k.
    pub links: Vec<LinkTransform>,
    /// Coordinates: the real joints in order of the chain, then virtual ones.
    pub coordinates: Vec<Coordinate>,
    /// Number of real joints.
    pub real: usize,
    /// Constant transform before frame 0.
    pub start: Transform,
    /// Constant transform after the last frame.
    pub end: Transform,
    /// All motions from the base to the tip in order, with the places of the table's frames among them.
    pub items: Vec<Item>,
    /// For each frame of the links, frame 0 first, the item that follows it.
    pub places: Vec<usize>,
    /// Names: the chain's, the virtual joints' and those that plans introduce.
    pub ring: Ring,
    /// Sum of the lengths of all constant shifts (table units), 1 if there are none.
    pub length_scale: f64,
    /// Products of links: see [`Axes::between`].
    products: Vec<OnceLock<Transform>>,
    /// Their inverses: see [`Axes::back`].
    inverses: Vec<OnceLock<Transform>>,
    /// Squared distances: see [`Axes::square`].
    squares: Vec<OnceLock<Poly>>,
}

/// Numeric value of a parameter; fields get their nominal value, slightly detuned so that no structure is inferred from a value that the
/// user may change.
pub(crate) fn generic_parameter(chain: &Chain, handle: Handle) -> f64 {
    let value = chain.nominal(handle);
    let Some(i) = chain.parameters.iter().position(|x| x.handle == handle) else { return value };
    if !matches!(chain.parameters[i].role, crate::chain::Role::Field(_)) {
        return value;
    }
    let unit = if matches!(handle, Handle::Angle(_)) { 0.9 } else { 1.0 };
    let base = if value == 0.0 { unit } else { value };
    base * (1.0 + 0.0113 * (1.0 + i as f64).sqrt())
}

/// The same for a formula in parameters.
pub(crate) fn generic_value(chain: &Chain, p: &Poly) -> f64 {
    p.evaluate(&crate::algebra::Point {
        symbol: &|s| generic_parameter(chain, Handle::Length(s)),
        angle: &|v| generic_parameter(chain, Handle::Angle(v)),
    })
}

pub(crate) fn numeric(chain: &Chain, t: &Transform, length_scale: f64) -> Pose {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let x = generic_value(chain, &t.entry(i, j));
            if j == 3 { x / length_scale } else { x }
        })
    })
}

/// A motion on the way from the base to the tip, or a frame between motions.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A constant motion.
    Constant(Elementary),
    /// The motion of a coordinate.
    Joint(usize),
    /// The base; where there is none, frame 0.
    Base,
    /// A frame of the table.
    Frame(usize),
    /// The tool; where there is none, the last frame.
    Tool,
}

impl Axes {
    /// Cuts a chain at its axes.
    pub fn new(chain: &Chain) -> Axes {
        let mut ring = chain.ring.clone();
        let mut coordinates: Vec<Coordinate> = chain.joints.iter().map(|j| j.coordinate).collect();
        let real = coordinates.len();
        let mut items: Vec<Item> = Vec::new();
        match (chain.settings.task, plane::constant_height(chain)) {
            // The target's height is 0.
            (Task::Planar, Some(height)) => items.push(Item::Constant(Elementary::Translate(2, -&height))),
            (Task::Planar, None) => {
                coordinates.push(Coordinate::Length(ring.symbol("virtual_z")));
                items.push(Item::Joint(real));
            }
            _ => {}
        }
        items.push(Item::Base);
        items.extend(chain.base.iter().cloned().map(Item::Constant));
        items.push(Item::Frame(0));
        for (row, link) in chain.links.iter().enumerate() {
            for e in chain.link_factors(row) {
                push_factor(&mut items, chain, link.joint, e);
            }
            items.push(Item::Frame(row + 1));
        }
        items.extend(chain.tool.iter().cloned().map(Item::Constant));
        items.push(Item::Tool);
        let mut virtual_turn = |items: &mut Vec<Item>, name: &str| {
            items.push(Item::Joint(coordinates.len()));
            coordinates.push(Coordinate::Angle(ring.angle(name)));
        };
        match chain.settings.task {
            Task::Axis => virtual_turn(&mut items, "virtual_roll"),
            Task::Position => {
                let quarter = || Elementary::Rotate(0, LinearAngle::constant(Angle::degrees(&Rational::int(90))));
                virtual_turn(&mut items, "virtual_yaw");
                items.push(Item::Constant(quarter()));
                virtual_turn(&mut items, "virtual_pitch");
                items.push(Item::Constant(quarter()));
                virtual_turn(&mut items, "virtual_roll");
            }
            Task::Pose | Task::Planar => {}
        }
        Axes::cut(chain, ring, coordinates, real, items)
    }

    fn cut(chain: &Chain, ring: Ring, coordinates: Vec<Coordinate>, real: usize, items: Vec<Item>) -> Axes {
        let mut start = Transform::identity();
        let mut pending = Transform::identity();
        let mut along = true; // only shifts along and turns about the last axis so far
        let mut links: Vec<(Transform, Option<usize>)> = Vec::new();
        let mut places = vec![0];
        let mut first = true;
        for (place, item) in items.iter().enumerate() {
            match item {
                Item::Base | Item::Frame(_) | Item::Tool => {}
                Item::Joint(j) => {
                    if first {
                        start = std::mem::replace(&mut pending, Transform::identity());
                        places = vec![place];
                        first = false;
                    }
                    links.push((std::mem::replace(&mut pending, Transform::identity()), Some(*j)));
                    places.push(place + 1);
                    along = true;
                }
                Item::Constant(e) => {
                    let on_axis = matches!(e, Elementary::Rotate(2, _) | Elementary::Translate(2, _));
                    if !first && along && !on_axis {
                        along = false;
                        if !pending.p[2].is_zero() {
                            links.push((std::mem::replace(&mut pending, Transform::identity()), None));
                            places.push(place);
                        }
                    }
                    pending = pending.times(&e.transform());
                }
            }
        }
        let length_scale: f64 = links
            .iter()
            .map(|(t, _)| t)
            .chain([&pending])
            .map(|t| (0..3).map(|i| generic_value(chain, &t.p[i]).powi(2)).sum::<f64>().sqrt())
            .sum();
        let length_scale = if length_scale > 0.0 { length_scale } else { 1.0 };
        let links: Vec<LinkTransform> = links
            .into_iter()
            .map(|(before, joint)| LinkTransform { number: numeric(chain, &before, length_scale), before, joint })
            .collect();
        let products = vec![OnceLock::new(); (links.len() + 1).pow(2)];
        let inverses = products.clone();
        let squares = vec![OnceLock::new(); products.len()];
        Axes {
            links,
            coordinates,
            real,
            start,
            end: pending,
            items,
            places,
            ring,
            length_scale,
            products,
            inverses,
            squares,
        }
    }

    /// Whether coordinate `k` belongs to a revolute joint.
    pub fn is_revolute(&self, k: usize) -> bool {
        matches!(self.coordinates.get(k), Some(Coordinate::Angle(_)))
    }

    /// The index of an angle among the coordinates.
    pub fn index_of_angle(&self, v: AngleVar) -> Option<usize> {
        self.coordinates.iter().position(|c| *c == Coordinate::Angle(v))
    }

    /// Number of coordinates, virtual ones included.
    pub fn count(&self) -> usize {
        self.coordinates.len()
    }

    /// Frame `b` seen from frame `a`, exact. Made once: equations ask for the same products again and again.
    ///
    /// # Panics
    /// Where there is no frame `b`, or `a` comes after it.
    pub fn between(&self, a: usize, b: usize) -> &Transform {
        self.products[a * (self.links.len() + 1) + b].get_or_init(|| {
            if a == b {
                return Transform::identity();
            }
            let (t, link) = (self.between(a, b - 1), &self.links[b - 1]);
            let t = if link.before == Transform::identity() { t.clone() } else { t.times(&link.before) };
            match link.joint.map(|j| self.motion(j)) {
                Some(m) => t.times(&m),
                None => t,
            }
        })
    }

    /// Frame `a` seen from frame `b`: the inverse of [`Axes::between`], as a product too, since inverting a long product
    /// costs many times as much.
    ///
    /// # Panics
    /// As [`Axes::between`].
    pub fn back(&self, a: usize, b: usize) -> &Transform {
        self.inverses[a * (self.links.len() + 1) + b].get_or_init(|| {
            if a == b {
                return Transform::identity();
            }
            let link = &self.links[b - 1];
            let before = link.before.inverse();
            let last = link.joint.map_or(before.clone(), |j| self.motion(j).inverse().times(&before));
            last.times(self.back(a, b - 1))
        })
    }

    /// The squared distance of the origins of frames `a` and `b`.
    ///
    /// With the next displacement d it grows by d.d + 2 (R^T p).d, and -R^T p is known: no long sum is squared only to cancel afterwards.
    ///
    /// # Panics
    /// As [`Axes::between`].
    pub fn square(&self, a: usize, b: usize) -> &Poly {
        self.squares[a * (self.links.len() + 1) + b].get_or_init(|| {
            if a == b {
                return Poly::zero();
            }
            let link = &self.links[b - 1];
            let way = match link.joint {
                Some(j) if !self.is_revolute(j) => link.before.times(&self.motion(j)).p,
                _ => link.before.p.clone(),
            };
            let across = dot(&self.back(a, b - 1).p, &way).scale(&Rational::int(2));
            &(self.square(a, b - 1) + &dot(&way, &way)) - &across
        })
    }

    /// The motion of a joint.
    pub fn motion(&self, joint: usize) -> Transform {
        match self.coordinates[joint] {
            Coordinate::Angle(v) => {
                let (c, s) = Poly::cos_sin(v);
                Transform::rotation(2, (&c, &s))
            }
            Coordinate::Length(s) => Transform::translation(2, &Poly::symbol(s)),
        }
    }

    /// A link in numbers.
    pub fn link_pose(&self, link: usize, x: &[f64]) -> Pose {
        let h = &self.links[link];
        match h.joint {
            None => h.number,
            Some(j) if self.is_revolute(j) => pose::turn(&h.number, [x[j].cos(), x[j].sin()]),
            Some(j) => pose::slide(&h.number, x[j]),
        }
    }

    /// Frames seen from frame 0, in numbers (lengths over the length scale).
    pub fn frames_number(&self, x: &[f64]) -> Vec<Pose> {
        let mut t = pose::IDENTITY;
        let mut all = vec![t];
        for link in 0..self.links.len() {
            t = pose::compose(&t, &self.link_pose(link, x));
            all.push(t);
        }
        all
    }
}

/// Splits a link factor into its moving and its constant part.
fn push_factor(items: &mut Vec<Item>, chain: &Chain, joint: Option<usize>, e: Elementary) {
    let moving = joint.and_then(|j| chain.joints.get(j).map(|x| (j, x.coordinate)));
    match (e, moving) {
        (Elementary::Rotate(2, angle), Some((j, Coordinate::Angle(_)))) => {
            items.push(Item::Joint(j));
            if !angle.constant.is_zero() {
                items.push(Item::Constant(Elementary::Rotate(2, LinearAngle::constant(angle.constant))));
            }
        }
        (Elementary::Translate(2, d), Some((j, Coordinate::Length(s)))) => {
            items.push(Item::Joint(j));
            let rest = &d - &Poly::symbol(s);
            if !rest.is_zero() {
                items.push(Item::Constant(Elementary::Translate(2, rest)));
            }
        }
        (e, _) => {
            if !e.is_identity() {
                items.push(Item::Constant(e));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::dot;
    use crate::chain::table;

    #[test]
    fn squared_distances_are_what_squaring_gives() {
        let text = "pub struct Arm;
            convention = modified;
            let d4: length;
            | joint | alpha | a | d | theta |
            | 1 | 0 | 0 | 0.1 | q1 |
            | 2 | 40deg | 0.3 | q2 | 30deg |
            | 3 | -90deg | 0 | 0.2 | q3 |
            | 4 | 60deg | 0.2 | d4 | q4 |";
        let parsed = table::parse(text.parse().expect("it lexes"));
        let axes = Axes::new(&Chain::new(parsed.spec.expect("a table")));
        for a in 0..=axes.links.len() {
            for b in a..=axes.links.len() {
                let p = &axes.between(a, b).p;
                assert_eq!(*axes.square(a, b), dot(p, p), "{a} {b}");
            }
        }
    }
}
