//! The Rust backend: from a chain and its programs to the items that `dh_robot!` leaves behind.
//!
//! Items are written as text and lexed once: the text is what a reader of `cargo expand` sees, and the compiler's own lexer is
//! much faster than building tokens one by one in an unoptimised macro. The user's own tokens (attributes, visibility, name) keep
//! their spans.

pub(in crate::render) mod body;
mod candidates;
mod docs;
pub(in crate::render) mod drive;
mod forward;
mod inverse;
mod lanes;
mod names;
#[cfg(feature = "cli")]
mod pretty;
pub(in crate::render) mod steps;
mod structure;
mod stub;
pub(in crate::render) mod target;
mod verify;

pub use inverse::inverse;
#[cfg(feature = "cli")]
pub use pretty::pretty;
pub use structure::{Head, robot};
pub use stub::stub;

use crate::algebra::{Point, Poly};
use crate::chain::{AngleCell, Bound, Chain, Handle, Role, Scalar};

/// Name of the number type.
pub(crate) fn scalar_name(s: Scalar) -> &'static str {
    match s {
        Scalar::F64 => "f64",
        Scalar::F32 => "f32",
    }
}

/// A number as a literal of the robot's type.
pub(crate) fn literal(x: f64, s: Scalar) -> String {
    match s {
        Scalar::F64 => format!("{x:?}"),
        Scalar::F32 => format!("{:?}", x as f32),
    }
}

/// The value of a bound.
pub(crate) fn bound(b: &Bound) -> f64 {
    match b {
        Bound::HalfTurns(x) => crate::algebra::Angle::half_turns(x.clone()).radians(),
        Bound::Radians(x) | Bound::Length(x) => x.to_f64(),
    }
}

/// A constant formula as a number, with all lengths multiplied by `scale`.
pub(crate) fn scaled_constant(chain: &Chain, p: &Poly, scale: f64) -> f64 {
    p.evaluate(&Point {
        symbol: &|s| chain.nominal(Handle::Length(s)) * scale,
        angle: &|v| chain.nominal(Handle::Angle(v)),
    })
}

/// The joint angle offset (radians) that is kept out of formulas, with declared angles by name: an expression, `None` if zero.
pub(crate) fn shift_expression(chain: &Chain, cell: &AngleCell, scalar: Scalar) -> Option<String> {
    let wide = chain.scalar == Scalar::F32 && scalar == Scalar::F64;
    let field = |name: &str| if wide { format!("f64::from(self.{name})") } else { format!("self.{name}") };
    let mut parts = Vec::new();
    let mut number = cell.radians();
    for (i, k) in &cell.symbols {
        let Some(p) = chain.parameters.get(*i) else { continue };
        match &p.role {
            Role::Field(_) => parts.push(match k {
                1 => field(&p.name),
                -1 => format!("-{}", field(&p.name)),
                _ => format!("{} * {}", literal(f64::from(*k), scalar), field(&p.name)),
            }),
            Role::Constant(_) => number += f64::from(*k) * chain.nominal(p.handle),
        }
    }
    if number != 0.0 {
        parts.push(literal(number, scalar));
    }
    let mut out = String::new();
    for p in parts {
        match (out.is_empty(), p.strip_prefix('-')) {
            (true, _) => out = p,
            (false, Some(rest)) => out.push_str(&format!(" - {rest}")),
            (false, None) => out.push_str(&format!(" + {p}")),
        }
    }
    (!out.is_empty()).then_some(out)
}
