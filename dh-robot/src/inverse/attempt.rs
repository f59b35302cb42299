//! What generated code and the driver tell each other: which value a free unknown takes, and how a run of the plan ended.

use crate::{FreeJoints, Why};
use dh_kernels::Outcome;

/// Which values the unknowns take that their equations leave free: one choice for a whole run of the plan.
///
/// The first choice is zero for every step; the others spread over the circle, in another order for each step: first eleven, then three
/// between each two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pick(u8);

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
/// Lengths over the reach.
const LENGTHS: [f64; 12] = [0.0, 0.27, -0.23, 0.51, -0.48, 0.76, -0.74, 1.03, -0.97, 1.52, -1.46, 2.1];

impl Pick {
    /// Zero everywhere.
    pub const FIRST: Self = Self(0);

    /// Choice number `n`.
    #[doc(hidden)]
    #[must_use]
    pub fn nth(n: u8) -> Self {
        Self(n)
    }

    /// All choices but the first.
    pub(super) fn others() -> impl Iterator<Item = Self> {
        (1..48).map(Self)
    }

    /// The place in a list of twelve: each step goes through it in another order.
    fn place(self, step: usize) -> usize {
        let stride = [1, 5, 7, 11].get(step % 4).copied().unwrap_or(1);
        usize::from(self.0) * stride % 12
    }

    /// The angle, as `[cos, sin]`.
    #[must_use]
    pub fn angle(self, step: usize) -> [f64; 2] {
        let [c, s] = ANGLES.get(self.place(step)).copied().unwrap_or([1.0, 0.0]);
        let [x, y] = BETWEEN.get(usize::from(self.0 / 12)).copied().unwrap_or([1.0, 0.0]);
        [c * x - s * y, s * x + c * y]
    }

    /// The length, over the reach.
    #[must_use]
    pub fn length(self, step: usize) -> f64 {
        LENGTHS.get(self.place(step)).copied().unwrap_or(0.0) + 0.061 * f64::from(self.0 / 12)
    }
}

/// What the closed form reports beside its candidates.
#[derive(Clone, Copy, Debug)]
pub struct Attempt {
    /// Some step left its unknown free.
    pub degenerate: bool,
    /// A value that was chosen for a free unknown led to nothing, and another one might lead to something; or a step missed its root
    /// by no more than the error of a double root before it; or a step without a root came after a double one.
    pub lost: bool,
    /// Some step had a double root, or nearly: what comes after it has fewer digits.
    pub grazed: bool,
    /// Rounding, or an elimination that lost its rank, may have hidden a root.
    pub doubt: bool,
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
        Attempt { degenerate: false, lost: false, grazed: false, doubt: false, why: Why::NoSolution }
    }

    /// The same for a target in `f32`: beside a singular pose its rounding turns a double root into two, and what comes after them has as few
    /// digits as after a double one.
    #[inline]
    #[must_use]
    pub fn single() -> Self {
        Attempt { grazed: true, ..Attempt::new() }
    }

    /// Notes how a step ended that has no roots, or a double one, where `free` are the joints for which values were chosen before. `scale` turns the
    /// numbers of its equation into `unit`.
    #[cold]
    pub fn note(&mut self, outcome: Outcome, free: FreeJoints, step: &'static str, scale: f64, unit: &'static str) {
        match outcome {
            Outcome::Free => return self.degenerate = true,
            Outcome::Touching => return self.grazed = true,
            _ => {}
        }
        self.lost |= !free.is_empty() || self.grazed || outcome.just_misses_a_root();
        self.doubt |= outcome.may_hide_a_root();
        match outcome {
            Outcome::OutOfReach { needed, available } => {
                let why = Why::OutOfReach { step, needs: needed * scale, has: available * scale, unit };
                self.why = self.why.or_nearer(why);
            }
            Outcome::NoRealRoot => self.why = self.why.or_nearer(Why::NoRealRoot { step }),
            Outcome::Free | Outcome::Regular | Outcome::Touching => {}
        }
    }

    /// The same for a law of cosines: with `[base, rest]` the squared distance is `base + rest`, and `rest = a cos u + b sin u`, in units of the
    /// reach. Where `grows`, the amplitude of the right side is proportional to the distance, else it is constant. Reports distances.
    #[cold]
    #[allow(clippy::too_many_arguments)] // one call per step of generated code
    pub fn note_law(
        &mut self,
        outcome: Outcome,
        free: FreeJoints,
        step: &'static str,
        [base, rest]: [f64; 2],
        grows: bool,
        reach: f64,
        unit: &'static str,
    ) {
        let Outcome::OutOfReach { available, .. } = outcome else { return self.note(outcome, free, step, 1.0, unit) };
        self.lost |= !free.is_empty() || self.grazed || outcome.just_misses_a_root();
        self.doubt |= outcome.may_hide_a_root();
        let distance = crate::math::sqrt((base + rest).max(0.0));
        let available = if rest > 0.0 { available } else { -available };
        let limit = if grows {
            // distance^2 = base + slope distance; of two limits the near one where the target is too near.
            let half = 0.5 * available / distance;
            let root = crate::math::sqrt((base + half * half).max(0.0));
            if distance < half { half - root } else { half + root }
        } else {
            crate::math::sqrt((base + available).max(0.0))
        };
        let (needs, has) = (distance * reach, limit.max(0.0) * reach);
        self.why = self.why.or_nearer(Why::OutOfReach { step, needs, has, unit });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_all_different_for_every_step_and_lie_on_the_circle() {
        for step in 0..5 {
            let all: Vec<[f64; 2]> =
                core::iter::once(Pick::FIRST).chain(Pick::others()).map(|p| p.angle(step)).collect();
            assert_eq!(all.len(), 48);
            assert_eq!((all[0], Pick::FIRST.length(step)), ([1.0, 0.0], 0.0));
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
            attempt.note_law(outcome, FreeJoints::NONE, "q", [base, rest], grows, 2.0, "m");
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
        attempt.note(outcome, FreeJoints::NONE, "q3", 1.0, "m");
        assert!(!attempt.lost && !attempt.degenerate);
        attempt.note(Outcome::Free, FreeJoints::NONE, "q4", 1.0, "m");
        assert!(!attempt.lost && attempt.degenerate);
        attempt.note(outcome, FreeJoints::of(&[3]), "q5", 1.0, "m");
        assert!(attempt.lost);
    }
}
