//! Sums of products as written in a cell: exact factors, declared names, at most one angle and one joint variable each.

use crate::algebra::Rational;
use crate::diagnostic::{Error, Place};

/// Limits of one cell. Nothing that a person writes comes near; they keep hostile input from taking time.
const MOST_TERMS: usize = 64;
const MOST_NAMES: usize = 8;

/// The angle in a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum AngleUnit {
    /// The factor counts half turns.
    Pi,
    /// The factor counts radians (`approx`).
    Radian,
    /// A declared angle: its index.
    Declared(usize),
}

/// A product.
#[derive(Clone, Debug)]
pub(super) struct Term {
    /// The number.
    pub(super) factor: Rational,
    /// Declared lengths and numbers: their indices in order, with repetition.
    pub(super) names: Vec<usize>,
    /// How many of the factors are lengths: literals with a unit, declared lengths.
    pub(super) lengths: usize,
    /// Whether one of them is a literal with a unit of length.
    pub(super) literal_length: bool,
    /// The angle among the factors.
    pub(super) angle: Option<AngleUnit>,
    /// The joint variable among the factors, from 0.
    pub(super) variable: Option<usize>,
    /// Where to point if it does not fit: the factor that decides what the product is.
    pub(super) place: Place,
    /// That factor as written.
    pub(super) word: String,
}

impl Term {
    /// A number.
    pub(super) fn number(factor: Rational, place: Place, word: String) -> Term {
        Term { factor, names: Vec::new(), lengths: 0, literal_length: false, angle: None, variable: None, place, word }
    }

    fn same_kind(&self, other: &Term) -> bool {
        self.names == other.names
            && self.lengths == other.lengths
            && self.angle == other.angle
            && self.variable == other.variable
    }

    /// How much a factor decides what the product is.
    fn weight(&self) -> usize {
        if self.variable.is_some() || self.angle.is_some() {
            3
        } else if self.lengths > 0 {
            2
        } else {
            usize::from(!self.names.is_empty())
        }
    }

    fn times(&self, other: &Term) -> Result<Term, Error> {
        let both = self.place.to(other.place);
        if self.variable.is_some() && other.variable.is_some() {
            return Err(Error::new(both, "a product of joint variables: a motor drives its joints linearly"));
        }
        if self.angle.is_some() && other.angle.is_some() {
            return Err(Error::new(both, "the product of two angles is no angle"));
        }
        let mut names = [self.names.as_slice(), other.names.as_slice()].concat();
        names.sort_unstable();
        if names.len() > MOST_NAMES {
            return Err(Error::new(both, format!("a product of more than {MOST_NAMES} names")));
        }
        let leader = if other.weight() > self.weight() { other } else { self };
        Ok(Term {
            factor: &self.factor * &other.factor,
            names,
            lengths: self.lengths + other.lengths,
            literal_length: self.literal_length || other.literal_length,
            angle: self.angle.or(other.angle),
            variable: self.variable.or(other.variable),
            place: leader.place,
            word: leader.word.clone(),
        })
    }
}

/// A sum of products; equal kinds are merged, zeros are kept (`0mm` is a length).
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    pub(super) terms: Vec<Term>,
}

impl Sum {
    /// A sum of one product.
    pub(super) fn of(term: Term) -> Sum {
        Sum { terms: vec![term] }
    }

    /// Adds a product.
    pub(super) fn push(&mut self, term: Term) -> Result<(), Error> {
        let full = self.terms.len() >= MOST_TERMS;
        match self.terms.iter_mut().find(|t| t.same_kind(&term)) {
            Some(t) => {
                t.factor = &t.factor + &term.factor;
                t.literal_length |= term.literal_length;
            }
            None if full => {
                return Err(Error::new(term.place, format!("a sum of more than {MOST_TERMS} products")));
            }
            None => self.terms.push(term),
        }
        Ok(())
    }

    /// Adds a sum.
    pub(super) fn add(&mut self, other: Sum) -> Result<(), Error> {
        other.terms.into_iter().try_for_each(|t| self.push(t))
    }

    /// The product.
    pub(super) fn times(&self, other: &Sum) -> Result<Sum, Error> {
        let mut product = Sum::default();
        for a in &self.terms {
            for b in &other.terms {
                product.push(a.times(b)?)?;
            }
        }
        Ok(product)
    }

    /// A multiple.
    pub(super) fn scaled(mut self, factor: &Rational) -> Sum {
        for t in &mut self.terms {
            t.factor = &t.factor * factor;
        }
        self
    }
}
