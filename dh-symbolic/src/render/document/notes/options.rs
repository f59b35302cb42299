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
}

impl Part {
    /// All parts with their names on the command line, in the order of a note.
    pub const ALL: [(&'static str, Part); 9] = [
        ("table", Part::Table),
        ("figure", Part::Figure),
        ("links", Part::Links),
        ("forward", Part::Forward),
        ("jacobian", Part::Jacobian),
        ("singular", Part::Singular),
        ("workspace", Part::Workspace),
        ("inverse", Part::Inverse),
        ("example", Part::Example),
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
            digits: 4,
            terms: 1500,
            parts: Part::ALL.iter().map(|p| p.1).collect(),
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
    pub const NAMES: [&'static str; 14] = [
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
    ];

    /// What the command line of `dh notes` may say, for its help text.
    pub const HELP: &'static str = "  --parts table,links,forward,...    parts in this order: table figure links forward jacobian singular workspace inverse example
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
            "--parts" => self.parts = list().map(|t| choose(name, t, &Part::ALL)).collect::<Result<_, _>>()?,
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
