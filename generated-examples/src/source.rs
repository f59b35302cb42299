//! The macro calls of this crate as text, for programs that do at run time what the macro does while compiling.
//!
//! The modules are the only place where the tables stand; nothing is copied.

use std::path::{Path, PathBuf};
use std::{fs, io};

/// The body of one macro call.
#[derive(Clone, Debug)]
pub struct Source {
    /// Name of the module, and of the files made from it.
    pub module: String,
    /// What stands between the braces of `dh_robot!`: the text that a `.dh` file would hold.
    pub body: String,
    /// Options of its notes, from lines `Notes: --name value` of the module's documentation.
    pub options: Vec<(String, String)>,
}

/// The folder of this crate.
#[must_use]
pub fn folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All robots, in the order in which `lib.rs` lists them.
///
/// # Errors
/// Where a file cannot be read, or a module that `lib.rs` lists as a robot does not end with a macro call.
pub fn all() -> io::Result<Vec<Source>> {
    crate::ROBOTS.iter().map(|module| one(module)).collect()
}

/// Options of the notes that a module's documentation asks for.
fn options(module: &str) -> Vec<(String, String)> {
    let lines = module.lines().filter_map(|line| line.strip_prefix("//! Notes: "));
    lines
        .filter_map(|line| line.split_once(' '))
        .map(|(name, value)| (name.to_string(), value.trim().to_string()))
        .collect()
}

fn one(module: &str) -> io::Result<Source> {
    let path: PathBuf = folder().join(format!("src/{module}.rs"));
    let text = fs::read_to_string(&path)?;
    match body(&text) {
        Some(body) => Ok(Source { module: module.to_string(), body, options: options(&text) }),
        None => Err(io::Error::new(
            io::ErrorKind::InvalidData,
            format!("{}: no `dh_robot! {{ }}` at its end", path.display()),
        )),
    }
}

/// The body of the macro call that a module ends with, without its indentation.
fn body(module: &str) -> Option<String> {
    let (_, call) = module.split_once("\ndh_robot! {\n")?;
    let inside = call.strip_suffix("\n}\n")?;
    Some(inside.lines().map(|line| format!("{}\n", line.strip_prefix("    ").unwrap_or(line))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_what_stands_between_the_braces() {
        let module = "//! x\n\nuse dh_robot::dh_robot;\n\ndh_robot! {\n    pub struct A;\n\n    | a |\n}\n";
        assert_eq!(body(module).as_deref(), Some("pub struct A;\n\n| a |\n"));
        assert_eq!(body("//! none\n"), None);
    }

    #[test]
    fn every_robot_has_a_body() {
        let all = all().expect("every module ends with a macro call");
        assert!(all.iter().all(|source| source.body.contains("pub struct") && source.body.contains("convention")));
    }
}
