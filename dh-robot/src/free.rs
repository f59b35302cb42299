//! The set of joints that are free at a singular pose.

use core::fmt;

/// Joints that may move, together or alone, without moving the tool: empty at regular poses.
///
/// Joints are counted from 0, as in `q`; printed they are `q1`, `q2`, ..., as in the table. Indices from 32 on are not kept.
///
/// ```
/// use dh_robot::FreeJoints;
///
/// let wrist = FreeJoints::of(&[3, 5]);
/// assert!(wrist.contains(3) && !wrist.contains(4));
/// assert_eq!(wrist.to_string(), "q4, q6");
/// assert_eq!(wrist.iter().collect::<Vec<_>>(), [3, 5]);
/// ```
#[repr(transparent)]
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FreeJoints(u32);

impl FreeJoints {
    /// No joint: the pose is regular.
    pub const NONE: Self = Self(0);

    /// The set of these joints.
    pub const fn of(indices: &[usize]) -> Self {
        let mut set = Self::NONE;
        let mut i = 0;
        while i < indices.len() {
            set = set.with(indices[i]);
            i += 1;
        }
        set
    }

    /// The set with one joint more.
    #[inline]
    pub const fn with(self, index: usize) -> Self {
        if index < 32 { Self(self.0 | 1 << index) } else { self }
    }

    /// The joints that are in either set.
    #[inline]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether the two sets have a joint in common.
    #[inline]
    pub const fn intersects(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Whether the joint is free.
    #[inline]
    pub const fn contains(self, index: usize) -> bool {
        index < 32 && self.0 >> index & 1 == 1
    }

    /// Whether no joint is free.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many joints are free.
    #[inline]
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The set as a number: bit `i` is joint `i`.
    #[inline]
    pub const fn to_bits(self) -> u32 {
        self.0
    }

    /// The indices of the free joints, rising.
    #[inline]
    pub const fn iter(self) -> FreeJointsIter {
        FreeJointsIter(self.0)
    }
}

impl IntoIterator for FreeJoints {
    type Item = usize;
    type IntoIter = FreeJointsIter;

    fn into_iter(self) -> FreeJointsIter {
        self.iter()
    }
}

impl fmt::Display for FreeJoints {
    /// `q4, q6`; nothing for the empty set.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, index) in self.iter().enumerate() {
            write!(f, "{}q{}", if position == 0 { "" } else { ", " }, index + 1)?;
        }
        Ok(())
    }
}

impl fmt::Debug for FreeJoints {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{{{self}}}")
    }
}

/// The indices in a [`FreeJoints`], rising.
#[derive(Clone, Debug)]
pub struct FreeJointsIter(u32);

impl Iterator for FreeJointsIter {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let index = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        Some(index)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let len = self.0.count_ones() as usize;
        (len, Some(len))
    }
}

impl ExactSizeIterator for FreeJointsIter {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_constants_and_combine() {
        const WRIST: FreeJoints = FreeJoints::of(&[5, 3, 3]);
        assert_eq!((WRIST.len(), WRIST.to_bits()), (2, 0b10_1000));
        assert_eq!(WRIST.union(FreeJoints::NONE.with(0)).to_string(), "q1, q4, q6");
        assert_eq!(format!("{WRIST:?}"), "{q4, q6}");
        assert_eq!(FreeJoints::NONE.to_string(), "");
        assert!(FreeJoints::default().is_empty());
    }

    #[test]
    fn the_last_index_fits_and_later_ones_are_ignored() {
        assert!(FreeJoints::of(&[31]).contains(31));
        assert!(FreeJoints::of(&[32, usize::MAX]).is_empty());
        assert!(!FreeJoints::of(&[0]).contains(32));
        assert_eq!(FreeJoints::of(&[0, 31]).iter().len(), 2);
    }
}
