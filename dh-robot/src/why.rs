//! The reasons why an inverse has no solutions.

use core::fmt;

use crate::Real;

/// The reason for an empty answer, or that there is none.
///
/// ```
/// use dh_robot::Why;
///
/// let why = Why::OutOfReach { step: "elbow", needs: 1.32, has: 0.86, unit: "m" };
/// assert_eq!(why.to_string(), "elbow: distance 1.320 m exceeds 0.860 m");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Why<T = f64> {
    /// There are solutions.
    Solved,
    /// There is no solution, and no step knows more.
    #[default]
    NoSolution,
    /// An entry of the target, or a joint value given with it, is infinite or not a number.
    NotFinite,
    /// The target's matrix is not a rotation.
    NotARotation {
        /// The largest entry of `R^T R - 1`; 2 for a reflection.
        deviation: T,
    },
    /// The target's axis is not a unit vector.
    NotAUnitVector {
        /// How far the square of its length is from 1.
        deviation: T,
    },
    /// The target is too far away, or too near.
    OutOfReach {
        /// The step of the solution that has no answer.
        step: &'static str,
        /// What the target asks for: a distance, or a pure number such as a sine.
        needs: T,
        /// The limit on the side where it was passed: the greatest that the arm can do, or the least.
        has: T,
        /// The unit of both: `m`, `mm`, or nothing for pure numbers.
        unit: &'static str,
    },
    /// A polynomial of the solution has no real root here.
    NoRealRoot {
        /// The step that solves the polynomial.
        step: &'static str,
    },
    /// The arm has fewer joints than the pose has coordinates, and the pose is not one it can take.
    NotOnTask {
        /// What of the pose the arm cannot do: `its orientation` or `its position`, whichever is farther off (radians against lengths over
        /// the sum of the arm's link lengths).
        what: &'static str,
        /// By how much the target misses, where the arm comes nearest.
        by: T,
        /// The unit of that: of length, `rad`, or nothing.
        unit: &'static str,
    },
    /// No joint values reach the target, although some were found that had to be tried: on arms without a simpler closed form the usual
    /// answer to a target out of reach; on others a sign that the numbers are out of hand.
    NotVerified {
        /// The smallest miss (position over the sum of the link lengths, or radians).
        error: T,
    },
    /// A pose that the program sets (a field of the robot) is no rigid motion, or not one that the arm's task allows.
    UnfitPose {
        /// The field; `base` or `tool` where it is the product.
        of: &'static str,
        /// What is wrong with it, as the rest of a sentence.
        what: &'static str,
    },
    /// There are solutions, but each leaves the range of some joint.
    OutOfRange {
        /// How many solutions there were.
        solutions: usize,
    },
}

impl<T: Real> Why<T> {
    /// Whether there are solutions.
    pub fn is_solved(&self) -> bool {
        matches!(self, Self::Solved)
    }

    /// The reason that says more, of two branches that failed: the one that got nearer to an answer.
    ///
    /// Of two that are out of reach it is the nearer miss; any reason says more than none. If that decides nothing the first
    /// is kept.
    pub fn or_nearer(self, other: Self) -> Self {
        let nearer = match (&self, &other) {
            (Self::NoSolution, _) => true,
            (_, Self::NoSolution) => false,
            (Self::NotVerified { error: known }, Self::NotVerified { error }) => error < known,
            // A candidate is nearer than no candidate.
            (Self::NotVerified { .. }, _) => false,
            (_, Self::NotVerified { .. }) => true,
            (
                Self::OutOfReach { needs: known, has: limit, unit, .. },
                Self::OutOfReach { needs, has, unit: same, .. },
            ) => unit == same && (*needs - *has).abs() < (*known - *limit).abs(),
            _ => false,
        };
        if nearer { other } else { self }
    }
}

/// The decimals that it takes to see the difference of two numbers, between 3 and 15.
fn decimals<T: Real>(a: T, b: T) -> usize {
    let difference = (a - b).abs().to_f64();
    let mut decimals = 3;
    let mut resolution = 2e-3;
    while difference < resolution && decimals < 15 {
        decimals += 3;
        resolution *= 1e-3;
    }
    decimals
}

/// A space and the unit, or nothing.
struct Unit(&'static str);

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() { Ok(()) } else { write!(f, " {}", self.0) }
    }
}

impl<T: Real> fmt::Display for Why<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Solved => f.write_str("solved"),
            Self::NoSolution => f.write_str("no solution"),
            Self::NotFinite => f.write_str("the input holds a number that is not finite"),
            Self::NotARotation { deviation } => {
                write!(f, "the target's matrix is not a rotation: R^T R is off by {deviation:.1e}")?;
                let rounded = deviation <= T::of(crate::pose::NEAREST);
                f.write_str(if rounded { "; `inverse_nearest_rotation` takes the nearest one" } else { "" })
            }
            Self::NotAUnitVector { deviation } => {
                write!(f, "the target's axis is not a unit vector: the square of its length is off by {deviation:.1e}")
            }
            Self::OutOfReach { step, needs, has, unit } => {
                let measure = if unit.is_empty() { "" } else { "distance " };
                let verb = if needs > has { "exceeds" } else { "is below" };
                let (digits, unit) = (decimals(needs, has), Unit(unit));
                if needs > T::of(1e9) {
                    return write!(f, "{step}: {measure}{needs:.3e}{unit} {verb} {has:.3e}{unit}");
                }
                write!(f, "{step}: {measure}{needs:.digits$}{unit} {verb} {has:.digits$}{unit}")
            }
            Self::NoRealRoot { step } => write!(f, "{step}: the equation has no real root"),
            Self::NotOnTask { what, by, unit } => {
                write!(f, "the arm cannot take this pose: {what} is off by {by:.3e}{}", Unit(unit))
            }
            Self::NotVerified { error } => {
                write!(f, "no joint values reach the target: the best candidate misses it by {error:.1e}")
            }
            Self::UnfitPose { of, what } => write!(f, "`{of}` {what}"),
            Self::OutOfRange { solutions: 1 } => f.write_str("the only solution leaves a joint's range"),
            Self::OutOfRange { solutions } => write!(f, "each of the {solutions} solutions leaves a joint's range"),
        }
    }
}

impl<T: Real> core::error::Error for Why<T> {}

#[cfg(test)]
mod tests {
    use super::*;

    fn reach(needs: f64, has: f64, unit: &'static str) -> Why {
        Why::OutOfReach { step: "elbow", needs, has, unit }
    }

    #[test]
    fn every_reason_reads_as_a_sentence() {
        for (why, text) in [
            (Why::Solved, "solved"),
            (Why::NotFinite, "the input holds a number that is not finite"),
            (Why::NotARotation { deviation: 0.25 }, "the target's matrix is not a rotation: R^T R is off by 2.5e-1"),
            (
                Why::NotARotation { deviation: 1e-4 },
                "the target's matrix is not a rotation: R^T R is off by 1.0e-4; `inverse_nearest_rotation` takes the nearest one",
            ),
            (reach(0.1, 0.25, "m"), "elbow: distance 0.100 m is below 0.250 m"),
            (reach(1.000_001, 1.0, ""), "elbow: 1.000001000 exceeds 1.000000000"),
            (
                Why::NotAUnitVector { deviation: 0.5 },
                "the target's axis is not a unit vector: the square of its length is off by 5.0e-1",
            ),
            (Why::NoRealRoot { step: "wrist" }, "wrist: the equation has no real root"),
            (
                Why::NotOnTask { what: "its orientation", by: 0.5, unit: "rad" },
                "the arm cannot take this pose: its orientation is off by 5.000e-1 rad",
            ),
            (
                Why::NotVerified { error: 1e-3 },
                "no joint values reach the target: the best candidate misses it by 1.0e-3",
            ),
            (Why::UnfitPose { of: "gripper", what: "is not a rotation" }, "`gripper` is not a rotation"),
            (Why::OutOfRange { solutions: 1 }, "the only solution leaves a joint's range"),
            (Why::OutOfRange { solutions: 8 }, "each of the 8 solutions leaves a joint's range"),
        ] {
            assert_eq!(why.to_string(), text);
        }
        assert_eq!(Why::<f32>::default().to_string(), "no solution");
    }

    #[test]
    fn the_nearer_miss_is_kept() {
        assert_eq!(reach(1.3, 0.8, "m").or_nearer(reach(0.9, 0.8, "m")), reach(0.9, 0.8, "m"));
        assert_eq!(reach(0.9, 0.8, "m").or_nearer(reach(1.3, 0.8, "m")), reach(0.9, 0.8, "m"));
        assert_eq!(Why::NoSolution.or_nearer(reach(0.9, 0.8, "m")), reach(0.9, 0.8, "m"));
        assert_eq!(reach(0.9, 0.8, "m").or_nearer(Why::NoSolution), reach(0.9, 0.8, "m"));
        let verified = Why::NotVerified { error: 1e-3 };
        assert_eq!(reach(0.9, 0.8, "m").or_nearer(verified), verified);
        assert_eq!(verified.or_nearer(reach(0.9, 0.8, "m")), verified);
        assert_eq!(Why::NotVerified { error: 1e-2 }.or_nearer(verified), verified);
        assert_eq!(verified.or_nearer(Why::NotVerified { error: 1e-2 }), verified);
    }
}
