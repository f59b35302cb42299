//! Tables made from URDF files: their poses are those of the file, by a product of transforms that is written here anew.

mod oracle;
mod others;

use std::fs;
use std::path::{Path, PathBuf};

use dh_symbolic::chain::{Chain, Convention};
use dh_symbolic::import::{Imported, Options, Rounding, from_urdf};
use dh_symbolic::planner;
use dh_symbolic::program::Inverse;
use dh_tests::engine::spec;
use dh_tests::naive::Arm;
use oracle::{difference, pose, product, steps, transform};

fn options(convention: Convention, rounding: Rounding) -> Options {
    Options { convention: Some(convention), rounding, ..Options::default() }
}

const BOTH: [Convention; 2] = [Convention::Modified, Convention::Standard];

/// An arm whose table is made from its file while the macro runs.
mod from_file {
    dh_robot::dh_robot! {
        /// The arm on the bench.
        pub struct BenchArm;

        convention = standard;
        urdf = "urdf/bench_arm.urdf";
        chain = base_link..tool0;
        tool = tz(0.1);
    }
}

/// Checks poses in both conventions, as written and rounded, and that the arm is inverted.
fn check(name: &str, text: &str, tip: Option<&str>) -> Vec<Imported> {
    let mut all = Vec::new();
    for convention in BOTH {
        // The second opinion undoes the rounding of angles, not of lengths, which may move by 1e-5 of the reach. As written, angles of less
        // than 1e-9 rad are rounded still: some makers' files hold them.
        for (rounding, exact, most) in [(Rounding::Near, 1e-3, 1e-5), (Rounding::AsWritten, 1e-9, 1e-9)] {
            let options = Options { tip: tip.map(str::to_string), ..options(convention, rounding) };
            let made = from_urdf(text, &options).unwrap_or_else(|e| panic!("{name}: {}", e.draw(text, name)));
            let off = difference(text, &made, exact);
            assert!(off < most, "{name} {convention:?} {rounding:?}: {off:e}\n{}\n{:#?}", made.table, made.notes);
            if rounding == Rounding::Near {
                let chain = Chain::new(spec(&made.table));
                if chain.settings.ik {
                    let plan = planner::search(&chain).unwrap_or_else(|e| panic!("{name}: {e:?}"));
                    let missed = Inverse::derive(&chain, plan).check(&chain, 4);
                    assert_eq!(missed, Ok(()), "{name}: {}", made.table);
                }
                all.push(made);
            }
        }
    }
    all
}

/// The folder of URDF files of makers and users; `None` where it is not there (an error under CI).
fn fixtures() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/fixtures/urdf");
    if folder.is_dir() {
        return Some(folder);
    }
    assert!(std::env::var_os("CI").is_none(), "{} is missing", folder.display());
    eprintln!("skipped: {} is missing", folder.display());
    None
}

#[test]
fn arms_of_makers_and_users() {
    let Some(folder) = fixtures() else { return };
    let mut files: Vec<PathBuf> = fs::read_dir(folder).expect("a folder").map(|e| e.expect("a file").path()).collect();
    files.retain(|f| f.extension().is_some_and(|e| e == "urdf"));
    files.sort();
    assert_eq!(files.len(), 35);
    for file in files {
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        let text = fs::read_to_string(&file).expect("text");
        let tip = match name.as_str() {
            "yumi_left_ik" => Some("gripper_l_base"),
            "openarm_left" => Some("openarm_left_ee_base_link"),
            _ => None,
        };
        if tip.is_some() {
            let problem = from_urdf(&text, &Options::default()).expect_err("two arms");
            assert!(problem.help.is_some_and(|h| h.contains("moving joints")), "{name}");
        }
        for made in check(&name, &text, tip) {
            assert!(!made.table.contains("ik = none"), "{name}: {}", made.table);
        }
    }
}

/// A chain of joints `joint_1`, ... between links `link_0`, ...: type, xyz, rpy, axis, more elements.
fn serial(joints: &[[&str; 5]]) -> String {
    let mut out = String::from("<robot name=\"test arm\">\n  <link name=\"link_0\"/>\n");
    for (i, [kind, xyz, rpy, axis, more]) in joints.iter().enumerate() {
        let n = i + 1;
        out += &format!("  <link name=\"link_{n}\"/>\n  <joint name=\"joint_{n}\" type=\"{kind}\">\n");
        out += &format!("    <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>\n    <parent link=\"link_{i}\"/>\n");
        out += &format!("    <child link=\"link_{n}\"/>\n    <axis xyz=\"{axis}\"/>\n{more}  </joint>\n");
    }
    out + "</robot>\n"
}

/// The rows of a table: the line behind the rule and all that follow, without labels.
fn rows(made: &Imported) -> Vec<Vec<String>> {
    let lines = made.table.lines().filter(|l| l.starts_with("| ") && !l.starts_with("| joint "));
    let cells = |l: &str| l.split('|').skip(1).map(|c| c.trim().to_string()).collect::<Vec<_>>();
    lines.map(|l| cells(l.trim_end_matches('|'))).collect()
}

#[test]
fn rounded_angles_are_told() {
    let text = serial(&[
        ["revolute", "0 0 0.3", "0 0 0", "0 0 1", "<limit lower=\"-2.9671\" upper=\"2.6\"/>\n"],
        ["revolute", "0 0 0.1", "-1.5708 0 0", "0 0 1", ""],
        ["revolute", "0.4 0 0", "0 0 1.57", "0 0 1", ""],
        ["revolute", "0 -0.3 0", "1.571 0 0", "0 0 1", "<limit lower=\"2\" upper=\"-2\"/>\n"],
        ["revolute", "0 0 0", "-1.5707963 0 0", "0 0 1", ""],
        ["continuous", "0 -0.1 0", "1.5707963267948966 0 0", "0 0 1", ""],
        ["fixed", "0 0 0.05", "0 0 3.14159", "1 0 0", ""],
    ]);
    let made = check("rounded", &text, None);
    let notes = made[0].notes.join("\n");
    for part in [
        "chain link_0..link_7, 6 moving joints",
        "joint_2 twist -1.5708 -> -90deg, off by 3.7e-6",
        "joint_4 twist 1.571 -> 90deg, off by 2.0e-4",
        "joint_3 yaw 1.57 -> 90deg, off by 8.0e-4",
        "joint_7 yaw 3.14159 -> 180deg, off by 2.7e-6",
        "joint_4: its limits came reversed, 2 to -2",
        "axes 2 and 3 are parallel",
        "axes 4, 5 and 6 meet in one point",
        "6 joints; inverse by closed form, at most 8 solutions",
    ] {
        assert!(notes.contains(part), "{part}\n{notes}");
    }
    let table = rows(&made[0]);
    assert_eq!(table[0], ["joint_1", "0", "0", "0.4", "q1", "-170deg..=2.6rad"]);
    assert_eq!(table[3][5], "-2rad..=2rad");
    assert!(made[0].table.contains("pub struct TestArm;"), "{}", made[0].table);
    let written = from_urdf(&text, &options(Convention::Modified, Rounding::AsWritten)).expect("a table");
    assert!(written.table.contains("approx"), "{}", written.table);
}

#[test]
fn axes_in_any_position() {
    // Skew, meeting, the same line, opposite, parallel, sliding ones, along any direction.
    let text = serial(&[
        ["prismatic", "0.1 0.2 0.3", "0.3 -0.2 0.1", "1 1 0", "<limit lower=\"-0.5\" upper=\"0.5\"/>\n"],
        ["revolute", "0.1 -0.2 0.3", "0.7 0.2 -0.4", "0.2 -0.5 0.9", ""],
        ["revolute", "0.02 -0.05 0.09", "0 0 0", "0.2 -0.5 0.9", ""],
        ["revolute", "0.1 0.3 0.2", "0 0 0", "-0.2 0.5 -0.9", ""],
        ["fixed", "0.1 0 0", "1 2 3", "1 0 0", ""],
        ["revolute", "0 0 0", "0 0.2 0", "0 1 0", ""],
        ["revolute", "0 0 0", "0.4 0 0.3", "0 0 -1", ""],
        ["continuous", "0 0.2 0.1", "0.4 1.3 0.3", "0 -1 0", ""],
        ["fixed", "0.3 0.1 0.2", "0.5 -1 2", "1 0 0", ""],
    ]);
    let made = check("any", &text, None);
    assert!(made[0].notes.iter().any(|n| n.contains("axes 2, 3 and 4 are parallel")), "{:#?}", made[0].notes);
    let table = rows(&made[0]);
    // The second and third axis are one line.
    assert_eq!((table[2][1].as_str(), table[2][2].as_str()), ("0", "0"));
    assert_eq!((table[3][1].as_str(), table[3][5].as_str()), ("180deg", "-"));
    assert_eq!(table[0][5], "-0.5..=0.5");
}

#[test]
fn joints_that_follow_others() {
    let text = serial(&[
        ["revolute", "0 0 0.2", "0 0 0", "0 0 1", ""],
        ["revolute", "0 0 0.1", "1.5708 0 0", "0 0 1", ""],
        ["revolute", "0.4 0 0", "0 0 0.3", "0 0 1", ""],
        ["revolute", "0.3 0 0", "0 0 0", "0 0 1", "<mimic joint=\"joint_2\" multiplier=\"-0.5\" offset=\"0.25\"/>\n"],
        ["prismatic", "0.1 0 0", "0 1.5708 0", "0 0 -1", "<mimic joint=\"joint_3\" multiplier=\"0.02\"/>\n"],
    ]);
    let made = check("follows", &text, None);
    let notes = made[0].notes.join("\n");
    assert!(
        notes.contains("joint_4 follows joint_2: -0.5 * joint_2 + 0.25; its own variable q4 stays at 0"),
        "{notes}"
    );
    let table = rows(&made[0]);
    assert!(table[3][4].starts_with("-0.5*q2 + q4 "), "{}", made[0].table);
    assert_eq!(table[3][5], "0deg..=0deg");
    assert!(table[4][3].starts_with("0.02*q3 + q5"), "{}", made[0].table);
    let circle = text.replacen("</joint>", "<mimic joint=\"joint_1\"/></joint>", 1);
    assert!(from_urdf(&circle, &Options::default()).expect_err("itself").message.contains("follows itself"));
}

#[test]
fn a_file_in_the_macro() {
    let arm = from_file::BenchArm;
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("urdf/bench_arm.urdf")).expect("text");
    let steps = steps(&text, "base_link", "tool0", 1e-3);
    let q = [0.3, -1.1, 0.7, 0.4, -0.9, 1.2];
    let tool = transform([0.0, 0.0, 0.1], [0.0; 3]);
    let want = product(&pose(&steps, &q), &tool);
    let have = arm.forward(&q);
    for i in 0..3 {
        assert!((have.translation.vector[i] - want[i][3]).abs() < 1e-12);
        for j in 0..3 {
            assert!((have.rotation.matrix()[(i, j)] - want[i][j]).abs() < 1e-12);
        }
    }
    let solutions = arm.inverse(&have);
    let own = |s: &dh_robot::Solution<f64, 6>| s.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(solutions.iter().any(own));
    assert_eq!(from_file::BenchArm::JOINTS[1].label, "shoulder_lift");
}

/// A number from -1 to 1, the same in each run.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

#[test]
fn random_chains() {
    let mut seed = 5;
    for round in 0..30 {
        let mut joints: Vec<[String; 5]> = Vec::new();
        for _ in 0..6 {
            let mut number = |digits: usize| format!("{:.digits$}", random(&mut seed));
            let xyz = format!("{} {} {}", number(3), number(2), number(4));
            let mut rpy = format!("{} {} {}", number(4), number(6), number(2));
            let mut axis = format!("{} {} {}", number(2), number(3), number(1));
            let dice = (random(&mut seed) * 8.0).abs() as usize;
            match dice {
                0 => rpy = "0 0 0".into(),
                1 => rpy = "1.5708 0 -1.57".into(),
                2 => rpy = "0.785398 3.1416 0".into(),
                3 => axis = "0 0 1".into(),
                4 => (rpy, axis) = ("0 0 0".into(), "0 0 1".into()),
                5 => (rpy, axis) = ("0 1.5708 0".into(), "0 0 1".into()),
                _ => {}
            }
            let kind = if (dice + joints.len()) % 5 == 4 { "prismatic" } else { "revolute" };
            joints.push([kind.into(), xyz, rpy, axis, String::new()]);
        }
        let list: Vec<[&str; 5]> = joints.iter().map(|j| std::array::from_fn(|i| j[i].as_str())).collect();
        let text = serial(&list);
        for convention in BOTH {
            for (rounding, exact) in [(Rounding::Near, 1e-3), (Rounding::AsWritten, 1e-9)] {
                let made = from_urdf(&text, &options(convention, rounding)).unwrap_or_else(|e| panic!("{e:?}\n{text}"));
                let off = difference(&text, &made, exact);
                // Chance makes a right angle now and then.
                let rounded =
                    made.notes.iter().any(|n| (n.contains(" twist ") && n.contains("->")) || n.ends_with("-> 0"));
                assert!(
                    off < if rounded { 1e-3 } else { 1e-11 },
                    "{round} {rounding:?}: {off:e}\n{text}\n{}",
                    made.table
                );
            }
        }
    }
}

#[test]
fn nearly_parallel_axes_have_short_links() {
    let tilted = |tilt: &str| {
        serial(&[
            ["revolute", "0 0 0.16", "0 0 0", "0 0 1", ""],
            ["revolute", "0 0 0", "1.5708 0 0", "0 0 1", ""],
            ["revolute", "0.425 0.0001 0.0002", tilt, "0 0 1", ""],
            ["revolute", "0.392 0 0.13", "0.0021 -0.0017 0.02", "0 0 1", ""],
            ["revolute", "0 -0.1 0", "1.5708 0 0", "0 0 1", ""],
            ["revolute", "0 0.1 0", "-1.5708 0 0", "0 0 1", ""],
        ])
    };
    // Small enough to be rounding; then not.
    for (tilt, parallel) in [("0.0004 0.0003 0", true), ("0.004 -0.003 0", false)] {
        let text = tilted(tilt);
        for convention in BOTH {
            for rounding in [Rounding::Near, Rounding::AsWritten] {
                let made = from_urdf(&text, &options(convention, rounding)).expect("a table");
                let arm = Arm::new(&spec(&made.table), &|_| 0.0);
                assert!(arm.rows.iter().all(|r| r.d.abs() < 1.0 && r.a.abs() < 1.0), "{}", made.table);
                let joined = made.notes.iter().any(|n| n.contains("axes 2 and 3 are parallel"));
                assert_eq!(joined, parallel && rounding == Rounding::Near, "{:#?}", made.notes);
                if rounding == Rounding::AsWritten || !parallel {
                    let exact = if rounding == Rounding::Near { 1e-3 } else { 1e-9 };
                    let off = difference(&text, &made, exact);
                    assert!(off < 1e-12, "{tilt} {rounding:?}: {off:e}\n{}", made.table);
                }
            }
        }
    }
}

#[test]
fn the_chain_is_chosen() {
    let joint = |name: &str, kind: &str, parent: &str, child: &str, more: &str| {
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><origin xyz=\"0.1 0 0.2\" rpy=\"1.5708 0 0\"/>\
             <parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"0 0 1\"/>{more}</joint>\n"
        )
    };
    let links = |names: &[&str]| names.iter().map(|n| format!("<link name=\"{n}\"/>")).collect::<String>();
    let arm = joint("a", "revolute", "base", "one", "")
        + &joint("b", "revolute", "one", "two", "")
        + &joint("c", "revolute", "two", "three", "");
    let names = ["base", "one", "two", "three", "flange", "camera", "left", "right"];
    let hand = joint("f", "fixed", "three", "flange", "")
        + &joint("k", "fixed", "one", "camera", "")
        + &joint("l", "prismatic", "flange", "left", "")
        + &joint("r", "prismatic", "flange", "right", "<mimic joint=\"l\" multiplier=\"-1\"/>");
    let hand_text = format!("<robot name=\"hand\">{}{arm}{hand}</robot>", links(&names));
    let made = from_urdf(&hand_text, &Options::default()).expect("a table");
    assert_eq!(made.notes[0], "chain base..flange, 3 moving joints");
    assert!(made.notes.contains(&"left out, since they are not on the chain: l, r (follows l)".to_string()));
    // Both fingers, and a part of the arm.
    for (base, tip, chain) in [
        (None, "right", "chain base..right, 4 moving joints"),
        (Some("one"), "three", "chain one..three, 2 moving joints"),
    ] {
        let options = Options { base: base.map(str::to_string), tip: Some(tip.into()), ..Options::default() };
        let made = from_urdf(&hand_text, &options).expect("a table");
        assert_eq!(made.notes[0], chain);
        assert!(difference(&hand_text, &made, 1e-3) < 1e-12);
    }
    // Two arms: a list to choose from.
    let second = joint("d", "revolute", "base", "left", "")
        + &joint("e", "revolute", "left", "right", "")
        + &joint("g", "revolute", "right", "camera", "");
    let two = format!("<robot name=\"two\">{}{arm}{second}</robot>", links(&names[..8]));
    let problem = from_urdf(&two, &Options { base: Some("base".into()), ..Options::default() }).expect_err("two arms");
    assert_eq!(problem.message, "several chains come into question");
    let help = problem.help.expect("a list");
    assert!(
        help.contains("base..three  (3 moving joints)") && help.contains("base..camera  (3 moving joints)"),
        "{help}"
    );
}

#[test]
fn what_is_wrong_has_its_line() {
    let good =
        serial(&[["revolute", "0 0 0.3", "0 0 0", "0 0 1", ""], ["revolute", "0 0 0.1", "-1.5708 0 0", "0 0 1", ""]]);
    assert!(from_urdf(&good, &Options::default()).is_ok());
    let replaced = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, to, 1)
    };
    let xacro = good.replacen("<robot", "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"", 1);
    let cases = [
        (replaced("</joint>", "</join>"), Some(9), "this is no XML"),
        (replaced("0 0 1\"", "0 0 0\""), Some(8), "the axis of joint `joint_1` has no direction"),
        (replaced("0 0 0.3", "0 nan 0.3"), Some(5), "`nan` is not finite"),
        (replaced("0 0 0.3", "0 0 1e9"), Some(5), "`1e9` is beyond all reason"),
        (replaced("0 0 0.3", "0 0"), Some(5), "`xyz` takes three numbers, and this is `0 0`"),
        (replaced("0 0 0.3", "0 0 ${h}"), Some(5), "`${h}` is a property of xacro"),
        (replaced("0 0 0.3", "0 0 a"), Some(5), "`a` is no number"),
        (replaced("parent link=\"link_0\"", "parent link=\"lost\""), Some(6), "there is no link `lost`"),
        (replaced("parent link=\"link_0\"", "parent link=\"link_2\""), Some(4), "the links run in a circle"),
        (
            replaced(
                "parent link=\"link_1\"/>\n    <child link=\"link_2\"",
                "parent link=\"link_0\"/>\n    <child link=\"link_1\"",
            ),
            Some(11),
            "link `link_1` is the child of `joint_1` already",
        ),
        (replaced("type=\"revolute\"", "type=\"floating\""), Some(4), "joint `joint_1` has several degrees of freedom"),
        (replaced("type=\"revolute\"", "type=\"rotary\""), Some(4), "joint `joint_1` has the unknown type `rotary`"),
        (replaced("joint_2", "joint_1"), Some(11), "there are two joints `joint_1`"),
        (replaced("link name=\"link_2\"", "link name=\"link_1\""), Some(10), "there are two links `link_1`"),
        (good.replace("revolute", "fixed"), None, "nothing moves between `link_0` and `link_2`"),
        (xacro.replacen("<link", "<xacro:include filename=\"a\"/><link", 1), Some(2), "this is a xacro file"),
        ("<html></html>".into(), Some(1), "this is no URDF file: its root is `html`"),
        ("<robot/>".into(), Some(1), "there is no joint in this file"),
        (" ".into(), None, "the file is empty"),
        ("<!DOCTYPE a [<!ENTITY b \"c\">]><robot/>".into(), Some(1), "this is no XML"),
    ];
    for (text, line, message) in cases {
        let problem = from_urdf(&text, &Options::default()).expect_err(message);
        assert!(problem.message.starts_with(message), "{message}: {problem:?}");
        assert_eq!(problem.at.map(|at| at.0), line, "{message}: {problem:?}");
    }
    let problem = from_urdf(&good, &Options { tip: Some("tool".into()), ..Options::default() }).expect_err("no tool");
    assert_eq!(problem.help.as_deref(), Some("the links: link_0, link_1, link_2"));
    let drawn = from_urdf(&replaced("0 0 0.3", "0 nan 0.3"), &Options::default()).expect_err("nan");
    let picture = drawn.draw(&replaced("0 0 0.3", "0 nan 0.3"), "arm.urdf");
    assert!(picture.contains(" --> arm.urdf:5:18\n"), "{picture}");
    // Deep and long input ends.
    let deep = format!("<robot>{}", "<a>".repeat(200_000));
    assert!(from_urdf(&deep, &Options::default()).is_err());
}
