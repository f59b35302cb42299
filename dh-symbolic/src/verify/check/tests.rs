//! Tests of verdicts on single lines.

mod angles;

use super::*;
use crate::chain::table::parse;
use crate::verify::Claims;
use crate::verify::report::derivation_report;

/// A table with a `prove` block, checked; the verdicts as text.
pub(super) fn verdicts(text: &str) -> String {
    let parsed = parse(text.parse().unwrap());
    let errors = parsed.errors.to_compile_errors().to_string();
    let chain = Chain::new(parsed.spec.unwrap_or_else(|| panic!("{errors}")));
    let claims = Claims::read(&parsed.claims);
    let report = check(&chain, &claims.derivation);
    derivation_report(&report, &claims.derivation)
}

pub(super) fn puma(claims: &str) -> String {
    verdicts(&format!(
        "pub struct Puma; convention = modified;
        let a2: length; let a3: length; let d3: length; let d4: length;
        | alpha | a | d | theta |
        | 0 | 0 | 0 | q1 |
        | -90deg | 0 | 0 | q2 |
        | 0 | a2 | d3 | q3 |
        | -90deg | a3 | d4 | q4 |
        | 90deg | 0 | 0 | q5 |
        | -90deg | 0 | 0 | q6 |
        prove {{ {claims} }}"
    ))
}

#[test]
fn puma_lines() {
    let text = puma(
        "T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, -c23, 0, -a2*s2; 0, 0, 0, 1];
        T(1,6).r11 = c23*(c4*c5*c6 - s4*s6) - s23*s5*s6;
        T(0,6).r11 = c1*(c23*(c4*c5*c6 - s4*s5) - s23*s5*c5) + s1*(s4*c5*c6 + c4*s6);
        T(0,6).r22 = s1*(s23*(-c4*c5*s6 - s4*c6) + s23*s5*s6) - c1*(c4*c6 - s4*c5*s6);
        T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
        T(0,6).px = c1*(a2*c2 + a3*c23 + d4*s23) - d3*s1;
        subst(T(3,6), q4 = q4 + 180deg, q5 = -q5, q6 = q6 + 180deg) = T(3,6);
        T(3,6).R = Rz(q4)*Ry(q5)*Rz(q6);
        x = 3; T(0,9).px = 0; T(0,6) = I3; c8 = 1; a7 = 0; (q1 = 2); 2 x = 3;
        ",
    );
    insta::assert_snapshot!(text);
}

/// The first word of every verdict.
fn words(table: &str, claims: &str) -> Vec<String> {
    let text = verdicts(&format!("pub struct Arm; {table} prove {{ {claims} }}"));
    let starts = ["proven", "agrees", "wrong", "unclear", "noted"];
    let first = |l: &str| l.split_whitespace().next().map(str::to_string);
    text.lines().filter(|l| !l.starts_with(' ')).filter_map(first).filter(|w| starts.contains(&w.as_str())).collect()
}

#[test]
fn names_mean_what_the_table_says() {
    let table = "convention = standard; let l: length; let beta: angle;
        | theta | d | a | alpha |
        | q1 - 90deg | 0.5 | l | beta |
        | 30deg | q2 + 0.25 | 0 | 20deg |";
    let claims = "theta1 = q1 - 90deg; c1 = cos(q1); c1 = cos(theta1); d1 = 0.5; d1 = 50cm; a1 = l; alpha1 = beta;
        sa1 = sin(beta); ca2 = cos(20deg); d2 = q2 + 0.25; theta2 = pi/6; T(0,1).r11 = s1; T(1,0) = inv(T(0,1));
        a3 = 0; c2 = 1; A(2) = T(1,2); sbeta^2 + cbeta^2 = 1;";
    let expected = "proven proven wrong proven proven proven proven
        proven proven proven proven proven proven
        unclear unclear proven proven";
    assert_eq!(words(table, claims), expected.split_whitespace().collect::<Vec<_>>());
}

#[test]
fn coupled_drives_speak_of_motors() {
    let table = "convention = standard; let l1: length; let l2: length; let p: length;
        | theta | d | a | alpha |
        | q1 | 0 | l1 | 0 |
        | q2 - q1 | 0 | l2 | 90deg |
        | 0 | p*q3 - p*q2 | 0 | 0 |";
    let claims = "T(0,2).px = l1*c1 + l2*c2; theta2 = q2 - q1; cos(theta2) = c(2-1); d3 = p*(q3 - q2);
        q3 = theta1 + theta2 + d3/p; T(0,2).px = l1*c1 + l2*c12;
        at q1 = 10deg, q2 = 30deg, l1 = 1, l2 = 1; theta2 ~ 20deg; c2 ~ 0.866; theta2 ~ 21deg;";
    let expected = "proven proven proven proven proven wrong noted agrees agrees wrong";
    assert_eq!(words(table, claims), expected.split(' ').collect::<Vec<_>>());
}

#[test]
fn signs_left_open_become_conditions() {
    let table = "convention = modified; | alpha | a | d | theta | | 0 | 0 | 0 | q1 | | 90deg | 0 | q2 | 0 |";
    let text = verdicts(&format!(
        "pub struct Arm; {table} prove {{
            sqrt(s1^2) = s1;
            sqrt(q2^2*s1^2) = -q2*s1;
            sqrt(q2^2) + 1 = q2 + 1;
            sqrt((1 + c1^2)^2) = 1 + c1^2;
            atan2(s1, c1) = q1;
            atan2(2*s1, 2*c1) = q1;
            atan2(-s1, -c1) = q1;
            atan2(q2*s1, q2*c1) = q1;
            acos(c1) = q1;
            asin(s1) = q1;
            2*atan2(s1, 1 + c1) = q1;
            q1 = q1 + 360deg;
            q1 = q1 + 180deg;
            atan2(c1, s1) = q1;
            sqrt(q2^2) = q2 + 1;
        }}"
    ));
    insta::assert_snapshot!(text);
}

/// The branches of Craig's solution: each holds somewhere, and what holds nowhere is wrong, whatever condition the algebra would put to it.
#[test]
fn a_condition_that_no_pose_meets_is_no_proof() {
    let table = "convention = modified;
        let a2: length = 0.4318; let a3: length = 0.0203; let d3: length = 0.15005; let d4: length = 0.4318;
        | alpha | a | d | theta |
        | 0 | 0 | 0 | q1 |
        | -90deg | 0 | 0 | q2 |
        | 0 | a2 | d3 | q3 |
        | -90deg | a3 | d4 | q4 |
        | 90deg | 0 | 0 | q5 |
        | -90deg | 0 | 0 | q6 |";
    let claims = "let px = T(0,6).px; let py = T(0,6).py; let pz = T(0,6).pz;
        let K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2);
        q1 = atan2(py, px) - atan2(d3, sqrt(px^2 + py^2 - d3^2));
        q1 = atan2(py, px) - atan2(d3, -sqrt(px^2 + py^2 - d3^2));
        q3 = atan2(a3, d4) - atan2(K, sqrt(a3^2 + d4^2 - K^2));
        q3 = atan2(a3, d4) - atan2(K, -sqrt(a3^2 + d4^2 - K^2));
        q1 = atan2(py, px) + atan2(d3, sqrt(px^2 + py^2 - d3^2));
        q1 = atan2(py, px) + atan2(d3, -sqrt(px^2 + py^2 - d3^2));
        q1 = atan2(py, px) - atan2(-d3, sqrt(px^2 + py^2 - d3^2));
        q3 = atan2(a3, d4) + atan2(K, sqrt(a3^2 + d4^2 - K^2));
        sqrt(a2^2) = -a2;
        sqrt(s2^2) = s2 = -sqrt(s2^2);
        a2 > 0;";
    let expected = [["noted"; 4].as_slice(), &["proven"; 4], &["wrong"; 5], &["unclear", "agrees"]].concat();
    assert_eq!(words(table, claims), expected);
}

/// At every pose one of the possibilities holds; where it is said when, that one.
#[test]
fn possibilities_are_a_set() {
    let table = "convention = standard; let l1: length = 0.5; let l2: length = 0.25;
        | theta | d | a | alpha | | q1 | 0 | l1 | 0 | | q2 | 0 | l2 | 0 |";
    let claims =
        "let x = T(0,2).px; let y = T(0,2).py; let psi = acos((x^2 + y^2 + l1^2 - l2^2)/(2*l1*sqrt(x^2 + y^2)));
        q1 = atan2(y, x) + psi or q1 = atan2(y, x) - psi;
        q1 = atan2(y, x) + psi if q2 < 0deg or q1 = atan2(y, x) - psi if q2 > 0deg;
        q1 = atan2(y, x) - psi if q2 < 0deg or q1 = atan2(y, x) + psi if q2 > 0deg;
        q1 = atan2(x, y) + psi or q1 = atan2(x, y) - psi;
        s2 = sqrt(1 - c2^2) or s2 = -sqrt(1 - c2^2);
        s2 = sqrt(1 - c2^2) or s2 = sqrt(1 - c2^2);";
    let expected = ["noted", "noted", "noted", "proven", "proven", "wrong", "wrong", "proven", "wrong"];
    assert_eq!(words(table, claims), expected);
}

/// Numbers of no robot cost no time.
#[test]
fn huge_numbers_are_refused() {
    let text = puma("a2 = 1e-400*a3^2; a2 = 1e400; a2 = 0.00000000000000000000000000000000000000000000000000001;");
    assert_eq!(text.matches("unclear").count(), 3, "{text}");
}

/// What holds at the lengths of the table, and not for all, is no proof and no mistake.
#[test]
fn an_instance_is_no_identity() {
    let table = "convention = standard; let l1: length = 0.5; let l2: length = 0.25;
        | theta | d | a | alpha | | q1 | 0 | l1 | 0 | | q2 | 0 | l2 | 0 |";
    let claims = "T(0,2).px = 0.5*c1 + 0.25*c12; l1 - l2 = 0.25; l1 - l2 = 0.3; T(0,2).px = l1*c1 + l2*c12;";
    assert_eq!(words(table, claims), ["agrees", "agrees", "wrong", "proven"]);
}

#[test]
fn tables_of_numbers() {
    let table = "convention = modified; unit = mm; let l = 30;
        | alpha | a | d | theta | | 0 | 0 | 0 | q1 | | -90deg | -30 | 338 | q2 | | 0 | 12.5 | 0 | q3 |";
    let claims =
        "T(0,2).px = -30*c1 - 338*s1; T(0,2).px = -l*c1 - d2*s1; a1 = -30mm; a1 = -3cm; a2 = 12.5; a2 > 12; a2 <= 12.5;
        T(0,2).px = 30*c1 - 338*s1; norm2(T(0,2).p) = 30^2 + 338^2; sqrt(8) = 2*sqrt(2); sqrt(0.5) = cos(45deg);
        cos(70deg) = 2*cos(35deg)^2 - 1;
        at q1 = 0; T(0,2).px ~ -30.0; T(0,2).px ~ 30; T(0,2).py ~ 338.0 within 0.1; T(0,3).px ~ 0.0;";
    let expected = "proven proven proven proven proven proven proven
        wrong proven proven proven
        unclear
        noted agrees wrong agrees unclear";
    assert_eq!(words(table, claims), expected.split_whitespace().collect::<Vec<_>>());
}

/// Whatever stands in a `prove` block: a verdict, no panic, in bounded time.
#[test]
fn soups_of_words_are_judged() {
    let pool = [
        "=",
        "=",
        ";",
        "~",
        "(",
        ")",
        "[",
        "]",
        ",",
        ".",
        "*",
        "+",
        "-",
        "/",
        "^",
        "2",
        "3",
        "16",
        "0",
        "90deg",
        "0.5",
        "c1",
        "s23",
        "c4",
        "T",
        "T(0,6)",
        "T(1,3)",
        "px",
        "R",
        "p",
        "x",
        "q1",
        "q2",
        "a2",
        "d4",
        "sqrt",
        "atan2",
        "inv",
        "subst",
        "diff",
        "let",
        "at",
        "within",
        "length",
        "angle",
        ":",
        "u",
        "v",
        "norm2",
        "dot",
        "cross",
        "<",
        ">",
        "!",
        "pi",
        "acos",
        "Rz",
        "Trans",
        "1e9",
        "99999999999999999999",
        "7rad",
        "3pi",
        "theta9",
        "c12345",
        "I3",
        "_",
        "#",
        "A",
        "base",
        "s()",
    ];
    let mut state = 12345u64;
    let mut next = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) as usize) % n
    };
    let chain = {
        let rows = [
            (0, "0", "0", 0),
            (-90, "0", "0", 0),
            (0, "0.4", "0.1", 0),
            (-90, "0.02", "0.4", 0),
            (90, "0", "0", 0),
            (-90, "0", "0", 0),
        ];
        crate::chain::tests::revolute_chain(crate::chain::Convention::Modified, &rows)
    };
    for _ in 0..400 {
        let mut text = String::new();
        for _ in 0..3 {
            let left = ["T(0,6).px", "c1", "u", "x", "T(1,3)", "let w", "at q1", ""][next(8)];
            text.push_str(left);
            text.push_str(" = ");
            for _ in 0..next(14) {
                text.push_str(pool[next(pool.len())]);
                text.push(' ');
            }
            text.push(';');
        }
        let Ok(tokens) = text.parse() else { continue };
        let claims = Claims::from_tokens(tokens);
        let report = check(&chain, &claims.derivation);
        assert_eq!(report.verdicts.len(), claims.derivation.lines.len(), "{text}");
        derivation_report(&report, &claims.derivation);
    }
}

#[test]
fn growth_is_bounded() {
    let sum = "(q1 + q2 + q3 + q4 + q5 + q6 + a2 + a3 + d3 + d4)";
    let text = puma(&format!(
        "{sum}^16 = 1; let u = {sum}^8; u^16 = u^15; (((c2^16)^16)^16) = 1; T(0,6)^16 = I4; diff({sum}^12, q1) = 0;"
    ));
    assert!(text.contains("grows too large"), "{text}");
    assert!(!text.contains("proven"), "{text}");
}

/// An entry or a determinant that does not hold as J is, holds with no other rows either; a matrix that is written out shows its rows.
#[test]
fn a_line_does_not_choose_the_rows_that_make_it_true() {
    let words = |claims: &str| {
        let text = puma(claims);
        let first = |l: &str| l.split_whitespace().next().map(str::to_string);
        text.lines().filter(|l| !l.starts_with(' ')).filter_map(first).collect::<Vec<_>>().join(" ")
    };
    // the angular rows would come first
    assert_eq!(
        words("J(6,1) = 0; J(4,1) = 0; J(1,1) = 0; J(3,1) = 0; J(3,2) = -1;"),
        "wrong proven wrong proven wrong"
    );
    let det = "a2*s5*(a3*s3 + d4*c3)*(a2*c2 + a3*c23 - d4*s23)";
    assert_eq!(words(&format!("det(J) = {det}; det(J) = -{det};")).matches("proven").count(), 1);
    let row = "[-s1*(a2*c2 + a3*c23 - d4*s23) - c1*d3, c1*(-a2*s2 - a3*s23 - d4*c23), -c1*(a3*s23 + d4*c23), 0, 0, 0]";
    assert_eq!(words(&format!("J = {row}; J(1,4) = 0; J(1,1) = 0;")), "proven proven wrong");
}
