//! Rigid transforms as plain arrays of three rows and four columns: products, inverses, and the rotation between two of them.

use super::elementary::{atan2, sqrt};
pub use super::vector::{cross, dot};

/// A rigid transform, the upper three rows `[R | p]` of its homogeneous matrix.
pub type Pose = [[f64; 4]; 3];

/// The transform that changes nothing.
pub const IDENTITY: Pose = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

/// `a * b`.
#[inline]
pub fn compose(a: &Pose, b: &Pose) -> Pose {
    let mut out = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..4 {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
        out[i][3] += a[i][3];
    }
    out
}

/// The inverse of a rigid transform: `[R^T | -R^T p]`.
#[inline]
pub fn inverse(a: &Pose) -> Pose {
    let mut out = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..3 {
            out[i][j] = a[j][i];
        }
        out[i][3] = -(a[0][i] * a[0][3] + a[1][i] * a[1][3] + a[2][i] * a[2][3]);
    }
    out
}

/// `a * Rz(t)` with `[cos t, sin t]` given.
#[inline]
pub fn turn(a: &Pose, [c, s]: [f64; 2]) -> Pose {
    let mut out = *a;
    for row in &mut out {
        let (x, y) = (row[0], row[1]);
        row[0] = x * c + y * s;
        row[1] = y * c - x * s;
    }
    out
}

/// `a * Tz(d)`.
#[inline]
pub fn slide(a: &Pose, d: f64) -> Pose {
    let mut out = *a;
    for row in &mut out {
        row[3] += row[2] * d;
    }
    out
}

/// The rotation vector (axis times angle in `[0, pi]`) that turns the rotation of `from` into that of `to`, in base axes.
///
/// Half a turn has two such vectors; either may come back.
pub fn rotation_between(from: &Pose, to: &Pose) -> [f64; 3] {
    // E = R_to R_from^T, with antisymmetric part sin(angle) [axis] and trace 1 + 2 cos(angle).
    let mut e = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            e[i][j] = to[i][0] * from[j][0] + to[i][1] * from[j][1] + to[i][2] * from[j][2];
        }
    }
    let v = [0.5 * (e[2][1] - e[1][2]), 0.5 * (e[0][2] - e[2][0]), 0.5 * (e[1][0] - e[0][1])];
    let cos = 0.5 * (e[0][0] + e[1][1] + e[2][2] - 1.0);
    let sin = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if cos > 0.0 && sin < 1e-4 {
        // angle / sin(angle) = 1 + sin^2 / 6 + ..., and the next term is below rounding.
        let factor = 1.0 + sin * sin / 6.0;
        return v.map(|x| x * factor);
    }
    let angle = atan2(sin, cos);
    if cos > -0.99 {
        return v.map(|x| x * angle / sin);
    }
    // Near half a turn the symmetric part gives the axis: E + E^T = 2 cos + 2 (1 - cos) axis axis^T.
    let k = if e[0][0] >= e[1][1] && e[0][0] >= e[2][2] {
        0
    } else if e[1][1] >= e[2][2] {
        1
    } else {
        2
    };
    let mut axis = [0.0; 3];
    for i in 0..3 {
        axis[i] = 0.5 * (e[i][k] + e[k][i]);
    }
    axis[k] -= cos;
    let n = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    let sign = if dot(axis, v) < 0.0 { -1.0 } else { 1.0 };
    axis.map(|x| sign * x * angle / n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{Rng, random_pose};

    #[test]
    fn inverse_undoes() {
        let mut rng = Rng::new(4);
        let a = random_pose(&mut rng);
        let e = compose(&a, &inverse(&a));
        for i in 0..3 {
            for j in 0..4 {
                assert!((e[i][j] - IDENTITY[i][j]).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn rotation_vector_has_the_angle_and_the_axis_at_every_angle() {
        let mut rng = Rng::new(5);
        for angle in [0.0, 1e-12, 1e-6, 9e-5, 1.1e-4, 0.3, 1.5, 1.6, 2.9, 3.0, 3.1, 3.1413, core::f64::consts::PI] {
            for _ in 0..20 {
                let a = random_pose(&mut rng);
                let axis = random_pose(&mut rng);
                // Turn about the third axis of a random frame: F Rz(angle) F^-1 a.
                let (s, c) = f64::sin_cos(angle);
                let b = compose(&compose(&turn(&axis, [c, s]), &inverse(&axis)), &a);
                let v = rotation_between(&a, &b);
                let along: f64 = (0..3).map(|i| v[i] * axis[i][2]).sum();
                let norm = crate::vector::norm(v);
                assert!((norm - angle).abs() < 1e-14, "{angle} {norm}");
                let along = if angle > 3.1 { along.abs() } else { along };
                assert!((along - angle).abs() < 1e-7 * angle + 1e-15, "{angle} {along}");
            }
        }
    }
}
