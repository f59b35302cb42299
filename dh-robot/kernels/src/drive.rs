//! Drives where one joint turn is not a whole number of actuator turns.

use super::elementary::floor;

/// How actuators move the rows of a table: row = `rows` times actuator values, actuators = `actuators` times row values.
///
/// A whole turn of a row that turns leaves the arm where it was. What the actuators do meanwhile is a column of `actuators`, times 2 pi; joint
/// values that differ by such columns are one solution.
#[derive(Clone, Copy, Debug)]
pub struct Drive<const N: usize> {
    /// From actuators to rows.
    pub rows: [[f64; N]; N],
    /// From rows to actuators.
    pub actuators: [[f64; N]; N],
    /// The rows that turn.
    pub revolute: [bool; N],
}

const TAU: f64 = core::f64::consts::TAU;
/// What rounding may add beyond a limit of a range.
const EDGE: f64 = 1e-9;

impl<const N: usize> Drive<N> {
    /// A difference of actuator values without whole turns of the rows: each row turns by at most half a turn.
    #[must_use]
    pub fn shortest(&self, difference: [f64; N]) -> [f64; N] {
        let mut out = difference;
        for (i, row) in self.rows.iter().enumerate().filter(|(i, _)| self.revolute[*i]) {
            let angle: f64 = row.iter().zip(&difference).map(|(k, x)| k * x).sum();
            self.turn(&mut out, i, -floor(angle / TAU + 0.5));
        }
        out
    }

    /// The same actuator values but for whole turns of the rows: each row is turned by an angle in (-pi, pi], except those that would
    /// move an actuator whose value is `given`.
    #[must_use]
    pub fn principal(&self, q: [f64; N], given: &[Option<f64>; N]) -> [f64; N] {
        let mut out = q;
        let stays = |i: usize| given.iter().zip(&self.actuators).any(|(g, actuator)| g.is_some() && actuator[i] != 0.0);
        for (i, row) in self.rows.iter().enumerate().filter(|(i, _)| self.revolute[*i] && !stays(*i)) {
            let angle: f64 = row.iter().zip(&q).map(|(k, x)| k * x).sum();
            self.turn(&mut out, i, floor(0.5 - angle / TAU));
        }
        out
    }

    /// Turns rows by whole turns, as few as possible, so that all actuators come into their ranges, where that can be done one row after the
    /// other.
    pub fn into_ranges(&self, ranges: &[Option<(f64, f64)>; N], q: &mut [f64; N]) {
        let outside = |q: &[f64; N]| {
            let inside = |(x, range): (&f64, &Option<(f64, f64)>)| {
                range.is_none_or(|(least, greatest)| *x >= least - EDGE && *x <= greatest + EDGE)
            };
            !q.iter().zip(ranges).all(inside)
        };
        if !outside(q) {
            return;
        }
        let mut out = *q;
        let mut open = self.revolute;
        for _ in 0..N {
            // A row that alone still moves some actuator with a range; without one, the first.
            let others = |k: usize, i: usize| (0..N).any(|j| j != i && open[j] && self.actuators[k][j] != 0.0);
            let decides = |k: usize, i: usize| ranges[k].is_some() && self.actuators[k][i] != 0.0 && !others(k, i);
            let next = (0..N).find(|i| open[*i] && (0..N).any(|k| decides(k, *i)));
            let Some(i) = next.or_else(|| (0..N).find(|i| open[*i])) else { break };
            let (mut fewest, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
            for k in (0..N).filter(|k| decides(*k, i)) {
                let Some((least, greatest)) = ranges[k] else { continue };
                let turn = TAU * self.actuators[k][i];
                let (a, b) = ((least - EDGE - out[k]) / turn, (greatest + EDGE - out[k]) / turn);
                fewest = fewest.max(-floor(-a.min(b)));
                most = most.min(floor(a.max(b)));
            }
            if !(fewest <= most) {
                return;
            }
            self.turn(&mut out, i, fewest.max(most.min(0.0)));
            open[i] = false;
        }
        if !outside(&out) {
            *q = out;
        }
    }

    /// Turns a row by whole turns.
    fn turn(&self, q: &mut [f64; N], row: usize, turns: f64) {
        for (x, k) in q.iter_mut().zip(&self.actuators) {
            *x += TAU * turns * k[row];
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;

    /// theta1 = q1 / 2, theta2 = q2 + q1 / 2.
    const GEARS: Drive<2> =
        Drive { rows: [[0.5, 0.0], [0.5, 1.0]], actuators: [[2.0, 0.0], [-1.0, 1.0]], revolute: [true, true] };

    #[test]
    fn a_whole_turn_of_a_row_is_nothing() {
        let far = GEARS.shortest([0.25 + 4.0 * PI, 0.5 - 2.0 * PI]);
        assert!((far[0] - 0.25).abs() < 1e-12 && (far[1] - 0.5).abs() < 1e-12, "{far:?}");
        // A whole turn of the first actuator is half a turn of both rows.
        let half = GEARS.shortest([2.0 * PI - 0.1, 0.0]);
        assert!((half[0].abs() - 2.0 * PI + 0.1).abs() < 1e-12, "{half:?}");
    }

    #[test]
    fn rows_come_to_less_than_a_turn() {
        let near = GEARS.principal([4.0 * PI + 0.2, 0.5 - 2.0 * PI], &[None; 2]);
        assert!((near[0] - 0.2).abs() < 1e-12 && (near[1] - 0.5).abs() < 1e-12, "{near:?}");
        assert_eq!(GEARS.principal([2.0 * PI, -PI], &[None; 2]), [2.0 * PI, -PI]);
        let half = GEARS.principal([-2.0 * PI, PI], &[None; 2]);
        assert!((half[0] - 2.0 * PI).abs() < 1e-12 && (half[1] + PI).abs() < 1e-12, "{half:?}");
        let given = GEARS.principal([9.0 * PI, 0.0], &[Some(9.0 * PI), None]);
        assert!((given[0] - 9.0 * PI).abs() < 1e-12 && (given[1] + 4.0 * PI).abs() < 1e-12, "{given:?}");
    }

    #[test]
    fn motors_come_into_their_ranges() {
        let mut q = [-PI, 0.5];
        GEARS.into_ranges(&[Some((0.0, 4.0 * PI)), Some((-PI, PI))], &mut q);
        assert!((q[0] - 3.0 * PI).abs() < 1e-12 && (q[1] - 0.5).abs() < 1e-12, "{q:?}");
        // Nothing fits: it stays.
        let mut q = [-PI, 0.5];
        GEARS.into_ranges(&[Some((0.0, PI)), None], &mut q);
        assert_eq!(q, [-PI, 0.5]);
        let mut q = [f64::NAN, 0.5];
        GEARS.into_ranges(&[Some((0.0, PI)), None], &mut q);
        assert!(q[0].is_nan() && q[1] == 0.5);
    }
}
