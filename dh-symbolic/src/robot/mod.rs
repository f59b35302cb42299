//! The library's front door: a [`Robot`] read from the text of a table, and its kinematics as exact formulas.
//!
//! **In:** the text that stands between the braces of `dh_robot!`. **Out:** [`Formula`]s and [`Matrix`]es that can be printed,
//! differentiated, compared and evaluated; plans, notes, pages and code as text; errors that show the place in the text.
//!
//! What is public here, and what the crate root re-exports, is the crate's API. The modules behind it are public for the
//! workspace's own tests and examples only, and hidden from the documentation.
//!
//! **Never here:** tokens, algebra of its own.

mod compare;
mod error;
mod export;
mod formula;
mod matrix;
mod names;

pub use crate::verify::listing::{CheckedLine, Finding};
pub use compare::Comparison;
pub use error::{EvalError, Mistake, TableError};
pub use export::ExportOptions;
pub use formula::Formula;
pub use matrix::Matrix;

use crate::algebra::{Poly, Transform};
use crate::chain::Chain;
use crate::chain::table::{self, Parsed};
use crate::diagnostic::{Error, Errors, Place, lex};
use crate::kinematics::{self, Kinematics};
use crate::pipeline;
use crate::planner::Refusal;
use crate::program::{Forward, Inverse};
use crate::render::Language;
use crate::render::code::javascript;
#[cfg(feature = "cli")]
use crate::render::code::rust::Batches;
use crate::render::document::{Document, InversePlan, Options, notes, page};
use crate::verify::{self, Claims, check, listing};
use names::Names;
use std::fmt;
use std::sync::Arc;

/// A robot whose table has been read: the way to all that follows from it.
///
/// Cloning is cheap, and a robot can be sent to other threads.
///
/// ```
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let arm = dh_symbolic::Robot::parse(
///     "pub struct Planar;
///      convention = modified;
///      let l1: length;
///      let l2: length = 0.3m;
///      | alpha | a  | d | theta |
///      |-------|----|---|-------|
///      | 0     | 0  | 0 | q1    |
///      | 0     | l1 | 0 | q2    |
///      | 0     | l2 | 0 | 0     |",
/// )?;
/// let t = arm.transform(0, 3);
/// assert_eq!(t.entry(0, 3).to_string(), "l₁c₁ + l₂c₁₂");
/// assert_eq!(t.entry(0, 3).diff("q1"), -t.entry(1, 3));
///
/// // Numbers: `l2` has a nominal value in the table, `l1` has none.
/// let x = t.entry(0, 3).eval(&[("q1", 0.0), ("q2", 0.0), ("l1", 0.4)])?;
/// assert!((x - 0.7).abs() < 1e-15);
/// assert!(t.eval(&[("q1", 0.0), ("q2", 0.0)]).is_err());
///
/// // A line of a hand derivation.
/// arm.check("T(0,3).py = l1*s1 + l2*s12")?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Robot {
    arm: Arc<Names>,
    kinematics: Arc<Kinematics>,
    source: Arc<Source>,
    /// The first line of the table's doc comment.
    about: Option<Arc<str>>,
}

/// The text of a table, and what it is called in messages.
#[derive(Debug)]
struct Source {
    name: String,
    text: String,
}

impl Source {
    fn error(&self, errors: &Errors) -> TableError {
        TableError::new(errors, &self.text, &self.name)
    }

    fn parse(&self) -> Result<Parsed, TableError> {
        Ok(table::parse(lex(&self.text).map_err(|errors| self.error(&errors))?))
    }
}

impl Robot {
    /// Reads a table: what stands between the braces of `dh_robot!`.
    ///
    /// # Errors
    /// Everything that is wrong with it at once, each mistake with its place:
    ///
    /// ```
    /// let error = dh_symbolic::Robot::parse(
    ///     "pub struct Arm;
    /// convention = standard;
    /// | theta | d | a  | alpha |
    /// | q1    | 0 | l1 | 90    |",
    /// )
    /// .unwrap_err();
    /// assert_eq!(error.mistakes().len(), 2);
    /// assert_eq!((error.mistakes()[0].line, error.mistakes()[0].column), (4, 15));
    /// assert!(error.to_string().contains("4 | | q1    | 0 | l1 | 90    |\n  |               ^^\n"), "{error}");
    /// ```
    pub fn parse(text: &str) -> Result<Robot, TableError> {
        Robot::parse_file("table", text)
    }

    /// The same for the text of a file, whose name stands in the errors.
    ///
    /// # Errors
    /// As [`Robot::parse`].
    pub fn parse_file(name: &str, text: &str) -> Result<Robot, TableError> {
        let source = Source { name: name.to_string(), text: text.to_string() };
        let mut parsed = source.parse()?;
        let Some(spec) = parsed.spec.take().filter(|_| parsed.errors.is_empty()) else {
            return Err(source.error(&parsed.errors));
        };
        let chain = Chain::new(spec);
        let kinematics = Arc::new(Kinematics::new(&chain));
        let about = parsed.head.docs.first().map(|line| Arc::from(line.trim().trim_end_matches('.')));
        Ok(Robot { about, arm: Arc::new(Names::new(chain)), kinematics, source: Arc::new(source) })
    }

    /// The name of the type in the table.
    pub fn name(&self) -> &str {
        &self.arm.chain.name
    }

    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.arm.chain.dof()
    }

    /// Number of rows: frames are numbered from 0, before the first row, to this.
    pub fn rows(&self) -> usize {
        self.kinematics.len()
    }

    /// The joint variables `q1`, `q2` and so on, and the names of all lengths and angles: what [`Formula::diff`] and
    /// [`Formula::eval`] take. Numbers in cells have the name of their quantity: `a2`, `d4`.
    pub fn names(&self) -> Vec<&str> {
        self.arm.names().collect()
    }

    /// T(i, j): frame `j` seen from frame `i`, a 4x4 matrix without `base` and `tool`. For i > j it is the inverse of T(j, i).
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let t = puma.transform(0, 6);
    /// assert_eq!(t.entry(0, 3).to_string(), "c₁(a₂c₂ + a₃c₂₃ − d₄s₂₃) − d₃s₁");
    /// assert_eq!(t.entry(0, 3).latex(), r"c_1(a_2c_2 + a_3c_{23} - d_4s_{23}) - d_3s_1");
    /// assert_eq!(&puma.transform(0, 2) * &puma.transform(2, 6), t);
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    ///
    /// # Panics
    /// Where there is no such frame; see [`Robot::rows`], and [`Robot::get_transform`] which does not panic.
    #[track_caller]
    pub fn transform(&self, i: usize, j: usize) -> Matrix {
        match self.get_transform(i, j) {
            Some(t) => t,
            None => panic!("there is no T({i}, {j}): the last frame of {} is {}", self.name(), self.rows()),
        }
    }

    /// T(i, j); `None` where there is no such frame.
    pub fn get_transform(&self, i: usize, j: usize) -> Option<Matrix> {
        Some(self.of_transform(&self.kinematics.transform(i, j)?))
    }

    /// The pose of the tool in the base, a 4x4 matrix: base * T(0, n) * tool, what `forward` of the generated type computes.
    pub fn pose(&self) -> Matrix {
        self.of_transform(&self.kinematics.pose())
    }

    /// The constant transform before the first row, a 4x4 matrix.
    pub fn base(&self) -> Matrix {
        self.of_transform(self.kinematics.base())
    }

    /// The constant transform after the last row, a 4x4 matrix.
    pub fn tool(&self) -> Matrix {
        self.of_transform(self.kinematics.tool())
    }

    /// The geometric Jacobian, 6 rows and a column for each joint variable: linear velocity of the origin of the last frame (or
    /// tool), then angular velocity, both in the axes of the base.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let j = puma.jacobian();
    /// assert_eq!((j.rows(), j.columns()), (6, 6));
    /// assert_eq!(j.entry(0, 1), puma.pose().entry(0, 3).diff("q2"));
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    pub fn jacobian(&self) -> Matrix {
        let chain = &self.arm.chain;
        let columns = kinematics::jacobian(chain, &self.kinematics);
        let entry = |i: usize, actuator: usize| -> Poly {
            let column = |(linear, angular): &(_, _)| -> Poly {
                let list: &[Poly; 3] = if i < 3 { linear } else { angular };
                list[i % 3].clone()
            };
            let driven = columns.iter().zip(&chain.drive);
            driven.filter_map(|(c, row)| row.get(actuator).map(|k| &column(c) * k)).sum()
        };
        let rows = (0..6).map(|i| (0..chain.dof()).map(|k| entry(i, k)).collect()).collect();
        Matrix::new(&self.arm, rows)
    }

    /// The pose of the tool in numbers, by rows: radians and the table's unit in, the table's unit out.
    ///
    /// Names that the table gives a value need none here.
    ///
    /// ```
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let q = [("q1", 0.0), ("q2", 0.0), ("q3", 0.0), ("q4", 0.0), ("q5", 0.0), ("q6", 0.0)];
    /// let pose = puma.forward(&q)?;
    /// assert!((pose[0][3] - (0.4318 + 0.0203)).abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Names without a value, and names that the robot does not have.
    pub fn forward(&self, values: &[(&str, f64)]) -> Result<[[f64; 4]; 4], EvalError> {
        let pose = self.pose().eval(values)?;
        Ok(std::array::from_fn(|i| std::array::from_fn(|j| pose[i][j])))
    }

    /// Checks lines of a hand derivation, separated by `;`, in the notation of `prove { }` blocks.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// puma.check("T(1,3).px = a2*c2")?;
    /// let error = puma.check("T(1,3).px = a2*s2").unwrap_err();
    /// assert!(error.to_string().contains("`s2` should be `c2`"), "{error}");
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    ///
    /// # Errors
    /// Lines that are wrong, with the difference and a correction, and lines that are not understood.
    pub fn check(&self, claims: &str) -> Result<(), TableError> {
        let source = Source { name: "claim".to_string(), text: claims.to_string() };
        let tokens = lex(claims).map_err(|errors| source.error(&errors))?;
        let errors = pipeline::wrong_claims(&self.arm.chain, &Claims::from_tokens(tokens));
        if errors.is_empty() { Ok(()) } else { Err(source.error(&errors)) }
    }

    /// The claims of the table's own `prove { }` blocks, each with its verdict; `None` where it has none.
    pub fn check_proofs(&self) -> Option<Checked> {
        let lines = self.source.parse().ok()?.claims;
        let claims = Claims::read(&lines);
        let verdicts = check::check(&self.arm.chain, &claims.derivation);
        let checked = Checked {
            fine: verdicts.is_fine(),
            wrong: verdicts.wrong() > 0,
            lines: listing::claim_lines(&verdicts, &claims),
            text: listing::check_text(&verdicts, &claims),
        };
        (!lines.is_empty()).then_some(checked)
    }

    /// The formulas of a document (LaTeX, Markdown or plain text) about this robot, line by line.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let checked = puma.check_document(r"The wrist is at ${}^0p_x = c_1(a_2 c_2 + a_3 c_{23} - d_4 s_{23}) - d_3 s_1$.");
    /// assert!(checked.is_fine(), "{checked}");
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    pub fn check_document(&self, text: &str) -> Checked {
        let (paper, verdicts) = verify::judge(&self.arm.chain, text);
        Checked {
            fine: verdicts.is_fine(),
            wrong: verdicts.wrong() > 0,
            lines: listing::document_lines(&verdicts, &paper),
            text: listing::document_text(&verdicts, &paper),
        }
    }

    /// How the arm is inverted, step by step.
    ///
    /// ```
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let plan = puma.plan()?;
    /// assert_eq!((plan.steps().len(), plan.max_solutions()), (6, 8));
    /// println!("{plan}");
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    ///
    /// # Errors
    /// Why there is no inverse in closed form, at the cells that break the structure.
    pub fn plan(&self) -> Result<InversePlan, TableError> {
        let chain = &self.arm.chain;
        InversePlan::new(chain).map_err(|refusal| self.refused(&refusal))
    }

    /// What the robot is, for crates of this workspace.
    #[doc(hidden)]
    pub fn chain(&self) -> &Chain {
        &self.arm.chain
    }

    /// The proven programs of pose, frames and Jacobian, for crates of this workspace.
    ///
    /// # Errors
    /// As [`Robot::page`].
    #[doc(hidden)]
    pub fn forward_programs(&self) -> Result<Forward, TableError> {
        if self.arm.chain.is_part() {
            let text = "poses that the program sets, and calibrations, are for `dh_robot!` and `dh export --to c`";
            return Err(self.source.error(&Errors::from(Error::new(Place::call_site(), text))));
        }
        Forward::derive(&self.arm.chain).map_err(|difference| self.defect(&difference))
    }

    /// The program of the inverse, for crates of this workspace; `None` where the table asks for none.
    ///
    /// # Errors
    /// Why there is no inverse in closed form, as [`Robot::plan`] says it.
    #[doc(hidden)]
    pub fn inverse_program(&self) -> Result<Option<Inverse>, TableError> {
        let chain = &self.arm.chain;
        let inverse = chain.settings.ik.then(|| Inverse::of(chain)).transpose();
        inverse.map_err(|refusal| self.refused(&refusal))
    }

    /// Does the macro accept the table? All that it would refuse, but for wrong lines of `prove { }` blocks:
    /// [`Robot::check_proofs`] tells about these.
    ///
    /// # Errors
    /// The errors of the macro.
    pub fn verify(&self) -> Result<(), TableError> {
        let parsed = self.source.parse()?;
        pipeline::programs(&self.arm.chain, &parsed).map(|_| ()).map_err(|errors| self.source.error(&errors))
    }

    /// Lecture notes, with the first line of the table's doc comment below the title: table, link transforms, products, Jacobian, singularities, inverse, a worked example, as the options say.
    ///
    /// ```
    /// use dh_symbolic::{Format, NotesOptions};
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let notes = puma.notes(&NotesOptions::default());
    /// assert!(notes.print(Format::Latex).starts_with(r"\documentclass"));
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    ///
    /// Values in the options that do not fit the robot are passed over: [`Robot::check_options`] finds them.
    pub fn notes(&self, options: &Options) -> Document {
        match (&options.subtitle, &self.about) {
            // a line in Latin letters only is no subtitle of a Chinese note
            (None, Some(about)) if options.language == Language::English || !about.is_ascii() => {
                notes(&self.arm.chain, &Options { subtitle: Some(about.to_string()), ..options.clone() })
            }
            _ => notes(&self.arm.chain, options),
        }
    }

    /// Do joint names, values, motions and frames of these options fit the robot?
    ///
    /// # Errors
    /// What is wrong with the first that does not.
    pub fn check_options(&self, options: &Options) -> Result<(), String> {
        options.check(&self.arm.chain)
    }

    /// An interactive page, one HTML file that needs no network: sliders, the drawn arm, its pose, its formulas, all solutions.
    ///
    /// # Errors
    /// A defect of this crate: a program that differs from the product of the link transforms.
    pub fn page(&self, options: &Options) -> Result<String, TableError> {
        page(&self.arm.chain, options).map_err(|difference| self.defect(&difference))
    }

    /// A script that defines a class `Arm` with `forward`, `frames`, `jacobian` and `inverse`.
    ///
    /// # Errors
    /// As [`Robot::page`].
    pub fn javascript(&self) -> Result<String, TableError> {
        javascript::script(&self.arm.chain).map_err(|difference| self.defect(&difference))
    }

    /// The Rust code that `dh_robot!` leaves behind, formatted.
    ///
    /// # Errors
    /// Those of the macro: wrong lines of `prove { }` blocks, and why there is no inverse.
    #[cfg(feature = "cli")]
    pub fn expand(&self) -> Result<String, TableError> {
        let (items, errors) = pipeline::compile_table(&self.source.parse()?, Batches::OneByOne);
        if !errors.is_empty() {
            return Err(self.source.error(&errors));
        }
        crate::render::code::rust::pretty(items).map_err(|e| TableError::defect(&e.to_string()))
    }

    fn refused(&self, refusal: &Refusal) -> TableError {
        match self.source.parse() {
            Ok(parsed) => self.source.error(&pipeline::refused(&self.arm.chain, refusal, &parsed)),
            Err(error) => error,
        }
    }

    fn defect(&self, difference: &crate::program::Disproof) -> TableError {
        TableError::defect(&difference.to_string())
    }

    fn of_transform(&self, t: &Transform) -> Matrix {
        Matrix::new(&self.arm, (0..4).map(|i| (0..4).map(|j| t.entry(i, j)).collect()).collect())
    }
}

impl fmt::Debug for Robot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Robot").field(&self.name()).finish()
    }
}

/// Lines of a derivation with their verdicts, to be printed.
#[derive(Clone, Debug)]
#[must_use]
pub struct Checked {
    fine: bool,
    wrong: bool,
    lines: Vec<CheckedLine>,
    text: String,
}

impl Checked {
    /// The lines in the order of the text, those of prose left out.
    pub fn lines(&self) -> &[CheckedLine] {
        &self.lines
    }

    /// Is a line wrong? (One that is not understood is not.)
    pub fn has_wrong(&self) -> bool {
        self.wrong
    }

    /// Is no line wrong or not understood?
    pub fn is_fine(&self) -> bool {
        self.fine
    }
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
