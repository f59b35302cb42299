//! The lines of a table's text: struct, settings, `let` lines, the table proper, claims. No meaning yet.

use super::cursor::{Cursor, unwrapped};
use super::rows::{self, Grid};
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};

/// `/// docs`, attributes, `pub struct Name;`.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// All attributes in order, doc comments too; derives without the traits that every robot has (`Debug`, `Clone`, ...).
    pub attributes: TokenStream,
    /// The lines of the doc comment.
    pub docs: Vec<String>,
    /// `pub`, `pub(crate)` or nothing.
    pub visibility: TokenStream,
    /// The name; `None` where no `struct Name` was found.
    pub name: Option<Ident>,
}

/// Some words.
#[derive(Clone, Debug)]
pub(super) struct Words {
    pub(super) text: String,
    pub(super) place: Place,
}

/// `NAME = VALUE;`
#[derive(Clone, Debug)]
pub(super) struct SettingLine {
    pub(super) name: Ident,
    pub(super) value: Vec<TokenTree>,
    /// The value's place (the name's, where there is no value).
    pub(super) place: Place,
}

/// `let NAME: KIND = VALUE;`
#[derive(Clone, Debug)]
pub(super) struct Let {
    pub(super) docs: Vec<String>,
    pub(super) name: Ident,
    pub(super) kind: Option<Words>,
    pub(super) value: Option<Vec<TokenTree>>,
    pub(super) place: Place,
}

/// One line of a `prove` block, unread.
#[derive(Clone, Debug)]
pub struct ClaimTokens {
    /// Its tokens without the `;`.
    pub tokens: Vec<TokenTree>,
    /// From the first token to the last.
    pub place: Place,
}

/// The text of one call.
#[derive(Debug, Default)]
pub(super) struct Written {
    pub(super) head: Head,
    pub(super) settings: Vec<SettingLine>,
    pub(super) lets: Vec<Let>,
    pub(super) grid: Option<Grid>,
    pub(super) claims: Vec<ClaimTokens>,
}

/// Reads everything, and goes on after each error.
pub(super) fn read(tokens: &[TokenTree], errors: &mut Errors) -> Written {
    let mut c = Cursor::new(tokens);
    let mut written = Written { head: head(&mut c, errors), ..Written::default() };
    while let Some(token) = c.peek() {
        if c.is_punct(0, '#') {
            let (_, docs, place) = attributes(&mut c, errors);
            if c.is_word(0, "let") {
                written.lets.extend(let_line(&mut c, docs, errors));
            } else {
                errors.push(Error::new(place, "comments for the documentation stand before the `struct` or a `let`"));
            }
        } else if c.is_word(0, "let") {
            written.lets.extend(let_line(&mut c, Vec::new(), errors));
        } else if c.is_punct(0, '|') {
            let grid = rows::read(&mut c, errors);
            match &written.grid {
                Some(first) => errors.push(
                    Error::new(grid.place, "a second table: there is one robot in each call")
                        .related(first.place, "the first table is here"),
                ),
                None => written.grid = Some(grid),
            }
        } else if c.is_word(0, "prove") && matches!(c.look(1), Some(TokenTree::Group(_))) {
            prove(&mut c, &mut written.claims, errors);
        } else if c.is_word(0, "pub") || c.is_word(0, "struct") {
            errors.push(Error::new(Place::of(token), "a second struct: there is one robot in each call"));
            skip_line(&mut c);
        } else if let (TokenTree::Ident(name), true) = (token, c.is_punct(1, '=')) {
            c.next();
            c.next();
            let value = value(&mut c, errors);
            let place = Place::of_all(&value).unwrap_or_else(|| Place::at(name.span()));
            written.settings.push(SettingLine { name: name.clone(), value, place });
        } else if let (TokenTree::Ident(name), true) = (token, c.is_word(0, "calibrated") && c.is_punct(1, ';')) {
            c.next();
            c.next();
            let place = Place::at(name.span());
            written.settings.push(SettingLine { name: name.clone(), value: Vec::new(), place });
        } else {
            let error = Error::new(Place::of(token), "this belongs to no line of the table");
            errors.push(match token {
                TokenTree::Ident(i) => error.help(format!("a setting is written `{i} = VALUE;`")),
                TokenTree::Punct(p) if p.as_char() == ';' => error.help("no `;` stands here"),
                _ => error.help("lines are settings `NAME = VALUE;`, `let NAME = VALUE;` and rows `| ... |`"),
            });
            skip_line(&mut c);
        }
    }
    written
}

/// To the next place where a line may start.
fn skip_line(c: &mut Cursor<'_>) {
    c.next();
    c.take_while(|c| !c.is_punct(0, ';') && !c.is_punct(0, '|') && !c.starts_line());
    c.eat_punct(';');
}

/// `#[...]` in a row: tokens, lines of documentation, place.
fn attributes(c: &mut Cursor<'_>, errors: &mut Errors) -> (TokenStream, Vec<String>, Place) {
    let (mut tokens, mut docs, mut place) = (Vec::new(), Vec::new(), c.place());
    while let Some(hash) = c.peek().filter(|_| c.is_punct(0, '#')) {
        c.next();
        if let Some(inner) = c.eat_punct('!') {
            errors.push(Error::new(inner, "attributes of the inside (`#!`, `//!`) have no meaning here"));
        }
        match c.eat_group(Delimiter::Bracket) {
            Some(group) => {
                let inside = unwrapped(group.stream());
                if !matches!(inside.first(), Some(TokenTree::Ident(_))) && !leading_colons(&inside) {
                    let error = Error::new(Place::of(&TokenTree::Group(group.clone())), "this is no attribute");
                    errors.push(error.help("an attribute is written `#[name]` or `#[name(...)]`"));
                    continue;
                }
                if let [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Literal(text)] = inside.as_slice() {
                    // Other literals than strings are left to rustc.
                    if name == "doc"
                        && text.to_string().starts_with(['"', 'r'])
                        && let syn::Lit::Str(text) = syn::Lit::new(text.clone())
                    {
                        docs.push(text.value());
                    }
                }
                tokens.extend([hash.clone(), TokenTree::Group(group.clone())]);
            }
            None => errors.push(Error::new(Place::of(hash), "`#` starts an attribute: `#[...]`")),
        }
        place = place.to(c.before());
    }
    (tokens.into_iter().collect(), docs, place)
}

/// Whether a path with leading colons begins here.
fn leading_colons(inside: &[TokenTree]) -> bool {
    matches!(inside.first(), Some(TokenTree::Punct(p)) if p.as_char() == ':')
}

fn head(c: &mut Cursor<'_>, errors: &mut Errors) -> Head {
    const FORM: &str = "the first line names the robot: `pub struct Name;`";
    let (attributes, docs, _) = attributes(c, errors);
    let mut head = Head { attributes, docs, ..Head::default() };
    if let Some(public) = c.peek().filter(|_| c.is_word(0, "pub")) {
        c.next();
        let scope = c.eat_group(Delimiter::Parenthesis).map(|g| TokenTree::Group(g.clone()));
        if let Some(scope @ TokenTree::Group(g)) = &scope {
            let words: Vec<String> = g.stream().into_iter().map(|t| t.to_string()).collect();
            let known = matches!(words.first().map(String::as_str), Some("crate" | "super" | "self") if words.len() == 1)
                || words.first().is_some_and(|w| w == "in");
            if !known {
                let error = Error::new(Place::of(scope), "this is no visibility");
                errors.push(error.help("`pub`, `pub(crate)`, `pub(super)` or `pub(in path)`"));
            }
        }
        head.visibility = std::iter::once(public.clone()).chain(scope).collect();
    } else if let Some(group) = c.eat_group(Delimiter::None) {
        head.visibility = group.stream();
    }
    let place = c.place();
    if !c.is_word(0, "struct") {
        errors.push(Error::new(place, "`struct` is missing").help(FORM));
        if c.peek().is_some() && !c.starts_line() && !c.is_punct(0, '|') {
            skip_line(c);
        }
        return head;
    }
    c.next();
    match c.eat_ident() {
        Some(name) => {
            // A name that cannot be a type would break the stub as well.
            head.name = errors.take(super::names::check_type(name)).map(|()| name.clone());
        }
        None => errors.push(Error::new(c.place(), "the name of the robot is missing").help(FORM)),
    }
    if c.eat_punct(';').is_some() {
        return head;
    }
    let error = Error::new(c.place(), "`;` is missing after the name of the robot").help(FORM);
    match c.peek() {
        Some(TokenTree::Group(_)) => {
            errors
                .push(Error::new(c.place(), "the struct has no body here: its fields are the `let` lines").help(FORM));
            c.next();
            c.eat_punct(';');
        }
        Some(_) if !c.starts_line() && !c.is_punct(0, '|') => {
            errors.push(error);
            skip_line(c);
        }
        _ => errors.push(error),
    }
    head
}

/// The tokens up to `;`.
fn value(c: &mut Cursor<'_>, errors: &mut Errors) -> Vec<TokenTree> {
    let tokens = c.take_while(|c| !c.is_punct(0, ';') && !c.is_punct(0, '|') && !c.starts_line()).to_vec();
    let before = c.before();
    if c.eat_punct(';').is_none() {
        errors.push(Error::new(before, "`;` is missing after this"));
    }
    tokens
}

fn let_line(c: &mut Cursor<'_>, docs: Vec<String>, errors: &mut Errors) -> Option<Let> {
    let start = c.place();
    c.next();
    let Some(name) = c.eat_ident() else {
        errors.push(Error::new(start.to(c.place()), "a name follows `let`").help("`let a2: length = 431.8mm;`"));
        skip_line(c);
        return None;
    };
    let mut line = Let { docs, name: name.clone(), kind: None, value: None, place: Place::at(name.span()) };
    if let Some(colon) = c.eat_punct(':') {
        let tokens =
            c.take_while(|c| !c.is_punct(0, ';') && !c.is_punct(0, '=') && !c.is_punct(0, '|') && !c.is_word(0, "let"));
        let place = Place::of_all(tokens).unwrap_or(colon);
        line.kind = Some(Words { text: super::text::of(tokens), place });
    }
    if let Some(equals) = c.eat_punct('=') {
        let tokens = value(c, errors);
        line.place = Place::of_all(&tokens).unwrap_or(equals);
        line.value = Some(tokens);
    } else if c.eat_punct(';').is_none() {
        let error = Error::new(c.before(), "`;` is missing after this");
        let stray = c.peek().is_some() && !c.is_word(0, "let") && !c.is_punct(0, '|') && !c.starts_line();
        errors.push(match c.peek() {
            Some(token) if stray => Error::new(Place::of(token), "`:`, `=` or `;` was expected here"),
            _ => error,
        });
        if stray {
            skip_line(c);
        }
    }
    Some(line)
}

fn prove(c: &mut Cursor<'_>, claims: &mut Vec<ClaimTokens>, errors: &mut Errors) {
    c.next();
    let Some(token) = c.next() else { return };
    let TokenTree::Group(group) = token else { return };
    if group.delimiter() != Delimiter::Brace {
        errors.push(Error::new(Place::of(token), "the claims stand in braces: `prove { ... }`"));
    }
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    for tokens in tokens.split(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ';')) {
        if let Some(place) = Place::of_all(tokens) {
            claims.push(ClaimTokens { tokens: tokens.to_vec(), place });
        }
    }
    c.eat_punct(';');
}
