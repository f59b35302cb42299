//! Lecture notes: from a chain to a document, step by step as on a blackboard.
//!
//! **In:** a [`Chain`]. **Out:** a [`Document`]. Prose is in `words`, formulas come from the algebra through
//! [`Order`] and [`Notation`]; nothing here knows a robot.

mod arm;
mod chapter;
mod degenerate;
mod example;
mod figures;
mod forward;
mod given;
mod inverse;
mod jacobian;
mod numbers;
mod options;
mod products;
mod singular;
mod table;
#[cfg(test)]
mod tests;
mod tree;
pub(super) mod words;
mod workspace;

pub use options::{Options, Part};

use super::{Block, Document, Equation, Span, Text};
use crate::algebra::{Poly, Transform};
use crate::chain::Chain;
use crate::kinematics::Kinematics;
use crate::planner::Refusal;
use crate::program::Inverse;
use crate::render::document::frames::Frame;
use crate::render::formula::expression::{Expression, Trig};
use crate::render::formula::grouping::Order;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::{Notation, trigs};
use crate::render::formula::quantities::named_offsets;
use example::Start;
use std::rc::Rc;
use words::Phrase;

/// The notes of a robot: the parts that the options name. Example texts that cannot be read are passed over; ask
/// [`Options::check`] first.
pub fn notes(chain: &Chain, options: &Options) -> Document {
    let start = Start::read(chain, options).or_else(|_| Start::read(chain, &Options::default()));
    let named = named_offsets(chain);
    let chain = named.as_ref().unwrap_or(chain);
    let kinematics = Kinematics::new(chain);
    let mut options = options.clone();
    if options.parts.iter().any(|p| matches!(p, Part::Planar | Part::Pieper)) {
        // their letters are those of the textbook
        options.style.taken = vec!['u', 'f', 'g', 'h', 'k'];
    }
    let options = &options;
    let mut w = NotesWriter::new(chain, options.clone());
    for part in &options.parts {
        match part {
            Part::Table => w.table(),
            Part::Figure => w.figure(&kinematics, start.as_ref().ok()),
            Part::Links => w.links(&kinematics),
            Part::Forward => w.forward(&kinematics),
            Part::Jacobian => w.jacobian(&kinematics),
            Part::Singular => w.singular(&kinematics),
            Part::Workspace => {
                // its form of the pose is not the one that later parts refer to
                let cited = w.numbered.len();
                w.workspace(&kinematics);
                w.numbered.truncate(cited);
                w.workspace_figure(&kinematics, start.as_ref().ok());
            }
            Part::Inverse => w.inverse(),
            Part::Frames => w.construction(),
            Part::Elementary => w.elementary(),
            Part::Conventions => w.conventions(),
            Part::Directions => w.directions(start.as_ref().ok()),
            Part::Spaces => w.spaces(),
            Part::Solutions => w.solutions_part(start.as_ref().ok()),
            Part::Accuracy => w.accuracy(),
            Part::Calibration => w.calibration(),
            Part::Methods => w.methods(),
            Part::Planar => w.planar_arm(start.as_ref().ok()),
            Part::Pieper => w.pieper(start.as_ref().ok()),
            Part::Example => {
                if let Ok(start) = &start {
                    w.example(start);
                }
            }
        }
    }
    let named = || Phrase::Title.in_language(options.language).replace("{}", &chain.name);
    let title = options.title.clone().unwrap_or_else(named);
    let (subtitle, fragment) = (options.subtitle.clone(), options.fragment);
    Document { title, subtitle, fragment, language: options.language.tag(), blocks: w.blocks }
}

/// Table, link transforms and their products: the formulas that stand beside numbers.
pub(super) fn matrices(chain: &Chain, options: &Options) -> Vec<Block> {
    let named = named_offsets(chain);
    let chain = named.as_ref().unwrap_or(chain);
    let kinematics = Kinematics::new(chain);
    let mut w = NotesWriter::new(chain, options.clone());
    w.table();
    w.links(&kinematics);
    w.forward(&kinematics);
    w.blocks
}

impl Options {
    /// Do joint names, values, motions and frames of these options fit the robot?
    ///
    /// # Errors
    /// What is wrong with the first that does not.
    pub fn check(&self, chain: &Chain) -> Result<(), String> {
        let last = chain.links.len();
        if let Some((i, j)) = self.products.iter().find(|p| p.1 > last) {
            return Err(format!("`--products`: there is no T({i}, {j}), the last frame is {last}"));
        }
        Start::read(chain, self).map(|_| ())
    }
}

/// Glyphs of a left side that costs the right one nothing.
const NAME: usize = 8;

/// Glyphs of a short product that stands beside a matrix of full width.
const PRODUCT: usize = 10;

/// A note while it is being written.
struct NotesWriter<'a> {
    chain: &'a Chain,
    notation: Notation,
    order: Order,
    options: Options,
    blocks: Vec<Block>,
    /// Abbreviations that the reader knows already.
    introduced: Vec<Trig>,
    /// Entries of the pose that have a name.
    named: Vec<(Poly, Math)>,
    /// Number of the last numbered equation.
    number: usize,
    /// Left sides of numbered equations with their numbers.
    numbered: Vec<(Math, usize)>,
    /// Whether the wrist is another point than the origin of the pose that is given.
    wrist_apart: bool,
    /// The inverse or why there is none, once a part has asked for it.
    solved: Option<Solved>,
}

/// An inverse that several parts use, or why there is none.
type Solved = Rc<Result<Rc<Inverse>, Refusal>>;

impl<'a> NotesWriter<'a> {
    fn new(chain: &'a Chain, options: Options) -> NotesWriter<'a> {
        NotesWriter {
            chain,
            notation: Notation::styled(chain, &options.style),
            order: Order::of(chain),
            options,
            blocks: Vec::new(),
            introduced: Vec::new(),
            named: Vec::new(),
            number: 0,
            numbered: Vec::new(),
            wrist_apart: false,
            solved: None,
        }
    }

    /// The inverse, found once for all parts.
    fn solved(&mut self) -> Solved {
        let chain = self.chain;
        self.solved.get_or_insert_with(|| Rc::new(Inverse::of(chain).map(Rc::new))).clone()
    }

    /// The transform between two frames of the table.
    fn link_name(&self, i: usize, j: usize) -> Math {
        self.notation.transform(Frame::Row(i), Frame::Row(j))
    }

    fn words(&self, p: Phrase) -> &'static str {
        p.in_language(self.options.language)
    }

    fn heading(&mut self, level: u8, p: Phrase) {
        let text = self.words(p).into();
        self.blocks.push(Block::Heading(level, text));
    }

    fn say(&mut self, p: Phrase, pieces: Vec<Math>) {
        let text = Text::fill(self.words(p), pieces.into_iter().map(Span::Math).collect());
        self.blocks.push(Block::Paragraph(text));
    }

    /// A formula in reading order.
    fn group(&self, p: &Poly) -> Expression {
        self.order.group(p)
    }

    /// `left = formula`, cut into lines.
    fn equation(&self, left: Math, right: Math) -> Equation {
        let width = self.options.width;
        let room = (width + NAME).saturating_sub(left.glyphs()).clamp(width / 3, width);
        Equation { left, right: loosened(right, room).lines(room), number: None }
    }

    /// The number of the last equation with this left side.
    fn number_of_equation(&self, left: &Math) -> Option<usize> {
        self.numbered.iter().rev().find(|e| e.0 == *left).map(|e| e.1)
    }

    /// A displayed equation with a number.
    fn display(&mut self, left: Math, right: Math) {
        self.number += 1;
        self.numbered.push((left.clone(), self.number));
        self.blocks.push(Block::Equations(vec![Equation { left, right: vec![right], number: Some(self.number) }]));
    }

    /// `left = product = matrix`, on two lines where one is too short.
    fn display_product(&mut self, left: Math, product: Option<Math>, matrix: Math) {
        let width = |m: &Math| match m {
            Math::Matrix(rows) => row_width(rows),
            other => other.glyphs(),
        };
        let short = |p: &Math| if p.glyphs() <= PRODUCT { PRODUCT } else { 0 };
        let right = match product {
            Some(p) if width(&matrix) + p.glyphs() <= self.options.width + short(&p) => {
                vec![Math::equation(p, matrix)]
            }
            Some(p) => vec![p, Math::Row(vec![Math::Sign(Sign::Equals), matrix])],
            None => vec![matrix],
        };
        self.number += 1;
        self.numbered.push((left.clone(), self.number));
        self.blocks.push(Block::Equations(vec![Equation { left, right, number: Some(self.number) }]));
    }

    /// Introduces the abbreviations in these formulas that are new to the reader.
    fn tell_new(&mut self, p: Phrase, expressions: &[Expression]) {
        let new: Vec<Trig> = trigs(expressions).into_iter().filter(|w| !self.introduced.contains(w)).collect();
        let legend = self.notation.legend_of(&new);
        self.introduced.extend(new);
        self.tell(p, legend);
    }

    fn tell(&mut self, p: Phrase, legend: Vec<Math>) {
        if legend.is_empty() {
            return;
        }
        let mut halves = self.words(p).splitn(2, "{}");
        let mut text = Text::from(halves.next().unwrap_or_default());
        let mut between = "";
        for m in legend {
            text.0.push(Span::Plain(between.to_string()));
            // after one that has commas of its own
            let commas = m.clone().flatten().iter().any(|x| matches!(x, Math::Sign(Sign::Comma | Sign::Dots)));
            between = self.words(if commas { Phrase::Then } else { Phrase::Between });
            text.0.push(Span::Math(m));
        }
        text.0.extend(halves.next().map(|t| Span::Plain(t.to_string())));
        text.0.retain(|s| !matches!(s, Span::Plain(t) if t.is_empty()));
        self.blocks.push(Block::Paragraph(text));
    }

    /// The upper three rows, grouped.
    fn entries(&self, t: &Transform) -> Vec<Vec<Expression>> {
        (0..3).map(|i| (0..4).map(|j| self.group(&t.entry(i, j))).collect()).collect()
    }

    fn matrix(&self, rows: &[Vec<Expression>]) -> Vec<Vec<Math>> {
        rows.iter().map(|r| r.iter().map(|e| self.notation.typeset(e)).collect()).collect()
    }

    /// `left = product = matrix`, or, where the matrix is too wide, a matrix of names and the entries one by one, in columns.
    fn transform(&mut self, left: Math, product: Option<Math>, t: &Transform, prefix: Prefix) -> Vec<Expression> {
        let entries = self.entries(t);
        let mut cells = self.matrix(&entries);
        let fits = row_width(&cells) <= self.options.width;
        let mut list = Vec::new();
        self.named.clear();
        if !fits {
            for j in 0..4 {
                for i in 0..3 {
                    let named = name(i, j, prefix);
                    self.named.push((t.entry(i, j), named.clone()));
                    if let Some(cell) = cells.get_mut(i).and_then(|r| r.get_mut(j)) {
                        let right = std::mem::replace(cell, named.clone());
                        list.push(self.equation(named, right));
                    }
                }
            }
        }
        cells.push(["0", "0", "0", "1"].map(Math::number).to_vec());
        let matrix = Math::Matrix(cells);
        self.display_product(left, product, matrix);
        if !list.is_empty() {
            self.blocks.push(Block::Equations(list));
        }
        entries.into_iter().flatten().collect()
    }
}

/// A fraction that is too wide as a product, which can be cut: 1/2 [...].
fn loosened(m: Math, width: usize) -> Math {
    match m {
        Math::Fraction(above, below) if above.glyphs() > width => {
            let one = Math::Fraction(Box::new(Math::number(1)), below);
            Math::Row(vec![one, Math::Open('['), *above, Math::Close(']')])
        }
        Math::Row(list) => Math::Row(list.into_iter().map(|m| loosened(m, width)).collect()),
        other => other,
    }
}

/// Glyphs of the widest entries of all columns, with some room between.
fn row_width(cells: &[Vec<Math>]) -> usize {
    let columns = cells.iter().map(Vec::len).max().unwrap_or(0);
    (0..columns).map(|j| 1 + cells.iter().filter_map(|r| r.get(j)).map(Math::glyphs).max().unwrap_or(0)).sum()
}

/// The frames of a transform whose entries get names: the first where it is not the base, the second where it is not the last.
type Prefix = Option<(usize, Option<usize>)>;

/// r11, px; with the frames before it.
fn name(i: usize, j: usize, prefix: Prefix) -> Math {
    let axes = ['x', 'y', 'z'];
    let plain = match axes.get(i) {
        Some(axis) if j == 3 => Math::Letter('p').below(Math::Letter(*axis)),
        _ => Math::Letter('r').below(Math::number(format!("{}{}", i + 1, j + 1))),
    };
    match prefix {
        Some((from, None)) => plain.before(Math::number(from)),
        Some((from, Some(to))) => match plain.before(Math::number(from)) {
            Math::Script(mut s) => {
                s.before_sub = Some(Math::number(to));
                Math::Script(s)
            }
            other => other,
        },
        None => plain,
    }
}

fn side_by_side(list: Vec<Math>) -> Math {
    let mut row = Vec::new();
    for m in list {
        if !row.is_empty() {
            row.push(Math::Sign(Sign::Thin));
        }
        row.push(m);
    }
    Math::Row(row)
}
