//! The commands of `dh`, each a thin call of the library.

use crate::arguments::Request;
use crate::output::{Answer, WRONG, read, write_whole};
use dh_symbolic::{Comparison, Document, Format, Robot, TableError, mdbook};
use std::path::Path;

/// Runs a command.
pub(crate) fn run(request: &Request) -> Answer {
    let answer = match request.command.as_str() {
        "mdbook" => book(&request.files),
        "compare" => compare(request),
        command => robot(request.files.first()).and_then(|robot| match (command, request.format.as_str()) {
            ("page", _) | ("notes", "page") => robot.page(&request.options).map(Answer::good).map_err(drawn),
            ("notes", format) => notes(&robot, request, format),
            ("plan", format) => {
                let plan = robot.plan().map_err(drawn)?;
                Ok(Answer::good(match named(format) {
                    Some(format) => plan.document(request.options.language).print(format),
                    None => plan.mermaid(request.options.language),
                }))
            }
            ("expand", "javascript") => robot.javascript().map(Answer::good).map_err(drawn),
            ("expand", _) => expand(&robot),
            _ => check(&robot, request.files.get(1..).unwrap_or_default()),
        }),
    };
    let mut answer = answer.unwrap_or_else(|bad| bad);
    answer.to.clone_from(&request.out);
    answer
}

/// The robot of a file.
pub(crate) fn robot(file: Option<&String>) -> Result<Robot, Answer> {
    let file = file.map(String::as_str);
    let text = read(file)?;
    Robot::parse_file(file.filter(|f| *f != "-").unwrap_or("standard input"), &text).map_err(drawn)
}

/// Errors of a table, drawn.
pub(crate) fn drawn(error: TableError) -> Answer {
    Answer::bad(error.to_string())
}

/// A format that documents are printed in.
fn named(format: &str) -> Option<Format> {
    Format::ALL.iter().find(|f| f.0 == format).map(|f| f.1)
}

fn notes(robot: &Robot, request: &Request, format: &str) -> Result<Answer, Answer> {
    robot.check_options(&request.options).map_err(|message| Answer::error(&message))?;
    let note = robot.notes(&request.options);
    match (named(format).unwrap_or(Format::Text), &request.out) {
        (Format::Markdown, Some(path)) => linked(&note, Path::new(path)),
        (format, _) => Ok(Answer::good(note.print(format))),
    }
}

/// Markdown for a file, with its figures in files beside it.
fn linked(note: &Document, path: &Path) -> Result<Answer, Answer> {
    let stem = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    let (text, files) = note.linked_markdown(&stem);
    for (name, text) in files {
        let place = path.with_file_name(name);
        write_whole(&place, &text).map_err(|e| Answer::error(&format!("{}: {e}", place.display())))?;
    }
    Ok(Answer::good(text))
}

/// The table as the macro sees it, the claims of its `prove` blocks, and those of documents.
fn check(robot: &Robot, documents: &[String]) -> Result<Answer, Answer> {
    let texts = documents.iter().map(|path| read(Some(path))).collect::<Result<Vec<_>, _>>()?;
    robot.verify().map_err(drawn)?;
    let mut out = format!("{}: {} rows, {} joints, in order\n", robot.name(), robot.rows(), robot.dof());
    let mut fine = true;
    if let Some(checked) = robot.check_proofs() {
        out.push_str(&checked.to_string());
        fine &= checked.is_fine();
    }
    for (path, text) in documents.iter().zip(&texts) {
        let checked = robot.check_document(text);
        out.push_str(&format!("\n{path}\n{checked}"));
        fine &= !checked.has_wrong();
    }
    Ok(Answer { out, code: if fine { 0 } else { WRONG }, ..Answer::default() })
}

fn expand(robot: &Robot) -> Result<Answer, Answer> {
    robot.expand().map(Answer::good).map_err(|error| {
        let claims = robot.check_proofs().is_none_or(|checked| checked.is_fine());
        let bad = drawn(error);
        if claims { bad } else { Answer { code: WRONG, ..bad } }
    })
}

/// Whether two tables are one arm.
fn compare(request: &Request) -> Result<Answer, Answer> {
    let [a, b] = request.files.as_slice() else {
        return Err(Answer::usage("`dh compare` takes two tables"));
    };
    let comparison = Comparison::new(&robot(Some(a))?, &robot(Some(b))?);
    Ok(Answer { out: comparison.to_string(), code: if comparison.same() { 0 } else { WRONG }, ..Answer::default() })
}

/// What mdBook asks a preprocessor: whether it serves a renderer, or for the book.
fn book(arguments: &[String]) -> Result<Answer, Answer> {
    match arguments {
        [] => mdbook::preprocess(&read(None)?).map(Answer::good).map_err(Answer::bad),
        [word, renderer] if word == "supports" => {
            let served = mdbook::RENDERERS.contains(&renderer.as_str());
            Ok(Answer { code: u8::from(!served), ..Answer::default() })
        }
        _ => Err(Answer::error("`dh mdbook` reads the book from standard input; or `dh mdbook supports RENDERER`")),
    }
}
