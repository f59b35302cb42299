//! `dh import`: its options, and from the text of a file to what is printed. Files are read by the caller.

use super::{Imported, Options, Problem, Rounding, from_calibration, from_table, from_toolbox, from_urdf};
use crate::chain::Convention;
use std::path::Path;

/// What `dh --help` says about it.
pub const HELP: &str = "\
dh import FILE: a table from another description of an arm, on standard output; what was decided on standard error

  arm.urdf                              chain, rounding and class of the arm are told; xacro files are expanded first
    --base LINK --tip LINK              the chain; may be left out where there is only one
  table.csv, table.tsv, table.md        a table as it is printed
    --angles deg|rad --unit m|mm|..     units of bare numbers, where neither header nor numbers tell
  script.m, script.py                   links of a robotics toolbox: Revolute(..), RevoluteMDH(..), Link([..])
  calibration.yaml --nominal arm.dh     the arm of one serial number

  --from urdf|csv|tsv|markdown|toolbox|calibration   where the name of the file does not tell
  --convention standard|modified        of the table that is written (URDF: modified if not given)
  --name NAME                           of the struct
  --as-written                          keep every digit; otherwise angles within 1e-3 rad of a multiple of 15 degrees
                                        and lengths within 1e-5 of the reach of 0 are rounded, and it is said
  --round                               round ten times as much
  --out PATH                            write there; the file appears when it is complete
";

/// The kinds of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A robot description in XML.
    Urdf,
    /// CSV, TSV, Markdown.
    Table,
    /// A script of a robotics toolbox.
    Toolbox,
    /// The calibration of one serial number.
    Calibration,
}

/// The command line, taken apart.
#[derive(Clone, Debug)]
pub struct Request {
    /// The file; `None` or `-`: standard input.
    pub file: Option<String>,
    /// Its format.
    pub format: Format,
    /// The nominal table of a calibration.
    pub nominal: Option<String>,
    /// How it is read.
    pub options: Options,
    /// `--out`: where to write the table.
    pub out: Option<String>,
}

impl Request {
    /// Reads the arguments behind `dh import`.
    ///
    /// # Errors
    /// A sentence about the argument that is wrong.
    pub fn read(arguments: &[String]) -> Result<Request, String> {
        let mut request =
            Request { file: None, format: Format::Urdf, nominal: None, options: Options::default(), out: None };
        let mut from = None;
        let mut list = arguments.iter();
        while let Some(argument) = list.next() {
            let (name, attached) = match argument.split_once('=') {
                Some((n, v)) if n.starts_with("--") => (n, Some(v.to_string())),
                _ => (argument.as_str(), None),
            };
            let mut value =
                || attached.clone().or_else(|| list.next().cloned()).ok_or(format!("`{name}` needs a value"));
            let options = &mut request.options;
            match name {
                "--base" => options.base = Some(value()?),
                "--tip" => options.tip = Some(value()?),
                "--name" => options.name = Some(type_name(value()?)?),
                "--convention" => {
                    options.convention = Some(match value()?.as_str() {
                        "standard" => Convention::Standard,
                        "modified" => Convention::Modified,
                        other => return Err(format!("no convention `{other}`: standard or modified")),
                    });
                }
                "--as-written" => options.rounding = Rounding::AsWritten,
                "--round" => options.rounding = Rounding::Far,
                "--angles" => {
                    options.degrees = Some(match value()?.as_str() {
                        "deg" => true,
                        "rad" => false,
                        other => return Err(format!("no unit `{other}` of angles: deg or rad")),
                    });
                }
                "--unit" => options.unit = Some(value()?),
                "--nominal" => request.nominal = Some(value()?),
                "--from" => from = Some(value()?),
                "--out" | "-o" => request.out = Some(value()?),
                _ if name.starts_with("--") => return Err(format!("no option `{name}` of `dh import`")),
                _ if request.file.is_none() => request.file = Some(argument.clone()),
                _ => return Err(format!("one file at a time: `{argument}` is too much")),
            }
        }
        request.format = format(from.as_deref(), request.file.as_deref())?;
        match (request.format, &request.nominal) {
            (Format::Calibration, None) => Err("a calibration needs the table of the arm: `--nominal arm.dh`".into()),
            (format, Some(_)) if format != Format::Calibration => Err("`--nominal` is for calibrations".into()),
            _ => Ok(request),
        }
    }

    /// The table from the text of the file; of a calibration, beside that of the nominal table.
    ///
    /// # Errors
    /// With the line of the file.
    pub fn run(&self, text: &str, nominal: &str) -> Result<Imported, Problem> {
        match self.format {
            Format::Urdf => from_urdf(text, &self.options),
            Format::Table => from_table(text, &self.options),
            Format::Toolbox => from_toolbox(text, &self.options),
            Format::Calibration => from_calibration(text, nominal, &self.options),
        }
    }
}

/// The formats: names for `--from`, and endings of files.
const FORMATS: [(Format, &[&str], &[&str]); 4] = [
    (Format::Urdf, &["urdf"], &["urdf", "xml", "xacro"]),
    (Format::Table, &["csv", "tsv", "markdown"], &["csv", "tsv", "md", "txt"]),
    (Format::Toolbox, &["toolbox"], &["m", "py"]),
    (Format::Calibration, &["calibration"], &["yaml", "yml", "conf"]),
];

/// The format by `--from`, or by the name of the file.
fn format(from: Option<&str>, file: Option<&str>) -> Result<Format, String> {
    let names = || FORMATS.iter().flat_map(|f| f.1).copied().collect::<Vec<_>>().join(", ");
    let extension = file.and_then(|f| Path::new(f).extension()).map(|e| e.to_string_lossy().to_lowercase());
    let found = match (from, extension.as_deref()) {
        (Some(name), _) => FORMATS.iter().find(|f| f.1.contains(&name)),
        (None, Some(ending)) => FORMATS.iter().find(|f| f.2.contains(&ending)),
        (None, None) => None,
    };
    match (found, from) {
        (Some(format), _) => Ok(format.0),
        (None, Some(name)) => Err(format!("no format `{name}`: one of {}", names())),
        (None, None) => Err(format!("say what the file is: `--from` with one of {}", names())),
    }
}

/// A name that a Rust type can have.
fn type_name(name: String) -> Result<String, String> {
    let fine = name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && name != "Self";
    if fine { Ok(name) } else { Err(format!("`{name}` is no name of a type: letters and digits, a letter first")) }
}
