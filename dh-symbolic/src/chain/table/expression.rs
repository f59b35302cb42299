//! Arithmetic in a cell: tokens to a [`Sum`]. `+ - * /`, parentheses, numbers with units, `pi`, `approx`, names.

use super::functions;
use super::names::variable_number;
use super::number::{self, Unit};
use super::radians;
use super::scope::{Kind, Scope};
use super::spelling::{shown, suggestion};
use super::sum::{AngleUnit, Sum, Term};
use crate::algebra::Rational;
use crate::diagnostic::{Error, Place};
use proc_macro2::{Delimiter, Ident, Literal, TokenTree};

/// Limits of one cell, against hostile input.
const MOST_TOKENS: usize = 200;
const DEEPEST: usize = 64;
const MOST_DIGITS: usize = 1000;

/// Reads an expression. `place` is where an empty one stands; `want` is what an undeclared name is likely to be.
pub(super) fn read(tokens: &[TokenTree], place: Place, scope: &Scope, want: Kind) -> Result<Sum, Error> {
    read_as(tokens, place, scope, want, false)
}

/// Reads a bound of a range: nothing is derived from it, so radians may be rounded, and need no `approx`.
pub(super) fn read_bound(tokens: &[TokenTree], place: Place, scope: &Scope, want: Kind) -> Result<Sum, Error> {
    read_as(tokens, place, scope, want, true)
}

fn read_as(tokens: &[TokenTree], place: Place, scope: &Scope, want: Kind, rounded: bool) -> Result<Sum, Error> {
    let mut budget = Budget { tokens: MOST_TOKENS, digits: MOST_DIGITS };
    Reader { tokens, at: 0, end: place, scope, want, rounded, depth: 0, budget: &mut budget }.all()
}

struct Reader<'a> {
    tokens: &'a [TokenTree],
    at: usize,
    /// Where to point if something is missing at the end.
    end: Place,
    scope: &'a Scope,
    want: Kind,
    /// Whether radians may be rounded numbers.
    rounded: bool,
    depth: usize,
    budget: &'a mut Budget,
}

/// What may still be read, groups included.
struct Budget {
    tokens: usize,
    digits: usize,
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
        self.budget.tokens =
            self.budget.tokens.checked_sub(1).ok_or_else(|| Error::new(Place::of(token), "this cell is too long"))?;
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
        if super::cell::doubtful(factor, self.scope) {
            return Ok(Rational::ONE);
        }
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
        let atom = self.atom()?;
        Ok(if negative { atom.scaled(&Rational::int(-1)) } else { atom })
    }

    /// A number, a name or parentheses.
    fn atom(&mut self) -> Result<Sum, Error> {
        match self.next()? {
            Some(TokenTree::Literal(literal)) => self.number(literal, None),
            Some(TokenTree::Ident(name)) => self.name(name),
            Some(token @ TokenTree::Group(group)) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                match group.delimiter() {
                    // An invisible group is what a `macro_rules!` fragment arrives in.
                    Delimiter::Parenthesis | Delimiter::None if self.depth < DEEPEST => Reader {
                        tokens: &inside,
                        at: 0,
                        end: Place::of(token),
                        scope: self.scope,
                        want: self.want,
                        rounded: self.rounded,
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
                let after = self.tokens.get(self.at + 1).filter(|t| number::is_unit(&t.to_string()));
                let unit = after.map(ToString::to_string).unwrap_or_default();
                Error::new(
                    Place::at(l.span()).to(after.map_or(place, Place::of)),
                    "a number does not end with its point",
                )
                .help(format!("write `{l}{unit}` or `{l}.0{unit}`"))
            }
            (Some(TokenTree::Ident(name)), TokenTree::Group(g)) if g.delimiter() == Delimiter::Parenthesis => {
                Error::new(
                    Place::at(name.span()).to(place),
                    "a cell holds sums and products; of functions there are sqrt, sin, cos, tan, asin, acos, atan, atan2, of constants",
                )
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

    /// `approximate`: where `approx` stands before it, and whether a minus is between.
    fn number(&mut self, literal: &Literal, approximate: Option<(Place, bool)>) -> Result<Sum, Error> {
        let place = Place::at(literal.span());
        let n = number::read(literal, &|name| self.scope.find(name).is_some())?;
        self.budget.digits = self
            .budget
            .digits
            .checked_sub(n.digits)
            .ok_or_else(|| Error::new(place, "this cell has too many digits"))?;
        let mut term = Term::number(n.value.clone(), place, literal.to_string());
        match &n.unit {
            Unit::Radians => {
                if !self.rounded {
                    radians::check(&n, &term.word, place, approximate)?;
                }
                term.angle = Some(if n.value.is_zero() { AngleUnit::Pi } else { AngleUnit::Radian });
            }
            _ if approximate.is_some() => {
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

    fn name(&mut self, name: &Ident) -> Result<Sum, Error> {
        let text = name.to_string();
        let place = Place::at(name.span());
        let mut term = Term::number(Rational::ONE, place, text.clone());
        if text == "approx" {
            return self.approximate(place);
        }
        if let Some(token @ TokenTree::Group(g)) = self.peek()
            && g.delimiter() == Delimiter::Parenthesis
        {
            if !functions::is_function(&text) {
                return Err(self.unexpected(token));
            }
            self.next()?;
            let arguments = self.arguments(g)?;
            return functions::apply(&text, place.to(Place::of(token)), &arguments, self.scope);
        }
        if matches!(text.as_str(), "pi" | "π") {
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
            if self.scope.pose(&text).is_some() {
                let error = Error::new(place, format!("`{text}` is a pose, not a number"));
                return Err(error.help("a pose is a factor of `base` or `tool`"));
            }
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

    /// The arguments of a function.
    fn arguments(&mut self, group: &proc_macro2::Group) -> Result<Vec<Sum>, Error> {
        let place = Place::of(&TokenTree::Group(group.clone()));
        if self.depth >= DEEPEST {
            return Err(Error::new(place, format!("parentheses deeper than {DEEPEST}")));
        }
        let inside: Vec<TokenTree> = group.stream().into_iter().collect();
        let comma = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ',');
        let read = |tokens: &[TokenTree]| {
            Reader {
                tokens,
                at: 0,
                end: place,
                scope: self.scope,
                want: Kind::Length,
                rounded: self.rounded,
                depth: self.depth + 1,
                budget: &mut *self.budget,
            }
            .all()
        };
        inside.split(comma).map(read).collect()
    }

    /// `approx 1.2rad`, `approx -1.2rad`.
    fn approximate(&mut self, place: Place) -> Result<Sum, Error> {
        let mut negative = false;
        while let Some(sign @ ('+' | '-')) = self.punct(0) {
            self.next()?;
            negative ^= sign == '-';
        }
        match self.next()? {
            Some(TokenTree::Literal(literal)) => {
                let sum = self.number(literal, Some((place, negative)))?;
                Ok(if negative { sum.scaled(&Rational::int(-1)) } else { sum })
            }
            _ => Err(Error::new(place, "`approx` stands before a number in radians: `approx 1.2rad`")),
        }
    }

    fn unknown(&self, name: &str, place: Place) -> Error {
        let error = Error::new(place, format!("unknown name `{}`", shown(name)));
        let columns = ["alpha", "a", "d", "theta", "joint", "range"];
        // `a3` is no slip for `a2`.
        let letters = |n: &str| n.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        let other = |d: &&str| d.get(..letters(d)) != name.get(..letters(name));
        if let Some(near) =
            suggestion(name, self.scope.names.iter().map(|d| d.name.as_str()).chain(["pi"]).filter(other))
        {
            return error.help(format!("did you mean `{near}`?"));
        }
        if number::is_unit(name) {
            return error.help("a unit stands behind its number: `431.8mm`");
        }
        if name == "PI" {
            return error.help("write `pi`");
        }
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
        if matches!(letters.to_lowercase().as_str(), "theta" | "θ" | "ϑ" | "th" | "thet" | "theta_" | "q" | "joint") {
            let digits: String = name.chars().filter(char::is_ascii_digit).collect();
            let digits = if digits.is_empty() { "1" } else { &digits };
            return error.help(format!("the variable of a joint is called `q{digits}`"));
        }
        if columns.contains(&name)
            || !name.is_ascii()
            || name.len() > 40
            || super::names::variable_number(name).is_some()
        {
            return error;
        }
        let kind = if self.want == Kind::Angle { "angle" } else { "length" };
        error.help(format!("declare it: `let {name}: {kind};`"))
    }
}
