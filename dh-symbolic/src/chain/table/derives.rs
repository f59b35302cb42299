//! `#[derive(...)]` on the struct: what the generated type has anyway is taken out, since twice would not compile.

use super::cursor::unwrapped;
use crate::diagnostic::Place;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Traits of every generated type.
const PROVIDED: [&str; 5] = ["Clone", "Copy", "Debug", "Default", "PartialEq"];

/// The attributes without the traits that are provided, and the place of `Default`, if it was asked for.
pub(super) fn filter(attributes: TokenStream) -> (TokenStream, Option<Place>) {
    let mut default = None;
    let filtered = attributes.into_iter().map(|token| match &token {
        TokenTree::Group(attribute) => {
            let inside = unwrapped(attribute.stream());
            match inside.as_slice() {
                [word @ TokenTree::Ident(name), TokenTree::Group(list)] if name == "derive" => {
                    let (list, place) = traits(list);
                    default = default.or(place);
                    let mut group = Group::new(Delimiter::Bracket, [word.clone(), list].into_iter().collect());
                    group.set_span(attribute.span());
                    TokenTree::Group(group)
                }
                _ => token,
            }
        }
        _ => token,
    });
    (filtered.collect(), default)
}

/// The list of one `derive`.
fn traits(list: &Group) -> (TokenTree, Option<Place>) {
    let tokens: Vec<TokenTree> = list.stream().into_iter().collect();
    let (mut kept, mut default) = (Vec::new(), None);
    for path in tokens.split_inclusive(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ',')) {
        let last = path.iter().rev().find_map(|t| match t {
            TokenTree::Ident(i) => Some(i),
            _ => None,
        });
        match last {
            Some(name) if PROVIDED.iter().any(|p| name == p) => {
                if name == "Default" {
                    default = Some(Place::at(name.span()));
                }
            }
            _ => kept.extend_from_slice(path),
        }
    }
    let mut group = Group::new(Delimiter::Parenthesis, kept.into_iter().collect());
    group.set_span(list.span());
    (TokenTree::Group(group), default)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn provided_traits_are_taken_out() {
        let read = |text: &str| filter(text.parse().expect("attributes"));
        let (rest, default) = read("#[doc = \"x\"] #[derive(Debug, serde::Serialize, Default, Hash)] #[cfg(test)]");
        let want: TokenStream =
            "#[doc = \"x\"] #[derive(serde::Serialize, Hash)] #[cfg(test)]".parse().expect("tokens");
        assert_eq!((rest.to_string(), default.is_some()), (want.to_string(), true));
        assert!(read("#[derive(core::clone::Clone)]").0.to_string().replace(' ', "") == "#[derive()]");
    }
}
