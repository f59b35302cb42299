//! Where the elementary functions of both scalars come from: the standard library, or libm through nalgebra where there is none.
//!
//! nalgebra itself is built without its `std`, which would compile vector types that nothing here uses; a program that wants
//! more of nalgebra turns its features on.

/// The functions behind [`math`](crate::math), as methods under names that nothing else has.
pub trait Elementary: Copy {
    /// Square root.
    fn root(self) -> Self;
    /// Cube root.
    fn cube_root(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sine_cosine(self) -> (Self, Self);
    /// The angle of the vector with this second coordinate, as the backend gives it.
    fn angle_above(self, x: Self) -> Self;
    /// Inverse cosine.
    fn arc_cosine(self) -> Self;
    /// The largest whole number that is not above.
    fn rounded_down(self) -> Self;
    /// The smallest whole number that is not below.
    fn rounded_up(self) -> Self;
    /// The nearest whole number, halves away from zero.
    fn rounded(self) -> Self;
}

/// Inherent methods of the scalar with `std`, those of nalgebra's traits without.
macro_rules! elementary {
    ($scalar:ty) => {
        impl Elementary for $scalar {
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }
            #[inline(always)]
            fn cube_root(self) -> Self {
                self.cbrt()
            }
            #[inline(always)]
            fn sine_cosine(self) -> (Self, Self) {
                self.sin_cos()
            }
            #[inline(always)]
            fn angle_above(self, x: Self) -> Self {
                self.atan2(x)
            }
            #[inline(always)]
            fn arc_cosine(self) -> Self {
                self.acos()
            }
            #[inline(always)]
            fn rounded_down(self) -> Self {
                self.floor()
            }
            #[inline(always)]
            fn rounded_up(self) -> Self {
                self.ceil()
            }
            #[inline(always)]
            fn rounded(self) -> Self {
                self.round()
            }
        }
    };
}

/// One module, so that the traits are in scope exactly where the inherent methods are missing.
mod scalars {
    use super::Elementary;
    #[cfg(not(any(test, feature = "std")))]
    use nalgebra::{ComplexField, RealField};

    elementary!(f32);
    elementary!(f64);
}
