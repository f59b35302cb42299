//! Documents that nobody would write: real ones, cut, spliced, nested and strewn with marks. The checker answers all of them.
//!
//! A few seeds each time; `.ci/fuzz` (`SEEDS=n`) takes more, with a bound on time and memory of the whole process.

use std::path::Path;

use dh_symbolic::chain::Chain;
use dh_symbolic::chain::table::parse;
use dh_symbolic::render::{Format, Options, notes};
use dh_symbolic::verify::judge;
use dh_symbolic::verify::listing::{Finding, document_lines, document_text};
use generated_examples::{corpus, source};

/// Most characters of a mutated document: what is longer is a test of its own.
const LONGEST: usize = 6_000;

/// What is strewn in.
const MARKS: &[&str] = &[
    "$",
    "$$",
    "\\[",
    "\\]",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "^",
    "_",
    "&",
    "\\\\",
    "=",
    "\\ne",
    "<",
    "±",
    "\\pm",
    "\\mp",
    ",",
    ";",
    "'",
    "|",
    "\\frac",
    "\\frac{1}{",
    "\\sqrt{",
    "\\left(",
    "\\right.",
    "\\begin{bmatrix}",
    "\\end{bmatrix}",
    "\\begin{cases}",
    "\\end{cases}",
    "\\begin{aligned}",
    "\\begin{array}{ccc|c}",
    "\\cdots",
    "\\dot{",
    "\\partial",
    "\\text{ORG}",
    "\\def\\x{\\x\\x}",
    "\\newcommand{\\y}[2]{#1#2}",
    "\\x",
    "\\y{a}{b}",
    "{}^0_6T",
    "{}^{i-1}_iT",
    "J",
    "\\det",
    "^{-1}",
    "^T",
    "\\theta_1",
    "c_{23}",
    "\\alpha_{i-1}",
    "0.0",
    "1e-400",
    "10^{400}",
    "999999999999999999999",
    "90^\\circ",
    "- [ ] ",
    "- [x] ",
    "```math\n",
    "```\n",
    "$`",
    "`$",
    "\n\n",
    "\n",
    " ",
    "⎡",
    "⎣",
    "⁰T₆",
    "当",
    "若",
    "\u{0}",
    "\u{202e}",
    "If $a_1 = 0$, ",
    "\\tan^{-1}\\frac",
    "atan2(",
    "subst(",
    "let x = ",
    "at q1 = ",
];

struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n.max(1)
    }
}

/// A part of a document, from some place on.
fn stretch(text: &[char], most: usize, r: &mut Random) -> Vec<char> {
    let from = r.below(text.len());
    let length = 1 + r.below(most);
    text.iter().skip(from).take(length).copied().collect()
}

/// A document that is made of real ones.
fn mutated(documents: &[Vec<char>], seed: u64) -> String {
    let mut r = Random(seed.wrapping_mul(7919) + 11);
    for _ in 0..4 {
        r.below(2);
    }
    let mut text = stretch(&documents[r.below(documents.len())], LONGEST / 2, &mut r);
    for _ in 0..1 + r.below(24) {
        let at = r.below(text.len() + 1);
        match r.below(6) {
            0 => {
                let mark: Vec<char> = MARKS[r.below(MARKS.len())].chars().collect();
                let times = if r.below(6) == 0 { 1 + r.below(200) } else { 1 };
                text.splice(at..at, mark.iter().copied().cycle().take(mark.len() * times));
            }
            1 => drop(text.drain(at..(at + r.below(40)).min(text.len()))),
            2 => {
                let other = stretch(&documents[r.below(documents.len())], 400, &mut r);
                text.splice(at..at, other);
            }
            3 => {
                let own = stretch(&text, 60, &mut r);
                let times = 1 + r.below(8);
                text.splice(at..at, own.iter().copied().cycle().take(own.len() * times));
            }
            4 if at < text.len() => text[at] = char::from_u32(r.below(0x2500) as u32).unwrap_or('?'),
            _ => text.truncate(text.len().max(LONGEST / 4).min(text.len() - r.below(text.len() / 8 + 1))),
        }
        text.truncate(LONGEST);
    }
    text.into_iter().collect()
}

fn example(module: &str) -> String {
    source::all().unwrap().into_iter().find(|s| s.module == module).unwrap().body
}

fn chain(table: &str) -> Chain {
    Chain::new(parse(table.parse().expect("words")).spec.expect("a table"))
}

/// A report says something of every line, and can be printed.
fn answered(chain: &Chain, text: &str) -> usize {
    let (claims, report) = judge(chain, text);
    let lines = document_lines(&report, &claims);
    assert!(lines.len() <= report.verdicts.len());
    assert!(!document_text(&report, &claims).is_empty());
    lines.len()
}

#[test]
fn mutated_documents_are_answered() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut documents: Vec<Vec<char>> = Vec::new();
    for name in ["puma560_slides.md", "puma560.txt", "puma560.tex"] {
        documents.push(std::fs::read_to_string(folder.join("papers").join(name)).unwrap().chars().collect());
    }
    let puma = chain(&std::fs::read_to_string(corpus::folder().join("puma560.dh")).unwrap());
    let arms: Vec<Chain> = ["planar_3r", "rpr"].iter().map(|n| chain(&example(n))).chain([puma]).collect();
    for format in [Format::Latex, Format::Markdown, Format::Text] {
        documents.extend(arms.iter().map(|a| notes(a, &Options::default()).print(format).chars().collect()));
    }
    let seeds: u64 = std::env::var("SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(24);
    let mut lines = 0;
    for seed in 0..seeds {
        let text = mutated(&documents, seed);
        // said where the checker panics
        let answer = std::panic::catch_unwind(|| answered(&arms[seed as usize % arms.len()], &text));
        lines += answer.unwrap_or_else(|_| panic!("seed {seed}:\n{text}"));
    }
    assert!(lines as u64 > seeds, "{lines} lines of {seeds} documents");
}

/// Deep, long, and growing without end.
#[test]
fn hostile_documents_are_answered() {
    let puma = chain(&std::fs::read_to_string(corpus::folder().join("puma560.dh")).unwrap());
    let nested = |open: &str, close: &str| format!("$$p_x = {}1{}$$\n", open.repeat(12_000), close.repeat(12_000));
    let growing: String = (b'a'..=b'y')
        .map(|c| format!("\\newcommand{{\\m{0}}}{{\\m{1}\\m{1}}}\n", c as char, (c + 1) as char))
        .collect();
    for text in [
        nested("(", ")"),
        nested("{", "}"),
        nested("\\left(", "\\right)"),
        nested("\\frac{1}{", "}"),
        nested("\\sqrt{", "}"),
        nested("\\begin{bmatrix}", "\\end{bmatrix}"),
        nested("-", ""),
        format!("px = {}1{}\n", "(".repeat(12_000), ")".repeat(12_000)),
        format!("$${}p_x = 1{}$$", "{".repeat(12_000), "}".repeat(12_000)),
        "$".repeat(1_000_000),
        "$p_x".repeat(200_000),
        format!("p_x = {}1", "c1*s1 + ".repeat(100_000)),
        "- [ ] a = b\n- [x] $p_x = 1$\n- [ ] q1 = [ ]\n".repeat(20),
        "$$p_x = 1e-400 + 1e400 + 10^{400}$$".into(),
        format!("$$p_x = 0.{}$$", "1".repeat(50_000)),
        "$$p_x = (c_1 + s_1 + c_2 + s_2 + a_2 + a_3)^{16}(c_{23} + s_4 + c_5 + s_6)^{16}$$".into(),
        growing + "$$\\ma = p_x$$",
    ] {
        let (claims, report) = judge(&puma, &text);
        let start: String = text.chars().take(60).collect();
        // none of them holds, and something is said of every equation
        let lines = document_lines(&report, &claims);
        assert!(!lines.is_empty() || !text.contains('='), "{start}");
        let proven = |f: Finding| matches!(f, Finding::Proven | Finding::ProvenWhere | Finding::Agrees);
        assert!(!lines.iter().any(|l| proven(l.finding)), "{start}: {lines:?}");
    }
}

/// More than is read: refused in one line.
#[test]
fn documents_without_end_are_refused() {
    let arm = chain(&example("planar_3r"));
    let text = "$$p_x = 1$$\n".repeat(900_000);
    assert_eq!(answered(&arm, &text), 1);
}
