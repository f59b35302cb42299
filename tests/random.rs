//! Random tables: the programs are proven, the interpreter agrees with the plain product, and nothing costs more than that product.

use dh_symbolic::algebra::LinearAngle;
use dh_symbolic::chain::{Chain, Convention, Elementary};
use dh_symbolic::program::{Cost, Graph, Program, Value};
use dh_tests::compare::{self, ROUNDING};
use dh_tests::engine::{Interpreter, fields, naive, spec};
use dh_tests::naive::Arm;
use dh_tests::sample::joint_vectors;
use proptest::prelude::*;
use proptest::sample::select;

/// What a row does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Turns,
    Slides,
    Fixed,
}

/// A row: its kind, the four cells without the variable, and the share of the variable before in its drive.
type Row = (Kind, [&'static str; 4], Option<&'static str>);

const ANGLES: &[&str] = &[
    "0",
    "0",
    "0",
    "90deg",
    "-90deg",
    "180deg",
    "30deg",
    "-45deg",
    "60deg",
    "pi/12",
    "17deg",
    "-101.25deg",
    "approx 0.7rad",
    "tilt",
    "tilt - 90deg",
    "fix",
];
const LENGTHS: &[&str] = &["0", "0", "0.3", "-0.25m", "120mm", "l1", "-l1", "2*l1 + 0.1", "l2", "c1"];
const DRIVES: &[&str] = &["-1", "1", "0.5", "k"];
const MOTIONS: &[&str] =
    &["tx(0.1)", "ty(-l1)", "tz(373mm)", "rx(90deg)", "ry(-90deg)", "rz(30deg)", "ry(tilt)", "rx(13deg)"];

fn row() -> impl Strategy<Value = Row> {
    let kind = select(&[Kind::Turns, Kind::Turns, Kind::Turns, Kind::Slides, Kind::Fixed][..]);
    let cells = (select(ANGLES), select(LENGTHS), select(LENGTHS), select(ANGLES));
    let coupled = prop_oneof![6 => Just(None), 1 => select(DRIVES).prop_map(Some)];
    (kind, cells, coupled).prop_map(|(kind, (alpha, a, d, theta), coupled)| (kind, [alpha, a, d, theta], coupled))
}

/// A table's text.
fn table() -> impl Strategy<Value = String> {
    let rows = prop::collection::vec(row(), 1..=8)
        .prop_filter("an arm moves", |rows| rows.iter().any(|row| row.0 != Kind::Fixed));
    let motions = || prop::collection::vec(select(MOTIONS), 0..=3);
    (any::<bool>(), rows, motions(), motions())
        .prop_map(|(modified, rows, base, tool)| text(modified, &rows, &base, &tool))
}

fn text(modified: bool, rows: &[Row], base: &[&str], tool: &[&str]) -> String {
    let mut out =
        format!("struct Arm;\nconvention = {};\nik = none;\n", if modified { "modified" } else { "standard" });
    out += "let l1: length = 0.35;\nlet l2: length;\nlet tilt: angle = 0.2turn;\nlet k: number = 1.5;\n";
    out += "let c1 = 45mm;\nlet fix = 15deg;\n";
    for (name, motions) in [("base", base), ("tool", tool)] {
        if !motions.is_empty() {
            out += &format!("{name} = {};\n", motions.join(" * "));
        }
    }
    out += "| alpha | a | d | theta |\n";
    let mut n = 0;
    for (kind, [alpha, a, d, theta], coupled) in rows {
        let (mut d, mut theta) = ((*d).to_string(), (*theta).to_string());
        if *kind != Kind::Fixed {
            n += 1;
            let mut q = format!("q{n}");
            if let (Some(k), true) = (coupled, n > 1) {
                q = format!("{q} + {k}*q{}", n - 1);
            }
            let cell = if *kind == Kind::Turns { &mut theta } else { &mut d };
            *cell = format!("{q} + {cell}");
        }
        out += &format!("| {alpha} | {a} | {d} | {theta} |\n").replace("+ -", "- ");
    }
    out
}

/// The product of all matrices from the base on, entry by entry, as a program. Zeros and ones cost nothing, and equal
/// instructions are one: what a good compiler makes of the textbook's formula.
struct Plain {
    graph: Graph,
    now: [[Value; 4]; 3],
    zero: Value,
}

impl Plain {
    fn new(chain: &Chain) -> Plain {
        let mut graph = Graph::new(chain);
        let [zero, one] = [0, 1].map(|x| graph.constant(dh_symbolic::algebra::Poly::int(x)));
        let now = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { one } else { zero }));
        Plain { graph, now, zero }
    }

    /// Multiplies by the 4x4 matrix of one link (or of the base, or of the tool).
    fn step(&mut self, factors: &[Elementary]) {
        let mut link = Plain { graph: self.graph.clone(), now: Plain::identity(&mut self.graph), zero: self.zero };
        for factor in factors {
            link.factor(factor);
        }
        self.graph = link.graph;
        self.now = self.times(&link.now);
    }

    fn identity(graph: &mut Graph) -> [[Value; 4]; 3] {
        let [zero, one] = [0, 1].map(|x| graph.constant(dh_symbolic::algebra::Poly::int(x)));
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { one } else { zero }))
    }

    fn factor(&mut self, factor: &Elementary) {
        let mut m = Plain::identity(&mut self.graph);
        match factor {
            Elementary::Translate(axis, length) => m[*axis][3] = self.graph.polynomial(length),
            Elementary::Rotate(axis, angle) => {
                let (c, s) = self.cos_sin(angle);
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                (m[j][j], m[j][k], m[k][j], m[k][k]) = (c, -s, s, c);
            }
        }
        self.now = self.times(&m);
    }

    fn cos_sin(&mut self, angle: &LinearAngle) -> (Value, Value) {
        self.graph.cos_sin(angle)
    }

    fn times(&mut self, m: &[[Value; 4]; 3]) -> [[Value; 4]; 3] {
        let now = self.now;
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let sum = (0..3).fold(self.zero, |sum, k| {
                    let part = self.graph.mul(now[i][k], m[k][j]);
                    self.graph.add(sum, part)
                });
                if j == 3 { self.graph.add(sum, now[i][3]) } else { sum }
            })
        })
    }

    fn column(&self, j: usize) -> [Value; 3] {
        self.now.map(|row| row[j])
    }
}

fn plain_pose(chain: &Chain) -> Program {
    let mut plain = Plain::new(chain);
    plain.step(&chain.base);
    for i in 0..chain.links.len() {
        plain.step(&chain.link_factors(i));
    }
    plain.step(&chain.tool);
    let outputs = (0..4).flat_map(|j| plain.column(j)).collect();
    Program { graph: plain.graph, outputs }
}

/// The pose and the textbook's columns z x (p - o), z; without coupled drives.
fn plain_jacobian(chain: &Chain) -> Program {
    let mut plain = Plain::new(chain);
    plain.step(&chain.base);
    let mut axes = Vec::new();
    for (i, link) in chain.links.iter().enumerate() {
        let before = (plain.column(2), plain.column(3));
        plain.step(&chain.link_factors(i));
        if link.joint.is_some() {
            let after = (plain.column(2), plain.column(3));
            axes.push(if chain.convention == Convention::Modified { after } else { before });
        }
    }
    plain.step(&chain.tool);
    let mut outputs: Vec<Value> = (0..4).flat_map(|j| plain.column(j)).collect();
    let tip = plain.column(3);
    for ((z, o), joint) in axes.into_iter().zip(&chain.joints) {
        let turns = matches!(joint.coordinate, dh_symbolic::chain::Coordinate::Angle(_));
        if turns {
            let r: [Value; 3] = std::array::from_fn(|i| plain.graph.sub(tip[i], o[i]));
            for i in 0..3 {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let (left, right) = (plain.graph.mul(z[j], r[k]), plain.graph.mul(z[k], r[j]));
                let across = plain.graph.sub(left, right);
                outputs.push(across);
            }
            outputs.extend(z);
        } else {
            outputs.extend(z);
            outputs.extend([plain.zero; 3]);
        }
    }
    Program { graph: plain.graph, outputs }
}

fn cost(program: &Program) -> Cost {
    Cost::of(&program.graph, &program.outputs)
}

fn cheaper(what: &str, got: Cost, plain: Cost, table: &str) {
    assert!(got.weight() <= plain.weight(), "{what}: {got}, but the plain product: {plain}\n{table}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn tables_give_proven_programs(table in table()) {
        let spec = spec(&table);
        let interpreter = Interpreter::new(&spec);
        let arm = Arm::new(&spec, &fields(&interpreter.chain));
        let chain = interpreter.chain.clone();
        let (pose, jacobian) = (cost(&interpreter.forward.pose), cost(&interpreter.forward.jacobian));
        let (engine, plain) = (interpreter.engine(), naive(arm.clone()));
        for q in joint_vectors(&spec, 5) {
            compare::engines(&engine, &plain, &table, &q, arm.reach(&q), ROUNDING);
        }
        cheaper("pose", pose, cost(&plain_pose(&chain)), &table);
        if chain.is_direct() {
            cheaper("Jacobian", jacobian, cost(&plain_jacobian(&chain)), &table);
        }
    }
}
