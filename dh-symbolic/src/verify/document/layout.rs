//! The layout of a printed formula: letters with their indices, signs, fractions, matrices. No meaning yet.

/// A piece of a formula with its indices.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item {
    pub(super) kind: ItemKind,
    pub(super) sub: Option<Vec<Item>>,
    pub(super) sup: Option<Vec<Item>>,
    pub(super) before_sub: Option<Vec<Item>>,
    pub(super) before_sup: Option<Vec<Item>>,
    pub(super) primes: usize,
    /// Room before it.
    pub(super) spaced: bool,
    pub(super) line: usize,
}

/// What a piece is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ItemKind {
    Number(String),
    /// A letter, the name of a Greek letter, a word.
    Name(String),
    /// `+ - * / , ; . :` and brackets.
    Mark(char),
    /// In the notation of claims.
    Relation(&'static str),
    Group(Vec<Item>),
    Fraction(Vec<Item>, Vec<Item>),
    Root(Vec<Item>),
    Matrix(Vec<Vec<Vec<Item>>>),
    /// Words between formulas.
    Text(String),
    Degree,
    PlusMinus,
    MinusPlus,
    /// Rows of `\begin{cases}` after an equals sign: cells of each.
    Cases(Vec<Vec<Vec<Item>>>),
    /// A letter with a dot: a velocity.
    Dotted(Vec<Item>),
    Dots,
    /// Much room between formulas.
    Gap,
    /// The next row of aligned formulas or of a matrix.
    Break,
    /// The next column.
    Tab,
    /// Nothing, to carry indices that stand before a letter.
    Empty,
}

impl Item {
    pub(super) fn new(kind: ItemKind, line: usize, spaced: bool) -> Item {
        Item { kind, sub: None, sup: None, before_sub: None, before_sup: None, primes: 0, spaced, line }
    }

    pub(super) fn is(&self, mark: char) -> bool {
        self.kind == ItemKind::Mark(mark)
    }

    pub(super) fn name(&self) -> Option<&str> {
        match &self.kind {
            ItemKind::Name(n) => Some(n),
            _ => None,
        }
    }

    pub(super) fn is_bare(&self) -> bool {
        self.sub.is_none() && self.sup.is_none() && self.before_sub.is_none() && self.before_sup.is_none()
    }

    /// May indices follow?
    pub(super) fn carries(&self) -> bool {
        match &self.kind {
            ItemKind::Mark(c) => matches!(c, ')' | ']' | '}' | '|'),
            ItemKind::Relation(_)
            | ItemKind::Text(_)
            | ItemKind::Gap
            | ItemKind::Break
            | ItemKind::Tab
            | ItemKind::PlusMinus
            | ItemKind::MinusPlus => false,
            _ => true,
        }
    }
}

/// Rows and cells of a matrix.
pub(super) fn rows(inner: Vec<Item>) -> Vec<Vec<Vec<Item>>> {
    let mut rows: Vec<Vec<Vec<Item>>> = vec![vec![Vec::new()]];
    for item in inner {
        match item.kind {
            ItemKind::Break => rows.push(vec![Vec::new()]),
            ItemKind::Tab => {
                if let Some(row) = rows.last_mut() {
                    row.push(Vec::new());
                }
            }
            _ => {
                if let Some(cell) = rows.last_mut().and_then(|r| r.last_mut()) {
                    cell.push(item);
                }
            }
        }
    }
    rows.retain(|r| r.len() > 1 || r.iter().any(|c| !c.is_empty()));
    rows
}
