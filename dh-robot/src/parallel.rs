//! Inverse kinematics of many targets on all cores, with the feature `rayon`.

use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::{InverseKinematics, Real, Solution, Why};

/// Targets that a core takes at a time: some tens of microseconds of work, against one for handing it over.
const SHARE: usize = 64;

/// Batches on all cores, for every robot that has an inverse.
///
/// ```
/// use dh_robot::{ParallelInverse, Solutions, Why, dh_robot};
/// use dh_robot::nalgebra::Point3;
///
/// dh_robot! {
///     struct Planar;
///     convention = standard;
///     task = position;
///     | theta | d | a | alpha |
///     | q1    | 0 | 1 | 0     |
///     | q2    | 0 | 1 | 0     |
/// }
///
/// let targets: Vec<_> = (0..1000).map(|i| Point3::new(0.002 * f64::from(i), 0.5, 0.0)).collect();
/// let mut solutions = vec![Solutions::none(&Planar::JOINTS, Why::NoSolution); targets.len()];
/// Planar.par_inverse_batch(&targets, &mut solutions);
/// assert_eq!(solutions[500].len(), 2);
/// ```
pub trait ParallelInverse<const N: usize, T: Real = f64>: InverseKinematics<N, T> + Sync {
    /// All solutions of every target: as many as the shorter slice holds; what lies beyond stays as it is. Each result is that of the single call.
    fn par_inverse_batch(&self, targets: &[Self::Target], solutions: &mut [Self::Solutions])
    where
        Self::Target: Sync,
        Self::Solutions: Send,
    {
        targets.par_chunks(SHARE).zip(solutions.par_chunks_mut(SHARE)).for_each(|(targets, solutions)| {
            for (target, to) in targets.iter().zip(solutions) {
                *to = self.inverse(target);
            }
        });
    }

    /// The solution that continues from `q`, of every target and joint vector of the same place: as many as the shortest slice holds.
    fn par_inverse_near_batch(
        &self,
        targets: &[Self::Target],
        q: &[[T; N]],
        solutions: &mut [Result<Solution<T, N>, Why<T>>],
    ) where
        Self::Target: Sync,
    {
        let given = targets.par_chunks(SHARE).zip(q.par_chunks(SHARE));
        given.zip(solutions.par_chunks_mut(SHARE)).for_each(|((targets, q), solutions)| {
            for ((target, q), to) in targets.iter().zip(q).zip(solutions) {
                *to = self.inverse_near(target, q);
            }
        });
    }
}

impl<const N: usize, T: Real, A: InverseKinematics<N, T> + Sync> ParallelInverse<N, T> for A {}
