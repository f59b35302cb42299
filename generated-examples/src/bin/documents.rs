//! Writes the notes of all example robots in all formats and languages, for the programs that read them: see
//! `tests/documents/README.md`.
//!
//! `cargo run -p generated-examples --bin documents -- FOLDER` makes `FOLDER/<format>/<robot>.<language>.<ending>`.

#![allow(clippy::print_stderr)] // a command prints

use std::path::PathBuf;
use std::process::ExitCode;
use std::{fs, io};

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::{Format, Options, notes};
use generated_examples::source::{self, Source};
use proc_macro2::TokenStream;

/// Formats with their folders and file endings.
const FORMATS: [(&str, &str, Format); 5] = [
    ("latex", "tex", Format::Latex),
    ("typst", "typ", Format::Typst),
    ("html", "html", Format::Html),
    ("markdown", "md", Format::Markdown),
    ("text", "txt", Format::Text),
];

fn main() -> ExitCode {
    let folder = match std::env::args().skip(1).collect::<Vec<_>>().as_slice() {
        [folder] => PathBuf::from(folder),
        _ => {
            eprintln!("usage: documents FOLDER");
            return ExitCode::from(2);
        }
    };
    match source::all().and_then(|all| all.iter().try_for_each(|s| write(s, &folder))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn write(source: &Source, folder: &std::path::Path) -> io::Result<()> {
    let fail =
        |e: &dyn std::fmt::Display| io::Error::new(io::ErrorKind::InvalidData, format!("{}: {e}", source.module));
    let tokens: TokenStream = source.body.parse().map_err(|e: proc_macro2::LexError| fail(&e))?;
    let chain = Chain::new(parse(tokens).spec.ok_or_else(|| fail(&"the table has errors"))?);
    for language in ["en", "zh"] {
        let mut options = Options::default();
        let own = source.options.iter().map(|(name, value)| (name.to_string(), value.to_string()));
        for (name, value) in own.chain([("--lang".to_string(), language.to_string())]) {
            options.set(&name, &value).map_err(|e| fail(&e))?;
        }
        options.check(&chain).map_err(|e| fail(&e))?;
        let note = notes(&chain, &options);
        for (name, ending, format) in FORMATS {
            let folder = folder.join(name);
            fs::create_dir_all(&folder)?;
            fs::write(folder.join(format!("{}.{language}.{ending}", source.module)), note.print(format))?;
        }
    }
    Ok(())
}
