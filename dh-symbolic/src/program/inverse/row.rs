//! The coefficients of one equation, in the order that its kind of step expects.

use super::super::graph::{Graph, Value, ZERO};
use super::lower::Lower;
use crate::algebra::{Factor, Monomial, Poly, Rational, Symbol};
use crate::planner::{Basis, Collected};

impl Lower<'_> {
    /// The coefficients of an equation, in the order of some columns.
    pub(super) fn row(&mut self, columns: &[Vec<Basis>], c: &Collected) -> Vec<Value> {
        columns.iter().map(|k| c.get(k).map_or(ZERO, |p| self.formula(p))).collect()
    }

    /// A coefficient, factored by the inputs that occur most often.
    pub(super) fn formula(&mut self, p: &Poly) -> Value {
        factored(&mut self.g, p)
    }
}

/// Horner's scheme by the input that occurs in most terms.
fn factored(g: &mut Graph, p: &Poly) -> Value {
    let mut counts: Vec<(Symbol, usize)> = Vec::new();
    for (m, _) in p.terms() {
        for f in m.factors() {
            if let Factor::Power(s, _) = f {
                match counts.iter_mut().find(|c| c.0 == s) {
                    Some(c) => c.1 += 1,
                    None => counts.push((s, 1)),
                }
            }
        }
    }
    // The most frequent input; of equals the one declared last (found last), so that inner loops do less.
    let best = counts.iter().filter(|c| c.1 > 1).max_by_key(|c| (c.1, c.0));
    let Some((s, _)) = best.copied() else { return g.polynomial(p) };
    let (with, without): (Vec<_>, Vec<_>) = p.terms().iter().cloned().partition(|(m, _)| m.exponent(s) > 0);
    let quotient: Vec<(Monomial, Rational)> = with
        .into_iter()
        .flat_map(|(m, c)| {
            let n = m.exponent(s);
            let rest = Poly::term(m.filter(|f| !matches!(f, Factor::Power(x, _) if *x == s)), c);
            (&rest * &Poly::power(s, n - 1)).terms().to_vec()
        })
        .collect();
    let a = factored(g, &Poly::from_terms(quotient));
    let x = g.symbol(s);
    let product = g.mul(a, x);
    let rest = factored(g, &Poly::from_terms(without));
    g.add(product, rest)
}
