//! Prints programs and plans as Rust items and as JavaScript, and interfaces to the Rust code for C and C++.
//!
//! **In:** a chain, its programs and its inverse. **Out:** text and tokens. `body` prints straight lines, `steps`, `drive` and `names`
//! what surrounds them; [`rust`], `javascript` and `c` (feature `documents`: the macro does without these two) are siblings over this
//! base.

pub(in crate::render) mod body;
#[cfg(feature = "documents")]
pub mod c;
mod closed_form;
mod docs;
pub(in crate::render) mod drive;
#[cfg(feature = "documents")]
pub mod javascript;
pub(in crate::render) mod names;
pub mod rust;
pub(in crate::render) mod steps;

use crate::algebra::{Point, Poly, Transform};
use crate::chain::{AngleCell, Bound, Chain, Elementary, Handle, Role, Scalar};
use body::Code;

pub use closed_form::rustdoc;

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

/// The value of a constant product as a literal pose.
fn constant_pose(chain: &Chain, factors: &[Elementary]) -> String {
    let t = factors.iter().fold(Transform::identity(), |t, f| t.times(&f.transform()));
    let value = |p: &Poly| literal(scaled_constant(chain, p, 1.0), chain.settings.scalar);
    let row = |i: usize| format!("[{}]", t.r[i].iter().map(value).collect::<Vec<_>>().join(", "));
    let place: Vec<String> = t.p.iter().map(value).collect();
    format!("::dh_robot::pose::from_entries([{}, {}, {}], [{}])", row(0), row(1), row(2), place.join(", "))
}

/// A field as a number of the code's type.
fn field(chain: &Chain, name: &str, scalar: Scalar) -> Code {
    let widened = chain.settings.scalar == Scalar::F32 && scalar == Scalar::F64;
    Code::atom(if widened { format!("f64::from(self.{name})") } else { format!("self.{name}") })
}

/// The joint angle offset (radians) that is kept out of formulas, with declared angles by name: an expression, `None` if zero.
pub(in crate::render) fn shift_expression(chain: &Chain, cell: &AngleCell, scalar: Scalar) -> Option<Code> {
    let constant = |x: f64| Code::number(x.is_sign_negative(), literal(x.abs(), scalar));
    let (mut parts, mut number) = (Vec::new(), cell.radians());
    for (i, k) in &cell.symbols {
        let Some(p) = chain.parameters.get(*i) else { continue };
        match &p.role {
            Role::Field(_) => parts.push(match k {
                1 => field(chain, &p.name, scalar),
                -1 => field(chain, &p.name, scalar).negated(),
                _ => constant(f64::from(*k)).times(&field(chain, &p.name, scalar)),
            }),
            Role::Constant(_) => number += f64::from(*k) * chain.nominal(p.handle),
        }
    }
    if number != 0.0 {
        parts.push(constant(number));
    }
    (!parts.is_empty()).then(|| Code::sum(&parts))
}
