//! Small matrices of floating-point numbers.

use super::Direct;

/// A matrix by rows.
#[derive(Clone, Debug)]
pub(in super::super) struct Rows {
    pub(in super::super) columns: usize,
    pub(in super::super) cells: Vec<f64>,
}

pub(super) fn identity(n: usize) -> Rows {
    let mut m = Rows { columns: n, cells: vec![0.0; n * n] };
    for i in 0..n {
        m.set(i, i, 1.0);
    }
    m
}

/// A turn about axis 0, 1 or 2, as 4x4.
pub(super) fn rotation(axis: usize, x: f64) -> Rows {
    let mut m = identity(4);
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    for (row, column, v) in [(j, j, x.cos()), (k, k, x.cos()), (j, k, -x.sin()), (k, j, x.sin())] {
        m.set(row, column, v);
    }
    m
}

pub(super) fn translation(p: [f64; 3]) -> Rows {
    let mut m = identity(4);
    for (i, x) in p.into_iter().enumerate() {
        m.set(i, 3, x);
    }
    m
}

impl Rows {
    pub(super) fn rows(&self) -> usize {
        self.cells.len() / self.columns.max(1)
    }

    pub(in super::super) fn get(&self, i: usize, j: usize) -> Option<f64> {
        if j < self.columns { self.cells.get(i * self.columns + j).copied() } else { None }
    }

    /// Not a number outside.
    pub(super) fn at(&self, i: usize, j: usize) -> f64 {
        self.get(i, j).unwrap_or(f64::NAN)
    }

    fn set(&mut self, i: usize, j: usize, x: f64) {
        if let Some(cell) = self.cells.get_mut(i * self.columns + j) {
            *cell = x;
        }
    }

    fn by(rows: usize, columns: usize, f: impl Fn(usize, usize) -> f64) -> Rows {
        Rows {
            columns,
            cells: (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| f(i, j)).collect(),
        }
    }

    pub(super) fn scaled(mut self, k: f64) -> Rows {
        self.cells.iter_mut().for_each(|x| *x *= k);
        self
    }

    pub(super) fn times(&self, other: &Rows) -> Rows {
        Rows::by(self.rows(), other.columns, |i, j| (0..self.columns).map(|k| self.at(i, k) * other.at(k, j)).sum())
    }

    /// The 3x3 part of a transform without a translation.
    pub(super) fn rotation(&self) -> Option<Rows> {
        let pure = self.rows() == 4 && self.columns == 4 && (0..3).all(|i| self.at(i, 3) == 0.0);
        pure.then(|| Rows::by(3, 3, |i, j| self.at(i, j)))
    }

    /// The inverse of a rotation with a translation.
    pub(super) fn rigid_inverse(&self) -> Rows {
        let entry = |i: usize, j: usize| match (i, j) {
            (3, _) => f64::from(u8::from(j == 3)),
            (_, 3) => -(0..3).map(|k| self.at(k, i) * self.at(k, 3)).sum::<f64>(),
            _ => self.at(j, i),
        };
        Rows::by(4, 4, entry)
    }

    /// The rotation of a transform without translation, where the other matrix is 3x3.
    pub(super) fn beside(&self, other: &Rows) -> Rows {
        let shapes = (self.rows(), self.columns, other.rows(), other.columns) == (4, 4, 3, 3);
        if (self.rows(), self.columns, other.rows(), other.columns) == (3, 1, 4, 1) {
            return self.clone().homogeneous();
        }
        let pure = shapes && (0..3).all(|i| self.at(i, 3).abs() < 1e-9 && self.at(3, i).abs() < 1e-9);
        if pure { Rows::by(3, 3, |i, j| self.at(i, j)) } else { self.clone() }
    }

    /// Rows by their numbers from 0.
    pub(super) fn some_rows(&self, rows: &[usize]) -> Option<Rows> {
        let mut cells = Vec::with_capacity(rows.len() * self.columns);
        for i in rows {
            cells.extend_from_slice(self.cells.get(i * self.columns..(i + 1) * self.columns)?);
        }
        Some(Rows { columns: self.columns, cells })
    }

    /// A point with a one below.
    pub(super) fn homogeneous(mut self) -> Rows {
        self.cells.push(1.0);
        self
    }

    fn is_square(&self) -> bool {
        self.columns > 0 && self.rows() == self.columns
    }

    /// By elimination with the largest pivot; `None` for shapes that have none. What has no inverse comes out as no numbers.
    pub(super) fn inverse(&self) -> Option<Rows> {
        let (inverse, _) = self.eliminated()?;
        Some(inverse)
    }

    pub(super) fn determinant(&self) -> Option<f64> {
        let (_, determinant) = self.eliminated()?;
        Some(determinant)
    }

    fn eliminated(&self) -> Option<(Rows, f64)> {
        if !self.is_square() {
            return None;
        }
        let n = self.columns;
        let (mut m, mut out, mut determinant) = (self.clone(), identity(n), 1.0);
        for column in 0..n {
            let pivot = (column..n).max_by(|a, b| m.at(*a, column).abs().total_cmp(&m.at(*b, column).abs()))?;
            if pivot != column {
                determinant = -determinant;
                for j in 0..n {
                    for t in [&mut m, &mut out] {
                        let (x, y) = (t.at(pivot, j), t.at(column, j));
                        t.set(pivot, j, y);
                        t.set(column, j, x);
                    }
                }
            }
            let p = m.at(column, column);
            determinant *= p;
            for i in (0..n).filter(|i| *i != column) {
                let k = m.at(i, column) / p;
                for j in 0..n {
                    for t in [&mut m, &mut out] {
                        let x = t.at(i, j) - k * t.at(column, j);
                        t.set(i, j, x);
                    }
                }
            }
            for j in 0..n {
                for t in [&mut m, &mut out] {
                    let x = t.at(column, j) / p;
                    t.set(column, j, x);
                }
            }
        }
        // a column of zeros
        Some((out, if determinant.is_nan() && self.cells.iter().all(|x| x.is_finite()) { 0.0 } else { determinant }))
    }

    pub(super) fn power(&self, n: i32) -> Option<Rows> {
        if !self.is_square() {
            return None;
        }
        let m = if n < 0 { self.inverse()? } else { self.clone() };
        Some((0..n.unsigned_abs()).fold(identity(self.columns), |p, _| p.times(&m)))
    }

    /// An entry, a part, or the transpose.
    pub(super) fn field(&self, name: &str) -> Option<Direct> {
        let axis = |letter: &str| ["x", "y", "z"].iter().position(|a| *a == letter);
        let shape = (self.rows(), self.columns);
        let (place, rotation) = (shape == (4, 4), shape == (4, 4) || shape == (3, 3));
        let part = |columns: std::ops::Range<usize>| {
            Some(Direct::Matrix(Rows::by(3, columns.len(), |i, j| self.at(i, columns.start + j))))
        };
        if name == "t" {
            return Some(Direct::Matrix(Rows::by(self.columns, self.rows(), |i, j| self.at(j, i))));
        }
        if let Some(i) = axis(name) {
            return if rotation {
                part(i..i + 1)
            } else {
                self.get(i, 0).filter(|_| self.columns == 1).map(Direct::Scalar)
            };
        }
        if let (Some(i), true) = (name.strip_prefix('p').and_then(axis), place) {
            return self.get(i, 3).map(Direct::Scalar);
        }
        if let (Some([i @ b'1'..=b'3', j @ b'1'..=b'3']), true) = (name.strip_prefix('r').map(str::as_bytes), rotation)
        {
            return self.get(usize::from(i - b'1'), usize::from(j - b'1')).map(Direct::Scalar);
        }
        match name {
            "p" if place => part(3..4),
            "R" if rotation => part(0..3),
            _ => None,
        }
    }
}
