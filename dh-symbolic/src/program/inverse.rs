//! A plan as instructions: for each step the coefficients of its equations, computed from the target and from what is known.
//!
//! All lengths are over the arm's reach, so that one tolerance fits all. Known combinations enter as symbols of their cosine and
//! sine; which symbols an instruction needs tells at which depth of the search it is computed.

use super::graph::{Graph, Value, ZERO};
use super::vector::V3;
use super::{Names, Node};
use crate::algebra::{Factor, Monomial, Poly, Rational, Symbol, Transform};
use crate::chain::{Chain, Coordinate};
use crate::planner::{Collected, Form, Knowledge, KnownPose, Part, Plan, StepKind};

/// The equations of one step, ready to be solved.
#[derive(Clone, Debug)]
pub struct Solver {
    /// What kind.
    pub kind: StepKind,
    /// Coefficients, one row per equation; their order belongs to the kind, see [`Inverse::derive`].
    pub rows: Vec<Vec<Value>>,
    /// The combinations it finds: indices into the plan's knowledge.
    pub finds: Vec<usize>,
}

/// A plan with its instructions.
#[derive(Clone, Debug)]
pub struct Inverse {
    /// The plan.
    pub plan: Plan,
    /// The instructions.
    pub graph: Graph,
    /// Symbols of the target's entries: rotation by rows, then position.
    pub target: [Symbol; 12],
    /// The steps.
    pub solvers: Vec<Solver>,
    /// Each real coordinate as a combination of known ones.
    pub joints: Vec<Vec<i8>>,
    /// The pose that the known combinations give (12 values, columns first, lengths over the reach): what a branch is confirmed by.
    pub confirmation: Vec<Value>,
    /// For the general elimination: which of its joints slide.
    pub slides: [bool; 6],
    /// For the general elimination: the best ways to cut the loop of joints (`ik::general::Choice`).
    pub choices: [u8; 3],
    /// How the roots of shoulder, elbow and wrist are named.
    pub names: [Names; 3],
}

/// A pose of values.
#[derive(Clone, Copy)]
struct Pose {
    columns: [V3; 3],
    p: V3,
}

impl Inverse {
    /// Lowers a plan. Rows are, with "sum = 0":
    ///
    /// * `Linear` a, b of a d + b; `Quadratic` a, b, c;
    /// * `HalfTurn` a, b; `SinCos` and every row of `AtanPair` a, b, c of a cos u + b sin u + c;
    /// * `SecondHarmonic` the coefficients of 1, cos u, sin u, cos 2u, sin 2u;
    /// * `Bilinear` and `SlideAndTurn` nine: (1, cos u, sin u) or (1, d, d^2) times (1, cos v, sin v), the second factor running faster;
    /// * `General` seven poses of twelve entries (columns, then position): the constant transforms behind joints 1 to 6, then
    ///   the target.
    pub fn derive(chain: &Chain, plan: Plan) -> Inverse {
        let mut plan = plan;
        let ring = &mut plan.knowledge.ring;
        let names = ["g11", "g12", "g13", "g21", "g22", "g23", "g31", "g32", "g33", "gx", "gy", "gz"];
        let target = names.map(|n| {
            let mut name = n.to_string();
            while ring.find_symbol(&name).is_some() {
                name.push('_');
            }
            ring.symbol(&name)
        });
        let mut l = Lower { g: Graph::new(chain), plan: &plan, bound: Vec::new() };
        let entry = |l: &mut Lower<'_>, i: usize| l.g.symbol(target[i]);
        let mut w = Pose { columns: [[ZERO; 3]; 3], p: [ZERO; 3] };
        for j in 0..3 {
            w.columns[j] = std::array::from_fn(|i| entry(&mut l, 3 * i + j));
        }
        w.p = std::array::from_fn(|i| entry(&mut l, 9 + i));
        // The target as the first frame and the last one see it.
        let w = l.after_inverse(w, &plan.axes.end);
        let w = l.before_inverse(w, &plan.axes.start);
        let mut solvers = Vec::new();
        for step in &plan.steps {
            for pose in poses_of(&step.collected, &plan.knowledge) {
                l.bind_pose(w, &pose, step.before);
            }
            let finds = (step.before..step.before + step.unknown.len()).collect();
            let rows = match step.kind {
                StepKind::General => l.general(w, step),
                _ => step.collected.iter().map(|c| l.row(step.kind, c)).collect(),
            };
            solvers.push(Solver { kind: step.kind, rows, finds });
        }
        let forms: Vec<Form> = plan.knowledge.known.iter().map(|k| k.form.clone()).collect();
        let joints = (0..plan.axes.real)
            .map(|k| {
                let mut unit = vec![0i8; plan.axes.count()];
                unit[k] = 1;
                crate::planner::combination(&unit, &forms).unwrap_or_default()
            })
            .collect();
        let confirmation = l.confirmation(chain);
        let graph = l.g;
        let (slides, choices, names) = ([false; 6], [0; 3], [Names::PLAIN; 3]);
        let mut inverse = Inverse { graph, target, solvers, joints, confirmation, slides, choices, names, plan };
        inverse.slides = inverse.sliding();
        inverse.choices = inverse.best_choices(chain);
        inverse.names = inverse.find_names(chain);
        inverse
    }

    /// Which joints of the general elimination slide.
    fn sliding(&self) -> [bool; 6] {
        let mut slides = [false; 6];
        for step in self.plan.steps.iter().filter(|s| s.kind == StepKind::General) {
            for (slide, form) in slides.iter_mut().zip(&step.unknown) {
                *slide = form.iter().position(|k| *k != 0).is_some_and(|k| !self.plan.axes.turns(k));
            }
        }
        slides
    }

    /// How many known combinations must be there before each node can be computed.
    pub fn depths(&self) -> Vec<usize> {
        let mut depth = Vec::with_capacity(self.graph.nodes().len());
        for node in self.graph.nodes() {
            let d = match *node {
                Node::Symbol(s) => {
                    self.plan.knowledge.known.iter().position(|k| k.symbols.contains(&s)).map_or(0, |i| i + 1)
                }
                Node::Add(a, b) => usize::max(depth[a.node as usize], depth[b.node as usize]),
                Node::Mul(a, b) => usize::max(depth[a as usize], depth[b as usize]),
                Node::Constant(_) | Node::Cos(_) | Node::Sin(_) => 0,
            };
            depth.push(d);
        }
        depth
    }
}

/// The known poses that occur in some equations.
fn poses_of(collected: &[Collected], knowledge: &Knowledge) -> Vec<KnownPose> {
    let mut symbols: Vec<Symbol> = collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
    symbols.sort_unstable();
    symbols.dedup();
    let used = |k: &KnownPose| k.symbols().any(|s| symbols.binary_search(&s).is_ok());
    knowledge.poses.iter().filter(|k| used(k)).cloned().collect()
}

struct Lower<'a> {
    g: Graph,
    plan: &'a Plan,
    bound: Vec<(usize, usize)>,
}

impl Lower<'_> {
    fn vector(&mut self, v: &[Poly; 3]) -> V3 {
        self.g.vector(v)
    }

    /// Cosine and sine of a combination of known forms.
    fn cos_sin(&mut self, form: &[i8], before: usize) -> (Value, Value) {
        let known = &self.plan.knowledge.known[..before];
        let forms: Vec<Form> = known.iter().map(|k| k.form.clone()).collect();
        let weights = crate::planner::combination(form, &forms).unwrap_or_else(|| vec![0; forms.len()]);
        let (mut c, mut s) = (super::graph::ONE, ZERO);
        for (w, k) in weights.iter().zip(known).filter(|(w, _)| **w != 0) {
            let (ck, sk) = (self.g.symbol(k.symbols[0]), self.g.symbol(k.symbols[1]));
            let sk = if *w < 0 { -sk } else { sk };
            for _ in 0..w.unsigned_abs() {
                let turned = self.g.turn(2, (ck, sk), [c, s, ZERO]);
                (c, s) = (turned[0], turned[1]);
            }
        }
        (c, s)
    }

    /// t^-1 W.
    fn before_inverse(&mut self, w: Pose, t: &Transform) -> Pose {
        let columns: [V3; 3] = std::array::from_fn(|j| self.vector(&t.column(j)));
        let shift = self.vector(&t.p);
        let p = self.g.minus(w.p, shift);
        let mut turned = |v: V3| -> V3 { std::array::from_fn(|i| self.g.dot(columns[i], v)) };
        Pose { columns: w.columns.map(&mut turned), p: turned(p) }
    }

    /// W t^-1.
    fn after_inverse(&mut self, w: Pose, t: &Transform) -> Pose {
        // R' = R Rt^T: column j is the sum over k of Rt[j][k] times column k.
        let columns: [V3; 3] = std::array::from_fn(|j| {
            let mut sum = [ZERO; 3];
            for k in 0..3 {
                let x = self.g.polynomial(&t.r[j][k]);
                let part = self.g.times(x, w.columns[k]);
                sum = self.g.plus(sum, part);
            }
            sum
        });
        let mut p = w.p;
        for (column, x) in columns.iter().zip(&t.p) {
            let x = self.g.polynomial(x);
            let part = self.g.times(x, *column);
            p = self.g.minus(p, part);
        }
        Pose { columns, p }
    }

    /// Binds the symbols of a known pose: the target brought back over known joints. Turns about parallel axes are taken together.
    fn bind_pose(&mut self, w: Pose, pose: &KnownPose, before: usize) {
        if self.bound.contains(&(pose.left, pose.right)) {
            return;
        }
        self.bound.push((pose.left, pose.right));
        let t = self.pose_between(w, pose.left, pose.right, before);
        for i in 0..3 {
            for j in 0..3 {
                self.g.bind(pose.r[i][j], t.columns[j][i]);
            }
            self.g.bind(pose.p[i], t.p[i]);
        }
        for j in 0..3 {
            let back = self.g.dot(t.columns[j], t.p);
            self.g.bind(pose.back[j], -back);
        }
        let square = self.g.dot(t.p, t.p);
        self.g.bind(pose.square, square);
    }

    fn pose_between(&mut self, w: Pose, left: usize, right: usize, before: usize) -> Pose {
        let mut t = w;
        let count = self.plan.axes.count();
        // From the left: the rotation waits until an axis of another direction comes.
        let mut pending: Form = vec![0; count];
        for hop in 0..left {
            let h = self.plan.axes.hops[hop].clone();
            if is_shift(&h.before) {
                let shift = self.vector(&h.before.p);
                t.p = self.g.minus(t.p, shift);
            } else {
                t = self.flush(t, &mut pending, before);
                t = self.before_inverse(t, &h.before);
            }
            if let Some(j) = h.joint {
                match self.plan.axes.coordinates[j] {
                    Coordinate::Angle(_) => {
                        pending[j] += 1;
                        let mut unit = vec![0; count];
                        unit[j] = 1;
                        let (c, s) = self.cos_sin_if_needed(&unit, before, t.p);
                        t.p = self.g.turn(2, (c, -s), t.p);
                    }
                    Coordinate::Length(s) => {
                        let d = self.g.symbol(s);
                        t.p = self.g.minus(t.p, [ZERO, ZERO, d]);
                    }
                }
            }
        }
        t = self.flush(t, &mut pending, before);
        for hop in (right..self.plan.axes.hops.len()).rev() {
            let h = self.plan.axes.hops[hop].clone();
            if let Some(j) = h.joint {
                match self.plan.axes.coordinates[j] {
                    Coordinate::Angle(_) => {
                        let mut unit = vec![0; count];
                        unit[j] = 1;
                        let (c, s) = self.cos_sin(&unit, before);
                        // Columns times Rz(-q): x' = x c - y s, y' = x s + y c.
                        let (x, y) = (t.columns[0], t.columns[1]);
                        let (a, b) = (self.g.times(c, x), self.g.times(s, y));
                        t.columns[0] = self.g.minus(a, b);
                        let (a, b) = (self.g.times(s, x), self.g.times(c, y));
                        t.columns[1] = self.g.plus(a, b);
                    }
                    Coordinate::Length(s) => {
                        let d = self.g.symbol(s);
                        let part = self.g.times(d, t.columns[2]);
                        t.p = self.g.minus(t.p, part);
                    }
                }
            }
            t = self.after_inverse(t, &h.before);
        }
        t
    }

    /// The turn of a position about z costs nothing where the position is on the axis.
    fn cos_sin_if_needed(&mut self, form: &[i8], before: usize, p: V3) -> (Value, Value) {
        if p[0] == ZERO && p[1] == ZERO { (super::graph::ONE, ZERO) } else { self.cos_sin(form, before) }
    }

    /// Applies the waiting rotation to the columns.
    fn flush(&mut self, mut t: Pose, pending: &mut Form, before: usize) -> Pose {
        if pending.iter().any(|k| *k != 0) {
            let (c, s) = self.cos_sin(pending, before);
            t.columns = t.columns.map(|v| self.g.turn(2, (c, -s), v));
            pending.fill(0);
        }
        t
    }

    fn row(&mut self, kind: StepKind, c: &Collected) -> Vec<Value> {
        use Part::{Cos, One, Power, Sin};
        let keys: Vec<Vec<Part>> = match kind {
            StepKind::Linear => vec![vec![Power(1)], vec![One]],
            StepKind::Quadratic => vec![vec![Power(2)], vec![Power(1)], vec![One]],
            StepKind::HalfTurn => vec![vec![Cos(1)], vec![Sin(1)]],
            StepKind::SinCos | StepKind::AtanPair => vec![vec![Cos(1)], vec![Sin(1)], vec![One]],
            StepKind::SecondHarmonic => vec![vec![One], vec![Cos(1)], vec![Sin(1)], vec![Cos(2)], vec![Sin(2)]],
            StepKind::Bilinear | StepKind::SlideAndTurn => {
                let first = if kind == StepKind::Bilinear { [One, Cos(1), Sin(1)] } else { [One, Power(1), Power(2)] };
                first.iter().flat_map(|u| [One, Cos(1), Sin(1)].map(|v| vec![*u, v])).collect()
            }
            StepKind::General | StepKind::Choose => vec![],
        };
        keys.iter().map(|k| c.get(k).map_or(ZERO, |p| self.formula(p))).collect()
    }

    /// A coefficient, factored by the inputs that occur most often.
    fn formula(&mut self, p: &Poly) -> Value {
        factored(&mut self.g, p)
    }

    /// The cheapest program of the pose, with sines and cosines made of known ones.
    fn confirmation(&mut self, chain: &Chain) -> Vec<Value> {
        let pose = super::forward::pose(chain, &crate::kinematics::blocks(chain));
        let before = self.plan.knowledge.known.len();
        let mut values: Vec<Value> = Vec::with_capacity(pose.graph.nodes().len());
        let live = pose.graph.live(&pose.outputs);
        for (node, live) in pose.graph.nodes().iter().zip(live) {
            let signed =
                |v: Value, all: &[Value]| if v.negative { -all[v.node as usize] } else { all[v.node as usize] };
            let value = match *node {
                _ if !live => ZERO,
                Node::Constant(i) => self.g.constant(pose.graph.constants()[i as usize].clone()),
                Node::Symbol(s) => self.g.symbol(s),
                Node::Cos(w) => self.wave(&pose.graph.waves()[w as usize], before).0,
                Node::Sin(w) => self.wave(&pose.graph.waves()[w as usize], before).1,
                Node::Add(a, b) => self.g.add(signed(a, &values), signed(b, &values)),
                Node::Mul(a, b) => self.g.mul(values[a as usize], values[b as usize]),
            };
            values.push(value);
        }
        pose.outputs
            .iter()
            .map(|v| if v.negative { -values[v.node as usize] } else { values[v.node as usize] })
            .collect()
    }

    /// Cosine and sine of an angle sum of the chain: joints from what is known, the rest as it is.
    fn wave(&mut self, wave: &crate::algebra::LinearAngle, before: usize) -> (Value, Value) {
        let mut form = vec![0i8; self.plan.axes.count()];
        let mut rest = wave.clone();
        rest.terms.retain(|(v, k)| match self.plan.axes.index_of_angle(*v) {
            Some(i) => {
                form[i] = *k;
                false
            }
            None => true,
        });
        let (c, s) = self.cos_sin(&form, before);
        let (rc, rs) = self.g.cos_sin(&rest);
        let turned = self.g.turn(2, (rc, rs), [c, s, ZERO]);
        (turned[0], turned[1])
    }

    /// The constant transforms behind the open joints, filled up to six, and the target.
    fn general(&mut self, w: Pose, step: &crate::planner::Step) -> Vec<Vec<Value>> {
        let before = step.before;
        let open = |j: usize| step.unknown.iter().any(|f| f[j] != 0);
        let flat = |t: Pose| [t.columns[0], t.columns[1], t.columns[2], t.p].concat();
        let identity = Pose { columns: super::vector::identity(), p: [ZERO; 3] };
        // Constants between open joints; what stands before the first one is taken off the target.
        let mut list: Vec<Pose> = vec![identity];
        for hop in self.plan.axes.hops.clone() {
            let last = list.len() - 1;
            list[last] = self.times(list[last], &hop.before);
            match hop.joint {
                Some(j) if !open(j) => list[last] = self.moved(list[last], j, before),
                Some(_) => list.push(identity),
                None => {}
            }
        }
        // W' = list[0]^-1 W.
        let first = list.remove(0);
        let p = self.g.minus(w.p, first.p);
        let turned = |g: &mut Graph, v: V3| -> V3 { std::array::from_fn(|i| g.dot(first.columns[i], v)) };
        let goal = Pose { columns: w.columns.map(|v| turned(&mut self.g, v)), p: turned(&mut self.g, p) };
        // Further joints with transforms around them that cancel when they are zero.
        let mut undo = Transform::identity();
        for k in list.len()..6 {
            let t = filler(k);
            let last = list.len() - 1;
            list[last] = self.times(list[last], &t);
            undo = undo.times(&t);
            list.push(identity);
        }
        if let Some(last) = list.last().copied().filter(|_| undo != Transform::identity()) {
            let end = list.len() - 1;
            list[end] = self.times(last, &undo.inverse());
        }
        list.push(goal);
        list.into_iter().map(flat).collect()
    }

    /// T times the motion of a joint that is known.
    fn moved(&mut self, t: Pose, joint: usize, before: usize) -> Pose {
        let mut out = t;
        match self.plan.axes.coordinates[joint] {
            Coordinate::Angle(_) => {
                let mut unit = vec![0; self.plan.axes.count()];
                unit[joint] = 1;
                let (c, s) = self.cos_sin(&unit, before);
                let (x, y) = (t.columns[0], t.columns[1]);
                let (a, b) = (self.g.times(c, x), self.g.times(s, y));
                out.columns[0] = self.g.plus(a, b);
                let (a, b) = (self.g.times(c, y), self.g.times(s, x));
                out.columns[1] = self.g.minus(a, b);
            }
            Coordinate::Length(s) => {
                let d = self.g.symbol(s);
                let part = self.g.times(d, t.columns[2]);
                out.p = self.g.plus(out.p, part);
            }
        }
        out
    }

    /// T * t for a constant t.
    fn times(&mut self, a: Pose, t: &Transform) -> Pose {
        let apply = |g: &mut Graph, v: V3| {
            let mut sum = [ZERO; 3];
            for k in 0..3 {
                let part = g.times(v[k], a.columns[k]);
                sum = g.plus(sum, part);
            }
            sum
        };
        let columns = std::array::from_fn(|j| {
            let v = self.vector(&t.column(j));
            apply(&mut self.g, v)
        });
        let v = self.vector(&t.p);
        let moved = apply(&mut self.g, v);
        Pose { columns, p: self.g.plus(a.p, moved) }
    }
}

/// A transform without any structure, lengths over the reach, in front of the k-th joint of the general elimination.
fn filler(k: usize) -> Transform {
    let angle = |degrees: i64| {
        let (c, s) = crate::algebra::Angle::degrees(&Rational::int(degrees)).cos_sin().unwrap_or_default();
        move |axis: usize| Transform::rotation(axis, (&c, &s))
    };
    let length = |n: i64| Poly::constant(Rational::new(n, 100).unwrap_or(Rational::ZERO));
    let n = k as i64;
    angle(60)(0)
        .times(&Transform::translation(0, &length(23 + 7 * n)))
        .times(&angle(45 + 15 * n)(1))
        .times(&Transform::translation(2, &length(31 - 5 * n)))
        .times(&angle(75)(0))
}

/// Is the rotation part the identity?
fn is_shift(t: &Transform) -> bool {
    t.r == Transform::identity().r
}

/// Horner by the input that stands in most terms.
fn factored(g: &mut Graph, p: &Poly) -> Value {
    let mut counts: Vec<(Symbol, usize)> = Vec::new();
    for (m, _) in p.terms() {
        for f in m.factors() {
            if let Factor::Power(s, _) = f {
                match counts.iter_mut().find(|c| c.0 == s) {
                    Some(c) => c.1 += 1,
                    None => counts.push((s, 1)),
                }
            }
        }
    }
    // The most frequent input; of equals the one declared last (found last), so that inner loops do less.
    let best = counts.iter().filter(|c| c.1 > 1).max_by_key(|c| (c.1, c.0));
    let Some((s, _)) = best.copied() else { return g.polynomial(p) };
    let (with, without): (Vec<_>, Vec<_>) = p.terms().iter().cloned().partition(|(m, _)| m.exponent(s) > 0);
    let quotient: Vec<(Monomial, Rational)> = with
        .into_iter()
        .flat_map(|(m, c)| {
            let n = m.exponent(s);
            let rest = Poly::term(m.filter(|f| !matches!(f, Factor::Power(x, _) if *x == s)), c);
            (&rest * &Poly::power(s, n - 1)).terms().to_vec()
        })
        .collect();
    let a = factored(g, &Poly::from_terms(quotient));
    let x = g.symbol(s);
    let product = g.mul(a, x);
    let rest = factored(g, &Poly::from_terms(without));
    g.add(product, rest)
}
