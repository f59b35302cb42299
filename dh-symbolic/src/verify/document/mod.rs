//! Reads printed derivations (LaTeX, Markdown or plain text) as lines of a [`Derivation`].
//!
//! **In:** a [`Chain`] and the text of a document. **Out:** a [`DocumentClaims`]: the lines of the document that say something about the
//! robot, in the notation of [`claim`](super::language), each with the number of its line. Prose is skipped and counted.
//!
//! **Never here:** verdicts (those are in `verify::check`), algebra.
//!
//! # What is read
//!
//! In a document with marked formulas, what stands between `$`, `$$`, `\[ \]`, `\( \)` or in `equation`, `align`, `gather` and the
//! like. In a document without any, every line with a relation whose left side is a formula; matrices may be drawn with
//! `⎡ ⎢ ⎣`. A row that begins with a sign or a relation continues the one before.
//!
//! | printed | meaning |
//! |---------|---------|
//! | `{}^0_6T` `^0T_6` `T_6^0` `T_{06}` `0T6` `⁰T₆` `A_1` | transforms between frames; `{}^0_3R` and `{}^0P_4` their parts; `^{-1}` and `^T` |
//! | `r_{11}` `p_x` `{}^1r_{11}` `{}^0_6T r_{11}` | entries: of the transform whose matrix named them last, otherwise of the whole arm |
//! | `c_1` `s_{23}` `c_{2-3}` `c₂₃` `c23` `c\theta_1` `\cos(\theta_2+\theta_3)` `\cos[t1]` | cosines and sines |
//! | `c_i = \cos q_i` | says whether c1 is the cosine of q1 (so without it) or of the table's angle theta1 |
//! | `{}^{4'}_4T = D_z(d_4)` | defines a frame 4' beside those of the table; `{}^0_6T = G` calls the pose G and its entries r and p |
//! | `J` `J_2` `J_{12}` | the geometric Jacobian, its columns and entries |
//! | `[ ]` `\{ \}` `\left( \right)` | brackets; with `,` or `;` inside a matrix |
//! | `U = {}^0_1T^{-1} {}^0_6T`, `K = ...` | names for later lines; `u_{11}`, `u_x` and `u` are the entries and the position of a matrix U |
//! | `\theta_1 = 20^\circ`, `a_2 = 0.43` | given values; numbers with decimals on one side are then compared to their printed digits |
//! | `If $a_1 = 0$, $r = k_3$` | said for this value |
//! | `r = ...` where r is already a name and this is not what it was, nor a slip in it | a new meaning from there on; `a\cos\theta + b\sin\theta = c` is a law for any quantities, if the document does not say what they are in this arm |
//! | `A \pm B` | both of the two; what an angle is equated to must have the cosine that this says |

mod ascii_matrices;
mod brackets;
mod calls;
mod cases;
mod commands;
mod definitions;
mod layout;
mod letter;
mod macros;
mod meaning;
mod names;
mod others;
mod pieces;
mod reader;
mod regions;
mod statements;
mod tables;
#[cfg(test)]
mod tests;
mod transforms;
mod unapplied;
mod values;

use super::language::{Derivation, NotUnderstood, Place, Statement, Token, TokenKind};
use crate::chain::Chain;
use names::DocumentNames;
use std::collections::{BTreeMap, BTreeSet};

/// A document: its lines as a derivation, and where they stand.
#[derive(Clone, Debug, Default)]
pub struct DocumentClaims {
    /// What it says.
    pub derivation: Derivation,
    /// How many lines with text say nothing about the robot.
    pub prose: usize,
    /// Where the table's angle of a joint has an offset and the document speaks of theta_i: is the variable meant?
    pub theta_is_variable: Option<bool>,
    /// Line in the document of every token of the derivation.
    lines: Vec<usize>,
    /// Quantities that the document leaves free, by their names.
    free: BTreeSet<String>,
    /// Is it about other arms too?
    has_others: bool,
    /// Lines of the document whose names are said further down.
    waited: BTreeSet<usize>,
}

/// What one reading of a document shows for the next one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Learnt {
    /// Lines that give a letter a new meaning, and the letter.
    renewed: BTreeSet<(usize, String)>,
    /// Lines with laws that hold for any quantities: what their letters are further down does not fit.
    laws: BTreeSet<usize>,
}

impl DocumentClaims {
    /// Reads a document. Never fails as a whole, never panics.
    pub fn read(chain: &Chain, text: &str) -> DocumentClaims {
        DocumentClaims::read_as(chain, text, false, &Learnt::default()).0
    }

    /// The same, with theta_i as the variable of joint i instead of the table's angle, where the two differ; and whether they do anywhere.
    pub(super) fn read_as(
        chain: &Chain,
        text: &str,
        theta_is_variable: bool,
        learnt: &Learnt,
    ) -> (DocumentClaims, bool) {
        let mut names = DocumentNames::new(chain);
        names.learnt = learnt.clone();
        names.theta_is_variable = theta_is_variable;
        let mut sheet = Sheet::default();
        if text.len() > LARGEST {
            sheet.refuse("the document", 1, format!("longer than {} MB: not read", LARGEST / 1_000_000));
            return (sheet.finish(text), false);
        }
        let regions = regions::split(text, &names);
        statements::census(&regions, &mut names);
        for region in regions {
            if sheet.count >= MOST {
                let line = region.text.first().map_or(0, |t| t.1);
                sheet.refuse("the rest of the document", line, format!("more than {MOST} formulas: not read"));
                break;
            }
            statements::read(&region, &mut names, &mut sheet);
        }
        statements::finish(&mut names, &mut sheet);
        let mut claims = sheet.finish(text);
        claims.has_others = names.has_others;
        claims.free = names.free;
        (claims, names.theta_differs.get())
    }

    /// Of lines with quantities that the document leaves free, those that do not hold for all of them say something of the free ones.
    pub(super) fn forgive(&self, report: &mut crate::verify::check::Report) {
        use crate::verify::check::Verdict;
        let laws = self.names_of_laws();
        for (line, verdict) in self.derivation.lines.iter().zip(&mut report.verdicts) {
            let words = self.derivation.tokens.get(line.place.clone()).unwrap_or_default();
            let near = words.iter().any(|t| t.is("~"));
            // what holds of no quantity of the arm is nothing that is said of it
            let name = |t: &&Token| t.kind == TokenKind::Name && !is_function(&t.text);
            let of_law = words.iter().any(|t| laws.contains(&t.text))
                && words.iter().filter(name).all(|t| laws.contains(&t.text));
            if of_law && matches!(verdict, Verdict::Wrong(_) | Verdict::NotUnderstood(..)) {
                *verdict = Verdict::Noted;
            }
            if let Verdict::NotUnderstood(n, _) = verdict {
                // an example in numbers, of which the document does not give all
                if self.has_others && near && n.why.contains(crate::verify::check::NO_VALUE) {
                    *verdict = Verdict::Noted;
                }
                continue;
            }
            let Verdict::Wrong(faults) = verdict else { continue };
            let slip = faults.iter().all(|f| f.repair.is_some());
            let free = words.iter().find(|t| self.free.contains(&t.text));
            if self.has_others && near {
                let why = "numbers that do not fit the given values: of another arm of this document?".to_string();
                *verdict = Verdict::NotUnderstood(NotUnderstood { place: line.place.clone(), why }, None);
            } else if free.is_some()
                && (self.has_others || words.iter().filter(name).all(|t| self.free.contains(&t.text)))
            {
                // it says something of quantities that are none of this arm
                *verdict = Verdict::Noted;
            } else if self.has_others && !slip {
                let why = "this does not hold for this arm: is another arm of this document meant?".to_string();
                *verdict = Verdict::NotUnderstood(NotUnderstood { place: line.place.clone(), why }, None);
            } else if let Some(name) = free {
                let why = format!("this does not hold for every `{}`, and nothing says which is meant", name.text);
                *verdict = Verdict::NotUnderstood(NotUnderstood { place: line.place.clone(), why }, None);
            }
        }
    }

    /// Names of laws for any quantities: those that are left free, and what is defined by nothing else.
    fn names_of_laws(&self) -> BTreeSet<String> {
        let mut laws = self.free.clone();
        for line in &self.derivation.lines {
            let Statement::Define(name, value) = &line.statement else { continue };
            let words = self.derivation.tokens.get(value.place.clone()).unwrap_or_default();
            let mut names = words.iter().filter(|t| t.kind == TokenKind::Name && !is_function(&t.text)).peekable();
            if names.peek().is_some() && names.all(|t| laws.contains(&t.text)) {
                laws.insert(name.clone());
            }
        }
        laws
    }

    /// What the verdicts show of the meaning of letters: a letter of the document that is equal to something quite different further down, and
    /// not by a slip, is defined anew there.
    pub(super) fn learn(&self, report: &crate::verify::check::Report, learnt: &mut Learnt) -> bool {
        use super::language::{ExprKind, Relation};
        use crate::verify::check::Verdict;
        let before = learnt.clone();
        let mut defined: BTreeSet<&str> = BTreeSet::new();
        let mut anew: BTreeSet<&str> = BTreeSet::new();
        for (line, verdict) in self.derivation.lines.iter().zip(&report.verdicts) {
            let number = self.line(&line.place);
            match (&line.statement, verdict) {
                (Statement::Define(name, _), _) => _ = defined.insert(name),
                (Statement::Claim { .. } | Statement::Either(_), Verdict::Wrong(_))
                    if self.waited.contains(&number) =>
                {
                    learnt.laws.insert(number);
                }
                (Statement::Claim { first, rest, .. }, Verdict::Wrong(faults)) => {
                    if let (ExprKind::Name(name), [(Relation::Equal, value), ..]) = (&first.kind, rest.as_slice())
                        && defined.contains(name.as_str())
                        && faults.iter().all(|f| f.repair.is_none())
                        && !self
                            .derivation
                            .tokens
                            .get(value.place.clone())
                            .unwrap_or_default()
                            .iter()
                            .any(|t| t.text == *name)
                    {
                        // what comes after it may repeat the new meaning
                        if anew.insert(name) {
                            let letter = name.trim_end_matches('x').strip_suffix('_').unwrap_or(name);
                            learnt.renewed.insert((number, letter.to_string()));
                        }
                    }
                }
                _ => {}
            }
        }
        *learnt != before
    }

    /// Line of the document, from 1, where some words stand. 0 where there are none.
    pub fn line(&self, place: &Place) -> usize {
        self.lines.get(place.start).or(self.lines.last()).copied().unwrap_or(0)
    }
}

/// Is it the name of a function?
fn is_function(name: &str) -> bool {
    matches!(
        name,
        "cos" | "sin" | "tan" | "atan2" | "atan" | "acos" | "asin" | "sqrt" | "let" | "or" | "if" | "at" | "pi"
    )
}

/// Largest document, in bytes, and most formulas in it.
const LARGEST: usize = 4_000_000;
const MOST: usize = 4_000;

/// Letters that are shown of a line that is not understood.
const LONGEST: usize = 100;

/// A word and its line in the document.
#[derive(Clone, Debug, PartialEq)]
struct Word {
    token: Token,
    line: usize,
}

impl Word {
    fn new(text: &str, line: usize) -> Word {
        Word { token: Token::new(text), line }
    }
}

/// The derivation while it is written.
#[derive(Default)]
struct Sheet {
    tokens: Vec<Token>,
    lines: Vec<usize>,
    /// Why the line that begins with this token was not understood.
    refused: BTreeMap<usize, String>,
    /// Lines, by their first token, that say something and claim nothing: their text.
    remarks: BTreeMap<usize, String>,
    /// Quantities of any row that have been given a name.
    general: BTreeSet<String>,
    /// Lines so far.
    count: usize,
    /// Lines of the document that waited for a name.
    waited: BTreeSet<usize>,
    /// Lines with a name that a later line may define.
    waiting: Vec<(pieces::Statement, names::Unknown)>,
    /// Lines of the document that say something, in order of appearance.
    used: Vec<usize>,
}

/// The beginning of a long text.
fn short(text: &str) -> String {
    let mut out: String = text.chars().take(LONGEST).collect();
    if out.len() < text.len() {
        out.push_str("...");
    }
    out
}

impl Sheet {
    fn put(&mut self, words: Vec<Word>) {
        self.count += 1;
        let last = words.last().map_or(0, |w| w.line);
        for w in words {
            self.used.push(w.line);
            self.lines.push(w.line);
            self.tokens.push(w.token);
        }
        self.lines.push(last);
        self.tokens.push(Token::new(";"));
    }

    /// A line that is not understood: its text and why.
    fn refuse(&mut self, text: &str, line: usize, why: String) {
        self.refused.insert(self.tokens.len(), why);
        self.one_word(text, line);
    }

    /// A line that says something and claims nothing.
    fn remark(&mut self, text: &str, line: usize) {
        self.remarks.insert(self.tokens.len(), text.to_string());
        self.one_word(text, line);
    }

    fn one_word(&mut self, text: &str, line: usize) {
        self.count += 1;
        self.used.push(line);
        self.lines.extend([line, line]);
        self.tokens.push(Token { kind: TokenKind::Other, text: short(text) });
        self.tokens.push(Token::new(";"));
    }

    fn finish(mut self, text: &str) -> DocumentClaims {
        let mut derivation = Derivation::parse(self.tokens);
        for line in &mut derivation.lines {
            if let Some(why) = self.refused.get(&line.place.start) {
                line.statement = Statement::Unreadable(NotUnderstood { place: line.place.clone(), why: why.clone() });
            }
            if let Some(text) = self.remarks.get(&line.place.start) {
                line.statement = Statement::Remark(text.clone());
            }
        }
        self.used.sort_unstable();
        self.used.dedup();
        let full = |(k, l): &(usize, &str)| !l.trim().is_empty() && self.used.binary_search(&(k + 1)).is_err();
        let prose = text.lines().enumerate().filter(full).count();
        DocumentClaims {
            derivation,
            prose,
            theta_is_variable: None,
            lines: self.lines,
            free: BTreeSet::new(),
            has_others: false,
            waited: self.waited,
        }
    }
}
