//! `dh export`: a folder that makes a robot usable from another language.

use crate::commands::{drawn, robot};
use crate::output::{Answer, WRONG, write_folder};
use dh_symbolic::ExportOptions;
use lexopt::{Arg, Parser, ValueExt};
use std::ffi::OsString;
use std::path::Path;

const USAGE: &str = "\
dh export [FILE] --to c --out DIR: C and C++ interfaces of a robot

Writes a folder that stands alone: a small Rust crate with the table, a C99 and a C++17 header, a CMake package, example programs, and a
README.md with the commands. FILE holds the body of dh_robot!; without it, or with -, standard input is read.

  --to c            the language (C and C++)
  --out DIR         the folder: new or empty
  --force           write into a folder that is not empty: files of the same names are replaced, others stay
  --name NAME       the library's name, which begins the names of all functions; by default the table's in small letters
  --dh-robot PATH   the folder of the crate dh-robot, for those who have its source; by default cargo takes it from the registry
";

/// The command line, taken apart.
#[derive(Default)]
struct Request {
    file: Option<String>,
    to: Option<String>,
    out: Option<String>,
    force: bool,
    options: ExportOptions,
}

/// Reads the arguments behind `export`, and writes the folder.
pub(crate) fn run(arguments: impl Iterator<Item = OsString>) -> Answer {
    Request::read(arguments).and_then(export).unwrap_or_else(|answer| answer)
}

/// Bad usage.
fn usage(message: &str) -> Answer {
    Answer::error(&format!("{message} (`dh export --help`)"))
}

impl Request {
    fn read(arguments: impl Iterator<Item = OsString>) -> Result<Request, Answer> {
        let mut parser = Parser::from_args(arguments);
        let mut request = Request::default();
        let wrong = |e: lexopt::Error| usage(&e.to_string());
        while let Some(argument) = parser.next().map_err(wrong)? {
            let place = match argument {
                Arg::Short('h') | Arg::Long("help") => return Err(Answer::good(USAGE.to_string())),
                Arg::Long("force") => {
                    request.force = true;
                    continue;
                }
                Arg::Value(file) if request.file.is_none() => {
                    request.file = Some(file.string().map_err(wrong)?);
                    continue;
                }
                Arg::Long("to") => &mut request.to,
                Arg::Short('o') | Arg::Long("out") => &mut request.out,
                Arg::Long("name") => &mut request.options.name,
                Arg::Long("dh-robot") => &mut request.options.dh_robot,
                other => return Err(wrong(other.unexpected())),
            };
            *place = Some(parser.value().and_then(ValueExt::string).map_err(wrong)?);
        }
        Ok(request)
    }
}

fn export(mut request: Request) -> Result<Answer, Answer> {
    match request.to.as_deref() {
        Some("c") => {}
        Some(other) => return Err(usage(&format!("`dh export` has no `--to {other}`: c"))),
        None => return Err(usage("which language? `--to c`")),
    }
    let Some(out) = request.out else { return Err(usage("which folder? `--out DIR`")) };
    if let Some(path) = &mut request.options.dh_robot {
        let whole = Path::new(path).canonicalize().ok().filter(|folder| folder.join("Cargo.toml").is_file());
        let Some(whole) = whole else { return Err(usage(&format!("`{path}` is not the folder of a crate"))) };
        *path = whole.to_string_lossy().into_owned();
    }
    let robot = robot(request.file.as_ref())?;
    let files = robot.export_c(&request.options).map_err(|error| {
        let claims = robot.check_proofs().is_none_or(|checked| checked.is_fine());
        let bad = drawn(error);
        if claims { bad } else { Answer { code: WRONG, ..bad } }
    })?;
    write_folder(Path::new(&out), &files, request.force)
        .map_err(|message| Answer::error(&format!("{out}: {message}")))?;
    Ok(Answer {
        err: format!("{out}: {} files; its README.md says how to build them\n", files.len()),
        ..Answer::default()
    })
}
