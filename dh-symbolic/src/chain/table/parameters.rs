//! `let` lines: fields and constants.

use super::cell::{self, Site};
use super::expression;
use super::motion;
use super::names::check_parameter;
use super::scope::{Declared, DeclaredPose, Kind, Scope};
use super::spelling::suggestion;
use super::statements::Let;
use super::sum::{AngleUnit, Sum, Term};
use crate::algebra::Rational;
use crate::chain::{AngleCell, Nominal, ParameterSpec, PoseSpec, Quantity, Role};
use crate::diagnostic::{Error, Errors};

/// Most names of one table.
const MOST: usize = 64;

/// Reads a line and adds its name to the scope, whatever is wrong with it: cells that use the name stay one error.
pub(super) fn declare(line: &Let, scope: &mut Scope, errors: &mut Errors) {
    let name = line.name.to_string();
    let place = crate::diagnostic::Place::at(line.name.span());
    errors.take(check_parameter(&line.name));
    if let Some(first) = scope.place(&name) {
        errors.push(Error::new(place, format!("`{name}` is declared twice")).related(first, "first declared here"));
        return;
    }
    if scope.names.len() + scope.poses.len() == MOST {
        errors.push(Error::new(place, format!("a table has at most {MOST} names")));
        return;
    }
    if line.kind.as_ref().is_some_and(|kind| kind.text == "pose") {
        let value = line.value.as_ref().map(|tokens| motion::constant(tokens, line.place, scope, errors));
        scope.poses.push(DeclaredPose { name, value, place });
        return;
    }
    let mut declared =
        Declared { name, kind: Kind::Number, field: line.kind.is_some(), value: None, sound: true, place };
    if let Some(kind) = &line.kind {
        match errors.take(read_kind(kind)) {
            Some(k) => declared.kind = k,
            None => declared.sound = false,
        }
    }
    match &line.value {
        Some(tokens) => {
            let value = expression::read(tokens, line.place, scope, declared.kind).and_then(|sum| {
                // What a wrong line leads to is no second error.
                declared.sound &= !cell::doubtful(&sum, scope);
                if declared.sound { constant(&sum, scope, line) } else { Ok((sum, Kind::Number)) }
            });
            match errors.take(value) {
                Some(_) if !declared.sound => {}
                Some((sum, found)) => {
                    if !declared.field {
                        declared.kind = found;
                    }
                    match errors.take(checked(&declared, &sum, scope)) {
                        Some(sum) => declared.value = Some(sum),
                        None => declared.sound = false,
                    }
                }
                None => declared.sound = false,
            }
        }
        None if line.kind.is_none() => {
            let error = Error::new(place, format!("`let {}` has neither a kind nor a value", declared.name));
            errors.push(error.help(format!("write `let {0}: length;` or `let {0} = 431.8mm;`", declared.name)));
            declared.sound = false;
        }
        None => {}
    }
    scope.names.push(declared);
}

fn read_kind(kind: &super::statements::Words) -> Result<Kind, Error> {
    match kind.text.as_str() {
        "length" => Ok(Kind::Length),
        "angle" => Ok(Kind::Angle),
        "number" => Ok(Kind::Number),
        other => {
            let error = Error::new(kind.place, "a name is a `length`, an `angle`, a `number` or a `pose`");
            match suggestion(other, ["length", "angle", "number", "pose"]) {
                Some(near) => Err(error.help(format!("did you mean `{near}`?"))),
                None => Err(error),
            }
        }
    }
}

/// Folds the constants of a value; a field or a variable in it is an error. Also the kind that the value shows.
fn constant(sum: &Sum, scope: &Scope, line: &Let) -> Result<(Sum, Kind), Error> {
    let kind = cell::kind(sum, scope);
    let mut folded = Sum::default();
    for t in &sum.terms {
        if t.variable.is_some() {
            return Err(Error::new(t.place, "a joint variable has no value here"));
        }
        let (factor, fields) = scope.fold_constants(&t.factor, &t.names);
        let field = fields.first().copied().or(match t.angle {
            Some(AngleUnit::Declared(i)) => Some(i),
            _ => None,
        });
        if let Some(field) = field.and_then(|i| scope.names.get(i)) {
            let text = format!("`{}` is a field: its value may change while the program runs", field.name);
            return Err(Error::new(t.place, text).help(match line.kind {
                None => "write the expression in the cells, or make both constants: `let NAME = VALUE;`",
                Some(_) => "a nominal value is made of numbers and constants",
            }));
        }
        folded.push(Term { factor, names: Vec::new(), ..t.clone() })?;
    }
    Ok((folded, kind))
}

/// Checks a value against its kind.
fn checked(declared: &Declared, sum: &Sum, scope: &Scope) -> Result<Sum, Error> {
    let site = format!("`{}`", declared.name);
    match declared.kind {
        Kind::Angle => {
            cell::angle(sum, scope, Site(&site))?;
        }
        Kind::Length => {
            cell::length(sum, scope, Site(&site))?;
        }
        Kind::Number => {
            if let Some(t) = sum.terms.iter().find(|t| t.lengths > 0 || t.angle.is_some()) {
                return Err(Error::new(t.place, format!("{site} is a number, but `{}` has a unit", t.word)));
            }
            cell::length(sum, scope, Site(&site))?;
        }
    }
    Ok(sum.clone())
}

/// The poses for the chain, in order.
pub(super) fn poses(scope: &Scope) -> Vec<PoseSpec> {
    scope.poses.iter().map(|p| PoseSpec { name: p.name.clone(), nominal: p.value.clone() }).collect()
}

/// The lines for the chain, in order.
pub(super) fn specs(scope: &Scope) -> Vec<ParameterSpec> {
    scope
        .names
        .iter()
        .map(|d| {
            let quantity = if d.kind == Kind::Angle { Quantity::Angle } else { Quantity::Length };
            let value = d.value.as_ref().map(|sum| match quantity {
                Quantity::Angle => {
                    Nominal::Angle(cell::angle(sum, scope, Site("")).unwrap_or_else(|_| AngleCell::default()))
                }
                Quantity::Length => Nominal::Length(d.number().unwrap_or(Rational::ZERO)),
            });
            let role = match value {
                Some(value) if !d.field => Role::Constant(value),
                value => Role::Field(value),
            };
            ParameterSpec { name: d.name.clone(), quantity, role }
        })
        .collect()
}
