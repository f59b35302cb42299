//! Anything may stand between the braces: random tokens, and tables with random mistakes in them.
//!
//! Reading must not panic, must give a robot or errors (not both, not neither), and must point into the text.

use dh_symbolic::chain::table::parse;
use dh_symbolic::chain::{ChainSpec, Nominal};
use dh_symbolic::diagnostic::{Place, lex};
use proptest::prelude::*;

const TABLE: &str = "
/// Documentation.
pub struct Arm;
convention = modified; unit = mm; task = position; redundant = q2; ik = none; scalar = f32;
let a2: length = 431.8mm; let b: angle = pi/6; let k: number = 2; let w = -90deg; let l = 2*(3cm - 5);
base = tz(373mm) * rx(b); tool = ty(-a2);
| joint | alpha | a | d | theta | range |
|-------|:-----:|---|---|-------|-------|
| 1 | 0 | 0 | 0 | q1 | -160deg..=160deg |
| 2 | w | a2 + 10mm | 0 | q2 - 90deg | - |
| 3 | approx 1.2rad | -l/2 | q3 + 0.05 | 0.25turn | 0mm..=30 |
| tip | 2*b | k*a2 | 0 | 30deg | fixed |
| 5 | -3*pi/4 | 1in | 0 | k*q4 + q1 | - |
prove { T(0,1).px = 0; }
";

const WORDS: &[&str] = &[
    "|",
    "|",
    "|",
    "||",
    "|---|",
    "-",
    "--",
    "+",
    "*",
    "/",
    "^",
    ".",
    "..",
    "..=",
    "=",
    "==",
    ";",
    ":",
    "::",
    ",",
    "#",
    "#[doc = \"x\"]",
    "#[derive(Debug, Default)]",
    "#!",
    "'a",
    "'a'",
    "\"s\"",
    "b\"s\"",
    "r#fn",
    "_",
    "pub",
    "pub(crate)",
    "struct",
    "Arm",
    "f64",
    "let",
    "a2",
    "b",
    "k",
    "w",
    "l",
    "fn",
    "q0",
    "q1",
    "q2",
    "q3",
    "q99",
    "q99999",
    "pi",
    "approx",
    "fixed",
    "none",
    "length",
    "angle",
    "number",
    "prove",
    "{}",
    "{ x = 1; y }",
    "()",
    "(1)",
    "(q1)",
    "[1]",
    "(((1)))",
    "convention",
    "modified",
    "standard",
    "unit",
    "mm",
    "task",
    "axis",
    "redundant",
    "ik",
    "scalar",
    "base",
    "tool",
    "tx(1)",
    "rz(90deg)",
    "rw",
    "joint",
    "alpha",
    "a",
    "d",
    "theta",
    "range",
    "0",
    "1",
    "90deg",
    "1.5708rad",
    "1.2rad",
    "0.5turn",
    "431.8mm",
    "1e999",
    "1e300",
    "1e-300",
    "0x1f",
    "1f32",
    "90degrees",
    "2a2",
    ".5m",
    "1.",
    "\n",
    "\n",
    "λ",
    "α",
    "機械",
];

/// Does it point into the text?
fn inside(place: Place, source: &str) -> bool {
    let (start, end) = (place.start(), place.end());
    let within = |(line, column): (usize, usize)| {
        let text = line.checked_sub(1).and_then(|i| source.lines().nth(i));
        text.is_some_and(|t| column <= t.chars().count())
    };
    // What was never written has the place of the macro call, which is (1, 0) here.
    start <= end && ((within(start) && within(end)) || end == (1, 0))
}

fn check(source: &str) -> Result<(), TestCaseError> {
    let Ok(tokens) = lex(source) else { return Ok(()) };
    let parsed = parse(tokens);
    prop_assert_eq!(parsed.errors.is_empty(), parsed.spec.is_some(), "a robot or errors:\n{}", source);
    for e in parsed.errors.in_order() {
        prop_assert!(inside(e.place, source), "{:?} {:?} {}:\n{}", e.place.start(), e.place.end(), e.message, source);
        prop_assert!(!e.message.is_empty());
    }
    let drawn = parsed.errors.draw(source, "soup");
    prop_assert_eq!(drawn.is_empty(), parsed.errors.is_empty());
    prop_assert_eq!(parsed.errors.to_compile_errors().is_empty(), parsed.errors.is_empty());
    prop_assert!(parsed.sketch.table.len() <= source.len());
    Ok(())
}

/// Words with the spaces left out or not.
fn soup(words: &[(usize, bool)]) -> String {
    let text = |(i, space): &(usize, bool)| format!("{}{}", WORDS[i % WORDS.len()], if *space { " " } else { "" });
    words.iter().map(text).collect()
}

fn words(most: usize) -> impl Strategy<Value = Vec<(usize, bool)>> {
    prop::collection::vec((0..WORDS.len(), prop::bool::weighted(0.9)), 0..most)
}

/// The tokens of the good table with some of them removed, doubled, swapped or replaced.
fn mistaken(edits: &[(usize, usize, usize)]) -> String {
    let mut tokens: Vec<String> =
        TABLE.lines().flat_map(|l| l.split(' ').map(String::from).chain(["\n".into()])).collect();
    for (kind, at, word) in edits {
        let at = at % tokens.len();
        match kind % 4 {
            0 => drop(tokens.remove(at)),
            1 => tokens.insert(at, tokens[at].clone()),
            2 => tokens.swap(at, word % at.max(1)),
            _ => tokens[at] = WORDS[word % WORDS.len()].to_string(),
        }
    }
    tokens.join(" ")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn random_words(words in words(80)) {
        check(&soup(&words))?;
        check(&format!("struct S; convention = standard; {}", soup(&words)))?;
    }

    #[test]
    fn random_cells(words in words(12)) {
        let header = "struct S; convention = standard; let a2: length; let b: angle; let k: number; let w = 1deg; let l = 1;";
        check(&format!("{header}| alpha | a | d | theta | range |\n| {} | q1 | 0 | 0 | - |", soup(&words)))?;
        check(&format!("{header}| alpha | a | d | theta | range |\n| 0 | 0 | {0} | q1 | {0} |\n| 0 | 0 | 0 | {0} | {0} |", soup(&words)))?;
    }

    #[test]
    fn mistaken_tables(edits in prop::collection::vec((0usize..4, 0usize..1000, 0usize..1000), 0..6)) {
        check(&mistaken(&edits))?;
    }

    #[test]
    fn any_text(text in any::<String>()) {
        check(&text)?;
    }

    /// Cells of lengths are computed exactly.
    #[test]
    fn lengths_have_the_value_they_say(expression in length(), unit in 0usize..5) {
        let (name, metres) = UNITS[unit];
        let source = format!(
            "struct S; convention = standard; unit = {name}; let x = {}; | alpha | a | d | theta | | 0 | x | {} | q1 |",
            expression.0, expression.0,
        );
        let parsed = parse(lex(&source).map_err(|e| TestCaseError::fail(e.draw(&source, "length")))?);
        let errors = parsed.errors.draw(&source, "length");
        let spec: ChainSpec = parsed.spec.ok_or_else(|| TestCaseError::fail(errors))?;
        let want = expression.1 / metres;
        let have: f64 = spec.rows[0].d.terms.iter().map(|(x, names)| if names.is_empty() { x.to_f64() } else { f64::NAN }).sum();
        let constant = match &spec.parameters[0].role {
            dh_symbolic::chain::Role::Constant(Nominal::Length(x)) => x.to_f64(),
            other => return Err(TestCaseError::fail(format!("{other:?}"))),
        };
        let tolerance = 1e-12 * (expression.2 / metres);
        prop_assert!((have - want).abs() <= tolerance, "{}: {} and {}", source, have, want);
        prop_assert!((constant - want).abs() <= tolerance);
    }
}

const UNITS: [(&str, f64); 5] = [("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("in", 0.0254), ("ft", 0.3048)];

/// A length: its text, its value in metres, and the sum of the magnitudes in it.
fn length() -> impl Strategy<Value = (String, f64, f64)> {
    let leaf = (0u32..100_000, 0usize..4, 0usize..5).prop_map(|(digits, places, unit)| {
        let value = f64::from(digits) / 10f64.powi(places as i32) * UNITS[unit].1;
        (format!("{:.places$}{}", f64::from(digits) / 10f64.powi(places as i32), UNITS[unit].0), value, value)
    });
    leaf.prop_recursive(5, 24, 3, |inner| {
        prop_oneof![
            (inner.clone(), inner.clone()).prop_map(|(a, b)| (format!("{} + {}", a.0, b.0), a.1 + b.1, a.2 + b.2)),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| (format!("{} - ({})", a.0, b.0), a.1 - b.1, a.2 + b.2)),
            (inner.clone(), 1u32..9).prop_map(|(a, n)| (
                format!("{n}*({})", a.0),
                a.1 * f64::from(n),
                a.2 * f64::from(n)
            )),
            (inner.clone(), 1u32..9).prop_map(|(a, n)| (
                format!("-({})/{n}", a.0),
                -a.1 / f64::from(n),
                a.2 / f64::from(n)
            )),
        ]
    })
}

#[test]
fn long_input_is_no_trouble() {
    let (head, n) = ("struct R; convention = standard;\n", 5000);
    let header = "| alpha | a | d | theta |\n";
    let many = |word: &str| word.repeat(n);
    let texts = [
        format!("{head}|{}", many(" alpha |")),
        format!("{head}{header}{}", many("| 0 | 1 | 0 | q1 |\n")),
        format!("{head}{}", many("unit = mm;")),
        format!("{head}{}", many("let a: length;")),
        format!("{head}{header}| 0 | {}1 | 0 | q1 |", many("1 + ")),
        format!("{head}{header}| 0 | {}1{} | {}1{} | q1 |", many("("), many(")"), many("["), many("]")),
        format!("{head}{header}{}", many("|")),
        format!("{head}{}", many("foo; ")),
        format!("{}{head}", many("#[x]")),
        format!("{head}tool = {}tz(1);", many("tz(1) * ")),
        format!("{head}{header}| {0} | {0} | 1{0} | q1 |", many("m")),
        format!("{head}{header}| 0 | {0} | 0.{0}m | q1 |", many("1")),
    ];
    for text in texts {
        check(&text).expect("errors");
        let drawn = parse(lex(&text).expect("tokens")).errors;
        assert!(!drawn.is_empty() && drawn.in_order().iter().all(|e| e.message.len() < 500));
    }
}

#[test]
fn the_table_without_mistakes_is_fine() {
    let parsed = parse(lex(TABLE).expect("tokens"));
    assert!(parsed.errors.is_empty(), "{}", parsed.errors.draw(TABLE, "table"));
}
