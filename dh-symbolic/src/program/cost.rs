//! What a program costs.

use super::{Graph, Node, Value};
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
        let mut waves = vec![false; graph.waves().len()];
        for (node, _) in graph.nodes().iter().zip(&live).filter(|(_, l)| **l) {
            match node {
                Node::Mul(..) => cost.multiplications += 1,
                Node::Add(..) => cost.additions += 1,
                Node::Cos(w) | Node::Sin(w) => waves[*w as usize] = true,
                _ => {}
            }
        }
        for (wave, _) in graph.waves().iter().zip(&waves).filter(|(_, l)| **l) {
            cost.sincos += 1;
            let terms: usize = wave.terms.iter().map(|t| usize::from(t.1.unsigned_abs())).sum();
            cost.additions += terms.saturating_sub(1) + usize::from(!wave.constant.is_zero());
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
