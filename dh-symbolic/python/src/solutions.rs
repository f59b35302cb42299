//! Solutions of an inverse as Python objects: one solution, all of one target, all of many targets.

use std::sync::Arc;

use dh_dynamic::{Batch, DynamicArm};
use dh_robot::{Branch, FreeJoints, Why};
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyAny;

use crate::arrays;

/// Joint values that reach a target.
#[pyclass(frozen, module = "dhkin")]
pub(crate) struct Solution {
    arm: Arc<DynamicArm>,
    pub(crate) q: Vec<f64>,
    branch: Branch,
    free: FreeJoints,
}

impl Solution {
    pub(crate) fn new(arm: Arc<DynamicArm>, q: Vec<f64>, (branch, free): (Branch, FreeJoints)) -> Solution {
        Solution { arm, q, branch, free }
    }
}

/// The last word of a name of a branch: `left` of `shoulder left`.
fn word(name: Option<String>, part: &str) -> Option<String> {
    name.map(|name| name.trim_start_matches(part).trim().to_string())
}

#[pymethods]
impl Solution {
    /// The joint values: radians, or the table's unit of length for sliding joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        arrays::array(py, self.q.clone(), None, &[self.q.len()])
    }

    /// Which alternatives were taken, in words: `shoulder right, elbow up, wrist flip`.
    #[getter]
    fn branch(&self) -> String {
        self.branch.to_string()
    }

    /// `left` or `right`; None on arms without this choice.
    #[getter]
    fn shoulder(&self) -> Option<String> {
        word(self.branch.shoulder().map(|x| x.to_string()), "shoulder")
    }

    /// `up` or `down`; None on arms without this choice.
    #[getter]
    fn elbow(&self) -> Option<String> {
        word(self.branch.elbow().map(|x| x.to_string()), "elbow")
    }

    /// `no flip` or `flip`; None on arms without this choice.
    #[getter]
    fn wrist(&self) -> Option<String> {
        word(self.branch.wrist().map(|x| x.to_string()), "wrist")
    }

    /// Names of the joints that are free at this pose, which is singular then; empty at a regular pose.
    #[getter]
    fn free(&self) -> Vec<&'static str> {
        let names = self.arm.joints().iter().enumerate();
        names.filter(|(i, _)| self.free.contains(*i)).map(|(_, joint)| joint.name).collect()
    }

    /// Whether every joint is in its range.
    #[getter]
    fn within_range(&self) -> bool {
        inside(&self.arm, &self.q)
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        &self,
        py: Python<'py>,
        dtype: Option<Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let _ = copy; // it is a copy in any case
        let array = self.q(py)?.into_any();
        match dtype {
            Some(dtype) => array.call_method1("astype", (dtype,)),
            None => Ok(array),
        }
    }

    fn __len__(&self) -> usize {
        self.q.len()
    }

    fn __getitem__(&self, index: isize) -> PyResult<f64> {
        Ok(self.q[place(index, self.q.len())?])
    }

    fn __repr__(&self) -> String {
        let numbers: Vec<String> = self.q.iter().map(|x| format!("{x:.4}")).collect();
        let free = if self.free.is_empty() { String::new() } else { format!("; {} free", self.free) };
        format!("Solution([{}], {}{free})", numbers.join(", "), self.branch)
    }
}

/// Whether joint values are in their ranges.
fn inside(arm: &DynamicArm, q: &[f64]) -> bool {
    arm.joints().iter().zip(q).all(|(joint, x)| joint.contains(*x))
}

/// An index as Python counts: negative ones from the end.
fn place(index: isize, length: usize) -> PyResult<usize> {
    let from_end = if index < 0 { index + length as isize } else { index };
    usize::try_from(from_end)
        .ok()
        .filter(|i| *i < length)
        .ok_or_else(|| PyIndexError::new_err(format!("index {index} of {length}")))
}

/// Every solution of a target, each once: a sequence of `Solution`.
#[pyclass(frozen, sequence, module = "dhkin")]
pub(crate) struct Solutions {
    arm: Arc<DynamicArm>,
    /// Solution by solution.
    q: Vec<f64>,
    names: Vec<(Branch, FreeJoints)>,
    why: Why,
}

impl Solutions {
    pub(crate) fn new(arm: Arc<DynamicArm>, q: Vec<f64>, names: Vec<(Branch, FreeJoints)>, why: Why) -> Solutions {
        Solutions { arm, q, names, why }
    }

    fn each(&self) -> impl Iterator<Item = &[f64]> {
        self.q.chunks(self.arm.dof().max(1))
    }

    fn at(&self, i: usize) -> Solution {
        let n = self.arm.dof();
        Solution::new(self.arm.clone(), self.q[i * n..(i + 1) * n].to_vec(), self.names[i])
    }

    /// The solution with the least sum of squares of some differences from `q`, and its joint values.
    fn nearest(&self, q: &[f64], value: impl Fn(usize, f64) -> (f64, f64)) -> Option<Solution> {
        let mut best: Option<(f64, usize, Vec<f64>)> = None;
        for (i, solution) in self.each().enumerate() {
            let (mut sum, mut values) = (0.0, Vec::with_capacity(q.len()));
            for (k, x) in solution.iter().enumerate() {
                let (shifted, difference) = value(k, *x);
                values.push(shifted);
                sum += difference * difference;
            }
            if sum.is_finite() && best.as_ref().is_none_or(|(least, ..)| sum < *least) {
                best = Some((sum, i, values));
            }
        }
        best.map(|(_, i, values)| Solution::new(self.arm.clone(), values, self.names[i]))
    }

    fn joints_at(&self, q: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        crate::inputs::joint_values(&self.arm, q, false).map(|numbers| numbers.list)
    }
}

#[pymethods]
impl Solutions {
    /// The joint values, a row per solution.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        arrays::array(py, self.q.clone(), Some(self.names.len()), &[self.arm.dof()])
    }

    /// `solved`, or the reason why there is no solution: `elbow q3: distance 1.253 m exceeds 0.877 m`.
    #[getter]
    fn why(&self) -> String {
        self.why.to_string()
    }

    /// The solutions that keep every joint in its range.
    fn within_range(&self) -> Solutions {
        let kept: Vec<usize> = self.each().enumerate().filter(|(_, q)| inside(&self.arm, q)).map(|(i, _)| i).collect();
        let n = self.arm.dof();
        let why = match (kept.is_empty(), self.names.len()) {
            (true, solutions) if solutions > 0 => Why::OutOfRange { solutions },
            _ => self.why,
        };
        Solutions {
            arm: self.arm.clone(),
            q: kept.iter().flat_map(|i| &self.q[i * n..(i + 1) * n]).copied().collect(),
            names: kept.iter().map(|i| self.names[*i]).collect(),
            why,
        }
    }

    /// The solution nearest to `q`, whole turns apart; None if there is none.
    fn closest_to(&self, q: &Bound<'_, PyAny>) -> PyResult<Option<Solution>> {
        let (q, joints) = (self.joints_at(q)?, self.arm.joints());
        Ok(self.nearest(&q, |k, x| (x, joints[k].difference(x, q[k]))))
    }

    /// The solution that needs the least movement from `q`, with every angle shifted by the whole turns that bring it nearest to `q` within
    /// the joint's range; None if there is none.
    fn toward(&self, q: &Bound<'_, PyAny>) -> PyResult<Option<Solution>> {
        let (q, joints) = (self.joints_at(q)?, self.arm.joints());
        Ok(self.nearest(&q, |k, x| {
            let shifted = joints[k].nearest_to(q[k], x);
            (shifted, shifted - q[k])
        }))
    }

    fn __len__(&self) -> usize {
        self.names.len()
    }

    fn __bool__(&self) -> bool {
        !self.names.is_empty()
    }

    fn __getitem__(&self, index: isize) -> PyResult<Solution> {
        Ok(self.at(place(index, self.names.len())?))
    }

    fn __repr__(&self) -> String {
        if self.names.is_empty() {
            return format!("Solutions(none: {})", self.why);
        }
        let lines: Vec<String> = (0..self.names.len()).map(|i| format!("  {}", self.at(i).__repr__())).collect();
        format!("Solutions(\n{}\n)", lines.join(",\n"))
    }
}

/// Solutions of many targets: a sequence of `Solutions`, and all joint values as one array.
#[pyclass(frozen, sequence, module = "dhkin")]
pub(crate) struct BatchSolutions {
    arm: Arc<DynamicArm>,
    /// Joint values, target by target, not a number where there is no solution.
    q: Py<PyArrayDyn<f64>>,
    count: Vec<u8>,
    names: Vec<(Branch, FreeJoints)>,
    refused: Vec<(usize, Why)>,
    most: usize,
}

impl BatchSolutions {
    /// `single`: one solution per target, whose joint values are an array (n, dof).
    pub(crate) fn new(py: Python<'_>, arm: Arc<DynamicArm>, batch: Batch, single: bool) -> PyResult<BatchSolutions> {
        let (n, dof) = (batch.count.len(), arm.dof());
        let item: &[usize] = if single { &[dof] } else { &[batch.most, dof] };
        let q = arrays::array(py, batch.q, Some(n), item)?.unbind();
        Ok(BatchSolutions { arm, q, count: batch.count, names: batch.names, refused: batch.refused, most: batch.most })
    }

    fn why_of(&self, i: usize) -> Why {
        let place = self.refused.binary_search_by_key(&i, |r| r.0);
        place.map_or(Why::Solved, |k| self.refused[k].1)
    }
}

#[pymethods]
impl BatchSolutions {
    /// The joint values: an array (n, max_solutions, dof), or (n, dof) of `inverse_near`; not a number beyond the solutions that there are.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.q.bind(py).clone()
    }

    /// The number of solutions of each target.
    #[getter]
    fn count<'py>(&self, py: Python<'py>) -> Bound<'py, numpy::PyArray1<u8>> {
        numpy::PyArray1::from_slice(py, &self.count)
    }

    /// The reasons of the targets without a solution, by their number.
    #[getter]
    fn why(&self) -> std::collections::BTreeMap<usize, String> {
        self.refused.iter().map(|(i, why)| (*i, why.to_string())).collect()
    }

    fn __len__(&self) -> usize {
        self.count.len()
    }

    fn __getitem__(&self, py: Python<'_>, index: isize) -> PyResult<Solutions> {
        let i = place(index, self.count.len())?;
        let (n, first) = (self.arm.dof(), i * self.most);
        let count = usize::from(self.count[i]);
        let q = self.q.bind(py).try_readonly()?;
        let q = q.as_slice().map(|q| q[first * n..(first + count) * n].to_vec()).unwrap_or_default();
        Ok(Solutions::new(self.arm.clone(), q, self.names[first..first + count].to_vec(), self.why_of(i)))
    }

    fn __repr__(&self) -> String {
        let (n, without) = (self.count.len(), self.refused.len());
        let all: usize = self.count.iter().map(|k| usize::from(*k)).sum();
        format!("BatchSolutions({n} targets, {all} solutions, {without} targets without one)")
    }
}
