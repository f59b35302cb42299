//! The interface between generated code and the solvers: samples for free unknowns, the roots behind a candidate, the outcome of a run.

use super::path::{Path, SinCosEquation};
use crate::{FreeJoints, Why};
use dh_kernels::{Budget, List, Outcome, Status};

/// The values that unknowns take where their equations leave them free, for one run of the plan, and the size below which coefficients count
/// as zero.
///
/// The first sample is zero for every step; the others spread over the circle, in another order for each step: first eleven, then three
/// between each two. Single steps can be given values of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    nth: u8,
    /// Coefficients up to this size (rotation entries, lengths over the length scale) count as zero; a right-hand side beyond its amplitude by no
    /// more than this (relative) counts as reached.
    pub tolerance: f64,
    /// The values of steps that have one of their own: an angle in radians, or a length over the length scale.
    values: [f64; STEPS],
    /// Those steps, a bit each.
    given: u16,
    /// Whether an elimination may take its time.
    thorough: bool,
}

/// Steps that can have values of their own.
pub(super) const STEPS: usize = 8;
/// Rounding of the coefficients.
const NOISE: f64 = 1e-11;

/// Cosines and sines: zero, then angles of no special kind, about 30 degrees apart and far ones first.
const ANGLES: [[f64; 2]; 12] = [
    [1.0, 0.0],
    [-0.224_951_054_343_865, 0.974_370_064_785_235_2],
    [-0.453_990_499_739_546_75, -0.891_006_524_188_367_9],
    [0.819_152_044_288_991_8, -0.573_576_436_351_046],
    [0.694_658_370_458_997_3, 0.719_339_800_338_651_1],
    [-0.987_688_340_595_137_8, -0.156_434_465_040_230_87],
    [0.309_016_994_374_947_45, -0.951_056_516_295_153_5],
    [-0.838_670_567_945_424, 0.544_639_035_015_027_1],
    [0.956_304_755_963_035_4, 0.292_371_704_722_736_7],
    [0.241_921_895_599_667_73, 0.970_295_726_275_996_5],
    [-0.798_635_510_047_292_9, -0.601_815_023_152_048_2],
    [0.992_546_151_641_322, -0.121_869_343_405_147_48],
];
/// From each of these angles to three more, so that no gap is left of more than 12.5 degrees: 0, 11.1, 21 and 32.5 degrees.
const BETWEEN: [[f64; 2]; 4] = [
    [1.0, 0.0],
    [0.981_292_663_992_245_1, 0.192_521_966_525_907_42],
    [0.933_580_426_497_201_7, 0.358_367_949_545_300_3],
    [0.843_391_445_812_885_7, 0.537_299_608_346_823_9],
];
/// Lengths over the length scale.
const LENGTHS: [f64; 12] = [0.0, 0.27, -0.23, 0.51, -0.48, 0.76, -0.74, 1.03, -0.97, 1.52, -1.46, 2.1];

impl Sample {
    /// Zero everywhere.
    pub const FIRST: Self = Self::nth(0);

    /// Sample number `n`.
    #[must_use]
    pub const fn nth(n: u8) -> Self {
        Self { nth: n, tolerance: NOISE, values: [0.0; STEPS], given: 0, thorough: false }
    }

    /// These values for the first steps.
    #[must_use]
    pub fn of(values: [f64; STEPS]) -> Self {
        Self { values, given: 0xff, ..Self::FIRST }
    }

    /// The same sample with this value for one step.
    #[must_use]
    pub fn with(mut self, step: usize, value: f64) -> Self {
        if let Some(place) = self.values.get_mut(step) {
            *place = value;
            self.given |= 1 << step;
        }
        self
    }

    /// The same sample with another size of what counts as zero.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// The same sample for a search without a bound on its time.
    #[must_use]
    pub(super) const fn thorough(self) -> Self {
        Self { thorough: true, ..self }
    }

    /// What an elimination may compute.
    #[must_use]
    pub const fn budget(&self) -> Budget {
        if self.thorough { Budget::THOROUGH } else { Budget::BOUNDED }
    }

    /// All samples but the first, for a search without a bound on its time.
    pub(super) fn others() -> impl Iterator<Item = Self> {
        (1..48).map(|n| Self::nth(n).thorough())
    }

    /// The place in a list of twelve: each step goes through it in another order.
    fn place(&self, step: usize) -> usize {
        let stride = [1, 5, 7, 11].get(step % 4).copied().unwrap_or(1);
        usize::from(self.nth) * stride % 12
    }

    /// The value that a step has of its own.
    fn own(&self, step: usize) -> Option<f64> {
        self.values.get(step).filter(|_| self.given >> step & 1 == 1).copied()
    }

    /// The value of the one step that has its own; 0 without.
    pub(super) fn value(&self) -> f64 {
        self.values.get(self.given.trailing_zeros() as usize).copied().unwrap_or(0.0)
    }

    /// The angle of a step, as `[cos, sin]`.
    #[must_use]
    #[inline]
    pub fn angle(&self, step: usize) -> [f64; 2] {
        if self.nth == 0 && self.given == 0 {
            return [1.0, 0.0];
        }
        if let Some(angle) = self.own(step) {
            let (s, c) = crate::math::sin_cos(angle);
            return [c, s];
        }
        let [c, s] = ANGLES.get(self.place(step)).copied().unwrap_or([1.0, 0.0]);
        let [x, y] = BETWEEN.get(usize::from(self.nth / 12)).copied().unwrap_or([1.0, 0.0]);
        [c * x - s * y, s * x + c * y]
    }

    /// The length of a step, over the length scale.
    #[must_use]
    pub fn length(&self, step: usize) -> f64 {
        let listed = LENGTHS.get(self.place(step)).copied().unwrap_or(0.0) + 0.061 * f64::from(self.nth / 12);
        self.own(step).unwrap_or(listed)
    }
}

/// What the closed form reports beside its candidates.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// What may be missing.
    pub status: Status,
    /// The steps that left their unknown free, a bit each.
    free: u16,
    /// Equations of one unknown behind a free one.
    pub(super) equations: List<SinCosEquation, 24>,
    pub(super) why: Why<f64>,
}

impl Default for Attempt {
    fn default() -> Self {
        Attempt::new()
    }
}

impl Attempt {
    /// Nothing to report.
    #[inline]
    #[must_use]
    pub fn new() -> Self {
        Attempt { status: Status::default(), free: 0, equations: List::new(), why: Why::NoSolution }
    }

    /// The same for a target in `f32`: beside a singular pose its rounding turns a double root into two, and what comes after them has as few
    /// digits as after a double one.
    #[inline]
    #[must_use]
    pub fn single() -> Self {
        Attempt { status: Status { grazed: true, ..Status::default() }, ..Attempt::new() }
    }

    /// Notes how a step ended that has no roots, or a double one, behind the roots and samples of `path`. `scale` turns the
    /// numbers of its equation into `unit`.
    #[cold]
    pub fn note(&mut self, outcome: Outcome, path: &Path, step: &'static str, scale: f64, unit: &'static str) {
        self.status.note(outcome, path.is_chosen());
        match outcome {
            Outcome::OutOfReach { needed, available } => {
                let why = Why::OutOfReach { step, needs: needed * scale, has: available * scale, unit };
                self.why = self.why.or_nearer(why);
            }
            Outcome::NoRealRoot => self.why = self.why.or_nearer(Why::NoRealRoot { step }),
            Outcome::Free | Outcome::Regular | Outcome::Touching => {}
        }
    }

    /// The same for a law of cosines, with the parts of [`Outcome::distances`] in units of the length scale. Reports distances.
    #[cold]
    #[allow(clippy::too_many_arguments)] // one call per step of generated code
    pub fn note_law(
        &mut self,
        outcome: Outcome,
        path: &Path,
        step: &'static str,
        [base, rest]: [f64; 2],
        grows: bool,
        length_scale: f64,
        unit: &'static str,
    ) {
        let Some([distance, limit]) = outcome.distances([base, rest], grows) else {
            return self.note(outcome, path, step, 1.0, unit);
        };
        self.status.note(outcome, path.is_chosen());
        let (needs, has) = (distance * length_scale, limit * length_scale);
        self.why = self.why.or_nearer(Why::OutOfReach { step, needs, has, unit });
    }

    /// Notes that a step left its unknown free, behind the roots and samples of `path`; gives back the path with it.
    #[cold]
    pub fn choose(&mut self, step: usize, path: &Path, joints: FreeJoints) -> Path {
        self.status.degenerate = true;
        self.free |= 1 << (step & 15);
        path.choose(step, joints)
    }

    /// The first step that was free in some branch.
    pub(super) fn first_free(&self) -> Option<usize> {
        (self.free != 0).then(|| self.free.trailing_zeros() as usize)
    }

    /// Notes `a cos u + b sin u = c` of a step behind a free one.
    #[cold]
    pub fn see(&mut self, step: usize, path: &Path, coefficients: [f64; 3]) {
        self.equations.push(SinCosEquation { step, path: *path, coefficients });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_all_different_for_every_step_and_lie_on_the_circle() {
        for step in 0..5 {
            let all: Vec<[f64; 2]> =
                core::iter::once(Sample::FIRST).chain(Sample::others()).map(|p| p.angle(step)).collect();
            assert_eq!(all.len(), 48);
            assert_eq!((all[0], Sample::FIRST.length(step)), ([1.0, 0.0], 0.0));
            for (i, a) in all.iter().enumerate() {
                assert!((a[0].hypot(a[1]) - 1.0).abs() < 1e-15);
                assert!(all[..i].iter().all(|b| (a[0] - b[0]).hypot(a[1] - b[1]) > 0.02));
            }
        }
    }

    #[test]
    fn laws_of_cosines_report_distances() {
        // Links of 0.4 and 0.3; where the amplitude grows, the first turns about the origin of the target.
        let reported = |distance: f64, grows: bool| {
            let base: f64 = if grows { 0.3 * 0.3 - 0.4 * 0.4 } else { 0.3 * 0.3 + 0.4 * 0.4 };
            let available = 2.0 * 0.4 * if grows { distance } else { 0.3 };
            let rest = distance * distance - base;
            let mut attempt = Attempt::new();
            let outcome = Outcome::OutOfReach { needed: rest.abs(), available };
            attempt.note_law(outcome, &Path::START, "q", [base, rest], grows, 2.0, "m");
            match attempt.why {
                Why::OutOfReach { needs, has, .. } => [needs, has],
                _ => [f64::NAN; 2],
            }
        };
        for grows in [false, true] {
            for (distance, limit) in [(0.9, 0.7), (40.0, 0.7), (0.05, 0.1)] {
                let [needs, has] = reported(distance, grows);
                assert!((needs - 2.0 * distance).abs() < 1e-12 && (has - 2.0 * limit).abs() < 1e-9, "{needs} {has}");
            }
        }
    }

    #[test]
    fn a_dead_end_behind_a_choice_is_a_loss() {
        let mut attempt = Attempt::new();
        let outcome = Outcome::OutOfReach { needed: 2.0, available: 1.0 };
        attempt.note(outcome, &Path::START, "q3", 1.0, "m");
        assert!(!attempt.status.lost && !attempt.status.degenerate);
        attempt.note(Outcome::Free, &Path::START, "q4", 1.0, "m");
        assert!(!attempt.status.lost && attempt.status.degenerate);
        attempt.note(outcome, &Path::START.choose(4, FreeJoints::of(&[3])), "q5", 1.0, "m");
        assert!(attempt.status.lost);
    }
}
