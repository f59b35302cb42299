//! Errors with their places in the input, reported to rustc as `compile_error!` or drawn for a terminal.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use std::fmt::Write;

/// More errors than this are counted, not told: a reader works from the top.
const MOST: usize = 60;

/// A stretch of the input, from the start of one token to the end of another.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    first: Span,
    last: Span,
}

impl Place {
    /// The place of one span.
    pub fn at(span: Span) -> Place {
        Place { first: span, last: span }
    }

    /// The whole macro call: the place of what was never written.
    pub fn call_site() -> Place {
        Place::at(Span::call_site())
    }

    /// The place of one token, a group with its delimiters.
    pub fn of(token: &TokenTree) -> Place {
        match token {
            TokenTree::Group(g) if g.delimiter() != Delimiter::None => {
                Place { first: g.span_open(), last: g.span_close() }
            }
            // An invisible group has no delimiters to point at.
            TokenTree::Group(g) => {
                let tokens: Vec<TokenTree> = g.stream().into_iter().collect();
                match (tokens.first(), tokens.last()) {
                    (Some(TokenTree::Group(_)), _) | (_, Some(TokenTree::Group(_))) | (None, _) | (_, None) => {
                        Place::at(g.span())
                    }
                    (Some(a), Some(b)) => Place { first: a.span(), last: b.span() },
                }
            }
            other => Place::at(other.span()),
        }
    }

    /// From the first token to the last; `None` for no tokens.
    pub fn of_all(tokens: &[TokenTree]) -> Option<Place> {
        Some(Place::of(tokens.first()?).to(Place::of(tokens.last()?)))
    }

    /// From the start of this place to the end of the other.
    #[must_use]
    pub fn to(self, end: Place) -> Place {
        Place { first: self.first, last: end.last }
    }

    /// Line of the first character, from 1. 0 where the compiler does not tell.
    pub fn line(self) -> usize {
        self.first.start().line
    }

    /// Line of the last character, from 1.
    pub fn last_line(self) -> usize {
        self.last.end().line
    }

    /// (line from 1, column from 0) of the first character.
    pub fn start(self) -> (usize, usize) {
        let at = self.first.start();
        (at.line, at.column)
    }

    /// (line from 1, column from 0) after the last character.
    pub fn end(self) -> (usize, usize) {
        let at = self.last.end();
        (at.line, at.column)
    }

    /// What is to be underlined of a text: line from 1, column from 0, number of characters; of a place over several lines the first.
    /// `None` where the place is none of the text's.
    pub fn on_first_line(self, source: &str) -> Option<(usize, usize, usize)> {
        let ((line, column), (last_line, last_column)) = (self.start(), self.end());
        let length = source.lines().nth(line.checked_sub(1)?)?.chars().count();
        let column = column.min(length);
        let end = if last_line == line { last_column.min(length) } else { length };
        Some((line, column, end.saturating_sub(column).max(1)))
    }

    /// The span of the first token.
    pub fn first_span(self) -> Span {
        self.first
    }
}

/// One thing that is wrong.
#[derive(Clone, Debug)]
pub struct Error {
    /// Where.
    pub place: Place,
    /// What, in one sentence.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
    /// A second place that belongs to it, and what is there.
    pub related: Option<(Place, String)>,
}

impl Error {
    /// An error with a message only.
    pub fn new(place: Place, message: impl Into<String>) -> Error {
        Error { place, message: message.into(), help: None, related: None }
    }

    /// Adds what to write instead.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Error {
        self.help = Some(text.into());
        self
    }

    /// Adds a second place.
    #[must_use]
    pub fn related(mut self, place: Place, text: impl Into<String>) -> Error {
        self.related = Some((place, text.into()));
        self
    }

    /// Message, help and the line of the second place: all that `compile_error!` can say.
    fn text(&self) -> String {
        let mut text = self.message.clone();
        if let Some((place, what)) = &self.related {
            let _ = match place.line() {
                0 => write!(text, "\nnote: {what}"),
                line => write!(text, "\nnote: {what} (line {line})"),
            };
        }
        if let Some(help) = &self.help {
            let _ = write!(text, "\nhelp: {help}");
        }
        text
    }

    fn to_tokens(&self, out: &mut Vec<TokenTree>) {
        let (first, last) = (self.place.first, self.place.last);
        let colon = |spacing| {
            let mut p = Punct::new(':', spacing);
            p.set_span(first);
            TokenTree::Punct(p)
        };
        // rustc underlines from the first token of the macro call to its last one.
        let mut text = Literal::string(&self.text());
        text.set_span(last);
        let mut group = Group::new(Delimiter::Brace, TokenTree::Literal(text).into());
        group.set_span(last);
        let mut bang = Punct::new('!', Spacing::Alone);
        bang.set_span(first);
        out.extend([
            colon(Spacing::Joint),
            colon(Spacing::Alone),
            TokenTree::Ident(Ident::new("core", first)),
            colon(Spacing::Joint),
            colon(Spacing::Alone),
            TokenTree::Ident(Ident::new("compile_error", first)),
            TokenTree::Punct(bang),
            TokenTree::Group(group),
        ]);
    }
}

/// All errors of one input.
#[derive(Clone, Debug, Default)]
#[must_use]
pub struct Errors {
    list: Vec<Error>,
    untold: usize,
}

impl From<Error> for Errors {
    fn from(error: Error) -> Errors {
        Errors { list: vec![error], untold: 0 }
    }
}

impl Errors {
    /// No errors yet.
    pub fn new() -> Errors {
        Errors::default()
    }

    /// Adds one.
    pub fn push(&mut self, error: Error) {
        if self.list.len() < MOST {
            self.list.push(error);
        } else {
            self.untold += 1;
        }
    }

    /// Keeps the value, or notes the error.
    pub fn take<T>(&mut self, result: Result<T, Error>) -> Option<T> {
        result.map_err(|e| self.push(e)).ok()
    }

    /// Adds all of another list.
    pub fn extend(&mut self, other: Errors) {
        self.untold += other.untold;
        for e in other.list {
            self.push(e);
        }
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Number of errors.
    pub fn len(&self) -> usize {
        self.list.len() + self.untold
    }

    /// The errors in the order of the input.
    pub fn in_order(&self) -> Vec<&Error> {
        let mut list: Vec<(&Error, (usize, usize))> = self.list.iter().map(|e| (e, e.place.start())).collect();
        list.sort_by_key(|(_, at)| *at);
        list.into_iter().map(|(e, _)| e).collect()
    }

    /// `compile_error!` items, one per error, each underlining its place.
    pub fn to_compile_errors(&self) -> TokenStream {
        let mut out = Vec::new();
        for e in self.in_order() {
            e.to_tokens(&mut out);
        }
        if self.untold > 0 {
            Error::new(Place::call_site(), format!("and {} more errors", self.untold)).to_tokens(&mut out);
        }
        out.into_iter().collect()
    }

    /// The errors as a terminal shows them: `file:line:column`, the line, carets below. `source` is the text the tokens
    /// were read from.
    pub fn draw(&self, source: &str, file: &str) -> String {
        let mut out = String::new();
        for e in self.in_order() {
            let _ = writeln!(out, "error: {}", e.message);
            picture(&mut out, source, file, e.place, '^');
            if let Some((place, what)) = &e.related {
                let _ = writeln!(out, "note: {what}");
                picture(&mut out, source, file, *place, '-');
            }
            if let Some(help) = &e.help {
                let _ = writeln!(out, "help: {help}");
            }
            out.push('\n');
        }
        match self.len() {
            0 => {}
            1 => out.push_str("1 error\n"),
            n => {
                let _ = writeln!(out, "{n} errors");
            }
        }
        out
    }
}

/// The line of a place with the place underlined; of a place over several lines the first.
fn picture(out: &mut String, source: &str, file: &str, place: Place, mark: char) {
    let Some((line, column, length)) = place.on_first_line(source) else {
        let _ = writeln!(out, " --> {file}");
        return;
    };
    let text = source.lines().nth(line - 1).unwrap_or_default();
    let number = line.to_string();
    let margin = " ".repeat(number.len());
    // Tabs stay tabs, so that the carets stand below what they mean.
    let indent: String = text.chars().take(column).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    let marks = mark.to_string().repeat(length);
    let more = if place.last_line() > line { "..." } else { "" };
    let _ = writeln!(out, "{margin}--> {file}:{line}:{}", column + 1);
    let _ = writeln!(out, "{margin} |\n{number} | {text}\n{margin} | {indent}{marks}{more}");
}

/// The rows of a table as data sheets print them, with characters that Rust has in place of those that it has not, one for one, so that
/// places stay: a degree sign, TeX's backslash, minus signs and dots of typesetting.
fn pasted(source: &str) -> String {
    let row = |line: &str| line.trim_start().starts_with('|');
    let letter = |c: char| match c {
        '°' => 'º',
        '\\' => ' ',
        '−' | '–' => '-',
        '×' | '·' | '⋅' => '*',
        other => other,
    };
    let line = |l: &str| if row(l) { l.chars().map(letter).collect() } else { l.to_string() };
    source.split_inclusive('\n').map(line).collect()
}

/// Reads source text into tokens. The error says where the text is no Rust token.
pub fn lex(source: &str) -> Result<TokenStream, Errors> {
    pasted(source).parse::<TokenStream>().map_err(|e| {
        let place = Place::at(e.span());
        let (line, column) = place.start();
        let culprit = line.checked_sub(1).and_then(|i| source.lines().nth(i)).and_then(|l| l.chars().nth(column));
        let error = match culprit {
            Some('°') => Error::new(place, "`°` is no unit here").help("write `90deg`"),
            Some(c @ ('−' | '–')) => Error::new(place, format!("`{c}` is no minus sign")).help("write `-`"),
            Some('×' | '·' | '⋅') => Error::new(place, "a product is written with `*`"),
            Some('(' | '[' | '{' | ')' | ']' | '}') => Error::new(place, "this bracket has no partner"),
            Some(c) => Error::new(place, format!("the text cannot be read from here (`{}`)", c.escape_debug())),
            None => Error::new(place, "the text cannot be read from here"),
        };
        let mut errors = Errors::new();
        errors.push(error);
        errors
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_the_line_and_both_places() {
        let source = "one two\n\tthree four\n";
        let tokens: Vec<TokenTree> = lex(source).expect("words").into_iter().collect();
        let mut errors = Errors::new();
        errors.push(
            Error::new(Place::of(&tokens[3]), "no fours").help("write `4`").related(Place::of(&tokens[0]), "but ones"),
        );
        errors.push(Error::new(Place::of_all(&tokens[1..3]).expect("two tokens"), "across"));
        let want = "error: across\n --> f.dh:1:5\n  |\n1 | one two\n  |     ^^^...\n\n\
                    error: no fours\n --> f.dh:2:8\n  |\n2 | \tthree four\n  | \t      ^^^^\n\
                    note: but ones\n --> f.dh:1:1\n  |\n1 | one two\n  | ---\nhelp: write `4`\n\n2 errors\n";
        assert_eq!(errors.draw(source, "f.dh"), want);
    }

    #[test]
    fn compile_errors_hold_the_whole_text() {
        let mut errors = Errors::new();
        errors.push(Error::new(Place::call_site(), "what").help("this"));
        assert_eq!(errors.to_compile_errors().to_string(), ":: core :: compile_error ! { \"what\\nhelp: this\" }");
    }

    #[test]
    fn text_that_is_no_token_is_an_error() {
        let drawn = lex("a = 90°;").expect_err("no token").draw("a = 90°;", "-");
        assert!(drawn.contains("-:1:7") && drawn.contains("90deg"), "{drawn}");
        assert_eq!(
            lex(r"| $\alpha_{i-1}$ | 90° − 1 |").expect("a row").to_string(),
            "| $ alpha_ { i - 1 } $ | 90º - 1 |"
        );
        assert!(lex("( ").is_err() && lex(")").is_err() && lex("\"").is_err());
    }
}
