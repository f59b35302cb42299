//! The class `Robot`: an arm from the text of its table, or from a URDF.

use std::sync::{Arc, Mutex, PoisonError};

use dh_dynamic::DynamicArm;
use dh_robot::Why;
use dh_symbolic::import;
use dh_symbolic::{Format, NotesOptions, Robot as Table};
use numpy::PyArrayDyn;
use pyo3::exceptions::{PyAttributeError, PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

use crate::arrays;
use crate::errors;
use crate::formula::{Matrix, borrowed, values};
use crate::inputs::{Given, Targets, joint_values};
use crate::page::{Notes, Page, Plan};
use crate::solutions::{BatchSolutions, Solution, Solutions};

/// A joint variable: its name in the table, what the table calls its row, its kind and its range.
#[pyclass(frozen, module = "dhkin")]
pub(crate) struct Joint(dh_robot::Joint);

#[pymethods]
impl Joint {
    /// The variable's name: `q3`.
    #[getter]
    fn name(&self) -> &'static str {
        self.0.name
    }

    /// What column `joint` of the table calls the row, where that is not its number.
    #[getter]
    fn label(&self) -> &'static str {
        self.0.label
    }

    /// `revolute` or `prismatic`.
    #[getter]
    fn kind(&self) -> &'static str {
        if self.0.is_revolute() { "revolute" } else { "prismatic" }
    }

    /// Least and greatest value, in radians or in the table's unit of length; None where the table gives none.
    #[getter]
    fn range(&self) -> Option<(f64, f64)> {
        self.0.range
    }

    fn __repr__(&self) -> String {
        let range = self.0.range.map_or(String::new(), |(least, greatest)| format!(", {least:.4}..={greatest:.4}"));
        format!("Joint({}, {}{range})", self.0.name, self.kind())
    }
}

/// An arm from its Denavit-Hartenberg table.
///
/// `table` is what stands between the braces of `dh_robot!`, in a string. Lengths and angles that the table declares are keyword arguments and
/// attributes: `Robot(table, a2=0.5).a2`. Joint values are arrays of shape (dof,) or, for many at once, (n, dof); poses are 4x4 matrices or
/// arrays (n, 4, 4). Many at once are computed on all cores, without Python's lock; one that is not finite spoils its own result only.
#[pyclass(frozen, module = "dhkin")]
pub(crate) struct Robot {
    table: Table,
    text: String,
    /// The arm with its present parameters.
    arm: Mutex<Arc<DynamicArm>>,
}

/// Where a URDF starts and ends: `base..tip`.
fn chain_of(chain: &str) -> PyResult<[Option<String>; 2]> {
    let (base, tip) = chain
        .split_once("..")
        .ok_or_else(|| PyValueError::new_err(format!("chain: expected `base_link..tool0`, got `{chain}`")))?;
    Ok([base, tip].map(|link| Some(link.trim().to_string()).filter(|link| !link.is_empty())))
}

impl Robot {
    fn make(py: Python<'_>, text: &str, file: &str, parameters: &[(String, f64)]) -> PyResult<Robot> {
        let made = py.detach(|| {
            let table = Table::parse_file(file, text)?;
            let arm = DynamicArm::new(&table)?;
            Ok((table, arm))
        });
        let (table, arm) = made.map_err(|error| errors::table(py, &error))?;
        let arm = Robot::changed(&arm, parameters)?;
        Ok(Robot { table, text: text.to_string(), arm: Mutex::new(Arc::new(arm)) })
    }

    fn changed(arm: &DynamicArm, parameters: &[(String, f64)]) -> PyResult<DynamicArm> {
        let unknown = |name: &str| {
            let names: Vec<&str> = arm.parameters().map(|p| p.name).collect();
            let known = if names.is_empty() { "none".to_string() } else { names.join(", ") };
            PyTypeError::new_err(format!("the table declares no `{name}`; its parameters: {known}"))
        };
        arm.with_parameters(&borrowed(parameters)).map_err(unknown)
    }

    /// The arm as it is now.
    fn now(&self) -> Arc<DynamicArm> {
        self.arm.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The same, if all its parameters have values.
    fn ready(&self) -> PyResult<Arc<DynamicArm>> {
        let arm = self.now();
        let missing: Vec<&str> = arm.parameters().filter(|p| p.value.is_nan()).map(|p| p.name).collect();
        if missing.is_empty() {
            return Ok(arm);
        }
        let names = missing.join(", ");
        Err(PyValueError::new_err(format!(
            "no value for {names}: the table gives none, so set it: arm.{} = ..",
            missing[0]
        )))
    }

    /// The same, if it has an inverse.
    fn invertible(&self, py: Python<'_>) -> PyResult<Arc<DynamicArm>> {
        let arm = self.ready()?;
        if arm.has_inverse() {
            return Ok(arm);
        }
        Err(match arm.refusal() {
            Some(error) => errors::table(py, error),
            None if arm.max_solutions() > 0 => {
                PyValueError::new_err("the inverse of arms of more than 10 joints is not interpreted")
            }
            None => PyValueError::new_err("the table asks for no inverse: ik = none"),
        })
    }

    fn straight<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        item: impl Fn(usize) -> Vec<usize>,
        run: impl Fn(&DynamicArm, &[f64], &mut [f64]) + Send + Sync,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let arm = self.ready()?;
        let q = joint_values(&arm, q, true)?;
        let item = item(arm.dof());
        let mut out = vec![0.0; item.iter().product::<usize>() * q.count.unwrap_or(1)];
        match q.count {
            None => run(&arm, &q.list, &mut out),
            Some(_) => py.detach(|| run(&arm, &q.list, &mut out)),
        }
        arrays::array(py, out, q.count, &item)
    }
}

#[pymethods]
impl Robot {
    #[new]
    #[pyo3(signature = (table, /, **parameters))]
    fn new(py: Python<'_>, table: &str, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Robot> {
        Robot::make(py, table, "table", &values(parameters)?)
    }

    /// An arm from a URDF: its text, or the path of a file. `chain` names its ends (`base_link..tool0`); it may be left out where there is
    /// only one.
    #[staticmethod]
    #[pyo3(signature = (source, *, chain=None, convention=None, name=None))]
    fn from_urdf(
        py: Python<'_>,
        source: &Bound<'_, PyAny>,
        chain: Option<&str>,
        convention: Option<&str>,
        name: Option<String>,
    ) -> PyResult<Robot> {
        let (text, file) = match source.extract::<String>() {
            Ok(text) if text.contains('<') => (text, "urdf".to_string()),
            _ => {
                let path: std::path::PathBuf = source.extract().map_err(|_| {
                    let given = source.get_type();
                    PyTypeError::new_err(format!("source: expected the text of a URDF or a path, got {given}"))
                })?;
                (std::fs::read_to_string(&path)?, path.display().to_string())
            }
        };
        let convention = match convention {
            None => None,
            Some("standard") => Some(dh_symbolic::chain::Convention::Standard),
            Some("modified") => Some(dh_symbolic::chain::Convention::Modified),
            Some(other) => {
                return Err(PyValueError::new_err(format!(
                    "convention: expected `standard` or `modified`, got `{other}`"
                )));
            }
        };
        let [base, tip] = chain.map_or(Ok([None, None]), chain_of)?;
        let options = import::Options { base, tip, convention, name, ..import::Options::default() };
        let imported = py.detach(|| import::from_urdf(&text, &options));
        let imported = imported.map_err(|problem| errors::imported(py, &problem, &text, &file))?;
        Robot::make(py, &imported.table, "imported table", &[])
    }

    /// The text of the table.
    #[getter]
    fn table(&self) -> &str {
        &self.text
    }

    /// The robot's name in the table.
    #[getter]
    fn name(&self) -> &str {
        self.table.name()
    }

    /// How many joint variables there are.
    #[getter]
    fn dof(&self) -> usize {
        self.now().dof()
    }

    /// How many rows the table has: frames count from 0 to this.
    #[getter]
    fn rows(&self) -> usize {
        self.table.rows()
    }

    /// Name, kind and range of every joint variable.
    #[getter]
    fn joints(&self) -> Vec<Joint> {
        self.now().joints().iter().map(|joint| Joint(*joint)).collect()
    }

    /// What the inverse is asked for: `pose`, `position`, `planar` or `axis`.
    #[getter]
    fn task(&self) -> &'static str {
        self.now().task()
    }

    /// The unit of all lengths.
    #[getter]
    fn unit(&self) -> &'static str {
        self.now().unit()
    }

    /// The names of the joints whose values the caller of the inverse gives.
    #[getter]
    fn redundant(&self) -> Vec<&'static str> {
        let arm = self.now();
        arm.redundant().iter().filter_map(|k| arm.joints().get(*k)).map(|joint| joint.name).collect()
    }

    /// The most solutions that a target can have; 0 where there is no inverse.
    #[getter]
    fn max_solutions(&self) -> usize {
        self.now().max_solutions()
    }

    /// The ranges of the joints, an array (dof, 2); infinite where the table gives none.
    #[getter]
    fn ranges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let arm = self.now();
        let range = |joint: &dh_robot::Joint| joint.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let list = arm.joints().iter().map(range).flat_map(|(least, greatest)| [least, greatest]).collect();
        arrays::array(py, list, Some(arm.dof()), &[2])
    }

    /// The lengths and angles that the table declares, with their present values; None where there is no value yet.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for p in self.now().parameters() {
            all.set_item(p.name, Some(p.value).filter(|x| !x.is_nan()))?;
        }
        Ok(all)
    }

    /// The same robot with other values of parameters; this one stays as it is.
    #[pyo3(signature = (**parameters))]
    fn with_parameters(&self, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Robot> {
        let arm = Robot::changed(&self.now(), &values(parameters)?)?;
        Ok(Robot { table: self.table.clone(), text: self.text.clone(), arm: Mutex::new(Arc::new(arm)) })
    }

    fn __getattr__(&self, name: &str) -> PyResult<f64> {
        let arm = self.now();
        let value = arm.parameters().find(|p| p.name == name).map(|p| p.value);
        value.ok_or_else(|| PyAttributeError::new_err(format!("the robot has no attribute or parameter `{name}`")))
    }

    fn __setattr__(&self, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        if !self.now().parameters().any(|p| p.name == name) {
            return Err(PyAttributeError::new_err(format!("the table declares no parameter `{name}`")));
        }
        let wrong = |_| PyTypeError::new_err(format!("{name}: expected a number, got {}", value.get_type()));
        let value: f64 = value.extract().map_err(wrong)?;
        // Only now, since a number of Python's may run code that uses the robot.
        let mut arm = self.arm.lock().unwrap_or_else(PoisonError::into_inner);
        *arm = Arc::new(Robot::changed(&arm, &[(name.to_string(), value)])?);
        Ok(())
    }

    fn __dir__<'py>(this: &Bound<'py, Self>) -> PyResult<Vec<String>> {
        let class: Vec<String> = this.get_type().dir()?.extract()?;
        Ok(class.into_iter().chain(this.get().now().parameters().map(|p| p.name.to_string())).collect())
    }

    /// The pose of the last frame, or of the tool, in the base: (4, 4), or (n, 4, 4) of many joint vectors.
    #[pyo3(signature = (q, *, threads=None))]
    fn forward<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.straight(py, q, |_| vec![4, 4], |arm, q, out| arm.forward_batch(q, out, threads))
    }

    /// The pose of every joint's link frame in the base: (dof, 4, 4), or (n, dof, 4, 4).
    #[pyo3(signature = (q, *, threads=None))]
    fn frames<'py>(
        &self,
        py: Python<'py>,
        q: &Bound<'_, PyAny>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.straight(py, q, |n| vec![n, 4, 4], |arm, q, out| arm.frames_batch(q, out, threads))
    }

    /// The geometric Jacobian: (6, dof), or (n, 6, dof). Rows 0..3 are linear, 3..6 angular velocities per joint speed, in base axes, at the
    /// origin of the last frame (or tool). `jacobian()` without joint values is the matrix of formulas.
    #[pyo3(signature = (q=None, *, threads=None))]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        q: Option<&Bound<'_, PyAny>>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Some(q) = q else {
            return Ok(Matrix::new(&self.table, self.table.jacobian()).into_pyobject(py)?.into_any());
        };
        let array = self.straight(py, q, |n| vec![6, n], |arm, q, out| arm.jacobian_batch(q, out, threads));
        Ok(array?.into_any())
    }

    /// All solutions for a target, each verified by forward kinematics: `Solutions`, or `BatchSolutions` of many targets.
    ///
    /// A target is a pose (4, 4), or what the task asks for: position (3,); x, y and angle (3,); position and direction of the z axis (6,).
    /// `given` are the values of the joints that the table leaves to the caller.
    #[pyo3(signature = (target, given=None, *, threads=None))]
    fn inverse<'py>(
        &self,
        py: Python<'py>,
        target: &Bound<'_, PyAny>,
        given: Option<&Bound<'_, PyAny>>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let arm = self.invertible(py)?;
        let targets = Targets::read(&arm, target)?;
        let given = Given::read(&arm, given, &targets)?;
        if targets.numbers.count.is_none() {
            let (mut q, mut names) = (Vec::with_capacity(8 * arm.dof()), Vec::with_capacity(8));
            let why = arm.solutions(&targets.get(&arm, 0), given.of(0), &mut |solution| {
                q.extend_from_slice(solution.q);
                names.push((solution.branch, solution.free));
            });
            return Ok(Solutions::new(arm, q, names, why).into_pyobject(py)?.into_any());
        }
        let one = |i: usize| (targets.get(&arm, i), given.of(i));
        let batch = py.detach(|| arm.inverse_batch(targets.count(), one, threads));
        Ok(BatchSolutions::new(py, arm, batch, false)?.into_pyobject(py)?.into_any())
    }

    /// The solution that continues from the joint values `q`: the one of least travel, and on a self-motion (at a singular pose) the point of
    /// it nearest to `q`. Angles are shifted by whole turns towards `q`, within the ranges where that is possible.
    ///
    /// A target without a solution raises `Unreachable`; of many targets (with one `q` for all or one for each) it is told in the result.
    #[pyo3(signature = (target, q, given=None, *, threads=None))]
    fn inverse_near<'py>(
        &self,
        py: Python<'py>,
        target: &Bound<'_, PyAny>,
        q: &Bound<'_, PyAny>,
        given: Option<&Bound<'_, PyAny>>,
        threads: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let arm = self.invertible(py)?;
        let targets = Targets::read(&arm, target)?;
        let given = Given::read(&arm, given, &targets)?;
        let from = joint_values(&arm, q, targets.numbers.count.is_some())?;
        if targets.numbers.count.is_none() {
            let mut q = from.list;
            let found = arm.inverse_near(&targets.get(&arm, 0), given.of(0), &mut q);
            let names = found.map_err(|why: Why| errors::unreachable(&why))?;
            return Ok(Solution::new(arm, q, names).into_pyobject(py)?.into_any());
        }
        let (n, dof) = (targets.count(), arm.dof());
        if from.count.is_some_and(|count| count != n) {
            return Err(PyValueError::new_err(format!(
                "q: expected an array of shape ({dof},) or ({n}, {dof}), one row for each target"
            )));
        }
        let start = |i: usize| if from.count.is_some() { i * dof } else { 0 };
        let one = |i: usize| (targets.get(&arm, i), given.of(i), &from.list[start(i)..start(i) + dof]);
        let batch = py.detach(|| arm.inverse_near_batch(n, one, threads));
        Ok(BatchSolutions::new(py, arm, batch, true)?.into_pyobject(py)?.into_any())
    }

    /// Whether joint values are in their ranges: a bool, or an array of them of many joint vectors.
    fn within_range<'py>(&self, py: Python<'py>, q: &Bound<'_, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let arm = self.now();
        let q = joint_values(&arm, q, true)?;
        let inside = |q: &[f64]| arm.joints().iter().zip(q).all(|(joint, x)| joint.contains(*x));
        let all: Vec<bool> = q.list.chunks(arm.dof().max(1)).map(inside).collect();
        match q.count {
            Some(_) => Ok(numpy::PyArray1::from_vec(py, all).into_any()),
            None => Ok(pyo3::types::PyBool::new(py, all.first() == Some(&true)).to_owned().into_any()),
        }
    }

    /// T(i, j), exact: frame `j` seen from frame `i`, without base and tool.
    fn transform(&self, i: usize, j: usize) -> PyResult<Matrix> {
        let last = self.table.rows();
        let none = || PyIndexError::new_err(format!("there is no T({i}, {j}): the last frame is {last}"));
        Ok(Matrix::new(&self.table, self.table.get_transform(i, j).ok_or_else(none)?))
    }

    /// The pose of the tool in the base, exact: base T(0, n) tool.
    fn pose(&self) -> Matrix {
        Matrix::new(&self.table, self.table.pose())
    }

    /// Checks lines of a hand derivation, separated by `;`: `T(1,3).px = a2*c2`. Also an equation of SymPy, in the symbols that `to_sympy`
    /// makes. A wrong line raises `TableError`, with the difference.
    fn check(&self, py: Python<'_>, claims: &Bound<'_, PyAny>) -> PyResult<()> {
        let claims: String = match claims.extract() {
            Ok(text) => text,
            Err(_) => py.import("dhkin._sympy")?.call_method1("claim", (claims,))?.extract()?,
        };
        py.detach(|| self.table.check(&claims)).map_err(|error| errors::table(py, &error))
    }

    /// How the arm is inverted, step by step; raises `TableError` where there is no closed form, with the reason.
    fn plan(&self, py: Python<'_>) -> PyResult<Plan> {
        let plan = py.detach(|| self.table.plan()).map_err(|error| errors::table(py, &error))?;
        Ok(Plan { plan })
    }

    /// A lecture note: `format` is `markdown`, `latex`, `typst`, `html` or `text`. Keyword arguments are the options of `dh notes`:
    /// `notes("latex", lang="zh", parts="table,links,inverse", at="q1 = 20deg")`.
    #[pyo3(signature = (format="markdown", **options))]
    fn notes(&self, py: Python<'_>, format: &str, options: Option<&Bound<'_, PyDict>>) -> PyResult<Notes> {
        let Some((_, format)) = Format::ALL.iter().find(|f| f.0 == format) else {
            let names: Vec<&str> = Format::ALL.iter().map(|f| f.0).collect();
            return Err(PyValueError::new_err(format!("format: expected one of {}, got `{format}`", names.join(", "))));
        };
        let options = self.options(options)?;
        let text = py.detach(|| self.table.notes(&options).print(*format));
        Ok(Notes { text, format: *format })
    }

    /// An interactive page of the arm, which a notebook shows in place: sliders, the drawn arm, its pose, its formulas, all solutions.
    #[pyo3(signature = (*, height=700, **options))]
    fn page(&self, py: Python<'_>, height: u32, options: Option<&Bound<'_, PyDict>>) -> PyResult<Page> {
        let options = self.options(options)?;
        let html = py.detach(|| self.table.page(&options)).map_err(|error| errors::table(py, &error))?;
        Ok(Page { html, height })
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let py = this.py();
        let robot = this.get();
        let given = PyDict::new(py);
        for p in robot.now().parameters().filter(|p| !p.value.is_nan()) {
            given.set_item(p.name, p.value)?;
        }
        let rebuild = py.import("dhkin._pickle")?.getattr("rebuild")?;
        Ok((rebuild, (robot.text.as_str(), given).into_pyobject(py)?.into_any()))
    }

    fn __repr__(&self) -> String {
        let arm = self.now();
        format!("Robot({}, {} joints, task = {})", self.name(), arm.dof(), arm.task())
    }
}

impl Robot {
    /// Options of notes and pages from keyword arguments.
    fn options(&self, given: Option<&Bound<'_, PyDict>>) -> PyResult<NotesOptions> {
        let mut options = NotesOptions::default();
        for (name, value) in given.into_iter().flatten() {
            let (name, value) = (format!("--{}", name.extract::<String>()?), value.str()?.to_string());
            if !options.set(&name, &value).map_err(PyValueError::new_err)? {
                let known: Vec<&str> = NotesOptions::NAMES.iter().map(|n| n.trim_start_matches('-')).collect();
                let name = name.trim_start_matches('-');
                return Err(PyTypeError::new_err(format!("no option `{name}`; there are {}", known.join(", "))));
            }
        }
        self.table.check_options(&options).map_err(PyValueError::new_err)?;
        Ok(options)
    }
}
