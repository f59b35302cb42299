//! Parses the command line: command, files, options; combinations that make no sense are one-line errors.

use crate::output::Answer;
use dh_symbolic::NotesOptions;
use lexopt::{Arg, Parser, ValueExt};
use std::ffi::OsString;

const USAGE: &str = "\
dh: kinematics from a Denavit-Hartenberg table

  dh notes   [FILE]   lecture notes
  dh page    [FILE]   an interactive page: sliders, drawing, pose, solutions (one HTML file; also notes --to page)
  dh check   [FILE] [DOCUMENT...]
                      the table, the claims of its prove blocks, and the formulas of documents
                      (LaTeX, Markdown, plain text) line by line: proven, wrong, not understood
  dh plan    [FILE]   the steps of the inverse kinematics
  dh expand  [FILE]   the Rust code that dh_robot! leaves behind
  dh compare A B      are two tables the same arm? If so, the constant transforms between their frames
  dh import  FILE     a table from URDF, CSV, toolbox scripts, calibrations (`dh import --help`)
  dh export  FILE     a folder with C and C++ interfaces of the arm (`dh export --help`)
  dh mdbook           preprocessor for mdBook: fenced `dh` blocks become notes

  --to text|latex|markdown|typst|html   format of notes and plans; plans also: mermaid; notes also: page;
                                        expand: rust, javascript
  --lang en|zh                          their language
  --out PATH                            write there, not to standard output; the file appears when it is complete

for notes:
{notes}
FILE holds the body of dh_robot!; without it, or with -, standard input is read.
Exit code: 0, 1 (a claim is wrong, one of the table's own not understood, or the arms differ), 2 (bad usage or table).
";

/// The commands, with the formats that each prints, its usual one first, and the most files that it reads.
const COMMANDS: [(&str, &[&str], usize); 7] = [
    ("notes", &["text", "latex", "markdown", "typst", "html", "page"], 1),
    ("page", &[], 1),
    ("check", &[], usize::MAX),
    ("plan", &["text", "latex", "markdown", "typst", "html", "mermaid"], 1),
    ("expand", &["rust", "javascript"], 1),
    ("compare", &[], 2),
    ("mdbook", &[], 2),
];

/// The command line, taken apart.
#[derive(Debug, Default)]
pub(crate) struct Request {
    /// What is to be done: one of the commands.
    pub(crate) command: String,
    /// The files in order.
    pub(crate) files: Vec<String>,
    /// The format; empty where the command has one only.
    pub(crate) format: String,
    /// How notes are written.
    pub(crate) options: NotesOptions,
    /// Where to write.
    pub(crate) out: Option<String>,
}

impl Request {
    /// Reads the arguments behind the program's name.
    ///
    /// # Errors
    /// What to answer where nothing is to be done: help, or what is wrong with the arguments.
    pub(crate) fn read(arguments: impl Iterator<Item = OsString>) -> Result<Request, Answer> {
        let mut parser = Parser::from_args(arguments);
        let (mut request, mut to, mut of_notes) = (Request::default(), None, None);
        let usage = |e: lexopt::Error| Answer::usage(&e.to_string());
        while let Some(argument) = parser.next().map_err(usage)? {
            let name = match argument {
                Arg::Value(word) => {
                    let word = word.string().map_err(usage)?;
                    match request.command.as_str() {
                        "" if word == "help" => return Err(Answer::good(help())),
                        "" => request.command = word,
                        _ => request.files.push(word),
                    }
                    continue;
                }
                Arg::Short('h') | Arg::Long("help") => return Err(Answer::good(help())),
                Arg::Short('V') | Arg::Long("version") => {
                    return Err(Answer::good(format!("dh {}\n", env!("CARGO_PKG_VERSION"))));
                }
                Arg::Short('o') => "--out".to_string(),
                Arg::Long(name) => format!("--{name}"),
                Arg::Short(letter) => format!("-{letter}"),
            };
            // Whether there is such an option is asked before its value is taken.
            if name != "--to" && name != "--out" && !NotesOptions::NAMES.contains(&name.as_str()) {
                return Err(Answer::usage(&format!("no option `{name}`")));
            }
            if NotesOptions::FLAGS.contains(&name.as_str()) {
                request.options.set(&name, "").map_err(|e| Answer::usage(&e))?;
                of_notes = Some(name);
                continue;
            }
            let value = parser.value().and_then(ValueExt::string);
            let value = value.map_err(|_| Answer::usage(&format!("`{name}` needs a value")))?;
            match name.as_str() {
                "--to" => to = Some(value),
                "--out" => request.out = Some(value),
                _ => {
                    request.options.set(&name, &value).map_err(|e| Answer::usage(&e))?;
                    if name != "--lang" {
                        of_notes = Some(name);
                    }
                }
            }
        }
        request.fit(to, of_notes).map_err(|message| Answer::usage(&message))
    }

    /// Do command, format, options and files go together?
    fn fit(mut self, to: Option<String>, of_notes: Option<String>) -> Result<Request, String> {
        if self.command.is_empty() {
            return Err(format!("which command? {}", COMMANDS.map(|c| c.0).join(", ")));
        }
        let command = &self.command;
        let known = COMMANDS.iter().find(|c| c.0 == command);
        let Some((_, formats, most)) = known else {
            return Err(format!("no command `{command}`: {}", COMMANDS.map(|c| c.0).join(", ")));
        };
        if let Some(name) = of_notes.filter(|_| command != "notes") {
            return Err(format!("`{name}` is for notes"));
        }
        if let Some(more) = self.files.get(*most) {
            return Err(format!("`dh {command}` does not read so many files: `{more}` is too much"));
        }
        self.format = match to {
            Some(to) if formats.contains(&to.as_str()) => to,
            Some(to) if formats.is_empty() => {
                return Err(format!("`dh {command}` has no `--to {to}`: it has one format"));
            }
            Some(to) => return Err(format!("`dh {command}` has no `--to {to}`: one of {}", formats.join(", "))),
            None => formats.first().map_or_else(String::new, |f| (*f).to_string()),
        };
        Ok(self)
    }
}

/// The help text.
fn help() -> String {
    USAGE.replace("{notes}", NotesOptions::HELP)
}
