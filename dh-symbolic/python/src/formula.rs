//! Exact formulas in Python: entries of transforms and Jacobians, matrices of them.

use dh_symbolic::{EvalError, Robot};
use numpy::PyArrayDyn;
use pyo3::exceptions::{PyIndexError, PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

use crate::arrays;
use crate::export::Export;

/// Values by name from keyword arguments.
pub(crate) fn values(given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, f64)>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    let one = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        let wrong = |_| PyTypeError::new_err(format!("{name}: expected a number, got {}", value.get_type()));
        Ok((name.clone(), value.extract::<f64>().map_err(wrong)?))
    };
    given.iter().map(one).collect()
}

/// The same as slices.
pub(crate) fn borrowed(values: &[(String, f64)]) -> Vec<(&str, f64)> {
    values.iter().map(|(name, x)| (name.as_str(), *x)).collect()
}

/// A name without a value, or one that the robot does not have.
fn no_number(error: &EvalError) -> PyErr {
    match error {
        EvalError::Unknown(_) => PyKeyError::new_err(error.to_string()),
        _ => PyValueError::new_err(error.to_string()),
    }
}

/// An exact formula of a robot. `==` decides whether two are equal for all values of their names.
#[pyclass(frozen, eq, str, module = "dhkin")]
pub(crate) struct Formula {
    robot: Robot,
    formula: dh_symbolic::Formula,
}

impl PartialEq for Formula {
    fn eq(&self, other: &Formula) -> bool {
        self.formula == other.formula
    }
}

impl std::fmt::Display for Formula {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.formula.fmt(f)
    }
}

impl Formula {
    fn with(&self, formula: dh_symbolic::Formula) -> Formula {
        Formula { robot: self.robot.clone(), formula }
    }

    fn same_robot(&self, other: &Formula) -> PyResult<()> {
        let same = self.robot.chain().ring == other.robot.chain().ring;
        if same { Ok(()) } else { Err(PyValueError::new_err("formulas of two robots")) }
    }
}

#[pymethods]
impl Formula {
    /// The derivative by a joint variable or by a length or angle of the table.
    fn diff(&self, name: &str) -> Formula {
        self.with(self.formula.diff(name))
    }

    /// The number, at values by name: `eval(q1=0.3)`; radians and the table's unit. Names that the table gives a value need none.
    #[pyo3(signature = (**values))]
    fn eval(&self, values: Option<&Bound<'_, PyDict>>) -> PyResult<f64> {
        self.formula.eval(&borrowed(&self::values(values)?)).map_err(|e| no_number(&e))
    }

    /// As LaTeX, without dollar signs.
    fn latex(&self) -> String {
        self.formula.latex()
    }

    /// As `check` reads it: `a2*c2`.
    fn plain(&self) -> String {
        self.formula.plain()
    }

    /// As a SymPy expression: joint variables and parameters are real symbols of their names.
    fn to_sympy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let data = Export { robot: &self.robot, py }.sum(self.formula.polynomial())?;
        py.import("dhkin._sympy")?.call_method1("expression", (data,))
    }

    /// Whether it is zero for all values of its names.
    fn is_zero(&self) -> bool {
        self.formula.is_zero()
    }

    fn _repr_latex_(&self) -> String {
        format!("${}$", self.formula.latex())
    }

    fn __repr__(&self) -> String {
        self.formula.to_string()
    }

    fn __neg__(&self) -> Formula {
        self.with(-&self.formula)
    }

    fn __add__(&self, other: &Formula) -> PyResult<Formula> {
        self.same_robot(other)?;
        Ok(self.with(&self.formula + &other.formula))
    }

    fn __sub__(&self, other: &Formula) -> PyResult<Formula> {
        self.same_robot(other)?;
        Ok(self.with(&self.formula - &other.formula))
    }

    fn __mul__(&self, other: &Formula) -> PyResult<Formula> {
        self.same_robot(other)?;
        Ok(self.with(&self.formula * &other.formula))
    }
}

/// A matrix of exact formulas of a robot.
#[pyclass(frozen, eq, str, module = "dhkin")]
pub(crate) struct Matrix {
    robot: Robot,
    matrix: dh_symbolic::Matrix,
}

impl PartialEq for Matrix {
    fn eq(&self, other: &Matrix) -> bool {
        self.matrix == other.matrix
    }
}

impl std::fmt::Display for Matrix {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.matrix.fmt(f)
    }
}

impl Matrix {
    pub(crate) fn new(robot: &Robot, matrix: dh_symbolic::Matrix) -> Matrix {
        Matrix { robot: robot.clone(), matrix }
    }
}

#[pymethods]
impl Matrix {
    /// Rows and columns.
    #[getter]
    fn shape(&self) -> (usize, usize) {
        (self.matrix.rows(), self.matrix.columns())
    }

    /// The entry in row `i` and column `j`, both from 0.
    fn entry(&self, i: usize, j: usize) -> PyResult<Formula> {
        let (rows, columns) = self.shape();
        let none = || PyIndexError::new_err(format!("there is no entry ({i}, {j}): the matrix is {rows}x{columns}"));
        let formula = self.matrix.get(i, j).ok_or_else(none)?;
        Ok(Formula { robot: self.robot.clone(), formula })
    }

    fn __getitem__(&self, index: (usize, usize)) -> PyResult<Formula> {
        self.entry(index.0, index.1)
    }

    /// Every entry differentiated by a joint variable or by a length or angle of the table.
    fn diff(&self, name: &str) -> Matrix {
        Matrix::new(&self.robot, self.matrix.diff(name))
    }

    /// The numbers as an array, at values by name: `eval(q1=0.3)`.
    #[pyo3(signature = (**values))]
    fn eval<'py>(&self, py: Python<'py>, values: Option<&Bound<'_, PyDict>>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let rows = self.matrix.eval(&borrowed(&self::values(values)?)).map_err(|e| no_number(&e))?;
        arrays::array(py, rows.concat(), Some(self.matrix.rows()), &[self.matrix.columns()])
    }

    /// Rows and columns exchanged.
    fn transpose(&self) -> Matrix {
        Matrix::new(&self.robot, self.matrix.transpose())
    }

    /// The determinant; None where the matrix is not square or the formula would be too long.
    fn determinant(&self, py: Python<'_>) -> Option<Formula> {
        let formula = py.detach(|| self.matrix.determinant())?;
        Some(Formula { robot: self.robot.clone(), formula })
    }

    /// As LaTeX, without dollar signs.
    fn latex(&self) -> String {
        self.matrix.latex()
    }

    /// As a SymPy matrix.
    fn to_sympy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (rows, columns) = self.shape();
        let mut data = Vec::with_capacity(rows);
        for i in 0..rows {
            let row = (0..columns).map(|j| {
                let entry = self.entry(i, j)?;
                Export { robot: &self.robot, py }.sum(entry.formula.polynomial())
            });
            data.push(row.collect::<PyResult<Vec<_>>>()?);
        }
        py.import("dhkin._sympy")?.call_method1("matrix", (data,))
    }

    fn _repr_latex_(&self) -> String {
        format!("$\\displaystyle {}$", self.matrix.latex())
    }

    fn __repr__(&self) -> String {
        self.matrix.to_string()
    }

    fn __matmul__(&self, other: &Matrix) -> PyResult<Matrix> {
        let ((_, columns), (rows, _)) = (self.shape(), other.shape());
        if columns != rows {
            return Err(PyValueError::new_err(format!("a product of {:?} and {:?}", self.shape(), other.shape())));
        }
        if self.robot.chain().ring != other.robot.chain().ring {
            return Err(PyValueError::new_err("matrices of two robots"));
        }
        Ok(Matrix::new(&self.robot, &self.matrix * &other.matrix))
    }
}
