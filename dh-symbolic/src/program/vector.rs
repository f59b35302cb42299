//! Three-vectors of program values: rotation, sum, inner and vector product.

use super::graph::{Graph, ONE, Value, ZERO};
use crate::algebra::Poly;
use crate::chain::Elementary;
use crate::kinematics::AngleSum;

/// Three values.
pub(super) type V3 = [Value; 3];

/// Unit vector.
pub(super) fn unit(axis: usize) -> V3 {
    std::array::from_fn(|i| if i == axis { ONE } else { ZERO })
}

/// Unit columns.
pub(super) fn identity() -> [V3; 3] {
    [unit(0), unit(1), unit(2)]
}

/// Turns three columns by Rz on the right: the forward way.
pub(super) fn turn_columns(g: &mut Graph, axis: usize, (c, s): (Value, Value), m: [V3; 3]) -> [V3; 3] {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut w = m;
    let (a, b) = (g.times(c, m[j]), g.times(s, m[k]));
    w[j] = g.plus(a, b);
    let (a, b) = (g.times(c, m[k]), g.times(s, m[j]));
    w[k] = g.minus(a, b);
    w
}

impl Graph {
    /// x * c + y * s.
    fn mix(&mut self, x: Value, c: Value, y: Value, s: Value) -> Value {
        let (a, b) = (self.mul(x, c), self.mul(y, s));
        self.add(a, b)
    }

    /// Turns a vector about axis 0, 1 or 2.
    pub(super) fn turn(&mut self, axis: usize, (c, s): (Value, Value), v: V3) -> V3 {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut w = v;
        w[j] = self.mix(v[j], c, -v[k], s);
        w[k] = self.mix(v[j], s, v[k], c);
        w
    }

    /// Turns about z by an angle sum.
    pub(super) fn turn_z(&mut self, angle_sum: &AngleSum, v: V3) -> V3 {
        let cs = self.cos_sin(&angle_sum.0);
        self.turn(2, cs, v)
    }

    /// Applies constant turns, the last one first.
    pub(super) fn turn_by(&mut self, turns: &[Elementary], v: V3) -> V3 {
        turns.iter().rev().fold(v, |v, e| match e {
            Elementary::Rotate(axis, angle) => {
                let cs = self.cos_sin(angle);
                self.turn(*axis, cs, v)
            }
            Elementary::Translate(..) => v,
        })
    }

    /// Sum.
    pub(super) fn plus(&mut self, a: V3, b: V3) -> V3 {
        std::array::from_fn(|i| self.add(a[i], b[i]))
    }

    /// Difference.
    pub(super) fn minus(&mut self, a: V3, b: V3) -> V3 {
        std::array::from_fn(|i| self.sub(a[i], b[i]))
    }

    /// Multiple.
    pub(super) fn times(&mut self, k: Value, v: V3) -> V3 {
        v.map(|x| self.mul(k, x))
    }

    /// Scalar product.
    pub(super) fn dot(&mut self, a: V3, b: V3) -> Value {
        let (x, y) = (self.mix(a[0], b[0], a[1], b[1]), self.mul(a[2], b[2]));
        self.add(x, y)
    }

    /// Cross product.
    pub(super) fn cross(&mut self, a: V3, b: V3) -> V3 {
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            self.mix(a[j], b[k], -a[k], b[j])
        })
    }

    /// A vector of formulas.
    pub(super) fn vector(&mut self, v: &[Poly; 3]) -> V3 {
        std::array::from_fn(|i| self.polynomial(&v[i]))
    }
}
