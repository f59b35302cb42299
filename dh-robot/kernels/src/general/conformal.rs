//! The action of a rigid transform on an axis with a point on it, as a linear map of fourteen numbers.
//!
//! For a point `p` on an axis with direction `l`, Raghavan and Roth's fourteen expressions
//!
//! ```text
//! l,  p x l,  (p.p) l - 2 (p.l) p,  p,  p.p,  p.l
//! ```
//!
//! (three vectors and a half, so to speak) and the constant 1 are mapped among themselves, linearly, by every rigid transform: they
//! are a representation of the group. A turn about z acts on them linearly in its cosine and sine, a slide along z
//! quadratically, so a product of joints and links has three monomials per joint. This is why the fourteen equations have so few.

use super::super::pose::Pose;
use super::super::vector::{cross, dot};

/// The number of expressions, without the constant.
pub(super) const EXPRESSIONS: usize = 14;

/// The expressions of an axis, or a coefficient vector of them.
#[derive(Clone, Copy, Default)]
pub(super) struct Axis {
    /// `l`, `p x l`, `(p.p) l - 2 (p.l) p` and `p`.
    vectors: [[f64; 3]; 4],
    /// `p.p` and `p.l`.
    scalars: [f64; 2],
    /// 1 for an axis; 0 for the coefficient of a cosine or sine.
    one: f64,
}

impl Axis {
    /// The z axis of a frame, with the frame's origin.
    pub(super) const Z: Self =
        Self { vectors: [[0.0, 0.0, 1.0], [0.0; 3], [0.0; 3], [0.0; 3]], scalars: [0.0; 2], one: 1.0 };

    /// All expressions in a row.
    #[inline]
    pub(super) fn expressions(&self) -> [f64; EXPRESSIONS] {
        let [l, m, r, p] = self.vectors;
        let [pp, pl] = self.scalars;
        [l[0], l[1], l[2], m[0], m[1], m[2], r[0], r[1], r[2], p[0], p[1], p[2], pp, pl]
    }

    /// The axis after a rigid transform.
    #[inline]
    pub(super) fn moved(&self, by: &Pose) -> Self {
        let [l, m, r, p] = &self.vectors;
        let [l, m, r, p] = [rotated(by, l), rotated(by, m), rotated(by, r), rotated(by, p)];
        let [pp, pl] = self.scalars;
        let t = [by[0][3], by[1][3], by[2][3]];
        let tt = dot(t, t);
        let along = dot(t, l);
        let (tl, tm) = (cross(t, l), cross(t, m));
        let mut out =
            Self { vectors: [l, m, r, p], scalars: [pp + 2.0 * dot(t, p) + tt * self.one, pl + along], one: self.one };
        for i in 0..3 {
            out.vectors[1][i] += tl[i];
            out.vectors[2][i] += tt * l[i] - 2.0 * (tm[i] + (along + pl) * t[i]);
            out.vectors[3][i] += t[i] * self.one;
        }
        out
    }

    /// The axis after a slide along z, as coefficients of 1, the way and its square.
    #[inline]
    pub(super) fn slid(&self) -> [Self; 3] {
        let [l, m, _, p] = self.vectors;
        let [_, pl] = self.scalars;
        let along = |v: [f64; 3]| [-v[1], v[0], 0.0];
        let (zl, zm) = (along(l), along(m));
        let way = Self {
            vectors: [[0.0; 3], zl, [-2.0 * zm[0], -2.0 * zm[1], -2.0 * pl], [0.0, 0.0, self.one]],
            scalars: [2.0 * p[2], l[2]],
            one: 0.0,
        };
        let square =
            Self { vectors: [[0.0; 3], [0.0; 3], [l[0], l[1], -l[2]], [0.0; 3]], scalars: [self.one, 0.0], one: 0.0 };
        [*self, way, square]
    }

    /// What a joint makes of the axis: [`Axis::slid`] or [`Axis::turned`].
    #[inline]
    pub(super) fn joined(&self, prismatic: bool) -> [Self; 3] {
        if prismatic { self.slid() } else { self.turned() }
    }

    /// The same for the joint's inverse, still as coefficients for the joint's own value.
    #[inline]
    pub(super) fn joined_backwards(&self, prismatic: bool) -> [Self; 3] {
        let [a, b, c] = self.joined(prismatic);
        if prismatic { [a, b.negated(), c] } else { [a, b, c.negated()] }
    }

    /// All expressions with the opposite sign.
    #[inline]
    pub(super) fn negated(&self) -> Self {
        Self { vectors: self.vectors.map(|v| v.map(|x| -x)), scalars: self.scalars.map(|x| -x), one: -self.one }
    }

    /// The axis after a turn about z, as coefficients of 1, `cos` and `sin`.
    #[inline]
    pub(super) fn turned(&self) -> [Self; 3] {
        let mut out =
            [Self { scalars: self.scalars, one: self.one, ..Self::default() }, Self::default(), Self::default()];
        for (i, v) in self.vectors.iter().enumerate() {
            out[0].vectors[i][2] = v[2];
            out[1].vectors[i] = [v[0], v[1], 0.0];
            out[2].vectors[i] = [-v[1], v[0], 0.0];
        }
        out
    }
}

/// A direction after the rotation of a transform.
#[inline]
fn rotated([x, y, z]: &Pose, v: &[f64; 3]) -> [f64; 3] {
    [
        x[0] * v[0] + x[1] * v[1] + x[2] * v[2],
        y[0] * v[0] + y[1] * v[1] + y[2] * v[2],
        z[0] * v[0] + z[1] * v[1] + z[2] * v[2],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::{IDENTITY, compose, slide, turn};
    use crate::testing::{Rng, random_pose};

    /// The fourteen expressions from their definition.
    fn expressions_of(frame: &Pose) -> [f64; 14] {
        let (p, l) = ([frame[0][3], frame[1][3], frame[2][3]], [frame[0][2], frame[1][2], frame[2][2]]);
        let (m, pp, pl) = (cross(p, l), dot(p, p), dot(p, l));
        let r = [0, 1, 2].map(|i| pp * l[i] - 2.0 * pl * p[i]);
        [l[0], l[1], l[2], m[0], m[1], m[2], r[0], r[1], r[2], p[0], p[1], p[2], pp, pl]
    }

    #[test]
    fn moving_an_axis_moves_its_expressions() {
        let mut rng = Rng::new(60);
        for _ in 0..20 {
            let (a, b) = (random_pose(&mut rng), random_pose(&mut rng));
            let moved = Axis::Z.moved(&b).moved(&a).expressions();
            let expected = expressions_of(&compose(&a, &b));
            assert!(moved.iter().zip(&expected).all(|(x, y)| (x - y).abs() < 1e-13));
        }
    }

    #[test]
    fn turning_is_linear_in_cosine_and_sine() {
        let mut rng = Rng::new(61);
        let (a, t) = (random_pose(&mut rng), 0.7f64);
        let parts = Axis::Z.moved(&a).turned().map(|x| x.expressions());
        let expected = expressions_of(&compose(&turn(&IDENTITY, [t.cos(), t.sin()]), &a));
        for i in 0..14 {
            assert!((parts[0][i] + parts[1][i] * t.cos() + parts[2][i] * t.sin() - expected[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn sliding_is_quadratic_in_the_way() {
        let mut rng = Rng::new(62);
        let (a, d) = (random_pose(&mut rng), 0.7f64);
        let parts = Axis::Z.moved(&a).slid().map(|x| x.expressions());
        let expected = expressions_of(&compose(&slide(&IDENTITY, d), &a));
        for i in 0..14 {
            assert!((parts[0][i] + parts[1][i] * d + parts[2][i] * d * d - expected[i]).abs() < 1e-14);
        }
    }
}
