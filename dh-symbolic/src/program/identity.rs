//! Proof by values in a prime field (see [`FieldPoint`]) that a program computes the product of link transforms: for long chains and odd twists,
//! whose normal forms have thousands of terms. Program and product of link transforms must agree at every point.

use super::Program;
use super::fold::Arithmetic;
use super::proof::Disproof;
use crate::algebra::{Element, FieldPoint, LinearAngle, Poly, Symbol, Transform, cross};
use crate::chain::{Chain, Coordinate, Elementary};
use crate::kinematics::Kinematics;

/// Number of points: the chance that different formulas agree at all of them is below 1e-60.
const POINTS: u64 = 4;

/// Columns and position.
type FieldFrame = [[Element; 3]; 4];

/// Elements of a prime field, at a point.
struct Elements<'a>(&'a FieldPoint);

impl Arithmetic for Elements<'_> {
    type Number = Element;

    fn zero(&mut self) -> Element {
        Element::ZERO
    }

    fn constant(&mut self, p: &Poly) -> Element {
        self.0.value(p)
    }

    fn symbol(&mut self, s: Symbol) -> Element {
        self.0.symbol(s)
    }

    fn harmonic(&mut self, _: usize, angle: &LinearAngle, sine: bool) -> Element {
        let (cosine, other) = self.0.cos_sin(angle).unwrap_or((Element::ZERO, Element::ZERO));
        if sine { other } else { cosine }
    }

    fn negative(&mut self, a: Element) -> Element {
        a.negative()
    }

    fn add(&mut self, a: Element, b: Element) -> Element {
        a.plus(b)
    }

    fn multiply(&mut self, a: Element, b: Element) -> Element {
        a.times(b)
    }
}

fn values(program: &Program, at: &FieldPoint) -> Vec<Element> {
    program.graph.fold(&program.outputs, &mut Elements(at))
}

fn frame_of(t: &Transform, at: &FieldPoint) -> FieldFrame {
    std::array::from_fn(|j| t.column(j).map(|p| at.value(&p)))
}

fn times(a: &FieldFrame, b: &FieldFrame) -> FieldFrame {
    let apply = |v: &[Element; 3], shift: bool| -> [Element; 3] {
        std::array::from_fn(|i| {
            let sum = (0..3).fold(Element::ZERO, |s, k| s.plus(a[k][i].times(v[k])));
            if shift { sum.plus(a[3][i]) } else { sum }
        })
    };
    std::array::from_fn(|j| apply(&b[j], j == 3))
}

/// What the product of link transforms gives: every frame, the pose, and per joint its axis and a point on it.
struct Truth {
    frames: Vec<FieldFrame>,
    pose: FieldFrame,
    axes: Vec<FieldFrame>,
}

fn truth(chain: &Chain, kinematics: &Kinematics, at: &FieldPoint) -> Truth {
    let mut t = frame_of(kinematics.base(), at);
    let (mut frames, mut axes) = (Vec::new(), Vec::new());
    for (row, link) in chain.links.iter().enumerate() {
        if link.joint.is_some() {
            let mut axis = t;
            for e in chain.link_factors(row) {
                if matches!(e, Elementary::Rotate(2, _) | Elementary::Translate(2, _)) {
                    break;
                }
                axis = times(&axis, &frame_of(&e.transform(), at));
            }
            axes.push(axis);
        }
        if let Some(link) = kinematics.link(row + 1) {
            t = times(&t, &frame_of(link, at));
        }
        frames.push(t);
    }
    Truth { pose: times(&t, &frame_of(kinematics.tool(), at)), frames, axes }
}

fn same(got: &[Element], want: impl Iterator<Item = Element>, name: impl Fn(usize) -> String) -> Result<(), Disproof> {
    for (i, want) in want.enumerate() {
        if got.get(i) != Some(&want) {
            return Err(Disproof { output: name(i), difference: None });
        }
    }
    Ok(())
}

/// Pose, frames and Jacobian (see [`super::Forward`]) against the product of link transforms.
///
/// # Errors
/// The first output that differs.
pub fn test_identities(forward: &super::Forward, chain: &Chain, kinematics: &Kinematics) -> Result<(), Disproof> {
    for n in 0..POINTS {
        let at = FieldPoint::new(n);
        let truth = truth(chain, kinematics, &at);
        let entries = |f: &FieldFrame| f.concat().into_iter().collect::<Vec<_>>().into_iter();
        same(&values(&forward.pose, &at), entries(&truth.pose), |k| format!("output {k} of the pose"))?;
        let frames = truth.frames.iter().flat_map(|f| f.concat()).collect::<Vec<_>>().into_iter();
        same(&values(&forward.frames, &at), frames, |k| format!("output {} of frame {}", k % 12, k / 12 + 1))?;
        let mut want: Vec<Element> = truth.pose.concat();
        let columns: Vec<[[Element; 3]; 2]> = chain
            .joints
            .iter()
            .zip(&truth.axes)
            .map(|(joint, axis)| match joint.coordinate {
                Coordinate::Length(_) => [axis[2], [Element::ZERO; 3]],
                Coordinate::Angle(_) => {
                    let lever = std::array::from_fn(|i| truth.pose[3][i].plus(axis[3][i].negative()));
                    [cross(&axis[2], &lever), axis[2]]
                }
            })
            .collect();
        for actuator in 0..chain.dof() {
            let drive: Vec<Element> = chain.drive.iter().map(|row| at.value(&row[actuator])).collect();
            for part in 0..2 {
                for i in 0..3 {
                    want.push(columns.iter().zip(&drive).fold(Element::ZERO, |s, (c, k)| s.plus(c[part][i].times(*k))));
                }
            }
        }
        same(&values(&forward.jacobian, &at), want.into_iter(), |k| format!("output {k} of pose and Jacobian"))?;
    }
    Ok(())
}
