//! Block-triangular form of a square matrix, found from the pattern of its zeros.

/// Side of the matrices here: three linear and three angular rows.
pub(super) const SIDE: usize = 6;

/// Which entries are not zero: for every row, a bit per column.
pub(super) type Pattern = [u8; SIDE];

/// A block on the diagonal, once rows and columns are in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Its rows.
    pub rows: Vec<usize>,
    /// Its columns.
    pub columns: Vec<usize>,
}

/// The finest block-triangular form: a matching of rows and columns, and the strongly connected parts of what it leaves (Dulmage and
/// Mendelsohn 1958). `None` where no matching exists: the determinant is zero. Blocks are in order of their first columns.
pub(super) fn blocks(p: &Pattern) -> Option<Vec<Block>> {
    let row_of = matching(p)?;
    // Column c reaches column d where the row of c has an entry in d.
    let mut reach: [u8; SIDE] = row_of.map(|row| p[row]);
    for k in 0..SIDE {
        for c in 0..SIDE {
            if reach[c] >> k & 1 == 1 {
                reach[c] |= reach[k];
            }
        }
    }
    let mut done = 0u8;
    let mut list = Vec::new();
    for c in 0..SIDE {
        if done >> c & 1 == 1 {
            continue;
        }
        let together = |d: usize| d == c || (reach[c] >> d & 1 == 1 && reach[d] >> c & 1 == 1);
        let columns: Vec<usize> = (c..SIDE).filter(|d| together(*d)).collect();
        columns.iter().for_each(|d| done |= 1 << d);
        let mut rows: Vec<usize> = columns.iter().map(|d| row_of[*d]).collect();
        rows.sort_unstable();
        list.push(Block { rows, columns });
    }
    Some(list)
}

/// The row of every column.
fn matching(p: &Pattern) -> Option<[usize; SIDE]> {
    let mut row_of: [Option<usize>; SIDE] = [None; SIDE];
    for row in 0..SIDE {
        let mut seen = 0u8;
        if !augment(p, row, &mut seen, &mut row_of) {
            return None;
        }
    }
    let mut out = [0; SIDE];
    for (place, row) in out.iter_mut().zip(row_of) {
        *place = row?;
    }
    Some(out)
}

fn augment(p: &Pattern, row: usize, seen: &mut u8, row_of: &mut [Option<usize>; SIDE]) -> bool {
    for c in 0..SIDE {
        if p[row] >> c & 1 == 0 || *seen >> c & 1 == 1 {
            continue;
        }
        *seen |= 1 << c;
        if row_of[c].is_none_or(|other| augment(p, other, seen, row_of)) {
            row_of[c] = Some(row);
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_of_a_triangular_matrix_are_single_entries() {
        let p: Pattern = std::array::from_fn(|i| (0xffu8 << i) & 0x3f);
        let list = blocks(&p).unwrap();
        assert_eq!(list.len(), SIDE);
        assert!(list.iter().all(|b| b.rows == b.columns));
    }

    #[test]
    fn a_full_corner_is_one_block_and_an_empty_row_none() {
        let mut p: Pattern = [0b000_011, 0b000_011, 0b111_100, 0b111_100, 0b111_100, 0b111_111];
        let sizes: Vec<usize> = blocks(&p).unwrap().iter().map(|b| b.rows.len()).collect();
        assert_eq!(sizes, [2, 4]);
        p[3] = 0;
        assert_eq!(blocks(&p), None);
    }
}
