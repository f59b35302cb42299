//! Column `range`: `-160deg..=160deg`, or `-` where it is not known.

use super::cell::{self, Site};
use super::expression;
use super::rows::Cell;
use super::scope::{Kind, Scope};
use super::sum::Sum;
use crate::algebra::Rational;
use crate::chain::Bound;
use crate::diagnostic::{Error, Place};
use proc_macro2::TokenTree;

/// What the variable of a row measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Measure {
    /// A turning joint that has its own actuator.
    Angle,
    /// A sliding joint that has its own actuator.
    Length,
    /// An actuator that drives several joints, or through a gear: angle or length, as written.
    Either,
    /// Nothing moves.
    Fixed,
}

/// The bounds, `None` for `-`, `none` and `fixed`. `joint`: the number of the row's joint, from 1.
pub(super) fn read(
    cell: &Cell,
    scope: &Scope,
    measure: Measure,
    joint: usize,
) -> Result<Option<(Bound, Bound)>, Error> {
    match cell.tokens.as_slice() {
        [TokenTree::Punct(p)] if p.as_char() == '-' => return Ok(None),
        [TokenTree::Ident(i)] if i == "none" => return Ok(None),
        [TokenTree::Ident(i)] if i == "fixed" => {
            return match measure {
                Measure::Fixed => Ok(None),
                _ => Err(Error::new(cell.place, format!("the row says `fixed`, but joint {joint} moves"))),
            };
        }
        _ => {}
    }
    let (low, high) = split(cell)?;
    if measure == Measure::Fixed {
        return Err(Error::new(cell.place, "this row has no joint variable, so there is no range").help("write `-`"));
    }
    let want = if measure == Measure::Length { Kind::Length } else { Kind::Angle };
    let sum =
        |tokens: &[TokenTree]| expression::read_bound(tokens, Place::of_all(tokens).unwrap_or(cell.place), scope, want);
    let (low, high) = (sum(low)?, sum(high)?);
    // Of `0..=90deg` both are angles.
    let angles = match measure {
        Measure::Either => [&low, &high].iter().any(|s| s.terms.iter().any(|t| t.angle.is_some())),
        _ => measure == Measure::Angle,
    };
    let (low, high) = (bound(&low, scope, angles, measure, joint)?, bound(&high, scope, angles, measure, joint)?);
    let backwards = match (&low, &high) {
        (Bound::Length(a), Bound::Length(b)) => a > b,
        (Bound::HalfTurns(a), Bound::HalfTurns(b)) => a > b,
        (a, b) => radians(a) > radians(b),
    };
    if backwards {
        let bounds = [split(cell)?.1, split(cell)?.0].map(super::text::of);
        return Err(Error::new(cell.place, "this range is empty: its lower bound is above its upper bound")
            .help(format!("if the bounds came reversed, write `{}..={}`", bounds[0], bounds[1])));
    }
    Ok(Some((low, high)))
}

/// The tokens on both sides of `..=`.
fn split(cell: &Cell) -> Result<(&[TokenTree], &[TokenTree]), Error> {
    let dot = |t: Option<&TokenTree>, c: char| matches!(t, Some(TokenTree::Punct(p)) if p.as_char() == c);
    let form = "a range is written `-160deg..=160deg`; `-` where it is not known";
    let tokens = cell.tokens.as_slice();
    let Some(at) = (0..tokens.len()).find(|&i| dot(tokens.get(i), '.') && dot(tokens.get(i + 1), '.')) else {
        return Err(Error::new(cell.place, "this is no range").help(form));
    };
    let (low, rest) = tokens.split_at(at);
    let skip = if dot(rest.get(2), '=') { 3 } else { 2 };
    let high = rest.get(skip..).unwrap_or(&[]);
    if low.is_empty() || high.is_empty() {
        return Err(Error::new(cell.place, "both bounds of a range must be given").help(form));
    }
    if skip == 2 {
        return Err(Error::new(cell.place, "the bounds belong to the range").help("write `..=`"));
    }
    Ok((low, high))
}

fn bound(sum: &Sum, scope: &Scope, angle: bool, measure: Measure, joint: usize) -> Result<Bound, Error> {
    let angular = sum.terms.iter().any(|t| t.angle.is_some());
    let long = sum.terms.iter().any(|t| t.lengths > 0);
    let place = sum.terms.iter().find(|t| t.angle.is_some() || t.lengths > 0).map(|t| t.place);
    let wrong = |text: String| place.map_or(Ok(()), |p| Err(Error::new(p, text)));
    match measure {
        Measure::Angle if long => wrong(format!("joint {joint} turns: its range is in angles"))?,
        Measure::Length if angular => wrong(format!("joint {joint} slides: its range is in lengths"))?,
        _ => {}
    }
    let field = |i: &usize| scope.names.get(*i).filter(|d| d.field);
    for t in &sum.terms {
        let declared = match t.angle {
            Some(super::sum::AngleUnit::Declared(i)) => scope.names.get(i),
            _ => t.names.iter().find_map(field),
        };
        if let Some(d) = declared {
            let text = format!("`{}` is a field: a range needs numbers or constants", d.name);
            return Err(Error::new(t.place, text));
        }
    }
    let site = Site("this range");
    if angle {
        let a = cell::angle(sum, scope, site)?;
        let exact = a.half_turns.unwrap_or(Rational::ZERO);
        return Ok(match a.approx {
            None => Bound::HalfTurns(exact),
            Some(x) => Bound::Radians(&x + &(&exact * &pi())),
        });
    }
    let length = cell::length(sum, scope, site)?;
    let value = length.terms.iter().fold(Rational::ZERO, |x, (factor, names)| {
        let (y, _) = scope.fold_constants(factor, names);
        &x + &y
    });
    Ok(Bound::Length(value))
}

/// pi to 30 digits: for bounds, which are rounded anyway.
fn pi() -> Rational {
    Rational::from_decimal("3.141592653589793238462643383280").unwrap_or(Rational::ZERO)
}

fn radians(b: &Bound) -> Rational {
    match b {
        Bound::HalfTurns(x) => x * &pi(),
        Bound::Radians(x) | Bound::Length(x) => x.clone(),
    }
}
