//! Formulas of a Markdown note, read as trees: nothing here knows the product.

/// A formula.
#[derive(Clone, Debug)]
pub(crate) enum Formula {
    Number(f64),
    Name(String),
    /// Summands with their signs: `'+'`, `'-'`, or `'±'`.
    Sum(Vec<(char, Formula)>),
    Product(Vec<Formula>),
    Quotient(Box<Formula>, Box<Formula>),
    Root(Box<Formula>),
    Power(Box<Formula>, i32),
    Call(String, Vec<Formula>),
    Matrix(Vec<Vec<Formula>>),
}

#[derive(Clone, Debug, PartialEq)]
enum Token {
    Command(String),
    Char(char),
    Number(String),
}

fn tokens(text: &str) -> Vec<Token> {
    let mut out = Vec::new();
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        match c {
            '\\' => {
                let mut name = String::new();
                while let Some(c) = rest.peek().filter(|c| c.is_ascii_alphabetic()) {
                    name.push(*c);
                    rest.next();
                }
                if name.is_empty() {
                    name.extend(rest.next());
                }
                if !matches!(name.as_str(), "," | "left" | "right" | ";" | " " | "!") {
                    out.push(Token::Command(name));
                }
            }
            c if c.is_whitespace() || c == '&' => {}
            c if c.is_ascii_digit() => {
                let mut number = c.to_string();
                while let Some(c) = rest.peek().filter(|c| c.is_ascii_digit() || **c == '.') {
                    number.push(*c);
                    rest.next();
                }
                out.push(Token::Number(number));
            }
            c => out.push(Token::Char(c)),
        }
    }
    out
}

/// Greek letters that names of angles begin with.
const GREEK: [&str; 10] = ["theta", "alpha", "beta", "gamma", "phi", "varphi", "psi", "chi", "delta", "Delta"];

struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn is(&self, c: char) -> bool {
        self.peek() == Some(&Token::Char(c))
    }

    fn take(&mut self, c: char) -> bool {
        let hit = self.is(c);
        self.at += usize::from(hit);
        hit
    }

    fn command(&self) -> Option<&str> {
        match self.peek() {
            Some(Token::Command(name)) => Some(name),
            _ => None,
        }
    }

    fn expect(&mut self, c: char) -> Option<()> {
        self.take(c).then_some(())
    }

    /// What stands in braces, or the next token.
    fn group(&mut self) -> Option<Vec<Token>> {
        if !self.take('{') {
            self.at += 1;
            return Some(vec![self.tokens.get(self.at - 1)?.clone()]);
        }
        let mut depth = 1;
        let start = self.at;
        while depth > 0 {
            match self.tokens.get(self.at)? {
                Token::Char('{') => depth += 1,
                Token::Char('}') => depth -= 1,
                _ => {}
            }
            self.at += 1;
        }
        Some(self.tokens[start..self.at - 1].to_vec())
    }

    fn sum(&mut self) -> Option<Formula> {
        let mut list = Vec::new();
        let mut sign = '+';
        if self.take('-') {
            sign = '-';
        } else if self.command() == Some("pm") {
            self.at += 1;
            sign = '±';
        }
        loop {
            list.push((sign, self.product()?));
            if self.take('+') {
                sign = '+';
            } else if self.take('-') {
                sign = '-';
            } else if self.command() == Some("pm") {
                self.at += 1;
                sign = '±';
            } else {
                return Some(Formula::Sum(list));
            }
        }
    }

    fn product(&mut self) -> Option<Formula> {
        let mut list = vec![self.factor()?];
        loop {
            match self.peek() {
                Some(Token::Number(_)) => {}
                Some(Token::Char(c)) if c.is_alphabetic() || "([{".contains(*c) => {}
                Some(Token::Command(c)) if c == "cdot" => self.at += 1,
                Some(Token::Command(c)) if !matches!(c.as_str(), "pm" | "qquad" | "end" | "\\" | "}") => {}
                _ => return Some(Formula::Product(list)),
            }
            list.push(self.factor()?);
        }
    }

    fn factor(&mut self) -> Option<Formula> {
        let base = self.bare()?;
        self.powers(base)
    }

    fn powers(&mut self, base: Formula) -> Option<Formula> {
        if !self.take('^') {
            return Some(base);
        }
        let exponent = self.group()?;
        match exponent.as_slice() {
            [Token::Command(c)] if c == "circ" => {
                Some(Formula::Product(vec![base, Formula::Number(1f64.to_radians())]))
            }
            [Token::Number(n)] => Some(Formula::Power(Box::new(base), n.parse().ok()?)),
            [Token::Char('-'), Token::Number(n)] => Some(Formula::Power(Box::new(base), -n.parse::<i32>().ok()?)),
            _ => None,
        }
    }

    fn inside(tokens: &[Token]) -> Option<Formula> {
        let mut r = Reader { tokens, at: 0 };
        let out = r.sum()?;
        (r.at == tokens.len()).then_some(out)
    }

    fn arguments(&mut self) -> Option<Vec<Formula>> {
        self.expect('(')?;
        let mut list = vec![self.sum()?];
        while self.take(',') {
            list.push(self.sum()?);
        }
        self.expect(')')?;
        Some(list)
    }

    fn bare(&mut self) -> Option<Formula> {
        match self.peek()?.clone() {
            Token::Number(n) => {
                self.at += 1;
                Some(Formula::Number(n.parse().ok()?))
            }
            Token::Char(open @ ('(' | '[')) => {
                self.at += 1;
                let out = self.sum()?;
                self.expect(if open == '(' { ')' } else { ']' })?;
                Some(out)
            }
            Token::Command(c) if c == "{" => {
                self.at += 1;
                let out = self.sum()?;
                (self.command() == Some("}")).then(|| self.at += 1)?;
                Some(out)
            }
            Token::Char('{') => {
                let inner = self.group()?;
                if inner.is_empty() { self.name(true) } else { Reader::inside(&inner) }
            }
            Token::Command(c) => match c.as_str() {
                "dfrac" | "frac" | "tfrac" => {
                    self.at += 1;
                    let (a, b) = (self.group()?, self.group()?);
                    Some(Formula::Quotient(Box::new(Reader::inside(&a)?), Box::new(Reader::inside(&b)?)))
                }
                "sqrt" => {
                    self.at += 1;
                    let inner = self.group()?;
                    Some(Formula::Root(Box::new(Reader::inside(&inner)?)))
                }
                "operatorname" => {
                    self.at += 1;
                    let name = text(&self.group()?);
                    Some(Formula::Call(name, self.arguments()?))
                }
                "cos" | "sin" | "tan" => {
                    self.at += 1;
                    let list = if self.is('(') { self.arguments()? } else { vec![self.factor()?] };
                    Some(Formula::Call(c, list))
                }
                "pi" => {
                    self.at += 1;
                    Some(Formula::Number(std::f64::consts::PI))
                }
                "begin" => None,
                _ => self.name(false),
            },
            // c theta, s alpha: cosine and sine of an angle
            Token::Char(c @ ('c' | 's')) => {
                let next = self.tokens.get(self.at + 1);
                if matches!(next, Some(Token::Command(g)) if GREEK.contains(&g.as_str())) {
                    self.at += 1;
                    let angle = self.name(false)?;
                    let name = if c == 'c' { "cos" } else { "sin" };
                    return Some(Formula::Call(name.into(), vec![angle]));
                }
                self.name(false)
            }
            Token::Char(c) if c.is_alphabetic() => self.name(false),
            _ => None,
        }
    }

    /// A letter with its indices; `before`: `{}` with indices stands before it.
    fn name(&mut self, before: bool) -> Option<Formula> {
        let (mut from, mut to) = (None, None);
        while before && (self.is('^') || self.is('_')) {
            let up = self.take('^') || !self.take('_');
            let index = text(&self.group()?);
            if up { from = Some(index) } else { to = Some(index) }
        }
        let base = match self.peek()?.clone() {
            Token::Char(c) => c.to_string(),
            Token::Command(c) if c == "mathrm" => {
                self.at += 1;
                let word = text(&self.group()?);
                self.at -= 1;
                word
            }
            Token::Command(c) => c,
            Token::Number(_) => return None,
        };
        self.at += 1;
        let mut name = base;
        if self.take('_') {
            name = format!("{name}_{}", text(&self.group()?));
        }
        // primes are part of the name, numbers are powers
        let saved = self.at;
        if self.take('^') {
            let index = text(&self.group()?);
            if !index.is_empty() && index.chars().all(|c| c == '\'') {
                name.push_str(&index);
            } else {
                self.at = saved;
            }
        }
        if matches!(name.as_str(), "R_x" | "R_y" | "R_z" | "D_x" | "D_y" | "D_z") && self.is('(') {
            return Some(Formula::Call(name, self.arguments()?));
        }
        if from.is_some() || to.is_some() {
            name = format!("{name}[{},{}]", from.unwrap_or_default(), to.unwrap_or_default());
        }
        self.powers(Formula::Name(name))
    }
}

/// Letters and digits of an index, primes as `'`.
fn text(tokens: &[Token]) -> String {
    tokens
        .iter()
        .map(|t| match t {
            Token::Command(c) if c == "prime" => "'".to_string(),
            Token::Command(c) => c.clone(),
            Token::Char('^' | '{' | '}' | '_') => String::new(),
            Token::Char(c) => c.to_string(),
            Token::Number(n) => n.clone(),
        })
        .collect()
}

/// Reads one formula; `None` where it is not one that a calculator takes.
pub(crate) fn read(source: &str) -> Option<Formula> {
    let source = source.trim();
    if let Some(inner) = source.strip_prefix("\\begin{bmatrix}").and_then(|s| s.strip_suffix("\\end{bmatrix}")) {
        let rows = inner.split("\\\\").map(|r| r.split('&').map(read).collect::<Option<Vec<_>>>());
        return Some(Formula::Matrix(rows.collect::<Option<_>>()?));
    }
    Reader::inside(&tokens(source))
}
