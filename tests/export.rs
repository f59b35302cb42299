//! C and C++ interfaces of robots, as a C programmer reads them. `.ci/c` compiles and runs them, and compares with Rust.

use dh_symbolic::{ExportOptions, Robot};

/// The arms that `.ci/c` takes too.
fn arm(name: &str) -> Robot {
    let path = format!("{}/c/arms/{name}.dh", env!("CARGO_MANIFEST_DIR"));
    Robot::parse(&std::fs::read_to_string(path).expect("a table")).expect("a robot")
}

fn exported(name: &str) -> Vec<(String, String)> {
    arm(name).export_c(&ExportOptions::default()).expect("files")
}

fn file(name: &str, path: &str) -> String {
    let files = exported(name);
    files.into_iter().find(|(own, _)| own == path).unwrap_or_else(|| panic!("{name} has no {path}")).1
}

#[test]
fn headers() {
    for name in ["puma560", "slider", "rail_arm", "wrist32", "planar3", "one_joint"] {
        insta::assert_snapshot!(format!("header_{name}"), file(name, &format!("include/{name}.h")));
    }
}

#[test]
fn the_border_and_the_class() {
    insta::assert_snapshot!("border_iiwa7", file("iiwa7", "src/c.rs"));
    insta::assert_snapshot!("class_youbot", file("youbot", "include/youbot.hpp"));
}

#[test]
fn every_file_is_there_and_nothing_is_left_to_fill_in() {
    for name in ["puma560", "iiwa7", "planar3", "one_joint"] {
        let files = exported(name);
        let paths: Vec<&str> = files.iter().map(|(path, _)| path.as_str()).collect();
        let header = format!("include/{name}.h");
        for path in
            ["Cargo.toml", "CMakeLists.txt", "README.md", "src/lib.rs", "src/c.rs", "examples/example.c", &header]
        {
            assert!(paths.contains(&path), "{name}: {paths:?}");
        }
        for (path, text) in &files {
            let text = text.replace("@PACKAGE_INIT@", "").replace("@PACKAGE_library_dir@", "");
            assert!(!text.replace("@PACKAGE_include_dir@", "").contains('@'), "{name}/{path}");
            assert!(text.ends_with('\n') && !text.lines().any(|line| line.ends_with(' ')), "{name}/{path}");
        }
    }
}

/// A header declares what the border defines, and nothing else.
#[test]
fn header_and_border_have_the_same_functions() {
    for name in ["puma560", "rail_arm", "planar3", "one_joint"] {
        let (header, border) = (file(name, &format!("include/{name}.h")), file(name, "src/c.rs"));
        let word =
            |text: &str| text.split('(').next().and_then(|head| head.split([' ', '*']).next_back()).map(String::from);
        let mut declared: Vec<String> = header
            .lines()
            .filter(|line| line.contains('(') && ["int ", "size_t ", name].iter().any(|kind| line.starts_with(kind)))
            .filter_map(word)
            .collect();
        let mut defined: Vec<String> = border.split("extern \"C\" fn ").skip(1).filter_map(word).collect();
        declared.sort();
        defined.sort();
        assert_eq!(declared, defined);
    }
}

#[test]
fn names() {
    let robot = |name: &str| {
        Robot::parse(&format!(
            "struct {name}; convention = standard; ik = none; | theta | d | a | alpha | | q1 | 0 | 0 | 0 |"
        ))
        .expect("a robot")
    };
    let named = |robot: &Robot, name: Option<&str>| {
        robot.export_c(&ExportOptions { name: name.map(String::from), ..ExportOptions::default() })
    };
    let error = named(&robot("Double"), None).unwrap_err();
    assert!(error.to_string().contains("cannot be called `double`") && error.to_string().contains("--name"), "{error}");
    assert!(named(&robot("Größe"), None).is_err() && named(&robot("Arm"), Some("a-b")).is_err());
    let files = named(&robot("Double"), Some("twice")).expect("files");
    assert!(
        files
            .iter()
            .any(|(path, text)| path == "include/twice.h" && text.contains("int twice_forward(const double q[1]"))
    );
}
