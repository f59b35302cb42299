//! The textbook's solution of each kind of equation.

use super::Explanation;
use super::rows::Row;
use crate::algebra::{Poly, Rational, Ring};
use crate::planner::{Basis, Step, StepKind};
use crate::render::formula::expression::Expression;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::Notation;

/// Longer formulas get a name instead of being put into another one.
const SHORT: usize = 14;
/// A sum in a product gets a name sooner.
const SHORT_SUM: usize = 5;
/// Without M, the matrix of the singular configurations, P, a position, the letters of poses, and C and S, cosine and sine.
pub(super) const LETTERS: [char; 7] = ['K', 'L', 'Q', 'X', 'Y', 'Z', 'D'];

/// A formula over another one.
#[derive(Clone)]
pub(crate) struct Quotient {
    /// Above the bar.
    pub(crate) top: Poly,
    /// Below it.
    pub(crate) below: Poly,
}

impl Quotient {
    fn new(top: &Poly, below: &Poly) -> Quotient {
        Quotient { top: top.clone(), below: below.clone() }
    }
}

/// The values of the unknown, as formulas of what is known.
#[derive(Clone, Default)]
pub(crate) enum RootFormulas {
    /// No formula is printed.
    #[default]
    Unprinted,
    /// A length.
    Linear(Quotient),
    /// a d^2 + b d = k.
    Quadratic(Poly, Poly, Quotient),
    /// a cos u + b sin u = k.
    SinCos(Poly, Poly, Quotient),
    /// a cos u + b sin u = 0.
    HalfTurn(Poly, Poly),
    /// The angle of (cosine, sine).
    Pair(Quotient, Quotient),
}

impl RootFormulas {
    /// The values, smallest sign first as they are printed; `at` evaluates a formula.
    pub(crate) fn values(&self, at: &dyn Fn(&Poly) -> f64) -> Vec<f64> {
        let over = |q: &Quotient| at(&q.top) / at(&q.below);
        let list = match self {
            RootFormulas::Unprinted => Vec::new(),
            RootFormulas::Linear(q) => vec![over(q)],
            RootFormulas::Quadratic(a, b, k) => {
                let (a, b, k) = (at(a), at(b), over(k));
                let root = (b * b + 4.0 * a * k).sqrt();
                vec![(root - b) / (2.0 * a), (-root - b) / (2.0 * a)]
            }
            RootFormulas::SinCos(a, b, k) => {
                let (a, b, k) = (at(a), at(b), over(k));
                let (middle, apart) = (b.atan2(a), (a * a + b * b - k * k).sqrt().atan2(k));
                vec![middle + apart, middle - apart]
            }
            RootFormulas::HalfTurn(a, b) => {
                let (a, b) = (at(a), at(b));
                vec![(-a).atan2(b), a.atan2(-b)]
            }
            RootFormulas::Pair(c, s) => vec![over(s).atan2(over(c))],
        };
        list.into_iter().filter(|x| x.is_finite()).collect()
    }
}

/// How a step is solved.
#[derive(Default)]
pub(crate) struct Solution {
    /// The name of the equation's right side, where it is long.
    pub(crate) right: Option<Math>,
    /// Names for long coefficients.
    pub(crate) abbreviations: Vec<(Math, Math)>,
    /// The same and the name of the right side, as formulas.
    pub(crate) letters: Vec<(Math, Quotient)>,
    /// The values of the unknown.
    pub(crate) roots: RootFormulas,
    /// The unknown.
    pub(crate) formulas: Vec<(Math, Math)>,
    /// Does another equation give the unknown in the same way where this one vanishes?
    pub(crate) second: bool,
    /// What must not be negative for a real solution.
    pub(crate) radicand: Option<Math>,
    /// What must not vanish all at once: where it does, the unknown is free.
    pub(crate) degenerate: Vec<Math>,
    /// The same as formulas.
    pub(crate) coefficients: Vec<Poly>,
}

pub(super) fn solution(explanation: &Explanation<'_>, number: usize, step: &Step, rows: &[Row]) -> Solution {
    let Some(unknown) = step.unknown.first().map(|f| explanation.unknown(f)) else { return Solution::default() };
    let mut w = SolutionWriter {
        explanation,
        number,
        ring: explanation.plan.knowledge.ring.clone(),
        notation: explanation.notation.clone(),
        names: Vec::new(),
        out: Solution::default(),
    };
    match (step.kind, rows) {
        (StepKind::Linear, [row]) => w.linear(unknown, row),
        (StepKind::Quadratic, [row]) => w.quadratic(unknown, row),
        (StepKind::HalfTurn, [row, more @ ..]) => w.half_turn(unknown, row, more),
        (StepKind::SinCos, [row]) => w.sin_cos(unknown, row),
        (StepKind::AtanPair, [first, second, ..]) => w.atan_pair(unknown, rows, first, second),
        _ => {}
    }
    w.out
}

struct SolutionWriter<'a, 'b> {
    explanation: &'a Explanation<'b>,
    /// Number of the step, an index of its letters.
    number: usize,
    ring: Ring,
    notation: Notation,
    /// Sums that have a letter, and the letter.
    names: Vec<(Poly, Poly)>,
    out: Solution,
}

fn atan2(sine: Math, cosine: Math) -> Math {
    Math::call("atan2", vec![sine, cosine])
}

fn sign(s: Sign) -> Math {
    Math::Sign(s)
}

fn root(m: Math) -> Math {
    Math::Root(Box::new(m))
}

fn over(m: Math, below: Math) -> Math {
    Math::Fraction(Box::new(m), Box::new(below))
}

impl SolutionWriter<'_, '_> {
    fn typeset(&self, p: &Poly) -> Math {
        self.notation.typeset(&self.explanation.order.group(p))
    }

    /// The letter of the k-th intermediate result, with the step's number.
    fn name(&self, k: usize) -> Math {
        let letters = &self.explanation.letters;
        let letter = letters.get(k % letters.len().max(1)).copied().unwrap_or('K');
        let round = k / letters.len().max(1);
        let index = Math::number(self.number);
        Math::Letter(letter).below(match round {
            0 => index,
            n => Math::Row(vec![index, Math::Sign(Sign::Comma), Math::number(n)]),
        })
    }

    /// The next letter, with the step's number.
    fn letter(&mut self, right: &Math, value: Quotient) -> Math {
        let used = self.out.abbreviations.len() + usize::from(self.out.right.is_some());
        let name = self.name(used);
        self.out.abbreviations.push((name.clone(), right.clone()));
        self.out.letters.push((name.clone(), value));
        name
    }

    /// The right side, or its name where it is long.
    fn right(&mut self, row: &Row) -> Math {
        let m = row.known_side(self.explanation);
        if m.glyphs() <= SHORT {
            return m;
        }
        let name = self.name(0);
        self.out.right = Some(name.clone());
        self.out.letters.push((name.clone(), Quotient::new(&row.right, &row.divisor)));
        name
    }

    /// The formula with a letter in place of a sum that stands in it as a factor; the same letter for the same sum and its negative.
    fn named(&mut self, p: &Poly) -> Poly {
        if p.terms().len() < 2 || self.typeset(p).glyphs() <= SHORT_SUM {
            return p.clone();
        }
        let negative = -p;
        if let Some((q, letter)) = self.names.iter().find(|(q, _)| q == p || *q == negative) {
            return if q == p { letter.clone() } else { -letter };
        }
        // The letter stands for the form that begins with a plus.
        let leading_minus = matches!(
            self.explanation.order.group(p),
            Expression::Sum(list) if list.first().is_some_and(|s| s.negative)
        );
        let positive = if leading_minus { negative } else { p.clone() };
        let right = self.typeset(&positive);
        let name = self.letter(&right, Quotient::new(&positive, &Poly::one()));
        let symbol = self.ring.symbol(&format!("letter {}", self.names.len()));
        self.notation.set_symbol(symbol, name);
        let letter = Poly::symbol(symbol);
        self.names.push((positive, letter.clone()));
        if leading_minus { -&letter } else { letter }
    }

    /// Notes what must not vanish all at once; constants of the arm never do.
    fn degenerate(&mut self, list: &[&Poly]) {
        let constant =
            |p: &&&Poly| p.angles().is_empty() && p.symbols().iter().all(|s| self.explanation.lengths.contains(s));
        if list.iter().all(|p| constant(&p)) {
            return;
        }
        let shown = list.iter().filter(|p| !p.is_zero()).map(|p| {
            let group = self.explanation.order.group(p);
            let negative = matches!(&group, Expression::Sum(list) if list.first().is_some_and(|s| s.negative));
            if negative { self.explanation.typeset(&-*p) } else { self.explanation.notation.typeset(&group) }
        });
        self.out.degenerate = shown.collect();
        self.out.coefficients = list.iter().filter(|p| !p.is_zero()).map(|p| (*p).clone()).collect();
    }

    fn linear(&mut self, unknown: Math, row: &Row) {
        let a = row.coefficient(Basis::Power(1));
        self.out.roots = RootFormulas::Linear(Quotient::new(&row.right, &(&a * &row.divisor)));
        let value = match a.as_rational() {
            Some(x) if x.is_one() => row.known_side(self.explanation),
            Some(x) if (-&x).is_one() && row.divisor.is_one() => self.typeset(&-&row.right),
            _ => over(row.known_side(self.explanation), self.typeset(&a)),
        };
        self.out.formulas.push((unknown, value));
        self.degenerate(&[&a]);
    }

    /// a d^2 + b d = k.
    fn quadratic(&mut self, unknown: Math, row: &Row) {
        let (a, b) = (row.coefficient(Basis::Power(2)), row.coefficient(Basis::Power(1)));
        self.out.roots = RootFormulas::Quadratic(a.clone(), b.clone(), Quotient::new(&row.right, &row.divisor));
        let k = self.right(row);
        let (a, b) = (self.named(&a), self.named(&b));
        let monic = a.is_one();
        let a = self.typeset(&a);
        if b.is_zero() {
            let inside = if monic { k } else { over(k, a) };
            self.out.radicand = Some(inside.clone());
            self.out.formulas.push((unknown, Math::Row(vec![sign(Sign::Either), root(inside)])));
            return;
        }
        let four = if monic { vec![Math::number(4)] } else { vec![Math::number(4), wrapped(a.clone())] };
        let mut inside = vec![square(self.typeset(&b)), sign(Sign::Plus)];
        inside.extend(four);
        inside.push(wrapped(k));
        let inside = Math::Row(inside);
        let top = Math::Row(vec![self.typeset(&-&b), sign(Sign::PlusMinus), root(inside.clone())]);
        let below = if monic { Math::number(2) } else { Math::Row(vec![Math::number(2), wrapped(a)]) };
        self.out.radicand = Some(inside);
        self.out.formulas.push((unknown, over(top, below)));
    }

    /// a cos + b sin = 0.
    fn half_turn(&mut self, unknown: Math, row: &Row, more: &[Row]) {
        let (a, b) = (row.coefficient(Basis::Cos(1)), row.coefficient(Basis::Sin(1)));
        self.out.roots = RootFormulas::HalfTurn(a.clone(), b.clone());
        let (x, y) = (self.short(&a), self.short(&b));
        let right = Math::Row(vec![
            atan2(self.typeset(&-&x), self.typeset(&y)),
            sign(Sign::Comma),
            sign(Sign::Wide),
            atan2(self.typeset(&x), self.typeset(&-&y)),
        ]);
        self.out.formulas.push((unknown, right));
        let others: Vec<Poly> =
            more.iter().flat_map(|row| [row.coefficient(Basis::Cos(1)), row.coefficient(Basis::Sin(1))]).collect();
        self.out.second = !more.is_empty();
        self.degenerate(&[&a, &b].into_iter().chain(&others).collect::<Vec<_>>());
    }

    /// A letter only where the formula is long.
    fn short(&mut self, p: &Poly) -> Poly {
        if self.typeset(p).glyphs() <= SHORT { p.clone() } else { self.named(p) }
    }

    /// a cos + b sin = k.
    fn sin_cos(&mut self, unknown: Math, row: &Row) {
        let (a, b) = (row.coefficient(Basis::Cos(1)), row.coefficient(Basis::Sin(1)));
        self.out.roots = RootFormulas::SinCos(a.clone(), b.clone(), Quotient::new(&row.right, &row.divisor));
        let k = self.right(row);
        if b.is_zero() || a.is_zero() {
            // one of them alone: the unit circle gives the other
            let p = if b.is_zero() { &a } else { &b };
            let k = match p.as_rational() {
                Some(x) if x.is_one() => k,
                Some(x) if (-&x).is_one() => Math::Row(vec![sign(Sign::Negative), wrapped(k)]),
                _ => {
                    let quotient = over(k, self.typeset(p));
                    self.letter(&quotient, Quotient::new(&row.right, &(&row.divisor * p)))
                }
            };
            let other = Math::Row(vec![Math::number(1), sign(Sign::Minus), square(k.clone())]);
            let side = Math::Row(vec![sign(Sign::Either), root(other.clone())]);
            let value = if b.is_zero() { atan2(side, k) } else { atan2(k, side) };
            self.out.radicand = Some(other);
            self.out.formulas.push((unknown, value));
            self.degenerate(&[p]);
            return;
        }
        let (x, y) = (self.named(&a), self.named(&b));
        let sum = self.typeset(&(&x.square() + &y.square()));
        let inside = Math::Row(vec![sum, sign(Sign::Minus), square(k.clone())]);
        let value = Math::Row(vec![
            atan2(self.typeset(&y), self.typeset(&x)),
            sign(Sign::PlusMinus),
            atan2(root(inside.clone()), k),
        ]);
        self.out.radicand = Some(inside);
        self.out.formulas.push((unknown, value));
        self.degenerate(&[&a, &b]);
    }

    /// Two or more equations in cosine and sine.
    fn atan_pair(&mut self, unknown: Math, rows: &[Row], first: &Row, second: &Row) {
        let parts: Vec<[Poly; 3]> = rows
            .iter()
            .map(|r| [r.coefficient(Basis::Cos(1)), r.coefficient(Basis::Sin(1)), r.right.clone()])
            .collect();
        let divided = rows.iter().any(|r| !r.divisor.is_one());
        // Normal equations: where the columns are orthogonal, each side is one quotient.
        let dot = |list: &[[Poly; 3]], i: usize, j: usize| -> Poly { list.iter().map(|p| &p[i] * &p[j]).sum() };
        let (cc, cs, ss) = (dot(&parts, 0, 0), dot(&parts, 0, 1), dot(&parts, 1, 1));
        let orthogonal = cs.is_zero() && !cc.is_zero() && !ss.is_zero() && !divided;
        if orthogonal {
            self.out.roots =
                RootFormulas::Pair(Quotient::new(&dot(&parts, 0, 2), &cc), Quotient::new(&dot(&parts, 1, 2), &ss));
            let mut letters = |p: &[Poly; 3]| -> [Poly; 3] { std::array::from_fn(|i| self.named(&p[i])) };
            let single = |p: &[Poly; 3]| p[0].as_rational().is_some() && p[1].as_rational().is_some();
            let named: Vec<[Poly; 3]> = parts.iter().map(|p| if single(p) { p.clone() } else { letters(p) }).collect();
            let (s, c) = (dot(&named, 1, 2), dot(&named, 0, 2));
            let (s, c) = (self.typeset(&s), self.typeset(&c));
            let value = if cc == ss {
                atan2(s, c)
            } else {
                let below = |m: Math, p: &Poly| if p.is_one() { m } else { over(m, self.explanation.typeset(p)) };
                atan2(below(s, &ss), below(c, &cc))
            };
            self.out.formulas.push((unknown, value));
            // The sums of squares vanish where every coefficient does.
            let mut all: Vec<Poly> = Vec::new();
            for p in parts.iter().flat_map(|p| [&p[0], &p[1]]).filter(|p| !p.is_zero()) {
                let negative = -p;
                if !all.contains(p) && !all.contains(&negative) {
                    all.push(p.clone());
                }
            }
            if !cc.is_one() || !ss.is_one() {
                self.degenerate(&all.iter().collect::<Vec<_>>());
            }
            return;
        }
        // Cramer's rule on the first two.
        let cramer = |p: [&Poly; 4]| &(p[0] * p[1]) - &(p[2] * p[3]);
        if let [[a, b, k], [e, f, l], ..] = parts.as_slice() {
            let (dk, dl) = (&first.divisor, &second.divisor);
            let (k, l) = (&(k * dl), &(l * dk));
            let determinant = cramer([a, f, b, e]);
            let below = &determinant * &(dk * dl);
            if determinant.as_rational().is_none() {
                self.out.coefficients = vec![determinant];
            }
            let (c, s) = (cramer([f, k, b, l]), cramer([a, l, e, k]));
            self.out.roots = RootFormulas::Pair(Quotient::new(&c, &below), Quotient::new(&s, &below));
        }
        let mut letters = |p: &[Poly; 3]| -> [Poly; 3] { std::array::from_fn(|i| self.named(&p[i])) };
        let [a, b, k] =
            letters(&[first.coefficient(Basis::Cos(1)), first.coefficient(Basis::Sin(1)), first.right.clone()]);
        let [e, f, l] =
            letters(&[second.coefficient(Basis::Cos(1)), second.coefficient(Basis::Sin(1)), second.right.clone()]);
        let (dk, dl) = (&first.divisor, &second.divisor);
        let determinant = &(&a * &f) - &(&b * &e);
        let (k, l) = (&k * dl, &l * dk);
        let (mut s, mut c) = (&(&a * &l) - &(&e * &k), &(&f * &k) - &(&b * &l));
        let mut below = &determinant * &(dk * dl);
        if let Some(x) = below.as_rational() {
            let one = if x.is_negative() { Rational::int(-1) } else { Rational::ONE };
            (s, c) = (s.scale(&one), c.scale(&one));
            below = Poly::one();
        } else {
            self.out.degenerate.push(self.typeset(&determinant));
        }
        let divide = |m: Math| if below.is_one() { m } else { over(m, self.typeset(&below)) };
        let value = atan2(divide(self.typeset(&s)), divide(self.typeset(&c)));
        self.out.formulas.push((unknown, value));
    }
}

/// May this be a factor or squared without brackets?
fn simple(m: &Math) -> bool {
    match m {
        Math::Letter(_) | Math::Number(_) => true,
        Math::Script(s) => s.sup.is_none(),
        Math::Row(list) => matches!(list.as_slice(), [only] if simple(only)),
        _ => false,
    }
}

fn wrapped(m: Math) -> Math {
    if simple(&m) { m } else { m.in_brackets() }
}

fn square(m: Math) -> Math {
    let m = match m {
        Math::Row(mut list) if list.len() == 1 => list.remove(0),
        other => other,
    };
    wrapped(m).above(Math::number(2))
}
