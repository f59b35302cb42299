//! A matrix of exact formulas of one robot: transforms, Jacobians, and what is made of them.

use super::formula::same_arm;
use super::names::Names;
use super::{EvalError, Formula};
use crate::algebra::{Poly, determinant};
use crate::render::document::{latex, typst};
use crate::render::formula::{math::Math, text};
use std::fmt;
use std::ops::Mul;
use std::sync::Arc;

/// A matrix of [`Formula`]s.
///
/// ```
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
/// let t = puma.transform(1, 3);
/// assert_eq!(
///     t.to_string(),
///     "⎡  c₂₃  −s₂₃  0   a₂c₂ ⎤
/// ⎢  0     0    1   d₃   ⎥
/// ⎢ −s₂₃  −c₂₃  0  −a₂s₂ ⎥
/// ⎣  0     0    0   1    ⎦
/// "
/// );
/// assert!(t.latex().starts_with(r"\begin{bmatrix}"));
/// let numbers = t.eval(&[("q2", 0.0), ("q3", 0.0)])?;
/// assert_eq!(numbers[0], [1.0, 0.0, 0.0, 0.4318]);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Matrix {
    arm: Arc<Names>,
    /// By rows, all of one length.
    entries: Vec<Vec<Poly>>,
}

/// Products of terms that a determinant may take.
const BUDGET: usize = 4_000_000;

impl Matrix {
    pub(super) fn new(arm: &Arc<Names>, entries: Vec<Vec<Poly>>) -> Matrix {
        Matrix { arm: Arc::clone(arm), entries }
    }

    fn formula(&self, value: &Poly) -> Formula {
        Formula { arm: Arc::clone(&self.arm), value: value.clone() }
    }

    fn map(&self, f: impl Fn(&Poly) -> Poly) -> Matrix {
        Matrix::new(&self.arm, self.entries.iter().map(|row| row.iter().map(&f).collect()).collect())
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.entries.len()
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.entries.first().map_or(0, Vec::len)
    }

    /// The entry in row `i` and column `j`, both from 0.
    ///
    /// # Panics
    /// Where there is no such entry; [`Matrix::get`] does not panic.
    #[track_caller]
    pub fn entry(&self, i: usize, j: usize) -> Formula {
        match self.get(i, j) {
            Some(entry) => entry,
            None => panic!("there is no entry ({i}, {j}): the matrix is {}x{}", self.rows(), self.columns()),
        }
    }

    /// The entry in row `i` and column `j`, both from 0; `None` where there is no such entry.
    pub fn get(&self, i: usize, j: usize) -> Option<Formula> {
        self.entries.get(i).and_then(|row| row.get(j)).map(|p| self.formula(p))
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub fn transpose(&self) -> Matrix {
        let column = |j: usize| self.entries.iter().filter_map(|row| row.get(j).cloned()).collect();
        Matrix::new(&self.arm, (0..self.columns()).map(column).collect())
    }

    /// The determinant; `None` where the matrix is not square, or where the formula would be too long to be formed in a moment.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// assert_eq!(puma.transform(0, 3).determinant().map(|d| d.to_string()), Some("1".into()));
    /// assert_eq!(puma.jacobian().transpose().determinant(), puma.jacobian().determinant());
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    pub fn determinant(&self) -> Option<Formula> {
        let square = self.rows() == self.columns();
        square.then(|| determinant(&self.entries, BUDGET)).flatten().map(|p| self.formula(&p))
    }

    /// Every entry differentiated: see [`Formula::diff`].
    #[must_use]
    pub fn diff(&self, name: &str) -> Matrix {
        self.map(|p| self.arm.derivative(p, name))
    }

    /// The numbers by rows: see [`Formula::eval`].
    ///
    /// # Errors
    /// Names without a value, and names that the robot does not have.
    pub fn eval(&self, values: &[(&str, f64)]) -> Result<Vec<Vec<f64>>, EvalError> {
        let all: Vec<&Poly> = self.entries.iter().flatten().collect();
        let numbers = self.arm.evaluate(&all, values)?;
        Ok(numbers.chunks(self.columns().max(1)).map(<[f64]>::to_vec).collect())
    }

    /// As LaTeX, without dollar signs.
    pub fn latex(&self) -> String {
        latex::math(&self.math())
    }

    /// As Typst, without dollar signs.
    pub fn typst(&self) -> String {
        typst::math(&self.math())
    }

    fn math(&self) -> Math {
        Math::Matrix(self.entries.iter().map(|row| row.iter().map(|p| self.formula(p).math()).collect()).collect())
    }
}

impl fmt::Display for Matrix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&text::display(&self.math()))
    }
}

impl fmt::Debug for Matrix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = self.entries.iter().map(|row| row.iter().map(|p| self.formula(p)).collect::<Vec<_>>());
        f.debug_list().entries(rows).finish()
    }
}

impl PartialEq for Matrix {
    fn eq(&self, other: &Matrix) -> bool {
        self.arm.is_like(&other.arm) && self.entries == other.entries
    }
}

impl Eq for Matrix {}

impl Mul for &Matrix {
    type Output = Matrix;

    /// # Panics
    /// Where the left matrix has not as many columns as the right one has rows, or where they belong to different robots.
    #[track_caller]
    fn mul(self, other: &Matrix) -> Matrix {
        same_arm(&self.arm, &other.arm);
        let shape = |m: &Matrix| format!("{}x{}", m.rows(), m.columns());
        assert_eq!(self.columns(), other.rows(), "a product of {} and {}", shape(self), shape(other));
        let columns = other.transpose();
        let entry = |row: &Vec<Poly>, column: &Vec<Poly>| Poly::sum_of_products(row.iter().zip(column));
        let rows = self.entries.iter().map(|row| columns.entries.iter().map(|c| entry(row, c)).collect());
        Matrix::new(&self.arm, rows.collect())
    }
}

impl Mul for Matrix {
    type Output = Matrix;

    #[track_caller]
    fn mul(self, other: Matrix) -> Matrix {
        &self * &other
    }
}
