//! Determinants of known arms.

use super::*;
use crate::chain::table::parse;

fn chain(table: &str) -> Chain {
    let tokens = crate::diagnostic::lex(table).unwrap_or_else(|e| panic!("{}", e.draw(table, "table")));
    let parsed = parse(tokens);
    Chain::new(parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(table, "table"))))
}

/// `-1 * a2 * (a3*s3 + d4*c3) * ...` and the meanings of the factors that move.
fn show(table: &str) -> (String, Vec<Option<Degeneracy>>) {
    let chain = chain(table);
    match singular(&chain, &Kinematics::new(&chain)) {
        Singular::Determinant(d) => {
            let power = |f: &DeterminantFactor| vec![chain.ring.text(&f.value); f.power as usize].join(" * ");
            let list: Vec<String> = d.factors.iter().map(power).collect();
            let kinds = d.factors.iter().filter(|f| f.moves).map(|f| f.meaning.map(|m| m.kind)).collect();
            (format!("{} * {}", d.number, list.join(" * ")), kinds)
        }
        other => (format!("{other:?}"), Vec::new()),
    }
}

fn rows(head: &str, rows: &[&str]) -> String {
    let columns = if head.contains("standard") { "theta | d | a | alpha" } else { "alpha | a | d | theta" };
    let rows: String = rows.iter().map(|r| format!("| {r} |\n")).collect();
    format!("pub struct Arm; {head}\n| {columns} |\n|-|-|-|-|\n{rows}")
}

#[test]
fn an_arm_with_a_spherical_wrist() {
    let lengths = "let a2: length; let a3: length; let d3: length; let d4: length;";
    let head = format!("convention = modified; {lengths}");
    let puma = ["0|0|0|q1", "-90deg|0|0|q2", "0|a2|d3|q3", "-90deg|a3|d4|q4", "90deg|0|0|q5", "-90deg|0|0|q6"];
    let (text, kinds) = show(&rows(&head, &puma));
    assert_eq!(text, "-1 * a2 * a2*c2 + a3*c23 - d4*s23 * a3*s3 + d4*c3 * s5");
    let [shoulder, elbow, wrist] = kinds[..] else { panic!("{kinds:?}") };
    assert_eq!(shoulder, Some(Degeneracy::InPlane(ReferenceFrame::Link(4), 0, 1)));
    assert_eq!(elbow, Some(Degeneracy::Stretched(1, 2, ReferenceFrame::Link(4))));
    assert_eq!(wrist, Some(Degeneracy::Parallel(3, 5)));
    // Without the offset d3 the wrist comes to lie on the first axis itself.
    let puma = puma.map(|r| r.replace("d3", "0"));
    let (_, kinds) = show(&rows(&head, &puma.each_ref().map(String::as_str)));
    assert_eq!(kinds[0], Some(Degeneracy::OnAxis(ReferenceFrame::Link(4), 0)));
}

#[test]
fn an_arm_with_three_parallel_axes() {
    let head = "convention = standard; let d1: length; let a2: length; let a3: length; let d4: length; let d5: length; let d6: length;";
    let arm = ["q1|d1|0|90deg", "q2|0|a2|0", "q3|0|a3|0", "q4|d4|0|90deg", "q5|d5|0|-90deg", "q6|d6|0|0"];
    let (text, kinds) = show(&rows(head, &arm));
    assert_eq!(text, "1 * a2 * a3 * s5 * a2*c2 + a3*c23 + d5*s234 * s3");
    let expected =
        [Degeneracy::Parallel(3, 5), Degeneracy::InPlane(ReferenceFrame::Link(5), 0, 1), Degeneracy::Axes(1, 2, 3)];
    assert_eq!(kinds, expected.map(Some));
}

#[test]
fn slides_and_arms_with_few_joints() {
    let stanford = ["q1|0|0|-90deg", "q2|d2|0|90deg", "0|q3|0|0", "q4|0|0|-90deg", "q5|0|0|90deg", "q6|0|0|0"];
    let (text, kinds) = show(&rows("convention = standard; let d2: length;", &stanford));
    assert_eq!(text, "1 * q3 * q3 * s2 * s5");
    assert_eq!(kinds[0], Some(Degeneracy::OnAxis(ReferenceFrame::Link(3), 1)));
    let planar = ["0|0|0|q1", "0|l1|0|q2"];
    let head = |task: &str| format!("convention = modified; {task} let l1: length; let l2: length; tool = tx(l2);");
    let elbow = vec![Some(Degeneracy::Stretched(0, 1, ReferenceFrame::Tool))];
    assert_eq!(show(&rows(&head("task = position;"), &planar)), ("1 * l1 * l2 * s2".into(), elbow.clone()));
    assert_eq!(show(&rows(&head(""), &planar)), ("1 * l1 * l2 * s2".into(), elbow));
    let scara = ["0|0|0|q1", "0|l1|0|q2", "0|l2|0|q3", "180deg|0|q4|0"];
    let (text, kinds) = show(&rows(&head(""), &scara));
    assert_eq!((text.as_str(), &kinds[..]), ("1 * l1 * l2 * s2", &[Some(Degeneracy::Axes(0, 1, 2))][..]));
    // The roll of the tool is the last joint: it cannot help.
    let idle = ["q1|0|0|90deg", "q2|0|0.5|0", "q3|0|0.4|0", "q4|0|0|-90deg", "q5|0.2|0|0"];
    assert_eq!(show(&rows("convention = standard; task = axis;", &idle)).0, "Everywhere");
    assert_eq!(show(&rows("convention = standard;", &idle[..4])).0, "NotSquare");
}

/// The number in front is compared with the Jacobian's determinant; this makes sure that the comparison can fail.
#[test]
fn a_wrong_factor_is_found() {
    let planar = chain(&rows(
        "convention = modified; task = position; let l1: length; tool = tx(0.3);",
        &["0|0|0|q1", "0|l1|0|q2"],
    ));
    let k = Kinematics::new(&planar);
    let Singular::Determinant(mut d) = singular(&planar, &k) else { panic!("no determinant") };
    let points = [FieldPoint::new(7), FieldPoint::new(8)];
    let views = points.map(|at| View { chain: &planar, frames: frames(&k, &at) });
    let truths: Vec<Element> =
        points.iter().zip(&views).map(|(at, v)| truth(&planar, &k, at, v, &d.joints, &d.open)).collect();
    assert!(d.agree(&points, &truths));
    d.factors[0].power += 1;
    assert!(!d.agree(&points, &truths));
}
