//! Inner and vector products of plain arrays, used by the kernels and the code around them.

use super::elementary::sqrt;

/// The inner product.
#[inline]
#[must_use]
pub fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    // A `while`, since the compiler runs this unoptimised, where iterators cost more than the sum.
    let (mut sum, mut i) = (0.0, 0);
    while i < N {
        sum += a[i] * b[i];
        i += 1;
    }
    sum
}

/// The length of a vector.
#[inline]
#[must_use]
pub fn norm<const N: usize>(a: [f64; N]) -> f64 {
    sqrt(dot(a, a))
}

/// The vector product.
#[inline]
#[must_use]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_known_vectors() {
        let (a, b) = ([1.0, 2.0, 2.0], [-2.0, 0.5, 4.0]);
        assert_eq!((dot(a, b), norm(a)), (7.0, 3.0));
        let normal = cross(a, b);
        assert_eq!(normal, [7.0, -8.0, 4.5]);
        assert_eq!((dot(normal, a), dot(normal, b)), (0.0, 0.0));
        assert_eq!(cross(b, a), normal.map(|x| -x));
    }
}
