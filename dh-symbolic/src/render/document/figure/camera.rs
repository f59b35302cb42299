//! From space to the drawing plane: parallel projection, as large as fits.

pub(super) use dh_kernels::vector::{cross, dot};

/// A point or direction in space.
pub(super) type V3 = [f64; 3];

pub(super) fn plus(a: V3, b: V3, k: f64) -> V3 {
    std::array::from_fn(|i| a[i] + k * b[i])
}

pub(super) fn distance(a: V3, b: V3) -> f64 {
    dot(plus(a, b, -1.0), plus(a, b, -1.0)).sqrt()
}

/// Where the drawing is seen from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    /// Towards the eye.
    pub(super) toward: V3,
    right: V3,
    up: V3,
    /// Points of the drawing per unit of length.
    pub(super) scale: f64,
}

impl Camera {
    /// From the right, and a little from above; planar arms from above. All points fit into a square of `size`.
    pub(super) fn of(points: &[V3], flat: bool, size: f64) -> Camera {
        let (azimuth, elevation) =
            if flat { (-std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2) } else { (-0.9, 0.42) };
        let ((sa, ca), (se, ce)) = (f64::sin_cos(azimuth), f64::sin_cos(elevation));
        let toward = [ce * ca, ce * sa, se];
        let right = [-sa, ca, 0.0];
        let mut camera = Camera { toward, right, up: cross(toward, right), scale: 1.0 };
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in points.iter().map(|p| camera.project(*p)) {
            for i in 0..2 {
                low[i] = low[i].min(p[i]);
                high[i] = high[i].max(p[i]);
            }
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        camera.scale = if extent > 0.0 && extent.is_finite() { size / extent } else { 1.0 };
        camera
    }

    /// The point in the drawing plane.
    pub(super) fn project(&self, p: V3) -> [f64; 2] {
        [self.scale * dot(p, self.right), -self.scale * dot(p, self.up)]
    }

    /// How near a point is to the eye.
    pub(super) fn depth(&self, p: V3) -> f64 {
        dot(p, self.toward)
    }
}

/// The convex hull of points in the plane.
pub(super) fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let half = |list: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut out: Vec<[f64; 2]> = Vec::new();
        for p in list {
            while let [.., a, b] = out.as_slice() {
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0 {
                    break;
                }
                out.pop();
            }
            out.push(*p);
        }
        out.pop();
        out
    };
    let mut out = half(&mut sorted.iter());
    out.extend(half(&mut sorted.iter().rev()));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_has_four_corners() {
        let square = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.5], [1.0, 1.0], [0.0, 1.0], [0.2, 0.7]];
        assert_eq!(hull(&square).len(), 4);
    }

    #[test]
    fn everything_fits() {
        let points = [[0.0, 0.0, 0.0], [3.0, 1.0, 2.0], [-1.0, 0.5, 4.0]];
        for flat in [false, true] {
            let camera = Camera::of(&points, flat, 100.0);
            let xs: Vec<f64> = points.iter().map(|p| camera.project(*p)[0]).collect();
            let width = xs.iter().copied().fold(f64::MIN, f64::max) - xs.iter().copied().fold(f64::MAX, f64::min);
            assert!(width <= 100.0 + 1e-9);
        }
    }
}
