//! Detects equivalent equations numerically, before expansion.
//!
//! Frames on one axis, or frames that differ by a turn about one point only, have coordinates and distances in common: of a dozen
//! equations with the same unknowns often two are different.

use super::super::axes::Axes;
use super::super::random::Random;
use super::super::scalar::{Equation, FrameScalar};
use dh_kernels::pose::{self, Pose};

/// Equations whose values (lengths over the length scale) differ by less at generic joint vectors and targets count as one.
const EQUAL: f64 = 1e-10;

/// Joint vectors and targets that are independent of each other.
pub(super) struct Probes(Vec<(Vec<Pose>, Pose)>);

/// Left side minus right side at each probe.
pub(super) type Values = Vec<f64>;

impl Probes {
    pub(super) fn new(axes: &Axes) -> Probes {
        let mut random = Random::new(23);
        let mut frames = || axes.frames_number(&(0..axes.count()).map(|_| 2.3 * random.next()).collect::<Vec<f64>>());
        let target = |f: Vec<Pose>| f.last().copied().unwrap_or(pose::IDENTITY);
        Probes((0..2).map(|_| (frames(), target(frames()))).collect())
    }

    /// The values of an equation that compares two frames; `None` for those across prismatic joints.
    pub(super) fn values(&self, e: &Equation) -> Option<Values> {
        self.0.iter().map(|(frames, target)| value(e, frames, target)).collect()
    }
}

/// Whether two equations are the same, perhaps up to the sign.
pub(super) fn is_same(a: &Values, b: &Values) -> bool {
    [1.0, -1.0].iter().any(|sign| a.iter().zip(b).all(|(a, b)| (a - sign * b).abs() <= EQUAL * (1.0 + a.abs())))
}

fn value(e: &Equation, frames: &[Pose], target: &Pose) -> Option<f64> {
    let (a, b, last) = (pose::inverse(frames.get(e.a)?), frames.get(e.b)?, frames.last()?);
    let left = pose::compose(&a, b);
    // M(0, a)^-1 W M(b, n)^-1
    let right = pose::compose(&pose::compose(&a, target), &pose::compose(&pose::inverse(last), b));
    let scalar = |t: &Pose| match e.scalar {
        FrameScalar::Rotation(i, j) => Some(t[usize::from(i)][usize::from(j)]),
        FrameScalar::Position(i) => Some(t[usize::from(i)][3]),
        FrameScalar::Back(j) => Some(pose::inverse(t)[usize::from(j)][3]),
        FrameScalar::Distance => Some(t.iter().map(|row| row[3] * row[3]).sum()),
        FrameScalar::Across(_) | FrameScalar::Bridge(..) => None,
    };
    Some(scalar(&left)? - scalar(&right)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    #[test]
    fn frames_on_one_axis_have_coordinates_in_common() {
        let rows = [
            (40, "0.3", "0.1", 0),
            (-70, "0.5", "0.2", 0),
            (110, "0.2", "0.3", 0),
            (55, "0.1", "0.4", 0),
            (-85, "0.2", "0.05", 0),
            (25, "0.1", "0.3", 0),
        ];
        let axes = Axes::new(&revolute_chain(Convention::Standard, &rows));
        let probes = Probes::new(&axes);
        let values = |a, b, scalar| probes.values(&Equation { a, b, scalar }).expect("no slides");
        // Frames 1 and 2 stand on the first axis, before and after the shift along it.
        assert!(axes.links[1].joint.is_none());
        let [before, after] = [1, 2].map(|a| values(a, 6, FrameScalar::Position(2)));
        assert!(is_same(&before, &after) && is_same(&before, &after.iter().map(|x| -x).collect()));
        let [before, after] = [1, 2].map(|a| values(a, 6, FrameScalar::Distance));
        assert!(!is_same(&before, &after));
        assert!(!is_same(&values(1, 6, FrameScalar::Position(0)), &values(1, 6, FrameScalar::Position(1))));
    }
}
