//! Names conditions by the configuration of the arm: shoulder left or right, elbow up or down, wrist flipped or not.

use super::{Condition, Evaluator};
use crate::chain::Coordinate;
use crate::planner::Axes;
use crate::program::{Indicator, sides};

/// Poses of the arm as it is that are looked at.
const POSES: usize = 60;
/// Fewest poses of each kind.
const FEWEST: usize = 6;

impl Evaluator<'_> {
    /// The sides of the arm's parts that are taken exactly where the conditions are met; nothing where no sides say it.
    pub(super) fn configuration_of(&self, conditions: &[Condition]) -> Vec<(Indicator, bool)> {
        let chain = self.chain;
        // six joints, with the lengths of the table
        let open = chain.parameters.iter().any(|p| matches!(p.role, crate::chain::Role::Field(None)));
        if chain.dof() != 6 || !chain.is_direct() || open {
            return Vec::new();
        }
        let axes = Axes::new(chain);
        if axes.count() != axes.real {
            return Vec::new();
        }
        let solved: Vec<usize> = (0..6).collect();
        let mut seen = Vec::new();
        for (numbers, _) in (0..2 * POSES).map(|k| self.sample(k)).filter(|s| s.1).take(POSES) {
            let x: Vec<f64> = chain
                .joints
                .iter()
                .map(|j| match j.coordinate {
                    Coordinate::Angle(v) => numbers.angle(v),
                    Coordinate::Length(s) => numbers.symbol(s) / axes.length_scale,
                })
                .collect();
            seen.push((self.is_met(&numbers, conditions), sides(chain, &axes, &x, &solved)));
        }
        let mut out = Vec::new();
        for (part, indicator) in [Indicator::Shoulder, Indicator::Elbow, Indicator::Wrist].into_iter().enumerate() {
            let met = || seen.iter().filter(|s| s.0).map(|s| s.1[part]);
            let first = met().all(|side| side == Some(true));
            if first || met().all(|side| side == Some(false)) {
                out.push((part, indicator, first));
            }
        }
        let (met, all) = (seen.iter().filter(|s| s.0).count(), seen.len());
        let named = |s: &[Option<bool>; 3]| out.iter().all(|(part, _, first)| s[*part] == Some(*first));
        let exact = seen.iter().all(|(met, s)| *met == named(s));
        if !exact || met < FEWEST || all - met < FEWEST {
            return Vec::new();
        }
        out.into_iter().map(|(_, indicator, first)| (indicator, first)).collect()
    }
}
