//! What callers hand over: joint values, targets, values of the joints that they choose; each with what was expected where it is wrong.

use dh_dynamic::{DynamicArm, Target};
use dh_robot::pose::from_entries;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyAny;

use crate::arrays::{Numbers, items};

/// Joint values: one vector or, if `many`, several.
pub(crate) fn joint_values(arm: &DynamicArm, q: &Bound<'_, PyAny>, many: bool) -> PyResult<Numbers> {
    let n = arm.dof();
    let expected =
        if many { format!("an array of shape ({n},) or (n, {n})") } else { format!("an array of shape ({n},)") };
    let numbers = items(q, "q", &[&[n]], &expected)?;
    match numbers.count {
        Some(count) if !many => Err(PyValueError::new_err(format!("q: expected {expected}, got shape ({count}, {n})"))),
        _ => Ok(numbers),
    }
}

/// The targets of an inverse: what the arm's task asks for, or poses.
pub(crate) struct Targets {
    pub(crate) numbers: Numbers,
    /// Numbers of each target: 16 of a pose.
    size: usize,
}

impl Targets {
    pub(crate) fn read(arm: &DynamicArm, object: &Bound<'_, PyAny>) -> PyResult<Targets> {
        let (short, what): (&[usize], &str) = match arm.task() {
            "position" => (&[3], "positions of shape (3,) or (n, 3), or poses of shape (4, 4) or (n, 4, 4)"),
            "planar" => (&[3], "x, y and angle of shape (3,) or (n, 3), or poses of shape (4, 4) or (n, 4, 4)"),
            "axis" => (&[6], "position and direction of shape (6,) or (n, 6), or poses of shape (4, 4) or (n, 4, 4)"),
            _ => (&[4, 4], "a pose of shape (4, 4), or poses of shape (n, 4, 4)"),
        };
        let numbers = items(object, "target", &[&[4, 4], short], what)?;
        let size = numbers.list.len() / numbers.count.unwrap_or(1).max(1);
        for (i, pose) in numbers.list.chunks(16).enumerate().filter(|_| size == 16) {
            let last = &pose[12..];
            let off = last.iter().zip([0.0, 0.0, 0.0, 1.0]).any(|(x, wanted)| (x - wanted).abs() > 1e-9);
            if off {
                let which = numbers.count.map_or(String::new(), |_| format!(" of pose {i}"));
                return Err(PyValueError::new_err(format!(
                    "target: expected the last row{which} to be 0, 0, 0, 1, got {last:?}; is the matrix transposed?"
                )));
            }
        }
        Ok(Targets { numbers, size })
    }

    pub(crate) fn count(&self) -> usize {
        self.numbers.count.unwrap_or(1)
    }

    pub(crate) fn get(&self, arm: &DynamicArm, i: usize) -> Target {
        let x = &self.numbers.list[i * self.size..(i + 1) * self.size];
        match *x {
            [a, b, c] if arm.task() == "planar" => Target::Planar(a, b, c),
            [a, b, c] => Target::Position([a, b, c]),
            [a, b, c, u, v, w] => Target::Axis([a, b, c], [u, v, w]),
            _ => {
                let entry = |i: usize, j: usize| x[4 * i + j];
                let rows = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
                arm.target(&from_entries(rows, std::array::from_fn(|i| entry(i, 3))))
            }
        }
    }
}

/// Values of the joints that the caller of the inverse chooses: the same for all targets, or a row for each.
pub(crate) struct Given {
    list: Vec<f64>,
    size: usize,
    each: bool,
}

impl Given {
    pub(crate) fn read(arm: &DynamicArm, object: Option<&Bound<'_, PyAny>>, targets: &Targets) -> PyResult<Given> {
        let names: Vec<&str> = arm.redundant().iter().filter_map(|k| arm.joints().get(*k)).map(|j| j.name).collect();
        let (size, names) = (names.len(), names.join(", "));
        let Some(object) = object else {
            return match size {
                0 => Ok(Given { list: Vec::new(), size, each: false }),
                _ => {
                    Err(PyTypeError::new_err(format!("given: the table leaves {names} to the caller: expected given=")))
                }
            };
        };
        if size == 0 {
            return Err(PyTypeError::new_err("given: the table leaves no joint to the caller"));
        }
        let expected = format!("values of {names}: shape ({size},), or (n, {size}) with one row for each target");
        let scalar = object.extract::<f64>().ok().filter(|_| size == 1);
        let numbers = match scalar {
            Some(x) => Numbers { list: vec![x], count: None },
            None => items(object, "given", &[&[size]], &expected)?,
        };
        if numbers.count.is_some_and(|count| targets.numbers.count != Some(count)) {
            return Err(PyValueError::new_err(format!("given: expected {expected}")));
        }
        Ok(Given { list: numbers.list, size, each: numbers.count.is_some() })
    }

    pub(crate) fn of(&self, i: usize) -> &[f64] {
        let first = if self.each { i * self.size } else { 0 };
        &self.list[first..first + self.size]
    }
}
