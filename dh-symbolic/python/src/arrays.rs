//! NumPy arrays in and out, with what was expected where a shape or a type is wrong.

use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyAny;

/// Numbers of one item or of many.
pub(crate) struct Numbers {
    /// The numbers, item by item.
    pub(crate) list: Vec<f64>,
    /// How many items there are; `None` where the array is a single item.
    pub(crate) count: Option<usize>,
}

/// An array-like object of numbers as an array of doubles.
fn doubles<'py>(object: &Bound<'py, PyAny>, what: &str, expected: &str) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    if let Ok(array) = object.cast::<PyArrayDyn<f64>>() {
        return Ok(array.try_readonly()?);
    }
    let wrong_type = |given: String| PyTypeError::new_err(format!("{what}: expected {expected}, got {given}"));
    let numpy = object.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (object,)).map_err(|error| {
        PyValueError::new_err(format!("{what}: expected {expected}, got what NumPy makes no array of: {error}"))
    })?;
    let dtype = array.getattr("dtype")?;
    if !matches!(dtype.getattr("kind")?.extract::<String>()?.as_str(), "f" | "i" | "u") {
        return Err(wrong_type(format!("{} of type {dtype}", object.get_type().name()?)));
    }
    let array = array.call_method1("astype", ("float64",))?;
    Ok(array.cast::<PyArrayDyn<f64>>().map_err(|_| wrong_type(dtype.to_string()))?.try_readonly()?)
}

/// Items of one of some shapes, alone or many along the first axis. `expected` says these shapes: `an array of shape (6,) or (n, 6)`.
pub(crate) fn items(object: &Bound<'_, PyAny>, what: &str, shapes: &[&[usize]], expected: &str) -> PyResult<Numbers> {
    let array = doubles(object, what, expected)?;
    let shape = array.shape();
    let count = shapes.iter().find_map(|item| {
        if shape == *item {
            Some(None)
        } else {
            shape.split_first().filter(|(_, rest)| rest == item).map(|(n, _)| Some(*n))
        }
    });
    let Some(count) = count else {
        return Err(PyValueError::new_err(format!("{what}: expected {expected}, got shape {}", shown(shape))));
    };
    // A slice of an array in Fortran's order goes down the columns.
    let list = match array.as_slice() {
        Ok(slice) if array.is_c_contiguous() => slice.to_vec(),
        _ => array.as_array().iter().copied().collect(),
    };
    Ok(Numbers { list, count })
}

/// A shape as Python writes it.
fn shown(shape: &[usize]) -> String {
    match shape {
        [n] => format!("({n},)"),
        _ => format!("({})", shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// Numbers as an array of items of some shape: one, or as many as there are.
pub(crate) fn array<'py>(
    py: Python<'py>,
    list: Vec<f64>,
    count: Option<usize>,
    item: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let shape: Vec<usize> = count.into_iter().chain(item.iter().copied()).collect();
    numpy::PyArray1::from_vec(py, list).reshape(shape)
}
