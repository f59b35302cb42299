//! The geometric Jacobian in numbers.

use super::super::Evaluator;
use super::Spot;
use super::matrix::Rows;
use crate::chain::{Chain, Convention, Coordinate};

impl Spot {
    /// The rows that J stands for.
    pub(super) fn jacobian(&mut self, on: &Evaluator<'_>) -> Option<Rows> {
        self.whole_jacobian(on.chain)?.some_rows(&on.rows)
    }

    /// For the variables q: an axis and a lever for every turning row, a direction for every sliding one.
    pub(in super::super) fn whole_jacobian(&mut self, chain: &Chain) -> Option<Rows> {
        let n = chain.links.len();
        let base = self.product(&chain.base);
        let tip = base.times(&self.transform(0, n, chain)?).times(&self.product(&chain.tool));
        let actuators = chain.dof();
        let mut cells = vec![0.0; 6 * actuators];
        for (joint, drive) in chain.joints.iter().zip(&chain.drive) {
            let frame = match chain.convention {
                Convention::Standard => joint.row,
                Convention::Modified => joint.row + 1,
            };
            let axis = base.times(&self.transform(0, frame, chain)?);
            let z = [axis.at(0, 2), axis.at(1, 2), axis.at(2, 2)];
            let arm = [0, 1, 2].map(|i| tip.at(i, 3) - axis.at(i, 3));
            let column = match joint.coordinate {
                Coordinate::Angle(_) => {
                    let linear = [0, 1, 2].map(|i| {
                        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                        z[j] * arm[k] - z[k] * arm[j]
                    });
                    [linear, z]
                }
                Coordinate::Length(_) => [z, [0.0; 3]],
            };
            for (actuator, k) in drive.iter().enumerate() {
                let k = self.numbers.evaluate(k);
                for (row, x) in column.iter().flatten().enumerate() {
                    if let Some(cell) = cells.get_mut(row * actuators + actuator) {
                        *cell += k * x;
                    }
                }
            }
        }
        Some(Rows { columns: actuators, cells })
    }
}
