//! The search for a plan: which equations next.
//!
//! Rule, in order: a combination that two or more equations fix (one solution); one equation without a constant term (two solutions,
//! never out of reach); a linear slide; one equation in sine and cosine; a quadratic; a second harmonic; then two equations in two
//! unknowns; at last the general elimination. Ties go to the shorter formula.

use super::axes::Axes;
use super::bound::bound;
use super::equation::{exact, weight};
use super::known::{Collected, Knowledge, Part};
use super::mobility::Mobility;
use super::pool::{Equation, Family, Scalar, families};
use super::sample::{Sample, joint_vectors};
use super::span::{Form, Span, numbers};
use super::step::{Plan, Refusal, Step, StepKind};
use crate::algebra::Poly;
use crate::chain::{Chain, Handle, Role};

/// Most equations of one unknown that are looked at.
const LOOK: usize = 14;
/// Equations with more terms than this, before any are put together, are left out: written out they take seconds, and nobody could read
/// them. (Joints that a task leaves open, behind twists of no simple angle; those of usual arms stay below 1500.)
const HEAVY: usize = 4000;

/// Finds a plan.
///
/// # Errors
/// Where the arm's equations never come down to one or two unknowns, and it is no six-axis arm with turning joints only.
pub fn search(chain: &Chain) -> Result<Plan, Refusal> {
    let axes = Axes::new(chain);
    let families = families(&axes);
    let mut s = Search { chain, knowledge: Knowledge::new(&axes), axes, families, steps: Vec::new() };
    if let Some(r) = chain.redundant {
        let form = s.unit(r);
        s.knowledge.learn(&s.axes, &form);
    }
    let given = s.knowledge.known.len();
    while !s.done() {
        // What a task leaves open is only solved for where nothing else helps.
        if s.one_unknown(false)
            || s.two_unknowns(false)
            || s.one_unknown(true)
            || s.two_unknowns(true)
            || s.general()
            || s.choose()
        {
            continue;
        }
        return Err(s.refusal());
    }
    let mobility = Mobility::new(chain, &s.axes);
    let max_solutions = bound(chain, &mobility, &s.knowledge, &s.steps, &s.samples(4, 0));
    let few = mobility.misses_its_task();
    Ok(Plan { axes: s.axes, knowledge: s.knowledge, given, steps: s.steps, max_solutions, few })
}

struct Search<'a> {
    chain: &'a Chain,
    axes: Axes,
    families: Vec<Family>,
    knowledge: Knowledge,
    steps: Vec<Step>,
}

/// A way to take the next step, with its rank (lower is better).
struct Option1 {
    rank: (usize, usize, usize),
    step: Step,
}

impl Search<'_> {
    fn unit(&self, k: usize) -> Form {
        let mut form = vec![0; self.axes.count()];
        form[k] = 1;
        form
    }

    fn done(&self) -> bool {
        (0..self.axes.real).all(|k| self.knowledge.has(&self.axes, k))
    }

    fn refusal(&self) -> Refusal {
        Refusal {
            solved: self.knowledge.known.iter().map(|k| k.name.clone()).collect(),
            open: (0..self.axes.real).filter(|k| !self.knowledge.has(&self.axes, *k)).collect(),
        }
    }

    /// Families grouped by what they still depend on, with `dimension` unknown combinations.
    fn open_groups(&self, dimension: usize) -> Vec<(Span, Vec<usize>)> {
        let mut groups: Vec<(Vec<i32>, Span, Vec<usize>)> = Vec::new();
        for (i, family) in self.families.iter().enumerate() {
            let rest = family.span.modulo(&self.knowledge.span);
            if rest.dimension() != dimension {
                continue;
            }
            let key = rest.key();
            match groups.iter_mut().find(|g| g.0 == key) {
                Some(g) => g.2.push(i),
                None => groups.push((key, rest, vec![i])),
            }
        }
        groups.into_iter().map(|g| (g.1, g.2)).collect()
    }

    /// The equations of some families that are not known identities, short ones first.
    fn equations(&self, families: &[usize]) -> Vec<Equation> {
        let mut list: Vec<(usize, Equation)> = Vec::new();
        let (prefix, suffix) = (self.knowledge.prefix(&self.axes), self.knowledge.suffix(&self.axes));
        for f in families {
            for e in &self.families[*f].equations {
                let joints = |a: usize, b: usize| {
                    self.axes.hops.get(a..b).unwrap_or(&[]).iter().filter(|h| h.joint.is_some()).count()
                };
                // Joints written out: those between a and b, and those outside that are not folded into the known pose.
                let outside = joints(prefix.min(e.a), e.a) + joints(e.b, suffix.max(e.b));
                let unfolded = joints(e.a, prefix) + joints(suffix, e.b);
                let size = match e.scalar {
                    Scalar::Rotation(..) => 0,
                    Scalar::Position(_) => 1,
                    Scalar::Back(_) => 2,
                    Scalar::Distance => 2,
                };
                list.push((4 * (joints(e.a, e.b) + 2 * outside) + 6 * unfolded + size, *e));
            }
        }
        list.sort_unstable();
        let light = |e: &Equation| weight(&self.axes, &self.knowledge, e) <= HEAVY;
        list.into_iter().map(|x| x.1).filter(light).take(LOOK).collect()
    }

    /// The candidates for an unknown: plain joint coordinates and the sums that the equations name.
    fn unknowns(&self, rest: &Span, families: &[usize]) -> Vec<Form> {
        let mut forms: Vec<Form> = Vec::new();
        let mut reach = self.knowledge.span.clone();
        for row in rest.rows() {
            reach.add(row);
        }
        for f in families {
            for row in self.families[*f].span.integer_basis().unwrap_or_default() {
                if !self.knowledge.span.contains(&numbers(&row))
                    && reach.contains(&numbers(&row))
                    && !forms.contains(&row)
                {
                    forms.push(row);
                }
            }
        }
        for k in 0..self.axes.count() {
            let unit = self.unit(k);
            if !self.knowledge.has(&self.axes, k) && reach.contains(&numbers(&unit)) && !forms.contains(&unit) {
                forms.push(unit);
            }
        }
        let pure = |f: &Form| {
            let kinds: Vec<bool> =
                f.iter().enumerate().filter(|(_, k)| **k != 0).map(|(i, _)| self.axes.turns(i)).collect();
            kinds.iter().all(|t| *t) || kinds.len() == 1
        };
        let small = |f: &Form| f.iter().all(|k| k.abs() <= 1);
        forms.retain(|f| pure(f) && small(f));
        forms
    }

    fn constants(&self, p: &Poly) -> bool {
        p.symbols().iter().all(|s| {
            self.chain.parameters.iter().any(|x| x.handle == Handle::Length(*s) && matches!(x.role, Role::Constant(_)))
        })
    }

    /// Does a combination hold a virtual coordinate?
    fn is_virtual(&self, form: &Form) -> bool {
        form[self.axes.real.min(form.len())..].iter().any(|k| *k != 0)
    }

    fn one_unknown(&mut self, virtual_too: bool) -> bool {
        let mut best: Option<Option1> = None;
        for (rest, families) in self.open_groups(1) {
            for form in self.unknowns(&rest, &families) {
                if !virtual_too && self.is_virtual(&form) {
                    continue;
                }
                for option in self.options(&form, &families) {
                    if best.as_ref().is_none_or(|b| option.rank < b.rank) {
                        best = Some(option);
                    }
                }
            }
        }
        self.take(best)
    }

    fn take(&mut self, best: Option<Option1>) -> bool {
        let Some(option) = best else { return false };
        for form in &option.step.unknown {
            self.knowledge.learn(&self.axes, form);
        }
        self.steps.push(option.step);
        true
    }

    /// The ways to find one combination.
    fn options(&mut self, form: &Form, families: &[usize]) -> Vec<Option1> {
        let mut rows: Vec<(Equation, Collected)> = Vec::new();
        for e in self.equations(families) {
            let p = exact(&self.axes, &mut self.knowledge, &e);
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
        let size = |c: &Collected| self.size(c);
        let mut options = Vec::new();
        if !turns {
            for row in &rows {
                let degree = row.1.keys().map(|k| if let Part::Power(n) = k[0] { n } else { 0 }).max().unwrap_or(0);
                let lead = row.1.get(&vec![Part::Power(degree)]);
                let firm = lead.is_some_and(|p| self.constants(p));
                match degree {
                    1 if firm => options.push(Option1 {
                        rank: (0, size(&row.1), first_joint),
                        step: step(StepKind::Linear, 1, vec![row]),
                    }),
                    1 => options.push(Option1 {
                        rank: (3, size(&row.1), first_joint),
                        step: step(StepKind::Linear, 1, vec![row]),
                    }),
                    2 => options.push(Option1 {
                        rank: (5, size(&row.1), first_joint),
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
            let total = chosen.iter().map(|r| size(&r.1)).sum();
            options.push(Option1 { rank: (1, total, first_joint), step: step(StepKind::AtanPair, 1, chosen) });
        }
        let has_constant = |r: &&(Equation, Collected)| r.1.contains_key(&vec![Part::One]);
        let ratios: Vec<&(Equation, Collected)> = first.iter().copied().filter(|r| !has_constant(r)).collect();
        let special = if ratios.len() > 1 { self.samples(0, 32) } else { Vec::new() };
        for row in &first {
            if has_constant(row) {
                options
                    .push(Option1 { rank: (4, size(&row.1), first_joint), step: step(StepKind::SinCos, 2, vec![row]) });
            } else {
                let second = self.second_half_turn(row, &ratios, &special);
                options.push(Option1 {
                    rank: (2, size(&row.1), first_joint),
                    step: step(StepKind::HalfTurn, 2, std::iter::once(*row).chain(second).collect()),
                });
            }
        }
        for row in rows.iter().filter(|r| degree(&r.1) == 2) {
            options.push(Option1 {
                rank: (6, size(&row.1), first_joint),
                step: step(StepKind::SecondHarmonic, 4, vec![row]),
            });
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
        others.into_iter().min_by_key(|r| self.size(&r.1))
    }

    /// Numbers at joint vectors: generic ones, then special ones.
    fn samples(&self, generic: usize, special: usize) -> Vec<Sample<'_>> {
        joint_vectors(&self.axes, generic, special)
            .into_iter()
            .map(|x| Sample::new(self.chain, &self.axes, &self.knowledge, x))
            .collect()
    }

    /// How long an equation is: its terms, and what was found before and is needed here (so that steps which depend on the target
    /// alone come first, and errors do not pile up).
    fn size(&self, c: &Collected) -> usize {
        let terms: usize = c.values().map(|p| p.terms().len()).sum();
        let mut symbols: Vec<_> = c.values().flat_map(Poly::symbols).collect();
        symbols.sort_unstable();
        symbols.dedup();
        let known =
            self.knowledge.known.iter().filter(|k| k.symbols.iter().any(|s| symbols.binary_search(s).is_ok())).count();
        let joints =
            |a: usize, b: usize| self.axes.hops.get(a..b).unwrap_or(&[]).iter().filter(|h| h.joint.is_some()).count();
        let folded = self
            .knowledge
            .poses
            .iter()
            .filter(|k| k.symbols().any(|s| symbols.binary_search(&s).is_ok()))
            .map(|k| joints(0, k.left) + joints(k.right, self.axes.hops.len()))
            .max()
            .unwrap_or(0);
        terms + 4 * (known + folded)
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

    fn two_unknowns(&mut self, virtual_too: bool) -> bool {
        let mut best: Option<Option1> = None;
        for (rest, families) in self.open_groups(2) {
            let mut forms = self.unknowns(&rest, &families);
            forms.retain(|f| virtual_too || !self.is_virtual(f));
            let equations = self.equations(&families);
            if equations.len() < 2 {
                continue;
            }
            let polys: Vec<(Equation, Poly)> =
                equations.into_iter().map(|e| (e, exact(&self.axes, &mut self.knowledge, &e))).collect();
            for i in 0..forms.len() {
                for j in 0..forms.len() {
                    let mut both = self.knowledge.span.clone();
                    if i == j || !both.add(&numbers(&forms[i])) || !both.add(&numbers(&forms[j])) {
                        continue;
                    }
                    let turns = |f: &Form| f.iter().position(|k| *k != 0).is_some_and(|i| self.axes.turns(i));
                    // The slide first; two angles in either order once.
                    if (turns(&forms[i]) && !turns(&forms[j])) || (turns(&forms[i]) == turns(&forms[j]) && i > j) {
                        continue;
                    }
                    let pair = [forms[i].clone(), forms[j].clone()];
                    if let Some(option) = self.pair_option(&pair, &polys)
                        && best.as_ref().is_none_or(|b| option.rank < b.rank)
                    {
                        best = Some(option);
                    }
                }
            }
        }
        self.take(best)
    }

    fn pair_option(&self, pair: &[Form; 2], polys: &[(Equation, Poly)]) -> Option<Option1> {
        let fits = |c: &Collected| {
            c.keys().all(|k| {
                matches!(k[0], Part::One | Part::Cos(1) | Part::Sin(1) | Part::Power(1 | 2))
                    && matches!(k[1], Part::One | Part::Cos(1) | Part::Sin(1))
            })
        };
        let rows: Vec<(Equation, Collected)> = polys
            .iter()
            .filter_map(|(e, p)| self.knowledge.collect(&self.axes, p, pair).filter(|c| fits(c)).map(|c| (*e, c)))
            .collect();
        let slide = pair[0].iter().position(|k| *k != 0).is_some_and(|i| !self.axes.turns(i));
        let sample = self.samples(2, 0);
        let size = |c: &Collected| self.size(c);
        let mut best: Option<(usize, usize, usize)> = None;
        for i in 0..rows.len() {
            for j in i + 1..rows.len() {
                let independent = sample.iter().all(|s| {
                    let (a, b) = (gradient(&rows[i].1, pair, s), gradient(&rows[j].1, pair, s));
                    (a[0] * b[1] - a[1] * b[0]).abs() > 1e-5
                });
                let total = size(&rows[i].1) + size(&rows[j].1);
                if independent && best.is_none_or(|b| total < b.0) {
                    best = Some((total, i, j));
                }
            }
        }
        let (total, i, j) = best?;
        let (kind, roots) = if slide {
            (StepKind::SlideAndTurn, 8)
        } else {
            (StepKind::Bilinear, self.bilinear_roots(&rows[i].1, &rows[j].1))
        };
        Some(Option1 {
            rank: (7 + roots, total, 0),
            step: Step {
                kind,
                unknown: pair.to_vec(),
                equations: vec![rows[i].0, rows[j].0],
                collected: vec![rows[i].1.clone(), rows[j].1.clone()],
                roots,
                before: self.knowledge.known.len(),
            },
        })
    }

    /// Bound of the solutions of a bilinear pair: 8; 4 where both coefficient pairs of one angle are turned into each other by a
    /// quarter turn (then its elimination is a square sum with a common factor, Pieper's quartic), or where one equation lacks an
    /// angle's products.
    fn bilinear_roots(&self, a: &Collected, b: &Collected) -> usize {
        let get = |c: &Collected, u: Part, v: Part| c.get(&vec![u, v]).cloned().unwrap_or_default();
        let parts = [Part::One, Part::Cos(1), Part::Sin(1)];
        for swap in [false, true] {
            let at = |c: &Collected, u: Part, v: Part| if swap { get(c, v, u) } else { get(c, u, v) };
            let row = |c: &Collected, u: Part| parts.map(|v| at(c, u, v));
            let (ca, sa, cb, sb) =
                (row(a, Part::Cos(1)), row(a, Part::Sin(1)), row(b, Part::Cos(1)), row(b, Part::Sin(1)));
            // cb = k sa, sb = -k ca: all cross products vanish.
            let proportional = (0..3).all(|i| (0..3).all(|j| &cb[i] * &ca[j] == -&(&sb[j] * &sa[i])));
            if proportional {
                return 4;
            }
            let plain = |c: &Collected| parts[1..].iter().all(|u| parts[1..].iter().all(|v| at(c, *u, *v).is_zero()));
            if plain(a) && plain(b) {
                return 4;
            }
        }
        8
    }

    /// The general elimination takes what is open at once: up to six coordinates, of which one may slide, or two that are neighbours in
    /// the loop. Fewer than six are filled up with joints that have to come out as zero.
    fn general(&mut self) -> bool {
        let open: Vec<usize> = (0..self.axes.count()).filter(|k| !self.knowledge.has(&self.axes, *k)).collect();
        let slides: Vec<usize> = (0..open.len()).filter(|i| !self.axes.turns(open[*i])).collect();
        let fits = match slides.as_slice() {
            [] | [_] => true,
            [i, j] => j - i == 1 || (*i == 0 && *j == 5),
            _ => false,
        };
        if open.is_empty() || open.len() > 6 || !fits || always_free(&self.axes, &self.knowledge).is_some() {
            return false;
        }
        let unknown: Vec<Form> = open.iter().map(|k| self.unit(*k)).collect();
        let before = self.knowledge.known.len();
        let step = Step { kind: StepKind::General, unknown, equations: vec![], collected: vec![], roots: 16, before };
        self.take(Some(Option1 { rank: (0, 0, 0), step }))
    }

    /// An arm that is singular everywhere: one coordinate of those that move the tool in the same way is chosen.
    fn choose(&mut self) -> bool {
        let Some(k) = always_free(&self.axes, &self.knowledge) else { return false };
        let form = self.unit(k);
        let before = self.knowledge.known.len();
        let step = Step {
            kind: StepKind::Choose,
            unknown: vec![form],
            equations: vec![],
            collected: vec![],
            roots: 1,
            before,
        };
        self.take(Some(Option1 { rank: (0, 0, 0), step }))
    }
}

/// Slope of an equation by its unknown at a sample.
fn slope(c: &Collected, form: &Form, s: &Sample<'_>) -> f64 {
    let padded: Collected = c.iter().map(|(k, p)| (vec![k[0], Part::One], p.clone())).collect();
    gradient(&padded, &[form.clone(), form.clone()], s)[0]
}

/// Slopes of an equation by the two unknowns at a sample.
fn gradient(c: &Collected, pair: &[Form; 2], s: &Sample<'_>) -> [f64; 2] {
    let angle = |f: &Form| f.iter().zip(&s.x).map(|(k, x)| f64::from(*k) * x).sum::<f64>();
    let (u, v) = (angle(&pair[0]), angle(&pair[1]));
    let part = |p: Part, x: f64| match p {
        Part::One => (1.0, 0.0),
        Part::Cos(n) => ((f64::from(n) * x).cos(), -f64::from(n) * (f64::from(n) * x).sin()),
        Part::Sin(n) => ((f64::from(n) * x).sin(), f64::from(n) * (f64::from(n) * x).cos()),
        Part::Power(n) => (x.powi(i32::from(n)), f64::from(n) * x.powi(i32::from(n) - 1)),
    };
    let mut g = [0.0; 2];
    for (key, p) in c {
        let k = s.evaluate(p);
        let (a, b) = (part(key[0], u), part(key[1], v));
        g[0] += k * a.1 * b.0;
        g[1] += k * a.0 * b.1;
    }
    g
}

/// A coordinate that can be chosen at will at every generic configuration, given what is known.
fn always_free(axes: &Axes, knowledge: &Knowledge) -> Option<usize> {
    let x = joint_vectors(axes, 1, 0).pop()?;
    let open: Vec<usize> = (0..axes.count()).filter(|k| !knowledge.has(axes, *k)).collect();
    let rates = super::pool::rates(axes, &x);
    let column = |k: usize| {
        let s = &rates[k];
        vec![s[2][1], s[0][2], s[1][0], s[0][3], s[1][3], s[2][3]]
    };
    // What a task leaves open (virtual coordinates) is open anyway: of dependent coordinates a real one is chosen.
    let mut rank = Span::default();
    let mut last = None;
    for k in open.iter().filter(|k| **k >= axes.real).chain(open.iter().filter(|k| **k < axes.real)) {
        if !rank.add(&column(*k)) {
            last = Some(*k);
        }
    }
    last.filter(|k| *k < axes.real)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    fn outline(convention: Convention, rows: &[(i64, &str, &str, i64)]) -> String {
        let chain = revolute_chain(convention, rows);
        match search(&chain) {
            Ok(plan) => plan
                .steps
                .iter()
                .map(|s| {
                    let names: Vec<String> =
                        s.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
                    format!("{:?} {} ({})", s.kind, names.join(", "), s.roots)
                })
                .collect::<Vec<_>>()
                .join("\n"),
            Err(r) => format!("stuck after {:?}, open {:?}", r.solved, r.open),
        }
    }

    #[test]
    fn plans_of_known_arms() {
        let puma = [
            (0, "0", "0", 0),
            (-90, "0", "0", 0),
            (0, "0.4318", "0.15005", 0),
            (-90, "0.0203", "0.4318", 0),
            (90, "0", "0", 0),
            (-90, "0", "0", 0),
        ];
        let ur5 = [
            (90, "0", "0.089159", 0),
            (0, "-0.425", "0", 0),
            (0, "-0.39225", "0", 0),
            (90, "0", "0.10915", 0),
            (-90, "0", "0.09465", 0),
            (0, "0", "0.0823", 0),
        ];
        let kuka = [
            (-90, "0.025", "0.4", 0),
            (0, "0.315", "0", -90),
            (-90, "0.035", "0", 0),
            (90, "0", "0.365", 0),
            (-90, "0", "0", 0),
            (0, "0", "0.08", 0),
        ];
        let text = [
            outline(Convention::Modified, &puma),
            outline(Convention::Standard, &ur5),
            outline(Convention::Standard, &kuka),
        ]
        .join("\n\n");
        insta::assert_snapshot!(text);
    }

    #[test]
    fn a_second_ratio_stands_by_where_the_first_one_vanishes() {
        // A tool that points straight down: its direction does not say how the first joint stands, its position does.
        let five_axes = [
            (-90, "0.016", "0.349", 0),
            (0, "0.221", "0", 0),
            (0, "0.221", "0", 0),
            (90, "0", "0", 90),
            (0, "0", "0.145", 0),
        ];
        let plan = search(&revolute_chain(Convention::Standard, &five_axes)).unwrap();
        assert_eq!((plan.steps[0].kind, plan.steps[0].equations.len()), (StepKind::HalfTurn, 2));
    }
}
