//! The solutions of an inverse: a list on the stack with the joints' ranges and the reason if it is empty.

use core::fmt;
use core::iter::Take;
use core::ops::{Deref, DerefMut};

use crate::{Branch, Joint, Real, Solution, Why};

/// Every solution of a target, each once: at most `M` joint vectors of length `N`.
///
/// It derefs to a slice of [`Solution`], is made without a heap, and says why where it is empty. Generated code fills it;
/// hand-written solvers can do so with [`Solutions::new`], [`push`](Solutions::push) and [`refuse`](Solutions::refuse).
///
/// ```
/// use dh_robot::{Branch, Elbow, Joint, Solution, Solutions, Why};
///
/// static JOINTS: [Joint; 2] = [Joint::revolute("q1"), Joint::revolute("q2").with_range(0.0, 2.5)];
///
/// let mut solutions: Solutions<f64, 2, 2> = Solutions::new(&JOINTS);
/// let (up, down) = (Branch::ANY.with_elbow(Elbow::Up), Branch::ANY.with_elbow(Elbow::Down));
/// solutions.push(Solution::new([0.3, 0.8], down));
/// solutions.push(Solution::new([1.1, -0.8], up));
///
/// assert_eq!(solutions.len(), 2);
/// assert_eq!(solutions.why(), Why::Solved);
/// assert_eq!(solutions.closest_to(&[1.0, -1.0]).unwrap().branch, up);
/// assert_eq!(solutions.with_branch(down).unwrap().q, [0.3, 0.8]);
/// for solution in &solutions.within_range() {
///     assert!(solution.q[1] >= 0.0);
/// }
/// ```
#[derive(Clone, Copy)]
pub struct Solutions<T: 'static, const N: usize, const M: usize> {
    list: [Solution<T, N>; M],
    len: usize,
    why: Why<T>,
    joints: &'static [Joint<T>; N],
}

impl<T: Real, const N: usize, const M: usize> Solutions<T, N, M> {
    /// No solutions yet, of a robot with these joints.
    #[inline]
    pub fn new(joints: &'static [Joint<T>; N]) -> Self {
        Self::none(joints, Why::NoSolution)
    }

    /// As many solutions as there can be, with their joint values as they are.
    #[inline(always)]
    pub fn full(joints: &'static [Joint<T>; N], list: [Solution<T, N>; M]) -> Self {
        Self { list, len: M, why: Why::NoSolution, joints }
    }

    /// No solutions, and why.
    #[inline]
    pub fn none(joints: &'static [Joint<T>; N], why: Why<T>) -> Self {
        Self { list: [Solution::default(); M], len: 0, why, joints }
    }

    /// Adds a solution with its joint values as they are; beyond `M` solutions nothing happens. Says whether it was added.
    #[inline]
    pub fn push(&mut self, solution: Solution<T, N>) -> bool {
        match self.list.get_mut(self.len) {
            Some(place) => {
                *place = solution;
                self.len += 1;
                true
            }
            None => false,
        }
    }

    /// Adds a solution unless an earlier one is the same within `tolerance` at every joint, whole turns apart, and brings
    /// its angles where [`Joint::normalize`] wants them. Says whether it was added.
    ///
    /// A double root, where two branches meet, is one solution: it keeps the first branch, and the free joints of both.
    pub fn insert(&mut self, mut solution: Solution<T, N>, tolerance: T) -> bool {
        let joints = self.joints;
        for known in self.iter_mut() {
            let same = |((joint, a), b): ((&Joint<T>, &T), &T)| joint.difference(*a, *b) <= tolerance;
            if joints.iter().zip(&known.q).zip(&solution.q).all(same) {
                known.free = known.free.union(solution.free);
                return false;
            }
        }
        for (joint, value) in joints.iter().zip(&mut solution.q) {
            *value = joint.normalize(*value);
        }
        self.push(solution)
    }

    /// Notes why a branch gave nothing. Of several reasons the nearest miss is kept: see [`Why::or_nearer`].
    #[inline]
    pub fn refuse(&mut self, why: Why<T>) {
        self.why = self.why.or_nearer(why);
    }

    /// The solutions as a slice.
    #[inline]
    pub fn as_slice(&self) -> &[Solution<T, N>] {
        self.list.get(..self.len).unwrap_or(&[])
    }

    /// How many solutions there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none; [`why`](Self::why) tells the reason.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// [`Why::Solved`] if there are solutions, else the reason why not.
    #[inline]
    pub fn why(&self) -> Why<T> {
        if self.len > 0 { Why::Solved } else { self.why }
    }

    /// The solutions, or the reason why there is none as an error.
    ///
    /// # Errors
    ///
    /// Any [`Why`] but [`Why::Solved`].
    #[inline]
    pub fn or_why(self) -> Result<Self, Why<T>> {
        if self.len > 0 { Ok(self) } else { Err(self.why) }
    }

    /// The joints of the robot.
    #[inline]
    pub fn joints(&self) -> &'static [Joint<T>; N] {
        self.joints
    }

    /// The solution nearest to `q`; `None` only if there is none. Of equally near ones it is the first.
    ///
    /// Nearest means the least sum of squared joint movements, in radians and in the table's unit of length. Turning
    /// joints are compared modulo whole turns, whatever their range; [`toward`](Self::toward) looks at the range and
    /// gives the values to move to.
    pub fn closest_to(&self, q: &[T; N]) -> Option<&Solution<T, N>> {
        let distance = |s: &Solution<T, N>| sum_of_squares(self.joints, &s.q, q, Joint::difference);
        let mut best = self.first()?;
        let mut least = distance(best);
        for solution in self.get(1..)? {
            let d = distance(solution);
            if d < least {
                (best, least) = (solution, d);
            }
        }
        Some(best)
    }

    /// Where to go from `q`: the solution that needs the least movement, with every angle shifted by the whole turns that
    /// bring it nearest to `q` within the joint's range. `None` if there is no solution, or a value of `q` is not
    /// finite.
    ///
    /// Nearest means the least sum of squared differences of the values as returned. Solutions out of range count as well;
    /// ask [`within_range`](Self::within_range) first to leave them out.
    pub fn toward(&self, q: &[T; N]) -> Option<Solution<T, N>> {
        // From nowhere there is no way.
        if !q.iter().all(|x| x.is_finite()) {
            return None;
        }
        let straight = |_: &Joint<T>, a: T, b: T| a - b;
        let mut best: Option<(T, Solution<T, N>)> = None;
        for solution in self {
            let mut shifted = *solution;
            for ((joint, value), reference) in self.joints.iter().zip(&mut shifted.q).zip(q) {
                *value = joint.nearest_to(*reference, *value);
            }
            let d = sum_of_squares(self.joints, &shifted.q, q, straight);
            if best.is_none_or(|(least, _)| d < least) {
                best = Some((d, shifted));
            }
        }
        best.map(|(_, solution)| solution)
    }

    /// The first solution whose branch is as `wanted` says, in everything that it says; see [`Branch::agrees_with`].
    #[inline]
    pub fn with_branch(&self, wanted: Branch) -> Option<&Solution<T, N>> {
        self.iter().find(|solution| solution.branch.agrees_with(wanted))
    }

    /// The solutions whose branch is as `wanted` says; see [`Branch::agrees_with`].
    #[must_use]
    pub fn in_branch(&self, wanted: Branch) -> Self {
        let mut kept = Self { why: self.why, ..Self::new(self.joints) };
        self.iter().filter(|s| s.branch.agrees_with(wanted)).for_each(|s| _ = kept.push(*s));
        kept
    }

    /// The solutions within limits that are known while the program runs: the least and the greatest value of every joint, both included.
    /// Angles are shifted by whole turns where that brings them between their limits.
    ///
    /// If none is left, [`why`](Self::why) is [`Why::OutOfRange`], or what it was before.
    #[must_use]
    pub fn within(&self, limits: &[(T, T); N]) -> Self {
        let mut kept = Self::new(self.joints);
        for solution in self {
            let mut inside = *solution;
            let mut all = true;
            for ((joint, value), (least, greatest)) in self.joints.iter().zip(&mut inside.q).zip(limits) {
                let limited = joint.with_range(*least, *greatest);
                *value = limited.normalize(*value);
                all &= limited.contains(*value);
                *value = limited.clamp(*value);
            }
            if all {
                kept.push(inside);
            }
        }
        kept.why = if self.len > 0 { Why::OutOfRange { solutions: self.len } } else { self.why };
        kept
    }

    /// The solution nearest to `q` as [`closest_to`](Self::closest_to), with a weight for the movement of every joint: its square is multiplied
    /// by the weight. `None` only if there is no solution.
    pub fn closest_by(&self, q: &[T; N], weights: &[T; N]) -> Option<&Solution<T, N>> {
        let distance = |s: &Solution<T, N>| {
            let parts = self.joints.iter().zip(&s.q).zip(q).zip(weights);
            parts.fold(T::zero(), |sum, (((joint, a), b), weight)| {
                let d = joint.difference(*a, *b);
                sum + *weight * d * d
            })
        };
        let mut best = self.first()?;
        for solution in self.get(1..)? {
            if distance(solution) < distance(best) {
                best = solution;
            }
        }
        Some(best)
    }

    /// The solutions that keep every joint in its range. Values beyond a limit by round-off only are put on the limit.
    ///
    /// If none is left, [`why`](Self::why) is [`Why::OutOfRange`], or what it was before.
    pub fn within_range(&self) -> Self {
        let mut kept = Self::new(self.joints);
        for solution in self {
            let mut inside = *solution;
            if self.joints.iter().zip(&inside.q).all(|(joint, value)| joint.contains(*value)) {
                for (joint, value) in self.joints.iter().zip(&mut inside.q) {
                    *value = joint.clamp(*value);
                }
                kept.push(inside);
            }
        }
        kept.why = if self.len > 0 { Why::OutOfRange { solutions: self.len } } else { self.why };
        kept
    }
}

/// The sum of squared joint differences.
#[inline]
fn sum_of_squares<T: Real, const N: usize>(
    joints: &[Joint<T>; N],
    a: &[T; N],
    b: &[T; N],
    difference: impl Fn(&Joint<T>, T, T) -> T,
) -> T {
    let mut sum = T::zero();
    for ((joint, a), b) in joints.iter().zip(a).zip(b) {
        let d = difference(joint, *a, *b);
        sum += d * d;
    }
    sum
}

impl<T: Real, const N: usize, const M: usize> Deref for Solutions<T, N, M> {
    type Target = [Solution<T, N>];

    #[inline]
    fn deref(&self) -> &[Solution<T, N>] {
        self.as_slice()
    }
}

impl<T: Real, const N: usize, const M: usize> DerefMut for Solutions<T, N, M> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [Solution<T, N>] {
        self.list.get_mut(..self.len).unwrap_or(&mut [])
    }
}

impl<T: Real, const N: usize, const M: usize> IntoIterator for Solutions<T, N, M> {
    type Item = Solution<T, N>;
    type IntoIter = Take<core::array::IntoIter<Solution<T, N>, M>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter().take(self.len)
    }
}

impl<'a, T: Real, const N: usize, const M: usize> IntoIterator for &'a Solutions<T, N, M> {
    type Item = &'a Solution<T, N>;
    type IntoIter = core::slice::Iter<'a, Solution<T, N>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: Real, const N: usize, const M: usize> PartialEq for Solutions<T, N, M> {
    /// The same solutions in the same order, for the same reason.
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice() && self.why() == other.why()
    }
}

impl<T: Real, const N: usize, const M: usize> fmt::Debug for Solutions<T, N, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Solutions").field("list", &self.as_slice()).field("why", &self.why()).finish_non_exhaustive()
    }
}

impl<T: Real, const N: usize, const M: usize> fmt::Display for Solutions<T, N, M> {
    /// A line per solution, or the reason why there is none.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return self.why.fmt(f);
        }
        for (i, solution) in self.iter().enumerate() {
            if i > 0 {
                f.write_str("\n")?;
            }
            solution.fmt(f)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
