//! An upper bound on the number of isolated solutions of a plan.

use super::axes::{Axes, generic_parameter};
use super::known::{Basis, Collected, Knowledge};
use super::mobility::Mobility;
use super::sample::Sample;
use super::step::Step;
use super::steps::StepKind;
use crate::algebra::{Point, Poly, Symbol};
use crate::chain::{Chain, Handle};
use std::f64::consts::TAU;

/// Bound of the number of isolated solutions.
///
/// Where the arm moves the tool through as many dimensions as its joints' motions could at all, every solution that is regular at a
/// special pose goes on to the generic poses around it: there are no more of them than the steps have roots. Otherwise what the arm
/// reaches is thin, one sheet of it may cross another one at special poses, and an angle that two equations fix at generic poses is
/// fixed by one of them there: such a pair counts two, unless its determinant vanishes nowhere.
pub(super) fn bound(
    chain: &Chain,
    mobility: &Mobility,
    axes: &Axes,
    knowledge: &Knowledge,
    steps: &[Step],
    samples: &[Sample<'_>],
) -> usize {
    let firm =
        |s: &Step| always_independent(&s.collected, samples) || independent_all_round(&s.collected, chain, knowledge);
    let roots = |s: &Step| {
        let may_lose_an_equation = s.kind.is_overdetermined() && mobility.has_crossings() && !firm(s);
        if may_lose_an_equation { 2 } else { s.roots }
    };
    // An angle found from one equation may be free there, and what decides it then has as many roots again.
    let lone = |s: &Step| s.kind == StepKind::HalfTurn && s.equations.len() == 1;
    let again = if mobility.has_crossings() && steps.iter().any(lone) { 2 } else { 1 };
    steps.iter().map(roots).fold(again, usize::saturating_mul).clamp(1, most(axes, knowledge, steps))
}

/// Most isolated solutions that a loop of six joints has at all: 16 where none or one of them slides (Primrose 1986), 8 where two do, 2
/// where three do (Raghavan and Roth 1990). A loop of fewer joints is one of six where the others, which turn, happen to stand still.
fn most(axes: &Axes, knowledge: &Knowledge, steps: &[Step]) -> usize {
    let open = |k: &usize| steps.iter().any(|s| s.unknown.iter().any(|f| f[*k] != 0));
    let prismatic = (0..axes.count()).filter(|k| !axes.is_revolute(*k) && open(k)).count();
    let chosen = steps.iter().any(|s| s.kind == StepKind::Choose); // an arm that is singular everywhere
    match prismatic {
        2 if !chosen && knowledge.known.len() <= 6 => 8,
        3 if !chosen && knowledge.known.len() <= 6 => 2,
        _ => 16,
    }
}

/// What two equations say of the cosine and sine of an angle.
fn slopes<V: Default>(row: &Collected, value: impl Fn(&Poly) -> V) -> [V; 2] {
    [Basis::Cos(1), Basis::Sin(1)].map(|p| row.get(&vec![p]).map(&value).unwrap_or_default())
}

fn pairs<V>(rows: &[V]) -> impl Iterator<Item = (&V, &V)> {
    rows.iter().enumerate().flat_map(|(i, a)| rows[..i].iter().map(move |b| (a, b)))
}

/// Whether equations in the cosine and sine of one angle determine it at every pose. Measured: their determinants are analytic, so what is the same
/// at some random configurations is the same everywhere.
fn always_independent(rows: &[Collected], samples: &[Sample<'_>]) -> bool {
    let determinants: Vec<f64> = samples
        .iter()
        .map(|s| {
            let rows: Vec<[f64; 2]> = rows.iter().map(|r| slopes(r, |p| s.evaluate(p))).collect();
            pairs(&rows).map(|(a, b)| (a[0] * b[1] - a[1] * b[0]).powi(2)).sum()
        })
        .collect();
    determinants.iter().all(|d| *d > 1e-6 && (d - determinants[0]).abs() < 1e-9 * d)
}

/// The same where the determinant changes with one angle found before, and with nothing else: looked at all round.
fn independent_all_round(rows: &[Collected], chain: &Chain, knowledge: &Knowledge) -> bool {
    let rows: Vec<[Poly; 2]> = rows.iter().map(|r| slopes(r, Poly::clone)).collect();
    let symbols: Vec<Symbol> = rows.iter().flatten().flat_map(Poly::symbols).collect();
    let mut of = knowledge.known.iter().filter(|k| k.symbols.iter().any(|s| symbols.contains(s)));
    let (Some(angle), None) = (of.next(), of.next()) else { return false };
    let known =
        |s: &Symbol| angle.symbols.contains(s) || chain.parameters.iter().any(|p| p.handle == Handle::Length(*s));
    if !angle.is_angle || !symbols.iter().all(known) {
        return false;
    }
    let determinant = |x: f64| -> f64 {
        let [cos, sin] = angle.symbols;
        let symbol = |s: Symbol| match s {
            s if s == cos => x.cos(),
            s if s == sin => x.sin(),
            s => generic_parameter(chain, Handle::Length(s)),
        };
        let at = Point { symbol: &symbol, angle: &|v| generic_parameter(chain, Handle::Angle(v)) };
        let rows: Vec<[f64; 2]> = rows.iter().map(|r| [r[0].evaluate(&at), r[1].evaluate(&at)]).collect();
        pairs(&rows).map(|(a, b)| (a[0] * b[1] - a[1] * b[0]).powi(2)).sum()
    };
    let step = TAU / f64::from(LOOKS);
    let values: Vec<f64> = (0..LOOKS).map(|i| determinant(f64::from(i) * step)).collect();
    let most = values.iter().fold(0.0_f64, |m, x| m.max(*x));
    let (lowest, _) = (0..LOOKS).zip(&values).fold((0, f64::INFINITY), |m, (i, x)| if *x < m.1 { (i, *x) } else { m });
    let (mut low, mut high) = ((f64::from(lowest) - 1.0) * step, (f64::from(lowest) + 1.0) * step);
    for _ in 0..60 {
        let (a, b) = ((2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0);
        if determinant(a) < determinant(b) { high = b } else { low = a }
    }
    most > 0.0 && determinant(low) > 1e-8 * most
}

/// Angles at which a determinant is looked at.
const LOOKS: i32 = 180;
