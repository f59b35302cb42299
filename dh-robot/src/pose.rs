//! Checks that target poses are rigid transforms, and measures the distance of two poses.

use nalgebra::{Isometry3, IsometryMatrix3, Matrix3, Matrix4, Rotation3, Translation3, Vector3};

use crate::math::{atan2, sqrt};
use crate::{Real, Why};

/// Checks a target: all entries finite, and the matrix a rotation within [`Real::ROTATION_TOLERANCE`].
///
/// # Errors
///
/// [`Why::NotFinite`] and [`Why::NotARotation`]. A reflection (determinant -1) has deviation 2.
///
/// ```
/// use dh_robot::{Why, nalgebra::IsometryMatrix3, pose};
///
/// let mut target = IsometryMatrix3::translation(0.4, 0.0, 0.3);
/// assert_eq!(pose::check(&target), Ok(()));
/// target.translation.x = f64::NAN;
/// assert_eq!(pose::check(&target), Err(Why::NotFinite));
/// ```
#[inline]
pub fn check<T: Real>(pose: &IsometryMatrix3<T>) -> Result<(), Why<T>> {
    let deviation = rotation_deviation(pose.rotation.matrix());
    // A deviation that is not a number fails the comparison.
    if deviation <= T::ROTATION_TOLERANCE && pose.translation.vector.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Err(reason(pose, deviation))
}

#[cold]
fn reason<T: Real>(pose: &IsometryMatrix3<T>, deviation: T) -> Why<T> {
    let finite = |x: &T| x.is_finite();
    if pose.translation.vector.iter().all(finite) && pose.rotation.matrix().iter().all(finite) {
        Why::NotARotation { deviation }
    } else {
        Why::NotFinite
    }
}

/// How far a matrix is from a rotation: the largest entry of `R^T R - 1`, or 2 if its determinant is negative.
///
/// NaN or infinite if an entry is.
#[inline]
pub fn rotation_deviation<T: Real>(r: &Matrix3<T>) -> T {
    let (x, y, z) = (r.column(0), r.column(1), r.column(2));
    let one = T::one();
    let entries = [x.dot(&x) - one, y.dot(&y) - one, z.dot(&z) - one, x.dot(&y), y.dot(&z), z.dot(&x)];
    let mut largest = T::zero();
    for entry in entries {
        largest = largest.max(entry.abs());
    }
    // The greatest ignores what is not a number; the sum does not.
    let sum = entries[0] + entries[1] + entries[2] + entries[3] + entries[4] + entries[5];
    if !sum.is_finite() {
        return sum;
    }
    if r.determinant() < T::zero() { T::of(2.0) } else { largest }
}

/// A pose from its entries: the rotation row by row, as printed, and the position.
#[inline]
pub fn from_entries<T: Real>(rows: [[T; 3]; 3], position: [T; 3]) -> IsometryMatrix3<T> {
    let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = rows;
    let matrix = Matrix3::new(xx, yx, zx, xy, yy, zy, xz, yz, zz);
    let [x, y, z] = position;
    IsometryMatrix3::from_parts(Translation3::new(x, y, z), Rotation3::from_matrix_unchecked(matrix))
}

/// The same pose with its rotation as a matrix instead of a quaternion.
#[inline]
pub fn from_quaternion<T: Real>(pose: &Isometry3<T>) -> IsometryMatrix3<T> {
    IsometryMatrix3::from_parts(pose.translation, pose.rotation.to_rotation_matrix())
}

/// The same pose with its rotation as a quaternion instead of a matrix.
#[inline]
pub fn to_quaternion<T: Real>(pose: &IsometryMatrix3<T>) -> Isometry3<T> {
    Isometry3::from_parts(pose.translation, nalgebra::UnitQuaternion::from_rotation_matrix(&pose.rotation))
}

/// The pose of a homogeneous matrix.
///
/// # Errors
///
/// As [`check`]; a last row that is not `0 0 0 1` within the same tolerance is [`Why::NotARotation`] too.
pub fn from_matrix<T: Real>(matrix: &Matrix4<T>) -> Result<IsometryMatrix3<T>, Why<T>> {
    let rotation: Matrix3<T> = matrix.fixed_view::<3, 3>(0, 0).into_owned();
    let position: Vector3<T> = matrix.fixed_view::<3, 1>(0, 3).into_owned();
    let pose = IsometryMatrix3::from_parts(position.into(), Rotation3::from_matrix_unchecked(rotation));
    check(&pose)?;
    let last = [matrix[(3, 0)], matrix[(3, 1)], matrix[(3, 2)], matrix[(3, 3)] - T::one()];
    let mut deviation = T::zero();
    for entry in last {
        if !entry.is_finite() {
            return Err(Why::NotFinite);
        }
        deviation = deviation.max(entry.abs());
    }
    if deviation > T::ROTATION_TOLERANCE { Err(Why::NotARotation { deviation }) } else { Ok(pose) }
}

/// The rows of the homogeneous matrix of a pose: what programs in other languages pass around.
#[inline]
pub fn to_rows<T: Real>(pose: &IsometryMatrix3<T>) -> [[T; 4]; 4] {
    let (r, p) = (pose.rotation.matrix(), &pose.translation.vector);
    let row = |i: usize| [r[(i, 0)], r[(i, 1)], r[(i, 2)], p[i]];
    [row(0), row(1), row(2), [T::zero(), T::zero(), T::zero(), T::one()]]
}

/// The pose of a homogeneous matrix given by its rows. An exact last row makes it a pose unchecked: functions that take it check the rest.
///
/// # Errors
///
/// Where the last row is not exactly `0 0 0 1`: as [`from_matrix`].
#[inline]
pub fn from_rows<T: Real>(rows: &[[T; 4]; 4]) -> Result<IsometryMatrix3<T>, Why<T>> {
    let [[xx, yx, zx, x], [xy, yy, zy, y], [xz, yz, zz, z], [a, b, c, d]] = *rows;
    let zero = T::zero();
    if a == zero && b == zero && c == zero && d == T::one() {
        return Ok(from_entries([[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]], [x, y, z]));
    }
    from_matrix(&Matrix4::from(*rows).transpose())
}

/// The pose with the rotation that is nearest to its matrix: for targets that lost digits on the way.
///
/// Newton's iteration `R <- R (3 - R^T R) / 2`, which converges for matrices less than half off (entries of
/// `R^T R - 1` below about 0.5); farther off the result is no rotation either, and [`check`] says so.
///
/// ```
/// use dh_robot::pose;
///
/// let rounded = pose::from_entries([[0.866, -0.5, 0.0], [0.5, 0.866, 0.0], [0.0, 0.0, 1.0]], [0.1, 0.2, 0.3]);
/// assert!(pose::check(&rounded).is_err());
/// assert!(pose::check(&pose::orthonormalized(&rounded)).is_ok());
/// ```
pub fn orthonormalized<T: Real>(pose: &IsometryMatrix3<T>) -> IsometryMatrix3<T> {
    let mut r = *pose.rotation.matrix();
    for _ in 0..8 {
        if rotation_deviation(&r) <= T::of(4.0) * T::EPSILON {
            break;
        }
        r = r * (Matrix3::identity() * T::of(3.0) - r.transpose() * r) * T::of(0.5);
    }
    IsometryMatrix3::from_parts(pose.translation, Rotation3::from_matrix_unchecked(r))
}

/// The greatest deviation (largest entry of `R^T R - 1`) of a matrix that [`nearest_rotation`] accepts: that of a rotation whose entries are off by up
/// to 1e-3.
pub const NEAREST: f64 = 4e-3;

/// The pose with the rotation nearest to its matrix, and by how much that was off: the largest entry of `R^T R - 1`. For targets with three to
/// five decimals.
///
/// # Errors
/// [`Why::NotARotation`] where the deviation is more than [`NEAREST`], [`Why::NotFinite`].
///
/// ```
/// use dh_robot::pose;
///
/// let rounded = pose::from_entries([[0.866, -0.5, 0.0], [0.5, 0.866, 0.0], [0.0, 0.0, 1.0]], [0.1, 0.2, 0.3]);
/// let (near, deviation) = pose::nearest_rotation(&rounded)?;
/// assert!(pose::check(&near).is_ok() && (deviation - 4.4e-5_f64).abs() < 1e-6);
/// # Ok::<(), dh_robot::Why>(())
/// ```
pub fn nearest_rotation<T: Real>(pose: &IsometryMatrix3<T>) -> Result<(IsometryMatrix3<T>, T), Why<T>> {
    let deviation = rotation_deviation(pose.rotation.matrix());
    let finite = pose.translation.vector.iter().all(|x| x.is_finite());
    // A deviation that is not a number fails the comparison.
    if finite && deviation <= T::of(NEAREST) {
        return Ok((orthonormalized(pose), deviation));
    }
    Err(reason(pose, deviation))
}

/// How far two poses are apart: the distance of their origins, and the angle of the rotation between them in `[0, pi]`.
///
/// The angle is accurate for small and for large rotations (no inverse cosine is taken).
pub fn distance<T: Real>(a: &IsometryMatrix3<T>, b: &IsometryMatrix3<T>) -> (T, T) {
    let apart = (a.translation.vector - b.translation.vector).norm();
    let r = a.rotation.matrix().transpose() * b.rotation.matrix();
    let axis = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]);
    let twice_sine = sqrt(axis.dot(&axis));
    let twice_cosine = r.trace() - T::one();
    (apart, atan2(twice_sine, twice_cosine))
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use super::*;

    fn some_pose() -> IsometryMatrix3<f64> {
        IsometryMatrix3::new(Vector3::new(0.1, -0.2, 0.3), Vector3::new(0.4, 1.5, -0.6))
    }

    #[test]
    fn poses_pass_and_small_errors_too() {
        assert_eq!(check(&some_pose()), Ok(()));
        let mut matrix = *some_pose().rotation.matrix();
        matrix[(1, 2)] += 3e-7;
        let rounded = IsometryMatrix3::from_parts(some_pose().translation, Rotation3::from_matrix_unchecked(matrix));
        assert_eq!(check(&rounded), Ok(()));
        assert_eq!(check(&some_pose().cast::<f32>()), Ok(()));
    }

    #[test]
    fn each_entry_is_looked_at() {
        let pose = some_pose();
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for i in 0..3 {
                let mut p = pose.translation.vector;
                p[i] = bad;
                let moved = IsometryMatrix3::from_parts(p.into(), pose.rotation);
                assert_eq!(check(&moved), Err(Why::NotFinite), "position {i} = {bad}");
                for j in 0..3 {
                    let mut r = *pose.rotation.matrix();
                    r[(i, j)] = bad;
                    let turned = IsometryMatrix3::from_parts(pose.translation, Rotation3::from_matrix_unchecked(r));
                    assert_eq!(check(&turned), Err(Why::NotFinite), "entry {i} {j} = {bad}");
                    r[(i, j)] = pose.rotation.matrix()[(i, j)] + 1e-3;
                    let turned = IsometryMatrix3::from_parts(pose.translation, Rotation3::from_matrix_unchecked(r));
                    assert!(matches!(check(&turned), Err(Why::NotARotation { .. })), "entry {i} {j}");
                }
            }
        }
    }

    #[test]
    fn each_pair_of_columns_is_looked_at() {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let mut sheared = *some_pose().rotation.matrix();
            let column = sheared.column(i) + sheared.column(j) * 1e-3;
            sheared.set_column(i, &column);
            assert!((rotation_deviation(&sheared) - 1e-3).abs() < 1e-9, "{i} {j}");
        }
    }

    #[test]
    fn scaled_and_reflected_matrices_are_not_rotations() {
        let scaled = from_entries([[1.1, 0.0, 0.0], [0.0, 1.1, 0.0], [0.0, 0.0, 1.1]], [0.0; 3]);
        assert!((rotation_deviation(scaled.rotation.matrix()) - 0.21_f64).abs() < 1e-12);
        assert!(matches!(check(&scaled), Err(Why::NotARotation { .. })));
        let mirror = from_entries([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], [0.0; 3]);
        assert_eq!(check(&mirror), Err(Why::NotARotation { deviation: 2.0 }));
        let zero = from_entries([[0.0; 3]; 3], [0.0; 3]);
        assert_eq!(check(&zero), Err(Why::NotARotation { deviation: 1.0 }));
    }

    #[test]
    fn entries_are_rows() {
        let pose = from_entries([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [1.0, 2.0, 3.0]);
        assert_eq!(pose.rotation * Vector3::x(), Vector3::y());
        assert_eq!(from_matrix(&pose.to_homogeneous()), Ok(pose));
    }

    #[test]
    fn homogeneous_matrices_are_checked() {
        let mut matrix = some_pose().to_homogeneous();
        matrix[(3, 3)] = 2.0;
        assert_eq!(from_matrix(&matrix), Err(Why::NotARotation { deviation: 1.0 }));
        matrix[(3, 0)] = f64::NAN;
        assert_eq!(from_matrix(&matrix), Err(Why::NotFinite));
    }

    #[test]
    fn rows_go_there_and_back() {
        let mut rows = to_rows(&some_pose());
        assert_eq!(from_rows(&rows), Ok(some_pose()));
        assert_eq!(rows[1][3], -0.2);
        rows[3][3] = 1.0 + 1e-9;
        assert_eq!(from_rows(&rows), Ok(some_pose()));
        rows[3][1] = 0.5;
        assert_eq!(from_rows(&rows), Err(Why::NotARotation { deviation: 0.5 }));
        rows[3][1] = f64::NAN;
        assert_eq!(from_rows(&rows), Err(Why::NotFinite));
    }

    #[test]
    fn quaternions_go_there_and_back() {
        let pose = some_pose();
        let (apart, turn) = distance(&pose, &from_quaternion(&to_quaternion(&pose)));
        assert!(apart == 0.0 && turn < 1e-15);
    }

    #[test]
    fn distances_are_accurate_at_both_ends() {
        let pose = some_pose();
        for angle in [0.0, 1e-12, 1e-6, 1.0, PI - 1e-6, PI] {
            let turned = pose * IsometryMatrix3::rotation(Vector3::new(0.6, 0.0, 0.8) * angle);
            let (_, turn) = distance(&pose, &turned);
            assert!((turn - angle).abs() < 1e-15 + 1e-14 * angle, "{angle}: {turn}");
        }
        let moved = IsometryMatrix3::translation(3.0, 4.0, 0.0) * pose;
        assert!((distance(&pose, &moved).0 - 5.0).abs() < 1e-14);
    }

    #[test]
    fn hopeless_matrices_stay_refused() {
        for rows in [[[0.0; 3]; 3], [[f64::NAN; 3]; 3], [[1e200; 3]; 3]] {
            assert!(check(&orthonormalized(&from_entries(rows, [0.0; 3]))).is_err());
        }
    }
}
