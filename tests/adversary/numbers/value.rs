//! Numbers, angles and matrices at a pose, and when two of them are the same.

use Value::{Angle, Matrix, Number};

/// A value at a pose.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Number(f64),
    Angle(f64),
    Matrix(Vec<Vec<f64>>),
}

pub(super) fn rows(m: &[[f64; 4]; 4]) -> Vec<Vec<f64>> {
    m.iter().map(|r| r.to_vec()).collect()
}

pub(super) fn identity(n: usize) -> Vec<Vec<f64>> {
    (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect()
}

pub(super) fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
    a.iter().map(|row| (0..b[0].len()).map(|j| row.iter().zip(b).map(|(x, r)| x * r[j]).sum()).collect()).collect()
}

fn transposed(m: &[Vec<f64>]) -> Vec<Vec<f64>> {
    (0..m[0].len()).map(|j| m.iter().map(|r| r[j]).collect()).collect()
}

/// By elimination with pivots: the determinant, and the inverse (not finite where there is none).
pub(super) fn determinant_and_inverse(m: &[Vec<f64>]) -> Option<(f64, Vec<Vec<f64>>)> {
    let n = m.len();
    if m.iter().any(|r| r.len() != n) {
        return None;
    }
    let (mut a, mut inverse, mut det) = (m.to_vec(), identity(n), 1.0);
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
        if pivot != k {
            a.swap(pivot, k);
            inverse.swap(pivot, k);
            det = -det;
        }
        let p = a[k][k];
        det *= p;
        let (pivot_row, pivot_inverse) = (a[k].clone(), inverse[k].clone());
        for i in 0..n {
            let factor = if i == k { 1.0 - 1.0 / p } else { a[i][k] / p };
            for j in 0..n {
                a[i][j] -= factor * pivot_row[j];
                inverse[i][j] -= factor * pivot_inverse[j];
            }
        }
    }
    Some((if det.is_nan() { 0.0 } else { det }, inverse))
}

fn axis(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|a| *a == name)
}

/// An entry, a part or the transpose of a matrix.
pub(super) fn entry(v: Value, field: &str) -> Option<Value> {
    let Matrix(m) = v else { return None };
    let column = |j: usize| Matrix((0..3).map(|i| vec![m[i][j]]).collect());
    if let (Some(i), 4, 4) = (field.strip_prefix('p').and_then(axis), m.len(), m[0].len()) {
        return Some(Number(m[i][3]));
    }
    match (field, m.len(), m[0].len()) {
        ("t", ..) => Some(Matrix(transposed(&m))),
        ("p", 4, 4) => Some(column(3)),
        ("R", 3, 3) | ("R", 4, 4) => Some(Matrix((0..3).map(|i| m[i][..3].to_vec()).collect())),
        ("x" | "y" | "z", 3, 3) | ("x" | "y" | "z", 4, 4) => Some(column(axis(field)?)),
        ("x" | "y" | "z", 3 | 4, 1) => Some(Number(m[axis(field)?][0])),
        (r, 3, 3) | (r, 4, 4) => {
            let digits: Vec<usize> =
                r.strip_prefix('r')?.chars().map(|c| c.to_digit(10).map(|d| d as usize)).collect::<Option<_>>()?;
            let [i @ 1..=3, j @ 1..=3] = digits.as_slice() else { return None };
            Some(Number(m[i - 1][j - 1]))
        }
        _ => None,
    }
}

/// Same, different, or nothing where they are too near to tell or have no value.
pub(super) fn compare(a: &Value, b: &Value) -> Option<bool> {
    let numbers = |x: f64, y: f64| {
        let apart = (x - y).abs() / x.abs().max(y.abs()).max(1.0);
        if !apart.is_finite() || (1e-9..1e-5).contains(&apart) { None } else { Some(apart < 1e-9) }
    };
    match (a, b) {
        (Number(x), Number(y)) => numbers(*x, *y),
        (Angle(x), Angle(y)) => {
            let apart = (x - y).rem_euclid(std::f64::consts::TAU);
            numbers(apart.min(std::f64::consts::TAU - apart), 0.0)
        }
        (Matrix(m), Matrix(n)) if m.len() == n.len() && m[0].len() == n[0].len() => {
            let all: Vec<Option<bool>> =
                m.iter().flatten().zip(n.iter().flatten()).map(|(x, y)| numbers(*x, *y)).collect();
            if all.contains(&Some(false)) { Some(false) } else { all.iter().all(Option::is_some).then_some(true) }
        }
        (Matrix(m), Number(0.0)) | (Number(0.0), Matrix(m)) => {
            let zero = vec![vec![0.0; m[0].len()]; m.len()];
            compare(&Matrix(m.clone()), &Matrix(zero))
        }
        (Angle(x), Number(0.0)) | (Number(0.0), Angle(x)) => compare(&Angle(*x), &Angle(0.0)),
        _ => None,
    }
}
