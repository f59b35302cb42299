//! Lines with several possibilities, `A ± B` and `A if ... or B`: at every pose one of them must hold.
//!
//! Each possibility is proven where the algebra finds it to hold; that together they hold everywhere is seen at the poses.

use super::direct::Direct;
use super::line::Sides;
use super::point::Numbers;
use super::refusal::{Understood, refuse};
use super::value::Value;
use super::{Evaluator, Fault, FaultKind, Verdict, Where};
use crate::chain::{Handle, Role};
use crate::verify::language::{Branch, Expr, Place, Relation};

/// Poses that are looked at.
const POSES: usize = 120;
/// Two values are the same if they differ by no more than this part of their size.
const SAME: f64 = 1e-7;

impl<'a> Evaluator<'a> {
    pub(super) fn either(&mut self, branches: &[Branch], place: &Place) -> Understood<Verdict> {
        let mut proven = 0;
        let mut alone = None;
        let mut trouble = None;
        for b in branches {
            let mut left = &b.first;
            let mut holds = true;
            for (relation, right) in &b.rest {
                match self.relation(&Sides::new(left, right), *relation, None) {
                    Ok(Verdict::Proven(w)) if w.is_everywhere() && b.guard.is_none() => alone = Some(w),
                    Ok(Verdict::Proven(_)) => {}
                    Ok(v) => {
                        holds = false;
                        trouble.get_or_insert(Ok(v));
                    }
                    Err(n) => {
                        holds = false;
                        trouble.get_or_insert(Err(n));
                    }
                }
                left = right;
            }
            proven += usize::from(holds);
        }
        let (mut met, mut held) = (0, vec![0; branches.len()]);
        let mut failed = None;
        let guarded_line = branches.iter().any(|b| b.guard.is_some());
        for k in 0..POSES {
            let (mut spot, own) = self.spot(k);
            let holds: Vec<Option<bool>> = branches.iter().map(|b| self.branch_holds(b, &mut spot)).collect();
            let numbers = spot.numbers.clone();
            self.put_back(k, spot, own);
            // which possibility holds where is said of the arm as it is: links have lengths
            if guarded_line && (!own || self.has_negative_length(&numbers)) {
                continue;
            }
            // not understood, or not defined, at this pose
            if holds.iter().all(Option::is_none) {
                continue;
            }
            met += 1;
            let guarded = |k: usize| branches.get(k).is_some_and(|b| b.guard.is_some());
            let broken = holds.iter().enumerate().any(|(k, h)| guarded(k) && *h == Some(false));
            if broken || !holds.contains(&Some(true)) {
                failed.get_or_insert(numbers);
            } else {
                for (count, h) in held.iter_mut().zip(&holds) {
                    *count += usize::from(*h == Some(true));
                }
            }
        }
        if met == 0 {
            return match trouble {
                Some(Err(n)) => Err(n),
                _ => refuse(place, "no joint values were found at which this line says something"),
            };
        }
        if let Some(at) = failed {
            if held.iter().all(|h| *h == 0)
                && branches.iter().all(|b| b.guard.is_none())
                && let Some(Ok(Verdict::Wrong(faults))) = trouble
            {
                return Ok(Verdict::Wrong(faults));
            }
            let kind = FaultKind::None(Box::new(self.example(&at)));
            return Ok(Verdict::Wrong(vec![Fault { place: place.clone(), entry: None, kind, repair: None }]));
        }
        if alone.is_some() || proven == branches.len() || self.both_by_product(branches)? {
            // a possibility that never holds is a slip, even if the other one always does
            if let Some(k) = held.iter().position(|h| *h == 0).filter(|_| proven < branches.len()) {
                let place = branches.get(k).map_or(place.clone(), |b| b.place.clone());
                return refuse(&place, "one of these possibilities holds at no joint values that were tried");
            }
            return Ok(Verdict::Proven(Where::everywhere()));
        }
        refuse(
            place,
            "one of the possibilities holds at every pose that was tried, but the normal form cannot prove it",
        )
    }

    fn has_negative_length(&self, at: &Numbers) -> bool {
        self.chain.parameters.iter().any(|p| match p.handle {
            Handle::Length(s) => matches!(p.role, Role::Field(None)) && at.symbol(s) < 0.0,
            Handle::Angle(_) => false,
        })
    }

    /// Does a possibility hold at a pose? `None` where it has no value, or where its condition is not met.
    fn branch_holds(&mut self, b: &Branch, spot: &mut super::direct::Spot) -> Option<bool> {
        if let Some((left, relation, right)) = &b.guard {
            let number = |v: Direct| match v {
                Direct::Scalar(x) => Some(x),
                Direct::Angle(x) => Some(super::point::wrapped(x)),
                Direct::Matrix(_) => None,
            };
            let (x, y) = (number(spot.evaluate(left, self)?)?, number(spot.evaluate(right, self)?)?);
            let met = match relation {
                Relation::Less | Relation::LessOrEqual => x < y,
                Relation::Greater | Relation::GreaterOrEqual => x > y,
                Relation::NotEqual => x != y,
                Relation::Equal | Relation::Near => (x - y).abs() < 1e-12,
            };
            if !met {
                return None;
            }
        }
        let mut left = &b.first;
        let mut all = true;
        for (_, right) in &b.rest {
            let (x, y) = (spot.evaluate(left, self)?, spot.evaluate(right, self)?);
            if !(x.is_finite() && y.is_finite()) {
                return None;
            }
            all &= x.is_near(&y, SAME) || self.is_delicate(&spot.numbers, [left, right], [&x, &y]);
            left = right;
        }
        Some(all)
    }

    /// Two possibilities: is the product of what is zero in each of them zero everywhere?
    fn both_by_product(&mut self, branches: &[Branch]) -> Understood<bool> {
        let [a, b] = branches else { return Ok(false) };
        if a.guard.is_some() || b.guard.is_some() {
            return Ok(false);
        }
        let mut factors = Vec::new();
        for branch in [a, b] {
            let [(_, right)] = branch.rest.as_slice() else { return Ok(false) };
            let Some(x) = self.vanishing(&branch.first, right)? else { return Ok(false) };
            factors.push(x);
        }
        let [x, y] = factors.as_slice() else { return Ok(false) };
        let Ok(product) = x.times(y, &mut self.work) else { return Ok(false) };
        let Ok(product) = self.reduce(&product) else { return Ok(false) };
        let Ok(product) = self.with_numbers(&product) else { return Ok(false) };
        Ok(self.reduce(&product).is_ok_and(|p| p.is_zero()))
    }

    /// A formula that is zero exactly where two sides are equal.
    fn vanishing(&mut self, left: &Expr, right: &Expr) -> Understood<Option<super::ratio::Ratio>> {
        let (a, b) = (self.evaluate(left)?, self.evaluate(right)?);
        Ok(match (a, b) {
            (Value::Scalar(x), Value::Scalar(y)) => x.minus(&y, &mut self.work).ok(),
            (Value::Angle(t), Value::Angle(u)) => {
                let difference = t.plus(&u.negated());
                let one = super::ratio::Ratio::int(1);
                match self.cos_sin(&difference) {
                    Ok(Some((c, _))) => one.minus(&c, &mut self.work).ok(),
                    _ => None,
                }
            }
            _ => None,
        })
    }
}
