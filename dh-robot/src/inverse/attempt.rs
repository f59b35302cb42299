//! What generated code and the driver tell each other: which value a free unknown takes, and how a run of the plan ended.

use crate::ik::Outcome;
use crate::{FreeJoints, Why};

/// Which values the unknowns take that their equations leave free: one choice for a whole run of the plan.
///
/// The first choice is zero for every step; the others spread over the circle, in another order for each step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pick(u8);

/// Cosines and sines of multiples of 30 degrees, far ones first.
const ANGLES: [[f64; 2]; 12] = {
    const H: f64 = 0.866_025_403_784_438_6;
    [
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
        [0.0, -1.0],
        [H, 0.5],
        [-0.5, H],
        [-H, -0.5],
        [0.5, -H],
        [0.5, H],
        [-H, 0.5],
        [-0.5, -H],
        [H, -0.5],
    ]
};
/// Lengths over the reach.
const LENGTHS: [f64; 12] = [0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0, 1.5, -1.5, 2.0];

impl Pick {
    /// Zero everywhere.
    pub const FIRST: Self = Self(0);

    /// All choices but the first.
    pub(super) fn others() -> impl Iterator<Item = Self> {
        (1..12).map(Self)
    }

    /// The place in a list of twelve: each step goes through it in another order.
    fn place(self, step: usize) -> usize {
        let stride = [1, 5, 7, 11].get(step % 4).copied().unwrap_or(1);
        usize::from(self.0) * stride % 12
    }

    /// The angle, as `[cos, sin]`.
    #[must_use]
    pub fn angle(self, step: usize) -> [f64; 2] {
        ANGLES.get(self.place(step)).copied().unwrap_or([1.0, 0.0])
    }

    /// The length, over the reach.
    #[must_use]
    pub fn length(self, step: usize) -> f64 {
        LENGTHS.get(self.place(step)).copied().unwrap_or(0.0)
    }
}

/// What the closed form reports beside its candidates.
#[derive(Clone, Copy, Debug)]
pub struct Attempt {
    /// Some step left its unknown free.
    pub degenerate: bool,
    /// A value that was chosen for a free unknown led to nothing: another one might lead to something.
    pub lost: bool,
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
        Attempt { degenerate: false, lost: false, why: Why::NoSolution }
    }

    /// Notes how a step without roots ended, where `free` are the joints for which values were chosen before. `scale` turns the
    /// numbers of its equation into `unit`.
    #[cold]
    pub fn note(&mut self, outcome: Outcome, free: FreeJoints, step: &'static str, scale: f64, unit: &'static str) {
        if outcome == Outcome::Free {
            self.degenerate = true;
            return;
        }
        self.lost |= !free.is_empty();
        match outcome {
            Outcome::OutOfReach { needed, available } => {
                let why = Why::OutOfReach { step, needs: needed * scale, has: available * scale, unit };
                self.why = self.why.or_nearer(why);
            }
            Outcome::NoRealRoot => self.why = self.why.or_nearer(Why::NoRealRoot { step }),
            Outcome::Free | Outcome::Regular | Outcome::Touching => {}
        }
    }

    /// The same for a law of cosines `square - constant = a cos u + b sin u`, where `square` is a squared distance and `rest` the left side,
    /// in units of the reach: reports distances.
    #[cold]
    #[allow(clippy::too_many_arguments)] // one call per step of generated code
    pub fn note_distance(
        &mut self,
        outcome: Outcome,
        free: FreeJoints,
        step: &'static str,
        square: f64,
        rest: f64,
        reach: f64,
        unit: &'static str,
    ) {
        let Outcome::OutOfReach { available, .. } = outcome else { return self.note(outcome, free, step, 1.0, unit) };
        self.lost |= !free.is_empty();
        let limit = (square - rest + if rest > 0.0 { available } else { -available }).max(0.0);
        let (needs, has) = (crate::math::sqrt(square) * reach, crate::math::sqrt(limit) * reach);
        self.why = self.why.or_nearer(Why::OutOfReach { step, needs, has, unit });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_all_different_for_every_step_and_lie_on_the_circle() {
        for step in 0..5 {
            let all: Vec<[f64; 2]> = core::iter::once(Pick::FIRST).chain(Pick::others()).map(|p| p.angle(step)).collect();
            assert_eq!(all.len(), 12);
            assert_eq!((all[0], Pick::FIRST.length(step)), ([1.0, 0.0], 0.0));
            for (i, a) in all.iter().enumerate() {
                assert!((a[0].hypot(a[1]) - 1.0).abs() < 1e-15);
                assert!(all[..i].iter().all(|b| (a[0] - b[0]).hypot(a[1] - b[1]) > 0.5));
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
