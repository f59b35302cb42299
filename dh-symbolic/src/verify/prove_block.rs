//! Reads `prove` blocks: Rust tokens become the words of a [`Derivation`], each with its place in the source.

use crate::chain::table::ClaimTokens;
use crate::diagnostic::Place;
use crate::verify::language::{self, Derivation, Token, TokenKind};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Groups nested deeper than this are cut off; the reader of lines refuses far less.
const DEEPEST: usize = 128;

/// A derivation and where its words stand.
#[derive(Clone, Debug, Default)]
pub struct Claims {
    /// The lines.
    pub derivation: Derivation,
    /// The place of every token of the derivation.
    places: Vec<Place>,
}

impl Claims {
    /// Reads the lines of all `prove` blocks of a table.
    pub fn read(lines: &[ClaimTokens]) -> Claims {
        let mut words = Words::default();
        for line in lines {
            words.take(&line.tokens, 0);
            words.put(TokenKind::Mark, ";", line.place);
        }
        words.finish()
    }

    /// Reads lines that stand alone.
    pub fn from_tokens(tokens: TokenStream) -> Claims {
        let mut words = Words::default();
        words.take(&tokens.into_iter().collect::<Vec<_>>(), 0);
        words.finish()
    }

    /// Where some words stand; for an empty range the word before it. `None` where the derivation is empty.
    pub fn place(&self, range: &language::Place) -> Option<Place> {
        let last = range.end.max(1).min(self.places.len()).checked_sub(1)?;
        let first = range.start.min(last);
        Some(self.places.get(first)?.to(*self.places.get(last)?))
    }
}

#[derive(Default)]
struct Words {
    tokens: Vec<Token>,
    places: Vec<Place>,
}

impl Words {
    fn put(&mut self, kind: TokenKind, text: &str, place: Place) {
        self.tokens.push(Token { kind, text: text.to_string() });
        self.places.push(place);
    }

    fn finish(self) -> Claims {
        Claims { derivation: Derivation::parse(self.tokens), places: self.places }
    }

    fn take(&mut self, tokens: &[TokenTree], depth: usize) {
        let mut i = 0;
        while let Some(t) = tokens.get(i) {
            i += 1;
            if let (TokenTree::Punct(p), Some(TokenTree::Group(g))) = (t, tokens.get(i))
                && let ('#', Some(note)) = (p.as_char(), doc_comment(g))
            {
                self.put(TokenKind::Note, &note, Place::of(t).to(Place::of(&tokens[i])));
                i += 1;
                continue;
            }
            match t {
                TokenTree::Ident(name) => self.put(TokenKind::Name, &name.to_string(), Place::of(t)),
                TokenTree::Punct(p) => self.put(TokenKind::Mark, &p.as_char().to_string(), Place::of(t)),
                TokenTree::Literal(l) => self.literal(&l.to_string(), Place::of(t)),
                TokenTree::Group(g) => {
                    let (open, close) = crate::chain::table::text::brackets(g.delimiter());
                    if !open.is_empty() {
                        self.put(TokenKind::Mark, open, Place::at(g.span_open()));
                    }
                    if depth < DEEPEST {
                        self.take(&g.stream().into_iter().collect::<Vec<_>>(), depth + 1);
                    }
                    if !close.is_empty() {
                        self.put(TokenKind::Mark, close, Place::at(g.span_close()));
                    }
                }
            }
        }
    }

    /// A number that went through a macro may bring its sign along.
    fn literal(&mut self, text: &str, place: Place) {
        let digits = text.strip_prefix('-').unwrap_or(text);
        if digits.len() < text.len() {
            self.put(TokenKind::Mark, "-", place);
        }
        let number = digits.starts_with(|c: char| c.is_ascii_digit());
        self.put(if number { TokenKind::Number } else { TokenKind::Other }, digits, place);
    }
}

/// The text of `#[doc = "..."]`.
fn doc_comment(g: &proc_macro2::Group) -> Option<String> {
    let inner: Vec<TokenTree> = g.stream().into_iter().collect();
    match inner.as_slice() {
        [TokenTree::Ident(doc), TokenTree::Punct(_), TokenTree::Literal(text)]
            if g.delimiter() == Delimiter::Bracket && doc == "doc" =>
        {
            let text: syn::LitStr = syn::parse2(TokenTree::Literal(text.clone()).into()).ok()?;
            Some(text.value().trim().to_string())
        }
        _ => None,
    }
}
