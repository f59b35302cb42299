//! Tests of chains: names of quantities, groups of parallel joints.

use super::*;
use crate::algebra::Rational;

/// A chain of rows (alpha in degrees, a, d, theta offset in degrees), all turning, unit metres.
pub(crate) fn revolute_chain(convention: Convention, rows: &[(i64, &str, &str, i64)]) -> Chain {
    mixed_chain(convention, &"R".repeat(rows.len()), rows)
}

/// The same with a letter for each joint, R or P.
pub(crate) fn mixed_chain(convention: Convention, kinds: &str, rows: &[(i64, &str, &str, i64)]) -> Chain {
    let angle = |deg: i64| AngleCell { half_turns: Rational::new(deg, 180), ..AngleCell::default() };
    let length = |text: &str| {
        let (sign, digits) = text.strip_prefix('-').map_or((1, text), |t| (-1, t));
        LengthCell::number(&Rational::from_decimal(digits).unwrap() * &Rational::int(sign))
    };
    let rows = rows
        .iter()
        .zip(kinds.chars())
        .enumerate()
        .map(|(i, ((alpha, a, d, theta), kind))| RowSpec {
            alpha: angle(*alpha),
            a: length(a),
            d: length(d),
            theta: angle(*theta),
            moves: Some(Drive { revolute: kind == 'R', terms: vec![(i, LengthCell::number(Rational::ONE))] }),
            ..RowSpec::default()
        })
        .collect();
    Chain::new(ChainSpec {
        name: "Test".into(),
        convention,
        settings: Settings::default(),
        parameters: vec![],
        rows,
        base: vec![],
        tool: vec![],
        poses: vec![],
    })
}

#[test]
fn parallel_axes_share_a_group() {
    let rows = [(0, "0", "0", 0), (-90, "0", "0", 0), (0, "0.4", "0.1", 0), (180, "0.4", "0", 0), (90, "0", "0", 0)];
    let chain = revolute_chain(Convention::Modified, &rows);
    let group = |i: usize| match chain.joints[i].coordinate {
        Coordinate::Angle(v) => v.group(),
        Coordinate::Length(_) => panic!("all joints turn"),
    };
    assert!(group(0) != group(1) && group(1) == group(2) && group(2) == group(3) && group(3) != group(4));
    assert_eq!(chain.parameters.len(), 2, "equal magnitudes share a name");
}
