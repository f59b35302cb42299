//! What is printed for known arms.

use super::*;
use crate::algebra::Poly;
use crate::chain::samples::*;
use crate::render::Format;
use crate::render::Language;

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
    let show = |p: Poly| crate::render::formula::text::math(&notation.typeset(&order.group(&p)));
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
        let plan = crate::render::InversePlan::new(&chain).unwrap();
        let (text, chart) = (plan.to_string(), plan.mermaid(Language::Chinese));
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
            format!("{name}\n{}\n", crate::render::code::rustdoc(&chain, &kinematics))
        })
        .collect();
    insta::with_settings!({ omit_expression => true }, { insta::assert_snapshot!("rustdoc", all) });
}

const CUP: &str = "
pub struct Cup;
convention = modified;
unit = mm;
base = tz(373mm);
tool = tz(206mm) * ry(90deg) * rz(180deg);
| alpha  | a   | d   | theta |
|--------|-----|-----|-------|
|   0    | 0   | 0   | q1    |
| -90deg | -30 | 0   | q2    |
|   0    | 340 | 0   | q3    |
| -90deg | -40 | 338 | q4    |
|  90deg | 0   | 0   | q5    |
| -90deg | 0   | 0   | q6    |
";

/// The slides print 381.3, 151.8, 19.5 and 21.8, -52.2, 2.5, -20, -42, 15 degrees.
#[test]
fn the_cup_task_comes_out_as_on_the_slides() {
    let mut options = Options { parts: vec![Part::Example], ..Options::default() };
    options.set("--pose", "tx(830)*ty(20)*tz(330) * tx(-280)*ty(250)*tz(62.5)*rz(35deg)").unwrap();
    options.set("--frames", "b=W,e=C").unwrap();
    options.set("--near", "q1=20deg,q2=-50deg,q3=0,q4=-20deg,q5=-40deg,q6=15deg").unwrap();
    let chain = chain(CUP);
    assert_eq!(options.check(&chain), Ok(()));
    let text = notes(&chain, &options).print(Format::Text);
    for part in ["381.25", "151.84", "19.50", "yield 8 solutions", "is solution 4."] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let row = text.lines().find(|l| l.trim_start().starts_with("4 ")).unwrap();
    let values: Vec<&str> = row.split_whitespace().skip(1).take(6).collect();
    assert_eq!(values, ["21.72°", "−52.19°", "2.48°", "−20.05°", "−42.07°", "15.16°"]);
}

/// Tasks with freedom, a chosen joint, coupled actuators: the joint vector that made the pose is among the solutions.
#[test]
fn examples_of_every_kind_of_arm() {
    let position = PLANAR.replace("unit = mm;", "unit = mm; task = planar;");
    let axis =
        CUP.replace("unit = mm;", "unit = mm; task = axis;").replace("| -90deg | -40 | 338 | q4    |\n", "").replace(
            "|  90deg | 0   | 0   | q5    |\n| -90deg | 0   | 0   | q6    |",
            "|  90deg | 0   | 0   | q4    |\n| -90deg | 0   | 0   | q5    |",
        );
    let coupled = "pub struct Leg; convention = modified; let p: length = 0.02;
        | alpha | a | d | theta |\n|-|-|-|-|\n| 0 | 0 | 0 | q1 |\n| -90deg | 0 | p*(q2 - q1) | 0 |";
    let options = Options { parts: vec![Part::Example], ..Options::default() };
    for (table, first) in [
        (position.as_str(), "20.00° −35.00° 50.00°"),
        (axis.as_str(), "20.00° −35.00° 50.00°"),
        (PANDA, "20.00° −35.00° 50.00°"),
        (coupled, "20.00°"),
        (ODD, "20.00° −35.00°"),
    ] {
        let text = notes(&chain(table), &options).print(Format::Text);
        let mut rows = text.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" "));
        assert!(
            rows.any(|r| r.split_once(' ').is_some_and(|(_, values)| values.starts_with(first))),
            "{first}: {text}"
        );
    }
}

/// Radii of a planar arm against its joint space, searched at random.
#[test]
fn rings_hold_all_places_and_nothing_more() {
    let lengths = [[5.0, 2.0, 1.0], [1.0, 1.0, 0.3], [1.0, 0.5, 2.0]];
    let expected = [["8", "2", "4 ≤ ρ ≤ 6"], ["2.3", "0", "ρ ≤ 1.7"], ["3.5", "0.5", "no such place"]];
    for (l, e) in lengths.iter().zip(expected) {
        let table = format!(
            "pub struct Arm; convention = modified; task = planar; let a: length = {}; let b: length = {}; let c: length = {};
             tool = tx(c);\n| alpha | a | d | theta |\n|-|-|-|-|\n| 0 | 0 | 0 | q1 |\n| 0 | a | 0 | q2 |\n| 0 | b | 0 | q3 |",
            l[0], l[1], l[2]
        );
        let options = Options { parts: vec![Part::Workspace], ..Options::default() };
        let text = notes(&chain(&table), &options).print(Format::Text);
        let value = |name: &str| {
            let line = text.lines().find(|l| l.contains(name)).unwrap_or_else(|| panic!("{name}: {text}"));
            line.rsplit("= ").next().unwrap().to_string()
        };
        assert_eq!((value("ρ_max").as_str(), value("ρ_min").as_str()), (e[0], e[1]));
        assert!(text.contains(e[2]), "{text}");
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for i in 0..200 {
            for j in 0..200 {
                let (s, t) = (f64::from(i) * 0.0314159 * 1.0001, f64::from(j) * 0.0314159);
                let x = l[0] + l[1] * s.cos() + l[2] * (s + t).cos();
                let y = l[1] * s.sin() + l[2] * (s + t).sin();
                (least, most) = (least.min(x.hypot(y)), most.max(x.hypot(y)));
            }
        }
        let near = |text: String, x: f64| (text.parse::<f64>().unwrap() - x).abs() < 0.03;
        assert!(near(value("ρ_max"), most) && near(value("ρ_min"), least), "{least} {most}");
    }
}

/// The generated code names the equations of the default note.
#[test]
fn equations_have_the_numbers_that_the_code_names() {
    for (name, table) in ALL {
        let chain = chain(table);
        let document = notes(&chain, &Options::default());
        let all = document.blocks.iter().filter_map(|b| match b {
            Block::Equations(list) => Some(list),
            _ => None,
        });
        let numbered: Vec<(usize, String)> =
            all.flatten().filter_map(|e| Some((e.number?, crate::render::formula::text::math(&e.left)))).collect();
        let (pose, jacobian) = crate::render::formula::products::equation_numbers(&chain);
        let left = |n: usize| numbered.iter().find(|e| e.0 == n).map(|e| e.1.as_str());
        let end = if chain.tool.is_empty() { chain.links.len().to_string() } else { "e".into() };
        let start = if chain.base.is_empty() { "0" } else { "b" };
        let notation = Notation::textbook(&chain);
        let frame = |text: &str| text.parse().map_or(if text == "b" { Frame::Base } else { Frame::Tool }, Frame::Row);
        let expected = crate::render::formula::text::math(&notation.transform(frame(start), frame(&end)));
        assert_eq!(left(pose), Some(expected.as_str()), "{name}");
        assert_eq!(left(jacobian), Some("J"), "{name}");
    }
}

#[test]
fn the_part_about_calibration() {
    let part = |language, format| {
        let options = Options { language, parts: vec![Part::Calibration], ..Options::default() };
        notes(&chain(UR5), &options).print(format)
    };
    let text = part(Language::English, Format::Text);
    assert!(text.contains("Of the 26 deviations") && text.contains("tell 24 apart"), "{text}");
    assert!(text.contains("∂T/(∂αᵢ)") && text.matches("same as d₂").count() == 2, "{text}");
    assert!(part(Language::Chinese, Format::Text).contains("26 个偏差中的 24 个"));
    let latex = part(Language::English, Format::Latex);
    assert!(latex.contains("\\partial T") && !latex.contains('∂'), "{latex}");
}
