//! The document tree that every printer prints: headings, paragraphs, equations, tables, lists, figures, code.

use super::figure::Drawing;
use crate::render::formula::math::Math;
use std::fmt;

/// A note.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// What it is called.
    pub title: String,
    /// A line below the title.
    pub subtitle: Option<String>,
    /// Whether it is to be a piece of another document (LaTeX, Typst): without preamble and title.
    pub fragment: bool,
    /// Language tag: `en`, `zh`.
    pub language: &'static str,
    /// What it says, in order.
    pub blocks: Vec<Block>,
}

/// A piece of a note that stands on lines of its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// A heading; level 1 is a section.
    Heading(u8, Text),
    /// A paragraph.
    Paragraph(Text),
    /// Displayed equations, aligned at their equals signs.
    Equations(Vec<Equation>),
    /// A table: header and rows.
    Table(Vec<Text>, Vec<Vec<Text>>),
    /// Points.
    List(Vec<Text>),
    /// Source text with its language.
    Code(&'static str, String),
    /// A drawing with its caption.
    Figure(Figure),
}

/// A drawing with its caption.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// What is drawn.
    pub drawing: Drawing,
    /// What is to be seen.
    pub caption: Text,
    /// The word "Figure" in the note's language.
    pub word: &'static str,
}

/// `left = right`, the right side on one or more lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// What is defined or computed.
    pub left: Math,
    /// What it is: lines after the first continue the formula.
    pub right: Vec<Math>,
    /// Its number in the note.
    pub number: Option<usize>,
}

/// As plain text.
impl fmt::Display for Document {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.print(super::Format::Text))
    }
}

/// Running text with formulas in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text(pub Vec<Span>);

/// A piece of running text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Span {
    /// Words.
    Plain(String),
    /// A formula.
    Math(Math),
    /// A name from the program.
    Code(String),
}

impl From<&str> for Text {
    fn from(text: &str) -> Text {
        Text(vec![Span::Plain(text.to_string())])
    }
}

impl From<String> for Text {
    fn from(text: String) -> Text {
        Text(vec![Span::Plain(text)])
    }
}

impl From<Math> for Text {
    fn from(m: Math) -> Text {
        Text(vec![Span::Math(m)])
    }
}

impl Text {
    /// A sentence with holes: each `{}` takes the next piece; pieces left over are dropped.
    pub fn fill(template: &str, pieces: Vec<Span>) -> Text {
        let mut out = Vec::new();
        let mut pieces = pieces.into_iter();
        for (i, words) in template.split("{}").enumerate() {
            if i > 0 {
                out.extend(pieces.next());
            }
            if !words.is_empty() {
                out.push(Span::Plain(words.to_string()));
            }
        }
        Text(out)
    }

    /// A sentence whose names stand between backticks.
    pub fn with_code(sentence: &str) -> Text {
        let pieces = sentence.split('`').enumerate().filter(|(_, piece)| !piece.is_empty());
        let span = |(i, piece): (usize, &str)| match i % 2 {
            0 => Span::Plain(piece.to_string()),
            _ => Span::Code(piece.to_string()),
        };
        Text(pieces.map(span).collect())
    }

    /// Pieces with something between them.
    pub fn join(pieces: impl IntoIterator<Item = Text>, between: &str) -> Text {
        let mut out: Vec<Span> = Vec::new();
        for piece in pieces {
            if !out.is_empty() {
                out.push(Span::Plain(between.to_string()));
            }
            out.extend(piece.0);
        }
        Text(out)
    }
}
