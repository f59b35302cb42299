//! Writes what is made from the example robots: `expanded/<robot>.rs`, exactly what the macro leaves behind, formatted;
//! `notes/<robot>.md`, their lecture notes with their figures beside them, for one robot `notes/<robot>.html`, its interactive
//! page; and `notes/errata.md`, what is wrong in the documents that they come from.
//!
//! `cargo regen` writes, `cargo regen --check` compares and fails where a file is stale.

#![allow(clippy::print_stdout, clippy::print_stderr)] // a command prints

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::ExitCode;
use std::{fs, io};

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::pipeline::compile;
use dh_symbolic::render::code::rust::pretty;
use dh_symbolic::render::{Options, notes, page};
use generated_examples::corpus;
use generated_examples::source::{self, Source};
use proc_macro2::TokenStream;

const COMMAND: &str = "cargo regen";
/// Robots whose interactive page is kept, to be opened without building anything.
const PAGES: [&str; 1] = ["puma560"];
/// Folders whose files are all generated.
const FOLDERS: [&str; 2] = ["expanded", "notes"];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let check = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        _ => {
            eprintln!("usage: {COMMAND} [--check]");
            return ExitCode::from(2);
        }
    };
    let stale = files().and_then(|files| if check { compare(&files) } else { write(&files) });
    match stale {
        Ok(stale) if stale.is_empty() => ExitCode::SUCCESS,
        Ok(stale) => {
            for line in stale {
                println!("{line}");
            }
            if check {
                eprintln!("generated files are stale; run `{COMMAND}`");
                return ExitCode::FAILURE;
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Path in the crate's folder and text of every generated file.
type Files = BTreeMap<PathBuf, String>;

fn files() -> io::Result<Files> {
    let mut files = Files::new();
    let mut modules = format!("// Made by `{COMMAND}`; do not edit.\n\n");
    for source in source::all()? {
        modules.push_str(&format!("pub mod {};\n", source.module));
        files.insert(format!("expanded/{}.rs", source.module).into(), expanded(&source)?);
        if PAGES.contains(&source.module.as_str()) {
            files.insert(format!("notes/{}.html", source.module).into(), interactive(&source)?);
        }
        let (text, figures) = lecture(&source)?;
        files.insert(format!("notes/{}.md", source.module).into(), text);
        for (name, figure) in figures {
            files.insert(format!("notes/{name}").into(), figure);
        }
    }
    files.insert("expanded/mod.rs".into(), modules);
    files.insert("notes/errata.md".into(), corpus::errata_page()?);
    files.insert("notes/README.md".into(), gallery()?);
    Ok(files)
}

/// The page that links all notes.
fn gallery() -> io::Result<String> {
    let mut out = format!("<!-- Made by `{COMMAND}`; do not edit. -->\n\n# Gallery of the example robots\n\n");
    out.push_str("Everything here is made from the tables alone. `cargo dh page FILE --out arm.html` makes the interactive page of a table,\n");
    out.push_str("`cargo dh notes FILE --to latex --lang zh` the notes in other formats and in Chinese.\n\n");
    out.push_str("| robot | notes | table | generated code |\n|---|---|---|---|\n");
    for source in source::all()? {
        let about = source.body.lines().find_map(|l| l.trim().strip_prefix("///")).unwrap_or(&source.module);
        let m = &source.module;
        out.push_str(&format!(
            "| {} | [notes]({m}.md) | [table](../src/{m}.rs) | [code](../expanded/{m}.rs) |\n",
            about.trim()
        ));
    }
    out.push_str("\n[Errata](errata.md): what is wrong in the documents that many of these robots come from.\n");
    Ok(out)
}

fn fail(source: &Source, error: &dyn std::fmt::Display) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("{}: {error}", source.module))
}

fn tokens(source: &Source) -> io::Result<TokenStream> {
    source.body.parse().map_err(|e: proc_macro2::LexError| fail(source, &e))
}

/// The lecture notes, and names and texts of their figures.
fn lecture(source: &Source) -> io::Result<(String, Vec<(String, String)>)> {
    let parsed = parse(tokens(source)?);
    let spec = parsed.spec.ok_or_else(|| fail(source, &"the table has errors"))?;
    let chain = Chain::new(spec);
    let mut options = Options::default();
    for (name, value) in &source.options {
        options.set(name, value).map_err(|e| fail(source, &e))?;
    }
    options.check(&chain).map_err(|e| fail(source, &e))?;
    let (text, figures) = notes(&chain, &options).linked_markdown(&source.module);
    let text = format!("<!-- The notes of src/{}.rs. Made by `{COMMAND}`; do not edit. -->\n\n{text}", source.module);
    Ok((text, figures))
}

/// The interactive page.
fn interactive(source: &Source) -> io::Result<String> {
    let parsed = parse(tokens(source)?);
    let spec = parsed.spec.ok_or_else(|| fail(source, &"the table has errors"))?;
    page(&Chain::new(spec), &Options::default()).map_err(|e| fail(source, &e))
}

/// What the macro leaves behind.
fn expanded(source: &Source) -> io::Result<String> {
    let (items, errors) = compile(tokens(source)?);
    if !errors.is_empty() {
        return Err(fail(source, &errors.draw(&source.body, &source.module)));
    }
    let text = pretty(items).map_err(|e| fail(source, &e))?;
    Ok(format!("// What `dh_robot!` makes of src/{}.rs. Made by `{COMMAND}`; do not edit.\n\n{text}", source.module))
}

/// Writes what differs and removes what is no longer made. Returns what it did.
fn write(files: &Files) -> io::Result<Vec<String>> {
    let mut done = Vec::new();
    for (path, text) in files {
        let full = source::folder().join(path);
        if fs::read_to_string(&full).ok().as_ref() != Some(text) {
            if let Some(folder) = full.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(&full, text)?;
            done.push(format!("wrote {}", path.display()));
        }
    }
    for path in left_over(files)? {
        fs::remove_file(source::folder().join(&path))?;
        done.push(format!("removed {}", path.display()));
    }
    Ok(done)
}

/// Which files are not as they would be written.
fn compare(files: &Files) -> io::Result<Vec<String>> {
    let mut stale = Vec::new();
    for (path, text) in files {
        match fs::read_to_string(source::folder().join(path)) {
            Ok(old) if old == *text => {}
            Ok(old) => {
                let line = old.lines().zip(text.lines()).take_while(|(a, b)| a == b).count() + 1;
                stale.push(format!("differs at line {line}: generated-examples/{}", path.display()));
            }
            Err(_) => stale.push(format!("missing: generated-examples/{}", path.display())),
        }
    }
    stale.extend(left_over(files)?.iter().map(|path| format!("left over: generated-examples/{}", path.display())));
    Ok(stale)
}

/// Files in the generated folders that are not made any more.
fn left_over(files: &Files) -> io::Result<Vec<PathBuf>> {
    let mut old = Vec::new();
    for name in FOLDERS {
        let folder = source::folder().join(name);
        if !folder.exists() {
            continue;
        }
        for entry in fs::read_dir(folder)? {
            let path = PathBuf::from(name).join(entry?.file_name());
            if !files.contains_key(&path) {
                old.push(path);
            }
        }
    }
    old.sort();
    Ok(old)
}
