//! Joint values (what actuators do) from the coordinates of the formulas, behind coupled drives too.

use dh_kernels::Drive;
use dh_symbolic::algebra::{Poly, adjugate};
use dh_symbolic::chain::{Chain, Coordinate};

use crate::values::Values;

/// A coupled drive.
struct Matrices {
    /// From joint values to coordinates.
    rows: Vec<Vec<f64>>,
    /// Its adjugate and its determinant.
    adjugate: Vec<Vec<f64>>,
    det: f64,
}

/// From coordinates to joint values, in numbers.
pub(crate) struct Actuators {
    /// Constant parts of the coordinates that formulas leave out.
    pub(crate) shifts: Vec<f64>,
    /// Where drives are coupled.
    drive: Option<Matrices>,
    /// Which coordinates turn.
    revolute: Vec<bool>,
    /// Whether whole turns of coordinates are not whole turns of actuators.
    is_geared: bool,
    /// The factor from each joint value that the caller gives to its coordinate, and the number of that coordinate.
    chosen: Vec<(usize, f64)>,
}

impl Actuators {
    /// Of a chain with these parameters.
    pub(crate) fn new(values: &Values<'_>) -> Actuators {
        let chain = values.chain;
        let drive = (!chain.is_direct()).then(|| {
            let numbers =
                |m: &[Vec<Poly>]| m.iter().map(|row| row.iter().map(|p| values.formula(p)).collect()).collect();
            let (adjugate, det) = adjugate(&chain.drive);
            Matrices { rows: numbers(&chain.drive), adjugate: numbers(&adjugate), det: values.formula(&det) }
        });
        Actuators {
            shifts: (0..chain.dof()).map(|i| values.shift(i)).collect(),
            drive,
            revolute: chain.joints.iter().map(|j| matches!(j.coordinate, Coordinate::Angle(_))).collect(),
            is_geared: chain.is_geared(),
            chosen: chain.chosen().into_iter().map(|(joint, factor)| (joint, values.formula(&factor))).collect(),
        }
    }

    /// Joint values from coordinates.
    pub(crate) fn of<const N: usize>(&self, x: &[f64; N]) -> [f64; N] {
        let shifted: [f64; N] = std::array::from_fn(|i| x[i] - self.shifts[i]);
        match &self.drive {
            None => shifted,
            Some(Matrices { adjugate, det, .. }) => {
                std::array::from_fn(|i| adjugate[i].iter().zip(&shifted).map(|(k, x)| k * x).sum::<f64>() / det)
            }
        }
    }

    /// The coordinate that a given joint value makes: number `index` of those that the caller chooses.
    pub(crate) fn chosen(&self, index: usize, value: f64) -> f64 {
        match self.chosen.get(index) {
            Some((joint, factor)) => factor * value + self.shifts.get(*joint).copied().unwrap_or(0.0),
            None => value,
        }
    }

    /// The drive, where whole turns of coordinates are not whole turns of actuators.
    pub(crate) fn drive<const N: usize>(&self) -> Option<Drive<N>> {
        let Matrices { rows, adjugate, det } = self.drive.as_ref().filter(|_| self.is_geared)?;
        let matrix = |m: &[Vec<f64>], over: f64| std::array::from_fn(|i| std::array::from_fn(|j| m[i][j] / over));
        Some(Drive {
            rows: matrix(rows, 1.0),
            actuators: matrix(adjugate, *det),
            revolute: std::array::from_fn(|i| self.revolute[i]),
        })
    }
}

/// Whether whole turns of coordinates are whole turns of actuators and the other way round, and no slide is coupled.
pub(crate) fn is_whole(chain: &Chain) -> bool {
    let whole = |p: &Poly| p.as_rational().and_then(|x| x.to_i64()).is_some_and(|x| i8::try_from(x).is_ok());
    let revolute = |i: usize| chain.joints.get(i).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    let entries = chain.drive.iter().enumerate().all(|(i, row)| {
        row.iter().enumerate().all(|(j, p)| {
            let alone = if i == j { p.is_one() } else { p.is_zero() };
            whole(p) && (alone || revolute(i) && revolute(j))
        })
    });
    entries && (chain.is_direct() || adjugate(&chain.drive).1.as_rational().is_some_and(|x| x.to_f64().abs() == 1.0))
}
