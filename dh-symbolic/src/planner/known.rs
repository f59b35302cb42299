//! What is known at a step of a plan: the target, the joint combinations found so far, and matrices made of them.

use super::axes::Axes;
use super::subspace::{JointCombination, Subspace, combination, numbers};
use crate::algebra::{Factor, Poly, Ring, Symbol, Transform};
use crate::chain::Coordinate;
use std::collections::BTreeMap;

/// A combination of coordinates whose value is known at this point of the plan.
#[derive(Clone, Debug)]
pub struct Known {
    /// The combination.
    pub form: JointCombination,
    /// Symbols of its cosine and sine; for a prismatic joint its own symbol twice.
    pub symbols: [Symbol; 2],
    /// Whether it is an angle.
    pub is_angle: bool,
    /// Name for readers: `q1`, `q2 + q3`.
    pub name: String,
    /// The same as one word: `q2_plus_q3`.
    pub label: String,
}

/// A pose of known entries: the target brought back over known joints.
#[derive(Clone, Debug)]
pub struct KnownPose {
    /// Frames: M(0, left)^-1 W M(right, n)^-1.
    pub left: usize,
    /// See `left`.
    pub right: usize,
    /// Rotation by rows.
    pub r: [[Symbol; 3]; 3],
    /// Position.
    pub p: [Symbol; 3],
    /// -R^T p.
    pub back: [Symbol; 3],
    /// p.p.
    pub square: Symbol,
}

/// The dependence on one unknown in a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Basis {
    /// Not at all.
    One,
    /// cos(k u).
    Cos(u8),
    /// sin(k u).
    Sin(u8),
    /// u^k of a prismatic joint.
    Power(u8),
}

/// A scalar equation "sum of coefficient times parts = 0".
pub type Collected = BTreeMap<Vec<Basis>, Poly>;

/// A sine or cosine as a sum of coefficients times parts.
type Split = Vec<(Vec<Basis>, Poly)>;

/// Everything known at a stage of the plan.
#[derive(Clone, Debug)]
pub struct Knowledge {
    /// Names.
    pub ring: Ring,
    /// Known combinations.
    pub known: Vec<Known>,
    /// Their space.
    pub span: Subspace,
    /// Known poses, in order of first use.
    pub poses: Vec<KnownPose>,
}

impl Knowledge {
    /// At the start only the target is known.
    pub fn new(axes: &Axes) -> Knowledge {
        Knowledge { ring: axes.ring.clone(), known: Vec::new(), span: Subspace::default(), poses: Vec::new() }
    }

    /// A combination as text, `q2 + q3`.
    pub fn form_name(&self, axes: &Axes, form: &[i8]) -> String {
        self.joined(axes, form, ["-", " - ", " + "], "*")
    }

    /// The names in a combination, with words for its signs: a minus in front, minus, plus; and for a factor.
    fn joined(&self, axes: &Axes, form: &[i8], [first, minus, plus]: [&str; 3], times: &str) -> String {
        let mut out = String::new();
        for (i, k) in form.iter().enumerate().filter(|(_, k)| **k != 0) {
            let name = match axes.coordinates[i] {
                Coordinate::Angle(v) => self.ring.angle_name(v),
                Coordinate::Length(s) => self.ring.symbol_name(s),
            };
            out.push_str(match (out.is_empty(), *k < 0) {
                (true, false) => "",
                (true, true) => first,
                (false, true) => minus,
                (false, false) => plus,
            });
            if k.unsigned_abs() > 1 {
                out.push_str(&format!("{}{times}", k.unsigned_abs()));
            }
            out.push_str(name);
        }
        out
    }

    /// Makes a combination known.
    pub fn learn(&mut self, axes: &Axes, form: &[i8]) -> &Known {
        let single =
            form.iter().position(|k| *k != 0).filter(|i| form.iter().enumerate().all(|(j, k)| j == *i || *k == 0));
        let is_angle = form.iter().position(|k| *k != 0).is_some_and(|i| axes.is_revolute(i));
        let name = self.form_name(axes, form);
        let symbols = match (is_angle, single.map(|i| axes.coordinates[i])) {
            (false, Some(Coordinate::Length(s))) => [s, s],
            _ => {
                let tail: String = form
                    .iter()
                    .enumerate()
                    .filter(|(_, k)| **k != 0)
                    .map(|(i, k)| {
                        let name = match axes.coordinates[i] {
                            Coordinate::Angle(v) => self.ring.angle_name(v),
                            Coordinate::Length(s) => self.ring.symbol_name(s),
                        };
                        let tail = name.trim_start_matches("theta").trim_start_matches('q');
                        format!("{}{tail}", if *k < 0 { "m" } else { "" })
                    })
                    .collect();
                let c = self.ring.symbol(&self.free(&format!("c{tail}")));
                let s = self.ring.symbol(&self.free(&format!("s{tail}")));
                [c, s]
            }
        };
        self.span.add(&numbers(form));
        let label = self.joined(axes, form, ["minus_", "_minus_", "_plus_"], "x");
        self.known.push(Known { form: form.to_vec(), symbols, is_angle, name, label });
        &self.known[self.known.len() - 1]
    }

    fn free(&self, name: &str) -> String {
        let mut name = name.to_string();
        while self.ring.find_symbol(&name).is_some() || self.ring.find_angle(&name).is_some() {
            name.push('_');
        }
        name
    }

    /// Whether a coordinate is known by itself.
    pub fn has(&self, axes: &Axes, k: usize) -> bool {
        let mut unit = vec![0.0; axes.count()];
        unit[k] = 1.0;
        self.span.contains(&unit)
    }

    /// How many links from frame 0 hold only known joints.
    pub fn prefix(&self, axes: &Axes) -> usize {
        axes.links.iter().take_while(|h| h.joint.is_none_or(|j| self.has(axes, j))).count()
    }

    /// The first frame after which all joints are known.
    pub fn suffix(&self, axes: &Axes) -> usize {
        axes.links.len() - axes.links.iter().rev().take_while(|h| h.joint.is_none_or(|j| self.has(axes, j))).count()
    }

    /// The known pose between two frames; new symbols on first use.
    pub fn pose(&mut self, left: usize, right: usize) -> KnownPose {
        if let Some(p) = self.poses.iter().find(|p| p.left == left && p.right == right) {
            return p.clone();
        }
        let tag = if self.poses.is_empty() {
            String::new()
        } else {
            format!("{}_", (b'a' + (self.poses.len() as u8 - 1) % 26) as char)
        };
        let ring = &mut self.ring;
        let mut symbol = |name: String| {
            let mut name = name;
            while ring.find_symbol(&name).is_some() {
                name.push('_');
            }
            ring.symbol(&name)
        };
        let axis = ["x", "y", "z"];
        let pose = KnownPose {
            left,
            right,
            r: std::array::from_fn(|i| std::array::from_fn(|j| symbol(format!("{tag}r{}{}", i + 1, j + 1)))),
            p: std::array::from_fn(|i| symbol(format!("{tag}p{}", axis[i]))),
            back: std::array::from_fn(|i| symbol(format!("{tag}b{}", axis[i]))),
            square: symbol(format!("{tag}pp")),
        };
        self.poses.push(pose.clone());
        pose
    }

    /// Rewrites an equation in angles and lengths so that only the unknown combinations and known symbols are left.
    /// `None` where it depends on something else.
    pub fn collect(&self, axes: &Axes, p: &Poly, unknown: &[JointCombination]) -> Option<Collected> {
        let forms: Vec<JointCombination> =
            unknown.iter().cloned().chain(self.known.iter().map(|k| k.form.clone())).collect();
        let mut out: BTreeMap<Vec<Basis>, Vec<Poly>> = BTreeMap::new();
        // The same few sines and cosines occur in all terms.
        let mut seen: Vec<(Factor, Split)> = Vec::new();
        for (m, c) in p.terms() {
            let mut sum: BTreeMap<Vec<Basis>, Poly> = BTreeMap::new();
            let is_joint = |f: &Factor| match f {
                Factor::Power(s, _) => axes.coordinates.contains(&Coordinate::Length(*s)),
                Factor::Cos(t) | Factor::Sin(t) => t.iter().any(|(v, _)| axes.index_of_angle(*v).is_some()),
                Factor::Root(_) => false,
            };
            sum.insert(vec![Basis::One; unknown.len()], Poly::term(m.filter(|f| !is_joint(f)), c.clone()));
            for f in m.factors().filter(|f| is_joint(f)) {
                let place = match seen.iter().position(|s| s.0 == f) {
                    Some(place) => place,
                    None => {
                        let split = self.factor(axes, &f, unknown, &forms)?;
                        seen.push((f, split));
                        seen.len() - 1
                    }
                };
                let factor = &seen[place].1;
                let mut next: BTreeMap<Vec<Basis>, Poly> = BTreeMap::new();
                for (a, x) in &sum {
                    for (b, y) in factor {
                        let mut key = Vec::with_capacity(a.len());
                        for (p, q) in a.iter().zip(b) {
                            key.push(match (*p, *q) {
                                (Basis::One, x) | (x, Basis::One) => x,
                                _ => return None,
                            });
                        }
                        let entry = next.entry(key).or_default();
                        *entry = &*entry + &(x * y);
                    }
                }
                sum = next;
            }
            for (k, v) in sum {
                out.entry(k).or_default().push(v);
            }
        }
        Some(out.into_iter().map(|(k, v)| (k, v.into_iter().sum::<Poly>())).filter(|(_, v)| !v.is_zero()).collect())
    }

    /// One factor in terms of the unknowns.
    fn factor(
        &self,
        axes: &Axes,
        f: &Factor,
        unknown: &[JointCombination],
        forms: &[JointCombination],
    ) -> Option<Split> {
        let one = vec![Basis::One; unknown.len()];
        match f {
            Factor::Root(_) => None,
            Factor::Power(s, n) => {
                let i = axes.coordinates.iter().position(|c| *c == Coordinate::Length(*s))?;
                let mut unit = vec![0i8; axes.count()];
                unit[i] = 1;
                match unknown.iter().position(|u| *u == unit) {
                    Some(u) => {
                        let mut key = one;
                        key[u] = Basis::Power(u8::try_from(*n).ok()?);
                        Some(vec![(key, Poly::one())])
                    }
                    None if self.has(axes, i) => Some(vec![(one, Poly::power(*s, *n))]),
                    None => None,
                }
            }
            Factor::Cos(t) | Factor::Sin(t) => {
                let mut target = vec![0i8; axes.count()];
                for (v, k) in t {
                    target[axes.index_of_angle(*v)?] = *k;
                }
                let weights = combination(&target, forms)?;
                // cos and sin of the known part, then one unknown after the other.
                let (mut c, mut s) = (Poly::one(), Poly::zero());
                for (w, known) in weights[unknown.len()..].iter().zip(&self.known) {
                    let (ck, sk) = (Poly::symbol(known.symbols[0]), Poly::symbol(known.symbols[1]));
                    let sk = if *w < 0 { -&sk } else { sk };
                    for _ in 0..w.unsigned_abs() {
                        (c, s) = (&(&c * &ck) - &(&s * &sk), &(&s * &ck) + &(&c * &sk));
                    }
                }
                let mut cosine = vec![(one.clone(), c)];
                let mut sine = vec![(one, s)];
                for (u, w) in weights[..unknown.len()].iter().enumerate().filter(|(_, w)| **w != 0) {
                    let times = |list: &[(Vec<Basis>, Poly)], part: Basis, sign: i64| -> Vec<(Vec<Basis>, Poly)> {
                        list.iter()
                            .map(|(key, p)| {
                                let mut key = key.clone();
                                key[u] = part;
                                (key, p.scale(&sign.into()))
                            })
                            .collect()
                    };
                    let (ku, sign) = (w.unsigned_abs(), i64::from(w.signum()));
                    let mut c = times(&cosine, Basis::Cos(ku), 1);
                    c.extend(times(&sine, Basis::Sin(ku), -sign));
                    let mut s = times(&sine, Basis::Cos(ku), 1);
                    s.extend(times(&cosine, Basis::Sin(ku), sign));
                    (cosine, sine) = (c, s);
                }
                Some(if matches!(f, Factor::Cos(_)) { cosine } else { sine })
            }
        }
    }
}

impl Known {
    /// The combination's value at given coordinates.
    pub fn at(&self, x: &[f64]) -> f64 {
        self.form.iter().zip(x).map(|(k, x)| f64::from(*k) * x).sum()
    }

    /// Cosine and sine, or the length twice, at given coordinates.
    pub fn value(&self, x: &[f64]) -> [f64; 2] {
        let u: f64 = self.form.iter().zip(x).map(|(k, x)| f64::from(*k) * x).sum();
        if self.is_angle { [u.cos(), u.sin()] } else { [u, u] }
    }
}

impl KnownPose {
    /// All its symbols.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.r.iter().flatten().chain(&self.p).chain(&self.back).chain([&self.square]).copied()
    }

    /// As a transform of symbols.
    pub fn transform(&self) -> Transform {
        Transform {
            r: std::array::from_fn(|i| std::array::from_fn(|j| Poly::symbol(self.r[i][j]))),
            p: std::array::from_fn(|i| Poly::symbol(self.p[i])),
        }
    }
}
