//! Equations for arms with prismatic joints from which the joint lengths have been eliminated.
//!
//! Around the loop of links and target the ways from joint to joint add up to nothing. The directions u and v of two prismatic joints span a plane; the
//! component of that sum across it, (u x v).p, is free of both lengths: [`FrameScalar::Across`].
//!
//! An arm with two prismatic and four revolute joints has four angles and only three equations of directions. The fourth one is made of the
//! same component: where the neighbouring revolute axes x and y have no prismatic joint between them, the displacement from x to y is decomposed,
//!
//! ```text
//! p = l x + m y + k (x cross y),
//! (x cross y).(v cross u) = (x.v) (y.u) - (x.u) (y.v),   (x.u) (y.v) = (x.y) (u.v) + (x cross v).(u cross y).
//! ```
//!
//! x.y is a constant of the arm. So all of it is said with directions seen over the other two turning joints, linear in the sine and
//! cosine of each: [`FrameScalar::Bridge`]. With the angle between x and y, seen from the same side, these are two equations in two angles.

use super::axes::Axes;
use super::known::Knowledge;
use super::scalar::{Equation, FrameScalar, fold};
use super::subspace::Subspace;
use crate::algebra::{Poly, RingElement, cross, dot, minus};
use dh_kernels::pose::{self, Pose};

type V<T> = [T; 3];

/// (z x u).p in a frame whose z axis slides.
fn across<T: RingElement>(u: &V<T>, p: &V<T>) -> T {
    u[0].times(&p[1]).minus(&u[1].times(&p[0]))
}

/// A vector seen from this side of the target or from the other one.
#[derive(Clone)]
struct Seen<T> {
    here: bool,
    v: V<T>,
}

/// Products of vectors on either side: those of one side are put together first, so that the target enters once, by its rotation.
struct Target<T> {
    /// From the other side to this one, by columns.
    columns: [V<T>; 3],
}

impl<T: RingElement> Target<T> {
    fn dot(&self, a: &Seen<T>, b: &Seen<T>) -> T {
        match (a.here, b.here) {
            (true, false) => dot(&self.columns.each_ref().map(|c| dot(c, &a.v)), &b.v),
            (false, true) => self.dot(b, a),
            _ => dot(&a.v, &b.v),
        }
    }

    /// a.(b x c)
    fn triple(&self, a: &Seen<T>, b: &Seen<T>, c: &Seen<T>) -> T {
        let cross = |a: &Seen<T>, b: &Seen<T>| Seen { here: a.here, v: cross(&a.v, &b.v) };
        if b.here == c.here {
            self.dot(a, &cross(b, c))
        } else if a.here == b.here {
            self.dot(&cross(a, b), c)
        } else {
            self.dot(&cross(c, a), b)
        }
    }
}

/// Two turning axes, the way from the first to the second in pieces, and two sliding directions: the one that comes first behind y,
/// then the other one. x is on this side of the target, and where v is not, u is not.
struct Loop<T> {
    target: Target<T>,
    x: Seen<T>,
    y: Seen<T>,
    way: Vec<Seen<T>>,
    u: Seen<T>,
    v: Seen<T>,
}

/// The equation of the bridge; `y` and `p` are the second axis and the way to it as the first axis' frame sees them. Times the squared
/// sine of the axes' angle.
fn bridge<T: RingElement>(l: &Loop<T>, y: &V<T>, p: &V<T>) -> T {
    let square = y[0].times(&y[0]).plus(&y[1].times(&y[1]));
    // p = f x + g y + k (x cross y), each times the square.
    let g = p[0].times(&y[0]).plus(&p[1].times(&y[1]));
    let k = p[1].times(&y[0]).minus(&p[0].times(&y[1]));
    let f = p[2].times(&square).minus(&g.times(&y[2]));
    let Loop { target: t, x, y: axis, way, u, v } = l;
    let across = |w: &Seen<T>| t.triple(v, u, w);
    let way = way.iter().fold(T::zero(), |sum, w| sum.plus(&across(w))).times(&square);
    let along = across(x).times(&f).plus(&across(axis).times(&g));
    let seen = |a: &Seen<T>, b: &Seen<T>| Seen { here: a.here, v: cross(&a.v, &b.v) };
    // (x cross v).(u cross y)
    let crossed = if v.here == x.here { t.triple(&seen(x, v), u, axis) } else { t.triple(x, v, &seen(u, axis)) };
    let off = t.dot(x, v).times(&t.dot(axis, u)).minus(&y[2].times(&t.dot(u, v))).minus(&crossed);
    way.minus(&along).minus(&off.times(&k))
}

/// Links with prismatic joints.
fn prismatic_links(axes: &Axes) -> Vec<usize> {
    let is_prismatic = |h: &usize| axes.links.get(*h).and_then(|h| h.joint).is_some_and(|j| !axes.is_revolute(j));
    (0..axes.links.len()).filter(is_prismatic).collect()
}

/// The prismatic joints of a bridge in the order in which they follow frame `b`.
fn ordered([i, j]: [usize; 2], b: usize) -> [usize; 2] {
    if i < b && j >= b { [j, i] } else { [i, j] }
}

/// All these equations of an arm, with the coordinates that each depends on.
pub(super) fn equations(axes: &Axes) -> Vec<(Equation, Subspace)> {
    let prismatic = prismatic_links(axes);
    let frames = axes.links.len() + 1;
    let pairs = || {
        let behind = |n: usize| prismatic.get(n + 1..).unwrap_or_default();
        prismatic.iter().enumerate().flat_map(move |(n, i)| behind(n).iter().map(move |j| [*i, *j]))
    };
    let mut list: Vec<Equation> = Vec::new();
    for [i, j] in pairs() {
        let scalar = FrameScalar::Across(j as u8);
        list.extend((i + 2..frames).map(|b| Equation { a: i + 1, b, scalar }));
    }
    let moves: Vec<(usize, usize)> = axes.links.iter().enumerate().filter_map(|(h, x)| Some((h, x.joint?))).collect();
    for w in moves.windows(2).filter(|w| w.iter().all(|(_, j)| axes.is_revolute(*j))) {
        let (a, b) = (w[0].0, w[1].0 + 1);
        let link = link_number(axes, a, b);
        if link[0][2].hypot(link[1][2]) > 1e-6 {
            let bridge = |[i, j]: [usize; 2]| Equation { a, b, scalar: FrameScalar::Bridge(i as u8, j as u8) };
            list.extend(pairs().map(bridge));
        }
    }
    let mut random = super::random::Random::new(19);
    let mut spans = vec![Subspace::default(); list.len()];
    for _ in 0..3 {
        let mut point = || -> Vec<f64> { (0..axes.count()).map(|_| 2.3 * random.next()).collect() };
        let (x, y) = (point(), point());
        let target = *axes.frames_number(&y).last().unwrap_or(&pose::IDENTITY);
        let mut slopes = vec![vec![0.0; axes.count()]; list.len()];
        for k in 0..axes.count() {
            for sign in [1.0, -1.0] {
                let mut x = x.clone();
                x[k] += sign * STEP;
                let f = axes.frames_number(&x);
                for (slope, e) in slopes.iter_mut().zip(&list) {
                    slope[k] += sign * number(axes, e, &f, &target).unwrap_or(0.0) / (2.0 * STEP);
                }
            }
        }
        for (span, slope) in spans.iter_mut().zip(&slopes) {
            span.add(slope);
        }
    }
    list.into_iter().zip(spans).collect()
}

/// Step of the differences that slopes are measured by.
const STEP: f64 = 1e-4;

/// From the axis of link `a` to that of link `b - 1`.
fn link_number(axes: &Axes, a: usize, b: usize) -> Pose {
    let between = axes.links.get(a + 1..b).unwrap_or_default();
    between.iter().fold(pose::IDENTITY, |t, h| pose::compose(&t, &h.number))
}

fn column(t: &Pose, j: usize) -> V<f64> {
    t.map(|row| row[j])
}

/// The value of an equation at frames `f` for a target: zero at a solution. `None` for equations of other kinds.
pub(super) fn number(axes: &Axes, e: &Equation, f: &[Pose], target: &Pose) -> Option<f64> {
    // Frame k over the target.
    let tail = pose::compose(target, &pose::inverse(f.last()?));
    let outer = |k: usize| pose::compose(&tail, &f[k]);
    match e.scalar {
        FrameScalar::Across(j) => {
            let back = pose::inverse(&f[e.a]);
            let j = usize::from(j) + 1;
            let inside = pose::compose(&back, &f[e.b]);
            let outside = pose::compose(&back, &outer(e.b));
            let u = pose::compose(&back, &if j <= e.b { f[j] } else { outer(j) });
            let p = minus(&column(&inside, 3), &column(&outside, 3));
            Some(across(&column(&u, 2), &p))
        }
        FrameScalar::Bridge(i, j) => {
            let [u, v] = ordered([i, j].map(usize::from), e.b);
            let here = |v: V<f64>| Seen { here: true, v };
            let seen = |h: usize| here(column(&if h < e.b { f[h + 1] } else { outer(h + 1) }, 2));
            let (x, y) = (pose::compose(&f[e.a], &axes.links[e.a].number), outer(e.b));
            let way = vec![here(minus(&column(&y, 3), &column(&x, 3)))];
            let target = Target { columns: [[0.0; 3]; 3] };
            let (x, y) = (here(column(&x, 2)), here(column(&y, 2)));
            let link = link_number(axes, e.a, e.b);
            let around = Loop { target, x, y, way, u: seen(u), v: seen(v) };
            Some(bridge(&around, &column(&link, 2), &column(&link, 3)))
        }
        _ => None,
    }
}

/// z axis and origin of frame `k` as frame `from` sees them, without the target.
fn axis(axes: &Axes, from: usize, k: usize) -> [V<Poly>; 2] {
    let t = if k >= from { axes.between(from, k) } else { axes.back(k, from) };
    [t.column(2), t.p.clone()]
}

/// The vectors of [`across`].
fn across_parts(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, j: usize) -> (V<Poly>, V<Poly>) {
    let (left, right) = fold(axes, knowledge, e);
    let k = knowledge.pose(left, right).transform();
    let before = axes.between(left, e.a);
    let seen = |v: &V<Poly>| -> V<Poly> { std::array::from_fn(|i| dot(&before.column(i), v)) };
    let over = k.rotate(&axis(axes, right, e.b)[1]);
    let other = seen(&std::array::from_fn(|i| &(&over[i] + &k.p[i]) - &before.p[i]));
    let p = minus(&axes.between(e.a, e.b).p, &other);
    let [inside, outside] = [e.a, right].map(|from| axis(axes, from, j + 1)[0].clone());
    (if j < e.b { inside } else { seen(&k.rotate(&outside)) }, p)
}

/// The vectors of [`bridge`].
fn bridge_parts(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, prismatic: [usize; 2]) -> Loop<Poly> {
    let (left, right) = fold(axes, knowledge, e);
    let known = knowledge.pose(left, right);
    let k = known.transform();
    let [u, v] = ordered(prismatic, e.b).map(|h| {
        let here = h < e.b;
        Seen { here, v: axis(axes, if here { left } else { right }, h + 1)[0].clone() }
    });
    let from = axes.between(left, e.a).times(&axes.links[e.a].before);
    let [direction, to] = axis(axes, right, e.b);
    // From this side to the other one, as the side sees it where more of the vectors are.
    let between = if v.here {
        Seen { here: true, v: k.p.clone() }
    } else {
        Seen { here: false, v: known.back.map(|b| -&Poly::symbol(b)) }
    };
    Loop {
        target: Target { columns: [0, 1, 2].map(|j| k.column(j)) },
        x: Seen { here: true, v: from.column(2) },
        y: Seen { here: false, v: direction },
        way: vec![Seen { here: true, v: from.p.map(|p| -&p) }, between, Seen { here: false, v: to }],
        u,
        v,
    }
}

/// The equation across two prismatic joints.
pub(super) fn across_exact(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, j: usize) -> Poly {
    let (u, p) = across_parts(axes, knowledge, e, j);
    across(&u, &p)
}

/// About how many terms its products have.
pub(super) fn across_weight(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, j: usize) -> usize {
    let (u, p) = across_parts(axes, knowledge, e, j);
    most(&u) * most(&p)
}

/// The equation of a bridge.
pub(super) fn bridge_exact(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, prismatic: [usize; 2]) -> Poly {
    let link = axes.between(e.a + 1, e.b - 1).times(&axes.links[e.b - 1].before);
    bridge(&bridge_parts(axes, knowledge, e, prismatic), &link.column(2), &link.p)
}

/// About how many terms its products have.
pub(super) fn bridge_weight(axes: &Axes, knowledge: &mut Knowledge, e: &Equation, prismatic: [usize; 2]) -> usize {
    let l = bridge_parts(axes, knowledge, e, prismatic);
    let third = [&l.x, &l.y].into_iter().chain(&l.way).map(|s| most(&s.v)).max().unwrap_or(0);
    most(&l.u.v) * most(&l.v.v) * third
}

fn most(v: &V<Poly>) -> usize {
    v.iter().map(|p| p.terms().len()).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::super::sample::Sample;
    use super::*;
    use crate::chain::Convention;
    use crate::chain::tests::mixed_chain;

    const ROWS: [(i64, &str, &str, i64); 6] = [
        (30, "0.2", "0.1", 0),
        (-60, "0.3", "0.2", 30),
        (45, "-0.1", "0.3", 0),
        (90, "0.25", "-0.2", 45),
        (-30, "0.15", "0.12", 0),
        (60, "0.22", "0.17", 0),
    ];

    /// Every equation of an arm: it holds, and does not contain what it should be free of.
    fn check(convention: Convention, kinds: &str) {
        let chain = mixed_chain(convention, kinds, &ROWS);
        let axes = Axes::new(&chain);
        let x = vec![0.3, -0.8, 0.5, 1.1, -0.4, 0.7];
        let target = *axes.frames_number(&x).last().unwrap();
        let list = equations(&axes);
        assert!(list.len() > 3, "{kinds}: {} equations", list.len());
        for (e, span) in list {
            let mut knowledge = Knowledge::new(&axes);
            let p = match e.scalar {
                FrameScalar::Across(j) => across_exact(&axes, &mut knowledge, &e, usize::from(j)),
                FrameScalar::Bridge(i, j) => bridge_exact(&axes, &mut knowledge, &e, [i, j].map(usize::from)),
                _ => panic!("{e:?} is of another kind"),
            };
            let at = |x: &[f64]| Sample::new(&chain, &axes, &knowledge, x.to_vec()).evaluate(&p);
            assert!(at(&x).abs() < 1e-12, "{kinds} {e:?}: {}", at(&x));
            assert!(number(&axes, &e, &axes.frames_number(&x), &target).unwrap().abs() < 1e-12);
            for k in 0..6 {
                let moves = span.rows().iter().any(|r| r[k].abs() > 1e-6);
                let angle = match axes.coordinates[k] {
                    crate::chain::Coordinate::Angle(v) => p.angles().contains(&v),
                    crate::chain::Coordinate::Length(s) => p.symbols().contains(&s),
                };
                assert_eq!(moves, angle, "{kinds} {e:?}, joint {}", k + 1);
            }
            if let FrameScalar::Bridge(..) = e.scalar {
                assert_eq!(span.dimension(), 2, "{kinds}: all but two angles and two lengths");
            }
        }
    }

    #[test]
    fn equations_hold_and_depend_on_what_they_should() {
        for kinds in ["PRPRRR", "RPRRPR", "RRPRRP", "PRRRRP", "RRPPRR", "PPRRRR", "PRRPRP"] {
            check(Convention::Standard, kinds);
            check(Convention::Modified, kinds);
        }
    }
}
