//! Converts the sum in a cell to what its column can hold: an angle, a length, or a joint variable with an offset.

use super::radians;
use super::scope::{Declared, Kind, Scope};
use super::sum::{AngleUnit, Sum, Term};
use crate::algebra::Rational;
use crate::chain::{AngleCell, Drive, LengthCell};
use crate::diagnostic::{Error, Place};

/// Largest factor of a declared angle: `2*beta`.
const MOST_TIMES: i64 = 4;

/// Where a sum stands, for messages: "column `a`", "`tx`".
#[derive(Clone, Copy)]
pub(super) struct Site<'a>(pub(super) &'a str);

impl Site<'_> {
    fn want_length(self, t: &Term) -> Error {
        let have = match t.angle {
            Some(_) => format!("{} holds a length, but `{}` is an angle", self.0, t.word),
            None => format!("{} holds a length, but this is none", self.0),
        };
        Error::new(t.place, have).help("write a length: `0.4318m`, `431.8mm`")
    }

    fn want_angle(self, t: &Term) -> Error {
        if t.lengths > 0 {
            let text = format!("{} holds an angle, but `{}` is a length", self.0, t.word);
            return Error::new(t.place, text).help("write an angle: `90deg`, `pi/2`");
        }
        if !t.names.is_empty() {
            let text = format!("{} holds an angle, but `{}` is a number", self.0, t.word);
            return Error::new(t.place, text).help("give it a unit: `k*90deg`");
        }
        let text = format!("{} holds an angle (`90deg`, `pi/2`), but `{}` has no unit", self.0, t.word);
        Error::new(t.place, text).help(radians::unit_of(&t.word))
    }

    fn no_variable(self, t: &Term) -> Error {
        Error::new(t.place, format!("{} cannot move: a joint variable stands in column `theta` or `d`", self.0))
    }
}

/// A factor that a robot can have: finite as a float of the generated code, with room for products.
fn within_reason(x: &Rational, t: &Term) -> Result<(), Error> {
    const MOST: f64 = 1e15;
    const LEAST: f64 = 1e-300;
    let size = x.abs().to_f64();
    if x.is_zero() || (LEAST..=MOST).contains(&size) {
        return Ok(());
    }
    Err(Error::new(t.place, "this number is beyond all reason").help("numbers lie between 1e-300 and 1e15"))
}

/// Whether one of the names of this sum is declared wrongly; no further error is reported then.
pub(super) fn doubtful(sum: &Sum, scope: &Scope) -> bool {
    let unsound = |i: &usize| scope.names.get(*i).is_none_or(|d| !d.sound);
    sum.terms
        .iter()
        .any(|t| t.names.iter().any(unsound) || matches!(t.angle, Some(AngleUnit::Declared(i)) if unsound(&i)))
}

/// A constant angle.
pub(super) fn angle(sum: &Sum, scope: &Scope, site: Site<'_>) -> Result<AngleCell, Error> {
    let mut cell = AngleCell::default();
    if doubtful(sum, scope) {
        return Ok(cell);
    }
    let add = |slot: &mut Option<Rational>, x: &Rational| {
        *slot = Some(slot.as_ref().map_or_else(|| x.clone(), |y| y + x)).filter(|z| !z.is_zero());
    };
    for t in &sum.terms {
        if t.variable.is_some() {
            return Err(site.no_variable(t));
        }
        let Some(unit) = t.angle else {
            if t.factor.is_zero() && t.names.is_empty() && t.lengths == 0 {
                continue;
            }
            return Err(site.want_angle(t));
        };
        let (factor, fields) = scope.fold_constants(&t.factor, &t.names);
        if !fields.is_empty() || t.lengths > 0 {
            return Err(Error::new(t.place, "an angle takes plain numbers as factors, no fields and no lengths"));
        }
        within_reason(&factor, t)?;
        match unit {
            AngleUnit::Pi => add(&mut cell.half_turns, &factor),
            AngleUnit::Radian => add(&mut cell.approx, &factor),
            AngleUnit::Declared(_) if factor.is_zero() => {}
            AngleUnit::Declared(i) => match factor.to_i64().filter(|n| n.abs() <= MOST_TIMES) {
                Some(n) => cell.symbols.push((i, n as i8)),
                None => {
                    let text = format!("a declared angle takes whole factors from -{MOST_TIMES} to {MOST_TIMES}");
                    return Err(Error::new(t.place, text)
                        .help(format!("declare the part that you need as an angle of its own, besides `{}`", t.word)));
                }
            },
        }
    }
    Ok(cell)
}

/// A constant length in table units.
pub(super) fn length(sum: &Sum, scope: &Scope, site: Site<'_>) -> Result<LengthCell, Error> {
    let mut cell = LengthCell::default();
    if doubtful(sum, scope) {
        return Ok(cell);
    }
    // The value, as long as it is known while the macro runs.
    let mut value = Some(Rational::ZERO);
    for t in &sum.terms {
        if t.variable.is_some() {
            return Err(site.no_variable(t));
        }
        if t.angle.is_some() {
            return Err(site.want_length(t));
        }
        if t.lengths > 1 {
            return Err(Error::new(t.place, "a product of two lengths is no length")
                .help("a coefficient is declared as `let k: number;`"));
        }
        within_reason(&t.factor, t)?;
        let (known, fields) = scope.fold_constants(&t.factor, &t.names);
        within_reason(&known, t)?;
        value = value.filter(|_| fields.is_empty()).map(|v| &v + &known);
        add(&mut cell, &t.factor, &t.names);
    }
    // `a2 - a3` of equal constants is nothing, and the structure of the arm depends on it.
    if value.is_some_and(|v| v.is_zero()) {
        cell.terms.clear();
    }
    Ok(cell)
}

/// Adds a product; what adds up to zero goes.
fn add(cell: &mut LengthCell, factor: &Rational, names: &[usize]) {
    match cell.terms.iter_mut().find(|(_, n)| n == names) {
        Some((x, _)) => *x = &*x + factor,
        None => cell.terms.push((factor.clone(), names.to_vec())),
    }
    cell.terms.retain(|(x, _)| !x.is_zero());
}

/// Whether this sum contains a joint variable.
pub(super) fn moves(sum: &Sum) -> bool {
    sum.terms.iter().any(|t| t.variable.is_some())
}

/// Splits a moving cell into its drive and the constant rest.
pub(super) fn split(sum: &Sum, scope: &Scope, revolute: bool, place: Place) -> Result<(Drive, Sum), Error> {
    let mut rest = Sum::default();
    let mut terms: Vec<(usize, LengthCell)> = Vec::new();
    for t in &sum.terms {
        let Some(variable) = t.variable else {
            rest.push(t.clone())?;
            continue;
        };
        if t.angle.is_some() {
            return Err(Error::new(t.place, "the coefficient of a joint variable is a number, no angle"));
        }
        if revolute && t.literal_length {
            return Err(Error::new(t.place, "the coefficient of a turning joint is a number, no length"));
        }
        // Constants are put in place: a coefficient of 1 must be seen as such.
        let (factor, fields) = scope.fold_constants(&t.factor, &t.names);
        within_reason(&factor, t)?;
        let at = match terms.iter().position(|(v, _)| *v == variable) {
            Some(at) => at,
            None => {
                terms.push((variable, LengthCell::default()));
                terms.len() - 1
            }
        };
        if let Some((_, cell)) = terms.get_mut(at) {
            add(cell, &factor, &fields);
        }
    }
    terms.retain(|(_, cell)| !cell.terms.is_empty());
    terms.sort_by_key(|(v, _)| *v);
    if terms.is_empty() {
        return Err(Error::new(place, "the joint variables cancel out here, so the row does not move"));
    }
    Ok((Drive { revolute, terms }, rest))
}

/// The kind of a `let` value that does not name its kind.
pub(super) fn kind(sum: &Sum, scope: &Scope) -> Kind {
    let declared_kind = |i: &usize| scope.names.get(*i).map(|d: &Declared| d.kind);
    if sum.terms.iter().any(|t| t.angle.is_some()) {
        Kind::Angle
    } else if sum.terms.iter().any(|t| t.lengths > 0 || t.names.iter().any(|i| declared_kind(i) == Some(Kind::Length)))
    {
        Kind::Length
    } else {
        Kind::Number
    }
}
