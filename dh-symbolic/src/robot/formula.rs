//! One exact formula of a robot: arithmetic, derivatives, equality, numbers, and how it is printed.

use super::EvalError;
use super::names::Names;
use crate::algebra::Poly;
use crate::render::document::{latex, typst};
use crate::render::formula::{math::Math, plain, text};
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};
use std::sync::Arc;

/// A formula of a robot, exact: a polynomial in lengths and in sines and cosines of sums of joint angles.
///
/// Two formulas are equal where they are equal for all values of their names; this is decided, never guessed:
///
/// ```
/// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
/// let t = puma.transform(1, 3);
/// let (c23, s23) = (t.entry(0, 0), -t.entry(0, 1));
/// assert_eq!(&c23 * &c23 + &s23 * &s23, puma.transform(0, 0).entry(0, 0));
/// assert_eq!(format!("{} {} {}", c23, c23.latex(), c23.plain()), "c₂₃ c_{23} c23");
/// # Ok::<(), dh_symbolic::TableError>(())
/// ```
///
/// `Display` prints the textbook's grouping in one line. Sums, differences and products of formulas of different robots mean nothing.
#[derive(Clone)]
pub struct Formula {
    pub(super) arm: Arc<Names>,
    pub(super) value: Poly,
}

impl Formula {
    /// Is it zero for all values of its names?
    pub fn is_zero(&self) -> bool {
        self.value.is_zero()
    }

    /// The derivative by a joint variable (`q1`; angles in radians) or by a length or angle of the table. Zero for a name that does
    /// not occur.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let t = puma.transform(0, 6);
    /// assert_eq!(t.entry(0, 3).diff("q1"), -t.entry(1, 3));
    /// assert_eq!(t.entry(0, 3).diff("a2").to_string(), "c₁c₂");
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    #[must_use]
    pub fn diff(&self, name: &str) -> Formula {
        self.with(self.arm.derivative(&self.value, name))
    }

    /// The number: joint variables in radians and lengths in the table's unit. Names that the table gives a value need none here.
    ///
    /// # Errors
    /// Names without a value, and names that the robot does not have.
    pub fn eval(&self, values: &[(&str, f64)]) -> Result<f64, EvalError> {
        let list = self.arm.evaluate(&[&self.value], values)?;
        Ok(list.first().copied().unwrap_or(f64::NAN))
    }

    /// As LaTeX, without dollar signs: `a_2c_2`.
    pub fn latex(&self) -> String {
        latex::math(&self.math())
    }

    /// As Typst, without dollar signs.
    pub fn typst(&self) -> String {
        typst::math(&self.math())
    }

    /// As `prove { }` blocks and [`Robot::check`](super::Robot::check) read it: `a2*c2`.
    pub fn plain(&self) -> String {
        plain::formula(&self.arm.chain.ring, &self.arm.order, &self.value)
    }

    /// What the formula is, for crates of this workspace.
    #[doc(hidden)]
    pub fn polynomial(&self) -> &Poly {
        &self.value
    }

    pub(super) fn math(&self) -> Math {
        self.arm.notation.typeset(&self.arm.order.group(&self.value))
    }

    fn with(&self, value: Poly) -> Formula {
        Formula { arm: Arc::clone(&self.arm), value }
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&text::math(&self.math()))
    }
}

impl fmt::Debug for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.plain())
    }
}

impl PartialEq for Formula {
    fn eq(&self, other: &Formula) -> bool {
        self.arm.is_like(&other.arm) && self.value == other.value
    }
}

impl Eq for Formula {}

/// # Panics
/// The operators panic where the formulas belong to different robots.
#[track_caller]
pub(super) fn same_arm(a: &Names, b: &Names) {
    assert!(a.is_like(b), "formulas of two robots: {} and {}", a.chain.name, b.chain.name);
}

impl Neg for &Formula {
    type Output = Formula;

    fn neg(self) -> Formula {
        self.with(-&self.value)
    }
}

impl Neg for Formula {
    type Output = Formula;

    fn neg(self) -> Formula {
        -&self
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $sign:tt) => {
        impl $trait for &Formula {
            type Output = Formula;

            #[track_caller]
            fn $method(self, other: &Formula) -> Formula {
                same_arm(&self.arm, &other.arm);
                self.with(&self.value $sign &other.value)
            }
        }

        impl $trait for Formula {
            type Output = Formula;

            #[track_caller]
            fn $method(self, other: Formula) -> Formula {
                &self $sign &other
            }
        }

        impl $trait<&Formula> for Formula {
            type Output = Formula;

            #[track_caller]
            fn $method(self, other: &Formula) -> Formula {
                &self $sign other
            }
        }

        impl $trait<Formula> for &Formula {
            type Output = Formula;

            #[track_caller]
            fn $method(self, other: Formula) -> Formula {
                self $sign &other
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
