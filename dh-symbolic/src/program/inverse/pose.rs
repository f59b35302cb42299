//! Poses of values, multiplied by constant transforms and by joints that are known.

use super::super::graph::{Graph, ZERO};
use super::super::vector::V3;
use super::lower::{Lower, Pose};
use crate::algebra::Transform;
use crate::chain::Coordinate;

impl Lower<'_> {
    /// t^-1 W.
    pub(super) fn before_inverse(&mut self, w: Pose, t: &Transform) -> Pose {
        let columns: [V3; 3] = std::array::from_fn(|j| self.vector(&t.column(j)));
        let shift = self.vector(&t.p);
        let p = self.g.minus(w.p, shift);
        let mut turned = |v: V3| -> V3 { std::array::from_fn(|i| self.g.dot(columns[i], v)) };
        Pose { columns: w.columns.map(&mut turned), p: turned(p) }
    }

    /// W t^-1.
    pub(super) fn after_inverse(&mut self, w: Pose, t: &Transform) -> Pose {
        // R' = R Rt^T: column j is the sum over k of Rt[j][k] times column k.
        let columns: [V3; 3] = std::array::from_fn(|j| {
            let mut sum = [ZERO; 3];
            for k in 0..3 {
                let x = self.g.polynomial(&t.r[j][k]);
                let part = self.g.times(x, w.columns[k]);
                sum = self.g.plus(sum, part);
            }
            sum
        });
        let mut p = w.p;
        for (column, x) in columns.iter().zip(&t.p) {
            let x = self.g.polynomial(x);
            let part = self.g.times(x, *column);
            p = self.g.minus(p, part);
        }
        Pose { columns, p }
    }

    /// T * t for a constant t.
    pub(super) fn times(&mut self, a: Pose, t: &Transform) -> Pose {
        let apply = |g: &mut Graph, v: V3| {
            let mut sum = [ZERO; 3];
            for k in 0..3 {
                let part = g.times(v[k], a.columns[k]);
                sum = g.plus(sum, part);
            }
            sum
        };
        let columns = std::array::from_fn(|j| {
            let v = self.vector(&t.column(j));
            apply(&mut self.g, v)
        });
        let v = self.vector(&t.p);
        let moved = apply(&mut self.g, v);
        Pose { columns, p: self.g.plus(a.p, moved) }
    }

    /// T times the motion of a joint that is known.
    pub(super) fn moved(&mut self, t: Pose, joint: usize, before: usize) -> Pose {
        let mut out = t;
        match self.plan.axes.coordinates[joint] {
            Coordinate::Angle(_) => {
                let mut unit = vec![0; self.plan.axes.count()];
                unit[joint] = 1;
                let (c, s) = self.cos_sin(&unit, before);
                let (x, y) = (t.columns[0], t.columns[1]);
                let (a, b) = (self.g.times(c, x), self.g.times(s, y));
                out.columns[0] = self.g.plus(a, b);
                let (a, b) = (self.g.times(c, y), self.g.times(s, x));
                out.columns[1] = self.g.minus(a, b);
            }
            Coordinate::Length(s) => {
                let d = self.g.symbol(s);
                let part = self.g.times(d, t.columns[2]);
                out.p = self.g.plus(out.p, part);
            }
        }
        out
    }
}
