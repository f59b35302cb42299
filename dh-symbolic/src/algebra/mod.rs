//! Exact formulas: polynomials in lengths, prismatic variables and harmonics of angles, in a normal form.
//!
//! **In:** symbols and angles named in a [`Ring`]. **Out:** [`Poly`], [`Transform`]; equality of two formulas is equality of
//! their normal forms, so it is decided, never guessed.
//!
//! * Coefficients are exact rationals; the square roots that twists of 15-degree steps need are the atoms sqrt 2 and
//!   sqrt 3 with their relations built in.
//! * Angles come in *groups* (joints with parallel axes share one). Inside a group the basis is harmonic:
//!   1, cos(k.theta), sin(k.theta) with integer vectors k. Products turn into sums as they are formed, so
//!   c2 c3 - s2 s3 *is* c23 and c1^2 + s1^2 *is* 1. Across groups products stay products.
//! * A monomial is at most one harmonic per group times powers of symbols; a polynomial is a sorted list of monomials.
//!
//! **Never here:** robots, tokens, floats (except in `evaluate`), prose.

pub mod angle;
mod derivative;
mod determinant;
mod evaluate;
mod factor;
mod field;
mod matrix;
mod monomial;
mod poly;
pub mod rational;
mod substitute;
mod symbol;
#[cfg(test)]
mod tests;
mod text;
mod vector;

pub use angle::Angle;
pub use determinant::adjugate;
pub(crate) use determinant::determinant;
pub use evaluate::Point;
pub use field::{Element, FieldPoint};
pub use matrix::{Transform, Vector};
pub use monomial::{Factor, Monomial};
pub use poly::Poly;
pub use rational::Rational;
pub use symbol::{AngleVar, LinearAngle, Ring, Symbol};
pub(crate) use vector::{RingElement, cross, dot, minus};
