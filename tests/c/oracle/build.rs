//! Puts the tables of `arms` into macro calls, a module each.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

fn main() {
    let arms = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo")).join("../arms");
    println!("cargo::rerun-if-changed={}", arms.display());
    let mut files: Vec<_> = fs::read_dir(&arms).expect("the arms").map(|e| e.expect("an entry").path()).collect();
    files.sort();
    let mut text = String::new();
    for file in files {
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        let table = fs::read_to_string(&file).expect("a table");
        write!(text, "pub mod {name} {{\ndh_robot::dh_robot! {{\n{table}\n}}\n}}\n").expect("text");
    }
    fs::write(Path::new(&env::var("OUT_DIR").expect("cargo")).join("arms.rs"), text).expect("written");
}
