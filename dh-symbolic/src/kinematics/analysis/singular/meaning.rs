//! The geometric meaning of a factor of the Jacobian determinant: axes that align, points that lie on an axis, a stretched elbow.
//!
//! Each statement is a number that vanishes when it holds (a distance, a triple product). A factor means the first statement whose
//! number is a constant multiple of it, judged at joint vectors in general position with parameters in general position.

use super::{Determinant, ReferenceFrame};
use crate::algebra::{Point, Poly};
use crate::chain::{Chain, Coordinate, Handle};
use crate::kinematics::Kinematics;

/// What vanishes with a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Degeneracy {
    /// The axes of two joints become parallel.
    Parallel(usize, usize),
    /// Three parallel axes come to lie in one plane.
    Axes(usize, usize, usize),
    /// Two parallel axes and a point come to lie in one plane.
    Stretched(usize, usize, ReferenceFrame),
    /// A point comes to lie on the axis of a joint.
    OnAxis(ReferenceFrame, usize),
    /// A point comes to lie in the plane through the axis of the first joint parallel to the axis of the second.
    InPlane(ReferenceFrame, usize, usize),
    /// The directions of three axes come to lie in one plane.
    Coplanar(usize, usize, usize),
}

/// What textbooks call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Among the last three joints.
    Wrist,
    /// Between two parallel axes.
    Elbow,
    /// At the first turning joint.
    Shoulder,
}

/// What it means that a factor vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// The statement.
    pub kind: Degeneracy,
    /// Where.
    pub place: Option<Region>,
}

/// Joint vectors at which statements are judged.
const SAMPLES: usize = 4;
use dh_kernels::vector::{cross, dot, norm};

type Vector3 = [f64; 3];

fn minus(a: Vector3, b: Vector3) -> Vector3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// A value in general position.
fn generic(k: usize) -> f64 {
    0.35 + 2.3 * ((k as f64 + 1.0) * 0.618_033_988_749_895).fract()
}

/// Direction and origin of every frame at one joint vector, in the order of the frames from base to tool.
struct Posture {
    frames: Vec<(Vector3, Vector3)>,
    values: Vec<f64>,
}

impl Posture {
    fn new(chain: &Chain, k: &Kinematics, factors: &[&Poly], sample: usize) -> Posture {
        let joint = |c: Coordinate| chain.joints.iter().position(|j| j.coordinate == c);
        let parameter = |h: Handle| chain.parameters.iter().position(|p| p.handle == h).unwrap_or(0);
        let value = |c: Coordinate, h: Handle| match joint(c) {
            Some(i) => generic(17 * (sample + 1) + 5 * i + 31),
            None => generic(parameter(h)),
        };
        let at = Point {
            symbol: &|s| value(Coordinate::Length(s), Handle::Length(s)),
            angle: &|v| value(Coordinate::Angle(v), Handle::Angle(v)),
        };
        let mut r = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut p = [0.0; 3];
        let mut frames = vec![([0.0, 0.0, 1.0], p)];
        let links = (1..=k.len()).filter_map(|i| k.link(i));
        for t in std::iter::once(k.base()).chain(links).chain([k.tool()]) {
            let e: [[f64; 4]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| t.entry(i, j).evaluate(&at)));
            let product = |i: usize, j: usize| (0..3).map(|m| r[i][m] * e[m][j]).sum::<f64>();
            p = std::array::from_fn(|i| p[i] + product(i, 3));
            r = std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)));
            frames.push(([r[0][2], r[1][2], r[2][2]], p));
        }
        Posture { frames, values: factors.iter().map(|f| f.evaluate(&at)).collect() }
    }

    fn frame(&self, s: ReferenceFrame) -> (Vector3, Vector3) {
        let i = match s {
            ReferenceFrame::Base => 0,
            ReferenceFrame::Link(i) => i + 1,
            ReferenceFrame::Tool => self.frames.len() - 1,
        };
        self.frames[i.min(self.frames.len() - 1)]
    }
}

/// The number of a statement.
fn number(chain: &Chain, p: &Posture, kind: Degeneracy) -> f64 {
    let axis = |j: usize| p.frame(ReferenceFrame::of_joint(chain, j));
    match kind {
        Degeneracy::Parallel(i, j) => norm(cross(axis(i).0, axis(j).0)),
        Degeneracy::Axes(i, j, k) => {
            let (z, o) = axis(i);
            dot(z, cross(minus(axis(j).1, o), minus(axis(k).1, o)))
        }
        Degeneracy::Stretched(i, j, s) => {
            let (z, o) = axis(i);
            dot(z, cross(minus(axis(j).1, o), minus(p.frame(s).1, o)))
        }
        Degeneracy::OnAxis(s, i) => norm(cross(axis(i).0, minus(p.frame(s).1, axis(i).1))),
        Degeneracy::InPlane(s, i, j) => dot(cross(axis(i).0, minus(p.frame(s).1, axis(i).1)), axis(j).0),
        Degeneracy::Coplanar(i, j, k) => dot(axis(i).0, cross(axis(j).0, axis(k).0)),
    }
}

/// Statements about this arm, the plainest first.
fn statements(chain: &Chain, d: &Determinant, postures: &[Posture]) -> Vec<Degeneracy> {
    let turning: Vec<usize> = d
        .joints
        .iter()
        .copied()
        .filter(|j| chain.joints.get(*j).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_))))
        .collect();
    let always = |kind: Degeneracy| postures.iter().all(|p| number(chain, p, kind).abs() < 1e-9);
    let parallel = |i: usize, j: usize| always(Degeneracy::Parallel(i, j));
    let pairs = |list: &[usize]| -> Vec<(usize, usize)> {
        list.iter().enumerate().flat_map(|(k, i)| list[k + 1..].iter().map(move |j| (*i, *j))).collect()
    };
    let mut both = pairs(&turning);
    let mut points = vec![d.point];
    points.extend([ReferenceFrame::Tool].into_iter().filter(|s| *s != d.point));
    points.extend(turning.iter().map(|j| ReferenceFrame::of_joint(chain, *j)).filter(|s| *s != d.point));
    both.sort_by_key(|(i, j)| (j - i, *i));
    let mut list: Vec<Degeneracy> =
        both.iter().filter(|(i, j)| !parallel(*i, *j)).map(|(i, j)| Degeneracy::Parallel(*i, *j)).collect();
    for (i, j) in both.iter().filter(|(i, j)| parallel(*i, *j)) {
        list.extend(turning.iter().filter(|k| *k > j && parallel(*j, **k)).map(|k| Degeneracy::Axes(*i, *j, *k)));
        list.extend(points.iter().map(|s| Degeneracy::Stretched(*i, *j, *s)));
    }
    for s in &points {
        list.extend(turning.iter().map(|i| Degeneracy::OnAxis(*s, *i)));
        for i in &turning {
            for j in d.joints.iter().filter(|j| *j != i && !parallel(*i, **j)) {
                // In a plane that the point never leaves sideways, it is the axis itself.
                let square = |p: &Posture| {
                    let (axis, other) =
                        (p.frame(ReferenceFrame::of_joint(chain, *i)), p.frame(ReferenceFrame::of_joint(chain, *j)));
                    dot(axis.0, other.0).abs() + dot(minus(p.frame(*s).1, axis.1), other.0).abs() < 1e-9
                };
                if !postures.iter().all(square) {
                    list.push(Degeneracy::InPlane(*s, *i, *j));
                }
            }
        }
    }
    for (i, j) in &both {
        list.extend(turning.iter().filter(|k| *k > j).map(|k| Degeneracy::Coplanar(*i, *j, *k)));
    }
    list
}

/// Finds the meaning of every factor that moves.
pub(super) fn explain(chain: &Chain, k: &Kinematics, d: &mut Determinant) {
    let values: Vec<&Poly> = d.factors.iter().map(|f| &f.value).collect();
    let postures: Vec<Posture> = (0..SAMPLES).map(|s| Posture::new(chain, k, &values, s)).collect();
    let list = statements(chain, d, &postures);
    let numbers: Vec<Vec<f64>> =
        list.iter().map(|kind| postures.iter().map(|p| number(chain, p, *kind)).collect()).collect();
    let meanings: Vec<Option<Meaning>> = (0..values.len())
        .map(|i| {
            let same = |numbers: &Vec<f64>| {
                let mut ratios = postures.iter().zip(numbers).map(|(p, x)| (x / p.values[i]).abs());
                let first = ratios.next().unwrap_or(0.0);
                first.is_finite() && first > 1e-9 && ratios.all(|r| (r - first).abs() < 1e-9 * (1.0 + first))
            };
            let kind = numbers.iter().zip(&list).find(|(numbers, _)| same(numbers)).map(|(_, kind)| *kind)?;
            Some(Meaning { kind, place: place(chain, d, kind) })
        })
        .collect();
    for (f, meaning) in d.factors.iter_mut().zip(meanings) {
        if f.moves {
            f.meaning = meaning;
        }
    }
}

fn place(chain: &Chain, d: &Determinant, kind: Degeneracy) -> Option<Region> {
    let n = d.joints.len();
    if n < 6 {
        return None;
    }
    let in_wrist = |j: usize| d.joints.get(n - 3..).is_some_and(|w| w.contains(&j));
    let revolute = |j: &&usize| chain.joints.get(**j).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    let first = d.joints.iter().find(revolute).copied();
    match kind {
        Degeneracy::Parallel(i, j) if in_wrist(i) && in_wrist(j) => Some(Region::Wrist),
        Degeneracy::Coplanar(i, j, k) if [i, j, k].into_iter().all(in_wrist) => Some(Region::Wrist),
        Degeneracy::Axes(i, ..) | Degeneracy::Stretched(i, ..) if !in_wrist(i) => Some(Region::Elbow),
        Degeneracy::OnAxis(_, i) | Degeneracy::InPlane(_, i, _) if Some(i) == first => Some(Region::Shoulder),
        _ => None,
    }
}
