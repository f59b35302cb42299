//! The notation of hand derivations: its manual, and the syntax trees of the lines of a `prove { ... }` block.
//!
//! **In:** [`Token`]s (made from Rust tokens by `chain/table`). **Out:** a [`Derivation`]; a line that cannot be read is kept as
//! [`Statement::Unreadable`] with its place and reason, so that one slip of the pen stays one message.
//!
//! **Never here:** proc_macro2, algebra, verdicts (those are in `verify::check`).
//!
//! # Lines
//!
//! Every line ends with `;`. A doc comment before a line is its note (where it was printed, say).
//!
//! | line | meaning |
//! |------|---------|
//! | `A = B;` | A and B are the same formula: for all values of the joints and of the lengths. Decided exactly. `A = B = C` is two claims |
//! | `A != B;` | they are not the same formula |
//! | `A ~ B;` | they agree at the values of the last `at` line, to the printed digits: half a unit of the last digit of B's decimals, plus what the rounding of the `at` values can do |
//! | `A ~ B within t;` | they agree up to `t` (an angle where A is an angle) |
//! | `A = B or A = C;` | at every pose one of them holds; `A = B if q2 < 0deg or A = C if q2 > 0deg` says where each does. In documents `A = B ± C`, `∓` with it |
//! | `A < B;` `<=` `>` `>=` | holds for numbers, or at the values of the last `at` line |
//! | `at q1 = 21.8deg, q2 = -52.2deg;` | values for the `~` lines that follow. `q4 = -20deg within 0.5deg` says how far a value may be off; otherwise one with a decimal point was rounded at its last digit and one without is exact |
//! | `let f1 = a3*c3 + a2;` | a name for later lines |
//! | `let x: length;` `let phi: angle;` | a quantity of its own, not in the table |
//! | `alpha1: angle;` | the quantity is of this kind |
//!
//! # Formulas
//!
//! | written | meaning |
//! |---------|---------|
//! | `12`, `0.4318`, `30mm`, `90deg`, `pi/2` | exact numbers. A bare number is in the table's unit; angles need a unit (except 0) |
//! | `a2`, `l1`, ... | a declared name; otherwise the table's cell of that name: `a2` `d4` `alpha1` `theta3`, counted as the convention counts (modified: alpha0, a0, d1, theta1 in row 1) |
//! | `q3` | the variable of joint 3 |
//! | `c2` `s23` `c(2-3)` `c1_10` | cosine and sine of joint variables: q2, q2 + q3, q2 - q3, q1 + q10 |
//! | `ca2` `sa2` | cosine and sine of alpha2; `cphi`, `sphi` of an angle named `phi` |
//! | `cos(q2 + q3)` `sin` `tan` | of any angle; `cos(u, v)` of two unit vectors is the cosine of the angle between them |
//! | `atan2(y, x)` `acos` `asin` `atan` `sqrt` | angles by their ratio; angles are compared modulo a whole turn. A square root is never negative: where that decides, the verdict says under which condition the line holds |
//! | `T(i,j)` | frame j seen from frame i, 4x4, product of the rows without `base` and `tool`; for i > j the inverse. `A(i)` is T(i-1,i) |
//! | `J` `J(k)` `J(i,k)` | the geometric Jacobian (rows 1 to 3 linear, 4 to 6 angular, base axes, at the last frame or tool), its columns and entries. After a line that sets it equal to a written matrix with fewer rows, those of its rows that fit; before one, `det(J)` takes the rows of the task, or those that move |
//! | `Jv` `Jw` | its linear rows, its angular rows |
//! | `rows(M, 1, 2, 6)` | these rows of a matrix, in this order |
//! | `base` `tool` `I3` `I4` | the constant transforms of the table; identity matrices |
//! | `.r11` ... `.r33` `.px` `.py` `.pz` | entries of a transform |
//! | `.p` `.R` `.x` `.y` `.z` `.t` | position (3x1), rotation (3x3), columns (3x1), transpose; `.x` of a 3x1 is its first entry |
//! | `[a, b; c, d]` `[a; b; c]` | a matrix by rows; a column |
//! | `Rx(90deg)` `Tz(d4)` `Rot(x, 90deg)` `Trans(a, 0, d)` | elementary transforms, 4x4. A 4x4 without translation may be compared with a 3x3 |
//! | `+` `-` `*` `/` `^2` `^-1` | of numbers and matrices; the product sign is always written |
//! | `inv(M)` `det(M)` `dot(u, v)` `cross(u, v)` `norm2(v)` | inverse; determinant; products of columns; squared length |
//! | `subst(e, q2 = 0, a1 = a2)` | e with other quantities in place of variables, all at once |
//! | `diff(e, q2)` | derivative by a variable |

mod parse;
#[cfg(test)]
mod tests;
mod token;

pub use token::{Token, TokenKind, line_text};

use crate::chain::Quantity;
use std::ops::Range;

/// Numbers of tokens in [`Derivation::tokens`].
pub type Place = Range<usize>;

/// A hand derivation: its tokens and its lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Derivation {
    /// All tokens in order, brackets included.
    pub tokens: Vec<Token>,
    /// The lines in order.
    pub lines: Vec<Line>,
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Where it stands, without note and semicolon.
    pub place: Place,
    /// The doc comment before it, trimmed; empty where there is none.
    pub note: String,
    /// What it says.
    pub statement: Statement,
}

/// What a line says.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `A = B ~ C`: neighbours are related. At least one relation.
    Claim {
        /// The first formula.
        first: Expr,
        /// Relation to the one before, and the formula.
        rest: Vec<(Relation, Expr)>,
        /// `within` tolerance.
        within: Option<Expr>,
    },
    /// `alpha1: angle;`
    Kind(Expr, Quantity),
    /// `let f1 = ...;`
    Define(String, Expr),
    /// `let phi: angle;`
    Free(String, Quantity),
    /// `at q1 = 21.8deg, ...;`
    At(Vec<AtValue>),
    /// `A = B if q2 < 0deg or A = C`, `A = B ± C`: at every pose one of them holds; one with a condition, wherever this is met.
    Either(Vec<Branch>),
    /// Something that is said and claims nothing (only in documents): its text.
    Remark(String),
    /// Not a line of this notation.
    Unreadable(NotUnderstood),
}

/// One of several possibilities.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Where it stands.
    pub place: Place,
    /// The first formula.
    pub first: Expr,
    /// What it is equal to.
    pub rest: Vec<(Relation, Expr)>,
    /// Where it is to hold; nowhere in particular without it.
    pub guard: Option<(Expr, Relation, Expr)>,
}

/// Why and where a line could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotUnderstood {
    /// The offending tokens (may be empty: at the end of the line).
    pub place: Place,
    /// The reason, in one sentence.
    pub why: String,
}

/// One value of an `at` line.
#[derive(Clone, Debug, PartialEq)]
pub struct AtValue {
    /// The variable.
    pub name: String,
    /// Where its name stands.
    pub place: Place,
    /// Its value.
    pub value: Expr,
    /// How far the value may be off, where that is said.
    pub within: Option<Expr>,
}

/// How two formulas are related.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `=`
    Equal,
    /// `!=`
    NotEqual,
    /// `~`
    Near,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

/// A formula with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Its tokens.
    pub place: Place,
    /// What it is.
    pub kind: ExprKind,
}

/// What a formula is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A number as written, unit included.
    Number(String),
    /// A name.
    Name(String),
    /// `f(x, y)`; arguments may be labelled (`subst(e, q2 = 0)`).
    Call(String, Vec<(Option<String>, Expr)>),
    /// Terms; `true`: subtracted.
    Sum(Vec<(bool, Expr)>),
    /// Factors; `true`: divided by.
    Product(Vec<(bool, Expr)>),
    /// `-x`
    Negative(Box<Expr>),
    /// `x^n`
    Power(Box<Expr>, i32),
    /// `x.name`
    Field(Box<Expr>, String),
    /// Entries by rows: number of columns, entries.
    Matrix(usize, Vec<Expr>),
}

impl Derivation {
    /// Reads the lines. Never fails as a whole, never panics.
    pub fn parse(tokens: Vec<Token>) -> Derivation {
        let lines = parse::lines(&tokens);
        Derivation { tokens, lines }
    }

    /// The text of a place, spaced as people write.
    pub fn text(&self, place: &Place) -> String {
        line_text(self.tokens.get(place.clone()).unwrap_or_default()).0
    }
}

impl Expr {
    /// Reads one formula, which must fill the tokens.
    pub fn parse(tokens: &[Token]) -> Result<Expr, NotUnderstood> {
        parse::formula(tokens)
    }
}

impl Relation {
    /// As written.
    pub fn sign(self) -> &'static str {
        match self {
            Relation::Equal => "=",
            Relation::NotEqual => "!=",
            Relation::Near => "~",
            Relation::Less => "<",
            Relation::LessOrEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterOrEqual => ">=",
        }
    }
}
