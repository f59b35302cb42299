//! The `dh` command from outside: what it prints, what it says, how it exits.

use std::io::Write;
use std::process::{Command, Stdio};

const PLANAR: &str = "
pub struct Planar;
convention = modified;
let l1: length = 0.4;
let l2: length = 0.3;
| alpha | a  | d | theta |
|-------|----|---|-------|
| 0     | 0  | 0 | q1    |
| 0     | l1 | 0 | q2    |
| 0     | l2 | 0 | 0     |
";

/// Exit code, standard output, standard error.
fn dh(arguments: &[&str], input: &str) -> (i32, String, String) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_dh"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    child.stdin.take().expect("a pipe").write_all(input.as_bytes()).ok();
    let done = child.wait_with_output().expect("the command ends");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (done.status.code().expect("an exit code"), text(done.stdout), text(done.stderr))
}

#[test]
fn notes_in_every_format() {
    for (format, part) in [
        ("text", "s₁₂ = sin(θ₁ + θ₂)"),
        ("latex", "l_1c_1 + l_2c_{12}"),
        ("markdown", "\\begin{bmatrix}"),
        ("typst", "c_(12)"),
        ("html", "<msub><mi>c</mi><mn>12</mn></msub>"),
    ] {
        let (code, out, err) = dh(&["notes", "--to", format], PLANAR);
        assert_eq!((code, err.as_str()), (0, ""), "{format}");
        assert!(out.contains(part), "{format}: {out}");
        assert_eq!(out, dh(&["notes", "-", &format!("--to={format}")], PLANAR).1);
    }
    let chinese = dh(&["notes", "--lang", "zh"], PLANAR).1;
    assert!(chinese.contains("正运动学"), "{chinese}");
}

#[test]
fn plans_and_what_has_none() {
    let (code, out, err) = dh(&["plan"], &PLANAR.replace("convention", "task = position; convention"));
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("the law of cosines"), "{out}");
    let chart = dh(&["plan", "--to", "mermaid"], &PLANAR.replace("convention", "task = position; convention")).1;
    assert!(chart.starts_with("flowchart TD") && chart.contains("-->"), "{chart}");
    assert_eq!(dh(&["notes", "--to", "mermaid"], PLANAR).0, 2);
}

#[test]
fn a_wrong_claim_is_code_1() {
    let with = |claim: &str| format!("{PLANAR}prove {{ {claim} }}");
    let right = with("T(0,3).px = l1*c1 + l2*c12;");
    let wrong = with("T(0,3).px = l1*c1 + l2*s12;");
    let (code, out, _) = dh(&["check"], &right);
    assert_eq!(code, 0, "{out}");
    let (code, out, _) = dh(&["check"], &wrong);
    assert!(code == 1 && out.contains("`s12` should be `c12`"), "{out}");
    let (code, out, err) = dh(&["expand"], &wrong);
    assert!(code == 1 && out.is_empty() && err.contains("^^^"), "{err}");
}

#[test]
fn a_bad_table_and_bad_usage_are_code_2() {
    let bad = PLANAR.replace("| 0     | l1 |", "| 0     | l9 |");
    for command in ["notes", "check", "expand"] {
        let (code, out, err) = dh(&[command], &bad);
        assert!(code == 2 && out.is_empty(), "{out}");
        assert!(err.contains("standard input:9:11") && err.contains("^^"), "{err}");
    }
    for arguments in [
        &[][..],
        &["notes", "--to", "word"],
        &["note"],
        &["notes", "a", "b"],
        &["notes", "--to"],
        &["notes", "/nowhere.dh"],
        &["notes", "--sines"],
        &["notes", "--nothing"],
        &["notes", "--parts", "tables"],
        &["check", "--to", "html"],
        &["compare", "-"],
        &["compare", "a", "b", "c"],
    ] {
        let (code, out, err) = dh(arguments, PLANAR);
        assert!(code == 2 && out.is_empty() && err.starts_with("error: "), "{arguments:?} {err}");
        assert_eq!(err.lines().count(), 1, "one line says it: {err}");
    }
    assert_eq!(dh(&["--help"], "").0, 0);
}

/// What the macro refuses is refused by every command that rests on the inverse, at the same cells; notes say why.
#[test]
fn every_command_refuses_what_the_macro_refuses() {
    let rows = |n: usize| -> String {
        let row = |k| format!("| {} | 0 | 0.3 | q{k} |\n", ["90deg", "-90deg"][k % 2]);
        (1..=n).map(row).collect()
    };
    let table = |setting: &str, rows: &str| {
        format!("struct Arm; convention = modified; {setting}\n| alpha | a | d | theta |\n|--|--|--|--|\n{rows}")
    };
    let planar = "| 0 | 0 | 0 | q1 |\n| 0 | 0.3 | 0 | q2 |\n| 0 | 0.2 | 0 | q3 |\n";
    for (table, what) in [
        (table("task = planar;", &planar.replace("| 0 | 0.3", "| 90deg | 0.3")), "`q2` tilts the tool"),
        (table("task = planar; tool = ry(90deg);", planar), "points along z"),
        (table("", &rows(7)), "say which one the caller chooses"),
        (table("redundant = q3;", &rows(8)), "say which 2 joints"),
    ] {
        let expanded = dh(&["expand"], &table);
        assert!(expanded.0 == 2 && expanded.2.contains(what), "{}", expanded.2);
        for command in ["check", "plan"] {
            assert_eq!(dh(&[command], &table), expanded, "{command}");
        }
        let (code, out, err) = dh(&["notes", "--parts", "inverse"], &table);
        assert!(code == 0 && err.is_empty() && out.contains(&what.replace('`', "")), "{out}{err}");
        let page = dh(&["page"], &table).1;
        assert!(["tilts the tool", "points along z", "leave the inverse open"].iter().any(|part| page.contains(part)));
        let unasked = table.replace("convention", "ik = none; convention").replacen("redundant = q3;", "", 1);
        assert_eq!(dh(&["check"], &unasked).0, 0, "{unasked}");
    }
}

#[test]
fn expanded_code_is_rust() {
    let (code, out, err) = dh(&["expand"], &PLANAR.replace("convention", "task = position; convention"));
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("pub struct Planar {") && out.contains("pub fn forward("), "{out}");
}

#[test]
fn a_page_and_a_script() {
    let (code, out, err) = dh(&["page"], PLANAR);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.starts_with("<!DOCTYPE html>") && out.ends_with("</html>\n") && out.contains("class Arm"), "{out}");
    assert_eq!(out, dh(&["notes", "--to", "page"], PLANAR).1);
    assert!(dh(&["page", "--lang", "zh"], PLANAR).1.contains("逆运动学"));
    let script = dh(&["expand", "--to", "javascript"], PLANAR).1;
    assert!(script.starts_with("\"use strict\";") && script.contains("this.parameters = { l1: 0.4, l2: 0.3 };"));
    for arguments in [["plan", "--to", "page"], ["notes", "--to", "javascript"], ["expand", "--to", "html"]] {
        assert_eq!(dh(&arguments, PLANAR).0, 2, "{arguments:?}");
    }
}

#[test]
fn files_appear_when_they_are_complete() {
    let folder = std::env::temp_dir().join(format!("dh-out-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("page.html");
    let name = path.to_str().expect("a name");
    let bad = PLANAR.replace("| 0     | l1 |", "| 0     | l9 |");
    assert_eq!(dh(&["page", "--out", name], &bad).0, 2);
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0, "nothing is written for a bad table");
    assert_eq!(dh(&["page", "--out", name], PLANAR), (0, String::new(), String::new()));
    assert_eq!(std::fs::read_to_string(&path).expect("the page"), dh(&["page"], PLANAR).1);
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 1, "and nothing beside the page");
    let (code, _, err) = dh(&["page", "--out", "/nowhere/page.html"], PLANAR);
    assert!(code == 2 && err.starts_with("error: /nowhere/page.html"), "{err}");
    std::fs::remove_dir_all(&folder).ok();
}

/// Notation, parts and the example are choices; a choice that does not fit the robot is an error before anything is printed.
#[test]
fn choices_of_notes() {
    for (options, part, other) in [
        (vec!["--sines", "long"], "l₁·cos θ₁", "l₁c₁"),
        (vec!["--transforms", "trailing"], "T₂⁰ = T₁⁰ T₂¹", "⁰T₂"),
        (vec!["--transforms", "products"], "T₂ = A₁ A₂", "⁰T₂"),
        (vec!["--joints", "phi"], "φ₂", "θ₂"),
        (vec!["--frames", "0=S"], "(S)T₂", "⁰T₂"),
        (vec!["--parts", "forward"], "Forward kinematics", "Link transforms"),
        (vec!["--parts", "forward", "--products", "1-3,0-3"], "⁰T₃ = ⁰T₁ ¹T₃", "⁰T₂"),
        (vec!["--parts", "example", "--at", "q1 = 90deg"], "θ₁ = 90°", "θ₁ = 20°"),
        (vec!["--parts", "example", "--at=q1=90deg", "--angles=radians"], "θ₁ = 1.57", "90°"),
    ] {
        let (code, out, err) = dh(&[vec!["notes"], options.clone()].concat(), PLANAR);
        assert_eq!((code, err.as_str()), (0, ""), "{options:?}");
        assert!(out.contains(part), "{options:?}: {out}");
        assert!(!out.contains(other), "{options:?}: {out}");
    }
    for (options, part) in [
        (vec!["--parts", "tables"], "one of table, figure, links"),
        (vec!["--at", "q9 = 1deg"], "no joint variable `q9`"),
        (vec!["--at", "q1 = 1"], "has no unit"),
        (vec!["--pose", "tx(1) + 2"], "joined by `*`"),
        (vec!["--products", "0-7"], "the last frame is 3"),
        (vec!["--sines"], "needs a value"),
    ] {
        let (code, out, err) = dh(&[vec!["notes", "-"], options.clone()].concat(), PLANAR);
        assert_eq!((code, out.as_str()), (2, ""), "{options:?}");
        assert!(err.contains(part), "{options:?}: {err}");
    }
    assert_eq!(dh(&["plan", "--sines", "long"], PLANAR).0, 2);
}

/// A pose out of reach, and one that an arm of two joints cannot take, are said to be so.
#[test]
fn why_a_pose_has_no_solution() {
    let point = PLANAR.replace("convention", "task = position; convention");
    let note = |table: &str, pose: &str| dh(&["notes", "--parts", "example", "--pose", pose], table).1;
    let far = note(&point, "tx(0.9)");
    assert!(
        far.contains("too far away: step 1") && far.contains("distance of 0.90000") && far.contains("0.70000."),
        "{far}"
    );
    let near = note(&point, "tx(0.05)");
    assert!(
        near.contains("too near: step 1") && near.contains("distance of 0.05000") && near.contains("0.10000."),
        "{near}"
    );
    let tilted = note(PLANAR, "tx(0.5) * rx(20deg)");
    assert!(tilted.contains("this pose is none of those"), "{tilted}");
}

#[test]
fn figures_in_every_format() {
    for (format, part) in [
        ("text", "[Figure] The arm at θ₁ = 20°"),
        ("latex", "\\begin{tikzpicture}"),
        ("markdown", "<figure>\n<svg "),
        ("typst", "image(bytes(\"<svg "),
        ("html", "<figure>\n<svg "),
    ] {
        let out = dh(&["notes", "--to", format], PLANAR).1;
        assert!(out.contains(part), "{format}: {out}");
        let none = dh(&["notes", "--to", format, "--parts", "table,forward"], PLANAR).1;
        assert!(!none.contains(part), "{format}");
    }
    let folder = std::env::temp_dir().join(format!("dh-figures-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let note = folder.join("arm.md");
    assert_eq!(dh(&["notes", "--to", "markdown", "--out", note.to_str().expect("a name")], PLANAR).0, 0);
    let text = std::fs::read_to_string(&note).expect("the note");
    let figure = std::fs::read_to_string(folder.join("arm-1.svg")).expect("its figure");
    assert!(text.contains("![Figure](arm-1.svg)") && !text.contains("<svg") && figure.starts_with("<svg "), "{text}");
    std::fs::remove_dir_all(&folder).ok();
}

#[test]
fn documents_are_checked_line_by_line() {
    let folder = std::env::temp_dir().join(format!("dh-documents-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let good = folder.join("good.tex");
    let bad = folder.join("bad.txt");
    std::fs::write(&good, "So $p_x = l_1 \\cos\\theta_1 + l_2 c_{12}$.\n").expect("a file");
    std::fs::write(&bad, "The elbow:\n\npx = l1 c1 + l2 s12\npy = l1 s1 + k\n").expect("a file");
    let (good, bad) = (good.to_string_lossy(), bad.to_string_lossy());
    let (code, out, err) = dh(&["check", "-", &good], PLANAR);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("1 formula, 1 proven, 0 wrong, 0 unclear; 0 lines of prose"), "{out}");
    let (code, out, _) = dh(&["check", "-", &good, &bad], PLANAR);
    assert_eq!(code, 1);
    for part in [
        "   3  wrong ",
        "`s12` should be `c12`",
        "   4  unclear ",
        "`k` has no meaning",
        "1 wrong, 1 unclear; 1 line of prose",
    ] {
        assert!(out.contains(part), "{part}: {out}");
    }
    let (code, out, err) = dh(&["check", "-", "/nowhere.tex"], PLANAR);
    assert!(code == 2 && out.is_empty() && err.contains("/nowhere.tex"), "{err}");
    std::fs::remove_dir_all(folder).ok();
}

/// One arm in both conventions, with lengths as fields, in another unit; and arms that differ.
#[test]
fn tables_of_one_arm_are_compared() {
    let folder = std::env::temp_dir().join(format!("dh-compare-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("a file");
        path.to_string_lossy().into_owned()
    };
    let puma = include_str!("puma560.dh");
    let craig = file("craig.dh", puma);
    // The same frames as Lee puts them, in millimetres and without names.
    let rows = [
        "| q1 | 0 | 0 | -90deg |",
        "| q2 | 150.05 | 431.8 | 0 |",
        "| q3 | 0 | 20.3 | -90deg |",
        "| q4 | 431.8 | 0 | 90deg |",
        "| q5 | 0 | 0 | -90deg |",
        "| q6 | 0 | 0 | 0 |",
    ];
    let table = |rows: &[&str]| {
        format!("struct P; convention = standard; unit = mm;\n| theta | d | a | alpha |\n{}\n", rows.join("\n"))
    };
    let lee = file("lee.dh", &table(&rows));
    let (code, out, err) = dh(&["compare", &lee, &craig], "");
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let frames: Vec<&str> = out.lines().skip(2).collect();
    assert_eq!(
        frames,
        [
            "frame 0: equal",
            "frame 1: D = rx(-90deg)",
            "frame 2: D = tx(431.8) * tz(150.05)",
            "frame 3: D = tx(20.3) * rx(-90deg)",
            "frame 4: D = rx(90deg)",
            "frame 5: D = rx(-90deg)",
            "frame 6: equal",
            "pose of the tool: equal"
        ],
        "{out}"
    );
    assert_eq!(dh(&["compare", &craig, &craig], "").0, 0);
    for (k, change) in
        [(1, "| q2 | 150.05 | 431 | 0 |"), (2, "| q3 + 1deg | 0 | 20.3 | -90deg |"), (3, "| q4 | 431.8 | 0 | 91deg |")]
    {
        let mut rows = rows;
        rows[k] = change;
        let (code, out, _) = dh(&["compare", &file("other.dh", &table(&rows)), &craig], "");
        assert!(code == 1 && out.contains("the arms differ"), "{change}: {out}");
    }
    assert_eq!(dh(&["compare", &craig, &file("two.dh", &table(&rows[..2]))], "").0, 1);
    assert_eq!(dh(&["compare", &craig, &file("bad.dh", "struct")], "").0, 2);
    std::fs::remove_dir_all(folder).ok();
}

/// The protocol of mdBook's preprocessors.
#[test]
fn a_book_gets_its_notes() {
    assert_eq!(dh(&["mdbook", "supports", "html"], "").0, 0);
    assert_eq!(dh(&["mdbook", "supports", "epub"], "").0, 1);
    assert_eq!(dh(&["mdbook", "serve"], "").0, 2);
    let book = |table: &str| {
        let content = format!("# Arm\n\n```dh parts=forward\n{table}```\n").replace('\n', "\\n");
        format!(
            "[{{\"root\":\".\",\"config\":{{}}}},{{\"sections\":[{{\"Chapter\":{{\"content\":\"{content}\",\"path\":\"a.md\"}}}}]}}]"
        )
    };
    let (code, out, err) = dh(&["mdbook"], &book(PLANAR));
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(out.contains("## Forward kinematics") && out.contains("<math"), "{out}");
    let (code, out, err) = dh(&["mdbook"], &book(&PLANAR.replace("| 0     | l1 |", "| 0     | l9 |")));
    assert!(code == 2 && out.is_empty() && err.contains("a.md:12:") && err.contains("^^"), "{err}");
}

#[test]
fn a_folder_for_c_appears_whole_or_not_at_all() {
    let place = std::env::temp_dir().join(format!("dh-export-{}", std::process::id()));
    std::fs::create_dir_all(&place).expect("a folder");
    let out = place.join("new/planar");
    let out_text = out.to_string_lossy().into_owned();
    let export = |more: &[&str], input: &str| {
        let arguments = [&["export", "--to", "c", "--out", out_text.as_str()], more].concat();
        dh(&arguments, input)
    };
    let position = PLANAR.replace("convention", "task = position; convention");
    let (code, _, err) = export(&[], &position.replace("| 0     | l1 |", "| 0     | l9 |"));
    assert!(code == 2 && err.contains("^^") && !out.exists(), "{err}");
    for bad in [
        &["--name", "int"][..],
        &["--dh-robot", "/nowhere"],
        &["--fast"],
        &["a.dh", "b.dh"],
        &["--to", "ada"],
        &["--name"],
    ] {
        let (code, printed, err) = export(bad, &position);
        assert!(code == 2 && printed.is_empty() && err.starts_with("error: ") && !out.exists(), "{bad:?}: {err}");
    }
    assert_eq!((dh(&["export", "--to", "c"], &position).0, dh(&["export", "--out", "x"], &position).0), (2, 2));
    assert_eq!(export(&[], &format!("{position}prove {{ T(0,3).px = 0; }}")).0, 1);

    let (code, printed, err) = export(&["-"], &position);
    assert_eq!((code, printed.as_str()), (0, ""), "{err}");
    let read = |path: &str| std::fs::read_to_string(out.join(path)).unwrap_or_default();
    assert!(read("include/planar.h").contains("int planar_inverse(const double point[3]"));
    assert!(read("Cargo.toml").contains(&format!("dh-robot = '{}'", env!("CARGO_PKG_VERSION"))));

    // What is there is kept, unless one insists; then files of the same name are replaced and others stay.
    std::fs::write(out.join("mine.c"), "mine").expect("a file");
    std::fs::write(out.join("README.md"), "old").expect("a file");
    let (code, _, err) = export(&[], &position);
    assert!(code == 2 && err.contains("not empty") && read("README.md") == "old", "{err}");
    let crate_folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../dh-robot");
    assert_eq!(export(&["--force", "--dh-robot", crate_folder], &position).0, 0);
    assert!(read("README.md").starts_with("# planar") && read("mine.c") == "mine");
    assert!(read("Cargo.toml").contains("dh-robot = { path = '/"));
    let names = std::fs::read_dir(&out).expect("the folder").map(|e| e.expect("an entry").file_name());
    assert_eq!(names.filter(|name| name.to_string_lossy().contains("part")).count(), 0);
    std::fs::remove_dir_all(place).ok();
}
