//! From the normal form to the textbook's shape: common factors first, then the outermost angle of the chain, then the next.
//!
//! `c1[c23(c4c5c6 - s4s6) - s23s5c6] + s1(s4c5c6 + c4s6)` is what a hand computation from the tip to the base gives, and what
//! collecting by the angles in chain order finds again. Nothing is searched: the number of steps is bounded by terms times angles.

mod collect;
mod part;
mod power;

use super::expression::{Expression, Trig};
use crate::algebra::{AngleVar, Factor, Poly, Rational, Symbol};
use crate::chain::{Chain, Coordinate};
use collect::parts;
use part::sum;
use power::lower_powers;

/// The order in which angles are collected: groups of parallel joints from base to tip; all other angles are constants and
/// stay inside.
#[derive(Clone, Debug, Default)]
pub struct Order {
    groups: Vec<u16>,
}

impl Order {
    /// Groups in the order in which they are collected.
    pub fn new(groups: Vec<u16>) -> Order {
        Order { groups }
    }

    /// The order of a chain's joints.
    pub fn of(chain: &Chain) -> Order {
        let mut groups = Vec::new();
        for joint in &chain.joints {
            if let Coordinate::Angle(v) = joint.coordinate
                && !groups.contains(&v.group())
            {
                groups.push(v.group());
            }
        }
        Order { groups }
    }

    fn place(&self, trig: &Trig) -> usize {
        let group = trig.angles.first().map(|(v, _)| v.group());
        self.groups.iter().position(|g| Some(*g) == group).unwrap_or(usize::MAX)
    }

    /// The formula in reading order.
    pub fn group(&self, p: &Poly) -> Expression {
        let terms = p.terms().iter().map(|(m, c)| self.term(m.factors(), c)).collect();
        sum(parts(lower_powers(terms), true))
    }

    fn term(&self, factors: impl Iterator<Item = Factor>, coefficient: &Rational) -> Term {
        let mut atoms: Powers = factors
            .map(|f| match f {
                Factor::Root(n) => (Atom::Root(n), 1),
                Factor::Power(s, n) => (Atom::Symbol(s), n),
                Factor::Cos(angles) => (self.trig(Trig { angles, sine: false }), 1),
                Factor::Sin(angles) => (self.trig(Trig { angles, sine: true }), 1),
            })
            .collect();
        atoms.sort();
        Term { coefficient: coefficient.clone(), atoms }
    }

    fn trig(&self, trig: Trig) -> Atom {
        let place = self.place(&trig);
        if place == usize::MAX { Atom::Constant(Along::new(0, trig)) } else { Atom::Joint(Along::new(place, trig)) }
    }
}

/// A factor. The order of variants and fields is the order of factors in a product.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Atom {
    Root(u8),
    Symbol(Symbol),
    Joint(Along),
    Constant(Along),
}

/// A sine or cosine in the order of the chain: by place of its group, then by the last joint that it holds.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Along {
    place: usize,
    last: Option<AngleVar>,
    trig: Trig,
}

impl Along {
    fn new(place: usize, trig: Trig) -> Along {
        Along { place, last: trig.angles.last().map(|(v, _)| *v), trig }
    }
}

/// A product of powers, sorted.
type Powers = Vec<(Atom, u32)>;

/// A product of atoms with a coefficient.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Term {
    coefficient: Rational,
    atoms: Powers,
}
