//! From tokens to a checked [`ChainSpec`]; all errors of a table at once, each at its cell.
//!
//! **In:** the tokens between the braces of `dh_robot!`. **Out:** [`Parsed`]: the robot as written, where each fact stands
//! ([`Origins`]), the claims of `prove` blocks unread, and the [`Errors`].
//!
//! The way: `statements` finds the lines, `rows` cuts the table into cells, `parameters` and `settings` read what stands
//! outside the table, `expression` reads one cell into a `sum`, `cell` checks that the sum fits its place, `check` and
//! `drive` look at rows together.
//!
//! **Never here:** formulas, floats (but for limits and the look of radians), panics: anything may stand between the braces.

mod cell;
mod check;
mod cursor;
mod derives;
mod drive;
mod expression;
mod functions;
mod header;
mod motion;
mod names;
mod number;
mod origin;
mod parameters;
mod radians;
mod range;
mod rows;
mod scope;
mod settings;
mod size;
mod spelling;
mod statements;
mod sum;
#[cfg(test)]
mod tests;
pub(crate) mod text;

pub use origin::{Column, Origins};
pub use statements::{ClaimTokens, Head};

use super::{AngleCell, ChainSpec, LengthUnit, MotionSpec, Quantity, Settings};
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use scope::{Kind, Scope};
use statements::{SettingLine, Written};

/// What was read.
#[derive(Debug)]
pub struct Parsed {
    /// Documentation, attributes, visibility and name of the struct.
    pub head: Head,
    /// The robot; `None` if there were errors.
    pub spec: Option<ChainSpec>,
    /// What is known of it even so.
    pub sketch: Sketch,
    /// The lines of the `prove` blocks.
    pub claims: Vec<ClaimTokens>,
    /// Where everything stands.
    pub origins: Origins,
    /// All that is wrong.
    pub errors: Errors,
}

/// What the generated type looks like from outside, as far as it is known in spite of errors.
#[derive(Clone, Debug)]
pub struct Sketch {
    /// Number of rows with a joint variable.
    pub joints: usize,
    /// Number of rows.
    pub rows: usize,
    /// Fields of the struct.
    pub fields: Vec<Field>,
    /// What is set for the robot as a whole.
    pub settings: Settings,
    /// The table as text: header and rows, for the documentation of the generated type.
    pub table: Vec<Vec<String>>,
    /// `base` and `tool` as text.
    pub motions: Vec<(String, String)>,
}

/// A field of the struct.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name.
    pub name: Ident,
    /// Its doc comment, line by line.
    pub docs: Vec<String>,
    /// What it measures; `None` for a pose.
    pub quantity: Option<Quantity>,
    /// Whether it has a nominal value.
    pub nominal: bool,
}

/// A declared angle may stand in the rotations of a chain this often in all: sums of angles stay within what formulas can count.
const MOST_TIMES_OF_AN_ANGLE: u32 = 24;

/// Reads a table. Never panics, whatever the tokens are.
pub fn parse(input: TokenStream) -> Parsed {
    let mut errors = Errors::new();
    let tokens: Vec<TokenTree> = input.into_iter().collect();
    let nothing = tokens.is_empty();
    if nothing {
        let error = Error::new(Place::call_site(), "there is no robot here");
        errors.push(error.help("write `pub struct Name;`, `convention = modified;` and a table"));
    }
    let mut written = if nothing { Written::default() } else { statements::read(&tokens, &mut errors) };
    let lines = settings::read(&written.settings, &mut errors);
    let mut settings = lines.settings;
    let head_place = written.head.name.as_ref().map_or_else(Place::call_site, |n| Place::at(n.span()));

    let mut scope = Scope { names: Vec::new(), poses: Vec::new(), unit: settings.unit.clone() };
    for line in &written.lets {
        parameters::declare(line, &mut scope, &mut errors);
    }
    if !written.claims.is_empty() {
        for d in scope.names.iter().filter(|d| names::is_cosine_or_sine(&d.name)) {
            let text = format!("`{}` is a cosine or sine in the `prove` block: choose another name", d.name);
            errors.push(Error::new(d.place, text));
        }
    }
    if !lines.has_convention && !nothing {
        let error = Error::new(head_place, "the convention is missing; there is no default");
        errors.push(error.help("write `convention = standard;` or `convention = modified;` (Craig)"));
    }
    let motions = |name: &str, errors: &mut Errors| {
        let setting = written.settings.iter().find(|s| s.name == name && !s.value.is_empty());
        setting.map_or_else(Vec::new, |s| motion::read(s, &scope, errors))
    };
    let (base, tool) = (motions("base", &mut errors), motions("tool", &mut errors));
    let checked = match &written.grid {
        Some(grid) => check::grid(grid, lines.convention, &scope, &mut errors),
        None if nothing => check::Checked::default(),
        None => {
            let error = Error::new(head_place, "the table is missing");
            errors.push(error.help("write `| joint | alpha | a | d | theta |` and one row per link"));
            check::Checked::default()
        }
    };
    let joints = checked.joints.len();
    let fine = errors.is_empty();
    let known = written.grid.is_some() && joints > 0;
    for (word, place) in &lines.redundant {
        let index = variable(word, *place, if known { joints } else { usize::MAX }, &settings.redundant);
        let index = index.and_then(|k| if known && fine { moves_alone(k, *place, &checked.rows) } else { Ok(k) });
        settings.redundant.extend(errors.take(index));
    }
    check_angles(&scope, &checked.rows, &base, &tool, &mut errors);
    if errors.is_empty() && !written.settings.iter().any(|s| s.name == "unit") {
        size::check(&checked.bare, &written.lets, &mut errors);
    }

    let fields = fields(&written.lets, &scope);
    let (attributes, default) = derives::filter(std::mem::take(&mut written.head.attributes));
    written.head.attributes = attributes;
    if let (Some(place), Some(field)) = (default, fields.iter().find(|f| !f.nominal)) {
        let text = format!("there is no `Default`: `{}` has no nominal value", field.name);
        errors.push(Error::new(place, text));
    }
    let sketch = Sketch {
        joints,
        rows: checked.rows.len(),
        fields,
        settings: settings.clone(),
        table: written.grid.as_ref().map_or_else(Vec::new, table_text),
        motions: motions_text(&written.settings),
    };
    let origins = Origins {
        name: head_place,
        header: written.grid.as_ref().map_or(head_place, |g| g.header.place),
        rows: checked.places,
        settings: written.settings.iter().map(|s| (s.name.to_string(), s.place)).collect(),
        parameters: scope.names.iter().map(|d| d.place).collect(),
        joints: checked.joints,
    };
    let spec = match (&written.head.name, lines.convention) {
        (Some(name), Some(convention)) if errors.is_empty() => Some(ChainSpec {
            name: name.to_string(),
            convention,
            settings,
            parameters: parameters::specs(&scope),
            rows: checked.rows,
            base,
            tool,
            poses: parameters::poses(&scope),
        }),
        _ => None,
    };
    Parsed { head: written.head, spec, sketch, claims: written.claims, origins, errors }
}

/// A product of motions that stands alone, such as `tx(830mm) * rz(30deg)`, by the rules of `base` and `tool`.
///
/// # Errors
/// All that is wrong with it, at places of this text.
pub fn motions(text: &str, unit: &LengthUnit) -> Result<Vec<MotionSpec>, Errors> {
    let value: Vec<TokenTree> = crate::diagnostic::lex(text)?.into_iter().collect();
    let place = Place::of_all(&value).unwrap_or_else(Place::call_site);
    let line = SettingLine { name: Ident::new("base", Span::call_site()), value, place };
    let mut errors = Errors::new();
    let list = motion::read(&line, &Scope { names: Vec::new(), poses: Vec::new(), unit: unit.clone() }, &mut errors);
    if errors.is_empty() { Ok(list) } else { Err(errors) }
}

/// What a cell of a header says, in the spellings of books and data sheets: the column, whether it shows the index i-1, and the unit of
/// bare numbers. `None` where it names no column.
pub fn heading(text: &str) -> Option<(Column, bool, Option<String>)> {
    // In the form of a row, where characters of typesetting are read.
    let tokens: Vec<TokenTree> = crate::diagnostic::lex(&format!("|{text}")).ok()?.into_iter().skip(1).collect();
    let found = header::read(&tokens)?;
    let unit = found.unit.as_ref().map(number::unit_name);
    Some((found.column, found.previous, unit))
}

/// `redundant = q3;`: the index of the joint.
fn variable(word: &str, place: Place, joints: usize, others: &[usize]) -> Result<usize, Error> {
    let index = names::variable_number(word).and_then(|n| n.checked_sub(1)).filter(|i| *i < joints);
    match index {
        Some(i) if others.contains(&i) => Err(Error::new(place, format!("`{word}` is named twice"))),
        Some(i) => Ok(i),
        None => {
            let error = Error::new(place, "`redundant` names joint variables of the table");
            Err(if joints < usize::MAX { error.help(format!("of `q1` to `q{joints}`")) } else { error })
        }
    }
}

/// An actuator that the caller chooses must fix a joint, whatever the other actuators do.
fn moves_alone(actuator: usize, place: Place, rows: &[super::RowSpec]) -> Result<usize, Error> {
    let mut drives = rows.iter().filter_map(|row| row.moves.as_ref());
    if drives.any(|d| matches!(d.terms.as_slice(), [(v, _)] if *v == actuator)) {
        return Ok(actuator);
    }
    let text = format!("no row is moved by `q{}` alone, so choosing it fixes no joint", actuator + 1);
    Err(Error::new(place, text).help("choose a variable that stands alone in a cell"))
}

fn check_angles(scope: &Scope, rows: &[super::RowSpec], base: &[MotionSpec], tool: &[MotionSpec], errors: &mut Errors) {
    let motions = base.iter().chain(tool).filter_map(|m| match m {
        MotionSpec::Rotate(_, cell) => Some(cell),
        MotionSpec::Translate(..) | MotionSpec::Pose(_) => None,
    });
    let cells: Vec<&AngleCell> = rows.iter().flat_map(|r| [&r.alpha, &r.theta]).chain(motions).collect();
    for (i, d) in scope.names.iter().enumerate().filter(|(_, d)| d.kind == Kind::Angle) {
        let times = cells.iter().flat_map(|c| &c.symbols).filter(|s| s.0 == i).map(|s| u32::from(s.1.unsigned_abs()));
        if times.sum::<u32>() > MOST_TIMES_OF_AN_ANGLE {
            let text = format!("the angle `{}` occurs more than {MOST_TIMES_OF_AN_ANGLE} times", d.name);
            errors.push(Error::new(d.place, text));
        }
    }
}

/// The fields, once each, in order.
fn fields(lets: &[statements::Let], scope: &Scope) -> Vec<Field> {
    let mut list: Vec<Field> = Vec::new();
    for line in lets {
        let name = line.name.to_string();
        let number = scope.names.iter().find(|d| d.name == name).filter(|d| d.field);
        let quantity = match number {
            Some(d) => Some(if d.kind == Kind::Angle { Quantity::Angle } else { Quantity::Length }),
            None if scope.pose(&name).is_some() => None,
            None => continue,
        };
        // A name that is no field name is an error already, and must not break the struct as well.
        if names::check_parameter(&line.name).is_ok() && !list.iter().any(|f| f.name == name) {
            list.push(Field {
                name: line.name.clone(),
                docs: line.docs.clone(),
                quantity,
                nominal: line.value.is_some(),
            });
        }
    }
    list
}

fn motions_text(settings: &[statements::SettingLine]) -> Vec<(String, String)> {
    let motions = settings.iter().filter(|s| s.name == "base" || s.name == "tool");
    motions.map(|s| (s.name.to_string(), text::of(&s.value))).collect()
}

fn table_text(grid: &rows::Grid) -> Vec<Vec<String>> {
    let line = |row: &rows::Row| row.cells.iter().map(|c| text::of(&c.tokens)).collect();
    std::iter::once(&grid.header).chain(&grid.rows).take(1 + check::MOST_ROWS).map(line).collect()
}
