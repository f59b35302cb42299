//! An angle from two or more equations a cos u + b sin u + c = 0: sine and cosine both, one value.

use super::kernel::{Argument, BatchedKernel, BatchedRoots, Call, Coefficient, Kernel, KernelRoots, Representative};
use super::kernel::{minus, plus, row};
use super::recognise::{Offer, Rank, Row, SingleUnknown};
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;
use crate::planner::step::Step;
use dh_kernels::{solve_many, solve_pair};

/// Two equations.
static PAIR: Kernel = Kernel {
    rust: "solve_pair",
    javascript: Some("solvePair"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: false,
    unknowns: 1,
    run: |x, _, _, tolerance| {
        let &[a, b, c, d, e, f] = x else { return KernelRoots::none() };
        KernelRoots::of(&solve_pair(a, b, c, d, e, f, tolerance), |u| vec![u])
    },
};

/// Three or four, by least squares.
static MANY: Kernel = Kernel {
    rust: "solve_many",
    javascript: Some("solveMany"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: false,
    unknowns: 1,
    run: |x, _, _, tolerance| match *x {
        [a, b, c, d, e, f, g, h, i] => {
            KernelRoots::of(&solve_many(&[[a, b, c], [d, e, f], [g, h, i]], tolerance), |u| vec![u])
        }
        [a, b, c, d, e, f, g, h, i, j, k, l] => {
            KernelRoots::of(&solve_many(&[[a, b, c], [d, e, f], [g, h, i], [j, k, l]], tolerance), |u| vec![u])
        }
        _ => KernelRoots::none(),
    },
};

pub(super) struct AtanPair;

impl Kind for AtanPair {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let rows: Vec<&Row> = at.first_harmonics().collect();
        let chosen = independent(at, &rows);
        chosen.map(|rows| at.offer(Rank::AtanPair, StepKind::AtanPair, 1, &rows)).into_iter().collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        vec![vec![Basis::Cos(1)], vec![Basis::Sin(1)], vec![Basis::One]]
    }

    fn call(&self, equations: usize, _: bool) -> Call<Coefficient> {
        if equations == 2 {
            return Call { kernel: &PAIR, arguments: pair() };
        }
        let rows = (0..equations).map(|r| Argument::Array(vec![plus(r, 0), plus(r, 1), minus(r, 2)]));
        Call { kernel: &MANY, arguments: vec![Argument::Reference(rows.collect())] }
    }

    fn batched(&self, _: usize, _: bool, constant: &dyn Fn(usize, usize) -> Option<i8>) -> Option<BatchedKernel> {
        // The first two equations fix the angle at every regular pose. With coefficients 1, 0 and -1 each is the cosine or the sine.
        let single = |r: usize, k: i8| if k > 0 { minus(r, 2) } else { plus(r, 2) };
        let at = |r: usize, k: usize| constant(r, k);
        let unit = match [at(0, 0), at(0, 1), at(1, 0), at(1, 1)] {
            [Some(a), Some(0), Some(0), Some(b)] if a * b != 0 => Some(vec![single(0, a), single(1, b)]),
            [Some(0), Some(a), Some(b), Some(0)] if a * b != 0 => Some(vec![single(1, b), single(0, a)]),
            _ => None,
        };
        let has_margin = unit.is_none();
        let (name, arguments) = unit.map_or(("pair", pair()), |arguments| ("unit", arguments));
        let roots = BatchedRoots::One;
        Some(BatchedKernel { name, single_precision: None, arguments, roots, has_margin, equations: 2 })
    }

    fn measures_length(&self, _: &Step) -> bool {
        // Where the squares of cosine and sine do not add up to 1, by how much is a pure number.
        false
    }

    fn is_overdetermined(&self) -> bool {
        true
    }

    fn words(&self, _: bool) -> Words {
        let equation = "two equations a cos + b sin = c, one value";
        Words::new("sine and cosine", "同时得到正弦和余弦", equation).because(
            "Why: both equations are linear in the cosine and the sine of the unknown. Cramer's rule gives both, and atan2 the angle; a common positive factor of its arguments does not matter.",
            "理由：两式对未知角的余弦和正弦都是线性的，由克拉默法则求出二者，再由 atan2 得角；两个自变量的公共正因子可略去。",
        )
    }
}

/// Two equations, one after the other.
fn pair() -> Vec<Argument<Coefficient>> {
    (0..2).flat_map(|r| row(r, 0..2).into_iter().chain([minus(r, 2)])).collect()
}

/// Rows in cos u and sin u that together fix u at every generic pose, and at as many special poses as the rows allow.
fn independent<'r>(at: &SingleUnknown<'_>, rows: &[&'r Row]) -> Option<Vec<&'r Row>> {
    if rows.len() < 2 {
        return None;
    }
    let samples = at.scene.samples(2, 8);
    let slopes: Vec<Vec<[f64; 2]>> = rows
        .iter()
        .map(|r| samples.iter().map(|s| [r.at(Basis::Cos(1), s), r.at(Basis::Sin(1), s)]).collect())
        .collect();
    // How well a set of rows fixes the angle at sample k: the determinant of its normal matrix.
    let quality = |set: &[usize], k: usize| {
        let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
        for i in set {
            let [x, y] = slopes[*i][k];
            a += x * x;
            b += x * y;
            c += y * y;
        }
        a * c - b * b
    };
    let mut best: Option<(f64, [usize; 2])> = None;
    for i in 0..rows.len() {
        for j in i + 1..rows.len() {
            let generic = quality(&[i, j], 0).min(quality(&[i, j], 1));
            if generic < 1e-7 {
                continue;
            }
            // Good at the special samples first, then short.
            let fine = (2..samples.len()).filter(|k| quality(&[i, j], *k) > 1e-6).count() as f64;
            let terms: usize =
                [i, j].iter().map(|i| rows[*i].collected.values().map(|p| p.terms().len()).sum::<usize>()).sum();
            let score = 100.0 * fine - terms as f64;
            if best.is_none_or(|b| score > b.0) {
                best = Some((score, [i, j]));
            }
        }
    }
    let mut set = best?.1.to_vec();
    for k in 2..samples.len() {
        if set.len() == 4 || quality(&set, k) > 1e-6 {
            continue;
        }
        // One more row, or two where both of the set vanish.
        let fixes = |more: &[usize]| quality(&[&set[..], more].concat(), k) > 1e-6;
        let others: Vec<usize> = (0..rows.len()).filter(|i| !set.contains(i)).collect();
        let one = others.iter().find(|i| fixes(&[**i])).map(|i| vec![*i]);
        let two = || {
            others
                .iter()
                .enumerate()
                .find_map(|(n, i)| others[..n].iter().find(|j| fixes(&[**j, *i])).map(|j| vec![*j, *i]))
        };
        let more = if set.len() == 2 { one.or_else(two) } else { one };
        set.extend(more.unwrap_or_default());
    }
    Some(set.into_iter().map(|i| rows[i]).collect())
}
