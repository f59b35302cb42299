//! Steps with one unknown: the ways to find one combination of joints, ranked.

use super::super::known::{Collected, Part};
use super::super::sample::Sample;
use super::super::scalar::Equation;
use super::super::span::Form;
use super::super::step::{Step, StepKind};
use super::two::gradient;
use super::{Ranked, Search};

impl Search<'_> {
    pub(super) fn one_unknown(&mut self, virtual_too: bool) -> bool {
        let mut best: Option<Ranked> = None;
        for (rest, families) in self.open_groups(1) {
            let mut forms = self.unknowns(&rest, &families);
            // Real coordinates were tried before.
            forms.retain(|f| virtual_too == self.is_virtual(f));
            let equations = if forms.is_empty() { Vec::new() } else { self.equations(&families) };
            for form in forms {
                for option in self.options(&form, &equations) {
                    if best.as_ref().is_none_or(|b| option.rank < b.rank) {
                        best = Some(option);
                    }
                }
            }
        }
        self.take(best)
    }

    /// The ways to find one combination.
    fn options(&mut self, form: &Form, equations: &[Equation]) -> Vec<Ranked> {
        let mut rows: Vec<(Equation, Collected)> = Vec::new();
        for &e in equations {
            let p = self.write(&e);
            if let Some(c) = self.knowledge.collect(&self.axes, &p, std::slice::from_ref(form))
                && c.keys().any(|k| k[0] != Part::One)
                && !rows.iter().any(|r| r.1 == c)
            {
                rows.push((e, c));
            }
        }
        // An equation that follows from what is known already has no slope where it holds.
        let samples = self.samples(2, 0);
        rows.retain(|r| samples.iter().all(|s| slope(&r.1, form, s).abs() > 1e-6));
        drop(samples);
        let before = self.knowledge.known.len();
        let step = |kind, roots, chosen: Vec<&(Equation, Collected)>| Step {
            kind,
            unknown: vec![form.clone()],
            equations: chosen.iter().map(|r| r.0).collect(),
            collected: chosen.iter().map(|r| r.1.clone()).collect(),
            roots,
            before,
        };
        let first_joint = form.iter().position(|k| *k != 0).unwrap_or(0);
        let turns = self.axes.turns(first_joint);
        let size = |row: &(Equation, Collected)| self.size(row);
        let mut options = Vec::new();
        if !turns {
            for row in &rows {
                let degree = row.1.keys().map(|k| if let Part::Power(n) = k[0] { n } else { 0 }).max().unwrap_or(0);
                let lead = row.1.get(&vec![Part::Power(degree)]);
                let firm = lead.is_some_and(|p| self.constants(p));
                match degree {
                    1 if firm => options
                        .push(Ranked { rank: (0, size(row), first_joint), step: step(StepKind::Linear, 1, vec![row]) }),
                    1 => options
                        .push(Ranked { rank: (3, size(row), first_joint), step: step(StepKind::Linear, 1, vec![row]) }),
                    2 => options.push(Ranked {
                        rank: (5, size(row), first_joint),
                        step: step(StepKind::Quadratic, 2, vec![row]),
                    }),
                    _ => {}
                }
            }
            return options;
        }
        let degree = |c: &Collected| {
            c.keys().map(|k| if let Part::Cos(n) | Part::Sin(n) = k[0] { n } else { 0 }).max().unwrap_or(0)
        };
        let first: Vec<&(Equation, Collected)> = rows.iter().filter(|r| degree(&r.1) == 1).collect();
        if let Some(chosen) = self.independent(&first) {
            let total = chosen.iter().map(|r| size(r)).sum();
            options.push(Ranked { rank: (1, total, first_joint), step: step(StepKind::AtanPair, 1, chosen) });
        }
        let has_constant = |r: &&(Equation, Collected)| r.1.contains_key(&vec![Part::One]);
        let ratios: Vec<&(Equation, Collected)> = first.iter().copied().filter(|r| !has_constant(r)).collect();
        let special = if ratios.len() > 1 { self.samples(0, 32) } else { Vec::new() };
        for row in &first {
            if has_constant(row) {
                options.push(Ranked { rank: (4, size(row), first_joint), step: step(StepKind::SinCos, 2, vec![row]) });
            } else {
                let second = self.second_half_turn(row, &ratios, &special);
                options.push(Ranked {
                    rank: (2, size(row), first_joint),
                    step: step(StepKind::HalfTurn, 2, std::iter::once(*row).chain(second).collect()),
                });
            }
        }
        for row in rows.iter().filter(|r| degree(&r.1) == 2) {
            options
                .push(Ranked { rank: (6, size(row), first_joint), step: step(StepKind::SecondHarmonic, 4, vec![row]) });
        }
        options
    }

    /// The shortest other equation without a constant term that still fixes the angle where this one vanishes, at some special pose.
    fn second_half_turn<'r>(
        &self,
        row: &(Equation, Collected),
        rows: &[&'r (Equation, Collected)],
        special: &[Sample<'_>],
    ) -> Option<&'r (Equation, Collected)> {
        let value = |row: &Collected, part, s: &Sample<'_>| row.get(&vec![part]).map_or(0.0, |p| s.evaluate(p));
        let slope = |row: &Collected, s: &Sample<'_>| value(row, Part::Cos(1), s).hypot(value(row, Part::Sin(1), s));
        let empty: Vec<&Sample<'_>> = special.iter().filter(|s| slope(&row.1, s) < 1e-9).collect();
        let mut others = rows.to_vec();
        others.retain(|r| r.1 != row.1 && empty.iter().any(|s| slope(&r.1, s) > 1e-3));
        others.into_iter().min_by_key(|r| self.size(r))
    }

    /// Rows in cos u and sin u that together fix u at every generic pose, and at as many special poses as the rows allow.
    fn independent<'r>(&self, rows: &[&'r (Equation, Collected)]) -> Option<Vec<&'r (Equation, Collected)>> {
        if rows.len() < 2 {
            return None;
        }
        let samples = self.samples(2, 8);
        let value = |row: &Collected, part: Part, s: &Sample<'_>| row.get(&vec![part]).map_or(0.0, |p| s.evaluate(p));
        let slopes: Vec<Vec<[f64; 2]>> = rows
            .iter()
            .map(|r| samples.iter().map(|s| [value(&r.1, Part::Cos(1), s), value(&r.1, Part::Sin(1), s)]).collect())
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
                    [i, j].iter().map(|i| rows[*i].1.values().map(|p| p.terms().len()).sum::<usize>()).sum();
                let score = 100.0 * fine - terms as f64;
                if best.is_none_or(|b| score > b.0) {
                    best = Some((score, [i, j]));
                }
            }
        }
        let mut set = best?.1.to_vec();
        for k in 2..samples.len() {
            if set.len() < 4 && quality(&set, k) <= 1e-6 {
                let better = (0..rows.len()).filter(|i| !set.contains(i)).find(|i| {
                    let mut with = set.clone();
                    with.push(*i);
                    quality(&with, k) > 1e-6
                });
                set.extend(better);
            }
        }
        Some(set.into_iter().map(|i| rows[i]).collect())
    }
}

/// Slope of an equation by its unknown at a sample.
fn slope(c: &Collected, form: &Form, s: &Sample<'_>) -> f64 {
    let padded: Collected = c.iter().map(|(k, p)| (vec![k[0], Part::One], p.clone())).collect();
    gradient(&padded, &[form.clone(), form.clone()], s)[0]
}
