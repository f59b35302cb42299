//! The chapter as it is taught, line by line: every equation of every part is evaluated with the numbers that the part prints.
//!
//! A note is read as Markdown by the calculator of `handwork/`, extended by matrices of any size. Names get their values from printed
//! numbers or from equations whose right side is known; when all is read, no equation may be left without a value, and all its sides
//! must agree.

mod matrix;
mod sheet;

use crate::handwork::tables;
use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::document::notes::Part;
use dh_symbolic::render::{Format, Options, notes};
use generated_examples::source;
use sheet::Sheet;

/// Options of a note, by name.
type Settings = Vec<(String, String)>;

/// The note of a part, with all digits.
fn written(table: &str, part: Part, own: &[(String, String)]) -> String {
    let parsed = parse(table.parse().expect("words"));
    let chain = Chain::new(parsed.spec.unwrap_or_else(|| panic!("no table\n{table}")));
    let mut options = Options {
        parts: vec![Part::Table, Part::Links, Part::Example, part],
        width: 4000,
        digits: 11,
        ..Options::default()
    };
    for (name, value) in own {
        options.set(name, value).expect("an option");
    }
    notes(&chain, &options).print(Format::Markdown)
}

/// How many equations of a part hold; 0 where it does not apply.
fn holds(name: &str, table: &str, part: Part, own: &[(String, String)]) -> usize {
    let text = written(table, part, own);
    let mut sheet = Sheet::default();
    sheet.read(&text);
    match sheet.judge() {
        Ok(n) => n,
        Err(fault) => panic!("{name}, {part:?}: {fault}\n{text}"),
    }
}

/// All tables: examples with the options of their notes, tables with offsets, tools and bases, random ones.
fn all() -> Vec<(String, String, Settings)> {
    let examples = source::all().unwrap().into_iter().map(|s| {
        let options = s.options.iter().map(|(n, v)| (n.to_string(), v.to_string())).collect();
        (s.module, s.body, options)
    });
    let own = tables::OWN.iter().map(|(n, t)| (n.to_string(), t.to_string(), vec![]));
    let random = (0..tables::RANDOM).map(|seed| (format!("random {seed}"), tables::random(seed), vec![]));
    examples.chain(own).chain(random).collect()
}

#[test]
fn every_equation_of_the_chapter_holds() {
    for (part, least) in [(Part::Pieper, 300), (Part::Planar, 60)] {
        let mut equations = 0;
        for (name, table, own) in all() {
            equations += holds(&name, &table, part, &own);
        }
        assert!(equations > least, "{part:?}: {equations}");
    }
}
