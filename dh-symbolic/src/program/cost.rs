//! Operation counts of a program.

use super::{Graph, Node, Value};
use crate::algebra::LinearAngle;
use std::fmt;

/// Operation counts. Signs are free, additions include subtractions and the sums of angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Multiplications.
    pub multiplications: usize,
    /// Additions.
    pub additions: usize,
    /// Sine-cosine pairs.
    pub sincos: usize,
}

impl Cost {
    /// Counts what the outputs need.
    pub fn of(graph: &Graph, outputs: &[Value]) -> Cost {
        let live = graph.live(outputs);
        let mut cost = Cost { multiplications: 0, additions: 0, sincos: 0 };
        let mut angle_sums = vec![false; graph.angle_sums().len()];
        for (node, _) in graph.nodes().iter().zip(&live).filter(|(_, l)| **l) {
            match node {
                Node::Mul(..) => cost.multiplications += 1,
                Node::Add(..) => cost.additions += 1,
                Node::Cos(w) | Node::Sin(w) => angle_sums[*w as usize] = true,
                _ => {}
            }
        }
        let used: Vec<&LinearAngle> =
            graph.angle_sums().iter().zip(&angle_sums).filter(|(_, l)| **l).map(|(w, _)| w).collect();
        for angle_sum in &used {
            cost.sincos += 1;
            // A sum that continues another one (q2 + q3 + q4 after q2 + q3) begins with it.
            let begun = used
                .iter()
                .filter(|w| {
                    w.terms.len() < angle_sum.terms.len()
                        && w.constant.is_zero()
                        && angle_sum.terms.starts_with(&w.terms)
                })
                .map(|w| w.terms.len())
                .max()
                .unwrap_or(1);
            let terms: usize = angle_sum.terms[begun.min(angle_sum.terms.len())..]
                .iter()
                .map(|t| usize::from(t.1.unsigned_abs()))
                .sum();
            cost.additions += terms + usize::from(!angle_sum.constant.is_zero());
        }
        cost
    }

    /// The figure that searches compare: a sine-cosine pair counts as twenty operations.
    pub fn weight(&self) -> usize {
        self.multiplications + self.additions + 20 * self.sincos
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
        let (m, a) = (plural(self.multiplications, "multiplication"), plural(self.additions, "addition"));
        write!(f, "{m}, {a}, {}", plural(self.sincos, "sine-cosine pair"))
    }
}
