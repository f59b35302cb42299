//! The closed loop of six joints as fourteen equations in five joint values, and the linear elimination of two of them.

use super::super::chain::NumericChain;
use super::super::elementary::sqrt;
use super::super::pose::{Pose, compose, inverse};
use super::choice::Choice;
use super::conformal::{Axis, EXPRESSIONS};

/// Monomials of the three middle joints: `(1, cos, sin)` or `(1, d, d^2)` of each; the last joint runs fastest.
pub(super) const MONOMIALS: usize = 27;
/// Monomials of the two linear joints, without the constant.
const LINEAR: usize = 8;
/// Equations without the two linear joints.
pub(super) const EQUATIONS: usize = EXPRESSIONS - LINEAR;

/// The equations `X3 X4 X5 z = (X6 X1 X2)^-1 z` of the loop `X1 X2 X3 X4 X5 X6 = 1`, `X = Rz(angle) D` or `Tz(d) D`, triangularised.
///
/// `z` is the last joint's axis; that joint turns, so its angle does not occur. On the left, an expression is a combination of 27 monomials in the
/// middle angles; on the right, of 9 in the first two. Householder reflections make the 8 nonconstant columns of the
/// right side triangular: the 6 rows below are free of the first two angles, the 8 rows above give these back.
pub(super) struct Closure {
    /// The six remaining equations, each over its norm.
    pub(super) equations: [[f64; MONOMIALS]; EQUATIONS],
    /// The eight others, and their triangle.
    upper: [[f64; LINEAR]; MONOMIALS],
    triangle: [[f64; LINEAR]; LINEAR],
    /// Which joints slide, in the order of their parts.
    pub(super) prismatic: [bool; 6],
}

impl Closure {
    /// `arm` and `target` with lengths of order one.
    pub(super) fn new(arm: &NumericChain<6>, target: &Pose, choice: Choice) -> Self {
        let links = loop_links(arm, target, choice);
        let prismatic = choice.joints().map(|joint| arm.prismatic[joint]);
        // Columns: 27 monomials of the left side, then 8 of the right side; the right side's constant goes to the left.
        let mut columns = [[0.0; EXPRESSIONS]; MONOMIALS + LINEAR];
        for (k, x) in Axis::Z.moved(&links[4]).joined(prismatic[4]).iter().enumerate() {
            for (j, x) in x.moved(&links[3]).joined(prismatic[3]).iter().enumerate() {
                for (i, x) in x.moved(&links[2]).joined(prismatic[2]).iter().enumerate() {
                    columns[9 * i + 3 * j + k] = x.expressions();
                }
            }
        }
        let [drop, first, second] = [5, 0, 1].map(|i| inverse(&links[i]));
        for (i, x) in Axis::Z.moved(&drop).joined_backwards(prismatic[0]).iter().enumerate() {
            for (j, x) in x.moved(&first).joined_backwards(prismatic[1]).iter().enumerate() {
                let x = x.moved(&second).expressions();
                match 3 * i + j {
                    0 => {
                        for e in 0..EXPRESSIONS {
                            columns[0][e] -= x[e];
                        }
                    }
                    n => columns[MONOMIALS + n - 1] = x,
                }
            }
        }
        Self::triangularised(columns, prismatic)
    }

    fn triangularised(mut columns: [[f64; EXPRESSIONS]; MONOMIALS + LINEAR], prismatic: [bool; 6]) -> Self {
        for k in 0..LINEAR {
            // Householder reflection 1 - v v^T / h that clears column k below the diagonal.
            let mut v = [0.0; EXPRESSIONS];
            let mut norm = 0.0;
            for e in k..EXPRESSIONS {
                v[e] = columns[MONOMIALS + k][e];
                norm += v[e] * v[e];
            }
            let norm = sqrt(norm).copysign(v[k]);
            v[k] += norm;
            let h = norm * v[k];
            if !(h > 0.0) {
                continue;
            }
            let inverse = 1.0 / h;
            for (n, column) in columns.iter_mut().enumerate() {
                if n >= MONOMIALS && n < MONOMIALS + k {
                    continue;
                }
                // (Macros run unoptimised, where `for` costs more than the sums.)
                let (mut sum, mut e) = (0.0, k);
                while e < EXPRESSIONS {
                    sum += v[e] * column[e];
                    e += 1;
                }
                sum *= inverse;
                e = k;
                while e < EXPRESSIONS {
                    column[e] -= sum * v[e];
                    e += 1;
                }
            }
        }
        let mut out = Self {
            equations: [[0.0; MONOMIALS]; EQUATIONS],
            upper: [[0.0; LINEAR]; MONOMIALS],
            triangle: [[0.0; LINEAR]; LINEAR],
            prismatic,
        };
        for (r, equation) in out.equations.iter_mut().enumerate() {
            let mut norm = 0.0;
            for n in 0..MONOMIALS {
                equation[n] = columns[n][LINEAR + r];
                norm += equation[n] * equation[n];
            }
            if norm > 0.0 {
                let inverse = 1.0 / sqrt(norm);
                for x in equation {
                    *x *= inverse;
                }
            }
        }
        for n in 0..MONOMIALS {
            out.upper[n].copy_from_slice(&columns[n][..LINEAR]);
        }
        for k in 0..LINEAR {
            out.triangle[k].copy_from_slice(&columns[MONOMIALS + k][..LINEAR]);
        }
        out
    }

    /// The smallest over the largest diagonal entry of the triangle: 0 where the first two angles can't be eliminated one by one.
    pub(super) fn condition(&self) -> f64 {
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for k in 0..LINEAR {
            let x = self.triangle[k][k].abs();
            (least, most) = (least.min(x), most.max(x));
        }
        if most > 0.0 { least / most } else { 0.0 }
    }

    /// The values of the first two joints for given middle ones, as `[cos, sin]` or `[d, _]`. Meaningless where the triangle is singular.
    pub(super) fn linear_values(&self, middle: &[[f64; 2]; 3]) -> [[f64; 2]; 2] {
        let basis = [0, 1, 2].map(|i| monomials(middle[i], self.prismatic[2 + i]));
        let mut right = [0.0; LINEAR];
        for i in 0..3 {
            for j in 0..3 {
                let ij = basis[0][i] * basis[1][j];
                for k in 0..3 {
                    let monomial = ij * basis[2][k];
                    for (e, x) in right.iter_mut().enumerate() {
                        *x += monomial * self.upper[9 * i + 3 * j + k][e];
                    }
                }
            }
        }
        // Columns of the triangle are the monomials cos2, sin2, cos1, cos1 cos2, cos1 sin2, sin1, sin1 cos2, sin1 sin2.
        for k in (0..LINEAR).rev() {
            let pivot = self.triangle[k][k];
            right[k] = if pivot.abs() > 1e-13 { right[k] / pivot } else { 0.0 };
            for e in 0..k {
                right[e] -= right[k] * self.triangle[k][e];
            }
        }
        let value = |v: [f64; 2], prismatic: bool| if prismatic { v } else { unit(v) };
        [value([right[2], right[5]], self.prismatic[0]), value([right[0], right[1]], self.prismatic[1])]
    }
}

/// A vector over its length; `[1, 0]` for nothing.
pub(super) fn unit([x, y]: [f64; 2]) -> [f64; 2] {
    let norm = sqrt(x * x + y * y);
    if norm > 0.0 && norm < f64::INFINITY { [x / norm, y / norm] } else { [1.0, 0.0] }
}

/// The monomials of a joint's value: `(1, cos, sin)` of an angle, `(1, d, d^2)` of a slide, whose value is `[d, _]`.
pub(super) fn monomials([x, y]: [f64; 2], prismatic: bool) -> [f64; 3] {
    if prismatic { [1.0, x, x * x] } else { [1.0, x, y] }
}

/// The link transforms `D` of the loop in the order of the choice; the pose is part of the one after joint 6.
///
/// Against the order of the joints, the loop is `(X1 ... X6)^-1`, with negative angles.
pub(super) fn loop_links(arm: &NumericChain<6>, target: &Pose, choice: Choice) -> [Pose; 6] {
    let mut links = arm.links;
    links[5] = compose(&links[5], &inverse(target));
    choice.joints().map(|joint| if choice.reversed() { inverse(&links[(joint + 5) % 6]) } else { links[joint] })
}
