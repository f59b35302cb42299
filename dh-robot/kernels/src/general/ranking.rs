//! Ranks the choices of joints for an arm: by conditioning, then by trial.

use super::super::chain::NumericChain;
use super::super::elementary::sin_cos;
use super::super::{Blank, Kinematics, List};
use super::arm::General6R;
use super::attempt::Account;
use super::budget::Budget;
use super::choice::Choice;
use super::closure::Closure;
use super::dialytic::Dialytic;
use super::pairs;

/// A choice with its merits.
#[derive(Clone, Copy, Debug)]
pub struct Ranked {
    /// The choice.
    pub choice: Choice,
    /// Its worst condition as a power of two: about the number of binary digits that are lost.
    pub condition: i32,
    /// Samples on which it missed the known solution.
    pub misses: usize,
    /// Samples on which it found roots that it could not account for.
    pub unclean: usize,
    /// Work, in factorisations.
    pub work: usize,
}

impl Blank for Ranked {
    const BLANK: Self = Self { choice: Choice::BLANK, condition: 0, misses: 0, unclean: 0, work: 0 };
}

/// Choices worth a trial, and those worth a full one.
const TRIED: usize = 12;
const FINALISTS: usize = 5;
/// Samples of the first trial.
const FIRST_TRIALS: usize = 2;
/// Work of an elimination that only confirms another one.
const CONFIRMATION: usize = 60;
/// Samples for the first selection.
const FIRST_SAMPLES: usize = 3;
/// The condition of a choice that can't be made.
const NONE: i32 = -1023;
/// A choice that loses more binary digits than this at a generic pose is singular.
const USELESS: i32 = -36;

/// The best `K` choices for an arm, best first; fewer, or none, if fewer are of use. To be run once per arm, when its code is generated.
///
/// `samples` are arms with joint vectors; five random ones are enough. Where the arm itself varies (a locked joint, symbols
/// without values), so should it from sample to sample. The first is the choice that misses nothing, accounts for most roots
/// and takes least work; one that uses the arm's structure goes before all others. The following ones hide other joints where possible,
/// because they then fail at other poses.
pub fn rank<const K: usize>(samples: &[(NumericChain<6>, [f64; 6])]) -> List<Ranked, K> {
    let mut best = List::<Ranked, K>::new();
    let Some(rest) = samples.get(1..).filter(|_| K > 0) else { return best };
    let mut structured = structured(samples);
    for ranked in structured.as_mut_slice() {
        ranked.try_on(samples);
    }
    structured.as_mut_slice().sort_unstable_by_key(Ranked::key);
    if let Some(first) = structured.iter().find(|r| r.misses == 0) {
        best.push(*first);
    }
    let mut all = by_condition(samples.get(..FIRST_SAMPLES).unwrap_or(samples));
    let tried = all.get_mut(..TRIED).unwrap_or_default();
    if !best.is_empty() {
        // The others are for the few poses that the first one doesn't settle: one trial each, until there are enough.
        for ranked in tried {
            if best.len() < K && !best.iter().any(|b| b.choice.hidden_joint() == ranked.choice.hidden_joint()) {
                ranked.try_on(samples.get(..1).unwrap_or_default());
                if ranked.misses == 0 {
                    best.push(*ranked);
                }
            }
        }
        return best;
    }
    let later = samples.get(FIRST_TRIALS..).unwrap_or_default();
    let first = if later.is_empty() { samples } else { samples.get(..FIRST_TRIALS).unwrap_or(rest) };
    for ranked in &mut *tried {
        ranked.try_on(first);
    }
    tried.sort_unstable_by_key(Ranked::key);
    let finalists = tried.get_mut(..FINALISTS).unwrap_or_default();
    for ranked in &mut *finalists {
        ranked.try_on(later);
    }
    finalists.sort_unstable_by_key(Ranked::key);
    for fresh in [true, false] {
        for r in tried.iter().filter(|r| r.misses == 0) {
            let taken = |b: &Ranked| {
                if fresh { b.choice.hidden_joint() == r.choice.hidden_joint() } else { b.choice == r.choice }
            };
            if !best.iter().any(taken) {
                best.push(*r);
            }
        }
    }
    best
}

impl Ranked {
    /// Runs the elimination on samples whose solutions are known in part.
    fn try_on(&mut self, samples: &[(NumericChain<6>, [f64; 6])]) {
        if self.condition <= USELESS {
            self.misses += samples.len();
            return;
        }
        for (arm, q) in samples {
            let arm = General6R::with_prismatic(&arm.links, &arm.prismatic, [self.choice; 3]);
            let mut solutions = List::new();
            let q = arm.scaled(q);
            let attempt =
                arm.attempt(&arm.scaled_arm().forward(&q), self.choice, &mut { Budget::THOROUGH }, &mut solutions);
            let hit = solutions
                .iter()
                .any(|p: &[f64; 6]| p.iter().zip(&q).all(|(a, b)| sin_cos(0.5 * (a - b)).0.abs() < 1e-5));
            self.misses += usize::from(!hit);
            self.unclean += usize::from(attempt.account == Account::Open);
            // Spurious null vectors can mask roots: a second elimination must confirm.
            self.work += attempt.work + if attempt.account == Account::WithPhantoms { CONFIRMATION } else { 0 };
        }
    }

    /// What the order is by: a root that isn't accounted for costs another elimination, and in the end several.
    fn key(&self) -> (usize, usize, u8) {
        (self.misses, self.work + 200 * self.unclean, self.choice.number())
    }
}

/// The choices whose structure all samples have.
fn structured(samples: &[(NumericChain<6>, [f64; 6])]) -> List<Ranked, 4> {
    let mut fitting = List::new();
    for choice in (Choice::GENERAL..Choice::COUNT).map(Choice::new) {
        let fits = |(arm, _): &(NumericChain<6>, [f64; 6])| {
            let arm = General6R::with_prismatic(&arm.links, &arm.prismatic, [choice; 3]);
            pairs::fits(arm.scaled_arm(), choice)
        };
        if samples.iter().all(fits) {
            fitting.push(Ranked { choice, ..Ranked::BLANK });
        }
    }
    fitting
}

/// All choices without structure, the best conditioned ones first.
fn by_condition(samples: &[(NumericChain<6>, [f64; 6])]) -> [Ranked; Choice::GENERAL as usize] {
    let mut all = [Ranked::BLANK; Choice::GENERAL as usize];
    for (number, ranked) in all.iter_mut().enumerate() {
        ranked.choice = Choice::new(number as u8);
    }
    let mut hopeless = USELESS;
    for (arm, q) in samples {
        let arm = General6R::with_prismatic(&arm.links, &arm.prismatic, [Choice::BLANK; 3]);
        // Six choices share the equations.
        for ranked in all.chunks_exact_mut(6) {
            condition(arm.scaled_arm(), &arm.scaled(q), ranked, hopeless);
        }
        // Of the later samples, only those are looked at that may still be among the first.
        let mut conditions = all.map(|r| r.condition);
        conditions.sort_unstable_by_key(|c| -c);
        hopeless = conditions.get(2 * TRIED).map_or(USELESS, |c| USELESS.max(*c));
    }
    all.sort_unstable_by_key(|r| (-r.condition, r.choice.number()));
    all
}

/// The best `K` choices for an arm by their condition at two poses that have nothing special; fewer if fewer are of use.
///
/// A ranking without the trials of [`rank`], for run time, on an arm that the ranked choices don't fit.
pub(super) fn best_conditioned<const K: usize>(arm: &NumericChain<6>) -> List<Choice, K> {
    let samples = [[0.7, -1.1, 0.9, -0.4, 1.3, -2.1], [-2.0, 0.5, -0.6, 1.7, -0.9, 0.3]].map(|q| (*arm, q));
    let mut best = List::new();
    for ranked in structured(&samples).iter().chain(&by_condition(&samples)) {
        if ranked.condition > USELESS && best.len() < K {
            best.push(ranked.choice);
        }
    }
    best
}

/// The binary exponent of a positive number.
fn exponent(x: f64) -> i32 {
    if x > 0.0 { ((x.to_bits() >> 52) as i32 & 0x7ff) - 1023 } else { NONE }
}

/// How well choices that share their equations work at a pose: the least relevant pivot over the largest, at the solution and elsewhere.
/// Conditions only get worse; hopeless ones are left alone.
fn condition(arm: &NumericChain<6>, q: &[f64; 6], group: &mut [Ranked], hopeless: i32) {
    let Some(first) = group.first().filter(|_| group.iter().any(|r| r.condition > hopeless)) else { return };
    let closure = Closure::new(arm, &arm.forward(q), first.choice);
    let [one, two, ..] = first.choice.joints();
    // Two slides make some of the linear monomials vanish, but not those that are read off.
    let shared = if arm.prismatic[one] && arm.prismatic[two] { 1.0 } else { closure.condition() };
    for ranked in group {
        let choice = ranked.choice;
        if !choice.allows(&arm.prismatic) {
            ranked.condition = NONE;
        }
        ranked.condition = ranked.condition.min(exponent(shared));
        if ranked.condition <= hopeless {
            continue;
        }
        let dialytic = Dialytic::new(&closure, choice);
        let at = if choice.reversed() { -q[choice.hidden_joint()] } else { q[choice.hidden_joint()] };
        // At the solution exactly one pivot vanishes, elsewhere none.
        for (angle, vanishing) in [(at, 1), (at + 0.8, 0), (at + 3.3, 0)] {
            let (s, c) = sin_cos(angle);
            let pivot = dialytic.pivots([c, s])[11 - vanishing];
            ranked.condition = ranked.condition.min(exponent(pivot));
        }
    }
}
