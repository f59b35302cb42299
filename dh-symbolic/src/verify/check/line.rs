//! Checks one line of a derivation and returns its verdict.

use super::compare::{Outcome, Pair};
use super::direct::Meaning;
use super::ratio::Trouble;
use super::refusal::{Understood, refuse};
use super::value::{Matrix, Turn, Value};
use super::{Condition, Evaluator, Fault, FaultKind, Verdict, Where};
use crate::chain::Quantity;
use crate::verify::language::{Expr, ExprKind, Line, NotUnderstood, Relation, Statement};

/// One line's two formulas, and which of them is the printed one.
pub(super) struct Sides<'a> {
    pub(super) left: &'a Expr,
    pub(super) right: &'a Expr,
    pub(super) printed_left: bool,
}

impl<'a> Sides<'a> {
    pub(super) fn new(left: &'a Expr, right: &'a Expr) -> Sides<'a> {
        Sides { left, right, printed_left: refers(right) && !refers(left) }
    }

    pub(super) fn printed(&self) -> &'a Expr {
        if self.printed_left { self.left } else { self.right }
    }

    pub(super) fn other(&self) -> &'a Expr {
        if self.printed_left { self.right } else { self.left }
    }
}

/// Does a formula ask the table?
fn refers(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) | ExprKind::Name(_) => false,
        ExprKind::Call(name, arguments) => {
            matches!(name.as_str(), "T" | "A" | "J") || arguments.iter().any(|a| refers(&a.1))
        }
        ExprKind::Sum(parts) | ExprKind::Product(parts) => parts.iter().any(|p| refers(&p.1)),
        ExprKind::Negative(inner) | ExprKind::Power(inner, _) | ExprKind::Field(inner, _) => refers(inner),
        ExprKind::Matrix(_, entries) => entries.iter().any(refers),
    }
}

impl<'a> Evaluator<'a> {
    /// The verdict on a line.
    pub(super) fn line(&mut self, line: &'a Line) -> Verdict {
        self.work.renew();
        match self.understand(line) {
            Ok(v) => v,
            Err(n) => {
                self.work.renew();
                let repair = match &line.statement {
                    // what is too large to understand is too large to repair
                    Statement::Claim { first, rest, .. } if n.why != Trouble::TooLarge.why() => {
                        self.repair_meaning(first, rest, &n)
                    }
                    _ => None,
                };
                Verdict::NotUnderstood(n, repair)
            }
        }
    }

    fn understand(&mut self, line: &'a Line) -> Understood<Verdict> {
        match &line.statement {
            Statement::Unreadable(n) => Err(n.clone()),
            Statement::Define(name, e) => {
                self.choose_rows(e, &[]);
                self.free(name, line)?;
                let v = self.evaluate(e)?;
                self.locals.push((name.clone(), v));
                self.meanings.push((name.clone(), Meaning::Formula(e)));
                Ok(Verdict::Noted)
            }
            Statement::Free(name, quantity) => {
                self.free(name, line)?;
                let v = match quantity {
                    Quantity::Length => Value::Scalar(crate::algebra::Poly::symbol(self.ring.symbol(name)).into()),
                    Quantity::Angle => Value::Angle(Turn::var(self.ring.angle(name))),
                };
                self.locals.push((name.clone(), v.clone()));
                self.meanings.push((name.clone(), Meaning::Free(v)));
                // poses know nothing of the new quantity
                self.spots.clear();
                Ok(Verdict::Noted)
            }
            Statement::At(settings) => {
                let mut given = Vec::new();
                for s in settings {
                    given.push(self.setting(s)?);
                }
                self.given = given;
                Ok(Verdict::Noted)
            }
            Statement::Kind(e, quantity) => {
                let angle = matches!(self.evaluate(e)?, Value::Angle(_));
                if angle == (*quantity == Quantity::Angle) {
                    return Ok(Verdict::Proven(Where::everywhere()));
                }
                Ok(Verdict::Wrong(vec![Fault {
                    place: e.place.clone(),
                    entry: None,
                    kind: FaultKind::Kind(angle),
                    repair: None,
                }]))
            }
            Statement::Remark(_) => Ok(Verdict::Noted),
            Statement::Either(branches) => self.either(branches, &line.place),
            Statement::Claim { first, rest, within } => {
                self.choose_rows(first, rest);
                let mut verdict = Verdict::Proven(Where::everywhere());
                let mut left = first;
                let mut parts = 0;
                for (relation, right) in rest {
                    let next = self.relation(&Sides::new(left, right), *relation, within.as_ref())?;
                    parts += usize::from(matches!(&next, Verdict::Proven(w) if !w.is_everywhere()));
                    verdict = joined(verdict, next);
                    left = right;
                }
                match verdict {
                    // each part has poses at which it holds: the whole line needs one
                    Verdict::Proven(w) if parts > 1 => self.together(w, &line.place),
                    verdict => Ok(verdict),
                }
            }
        }
    }

    /// A name may be given once, and must not hide another meaning.
    fn free(&mut self, name: &str, line: &Line) -> Understood<()> {
        if self.is_taken(name) {
            let at = line.place.start + 1;
            return refuse(&(at..at + 1), format!("`{name}` already has a meaning here"));
        }
        Ok(())
    }

    pub(super) fn relation(
        &mut self,
        sides: &Sides<'_>,
        relation: Relation,
        within: Option<&Expr>,
    ) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        let (a, b) = (self.evaluate(sides.left)?, self.evaluate(sides.right)?);
        if within.is_some() && relation != Relation::Near {
            return refuse(&place, "`within` goes with `~`: `left ~ right within tolerance;`");
        }
        match relation {
            Relation::Equal => self.equal(sides, a, b),
            Relation::NotEqual => Ok(match self.equal(sides, a, b)? {
                Verdict::Proven(w) if w.is_everywhere() => {
                    Verdict::Wrong(vec![Fault { place, entry: None, kind: FaultKind::Same, repair: None }])
                }
                _ => Verdict::Proven(Where::everywhere()),
            }),
            Relation::Near => self.near(sides, a, b, within),
            order => self.order(sides, a, b, order),
        }
    }

    fn equal(&mut self, sides: &Sides<'_>, a: Value, b: Value) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        let (printed, correct) = if sides.printed_left { (a, b) } else { (b, a) };
        match self.pair(printed, correct, &place)? {
            Pair::Scalars(x, y) => {
                let outcome = self.compare_scalars(&x, &y, &place)?;
                let verdict = verdict(outcome, sides.printed().place.clone(), None, &place)?;
                let mut verdict = self.settled(sides, false, verdict)?;
                self.add_repair(&mut verdict, sides, &Value::Scalar(y));
                Ok(verdict)
            }
            Pair::Turns(t, u) => {
                let outcome = self.compare_turns(&t, &u, &place)?;
                let verdict = verdict(outcome, sides.printed().place.clone(), None, &place)?;
                let mut verdict = self.settled(sides, true, verdict)?;
                self.add_repair(&mut verdict, sides, &Value::Angle(u));
                Ok(verdict)
            }
            Pair::Matrices(m, n) => self.equal_matrices(sides, &m, &n),
        }
    }

    fn equal_matrices(&mut self, sides: &Sides<'_>, m: &Matrix, n: &Matrix) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        let written = match &sides.printed().kind {
            ExprKind::Matrix(columns, entries) if *columns == m.columns && entries.len() == m.entries.len() => {
                Some(entries)
            }
            _ => None,
        };
        let mut all = Verdict::Proven(Where::everywhere());
        for (k, (x, y)) in m.entries.iter().zip(&n.entries).enumerate() {
            let outcome = self.compare_scalars(x, y, &place)?;
            let at = written.and_then(|w| w.get(k)).map_or_else(|| sides.printed().place.clone(), |e| e.place.clone());
            let mut one = verdict(outcome, at.clone(), Some((k / m.columns + 1, k % m.columns + 1)), &place)?;
            if written.is_some()
                && let Verdict::Wrong(faults) = &mut one
            {
                let repair = self.repair(&at, &Value::Scalar(y.clone()));
                for f in faults {
                    f.repair = repair.clone();
                }
            }
            all = joined(all, one);
        }
        all = self.settled(sides, false, all)?;
        if written.is_none() {
            self.add_repair(&mut all, sides, &Value::Matrix(n.clone()));
        }
        Ok(all)
    }

    /// Looks for a repair of the printed side, then of the other one, where that is plain text as well.
    fn add_repair(&mut self, verdict: &mut Verdict, sides: &Sides<'_>, correct: &Value) {
        let Verdict::Wrong(faults) = verdict else { return };
        // where roots have signs and angles have branches, a line is tried at poses as a whole
        let by_poses =
            matches!(correct, Value::Angle(_)) || faults.iter().any(|f| matches!(f.kind, FaultKind::Nowhere(..)));
        if by_poses && let Some(m) = self.repair_at_poses(sides) {
            if let Some(f) = faults.first_mut() {
                f.repair = Some(m);
            }
            return;
        }
        let mut repair = self.ranked_repair(&sides.printed().place, correct);
        if repair.as_ref().is_none_or(|m| m.0 > 3)
            && let Ok(printed) = self.evaluate(sides.printed())
            && let Some(other) = self.ranked_repair(&sides.other().place, &printed)
            && repair.as_ref().is_none_or(|m| m.0 > other.0)
        {
            repair = Some(other);
        }
        let repair = repair.map(|m| m.1);
        if let Some(f) = faults.first_mut() {
            f.repair = repair;
        }
    }
}

fn verdict(
    outcome: Outcome,
    place: std::ops::Range<usize>,
    entry: Option<(usize, usize)>,
    whole: &std::ops::Range<usize>,
) -> Understood<Verdict> {
    let wrong = |kind| Verdict::Wrong(vec![Fault { place: place.clone(), entry, kind, repair: None }]);
    Ok(match outcome {
        Outcome::Same(conditions) => Verdict::Proven(Where::under(conditions)),
        Outcome::Differs(parts) => {
            let [printed, correct, difference] = *parts;
            wrong(FaultKind::Formula { printed, correct, difference })
        }
        Outcome::Turned(difference) => wrong(FaultKind::Angle(difference)),
        Outcome::Opposite => wrong(FaultKind::Opposite),
        Outcome::Open(why) => return Err(NotUnderstood { place: whole.clone(), why }),
    })
}

/// Both hold: all conditions; otherwise all faults.
pub(super) fn joined(a: Verdict, b: Verdict) -> Verdict {
    match (a, b) {
        (Verdict::Wrong(mut f), Verdict::Wrong(g)) => {
            f.extend(g);
            Verdict::Wrong(f)
        }
        (Verdict::Wrong(f), _) | (_, Verdict::Wrong(f)) => Verdict::Wrong(f),
        (Verdict::Agrees, _) | (_, Verdict::Agrees) => Verdict::Agrees,
        (Verdict::Proven(mut c), Verdict::Proven(d)) => {
            let new: Vec<Condition> = d.conditions.into_iter().filter(|x| !c.conditions.contains(x)).collect();
            c.conditions.extend(new);
            // one pose for each part of the line
            c.example = c.example.or(d.example);
            Verdict::Proven(c)
        }
        (a, _) => a,
    }
}
