//! How a run of the closed form ended: whether solutions may be missing, and why.

use super::roots::Outcome;

/// What the steps of a run say about solutions that it may have missed. The JavaScript runtime has the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Status {
    /// Some step left its unknown free.
    pub degenerate: bool,
    /// A value that was chosen for a free unknown led to nothing, and another one might lead to something; or a step missed its root
    /// by no more than the error of a double root before it; or a step without a root came after a double one.
    pub lost: bool,
    /// Some step had a double root, or nearly: what comes after it has fewer digits.
    pub grazed: bool,
    /// Rounding, or an elimination that lost its rank, may have hidden a root.
    pub doubt: bool,
}

impl Status {
    /// Records a step whose outcome is not regular; `chosen` says whether values were chosen before for free unknowns.
    pub fn note(&mut self, outcome: Outcome, chosen: bool) {
        match outcome {
            Outcome::Regular => {}
            Outcome::Free => self.degenerate = true,
            Outcome::Touching => self.grazed = true,
            Outcome::OutOfReach { .. } | Outcome::NoRealRoot => {
                self.lost |= chosen || self.grazed || outcome.just_misses_a_root();
                self.doubt |= outcome.may_hide_a_root();
            }
        }
    }
}
