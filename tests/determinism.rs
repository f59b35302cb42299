//! Same input, same bytes: in one process, and in two.

use std::process::Command;

use generated_examples::source;

/// Set in the second process.
const SECOND: &str = "DH_TESTS_PRINT_EXPANSIONS";

fn expansions() -> String {
    let sources = source::all().expect("the examples can be read");
    let expand = |source: source::Source| dh_symbolic::expand(source.body.parse().expect("it lexes")).to_string();
    sources.into_iter().map(expand).collect::<Vec<_>>().join("\n")
}

/// Hash maps are seeded anew in every process, and for every map: an order that depends on them shows here.
#[test]
fn expansions_do_not_depend_on_the_process() {
    let here = expansions();
    if let Some(path) = std::env::var_os(SECOND) {
        std::fs::write(path, here).expect("the file can be written");
        return;
    }
    assert!(here == expansions(), "two expansions in one process differ");
    let path = std::env::temp_dir().join(format!("dh-tests-{}", std::process::id()));
    let status = Command::new(std::env::current_exe().expect("this program has a path"))
        .args(["--exact", "determinism::expansions_do_not_depend_on_the_process"])
        .env(SECOND, &path)
        .output()
        .expect("this program can be run")
        .status;
    assert!(status.success(), "the second process failed");
    let there = std::fs::read_to_string(&path).expect("the second process wrote");
    std::fs::remove_file(&path).expect("the file can be removed");
    assert!(!there.is_empty() && here == there, "expansions in two processes differ");
}
