//! Arithmetic in a cell: tokens to a [`Sum`]. `+ - * /`, parentheses, numbers with units, `pi`, `approx`, names.

use super::names::{suggestion, variable_number};
use super::number::{self, Unit};
use super::scope::{Kind, Scope};
use super::sum::{AngleUnit, Sum, Term};
use crate::algebra::{Angle, Rational};
use crate::diagnostic::{Error, Place};
use proc_macro2::{Delimiter, Ident, Literal, TokenTree};

/// Limits of one cell, against hostile input.
const MOST_TOKENS: usize = 200;
const DEEPEST: usize = 64;

/// Reads an expression. `place` is where an empty one stands.
pub(super) fn read(tokens: &[TokenTree], place: Place, scope: &Scope) -> Result<Sum, Error> {
    let mut budget = MOST_TOKENS;
    Reader { tokens, at: 0, end: place, scope, depth: 0, budget: &mut budget }.all()
}

struct Reader<'a> {
    tokens: &'a [TokenTree],
    at: usize,
    /// Where to point if something is missing at the end.
    end: Place,
    scope: &'a Scope,
    depth: usize,
    /// Tokens that may still be read, groups included.
    budget: &'a mut usize,
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<&'a TokenTree> {
        self.tokens.get(self.at)
    }

    fn punct(&self, offset: usize) -> Option<char> {
        match self.tokens.get(self.at + offset) {
            Some(TokenTree::Punct(p)) => Some(p.as_char()),
            _ => None,
        }
    }

    fn next(&mut self) -> Result<Option<&'a TokenTree>, Error> {
        let Some(token) = self.peek() else { return Ok(None) };
        if *self.budget == 0 {
            return Err(Error::new(Place::of(token), "this cell is too long"));
        }
        *self.budget -= 1;
        self.at += 1;
        Ok(Some(token))
    }

    fn all(&mut self) -> Result<Sum, Error> {
        let sum = self.sum()?;
        match self.peek() {
            None => Ok(sum),
            Some(token) => Err(self.unexpected(token)),
        }
    }

    fn sum(&mut self) -> Result<Sum, Error> {
        let mut sum = self.product()?;
        while let Some(sign @ ('+' | '-')) = self.punct(0) {
            self.next()?;
            let term = self.product()?;
            sum.add(if sign == '-' { term.scaled(&Rational::int(-1)) } else { term })?;
        }
        Ok(sum)
    }

    fn product(&mut self) -> Result<Sum, Error> {
        let mut product = self.signed()?;
        while let Some(operator @ ('*' | '/')) = self.punct(0) {
            self.next()?;
            let start = self.at;
            let factor = self.signed()?;
            product = match operator {
                '*' => product.times(&factor)?,
                _ => {
                    let place = Place::of_all(self.tokens.get(start..self.at).unwrap_or(&[])).unwrap_or(self.end);
                    product.scaled(&self.divisor(&factor, place)?)
                }
            };
        }
        Ok(product)
    }

    /// 1 / factor.
    fn divisor(&self, factor: &Sum, place: Place) -> Result<Rational, Error> {
        let mut value = Rational::ZERO;
        for t in &factor.terms {
            let (x, fields) = self.scope.fold_constants(&t.factor, &t.names);
            if !fields.is_empty() || t.lengths > 0 || t.angle.is_some() || t.variable.is_some() {
                return Err(Error::new(place, "only plain numbers divide").help("write a factor instead: `0.5*a2`"));
            }
            value = &value + &x;
        }
        value.recip().ok_or_else(|| Error::new(place, "division by zero"))
    }

    /// Any number of signs before an atom.
    fn signed(&mut self) -> Result<Sum, Error> {
        let mut negative = false;
        while let Some(sign @ ('+' | '-')) = self.punct(0) {
            self.next()?;
            negative ^= sign == '-';
        }
        let atom = self.atom(negative)?;
        Ok(if negative { atom.scaled(&Rational::int(-1)) } else { atom })
    }

    /// A number, a name or parentheses; `negative`: a minus stands before it.
    fn atom(&mut self, negative: bool) -> Result<Sum, Error> {
        match self.next()? {
            Some(TokenTree::Literal(literal)) => self.number(literal, negative, false),
            Some(TokenTree::Ident(name)) => self.name(name, negative),
            Some(token @ TokenTree::Group(group)) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                match group.delimiter() {
                    // An invisible group is what a `macro_rules!` fragment arrives in.
                    Delimiter::Parenthesis | Delimiter::None if self.depth < DEEPEST => Reader {
                        tokens: &inside,
                        at: 0,
                        end: Place::of(token),
                        scope: self.scope,
                        depth: self.depth + 1,
                        budget: &mut *self.budget,
                    }
                    .all(),
                    Delimiter::Parenthesis | Delimiter::None => {
                        Err(Error::new(Place::of(token), format!("parentheses deeper than {DEEPEST}")))
                    }
                    _ => Err(Error::new(Place::of(token), "only round parentheses group here")),
                }
            }
            Some(token) => {
                if let (TokenTree::Punct(p), Some(TokenTree::Literal(l))) = (token, self.peek())
                    && p.as_char() == '.'
                {
                    let place = Place::of(token).to(Place::at(l.span()));
                    return Err(Error::new(place, "a number starts with a digit").help(format!("write `0.{l}`")));
                }
                Err(self.unexpected(token))
            }
            None => Err(Error::new(self.end, "a number or a name is missing here")),
        }
    }

    /// What cannot stand where it stands.
    fn unexpected(&self, token: &TokenTree) -> Error {
        let place = Place::of(token);
        let before = self.at.checked_sub(1).and_then(|i| self.tokens.get(i));
        match (before, token) {
            (Some(TokenTree::Literal(l)), TokenTree::Ident(unit)) if number::is_unit(&unit.to_string()) => {
                Error::new(Place::at(l.span()).to(place), "no space stands between a number and its unit")
                    .help(format!("write `{l}{unit}`"))
            }
            (Some(TokenTree::Literal(l)), TokenTree::Punct(p)) if p.as_char() == '.' => {
                let unit = self.tokens.get(self.at + 1).map(ToString::to_string).filter(|u| number::is_unit(u));
                let unit = unit.unwrap_or_default();
                Error::new(Place::at(l.span()).to(place), "a number does not end with its point")
                    .help(format!("write `{l}{unit}` or `{l}.0{unit}`"))
            }
            (Some(TokenTree::Ident(name)), TokenTree::Group(g)) if g.delimiter() == Delimiter::Parenthesis => {
                Error::new(Place::at(name.span()).to(place), "a cell holds sums and products, no functions")
            }
            (Some(_), TokenTree::Ident(_) | TokenTree::Literal(_) | TokenTree::Group(_)) => {
                Error::new(place, "an operator is missing before this").help("a product is written with `*`")
            }
            (_, TokenTree::Punct(p)) if p.as_char() == '^' => {
                Error::new(place, "there are no powers here").help("write a product")
            }
            (_, TokenTree::Punct(p)) => Error::new(place, format!("`{}` has no meaning here", p.as_char())),
            _ => Error::new(place, "this has no meaning here"),
        }
    }

    fn number(&self, literal: &Literal, negative: bool, approximate: bool) -> Result<Sum, Error> {
        let place = Place::at(literal.span());
        let n = number::read(literal, &|name| self.scope.find(name).is_some())?;
        let mut term = Term::number(n.value.clone(), place, literal.to_string());
        match &n.unit {
            Unit::Radians => {
                check_radians(&n, &term.word, place, negative, approximate)?;
                term.angle = Some(if n.value.is_zero() { AngleUnit::Pi } else { AngleUnit::Radian });
            }
            _ if approximate => {
                return Err(Error::new(place, "`approx` is for radians; all other numbers are exact")
                    .help("leave `approx` out"));
            }
            Unit::None => {}
            Unit::HalfTurns(x) => {
                term.factor = &term.factor * x;
                term.angle = Some(AngleUnit::Pi);
            }
            Unit::Length(metres) => {
                let per_metre = self.scope.unit.metres.recip().unwrap_or(Rational::ONE);
                term.factor = &(&term.factor * metres) * &per_metre;
                term.lengths = 1;
                term.literal_length = true;
            }
        }
        Ok(Sum::of(term))
    }

    fn name(&mut self, name: &Ident, negative: bool) -> Result<Sum, Error> {
        let text = name.to_string();
        let place = Place::at(name.span());
        let mut term = Term::number(Rational::ONE, place, text.clone());
        if text == "approx" {
            return self.approximate(place, negative);
        }
        if let Some(token @ TokenTree::Group(g)) = self.peek()
            && g.delimiter() == Delimiter::Parenthesis
        {
            return Err(self.unexpected(token));
        }
        if text == "pi" {
            term.angle = Some(AngleUnit::Pi);
            return Ok(Sum::of(term));
        }
        if let Some(n) = variable_number(&text) {
            let Some(index) = n.checked_sub(1) else {
                return Err(Error::new(place, "joint variables are numbered from 1: `q1` is the first"));
            };
            term.variable = Some(index);
            return Ok(Sum::of(term));
        }
        let Some((index, declared)) = self.scope.find(&text).and_then(|i| Some((i, self.scope.names.get(i)?))) else {
            return Err(self.unknown(&text, place));
        };
        match (declared.kind, &declared.value) {
            // Constant angles are exact where they are written so: put in place, they keep the structure of the arm visible.
            (Kind::Angle, Some(value)) if !declared.field => {
                let mut value = value.clone();
                for t in &mut value.terms {
                    t.place = place;
                    t.word.clone_from(&text);
                }
                return Ok(value);
            }
            (Kind::Angle, _) => term.angle = Some(AngleUnit::Declared(index)),
            (kind, _) => {
                term.lengths = usize::from(kind == Kind::Length);
                match declared.constant() {
                    Some(x) if x.is_zero() => term.factor = Rational::ZERO,
                    _ => term.names.push(index),
                }
            }
        }
        Ok(Sum::of(term))
    }

    /// `approx 1.2rad`, `approx -1.2rad`.
    fn approximate(&mut self, place: Place, mut negative: bool) -> Result<Sum, Error> {
        let mut flip = false;
        while let Some(sign @ ('+' | '-')) = self.punct(0) {
            self.next()?;
            flip ^= sign == '-';
        }
        negative ^= flip;
        match self.next()? {
            Some(TokenTree::Literal(literal)) => {
                let sum = self.number(literal, negative, true)?;
                Ok(if flip { sum.scaled(&Rational::int(-1)) } else { sum })
            }
            _ => Err(Error::new(place, "`approx` stands before a number in radians: `approx 1.2rad`")),
        }
    }

    fn unknown(&self, name: &str, place: Place) -> Error {
        let error = Error::new(place, format!("unknown name `{}`", name.escape_debug()));
        let columns = ["alpha", "a", "d", "theta", "joint", "range"];
        if let Some(near) = suggestion(name, self.scope.names.iter().map(|d| d.name.as_str()).chain(["pi"])) {
            return error.help(format!("did you mean `{near}`?"));
        }
        if number::is_unit(name) {
            return error.help("a unit stands behind its number: `431.8mm`");
        }
        if matches!(name, "π" | "PI") {
            return error.help("write `pi`");
        }
        if name.starts_with("theta") || name.starts_with('θ') {
            let digits: String = name.chars().filter(char::is_ascii_digit).collect();
            let digits = if digits.is_empty() { "1" } else { &digits };
            return error.help(format!("the variable of a joint is called `q{digits}`"));
        }
        if columns.contains(&name) || !name.is_ascii() || super::names::variable_number(name).is_some() {
            return error;
        }
        error.help(format!("declare it: `let {name}: length;`"))
    }
}

/// Radians are never exact (except 0): they must say so, and must not be the rounded form of an exact angle.
fn check_radians(
    n: &number::Number,
    written: &str,
    place: Place,
    negative: bool,
    approximate: bool,
) -> Result<(), Error> {
    /// As near to a multiple of 15 degrees as this, in radians, an angle looks like one: 1.57 does, 1.3 does not.
    const NEAR: f64 = 2e-3;
    /// As near as this it is one, however many digits are written.
    const EQUAL: f64 = 1e-9;
    if n.value.is_zero() && !approximate {
        return Ok(());
    }
    let x = n.value.to_f64();
    let steps = (x * 12.0 / std::f64::consts::PI).round();
    let miss = (x - steps * std::f64::consts::PI / 12.0).abs();
    // Calibrated arms have angles like 1.570320019: near, but no rounded pi/2. A rounded one misses by less than its last digit.
    let rounded = miss < NEAR && miss <= n.last_digit.to_f64();
    if miss < EQUAL || rounded || (miss < NEAR && !approximate) {
        let steps = Rational::int(if negative { -steps as i64 } else { steps as i64 });
        let spelling = exact_spelling(&steps);
        let what =
            if approximate { "this is an exact angle, written as a rounded number" } else { "radians are never exact" };
        return Err(Error::new(place, what).help(format!("write {spelling}")));
    }
    if !approximate {
        let text = format!("radians are never exact: say `approx {written}`");
        return Err(Error::new(place, text).help("or write the angle in degrees"));
    }
    Ok(())
}

/// "`90deg` or `pi/2`": a number of 15-degree steps.
fn exact_spelling(steps: &Rational) -> String {
    if steps.is_zero() {
        return "`0`".into();
    }
    let degrees = steps * &Rational::int(15);
    let angle = Angle::degrees(&degrees);
    match angle.factor().to_small() {
        Some((1, 1)) => format!("`{degrees}deg` or `pi`"),
        Some((-1, 1)) => format!("`{degrees}deg` or `-pi`"),
        Some((n, 1)) => format!("`{degrees}deg` or `{n}*pi`"),
        Some((1, d)) => format!("`{degrees}deg` or `pi/{d}`"),
        Some((-1, d)) => format!("`{degrees}deg` or `-pi/{d}`"),
        Some((n, d)) => format!("`{degrees}deg` or `{n}*pi/{d}`"),
        None => format!("`{degrees}deg`"),
    }
}
