//! Typeset mathematics: rows of letters, signs and brackets, without meaning. What every printer prints.

/// A piece of typeset mathematics.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Math {
    /// Pieces side by side.
    Row(Vec<Math>),
    /// An italic letter, Latin or Greek.
    Letter(char),
    /// An upright word: `cos`, `tool`.
    Word(String),
    /// Digits.
    Number(String),
    /// A sign.
    Sign(Sign),
    /// An opening bracket.
    Open(char),
    /// A closing bracket.
    Close(char),
    /// A base with indices.
    Script(Box<Script>),
    /// Numerator and denominator.
    Fraction(Box<Math>, Box<Math>),
    /// A square root.
    Root(Box<Math>),
    /// A rate of change: a dot above.
    Dot(Box<Math>),
    /// A matrix, by rows.
    Matrix(Vec<Vec<Math>>),
}

/// Signs between and before pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Between summands.
    Plus,
    /// Between summands.
    Minus,
    /// Before a summand.
    Negative,
    /// Between sides.
    Equals,
    /// Product sign where juxtaposition would be misread.
    Times,
    /// Between arguments.
    Comma,
    /// At most, between sides.
    AtMost,
    /// The sign of degrees.
    Degree,
    /// Plus or minus, between summands.
    PlusMinus,
    /// Plus or minus, before a summand.
    Either,
    /// Follows from; leads to.
    Arrow,
    /// A prime, as an index.
    Prime,
    /// Between a function's name and an argument without brackets.
    Apply,
    /// Nothing but a little room.
    Thin,
    /// Much room.
    Wide,
    /// And so on: comma, three dots, comma.
    Dots,
}

/// A base with indices at its four corners.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Script {
    /// What carries the indices.
    pub base: Math,
    /// Below right.
    pub sub: Option<Math>,
    /// Above right.
    pub sup: Option<Math>,
    /// Below left.
    pub before_sub: Option<Math>,
    /// Above left.
    pub before_sup: Option<Math>,
}

impl Math {
    /// A number.
    pub fn number(n: impl ToString) -> Math {
        Math::Number(n.to_string())
    }

    /// An upright word.
    pub fn word(text: &str) -> Math {
        Math::Word(text.to_string())
    }

    /// A base with an index below.
    #[must_use]
    pub fn below(self, index: Math) -> Math {
        Math::Script(Box::new(match self {
            Math::Script(mut s) if s.sub.is_none() => {
                s.sub = Some(index);
                *s
            }
            base => Script { base, sub: Some(index), sup: None, before_sub: None, before_sup: None },
        }))
    }

    /// A base with an exponent; a base that has one goes into brackets.
    #[must_use]
    pub fn above(self, index: Math) -> Math {
        Math::Script(Box::new(match self {
            Math::Script(mut s) if s.sup.is_none() => {
                s.sup = Some(index);
                *s
            }
            Math::Script(s) => {
                let base = Math::Script(s).in_brackets();
                Script { base, sub: None, sup: Some(index), before_sub: None, before_sup: None }
            }
            base => Script { base, sub: None, sup: Some(index), before_sub: None, before_sup: None },
        }))
    }

    /// A base with an index before and above, as in the transform from a frame.
    #[must_use]
    pub fn before(self, index: Math) -> Math {
        Math::Script(Box::new(match self {
            Math::Script(mut s) if s.before_sup.is_none() => {
                s.before_sup = Some(index);
                *s
            }
            base => Script { base, sub: None, sup: None, before_sub: None, before_sup: Some(index) },
        }))
    }

    /// Its rate of change: a dot above, indices stay outside.
    #[must_use]
    pub fn dotted(self) -> Math {
        match self {
            Math::Script(mut s) => {
                s.base = Math::Dot(Box::new(s.base));
                Math::Script(s)
            }
            base => Math::Dot(Box::new(base)),
        }
    }

    /// Inside round brackets.
    #[must_use]
    pub fn in_brackets(self) -> Math {
        Math::Row(vec![Math::Open('('), self, Math::Close(')')])
    }

    /// Name of a function with its arguments.
    pub fn call(name: &str, arguments: Vec<Math>) -> Math {
        let mut row = vec![Math::word(name), Math::Open('(')];
        for (i, a) in arguments.into_iter().enumerate() {
            if i > 0 {
                row.push(Math::Sign(Sign::Comma));
            }
            row.push(a);
        }
        row.push(Math::Close(')'));
        Math::Row(row)
    }

    /// Pieces with commas between them.
    pub fn list(pieces: &[Math]) -> Math {
        let mut row = Vec::new();
        for (i, piece) in pieces.iter().enumerate() {
            if i > 0 {
                row.push(Math::Sign(Sign::Comma));
            }
            row.push(piece.clone());
        }
        if let [only] = pieces { only.clone() } else { Math::Row(row) }
    }

    /// `left = right`.
    pub fn equation(left: Math, right: Math) -> Math {
        Math::Row(vec![left, Math::Sign(Sign::Equals), right])
    }

    /// Number of glyphs as typeset: letters, digits, signs, brackets, fraction bars and root signs. Indices count, room does not.
    pub fn glyphs(&self) -> usize {
        match self {
            Math::Row(list) => list.iter().map(Math::glyphs).sum(),
            Math::Word(text) | Math::Number(text) => text.chars().count(),
            Math::Sign(Sign::Apply | Sign::Thin | Sign::Wide) => 0,
            Math::Letter(_) | Math::Sign(_) | Math::Open(_) | Math::Close(_) => 1,
            Math::Script(s) => {
                let corner = |m: &Option<Math>| m.as_ref().map_or(0, Math::glyphs);
                s.base.glyphs() + corner(&s.sub) + corner(&s.sup) + corner(&s.before_sub) + corner(&s.before_sup)
            }
            Math::Fraction(n, d) => n.glyphs() + d.glyphs() + 1,
            Math::Root(x) => x.glyphs() + 1,
            Math::Dot(x) => x.glyphs(),
            Math::Matrix(rows) => 2 + rows.iter().flatten().map(Math::glyphs).sum::<usize>(),
        }
    }

    /// The pieces of a row, rows inside rows opened; other pieces stay whole.
    pub fn flatten(self) -> Vec<Math> {
        match self {
            Math::Row(list) => list.into_iter().flat_map(Math::flatten).collect(),
            piece => vec![piece],
        }
    }

    /// Cuts a long formula into lines of at most `width` glyphs where it can be cut at a plus or minus; the cut is made at the
    /// fewest open brackets. Each further line begins with its sign.
    pub fn lines(self, width: usize) -> Vec<Math> {
        let mut rest = self.flatten();
        let mut lines = Vec::new();
        loop {
            let total: usize = rest.iter().map(Math::glyphs).sum();
            let Some(cut) = (total > width).then(|| cut(&rest, width)).flatten() else {
                lines.push(Math::Row(rest));
                return lines;
            };
            let tail = rest.split_off(cut);
            lines.push(Math::Row(std::mem::replace(&mut rest, tail)));
        }
    }
}

/// Where to cut: the last plus or minus of least depth that fills at least a third of the line.
fn cut(row: &[Math], width: usize) -> Option<usize> {
    let (mut used, mut depth) = (0usize, 0usize);
    let mut best: Option<(usize, usize)> = None;
    let mut fallback = None;
    for (i, piece) in row.iter().enumerate() {
        match piece {
            Math::Open(_) => depth += 1,
            Math::Close(_) => depth = depth.saturating_sub(1),
            Math::Sign(Sign::Plus | Sign::Minus) if i > 0 => {
                if used > width {
                    fallback = fallback.or(Some(i));
                    break;
                }
                if used * 3 >= width && best.is_none_or(|(d, _)| depth <= d) {
                    best = Some((depth, i));
                }
                fallback = Some(i);
            }
            _ => {}
        }
        used += piece.glyphs();
    }
    best.map(|b| b.1).or(fallback)
}
