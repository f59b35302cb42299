//! Every line of hand derivations of a PUMA with one slip of the pen: what the checker says of it agrees with plain numbers.
//!
//! The numbers come from a parser, a table and a product of matrices of their own: nothing is shared with the checker but the text of the
//! lines. `ADVERSARY=all cargo test -p dh-tests --test main adversary` takes all
//! lines, not one in three, and twenty second slips for each first one.

#![allow(clippy::print_stdout)] // how many lines were judged

mod numbers;

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::document::notes::Part;
use dh_symbolic::render::{Format, Options, notes};
use dh_symbolic::verify::check::{Verdict, check_without_repairs};
use dh_symbolic::verify::language::{Derivation, Statement, Token};
use dh_symbolic::verify::{Claims, judge};
use generated_examples::{corpus, source};
use numbers::{Truth, random, truth};

/// Second slips for each first one, in the long run.
const PAIRS: usize = 20;

/// Craig's solution, section 4.7.
const CRAIG: &str = "
    let px = T(0,6).px; let py = T(0,6).py; let pz = T(0,6).pz;
    let K = (px^2 + py^2 + pz^2 - a2^2 - a3^2 - d3^2 - d4^2)/(2*a2);
    -s1*px + c1*py = d3;
    a3*c3 - d4*s3 = K;
    q1 = atan2(py, px) - atan2(d3, sqrt(px^2 + py^2 - d3^2));
    q1 = atan2(py, px) - atan2(d3, -sqrt(px^2 + py^2 - d3^2));
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

/// All lines with one slip.
fn slips(line: &[String]) -> Vec<Vec<String>> {
    let mut out: Vec<Vec<String>> = Vec::new();
    let mut put = |range: std::ops::Range<usize>, new: &[&str]| {
        let mut copy = line.to_vec();
        copy.splice(range, new.iter().map(|w| w.to_string()));
        out.push(copy);
    };
    let is = |k: usize, w: &str| line.get(k).is_some_and(|x| x == w);
    for (k, w) in line.iter().enumerate() {
        let field = k > 0 && is(k - 1, ".");
        let value_before = k > 0 && !["=", "(", "[", ",", ";", "*", "/", "+", "-"].contains(&line[k - 1].as_str());
        let stem = w.trim_end_matches(|c: char| c.is_ascii_digit());
        match w.as_str() {
            "+" => put(k..k + 1, &["-"]),
            "-" if value_before => put(k..k + 1, &["+"]),
            "-" => put(k..k + 1, &[]),
            "^" => put(k..k + 2, &[]),
            "sqrt" => put(k..k, &["-"]),
            "cos" => put(k..k + 1, &["sin"]),
            "sin" => put(k..k + 1, &["cos"]),
            "atan2" => {
                // the other order of the arguments
                let mut depth = 0;
                let (mut comma, mut close) = (None, None);
                for (j, x) in line.iter().enumerate().skip(k + 1) {
                    match x.as_str() {
                        "(" | "[" => depth += 1,
                        ")" | "]" => depth -= 1,
                        "," if depth == 1 => comma = Some(j),
                        _ => {}
                    }
                    if depth == 0 {
                        close = Some(j);
                        break;
                    }
                }
                if let (Some(comma), Some(close)) = (comma, close) {
                    let mut new: Vec<&str> = line[comma + 1..close].iter().map(String::as_str).collect();
                    new.push(",");
                    new.extend(line[k + 2..comma].iter().map(String::as_str));
                    put(k + 2..close, &new);
                }
            }
            _ if field || stem.len() == w.len() => {}
            _ => {
                let digits = &w[stem.len()..];
                match stem {
                    "c" => put(k..k + 1, &[&format!("s{digits}")]),
                    "s" => put(k..k + 1, &[&format!("c{digits}")]),
                    _ => {}
                }
                for other in 1..=6 {
                    let new = format!("{stem}{other}");
                    if digits.len() == 1 && new != *w && matches!(stem, "c" | "s" | "q" | "a" | "d") {
                        put(k..k + 1, &[&new]);
                    }
                }
                // a factor is lost
                if is(k + 1, "*") {
                    put(k..k + 2, &[]);
                }
                if k > 0 && is(k - 1, "*") {
                    put(k - 1..k + 1, &[]);
                }
            }
        }
    }
    out
}

/// The words of a line.
fn words(tokens: &[Token]) -> Vec<String> {
    tokens.iter().map(|t| t.text.clone()).collect()
}

type Source = (Vec<(String, Vec<String>)>, Vec<Vec<String>>);

/// Definitions and equations of a derivation.
fn lines(d: &Derivation) -> Source {
    let (mut lets, mut claims) = (Vec::new(), Vec::new());
    for l in &d.lines {
        let own = words(&d.tokens[l.place.clone()]);
        match &l.statement {
            Statement::Define(name, _) => lets.push((name.clone(), own[3..].to_vec())),
            Statement::Claim { .. } if own.iter().all(|w| !["~", "<", ">", "!"].contains(&w.as_str())) => {
                claims.push(own)
            }
            _ => {}
        }
    }
    (lets, claims)
}

#[test]
fn verdicts_on_slips_agree_with_numbers() {
    let body = source::all().unwrap().into_iter().find(|s| s.module == "puma560").unwrap().body;
    let chain = Chain::new(parse(body.parse().unwrap()).spec.unwrap());
    let printed = std::fs::read_to_string(corpus::folder().join("puma560.dh")).unwrap();
    let printed = Claims::read(&parse(printed.parse().unwrap()).claims).derivation;
    let parts = vec![Part::Links, Part::Forward, Part::Inverse];
    let note = notes(&chain, &Options { parts, ..Options::default() }).print(Format::Latex);
    let sources = [
        lines(&printed),
        lines(&Claims::from_tokens(CRAIG.parse().unwrap()).derivation),
        lines(&judge(&chain, &note).0.derivation),
    ];
    let step = if std::env::var("ADVERSARY").is_ok() { 1 } else { 3 };
    let (mut judged, mut open, mut settled) = (0, 0, [0; 3]);
    let mut bad = Vec::new();
    for (lets, claims) in &sources {
        let head: String = lets.iter().map(|(n, w)| format!("let {n} = {};\n", w.join(" "))).collect();
        let mut wrong: Vec<Vec<String>> = claims.iter().flat_map(|c| slips(c)).collect();
        wrong.sort();
        wrong.dedup();
        if step == 1 {
            // two slips at once
            let mut state = 42;
            let second = |w: &Vec<String>| {
                let all = slips(w);
                let pick = |_| all.get((random(&mut state) * all.len() as f64) as usize).cloned();
                (0..PAIRS).filter_map(pick).collect::<Vec<_>>()
            };
            let pairs: Vec<Vec<String>> = wrong.iter().flat_map(second).collect();
            wrong.extend(pairs);
        }
        let chosen: Vec<Vec<String>> = claims.iter().cloned().chain(wrong.into_iter().step_by(step)).collect();
        for batch in chosen.chunks(20) {
            let text = head.clone() + &batch.iter().map(|w| w.join(" ") + ";\n").collect::<String>();
            let d = Claims::from_tokens(text.parse().unwrap()).derivation;
            let report = check_without_repairs(&chain, &d);
            let verdicts = &report.verdicts[lets.len()..];
            assert_eq!(verdicts.len(), batch.len());
            for (line, verdict) in batch.iter().zip(verdicts) {
                let Some(truth) = truth(lets, line) else { continue };
                judged += 1;
                settled[truth as usize] += 1;
                let fits = match verdict {
                    Verdict::Proven(w) if w.is_everywhere() => truth == Truth::Always,
                    Verdict::Proven(_) => truth != Truth::Never,
                    Verdict::Agrees => truth == Truth::Always,
                    Verdict::Wrong(_) => truth == Truth::Never,
                    Verdict::NotUnderstood(..) => {
                        open += 1;
                        true
                    }
                    Verdict::Noted => false,
                };
                if !fits {
                    bad.push(format!("{truth:?}, but {verdict:?}: {}", line.join(" ")));
                }
            }
        }
    }
    println!(
        "{judged} lines judged, {settled:?} hold always, sometimes, never; {open} left open; {} misjudged",
        bad.len()
    );
    assert!(bad.is_empty(), "{} of {judged} misjudged:\n{}", bad.len(), bad.join("\n"));
    assert!(judged > 600 && settled.iter().all(|n| *n > 5), "{judged} {settled:?}");
    assert!(50 * open < judged, "{open} of {judged} are left open");
}
