//! Summands of a formula while it is being grouped, and their conversion to expressions.

use super::{Atom, Powers, Term};
use crate::algebra::{Rational, Symbol};
use crate::render::formula::expression::{Expression, Summand};

/// A summand while it is being put together: sign, number, sorted atoms, sums in brackets.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) negative: bool,
    pub(super) number: Rational,
    pub(super) atoms: Powers,
    pub(super) brackets: Vec<Vec<Part>>,
}

impl Part {
    pub(super) fn of_term(t: Term) -> Part {
        let (negative, number) = (t.coefficient.is_negative(), t.coefficient.abs());
        Part { negative, number, atoms: t.atoms, brackets: Vec::new() }
    }

    /// Number of groups of joints that occur: parts that reach further along the chain come first.
    pub(super) fn span(&self) -> usize {
        let mut places = Vec::new();
        self.places(&mut places);
        places.sort_unstable();
        places.dedup();
        places.len()
    }

    fn places(&self, out: &mut Vec<usize>) {
        for (a, _) in &self.atoms {
            if let Atom::Joint(w) = a {
                out.push(w.place);
            }
        }
        self.brackets.iter().flatten().for_each(|p| p.places(out));
    }

    pub(super) fn has_angles(&self) -> bool {
        self.atoms.iter().any(|(a, _)| matches!(a, Atom::Joint(_) | Atom::Constant(_)))
            || self.brackets.iter().flatten().any(Part::has_angles)
    }

    pub(super) fn symbols(&self) -> Vec<Symbol> {
        let own = self.atoms.iter().filter_map(|(a, _)| match a {
            Atom::Symbol(s) => Some(*s),
            _ => None,
        });
        own.chain(self.brackets.iter().flatten().flat_map(Part::symbols)).collect()
    }

    fn expression(self) -> Summand {
        let mut factors = Vec::new();
        if !self.number.is_one() {
            factors.push(Expression::Number(self.number));
        }
        let roots: Vec<u8> = self
            .atoms
            .iter()
            .filter_map(|(a, _)| match a {
                Atom::Root(n) => Some(*n),
                _ => None,
            })
            .collect();
        if !roots.is_empty() {
            factors.push(Expression::Root(roots.iter().product()));
        }
        for (atom, n) in self.atoms {
            let base = match atom {
                Atom::Root(_) => continue,
                Atom::Symbol(s) => Expression::Symbol(s),
                Atom::Joint(w) | Atom::Constant(w) => Expression::Trig(w.trig),
            };
            factors.push(if n == 1 { base } else { Expression::Power(Box::new(base), n) });
        }
        factors.extend(self.brackets.into_iter().map(sum));
        let value = match factors.len() {
            0 => Expression::Number(Rational::ONE),
            1 => factors.remove(0),
            _ => Expression::Product(factors),
        };
        Summand { negative: self.negative, value }
    }
}

/// The sum of some parts; one positive part alone is no sum.
pub(super) fn sum(parts: Vec<Part>) -> Expression {
    let mut list: Vec<Summand> = parts.into_iter().map(Part::expression).collect();
    match list.as_slice() {
        [only] if !only.negative => list.remove(0).value,
        _ => Expression::Sum(list),
    }
}
