//! Numbers at a point: the values of an `at` line, rounding, and random points that keep a verdict honest.

use super::Evaluator;
use super::number::Written;
use super::ratio::Ratio;
use super::refusal::{Understood, refuse};
use super::substitute::{Variable, variable_of};
use super::value::{Turn, Value};
use crate::algebra::{Angle, AngleVar, Monomial, Point, Poly, Rational, Symbol};
use crate::chain::{AngleCell, Coordinate, Handle, Role, Value as Nominal};
use crate::verify::language::{Expr, ExprKind, Setting};
use std::collections::BTreeMap;

/// One value of an `at` line.
#[derive(Clone, Debug)]
pub(super) struct Given {
    what: What,
    pub(super) value: f64,
    /// How far the value may be off.
    pub(super) off: f64,
}

#[derive(Clone, Debug)]
enum What {
    /// Variable of joint (from 0).
    Joint(usize),
    Symbol(Symbol, bool),
    /// The angle is the value minus this.
    Angle(AngleVar, f64),
}

/// Values of symbols and angles.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbers {
    symbols: BTreeMap<Symbol, f64>,
    angles: BTreeMap<AngleVar, f64>,
}

impl Numbers {
    fn evaluate(&self, p: &Poly) -> f64 {
        let symbol = |s: Symbol| self.symbols.get(&s).copied().unwrap_or(f64::NAN);
        let angle = |v: AngleVar| self.angles.get(&v).copied().unwrap_or(f64::NAN);
        p.evaluate(&Point { symbol: &symbol, angle: &angle })
    }

    pub(super) fn ratio(&self, x: &Ratio) -> f64 {
        if x.den.is_one() { self.evaluate(&x.num) } else { self.evaluate(&x.num) / self.evaluate(&x.den) }
    }

    /// The numerator, measured against its largest term.
    fn relative(&self, x: &Ratio) -> f64 {
        let size = |(m, c): &(Monomial, Rational)| self.evaluate(&Poly::term(m.clone(), c.clone())).abs();
        let largest = x.num.terms().iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
        self.evaluate(&x.num) / largest
    }

    pub(super) fn turn(&self, t: &Turn) -> f64 {
        let linear: f64 =
            t.terms.iter().map(|(v, k)| k.to_f64() * self.angles.get(v).copied().unwrap_or(f64::NAN)).sum();
        let side = |(x, y, minus): &(Ratio, Ratio, bool)| {
            let a = self.ratio(y).atan2(self.ratio(x));
            if *minus { -a } else { a }
        };
        linear + t.constant.radians() + t.sides.iter().map(side).sum::<f64>()
    }
}

/// A difference of angles, modulo a whole turn.
pub(super) fn wrapped(x: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    x - turn * (x / turn).round()
}

fn angle_value(a: &AngleCell) -> f64 {
    a.exact().radians() + a.approx.as_ref().map_or(0.0, Rational::to_f64)
}

/// Half a unit of the last digit of a number as written (radians for angles). `None` where the formula is no plain number.
pub(super) fn rounding(e: &Expr, metre: f64) -> Option<Rounding> {
    match &e.kind {
        ExprKind::Negative(inner) => rounding(inner, metre),
        ExprKind::Number(text) => {
            let w = Written::read(text)?;
            let unit = match w.unit.as_str() {
                "" => 1.0,
                "rad" => 1.0,
                "deg" => std::f64::consts::PI / 180.0,
                "turn" => std::f64::consts::TAU,
                "m" => 1.0 / metre,
                "cm" => 0.01 / metre,
                "mm" => 0.001 / metre,
                "in" => 0.0254 / metre,
                _ => return None,
            };
            let half = |d: i32| 0.5 * 10f64.powi(-d) * unit;
            Some(Rounding { half: half(w.decimals.unwrap_or(0)), decimal: w.decimals.is_some() })
        }
        _ => None,
    }
}

/// How a number was rounded when it was written.
#[derive(Clone, Copy)]
pub(super) struct Rounding {
    pub(super) half: f64,
    /// Was a decimal point written?
    pub(super) decimal: bool,
}

impl Evaluator<'_> {
    pub(super) fn metre(&self) -> f64 {
        self.chain.unit.metres.to_f64()
    }

    /// Reads a setting of an `at` line.
    pub(super) fn setting(&mut self, s: &Setting) -> Understood<Given> {
        let old = self.name(&s.name).or_else(|why| refuse(&s.place, why))?;
        let joint = self.chain.joints.iter().position(|j| j.name == s.name);
        let what = match (joint, variable_of(&old)) {
            (Some(i), _) => What::Joint(i),
            (None, Some(Variable::Symbol(x, positive))) => What::Symbol(x, positive),
            (None, Some(Variable::Angle(v, rest))) => What::Angle(v, self.numbers(&[]).turn(&rest)),
            (None, None) => return refuse(&s.place, format!("`{}` is no single variable", s.name)),
        };
        let angle = matches!(old, Value::Angle(_));
        let value = self.constant(&s.value, angle)?;
        let off = match &s.within {
            Some(w) => self.constant(w, angle)?.abs(),
            None => rounding(&s.value, self.metre()).filter(|r| r.decimal).map_or(0.0, |r| r.half),
        };
        Ok(Given { what, value, off })
    }

    /// The number that a formula without variables stands for.
    pub(super) fn constant(&mut self, e: &Expr, angle: bool) -> Understood<f64> {
        let v = self.evaluate(e)?;
        let v = if angle { Value::Angle(self.turn(v, &e.place)?) } else { v };
        let x = match &v {
            Value::Scalar(x) => {
                let n = self.numbers(&[]);
                n.ratio(x)
            }
            Value::Angle(t) if angle => self.numbers(&[]).turn(t),
            v => return refuse(&e.place, format!("{} stands where a number is needed", v.what())),
        };
        if x.is_finite() { Ok(x) } else { refuse(&e.place, "this is no number: it depends on a variable") }
    }

    /// The values of everything at these settings: constants of the table and nominal values are known, too.
    pub(super) fn numbers(&self, given: &[Given]) -> Numbers {
        let mut n = Numbers::default();
        for p in &self.chain.parameters {
            let value = match &p.role {
                Role::Constant(v) => v,
                Role::Field(Some(v)) => v,
                Role::Field(None) => continue,
            };
            match (p.handle, value) {
                (Handle::Length(s), Nominal::Length(x)) => _ = n.symbols.insert(s, x.to_f64()),
                (Handle::Angle(v), Nominal::Angle(a)) => _ = n.angles.insert(v, angle_value(a)),
                _ => {}
            }
        }
        let mut joints = vec![f64::NAN; self.chain.joints.len()];
        for g in given {
            match g.what {
                What::Joint(i) => {
                    if let Some(q) = joints.get_mut(i) {
                        *q = g.value;
                    }
                }
                What::Symbol(s, positive) => _ = n.symbols.insert(s, if positive { g.value } else { -g.value }),
                What::Angle(v, rest) => _ = n.angles.insert(v, g.value - rest),
            }
        }
        for (joint, row) in self.chain.joints.iter().zip(&self.chain.drive) {
            let used = row.iter().zip(&joints).filter(|(k, _)| !k.is_zero());
            let x: f64 = used.map(|(k, q)| n.evaluate(k) * q).sum();
            if x.is_nan() {
                continue;
            }
            match joint.coordinate {
                Coordinate::Angle(v) => _ = n.angles.insert(v, x + angle_value(&joint.shift)),
                Coordinate::Length(s) => _ = n.symbols.insert(s, x),
            }
        }
        self.complete(&mut n);
        n
    }

    /// Adds what follows: angles with a name of their own, radians as numbers, roots.
    fn complete(&self, n: &mut Numbers) {
        for (v, a) in &self.constants {
            n.angles.insert(*v, a.radians());
        }
        if let Some(s) = self.ring.find_symbol("pi") {
            n.symbols.insert(s, Angle::half_turns(Rational::ONE).radians());
        }
        for v in self.ring.angles() {
            if let (Some(s), Some(x)) = (self.ring.find_symbol(self.ring.angle_name(v)), n.angles.get(&v)) {
                n.symbols.insert(s, *x);
            }
        }
        for r in &self.roots {
            let x = n.ratio(&r.radicand);
            // a radicand that is zero up to rounding
            n.symbols.insert(r.symbol, if x < 0.0 && x > -1e-12 { 0.0 } else { x.sqrt() });
        }
    }

    /// A point where everything has some value; numbers of the table keep theirs.
    pub(super) fn random_point(&self, seed: u64) -> Numbers {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d;
        let mut unit = move || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (z >> 11) as f64 / (1u64 << 53) as f64
        };
        let mut n = Numbers::default();
        for s in self.ring.symbols() {
            n.symbols.insert(s, 0.4 + unit());
        }
        for v in self.ring.angles() {
            n.angles.insert(v, 6.0 * unit() - 3.0);
        }
        for p in &self.chain.parameters {
            if let (Handle::Length(s), Role::Constant(Nominal::Length(x))) = (p.handle, &p.role) {
                n.symbols.insert(s, x.to_f64());
            }
            if let (Handle::Angle(v), Role::Constant(Nominal::Angle(a))) = (p.handle, &p.role) {
                n.angles.insert(v, angle_value(a));
            }
        }
        self.complete(&mut n);
        n
    }

    /// May a formula be zero although its normal form is not? Only where roots occur, or angles of the same kind as 35deg and
    /// 70deg, whose sines are related; then numbers at several points decide. (Where a root is not real, a point says nothing.)
    pub(super) fn is_zero_in_numbers(&self, x: &Ratio) -> bool {
        let related = x.num.angles().iter().any(|v| self.constants.iter().any(|c| c.0 == *v))
            || x.num.symbols().iter().any(|s| self.roots.iter().any(|r| r.symbol == *s));
        if !related {
            return false;
        }
        let values: Vec<f64> = (1..12).map(|k| self.random_point(k).relative(x)).filter(|v| v.is_finite()).collect();
        !values.is_empty() && values.iter().all(|v| v.abs() < 1e-9)
    }

    /// The name of something without a value.
    pub(super) fn missing(&self, v: &Value, n: &Numbers) -> Option<String> {
        let in_ratio = |x: &Ratio| {
            for p in [&x.num, &x.den] {
                if let Some(v) = p.angles().into_iter().find(|v| !n.angles.contains_key(v)) {
                    return Some(self.ring.angle_name(v).to_string());
                }
                if let Some(s) = p.symbols().into_iter().find(|s| n.symbols.get(s).is_none_or(|x| x.is_nan())) {
                    return Some(self.ring.symbol_name(s).to_string());
                }
            }
            None
        };
        match v {
            Value::Scalar(x) => in_ratio(x),
            Value::Matrix(m) => m.entries.iter().find_map(in_ratio),
            Value::Angle(t) => {
                let free = t.terms.iter().find(|(v, _)| !n.angles.contains_key(v));
                let own = free.map(|(v, _)| self.ring.angle_name(*v).to_string());
                own.or_else(|| t.sides.iter().find_map(|(x, y, _)| in_ratio(x).or_else(|| in_ratio(y))))
            }
        }
    }

    /// How far a value may be off because the `at` values are rounded: to first order, by differences.
    pub(super) fn spread(&self, f: impl Fn(&Numbers) -> f64) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.given.len() {
            let mut moved = self.given.clone();
            let Some(g) = moved.get_mut(i).filter(|g| g.off > 0.0) else { continue };
            let (value, off) = (g.value, g.off);
            let mut ends = [0.0, 0.0];
            for (end, x) in ends.iter_mut().zip([value - off, value + off]) {
                if let Some(g) = moved.get_mut(i) {
                    g.value = x;
                }
                *end = f(&self.numbers(&moved));
            }
            sum += wrapped_if_small(ends[1] - ends[0]).abs() / 2.0;
        }
        sum
    }
}

/// A jump of an angle by a whole turn is no spread.
fn wrapped_if_small(x: f64) -> f64 {
    if (x.abs() - std::f64::consts::TAU).abs() < 0.5 { wrapped(x) } else { x }
}
