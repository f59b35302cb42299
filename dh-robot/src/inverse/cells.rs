//! Divides the circle of a free angle into cells at which later steps lose or change their roots: each cell is sampled once, and the cells
//! that one self-motion passes through are known without walking along it.

use super::path::{Path, SinCosEquation};
use crate::math::atan2;
use dh_kernels::{Angles, Blank, List, TrigPoly, solve_many};

/// Most angles at which the circle is cut.
pub(super) const CUTS: usize = 12;
/// Largest error of a coefficient's sinusoid at the angle that checks it.
const CHECKED: f64 = 1e-9;
/// Size of coefficients that vanish together.
const VANISHES: f64 = 1e-9;
/// Angles nearer than this are one.
const NEAR: f64 = 1e-6;

/// What happens at an angle of the free unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event {
    /// The two roots of a step meet and vanish.
    Fold,
    /// The two roots of a step meet at this angle only.
    Touch,
    /// A step's unknown is free at this angle.
    Crossing,
}

/// An angle of the free unknown at which something happens to a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) angle: f64,
    pub(super) event: Event,
    pub(super) step: usize,
    /// The path to that step.
    pub(super) path: Path,
}

impl Blank for Cut {
    const BLANK: Self = Cut { angle: 0.0, event: Event::Fold, step: 0, path: Path::START };
}

/// The cuts of a circle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cells {
    pub(super) cuts: List<Cut, CUTS>,
    /// The angles of the folds, rising.
    folds: List<f64, CUTS>,
    /// A coefficient is no sinusoid of the free unknown: the list of cuts is incomplete.
    pub(super) rough: bool,
}

/// Coefficients of 1, cos and sin.
type Sinusoid = [f64; 3];

impl Cells {
    /// The cuts that follow from the equations seen at some angles of the free unknown, of which three are needed and a fourth checks.
    pub(super) fn of(angles: &[f64], equations: &[&[SinCosEquation]]) -> Self {
        let mut cells = Cells { cuts: List::new(), folds: List::new(), rough: false };
        for (run, list) in equations.iter().enumerate() {
            for (i, e) in list.iter().enumerate() {
                let is = |x: &SinCosEquation| x.step == e.step && x.path == e.path;
                // Each equation once, at the first angle that it is seen at.
                if list[..i].iter().any(is) || equations[..run].iter().any(|l| l.iter().any(is)) {
                    continue;
                }
                let mut seen: List<[f64; 4], 8> = List::new();
                for (angle, list) in angles.iter().zip(equations) {
                    if let Some(x) = list.iter().find(|x| is(x)) {
                        let [a, b, c] = x.coefficients;
                        seen.push([*angle, a, b, c]);
                    }
                }
                match sinusoids(&seen) {
                    Some(sinusoids) => cells.cut(e, &sinusoids),
                    None => cells.rough = true,
                }
            }
        }
        let mut sorted: List<f64, CUTS> = List::new();
        let mut last = f64::NEG_INFINITY;
        loop {
            let next =
                |m: f64, c: &Cut| if c.event == Event::Fold && c.angle > last + NEAR { m.min(c.angle) } else { m };
            let angle = cells.cuts.iter().fold(f64::INFINITY, next);
            if !(angle < f64::INFINITY) || !sorted.push(angle) {
                break;
            }
            last = angle;
        }
        cells.folds = sorted;
        cells
    }

    /// Notes where something happens to an equation whose coefficients are sinusoids.
    fn cut(&mut self, e: &SinCosEquation, sinusoids: &[Sinusoid; 3]) {
        let note = |cuts: &mut List<Cut, CUTS>, root: [f64; 2], event: Event| {
            let angle = atan2(root[1], root[0]);
            cuts.push(Cut { angle, event, step: e.step, path: e.path });
        };
        let size = |sinusoid: &Sinusoid| sinusoid[1].abs() + sinusoid[2].abs();
        // All three vanish together?
        let crossing = solve_many(&sinusoids.map(|[k, c, s]| [c, s, -k]), VANISHES);
        for root in &crossing {
            let at = |w: &Sinusoid| (w[0] + w[1] * root[0] + w[2] * root[1]).abs();
            if sinusoids.iter().all(|w| at(w) <= VANISHES) {
                note(&mut self.cuts, *root, Event::Crossing);
            }
        }
        let [a, b, c] = sinusoids.each_ref().map(square);
        let discriminant = a.plus(&b, 1.0).plus(&c, -1.0);
        let moves = sinusoids.iter().any(|w| size(w) > VANISHES);
        if !moves || sinusoids[2] == [0.0; 3] {
            return;
        }
        let roots = discriminant.roots::<4>(VANISHES * VANISHES);
        for root in &roots {
            let ahead = |way: f64| {
                let turned = [root[0] - way * root[1], root[1] + way * root[0]];
                discriminant.value_and_slope(turned).0
            };
            let simple = discriminant.value_and_slope(*root).1.abs() > 1e-6 * discriminant.size();
            if simple || ahead(1e-4) * ahead(-1e-4) < 0.0 {
                note(&mut self.cuts, *root, Event::Fold);
            } else if !self.cuts.iter().any(|c| c.event == Event::Crossing && c.step == e.step && c.path == e.path) {
                note(&mut self.cuts, *root, Event::Touch);
            }
        }
    }

    /// How many cells there are.
    pub(super) fn len(&self) -> usize {
        self.folds.len().max(1)
    }

    /// The cell of an angle; `None` at a fold.
    pub(super) fn cell(&self, angle: f64) -> Option<usize> {
        if self.folds.iter().any(|f| (f - angle).abs() < NEAR || (f - angle).abs() > core::f64::consts::TAU - NEAR) {
            return None;
        }
        // The last cell goes round to the first fold.
        Some((self.folds.iter().filter(|f| **f < angle).count() + self.folds.len().max(1) - 1) % self.len())
    }

    /// The middle of a cell, which lies behind the fold of its number.
    pub(super) fn middle(&self, cell: usize) -> f64 {
        let Some(from) = self.folds.get(cell) else { return 0.0 };
        let to = match self.folds.get(cell + 1) {
            Some(to) => *to,
            None => self.folds.first().map_or(0.0, |f| f + core::f64::consts::TAU),
        };
        let middle = 0.5 * (from + to);
        if middle > core::f64::consts::PI { middle - core::f64::consts::TAU } else { middle }
    }

    /// Whether a cell lies before or behind an angle.
    pub(super) fn touches(&self, cell: usize, angle: f64) -> bool {
        let beside = |way: f64| {
            let x = angle + way;
            let turn = core::f64::consts::TAU;
            self.cell(if x > core::f64::consts::PI {
                x - turn
            } else if x <= -core::f64::consts::PI {
                x + turn
            } else {
                x
            })
        };
        beside(3.0 * NEAR) == Some(cell) || beside(-3.0 * NEAR) == Some(cell)
    }
}

/// The angles at which quantities that are sinusoids of the free unknown vanish together, from their values at four angles; quantities that are
/// no sinusoids do not count.
pub(super) fn common_zeros<const K: usize>(angles: [f64; 4], values: &[[f64; K]; 4]) -> Angles<2> {
    let mut rows = [[0.0; 3]; K];
    for (k, row) in rows.iter_mut().enumerate() {
        let seen = core::array::from_fn::<_, 4, _>(|i| [angles[i], values[i][k], 0.0, 0.0]);
        if let Some([[constant, cos, sin], ..]) = sinusoids(&seen) {
            *row = [cos, sin, -constant];
        }
    }
    solve_many(&rows, VANISHES)
}

/// The square of a sinusoid.
fn square([k, c, s]: &Sinusoid) -> TrigPoly<2> {
    TrigPoly {
        constant: k * k + 0.5 * (c * c + s * s),
        cos: [2.0 * k * c, 0.5 * (c * c - s * s)],
        sin: [2.0 * k * s, c * s],
    }
}

/// The sinusoids through coefficients at three angles, if a fourth one agrees.
fn sinusoids(seen: &[[f64; 4]]) -> Option<[Sinusoid; 3]> {
    let [p, q, r, check, ..] = seen else { return None };
    let at = |angle: f64| {
        let (s, c) = crate::math::sin_cos(angle);
        [c, s]
    };
    let ([pc, ps], [qc, qs], [rc, rs]) = (at(p[0]), at(q[0]), at(r[0]));
    let (c1, s1, c2, s2) = (qc - pc, qs - ps, rc - pc, rs - ps);
    let det = c1 * s2 - c2 * s1;
    if !(det.abs() > 1e-6) {
        return None;
    }
    let sinusoid = |k: usize| {
        let (d1, d2) = (q[k] - p[k], r[k] - p[k]);
        let (c, s) = ((d1 * s2 - d2 * s1) / det, (c1 * d2 - c2 * d1) / det);
        [p[k] - c * pc - s * ps, c, s]
    };
    let sinusoids = [sinusoid(1), sinusoid(2), sinusoid(3)];
    let [cc, cs] = at(check[0]);
    let agrees = |(w, x): (&Sinusoid, &f64)| (w[0] + w[1] * cc + w[2] * cs - x).abs() <= CHECKED;
    sinusoids.iter().zip(&check[1..]).all(agrees).then_some(sinusoids)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(angle: f64, path: Path, law: impl Fn(f64) -> [f64; 3]) -> SinCosEquation {
        SinCosEquation { step: 3, path, coefficients: law(angle) }
    }

    fn cells(law: impl Fn(f64) -> [f64; 3]) -> Cells {
        let angles = [0.0, 2.1, -2.1, 0.9];
        let lists = angles.map(|a| [seen(a, Path::START, &law)]);
        Cells::of(&angles, &lists.each_ref().map(|l| l.as_slice()))
    }

    #[test]
    fn a_law_of_cosines_is_feasible_on_arcs() {
        // Feasible where |0.5 + cos| <= 1: from 60 degrees round to -60 degrees.
        let c = cells(|t| [1.0, 0.0, 0.5 + t.cos()]);
        assert!(!c.rough && c.len() == 2);
        let third = core::f64::consts::FRAC_PI_3;
        assert!((c.cuts.iter().map(|x| x.angle.abs()).sum::<f64>() - 2.0 * third).abs() < 1e-12);
        assert_eq!(c.cell(3.0), c.cell(-3.0));
        assert_ne!(c.cell(0.0), c.cell(2.0));
        assert!((c.middle(c.cell(3.0).unwrap()).abs() - core::f64::consts::PI).abs() < 1e-9);
        assert!(c.middle(c.cell(0.1).unwrap()).abs() < 1e-9);
    }

    #[test]
    fn full_circles_touching_points_and_crossings_are_told_apart() {
        let full = cells(|t| [1.0, 0.0, 0.3 * t.sin()]);
        assert!(full.len() == 1 && full.cuts.is_empty() && !full.rough);
        let touch = cells(|t| [1.0, 0.0, 2.0 + t.cos()]);
        assert!(touch.cuts.iter().any(|c| c.event == Event::Touch), "{touch:?}");
        let crossing = cells(|t| [0.4 * (t.cos() - 0.6), 0.3 * (t.sin() - 0.8), 0.0]);
        assert!(crossing.cuts.iter().any(|c| c.event == Event::Crossing), "{crossing:?}");
        assert!(cells(|t| [1.0, 0.0, (2.0 * t).sin()]).rough);
    }
}
