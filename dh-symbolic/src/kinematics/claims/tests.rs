//! Verdicts on lines.

use super::*;
use crate::chain::table::{Claims, parse};
use crate::render::verdict::derivation_report;

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
