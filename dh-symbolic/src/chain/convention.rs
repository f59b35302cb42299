//! Standard and modified Denavit-Hartenberg parameters: one link transform each.
//!
//! * **Standard** (Denavit and Hartenberg 1955; Paul 1981): frame i sits at the far end of link i, on the axis of joint
//!   i+1. A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i).
//! * **Modified** (Craig 1986): frame i sits on the axis of joint i. Row i holds alpha_{i-1}, a_{i-1}, d_i, theta_i and
//!   T_i = Rx(alpha_{i-1}) Tx(a_{i-1}) Rz(theta_i) Tz(d_i).

use super::Link;
use crate::algebra::{LinearAngle, Poly, Transform};

/// Which Denavit-Hartenberg convention a table follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// Denavit and Hartenberg, Paul.
    Standard,
    /// Craig.
    Modified,
}

/// An elementary motion along or about a coordinate axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Elementary {
    /// Translation along axis 0, 1 or 2.
    Translate(usize, Poly),
    /// Rotation about axis 0, 1 or 2.
    Rotate(usize, LinearAngle),
}

impl Elementary {
    /// The 4x4 matrix. Angles with an inexact constant part are no part of a chain (they are named), so the sine exists; were it
    /// missing, the identity would be returned.
    pub fn transform(&self) -> Transform {
        match self {
            Elementary::Translate(axis, length) => Transform::translation(*axis, length),
            Elementary::Rotate(axis, angle) => match angle.cos_sin() {
                Some((c, s)) => Transform::rotation(*axis, (&c, &s)),
                None => Transform::identity(),
            },
        }
    }

    /// Whether it is the identity.
    pub fn is_identity(&self) -> bool {
        match self {
            Elementary::Translate(_, length) => length.is_zero(),
            Elementary::Rotate(_, angle) => angle.terms.is_empty() && angle.constant.is_zero(),
        }
    }
}

impl Convention {
    /// The four factors of a link transform, in order.
    pub fn factors(self, link: &Link) -> Vec<Elementary> {
        let theta = Elementary::Rotate(2, link.theta.clone());
        let d = Elementary::Translate(2, link.d.clone());
        let a = Elementary::Translate(0, link.a.clone());
        let alpha = Elementary::Rotate(0, link.alpha.clone());
        match self {
            Convention::Standard => vec![theta, d, a, alpha],
            Convention::Modified => vec![alpha, a, theta, d],
        }
    }
}
