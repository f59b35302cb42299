//! Every printed equation holds, and every printed solution solves it: the typeset formulas themselves are evaluated.

use super::Explanation;
use crate::algebra::{Point, Poly, Transform};
use crate::chain::samples::*;
use crate::chain::{Chain, Coordinate, Elementary, Handle};
use crate::kinematics::Kinematics;
use crate::planner::{Plan, search};
use crate::render::document::frames::Frame;
use crate::render::formula::expression::Expression;
use crate::render::formula::math::{Math, Sign};
use crate::render::formula::notation::{Notation, trigs};
use crate::render::formula::text;
use std::collections::BTreeMap;

/// Values by printed name.
type Values = BTreeMap<String, f64>;

/// All values of a typeset formula (a sign that may be either gives two).
fn evaluate(m: &Math, values: &Values) -> Vec<f64> {
    let tokens = m.clone().flatten();
    let mut at = 0;
    let out = alternatives(&tokens, &mut at, values);
    assert_eq!(at, tokens.len(), "{}: rest {:?}", text::math(m), &tokens[at..]);
    out
}

fn alternatives(t: &[Math], at: &mut usize, v: &Values) -> Vec<f64> {
    let mut out = sum(t, at, v);
    while matches!(t.get(*at), Some(Math::Sign(Sign::Comma))) {
        *at += 2; // comma, room
        out.extend(sum(t, at, v));
    }
    out
}

fn sum(t: &[Math], at: &mut usize, v: &Values) -> Vec<f64> {
    let signs: &[f64] = match t.get(*at) {
        Some(Math::Sign(Sign::Negative)) => &[-1.0],
        Some(Math::Sign(Sign::Either)) => &[1.0, -1.0],
        _ => &[1.0],
    };
    if matches!(t.get(*at), Some(Math::Sign(Sign::Negative | Sign::Either))) {
        *at += 1;
    }
    let mut total = combine(signs, &product(t, at, v), |a, b| a * b);
    loop {
        let signs: &[f64] = match t.get(*at) {
            Some(Math::Sign(Sign::Plus)) => &[1.0],
            Some(Math::Sign(Sign::Minus)) => &[-1.0],
            Some(Math::Sign(Sign::PlusMinus)) => &[1.0, -1.0],
            _ => return total,
        };
        *at += 1;
        let next = combine(signs, &product(t, at, v), |a, b| a * b);
        total = combine(&total, &next, |a, b| a + b);
    }
}

fn combine(a: &[f64], b: &[f64], f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    a.iter().flat_map(|x| b.iter().map(|y| f(*x, *y)).collect::<Vec<_>>()).collect()
}

fn product(t: &[Math], at: &mut usize, v: &Values) -> Vec<f64> {
    let mut out = vec![1.0];
    while let Some(m) = t.get(*at) {
        if matches!(m, Math::Sign(Sign::Times | Sign::Thin | Sign::Degree)) {
            *at += 1;
            continue;
        }
        if matches!(m, Math::Sign(_) | Math::Close(_)) {
            break;
        }
        out = combine(&out, &factor(t, at, v), |a, b| a * b);
    }
    out
}

fn factor(t: &[Math], at: &mut usize, v: &Values) -> Vec<f64> {
    let m = &t[*at];
    *at += 1;
    match m {
        Math::Number(n) => vec![n.parse().unwrap()],
        Math::Fraction(n, d) => combine(&evaluate(n, v), &evaluate(d, v), |a, b| a / b),
        Math::Root(x) => evaluate(x, v).into_iter().map(f64::sqrt).collect(),
        Math::Open(_) => {
            let out = sum(t, at, v);
            assert!(matches!(t.get(*at), Some(Math::Close(_))));
            *at += 1;
            out
        }
        Math::Word(w) if w == "atan2" => {
            *at += 1;
            let y = sum(t, at, v);
            *at += 1;
            let x = sum(t, at, v);
            *at += 1;
            // Both from one sign, where there is one.
            combine(&y, &x, f64::atan2)
        }
        // c alpha, s alpha: the letter and the angle together are the name.
        Math::Letter('c' | 's') if t.get(*at).is_some_and(|next| v.contains_key(&pair(m, next))) => {
            *at += 1;
            vec![v[&pair(m, &t[*at - 1])]]
        }
        Math::Script(s) if v.get(&text::math(m)).is_none() => {
            let power: f64 = text::math(s.sup.as_ref().expect("a power or a name")).parse().unwrap();
            let mut plain = s.clone();
            plain.sup = None;
            let base = if plain.sub.is_none() { plain.base } else { Math::Script(plain) };
            evaluate(&base, v).into_iter().map(|x| x.powf(power)).collect()
        }
        name => vec![*v.get(&text::math(name)).unwrap_or_else(|| panic!("no value for {}", text::math(name)))],
    }
}

fn pair(a: &Math, b: &Math) -> String {
    format!("{}{}", text::math(a), text::math(b))
}

/// An arm at one joint vector.
struct World<'a> {
    chain: &'a Chain,
    plan: &'a Plan,
    x: Vec<f64>,
}

impl World<'_> {
    fn parameter(&self, h: Handle) -> f64 {
        let i = self.chain.parameters.iter().position(|p| p.handle == h).unwrap_or(0);
        0.31 + 0.17 * (1.0 + i as f64).sqrt()
    }

    fn number(&self, p: &Poly) -> f64 {
        let place = |c: Coordinate| self.plan.axes.coordinates.iter().position(|d| *d == c);
        p.evaluate(&Point {
            symbol: &|s| place(Coordinate::Length(s)).map_or_else(|| self.parameter(Handle::Length(s)), |k| self.x[k]),
            angle: &|v| place(Coordinate::Angle(v)).map_or_else(|| self.parameter(Handle::Angle(v)), |k| self.x[k]),
        })
    }

    /// A frame seen from frame 0: a product of rows of the table, and what the document says of frames with primes.
    fn seen(&self, explanation: &Explanation<'_>, frame: Frame) -> Transform {
        let rows = Kinematics::new(self.chain);
        let product = |list: &[Elementary]| list.iter().fold(Transform::identity(), |t, e| t.times(&e.transform()));
        let row = |i: usize| if i == 0 { Transform::identity() } else { rows.transform(0, i).unwrap() };
        match frame {
            Frame::Row(i) => row(i),
            Frame::Base => product(&self.chain.base).inverse(),
            Frame::Tool => row(self.chain.links.len()).times(&product(&self.chain.tool)),
            primed => {
                let all = explanation.definitions();
                let d = all.iter().find(|d| d.from == primed || d.to == primed).expect("a definition");
                let motion = product(&d.factors);
                if d.to == primed {
                    self.seen(explanation, d.from).times(&motion)
                } else {
                    self.seen(explanation, d.to).times(&motion.inverse())
                }
            }
        }
    }

    fn values(&self, explanation: &Explanation<'_>) -> Values {
        let mut v = Values::new();
        let n = &explanation.notation;
        for p in &self.chain.parameters {
            let name = match p.handle {
                Handle::Length(s) => n.symbol(s),
                Handle::Angle(w) => n.angle(w),
            };
            v.insert(text::math(&name), self.parameter(p.handle));
        }
        for (k, c) in self.plan.axes.coordinates.iter().enumerate() {
            if let Coordinate::Length(s) = c {
                v.insert(text::math(&n.symbol(*s)), self.x[k]);
            }
        }
        let all: Vec<Expression> = explanation.steps.iter().flat_map(|s| s.expressions.clone()).collect();
        for w in trigs(&all) {
            v.insert(text::math(&n.trig(&w)), self.number(&Poly::harmonic(&w.angles, w.sine)));
        }
        for pose in &explanation.poses {
            // The frames as the document names them, by products of rows of the table alone.
            let t = self.seen(explanation, pose.left).inverse().times(&self.seen(explanation, pose.right));
            let pose = &self.plan.knowledge.poses[pose.index];
            for i in 0..3 {
                for j in 0..3 {
                    v.insert(text::math(&n.symbol(pose.r[i][j])), self.number(&t.r[i][j]));
                }
                v.insert(text::math(&n.symbol(pose.p[i])), self.number(&t.p[i]));
            }
        }
        v
    }
}

fn check(name: &str, table: &str) {
    let chain = chain(table);
    let plan = search(&chain).unwrap_or_else(|r| panic!("{name}: {r:?}"));
    let explanation = Explanation::new(&chain, &plan, &Notation::textbook(&chain));
    let mut solved = 0;
    for seed in 1..4 {
        let x = (0..plan.axes.count()).map(|k| ((1 + k) as f64 * 1.7 * f64::from(seed)).sin() * 1.4).collect();
        let world = World { chain: &chain, plan: &plan, x };
        let mut v = world.values(&explanation);
        for explained in &explanation.steps {
            let step = &plan.steps[explained.index];
            let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * (1.0 + a.abs());
            for (left, right) in explained.new_extras.iter() {
                let value = evaluate(right, &v);
                v.insert(text::math(left), value[0]);
            }
            let definitions: Vec<_> =
                explained.equations.iter().filter(|e| explained.solution.right.as_ref() == Some(&e.0)).collect();
            for (left, right) in definitions {
                let value = evaluate(right, &v);
                v.insert(text::math(left), value[0]);
            }
            for (left, right) in &explained.equations {
                let (l, r) = (evaluate(left, &v)[0], evaluate(right, &v)[0]);
                assert!(close(l, r), "{name}: {} = {l}, {} = {r}", text::math(left), text::math(right));
            }
            for (left, right) in &explained.solution.abbreviations {
                let value = evaluate(right, &v);
                v.insert(text::math(left), value[0]);
            }
            for (_, right) in &explained.solution.formulas {
                let form = &step.unknown[0];
                let want: f64 = form.iter().zip(&world.x).map(|(k, x)| f64::from(*k) * x).sum();
                let turns = !explanation.angles(form).is_empty();
                let same = |y: &f64| {
                    if turns {
                        (y - want).sin().abs() < 1e-6 && (y - want).cos() > 0.0
                    } else {
                        (y - want).abs() < 1e-6
                    }
                };
                let found = evaluate(right, &v);
                assert!(found.iter().any(same), "{name}: {} gives {found:?}, not {want}", text::math(right));
                solved += 1;
            }
        }
    }
    assert!(solved > 0, "{name}");
}

#[test]
fn printed_equations_hold_and_printed_solutions_solve_them() {
    for (name, table) in ALL {
        check(name, table);
    }
}
