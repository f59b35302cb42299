//! The names of an arm's quantities: how they are printed, what a derivative by one of them is, which numbers they stand for.

use super::EvalError;
use crate::algebra::{AngleVar, Point, Poly, Rational, Symbol};
use crate::chain::{Chain, Coordinate, Role};
use crate::render::formula::grouping::Order;
use crate::render::formula::notation::{Name, Notation};

/// What formulas of one robot share.
#[derive(Debug)]
pub(super) struct Names {
    pub(super) chain: Chain,
    pub(super) notation: Notation,
    pub(super) order: Order,
    /// The joint variables as factors: they occur in derivatives by the coefficients of coupled drives.
    actuators: Vec<Symbol>,
}

impl Names {
    pub(super) fn new(mut chain: Chain) -> Names {
        let mut notation = Notation::textbook(&chain);
        let order = Order::of(&chain);
        let mut actuators = Vec::new();
        if !chain.is_direct() {
            for k in 1..=chain.dof() {
                let name = format!("q{k}");
                if chain.ring.find_symbol(&name).is_none() {
                    notation.set_symbol(chain.ring.symbol(&name), Name::of(&name).math());
                }
                actuators.push(chain.ring.symbol(&name));
            }
        }
        Names { chain, notation, order, actuators }
    }

    /// Do formulas of these two arms mean the same?
    pub(super) fn is_like(&self, other: &Names) -> bool {
        std::ptr::eq(self, other) || self.chain.ring == other.chain.ring
    }

    /// All names: the joint variables, then lengths and angles.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        let joints = self.chain.joints.iter().map(|j| j.name.as_str());
        joints.chain(self.chain.parameters.iter().map(|p| p.name.as_str()))
    }

    /// The joint that has this coordinate.
    fn joint(&self, coordinate: Coordinate) -> Option<usize> {
        self.chain.joints.iter().position(|j| j.coordinate == coordinate)
    }

    /// The derivative by a joint variable or a parameter; zero for a name that does not occur.
    pub(super) fn derivative(&self, p: &Poly, name: &str) -> Poly {
        let mut sum = Poly::zero();
        if let Some(s) = self.chain.ring.find_symbol(name).filter(|s| self.joint(Coordinate::Length(*s)).is_none()) {
            sum = &sum + &p.derivative_by_symbol(s);
        }
        if let Some(v) = self.chain.ring.find_angle(name).filter(|v| self.joint(Coordinate::Angle(*v)).is_none()) {
            sum = &sum + &p.derivative_by_angle(v);
        }
        for (i, joint) in self.chain.joints.iter().enumerate() {
            let rate = self.rate(i, name);
            if !rate.is_zero() {
                let slope = match joint.coordinate {
                    Coordinate::Length(s) => p.derivative_by_symbol(s),
                    Coordinate::Angle(v) => p.derivative_by_angle(v),
                };
                sum = &sum + &(&slope * &rate);
            }
        }
        sum
    }

    /// How fast joint coordinate `i` grows with a joint variable or a parameter.
    fn rate(&self, i: usize, name: &str) -> Poly {
        let (chain, mut sum) = (&self.chain, Poly::zero());
        let Some((joint, row)) = chain.joints.get(i).zip(chain.drive.get(i)) else { return sum };
        for (actuator, factor) in chain.joints.iter().zip(row) {
            if actuator.name == name {
                sum = &sum + factor;
            }
        }
        if let Some(s) = chain.ring.find_symbol(name) {
            for (factor, q) in row.iter().zip(&self.actuators) {
                sum = &sum + &(&factor.derivative_by_symbol(s) * &Poly::symbol(*q));
            }
        }
        for (parameter, times) in &joint.shift.symbols {
            if chain.parameters.get(*parameter).is_some_and(|p| p.name == name) {
                sum = &sum + &Poly::constant(Rational::int(i64::from(*times)));
            }
        }
        sum
    }

    /// The numbers of some formulas.
    pub(super) fn evaluate(&self, formulas: &[&Poly], given: &[(&str, f64)]) -> Result<Vec<f64>, EvalError> {
        if let Some((name, _)) = given.iter().find(|(name, _)| !self.names().any(|known| known == *name)) {
            return Err(EvalError::Unknown((*name).to_string()));
        }
        let mut values = Values { arm: self, given, missing: Vec::new() };
        let symbols: Vec<(Symbol, f64)> = sorted(formulas.iter().flat_map(|p| p.symbols()))
            .into_iter()
            .map(|s| (s, values.coordinate(Coordinate::Length(s))))
            .collect();
        let angles: Vec<(AngleVar, f64)> = sorted(formulas.iter().flat_map(|p| p.angles()))
            .into_iter()
            .map(|v| (v, values.coordinate(Coordinate::Angle(v))))
            .collect();
        if !values.missing.is_empty() {
            let mut missing = values.missing;
            missing.sort_by_key(|name| self.names().position(|n| n == name));
            return Err(EvalError::Missing(missing));
        }
        let point = Point {
            symbol: &|s| symbols.iter().find(|x| x.0 == s).map_or(f64::NAN, |x| x.1),
            angle: &|v| angles.iter().find(|x| x.0 == v).map_or(f64::NAN, |x| x.1),
        };
        Ok(formulas.iter().map(|p| p.evaluate(&point)).collect())
    }
}

fn sorted<T: Ord>(list: impl Iterator<Item = T>) -> Vec<T> {
    let mut list: Vec<T> = list.collect();
    list.sort();
    list.dedup();
    list
}

/// Numbers for names while a formula is evaluated.
struct Values<'a> {
    arm: &'a Names,
    given: &'a [(&'a str, f64)],
    missing: Vec<String>,
}

impl Values<'_> {
    /// The number that was given, or the one that the table has.
    fn name(&mut self, name: &str) -> f64 {
        if let Some((_, x)) = self.given.iter().rev().find(|(n, _)| *n == name) {
            return *x;
        }
        let parameter = self.arm.chain.parameters.iter().find(|p| p.name == name);
        match parameter.filter(|p| !matches!(p.role, Role::Field(None))) {
            Some(p) => self.arm.chain.nominal(p.handle),
            None => {
                if !self.missing.iter().any(|m| m == name) {
                    self.missing.push(name.to_string());
                }
                f64::NAN
            }
        }
    }

    /// A symbol or angle of the ring: for a joint what its actuators and its constant part make of it.
    fn coordinate(&mut self, coordinate: Coordinate) -> f64 {
        let chain = &self.arm.chain;
        let Some(i) = self.arm.joint(coordinate) else {
            return match coordinate {
                Coordinate::Length(s) => self.name(chain.ring.symbol_name(s)),
                Coordinate::Angle(v) => self.name(chain.ring.angle_name(v)),
            };
        };
        let shift = &chain.joints[i].shift;
        let mut sum = shift.radians();
        for (parameter, times) in &shift.symbols {
            if let Some(p) = chain.parameters.get(*parameter) {
                sum += f64::from(*times) * self.name(&p.name);
            }
        }
        for (factor, actuator) in chain.drive[i].iter().zip(&chain.joints) {
            if !factor.is_zero() {
                let numbers: Vec<(Symbol, f64)> =
                    factor.symbols().into_iter().map(|s| (s, self.name(chain.ring.symbol_name(s)))).collect();
                let symbol = |s: Symbol| numbers.iter().find(|x| x.0 == s).map_or(f64::NAN, |x| x.1);
                sum += factor.evaluate(&Point { symbol: &symbol, angle: &|_| f64::NAN }) * self.name(&actuator.name);
            }
        }
        sum
    }
}
