//! The equations of a step with the unknown collected on the left (coefficients of its sine, cosine or powers) and known terms on the right.

use super::Explanation;
use crate::algebra::{Monomial, Poly, Rational, Symbol};
use crate::planner::{Basis, Collected, FrameScalar, Step, StepKind};
use crate::render::formula::expression::{Expression, Summand, Trig};
use crate::render::formula::math::{Math, Sign};

/// `sum of coefficient times unknown = right`.
pub(super) struct Row {
    /// Coefficients (in sines and cosines again) and parts.
    pub(super) left: Vec<(Poly, Vec<Basis>)>,
    /// The known side.
    pub(super) right: Poly,
    /// What both sides were divided by; lengths, never zero.
    pub(super) divisor: Poly,
    /// The expressions on the left, part by part.
    terms: Vec<Expression>,
    right_expression: Expression,
}

/// The rows of a step, signs and common lengths taken out.
pub(super) fn rows(explanation: &Explanation<'_>, step: &Step) -> Vec<Row> {
    step.collected.iter().map(|c| row(explanation, step, c)).collect()
}

/// The step without equations that a reader does not need: those whose left sides are those of others (of two the one stays that needs
/// fewer known poses), and where directions alone give the angle, or positions alone, the others.
pub(super) fn without_repeats(step: &Step) -> Step {
    let mut out = without_twins(step);
    let kinds = [true, false].map(|direction| -> Vec<usize> {
        let fits = |i: &usize| matches!(out.equations[*i].scalar, FrameScalar::Rotation(..)) == direction;
        (0..out.equations.len().min(out.collected.len())).filter(fits).collect()
    });
    let pair = step.kind == StepKind::AtanPair && kinds.iter().all(|k| !k.is_empty());
    if let Some(list) = kinds.into_iter().find(|k| pair && decides(&out, k)) {
        out.equations = list.iter().map(|i| out.equations[*i]).collect();
        out.collected = list.iter().map(|i| out.collected[*i].clone()).collect();
    }
    out
}

/// Do these equations give both sine and cosine?
fn decides(step: &Step, list: &[usize]) -> bool {
    let coefficient = |i: usize, part: Basis| step.collected[i].get(&vec![part]).cloned().unwrap_or_default();
    list.iter().any(|i| {
        list.iter().any(|j| {
            let [a, b] = [Basis::Cos(1), Basis::Sin(1)].map(|p| coefficient(*i, p));
            let [c, d] = [Basis::Cos(1), Basis::Sin(1)].map(|p| coefficient(*j, p));
            &a * &d != &b * &c
        })
    })
}

fn without_twins(step: &Step) -> Step {
    let left = |c: &Collected| -> Collected {
        let mut c = c.clone();
        c.retain(|k, _| k.iter().any(|x| *x != Basis::One));
        c
    };
    let negated = |c: &Collected| -> Collected { c.iter().map(|(k, p)| (k.clone(), -p)).collect() };
    let mut out = step.clone();
    let mut i = 0;
    while i < out.collected.len() && out.collected.len() == out.equations.len() {
        let here = left(&out.collected[i]);
        let twin = (i + 1..out.collected.len()).find(|j| {
            let there = left(&out.collected[*j]);
            there == here || negated(&there) == here
        });
        let Some(j) = twin else {
            i += 1;
            continue;
        };
        let shared = |k: usize| {
            let e = out.equations[k];
            out.equations.iter().filter(|f| (f.a, f.b) == (e.a, e.b)).count()
        };
        let drop = if shared(j) > shared(i) { i } else { j };
        out.collected.remove(drop);
        out.equations.remove(drop);
    }
    out
}

fn row(explanation: &Explanation<'_>, step: &Step, collected: &Collected) -> Row {
    let mut left: Vec<(Poly, Vec<Basis>)> = Vec::new();
    let mut right = Poly::zero();
    for (parts, p) in collected {
        if parts.iter().all(|x| *x == Basis::One) {
            right = -p;
        } else {
            left.push((p.clone(), parts.clone()));
        }
    }
    let (number, symbols) = common(explanation, left.iter().map(|(p, _)| p));
    for (p, _) in &mut left {
        *p = divide(p, &number, &symbols);
    }
    let inverse = number.recip().unwrap_or(Rational::ONE);
    let mut divisor = Poly::one();
    if right.terms().iter().all(|(_, c)| (c * &inverse).to_i64().is_some()) {
        right = right.scale(&inverse);
    } else {
        divisor = Poly::constant(number);
    }
    let (_, shared) = common(explanation, std::iter::once(&right));
    for (s, n) in symbols {
        // What the right side is divisible by goes; the rest is written below it.
        let whole = if right.is_zero() { n } else { shared.iter().find(|x| x.0 == s).map_or(0, |x| x.1.min(n)) };
        right = divide(&right, &Rational::ONE, &[(s, whole)]);
        divisor = &divisor * &Poly::power(s, n - whole);
    }
    let (mut left, mut right): (Vec<_>, Poly) =
        (left.into_iter().map(|(p, k)| (explanation.plain(&p), k)).collect(), explanation.plain(&right));
    let negative = |p: &Poly| leads_negative(&explanation.order.group(p));
    let minus = left.iter().filter(|(p, _)| negative(p)).count();
    let flip = match (2 * minus).cmp(&left.len()) {
        std::cmp::Ordering::Greater => true,
        std::cmp::Ordering::Equal => {
            if right.is_zero() {
                left.first().is_some_and(|(p, _)| negative(p))
            } else {
                negative(&right)
            }
        }
        std::cmp::Ordering::Less => false,
    };
    if flip {
        for (p, _) in &mut left {
            *p = -&*p;
        }
        right = -&right;
    }
    // What is added before what is subtracted.
    left.sort_by_key(|(p, _)| negative(p));
    let terms = left.iter().map(|(p, parts)| explanation.part_term(p, parts, step)).collect();
    Row { right_expression: explanation.order.group(&right), left, right, divisor, terms }
}

/// Does the expression begin with a minus sign?
fn leads_negative(e: &Expression) -> bool {
    matches!(e, Expression::Sum(list) if list.first().is_some_and(|s| s.negative))
}

/// The greatest number and powers of lengths that divide all coefficients.
fn common<'p>(
    explanation: &Explanation<'_>,
    coefficients: impl Iterator<Item = &'p Poly>,
) -> (Rational, Vec<(Symbol, u32)>) {
    let mut symbols: Option<Vec<(Symbol, u32)>> = None;
    let mut number: Option<Rational> = None;
    for (m, c) in coefficients.flat_map(Poly::terms) {
        let own: Vec<(Symbol, u32)> =
            explanation.lengths.iter().map(|s| (*s, m.exponent(*s))).filter(|(_, n)| *n > 0).collect();
        symbols = Some(match symbols {
            None => own,
            Some(list) => {
                let least = |(s, n): (Symbol, u32)| (s, n.min(own.iter().find(|x| x.0 == s).map_or(0, |x| x.1)));
                list.into_iter().map(least).filter(|(_, n)| *n > 0).collect()
            }
        });
        number = Some(match number {
            None => c.abs(),
            Some(x) if x == c.abs() => x,
            Some(_) => Rational::ONE,
        });
    }
    (number.unwrap_or(Rational::ONE), symbols.unwrap_or_default())
}

fn divide(p: &Poly, number: &Rational, symbols: &[(Symbol, u32)]) -> Poly {
    let inverse = number.recip().unwrap_or(Rational::ONE);
    p.terms()
        .iter()
        .map(|(m, c)| {
            let is_divided = |f: &crate::algebra::Factor| {
                matches!(f, crate::algebra::Factor::Power(s, _) if symbols.iter().any(|x| x.0 == *s))
            };
            let rest: Monomial = m.filter(|f| !is_divided(f));
            symbols.iter().fold(Poly::term(rest, c * &inverse), |q, (s, n)| {
                &q * &Poly::power(*s, m.exponent(*s).saturating_sub(*n))
            })
        })
        .sum()
}

impl Explanation<'_> {
    /// Coefficient times unknown.
    fn part_term(&self, p: &Poly, parts: &[Basis], step: &Step) -> Expression {
        let mut factors: Vec<Expression> = Vec::new();
        let mut negative = false;
        match self.order.group(p) {
            Expression::Number(x) if x.is_one() => {}
            Expression::Sum(list) if list.len() == 1 => {
                if let Some(only) = list.into_iter().next() {
                    negative = only.negative;
                    push_factors(&mut factors, only.value);
                }
            }
            // - (a + b) rather than (- a - b)
            Expression::Sum(mut list) => {
                negative = list.first().is_some_and(|s| s.negative);
                if negative {
                    list.iter_mut().for_each(|s| s.negative = !s.negative);
                }
                factors.push(Expression::Sum(list));
            }
            other => push_factors(&mut factors, other),
        }
        for (part, form) in parts.iter().zip(&step.unknown) {
            let trig = |k: u8, sine: bool| {
                let factor = i8::try_from(k).unwrap_or(1);
                let angles = self.angles(form).into_iter().map(|(v, n)| (v, n.saturating_mul(factor))).collect();
                Expression::Trig(Trig { angles, sine })
            };
            let slide = || {
                let axes = &self.plan.axes;
                form.iter().zip(&axes.coordinates).find(|(k, _)| **k != 0).and_then(|(_, c)| match c {
                    crate::chain::Coordinate::Length(s) => Some(Expression::Symbol(*s)),
                    crate::chain::Coordinate::Angle(_) => None,
                })
            };
            match part {
                Basis::One => {}
                Basis::Cos(k) => factors.push(trig(*k, false)),
                Basis::Sin(k) => factors.push(trig(*k, true)),
                Basis::Power(1) => factors.extend(slide()),
                Basis::Power(n) => factors.extend(slide().map(|s| Expression::Power(Box::new(s), u32::from(*n)))),
            }
        }
        let value = match factors.len() {
            0 => Expression::Number(Rational::ONE),
            1 => factors.remove(0),
            _ => Expression::Product(factors),
        };
        if negative { Expression::Sum(vec![Summand { negative, value }]) } else { value }
    }
}

fn push_factors(out: &mut Vec<Expression>, e: Expression) {
    match e {
        Expression::Number(x) if x.is_one() => {}
        Expression::Product(list) => out.extend(list),
        other => out.push(other),
    }
}

impl Row {
    /// Both sides as typeset.
    pub(super) fn sides(&self, explanation: &Explanation<'_>) -> (Math, Math) {
        let list: Vec<Summand> = self
            .terms
            .iter()
            .flat_map(|t| match t {
                Expression::Sum(list) if list.len() == 1 => list.clone(),
                other => vec![Summand { negative: false, value: other.clone() }],
            })
            .collect();
        let left = explanation.notation.typeset(&Expression::Sum(list));
        (left, self.known_side(explanation))
    }

    /// The right side, divided.
    pub(super) fn known_side(&self, explanation: &Explanation<'_>) -> Math {
        let top = explanation.notation.typeset(&self.right_expression);
        if self.divisor.is_one() {
            return top;
        }
        let below = explanation.typeset(&self.divisor);
        // A sign belongs before the bar.
        match &self.right_expression {
            Expression::Sum(list) if list.len() == 1 => match (list.first(), top) {
                (Some(only), Math::Row(_)) if only.negative => {
                    let value = explanation.notation.typeset(&only.value);
                    Math::Row(vec![Math::Sign(Sign::Negative), Math::Fraction(Box::new(value), Box::new(below))])
                }
                (_, top) => Math::Fraction(Box::new(top), Box::new(below)),
            },
            _ => Math::Fraction(Box::new(top), Box::new(below)),
        }
    }

    /// The coefficient of a part; 0 where it does not occur.
    pub(super) fn coefficient(&self, part: Basis) -> Poly {
        let found = self.left.iter().find(|(_, k)| matches!(k.as_slice(), [only] if *only == part));
        found.map_or_else(Poly::zero, |(p, _)| p.clone())
    }

    /// All its expressions.
    pub(super) fn expressions(&self) -> impl Iterator<Item = Expression> + '_ {
        self.terms.iter().cloned().chain(std::iter::once(self.right_expression.clone()))
    }
}
