//! Blames definitions: where lines are wrong because of a `let` before them, finds the change of that definition with which they hold.

use super::direct::{Meaning, Spot};
use super::line::Sides;
use super::repair::{EFFORT, LONGEST, TOTAL_EFFORT, repaired};
use super::{Evaluator, Fault, FaultKind, Repair, Verdict};
use crate::verify::language::{Derivation, Expr, ExprKind, Line, Relation, Statement};
use std::rc::Rc;

/// Most candidates for a definition that are proven.
const PROOFS: usize = 8;
/// Most wrong lines that one definition is tried on.
const USERS: usize = 6;

impl<'a> Evaluator<'a> {
    /// Puts the verdict `wrong` to definitions whose repair makes later lines hold, and says of those that they follow.
    pub(super) fn blame_definitions(&mut self, d: &'a Derivation, verdicts: &mut [Verdict]) {
        for (at, line) in d.lines.iter().enumerate() {
            let Statement::Define(name, e) = &line.statement else { continue };
            if e.place.len() > LONGEST
                || self.searched > TOTAL_EFFORT
                || !matches!(verdicts.get(at), Some(Verdict::Noted))
            {
                continue;
            }
            let users = self.wrong_users(d, verdicts, at, name);
            if users.is_empty() {
                continue;
            }
            let lines: Vec<&'a Line> = users.iter().take(USERS).filter_map(|k| d.lines.get(*k)).collect();
            let Some(repair) = self.repair_of_definition(d, at, &lines) else { continue };
            if let Some(v) = verdicts.get_mut(at) {
                let first = users.first().copied().unwrap_or(at);
                let kind = FaultKind::Definition(first);
                *v = Verdict::Wrong(vec![Fault { place: e.place.clone(), entry: None, kind, repair: Some(repair) }]);
            }
            for k in users {
                if let (Some(v), Some(l)) = (verdicts.get_mut(k), d.lines.get(k)) {
                    let kind = FaultKind::Follows(at);
                    *v = Verdict::Wrong(vec![Fault { place: l.place.clone(), entry: None, kind, repair: None }]);
                }
            }
        }
    }

    /// Equations after a definition that are wrong, have no change of their own, and speak of the name.
    fn wrong_users(&self, d: &Derivation, verdicts: &[Verdict], at: usize, name: &str) -> Vec<usize> {
        let mut names = vec![name.to_string()];
        let mut out = Vec::new();
        for (k, line) in d.lines.iter().enumerate().skip(at + 1) {
            match &line.statement {
                Statement::Define(other, e) if names.iter().any(|n| mentions(e, n)) => names.push(other.clone()),
                Statement::Claim { first, rest, .. } => {
                    let used = |n: &String| mentions(first, n) || rest.iter().any(|r| mentions(&r.1, n));
                    let equations = rest.iter().all(|r| r.0 == Relation::Equal);
                    let plain = |f: &Fault| f.repair.is_none() && !matches!(f.kind, FaultKind::Follows(_));
                    let wrong = matches!(verdicts.get(k), Some(Verdict::Wrong(f)) if f.iter().all(plain));
                    if wrong && equations && names.iter().any(used) {
                        out.push(k);
                    }
                }
                _ => {}
            }
        }
        out
    }

    /// A change of the definition in line `at` with which all of these lines hold.
    fn repair_of_definition(&mut self, d: &'a Derivation, at: usize, users: &[&'a Line]) -> Option<Repair> {
        let Statement::Define(name, e) = &d.lines.get(at)?.statement else { return None };
        let first = users.first()?;
        let Statement::Claim { first: left, rest, .. } = &first.statement else { return None };
        let index = self.meanings.iter().rposition(|m| m.0 == *name)?;
        let before = self.meanings.get(index)?.1.clone();
        // a definition speaks of nothing that is defined later
        let later = self.meanings.get(index..).unwrap_or_default();
        let mut words = self.words_of(&[&e.place, &first.place]);
        words.retain(|w| later.iter().all(|m| m.0 != *w));
        let mut all = self.angle_changes(&e.place, &words);
        all.sort_by_key(|c| c.rank);
        all.truncate(EFFORT / 4 / (e.place.len() + first.place.len()).max(1));
        self.searched += all.len() * (e.place.len() + first.place.len());
        let mut spots = self.poses();
        let mut found = None;
        let mut proofs = 0;
        for c in all {
            let repair = Repair { edits: vec![c.edit] };
            let Ok(new) = Expr::parse(&repaired(self.tokens, &e.place, &repair)) else { continue };
            let new = Rc::new(new);
            self.set_meaning(index, Meaning::Tried(new.clone()));
            if !self.chain_holds(left, rest, &mut spots) {
                continue;
            }
            proofs += 1;
            if self.all_proven(d, at, &new, users) {
                found = Some(repair);
                break;
            }
            if proofs >= PROOFS {
                break;
            }
        }
        self.set_meaning(index, before);
        self.spots.clear();
        found
    }

    fn set_meaning(&mut self, index: usize, meaning: Meaning<'a>) {
        if let Some(m) = self.meanings.get_mut(index) {
            m.1 = meaning;
        }
    }

    /// Do all equations of a line hold at some of the poses?
    fn chain_holds(&self, first: &Expr, rest: &[(Relation, Expr)], spots: &mut [Spot]) -> bool {
        let (mut agree, mut differ) = (0, 0);
        for spot in spots {
            spot.forget_names();
            let mut left = spot.evaluate(first, self);
            let mut same = true;
            for (_, right) in rest {
                let v = spot.evaluate(right, self);
                same &= match (&left, &v) {
                    (Some(a), Some(b)) => a.is_near(b, 1e-9),
                    _ => false,
                };
                left = v;
            }
            if same {
                agree += 1;
            } else {
                differ += 1;
            }
            if agree == 0 && differ >= 6 {
                return false;
            }
        }
        agree > 1
    }

    /// Are these lines proven with another definition in line `at`? Everything defined after it is formed anew.
    fn all_proven(&mut self, d: &'a Derivation, at: usize, new: &Expr, users: &[&'a Line]) -> bool {
        let before = self.locals.clone();
        let searched = std::mem::replace(&mut self.searched, usize::MAX);
        self.spots.clear();
        let mut fine = true;
        for (k, line) in d.lines.iter().enumerate().skip(at) {
            let Statement::Define(name, e) = &line.statement else { continue };
            self.work.renew();
            let v = if k == at { self.evaluate(new) } else { self.evaluate(e) };
            match (v, self.locals.iter_mut().rev().find(|l| l.0 == *name)) {
                (Ok(v), Some(local)) => local.1 = v,
                _ => fine &= k != at,
            }
        }
        fine = fine
            && users.iter().all(|line| {
                let Statement::Claim { first, rest, .. } = &line.statement else { return false };
                let mut left = first;
                rest.iter().all(|(relation, right)| {
                    self.work.renew();
                    let verdict = self.relation(&Sides::new(left, right), *relation, None);
                    left = right;
                    matches!(verdict, Ok(Verdict::Proven(_)))
                })
            });
        self.locals = before;
        self.searched = searched;
        fine
    }
}

/// Does a formula speak of a name?
fn mentions(e: &Expr, name: &str) -> bool {
    match &e.kind {
        ExprKind::Number(_) => false,
        ExprKind::Name(n) => n == name,
        ExprKind::Call(_, arguments) => arguments.iter().any(|a| mentions(&a.1, name)),
        ExprKind::Sum(parts) | ExprKind::Product(parts) => parts.iter().any(|p| mentions(&p.1, name)),
        ExprKind::Negative(inner) | ExprKind::Power(inner, _) | ExprKind::Field(inner, _) => mentions(inner, name),
        ExprKind::Matrix(_, entries) => entries.iter().any(|x| mentions(x, name)),
    }
}
