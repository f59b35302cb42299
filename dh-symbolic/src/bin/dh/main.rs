//! The `dh` command: notes, proofs, plans and expanded code of a table, from a file or standard input.
//!
//! Exit code 0: done. 1: a claim is wrong, one of the table's own not understood, or two arms differ. 2: bad usage or a bad table.

mod arguments;
mod commands;
mod export;
mod import;
mod output;

use arguments::Request;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1).peekable();
    if arguments.next_if(|word| word == "import").is_some() {
        return import::run(arguments).give();
    }
    if arguments.next_if(|word| word == "export").is_some() {
        return export::run(arguments).give();
    }
    let answer = match Request::read(arguments) {
        Ok(request) => commands::run(&request),
        Err(answer) => answer,
    };
    answer.give()
}
