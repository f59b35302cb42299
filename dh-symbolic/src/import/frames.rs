//! Denavit-Hartenberg frames on the axes of an arm, in any position of two neighbours to each other.
//!
//! The arm becomes base * Z1 * X1 * Z2 * X2 ... Zn * tool, where Z turns about and slides along the axis of a joint, X about and along the
//! common normal of two axes. A row of a standard table is Z and the X behind it, a row of a modified one Z and the X before it.
//!
//! Two neighbours are
//!
//! - **skew**: X runs along the common normal, from the first axis to the second (a > 0);
//! - **meeting** (a = 0): X is perpendicular to both, on the side that turns theta least at zero; where that leaves a choice, alpha > 0;
//! - **parallel**: of the common normals the one through the end of the normal before, so that d = 0 on the first of the two;
//! - **the same line**: a = alpha = 0, and theta counts from the direction of the normal before;
//! - **nearly parallel**, but not by rounding (a calibrated arm): the common normal may be kilometres away, so X runs to the point
//!   where the second axis passes through the plane of the first X, and a fixed row tilts it about the perpendicular direction.
//!
//! A sliding axis is a direction, not a line: it is laid on the next turning axis where the two are parallel, else through the end of the normal
//! before. Frame 0 sits on the first axis, at the point nearest to the base's origin; the last frame on the last axis, at the
//! point nearest to the tip.

use super::axes::PlacedAxes;
use super::rounding::{Angle, Limits};
use super::space::{Pose, Rotation, Vector, across, add, cross, dot, minus, norm, scale, unit};

/// An elementary motion of base or tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Motion {
    /// Along axis 0, 1 or 2, by metres.
    Shift(usize, f64),
    /// About axis 0, 1 or 2.
    Turn(usize, Angle),
}

/// Z and the X behind it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Link {
    /// Index of the moving axis; `None`: a fixed row.
    pub(super) axis: Option<usize>,
    pub(super) theta: Angle,
    pub(super) d: f64,
    pub(super) a: f64,
    pub(super) alpha: Angle,
    /// Lengths a and d that were taken as 0.
    pub(super) lost: (f64, f64),
}

/// The arm in Denavit-Hartenberg parameters.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub(super) base: Vec<Motion>,
    pub(super) links: Vec<Link>,
    pub(super) tool: Vec<Motion>,
}

/// Where the common normal of nearly parallel axes is farther away than this, in reaches of the arm, another way is taken.
const FAR: f64 = 2.0;
/// And they are nearly parallel below this angle.
const NEARLY: f64 = 0.1;

/// Puts frames on the axes.
pub(super) fn build(arm: &PlacedAxes) -> Rows {
    let limits = arm.limits;
    let lines = arm.axes.iter().map(|a| (a.p, a.z)).collect();
    let mut rest = Rest { lines, end: arm.end, limits, turned: 0.0 };
    let turning: Vec<bool> = arm.axes.iter().map(|a| a.turns).collect();
    let mut rows = Rows::default();
    let Some(&(_, z)) = rest.lines.first() else { return rows };
    if !turning[0] {
        rest.lines[0].0 = match (0..turning.len()).find(|&j| turning[j]) {
            Some(j) => foot([0.0; 3], rest.lines[j]),
            None => [0.0; 3],
        };
    }
    // Where the normal before ends on the axis, and its direction.
    let mut here = foot([0.0; 3], rest.lines[0]);
    let mut x = first_normal(z);
    rows.base = motions(&Pose { r: frame(x, z), p: here }, &limits.fine(0.0));
    for i in 0..rest.lines.len() {
        let z = rest.lines[i].1;
        let mut link = Link { axis: Some(i), ..Link::default() };
        let Some(&(_, next)) = rest.lines.get(i + 1) else {
            let (direction, origin) = last_frame(&rest, i, here);
            let fine = limits.fine(rest.turned);
            link.theta = fine.angle(angle_about(z, x, direction));
            link.d = limits.length(dot(minus(origin, here), z));
            let last = Pose { r: frame(direction, z), p: origin };
            rows.tool = motions(&last.back().times(&rest.end), &fine);
            rows.links.push(link);
            break;
        };
        if !turning[i + 1] {
            let parallel = |j: &usize| turning[*j] && norm(cross(rest.lines[*j].1, next)) <= limits.angle;
            let line = ((i + 2)..turning.len()).find(|j| turning[*j]).filter(parallel).map(|j| rest.lines[j].0);
            rest.lines[i + 1].0 = line.unwrap_or(here);
        }
        let pair = rest.pair(i, x, here);
        link.theta = limits.fine(rest.turned).angle(angle_about(z, x, pair.x));
        link.d = limits.length(dot(minus(pair.from, here), z));
        link.a = limits.length(pair.a);
        let lost = |taken: f64, x: f64| if taken == 0.0 { x.abs() } else { 0.0 };
        link.lost = (lost(link.a, pair.a), lost(link.d, dot(minus(pair.from, here), z)));
        link.alpha = pair.alpha;
        rows.links.push(link);
        x = pair.x;
        if !pair.tilt.is_zero() {
            // Turned by 90 degrees about z, X points along the direction about which the second axis is tilted.
            let theta = Angle { steps: 6, rest: 0.0 };
            rows.links.push(Link { axis: None, theta, alpha: pair.tilt, ..Link::default() });
            x = Rotation::about_vector(x, pair.alpha.radians()).apply(cross(z, x));
        }
        here = pair.to;
    }
    for link in &mut rows.links {
        link.theta = link.theta.folded();
        link.alpha = link.alpha.folded();
    }
    rows
}

/// The part of the arm that has no frames yet.
struct Rest {
    lines: Vec<(Vector, Vector)>,
    end: Pose,
    limits: Limits,
    /// The largest angle by which a part was turned, to make axes parallel that are so but for rounding.
    turned: f64,
}

/// How two neighbours lie.
struct CommonNormal {
    /// The direction of X.
    x: Vector,
    /// Its start on the first axis and its end on the second.
    from: Vector,
    to: Vector,
    a: f64,
    alpha: Angle,
    /// Turn about the direction that is perpendicular to X and to the first axis; zero but for nearly parallel axes.
    tilt: Angle,
}

impl Rest {
    /// Turns everything behind line `i` about a point.
    fn turn(&mut self, i: usize, about: Vector, by: &Rotation) {
        let point = |p: Vector| add(about, by.apply(minus(p, about)));
        for line in &mut self.lines[i + 1..] {
            *line = (point(line.0), by.apply(line.1));
        }
        self.turned = self.turned.max(by.angle());
        self.end = Pose { r: by.times(&self.end.r), p: point(self.end.p) };
    }

    /// The normal from line `i` to the next. `x` and `here`: direction and end of the normal before.
    fn pair(&mut self, i: usize, x: Vector, here: Vector) -> CommonNormal {
        let (p, z) = self.lines[i];
        let (q, next) = self.lines[i + 1];
        let n = cross(z, next);
        let (sine, cosine) = (norm(n), dot(z, next));
        let twist = sine.atan2(cosine.abs());
        if twist > self.limits.angle {
            let n = unit(n);
            // Feet of the common normal: p + s z and q + t next.
            let w = minus(q, p);
            let s = dot(cross(w, next), n) / sine;
            let t = dot(cross(w, z), n) / sine;
            let (from, to) = (add(p, scale(z, s)), add(q, scale(next, t)));
            let distance = dot(w, n);
            let far = norm(minus(from, here)) > FAR * self.limits.reach;
            if !(twist < NEARLY && far) {
                let meeting = distance.abs() <= self.limits.length;
                let direction = if meeting { nearer(n, x) } else { scale(n, distance.signum()) };
                let alpha = self.limits.angle(angle_about(direction, z, next));
                return CommonNormal { x: direction, from, to, a: distance.abs(), alpha, tilt: Angle::default() };
            }
        }
        // Parallel, by rounding or truly, or nearly so: to where the next axis passes through the plane of X.
        let to = add(q, scale(next, dot(minus(here, q), z) / cosine));
        let step = across(minus(to, here), z);
        let distance = norm(step);
        let direction = if distance <= self.limits.length { x } else { scale(step, 1.0 / distance) };
        let half_turn = Angle { steps: if cosine < 0.0 { 12 } else { 0 }, rest: 0.0 };
        let mut pair =
            CommonNormal { x: direction, from: here, to, a: distance, alpha: half_turn, tilt: Angle::default() };
        if twist > self.limits.angle {
            let y = cross(z, direction);
            let tilt = dot(next, direction).clamp(-1.0, 1.0).asin();
            pair.tilt = self.limits.angle(tilt);
            pair.alpha = self.limits.angle((-dot(next, y)).atan2(dot(next, z)));
        } else if sine > 0.0 {
            let by = Rotation::about_vector(unit(n), if cosine > 0.0 { -twist } else { twist });
            self.turn(i, to, &by);
        }
        pair
    }
}

/// The point of a line that is nearest to `p`.
fn foot(p: Vector, (q, z): (Vector, Vector)) -> Vector {
    add(q, scale(z, dot(minus(p, q), z)))
}

/// The angle about `axis` that carries `from` to `to`, both perpendicular to it.
fn angle_about(axis: Vector, from: Vector, to: Vector) -> f64 {
    dot(cross(from, to), axis).atan2(dot(from, to))
}

/// The normal or its opposite: the one that is less turned away from `x`.
fn nearer(n: Vector, x: Vector) -> Vector {
    // At a right angle the normal itself: then alpha > 0.
    if dot(n, x) < -1e-6 { scale(n, -1.0) } else { n }
}

/// The rotation with these directions of x and z.
fn frame(x: Vector, z: Vector) -> Rotation {
    Rotation([x, cross(z, x), z])
}

/// The direction of x0: one of the base's axes where that is possible, else level.
fn first_normal(z: Vector) -> Vector {
    let along = |k: usize| z[k].abs() > 1.0 - 1e-12;
    match (along(0), along(1), along(2)) {
        (_, _, true) => [1.0, 0.0, 0.0],
        (true, ..) => [0.0, z[0].signum(), 0.0],
        (_, true, _) => [z[1].signum(), 0.0, 0.0],
        _ => unit(cross([0.0, 0.0, 1.0], z)),
    }
}

/// The direction of x and the origin of the last frame: those of the tip as far as the axis allows.
fn last_frame(rest: &Rest, i: usize, here: Vector) -> (Vector, Vector) {
    let z = rest.lines[i].1;
    let tip = rest.end;
    let origin = add(here, scale(z, dot(minus(tip.p, here), z)));
    let away = minus(tip.p, origin);
    let same = |v: Vector| norm(cross(v, z)) <= rest.limits.angle;
    // One of the tip's axes along the joint's: another of them is x.
    if let Some(k) = (0..3).find(|&k| same(tip.r.0[k])) {
        let other = if k == 0 { 1 } else { 0 };
        let direction = unit(across(tip.r.0[other], z));
        return (direction, origin);
    }
    if norm(away) > rest.limits.length {
        return (unit(across(away, z)), origin);
    }
    (unit(cross(z, tip.r.0[2])), origin)
}

/// Elementary motions that make a pose: shifts, then as few turns as possible, exact ones if possible.
pub(super) fn motions(pose: &Pose, limits: &Limits) -> Vec<Motion> {
    let mut list = Vec::new();
    for (k, x) in pose.p.iter().enumerate() {
        let x = limits.length(*x);
        if x != 0.0 {
            list.push(Motion::Shift(k, x));
        }
    }
    list.extend(turns(&pose.r, limits).into_iter().map(|(k, angle)| Motion::Turn(k, angle)));
    list
}

/// The orders of three turns that are tried.
const ORDERS: [[usize; 3]; 12] = [
    [2, 1, 0],
    [2, 1, 2],
    [2, 0, 2],
    [2, 0, 1],
    [0, 1, 2],
    [0, 2, 1],
    [1, 0, 2],
    [1, 2, 0],
    [0, 1, 0],
    [0, 2, 0],
    [1, 0, 1],
    [1, 2, 1],
];

/// A rotation as turns about coordinate axes.
fn turns(r: &Rotation, limits: &Limits) -> Vec<(usize, Angle)> {
    let candidates = ORDERS.iter().map(|order| {
        let angles = euler(r, *order);
        let list: Vec<(usize, Angle)> = order.iter().zip(angles).map(|(k, x)| (*k, limits.angle(x).folded())).collect();
        let list: Vec<(usize, Angle)> = list.into_iter().filter(|(_, a)| !a.is_zero()).collect();
        let inexact = list.iter().filter(|(_, a)| !a.is_exact()).count();
        ((inexact, list.len()), list)
    });
    candidates.min_by_key(|(cost, _)| *cost).map(|(_, list)| list).unwrap_or_default()
}

/// Angles of three turns in this order, R = R_i(a) R_j(b) R_k(c).
fn euler(r: &Rotation, [i, j, k]: [usize; 3]) -> [f64; 3] {
    // Sign of the order: +1 for i -> j -> third in cyclic order.
    let cyclic = (i + 1) % 3 == j;
    let sign = if cyclic { 1.0 } else { -1.0 };
    let entry = |row: usize, column: usize| r.0[column][row];
    let third = 3 - i - j;
    // The middle angle from the image of the last axis, without loss of digits near the ends of its range.
    let (b, a);
    if i == k {
        let s = entry(j, i).hypot(entry(third, i));
        b = s.atan2(entry(i, i));
        a = if s < 1e-12 { 0.0 } else { entry(j, i).atan2(-sign * entry(third, i)) };
    } else {
        let c = entry(i, i).hypot(entry(i, j));
        b = (sign * entry(i, k)).atan2(c);
        a = if c < 1e-12 { 0.0 } else { (-sign * entry(j, k)).atan2(entry(k, k)) };
    }
    let rest = Rotation::about(j, -b).times(&Rotation::about(i, -a)).times(r);
    let (u, v) = ((k + 1) % 3, (k + 2) % 3);
    let c = rest.0[u][v].atan2(rest.0[u][u]);
    [a, b, c]
}

/// The pose that a list of motions makes.
pub(super) fn product(list: &[Motion]) -> Pose {
    list.iter().fold(Pose::IDENTITY, |pose, m| {
        pose.times(&match m {
            Motion::Shift(k, x) => Pose::shifted(*k, *x),
            Motion::Turn(k, a) => Pose::turned(*k, a.radians()),
        })
    })
}

impl Rows {
    /// The tip's pose for values of the motors.
    pub(super) fn pose(&self, arm: &PlacedAxes, q: &[f64]) -> Pose {
        let mut pose = product(&self.base);
        for link in &self.links {
            let (mut theta, mut d) = (link.theta.radians(), link.d);
            if let Some(axis) = link.axis.and_then(|i| arm.axes.get(i)) {
                *(if axis.turns { &mut theta } else { &mut d }) += axis.value(q);
            }
            pose = pose.times(&Pose::turned(2, theta)).times(&Pose::shifted(2, d));
            pose = pose.times(&Pose::shifted(0, link.a)).times(&Pose::turned(0, link.alpha.radians()));
        }
        pose.times(&product(&self.tool))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Rounding;
    use super::*;

    #[test]
    fn any_rotation_is_a_product_of_turns() {
        let limits = Limits::new(Rounding::AsWritten, 1.0);
        let mut seed = 7u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 * 6.0 - 3.0
        };
        for round in 0..500 {
            let mut rpy = [random(), random(), random()];
            if round % 3 == 0 {
                rpy = rpy.map(|x| x.round() * std::f64::consts::FRAC_PI_2);
            }
            let r = Rotation::rpy(rpy);
            for order in ORDERS {
                let [a, b, c] = euler(&r, order);
                let made = Rotation::about(order[0], a)
                    .times(&Rotation::about(order[1], b))
                    .times(&Rotation::about(order[2], c));
                assert!(made.back().times(&r).angle() < 1e-11, "{rpy:?} {order:?}");
            }
            let list = turns(&r, &limits);
            let made = product(&list.iter().map(|(k, a)| Motion::Turn(*k, *a)).collect::<Vec<_>>());
            assert!(made.r.back().times(&r).angle() < 1e-11, "{rpy:?}");
            assert!(round % 3 != 0 || list.len() <= 2, "{rpy:?}: {list:?}");
        }
    }
}
