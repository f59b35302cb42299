//! Formulas as plain data for computer algebra in Python: sums of products, whose factors are names, roots, cosines and sines.

use dh_symbolic::Robot;
use dh_symbolic::algebra::{AngleVar, Factor, Poly, Rational, Symbol};
use dh_symbolic::chain::{Coordinate, Joint};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

/// Makes Python data of formulas of one robot. `dhkin/_sympy.py` reads it.
pub(crate) struct Export<'a, 'py> {
    pub(crate) robot: &'a Robot,
    pub(crate) py: Python<'py>,
}

impl<'py> Export<'_, 'py> {
    /// A sum: a list of `(coefficient, factors)`, the coefficient as the text of a fraction.
    pub(crate) fn sum(&self, p: &Poly) -> PyResult<Bound<'py, PyList>> {
        let list = PyList::empty(self.py);
        for (monomial, coefficient) in p.terms() {
            let factors = PyList::empty(self.py);
            for factor in monomial.factors() {
                factors.append(self.factor(&factor)?)?;
            }
            list.append((coefficient.to_string(), factors))?;
        }
        Ok(list)
    }

    fn factor(&self, factor: &Factor) -> PyResult<Bound<'py, PyTuple>> {
        match factor {
            Factor::Root(n) => ("root", u32::from(*n)).into_pyobject(self.py),
            Factor::Power(s, n) => ("power", self.length(*s)?, *n).into_pyobject(self.py),
            Factor::Cos(terms) => ("cos", self.angles(terms)?).into_pyobject(self.py),
            Factor::Sin(terms) => ("sin", self.angles(terms)?).into_pyobject(self.py),
        }
    }

    /// A length: the coordinate of a sliding joint, or a name.
    fn length(&self, s: Symbol) -> PyResult<Bound<'py, PyAny>> {
        let chain = self.robot.chain();
        match chain.joints.iter().position(|j| j.coordinate == Coordinate::Length(s)) {
            Some(joint) => self.coordinate(joint),
            None => self.name(chain.ring.symbol_name(s)),
        }
    }

    /// A sum of angles with whole factors.
    fn angles(&self, terms: &[(AngleVar, i8)]) -> PyResult<Bound<'py, PyList>> {
        let (chain, list) = (self.robot.chain(), PyList::empty(self.py));
        for (v, k) in terms {
            let angle = match chain.joints.iter().position(|j| j.coordinate == Coordinate::Angle(*v)) {
                Some(joint) => self.coordinate(joint)?,
                None => self.name(chain.ring.angle_name(*v))?,
            };
            list.append((i64::from(*k), angle))?;
        }
        Ok(list)
    }

    fn name(&self, name: &str) -> PyResult<Bound<'py, PyAny>> {
        Ok(("name", name).into_pyobject(self.py)?.into_any())
    }

    /// What a joint coordinate is: the drive's combination of joint variables, and the constant that formulas leave out.
    fn coordinate(&self, joint: usize) -> PyResult<Bound<'py, PyAny>> {
        let chain = self.robot.chain();
        let Joint { shift, .. } = &chain.joints[joint];
        if chain.is_direct() && shift.is_zero() {
            return self.name(&chain.joints[joint].name);
        }
        let driven = PyList::empty(self.py);
        for (factor, actuator) in chain.drive[joint].iter().zip(&chain.joints) {
            if !factor.is_zero() {
                driven.append((self.sum(factor)?, actuator.name.as_str()))?;
            }
        }
        let text = |x: &Option<Rational>| x.as_ref().map_or_else(|| "0".to_string(), ToString::to_string);
        let named: Vec<(i64, &str)> = shift
            .symbols
            .iter()
            .filter_map(|(p, k)| Some((i64::from(*k), chain.parameters.get(*p)?.name.as_str())))
            .collect();
        let all = ("driven", driven, text(&shift.half_turns), text(&shift.approx), named);
        Ok(all.into_pyobject(self.py)?.into_any())
    }
}
