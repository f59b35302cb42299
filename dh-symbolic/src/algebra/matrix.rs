//! Rigid transforms whose entries are formulas.

use super::vector::{cross, dot};
use super::{Poly, Rational};

/// Three formulas.
pub type Vector = [Poly; 3];

/// A homogeneous transform: rotation, by rows, and translation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transform {
    /// Rotation, `r[row][column]`.
    pub r: [[Poly; 3]; 3],
    /// Translation.
    pub p: Vector,
}

impl Transform {
    /// The identity.
    pub fn identity() -> Transform {
        let r = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { Poly::one() } else { Poly::zero() }));
        Transform { r, p: std::array::from_fn(|_| Poly::zero()) }
    }

    /// Translation by `length` along axis 0, 1 or 2.
    pub fn translation(axis: usize, length: &Poly) -> Transform {
        let mut t = Transform::identity();
        t.p[axis] = length.clone();
        t
    }

    /// Rotation about axis 0, 1 or 2 by the angle with this cosine and sine.
    pub fn rotation(axis: usize, (c, s): (&Poly, &Poly)) -> Transform {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut t = Transform::identity();
        t.r[j][j] = c.clone();
        t.r[k][k] = c.clone();
        t.r[j][k] = -s;
        t.r[k][j] = s.clone();
        t
    }

    /// Column 0, 1, 2 of the rotation, or 3: the translation.
    pub fn column(&self, j: usize) -> Vector {
        if j == 3 { self.p.clone() } else { std::array::from_fn(|i| self.r[i][j].clone()) }
    }

    /// Entry of the 4x4 matrix, `i` and `j` in 0..4.
    pub fn entry(&self, i: usize, j: usize) -> Poly {
        match (i, j) {
            (0..3, 0..3) => self.r[i][j].clone(),
            (0..3, _) => self.p[i].clone(),
            (_, 3) => Poly::one(),
            _ => Poly::zero(),
        }
    }

    /// Product.
    #[must_use]
    pub fn times(&self, other: &Transform) -> Transform {
        let row = |i: usize, v: &Vector| dot(&self.r[i], v);
        let columns: [Vector; 3] = std::array::from_fn(|j| other.column(j));
        Transform {
            r: std::array::from_fn(|i| std::array::from_fn(|j| row(i, &columns[j]))),
            p: std::array::from_fn(|i| &row(i, &other.p) + &self.p[i]),
        }
    }

    /// The image of a direction.
    pub fn rotate(&self, v: &Vector) -> Vector {
        std::array::from_fn(|i| dot(&self.r[i], v))
    }

    /// Inverse of a rigid transform: the rotation is taken as orthogonal.
    #[must_use]
    pub fn inverse(&self) -> Transform {
        let r: [[Poly; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| self.r[j][i].clone()));
        let p = std::array::from_fn(|i| -&dot(&r[i], &self.p));
        Transform { r, p }
    }

    /// Applies a function to every entry of the upper three rows.
    #[must_use]
    pub fn map(&self, f: impl Fn(&Poly) -> Poly) -> Transform {
        Transform {
            r: std::array::from_fn(|i| std::array::from_fn(|j| f(&self.r[i][j]))),
            p: std::array::from_fn(|i| f(&self.p[i])),
        }
    }

    /// Whether the rotation part is orthogonal with determinant 1, decided exactly.
    pub fn is_rigid(&self) -> bool {
        let c: [Vector; 3] = std::array::from_fn(|j| self.column(j));
        let unit = (0..3).all(|i| (i..3).all(|j| dot(&c[i], &c[j]) == if i == j { Poly::one() } else { Poly::zero() }));
        unit && cross(&c[0], &c[1]) == c[2]
    }
}

impl Poly {
    /// x^2.
    #[must_use]
    pub fn square(&self) -> Poly {
        self * self
    }

    /// Half of it.
    #[must_use]
    pub fn half(&self) -> Poly {
        self.scale(&Rational::HALF)
    }
}
