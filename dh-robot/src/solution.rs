//! One solution of an inverse: joint values, its branch, and the joints that are free.

use core::fmt;

use crate::{Branch, FreeJoints, Real};

/// Joint values that reach the target.
///
/// Its memory is that of C's `struct { T q[N]; uint64_t branch; uint32_t free_joints; }`: exported libraries hand it out as it is.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<T, const N: usize> {
    /// The joint values: radians, or the table's unit of length for sliding joints. Angles are in `(-pi, pi]`, shifted by
    /// whole turns into the joint's range where that fits.
    pub q: [T; N],
    /// Which alternatives were taken: shoulder, elbow, wrist.
    pub branch: Branch,
    /// The joints that are free at this pose, which is singular then: `q` is one of infinitely many solutions.
    pub free: FreeJoints,
}

impl<T: Real, const N: usize> Solution<T, N> {
    /// A solution of a regular pose.
    #[inline]
    pub fn new(q: [T; N], branch: Branch) -> Self {
        Self { q, branch, free: FreeJoints::NONE }
    }

    /// The solution at a singular pose, where these joints are free.
    #[inline]
    pub fn with_free(self, free: FreeJoints) -> Self {
        Self { free, ..self }
    }
}

impl<T: Real, const N: usize> Default for Solution<T, N> {
    /// All joints at zero.
    #[inline]
    fn default() -> Self {
        Self::new([T::zero(); N], Branch::ANY)
    }
}

impl<T: Real, const N: usize> fmt::Display for Solution<T, N> {
    /// `[0.1000, -1.2000] (elbow up; q4, q6 free)`, with four decimals unless the format asks for others.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = f.precision().unwrap_or(4);
        f.write_str("[")?;
        for (i, value) in self.q.iter().enumerate() {
            write!(f, "{}{value:.digits$}", if i == 0 { "" } else { ", " })?;
        }
        f.write_str("]")?;
        match (self.branch != Branch::ANY, !self.free.is_empty()) {
            (false, false) => Ok(()),
            (true, false) => write!(f, " ({})", self.branch),
            (false, true) => write!(f, " ({} free)", self.free),
            (true, true) => write!(f, " ({}; {} free)", self.branch, self.free),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Elbow;

    #[test]
    fn solutions_print_what_they_know() {
        let plain = Solution::new([0.1, -1.2], Branch::ANY);
        assert_eq!(plain.to_string(), "[0.1000, -1.2000]");
        assert_eq!(format!("{plain:.1}"), "[0.1, -1.2]");
        let named = Solution::new([0.5_f32], Branch::ANY.with_elbow(Elbow::Up));
        assert_eq!(named.to_string(), "[0.5000] (elbow up)");
        let free = FreeJoints::of(&[3, 5]);
        assert_eq!(named.with_free(free).to_string(), "[0.5000] (elbow up; q4, q6 free)");
        assert_eq!(plain.with_free(free).to_string(), "[0.1000, -1.2000] (q4, q6 free)");
    }

    #[test]
    fn a_six_axis_solution_is_one_cache_line() {
        assert_eq!(size_of::<Solution<f64, 6>>(), 64);
    }
}
