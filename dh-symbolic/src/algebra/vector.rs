//! Vectors of three entries from any ring that the compiler computes in: formulas, elements of a prime field, floating-point numbers.

use super::{Element, Poly};

/// A commutative ring.
pub(crate) trait RingElement: Clone {
    /// The neutral element of addition.
    fn zero() -> Self;
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The sum of the products of pairs.
    fn sum_of_products<'a>(pairs: impl Iterator<Item = (&'a Self, &'a Self)>) -> Self
    where
        Self: 'a,
    {
        pairs.fold(Self::zero(), |sum, (a, b)| sum.plus(&a.times(b)))
    }
}

impl RingElement for f64 {
    fn zero() -> f64 {
        0.0
    }
    fn plus(&self, other: &f64) -> f64 {
        self + other
    }
    fn minus(&self, other: &f64) -> f64 {
        self - other
    }
    fn times(&self, other: &f64) -> f64 {
        self * other
    }
}

impl RingElement for Element {
    fn zero() -> Element {
        Element::ZERO
    }
    fn plus(&self, other: &Element) -> Element {
        Element::plus(*self, *other)
    }
    fn minus(&self, other: &Element) -> Element {
        Element::plus(*self, other.negative())
    }
    fn times(&self, other: &Element) -> Element {
        Element::times(*self, *other)
    }
}

impl RingElement for Poly {
    fn zero() -> Poly {
        Poly::zero()
    }
    fn plus(&self, other: &Poly) -> Poly {
        self + other
    }
    fn minus(&self, other: &Poly) -> Poly {
        self - other
    }
    fn times(&self, other: &Poly) -> Poly {
        self * other
    }
    // All products are collected before terms are merged.
    fn sum_of_products<'a>(pairs: impl Iterator<Item = (&'a Poly, &'a Poly)>) -> Poly {
        Poly::sum_of_products(pairs)
    }
}

/// The inner product.
pub(crate) fn dot<T: RingElement>(a: &[T; 3], b: &[T; 3]) -> T {
    T::sum_of_products(a.iter().zip(b))
}

/// The vector product.
pub(crate) fn cross<T: RingElement>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].times(&b[k]).minus(&a[k].times(&b[j]))
    })
}

/// The difference.
pub(crate) fn minus<T: RingElement>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    std::array::from_fn(|i| a[i].minus(&b[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{FieldPoint, Ring};

    /// a x b is perpendicular to a and b, and |a x b|^2 = |a|^2 |b|^2 - (a.b)^2.
    fn products<T: RingElement>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
        let normal = cross(a, b);
        let square = dot(a, a).times(&dot(b, b)).minus(&dot(a, b).times(&dot(a, b)));
        [dot(&normal, a), dot(&normal, b), dot(&normal, &normal).minus(&square)]
    }

    #[test]
    fn products_obey_lagranges_identity_in_every_ring() {
        let mut ring = Ring::new();
        let mut formulas = |names: [&str; 3]| names.map(|name| Poly::symbol(ring.symbol(name)));
        let (a, b) = (formulas(["x", "y", "z"]), formulas(["u", "v", "w"]));
        assert!(products(&a, &b).iter().all(Poly::is_zero));
        let at = FieldPoint::new(3);
        let value = |v: &[Poly; 3]| v.each_ref().map(|p| at.value(p));
        assert_eq!(products(&value(&a), &value(&b)), [Element::ZERO; 3]);
        assert_eq!(cross(&value(&a), &value(&b)), value(&cross(&a, &b)));
        let (a, b) = ([1.0, 2.0, 2.0], [-2.0, 0.5, 4.0]);
        assert_eq!((products(&a, &b), cross(&a, &b), minus(&a, &b)), ([0.0; 3], [7.0, -8.0, 4.5], [3.0, 1.5, -2.0]));
    }
}
