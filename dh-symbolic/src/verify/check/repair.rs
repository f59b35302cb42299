//! Repairs of wrong formulas: the smallest change (one token, or two) that makes a printed formula right.
//!
//! Candidates are what goes wrong when formulas are copied by hand: c for s, another index, another name, a flipped or lost sign,
//! a lost factor, a number. Each is tried in numbers at one point; what survives is proven.

use super::compare::{Outcome, Pair};
use super::direct::{Direct, Spot};
use super::value::Value;
use super::{Edit, Evaluator, Repair};
use crate::algebra::Factor;
use crate::verify::language::{Expr, NotUnderstood, Place, Relation, Token, TokenKind};

/// Longest printed formula that is searched.
pub(super) const LONGEST: usize = 240;
/// Most single changes that are combined in pairs.
const PAIRED: usize = 700;
/// Words that are read in search of repairs, for one formula and for a whole derivation.
pub(super) const EFFORT: usize = 400_000;
pub(super) const TOTAL_EFFORT: usize = 4_000_000;
/// Most survivors of the sieve that are proven.
const PROOFS: usize = 40;

/// What rounding may add to a value, as a part of it.
const NEAR: f64 = 1e-9;

/// The rank of a pair of changes: rather two wrong letters than one insertion.
const PAIR: u8 = 3;

/// A candidate: the smaller the rank, the likelier the slip.
pub(super) struct Candidate {
    pub(super) rank: u8,
    pub(super) edit: Edit,
}

impl Evaluator<'_> {
    /// A change of the tokens at `place` that makes them mean `target`.
    pub(super) fn repair(&mut self, place: &Place, target: &Value) -> Option<Repair> {
        self.ranked_repair(place, target).map(|m| m.1)
    }

    /// With its rank: how unlikely such a slip is.
    pub(super) fn ranked_repair(&mut self, place: &Place, target: &Value) -> Option<(u8, Repair)> {
        let tokens = self.tokens;
        let printed = tokens.get(place.clone())?;
        if printed.len() > LONGEST || self.searched > TOTAL_EFFORT {
            return None;
        }
        self.work.renew();
        let mut sieve = Spot::new(self.random_point(77));
        let goal = sieve.value(target);
        let mut singles = self.candidates(place, target);
        singles.sort_by_key(|c| c.rank);
        singles.truncate(EFFORT / printed.len().max(1));
        self.searched += singles.len() * printed.len();
        let mut proofs = 0;
        let mut values: Vec<Option<f64>> = Vec::with_capacity(singles.len());
        for c in &singles {
            let repair = Repair { edits: vec![c.edit.clone()] };
            let Some(v) = self.quick(&mut sieve, place, &repair) else {
                values.push(None);
                continue;
            };
            if v.is_near(&goal, NEAR) && proofs < PROOFS {
                proofs += 1;
                if self.proves(place, &repair, target) {
                    return Some((c.rank, repair));
                }
            }
            values.push(match v {
                Direct::Scalar(x) => Some(x),
                _ => None,
            });
        }
        self.pair_of_edits(place, target, &mut sieve, &goal, &singles, &values).map(|m| (PAIR, m))
    }

    /// Two changes in different terms add up; two in one term are tried one by one.
    fn pair_of_edits(
        &mut self,
        place: &Place,
        target: &Value,
        sieve: &mut Spot,
        goal: &Direct,
        singles: &[Candidate],
        values: &[Option<f64>],
    ) -> Option<Repair> {
        let Direct::Scalar(goal_value) = goal else { return None };
        let Some(Direct::Scalar(start)) = self.quick(sieve, place, &Repair { edits: vec![] }) else { return None };
        let usable: Vec<(&Candidate, f64)> = singles
            .iter()
            .zip(values)
            .filter(|(c, _)| c.rank <= 2)
            .filter_map(|(c, v)| Some((c, (*v)? - start)))
            .take(PAIRED)
            .collect();
        let missing = goal_value - start;
        let mut pairs: Vec<(u8, usize, usize)> = Vec::new();
        for (i, (a, x)) in usable.iter().enumerate() {
            for (j, (b, y)) in usable.iter().enumerate().skip(i + 1) {
                if a.edit.place == b.edit.place {
                    continue;
                }
                let distance = a.edit.place.start.abs_diff(b.edit.place.start);
                let adds_up = (x + y - missing).abs() < 1e-9;
                if adds_up || (distance <= 6 && a.rank + b.rank <= 2) {
                    pairs.push((a.rank + b.rank + u8::from(!adds_up), i, j));
                }
            }
        }
        pairs.sort_unstable();
        pairs.truncate(EFFORT / place.len().max(1));
        self.searched += pairs.len() * place.len();
        let mut proofs = 0;
        for (_, i, j) in pairs {
            let (Some((a, _)), Some((b, _))) = (usable.get(i), usable.get(j)) else { continue };
            let mut edits = vec![a.edit.clone(), b.edit.clone()];
            edits.sort_by_key(|e| e.place.start);
            let repair = Repair { edits };
            let near = self.quick(sieve, place, &repair).is_some_and(|v| v.is_near(goal, NEAR));
            if near && proofs < PROOFS {
                proofs += 1;
                if self.proves(place, &repair, target) {
                    return Some(repair);
                }
            }
        }
        None
    }

    fn quick(&mut self, sieve: &mut Spot, place: &Place, repair: &Repair) -> Option<Direct> {
        let e = Expr::parse(&repaired(self.tokens, place, repair)).ok()?;
        sieve.evaluate(&e, self)
    }

    fn proves(&mut self, place: &Place, repair: &Repair, target: &Value) -> bool {
        self.work.renew();
        let Ok(e) = Expr::parse(&repaired(self.tokens, place, repair)) else { return false };
        let Ok(v) = self.evaluate(&e) else { return false };
        match self.pair(v, target.clone(), place) {
            Ok(Pair::Scalars(x, y)) => matches!(self.compare_scalars(&x, &y, place), Ok(Outcome::Same(_))),
            Ok(Pair::Turns(t, u)) => matches!(self.compare_turns(&t, &u, place), Ok(Outcome::Same(_))),
            Ok(Pair::Matrices(m, n)) => m
                .entries
                .iter()
                .zip(&n.entries)
                .all(|(x, y)| matches!(self.compare_scalars(x, y, place), Ok(Outcome::Same(_)))),
            Err(_) => false,
        }
    }

    /// For a line that means nothing: a change of the side that means nothing, where the other one has a meaning.
    pub(super) fn repair_meaning(
        &mut self,
        first: &Expr,
        rest: &[(Relation, Expr)],
        n: &NotUnderstood,
    ) -> Option<Repair> {
        let [(Relation::Equal, second)] = rest else { return None };
        let inside = |e: &Expr| e.place.start <= n.place.start && n.place.end <= e.place.end;
        let order = if inside(first) { [(first, second), (second, first)] } else { [(second, first), (first, second)] };
        order.into_iter().find_map(|(broken, sound)| {
            let target = self.evaluate(sound).ok()?;
            self.repair(&broken.place.clone(), &target)
        })
    }

    /// All single changes that make `place` mean `target`.
    fn candidates(&mut self, place: &Place, target: &Value) -> Vec<Candidate> {
        let words = self.vocabulary(self.tokens.get(place.clone()).unwrap_or_default(), target);
        self.changes(place, &words)
    }

    /// All single changes with the names of a list.
    pub(super) fn changes(&self, place: &Place, words: &[String]) -> Vec<Candidate> {
        let tokens = self.tokens;
        let printed = tokens.get(place.clone()).unwrap_or_default();
        let mut out = Vec::new();
        let mut put = |rank: u8, range: Place, new: &[&str]| {
            let tokens = new.iter().map(|t| Token::new(t)).collect();
            out.push(Candidate { rank, edit: Edit { place: range, tokens } });
        };
        let is = |k: usize, mark: &str| k < place.end && tokens.get(k).is_some_and(|t| t.is(mark));
        for (offset, t) in printed.iter().enumerate() {
            let k = place.start + offset;
            let one = k..k + 1;
            let called = is(k + 1, "(");
            let field = offset > 0 && is(k - 1, ".");
            let frame = t.kind == TokenKind::Number && is_frame(tokens, k);
            let starts_term = offset == 0 || ["(", "[", ",", ";"].iter().any(|m| is(k - 1, m));
            match t.kind {
                TokenKind::Name if field => {
                    for f in siblings(&t.text) {
                        put(1, one.clone(), &[f]);
                    }
                }
                TokenKind::Name if called => {
                    for f in siblings(&t.text) {
                        put(1, one.clone(), &[f]);
                    }
                    match tokens.get(k + 2).filter(|_| is(k + 3, ")")) {
                        Some(only) => put(3, k..k + 4, &[&only.text]),
                        None => put(3, one.clone(), &[]),
                    }
                }
                TokenKind::Name => {
                    let swapped = swap(&t.text);
                    if let Some(s) = &swapped {
                        put(0, one.clone(), &[s]);
                    }
                    for w in words.iter().filter(|w| **w != t.text && Some(*w) != swapped.as_ref()) {
                        let family = |x: &str| x.trim_end_matches(|c: char| c.is_ascii_digit() || c == '_').to_string();
                        put(if family(w) == family(&t.text) { 1 } else { 2 }, one.clone(), &[w]);
                    }
                    put(4, k + 1..k + 1, &["^", "2"]);
                    for n in ["2", "-1"] {
                        put(4, k..k, &if n == "2" { vec!["2", "*"] } else { vec!["-"] });
                    }
                    for w in words {
                        put(5, k..k, &[w, "*"]);
                    }
                }
                // the two sides of a line speak of the same frames
                TokenKind::Number if frame => {}
                TokenKind::Number => {
                    for n in ["0", "1", "2", "3", "4", "5", "6", "0deg", "90deg", "180deg"] {
                        if n != t.text {
                            put(3, one.clone(), &[n]);
                        }
                    }
                    for w in words {
                        put(4, one.clone(), &[w]);
                        put(5, one.clone(), &["-", w]);
                    }
                }
                TokenKind::Mark => match t.text.as_str() {
                    "+" => put(0, one.clone(), &["-"]),
                    "-" if starts_term => put(0, one.clone(), &[]),
                    "-" => put(0, one.clone(), &["+"]),
                    "*" | "/" => {
                        put(4, k..k + 2, &[]);
                        put(4, one.clone(), &[if t.text == "*" { "/" } else { "*" }]);
                        put(4, one.clone(), &["+"]);
                    }
                    "^" => put(4, k..k + 2, &[]),
                    _ => {}
                },
                TokenKind::Note | TokenKind::Other => {}
            }
            if starts_term && !frame && !t.is("-") && t.kind != TokenKind::Note {
                put(1, k..k, &["-"]);
            }
        }
        // a factor before the whole, and the whole transposed
        for w in words {
            put(5, place.start..place.start, &[w, "*"]);
        }
        put(3, place.end..place.end, &[".", "t"]);
        out
    }

    /// The names that a repair may use: those of the formula, and those of the correct value.
    fn vocabulary(&mut self, printed: &[Token], target: &Value) -> Vec<String> {
        let mut words: Vec<String> = Vec::new();
        let mut add = |w: String| {
            if !words.contains(&w) {
                words.push(w);
            }
        };
        for (i, t) in printed.iter().enumerate() {
            let called = printed.get(i + 1).is_some_and(|n| n.is("("));
            let field = i > 0 && printed.get(i - 1).is_some_and(|n| n.is("."));
            if t.kind == TokenKind::Name && !called && !field {
                add(t.text.clone());
                if let Some(s) = swap(&t.text) {
                    add(s);
                }
            }
        }
        let entries: Vec<&crate::algebra::Poly> = match target {
            Value::Scalar(x) => vec![&x.num, &x.den],
            Value::Matrix(m) => m.entries.iter().map(|x| &x.num).collect(),
            Value::Angle(_) => vec![],
        };
        for p in entries {
            for (m, _) in p.terms() {
                for f in m.factors() {
                    let name = match &f {
                        Factor::Power(s, _) => self.ring.symbol_name(*s).to_string(),
                        Factor::Cos(t) => self.ring.harmonic_text(t, false),
                        Factor::Sin(t) => self.ring.harmonic_text(t, true),
                        Factor::Root(_) => continue,
                    };
                    if Token::new(&name).kind == TokenKind::Name
                        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
                    {
                        add(name);
                    }
                }
            }
        }
        words
    }
}

/// The tokens of a place after a change.
pub(super) fn repaired(tokens: &[Token], place: &Place, repair: &Repair) -> Vec<Token> {
    let mut out = Vec::with_capacity(place.len() + 2);
    let mut at = place.start;
    for e in &repair.edits {
        out.extend(tokens.get(at..e.place.start).unwrap_or_default().iter().cloned());
        out.extend(e.tokens.iter().cloned());
        at = e.place.end;
    }
    out.extend(tokens.get(at..place.end).unwrap_or_default().iter().cloned());
    out
}

impl Repair {
    /// The tokens of a place of the derivation, with the change made. The edits must lie inside.
    pub fn apply(&self, tokens: &[Token], place: &Place) -> Vec<Token> {
        repaired(tokens, place, self)
    }
}

/// Is this word one of the numbers of `T(0,6)` or `A(3)`?
fn is_frame(tokens: &[Token], k: usize) -> bool {
    let call = |open: usize| {
        tokens.get(open).is_some_and(|t| t.is("("))
            && open.checked_sub(1).and_then(|n| tokens.get(n)).is_some_and(|t| t.text == "T" || t.text == "A")
    };
    k.checked_sub(1).is_some_and(call) || k.checked_sub(3).is_some_and(call)
}

/// s23 for c23, sphi for cphi.
fn swap(name: &str) -> Option<String> {
    let rest = name.get(1..).filter(|r| !r.is_empty())?;
    match name.get(..1)? {
        "c" => Some(format!("s{rest}")),
        "s" => Some(format!("c{rest}")),
        _ => None,
    }
}

/// Functions and entries that are taken for one another.
fn siblings(name: &str) -> Vec<&'static str> {
    let families: [&[&'static str]; 9] = [
        &["cos", "sin", "tan"],
        &["c", "s"],
        &["acos", "asin", "atan"],
        &["Rx", "Ry", "Rz"],
        &["Tx", "Ty", "Tz"],
        &["px", "py", "pz"],
        &["x", "y", "z"],
        &["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"],
        &["dot", "cross"],
    ];
    let family = families.into_iter().find(|f| f.contains(&name)).unwrap_or_default();
    family.iter().copied().filter(|f| *f != name).collect()
}
