//! Reads `base` and `tool`: products of `tx ty tz rx ry rz` and of poses that the program sets; and nominal values of such poses.

use super::cell::{self, Site};
use super::cursor::Cursor;
use super::expression;
use super::scope::{Kind, Scope};
use super::spelling::{shown, suggestion};
use super::statements::SettingLine;
use crate::chain::MotionSpec;
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::{Delimiter, Ident, TokenTree};

/// Most factors of one product.
const MOST: usize = 16;
const MOTIONS: [&str; 6] = ["tx", "ty", "tz", "rx", "ry", "rz"];

/// Reads `tz(206mm) * ry(90deg) * gripper`; all errors of the factors are collected.
pub(super) fn read(setting: &SettingLine, scope: &Scope, errors: &mut Errors) -> Vec<MotionSpec> {
    product(&setting.value, setting.place, scope, errors).into_iter().map(|(motion, _)| motion).collect()
}

/// Reads the nominal value of a pose: motions by numbers and constants.
pub(super) fn constant(value: &[TokenTree], place: Place, scope: &Scope, errors: &mut Errors) -> Vec<MotionSpec> {
    let mut list = Vec::new();
    for (motion, place) in product(value, place, scope, errors) {
        let named = match &motion {
            MotionSpec::Translate(_, cell) => cell.terms.iter().any(|t| !t.1.is_empty()),
            MotionSpec::Rotate(_, cell) => !cell.symbols.is_empty(),
            MotionSpec::Pose(_) => true,
        };
        if named {
            let error = Error::new(place, "a field stands in a nominal value: it may change while the program runs");
            errors.push(error.help("a nominal value is made of numbers and constants"));
        } else {
            list.push(motion);
        }
    }
    list
}

/// The factors of a product with their places.
fn product(value: &[TokenTree], around: Place, scope: &Scope, errors: &mut Errors) -> Vec<(MotionSpec, Place)> {
    let mut list = Vec::new();
    let mut c = Cursor::new(value);
    loop {
        let place = if c.peek().is_some() { c.place() } else { around };
        match (c.eat_ident(), c.eat_group(Delimiter::Parenthesis)) {
            (Some(name), Some(group)) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let parentheses = Place::of(&TokenTree::Group(group.clone()));
                let motion = errors.take(factor(name, &inside, parentheses, scope));
                list.extend(motion.map(|motion| (motion, place.to(parentheses))));
            }
            (Some(name), None) => match errors.take(pose(name, place, scope)) {
                Some(pose) => list.push((pose, place)),
                None => return list,
            },
            _ => {
                let error = Error::new(place, "a motion was expected here");
                errors.push(error.help("write a product of motions: `tz(206mm) * ry(90deg)`"));
                return list;
            }
        }
        if c.peek().is_none() {
            break;
        }
        if c.eat_punct('*').is_none() {
            errors.push(Error::new(c.place(), "motions are joined by `*`"));
            return list;
        }
    }
    if list.len() > MOST {
        errors.push(Error::new(around, format!("a product of more than {MOST} motions")));
    }
    list
}

/// A factor without parentheses.
fn pose(name: &Ident, place: Place, scope: &Scope) -> Result<MotionSpec, Error> {
    const FORM: &str = "write a product of motions: `tz(206mm) * ry(90deg)`";
    let text = name.to_string();
    if let Some(i) = scope.pose(&text) {
        return Ok(MotionSpec::Pose(i));
    }
    if MOTIONS.contains(&text.as_str()) {
        return Err(Error::new(place, format!("`{text}` says by how much: `{text}(...)`")).help(FORM));
    }
    if let Some(d) = scope.names.iter().find(|d| d.name == text) {
        let (measure, motion) = if d.kind == Kind::Angle { ("an angle", "rz") } else { ("a number", "tz") };
        return Err(
            Error::new(place, format!("`{text}` is {measure}, not a motion")).help(format!("`{motion}({text})`"))
        );
    }
    let error = Error::new(place, format!("unknown pose `{}`", shown(&text)));
    Err(match suggestion(&text, scope.poses.iter().map(|p| p.name.as_str())) {
        Some(near) => error.help(format!("did you mean `{near}`?")),
        None => error.help(format!("declare it: `let {}: pose;`; or {FORM}", shown(&text))),
    })
}

fn factor(name: &Ident, inside: &[TokenTree], place: Place, scope: &Scope) -> Result<MotionSpec, Error> {
    let text = name.to_string();
    let Some(which) = MOTIONS.iter().position(|m| *m == text) else {
        if scope.pose(&text).is_some() {
            return Err(
                Error::new(place, format!("`{text}` is a pose: it takes no value")).help(format!("write `{text}`"))
            );
        }
        let error = Error::new(Place::at(name.span()), format!("unknown motion `{text}`; there are tx ty tz rx ry rz"));
        return Err(match suggestion(&text, MOTIONS) {
            Some(near) => error.help(format!("did you mean `{near}`?")),
            None => error,
        });
    };
    let site = format!("`{text}`");
    let sum = expression::read(inside, place, scope, if which < 3 { Kind::Length } else { Kind::Angle })?;
    if let Some(t) = sum.terms.iter().find(|t| t.variable.is_some()) {
        return Err(Error::new(t.place, "`base` and `tool` are constant: no joint variable stands here"));
    }
    Ok(if which < 3 {
        MotionSpec::Translate(which, cell::length(&sum, scope, Site(&site))?)
    } else {
        MotionSpec::Rotate(which - 3, cell::angle(&sum, scope, Site(&site))?)
    })
}
