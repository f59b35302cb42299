//! `dh import`: a table from another description of an arm.

use crate::output::{Answer, read};
use dh_symbolic::import::command::{HELP, Request};
use std::ffi::OsString;

/// Reads the arguments behind `import`, and the file.
pub(crate) fn run(arguments: impl Iterator<Item = OsString>) -> Answer {
    let arguments: Vec<String> = arguments.map(|a| a.to_string_lossy().into_owned()).collect();
    if arguments.iter().any(|a| a == "--help" || a == "-h") {
        return Answer::good(HELP.to_string());
    }
    import(&arguments).unwrap_or_else(|bad| bad)
}

fn import(arguments: &[String]) -> Result<Answer, Answer> {
    let request =
        Request::read(arguments).map_err(|message| Answer::error(&format!("{message} (`dh import --help`)")))?;
    let text = read(request.file.as_deref())?;
    let name = request.file.as_deref().filter(|f| *f != "-").unwrap_or("standard input");
    let nominal = request.nominal.as_deref().map(|file| read(Some(file))).transpose()?.unwrap_or_default();
    let made = request.run(&text, &nominal).map_err(|problem| Answer::bad(problem.draw(&text, name)))?;
    let err = made.notes.iter().map(|note| format!("{note}\n")).collect();
    Ok(Answer { out: made.table, err, code: 0, to: request.out })
}
