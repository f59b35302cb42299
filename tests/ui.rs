//! What rustc says about tables, right and wrong: `ui/pass` compiles, `ui/fail` fails with the text beside it.
//!
//! `TRYBUILD=overwrite cargo test -p dh-tests ui` writes the texts anew. They come from one version of rustc: other versions draw
//! errors in other ways, so there the wrong tables are left out.

use std::process::Command;

/// The version whose texts are checked in.
const RUSTC: &str = "rustc 1.95.";

#[test]
fn tables() {
    let cases = trybuild::TestCases::new();
    cases.pass("ui/pass/*.rs");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let version =
        Command::new(rustc).arg("--version").output().map(|o| String::from_utf8_lossy(&o.stdout).into_owned());
    match version {
        Ok(v) if v.starts_with(RUSTC) => cases.compile_fail("ui/fail/*.rs"),
        other => eprintln!("left out: the texts of wrong tables are those of {RUSTC}, this is {other:?}"),
    }
}
