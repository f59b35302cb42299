//! Numeric evaluation at a point: the values of an `at` line, rounding, and random points that double-check a verdict.

use super::Evaluator;
use super::direct::Meaning;
use super::number::Written;
use super::ratio::Ratio;
use super::refusal::{Understood, refuse};
use super::substitute::{Variable, variable_of};
use super::value::{Turn, Value};
use crate::algebra::{Angle, AngleVar, LinearAngle, Monomial, Point, Poly, Rational, Symbol};
use crate::chain::{AngleCell, Bound, Chain, Coordinate, Handle, Joint, Nominal, Parameter, Role};
use crate::verify::language::{AtValue, Expr, ExprKind};
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
    pub(super) fn evaluate(&self, p: &Poly) -> f64 {
        p.evaluate(&Point { symbol: &|s| self.symbol(s), angle: &|v| self.angle(v) })
    }

    /// Not a number where there is none.
    pub(super) fn symbol(&self, s: Symbol) -> f64 {
        self.symbols.get(&s).copied().unwrap_or(f64::NAN)
    }

    /// Radians; not a number where there is none.
    pub(super) fn angle(&self, v: AngleVar) -> f64 {
        self.angles.get(&v).copied().unwrap_or(f64::NAN)
    }

    pub(super) fn linear(&self, a: &LinearAngle) -> f64 {
        a.terms.iter().map(|(v, k)| f64::from(*k) * self.angle(*v)).sum::<f64>() + a.constant.radians()
    }

    /// The constant part that a joint coordinate has beside what the actuators do.
    fn shift(&self, chain: &Chain, cell: &AngleCell) -> f64 {
        let own = |(i, k): &(usize, i8)| match chain.parameters.get(*i).map(|p| p.handle) {
            Some(Handle::Angle(v)) => f64::from(*k) * self.angle(v),
            _ => 0.0,
        };
        angle_value(cell) + cell.symbols.iter().map(own).sum::<f64>()
    }

    /// The variables q of the actuators: the drive turned around, by elimination.
    pub(super) fn actuators(&self, chain: &Chain) -> Option<Vec<f64>> {
        let coordinate = |j: &Joint| match j.coordinate {
            Coordinate::Angle(v) => self.angle(v) - self.shift(chain, &j.shift),
            Coordinate::Length(s) => self.symbol(s),
        };
        let x: Vec<f64> = chain.joints.iter().map(coordinate).collect();
        if chain.is_direct() {
            return Some(x);
        }
        let n = x.len();
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for (row, x) in chain.drive.iter().zip(x) {
            rows.push(row.iter().map(|p| self.evaluate(p)).chain([x]).collect());
        }
        for k in 0..n {
            let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))?;
            rows.swap(k, pivot);
            let first = rows.get(k)?.clone();
            for (i, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
                let _ = i;
                let factor = row.get(k)? / first.get(k)?;
                for (a, b) in row.iter_mut().zip(&first) {
                    *a -= factor * b;
                }
            }
        }
        (0..n).map(|k| Some(rows.get(k)?.get(n)? / rows.get(k)?.get(k)?)).collect()
    }

    /// Puts the joint coordinates where the actuators are.
    pub(super) fn set_motors(&mut self, chain: &Chain, actuators: &[f64]) {
        for (joint, row) in chain.joints.iter().zip(&chain.drive) {
            let used = row.iter().zip(actuators).filter(|(k, _)| !k.is_zero());
            let x: f64 = used.map(|(k, q)| self.evaluate(k) * q).sum();
            if x.is_nan() {
                continue;
            }
            match joint.coordinate {
                Coordinate::Angle(v) => _ = self.angles.insert(v, x + self.shift(chain, &joint.shift)),
                Coordinate::Length(s) => _ = self.symbols.insert(s, x),
            }
        }
    }

    pub(super) fn ratio(&self, x: &Ratio) -> f64 {
        if x.den.is_one() { self.evaluate(&x.num) } else { self.evaluate(&x.num) / self.evaluate(&x.den) }
    }

    /// The numerator, measured against its largest term.
    pub(super) fn relative(&self, x: &Ratio) -> f64 {
        let size = |(m, c): &(Monomial, Rational)| self.evaluate(&Poly::term(m.clone(), c.clone())).abs();
        let largest = x.num.terms().iter().map(size).fold(f64::MIN_POSITIVE, f64::max);
        self.evaluate(&x.num) / largest
    }

    pub(super) fn turn(&self, t: &Turn) -> f64 {
        let linear: f64 = t.terms.iter().map(|(v, k)| k.to_f64() * self.angle(*v)).sum();
        let side = |(x, y, minus): &(Ratio, Ratio, bool)| {
            let a = self.ratio(y).atan2(self.ratio(x));
            if *minus { -a } else { a }
        };
        linear + t.constant.radians() + t.sides.iter().map(side).sum::<f64>()
    }
}

/// Numbers between 0 and 1, the same for the same seed.
fn uniform(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn bound(b: &Bound) -> f64 {
    match b {
        Bound::HalfTurns(x) => Angle::half_turns(x.clone()).radians(),
        Bound::Radians(x) | Bound::Length(x) => x.to_f64(),
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
            let whole = text.strip_suffix(w.unit.as_str()).is_some_and(|digits| digits.ends_with(".0"));
            Some(Rounding { half: half(w.decimals.unwrap_or(0)), decimal: w.decimals.is_some(), whole })
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
    /// Is it written as `2.0`: a whole number, or one rounded to a decimal?
    pub(super) whole: bool,
}

impl Evaluator<'_> {
    pub(super) fn metre(&self) -> f64 {
        self.chain.settings.unit.metres.to_f64()
    }

    /// Reads a setting of an `at` line.
    pub(super) fn setting(&mut self, s: &AtValue) -> Understood<Given> {
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
        n.set_motors(self.chain, &joints);
        self.complete(&mut n);
        n
    }

    /// Adds what follows: angles with a name of their own, radians as numbers, roots.
    pub(super) fn complete(&self, n: &mut Numbers) {
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
        let mut unit = uniform(seed);
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

    /// A pose of the arm, and whether the arm has the lengths and angles of the table there: joints within their ranges and beyond; what
    /// has no value in the table is drawn, lengths with either sign.
    pub(super) fn sample(&self, k: usize) -> (Numbers, bool) {
        let mut unit = uniform(1_000_003 + k as u64);
        let chain = self.chain;
        let has_value = |p: &&Parameter| matches!(&p.role, Role::Field(Some(_)));
        // every third pose is that of another arm of the same kind
        let own = k % 3 != 2 || !chain.parameters.iter().any(|p| has_value(&p));
        let mut n = self.numbers(&[]);
        let constant = |v: &f64| v.is_finite() && *v != 0.0;
        let scale = n.symbols.values().filter(|v| constant(v)).fold(0.0, |s: f64, x| s.max(x.abs()));
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let fixed = |s: Handle| {
            chain.parameters.iter().any(|p| {
                p.handle == s && (matches!(p.role, Role::Constant(_)) || own && matches!(p.role, Role::Field(Some(_))))
            })
        };
        for s in self.ring.symbols() {
            let length = scale * (0.4 + unit()) * if unit() < 0.2 { -1.0 } else { 1.0 };
            if !fixed(Handle::Length(s)) {
                n.symbols.insert(s, length);
            }
        }
        for v in self.ring.angles() {
            let angle = std::f64::consts::PI * (2.0 * unit() - 1.0);
            if !fixed(Handle::Angle(v)) {
                n.angles.insert(v, angle);
            }
        }
        let mut actuators = Vec::new();
        for (joint, value) in chain.joints.iter().zip(&self.joints) {
            let u = unit();
            let range = joint.range.as_ref().filter(|_| k.is_multiple_of(2)).map(|(a, b)| (bound(a), bound(b)));
            let (low, high) = match (range, value) {
                (Some(range), _) => range,
                (None, Value::Angle(_)) => (-std::f64::consts::PI, std::f64::consts::PI),
                (None, _) => (-1.5 * scale, 1.5 * scale),
            };
            actuators.push(low + u * (high - low));
        }
        n.set_motors(chain, &actuators);
        self.complete(&mut n);
        (n, own)
    }

    /// The point where one variable has another value; `None` where the name is no single variable.
    pub(super) fn moved(&self, at: &Numbers, name: &str, new: impl Fn(f64) -> f64) -> Option<Numbers> {
        let mut n = at.clone();
        let own = self.meanings.iter().rev().find(|m| m.0 == name);
        let value = match own {
            Some((_, Meaning::Free(v))) => v.clone(),
            Some(_) => return None,
            None => self.quantity(name)?,
        };
        let actuator = self.chain.joints.iter().position(|j| own.is_none() && j.name == name);
        if let Some(k) = actuator {
            let mut actuators = n.actuators(self.chain)?;
            let q = actuators.get_mut(k)?;
            *q = new(*q);
            n.set_motors(self.chain, &actuators);
            return Some(n);
        }
        match variable_of(&value)? {
            Variable::Symbol(s, positive) => {
                let sign = if positive { 1.0 } else { -1.0 };
                n.symbols.insert(s, sign * new(sign * n.symbol(s)));
            }
            Variable::Angle(v, rest) => {
                let rest = n.turn(&rest);
                n.angles.insert(v, new(n.angle(v) + rest) - rest);
            }
        }
        Some(n)
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

    /// Does a value depend on a field of the robot?
    pub(super) fn asks_fields(&self, v: &Value) -> bool {
        let fields = || self.chain.parameters.iter().filter(|p| matches!(p.role, Role::Field(_)));
        let in_poly = |p: &Poly| {
            fields().any(|f| match f.handle {
                Handle::Length(s) => p.has_symbol(s),
                Handle::Angle(v) => p.has_angle(v),
            })
        };
        let in_ratio = |x: &Ratio| in_poly(&x.num) || in_poly(&x.den);
        match v {
            Value::Scalar(x) => in_ratio(x),
            Value::Matrix(m) => m.entries.iter().any(in_ratio),
            Value::Angle(t) => {
                let term = |v: &AngleVar| fields().any(|f| f.handle == Handle::Angle(*v));
                t.terms.iter().any(|(v, _)| term(v)) || t.sides.iter().any(|(x, y, _)| in_ratio(x) || in_ratio(y))
            }
        }
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
