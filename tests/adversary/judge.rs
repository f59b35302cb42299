//! Holds the checker's verdicts on true lines and their slips against plain numbers.

use super::numbers::{Calculator, Given, Truth, random};
use super::slips::slips;
use dh_symbolic::chain::{Chain, ChainSpec};
use dh_symbolic::verify::check::{Verdict, check_without_repairs};
use dh_symbolic::verify::language::{Derivation, Statement, Token};

/// Lines that are given to the checker at once.
const BATCH: usize = 50;

/// What names mean, and what is claimed with them.
pub(crate) struct Source {
    heads: Vec<Vec<String>>,
    lets: Vec<(String, Given)>,
    claims: Vec<Vec<String>>,
}

impl Source {
    /// Definitions and equations of a derivation.
    pub(crate) fn new(d: &Derivation) -> Source {
        let mut s = Source { heads: Vec::new(), lets: Vec::new(), claims: Vec::new() };
        for l in &d.lines {
            let own: Vec<String> = d.tokens[l.place.clone()].iter().map(|t| t.text.clone()).collect();
            let angle = |own: &[String]| own.last().is_some_and(|w| w == "angle");
            match &l.statement {
                Statement::Define(name, _) => s.lets.push((name.clone(), Given::Formula(own[3..].to_vec()))),
                Statement::Free(name, _) => s.lets.push((name.clone(), Given::Free(angle(&own)))),
                Statement::Claim { .. } | Statement::Either(_) => {
                    if own.iter().all(|w| !["~", "<", ">", "!", "if"].contains(&w.as_str())) {
                        s.claims.push(own);
                    }
                    continue;
                }
                _ => continue,
            }
            s.heads.push(own);
        }
        s
    }
}

/// How many lines are tried.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    /// Every how many lines one is taken.
    pub(crate) step: usize,
    /// Slips for each line, at most.
    pub(crate) slips: usize,
    /// Second slips for each first one.
    pub(crate) pairs: usize,
}

/// What came out.
#[derive(Default)]
pub(crate) struct Tally {
    /// Lines with a verdict in numbers.
    pub(crate) judged: usize,
    /// Those that hold always, sometimes, never.
    pub(crate) settled: [usize; 3],
    /// Those that the checker left open.
    pub(crate) open: usize,
    /// Misjudged lines.
    pub(crate) bad: Vec<String>,
}

impl Tally {
    /// Judges the lines of a source and their slips.
    pub(crate) fn judge(&mut self, name: &str, spec: &ChainSpec, source: &Source, extent: Extent) {
        let chain = Chain::new(spec.clone());
        let numbers = Calculator::new(spec);
        let mut state = 42;
        let claims = || source.claims.iter().step_by(extent.step);
        let mut lines: Vec<Vec<String>> = claims().cloned().collect();
        for claim in claims() {
            let mut wrong = slips(claim, numbers.dof());
            wrong.sort();
            wrong.dedup();
            let mut some = |all: &[Vec<String>], n: usize| -> Vec<Vec<String>> {
                if all.len() <= n {
                    return all.to_vec();
                }
                (0..n).filter_map(|_| all.get((random(&mut state) * all.len() as f64) as usize).cloned()).collect()
            };
            let first = some(&wrong, extent.slips);
            for w in &first {
                lines.extend(some(&slips(w, numbers.dof()), extent.pairs));
            }
            lines.extend(first);
        }
        lines.sort();
        lines.dedup();
        for batch in lines.chunks(BATCH) {
            let all = source.heads.iter().chain(batch);
            let words = all.flat_map(|l| l.iter().map(String::as_str).chain([";"]));
            let d = Derivation::parse(words.map(Token::new).collect());
            let report = check_without_repairs(&chain, &d);
            let verdicts = &report.verdicts[source.heads.len()..];
            assert_eq!(verdicts.len(), batch.len(), "{name}");
            for (line, verdict) in batch.iter().zip(verdicts) {
                let Some(truth) = numbers.truth(&source.lets, line) else { continue };
                self.judged += 1;
                self.settled[truth as usize] += 1;
                let several = line.iter().any(|w| w == "or" || w == "±" || w == "∓");
                let fits = match verdict {
                    Verdict::Proven(w) if w.is_everywhere() => truth == Truth::Always,
                    Verdict::Proven(_) => truth != Truth::Never,
                    Verdict::Agrees => truth == Truth::Always,
                    // where several signs are left open, one must hold everywhere
                    Verdict::Wrong(_) => truth == Truth::Never || several && truth == Truth::Sometimes,
                    Verdict::NotUnderstood(..) => {
                        self.open += 1;
                        true
                    }
                    Verdict::Noted => false,
                };
                if !fits {
                    self.bad.push(format!("{name}: {truth:?}, but {verdict:?}: {}", line.join(" ")));
                }
            }
        }
    }
}
