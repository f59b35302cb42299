//! Python's door to the kinematics of a Denavit-Hartenberg table: numbers through `dh-dynamic`, formulas and documents through `dh-symbolic`.
//!
//! Here is nothing but the border: arrays in and out, errors as Python's, classes over what the two crates give. Long work is done without
//! holding Python's lock.

mod arrays;
mod errors;
mod export;
mod formula;
mod inputs;
mod page;
mod robot;
mod solutions;

use pyo3::prelude::*;

/// Robot kinematics from Denavit-Hartenberg tables. The package `dhkin` re-exports all that is here.
#[pymodule]
mod _dhkin {
    #[pymodule_export]
    use crate::errors::{TableError, Unreachable};
    #[pymodule_export]
    use crate::formula::{Formula, Matrix};
    #[pymodule_export]
    use crate::page::{Notes, Page, Plan};
    #[pymodule_export]
    use crate::robot::{Joint, Robot};
    #[pymodule_export]
    use crate::solutions::{BatchSolutions, Solution, Solutions};

    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
