//! Values of formulas: numbers, angles, matrices, and their arithmetic.

use super::ratio::{Ratio, Work, Worked, dot};
use crate::algebra::{Angle, AngleVar, LinearAngle, Rational, Transform};

/// The value of a formula.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Scalar(Ratio),
    Angle(Turn),
    Matrix(Matrix),
}

/// An angle: multiples of angle variables, a constant, and angles given by their two sides.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    /// Angle variables with rational factors, in order, no zeros.
    pub(super) terms: Vec<(AngleVar, Rational)>,
    /// The constant part.
    pub(super) constant: Angle,
    /// atan2(y, x) as (x, y); `true`: subtracted.
    pub(super) sides: Vec<(Ratio, Ratio, bool)>,
}

/// A matrix by rows.
#[derive(Clone, Debug)]
pub(super) struct Matrix {
    pub(super) columns: usize,
    pub(super) entries: Vec<Ratio>,
}

impl Turn {
    pub(super) fn constant(constant: Angle) -> Turn {
        Turn { terms: Vec::new(), constant, sides: Vec::new() }
    }

    pub(super) fn var(v: AngleVar) -> Turn {
        Turn { terms: vec![(v, Rational::ONE)], ..Turn::constant(Angle::ZERO) }
    }

    pub(super) fn linear(a: &LinearAngle) -> Turn {
        let start = Turn::constant(a.constant.clone());
        a.terms.iter().fold(start, |t, (v, k)| t.plus(&Turn::var(*v).scaled(&Rational::int(i64::from(*k)))))
    }

    pub(super) fn atan2(y: Ratio, x: Ratio) -> Turn {
        Turn { sides: vec![(x, y, false)], ..Turn::constant(Angle::ZERO) }
    }

    pub(super) fn plus(&self, other: &Turn) -> Turn {
        let mut sum = self.clone();
        for (v, k) in &other.terms {
            match sum.terms.binary_search_by(|t| t.0.cmp(v)) {
                Ok(i) => sum.terms[i].1 = &sum.terms[i].1 + k,
                Err(i) => sum.terms.insert(i, (*v, k.clone())),
            }
        }
        sum.terms.retain(|t| !t.1.is_zero());
        sum.constant = sum.constant.plus(&other.constant);
        sum.sides.extend(other.sides.iter().cloned());
        sum
    }

    pub(super) fn negated(&self) -> Turn {
        let mut t = Turn { sides: Vec::new(), ..self.clone() }.scaled(&Rational::int(-1));
        t.sides = self.sides.iter().map(|(x, y, minus)| (x.clone(), y.clone(), !minus)).collect();
        t
    }

    /// A multiple of an angle without sides.
    fn scaled(&self, k: &Rational) -> Turn {
        let terms = self.terms.iter().map(|(v, n)| (*v, n * k)).filter(|t| !t.1.is_zero()).collect();
        Turn { terms, constant: self.constant.times(k), sides: self.sides.clone() }
    }

    /// A multiple; `None` for a fraction or a large multiple of an angle that is given by its sides.
    pub(super) fn times(&self, k: &Rational) -> Option<Turn> {
        if self.sides.is_empty() || k.is_one() {
            return Some(self.scaled(k));
        }
        let n = k.to_i64().filter(|n| n.abs() <= 8)?;
        let one = if n < 0 { self.negated() } else { self.clone() };
        Some((0..n.abs()).fold(Turn::constant(Angle::ZERO), |sum, _| sum.plus(&one)))
    }

    /// The linear part as an argument of sine and cosine; `None` where a factor is no small whole number.
    pub(super) fn to_linear(&self) -> Option<LinearAngle> {
        let whole = |k: &Rational| k.to_i64().and_then(|n| i8::try_from(n).ok()).filter(|n| n.abs() <= 16);
        let terms = self.terms.iter().map(|(v, k)| Some((*v, whole(k)?))).collect::<Option<Vec<_>>>()?;
        Some(LinearAngle { terms, constant: self.constant.clone() })
    }

    pub(super) fn is_zero(&self) -> bool {
        self.terms.is_empty() && self.constant.is_zero() && self.sides.is_empty()
    }
}

impl Matrix {
    pub(super) fn rows(&self) -> usize {
        self.entries.len() / self.columns.max(1)
    }

    pub(super) fn shape(&self) -> String {
        format!("{}x{}", self.rows(), self.columns)
    }

    pub(super) fn is(&self, rows: usize, columns: usize) -> bool {
        self.columns == columns && self.rows() == rows
    }

    /// A point with a one below.
    pub(super) fn homogeneous(mut self) -> Matrix {
        self.entries.push(Ratio::int(1));
        self
    }

    /// Determinant of a small square matrix: for every set of columns that of the upper rows, row by row.
    pub(super) fn determinant(&self, w: &mut Work) -> Worked<Ratio> {
        let n = self.columns.min(8);
        let mut minors: Vec<Ratio> = vec![Ratio::zero(); 1 << n];
        minors[0] = Ratio::int(1);
        for set in 1..minors.len() {
            let row = set.count_ones() as usize - 1;
            let mut sum = Ratio::zero();
            let mut after = set.count_ones();
            for column in (0..n).filter(|c| set & (1 << c) != 0) {
                after -= 1;
                let rest = &minors[set & !(1 << column)];
                let entry = self.at(row, column);
                if entry.is_zero() || rest.is_zero() {
                    continue;
                }
                let term = rest.times(&entry, w)?;
                sum = if after % 2 == 0 { sum.plus(&term, w)? } else { sum.minus(&term, w)? };
            }
            minors[set] = sum;
        }
        Ok(minors.pop().unwrap_or_else(Ratio::zero))
    }

    /// Entry, counted from 0; zero outside.
    pub(super) fn at(&self, i: usize, j: usize) -> Ratio {
        if j < self.columns {
            self.entries.get(i * self.columns + j).cloned().unwrap_or_else(Ratio::zero)
        } else {
            Ratio::zero()
        }
    }

    fn by(rows: usize, columns: usize, f: impl Fn(usize, usize) -> Ratio) -> Matrix {
        Matrix {
            columns,
            entries: (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| f(i, j)).collect(),
        }
    }

    pub(super) fn identity(n: usize) -> Matrix {
        Matrix::by(n, n, |i, j| Ratio::int(i64::from(i == j)))
    }

    pub(super) fn from_transform(t: &Transform) -> Matrix {
        Matrix::by(4, 4, |i, j| t.entry(i, j).into())
    }

    pub(super) fn block(&self, rows: usize, columns: std::ops::Range<usize>) -> Matrix {
        Matrix::by(rows, columns.len(), |i, j| self.at(i, columns.start + j))
    }

    pub(super) fn transposed(&self) -> Matrix {
        Matrix::by(self.columns, self.rows(), |i, j| self.at(j, i))
    }

    pub(super) fn plus(&self, other: &Matrix, w: &mut Work) -> Worked<Matrix> {
        let entries = self.entries.iter().zip(&other.entries).map(|(a, b)| a.plus(b, w)).collect::<Worked<_>>()?;
        Ok(Matrix { columns: self.columns, entries })
    }

    pub(super) fn scaled(&self, x: &Ratio, w: &mut Work) -> Worked<Matrix> {
        let entries = self.entries.iter().map(|a| a.times(x, w)).collect::<Worked<_>>()?;
        Ok(Matrix { columns: self.columns, entries })
    }

    pub(super) fn negated(&self) -> Matrix {
        Matrix { columns: self.columns, entries: self.entries.iter().map(Ratio::negated).collect() }
    }

    pub(super) fn times(&self, other: &Matrix, w: &mut Work) -> Worked<Matrix> {
        let mut entries = Vec::new();
        for i in 0..self.rows() {
            for j in 0..other.columns {
                let column: Vec<Ratio> = (0..self.columns).map(|k| other.at(k, j)).collect();
                let row = &self.entries[i * self.columns..(i + 1) * self.columns];
                entries.push(dot(row.iter().zip(&column), w)?);
            }
        }
        Ok(Matrix { columns: other.columns, entries })
    }

    /// Has it the last row 0 0 0 1?
    pub(super) fn is_homogeneous(&self) -> bool {
        self.is(4, 4) && (0..4).all(|j| self.at(3, j) == Ratio::int(i64::from(j == 3)))
    }

    /// The inverse of a matrix up to 3x3, or of a 4x4 with the last row 0 0 0 1. `None` for other shapes.
    pub(super) fn inverse(&self, w: &mut Work) -> Worked<Option<Matrix>> {
        if self.is_homogeneous() {
            let Some(r) = self.block(3, 0..3).inverse(w)? else { return Ok(None) };
            let p = r.times(&self.block(3, 3..4), w)?.negated();
            let entry = |i: usize, j: usize| match (i, j) {
                (3, _) => Ratio::int(i64::from(j == 3)),
                (_, 3) => p.at(i, 0),
                _ => r.at(i, j),
            };
            return Ok(Some(Matrix::by(4, 4, entry)));
        }
        let n = self.columns;
        if self.rows() != n || n > 3 {
            return Ok(None);
        }
        let back = self.transposed();
        let product = back.times(self, w)?;
        if product.entries == Matrix::identity(n).entries {
            return Ok(Some(back));
        }
        let adjugate = self.adjugate(w)?;
        let mut determinant = Ratio::zero();
        for k in 0..n {
            determinant = determinant.plus(&self.at(0, k).times(&adjugate.at(k, 0), w)?, w)?;
        }
        let one_over = Ratio::int(1).over(&determinant, w)?;
        Ok(Some(adjugate.scaled(&one_over, w)?))
    }

    fn adjugate(&self, w: &mut Work) -> Worked<Matrix> {
        let n = self.columns;
        let mut entries = Vec::new();
        for i in 0..n {
            for j in 0..n {
                // cofactor of (j, i)
                let others = |skip: usize| (0..n).filter(move |k| *k != skip).collect::<Vec<_>>();
                let (rows, columns) = (others(j), others(i));
                let minor = match (rows.as_slice(), columns.as_slice()) {
                    ([a, b], [c, d]) => {
                        let left = self.at(*a, *c).times(&self.at(*b, *d), w)?;
                        left.minus(&self.at(*a, *d).times(&self.at(*b, *c), w)?, w)?
                    }
                    ([a], [c]) => self.at(*a, *c),
                    _ => Ratio::int(1),
                };
                entries.push(if (i + j) % 2 == 0 { minor } else { minor.negated() });
            }
        }
        Ok(Matrix { columns: n, entries })
    }
}

impl Value {
    pub(super) fn what(&self) -> String {
        match self {
            Value::Scalar(_) => "a number".into(),
            Value::Angle(_) => "an angle".into(),
            Value::Matrix(m) => format!("a {} matrix", m.shape()),
        }
    }
}
