//! Cross-checks verdicts numerically: no line is called proven that fails at some pose of the arm, and no line is called wrong that holds at some pose.
//!
//! Both sides are evaluated directly ([`direct`](super::direct)) at many poses; conditions of a proof must be met by one of them.

use super::direct::{Direct, Spot};
use super::line::Sides;
use super::point::Numbers;
use super::refusal::{Understood, refuse};
use super::{Condition, Evaluator, Example, Fault, FaultKind, Verdict, Where};
use crate::chain::Coordinate;
use crate::verify::language::{Expr, Place};

/// Poses at which a line without conditions is tried.
const PLAIN: usize = 12;
/// Poses at which a wrong line is tried before it is called so.
const WRONG: usize = 30;
/// Most poses that are looked at for one where the conditions hold.
const MOST: usize = 900;
/// Poses in the set of the conditions that are enough.
const ENOUGH: usize = 24;
/// Words of a line times poses: what a long line may cost.
const EFFORT: usize = 400_000;
/// Two values are the same if they differ by no more than this part of their size.
const SAME: f64 = 1e-7;
/// Terms of a short formula.
const SHORT: usize = 2;
/// A condition decides where it is larger than this part of its largest term.
const CLEAR: f64 = 1e-7;

/// How two sides compare at poses.
#[derive(Default)]
struct Survey {
    /// Poses of the table's own arm within the set of the conditions, and whether the sides agree there.
    met: usize,
    /// The first of them.
    example: Option<Numbers>,
    /// A pose in the set where the sides differ.
    broken: bool,
    /// Poses where the sides agree or differ: of the table's own arm, and of others of its kind.
    agree: usize,
    differ: usize,
    others_agree: usize,
    others_differ: usize,
    /// A pose of the table's own arm where they differ.
    against: Option<(Numbers, Direct, Direct)>,
}

impl<'a> Evaluator<'a> {
    /// The verdict after both sides were held against each other in numbers. `angles`: are they compared modulo a turn?
    pub(super) fn settled(&mut self, sides: &Sides<'_>, angles: bool, verdict: Verdict) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        match verdict {
            Verdict::Proven(w) => {
                let limit = if w.conditions.is_empty() { PLAIN } else { MOST };
                let s = self.survey(sides, angles, &w.conditions, limit);
                let seen = s.agree + s.differ + s.others_agree + s.others_differ;
                if s.broken && s.agree > 0 {
                    return refuse(&place, "this holds at some joint values and not at others, and where is not found");
                }
                if s.broken {
                    return Ok(self.nowhere(sides, s));
                }
                if w.conditions.is_empty() {
                    return Ok(Verdict::Proven(w));
                }
                if s.met > 0 {
                    let example = s.example.map(|n| self.example(&n).of(self, &w.conditions));
                    let configuration = self.configuration_of(&w.conditions);
                    return Ok(Verdict::Proven(Where { example, configuration, ..w }));
                }
                if s.agree > 0 || seen == 0 {
                    return refuse(&place, "no joint values were found at which the conditions of this line hold");
                }
                Ok(self.nowhere(sides, s))
            }
            Verdict::Wrong(faults) => {
                let s = self.survey(sides, angles, &[], WRONG);
                let everywhere = s.agree > 2 && s.differ == 0;
                if everywhere && s.others_differ == 0 {
                    return refuse(&place, "both sides agree in numbers, but the normal form cannot prove it");
                }
                if everywhere {
                    return Ok(Verdict::Agrees);
                }
                if s.agree > 1 {
                    return refuse(&place, "this holds at some joint values and not at others, and where is not found");
                }
                Ok(Verdict::Wrong(self.shorter(sides, faults, s)))
            }
            other => Ok(other),
        }
    }

    /// Conditions of several parts of one line: a pose must meet all of them.
    pub(super) fn together(&mut self, w: Where, place: &Place) -> Understood<Verdict> {
        for k in 0..MOST {
            let (spot, own) = self.spot(k);
            let met = own && self.is_met(&spot.numbers, &w.conditions);
            let example = met.then(|| self.example(&spot.numbers).of(self, &w.conditions));
            self.put_back(k, spot, own);
            if example.is_some() {
                return Ok(Verdict::Proven(Where { example, ..w }));
            }
        }
        refuse(place, "the parts of this line hold at different joint values, and no values were found for all of them")
    }

    /// A line that holds nowhere, with a pose that shows it.
    fn nowhere(&self, sides: &Sides<'_>, s: Survey) -> Verdict {
        let Some((at, a, b)) = s.against else { return Verdict::Wrong(vec![]) };
        let (printed, correct) = if sides.printed_left { (a, b) } else { (b, a) };
        let kind = FaultKind::Nowhere(Box::new(self.example(&at)), Pair::of(&printed, &correct));
        Verdict::Wrong(vec![Fault { place: sides.printed().place.clone(), entry: None, kind, repair: None }])
    }

    /// Of angles that differ by a long formula, the numbers at a pose say more.
    fn shorter(&self, sides: &Sides<'_>, mut faults: Vec<Fault>, s: Survey) -> Vec<Fault> {
        if let ([Fault { kind, .. }], Some((at, a, b))) = (faults.as_mut_slice(), s.against)
            && matches!(kind, FaultKind::Angle(x) if x.num.terms().len() > SHORT)
        {
            let (printed, correct) = if sides.printed_left { (a, b) } else { (b, a) };
            *kind = FaultKind::AngleAt(Box::new(self.example(&at)), Pair::of(&printed, &correct));
        }
        faults
    }

    /// The joint values of a pose.
    pub(super) fn example(&self, at: &Numbers) -> Example {
        let actuators = at.actuators(self.chain).unwrap_or_default();
        let turns = |k: usize| matches!(self.joints.get(k), Some(super::value::Value::Angle(_)));
        let named = self.chain.joints.iter().zip(actuators).enumerate();
        Example { joints: named.map(|(k, (j, q))| (j.name.clone(), q, turns(k))).collect() }
    }

    fn survey(&mut self, sides: &Sides<'_>, angles: bool, conditions: &[Condition], limit: usize) -> Survey {
        let mut s = Survey::default();
        let words = sides.left.place.len() + sides.right.place.len();
        let limit = if limit == WRONG { WRONG } else { limit.min((EFFORT / words.max(1)).max(PLAIN / 2)) };
        for k in 0..limit {
            // where a proof is tried, one pose against it decides
            if s.met >= ENOUGH && s.differ + s.agree >= WRONG || limit != WRONG && s.broken && s.agree > 0 {
                break;
            }
            let (mut spot, own) = self.spot(k);
            let values = (spot.evaluate(sides.left, self), spot.evaluate(sides.right, self));
            let numbers = spot.numbers.clone();
            self.put_back(k, spot, own);
            let (Some(a), Some(b)) = values else { continue };
            let (a, b) = if angles { (as_angle(a), as_angle(b)) } else { (a, b) };
            if !(a.is_finite() && b.is_finite()) {
                continue;
            }
            let same = a.is_near(&b, SAME);
            if !same && self.is_delicate(&numbers, [sides.left, sides.right], [&a, &b]) {
                continue;
            }
            match (own, same) {
                (true, true) => s.agree += 1,
                (true, false) => s.differ += 1,
                (false, true) => s.others_agree += 1,
                (false, false) => s.others_differ += 1,
            }
            if own && !same && s.against.is_none() {
                s.against = Some((numbers.clone(), a, b));
            }
            if self.is_met(&numbers, conditions) {
                s.broken |= !same;
                if own {
                    s.met += 1;
                    s.example.get_or_insert(numbers);
                }
            }
        }
        s
    }

    /// Does a pose lie within the set of the conditions, and not on its edge?
    pub(super) fn is_met(&self, at: &Numbers, conditions: &[Condition]) -> bool {
        let mut n = at.clone();
        self.complete(&mut n);
        conditions.iter().all(|c| n.relative(&c.formula.clone().into()) > CLEAR)
    }

    /// Does a tiny motion of the arm change a side by more than the sides differ? Then the pose says nothing.
    pub(super) fn is_delicate(&self, at: &Numbers, sides: [&Expr; 2], values: [&Direct; 2]) -> bool {
        let Some(mut actuators) = at.actuators(self.chain) else { return false };
        actuators.iter_mut().enumerate().for_each(|(k, q)| *q += 1e-9 * (1.0 + k as f64 / 3.0));
        let mut n = at.clone();
        n.set_motors(self.chain, &actuators);
        let mut there = Spot::new(n);
        sides.into_iter().zip(values).any(|(e, v)| there.evaluate(e, self).is_none_or(|w| !w.is_near(v, 1e-5)))
    }

    pub(super) fn spot(&mut self, k: usize) -> (Spot, bool) {
        while self.spots.len() <= k {
            self.spots.push(None);
        }
        match self.spots.get_mut(k).and_then(Option::take) {
            Some(known) => known,
            None => {
                let (numbers, own) = self.sample(k);
                (Spot::new(numbers), own)
            }
        }
    }

    pub(super) fn put_back(&mut self, k: usize, spot: Spot, own: bool) {
        if let Some(place) = self.spots.get_mut(k) {
            *place = Some((spot, own));
        }
    }
}

fn as_angle(v: Direct) -> Direct {
    match v {
        Direct::Scalar(x) => Direct::Angle(x),
        v => v,
    }
}

impl Example {
    /// Only the joints on which the conditions depend.
    fn of(mut self, on: &Evaluator<'_>, conditions: &[Condition]) -> Example {
        let hidden = conditions.iter().any(|c| on.roots.iter().any(|r| c.formula.has_symbol(r.symbol)));
        if hidden || !on.chain.is_direct() {
            return self;
        }
        let used = |c: Coordinate| match c {
            Coordinate::Angle(v) => conditions.iter().any(|x| x.formula.has_angle(v)),
            Coordinate::Length(s) => conditions.iter().any(|x| x.formula.has_symbol(s)),
        };
        self.joints.retain(|(name, ..)| on.chain.joints.iter().any(|j| j.name == *name && used(j.coordinate)));
        self
    }
}

/// Two values in numbers, printed and correct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pair {
    /// Numbers or lengths.
    Numbers(f64, f64),
    /// Angles in radians.
    Angles(f64, f64),
    /// Matrices are not shown.
    Matrices,
}

impl Pair {
    fn of(printed: &Direct, correct: &Direct) -> Pair {
        match (printed, correct) {
            (Direct::Scalar(x), Direct::Scalar(y)) => Pair::Numbers(*x, *y),
            (Direct::Scalar(x) | Direct::Angle(x), Direct::Scalar(y) | Direct::Angle(y)) => {
                Pair::Angles(super::point::wrapped(*x), super::point::wrapped(*y))
            }
            _ => Pair::Matrices,
        }
    }
}
