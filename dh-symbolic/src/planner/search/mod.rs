//! The search for a plan: chooses which equations to solve next.
//!
//! Every kind of step (`planner/steps`) offers its ways to find one unknown combination of joints; the best offer is taken, in the order of
//! [`Rank`](super::steps::Rank), ties going to the shorter formula. Where there is none, two equations in two unknowns; at last the
//! fallbacks of the kinds.

mod dedup;
mod single_unknown;
mod two_unknowns;

use std::collections::BTreeMap;
use std::rc::Rc;

use super::axes::Axes;
use super::bound::bound;
use super::equation::{exact, weight};
use super::known::Knowledge;
use super::mobility::Mobility;
use super::pool::{Family, families};
use super::refusal::{self, Refusal};
use super::scalar::{Equation, FrameScalar, fold};
use super::step::{Plan, Step};
use super::steps::{Offer, Scene, StepKind};
use super::subspace::{JointCombination, Subspace, numbers};
use crate::algebra::Poly;
use crate::chain::{Chain, Task};
use dedup::{Probes, Values, is_same};

/// Most equations of one kind with the same unknowns that are considered.
const LOOK: usize = 14;
/// Equations with more terms than this, before any are put together, are left out: written out they take seconds, and nobody could read
/// them. (Joints that a task leaves open, behind twists of no simple angle; those of usual arms stay below 1500.)
const HEAVY: usize = 4000;

/// Finds a plan.
///
/// # Errors
/// Where the task does not suit the arm, or the arm's equations never come down to one or two unknowns and the general elimination does not
/// take what is left.
pub fn search(chain: &Chain) -> Result<Plan, Refusal> {
    refusal::check(chain)?;
    let axes = Axes::new(chain);
    refusal::check_given(chain, &axes)?;
    let families = families(&axes);
    let (knowledge, probes) = (Knowledge::new(&axes), Probes::new(&axes));
    let mut s = Search {
        chain,
        axes,
        families,
        knowledge,
        steps: Vec::new(),
        written: BTreeMap::new(),
        probes,
        groups: (usize::MAX, Vec::new()),
    };
    for (r, _) in chain.chosen() {
        let form = s.unit(r);
        s.knowledge.learn(&s.axes, &form);
    }
    let given = s.knowledge.known.len();
    while !s.done() {
        // What a task leaves open is only solved for where nothing else helps.
        if s.one_unknown(false) || s.two_unknowns(false) || s.one_unknown(true) || s.two_unknowns(true) || s.fall_back()
        {
            continue;
        }
        return Err(s.refusal());
    }
    let mobility = Mobility::new(chain, &s.axes);
    let max_solutions = bound(chain, &mobility, &s.axes, &s.knowledge, &s.steps, &s.scene().samples(4, 0));
    let rank_deficient = mobility.misses_its_task();
    let has_crossings = chain.settings.task == Task::Pose && mobility.has_crossings();
    Ok(Plan {
        axes: s.axes,
        knowledge: s.knowledge,
        given,
        steps: s.steps,
        max_solutions,
        rank_deficient,
        has_crossings,
    })
}

struct Search<'a> {
    chain: &'a Chain,
    axes: Axes,
    families: Vec<Family>,
    knowledge: Knowledge,
    steps: Vec<Step>,
    /// Equations written out, by the frames between which the target is known: step after step asks for the same ones.
    written: BTreeMap<(usize, usize, Equation), Rc<Poly>>,
    /// The probes at which equations are compared.
    probes: Probes,
    /// Cached groups of families with one or two unknowns, keyed by the number of known combinations.
    groups: (usize, Vec<Group>),
}

/// The unknown combinations that families still depend on, and the families.
type Group = (Subspace, Vec<usize>);

/// The better one of two offers; of equally good ones the first.
fn best(known: Option<Offer>, offer: Offer) -> Option<Offer> {
    match known {
        Some(known) if !offer.is_better_than(&known) => Some(known),
        _ => Some(offer),
    }
}

impl Search<'_> {
    fn scene(&self) -> Scene<'_> {
        Scene { chain: self.chain, axes: &self.axes, knowledge: &self.knowledge }
    }

    fn unit(&self, k: usize) -> JointCombination {
        self.scene().unit(k)
    }

    fn done(&self) -> bool {
        (0..self.axes.real).all(|k| self.knowledge.has(&self.axes, k))
    }

    fn refusal(&self) -> Refusal {
        Refusal::Stuck {
            solved: self.knowledge.known.iter().map(|k| k.name.clone()).collect(),
            open: (0..self.axes.real).filter(|k| !self.knowledge.has(&self.axes, *k)).collect(),
        }
    }

    /// Families grouped by what they still depend on, with `dimension` unknown combinations (one or two).
    fn open_groups(&mut self, dimension: usize) -> Vec<Group> {
        if self.groups.0 != self.knowledge.known.len() {
            let mut groups: Vec<(Vec<i32>, Group)> = Vec::new();
            for (i, family) in self.families.iter().enumerate() {
                let rest = family.span.modulo(&self.knowledge.span);
                if !(1..=2).contains(&rest.dimension()) {
                    continue;
                }
                let key = rest.key();
                match groups.iter_mut().find(|g| g.0 == key) {
                    Some((_, group)) => group.1.push(i),
                    None => groups.push((key, (rest, vec![i]))),
                }
            }
            self.groups = (self.knowledge.known.len(), groups.into_iter().map(|g| g.1).collect());
        }
        self.groups.1.iter().filter(|g| g.0.dimension() == dimension).cloned().collect()
    }

    /// The equations of some families that are not known identities, short ones first, each once.
    fn equations(&mut self, families: &[usize]) -> Vec<Equation> {
        let mut list: Vec<(usize, Equation)> = Vec::new();
        let (prefix, suffix) = (self.knowledge.prefix(&self.axes), self.knowledge.suffix(&self.axes));
        for f in families {
            for e in &self.families[*f].equations {
                let joints = |a: usize, b: usize| {
                    self.axes.links.get(a..b).unwrap_or(&[]).iter().filter(|h| h.joint.is_some()).count()
                };
                // Joints written out: those between a and b, and those outside that are not folded into the known pose.
                let outside = joints(prefix.min(e.a), e.a) + joints(e.b, suffix.max(e.b));
                let unfolded = joints(e.a, prefix) + joints(suffix, e.b);
                let size = match e.scalar {
                    FrameScalar::Rotation(..) => 0,
                    FrameScalar::Position(_) => 1,
                    FrameScalar::Back(_) => 2,
                    FrameScalar::Distance => 2,
                    FrameScalar::Across(_) | FrameScalar::Bridge(..) => 3,
                };
                list.push((4 * (joints(e.a, e.b) + 2 * outside) + 6 * unfolded + size, *e));
            }
        }
        list.sort_unstable();
        let (axes, knowledge) = (&self.axes, &mut self.knowledge);
        // Those without lengths are few, and there are many of one and the same direction cosine: each kind has its own limit.
        let mut taken = [0; 2];
        let mut fits = |e: &Equation| {
            let taken = &mut taken[usize::from(matches!(e.scalar, FrameScalar::Across(_) | FrameScalar::Bridge(..)))];
            let fits = *taken < LOOK && weight(axes, knowledge, e) <= HEAVY;
            *taken += usize::from(fits);
            fits
        };
        let fitting: Vec<Equation> = list.into_iter().map(|x| x.1).filter(|e| fits(e)).collect();
        let mut kept: Vec<(Equation, (usize, usize), Option<Values>)> = Vec::new();
        for e in fitting {
            let (folded, values) = (fold(&self.axes, &self.knowledge, &e), self.probes.values(&e));
            let known = |k: &(Equation, (usize, usize), Option<Values>)| {
                k.1 == folded && k.2.as_ref().zip(values.as_ref()).is_some_and(|(a, b)| is_same(a, b))
            };
            if !kept.iter().any(known) {
                kept.push((e, folded, values));
            }
        }
        kept.into_iter().map(|k| k.0).collect()
    }

    /// An equation written out.
    fn write(&mut self, e: &Equation) -> Rc<Poly> {
        let (left, right) = fold(&self.axes, &self.knowledge, e);
        let (axes, knowledge) = (&self.axes, &mut self.knowledge);
        Rc::clone(self.written.entry((left, right, *e)).or_insert_with(|| Rc::new(exact(axes, knowledge, e))))
    }

    /// The candidates for an unknown: plain joint coordinates and the sums that the equations name.
    fn unknowns(&self, rest: &Subspace, families: &[usize]) -> Vec<JointCombination> {
        let mut forms: Vec<JointCombination> = Vec::new();
        let mut spanned = self.knowledge.span.clone();
        for row in rest.rows() {
            spanned.add(row);
        }
        for f in families {
            for row in self.families[*f].span.integer_basis().unwrap_or_default() {
                if !self.knowledge.span.contains(&numbers(&row))
                    && spanned.contains(&numbers(&row))
                    && !forms.contains(&row)
                {
                    forms.push(row);
                }
            }
        }
        for k in 0..self.axes.count() {
            let unit = self.unit(k);
            if !self.knowledge.has(&self.axes, k) && spanned.contains(&numbers(&unit)) && !forms.contains(&unit) {
                forms.push(unit);
            }
        }
        let pure = |f: &JointCombination| {
            let kinds: Vec<bool> =
                f.iter().enumerate().filter(|(_, k)| **k != 0).map(|(i, _)| self.axes.is_revolute(i)).collect();
            kinds.iter().all(|t| *t) || kinds.len() == 1
        };
        let small = |f: &JointCombination| f.iter().all(|k| k.abs() <= 1);
        forms.retain(|f| pure(f) && small(f));
        forms
    }

    /// Whether a combination contains a virtual coordinate.
    fn is_virtual(&self, form: &JointCombination) -> bool {
        form[self.axes.real.min(form.len())..].iter().any(|k| *k != 0)
    }

    fn take(&mut self, best: Option<Offer>) -> bool {
        best.map(|offer| self.push(offer.step)).is_some()
    }

    fn fall_back(&mut self) -> bool {
        let step = StepKind::ALL.iter().find_map(|kind| kind.fallback(&self.scene()));
        step.map(|step| self.push(step)).is_some()
    }

    fn push(&mut self, step: Step) {
        for form in &step.unknown {
            self.knowledge.learn(&self.axes, form);
        }
        self.steps.push(step);
    }
}

#[cfg(test)]
mod tests;
