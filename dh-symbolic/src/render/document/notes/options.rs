//! How notes are written: language, width, parts, notation, which products, which example; read from a command line.

use crate::render::Language;
use crate::render::formula::style::{Style, Transforms};

/// A part of a note.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The table, the values of its parameters, the coupling of the actuators.
    Table,
    /// The arm drawn with its frames.
    Figure,
    /// Every link transform.
    Links,
    /// Partial products and the pose.
    Forward,
    /// The geometric Jacobian.
    Jacobian,
    /// The determinant of the Jacobian and what its factors mean.
    Singular,
    /// What the arm can reach: the poses of arms with few joints, the workspace of planar arms.
    Workspace,
    /// The derivation of the inverse kinematics.
    Inverse,
    /// A pose and all its joint vectors.
    Example,
    /// How the frames are found on the arm: axes, common normals, choices.
    Frames,
    /// The link transform from four elementary motions.
    Elementary,
    /// The same arm in the other convention, and what joins the frames of both.
    Conventions,
    /// Direction cosines and homogeneous coordinates.
    Directions,
    /// Actuator, joint and Cartesian space, and the velocities between them.
    Spaces,
    /// The planar arm by geometry and by algebra.
    Planar,
    /// Pieper's method, for arms whose last three axes meet, and Z-Y-Z Euler angles.
    Pieper,
    /// How many solutions, how they belong together, which one is taken.
    Solutions,
    /// Repeatability and accuracy.
    Accuracy,
    /// How the pose changes with the cells of the table, and which deviations measured poses can tell apart.
    Calibration,
    /// The methods that solve equations in sines and cosines, each once.
    Methods,
}

impl Part {
    /// All parts with their names on the command line.
    pub const ALL: [(&'static str, Part); 20] = [
        ("table", Part::Table),
        ("figure", Part::Figure),
        ("links", Part::Links),
        ("forward", Part::Forward),
        ("jacobian", Part::Jacobian),
        ("singular", Part::Singular),
        ("workspace", Part::Workspace),
        ("inverse", Part::Inverse),
        ("example", Part::Example),
        ("frames", Part::Frames),
        ("elementary", Part::Elementary),
        ("conventions", Part::Conventions),
        ("directions", Part::Directions),
        ("spaces", Part::Spaces),
        ("planar", Part::Planar),
        ("pieper", Part::Pieper),
        ("solutions", Part::Solutions),
        ("accuracy", Part::Accuracy),
        ("calibration", Part::Calibration),
        ("methods", Part::Methods),
    ];

    /// The chapter as it is taught, in its order: `--parts chapter`. Parts that do not fit an arm are empty.
    pub const CHAPTER: [Part; 19] = [
        Part::Directions,
        Part::Frames,
        Part::Table,
        Part::Figure,
        Part::Elementary,
        Part::Links,
        Part::Forward,
        Part::Conventions,
        Part::Spaces,
        Part::Jacobian,
        Part::Singular,
        Part::Workspace,
        Part::Inverse,
        Part::Example,
        Part::Planar,
        Part::Pieper,
        Part::Solutions,
        Part::Accuracy,
        Part::Methods,
    ];

    /// The parts of a note that names none, in their order.
    pub const NOTE: [Part; 9] = [
        Part::Table,
        Part::Figure,
        Part::Links,
        Part::Forward,
        Part::Jacobian,
        Part::Singular,
        Part::Workspace,
        Part::Inverse,
        Part::Example,
    ];
}

/// How notes are written.
#[derive(Clone, Debug)]
pub struct Options {
    /// Language of the prose.
    pub language: Language,
    /// Glyphs that fit on a line: longer formulas are cut, wider matrices become lists of entries.
    pub width: usize,
    /// The title instead of "Kinematics of ...".
    pub title: Option<String>,
    /// The line below the title, the first of the table's doc comment at `Robot::notes`.
    pub subtitle: Option<String>,
    /// Whether the note is a piece of another LaTeX or Typst document: without preamble and title.
    pub fragment: bool,
    /// Whether each step of the inverse says why its formulas follow.
    pub why: bool,
    /// Digits of the numbers of an example.
    pub digits: usize,
    /// Products with more terms than this, written out, are left as products.
    pub terms: usize,
    /// Parts, in the order in which they are printed.
    pub parts: Vec<Part>,
    /// Notation.
    pub style: Style,
    /// Products T(i, j) to form, in this order; empty: those that a textbook forms.
    pub products: Vec<(usize, usize)>,
    /// Joint values of the example, `q1 = 20deg, q2 = 0.1m`; joints left out have a value of their own. With a pose: the values
    /// that the caller chooses.
    pub at: Option<String>,
    /// The pose of the example as a product of motions, `tx(830mm) * rz(35deg)`, instead of joint values.
    pub pose: Option<String>,
    /// The joint values to which the closest solution is sought, written like `at`.
    pub near: Option<String>,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            language: Language::English,
            width: 64,
            title: None,
            subtitle: None,
            fragment: false,
            why: false,
            digits: 4,
            terms: 1500,
            parts: Part::NOTE.to_vec(),
            style: Style::default(),
            products: Vec::new(),
            at: None,
            pose: None,
            near: None,
        }
    }
}

/// One of several words.
fn choose<T: Copy>(name: &str, value: &str, words: &[(&str, T)]) -> Result<T, String> {
    words.iter().find(|w| w.0 == value).map(|w| w.1).ok_or_else(|| {
        let names: Vec<&str> = words.iter().map(|w| w.0).collect();
        format!("`{name}` knows no `{value}`: one of {}", names.join(", "))
    })
}

/// Is this fit to be a name in a formula?
fn is_name(text: &str) -> bool {
    text.starts_with(char::is_alphabetic) && text.chars().all(|c| c.is_alphanumeric() || c == '_')
}

impl Options {
    /// Names of the options that [`Options::set`] takes.
    pub const NAMES: [&'static str; 16] = [
        "--lang",
        "--parts",
        "--products",
        "--sines",
        "--transforms",
        "--angles",
        "--joints",
        "--frames",
        "--at",
        "--pose",
        "--near",
        "--width",
        "--digits",
        "--title",
        "--why",
        "--fragment",
    ];

    /// Those of them that take no value.
    pub const FLAGS: [&'static str; 2] = ["--why", "--fragment"];

    /// What the command line of `dh notes` may say, for its help text.
    pub const HELP: &'static str = "  --parts table,links,forward,...    parts in this order: table figure links forward jacobian singular workspace inverse example
                                     (`note`), frames elementary conventions directions spaces planar pieper solutions
                                     accuracy methods (`chapter`: all so far, as they are taught), calibration
  --products 0-3,3-6,0-6             which products T(i, j) to form, in this order
  --sines short|long                 c23 or cos(theta2 + theta3)
  --transforms leading|trailing|products   indices before T, behind T, or A1 A2
  --angles degrees|radians           unit of angles
  --joints theta                     what turning joints are called: theta, q, phi, ...
  --frames 0=B,6=W,b=S,e=C           names of frames (b: base, e: tool)
  --at \"q1 = 20deg, q3 = 0.1m\"       joint values of the worked example
  --pose \"tx(830mm) * rz(35deg)\"     its pose, instead of joint values
  --near \"q1 = 0, q2 = 90deg\"        which solution is closest to these
  --width 64                         glyphs on a line
  --digits 4                         digits of the numbers of the worked example
  --title \"Exercise 3\"             the title instead of the robot's name
  --why                              why the formulas of each step of the inverse follow from its equations
  --fragment                         LaTeX for \\input, Typst for #include: without preamble and title
";

    /// Takes an option of the command line; false where this is none of the notes'.
    ///
    /// # Errors
    /// What is wrong with the value.
    pub fn set(&mut self, name: &str, value: &str) -> Result<bool, String> {
        let list = || value.split(',').map(str::trim).filter(|t| !t.is_empty());
        match name {
            "--lang" => {
                self.language = choose(name, value, &[("en", Language::English), ("zh", Language::Chinese)])?;
            }
            "--parts" => {
                let part = |t: &str| match t {
                    "chapter" => Ok(Part::CHAPTER.to_vec()),
                    "note" => Ok(Part::NOTE.to_vec()),
                    t => choose(name, t, &Part::ALL).map(|p| vec![p]),
                };
                self.parts = list().map(part).collect::<Result<Vec<_>, _>>()?.concat();
            }
            "--products" => {
                let product = |t: &str| {
                    let ends = t.split_once('-').and_then(|(i, j)| Some((i.parse().ok()?, j.parse().ok()?)));
                    ends.filter(|(i, j): &(usize, usize)| i < j)
                        .ok_or_else(|| format!("`{name}` takes products such as 0-3, not `{t}`"))
                };
                self.products = list().map(product).collect::<Result<_, _>>()?;
            }
            "--sines" => self.style.long_sines = choose(name, value, &[("short", false), ("long", true)])?,
            "--transforms" => {
                let words = [
                    ("leading", Transforms::Leading),
                    ("trailing", Transforms::Trailing),
                    ("products", Transforms::Products),
                ];
                self.style.transforms = choose(name, value, &words)?;
            }
            "--angles" => self.style.radians = choose(name, value, &[("degrees", false), ("radians", true)])?,
            "--joints" => {
                if !is_name(value) || value.contains(|c: char| c.is_ascii_digit() || c == '_') {
                    return Err(format!("`{name}` takes a letter or word without index, not `{value}`"));
                }
                self.style.joints = Some(value.to_string());
            }
            "--frames" => {
                let frame = |t: &str| {
                    let (key, called) = t.split_once('=').map(|(a, b)| (a.trim(), b.trim())).unwrap_or((t, ""));
                    let known = matches!(key, "b" | "e") || key.parse::<usize>().is_ok();
                    let fine = known && is_name(called);
                    let error = || format!("`{name}` takes names such as 0=B or e=C, not `{t}`");
                    fine.then(|| (key.to_string(), called.to_string())).ok_or_else(error)
                };
                self.style.frames = list().map(frame).collect::<Result<_, _>>()?;
            }
            "--at" => self.at = Some(value.to_string()),
            "--pose" => self.pose = Some(value.to_string()),
            "--near" => self.near = Some(value.to_string()),
            "--width" => {
                let width = value.parse().ok().filter(|w| (20..=400).contains(w));
                self.width = width.ok_or_else(|| format!("`{name}` takes a number from 20 to 400, not `{value}`"))?;
            }
            "--why" => self.why = true,
            "--fragment" => self.fragment = true,
            "--title" => self.title = Some(value.to_string()),
            "--digits" => {
                let digits = value.parse().ok().filter(|n| (3..=14).contains(n));
                self.digits = digits.ok_or_else(|| format!("`{name}` takes a number from 3 to 14, not `{value}`"))?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_command_line() {
        let mut o = Options::default();
        for (name, value) in [
            ("--lang", "zh"),
            ("--parts", "inverse, table"),
            ("--products", "0-3,3-6"),
            ("--sines", "long"),
            ("--transforms", "trailing"),
            ("--angles", "radians"),
            ("--joints", "phi"),
            ("--frames", "0=B,e=C"),
        ] {
            assert_eq!(o.set(name, value), Ok(true), "{name}");
        }
        assert_eq!(o.parts, [Part::Inverse, Part::Table]);
        assert_eq!((o.products, o.style.frames.len()), (vec![(0, 3), (3, 6)], 2));
        assert!(o.style.long_sines && o.style.radians);
        let mut o = Options::default();
        assert_eq!(o.set("--parts", "chapter"), Ok(true));
        assert!(Part::ALL.iter().all(|p| o.parts.contains(&p.1) || p.1 == Part::Calibration));
        assert_eq!(o.set("--to", "html"), Ok(false));
        assert!(Options::NAMES.iter().all(|n| o.set(n, "") != Ok(false)));
        for (name, value) in [
            ("--parts", "tables"),
            ("--products", "3-0"),
            ("--products", "3"),
            ("--sines", "c"),
            ("--joints", "q1"),
            ("--frames", "0="),
            ("--width", "3"),
            ("--digits", "1"),
        ] {
            assert!(o.set(name, value).is_err(), "{name} {value}");
        }
    }
}
