//! Interprets header and rows of a table: which cell is which quantity, and checks each row.

use super::cell::{self, Site};
use super::drive::{self, Moving};
use super::expression;
use super::header::{self, Heading};
use super::names::variable_number;
use super::number::Unit;
use super::origin::Column;
use super::radians;
use super::range::{self, Measure};
use super::rows::{Cell, Grid, Row};
use super::scope::{Kind, Scope};
use super::size;
use super::spelling::suggestion;
use super::sum::{AngleUnit, Sum};
use super::text;
use crate::algebra::Rational;
use crate::chain::{Convention, RowSpec};
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::TokenTree;

/// Most rows of a table.
pub(super) const MOST_ROWS: usize = 16;
/// Most moving rows.
const MOST_JOINTS: usize = 12;

/// Longer labels are passed over.
const LONGEST_LABEL: usize = 60;

/// More columns are no table, and would only cost time.
const MOST_COLUMNS: usize = 24;
const COLUMNS: &str = "columns: joint, alpha, a, d, theta, range";

/// Columns that every table has.
const REQUIRED: [Column; 4] = [Column::Alpha, Column::A, Column::D, Column::Theta];

/// What the rows say.
#[derive(Default)]
pub(super) struct Checked {
    pub(super) rows: Vec<RowSpec>,
    /// Per joint: its row, and the column where it moves.
    pub(super) joints: Vec<(usize, Column)>,
    /// Per row: its place and those of its cells.
    pub(super) places: Vec<(Place, Vec<(Column, Place)>)>,
    /// Lengths without a unit.
    pub(super) bare: Vec<(f64, Place)>,
}

/// Checks header, rows and numbering.
pub(super) fn grid(grid: &Grid, convention: Option<Convention>, scope: &Scope, errors: &mut Errors) -> Checked {
    let mut out = Checked::default();
    let Some(headings) = header(&grid.header, errors) else { return out };
    let columns: Vec<Option<Column>> = headings.iter().map(|h| h.as_ref().map(|h| h.column)).collect();
    agrees(&grid.header, &headings, convention, errors);
    if grid.rows.is_empty() && errors.is_empty() {
        errors.push(Error::new(grid.place, "the table has no rows"));
    }
    if let Some(row) = grid.rows.get(MOST_ROWS) {
        errors.push(Error::new(row.place, format!("a table has at most {MOST_ROWS} rows")));
    }
    let complete = REQUIRED.iter().all(|c| columns.contains(&Some(*c)));
    let (mut moving, mut readable) = (Vec::new(), complete);
    for (i, row) in grid.rows.iter().take(MOST_ROWS).enumerate() {
        let cells: Vec<(Column, &Cell)> =
            columns.iter().zip(&row.cells).filter_map(|(c, cell)| Some(((*c)?, cell))).collect();
        let lengths = cells.iter().filter(|(c, _)| matches!(c, Column::A | Column::D));
        out.bare.extend(lengths.filter_map(|(_, cell)| size::bare(&cell.tokens, cell.place)));
        out.places.push((row.place, cells.iter().map(|(c, cell)| (*c, cell.place)).collect()));
        let before = errors.len();
        let units: Vec<(Column, Unit)> =
            headings.iter().flatten().filter_map(|h| Some((h.column, h.unit.clone()?))).collect();
        let reader =
            RowReader { units, cells: if row.fits { cells } else { Vec::new() }, number: i + 1, scope, complete };
        let (spec, driven) = reader.read(row, moving.len(), errors);
        readable &= errors.len() == before;
        if let Some((column, m)) = driven {
            out.joints.push((i, column));
            moving.push(m);
        }
        out.rows.push(spec);
    }
    if let Some(m) = moving.get(MOST_JOINTS) {
        errors.push(Error::new(m.place, format!("a robot has at most {MOST_JOINTS} joints")));
    } else if moving.is_empty() && readable && !grid.rows.is_empty() {
        let error = Error::new(grid.place, "nothing moves: no row has a joint variable");
        errors.push(error.help("write `q1` in column `theta` where the first joint turns, or in `d` where it slides"));
    } else {
        drive::check(&moving, readable && grid.rows.len() <= MOST_ROWS, scope, errors);
    }
    out
}

/// Which column each header cell names. `None` where there is no header at all.
fn header(row: &Row, errors: &mut Errors) -> Option<Vec<Option<Heading>>> {
    if row.cells.is_empty() {
        return None;
    }
    if let Some(cell) = row.cells.get(MOST_COLUMNS) {
        errors.push(Error::new(cell.place, "there are not so many columns").help(COLUMNS));
        return None;
    }
    let near = |name: &str| suggestion(name, Column::ALL.map(Column::name));
    let names: Vec<String> = row.cells.iter().map(|c| text::of(&c.tokens)).collect();
    let headings: Vec<Option<Heading>> = row.cells.iter().map(|c| header::read(&c.tokens)).collect();
    let column = |h: &Option<Heading>| h.as_ref().map(|h| h.column);
    if !names.iter().zip(&headings).any(|(n, h)| h.is_some() || near(n).is_some()) {
        let error = Error::new(row.place, "the header is missing: the first row names the columns");
        errors.push(error.help("`| joint | alpha | a | d | theta | range |`, in any order"));
        return None;
    }
    let mut columns: Vec<Option<Heading>> = Vec::new();
    // A misspelt or unnamed column is most likely the one that is missing.
    let mut doubtful = row.cells.iter().any(|c| c.tokens.is_empty());
    for ((name, cell), heading) in names.iter().zip(&row.cells).zip(&headings) {
        let mut meant = heading.clone();
        let first =
            columns.iter().position(|c| c.is_some() && column(c) == column(heading)).and_then(|i| row.cells.get(i));
        match (heading, first) {
            (Some(_), Some(first)) => {
                let error = Error::new(cell.place, format!("column `{name}` appears twice"));
                errors.push(error.related(first.place, "first here"));
                columns.push(None);
                doubtful = true;
                continue;
            }
            (None, _) if !cell.tokens.is_empty() => {
                doubtful = true;
                // The cells below are read as what was most likely meant.
                let free = |c: &Column| headings.iter().chain(&columns).all(|h| column(h) != Some(*c));
                let found = near(name).and_then(|n| Column::ALL.into_iter().find(|c| c.name() == n)).filter(free);
                meant = found.map(|column| Heading { column, previous: false, unit: None });
                let error = Error::new(cell.place, format!("unknown column `{name}`"));
                errors.push(match (near(name), other_name(name)) {
                    (Some(n), _) | (None, Some(n)) => error.help(format!("did you mean `{n}`?")),
                    _ => error.help(COLUMNS),
                });
            }
            _ => {}
        }
        columns.push(meant);
    }
    for want in REQUIRED {
        if !columns.iter().any(|h| column(h) == Some(want)) && !doubtful {
            errors.push(Error::new(row.place, format!("column `{}` is missing", want.name())));
        }
    }
    Some(columns)
}

/// Whether the convention fits the indices of the header: alpha(i-1) and a(i-1) belong to the modified one.
fn agrees(row: &Row, headings: &[Option<Heading>], convention: Option<Convention>, errors: &mut Errors) {
    let shows =
        |h: &Option<Heading>| h.as_ref().is_some_and(|h| h.previous && matches!(h.column, Column::Alpha | Column::A));
    let Some(cell) = headings.iter().position(shows).and_then(|i| row.cells.get(i)) else { return };
    if convention == Some(Convention::Standard) {
        let text = "a header with the index i-1 belongs to the modified convention, and the table says `standard`";
        errors.push(Error::new(cell.place, text).help("write `convention = modified;`, or the column without index"));
    }
}

/// What other books call the columns.
fn other_name(name: &str) -> Option<&'static str> {
    match name {
        "twist" => Some("alpha"),
        "r" | "length" | "l" => Some("a"),
        "s" | "offset" => Some("d"),
        "q" | "angle" => Some("theta"),
        "limits" | "limit" | "min" | "max" => Some("range"),
        _ => None,
    }
}

struct RowReader<'a> {
    cells: Vec<(Column, &'a Cell)>,
    /// Columns whose header names a unit.
    units: Vec<(Column, Unit)>,
    /// From 1, as people count.
    number: usize,
    scope: &'a Scope,
    /// Whether no column is missing: else a row that seems fixed may be none.
    complete: bool,
}

impl RowReader<'_> {
    fn cell(&self, column: Column) -> Option<&Cell> {
        self.cells.iter().find(|(c, cell)| *c == column && !cell.tokens.is_empty()).map(|(_, cell)| *cell)
    }

    fn sum(&self, column: Column, errors: &mut Errors) -> Option<Sum> {
        let cell = self.cell(column)?;
        let want = if matches!(column, Column::Alpha | Column::Theta) { Kind::Angle } else { Kind::Length };
        let sum = errors.take(expression::read(&cell.tokens, cell.place, self.scope, want))?;
        match self.units.iter().find(|u| u.0 == column) {
            Some((_, unit)) => errors.take(with_unit(sum, unit, self.scope)),
            None => Some(sum),
        }
    }

    /// `joint`: how many rows above move.
    fn read(&self, row: &Row, joint: usize, errors: &mut Errors) -> (RowSpec, Option<(Column, Moving)>) {
        let mut spec = RowSpec::default();
        let site = |c: Column| format!("column `{}`", c.name());
        if let Some(sum) = self.sum(Column::Alpha, errors) {
            let angle = cell::angle(&sum, self.scope, Site(&site(Column::Alpha)));
            spec.alpha = errors.take(angle).unwrap_or_default();
        }
        if let Some(sum) = self.sum(Column::A, errors) {
            let length = cell::length(&sum, self.scope, Site(&site(Column::A)));
            spec.a = errors.take(length).unwrap_or_default();
        }
        let (d, theta) = (self.sum(Column::D, errors), self.sum(Column::Theta, errors));
        // A cell that could not be read still shows whether it was meant to move.
        let meant = |c: Column| self.cell(c).is_some_and(|cell| has_variable(&cell.tokens));
        let place = |c: Column| self.cell(c).map_or(row.place, |cell| cell.place);
        let mut driven = match (meant(Column::Theta), meant(Column::D)) {
            (true, true) => {
                let text = format!("row {} moves in `theta` and in `d`: one joint per row", self.number);
                errors.push(
                    Error::new(place(Column::D), text)
                        .related(place(Column::Theta), "it moves here already")
                        .help("write a cylindrical joint as two rows"),
                );
                Some(Column::Theta)
            }
            (true, false) => Some(Column::Theta),
            (false, true) => Some(Column::D),
            (false, false) => None,
        };
        let mut moving = None;
        if !row.fits && driven.is_none() && row.cells.iter().any(|c| has_variable(&c.tokens)) {
            driven = Some(Column::Theta);
        }
        if let Some(column) = driven {
            moving = Some((column, Moving { row: self.number, place: place(column), drive: None }));
        }
        let both = meant(Column::Theta) && meant(Column::D);
        let mut rest = |sum: Option<Sum>, column: Column, errors: &mut Errors| {
            let sum = sum?;
            if both || !cell::moves(&sum) {
                return Some(sum).filter(|s| !cell::moves(s));
            }
            let (drive, rest) = errors.take(cell::split(&sum, self.scope, column == Column::Theta, place(column)))?;
            if let Some((_, m)) = &mut moving {
                m.drive = Some(drive.clone());
            }
            spec.moves = Some(drive);
            Some(rest)
        };
        let (d, theta) = (rest(d, Column::D, errors), rest(theta, Column::Theta, errors));
        if let Some(sum) = d {
            let length = cell::length(&sum, self.scope, Site(&site(Column::D)));
            spec.d = errors.take(length).unwrap_or_default();
        }
        if let Some(sum) = theta {
            let angle = cell::angle(&sum, self.scope, Site(&site(Column::Theta)));
            spec.theta = errors.take(angle).unwrap_or_default();
        }
        self.range(&mut spec, driven, joint, errors);
        spec.label = self.cell(Column::Joint).and_then(|cell| label(&cell.tokens));
        (spec, moving)
    }

    fn range(&self, spec: &mut RowSpec, driven: Option<Column>, joint: usize, errors: &mut Errors) {
        let Some(cell) = self.cell(Column::Range).filter(|_| self.complete) else { return };
        let measure = match (&spec.moves, driven) {
            (None, None) => Measure::Fixed,
            (Some(drive), _) => drive::measure(drive, joint),
            // The cell that moves could not be read: whatever the range says may be right.
            (None, Some(_)) => Measure::Either,
        };
        spec.range = errors.take(range::read(cell, self.scope, measure, joint + 1)).flatten();
    }
}

/// What a row is called: a word or a text, but not its number.
fn label(tokens: &[TokenTree]) -> Option<String> {
    let text = match tokens {
        [TokenTree::Literal(text)] => match syn::parse_str::<syn::Lit>(&text.to_string()) {
            Ok(syn::Lit::Str(text)) => text.value(),
            _ => return None,
        },
        tokens => text::of(tokens),
    };
    let fit = text.chars().count() <= LONGEST_LABEL && text.chars().any(char::is_alphabetic);
    fit.then_some(text)
}

/// Bare numbers of a column take the unit of its header.
fn with_unit(mut sum: Sum, unit: &Unit, scope: &Scope) -> Result<Sum, Error> {
    for t in &mut sum.terms {
        if t.lengths > 0 || t.angle.is_some() || t.variable.is_some() || !t.names.is_empty() || t.factor.is_zero() {
            continue;
        }
        match unit {
            Unit::Length(metres) => {
                let per_metre = scope.unit.metres.recip().unwrap_or(Rational::ONE);
                t.factor = &(&t.factor * metres) * &per_metre;
                t.lengths = 1;
            }
            Unit::HalfTurns(x) => {
                t.factor = &t.factor * x;
                t.angle = Some(AngleUnit::Pi);
            }
            // Radians are never exact: the error names the exact angle.
            Unit::Radians => {
                let help = radians::unit_of(&t.word);
                return Err(Error::new(t.place, "radians are never exact").help(help));
            }
            Unit::None => {}
        }
    }
    Ok(sum)
}

/// Whether there is a joint variable among these tokens (two levels of parentheses deep).
fn has_variable(tokens: &[TokenTree]) -> bool {
    fn look(tokens: impl IntoIterator<Item = TokenTree>, depth: usize) -> bool {
        tokens.into_iter().any(|t| match t {
            TokenTree::Ident(i) => variable_number(&i.to_string()).is_some(),
            TokenTree::Group(g) => depth > 0 && look(g.stream(), depth - 1),
            _ => false,
        })
    }
    look(tokens.iter().cloned(), 8)
}
