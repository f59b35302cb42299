//! Points, directions and rotations in space, as floating-point numbers.

use std::f64::consts::PI;

pub(super) use dh_kernels::vector::{cross, dot, norm};

/// A point or a direction.
pub(super) type Vector = [f64; 3];

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn scale(a: Vector, k: f64) -> Vector {
    a.map(|x| x * k)
}

/// The direction of a vector; as it is, where it is zero.
pub(super) fn unit(a: Vector) -> Vector {
    let n = norm(a);
    if n > 0.0 { scale(a, 1.0 / n) } else { a }
}

/// The part of `a` that is perpendicular to the unit vector `z`.
pub(super) fn across(a: Vector, z: Vector) -> Vector {
    minus(a, scale(z, dot(a, z)))
}

/// Cosine and sine; exact zeros, halves and ones at multiples of 90 and 30 degrees.
pub(super) fn cos_sin(angle: f64) -> (f64, f64) {
    let steps = (angle * 12.0 / PI).round();
    if (angle - steps * PI / 12.0).abs() > 4.0 * f64::EPSILON * angle.abs().max(1.0) || steps.abs() > 1e6 {
        return (angle.cos(), angle.sin());
    }
    let table = |n: i64| -> f64 {
        let n = n.rem_euclid(24);
        let n = if n > 12 { 24 - n } else { n };
        let (n, sign) = if n > 6 { (12 - n, -1.0) } else { (n, 1.0) };
        let value = match n {
            0 => 1.0,
            1 => (PI / 12.0).cos(),
            2 => 3f64.sqrt() / 2.0,
            3 => 0.5f64.sqrt(),
            4 => 0.5,
            5 => (PI / 12.0).sin(),
            _ => 0.0,
        };
        sign * value
    };
    (table(steps as i64), table(steps as i64 - 6))
}

/// A rotation; the columns are the turned coordinate axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rotation(pub(super) [Vector; 3]);

impl Rotation {
    pub(super) const IDENTITY: Rotation = Rotation([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// About coordinate axis 0, 1 or 2.
    pub(super) fn about(axis: usize, angle: f64) -> Rotation {
        let (c, s) = cos_sin(angle);
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut r = Rotation::IDENTITY;
        r.0[j][j] = c;
        r.0[j][k] = s;
        r.0[k][k] = c;
        r.0[k][j] = -s;
        r
    }

    /// About a unit vector (Rodrigues).
    pub(super) fn about_vector(n: Vector, angle: f64) -> Rotation {
        let (c, s) = cos_sin(angle);
        let column = |v: Vector| {
            let along = scale(n, dot(n, v) * (1.0 - c));
            add(add(scale(v, c), scale(cross(n, v), s)), along)
        };
        Rotation(Rotation::IDENTITY.0.map(column))
    }

    /// Roll, pitch and yaw: fixed axes x, y, z, in this order.
    pub(super) fn rpy([roll, pitch, yaw]: [f64; 3]) -> Rotation {
        Rotation::about(2, yaw).times(&Rotation::about(1, pitch)).times(&Rotation::about(0, roll))
    }

    /// The turned vector.
    pub(super) fn apply(&self, v: Vector) -> Vector {
        let [x, y, z] = self.0;
        add(add(scale(x, v[0]), scale(y, v[1])), scale(z, v[2]))
    }

    /// This rotation after the other.
    pub(super) fn times(&self, other: &Rotation) -> Rotation {
        Rotation(other.0.map(|column| self.apply(column)))
    }

    /// The inverse.
    pub(super) fn back(&self) -> Rotation {
        Rotation(std::array::from_fn(|i| std::array::from_fn(|j| self.0[j][i])))
    }

    /// The angle by which it turns, accurate for small ones too.
    pub(super) fn angle(&self) -> f64 {
        let [x, y, z] = self.0;
        let s = norm([y[2] - z[1], z[0] - x[2], x[1] - y[0]]) / 2.0;
        let c = (x[0] + y[1] + z[2] - 1.0) / 2.0;
        s.atan2(c)
    }
}

/// A pose: rotation and position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub(super) r: Rotation,
    pub(super) p: Vector,
}

impl Pose {
    pub(super) const IDENTITY: Pose = Pose { r: Rotation::IDENTITY, p: [0.0; 3] };

    /// The product.
    pub(super) fn times(&self, other: &Pose) -> Pose {
        Pose { r: self.r.times(&other.r), p: self.apply(other.p) }
    }

    /// The point that `v` is carried to.
    pub(super) fn apply(&self, v: Vector) -> Vector {
        add(self.r.apply(v), self.p)
    }

    /// The inverse.
    pub(super) fn back(&self) -> Pose {
        let r = self.r.back();
        Pose { p: scale(r.apply(self.p), -1.0), r }
    }

    pub(super) fn turned(axis: usize, angle: f64) -> Pose {
        Pose { r: Rotation::about(axis, angle), p: [0.0; 3] }
    }

    pub(super) fn shifted(axis: usize, length: f64) -> Pose {
        let mut p = [0.0; 3];
        p[axis] = length;
        Pose { r: Rotation::IDENTITY, p }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(Rotation::rpy([PI / 2.0, 0.0, -PI / 2.0]).0, [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]]);
        let (c, s) = cos_sin(7.0 * PI / 6.0);
        assert_eq!((c, s), (-(3f64.sqrt()) / 2.0, -0.5));
        for i in -50..50 {
            let angle = f64::from(i) * PI / 12.0;
            let (c, s) = cos_sin(angle);
            assert!((c - angle.cos()).abs() < 1e-14 && (s - angle.sin()).abs() < 1e-14, "{i}");
        }
        let tilted = Rotation::about_vector(unit([1.0, 2.0, 3.0]), 0.3);
        assert!((tilted.angle() - 0.3).abs() < 1e-15);
    }
}
