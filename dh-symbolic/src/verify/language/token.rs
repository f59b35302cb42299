//! The tokens of a derivation, and their text.

/// One word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// As written; for a note the text of the comment.
    pub text: String,
}

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// An identifier.
    Name,
    /// A number with its unit.
    Number,
    /// One character of punctuation, or a bracket.
    Mark,
    /// A doc comment.
    Note,
    /// Something that has no place in a derivation.
    Other,
}

impl Token {
    /// A word, classified by its first character. For tests and for replacing words.
    pub fn new(text: &str) -> Token {
        let first = text.chars().next().unwrap_or(' ');
        let kind = if first.is_ascii_digit() {
            TokenKind::Number
        } else if first.is_alphabetic() || first == '_' {
            TokenKind::Name
        } else {
            TokenKind::Mark
        };
        Token { kind, text: text.to_string() }
    }

    /// Is it this mark?
    pub fn is(&self, mark: &str) -> bool {
        self.kind == TokenKind::Mark && self.text == mark
    }
}

/// The words as one line with the usual spaces, and the column (in characters, from 0) where each word begins.
pub fn line_text(tokens: &[Token]) -> (String, Vec<usize>) {
    let mut line = String::new();
    let mut columns = Vec::with_capacity(tokens.len());
    let mut depth = 0usize;
    // True where a value ends: then `-` is a subtraction and not a sign.
    let mut after_value = false;
    let mut glue = true;
    for (i, t) in tokens.iter().enumerate() {
        let mark = if t.kind == TokenKind::Mark { t.text.as_str() } else { "" };
        let next_is_equal = tokens.get(i + 1).is_some_and(|n| n.is("="));
        let (before, after) = match mark {
            "(" | "[" => (!after_value, false),
            ")" | "]" => (false, true),
            "," => (false, !is_frame_comma(tokens, i)),
            ";" | ":" => (false, true),
            "." | "^" | "*" | "/" => (false, false),
            "+" | "-" if !after_value => (true, false),
            "+" | "-" if is_joint_sign(tokens, i) => (false, false),
            // `!=`, `<=` are two marks; named arguments have no spaces
            "!" | "<" | ">" if next_is_equal => (true, false),
            "=" if !glue && depth == 0 && line.ends_with(['!', '<', '>']) => (false, true),
            _ => (true, true),
        };
        if before && !glue {
            line.push(' ');
        }
        columns.push(line.chars().count());
        line.push_str(&t.text);
        glue = !after;
        depth = match mark {
            "(" | "[" => depth + 1,
            ")" | "]" => depth.saturating_sub(1),
            _ => depth,
        };
        after_value = matches!(t.kind, TokenKind::Name | TokenKind::Number) && t.text != "at" && t.text != "within"
            || matches!(mark, ")" | "]");
    }
    (line, columns)
}

/// The comma of `T(0,6)`.
fn is_frame_comma(tokens: &[Token], i: usize) -> bool {
    let Some([name, open, from, _, to, close]) = i.checked_sub(3).and_then(|k| tokens.get(k..k + 6)) else {
        return false;
    };
    let numbers = from.kind == TokenKind::Number && to.kind == TokenKind::Number;
    name.kind == TokenKind::Name && open.is("(") && numbers && close.is(")")
}

/// The sign of `c(2-3)`.
fn is_joint_sign(tokens: &[Token], i: usize) -> bool {
    let mut before = tokens.get(..i).unwrap_or_default();
    while let [rest @ .., last] = before {
        if last.is("(") {
            return rest.last().is_some_and(|t| t.kind == TokenKind::Name && (t.text == "c" || t.text == "s"));
        }
        if !(last.kind == TokenKind::Number || last.is("-") || last.is("+")) {
            return false;
        }
        before = rest;
    }
    false
}
