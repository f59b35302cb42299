//! Matrices of any size as plain numbers: products, inverses of rotations and rigid motions, elementary motions.

pub(super) type Matrix = Vec<Vec<f64>>;

pub(super) fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let n = b.len().min(a.len());
    let columns = b.first().map_or(0, Vec::len).min(if b.len() > n { n } else { usize::MAX });
    (0..n).map(|i| (0..columns).map(|j| (0..n).map(|k| a[i][k] * b[k][j]).sum()).collect()).collect()
}

pub(super) fn inverse(a: &Matrix) -> Matrix {
    let n = a.len();
    let mut t: Matrix = (0..n).map(|i| (0..n).map(|j| a[j][i]).collect()).collect();
    if n == 4 {
        for row in &mut t {
            row[3] = 0.0;
        }
        t[3] = vec![0.0, 0.0, 0.0, 1.0];
        for i in 0..3 {
            t[i][3] = -(0..3).map(|k| a[k][i] * a[k][3]).sum::<f64>();
        }
    }
    t
}

pub(super) fn elementary(motion: &str, x: f64) -> Option<Matrix> {
    let axis = "xyz".find(motion.chars().last()?)?;
    let mut t: Matrix = (0..4).map(|i| (0..4).map(|j| f64::from(i == j)).collect()).collect();
    if motion.starts_with('D') {
        t[axis][3] = x;
    } else {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        (t[j][j], t[k][k], t[j][k], t[k][j]) = (x.cos(), x.cos(), -x.sin(), x.sin());
    }
    Some(t)
}
