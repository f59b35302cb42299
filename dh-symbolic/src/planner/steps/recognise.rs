//! The view that a kind of step gets from the search: the arm, what is known so far, and the equations in one or two unknowns.

use super::StepKind;
use crate::algebra::Poly;
use crate::chain::{Chain, Handle, Role};
use crate::planner::axes::Axes;
use crate::planner::known::{Basis, Collected, Knowledge};
use crate::planner::pool::rates;
use crate::planner::sample::{Sample, joint_vectors};
use crate::planner::scalar::{Equation, FrameScalar};
use crate::planner::step::Step;
use crate::planner::subspace::{JointCombination, Subspace};

/// What the search prefers, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::planner) enum Rank {
    /// A length by a linear equation whose leading coefficient is constant.
    FirmLength,
    /// An angle by its sine and cosine: one solution.
    AtanPair,
    /// An angle by their ratio: two solutions, never out of reach.
    HalfTurn,
    /// A length by a linear equation.
    Length,
    /// An angle by one equation in sine and cosine.
    SinCos,
    /// A length by a quadratic equation.
    Quadratic,
    /// An angle by a second harmonic.
    SecondHarmonic,
    /// Two unknowns at once, with this number of solutions.
    TwoUnknowns(usize),
}

/// A way to take the next step; the least one is best.
pub(in crate::planner) struct Offer {
    /// The kind's rank.
    pub(in crate::planner) rank: Rank,
    /// How long its equations are.
    pub(in crate::planner) size: usize,
    /// The first joint of its unknown.
    pub(in crate::planner) joint: usize,
    /// The step.
    pub(in crate::planner) step: Step,
}

impl Offer {
    /// Whether it is better than another one.
    pub(in crate::planner) fn is_better_than(&self, other: &Offer) -> bool {
        (self.rank, self.size, self.joint) < (other.rank, other.size, other.joint)
    }
}

/// The arm, and what is known of its pose by now.
#[derive(Clone, Copy)]
pub(in crate::planner) struct Scene<'a> {
    pub(in crate::planner) chain: &'a Chain,
    pub(in crate::planner) axes: &'a Axes,
    pub(in crate::planner) knowledge: &'a Knowledge,
}

impl<'a> Scene<'a> {
    /// One coordinate, as a combination of all.
    pub(in crate::planner) fn unit(&self, k: usize) -> JointCombination {
        let mut form = vec![0; self.axes.count()];
        form[k] = 1;
        form
    }

    /// Whether a formula consists of lengths that are known when the code is generated.
    pub(super) fn is_constant(&self, p: &Poly) -> bool {
        p.symbols().iter().all(|s| {
            self.chain.parameters.iter().any(|x| x.handle == Handle::Length(*s) && matches!(x.role, Role::Constant(_)))
        })
    }

    /// Numbers at joint vectors: generic ones, then special ones.
    pub(in crate::planner) fn samples(&self, generic: usize, special: usize) -> Vec<Sample<'a>> {
        joint_vectors(self.axes, generic, special)
            .into_iter()
            .map(|x| Sample::new(self.chain, self.axes, self.knowledge, x))
            .collect()
    }

    /// How long an equation is: its terms, and what was found before and is needed here (so that steps which depend on the target
    /// alone come first, and errors do not pile up).
    pub(in crate::planner) fn size(&self, row: &Row) -> usize {
        // An element of a known matrix is seen at once.
        let unusual =
            if matches!(row.equation.scalar, FrameScalar::Across(_) | FrameScalar::Bridge(..)) { 12 } else { 0 };
        let terms: usize = row.collected.values().map(|p| p.terms().len()).sum();
        let mut symbols: Vec<_> = row.collected.values().flat_map(Poly::symbols).collect();
        symbols.sort_unstable();
        symbols.dedup();
        let known =
            self.knowledge.known.iter().filter(|k| k.symbols.iter().any(|s| symbols.binary_search(s).is_ok())).count();
        let joints =
            |a: usize, b: usize| self.axes.links.get(a..b).unwrap_or(&[]).iter().filter(|h| h.joint.is_some()).count();
        let folded = self
            .knowledge
            .poses
            .iter()
            .filter(|k| k.symbols().any(|s| symbols.binary_search(&s).is_ok()))
            .map(|k| joints(0, k.left) + joints(k.right, self.axes.links.len()))
            .max()
            .unwrap_or(0);
        terms + 4 * (known + folded) + unusual
    }

    /// A coordinate that can be chosen at will at every generic configuration, given what is known.
    pub(super) fn always_free(&self) -> Option<usize> {
        let (axes, knowledge) = (self.axes, self.knowledge);
        let x = joint_vectors(axes, 1, 0).pop()?;
        let open: Vec<usize> = (0..axes.count()).filter(|k| !knowledge.has(axes, *k)).collect();
        let rates = rates(axes, &x);
        let column = |k: usize| {
            let s = &rates[k];
            vec![s[2][1], s[0][2], s[1][0], s[0][3], s[1][3], s[2][3]]
        };
        // Virtual coordinates are free by definition: of dependent coordinates a real one is chosen.
        let mut rank = Subspace::default();
        let mut last = None;
        for k in open.iter().filter(|k| **k >= axes.real).chain(open.iter().filter(|k| **k < axes.real)) {
            if !rank.add(&column(*k)) {
                last = Some(*k);
            }
        }
        last.filter(|k| *k < axes.real)
    }
}

/// An equation, written out by powers of the unknowns.
#[derive(Clone)]
pub(in crate::planner) struct Row {
    /// Which one.
    pub(in crate::planner) equation: Equation,
    /// Its terms.
    pub(in crate::planner) collected: Collected,
}

impl Row {
    /// The highest multiple of the first unknown's angle, or power of its length.
    pub(super) fn degree(&self) -> u8 {
        let degree = |k: &Vec<Basis>| match k.first() {
            Some(Basis::Power(n) | Basis::Cos(n) | Basis::Sin(n)) => *n,
            Some(Basis::One) | None => 0,
        };
        self.collected.keys().map(degree).max().unwrap_or(0)
    }

    /// Whether it has a term without the unknown.
    pub(super) fn has_constant(&self) -> bool {
        self.collected.contains_key(&vec![Basis::One])
    }

    /// The value of a coefficient at a sample.
    pub(super) fn at(&self, part: Basis, sample: &Sample<'_>) -> f64 {
        self.collected.get(&vec![part]).map_or(0.0, |p| sample.evaluate(p))
    }

    /// Slopes by each of the unknowns at a sample.
    pub(in crate::planner) fn gradient<const N: usize>(
        &self,
        unknown: [&JointCombination; N],
        s: &Sample<'_>,
    ) -> [f64; N] {
        let angles = unknown.map(|f| f.iter().zip(&s.x).map(|(k, x)| f64::from(*k) * x).sum::<f64>());
        let part = |p: Basis, x: f64| match p {
            Basis::One => (1.0, 0.0),
            Basis::Cos(n) => ((f64::from(n) * x).cos(), -f64::from(n) * (f64::from(n) * x).sin()),
            Basis::Sin(n) => ((f64::from(n) * x).sin(), f64::from(n) * (f64::from(n) * x).cos()),
            Basis::Power(n) => (x.powi(i32::from(n)), f64::from(n) * x.powi(i32::from(n) - 1)),
        };
        let mut slopes = [0.0; N];
        for (key, p) in &self.collected {
            let k = s.evaluate(p);
            let parts: [(f64, f64); N] = std::array::from_fn(|i| part(key[i], angles[i]));
            for (i, slope) in slopes.iter_mut().enumerate() {
                let factors = parts.iter().enumerate().map(|(j, (value, change))| if i == j { change } else { value });
                *slope += k * factors.product::<f64>();
            }
        }
        slopes
    }
}

/// Equations that hold one unknown.
pub(in crate::planner) struct SingleUnknown<'a> {
    pub(in crate::planner) scene: Scene<'a>,
    /// The unknown.
    pub(in crate::planner) form: &'a JointCombination,
    /// Whether it is an angle.
    pub(in crate::planner) is_angle: bool,
    /// The equations, none of which follows from what is known.
    pub(in crate::planner) rows: Vec<Row>,
}

impl SingleUnknown<'_> {
    /// The equations a cos u + b sin u + c = 0.
    pub(super) fn first_harmonics(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|r| self.is_angle && r.degree() == 1)
    }

    /// The offer to solve some of the equations.
    pub(super) fn offer(&self, rank: Rank, kind: StepKind, roots: usize, rows: &[&Row]) -> Offer {
        let step = Step {
            kind,
            unknown: vec![self.form.clone()],
            equations: rows.iter().map(|r| r.equation).collect(),
            collected: rows.iter().map(|r| r.collected.clone()).collect(),
            roots,
            before: self.scene.knowledge.known.len(),
        };
        let size = rows.iter().map(|r| self.scene.size(r)).sum();
        Offer { rank, size, joint: self.form.iter().position(|k| *k != 0).unwrap_or(0), step }
    }
}

/// The two shortest independent equations that hold two unknowns.
pub(in crate::planner) struct TwoUnknowns<'a> {
    pub(in crate::planner) scene: Scene<'a>,
    /// The unknowns.
    pub(in crate::planner) pair: &'a [JointCombination; 2],
    /// Whether the first one is a length.
    pub(in crate::planner) prismatic: bool,
    /// The equations.
    pub(in crate::planner) rows: [&'a Row; 2],
}

impl TwoUnknowns<'_> {
    /// The offer to solve them.
    pub(super) fn offer(&self, kind: StepKind, roots: usize) -> Offer {
        let step = Step {
            kind,
            unknown: self.pair.to_vec(),
            equations: self.rows.map(|r| r.equation).to_vec(),
            collected: self.rows.map(|r| r.collected.clone()).to_vec(),
            roots,
            before: self.scene.knowledge.known.len(),
        };
        let size = self.rows.iter().map(|r| self.scene.size(r)).sum();
        Offer { rank: Rank::TwoUnknowns(roots), size, joint: 0, step }
    }
}
