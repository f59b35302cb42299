//! The result of a kernel: its roots, and the reason for their number.

use core::ops::Deref;

use super::elementary::sqrt;
use super::list::{Blank, List};

/// How far (relative) a double root in one step may put the next one out of reach: a root of multiplicity four is good to 1e-4.
const GRAZE: f64 = 1e-4;

/// Why a kernel found as many solutions as it did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// All solutions, well apart.
    Regular,
    /// All solutions, but at least one is a double one, or nearly: the boundary of the workspace, or of a branch of it.
    Touching,
    /// No solution: the equation asks for `needed`, and no angle gives more than `available`.
    OutOfReach {
        /// What the equation asks for, in the unit of its right-hand side.
        needed: f64,
        /// What an angle can give.
        available: f64,
    },
    /// No solution: all roots of the equation are complex, or a coefficient isn't finite.
    NoRealRoot,
    /// The equations say nothing about an unknown, or admit a curve of solutions.
    Free,
}

impl Outcome {
    /// Whether a step without a root may have one that rounding hides, or a loss of rank.
    ///
    /// A right-hand side that is clearly out of reach isn't, unless the coefficients on the other side are next to nothing; the roots of
    /// polynomials don't say by how much they are not real.
    pub fn may_hide_a_root(&self) -> bool {
        match *self {
            Self::OutOfReach { needed, available } => !(needed > 1.05 * available && available > 1e-4),
            Self::NoRealRoot => true,
            Self::Regular | Self::Touching | Self::Free => false,
        }
    }

    /// For a law of cosines that is out of reach: the distance that is asked for, and the limit that it passes.
    ///
    /// With `[base, rest]` the squared distance is `base + rest`, and `rest = a cos u + b sin u`. Where `grows`, the amplitude of the right
    /// side is proportional to the distance, else it is constant.
    pub fn distances(&self, [base, rest]: [f64; 2], grows: bool) -> Option<[f64; 2]> {
        let Self::OutOfReach { available, .. } = *self else { return None };
        let distance = sqrt((base + rest).max(0.0));
        let available = if rest > 0.0 { available } else { -available };
        let limit = if grows {
            // distance^2 = base + slope distance; of two limits the near one where the target is too near.
            let half = 0.5 * available / distance;
            let root = sqrt((base + half * half).max(0.0));
            if distance < half { half - root } else { half + root }
        } else {
            sqrt((base + available).max(0.0))
        };
        Some([distance, limit.max(0.0)])
    }

    /// Whether the excess over the limit is so small that the error of a double root in an earlier step may be the reason.
    pub fn just_misses_a_root(&self) -> bool {
        matches!(*self, Self::OutOfReach { needed, available } if needed > available && needed <= available * (1.0 + GRAZE))
    }
}

/// Up to `N` solutions, and the reason for their number; derefs to a slice.
#[derive(Clone, Copy, Debug)]
pub struct Roots<T, const N: usize> {
    /// The solutions, each once.
    pub roots: List<T, N>,
    /// Why there are as many.
    pub outcome: Outcome,
}

/// Angles, each as a point `[cos, sin]` of the unit circle.
pub type Angles<const N: usize> = Roots<[f64; 2], N>;

impl<T: Blank, const N: usize> Roots<T, N> {
    /// No solution, because of `outcome`.
    #[inline]
    pub(super) fn none(outcome: Outcome) -> Self {
        Self { roots: List::new(), outcome }
    }

    /// Takes `representative` where every value is a solution, and changes nothing elsewhere.
    #[inline]
    #[must_use]
    pub fn or_if_free(mut self, representative: T) -> Self {
        if self.is_free() && self.roots.is_empty() {
            self.roots.push(representative);
        }
        self
    }

    /// Whether there is at least one solution and all are well apart.
    #[inline]
    pub fn is_regular(&self) -> bool {
        self.outcome == Outcome::Regular
    }

    /// Whether the equations leave an unknown free.
    #[inline]
    pub fn is_free(&self) -> bool {
        self.outcome == Outcome::Free
    }
}

impl<T: Blank, const N: usize> Deref for Roots<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        &self.roots
    }
}

impl<'a, T: Blank, const N: usize> IntoIterator for &'a Roots<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;
    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.roots.as_slice().iter()
    }
}
