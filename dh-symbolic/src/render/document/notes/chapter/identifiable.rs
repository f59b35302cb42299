//! Which deviations of a table's cells measured poses can tell apart: the rank of the derivative of the pose by all of them.
//!
//! **In:** a chain. **Out:** every deviation with the ones that it cannot be told from. A deviation moves all that stands behind it along or
//! about one axis; that screw, seen from the base at many joint values, is its column. Columns are taken in a fixed order, and one that
//! the columns before it combine to adds nothing.

use crate::algebra::Point;
use crate::chain::{Chain, Convention, Coordinate, Handle, Role};
use crate::kinematics::Kinematics;
use dh_kernels::pose::{self, Pose};

/// A cell that deviates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cell {
    Alpha,
    A,
    D,
    Theta,
    /// A turn about y behind alpha and a, for neighbouring axes that are parallel (Hayati).
    Beta,
}

/// One deviation.
#[derive(Clone, Debug)]
pub(super) struct Deviation {
    /// Index of the row, from 0.
    pub(super) row: usize,
    pub(super) cell: Cell,
    /// Those that have the same effect together; `None`: it has an effect of its own.
    pub(super) same_as: Option<Vec<(usize, Cell)>>,
}

/// Joint values at which the derivative is formed.
const POSES: usize = 40;
/// What is left of a column, of its length, where the others combine to it but for rounding.
const NOTHING: f64 = 1e-8;
/// Sine of a twist below which neighbouring axes count as parallel.
const PARALLEL: f64 = 0.02;

/// All deviations of an arm, row by row.
pub(super) fn deviations(chain: &Chain) -> Vec<Deviation> {
    let samples: Vec<Vec<(Pose, Pose)>> = (0..POSES).map(|k| frames(chain, k)).collect();
    let reach = samples.iter().flatten().flat_map(|(_, end)| (0..3).map(|i| end[i][3].abs())).fold(0.0, f64::max);
    let scale = if reach > 0.0 { reach } else { 1.0 };
    let mut basis: Vec<Kept> = Vec::new();
    let mut found = Vec::new();
    for (row, cell) in order(chain) {
        let column: Vec<f64> = samples
            .iter()
            .filter_map(|frames| frames.get(row))
            .flat_map(|frames| screw(chain.convention, cell, frames, scale))
            .collect();
        let same_as = reduce(&mut basis, (row, cell), column);
        found.push(Deviation { row, cell, same_as });
    }
    found.sort_by_key(|d| d.row);
    found
}

/// The deviations in the order in which they are taken: offsets last, since those of parallel axes are the ones to leave out.
fn order(chain: &Chain) -> Vec<(usize, Cell)> {
    let rows = 0..chain.links.len();
    let parallel = |row: &usize| lies_between(chain, *row) && twist(chain, *row).sin().abs() < PARALLEL;
    let each = |cell: Cell| rows.clone().map(move |row| (row, cell));
    let mut list: Vec<_> = each(Cell::Theta).chain(each(Cell::Alpha)).chain(each(Cell::A)).collect();
    list.extend(rows.clone().filter(parallel).map(|row| (row, Cell::Beta)));
    list.extend(each(Cell::D));
    list
}

/// Whether a row's twist stands between two joints.
fn lies_between(chain: &Chain, row: usize) -> bool {
    let moves = |row: usize| chain.links.get(row).is_some_and(|l| l.joint.is_some());
    let n = chain.links.len();
    match chain.convention {
        Convention::Standard => (0..=row).any(moves) && (row + 1..n).any(moves),
        Convention::Modified => (0..row).any(moves) && (row..n).any(moves),
    }
}

fn twist(chain: &Chain, row: usize) -> f64 {
    let Some(link) = chain.links.get(row) else { return 0.0 };
    let symbols: f64 = link.alpha.terms.iter().map(|(v, k)| f64::from(*k) * nominal(chain, Handle::Angle(*v))).sum();
    symbols + link.alpha.constant.radians()
}

/// The nominal value of a parameter; in general position where it has none.
fn nominal(chain: &Chain, handle: Handle) -> f64 {
    match chain.parameters.iter().position(|p| p.handle == handle) {
        Some(i) if matches!(chain.parameters[i].role, Role::Field(None)) => 0.4 + 0.07 * i as f64,
        _ => chain.nominal(handle),
    }
}

/// Before and behind every row, at sample `k`.
fn frames(chain: &Chain, k: usize) -> Vec<(Pose, Pose)> {
    let kinematics = Kinematics::new(chain);
    let coordinate = |c: Coordinate| {
        let joint = chain.joints.iter().position(|j| j.coordinate == c)?;
        let x = (1.0 + joint as f64 * 7.3 + k as f64 * 2.9).sin() * 43.7;
        Some(match c {
            Coordinate::Angle(_) => x,
            Coordinate::Length(_) => x.sin(),
        })
    };
    let point = Point {
        symbol: &|s| coordinate(Coordinate::Length(s)).unwrap_or_else(|| nominal(chain, Handle::Length(s))),
        angle: &|v| coordinate(Coordinate::Angle(v)).unwrap_or_else(|| nominal(chain, Handle::Angle(v))),
    };
    let mut now = pose::IDENTITY;
    (1..=kinematics.len())
        .filter_map(|i| kinematics.link(i))
        .map(|t| {
            let link = std::array::from_fn(|i| std::array::from_fn(|j| t.entry(i, j).evaluate(&point)));
            let before = now;
            now = pose::compose(&now, &link);
            (before, now)
        })
        .collect()
}

/// What a deviation does to all behind it: velocity of the point at the base's origin over the reach, and turning.
fn screw(convention: Convention, cell: Cell, (before, behind): &(Pose, Pose), scale: f64) -> [f64; 6] {
    let standard = convention == Convention::Standard;
    // The frame whose axes the four motions have.
    let (across, along) = if standard { (behind, before) } else { (before, behind) };
    let axis = |t: &Pose, i: usize| std::array::from_fn::<f64, 3, _>(|r| t[r][i]);
    let about = |p: [f64; 3], w: [f64; 3]| {
        let v = cross(p, w).map(|x| x / scale);
        [v[0], v[1], v[2], w[0], w[1], w[2]]
    };
    let turn = |t: &Pose, i: usize| about(axis(t, 3), axis(t, i));
    let shift = |v: [f64; 3]| [v[0], v[1], v[2], 0.0, 0.0, 0.0];
    match cell {
        Cell::Alpha => turn(across, 0),
        Cell::A => shift(axis(across, 0)),
        Cell::D => shift(axis(along, 2)),
        Cell::Theta => turn(along, 2),
        Cell::Beta if standard => turn(behind, 1),
        // Through the point of the joint's axis where the common normal ends.
        Cell::Beta => {
            let (p, end, x) = (axis(before, 3), axis(behind, 3), axis(before, 0));
            let a: f64 = (0..3).map(|i| x[i] * (end[i] - p[i])).sum();
            about(std::array::from_fn(|i| p[i] + a * x[i]), cross(axis(behind, 2), x))
        }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A column that adds something: of length 1, perpendicular to those before, and the sum of columns that it is.
struct Kept {
    unit: Vec<f64>,
    sum: Vec<((usize, Cell), f64)>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Takes a column into the basis, or says which ones combine to it.
fn reduce(basis: &mut Vec<Kept>, name: (usize, Cell), mut column: Vec<f64>) -> Option<Vec<(usize, Cell)>> {
    let length = dot(&column, &column).sqrt();
    // Column = remainder + the sum of these; twice, against rounding.
    let mut sum: Vec<((usize, Cell), f64)> = Vec::new();
    for _ in 0..2 {
        for kept in basis.iter() {
            let along = dot(&column, &kept.unit);
            column.iter_mut().zip(&kept.unit).for_each(|(x, u)| *x -= along * u);
            for (of, factor) in &kept.sum {
                match sum.iter_mut().find(|s| s.0 == *of) {
                    Some(known) => known.1 += along * factor,
                    None => sum.push((*of, along * factor)),
                }
            }
        }
    }
    let rest = dot(&column, &column).sqrt();
    if rest <= NOTHING * length {
        return Some(sum.into_iter().filter(|s| s.1.abs() > 1e-6).map(|s| s.0).collect());
    }
    let mut own: Vec<_> = sum.into_iter().map(|(of, factor)| (of, -factor / rest)).collect();
    own.push((name, 1.0 / rest));
    basis.push(Kept { unit: column.into_iter().map(|x| x / rest).collect(), sum: own });
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::samples::{KUKA, PUMA, SCARA, UR5, chain};

    fn lost(table: &str) -> Vec<Deviation> {
        deviations(&chain(table)).into_iter().filter(|d| d.same_as.is_some()).collect()
    }

    #[test]
    fn offsets_of_parallel_axes_cannot_be_told_apart() {
        for (table, groups) in [(UR5, 2), (PUMA, 1), (KUKA, 1)] {
            let lost = lost(table);
            assert_eq!(lost.len(), groups, "{lost:?}");
            for d in lost {
                let same = d.same_as.unwrap_or_default();
                assert!(d.cell == Cell::D && same.len() == 1 && same[0].1 == Cell::D, "{same:?}");
            }
            let all = deviations(&chain(table));
            let turns: Vec<_> = all.iter().filter(|d| d.cell == Cell::Beta).collect();
            assert!(turns.len() == groups && turns.iter().all(|d| d.same_as.is_none()), "{turns:?}");
        }
    }

    /// A row with one small deviation, against the screw that is said to come of it.
    #[test]
    fn columns_are_the_differences_of_poses() {
        let turn = |axis: usize, x: f64| {
            let mut t = pose::IDENTITY;
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            (t[i][i], t[i][j], t[j][i], t[j][j]) = (x.cos(), -x.sin(), x.sin(), x.cos());
            t
        };
        let shift = |axis: usize, x: f64| {
            let mut t = pose::IDENTITY;
            t[axis][3] = x;
            t
        };
        let small = 1e-6;
        for table in [UR5, PUMA, SCARA] {
            let chain = chain(table);
            for (row, (before, behind)) in frames(&chain, 1).into_iter().enumerate() {
                let link = pose::compose(&pose::inverse(&before), &behind);
                let standard = chain.convention == Convention::Standard;
                for cell in [Cell::Alpha, Cell::A, Cell::D, Cell::Theta, Cell::Beta] {
                    let (motion, leads) = match cell {
                        Cell::Alpha => (turn(0, small), !standard),
                        Cell::A => (shift(0, small), !standard),
                        Cell::D => (shift(2, small), standard),
                        Cell::Theta => (turn(2, small), standard),
                        Cell::Beta => (turn(1, small), false),
                    };
                    // In the modified convention beta turns between the two halves of the row.
                    let half = pose::compose(&turn(0, twist(&chain, row)), &shift(0, link[0][3]));
                    let moved = if cell == Cell::Beta && !standard {
                        let rest = pose::compose(&pose::inverse(&half), &link);
                        pose::compose(&pose::compose(&half, &motion), &rest)
                    } else if leads {
                        pose::compose(&motion, &link)
                    } else {
                        pose::compose(&link, &motion)
                    };
                    let moved = pose::compose(&before, &moved);
                    let change = pose::compose(&moved, &pose::inverse(&behind));
                    let got = [0, 1, 2].map(|i| change[i][3] / small);
                    let w = [change[2][1], change[0][2], change[1][0]].map(|x| x / small);
                    let said = screw(chain.convention, cell, &(before, behind), 1.0);
                    for (x, y) in got.iter().chain(&w).zip(said) {
                        assert!((x - y).abs() < 1e-5, "row {row} {cell:?}: {got:?} {w:?} {said:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_sliding_axis_is_a_direction_without_a_place() {
        // Four parallel axes, one of them sliding: more is lost than the offsets.
        let lost = lost(SCARA);
        assert!(lost.iter().any(|d| d.cell != Cell::D) && lost.len() > 3, "{lost:?}");
    }
}
