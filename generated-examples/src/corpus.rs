//! The hand derivations of the lecture documents (`tests/corpus`), read and checked: for the errata page and for the tests.

use std::path::{Path, PathBuf};
use std::{fs, io};

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::verify::Claims;
use dh_symbolic::verify::check::{Report, check};
use dh_symbolic::verify::errata::{Page, errata};
use proc_macro2::TokenStream;

/// One file of the corpus, checked.
#[derive(Debug)]
pub struct Checked {
    /// Name of the file, without folder.
    pub file: String,
    /// Its lines.
    pub claims: Claims,
    /// The verdicts.
    pub report: Report,
}

/// The folder of the corpus.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus")
}

/// All files, in order of their names.
///
/// # Errors
/// Where a file cannot be read, or its table is not in order.
pub fn all() -> io::Result<Vec<Checked>> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder())?.map(|e| e.map(|e| e.path())).collect::<io::Result<_>>()?;
    paths.retain(|p| p.extension().is_some_and(|e| e == "dh"));
    paths.sort();
    paths.iter().map(|p| one(p)).collect()
}

fn one(path: &Path) -> io::Result<Checked> {
    let file = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let fail = |error: String| io::Error::new(io::ErrorKind::InvalidData, format!("{file}: {error}"));
    let text = fs::read_to_string(path)?;
    let tokens: TokenStream = text.parse().map_err(|e: proc_macro2::LexError| fail(e.to_string()))?;
    let parsed = parse(tokens);
    let claims = Claims::read(&parsed.claims);
    let spec = parsed.spec.ok_or_else(|| fail(parsed.errors.draw(&text, &file)))?;
    let report = check(&Chain::new(spec), &claims.derivation);
    Ok(Checked { file, claims, report })
}

/// The errata page of the documents, as Markdown.
///
/// # Errors
/// As [`all`].
pub fn errata_page() -> io::Result<String> {
    let corpus = all()?;
    let pages: Vec<Page<'_>> =
        corpus.iter().map(|c| Page { file: &c.file, derivation: &c.claims.derivation, report: &c.report }).collect();
    Ok(errata(&pages, &fs::read_to_string(folder().join("notes.md"))?))
}
