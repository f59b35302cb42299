//! The `dh` command: notes, proofs, plans and expanded code of a table, from a file or standard input.
//!
//! Exit code 0: done. 1: a claim of a `prove` block is wrong. 2: bad usage or a bad table.

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::{Parsed, parse};
use dh_symbolic::diagnostic::lex;
use dh_symbolic::pipeline::{compile_table, programs, refused};
use dh_symbolic::planner::Refusal;
use dh_symbolic::render::code::{javascript, rust::pretty};
use dh_symbolic::render::document::notes::{Options, notes};
use dh_symbolic::render::document::{Document, Format, mdbook, page, plan};
use dh_symbolic::verify::document::Paper;
use dh_symbolic::verify::{Claims, check, report};
use std::io::{Read, Write};
use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
dh: kinematics from a Denavit-Hartenberg table

  dh notes  [FILE]   lecture notes
  dh page   [FILE]   an interactive page: sliders, drawing, pose, solutions (one HTML file; also notes --to page)
  dh check  [FILE] [DOCUMENT...]
                     the table, the claims of its prove blocks, and the formulas of documents
                     (LaTeX, Markdown, plain text) line by line: proven, wrong, not understood
  dh plan   [FILE]   the steps of the inverse kinematics
  dh expand [FILE]   the Rust code that dh_robot! leaves behind
  dh mdbook          preprocessor for mdBook: fenced `dh` blocks become notes

  --to text|latex|markdown|typst|html   format of notes and plans; plans also: mermaid; notes also: page;
                                        expand: rust, javascript
  --lang en|zh                          their language
  --out PATH                            write there, not to standard output; the file appears when it is complete

for notes:
{notes}
FILE holds the body of dh_robot!; without it, or with -, standard input is read.
Exit code: 0, 1 (a claim is wrong or not understood), 2 (bad usage or table).
";

/// Formats of one command alone.
const OTHERS: [(&str, &str); 4] =
    [("plan", "mermaid"), ("notes", "page"), ("expand", "rust"), ("expand", "javascript")];

/// The help text.
fn usage() -> String {
    USAGE.replace("{notes}", Options::HELP)
}

const WRONG: u8 = 1;
const BAD: u8 = 2;

/// What to print, and the exit code.
struct Answer {
    out: String,
    err: String,
    code: u8,
    /// The file that takes `out`; else standard output.
    to: Option<String>,
}

impl Answer {
    fn good(out: String) -> Answer {
        Answer { out, err: String::new(), code: 0, to: None }
    }

    fn bad(err: String) -> Answer {
        Answer { out: String::new(), err, code: BAD, to: None }
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut answer = run(&arguments);
    if let Some(path) = answer.to.take()
        && answer.code == 0
    {
        match write_whole(Path::new(&path), &answer.out) {
            Ok(()) => answer.out.clear(),
            Err(e) => answer = Answer::bad(format!("error: {path}: {e}\n")),
        }
    }
    // A reader that has gone away (`dh notes | head`) is no error.
    let _ = std::io::stderr().write_all(answer.err.as_bytes());
    let _ = std::io::stdout().write_all(answer.out.as_bytes());
    ExitCode::from(answer.code)
}

/// The command line, taken apart.
struct Request {
    command: String,
    file: Option<String>,
    /// Documents to be checked against the table.
    papers: Vec<String>,
    /// `None`: a flow chart.
    format: Option<Format>,
    /// The format as written.
    to: Option<String>,
    /// How notes are written.
    options: Options,
    /// Where to write.
    out: Option<String>,
}

fn run(arguments: &[String]) -> Answer {
    if arguments.iter().any(|a| a == "--help" || a == "-h") || arguments.first().is_some_and(|a| a == "help") {
        return Answer::good(usage());
    }
    if arguments.iter().any(|a| a == "--version" || a == "-V") {
        return Answer::good(format!("dh {}\n", env!("CARGO_PKG_VERSION")));
    }
    if arguments.first().is_some_and(|a| a == "mdbook") {
        return book(&arguments[1..]);
    }
    let request = match request(arguments) {
        Ok(r) => r,
        Err(message) => return Answer::bad(format!("error: {message}\n\n{}", usage())),
    };
    let source = match read(request.file.as_deref()) {
        Ok(text) => text,
        Err(message) => return Answer::bad(format!("error: {message}\n")),
    };
    let name = request.file.as_deref().filter(|f| *f != "-").unwrap_or("standard input");
    let mut answer = match request.command.as_str() {
        "page" => with_chain(&source, name, |_, chain| or_defect(page(&chain, &request.options))),
        "notes" if request.to.as_deref() == Some("page") => {
            with_chain(&source, name, |_, chain| or_defect(page(&chain, &request.options)))
        }
        "expand" if request.to.as_deref() == Some("javascript") => {
            with_chain(&source, name, |_, chain| or_defect(javascript::script(&chain)))
        }
        "notes" => with_chain(&source, name, |_, chain| match request.options.check(&chain) {
            Ok(()) if request.format == Some(Format::Markdown) && request.out.is_some() => {
                linked(&notes(&chain, &request.options), request.out.as_deref().unwrap_or_default())
            }
            Ok(()) => Answer::good(notes(&chain, &request.options).print(request.format.unwrap_or(Format::Text))),
            Err(message) => Answer::bad(format!("error: {message}\n")),
        }),
        "check" => {
            let mut papers = Vec::new();
            for path in &request.papers {
                match read(Some(path)) {
                    Ok(text) => papers.push((path.as_str(), text)),
                    Err(message) => return Answer::bad(format!("error: {message}\n")),
                }
            }
            with_chain(&source, name, |parsed, chain| check((&source, name), parsed, &chain, &papers))
        }
        "plan" => with_chain(&source, name, |parsed, chain| match show_plan(&request, &chain) {
            Ok(text) => Answer::good(text),
            Err(refusal) => Answer::bad(refused(&chain, &refusal, parsed).draw(&source, name)),
        }),
        _ => expand(&source, name),
    };
    answer.to = request.out;
    answer
}

/// What mdBook asks a preprocessor: whether it serves a renderer, or for the book.
fn book(arguments: &[String]) -> Answer {
    match arguments {
        [] => match read(None).map_err(|e| format!("error: {e}\n")).and_then(|input| mdbook::preprocess(&input)) {
            Ok(book) => Answer::good(book),
            Err(errors) => Answer::bad(errors),
        },
        [word, renderer] if word == "supports" => {
            let served = mdbook::RENDERERS.contains(&renderer.as_str());
            Answer { code: u8::from(!served), ..Answer::good(String::new()) }
        }
        _ => Answer::bad(
            "error: `dh mdbook` reads the book from standard input; or `dh mdbook supports RENDERER`\n".into(),
        ),
    }
}

/// Text, or the defect of this crate that was found while making it.
fn or_defect(text: Result<String, dh_symbolic::program::Disproof>) -> Answer {
    text.map_or_else(|e| Answer::bad(format!("error: {e}; this is a defect of dh-symbolic\n")), Answer::good)
}

/// Markdown for a file, with its figures in files beside it.
fn linked(note: &Document, path: &str) -> Answer {
    let path = Path::new(path);
    let stem = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
    let (text, files) = note.linked_markdown(&stem);
    for (name, text) in files {
        let place = path.with_file_name(name);
        if let Err(e) = write_whole(&place, &text) {
            return Answer::bad(format!("error: {}: {e}\n", place.display()));
        }
    }
    Answer::good(text)
}

/// Writes a file beside its place and moves it there, so that nobody sees half of it.
fn write_whole(path: &Path, text: &str) -> std::io::Result<()> {
    let mut name = path.file_name().ok_or_else(|| std::io::Error::other("not the name of a file"))?.to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let done = std::fs::write(&part, text).and_then(|()| std::fs::rename(&part, path));
    if done.is_err() {
        let _ = std::fs::remove_file(&part);
    }
    done
}

fn request(arguments: &[String]) -> Result<Request, String> {
    let mut r = Request {
        command: String::new(),
        file: None,
        papers: Vec::new(),
        format: Some(Format::Text),
        to: None,
        options: Options::default(),
        out: None,
    };
    let mut of_notes = None;
    let mut list = arguments.iter();
    while let Some(a) = list.next() {
        let (name, attached) = match a.split_once('=') {
            Some((n, v)) if n.starts_with("--") => (n, Some(v.to_string())),
            _ => (a.as_str(), None),
        };
        let mut value = || attached.clone().or_else(|| list.next().cloned()).ok_or(format!("`{name}` needs a value"));
        match name {
            "--to" => {
                let wanted = value()?;
                let known = Format::ALL.iter().find(|(n, _)| *n == wanted).map(|(_, f)| *f);
                if known.is_none() && !OTHERS.iter().any(|(_, n)| *n == wanted) {
                    let names: Vec<&str> = Format::ALL.iter().map(|(n, _)| *n).collect();
                    let others: Vec<String> = OTHERS.iter().map(|(c, n)| format!("{n} for {c}")).collect();
                    return Err(format!("no format `{wanted}`: one of {}; {}", names.join(", "), others.join(", ")));
                }
                r.format = known;
                r.to = Some(wanted);
            }
            "--out" | "-o" => r.out = Some(value()?),
            // Whether there is such an option is asked before its value is taken.
            _ if Options::NAMES.contains(&name) => {
                r.options.set(name, &value()?)?;
                if name != "--lang" {
                    of_notes = Some(name.to_string());
                }
            }
            _ if name.starts_with("--") => return Err(format!("no option `{name}`")),
            _ if r.command.is_empty() => r.command = a.clone(),
            _ if r.file.is_none() => r.file = Some(a.clone()),
            _ if r.command == "check" => r.papers.push(a.clone()),
            _ => return Err(format!("one file at a time: `{a}` is too much")),
        }
    }
    if let Some((command, name)) = OTHERS.iter().find(|(_, n)| Some(*n) == r.to.as_deref())
        && *command != r.command
    {
        return Err(format!("{name} is for {command}"));
    }
    if let Some(name) = of_notes.filter(|_| r.command != "notes" && !r.command.is_empty()) {
        return Err(format!("`{name}` is for notes"));
    }
    match r.command.as_str() {
        "expand" | "page" if r.format.is_some() && r.to.is_some() => {
            Err(format!("{} is for notes and plans", r.to.unwrap_or_default()))
        }
        "notes" | "check" | "plan" | "expand" | "page" => Ok(r),
        "" => Err("what shall be done?".into()),
        other => Err(format!("no command `{other}`")),
    }
}

fn read(file: Option<&str>) -> Result<String, String> {
    match file {
        None | Some("-") => {
            let mut text = String::new();
            std::io::stdin().read_to_string(&mut text).map_err(|e| format!("standard input: {e}"))?;
            Ok(text)
        }
        Some(path) => std::fs::read_to_string(path).map_err(|e| format!("{path}: {e}")),
    }
}

/// Reads the table; its errors are drawn.
fn with_chain(source: &str, name: &str, go: impl FnOnce(&Parsed, Chain) -> Answer) -> Answer {
    let tokens = match lex(source) {
        Ok(tokens) => tokens,
        Err(errors) => return Answer::bad(errors.draw(source, name)),
    };
    let parsed = parse(tokens);
    match parsed.spec.clone().filter(|_| parsed.errors.is_empty()) {
        Some(spec) => go(&parsed, Chain::new(spec)),
        None => Answer::bad(parsed.errors.draw(source, name)),
    }
}

/// The verdicts on the `prove` blocks.
fn derivation(parsed: &Parsed, chain: &Chain) -> (Claims, check::Report) {
    let claims = Claims::read(&parsed.claims);
    let report = check::check(chain, &claims.derivation);
    (claims, report)
}

/// The claims of the table's file, and those of documents.
fn check((source, name): (&str, &str), parsed: &Parsed, chain: &Chain, papers: &[(&str, String)]) -> Answer {
    if let Err(errors) = programs(chain, parsed) {
        return Answer::bad(errors.draw(source, name));
    }
    let mut out = format!("{}: {} rows, {} joints, in order\n", chain.name, chain.links.len(), chain.dof());
    let mut fine = true;
    if !parsed.claims.is_empty() {
        let (claims, report) = derivation(parsed, chain);
        out.push_str(&report::check_text(&report, &claims));
        fine &= report.is_fine();
    }
    for (path, text) in papers {
        let paper = Paper::read(chain, text);
        let report = check::check(chain, &paper.derivation);
        out.push_str(&format!("\n{path}\n{}", report::paper_text(&report, &paper)));
        fine &= report.is_fine();
    }
    Answer { out, err: String::new(), code: if fine { 0 } else { WRONG }, to: None }
}

/// The plan, or why there is none.
fn show_plan(request: &Request, chain: &Chain) -> Result<String, Refusal> {
    match request.format {
        Some(format) => Ok(plan(chain, request.options.language)?.print(format)),
        None => plan::mermaid(chain, request.options.language),
    }
}

fn expand(source: &str, name: &str) -> Answer {
    with_chain(source, name, |parsed, chain| {
        let (items, errors) = compile_table(parsed);
        if !errors.is_empty() {
            let wrong = !derivation(parsed, &chain).1.is_fine();
            let err = errors.draw(source, name);
            return Answer { out: String::new(), err, code: if wrong { WRONG } else { BAD }, to: None };
        }
        match pretty(items) {
            Ok(text) => Answer::good(text),
            Err(e) => Answer::bad(format!("error: {e}\n")),
        }
    })
}
