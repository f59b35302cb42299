//! A number for each of several poses, side by side, with the arithmetic of plain numbers.

use core::ops::{Add, Mul, Neg, Sub};

/// A kind of vector register: what a processor does with several `f64` at once.
pub trait Register: Copy {
    /// The contents of a register.
    type Numbers: Copy;
    /// Yes or no for each of them.
    type Mask: Copy;

    /// The same number in every lane.
    fn splat(self, x: f64) -> Self::Numbers;
    /// `a + b`
    fn add(self, a: Self::Numbers, b: Self::Numbers) -> Self::Numbers;
    /// `a - b`
    fn sub(self, a: Self::Numbers, b: Self::Numbers) -> Self::Numbers;
    /// `a * b`
    fn mul(self, a: Self::Numbers, b: Self::Numbers) -> Self::Numbers;
    /// `-a`
    fn neg(self, a: Self::Numbers) -> Self::Numbers;
    /// `a * b + c`, rounded once where that is as fast as anything.
    fn mul_add(self, a: Self::Numbers, b: Self::Numbers, c: Self::Numbers) -> Self::Numbers;
    /// Sine and cosine turned by the quadrant that stands in the lowest bits of `rounded`.
    fn turn(self, rounded: Self::Numbers, sine: Self::Numbers, cosine: Self::Numbers)
    -> (Self::Numbers, Self::Numbers);
    /// No lane.
    fn nowhere(self) -> Self::Mask;
    /// The lanes of `mask`, and those where `|x| <= limit` does not hold.
    fn or_beyond(self, mask: Self::Mask, x: Self::Numbers, limit: f64) -> Self::Mask;
    /// Whether there is a lane in the mask.
    fn is_anywhere(self, mask: Self::Mask) -> bool;
}

/// One number for each of several poses.
#[derive(Clone, Copy, Debug)]
pub struct Packed<R: Register> {
    pub(super) register: R,
    pub(super) numbers: R::Numbers,
}

impl<R: Register> Packed<R> {
    /// `a * b + c`
    #[inline(always)]
    pub(super) fn mul_add(self, b: Self, c: Self) -> Self {
        Packed { numbers: self.register.mul_add(self.numbers, b.numbers, c.numbers), ..self }
    }

    /// The same number for every pose, in a register of this kind.
    #[inline(always)]
    pub(super) fn all(self, x: f64) -> Self {
        Packed { numbers: self.register.splat(x), ..self }
    }

    /// A result of generated code, which can be a plain number: the same for every pose.
    #[inline(always)]
    pub fn of(self, x: impl IntoPacked<R>) -> Self {
        x.packed(self)
    }
}

/// Plain and packed numbers.
pub trait IntoPacked<R: Register> {
    /// As a packed number, of the kind of `like`.
    fn packed(self, like: Packed<R>) -> Packed<R>;
}

impl<R: Register> IntoPacked<R> for f64 {
    #[inline(always)]
    fn packed(self, like: Packed<R>) -> Packed<R> {
        like.all(self)
    }
}

impl<R: Register> IntoPacked<R> for Packed<R> {
    #[inline(always)]
    fn packed(self, _: Packed<R>) -> Packed<R> {
        self
    }
}

macro_rules! operator {
    ($operator:ident $function:ident) => {
        impl<R: Register> $operator for Packed<R> {
            type Output = Packed<R>;
            #[inline(always)]
            fn $function(self, other: Packed<R>) -> Packed<R> {
                Packed { numbers: self.register.$function(self.numbers, other.numbers), ..self }
            }
        }
        impl<R: Register> $operator<f64> for Packed<R> {
            type Output = Packed<R>;
            #[inline(always)]
            fn $function(self, other: f64) -> Packed<R> {
                self.$function(self.all(other))
            }
        }
        impl<R: Register> $operator<Packed<R>> for f64 {
            type Output = Packed<R>;
            #[inline(always)]
            fn $function(self, other: Packed<R>) -> Packed<R> {
                other.all(self).$function(other)
            }
        }
    };
}

operator!(Add add);
operator!(Sub sub);
operator!(Mul mul);

impl<R: Register> Neg for Packed<R> {
    type Output = Packed<R>;
    #[inline(always)]
    fn neg(self) -> Packed<R> {
        Packed { numbers: self.register.neg(self.numbers), ..self }
    }
}
