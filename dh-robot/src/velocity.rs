//! Velocities: the Jacobian in other axes and its derivative, how far an arm is from a singular pose, and joint speeds for a tool's velocity.
//!
//! A twist is the velocity of the tool as the Jacobian gives it: three linear components (of the origin of the last frame, or of the tool),
//! then three angular ones, in base axes. Generated robots have functions of similar names, which call these.

use nalgebra::{IsometryMatrix3, SMatrix, Vector3, Vector6};

use crate::Real;
use crate::math::sqrt;

/// A singular value below this is damped by [`solve_velocity`]: lengths over the arm's size, angles in radians.
pub const DAMPED_BELOW: f64 = 0.02;

/// Most rounds over all pairs of columns: six or seven columns need at most ten.
const ROUNDS: usize = 16;

/// Joint speeds for a twist, and what they cost in accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSpeeds<T: Real, const N: usize> {
    /// The joint speeds: radians, or the table's unit of length for sliding joints, per unit of time.
    pub speeds: [T; N],
    /// The greatest damping factor that was used; 0 where the pose is not near a singular one, and the speeds are exact then.
    pub damping: T,
    /// The part of the twist that the joint speeds do not give: by damping, or since the arm cannot move so.
    pub missed: Vector6<T>,
}

/// A Jacobian in base axes, turned into the axes of `pose`: both the linear and the angular rows.
pub fn in_axes_of<T: Real, const N: usize>(pose: &IsometryMatrix3<T>, jacobian: &SMatrix<T, 6, N>) -> SMatrix<T, 6, N> {
    let mut out = *jacobian;
    for mut column in out.column_iter_mut() {
        let (v, w) = (Vector3::new(column[0], column[1], column[2]), Vector3::new(column[3], column[4], column[5]));
        let (v, w) = (pose.rotation.inverse() * v, pose.rotation.inverse() * w);
        column.copy_from(&Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z));
    }
    out
}

/// The time derivative of a serial arm's Jacobian at given joint speeds, from its columns alone.
///
/// The columns are in the order of the joints from base to tool, in base axes, for a point that moves with the tool. Joint i turns what
/// follows it, and moves the tool away from what precedes it:
///
/// ```text
/// d(v_j, w_j)/dq_i = (w_i x v_j, w_i x w_j)   for i <= j
///                    (w_j x v_i, 0)           for i >  j
/// ```
///
/// (Bruyninckx and De Schutter, Symbolic differentiation of the velocity mapping for a serial kinematic chain, Mechanism and Machine
/// Theory 31(2), 1996). The sums over i are formed once, so that the whole costs two or three cross products a joint.
pub fn jacobian_dot<T: Real, const N: usize>(jacobian: &SMatrix<T, 6, N>, speeds: &[T; N]) -> SMatrix<T, 6, N> {
    let linear = |j: usize| Vector3::new(jacobian[(0, j)], jacobian[(1, j)], jacobian[(2, j)]);
    let angular = |j: usize| Vector3::new(jacobian[(3, j)], jacobian[(4, j)], jacobian[(5, j)]);
    // The velocity that the joints behind the one at hand give the tool, and the angular velocity of the joints up to it.
    let mut behind = [Vector3::zeros(); N];
    let mut sum = Vector3::zeros();
    for j in (0..N).rev() {
        behind[j] = sum;
        sum += linear(j) * speeds[j];
    }
    let mut turning = Vector3::zeros();
    let mut out = SMatrix::<T, 6, N>::zeros();
    for j in 0..N {
        let (v, w) = (linear(j), angular(j));
        turning += w * speeds[j];
        let (v, w) = (turning.cross(&v) + w.cross(&behind[j]), turning.cross(&w));
        out.column_mut(j).copy_from(&Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z));
    }
    out
}

/// [`jacobian_dot`] for an arm with coupled drives.
///
/// `rows` says how far each moving row of the table moves by each actuator, `actuators` is its inverse; Jacobian and speeds are those of the
/// actuators.
pub fn jacobian_dot_coupled<T: Real, const N: usize>(
    jacobian: &SMatrix<T, 6, N>,
    speeds: &[T; N],
    rows: &[[f64; N]; N],
    actuators: &[[f64; N]; N],
) -> SMatrix<T, 6, N> {
    let product = |matrix: &SMatrix<T, 6, N>, by: &[[f64; N]; N]| {
        SMatrix::<T, 6, N>::from_fn(|i, j| (0..N).fold(T::zero(), |sum, k| sum + matrix[(i, k)] * T::of(by[k][j])))
    };
    let mut of_rows = [T::zero(); N];
    for (speed, row) in of_rows.iter_mut().zip(rows) {
        *speed = row.iter().zip(speeds).fold(T::zero(), |sum, (k, s)| sum + T::of(*k) * *s);
    }
    product(&jacobian_dot(&product(jacobian, actuators), &of_rows), rows)
}

/// The singular values of a Jacobian as it is (rows in units of length and in radians), the greatest first: six, or `N` where there
/// are fewer joints, the rest of the array is zero. NaN where the Jacobian is not finite.
pub fn singular_values<T: Real, const N: usize>(jacobian: &SMatrix<T, 6, N>) -> [T; 6] {
    let mut out = [T::zero(); 6];
    if !jacobian.iter().all(|x| x.is_finite()) {
        return [T::of(f64::NAN); 6];
    }
    let factors = Factors::of(jacobian);
    for (to, i) in out.iter_mut().zip(factors.order) {
        *to = sqrt(factors.squares[i]);
    }
    out
}

/// Yoshikawa's manipulability: the product of the singular values, `sqrt(det(J J^T))`, or `sqrt(det(J^T J))` for fewer than six joints.
/// Zero at singular poses; rows are in units of length and in radians, so that it changes with the unit.
///
/// (Yoshikawa, Manipulability of robotic mechanisms, International Journal of Robotics Research 4(2), 1985.)
pub fn manipulability<T: Real, const N: usize>(jacobian: &SMatrix<T, 6, N>) -> T {
    singular_values(jacobian).iter().take(N).fold(T::one(), |product, s| product * *s)
}

/// The smallest singular value of a Jacobian as it is: the least twist that a joint motion of length 1 gives (for more than six joints:
/// in the hardest direction). Zero at singular poses.
pub fn smallest_singular_value<T: Real, const N: usize>(jacobian: &SMatrix<T, 6, N>) -> T {
    singular_values(jacobian)[N.clamp(1, 6) - 1]
}

/// The joint speeds that give a twist, the shortest where there are several, the nearest where there are none; damped near singular poses.
///
/// Lengths are taken over `size`, the arm's size, so that all singular values are plain numbers. One of them, `s`, that is below
/// [`DAMPED_BELOW`] is damped, alone (numerical filtering: Maciejewski and Klein, Numerical filtering for the operation of robotic
/// manipulators through kinematically singular configurations, Journal of Robotic Systems 5(6), 1988): `1/s` becomes `s/(s^2 + d^2)` with
/// `d^2 = (DAMPED_BELOW^2 - s^2)/4`. So speeds change without a jump and stay below `1.16 / DAMPED_BELOW` times the twist in each
/// direction, and the directions that are not singular are exact.
/// The result says the damping and what of the twist is missed. Where a number is not finite the speeds are NaN.
pub fn solve_velocity<T: Real, const N: usize>(
    jacobian: &SMatrix<T, 6, N>,
    twist: &Vector6<T>,
    size: T,
) -> JointSpeeds<T, N> {
    let nan = T::of(f64::NAN);
    if !jacobian.iter().chain(twist.iter()).all(|x| x.is_finite()) {
        return JointSpeeds { speeds: [nan; N], damping: nan, missed: Vector6::repeat(nan) };
    }
    // A sliding joint (a column without angular velocity) has its speed in lengths over the size too.
    let unit = |j: usize| if (3..6).all(|i| jacobian[(i, j)] == T::zero()) { size } else { T::one() };
    let over = |i: usize| if i < 3 { T::one() / size } else { T::one() };
    let scaled = SMatrix::<T, 6, N>::from_fn(|i, j| jacobian[(i, j)] * over(i) * unit(j));
    let goal = Vector6::from_fn(|i, _| twist[i] * over(i));
    let factors = Factors::of(&scaled);
    let threshold = T::of(DAMPED_BELOW * DAMPED_BELOW);
    let (mut speeds, mut largest) = ([T::zero(); N], T::zero());
    for i in factors.order.into_iter().take(N) {
        let square = factors.squares[i];
        let damping = (threshold - square).max(T::zero()) * T::of(0.25);
        largest = largest.max(damping);
        let part = dot(&factors.images[i], &goal.into()) / (square + damping);
        for (j, speed) in speeds.iter_mut().enumerate() {
            *speed += factors.directions[i][j] * part * unit(j);
        }
    }
    let missed = *twist - *jacobian * SMatrix::<T, N, 1>::from(speeds);
    JointSpeeds { speeds, damping: sqrt(largest), missed }
}

/// A matrix times a rotation has orthogonal columns: its singular value decomposition.
struct Factors<T, const N: usize> {
    /// The orthogonal columns: each a left singular vector times its singular value.
    images: [[T; 6]; N],
    /// The right singular vectors, one per image.
    directions: [[T; N]; N],
    /// The squares of the singular values.
    squares: [T; N],
    /// The images from the greatest on; entries from `N` on are zero.
    order: [usize; 6],
}

impl<T: Real, const N: usize> Factors<T, N> {
    /// One-sided Jacobi (Hestenes 1958; Golub and Van Loan, Matrix Computations, 8.6.3) of a finite matrix.
    fn of(matrix: &SMatrix<T, 6, N>) -> Self {
        let mut images: [[T; 6]; N] = core::array::from_fn(|j| core::array::from_fn(|i| matrix[(i, j)]));
        let mut directions: [[T; N]; N] =
            core::array::from_fn(|j| core::array::from_fn(|i| if i == j { T::one() } else { T::zero() }));
        let total: T = images.iter().fold(T::zero(), |sum, column| sum + dot(column, column));
        let nothing = total * T::EPSILON * T::EPSILON;
        for _ in 0..ROUNDS {
            let mut turned = false;
            for i in 0..N {
                for j in i + 1..N {
                    let (a, b) = (dot(&images[i], &images[i]), dot(&images[j], &images[j]));
                    let g = dot(&images[i], &images[j]);
                    if a.min(b) <= nothing || g.abs() <= T::EPSILON * sqrt(a * b) {
                        continue;
                    }
                    turned = true;
                    let ratio = (b - a) / (g + g);
                    let sign = if ratio < T::zero() { -T::one() } else { T::one() };
                    let tangent = sign / (ratio.abs() + sqrt(T::one() + ratio * ratio));
                    let c = T::one() / sqrt(T::one() + tangent * tangent);
                    turn(&mut images, i, j, c, c * tangent);
                    turn(&mut directions, i, j, c, c * tangent);
                }
            }
            if !turned {
                break;
            }
        }
        let squares = images.map(|column| dot(&column, &column));
        let mut order = [0; 6];
        let mut taken = [false; N];
        for place in order.iter_mut().take(N) {
            let mut best = None;
            for k in 0..N {
                if !taken[k] && best.is_none_or(|b: usize| squares[k] > squares[b]) {
                    best = Some(k);
                }
            }
            if let Some(k) = best {
                (*place, taken[k]) = (k, true);
            }
        }
        Factors { images, directions, squares, order }
    }
}

fn dot<T: Real, const D: usize>(a: &[T; D], b: &[T; D]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (x, y)| sum + *x * *y)
}

/// Turns two vectors of a list in their plane, by the angle of cosine `c` and sine `s`.
fn turn<T: Real, const D: usize, const K: usize>(list: &mut [[T; D]; K], i: usize, j: usize, c: T, s: T) {
    for k in 0..D {
        let (x, y) = (list[i][k], list[j][k]);
        list[i][k] = c * x - s * y;
        list[j][k] = s * x + c * y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix with entries that follow no rule.
    fn some<const N: usize>(seed: f64) -> SMatrix<f64, 6, N> {
        SMatrix::from_fn(|i, j| (seed + 3.7 * i as f64 + 1.3 * (j * j) as f64).sin())
    }

    fn agrees<const N: usize>(j: &SMatrix<f64, 6, N>) {
        let big = nalgebra::DMatrix::from_fn(6, N, |i, k| j[(i, k)]);
        let mut wanted: Vec<f64> = big.singular_values().iter().copied().collect();
        wanted.sort_by(|a, b| b.total_cmp(a));
        for (a, b) in singular_values(j).iter().zip(&wanted) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
        let product: f64 = wanted.iter().product();
        assert!((manipulability(j) - product).abs() < 1e-12);
        assert!((smallest_singular_value(j) - wanted[wanted.len() - 1]).abs() < 1e-13);
    }

    #[test]
    fn singular_values_are_those_of_nalgebra() {
        for seed in 0..20 {
            agrees(&some::<1>(f64::from(seed)));
            agrees(&some::<4>(f64::from(seed)));
            agrees(&some::<6>(f64::from(seed)));
            agrees(&some::<9>(f64::from(seed)));
        }
        agrees(&SMatrix::<f64, 6, 6>::repeat(1.0));
        agrees(&SMatrix::<f64, 6, 7>::zeros());
    }

    #[test]
    fn speeds_are_exact_away_from_singular_poses_and_bounded_at_them() {
        let twist = Vector6::new(0.1, -0.2, 0.3, 0.4, 0.5, -0.6);
        let mut j = SMatrix::<f64, 6, 7>::from_fn(|i, k| if i == k { 1.0 } else { 0.1 * some::<7>(0.4)[(i, k)] });
        let found = solve_velocity(&j, &twist, 1.0);
        assert_eq!(found.damping, 0.0);
        assert!(found.missed.norm() < 1e-14 && (j * SMatrix::from(found.speeds) - twist).norm() < 1e-14);
        for small in [0.0, 1e-9, 1e-3, 0.01] {
            j = SMatrix::from_fn(|i, k| {
                if i != k {
                    0.0
                } else if i == 3 {
                    small
                } else {
                    1.0
                }
            });
            let found = solve_velocity(&j, &twist, 1.0);
            assert!(found.damping > 0.0 && found.speeds[3].abs() <= 1.16 / DAMPED_BELOW * 0.4);
            assert!((0..6).all(|i| i == 3 || found.missed[i].abs() < 1e-14));
            assert!((found.missed[3] + small * found.speeds[3] - 0.4).abs() < 1e-14);
        }
        j[(0, 0)] = f64::NAN;
        assert!(solve_velocity(&j, &twist, 1.0).speeds.iter().all(|x| x.is_nan()));
        assert!(smallest_singular_value(&j).is_nan());
    }

    #[test]
    fn the_unit_of_length_changes_nothing() {
        let (j, twist) = (some::<5>(0.3), Vector6::new(0.1, -0.2, 0.3, 0.4, 0.5, -0.6));
        let mut slides = j;
        slides.fixed_view_mut::<3, 1>(3, 2).fill(0.0);
        let longer = |i: usize| if i < 3 { 1000.0 } else { 1.0 };
        let millimetres = SMatrix::<f64, 6, 5>::from_fn(|i, k| slides[(i, k)] * if k == 2 { 1.0 } else { longer(i) });
        let a = solve_velocity(&slides, &twist, 1.2);
        let b = solve_velocity(&millimetres, &Vector6::from_fn(|i, _| twist[i] * longer(i)), 1200.0);
        for k in 0..5 {
            let b = b.speeds[k] / if k == 2 { 1000.0 } else { 1.0 };
            assert!((a.speeds[k] - b).abs() < 1e-12, "{k}");
        }
    }
}
