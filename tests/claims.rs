//! The corpus of hand derivations: every printed line is checked by the algebra, and the verdicts stay what they are.

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::verify::Claims;
use dh_symbolic::verify::check::{Verdict, check};
use dh_symbolic::verify::language::{Derivation, Token, line_text};
use dh_symbolic::verify::report::{derivation_report, verdict_word};
use generated_examples::corpus::{self, Checked};
use std::collections::BTreeMap;
use std::fmt::Write;

/// (id, verdict) of the lines that were printed.
fn printed_lines(c: &Checked) -> impl Iterator<Item = (&str, &Verdict)> {
    let lines = c.claims.derivation.lines.iter().zip(&c.report.verdicts);
    lines.filter_map(|(l, v)| Some((id_of(&l.note)?, v)))
}

/// `[puma_0T1] PUMA 0T1`: the id.
fn id_of(note: &str) -> Option<&str> {
    // an id may hold brackets: `001_link[1,4]`
    let inner = note.strip_prefix('[')?;
    Some(inner.split_once("] ")?.0)
}

fn corpus() -> Vec<Checked> {
    corpus::all().unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_line_has_its_verdict() {
    let mut text = String::new();
    for c in corpus() {
        writeln!(text, "=== {}\n\n{}", c.file, derivation_report(&c.report, &c.claims.derivation)).unwrap();
    }
    insta::assert_snapshot!("corpus_verdicts", text);
}

/// Every id of `printed.json` is a claim of the corpus or a note with a reason.
#[test]
fn every_printed_line_is_judged() {
    let folder = corpus::folder();
    let printed: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("printed.json")).unwrap()).unwrap();
    let notes = std::fs::read_to_string(folder.join("notes.md")).unwrap();
    let corpus = corpus();
    let mut verdicts: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for c in &corpus {
        for (id, v) in printed_lines(c) {
            verdicts.entry(id.to_string()).or_default().push(verdict_word(v));
        }
    }
    let ids: Vec<&str> = printed["lines"].as_array().unwrap().iter().map(|l| l["id"].as_str().unwrap()).collect();
    let missing: Vec<&&str> =
        ids.iter().filter(|id| !verdicts.contains_key(**id) && !notes.contains(&format!("## {id}\n"))).collect();
    assert!(missing.is_empty(), "not judged: {missing:?}");
    let unknown: Vec<&String> = verdicts.keys().filter(|id| !ids.contains(&id.as_str())).collect();
    assert!(unknown.is_empty(), "not printed: {unknown:?}");
}

/// Document 002 prints the PUMA matrices, too, but its text lost the letters: signs, zeros and ones are compared.
#[test]
fn the_skeletons_of_document_002_agree() {
    let folder = corpus::folder();
    let text = std::fs::read_to_string(folder.join("skeleton_002.txt")).unwrap();
    let corpus = corpus();
    let puma = &corpus.iter().find(|c| c.file == "puma560.dh").unwrap().claims.derivation;
    let mut compared = 0;
    for (id, skeleton) in text.lines().filter(|l| !l.starts_with('#')).map(|l| l.split_once(": ").unwrap()) {
        let lines = puma.lines.iter().filter(|l| id_of(&l.note).is_some_and(|i| i.starts_with(id)));
        let mut own = String::new();
        for line in lines {
            let tokens = &puma.tokens[line.place.clone()];
            let start = tokens.iter().position(|t| t.is("=")).unwrap();
            own.extend(tokens[start..].iter().map(|t| t.text.as_str()).filter(|t| ["+", "-", "0", "1"].contains(t)));
        }
        let other: String = skeleton.replace('\u{2212}', "-").chars().filter(|c| "+-01".contains(*c)).collect();
        assert_eq!(own, other, "{id}");
        compared += 1;
    }
    assert_eq!(compared, 11);
}

/// The numbers that the readme of the corpus and the errata page speak of.
#[test]
fn the_slips_are_found() {
    let mut wrong: Vec<String> = Vec::new();
    for c in &corpus() {
        let bad = printed_lines(c).filter(|(_, v)| matches!(v, Verdict::Wrong(_) | Verdict::NotUnderstood(..)));
        wrong.extend(bad.map(|(id, _)| id.to_string()));
    }
    wrong.sort();
    wrong.dedup();
    insta::assert_snapshot!("corpus_slips", wrong.join("\n"));
}

/// One wrong letter or sign in any true line of the PUMA is found, and repaired by one letter or sign.
#[test]
fn every_slip_of_the_pen_is_repaired() {
    let path = corpus::folder().join("puma560.dh");
    let parsed = parse(std::fs::read_to_string(path).unwrap().parse().unwrap());
    let derivation = Claims::read(&parsed.claims).derivation;
    let chain = Chain::new(parsed.spec.unwrap());
    let verdict = |tokens: Vec<Token>| {
        let d = Derivation::parse(tokens);
        check(&chain, &d).verdicts.remove(0)
    };
    let mut slips = 0;
    for line in &derivation.lines {
        let tokens = &derivation.tokens[line.place.clone()];
        if !matches!(verdict(tokens.to_vec()), Verdict::Proven(_)) || line.note.contains("flip") {
            continue;
        }
        let first = tokens.iter().position(|t| t.is("=")).unwrap() + 1;
        for i in first..tokens.len() {
            let t = &tokens[i];
            let slip = match t.text.as_str() {
                "+" => "-".to_string(),
                "-" if !tokens[i - 1].is("=") && !tokens[i - 1].is(",") => "+".to_string(),
                name if name.starts_with('c') => name.replacen('c', "s", 1),
                name if name.starts_with('s') => name.replacen('s', "c", 1),
                _ => continue,
            };
            let mut wrong = tokens.to_vec();
            wrong[i] = Token::new(&slip);
            let text = line_text(&wrong).0;
            match verdict(wrong.clone()) {
                Verdict::Wrong(faults) => {
                    let repair = faults[0].repair.clone().unwrap_or_else(|| panic!("not repaired: {text}"));
                    assert_eq!(repair.edits.len(), 1, "{text}");
                    let repaired = repair.apply(&wrong, &(0..wrong.len()));
                    assert!(matches!(verdict(repaired), Verdict::Proven(_)), "{text}");
                }
                other => panic!("{other:?}: {text}"),
            }
            slips += 1;
        }
    }
    assert!(slips > 150, "{slips}");
}
