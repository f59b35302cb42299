//! Determinants of small matrices of formulas.

use super::Poly;

/// Determinant of a small matrix, by the minors of its first rows; `None` where more than `budget` products of terms are needed.
pub(crate) fn determinant(m: &[Vec<Poly>], budget: usize) -> Option<Poly> {
    let n = m.len();
    let mut spent = 0usize;
    let mut minors: Vec<Option<Poly>> = vec![None; 1 << n];
    minors[0] = Some(Poly::one());
    for set in 1usize..1 << n {
        let row = set.count_ones() as usize - 1;
        let mut sum = Vec::new();
        for c in (0..n).filter(|c| set >> c & 1 == 1) {
            let (entry, rest) = (&m[row][c], minors[set & !(1 << c)].as_ref()?);
            if entry.is_zero() || rest.is_zero() {
                continue;
            }
            spent += entry.terms().len() * rest.terms().len();
            if spent > budget {
                return None;
            }
            let product = entry * rest;
            // Columns of the set after this one.
            let after = (set >> (c + 1)).count_ones();
            sum.push(if after % 2 == 1 { -&product } else { product });
        }
        minors[set] = Some(sum.into_iter().sum());
    }
    minors.pop()?
}

/// Adjugate and determinant of a small matrix of formulas.
pub fn adjugate(m: &[Vec<Poly>]) -> (Vec<Vec<Poly>>, Poly) {
    let n = m.len();
    let minor = |skip_row: usize, skip_column: usize| -> Poly {
        let rows: Vec<Vec<Poly>> = (0..n)
            .filter(|i| *i != skip_row)
            .map(|i| (0..n).filter(|j| *j != skip_column).map(|j| m[i][j].clone()).collect())
            .collect();
        determinant(&rows, usize::MAX).unwrap_or_default()
    };
    let signed = |p: Poly, odd: bool| if odd { -&p } else { p };
    let adjugate = (0..n).map(|i| (0..n).map(|j| signed(minor(j, i), (i + j) % 2 == 1)).collect()).collect();
    (adjugate, determinant(m, usize::MAX).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn determinants_of_numbers() {
        let m = |rows: &[[i64; 3]; 3]| -> Vec<Vec<Poly>> {
            rows.iter().map(|r| r.iter().map(|x| Poly::int(*x)).collect()).collect()
        };
        assert_eq!(determinant(&m(&[[2, -1, 0], [3, 5, 7], [-4, 1, 6]]), 99), Some(Poly::int(92)));
        assert_eq!(determinant(&m(&[[0, 0, 1], [0, 1, 0], [1, 0, 0]]), 99), Some(Poly::int(-1)));
        assert_eq!(determinant(&m(&[[2, -1, 3], [3, 5, 7], [-4, 1, 6]]), 5), None);
    }

    #[test]
    fn the_adjugate_times_the_matrix_is_the_determinant() {
        let m: Vec<Vec<Poly>> = [[1, 2, 0], [-1, 3, 4], [0, 5, -2]].map(|r| r.map(Poly::int).to_vec()).to_vec();
        let (adjugate, det) = adjugate(&m);
        for i in 0..3 {
            for j in 0..3 {
                let entry: Poly = (0..3).map(|k| &adjugate[i][k] * &m[k][j]).sum();
                assert_eq!(entry, if i == j { det.clone() } else { Poly::zero() }, "{i} {j}");
            }
        }
    }
}
