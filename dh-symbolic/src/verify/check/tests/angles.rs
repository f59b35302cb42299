//! Tests of lines with angles: derivatives, and the smallest change of a wrong one.

use super::{puma, words};

/// Craig's equations for a PUMA, each with one slip, and what the checker says to it.
#[test]
fn slips_in_angles_are_repaired() {
    let names = "let px = T(0,6).px; let py = T(0,6).py; let pz = T(0,6).pz;
        let K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2);";
    for (line, repair) in [
        ("q1 = atan2(py, px) + atan2(d3, sqrt(px^2 + py^2 - d3^2))", "`+` should be `-`"),
        ("q1 = atan2(px, py) - atan2(d3, sqrt(px^2 + py^2 - d3^2))", "`px, py` should be `py, px`"),
        ("q1 = atan2(py, px) - atan2(d4, sqrt(px^2 + py^2 - d3^2))", "`d4` should be `d3`"),
        ("q1 = atan2(py, px) - atan2(d3, sqrt(px^2 + py^2))", "`-d3^2` is missing before `)`"),
        ("q3 = atan2(d4, a3) - atan2(K, sqrt(a3^2 + d4^2 - K^2))", "`d4, a3` should be `a3, d4`"),
        ("q3 = atan2(a3, d4) - atan2(K, sqrt(a3^2 + d4^2 - K))", "`^2` is missing after `K`"),
        ("q2 + q3 = atan2(-s2*c3 - c2*s3, c23)", "`-` is too much and `-` should be `+`"),
        ("q5 = atan2(s5, -c5)", "`-` is too much"),
        ("q5 = atan2(c5, c5)", "`c5` should be `s5`"),
    ] {
        let text = puma(&format!("{names} {line};"));
        let said = text
            .lines()
            .map(str::trim)
            .filter(|l| l.contains("should be") || l.contains("missing") || l.contains("too much"));
        let said: Vec<&str> = said.collect();
        let two = repair.contains(" and ");
        assert!(text.contains("wrong") && (two || said == [repair]), "{line}\n{text}");
    }
}

/// A wrong definition is blamed where it stands, not where it is used.
#[test]
fn wrong_definitions_are_blamed() {
    let text = puma(
        "let px = T(0,6).px; let py = T(0,6).py; let pz = T(0,6).pz;
        let K = (px^2 + py^2 + pz^2 - a2^2 + a3^2 - d3^2 - d4^2)/(2*a2);
        a3*c3 - d4*s3 = K;
        q3 = atan2(a3, d4) - atan2(K, sqrt(a3^2 + d4^2 - K^2));
        T(1,3).px = a2*s2;",
    );
    let wrong: Vec<&str> = text.lines().filter(|l| l.starts_with("wrong")).collect();
    assert_eq!(wrong.len(), 4, "{text}");
    assert!(wrong[0].starts_with("wrong   let K"), "{text}");
    assert_eq!(text.matches("follows from `let K").count(), 2, "{text}");
    assert_eq!(text.matches("`+` should be `-`").count(), 1, "{text}");
    // one that is right is not blamed for what is wrong by itself
    assert!(text.contains("`s2` should be `c2`"), "{text}");
    let text = puma("let K = a2*c2; T(1,3).px = K + d3;");
    assert!(text.contains("noted   let K"), "{text}");
}

#[test]
fn derivatives_of_angles_and_roots() {
    let table = "convention = standard; let l1: length; let l2: length;
        | theta | d | a | alpha | | q1 | 0 | l1 | 0 | | q2 | 0 | l2 | 0 |";
    let claims = "let x = T(0,2).px; let y = T(0,2).py; let r = sqrt(x^2 + y^2);
        diff(atan2(y, x), q1) = 1; diff(r, q1) = 0; diff(r, q2) = -l1*l2*s2/r;
        diff(atan2(y, x) - q1, q2) = (l2^2 + l1*l2*c2)/r^2; diff(r, q2) = l1*l2*s2/r; diff(q1 + 2*q2, q2) = 2;
        diff(sqrt(1 + r), q2) = -l1*l2*s2/(2*r*sqrt(1 + r)); diff(r, l1) = (l1 + l2*c2)/r;";
    let expected = "noted noted noted proven proven proven proven wrong proven proven proven";
    assert_eq!(words(table, claims).join(" "), expected);
}

/// Rows of the Jacobian: of the task, of the plane, by their numbers.
#[test]
fn rows_of_the_jacobian() {
    let table = "convention = standard; let l1: length; let l2: length;
        | theta | d | a | alpha | | q1 | 0 | l1 | 0 | | q2 | 0 | l2 | 0 |";
    let claims = "J = [-l1*s1 - l2*s12, -l2*s12; l1*c1 + l2*c12, l2*c12]; det(J) = l1*l2*s2; det(J) = -l1*l2*s2;
        J^-1 = [l2*c12, l2*s12; -l1*c1 - l2*c12, -l1*s1 - l2*s12]/(l1*l2*s2); Jw = [0, 0; 0, 0; 1, 1];
        rows(Jv, 1, 2) = J; rows(Jv, 2, 1) = J; J(1,1) = -l1*s1 - l2*s12; J(3,1) = 0; rows(Jw, 4) = 1; det(J.t*J) = (l1*l2*s2)^2;";
    let expected = "proven proven wrong proven proven proven wrong proven proven unclear proven";
    assert_eq!(words(table, claims).join(" "), expected);
}
