//! Reads `base` and `tool`: products of `tx ty tz rx ry rz`.

use super::cell::{self, Site};
use super::cursor::Cursor;
use super::expression;
use super::scope::{Kind, Scope};
use super::spelling::suggestion;
use super::statements::SettingLine;
use crate::chain::MotionSpec;
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::{Delimiter, Ident, TokenTree};

/// Most factors of one product.
const MOST: usize = 16;
const MOTIONS: [&str; 6] = ["tx", "ty", "tz", "rx", "ry", "rz"];

/// Reads `tz(206mm) * ry(90deg)`; all errors of the factors are collected.
pub(super) fn read(setting: &SettingLine, scope: &Scope, errors: &mut Errors) -> Vec<MotionSpec> {
    let mut list = Vec::new();
    let mut c = Cursor::new(&setting.value);
    loop {
        let place = if c.peek().is_some() { c.place() } else { setting.place };
        match (c.eat_ident(), c.eat_group(Delimiter::Parenthesis)) {
            (Some(name), Some(group)) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let around = Place::of(&TokenTree::Group(group.clone()));
                list.extend(errors.take(factor(name, &inside, around, scope)));
            }
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
        errors.push(Error::new(setting.place, format!("a product of more than {MOST} motions")));
    }
    list
}

fn factor(name: &Ident, inside: &[TokenTree], place: Place, scope: &Scope) -> Result<MotionSpec, Error> {
    let text = name.to_string();
    let Some(which) = MOTIONS.iter().position(|m| *m == text) else {
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
