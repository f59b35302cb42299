//! Whole tables.

use super::*;
use crate::algebra::Rational;
use crate::chain::*;
use crate::diagnostic::lex;

const PUMA: &str = "
    /// Unimation PUMA 560, frames after Craig.
    pub struct Puma560;

    convention = modified;
    let a2: length = 431.8mm;
    let a3: length = 20.3mm;
    let d3: length = 150.05mm;
    let d4: length = 431.8mm;

    | joint | alpha  | a  | d  | theta | range            |
    |-------|--------|----|----|-------|------------------|
    |   1   |   0    | 0  | 0  | q1    | -160deg..=160deg |
    |   2   | -90deg | 0  | 0  | q2    | -225deg..= 45deg |
    |   3   |   0    | a2 | d3 | q3    |  -45deg..=225deg |
    |   4   | -90deg | a3 | d4 | q4    | -110deg..=170deg |
    |   5   |  90deg | 0  | 0  | q5    | -100deg..=100deg |
    |   6   | -90deg | 0  | 0  | q6    | -266deg..=266deg |
    prove {
        T(1,3) = [c23, -s23, 0, a2*c2; 0, 0, 1, d3; -s23, -c23, 0, -a2*s2; 0, 0, 0, 1];
        T(0,6).px = c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1;
    }
";

fn read(source: &str) -> Parsed {
    parse(lex(source).unwrap_or_else(|e| panic!("{}", e.draw(source, "-"))))
}

#[test]
fn the_puma_of_the_contract() {
    let parsed = read(PUMA);
    let spec = parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(PUMA, "-")));
    assert_eq!((spec.name.as_str(), spec.rows.len(), parsed.claims.len()), ("Puma560", 6, 2));
    assert_eq!(parsed.head.docs, [" Unimation PUMA 560, frames after Craig."]);
    assert_eq!(spec.rows[1].alpha.half_turns, Rational::new(-1, 2));
    assert_eq!(spec.rows[3].a.terms, [(Rational::ONE, vec![1])]);
    let bounds = (Rational::new(-8, 9), Rational::new(8, 9));
    assert_eq!(spec.rows[0].range, Some((Bound::HalfTurns(bounds.0.unwrap()), Bound::HalfTurns(bounds.1.unwrap()))));
    let a2 = Role::Field(Some(Value::Length(Rational::new(2159, 5000).unwrap())));
    assert_eq!(spec.parameters[0].role, a2);
    assert_eq!(parsed.sketch.table[2], ["2", "-90deg", "0", "0", "q2", "-225deg..=45deg"]);
    assert_eq!((parsed.origins.cell(3, Column::A).start(), parsed.origins.joint(5).start()), ((16, 23), (18, 33)));
}
