//! The operations of the fast path beside sums and products: the batched kernels of `dh-robot`, for all branches that their arguments have.

use dh_robot::runtime::batched as kernels;

use crate::tape::{Instruction, Operand, run};

/// One operation beside plain arithmetic, for all branches that its arguments have.
pub(super) enum Operation {
    Arithmetic(Vec<Instruction>),
    Constant {
        to: Operand,
        number: f64,
    },
    Negate {
        to: Operand,
        of: Operand,
    },
    /// a cos u + b sin u = c: both roots, which are real, margin.
    SinCos {
        equation: [Operand; 3],
        roots: [Operand; 4],
        valid: Operand,
        margin: Operand,
    },
    /// a cos u + b sin u = 0: one root, margin.
    HalfTurn {
        equations: Vec<[Operand; 2]>,
        root: [Operand; 2],
        margin: Operand,
    },
    /// Two equations a cos u + b sin u = c: the root, margin.
    Pair {
        equations: [Operand; 6],
        root: [Operand; 2],
        margin: Operand,
    },
    /// Cosine and sine that are known but for rounding.
    Unit {
        of: [Operand; 2],
        root: [Operand; 2],
    },
    /// a d + b = 0: the root, margin.
    Linear {
        equation: [Operand; 2],
        root: Operand,
        margin: Operand,
    },
    /// The angle of cosine and sine.
    Angle {
        to: Operand,
        pair: [Operand; 2],
    },
    /// The angle half a turn further.
    Opposite {
        to: Operand,
        of: Operand,
    },
    /// A length in table units.
    Length {
        to: Operand,
        of: Operand,
        scale: f64,
    },
    /// The roots of a step spread over the branches: the second root comes after `before` branches.
    Spread {
        to: Operand,
        roots: [Operand; 2],
        before: usize,
    },
    /// Adds how far a value is from an entry of the target.
    Miss {
        to: Operand,
        of: Operand,
        entry: Operand,
        first: bool,
    },
    /// The lesser of two margins, the product of two validities, the sum of two misses.
    Lesser {
        to: Operand,
        of: [Operand; 2],
    },
    Product {
        to: Operand,
        of: [Operand; 2],
    },
    Sum {
        to: Operand,
        of: [Operand; 2],
    },
}

/// Rows of an operand.
pub(super) fn rows(o: Operand) -> usize {
    o.mask as usize + 1
}

/// Fills the rows of a result, number by number.
fn each<const L: usize>(x: &mut [[f64; L]], to: Operand, f: impl Fn(&[[f64; L]], usize, usize) -> f64) {
    for branch in 0..rows(to) {
        let lanes = std::array::from_fn(|l| f(x, branch, l));
        x[to.row(branch)] = lanes;
    }
}

impl Operation {
    /// Runs it for all its branches.
    pub(super) fn run<const L: usize>(&self, x: &mut [[f64; L]]) {
        match self {
            Operation::Arithmetic(list) => run(list, x),
            Operation::Constant { to, number } => x[to.row(0)] = [*number; L],
            Operation::Negate { to, of } => each(x, *to, |x, b, l| -x[of.row(b)][l]),
            Operation::SinCos { equation: [a, b, c], roots, valid, margin } => {
                for r in 0..rows(*margin) {
                    let [a, b, c] = [a, b, c].map(|o| x[o.row(r)]);
                    let mut out = [[0.0; L]; 6];
                    for l in 0..L {
                        let (pairs, real, clear) = kernels::sincos(a[l], b[l], c[l]);
                        for (k, value) in pairs.into_iter().chain([real, clear]).enumerate() {
                            out[k][l] = value;
                        }
                    }
                    for (to, lanes) in roots.iter().chain([valid, margin]).zip(out) {
                        x[to.row(r)] = lanes;
                    }
                }
            }
            Operation::HalfTurn { equations, root, margin } => {
                for r in 0..rows(*margin) {
                    let equation = |k: usize| equations.get(k).map(|e| e.map(|o| x[o.row(r)]));
                    let [first, second] = [equation(0), equation(1)];
                    let mut out = [[0.0; L]; 3];
                    for l in 0..L {
                        let at = |e: Option<[[f64; L]; 2]>| e.map_or([0.0; 2], |[a, b]| [a[l], b[l]]);
                        let ([c, s], clear) = match second {
                            Some(_) => kernels::half_turn([at(first), at(second)]),
                            None => kernels::half_turn([at(first)]),
                        };
                        (out[0][l], out[1][l], out[2][l]) = (c, s, clear);
                    }
                    for (to, lanes) in root.iter().chain([margin]).zip(out) {
                        x[to.row(r)] = lanes;
                    }
                }
            }
            Operation::Pair { equations, root, margin } => {
                for r in 0..rows(*margin) {
                    let e = equations.map(|o| x[o.row(r)]);
                    let mut out = [[0.0; L]; 3];
                    for l in 0..L {
                        let ([c, s], clear) = kernels::pair(e[0][l], e[1][l], e[2][l], e[3][l], e[4][l], e[5][l]);
                        (out[0][l], out[1][l], out[2][l]) = (c, s, clear);
                    }
                    for (to, lanes) in root.iter().chain([margin]).zip(out) {
                        x[to.row(r)] = lanes;
                    }
                }
            }
            Operation::Unit { of, root } => {
                for r in 0..rows(root[0]) {
                    let [a, b] = of.map(|o| x[o.row(r)]);
                    let mut out = [[0.0; L]; 2];
                    for l in 0..L {
                        let [c, s] = kernels::unit(a[l], b[l]);
                        (out[0][l], out[1][l]) = (c, s);
                    }
                    (x[root[0].row(r)], x[root[1].row(r)]) = (out[0], out[1]);
                }
            }
            Operation::Linear { equation: [a, b], root, margin } => {
                for r in 0..rows(*margin) {
                    let [a, b] = [a, b].map(|o| x[o.row(r)]);
                    for l in 0..L {
                        (x[root.row(r)][l], x[margin.row(r)][l]) = kernels::linear(a[l], b[l]);
                    }
                }
            }
            Operation::Angle { to, pair: [c, s] } => {
                for r in 0..rows(*to) {
                    let lanes = kernels::angles(&x[s.row(r)], &x[c.row(r)]);
                    x[to.row(r)] = lanes;
                }
            }
            Operation::Opposite { to, of } => each(x, *to, |x, b, l| kernels::opposite(x[of.row(b)][l])),
            Operation::Length { to, of, scale } => each(x, *to, |x, b, l| x[of.row(b)][l] * scale),
            Operation::Spread { to, roots, before } => {
                for branch in 0..rows(*to) {
                    x[to.row(branch)] = x[roots[branch / before % 2].row(branch)];
                }
            }
            Operation::Miss { to, of, entry, first } => {
                let before = |x: &[[f64; L]], b: usize, l: usize| if *first { 0.0 } else { x[to.row(b)][l] };
                each(x, *to, |x, b, l| before(x, b, l) + (x[of.row(b)][l] - x[entry.row(0)][l]).abs());
            }
            Operation::Lesser { to, of: [p, q] } => {
                each(x, *to, |x, b, l| kernels::lesser(x[p.row(b)][l], x[q.row(b)][l]));
            }
            Operation::Product { to, of: [p, q] } => each(x, *to, |x, b, l| x[p.row(b)][l] * x[q.row(b)][l]),
            Operation::Sum { to, of: [p, q] } => each(x, *to, |x, b, l| x[p.row(b)][l] + x[q.row(b)][l]),
        }
    }
}
