//! Recursive-descent parser for the lines of a derivation, with a depth limit.

use super::{
    AtValue, Branch, Expr, ExprKind, Line, NotUnderstood, Place, Quantity, Relation, Statement, Token, TokenKind,
};

/// Deepest nesting of brackets and signs.
const DEPTH: usize = 48;
/// Most words of a line.
const WORDS: usize = 20_000;
/// Greatest exponent: formulas of kinematics have small ones.
const EXPONENT: i32 = 16;

/// Most possibilities of one line.
const BRANCHES: usize = 16;

type Read<T> = Result<T, NotUnderstood>;

/// Reads all lines.
pub(super) fn lines(tokens: &[Token]) -> Vec<Line> {
    let mut out = Vec::new();
    let mut start = 0;
    let mut depth = 0usize;
    for i in 0..=tokens.len() {
        let t = tokens.get(i);
        match t {
            Some(t) if t.is("(") || t.is("[") || t.is("{") => depth += 1,
            Some(t) if t.is(")") || t.is("]") || t.is("}") => depth = depth.saturating_sub(1),
            Some(t) if t.is(";") && depth == 0 => {
                out.extend(line(tokens, start..i, true));
                start = i + 1;
            }
            None => out.extend(line(tokens, start..i, false)),
            _ => {}
        }
    }
    out
}

/// Reads one line; `None` where there is nothing.
fn line(tokens: &[Token], mut place: Place, ended: bool) -> Option<Line> {
    let mut notes: Vec<&str> = Vec::new();
    while let Some(t) = tokens.get(place.start).filter(|t| place.start < place.end && t.kind == TokenKind::Note) {
        notes.push(t.text.trim());
        place.start += 1;
    }
    let note = notes.join(" ");
    if place.is_empty() {
        if note.is_empty() && !ended {
            return None;
        }
        let why = if ended { "an empty line: a `;` too many?" } else { "a comment without a line after it" };
        let statement = Statement::Unreadable(NotUnderstood { place: place.clone(), why: why.into() });
        return Some(Line { place, note, statement });
    }
    if place.len() > WORDS {
        let why = format!("a line of {} words: more than {WORDS} are not read", place.len());
        let statement = Statement::Unreadable(NotUnderstood { place: place.start..place.start + 1, why });
        return Some(Line { place, note, statement });
    }
    let read = |below| {
        let mut p = Parser { tokens, at: place.start, end: place.end, depth: 0, below };
        p.statement().and_then(|s| p.finished().map(|()| s))
    };
    let signed = tokens.get(place.clone()).unwrap_or_default().iter().any(|t| t.is("±") || t.is("∓"));
    let statement = if signed { both_signs(read(false), read(true)) } else { read(false) };
    let statement = statement.unwrap_or_else(Statement::Unreadable);
    Some(Line { place, note, statement })
}

/// The line with the upper signs or with the lower ones.
fn both_signs(upper: Read<Statement>, lower: Read<Statement>) -> Read<Statement> {
    let branches = |s: Statement| match s {
        Statement::Claim { first, rest, within: None } => {
            let place = first.place.start..rest.last().map_or(first.place.end, |r| r.1.place.end);
            Some(vec![Branch { place, first, rest, guard: None }])
        }
        Statement::Either(branches) => Some(branches),
        _ => None,
    };
    let (upper, lower) = (upper?, lower?);
    match (branches(upper.clone()), branches(lower)) {
        (Some(a), Some(b)) => Ok(Statement::Either([a, b].concat())),
        _ => Ok(upper),
    }
}

/// Reads one formula that fills the tokens.
pub(super) fn formula(tokens: &[Token]) -> Read<Expr> {
    let mut p = Parser { tokens, at: 0, end: tokens.len(), depth: 0, below: false };
    let e = p.sum()?;
    p.finished()?;
    Ok(e)
}

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    end: usize,
    depth: usize,
    /// Are the lower signs of ± and ∓ read?
    below: bool,
}

impl<'a> Parser<'a> {
    fn peek(&self) -> Option<&'a Token> {
        if self.at < self.end { self.tokens.get(self.at) } else { None }
    }

    fn peek_is(&self, mark: &str) -> bool {
        self.peek().is_some_and(|t| t.is(mark))
    }

    /// A sign here: is it a minus?
    fn sign(&self) -> Option<bool> {
        let t = self.peek()?;
        Some(match t.text.as_str() {
            "+" => false,
            "-" => true,
            "±" => self.below,
            "∓" => !self.below,
            _ => return None,
        })
    }

    fn ahead_is(&self, steps: usize, mark: &str) -> bool {
        self.at + steps < self.end && self.tokens.get(self.at + steps).is_some_and(|t| t.is(mark))
    }

    fn take(&mut self, mark: &str) -> bool {
        let hit = self.peek_is(mark);
        self.at += usize::from(hit);
        hit
    }

    fn take_word(&mut self, word: &str) -> bool {
        let hit = self.peek().is_some_and(|t| t.kind == TokenKind::Name && t.text == word);
        self.at += usize::from(hit);
        hit
    }

    fn fail<T>(&self, why: impl Into<String>) -> Read<T> {
        let end = if self.at < self.end { self.at + 1 } else { self.at };
        Err(NotUnderstood { place: self.at..end, why: why.into() })
    }

    fn expect(&mut self, mark: &str, context: &str) -> Read<()> {
        if self.take(mark) { Ok(()) } else { self.fail(format!("expected `{mark}` {context}, found {}", self.found())) }
    }

    fn found(&self) -> String {
        self.peek().map_or_else(|| "the end of the line".into(), |t| format!("`{}`", t.text))
    }

    fn finished(&self) -> Read<()> {
        if self.at >= self.end {
            return Ok(());
        }
        let missing_product = self.at > 0
            && self.peek().is_some_and(|t| matches!(t.kind, TokenKind::Name | TokenKind::Number) || t.is("("));
        if missing_product {
            return self.fail(format!("{} stands alone: write `*` for a product", self.found()));
        }
        self.fail(format!("{} does not belong here", self.found()))
    }

    fn name(&mut self, what: &str) -> Read<(String, Place)> {
        match self.peek() {
            Some(t) if t.kind == TokenKind::Name => {
                self.at += 1;
                Ok((t.text.clone(), self.at - 1..self.at))
            }
            _ => self.fail(format!("expected {what}, found {}", self.found())),
        }
    }

    fn statement(&mut self) -> Read<Statement> {
        // `let` and `at` are words of this notation only where a name follows them
        let name_follows =
            self.tokens.get(self.at + 1).is_some_and(|t| self.at + 1 < self.end && t.kind == TokenKind::Name);
        if self.take_word("let") {
            let (name, _) = self.name("a name")?;
            if self.take(":") {
                return Ok(Statement::Free(name, self.quantity()?));
            }
            self.expect("=", "after the name")?;
            return Ok(Statement::Define(name, self.sum()?));
        }
        if name_follows && self.take_word("at") {
            let mut settings = Vec::new();
            loop {
                let (name, place) = self.name("a variable")?;
                self.expect("=", "after the variable")?;
                let value = self.sum()?;
                let within = if self.take_word("within") { Some(self.sum()?) } else { None };
                settings.push(AtValue { name, place, value, within });
                if !self.take(",") || self.peek().is_none() {
                    return Ok(Statement::At(settings));
                }
            }
        }
        let start = self.at;
        let first = self.sum()?;
        if self.take(":") {
            return Ok(Statement::Kind(first, self.quantity()?));
        }
        let rest = self.relations()?;
        if rest.is_empty() {
            self.finished()?;
            return self.fail("a line says `left = right;` (or `~`, `!=`, `<`, `>`)");
        }
        let branching = self.peek().is_some_and(|t| t.kind == TokenKind::Name && (t.text == "or" || t.text == "if"));
        if !branching {
            let within = if self.take_word("within") { Some(self.sum()?) } else { None };
            return Ok(Statement::Claim { first, rest, within });
        }
        let mut branches = vec![self.branch(start, first, rest)?];
        while self.take_word("or") {
            let start = self.at;
            let first = self.sum()?;
            let rest = self.relations()?;
            branches.push(self.branch(start, first, rest)?);
            if branches.len() > BRANCHES {
                return self.fail(format!("more than {BRANCHES} possibilities"));
            }
        }
        Ok(Statement::Either(branches))
    }

    fn relations(&mut self) -> Read<Vec<(Relation, Expr)>> {
        let mut rest = Vec::new();
        while let Some(r) = self.relation() {
            rest.push((r, self.sum()?));
        }
        Ok(rest)
    }

    /// A possibility whose equation has been read: its condition.
    fn branch(&mut self, start: usize, first: Expr, rest: Vec<(Relation, Expr)>) -> Read<Branch> {
        if rest.is_empty() || rest.iter().any(|r| r.0 != Relation::Equal) {
            return self.fail("each possibility says `left = right`");
        }
        let place = start..self.at;
        let mut guard = None;
        if self.take_word("if") {
            let left = self.sum()?;
            let Some(relation) = self.relation() else { return self.fail("a condition says `left < right`") };
            guard = Some((left, relation, self.sum()?));
        }
        Ok(Branch { place, first, rest, guard })
    }

    fn quantity(&mut self) -> Read<Quantity> {
        if self.take_word("length") {
            Ok(Quantity::Length)
        } else if self.take_word("angle") {
            Ok(Quantity::Angle)
        } else {
            self.fail(format!("expected `length` or `angle`, found {}", self.found()))
        }
    }

    fn relation(&mut self) -> Option<Relation> {
        let second = self.ahead_is(1, "=");
        let (r, length) = match self.peek()?.text.as_str() {
            "=" => (Relation::Equal, if second { 2 } else { 1 }),
            "!" if second => (Relation::NotEqual, 2),
            "~" => (Relation::Near, 1),
            "<" if second => (Relation::LessOrEqual, 2),
            "<" => (Relation::Less, 1),
            ">" if second => (Relation::GreaterOrEqual, 2),
            ">" => (Relation::Greater, 1),
            _ => return None,
        };
        self.at += length;
        Some(r)
    }

    /// Enters a bracket or sign; the caller leaves by decrementing.
    fn enter(&mut self) -> Read<()> {
        self.depth += 1;
        if self.depth > DEPTH { self.fail(format!("nested more than {DEPTH} deep")) } else { Ok(()) }
    }

    fn sum(&mut self) -> Read<Expr> {
        let start = self.at;
        let mut terms = vec![(false, self.product()?)];
        while let Some(minus) = self.sign() {
            self.at += 1;
            terms.push((minus, self.product()?));
        }
        Ok(self.join(start, terms, ExprKind::Sum))
    }

    fn product(&mut self) -> Read<Expr> {
        let start = self.at;
        let mut factors = vec![(false, self.signed()?)];
        loop {
            let divided = self.peek_is("/");
            if !divided && !self.peek_is("*") {
                break;
            }
            self.at += 1;
            factors.push((divided, self.signed()?));
        }
        Ok(self.join(start, factors, ExprKind::Product))
    }

    fn join(&self, start: usize, mut parts: Vec<(bool, Expr)>, kind: impl Fn(Vec<(bool, Expr)>) -> ExprKind) -> Expr {
        match parts.pop() {
            Some((false, only)) if parts.is_empty() => only,
            last => {
                parts.extend(last);
                Expr { place: start..self.at, kind: kind(parts) }
            }
        }
    }

    fn signed(&mut self) -> Read<Expr> {
        let start = self.at;
        if let Some(minus) = self.sign() {
            self.at += 1;
            self.enter()?;
            let inner = self.signed()?;
            self.depth -= 1;
            let negative = |inner| Expr { place: start..self.at, kind: ExprKind::Negative(Box::new(inner)) };
            return Ok(if minus { negative(inner) } else { inner });
        }
        let base = self.postfix()?;
        if !self.take("^") {
            return Ok(base);
        }
        let minus = self.take("-");
        let exponent = self
            .peek()
            .filter(|t| t.kind == TokenKind::Number)
            .and_then(|t| t.text.parse::<i32>().ok())
            .filter(|n| *n <= EXPONENT);
        let Some(n) = exponent else {
            return self.fail(format!("an exponent is a whole number up to {EXPONENT}"));
        };
        self.at += 1;
        if self.peek_is("^") {
            return self.fail("a power of a power: use brackets");
        }
        Ok(Expr { place: start..self.at, kind: ExprKind::Power(Box::new(base), if minus { -n } else { n }) })
    }

    fn postfix(&mut self) -> Read<Expr> {
        let start = self.at;
        let mut e = self.primary()?;
        let mut fields = 0;
        while self.take(".") {
            let (name, _) = self.name("an entry such as `px` or `r11`")?;
            fields += 1;
            if fields > DEPTH {
                return self.fail("too many entries of entries");
            }
            e = Expr { place: start..self.at, kind: ExprKind::Field(Box::new(e), name) };
        }
        Ok(e)
    }

    fn primary(&mut self) -> Read<Expr> {
        let start = self.at;
        let Some(t) = self.peek() else { return self.fail("the formula ends too early") };
        self.at += 1;
        let kind = match (t.kind, t.text.as_str()) {
            (TokenKind::Number, _) => ExprKind::Number(t.text.clone()),
            (TokenKind::Name, _) if self.peek_is("(") => {
                self.at += 1;
                self.enter()?;
                let arguments = self.arguments()?;
                self.depth -= 1;
                ExprKind::Call(t.text.clone(), arguments)
            }
            (TokenKind::Name, _) => ExprKind::Name(t.text.clone()),
            (TokenKind::Mark, "(") => {
                self.enter()?;
                let inner = self.sum()?;
                self.expect(")", "to close the bracket")?;
                self.depth -= 1;
                return Ok(Expr { place: start..self.at, kind: inner.kind });
            }
            (TokenKind::Mark, "[") => {
                self.enter()?;
                let kind = self.matrix(start)?;
                self.depth -= 1;
                kind
            }
            _ => {
                self.at = start;
                return self.fail(format!("expected a number, a name or a bracket, found {}", self.found()));
            }
        };
        Ok(Expr { place: start..self.at, kind })
    }

    fn arguments(&mut self) -> Read<Vec<(Option<String>, Expr)>> {
        let mut out = Vec::new();
        while !self.take(")") {
            let labelled = self.peek().is_some_and(|t| t.kind == TokenKind::Name) && self.ahead_is(1, "=");
            let label = if labelled { Some(self.name("a variable")?.0) } else { None };
            self.at += usize::from(labelled);
            out.push((label, self.sum()?));
            if !self.take(",") && !self.peek_is(")") {
                return self.fail(format!("expected `,` or `)`, found {}", self.found()));
            }
        }
        Ok(out)
    }

    /// After `[`.
    fn matrix(&mut self, start: usize) -> Read<ExprKind> {
        let mut rows: Vec<Vec<Expr>> = vec![Vec::new()];
        while !self.take("]") {
            let e = self.sum()?;
            if let Some(row) = rows.last_mut() {
                row.push(e);
            }
            if self.take(";") {
                if !self.peek_is("]") {
                    rows.push(Vec::new());
                }
            } else if !self.take(",") && !self.peek_is("]") {
                return self.fail(format!("expected `,`, `;` or `]`, found {}", self.found()));
            }
        }
        let columns = rows.first().map_or(0, Vec::len);
        let uneven = rows.iter().position(|r| r.len() != columns);
        if let Some(i) = uneven {
            let count = rows.get(i).map_or(0, Vec::len);
            let why = format!("row {} of the matrix has {count} entries, row 1 has {columns}", i + 1);
            return Err(NotUnderstood { place: start..self.at, why });
        }
        if columns == 0 {
            return Err(NotUnderstood { place: start..self.at, why: "an empty matrix".into() });
        }
        Ok(ExprKind::Matrix(columns, rows.into_iter().flatten().collect()))
    }
}
