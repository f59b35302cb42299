//! The positioning structure of an arm whose last three axes meet: where the wrist centre is, as functions f, g and k of the joint angles.
//!
//! **In:** a chain. **Out:** [`Positioning`], exact. Both conventions describe the same sequence of motions, turn about a joint axis, way
//! along it, way along the common normal, twist: f and g are the wrist centre before the turns of the third and the second joint.

use crate::algebra::{AngleVar, Poly, Ring, Symbol, Transform, Vector};
use crate::chain::{Chain, Convention, Coordinate, Elementary};

/// The first three joints of an arm with a spherical wrist.
pub(super) struct Positioning {
    /// Angles of joints 1 to 6.
    pub(super) angles: [AngleVar; 6],
    /// Constant motions before the first joint, along its axis included.
    pub(super) head: Vec<Elementary>,
    /// Constant motions between the joint axes; the way along the axis first.
    pub(super) between: [Vec<Elementary>; 6],
    /// The wrist centre seen from the last frame.
    pub(super) from_tip: Vector,
    /// The wrist centre after the third turn and what follows, as the fourth column of a product: `f(theta3)`.
    pub(super) f: Vector,
    /// The wrist centre `g(theta2, f)` in letters for f.
    pub(super) g: Vector,
    /// Letters for the components of f.
    pub(super) letters: [Symbol; 3],
    /// Length and twist between the first two axes, way along the second.
    pub(super) first: Poly,
    pub(super) twist: (Poly, Poly),
    pub(super) offset: Poly,
}

fn product(list: &[Elementary]) -> Transform {
    list.iter().fold(Transform::identity(), |t, e| t.times(&e.transform()))
}

fn image(t: &Transform, v: &Vector) -> Vector {
    let turned = t.rotate(v);
    std::array::from_fn(|i| &turned[i] + &t.p[i])
}

/// Turns about z.
pub(super) fn turn(v: AngleVar) -> Transform {
    let (c, s) = Poly::cos_sin(v);
    Transform::rotation(2, (&c, &s))
}

impl Positioning {
    /// `None` where the arm has not six turning joints of which the last three meet.
    pub(super) fn of(chain: &Chain) -> Option<Positioning> {
        if chain.links.len() != 6 || chain.joints.len() != 6 {
            return None;
        }
        let mut angles = Vec::new();
        let mut parts: Vec<Vec<Elementary>> = vec![Vec::new()];
        for link in &chain.links {
            let Coordinate::Angle(v) = chain.joints.get(link.joint?)?.coordinate else { return None };
            if link.theta.terms != [(v, 1)] || !link.theta.constant.is_zero() {
                return None;
            }
            angles.push(v);
            for e in chain.convention.factors(link) {
                match &e {
                    Elementary::Rotate(2, _) => parts.push(Vec::new()),
                    e if e.is_identity() => {}
                    e => parts.last_mut()?.push(e.clone()),
                }
            }
        }
        let angles: [AngleVar; 6] = angles.try_into().ok()?;
        // The way along the first axis does not care about its turn.
        let mut parts = parts.into_iter();
        let mut head = parts.next()?;
        let mut between: [Vec<Elementary>; 6] = parts.collect::<Vec<_>>().try_into().ok()?;
        if matches!(between[0].first(), Some(Elementary::Translate(2, _))) {
            head.push(between[0].remove(0));
        }
        let along = |list: &[Elementary]| -> Vec<Elementary> {
            list.iter().take_while(|e| matches!(e, Elementary::Translate(2, _))).cloned().collect()
        };
        let lasts = product(&between[3]);
        let meets = product(&between[3][along(&between[3]).len()..]).p.iter().all(Poly::is_zero)
            && product(&between[4]).p.iter().all(Poly::is_zero);
        if !meets || lasts.r[2][2].is_one() || product(&between[4]).r[2][2].is_one() {
            return None;
        }
        let from_tip = product(&between[5]).inverse().p;
        let wrist = product(&along(&between[3])).p;
        let n = along(&between[1]).len();
        let third = image(&turn(angles[2]), &image(&product(&between[2]), &wrist));
        let f = image(&product(&between[1][n..]), &third);
        let mut ring: Ring = chain.ring.clone();
        let letters = ["wrist f1", "wrist f2", "wrist f3"].map(|n| ring.symbol(n));
        let shifted = image(&product(&between[1][..n]), &letters.map(Poly::symbol));
        let g = image(&product(&between[0]), &image(&turn(angles[1]), &shifted));
        let row = chain.links.get(usize::from(chain.convention == Convention::Modified))?;
        Some(Positioning {
            angles,
            head,
            from_tip,
            f,
            g,
            letters,
            first: row.a.clone(),
            twist: row.alpha.cos_sin()?,
            offset: chain.links.get(1)?.d.clone(),
            between,
        })
    }
}
