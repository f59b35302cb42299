//! Which joint plays which part in the elimination, and the search for the best cast.

use super::super::math::sin_cos;
use super::super::pose::Chain;
use super::super::{Blank, Kinematics, List};
use super::closure::Closure;
use super::dialytic::Dialytic;
use super::solve::{Account, General6R};

/// How the loop of six joints is cut. There are [`Choice::COUNT`]; structured arms make many of them useless.
///
/// Going round the loop in one direction or the other, from one of the joints on: the first two joints are eliminated linearly, of the
/// next three one is hidden (the determinant is a polynomial in it), one doubles the equations and one is single; the last one
/// doesn't occur.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Choice(u8);

impl Choice {
    /// The number of choices.
    pub const COUNT: u8 = 84;

    /// How many of them eliminate with the dialytic matrix; the others need two parallel neighbours and two neighbours that meet.
    const GENERAL: u8 = 72;

    /// The choice with this number, counted modulo [`Choice::COUNT`]. Numbers are stable: generated code holds them.
    pub const fn new(number: u8) -> Self {
        Self(number % Self::COUNT)
    }

    /// Does it need the structure of `pairs.rs`?
    pub(super) const fn is_pairs(self) -> bool {
        self.0 >= Self::GENERAL
    }

    /// Its number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Does the loop run against the order of the joints?
    pub(super) const fn reversed(self) -> bool {
        self.0 % Self::GENERAL >= if self.is_pairs() { 6 } else { 36 }
    }

    /// The joints (counted from 0) in the order of their parts: two linear ones, three others, and the one that drops out.
    pub const fn joints(self) -> [usize; 6] {
        let first = (if self.is_pairs() { self.0 % 6 } else { self.0 % 36 / 6 }) as usize;
        let mut joints = [0; 6];
        let mut i = 0;
        while i < 6 {
            joints[i] = if self.reversed() { (first + 6 - i) % 6 } else { (first + i) % 6 };
            i += 1;
        }
        joints
    }

    /// Of the three middle joints (0, 1, 2): the hidden one, the one that doubles, the single one.
    pub(super) const fn middle(self) -> [usize; 3] {
        match self.0 % 6 {
            0 => [0, 1, 2],
            1 => [0, 2, 1],
            2 => [1, 0, 2],
            3 => [1, 2, 0],
            4 => [2, 0, 1],
            _ => [2, 1, 0],
        }
    }

    /// Is the determinant of degree 8 for every arm, or may it be of degree 12, with roots that belong to no solution?
    ///
    /// The extraneous factor of Raghavan and Roth's determinant is known only for the angle next to the linear ones.
    pub(super) const fn has_least_degree(self) -> bool {
        self.middle()[0] == 0
    }

    /// Is the choice possible if these joints slide? The hidden one, the one that doubles and the one that drops out must turn.
    pub(super) fn allows(self, slides: &[bool; 6]) -> bool {
        let (joints, [hidden, double, _]) = (self.joints(), self.middle());
        ![joints[2 + hidden], joints[2 + double], joints[5]].iter().any(|j| slides[*j])
    }

    /// The joint (counted from 0) whose angle is found first.
    pub const fn hidden_joint(self) -> usize {
        self.joints()[if self.is_pairs() { 5 } else { 2 + self.middle()[0] }]
    }
}

/// A choice with its merits.
#[derive(Clone, Copy, Debug)]
pub struct Ranked {
    /// The choice.
    pub choice: Choice,
    /// Its worst condition, as a power of two: about so many binary digits are lost.
    pub condition: i32,
    /// Samples on which it missed the known solution.
    pub misses: usize,
    /// Samples on which it found roots that it could not account for.
    pub unclean: usize,
    /// Mean work, in factorisations.
    pub work: usize,
}

impl Blank for Ranked {
    const BLANK: Self = Self { choice: Choice(0), condition: 0, misses: 0, unclean: 0, work: 0 };
}

impl Blank for Choice {
    const BLANK: Self = Self(0);
}

/// Choices worth a full trial.
const TRIED: usize = 12;
/// Work of an elimination that only confirms another one.
const CONFIRMATION: usize = 60;
/// Samples for the first selection.
const FIRST_SAMPLES: usize = 3;
/// A choice that loses more binary digits than this at a generic pose is singular.
const USELESS: i32 = -36;

/// The best `K` choices for an arm, best first; fewer, or none, if fewer are of use. To be run once per arm, when its code is generated.
///
/// `samples` are arms with joint vectors; some ten random ones are enough. Where the arm itself varies (a locked joint, symbols
/// without values), so should it from sample to sample. The first is the choice that misses nothing, accounts for most roots
/// and takes least work; the following ones hide other joints where possible, because they then fail at other poses.
pub fn rank<const K: usize>(samples: &[(Chain<6>, [f64; 6])]) -> List<Ranked, K> {
    let mut all = [Ranked::BLANK; Choice::COUNT as usize];
    for (number, ranked) in all.iter_mut().enumerate() {
        ranked.choice = Choice::new(number as u8);
        for (arm, q) in samples.iter().take(FIRST_SAMPLES) {
            let arm = General6R::with_slides(&arm.links, &arm.slides, [ranked.choice; 3]);
            ranked.condition =
                ranked.condition.min(exponent(condition(arm.scaled_arm(), &arm.scaled(q), ranked.choice)));
        }
    }
    all.sort_unstable_by_key(|r| (-r.condition, r.choice.number()));
    let tried = all.get_mut(..TRIED).unwrap_or_default();
    for ranked in &mut *tried {
        if ranked.condition <= USELESS {
            ranked.misses = samples.len();
            continue;
        }
        for (arm, q) in samples {
            let arm = General6R::with_slides(&arm.links, &arm.slides, [ranked.choice; 3]);
            let mut solutions = List::new();
            let q = arm.scaled(q);
            let attempt = arm.attempt(&arm.scaled_arm().forward(&q), ranked.choice, &mut solutions);
            let hit = solutions
                .iter()
                .any(|p: &[f64; 6]| p.iter().zip(&q).all(|(a, b)| sin_cos(0.5 * (a - b)).0.abs() < 1e-5));
            ranked.misses += usize::from(!hit);
            ranked.unclean += usize::from(attempt.account == Account::Open);
            // Another elimination must confirm what phantoms may hide.
            ranked.work += attempt.work + if attempt.account == Account::WithPhantoms { CONFIRMATION } else { 0 };
        }
        ranked.work /= samples.len().max(1);
    }
    // A root that isn't accounted for costs another elimination, and in the end several.
    let cost = |r: &Ranked| r.work + 200 * r.unclean / samples.len().max(1);
    tried.sort_unstable_by_key(|r| (r.misses, cost(r), r.choice.number()));
    let mut best = List::<Ranked, K>::new();
    for fresh in [true, false] {
        for r in tried.iter().filter(|r| r.misses == 0 && !samples.is_empty()) {
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

/// The best `K` choices for an arm by their condition at two poses that have nothing special; fewer if fewer are of use.
///
/// What is left of [`rank`] where there is no time for trials: at run time, on an arm that the ranked choices don't fit.
pub(super) fn best_conditioned<const K: usize>(arm: &Chain<6>) -> List<Choice, K> {
    let mut all = [(0, Choice(0)); Choice::COUNT as usize];
    for (number, (worst, choice)) in all.iter_mut().enumerate() {
        *choice = Choice::new(number as u8);
        for q in [[0.7, -1.1, 0.9, -0.4, 1.3, -2.1], [-2.0, 0.5, -0.6, 1.7, -0.9, 0.3]] {
            *worst = exponent(condition(arm, &q, *choice)).min(*worst);
        }
    }
    all.sort_unstable_by_key(|(condition, choice)| (-condition, choice.number()));
    let mut best = List::new();
    for (condition, choice) in all {
        if condition > USELESS && best.len() < K {
            best.push(choice);
        }
    }
    best
}

/// The binary exponent of a positive number.
fn exponent(x: f64) -> i32 {
    if x > 0.0 { ((x.to_bits() >> 52) as i32 & 0x7ff) - 1023 } else { -1023 }
}

/// How well a choice works at a pose: the least relevant pivot over the largest, at the solution and elsewhere.
fn condition(arm: &Chain<6>, q: &[f64; 6], choice: Choice) -> f64 {
    if choice.is_pairs() {
        return if super::pairs::fits(arm, choice) { 1.0 } else { 0.0 };
    }
    if !choice.allows(&arm.slides) {
        return 0.0;
    }
    let closure = Closure::new(arm, &arm.forward(q), choice);
    let dialytic = Dialytic::new(&closure, choice);
    let angle = |t: f64| {
        let (s, c) = sin_cos(t);
        [c, s]
    };
    let at = if choice.reversed() { -q[choice.hidden_joint()] } else { q[choice.hidden_joint()] };
    // At the solution exactly one pivot vanishes, elsewhere none.
    let mut worst = dialytic.pivots(angle(at))[10];
    for k in 0..2 {
        worst = worst.min(dialytic.pivots(angle(at + 0.8 + 2.5 * f64::from(k)))[11]);
    }
    // Two slides make some of the linear monomials vanish, but not those that are read off.
    let [first, second, ..] = choice.joints();
    if arm.slides[first] && arm.slides[second] { worst } else { worst.min(closure.condition()) }
}
