//! The arm with its frames and the names of its lengths; all postures of a pose side by side.

use super::camera::{Camera, V3, cross, distance, dot, hull, plus};
use super::drawing::{Color, Drawing, Pen, Shape, label_size};
use super::posture::{Axis, BarPart, Posture, column, origin};
use crate::chain::Chain;
use crate::render::formula::grouping::Order;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::Notation;

const RED: Color = Color(198, 47, 47);
const BLUE: Color = Color(34, 85, 196);
const INK: Color = Color(40, 52, 64);
const STEEL: Color = Color(111, 139, 166);
const LIGHT_STEEL: Color = Color(170, 190, 208);
const BRASS: Color = Color(217, 180, 80);
const LIGHT_BRASS: Color = Color(239, 212, 138);
const BAR: Color = Color(201, 210, 218);
const BAR_EDGE: Color = Color(120, 134, 147);
const FLOOR: Color = Color(222, 227, 232);

/// Side of the square that an arm fits into.
const LARGE: f64 = 300.0;
/// The same for one of several postures.
const SMALL: f64 = 88.0;

/// An arm with frames, joints and the names of its lengths.
pub fn arm(chain: &Chain, notation: &Notation, posture: &Posture) -> Drawing {
    let camera = Camera::of(&posture.points(), posture.is_flat(), LARGE);
    let mut shapes = floor(&camera, posture);
    shapes.extend(body(&camera, posture, 1.0));
    let mut labels = Labels::new(&shapes);
    let arrows = arrows(&camera, posture, 42.0, &mut shapes);
    for arrow in arrows {
        labels.beyond(&arrow, &mut shapes);
    }
    let order = Order::of(chain);
    for bar in posture.bars() {
        let length = match bar.part {
            BarPart::Length(row) => chain.links.get(row).map(|l| &l.a),
            BarPart::Offset(row) => chain.links.get(row).map(|l| &l.d),
            BarPart::Base | BarPart::Tool => None,
        };
        let Some(length) = length else { continue };
        // The sign tells the direction; the label names the distance.
        let name = notation.typeset(&order.group(length));
        let name = if matches!(&name, Math::Row(r) if matches!(r.first(), Some(Math::Sign(Sign::Negative)))) {
            notation.typeset(&order.group(&-length))
        } else {
            name
        };
        let [a, b] = bar.ends.map(|p| camera.project(p));
        labels.beside(a, b, name, &mut shapes);
    }
    Drawing::around(shapes, 6.0)
}

/// Several postures that reach the same pose, numbered from 1.
pub fn postures(list: &[Posture]) -> Drawing {
    let points: Vec<V3> = list.iter().flat_map(Posture::points).collect();
    let flat = list.iter().all(Posture::is_flat);
    let camera = Camera::of(&points, flat, SMALL);
    let corners: Vec<[f64; 2]> = points.iter().map(|p| camera.project(*p)).collect();
    let low: [f64; 2] = std::array::from_fn(|i| corners.iter().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let drawings = list
        .iter()
        .enumerate()
        .map(|(i, posture)| {
            let mut shapes = floor(&camera, posture);
            shapes.extend(body(&camera, posture, 0.5));
            arrows(&camera, &posture.tip_alone(), 20.0, &mut shapes);
            // Points without ink at the corners of what all postures take keep them in the same place of their cells.
            shapes.extend(corners.iter().map(|c| Shape::Circle(*c, 0.0, None, None)));
            shapes.push(Shape::Label([low[0] - 8.0, low[1] - 10.0], Math::number(i + 1), INK));
            Drawing::around(shapes, 7.0)
        })
        .collect();
    Drawing::in_rows(drawings, 4)
}

/// A cross on the floor below the base.
fn floor(camera: &Camera, posture: &Posture) -> Vec<Shape> {
    let size = posture.points().iter().map(|p| distance(*p, [0.0; 3])).fold(0.0, f64::max) * 0.2;
    if posture.is_flat() || size == 0.0 {
        return Vec::new();
    }
    let ring: Vec<[f64; 2]> = (0..24)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 24.0)
        .map(|t| camera.project([size * t.cos(), size * t.sin(), 0.0]))
        .collect();
    vec![Shape::Area(ring, Color(244, 246, 248), Some(Pen::new(FLOOR, 0.8)))]
}

/// Bars and joints, the farthest first; `thick` scales them.
fn body(camera: &Camera, posture: &Posture, thick: f64) -> Vec<Shape> {
    let mut items: Vec<(f64, Vec<Shape>)> = Vec::new();
    for bar in posture.bars() {
        let [a, b] = bar.ends;
        let width = thick * if bar.prismatic { 4.0 } else { 6.5 };
        let (fill, edge) = if bar.prismatic { (LIGHT_BRASS, Color(150, 125, 50)) } else { (BAR, BAR_EDGE) };
        let line = vec![camera.project(a), camera.project(b)];
        let shapes = vec![
            Shape::Line(line.clone(), Pen::new(edge, width + 1.6 * thick.max(0.6))),
            Shape::Line(line, Pen::new(fill, width)),
        ];
        items.push((camera.depth(plus(a, plus(b, a, -1.0), 0.5)), shapes));
    }
    for axis in posture.axes() {
        let shrink = thick * (1.0 - 0.05 * axis.joint as f64).max(0.6) / camera.scale;
        let (along, across) = if axis.prismatic { (15.0, 6.5) } else { (12.0, 7.5) };
        items.push((
            camera.depth(axis.at) + across * shrink,
            prism(camera, &axis, along * shrink, across * shrink, thick),
        ));
    }
    items.sort_by(|a, b| a.0.total_cmp(&b.0));
    items.into_iter().flat_map(|item| item.1).collect()
}

/// A cylinder for a turning joint, a box for a sliding one.
fn prism(camera: &Camera, axis: &Axis, along: f64, across: f64, thick: f64) -> Vec<Shape> {
    let side = if axis.along[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
    let u = cross(axis.along, side);
    let u = u.map(|x| x / dot(u, u).sqrt());
    let v = cross(axis.along, u);
    let corners = match axis.prismatic {
        true => 4,
        false if thick < 1.0 => 12,
        false => 20,
    };
    let ring = |end: f64| -> Vec<[f64; 2]> {
        let turn = |i: usize| std::f64::consts::TAU * (i as f64 + 0.5) / corners as f64;
        let at = |t: f64| plus(plus(plus(axis.at, axis.along, end), u, across * t.cos()), v, across * t.sin());
        (0..corners).map(|i| camera.project(at(turn(i)))).collect()
    };
    let near = if dot(axis.along, camera.toward) >= 0.0 { along } else { -along };
    let (front, back) = (ring(near), ring(-near));
    let (fill, cap, edge) =
        if axis.prismatic { (BRASS, LIGHT_BRASS, Color(107, 87, 21)) } else { (STEEL, LIGHT_STEEL, Color(51, 72, 92)) };
    let pen = Some(Pen::new(edge, 0.8 * thick.max(0.6)));
    let mut shapes = vec![Shape::Area(hull(&[front.clone(), back].concat()), fill, pen)];
    if axis.prismatic {
        // The edges between the two visible sides.
        for (i, corner) in front.iter().enumerate() {
            let t = std::f64::consts::TAU * (i as f64 + 0.5) / 4.0;
            let outward = plus(u.map(|x| x * t.cos()), v, t.sin());
            if dot(outward, camera.toward) > 0.3 {
                let end = plus(plus(plus(axis.at, axis.along, -near), u, across * t.cos()), v, across * t.sin());
                shapes.push(Shape::Line(vec![*corner, camera.project(end)], Pen::new(edge, 0.6 * thick.max(0.6))));
            }
        }
    }
    shapes.push(Shape::Area(front, cap, pen));
    shapes
}

/// An arrow of a frame, in the drawing plane.
struct Arrow {
    letter: char,
    color: Color,
    ends: [[f64; 2]; 2],
    names: Vec<String>,
}

/// Draws the x and z axes of all frames; those that fall together are one arrow.
fn arrows(camera: &Camera, posture: &Posture, length: f64, shapes: &mut Vec<Shape>) -> Vec<Arrow> {
    let mut list: Vec<Arrow> = Vec::new();
    let named = posture.frames.iter().enumerate().map(|(i, f)| (i.to_string(), f));
    let tool = posture.has_tool().then(|| ("T".to_string(), &posture.tip));
    for (name, frame) in named.chain(tool) {
        for (letter, k, color) in [('x', 0, RED), ('z', 2, BLUE)] {
            let from = origin(frame);
            let to = plus(from, column(frame, k), length / camera.scale);
            let ends = [camera.project(from), camera.project(to)];
            let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) < 3.0;
            match list.iter_mut().find(|a| a.letter == letter && near(a.ends[0], ends[0]) && near(a.ends[1], ends[1])) {
                Some(same) => same.names.push(name.clone()),
                None => list.push(Arrow { letter, color, ends, names: vec![name.clone()] }),
            }
        }
    }
    for arrow in &list {
        let [a, b] = arrow.ends;
        let far = (b[0] - a[0]).hypot(b[1] - a[1]);
        let pen = Pen::new(arrow.color, if length > 30.0 { 1.3 } else { 1.0 });
        if far < 3.0 {
            // Towards the eye: a dot.
            shapes.push(Shape::Circle(a, 2.0, Some(arrow.color), None));
            continue;
        }
        let (ux, uy) = ((b[0] - a[0]) / far, (b[1] - a[1]) / far);
        shapes.push(Shape::Line(vec![a, b], pen));
        let head = vec![
            [b[0] + 4.0 * ux, b[1] + 4.0 * uy],
            [b[0] - 2.4 * uy, b[1] + 2.4 * ux],
            [b[0] + 2.4 * uy, b[1] - 2.4 * ux],
        ];
        shapes.push(Shape::Area(head, arrow.color, None));
    }
    list
}

/// Places of labels, so that none covers another.
struct Labels {
    taken: Vec<([f64; 2], [f64; 2])>,
    centre: [f64; 2],
}

impl Labels {
    fn new(shapes: &[Shape]) -> Labels {
        let points: Vec<[f64; 2]> = shapes
            .iter()
            .filter_map(|s| match s {
                Shape::Line(points, _) => points.first().copied(),
                _ => None,
            })
            .collect();
        let n = points.len().max(1) as f64;
        Labels { taken: Vec::new(), centre: std::array::from_fn(|i| points.iter().map(|p| p[i]).sum::<f64>() / n) }
    }

    fn is_free(&self, at: [f64; 2], size: [f64; 2]) -> bool {
        self.taken.iter().all(|(p, s)| {
            (p[0] - at[0]).abs() > 0.5 * (s[0] + size[0]) || (p[1] - at[1]).abs() > 0.42 * (s[1] + size[1])
        })
    }

    /// Puts a label at the first of some places that is free, else at the last one.
    fn put(&mut self, places: &[[f64; 2]], math: Math, color: Color, shapes: &mut Vec<Shape>) {
        let size = label_size(&math);
        let free = places.iter().find(|p| self.is_free(**p, size)).or(places.last());
        if let Some(at) = free.copied() {
            self.taken.push((at, size));
            shapes.push(Shape::Label(at, math, color));
        }
    }

    /// The name of an arrow, past its tip or beside it.
    fn beyond(&mut self, arrow: &Arrow, shapes: &mut Vec<Shape>) {
        let [a, b] = arrow.ends;
        let far = (b[0] - a[0]).hypot(b[1] - a[1]);
        let (ux, uy) = if far < 3.0 { (-0.6, 0.8) } else { ((b[0] - a[0]) / far, (b[1] - a[1]) / far) };
        let places: Vec<[f64; 2]> = [
            (11.0, 0.0),
            (12.0, 10.0),
            (12.0, -10.0),
            (22.0, 0.0),
            (22.0, 11.0),
            (22.0, -11.0),
            (0.0, 13.0),
            (0.0, -13.0),
            (33.0, 0.0),
        ]
        .iter()
        .map(|(along, aside)| [b[0] + along * ux - aside * uy, b[1] + along * uy + aside * ux])
        .collect();
        let mut index = Vec::new();
        for name in &arrow.names {
            if !index.is_empty() {
                index.push(Math::Sign(Sign::Comma));
            }
            index.push(if name == "T" { Math::Letter('T') } else { Math::number(name) });
        }
        self.put(&places, Math::Letter(arrow.letter).below(Math::Row(index)), arrow.color, shapes);
    }

    /// The name of a length, beside its bar on the outer side.
    fn beside(&mut self, a: [f64; 2], b: [f64; 2], math: Math, shapes: &mut Vec<Shape>) {
        let far = (b[0] - a[0]).hypot(b[1] - a[1]).max(1e-9);
        let (ux, uy) = ((b[0] - a[0]) / far, (b[1] - a[1]) / far);
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let outward = (middle[0] - self.centre[0]) * -uy + (middle[1] - self.centre[1]) * ux;
        let side = if outward < 0.0 { -1.0 } else { 1.0 };
        let half = 0.5 * label_size(&math)[0];
        // Far enough from the bar for the label's own width.
        let off = 9.0 + half * uy.abs();
        let places: Vec<[f64; 2]> =
            [(0.0, 1.0), (0.0, -1.0), (0.22, 1.0), (-0.22, 1.0), (0.22, -1.0), (-0.22, -1.0), (0.0, 1.8), (0.0, -1.8)]
                .iter()
                .map(|(along, aside)| {
                    let (along, aside) = (along * far, aside * side * off);
                    [middle[0] + along * ux - aside * uy, middle[1] + along * uy + aside * ux]
                })
                .collect();
        self.put(&places, math, INK, shapes);
    }
}
