//! Bounds on the work of one call of the inverse, and the counters that are checked against them.

/// What a call of an inverse computes at most, or has computed.
///
/// `MAX_WORK` of every generated robot is such a bound. A run of the plan gives all candidates of the closed form; a Newton step is one
/// forward kinematics with its Jacobian, and the solution of six linear equations; an evaluation is a forward kinematics, with or without
/// Jacobian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Work {
    /// Runs of the plan.
    pub runs: u32,
    /// Newton steps.
    pub steps: u32,
    /// Evaluations of the forward kinematics, those of Newton steps included.
    pub evaluations: u32,
    most: [u32; 3],
}

impl Work {
    /// The bounds of an arm whose plan is in closed form.
    pub const CLOSED_FORM: Self = Self { runs: 20, steps: 96, evaluations: 400, most: [0; 3] };
    /// The bounds of an arm of few joints that reaches some poses from several sides: what the plan's equations do not tell apart there is looked
    /// for from joint values all over.
    pub const CROSSING_SHEETS: Self = Self { runs: 20, steps: 420, evaluations: 900, most: [0; 3] };
    /// The bounds of an arm whose plan eliminates (six joints, or six after some were chosen). Beside these, each run eliminates at most five
    /// times, and takes at most 300 Newton steps of its own.
    pub const ELIMINATION: Self = Self { runs: 3, steps: 160, evaluations: 600, most: [0; 3] };

    /// Nothing.
    pub const NONE: Self = Self { runs: 0, steps: 0, evaluations: 0, most: [0; 3] };

    /// Of two calls the more of everything.
    #[must_use]
    pub fn or_more(self, other: Self) -> Self {
        Self {
            runs: self.runs.max(other.runs),
            steps: self.steps.max(other.steps),
            evaluations: self.evaluations.max(other.evaluations),
            most: self.most,
        }
    }

    /// Nothing yet, of at most this.
    pub(super) fn new(most: Self) -> Self {
        Self { runs: 0, steps: 0, evaluations: 0, most: [most.runs, most.steps, most.evaluations] }
    }

    /// Whether solutions are to be looked for from joint values all over.
    pub(super) fn has_crossing_sheets(&self) -> bool {
        self.most[1] >= Self::CROSSING_SHEETS.steps
    }

    /// Whether these are the bounds of an elimination.
    pub(super) fn is_elimination(&self) -> bool {
        self.most[0] <= Self::ELIMINATION.runs
    }

    /// How many Newton steps may still be taken.
    pub(super) fn steps_left(&self) -> usize {
        let evaluations = self.most[2].saturating_sub(self.evaluations + 1);
        self.most[1].saturating_sub(self.steps).min(evaluations) as usize
    }

    /// Whether any of the bounds is reached.
    pub(super) fn is_used_up(&self) -> bool {
        self.runs >= self.most[0] || self.steps >= self.most[1] || self.evaluations >= self.most[2]
    }
}
