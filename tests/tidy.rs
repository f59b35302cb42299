//! Rules of the house that no compiler knows: who uses whom, how long a file may be, who may read tokens.

use std::fs;
use std::path::{Path, PathBuf};

/// The stages, in order: a folder uses only those before it. The last one is the library's door.
const STAGES: [&str; 9] =
    ["algebra", "chain", "kinematics", "planner", "program", "render", "verify", "import", "robot"];

/// Folders of one stage that know nothing of each other, or of which the first knows nothing of the second.
const APART: [(&str, &str); 8] = [
    ("render/formula", "render::code"),
    ("render/formula", "render::document"),
    ("render/code", "render::document"),
    ("render/code/javascript", "code::rust"),
    ("render/code/rust", "code::javascript"),
    ("render/code/c", "code::rust"),
    ("render/code/c", "code::javascript"),
    ("verify/language", "verify::check"),
];

/// Lines of code that a file may have.
const LONGEST: usize = 450;

/// Who may name `proc_macro2`: those who read the user's tokens or write the generated ones.
const TOKENS: &[&str] = &[
    "chain/table/",
    "diagnostic.rs",
    "import/in_macro.rs",
    "pipeline.rs",
    "render/code/rust/",
    "verify/prove_block.rs",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace").to_path_buf()
}

/// All Rust files below a folder, in order, with their text. Links and build output are left out.
fn files(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut all = Vec::new();
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path()).collect();
    entries.sort();
    for path in entries {
        if path.is_symlink() || path.file_name().is_some_and(|name| name == "target" || name == "expanded") {
            continue;
        }
        if path.is_dir() {
            all.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).expect("a text file");
            all.push((path, text));
        }
    }
    all
}

/// The lines of code before the unit tests.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let end = text.find("\n#[cfg(test)]\nmod tests {").unwrap_or(text.len());
    text[..end].lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"))
}

#[test]
fn stages_use_only_stages_before_them() {
    let mut wrong = Vec::new();
    for (i, stage) in STAGES.iter().enumerate() {
        let folder = root().join("dh-symbolic/src").join(stage);
        for (path, text) in files(&folder) {
            if path.file_stem().is_some_and(|name| name == "tests") {
                continue;
            }
            for line in code(&text) {
                for later in &STAGES[i + 1..] {
                    let grouped = line.contains("crate::{") && line.contains(&format!("{later}::"));
                    if grouped || line.contains(&format!("crate::{later}")) {
                        wrong.push(format!("{}: {line}", path.display()));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "a stage uses a later one:\n{}", wrong.join("\n"));
}

#[test]
fn rooms_of_a_stage_keep_apart() {
    let mut wrong = Vec::new();
    for (folder, other) in APART {
        for (path, text) in files(&root().join("dh-symbolic/src").join(folder)) {
            wrong.extend(code(&text).filter(|l| l.contains(other)).map(|l| format!("{}: {l}", path.display())));
        }
    }
    assert!(wrong.is_empty(), "a folder uses one that it should not know:\n{}", wrong.join("\n"));
}

#[test]
fn files_are_short() {
    let mut long = Vec::new();
    for name in ["dh-macro", "dh-robot", "dh-symbolic", "generated-examples", "tests"] {
        for (path, text) in files(&root().join(name)) {
            let lines = code(&text).count();
            let name = path.strip_prefix(root()).expect("below").to_string_lossy().replace('\\', "/");
            if lines > LONGEST && !name.ends_with("/tests.rs") {
                long.push(format!("{name}: {lines} lines of code"));
            }
        }
    }
    assert!(long.is_empty(), "more than {LONGEST} lines: would two names fit better than one?\n{}", long.join("\n"));
}

#[test]
fn only_the_ends_of_the_pipeline_know_tokens() {
    let source = root().join("dh-symbolic/src");
    let named = |(path, text): &(PathBuf, String)| {
        let name = path.strip_prefix(&source).expect("below").to_string_lossy().replace('\\', "/");
        let allowed = TOKENS.iter().any(|allowed| name.starts_with(allowed));
        !allowed && code(text).any(|line| line.contains("proc_macro2"))
    };
    let wrong: Vec<PathBuf> = files(&source).into_iter().filter(named).map(|(path, _)| path).collect();
    assert!(wrong.is_empty(), "proc_macro2 in {wrong:?}");
}

#[test]
fn every_file_says_what_it_is() {
    let source = [
        "dh-macro/src",
        "dh-robot/kernels/src",
        "dh-robot/src",
        "dh-symbolic/dynamic/src",
        "dh-symbolic/python/src",
        "dh-symbolic/src",
        "generated-examples/src",
        "tests",
    ];
    let silent: Vec<PathBuf> = source
        .iter()
        .flat_map(|folder| files(&root().join(folder)))
        .filter(|(path, text)| !text.starts_with("//!") && !path.to_string_lossy().contains("/ui/"))
        .map(|(path, _)| path)
        .collect();
    assert!(silent.is_empty(), "files without `//!`: {silent:?}");
}

/// The packages that are published, by folder.
const PUBLISHED: [&str; 4] = ["dh-macro", "dh-robot", "dh-robot/kernels", "dh-symbolic"];

#[test]
fn packages_carry_licences_a_readme_and_their_documentation() {
    let text = |path: &str| fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"));
    let manifest = text("Cargo.toml");
    for folder in PUBLISHED {
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            assert_eq!(
                text(&format!("{folder}/{licence}")),
                text(licence),
                "{folder}/{licence} is not the workspace's"
            );
        }
        let package = text(&format!("{folder}/Cargo.toml"));
        let name = package.split('"').nth(1).expect("a name");
        assert!(package.contains(&format!("documentation = \"https://docs.rs/{name}\"")), "{name}: documentation");
        assert!(text(&format!("{folder}/README.md")).starts_with(&format!("# {name}\n")), "{name}: README.md");
        assert!(text(".ci/package").contains(name), "{name} is not packed by .ci/package");
    }
    let version = manifest.split("\nversion = \"").nth(1).expect("a version").split(['.', '"']).take(2);
    let version = version.collect::<Vec<_>>().join(".");
    for dependency in text("dh-robot/README.md").lines().filter(|line| line.starts_with("dh-robot = ")) {
        assert!(dependency.contains(&format!("\"{version}\"")), "dh-robot/README.md: {dependency}");
    }
}
