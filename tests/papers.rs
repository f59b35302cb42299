//! Whole documents against their tables: the slides as printed, hand-typed derivations, and our own notes read back.

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::document::notes::Part;
use dh_symbolic::render::{Format, Options, notes};
use dh_symbolic::verify::check::{Report, Verdict};
use dh_symbolic::verify::document::DocumentClaims;
use dh_symbolic::verify::judge;
use dh_symbolic::verify::language::Statement;
use dh_symbolic::verify::listing::{CheckedLine, Finding, document_lines, document_text};
use dh_symbolic::verify::report::verdict_word;
use generated_examples::{corpus, source};
use std::path::Path;

fn chain(text: &str) -> Chain {
    Chain::new(parse(text.parse().expect("words")).spec.expect("a table"))
}

fn judged(chain: &Chain, text: &str) -> (DocumentClaims, Report) {
    judge(chain, text)
}

/// Numbers of lines that are wrong, and not understood.
fn faults(report: &Report) -> (usize, usize) {
    let count = |f: fn(&Verdict) -> bool| report.verdicts.iter().filter(|v| f(v)).count();
    (count(|v| matches!(v, Verdict::Wrong(_))), count(|v| matches!(v, Verdict::NotUnderstood(..))))
}

/// The PUMA as the slides print it (three wrong lines), as somebody types it, and as an article: with slips in each.
#[test]
fn derivations_of_the_puma() {
    let table = std::fs::read_to_string(corpus::folder().join("puma560.dh")).unwrap();
    let puma = chain(&table);
    let mut text = String::new();
    for name in ["puma560_slides.md", "puma560.txt", "puma560.tex"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("papers").join(name);
        let (paper, report) = judged(&puma, &std::fs::read_to_string(path).unwrap());
        text.push_str(&format!("=== {name}\n\n{}\n", document_text(&report, &paper)));
    }
    insta::assert_snapshot!("papers", text);
}

/// Notes whose inverse cannot be read back in full, with what the reader does not know.
const PARTLY: [(&str, &str); 2] = [
    ("leg_wheel", "values are given for the joint coordinates, not for the motors"),
    ("pieper", "products of transforms without any structure grow too large for the checker"),
];

/// The parts that are read back: those whose formulas are about the arm and not about regions of the plane.
const PARTS: [Part; 7] =
    [Part::Table, Part::Links, Part::Forward, Part::Jacobian, Part::Singular, Part::Inverse, Part::Example];

/// Everything that the notes print is read back, in every format that is read, and is true: link transforms, products, pose,
/// Jacobian, the derivation of the inverse, the worked example.
#[test]
fn printed_notes_are_read_back() {
    let mut read = 0;
    for source in source::all().unwrap() {
        let chain = chain(&source.body);
        let note = notes(&chain, &Options { parts: PARTS.to_vec(), ..Options::default() });
        for format in [Format::Latex, Format::Markdown, Format::Text] {
            let printed = note.print(format);
            let known = PARTLY.iter().any(|p| p.0 == source.module);
            let printed = if known { before_inverse(&printed) } else { &printed };
            let (paper, report) = judged(&chain, printed);
            let shown = || document_text(&report, &paper);
            // the determinant of an arm with a given joint is that of the other joints' columns
            let lines = paper.derivation.lines.iter().zip(&report.verdicts);
            let open = lines.filter(|(l, v)| {
                let of_part = chain.dof() > 6 && paper.derivation.text(&l.place).starts_with("det(J) =");
                of_part && matches!(v, Verdict::NotUnderstood(..))
            });
            let open = open.count();
            assert_eq!(faults(&report), (0, open), "{} as {format:?}:\n{}", source.module, shown());
            let proven = report.verdicts.iter().filter(|v| matches!(v, Verdict::Proven(_))).count();
            // transforms of the links and a product at least
            assert!(proven > chain.links.len(), "{} as {format:?}:\n{}", source.module, shown());
            read += proven;
        }
    }
    assert!(read > 1500, "{read}");
}

/// What stands before the first joint moves the first frame of the inverse: notes call it 0' and say by which transform.
#[test]
fn a_moved_first_frame_is_read_back() {
    let slides =
        "| d | theta | a | alpha |\n| q1 | 90deg | 0 | 90deg |\n| q2 | 90deg | 0 | 90deg |\n| q3 | 0 | 0 | 0 |\n";
    let wrist = "| 0.1 | q4 | 0 | 90deg |\n| 0 | q5 | 0 | -90deg |\n| 0.2 | q6 | 0 | 0 |\n";
    let turned = "| alpha | a | d | theta |\n| 90deg | 0.1 | 0.3 | q1 |\n| -90deg | 0 | 0.1 | q2 |\n| 0 | 0.4 | 0 | q3 |\n\
        | -90deg | 0.02 | 0.4 | q4 |\n| 90deg | 0 | 0 | q5 |\n| -90deg | 0 | 0.1 | q6 |\n";
    let base = "base = tz(0.5) * rx(30deg);";
    for (convention, base, rows) in [
        ("standard", "", [slides, wrist].concat()),
        ("standard", base, [slides, wrist].concat()),
        ("modified", "", turned.to_string()),
        ("modified", base, turned.to_string()),
    ] {
        let chain = chain(&format!("pub struct Arm; convention = {convention}; {base}\n{rows}"));
        let note = notes(&chain, &Options { parts: PARTS.to_vec(), ..Options::default() });
        for format in [Format::Latex, Format::Text] {
            let (paper, report) = judged(&chain, &note.print(format));
            assert_eq!(faults(&report), (0, 0), "{convention} {base}:\n{}", document_text(&report, &paper));
        }
    }
}

const PLANAR: &str = "struct P3; convention = standard;
    let l1 = 3; let l2 = 2; let l3 = 1;
    | theta | d | a | alpha |
    | q1 | 0 | l1 | 0 |
    | q2 | 0 | l2 | 0 |
    | q3 | 0 | l3 | 0 |";

const PLANAR_JACOBIAN: &str = r"
$$J = \begin{bmatrix} -3s_1 - 2s_{12} - s_{123} & -2 s_{12} - s_{123} & -s_{123} \\ 3c_1+2c_{12}+c_{123} & 2c_{12}+c_{123} & c_{123}
\\ 1 & 1 & 1\end{bmatrix}$$
$$\det J = 6 s_2$$
$$\det(J) = 6 c_2$$
$$\begin{bmatrix}\dot x\\ \dot y\\ \dot\phi\end{bmatrix} = J \begin{bmatrix} \dot q_1 \\ \dot q_2 \\ \dot q_3 \end{bmatrix}$$
$$\dot x = J \dot q$$
$$\dot\phi = \dot\theta_1 + \dot\theta_2 + \dot\theta_3$$
$$\omega_z = \dot\theta_1 + \dot\theta_2$$
$$\frac{\partial x}{\partial\theta_2} = -2 s_{12} - s_{123}$$
$$J^{-1} = \frac{1}{6 s_2} \begin{bmatrix} 2 c_{12} & 2 s_{12} & 2 s_3 \\ -3c_1 - 2 c_{12} & -3 s_1 - 2 s_{12} & -(3 s_{23} + 2 s_3)
\\ 3 c_1 & 3 s_1 & 3 s_{23} + 6 s_2\end{bmatrix}$$
$$\det J = 6 s_2 = 0$$
$$|J| = 6 s_2$$
$$J^T = \begin{bmatrix} -3s_1 - 2s_{12} - s_{123} & 3c_1+2c_{12}+c_{123} & 1 \\ -2 s_{12} - s_{123} & 2c_{12}+c_{123} & 1\\ -s_{123} & c_{123} & 1
\end{bmatrix}$$
$$J = \begin{bmatrix} -3s_1 - 2s_{12} - s_{123} & -2 s_{12} - s_{123} & -s_{123} \\ 3c_1+2c_{12}+c_{123} & 2c_{12}+c_{123} & c_{123}
\end{bmatrix}$$
$$J = \begin{bmatrix} -3s_1 - 2s_{12} - s_{123} & -2 s_{12} + s_{123} & -s_{123} \\ 3c_1+2c_{12}+c_{123} & 2c_{12}+c_{123} & c_{123}
\end{bmatrix}$$";

/// A Jacobian with fewer rows than six: which they are is seen from the other side of the equation.
#[test]
fn reduced_jacobians() {
    for task in ["", "task = planar;", "task = position;"] {
        let arm = chain(&PLANAR.replace("let l1", &format!("{task} let l1")));
        let (paper, report) = judged(&arm, PLANAR_JACOBIAN);
        let words: Vec<&str> = report
            .verdicts
            .iter()
            .zip(&paper.derivation.lines)
            .filter(|(_, l)| !matches!(l.statement, Statement::Free(..)))
            .map(|(v, _)| verdict_word(v))
            .collect();
        let expected = "proven proven wrong proven noted proven wrong proven proven proven proven proven proven wrong";
        assert_eq!(words.join(" "), expected, "{task}\n{}", document_text(&report, &paper));
    }
}

/// What stands before the heading of the inverse.
fn before_inverse(text: &str) -> &str {
    &text[..text.find("Singular configurations").or(text.find("Inverse kinematics")).expect("the heading")]
}

/// A letter that is printed wrongly is found: every seventh sine or cosine of the note of the PUMA, one at a time.
#[test]
fn a_misprint_is_found() {
    let source = source::all().unwrap().into_iter().find(|s| s.module == "puma560").unwrap();
    let chain = chain(&source.body);
    let printed = notes(&chain, &Options::default()).print(Format::Latex);
    let start = printed.find("Link transforms").unwrap();
    let end = printed.find("Singular configurations").unwrap();
    let places: Vec<usize> = printed[start..end]
        .match_indices(['c', 's'])
        .map(|(i, _)| start + i)
        .filter(|i| printed[i + 1..].starts_with(['_']) && !printed[i + 1..].starts_with("_i"))
        .collect();
    let mut found = 0;
    for i in places.iter().step_by(7) {
        let other = if printed[*i..].starts_with('c') { "s" } else { "c" };
        let wrong = format!("{}{other}{}", &printed[..*i], &printed[i + 1..end]);
        let line = wrong[..*i].lines().count();
        // the legend says what c is; a letter of its own there is no formula about the arm
        let legend = wrong.lines().nth(line - 1).is_some_and(|l| l.contains("\\cos"));
        let (_, report) = judged(&chain, &wrong);
        let bad = faults(&report).0 > 0;
        assert!(bad || legend, "line {line}: {}", wrong.lines().nth(line - 1).unwrap_or_default());
        found += usize::from(bad);
    }
    assert!(found > 30, "{found}");
}

/// The notes of tables of all kinds, as Markdown, given back: nothing is wrong, and at most two lines of a hundred are not understood.
fn read_back(tables: impl Iterator<Item = (String, String)>) {
    let (mut lines, mut unclear) = (0, 0);
    for (name, table) in tables {
        let spec = parse(table.parse().expect("words")).spec.unwrap_or_else(|| panic!("{name}: no table"));
        let chain = Chain::new(spec);
        let note = notes(&chain, &Options { parts: PARTS.to_vec(), ..Options::default() });
        let (claims, report) = judged(&chain, &note.print(Format::Markdown));
        let (wrong, open) = faults(&report);
        assert_eq!(wrong, 0, "{name}:\n{}", document_text(&report, &claims));
        (lines, unclear) = (lines + report.verdicts.len(), unclear + open);
    }
    assert!(lines > 0 && 50 * unclear <= lines, "{unclear} of {lines} lines are not understood");
}

/// The chapter as it is taught, of every third example: its laws for any quantities and its cases say nothing of the arm that is wrong.
#[test]
fn chapters_are_read_back() {
    let (mut lines, mut unclear) = (0, 0);
    for source in source::all().unwrap().iter().step_by(3) {
        let chain = chain(&source.body);
        let note = notes(&chain, &Options { parts: Part::CHAPTER.to_vec(), ..Options::default() });
        let (claims, report) = judged(&chain, &note.print(Format::Markdown));
        // the determinant of a coupled arm is printed for its joints
        let of_joints = usize::from(!chain.is_direct());
        let (wrong, open) = faults(&report);
        assert!(wrong <= of_joints, "{}:\n{}", source.module, document_text(&report, &claims));
        (lines, unclear) = (lines + report.verdicts.len(), unclear + open);
    }
    assert!(lines > 500 && 25 * unclear <= lines, "{unclear} of {lines} lines are not understood");
}

#[test]
fn notes_of_other_tables_are_read_back() {
    use crate::handwork::tables;
    let own = tables::OWN.iter().map(|(n, t)| (n.to_string(), t.to_string()));
    read_back(own);
}

#[test]
fn notes_of_all_fixtures_are_read_back() {
    use crate::fixtures::{list, read, table, text};
    let robots = read("robots.json");
    read_back(list(&robots).iter().map(|r| (text(&r["name"]).to_string(), table(r))));
}

/// Tables that people reported: `../shared/reports/public-cases.json`.
#[test]
fn notes_of_public_tables_are_read_back() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/reports/public-cases.json");
    let Ok(file) = std::fs::read_to_string(&path) else {
        assert!(std::env::var_os("CI").is_none(), "{} is missing", path.display());
        eprintln!("skipped: {} is missing", path.display());
        return;
    };
    let cases: serde_json::Value = serde_json::from_str(&file).expect("JSON");
    let tables = cases.as_array().expect("a list").iter().flat_map(|case| {
        let name = case["id"].as_str().unwrap_or_default().to_string();
        let list: Vec<String> = match &case["table"] {
            serde_json::Value::String(t) => vec![t.clone()],
            serde_json::Value::Array(l) => l.iter().filter_map(|t| Some(t.as_str()?.to_string())).collect(),
            _ => Vec::new(),
        };
        list.into_iter().map(move |t| (name.clone(), t)).collect::<Vec<_>>()
    });
    read_back(tables);
}

/// The slides that the project grew out of, as their text was extracted, against each of the arms that they speak of: the slips of the PUMA
/// are found, nothing that is true is called wrong, and at most one formula in twenty is not understood.
#[test]
fn slides_of_several_arms_are_judged_fairly() {
    for (table, slides, expected) in [
        ("puma560", "000_9042cf5d4e2f9f01.txt", vec![1342, 1382, 1390]),
        ("planar_inverse", "004_782d5a12be52cebf.txt", vec![]),
        ("pieper", "004_782d5a12be52cebf.txt", vec![]),
        ("cup", "004_782d5a12be52cebf.txt", vec![]),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/seeds").join(slides);
        let Ok(text) = std::fs::read_to_string(&path) else {
            assert!(std::env::var_os("CI").is_none(), "{} is missing", path.display());
            eprintln!("skipped: {} is missing", path.display());
            return;
        };
        let arm = chain(&std::fs::read_to_string(corpus::folder().join(format!("{table}.dh"))).unwrap());
        let (paper, report) = judged(&arm, &text);
        let lines = document_lines(&report, &paper);
        let wrong: Vec<usize> = lines.iter().filter(|l| l.finding == Finding::Wrong).map(|l| l.line).collect();
        assert_eq!(wrong, expected, "{table}:\n{}", document_text(&report, &paper));
        let unclear = lines.iter().filter(|l| l.finding == Finding::Unclear).count();
        assert!(20 * unclear <= lines.len(), "{table}: {unclear} of {} are not understood", lines.len());
        if table == "pieper" {
            // f, g, k, r and z: every line but the one with the norm of a vector of numbers
            let method = |l: &&CheckedLine| (380..450).contains(&l.line);
            let open = lines.iter().filter(method).find(|l| l.finding == Finding::Unclear);
            assert!(open.is_none(), "{open:?}");
            assert!(lines.iter().filter(method).filter(|l| l.finding == Finding::Proven).count() > 8);
        }
    }
}

/// Letters that change their meaning, laws for any quantities, and cases.
#[test]
fn letters_mean_what_the_document_says_there() {
    let arm = chain(
        &PLANAR.replace("let l1 = 3; let l2 = 2; let l3 = 1;", "let l1: length; let l2: length; let l3: length;"),
    );
    let findings = |text: &str| {
        let (paper, report) = judged(&arm, text);
        document_lines(&report, &paper).iter().map(|l| l.finding.word()).collect::<Vec<_>>().join(" ")
    };
    // another r further down, and a slip in what repeats a definition
    let anew = "$$r = l_1 + l_2 c_2$$\n\n$${}^0_2T p_x = r c_1 - l_2 s_2 s_1$$\n\n$$r = l_1^2 + l_3^2 + 2 l_2 l_3$$\n\n$$r = (l_1)^2 + l_3 (l_3 + 2 l_2)$$";
    assert_eq!(findings(anew), "definition proven definition proven");
    let slip = "$$r = l_1 + l_2 c_2$$\n\n$${}^0_2T p_x = r c_1 - l_2 s_2 s_1$$\n\n$$r = l_1 + l_2 s_2$$";
    assert_eq!(findings(slip), "definition proven wrong");
    let law = "$$a\\cos\\theta + b\\sin\\theta = c$$\n\n$$u = \\tan\\frac{\\theta}{2}$$\n\n$$(a + c) u^2 - 2 b u + (c - a) = 0$$\n\n$$u = \\tan\\frac{\\theta_3}{2}$$\n\n$$c_3 = \\frac{1 - u^2}{1 + u^2}$$";
    assert_eq!(findings(law), "definition definition proven definition proven");
    let case = "If $l_3 = 0$, $p_x = l_1 c_1 + l_2 c_{12}$; if $l_2 = 0$\n\nIf $l_2 = 0$, $p_x = l_1 c_1 + l_2 c_{12}$";
    assert_eq!(findings(case), "definition proven definition definition wrong");
}
