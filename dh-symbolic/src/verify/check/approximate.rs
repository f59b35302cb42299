//! Checks numeric lines (`~`, `<` and the like) at the values of the last `at` line.

use super::compare::{Outcome, Pair};
use super::line::{Sides, joined};
use super::point::{Rounding, rounding, wrapped};
use super::ratio::Ratio;
use super::refusal::{Understood, refuse};
use super::value::Value;
use super::{Evaluator, Fault, FaultKind, Verdict, Where};
use crate::verify::language::{Expr, ExprKind, Relation};

/// Why a number cannot be compared.
pub(in super::super) const NO_VALUE: &str = "has no value here";

/// What two numbers may be apart beyond all rounding: floating point alone.
const FLOAT: f64 = 1e-9;

impl Evaluator<'_> {
    pub(super) fn near(&mut self, sides: &Sides<'_>, a: Value, b: Value, within: Option<&Expr>) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        let numbers = self.numbers(&self.given);
        for (v, e) in [(&a, sides.left), (&b, sides.right)] {
            if let Some(name) = self.missing(v, &numbers) {
                return refuse(&e.place, format!("`{name}` {NO_VALUE}: add it to the `at` line"));
            }
        }
        let (printed, correct) = if sides.printed_left { (a, b) } else { (b, a) };
        let metre = self.metre();
        let pair = self.pair(printed, correct, &place)?;
        let stated = within.map(|w| self.constant(w, matches!(pair, Pair::Turns(..)))).transpose()?.map(f64::abs);
        let tolerance = |e: &Expr, finest: Option<f64>| -> Understood<f64> {
            match (stated, rounding(e, metre)) {
                (Some(t), _) => Ok(t),
                (None, Some(Rounding { half, decimal: true, whole })) => Ok(finest.filter(|_| whole).unwrap_or(half)),
                (None, Some(Rounding { half, .. })) => Ok(finest.unwrap_or(half)),
                (None, None) => refuse(&e.place, "how near? Write a plain number, or add `within 0.05`"),
            }
        };
        let mut all = Verdict::Agrees;
        match pair {
            Pair::Turns(t, u) => {
                let tolerance = tolerance(sides.printed(), None)?;
                let (x, y) = (numbers.turn(&t), numbers.turn(&u));
                let spread = self.spread(|n| n.turn(&t) - n.turn(&u));
                let f = FaultKind::Number {
                    printed: wrapped(x),
                    correct: wrapped(y),
                    tolerance: tolerance + spread,
                    angle: true,
                };
                if wrapped(x - y).abs() > tolerance + spread + FLOAT {
                    all = Verdict::Wrong(vec![Fault {
                        place: sides.printed().place.clone(),
                        entry: None,
                        kind: f,
                        repair: None,
                    }]);
                }
            }
            Pair::Scalars(x, y) => {
                let tolerance = tolerance(sides.printed(), None)?;
                if let Some(kind) = self.apart(&x, &y, tolerance) {
                    all = Verdict::Wrong(vec![Fault {
                        place: sides.printed().place.clone(),
                        entry: None,
                        kind,
                        repair: None,
                    }]);
                }
            }
            Pair::Matrices(m, n) => {
                let written = match &sides.printed().kind {
                    ExprKind::Matrix(_, entries) if entries.len() == m.entries.len() => Some(entries),
                    _ => None,
                };
                let decimals = || {
                    let all = written.into_iter().flatten().filter_map(|e| rounding(e, metre));
                    all.filter(|r| r.decimal && !r.whole).map(|r| r.half)
                };
                // Beside 552.9 a 62.0 is rounded to a decimal as well; beside 0.7071 a 1.0 is the whole number.
                let (finest, coarsest) = (decimals().reduce(f64::min), decimals().reduce(f64::max));
                let rounded_alike =
                    |e: &Expr| rounding(e, metre).is_some_and(|r| r.whole && coarsest.is_some_and(|c| c >= r.half));
                for (k, (x, y)) in m.entries.iter().zip(&n.entries).enumerate() {
                    let e = written.and_then(|w| w.get(k)).unwrap_or(sides.printed());
                    if let Some(kind) = self.apart(x, y, tolerance(e, if rounded_alike(e) { None } else { finest })?) {
                        let entry = Some((k / m.columns + 1, k % m.columns + 1));
                        all = joined(
                            all,
                            Verdict::Wrong(vec![Fault { place: e.place.clone(), entry, kind, repair: None }]),
                        );
                    }
                }
            }
        }
        Ok(all)
    }

    fn apart(&self, printed: &Ratio, correct: &Ratio, tolerance: f64) -> Option<FaultKind> {
        let numbers = self.numbers(&self.given);
        let (x, y) = (numbers.ratio(printed), numbers.ratio(correct));
        let tolerance = tolerance + self.spread(|n| n.ratio(printed) - n.ratio(correct));
        let slack = FLOAT * x.abs().max(y.abs()).max(1.0);
        ((x - y).abs() > tolerance + slack || x.is_nan() || y.is_nan()).then_some(FaultKind::Number {
            printed: x,
            correct: y,
            tolerance,
            angle: false,
        })
    }

    pub(super) fn order(&mut self, sides: &Sides<'_>, a: Value, b: Value, order: Relation) -> Understood<Verdict> {
        let place = sides.left.place.start..sides.right.place.end;
        let numbers = self.numbers(&self.given);
        for (v, e) in [(&a, sides.left), (&b, sides.right)] {
            if let Some(name) = self.missing(v, &numbers) {
                return refuse(&e.place, format!("`{name}` {NO_VALUE}: add it to an `at` line"));
            }
        }
        // fields may have other values than those of the table
        let fields = [&a, &b].iter().any(|v| self.asks_fields(v));
        let (x, y, exact) = match self.pair(a, b, &place)? {
            Pair::Scalars(x, y) => {
                let exact = self.compare_scalars(&x, &y, &place)?;
                (numbers.ratio(&x), numbers.ratio(&y), matches!(exact, Outcome::Same(c) if c.is_empty()))
            }
            Pair::Turns(t, u) => (numbers.turn(&t), numbers.turn(&u), false),
            Pair::Matrices(..) => return refuse(&place, "matrices have no order"),
        };
        let difference = if exact { 0.0 } else { x - y };
        let holds = match order {
            Relation::Less => difference < 0.0,
            Relation::LessOrEqual => difference <= 0.0,
            Relation::Greater => difference > 0.0,
            _ => difference >= 0.0,
        };
        if holds {
            let bare = self.given.is_empty() && !fields;
            return Ok(if bare { Verdict::Proven(Where::everywhere()) } else { Verdict::Agrees });
        }
        Ok(Verdict::Wrong(vec![Fault {
            place,
            entry: None,
            kind: FaultKind::Order { left: x, right: y },
            repair: None,
        }]))
    }
}
