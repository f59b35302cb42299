//! The workspace of rank-deficient arms and of arms with parallel axes only.
//!
//! Seen along its axes, an arm whose axes are all parallel is a chain of links in a plane (sliding joints along the axes change
//! nothing there). The chain reaches a ring; every direction of its last link is possible where a circle about the point lies in the
//! ring of the links before (Craig 2005, section 4.2).

use super::singular::{ReferenceFrame, relative_transform};
use crate::algebra::{AngleVar, Factor, Poly, Rational, Symbol};
use crate::chain::{Chain, Coordinate};
use crate::kinematics::Kinematics;

/// A length: its square, and itself where that is no square root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Length {
    /// Its square.
    pub square: Poly,
    /// The length, up to sign.
    pub plain: Option<Poly>,
}

/// An arm with parallel axes, seen along them.
#[derive(Clone, Debug)]
pub struct Planar {
    /// Turning joints, in order.
    pub turning: Vec<usize>,
    /// Sliding joints along the axes.
    pub sliding: Vec<usize>,
    /// Lengths of the links: from each turning axis to the next, from the last to the tool.
    pub links: Vec<Length>,
}

/// The arm seen along its axes, if they are all parallel and at least two turn.
pub fn planar(chain: &Chain, k: &Kinematics) -> Option<Planar> {
    let turns = |j: &usize| matches!(chain.joints.get(*j).map(|j| j.coordinate), Some(Coordinate::Angle(_)));
    let (turning, sliding): (Vec<usize>, Vec<usize>) = (0..chain.dof()).partition(turns);
    let first = *turning.first()?;
    if turning.len() < 2 {
        return None;
    }
    let parallel = |j: &usize| {
        let z = relative_transform(k, ReferenceFrame::of_joint(chain, first), ReferenceFrame::of_joint(chain, *j))
            .column(2);
        z[0].is_zero() && z[1].is_zero()
    };
    if !(0..chain.dof()).all(|j| parallel(&j)) {
        return None;
    }
    let stands: Vec<ReferenceFrame> =
        turning.iter().map(|j| ReferenceFrame::of_joint(chain, *j)).chain([ReferenceFrame::Tool]).collect();
    let link = |w: &[ReferenceFrame]| match w {
        [a, b] => {
            let p = relative_transform(k, *a, *b).p;
            length(&p[0].square() + &p[1].square())
        }
        _ => length(Poly::zero()),
    };
    Some(Planar { turning, sliding, links: stands.windows(2).map(link).collect() })
}

/// The square root of a formula, where it is one term.
fn length(square: Poly) -> Length {
    let plain = match square.terms() {
        [] => Some(Poly::zero()),
        [(m, c)] => root(c).and_then(|x| {
            let half = |p: Option<Poly>, f: Factor| match f {
                Factor::Power(s, n) if n % 2 == 0 => Some(&p? * &Poly::power(s, n / 2)),
                _ => None,
            };
            m.factors().fold(Some(Poly::constant(x)), half)
        }),
        _ => None,
    };
    Length { square, plain }
}

/// The square root of a rational number, where it is rational.
fn root(x: &Rational) -> Option<Rational> {
    let (n, d) = x.to_small().filter(|(n, _)| *n >= 0)?;
    let whole = |n: i64| {
        let r = (n as f64).sqrt().round() as i64;
        (r.checked_mul(r) == Some(n)).then_some(r)
    };
    Rational::new(whole(n)?, whole(d)?)
}

/// The pose of an arm with a turning joint about the base's z and a sliding joint across it: x and y say it all.
///
/// Position A c - B s, A s + B c, constant height, where one of A and B is a constant K and the other the slide up to sign and a
/// constant: D = sign * d + shift.
#[derive(Clone, Debug)]
pub struct TurnAndSlide {
    /// The angle.
    pub angle: AngleVar,
    /// The sliding variable.
    pub slide: Symbol,
    /// Its sign in D.
    pub negative: bool,
    /// The constant in D.
    pub shift: Poly,
    /// K.
    pub constant: Poly,
    /// Whether D is the factor A (otherwise B).
    pub along: bool,
}

/// Recognises such an arm.
pub fn turn_and_slide(chain: &Chain, k: &Kinematics) -> Option<TurnAndSlide> {
    if chain.dof() != 2 {
        return None;
    }
    let angle = chain.joints.iter().find_map(|j| match j.coordinate {
        Coordinate::Angle(v) => Some(v),
        Coordinate::Length(_) => None,
    })?;
    let slide = chain.joints.iter().find_map(|j| match j.coordinate {
        Coordinate::Length(s) => Some(s),
        Coordinate::Angle(_) => None,
    })?;
    let p = k.pose().p;
    if p[2].has_angle(angle) || p[2].has_symbol(slide) {
        return None;
    }
    let (c, s) = Poly::cos_sin(angle);
    let part = |p: &Poly, sine: bool| -> Option<Poly> {
        let angle_sum = |f: &Factor| matches!(f, Factor::Cos(t) | Factor::Sin(t) if t.iter().any(|(v, _)| *v == angle));
        let wanted = if sine { &s } else { &c };
        let mut found = Poly::zero();
        for (m, value) in p.collect(angle_sum) {
            match Poly::term(m.clone(), Rational::ONE) {
                t if t == *wanted => found = value,
                t if t == c || t == s => {}
                _ => return None,
            }
        }
        Some(found)
    };
    let (a, b) = (part(&p[0], false)?, -&part(&p[0], true)?);
    if part(&p[1], true)? != a || part(&p[1], false)? != b {
        return None;
    }
    let along = a.has_symbol(slide);
    let (moving, constant) = if along { (a, b) } else { (b, a) };
    let one = moving.derivative_by_symbol(slide).as_rational().filter(|x| x.abs().is_one())?;
    let plain = !constant.has_symbol(slide);
    let shift = &moving - &Poly::symbol(slide).scale(&one);
    (plain && !shift.has_symbol(slide)).then_some(TurnAndSlide {
        angle,
        slide,
        negative: one.is_negative(),
        shift,
        constant,
        along,
    })
}

/// Row and column of an entry of the pose.
pub type Entry = (usize, usize);

/// What all poses of an arm have in common: entries (row, column) that never change, and entries that equal others up to sign.
#[derive(Clone, Debug, Default)]
pub struct Common {
    /// Entries with a constant value.
    pub fixed: Vec<(Entry, Poly)>,
    /// Entries that are plus or minus an entry before: (entry, the other, negative).
    pub same: Vec<(Entry, Entry, bool)>,
}

/// Compares the entries of the pose.
pub fn common(chain: &Chain, k: &Kinematics) -> Common {
    let pose = k.pose();
    let moves = |p: &Poly| {
        chain.joints.iter().any(|j| match j.coordinate {
            Coordinate::Angle(v) => p.has_angle(v),
            Coordinate::Length(s) => p.has_symbol(s),
        })
    };
    let mut out = Common::default();
    let mut seen: Vec<((usize, usize), Poly)> = Vec::new();
    for (i, j) in (0..4).flat_map(|j| (0..3).map(move |i| (i, j))) {
        let p = pose.entry(i, j);
        if !moves(&p) {
            out.fixed.push(((i, j), p));
            continue;
        }
        let minus = -&p;
        match seen.iter().find(|(_, q)| *q == p || *q == minus) {
            Some((place, q)) => out.same.push(((i, j), *place, *q != p)),
            None => seen.push(((i, j), p)),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::table::parse;

    fn arm(head: &str, rows: &[&str]) -> (Chain, Kinematics) {
        let rows: String = rows.iter().map(|r| format!("| {r} |\n")).collect();
        let table =
            format!("pub struct Arm; convention = modified; {head}\n| alpha | a | d | theta |\n|-|-|-|-|\n{rows}");
        let parsed = parse(crate::diagnostic::lex(&table).unwrap_or_else(|e| panic!("{}", e.draw(&table, "table"))));
        let chain = Chain::new(parsed.spec.unwrap_or_else(|| panic!("{}", parsed.errors.draw(&table, "table"))));
        let kinematics = Kinematics::new(&chain);
        (chain, kinematics)
    }

    #[test]
    fn links_of_planar_arms() {
        let (chain, k) =
            arm("let a: length; let b: length; tool = tx(b) * tz(1);", &["0|0|0|q1", "180deg|a|0.3|q2", "0|0|q3|0"]);
        let planar = planar(&chain, &k).unwrap();
        assert_eq!((planar.turning, planar.sliding), (vec![0, 1], vec![2]));
        let text: Vec<String> = planar.links.iter().map(|l| chain.ring.text(l.plain.as_ref().unwrap())).collect();
        assert_eq!(text, ["a", "b"]);
        let (chain, k) = arm("", &["0|0|0|q1", "90deg|0.5|0|q2"]);
        assert!(super::planar(&chain, &k).is_none());
    }

    #[test]
    fn an_arm_that_turns_and_slides() {
        let (chain, k) = arm("let e: length;", &["0|0|0|q1", "-90deg|e|q2 + 0.1|0"]);
        let t = turn_and_slide(&chain, &k).unwrap();
        assert_eq!((t.along, t.negative, chain.ring.text(&t.constant)), (false, false, "e".to_string()));
        assert_eq!(
            t.shift.evaluate(&crate::algebra::Point {
                symbol: &|s| chain.nominal(crate::chain::Handle::Length(s)),
                angle: &|_| 0.0
            }),
            0.1
        );
        let (chain, k) = arm("", &["0|0|0|q1", "0|0.2|q2|0"]);
        assert!(turn_and_slide(&chain, &k).is_none());
        let common = common(&chain, &k);
        assert_eq!((common.fixed.len(), common.same.len()), (5, 2));
    }
}
