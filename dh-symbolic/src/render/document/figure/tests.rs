//! Drawings of known arms: everything inside the frame, no label on another, every length named.

use super::drawing::label_size;
use super::*;
use crate::chain::Chain;
use crate::chain::samples::{PANDA, PLANAR, PUMA, SCARA, STANFORD, UR5, chain};
use crate::kinematics::Kinematics;
use crate::render::formula::math::Math;
use crate::render::formula::notation::Notation;

fn posture(chain: &Chain, x: &[f64]) -> Posture {
    Posture::at(chain, &Kinematics::new(chain), x)
}

fn drawn(table: &str, x: &[f64]) -> Drawing {
    let chain = chain(table);
    arm(&chain, &Notation::textbook(&chain), &posture(&chain, x))
}

const X: [f64; 7] = [0.35, -0.61, 0.87, 0.7, -1.05, 1.31, 0.52];

fn all() -> Vec<(&'static str, Drawing)> {
    let list = [
        ("puma", PUMA, 6),
        ("ur5", UR5, 6),
        ("scara", SCARA, 4),
        ("stanford", STANFORD, 6),
        ("planar", PLANAR, 3),
        ("panda", PANDA, 7),
    ];
    list.into_iter().map(|(name, table, n)| (name, drawn(table, &X[..n]))).collect()
}

fn labels(d: &Drawing) -> Vec<([f64; 2], Math)> {
    let label = |s: &Shape| match s {
        Shape::Label(at, math, _) => Some((*at, math.clone())),
        _ => None,
    };
    d.shapes.iter().filter_map(label).collect()
}

#[test]
fn everything_is_inside_the_frame() {
    for (name, d) in all() {
        let points = |s: &Shape| match s {
            Shape::Line(points, _) | Shape::Area(points, ..) => points.clone(),
            Shape::Circle(at, ..) | Shape::Label(at, ..) => vec![*at],
        };
        let inside = |p: &[f64; 2]| (0..2).all(|i| p[i] >= 0.0 && p[i] <= d.size[i]);
        assert!(d.shapes.iter().flat_map(points).all(|p| inside(&p)), "{name}");
        assert!(d.size.iter().all(|x| (30.0..430.0).contains(x)), "{name}: {:?}", d.size);
    }
}

#[test]
fn labels_keep_apart() {
    for (name, d) in all() {
        let list = labels(&d);
        assert!(list.len() > 8, "{name}");
        for (i, (p, a)) in list.iter().enumerate() {
            for (q, b) in &list[..i] {
                let (s, t) = (label_size(a), label_size(b));
                let over = (p[0] - q[0]).abs() < 0.4 * (s[0] + t[0]) && (p[1] - q[1]).abs() < 0.35 * (s[1] + t[1]);
                assert!(
                    !over,
                    "{name}: {} on {}",
                    crate::render::formula::text::math(a),
                    crate::render::formula::text::math(b)
                );
            }
        }
    }
}

#[test]
fn lengths_carry_their_names() {
    let names: Vec<String> =
        labels(&drawn(PUMA, &X[..6])).iter().map(|(_, m)| crate::render::formula::text::math(m)).collect();
    for wanted in ["a₂", "a₃", "d₃", "d₄", "x₂", "z₄"] {
        assert!(names.iter().any(|n| n == wanted), "{wanted}: {names:?}");
    }
}

#[test]
fn eight_postures_stand_in_two_rows() {
    let puma = chain(PUMA);
    let list: Vec<Posture> = (0..8).map(|i| posture(&puma, &[0.3 * f64::from(i), -0.6, 0.8, 0.7, -1.0, 1.3])).collect();
    let d = postures(&list);
    assert!(d.size[0] > d.size[1]);
    let numbers: Vec<String> = labels(&d).iter().map(|(_, m)| crate::render::formula::text::math(m)).collect();
    assert_eq!(numbers, ["1", "2", "3", "4", "5", "6", "7", "8"]);
}

#[test]
fn a_small_drawing_in_both_languages() {
    let table = "pub struct A; convention = modified; let l: length = 2; tool = tx(l);
        | alpha | a | d | theta |
        | 0     | 0 | 0 | q1    |";
    let d = drawn(table, &[0.5]);
    let both = format!(
        "{}\n{}",
        crate::render::document::html::svg::element(&d, "One link"),
        crate::render::document::latex::tikz::picture(&d)
    );
    insta::with_settings!({ omit_expression => true }, { insta::assert_snapshot!("one_link", both) });
}
