//! Tokens as text, spaced as in a table: `q2 - 90deg`, `-160deg..=160deg`.

use proc_macro2::{Delimiter, TokenTree};

/// Longest text; the rest becomes an ellipsis.
const LONGEST: usize = 200;
const DEEPEST: usize = 16;

/// The text of some tokens.
pub(super) fn of(tokens: &[TokenTree]) -> String {
    let mut out = String::new();
    write(tokens, &mut out, DEEPEST);
    out
}

/// What stands around a group.
pub(crate) fn brackets(delimiter: Delimiter) -> (&'static str, &'static str) {
    match delimiter {
        Delimiter::Parenthesis => ("(", ")"),
        Delimiter::Bracket => ("[", "]"),
        Delimiter::Brace => ("{", "}"),
        Delimiter::None => ("", ""),
    }
}

fn write(tokens: &[TokenTree], out: &mut String, depth: usize) {
    // What stands before: nothing or an operator makes the next minus a sign.
    let mut operand = false;
    for token in tokens {
        if out.len() > LONGEST || depth == 0 {
            out.push_str("...");
            return;
        }
        match token {
            TokenTree::Punct(p) => {
                let c = p.as_char();
                match c {
                    '+' | '-' if operand => {
                        out.extend([' ', c, ' ']);
                    }
                    '|' => out.push_str("\\|"),
                    _ => out.push(c),
                }
                operand = false;
            }
            TokenTree::Group(g) => {
                let (open, close) = brackets(g.delimiter());
                out.push_str(open);
                write(&g.stream().into_iter().collect::<Vec<_>>(), out, depth - 1);
                out.push_str(close);
                operand = true;
            }
            other => {
                if operand {
                    out.push(' ');
                }
                out.push_str(&other.to_string());
                operand = true;
            }
        }
    }
}
