//! Descriptions of arms in other formats, turned into the text of a table.
//!
//! **In:** the text of a URDF file, a table in CSV or Markdown, a script of a robotics toolbox, a calibration file. **Out:** [`Imported`]: the text of a complete table, and what was decided on the way (chain,
//! rounding, class of the arm) as lines for people; or a [`Problem`] with its line.
//!
//! The way of a URDF: `urdf` reads links and joints, `route` chooses the chain, `axes` places all axes in space, `frames` puts
//! Denavit-Hartenberg frames on them, `rounding` recovers exact angles and lengths, `write` makes cells of them and `sheet` the text, `describe` says
//! what kind of arm it is.
//!
//! **Never here:** access to files (the caller reads them), a second reader of tables: what is written here is read by `chain::table`.

mod arithmetic;
mod axes;
mod calibration;
pub mod command;
mod describe;
mod frames;
pub(crate) mod in_macro;
mod problem;
mod published;
mod rounding;
mod route;
mod sheet;
mod space;
mod toolbox;
mod urdf;
mod write;
mod yaml;

pub use problem::Problem;

use crate::chain::Convention;

/// How a file is to be read.
#[derive(Clone, Debug)]
pub struct Options {
    /// The link where the arm stands; the root of the tree if not given.
    pub base: Option<String>,
    /// The link that is moved; if not given, it must be the only one that comes into question.
    pub tip: Option<String>,
    /// Convention of the table: of a URDF the modified one if not given; of a table in text it must be known.
    pub convention: Option<Convention>,
    /// Name of the type; made from the robot's name if not given.
    pub name: Option<String>,
    /// How much rounding in the file is undone.
    pub rounding: Rounding,
    /// Whether bare angles of a table in text are degrees; told from the numbers if not given.
    pub degrees: Option<bool>,
    /// Unit of bare lengths of a table in text: `m`, `mm`; metres if neither given nor in the header.
    pub unit: Option<String>,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            base: None,
            tip: None,
            convention: None,
            name: None,
            rounding: Rounding::Near,
            degrees: None,
            unit: None,
        }
    }
}

/// How much rounding in a file is undone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Nothing but the noise of floating-point numbers (1e-9 radians, 1e-12 of the reach).
    AsWritten,
    /// Angles within 1e-3 radians of a multiple of 15 degrees, lengths within 1e-5 of the reach of 0 or of a short decimal.
    Near,
    /// Ten times as much.
    Far,
}

/// A table made from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Imported {
    /// The text of the table, as `dh_robot!` and the `dh` command take it.
    pub table: String,
    /// What was decided, line by line, for people.
    pub notes: Vec<String>,
}

/// A URDF file as a table.
///
/// # Errors
/// With the line of the file, where it is no URDF, the chain is not clear, or a joint cannot be a row of a table.
pub fn from_urdf(text: &str, options: &Options) -> Result<Imported, Problem> {
    let model = urdf::read(text)?;
    let route = route::choose(&model, options)?;
    let arm = axes::place(&model, &route, options.rounding)?;
    let rows = frames::build(&arm);
    let sheet = write::sheet(&model, &route, &arm, &rows, options);
    let mut notes = route.notes;
    notes.extend(arm.notes.iter().cloned());
    notes.extend(write::rounded(&arm, &rows));
    describe::finish(sheet, notes)
}

/// A table in CSV, TSV or Markdown, as data sheets and papers print it.
///
/// # Errors
/// With the line of the file, where a cell cannot be read, or where convention or unit of angles are not known.
pub fn from_table(text: &str, options: &Options) -> Result<Imported, Problem> {
    published::read(text, options)
}

/// A script of a robotics toolbox (MATLAB or Python): `Revolute('d', ..)`, `RevoluteMDH(d=..)`, `Link([...])`.
///
/// # Errors
/// With the line of the file, where a link cannot be read.
pub fn from_toolbox(text: &str, options: &Options) -> Result<Imported, Problem> {
    toolbox::read(text, options)
}

/// The calibration file of one serial number, beside the text of the nominal table.
///
/// # Errors
/// With the line of the file; where it is that of another arm.
pub fn from_calibration(text: &str, nominal: &str, options: &Options) -> Result<Imported, Problem> {
    calibration::read(text, nominal, options)
}
