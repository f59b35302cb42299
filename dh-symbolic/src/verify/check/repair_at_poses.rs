//! Repairs of lines with angles and roots: the smallest change with which the line holds at poses of the arm, and is then proven.
//!
//! Where a root has two signs and an angle two branches, a right line may hold at a part of the poses only: one point says nothing.

use super::direct::{Direct, Spot};
use super::line::Sides;
use super::repair::{Candidate, EFFORT, LONGEST, TOTAL_EFFORT, repaired};
use super::{Edit, Evaluator, Repair, Verdict};
use crate::chain::Handle;
use crate::verify::language::{Expr, Place, Relation, Token, TokenKind};

/// Poses at which every candidate is tried.
const POSES: usize = 12;
/// A candidate that holds at none of the first poses is dropped.
const FIRST: usize = 7;
/// Most candidates that are proven.
const PROOFS: usize = 16;
/// Two values are the same if they differ by no more than this part of their size.
const NEAR: f64 = 1e-9;
/// Ranks of the changes that only lines with angles and roots need: arguments in the other order, a half turn or a term too few.
const SWAPPED: u8 = 1;
const MISSING: u8 = 4;
/// What a change costs more on a side that is one name: rather the long side is wrong.
const SHORT_SIDE: u8 = 2;

/// A candidate that holds at some of the poses.
struct Survivor {
    rank: u8,
    everywhere: bool,
    on_left: bool,
    edit: Edit,
}

impl<'a> Evaluator<'a> {
    /// A change of one of both sides with which they are equal.
    pub(super) fn repair_at_poses(&mut self, sides: &Sides<'_>) -> Option<Repair> {
        if self.searched > TOTAL_EFFORT {
            return None;
        }
        let words = self.words_of(&[&sides.left.place, &sides.right.place]);
        let mut spots: Vec<Spot> = self.poses();
        let mut survivors = Vec::new();
        for on_left in [false, true] {
            let (own, other) = if on_left { (sides.left, sides.right) } else { (sides.right, sides.left) };
            if own.place.len() > LONGEST {
                continue;
            }
            let goals: Vec<Option<Direct>> = spots.iter_mut().map(|s| s.evaluate(other, self)).collect();
            let mut all = self.angle_changes(&own.place, &words);
            all.sort_by_key(|c| c.rank);
            all.truncate(EFFORT / 4 / own.place.len().max(1));
            self.searched += all.len() * own.place.len();
            let extra = if own.place.len() == 1 { SHORT_SIDE } else { 0 };
            for c in all {
                let repair = Repair { edits: vec![c.edit] };
                let Ok(e) = Expr::parse(&repaired(self.tokens, &own.place, &repair)) else { continue };
                let Some(everywhere) = self.holds_at(&e, &goals, &mut spots) else { continue };
                let Some(edit) = repair.edits.into_iter().next() else { continue };
                survivors.push(Survivor { rank: c.rank + extra, everywhere, on_left, edit });
            }
        }
        survivors.sort_by_key(|s| (s.rank, !s.everywhere));
        // what a candidate would need as a repair is of no interest
        let searched = std::mem::replace(&mut self.searched, usize::MAX);
        let found = survivors.into_iter().take(PROOFS).find(|s| {
            let place = if s.on_left { &sides.left.place } else { &sides.right.place };
            let repair = Repair { edits: vec![s.edit.clone()] };
            let Ok(e) = Expr::parse(&repaired(self.tokens, place, &repair)) else { return false };
            let changed = if s.on_left { Sides::new(&e, sides.right) } else { Sides::new(sides.left, &e) };
            self.work.renew();
            matches!(self.relation(&changed, Relation::Equal, None), Ok(Verdict::Proven(_)))
        });
        self.searched = searched;
        found.map(|s| Repair { edits: vec![s.edit] })
    }

    /// Poses of the arm as it is.
    pub(super) fn poses(&self) -> Vec<Spot> {
        (0..).map(|k| self.sample(k)).filter(|s| s.1).take(POSES).map(|s| Spot::new(s.0)).collect()
    }

    /// Does a formula have the given values at some poses? Then, whether at all of them.
    fn holds_at(&self, e: &Expr, goals: &[Option<Direct>], spots: &mut [Spot]) -> Option<bool> {
        let (mut agree, mut differ) = (0, 0);
        for (spot, goal) in spots.iter_mut().zip(goals) {
            let (Some(goal), Some(v)) = (goal, spot.evaluate(e, self)) else { continue };
            if !goal.is_finite() || !v.is_finite() {
                continue;
            }
            if v.is_near(goal, NEAR) {
                agree += 1;
            } else {
                differ += 1;
            }
            if agree == 0 && differ >= FIRST {
                return None;
            }
        }
        (agree > 1).then_some(differ == 0)
    }

    /// The names of some places, their neighbours (c2 for c1), and the lengths of the table.
    pub(super) fn words_of(&self, places: &[&Place]) -> Vec<String> {
        let mut words: Vec<String> = Vec::new();
        let mut add = |w: String| {
            if !words.contains(&w) {
                words.push(w);
            }
        };
        for place in places {
            let tokens = self.tokens.get((*place).clone()).unwrap_or_default();
            for (k, t) in tokens.iter().enumerate() {
                let called = tokens.get(k + 1).is_some_and(|n| n.is("("));
                let field = k > 0 && tokens.get(k - 1).is_some_and(|n| n.is("."));
                if t.kind != TokenKind::Name || called || field {
                    continue;
                }
                add(t.text.clone());
                let stem = t.text.trim_end_matches(|c: char| c.is_ascii_digit());
                if t.text.len() == stem.len() + 1 && matches!(stem, "c" | "s" | "q") {
                    (1..=self.chain.dof().min(9)).for_each(|n| add(format!("{stem}{n}")));
                }
            }
        }
        for p in self.chain.parameters.iter().filter(|p| p.declared && matches!(p.handle, Handle::Length(_))) {
            add(p.name.clone());
        }
        words
    }

    /// All single changes of a formula with angles and roots.
    pub(super) fn angle_changes(&self, place: &Place, words: &[String]) -> Vec<Candidate> {
        let mut out = self.changes(place, words);
        let tokens = self.tokens;
        let mut put = |rank: u8, range: Place, new: Vec<Token>| {
            out.push(Candidate { rank, edit: Edit { place: range, tokens: new } });
        };
        let is = |k: usize, mark: &str| tokens.get(k).is_some_and(|t| t.is(mark));
        let sum = |marks: &[&str]| marks.iter().map(|t| Token::new(t)).collect::<Vec<_>>();
        for k in place.clone() {
            let called = tokens.get(k).is_some_and(|t| t.text == "atan2") && is(k + 1, "(");
            if called && let Some((comma, close)) = arguments(tokens, k + 1, place.end) {
                let part = |range: Place| tokens.get(range).unwrap_or_default().to_vec();
                let swapped = [part(comma + 1..close), sum(&[","]), part(k + 2..comma)].concat();
                put(SWAPPED, k + 2..close, swapped);
            }
            // a term is lost at the end of a sum
            let ends = is(k, ")") || is(k, ",");
            if ends && k > place.start {
                for w in words {
                    for sign in ["-", "+"] {
                        put(MISSING, k..k, sum(&[sign, w]));
                        put(MISSING, k..k, sum(&[sign, w, "^", "2"]));
                    }
                }
            }
        }
        put(MISSING, place.end..place.end, sum(&["+", "180deg"]));
        out
    }
}

/// The comma and the closing bracket of a call with two arguments, from its opening bracket.
fn arguments(tokens: &[Token], open: usize, end: usize) -> Option<(usize, usize)> {
    let mut depth = 0;
    let mut comma = None;
    for k in open..end {
        let t = tokens.get(k)?;
        if t.is("(") || t.is("[") {
            depth += 1;
        } else if t.is(")") || t.is("]") {
            depth -= 1;
            if depth == 0 {
                return Some((comma?, k));
            }
        } else if t.is(",") && depth == 1 {
            comma = Some(k);
        }
    }
    None
}
