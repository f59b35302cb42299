//! State shared by the passes that translate a plan into instructions.

use super::super::graph::{Graph, ONE, Value, ZERO};
use super::super::vector::V3;
use crate::algebra::Poly;
use crate::planner::{JointCombination, Plan, combination};

/// A pose of values.
#[derive(Clone, Copy)]
pub(super) struct Pose {
    pub(super) columns: [V3; 3],
    pub(super) p: V3,
}

/// A plan on its way to instructions.
pub(super) struct Lower<'a> {
    pub(super) g: Graph,
    pub(super) plan: &'a Plan,
    /// The known poses that are bound already: first and last frame.
    pub(super) bound: Vec<(usize, usize)>,
}

impl Lower<'_> {
    /// A vector of formulas.
    pub(super) fn vector(&mut self, v: &[Poly; 3]) -> V3 {
        self.g.vector(v)
    }

    /// Cosine and sine of a combination of known forms.
    pub(super) fn cos_sin(&mut self, form: &[i8], before: usize) -> (Value, Value) {
        let known = &self.plan.knowledge.known[..before];
        let forms: Vec<JointCombination> = known.iter().map(|k| k.form.clone()).collect();
        let weights = combination(form, &forms).unwrap_or_else(|| vec![0; forms.len()]);
        let (mut c, mut s) = (ONE, ZERO);
        for (w, k) in weights.iter().zip(known).filter(|(w, _)| **w != 0) {
            let (ck, sk) = (self.g.symbol(k.symbols[0]), self.g.symbol(k.symbols[1]));
            let sk = if *w < 0 { -sk } else { sk };
            for _ in 0..w.unsigned_abs() {
                let turned = self.g.turn(2, (ck, sk), [c, s, ZERO]);
                (c, s) = (turned[0], turned[1]);
            }
        }
        (c, s)
    }
}
