//! Reads settings: `convention = modified;` and the others.

use super::number;
use super::spelling::{shown, suggestion};
use super::statements::SettingLine;
use super::text;
use crate::chain::{Convention, Scalar, Settings, Task};
use crate::diagnostic::{Error, Errors, Place};
use proc_macro2::TokenTree;

const NAMES: [&str; 9] = ["convention", "unit", "scalar", "base", "tool", "task", "redundant", "ik", "prove"];

/// More settings than this would only cost time.
const MOST: usize = 32;

/// What the lines say, before the names in them are looked up.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    pub(super) convention: Option<Convention>,
    /// Whether `convention` was written, rightly or wrongly.
    pub(super) has_convention: bool,
    /// `redundant`: the words and their places.
    pub(super) redundant: Vec<(String, Place)>,
    /// The rest, complete but for `redundant`.
    pub(super) settings: Settings,
}

/// Reads them; the later of two of one name is an error.
pub(super) fn read(list: &[SettingLine], errors: &mut Errors) -> Lines {
    let mut lines = Lines::default();
    let s = &mut lines.settings;
    if let Some(setting) = list.get(MOST) {
        errors.push(Error::new(Place::at(setting.name.span()), "there are not so many settings"));
    }
    for (i, setting) in list.iter().take(MOST).enumerate() {
        let name = setting.name.to_string();
        let at = Place::at(setting.name.span());
        if let Some(first) = list.iter().take(i).find(|f| f.name == setting.name) {
            let related = Place::at(first.name.span());
            errors.push(Error::new(at, format!("`{name}` is set twice")).related(related, "first set here"));
            continue;
        }
        if setting.value.is_empty() && NAMES.contains(&name.as_str()) {
            errors.push(Error::new(at, format!("`{name}` has no value")));
            lines.has_convention |= name == "convention";
            continue;
        }
        let word = text::of(&setting.value);
        let choice = Choice { name: &name, word: &word, place: setting.place };
        match name.as_str() {
            "convention" => {
                lines.has_convention = true;
                let all = [("standard", Convention::Standard), ("modified", Convention::Modified)];
                lines.convention = errors.take(choice.convention(&all));
            }
            "unit" => match number::length_unit(&word) {
                Some(unit) => s.unit = unit,
                None => errors.push(number::unknown_length_unit(&word, setting.place)),
            },
            "scalar" => {
                s.scalar = errors.take(choice.of(&[("f64", Scalar::F64), ("f32", Scalar::F32)])).unwrap_or(s.scalar);
            }
            "task" => {
                let all = [
                    ("pose", Task::Pose),
                    ("position", Task::Position),
                    ("planar", Task::Planar),
                    ("axis", Task::Axis),
                ];
                s.task = errors.take(choice.of(&all)).unwrap_or(s.task);
            }
            "redundant" => lines.redundant = words(setting),
            "ik" => s.ik = errors.take(choice.of(&[("none", false)])).unwrap_or(true),
            "base" | "tool" => {}
            "calibrated" => {
                let error = Error::new(at, "deviations of the rows as a field are not supported");
                errors.push(error.help(
                    "write the true rows into the table: `dh import calibration.yaml --nominal arm.dh` prints them",
                ));
            }
            "urdf" | "chain" => {
                let text =
                    format!("`{name}` needs the feature `urdf` of dh-robot, and in files the command `dh import`");
                errors.push(Error::new(at, text));
            }
            _ => {
                let error = Error::new(at, format!("unknown setting `{}`", shown(&name)));
                errors.push(match suggestion(&name, NAMES) {
                    Some("prove") => error.help("claims are written `prove { ... }`"),
                    Some(near) => error.help(format!("did you mean `{near}`?")),
                    None => error.help(format!("settings: {}; a name is declared with `let`", NAMES[..9].join(", "))),
                });
            }
        }
    }
    lines
}

/// The words of a list with commas.
fn words(setting: &SettingLine) -> Vec<(String, Place)> {
    let comma = |t: &TokenTree| matches!(t, TokenTree::Punct(p) if p.as_char() == ',');
    let parts = setting.value.split(comma).take(MOST);
    parts.map(|tokens| (text::of(tokens), Place::of_all(tokens).unwrap_or(setting.place))).collect()
}

struct Choice<'a> {
    name: &'a str,
    word: &'a str,
    place: Place,
}

impl Choice<'_> {
    fn of<T: Copy>(&self, all: &[(&str, T)]) -> Result<T, Error> {
        if let Some((_, value)) = all.iter().find(|(word, _)| *word == self.word) {
            return Ok(*value);
        }
        let words: Vec<String> = all.iter().map(|(w, _)| format!("`{w}`")).collect();
        let text = match words.as_slice() {
            [only] => format!("`{}` can only be set to {only}", self.name),
            list => format!("`{}` is one of {}", self.name, list.join(", ")),
        };
        let error = Error::new(self.place, text);
        Err(match suggestion(self.word, all.iter().map(|(w, _)| *w)) {
            Some(near) => error.help(format!("did you mean `{near}`?")),
            None => error,
        })
    }

    fn convention(&self, all: &[(&str, Convention)]) -> Result<Convention, Error> {
        self.of(all).map_err(|e| match self.word.to_lowercase().as_str() {
            "craig" | "proximal" | "mdh" => e.help("Craig's convention is `modified`"),
            "classic" | "distal" | "dh" | "paul" => {
                e.help("the convention of Denavit, Hartenberg and Paul is `standard`")
            }
            _ => e,
        })
    }
}
