//! The workspace of planar arms whose first joint turns all the way round: rings about its axis, with the number of solutions in each.

use super::camera::{V3, distance, dot, plus};
use super::drawing::{Color, Drawing, Pen, Shape};
use super::posture::{Posture, column, origin};
use crate::chain::{Chain, Coordinate};
use crate::kinematics::Kinematics;
use crate::render::code::bound;
use crate::render::formula::math::Math;

/// A ring about the first axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// Inner radius.
    pub inner: f64,
    /// Outer radius.
    pub outer: f64,
    /// Joint vectors that bring the tip to a point inside; `None`: infinitely many.
    pub solutions: Option<usize>,
}

/// What a planar arm reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Rings {
    /// Rings from the inside outwards, without those that nothing reaches.
    pub list: Vec<Ring>,
    /// Where the tip can be turned to every angle: inner and outer radius. For arms with three joints and more.
    pub dexterous: Option<[f64; 2]>,
}

/// Samples of the second joint.
const SAMPLES: usize = 1440;
const DIRECTIONS: f64 = 1e-9;

/// The rings of an arm with numbers; `None` for arms that are not planar, do not turn freely, or have no bound.
pub fn rings(chain: &Chain, kinematics: &Kinematics) -> Option<Rings> {
    let n = chain.dof();
    let revolute = |k: usize| chain.joints.get(k).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    let range = |k: usize| {
        let range = chain.joints.get(k).and_then(|j| j.range.as_ref());
        range.map(|(least, greatest)| (bound(least), bound(greatest)))
    };
    let free = |k: usize| range(k).is_none_or(|(a, b)| b - a >= std::f64::consts::TAU - 1e-9);
    if !(chain.is_direct() && n >= 2 && revolute(0) && free(0) && is_planar(chain, kinematics)) {
        return None;
    }
    if n > 2 {
        return (0..n).all(|k| revolute(k) && free(k)).then(|| links(chain, kinematics))?;
    }
    let (least, greatest) = match range(1) {
        Some(range) => range,
        None if revolute(1) => (-std::f64::consts::PI, std::f64::consts::PI),
        None => return None,
    };
    // The second joint alone decides how far the tip is from the first axis.
    let radius = |x: f64| reach(chain, kinematics, &[0.4, x]);
    let samples: Vec<f64> =
        (0..=SAMPLES).map(|i| radius(least + (greatest - least) * i as f64 / SAMPLES as f64)).collect();
    let size = samples.iter().copied().fold(0.0, f64::max);
    let mut critical: Vec<f64> = samples.first().into_iter().chain(samples.last()).copied().collect();
    let whole = revolute(1) && free(1);
    if whole {
        critical.clear();
    }
    for i in 0..samples.len() {
        let before = if i > 0 {
            samples.get(i - 1)
        } else if whole {
            samples.get(samples.len() - 2)
        } else {
            None
        };
        let after = samples.get(i + 1).or(if whole { samples.get(1) } else { None });
        if let (Some(before), Some(here), Some(after)) = (before, samples.get(i), after)
            && (here - before) * (after - here) <= 0.0
        {
            critical.push(*here);
        }
    }
    critical.sort_by(f64::total_cmp);
    // A sample beside an extremum misses it by the square of the distance.
    critical.dedup_by(|a, b| (*a - *b).abs() < 1e-4 * size);
    let list = critical.windows(2).filter_map(|pair| {
        let [inner, outer] = pair else { return None };
        let middle = 0.5 * (inner + outer);
        let count = samples.windows(2).filter(|p| matches!(p, [a, b] if (*a < middle) != (*b < middle))).count();
        let inner = if *inner < 1e-4 * size { 0.0 } else { *inner };
        (count > 0).then_some(Ring { inner, outer: *outer, solutions: Some(count) })
    });
    Some(Rings { list: list.collect(), dexterous: None }).filter(|r| !r.list.is_empty())
}

/// Distance of the tip from the first axis.
fn reach(chain: &Chain, kinematics: &Kinematics, x: &[f64]) -> f64 {
    let posture = Posture::at(chain, kinematics, x);
    let Some(axis) = posture.axes().first().copied() else { return 0.0 };
    let from = plus(origin(&posture.tip), axis.at, -1.0);
    distance(plus(from, axis.along, -dot(from, axis.along)), [0.0; 3])
}

/// Does the tip stay in one plane, at right angles to the first axis, with the other axes parallel to it or in the plane?
fn is_planar(chain: &Chain, kinematics: &Kinematics) -> bool {
    let mut height: Option<f64> = None;
    (0..4).all(|i| {
        let x: Vec<f64> = (0..chain.dof()).map(|k| 0.3 + 0.7 * f64::from(i) + 0.9 * k as f64).collect();
        let posture = Posture::at(chain, kinematics, &x);
        let axes = posture.axes();
        let Some(first) = axes.first() else { return false };
        let tip = dot(origin(&posture.tip), first.along);
        let same = height.replace(tip).is_none_or(|h| (h - tip).abs() < DIRECTIONS);
        same && axes.iter().all(|a| {
            let along = dot(a.along, first.along).abs();
            if a.prismatic { along < DIRECTIONS } else { along > 1.0 - DIRECTIONS }
        })
    })
}

/// Arms of turning joints alone: everything between the greatest and the least stretch.
fn links(chain: &Chain, kinematics: &Kinematics) -> Option<Rings> {
    let posture = Posture::at(chain, kinematics, &vec![0.3; chain.dof()]);
    let axes = posture.axes();
    let along = axes.first()?.along;
    let flat = |p: V3| plus(p, along, -dot(p, along));
    let points: Vec<V3> = axes.iter().map(|a| flat(a.at)).chain([flat(origin(&posture.tip))]).collect();
    let lengths: Vec<f64> = points.windows(2).filter_map(|p| Some(distance(*p.first()?, *p.last()?))).collect();
    let between = |list: &[f64]| {
        let (sum, most) = (list.iter().sum::<f64>(), list.iter().copied().fold(0.0, f64::max));
        [(2.0 * most - sum).max(0.0), sum]
    };
    let [inner, outer] = between(&lengths);
    let (last, others) = lengths.split_last()?;
    let [low, high] = between(others);
    // The last link may point anywhere if its root stays between the bounds of the others on the whole circle about the tip.
    let most = high - last;
    let least = if low > 0.0 { low + last } else { 0.0 };
    let dexterous = (most > least + 1e-9).then_some([least, most]);
    // Or inside, with the circle around the hole.
    let inside = (low > 0.0 && last - low > 1e-9).then(|| [0.0, (last - low).min(most)]).filter(|r| r[1] > 1e-9);
    Some(Rings { list: vec![Ring { inner, outer, solutions: None }], dexterous: dexterous.or(inside) })
}

const FILLS: [Color; 4] = [Color(226, 238, 248), Color(196, 220, 240), Color(160, 198, 230), Color(128, 176, 218)];
const EDGE: Color = Color(60, 110, 160);
const INK: Color = Color(40, 52, 64);
const WHITE: Color = Color(255, 255, 255);

/// The rings with the number of solutions in each, their radii, and the arm in a posture.
pub fn workspace(chain: &Chain, kinematics: &Kinematics, posture: &Posture) -> Option<Drawing> {
    let rings = rings(chain, kinematics)?;
    let greatest = rings.list.iter().map(|r| r.outer).fold(0.0, f64::max);
    let axis = posture.axes().first().copied()?;
    let scale = 110.0 / greatest;
    // The plane as seen against the first axis.
    let right = if axis.along[2].abs() > 0.5 { [1.0, 0.0, 0.0] } else { column(posture.frames.first()?, 0) };
    let right = plus(right, axis.along, -dot(right, axis.along));
    let up = super::camera::cross(axis.along, right);
    let project = |p: V3| {
        let d = plus(p, axis.at, -1.0);
        [scale * dot(d, right), -scale * dot(d, up)]
    };
    let pen = Pen::new(EDGE, 1.0);
    let mut shapes = Vec::new();
    let circle = |r: f64, fill: Color, pen: Pen| Shape::Circle([0.0; 2], scale * r, Some(fill), Some(pen));
    for ring in rings.list.iter().rev() {
        let fill = FILLS.get(ring.solutions.unwrap_or(2) / 2).or(FILLS.last()).copied().unwrap_or(WHITE);
        shapes.push(circle(ring.outer, fill, pen));
        if ring.inner > 0.0 {
            shapes.push(circle(ring.inner, WHITE, pen));
        }
    }
    if let Some([least, most]) = rings.dexterous {
        let dashed = Pen { dashed: true, ..pen };
        let light = FILLS.get(1).copied().unwrap_or(WHITE);
        shapes.push(circle(most, FILLS[2], dashed));
        if least > 0.0 {
            shapes.push(circle(least, light, dashed));
            if let Some(hole) = rings.list.first().filter(|r| r.inner > 0.0) {
                shapes.push(circle(hole.inner, WHITE, pen));
            }
        }
    }
    for bar in posture.bars() {
        let line: Vec<[f64; 2]> = bar.ends.iter().map(|p| project(*p)).collect();
        shapes.push(Shape::Line(line.clone(), Pen::new(Color(120, 134, 147), 5.0)));
        shapes.push(Shape::Line(line, Pen::new(Color(201, 210, 218), 3.4)));
    }
    for joint in posture.axes() {
        shapes.push(Shape::Circle(project(joint.at), 3.4, Some(Color(111, 139, 166)), Some(Pen::new(INK, 0.7))));
    }
    shapes.push(Shape::Circle(project(origin(&posture.tip)), 2.0, Some(Color(198, 47, 47)), None));
    // Numbers of solutions towards the lower left, radii along the right.
    let label = |r: f64, direction: f64, text: String| {
        let (s, c) = f64::to_radians(direction).sin_cos();
        Shape::Label([scale * r * c, -scale * r * s], Math::number(text), INK)
    };
    for ring in &rings.list {
        if let Some(count) = ring.solutions {
            shapes.push(label(0.5 * (ring.inner + ring.outer), 225.0, count.to_string()));
        }
    }
    if let Some(hole) = rings.list.first().filter(|r| r.inner > 0.12 * greatest) {
        shapes.push(label(0.5 * hole.inner, 225.0, "0".into()));
    }
    shapes.push(label(1.1 * greatest, 225.0, "0".into()));
    let mut radii: Vec<f64> =
        rings.list.iter().flat_map(|r| [r.inner, r.outer]).chain(rings.dexterous.into_iter().flatten()).collect();
    radii.retain(|r| *r > 0.0);
    radii.sort_by(f64::total_cmp);
    radii.dedup_by(|a, b| (*a - *b).abs() < 1e-6 * greatest);
    for (i, r) in radii.iter().enumerate() {
        // Fanned out, so that near radii do not touch.
        let direction = -20.0 - 14.0 * i as f64;
        let (s, c) = f64::to_radians(direction).sin_cos();
        let (from, to) = (scale * r, 1.12 * 110.0);
        shapes.push(Shape::Line(vec![[from * c, -from * s], [to * c, -to * s]], Pen::new(Color(150, 160, 170), 0.6)));
        let text = short(*r);
        let at = to + 6.0 + 2.8 * text.len() as f64;
        shapes.push(Shape::Label([at * c, -(to + 6.0) * s], Math::number(text), INK));
    }
    Some(Drawing::around(shapes, 4.0))
}

/// With as many decimals as are not zero, four at most.
fn short(x: f64) -> String {
    format!("{x:.4}").trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::samples::chain;

    fn of(table: &str) -> Option<Rings> {
        let chain = chain(table);
        rings(&chain, &Kinematics::new(&chain))
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-3
    }

    const TWO: &str = "pub struct A; convention = modified; tool = tx(0.6);
        | alpha | a | d | theta |
        | 0     | 0 | 0 | q1    |
        | 0     | 1 | 0 | q2    |";

    #[test]
    fn two_links_reach_a_ring_in_two_ways() {
        let rings = of(TWO).expect("planar");
        let [ring] = rings.list[..] else { panic!("{rings:?}") };
        assert!(close(ring.inner, 0.4) && close(ring.outer, 1.6) && ring.solutions == Some(2), "{ring:?}");
    }

    #[test]
    fn a_range_of_the_elbow_cuts_the_ring() {
        let table = TWO
            .replace("theta |", "theta | range |")
            .replace("q1    |", "q1 | - |")
            .replace("q2    |", "q2 | -30deg..=90deg |");
        let rings = of(&table).expect("planar");
        let counts: Vec<Option<usize>> = rings.list.iter().map(|r| r.solutions).collect();
        assert_eq!(counts, [Some(1), Some(2)]);
        assert!(close(rings.list[0].inner, (1.0f64 + 0.36).sqrt()), "{rings:?}");
    }

    #[test]
    fn three_links_have_a_dexterous_ring() {
        let table = "pub struct A; convention = standard;
            | theta | d | a | alpha |
            | q1    | 0 | 5 | 0     |
            | q2    | 0 | 2 | 0     |
            | q3    | 0 | 1 | 0     |";
        let rings = of(table).expect("planar");
        assert!(close(rings.list[0].inner, 2.0) && close(rings.list[0].outer, 8.0), "{rings:?}");
        let [least, most] = rings.dexterous.expect("some");
        assert!(close(least, 4.0) && close(most, 6.0));
    }

    #[test]
    fn arms_in_space_have_no_rings() {
        assert_eq!(of(crate::chain::samples::PUMA), None);
        assert_eq!(of(crate::chain::samples::STANFORD), None);
    }
}
