//! What is printed for known arms.

use super::*;
use crate::algebra::Poly;
use crate::render::Format;
use crate::render::samples::*;

const ALL: [(&str, &str); 8] = [
    ("puma", PUMA),
    ("ur5", UR5),
    ("scara", SCARA),
    ("stanford", STANFORD),
    ("planar", PLANAR),
    ("rpr", RPR),
    ("panda", PANDA),
    ("odd", ODD),
];

fn entries(t: &Transform) -> impl Iterator<Item = Poly> + '_ {
    (0..3).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| t.entry(i, j))
}

#[test]
fn expressions_expand_to_what_they_came_from() {
    for (name, table) in ALL {
        let chain = chain(table);
        let order = Order::of(&chain);
        let k = Kinematics::new(&chain);
        let mut list: Vec<Poly> = entries(&k.pose()).collect();
        for i in 0..k.len() {
            for j in i + 1..=k.len() {
                list.extend(entries(&k.transform(i, j).unwrap()));
            }
        }
        for (linear, angular) in crate::kinematics::jacobian(&chain, &k) {
            list.extend(linear);
            list.extend(angular);
        }
        // squares, so that multiple angles occur
        let squares: Vec<Poly> = list.iter().filter(|p| p.terms().len() < 6).map(Poly::square).collect();
        list.extend(squares);
        for p in list {
            assert_eq!(order.group(&p).expand(), p, "{name}: {}", chain.ring.text(&p));
        }
    }
}

/// The textbook needs 367 glyphs for the twelve entries of the PUMA's pose and 46 for the widest; computer algebra systems 1000.
#[test]
fn puma_takes_no_more_glyphs_than_the_textbook() {
    let chain = chain(PUMA);
    let (order, notation) = (Order::of(&chain), Notation::textbook(&chain));
    let pose = Kinematics::new(&chain).pose();
    let counts: Vec<usize> = entries(&pose).map(|p| notation.typeset(&order.group(&p)).glyphs()).collect();
    let (sum, widest) = (counts.iter().sum::<usize>(), counts.iter().max().copied().unwrap_or(0));
    assert_eq!((sum, widest), (357, 45));
}

#[test]
fn multiple_angles_become_powers_where_that_is_shorter() {
    let mut ring = crate::algebra::Ring::new();
    let (t, l) = (ring.angle("q5"), Poly::symbol(ring.symbol("l")));
    let order = Order::new(vec![t.group()]);
    let notation = Notation::of_ring(&ring);
    let (c, s) = Poly::cos_sin(t);
    let show = |p: Poly| crate::render::text::math(&notation.typeset(&order.group(&p)));
    assert_eq!(show(c.square()), "c₅²");
    assert_eq!(show(&l * &s.square()), "ls₅²");
    assert_eq!(show((&c * &s).scale(&2.into())), "2c₅s₅");
    assert_eq!(show(&c.square().square() * &l), "lc₅⁴");
    assert_eq!(show(&l * &(&c.square() - &s.square())), "l·cos(2q₅)");
}

#[test]
fn notes_of_known_arms() {
    for (name, table) in ALL {
        let text = notes(&chain(table), &Options::default()).print(Format::Text);
        insta::with_settings!({ omit_expression => true }, { insta::assert_snapshot!(name, text) });
    }
}

#[test]
fn notes_in_other_formats_and_in_chinese() {
    let chain = chain(PUMA);
    // Drawings have tests of their own.
    let undrawn = |language| {
        let mut note = notes(&chain, &Options { language, ..Options::default() });
        note.blocks.retain(|b| !matches!(b, Block::Figure(_)));
        note
    };
    let (english, chinese) = (undrawn(Language::English), undrawn(Language::Chinese));
    insta::with_settings!({ omit_expression => true }, {
        insta::assert_snapshot!("puma_latex", english.print(Format::Latex));
        insta::assert_snapshot!("puma_markdown", chinese.print(Format::Markdown));
        insta::assert_snapshot!("puma_typst", english.print(Format::Typst));
        insta::assert_snapshot!("puma_html", chinese.print(Format::Html));
    });
}

#[test]
fn plans_and_flow_charts() {
    for (name, table) in [("puma", PUMA), ("ur5", UR5), ("panda", PANDA)] {
        let chain = chain(table);
        let text = crate::render::plan(&chain, Language::English).print(Format::Text);
        let chart = crate::render::plan::mermaid(&chain, Language::Chinese);
        let both = format!("{text}\n{chart}");
        insta::with_settings!({ omit_expression => true }, { insta::assert_snapshot!(format!("{name}_plan"), both) });
    }
}

#[test]
fn closed_forms_for_rustdoc() {
    let all: String = ALL
        .iter()
        .map(|(name, table)| {
            let chain = chain(table);
            let kinematics = Kinematics::new(&chain);
            format!("{name}\n{}\n", crate::render::rustdoc(&chain, &kinematics))
        })
        .collect();
    insta::with_settings!({ omit_expression => true }, { insta::assert_snapshot!("rustdoc", all) });
}
