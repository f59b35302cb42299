//! Subspaces of linear combinations of joint coordinates: those that an equation depends on, and those that are known.

/// An integer combination of coordinates, such as theta2 + theta3.
pub type JointCombination = Vec<i8>;

/// A linear space of forms, by a reduced basis.
#[derive(Clone, Debug, Default)]
pub struct Subspace {
    rows: Vec<Vec<f64>>,
}

const TOLERANCE: f64 = 1e-5;

impl Subspace {
    /// Adds a vector; true where it was new.
    pub fn add(&mut self, v: &[f64]) -> bool {
        let mut v = self.reduce(v);
        let Some((pivot, size)) = v
            .iter()
            .enumerate()
            .map(|(i, x)| (i, x.abs()))
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .filter(|x| x.1 > TOLERANCE)
        else {
            return false;
        };
        // Prefer the first entry that is not small, so that bases of integer forms come out as integers.
        let pivot = v.iter().position(|x| x.abs() > 0.1 * size).unwrap_or(pivot);
        let k = v[pivot];
        for x in &mut v {
            *x /= k;
        }
        for row in &mut self.rows {
            let k = row[pivot];
            if k != 0.0 {
                for (x, y) in row.iter_mut().zip(&v) {
                    *x -= k * y;
                }
            }
        }
        self.rows.push(v);
        self.rows.sort_by_key(|r| r.iter().position(|x| x.abs() > 0.5));
        true
    }

    /// What is left of a vector modulo this space.
    pub fn reduce(&self, v: &[f64]) -> Vec<f64> {
        let mut v = v.to_vec();
        for row in &self.rows {
            let Some(pivot) = row.iter().position(|x| (x - 1.0).abs() < 1e-9) else { continue };
            let k = v[pivot];
            if k != 0.0 {
                for (x, y) in v.iter_mut().zip(row) {
                    *x -= k * y;
                }
            }
        }
        v
    }

    /// Whether the vector lies in the space.
    pub fn contains(&self, v: &[f64]) -> bool {
        self.reduce(v).iter().all(|x| x.abs() <= TOLERANCE)
    }

    /// The basis.
    pub fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// A key that is equal for equal spaces.
    pub fn key(&self) -> Vec<i32> {
        self.rows.iter().flatten().map(|x| (x * 1e4).round() as i32).collect()
    }

    /// Dimension.
    pub fn dimension(&self) -> usize {
        self.rows.len()
    }

    /// The basis, rounded to integers; `None` if it is not integral (a space that no joint sums span).
    pub fn integer_basis(&self) -> Option<Vec<JointCombination>> {
        self.rows
            .iter()
            .map(|r| {
                r.iter().map(|x| ((x - x.round()).abs() < 1e-4 && x.abs() < 100.0).then(|| x.round() as i8)).collect()
            })
            .collect()
    }

    /// This space modulo another one.
    pub fn modulo(&self, known: &Subspace) -> Subspace {
        let mut rest = Subspace::default();
        for row in &self.rows {
            rest.add(&known.reduce(row));
        }
        rest
    }
}

/// A form as numbers.
pub(super) fn numbers(form: &[i8]) -> Vec<f64> {
    form.iter().map(|k| f64::from(*k)).collect()
}

/// Writes `target` as an integer combination of `forms`; `None` where that is impossible.
pub fn combination(target: &[i8], forms: &[JointCombination]) -> Option<Vec<i8>> {
    // Gaussian elimination on the columns `forms`, right-hand side `target`.
    let (rows, columns) = (target.len(), forms.len());
    let mut m: Vec<Vec<f64>> =
        (0..rows).map(|i| forms.iter().map(|f| f64::from(f[i])).chain([f64::from(target[i])]).collect()).collect();
    let mut pivots = Vec::new();
    let mut r = 0;
    for c in 0..columns {
        let Some(p) = (r..rows).max_by(|a, b| m[*a][c].abs().total_cmp(&m[*b][c].abs())) else { break };
        if m[p][c].abs() < 1e-9 {
            continue;
        }
        m.swap(r, p);
        let k = m[r][c];
        for x in &mut m[r] {
            *x /= k;
        }
        let pivot = m[r].clone();
        for (i, row) in m.iter_mut().enumerate() {
            let k = row[c];
            if i != r && k != 0.0 {
                for (x, y) in row.iter_mut().zip(&pivot) {
                    *x -= k * y;
                }
            }
        }
        pivots.push(c);
        r += 1;
    }
    if m[r..].iter().any(|row| row[columns].abs() > 1e-9) {
        return None;
    }
    let mut out = vec![0i8; columns];
    for (i, c) in pivots.into_iter().enumerate() {
        let x = m[i][columns];
        if (x - x.round()).abs() > 1e-9 {
            return None;
        }
        out[c] = x.round() as i8;
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_and_combinations() {
        let mut known = Subspace::default();
        assert!(known.add(&[0.0, 2.0, 2.0, 0.0]));
        assert!(!known.add(&[0.0, -1.0, -1.0, 0.0]));
        assert!(known.contains(&[0.0, 1.0, 1.0, 0.0]) && !known.contains(&[0.0, 1.0, 0.0, 0.0]));
        known.add(&[0.0, 0.0, 1.0, 0.0]);
        assert!(known.contains(&[0.0, 1.0, 0.0, 0.0]));
        let forms = vec![vec![0, 1, 1, 0], vec![0, 0, 1, 0]];
        assert_eq!(combination(&[0, 1, 0, 0], &forms), Some(vec![1, -1]));
        assert_eq!(combination(&[1, 0, 0, 0], &forms), None);
    }
}
