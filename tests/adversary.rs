//! Lines of hand derivations with slips of the pen: what the checker says of them agrees with plain numbers.
//!
//! Taken are Craig's solution of the PUMA, the derivations of the corpus, and our own notes of all kinds of arms. The numbers come from
//! `adversary/numbers`, which shares nothing with the checker but the text of the lines and the table as it is read. The normal run takes a
//! few slips of every line; `.ci/adversary` (`ADVERSARY=n`: n slips of each line, and two more of each slip) takes some hundred thousand.

#![allow(clippy::print_stdout)] // how many lines were judged

mod judge;
mod numbers;
mod slips;

use crate::handwork::tables;
use dh_symbolic::chain::table::parse;
use dh_symbolic::chain::{Chain, ChainSpec};
use dh_symbolic::render::document::notes::Part;
use dh_symbolic::render::{Format, Options, notes};
use dh_symbolic::verify::{Claims, judge as judge_document};
use generated_examples::{corpus, source};
use judge::{Extent, Source, Tally};

/// Craig's solution, section 4.7.
const CRAIG: &str = "
    let px = T(0,6).px; let py = T(0,6).py; let pz = T(0,6).pz;
    let K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2);
    -s1*px + c1*py = d3;
    a3*c3 - d4*s3 = K;
    q1 = atan2(py, px) - atan2(d3, sqrt(px^2 + py^2 - d3^2));
    q1 = atan2(py, px) - atan2(d3, -sqrt(px^2 + py^2 - d3^2));
    q1 = atan2(py, px) - atan2(d3, sqrt(px^2 + py^2 - d3^2)) or q1 = atan2(py, px) - atan2(d3, -sqrt(px^2 + py^2 - d3^2));
    q3 = atan2(a3, d4) - atan2(K, sqrt(a3^2 + d4^2 - K^2));
    q3 = atan2(a3, d4) - atan2(K, -sqrt(a3^2 + d4^2 - K^2));
    c1*c23*px + s1*c23*py - s23*pz - a2*c3 = a3;
    -c1*s23*px - s1*s23*py - c23*pz + a2*s3 = d4;
    q2 + q3 = atan2((-a3 - a2*c3)*pz - (c1*px + s1*py)*(d4 - a2*s3), (a2*s3 - d4)*pz + (a3 + a2*c3)*(c1*px + s1*py));
    q4 = atan2(-T(0,6).r13*s1 + T(0,6).r23*c1, -T(0,6).r13*c1*c23 - T(0,6).r23*s1*c23 + T(0,6).r33*s23);
    s5 = -T(0,6).r13*(c1*c23*c4 + s1*s4) - T(0,6).r23*(s1*c23*c4 - c1*s4) + T(0,6).r33*s23*c4;
    c5 = -T(0,6).r13*c1*s23 - T(0,6).r23*s1*s23 - T(0,6).r33*c23;
    s6 = -T(0,6).r11*(c1*c23*s4 - s1*c4) - T(0,6).r21*(s1*c23*s4 + c1*c4) + T(0,6).r31*s23*s4;
";

fn spec(name: &str, table: &str) -> ChainSpec {
    parse(table.parse().expect("words")).spec.unwrap_or_else(|| panic!("{name}: no table"))
}

/// Some slips of every `step`th line; in the long run of all lines, and second slips.
fn extent(step: usize, slips: usize) -> Extent {
    match long() {
        Some(slips) => Extent { step: 1, slips, pairs: 2 },
        None => Extent { step, slips, pairs: 0 },
    }
}

/// In the long run: slips of each line.
fn long() -> Option<usize> {
    std::env::var("ADVERSARY").ok().map(|n| n.parse().unwrap_or(usize::MAX))
}

/// The formulas of a note, read back.
fn printed(spec: &ChainSpec) -> Source {
    let chain = Chain::new(spec.clone());
    let parts = vec![Part::Links, Part::Forward, Part::Jacobian, Part::Inverse];
    let note = notes(&chain, &Options { parts, ..Options::default() }).print(Format::Latex);
    Source::new(&judge_document(&chain, &note).0.derivation)
}

/// Nothing is misjudged, and the sources say something.
fn finished(tally: &Tally, least: usize) {
    let Tally { judged, settled, open, bad } = tally;
    println!("{judged} lines, {settled:?} always, sometimes, never; {open} left open; {} misjudged", bad.len());
    assert!(bad.is_empty(), "{} of {judged} misjudged:\n{}", bad.len(), bad.join("\n"));
    assert!(*judged > least && settled[0] > 5 && settled[2] > least / 3, "{judged} {settled:?}");
    assert!(20 * open < *judged, "{open} of {judged} are left open");
}

#[test]
fn slips_in_the_solution_of_the_puma() {
    let body = source::all().unwrap().into_iter().find(|s| s.module == "puma560").unwrap().body;
    let spec = spec("puma560", &body);
    let mut tally = Tally::default();
    let craig = Source::new(&Claims::from_tokens(CRAIG.parse().unwrap()).derivation);
    tally.judge("Craig", &spec, &craig, extent(1, 8));
    tally.judge("puma560", &spec, &printed(&spec), extent(4, 1));
    finished(&tally, 100);
}

#[test]
fn slips_in_derivations_of_lectures() {
    let mut tally = Tally::default();
    let mut paths: Vec<_> = std::fs::read_dir(corpus::folder()).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "dh"));
    paths.sort();
    for path in paths {
        let name = path.file_stem().unwrap().to_string_lossy();
        let parsed = parse(std::fs::read_to_string(&path).unwrap().parse().unwrap());
        let source = Source::new(&Claims::read(&parsed.claims).derivation);
        tally.judge(&name, &parsed.spec.unwrap(), &source, extent(3, 2));
    }
    finished(&tally, 50);
}

#[test]
fn slips_in_notes_of_examples() {
    let mut tally = Tally::default();
    let some = if long().is_some() { 1 } else { 3 };
    for s in source::all().unwrap().iter().step_by(some) {
        let spec = spec(&s.module, &s.body);
        tally.judge(&s.module, &spec, &printed(&spec), extent(4, 1));
    }
    finished(&tally, 60);
}

#[test]
fn slips_in_notes_of_other_tables() {
    let mut tally = Tally::default();
    let (some, seeds) = if long().is_some() { (1, 60) } else { (3, 2) };
    let own = tables::OWN.iter().step_by(some).map(|(n, t)| (n.to_string(), t.to_string()));
    for (name, table) in own.chain((0..seeds).map(|s| (format!("random {s}"), tables::random(s)))) {
        let spec = spec(&name, &table);
        tally.judge(&name, &spec, &printed(&spec), extent(4, 1));
    }
    finished(&tally, 60);
}
