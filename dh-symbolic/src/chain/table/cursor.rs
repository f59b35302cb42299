//! Reading a list of tokens from left to right.

use crate::diagnostic::Place;
use proc_macro2::{Delimiter, Group, Ident, TokenTree};

/// A position in a list of tokens.
pub(super) struct Cursor<'a> {
    tokens: &'a [TokenTree],
    at: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(tokens: &'a [TokenTree]) -> Cursor<'a> {
        Cursor { tokens, at: 0 }
    }

    pub(super) fn peek(&self) -> Option<&'a TokenTree> {
        self.look(0)
    }

    /// The token `n` further on.
    pub(super) fn look(&self, n: usize) -> Option<&'a TokenTree> {
        self.tokens.get(self.at.saturating_add(n))
    }

    pub(super) fn next(&mut self) -> Option<&'a TokenTree> {
        let token = self.peek()?;
        self.at += 1;
        Some(token)
    }

    /// Whether the token `n` further on is this character.
    pub(super) fn is_punct(&self, n: usize, c: char) -> bool {
        matches!(self.look(n), Some(TokenTree::Punct(p)) if p.as_char() == c)
    }

    /// Whether the token `n` further on is this word.
    pub(super) fn is_word(&self, n: usize, word: &str) -> bool {
        matches!(self.look(n), Some(TokenTree::Ident(i)) if i == word)
    }

    /// Whether a line of the table's text (a setting, `let`, `struct`, `prove`, an attribute) starts here. Nothing inside of cells looks like this.
    pub(super) fn starts_line(&self) -> bool {
        let next_is = |wanted| matches!(self.look(1), Some(TokenTree::Group(g)) if g.delimiter() == wanted);
        match self.peek() {
            Some(TokenTree::Ident(_)) => {
                let word = |w| self.is_word(0, w);
                let setting = self.is_punct(1, '=');
                word("let") || word("struct") || word("pub") || setting || (word("prove") && next_is(Delimiter::Brace))
            }
            Some(TokenTree::Punct(p)) if p.as_char() == '#' => next_is(Delimiter::Bracket),
            _ => false,
        }
    }

    /// Takes this character, if it is next.
    pub(super) fn eat_punct(&mut self, c: char) -> Option<Place> {
        let place = self.peek().filter(|_| self.is_punct(0, c)).map(Place::of)?;
        self.at += 1;
        Some(place)
    }

    /// Takes a name, if one is next.
    pub(super) fn eat_ident(&mut self) -> Option<&'a Ident> {
        match self.peek() {
            Some(TokenTree::Ident(i)) => {
                self.at += 1;
                Some(i)
            }
            _ => None,
        }
    }

    /// Takes a group with these delimiters, if one is next.
    pub(super) fn eat_group(&mut self, delimiter: Delimiter) -> Option<&'a Group> {
        match self.peek() {
            Some(TokenTree::Group(g)) if g.delimiter() == delimiter => {
                self.at += 1;
                Some(g)
            }
            _ => None,
        }
    }

    /// Takes tokens as long as the test holds for the cursor that stands before them.
    pub(super) fn take_while(&mut self, test: impl Fn(&Cursor<'a>) -> bool) -> &'a [TokenTree] {
        let start = self.at;
        while self.at < self.tokens.len() && test(self) {
            self.at += 1;
        }
        self.tokens.get(start..self.at).unwrap_or(&[])
    }

    /// The place of the next token, or of the last one at the end.
    pub(super) fn place(&self) -> Place {
        match self.peek().or_else(|| self.tokens.last()) {
            Some(token) => Place::of(token),
            None => Place::call_site(),
        }
    }

    /// The place of the token before.
    pub(super) fn before(&self) -> Place {
        self.at.checked_sub(1).and_then(|i| self.tokens.get(i)).map_or_else(Place::call_site, Place::of)
    }
}

/// The tokens, out of the invisible group that a fragment of `macro_rules!` arrives in.
pub(super) fn unwrapped(tokens: impl IntoIterator<Item = TokenTree>) -> Vec<TokenTree> {
    let mut list: Vec<TokenTree> = tokens.into_iter().collect();
    // Each macro on the way may have added one.
    for _ in 0..8 {
        match list.as_slice() {
            [TokenTree::Group(g)] if g.delimiter() == Delimiter::None => list = g.stream().into_iter().collect(),
            _ => break,
        }
    }
    list
}
