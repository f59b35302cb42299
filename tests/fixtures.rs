//! Arms and poses that other people's programs made (`fixtures/`), through the table and the interpreter.

use std::fs;

use dh_symbolic::algebra::Transform;
use dh_symbolic::chain::Chain;
use dh_symbolic::kinematics::Kinematics;
use dh_tests::compare;
use dh_tests::engine::{Interpreter, spec};
use dh_tests::naive::{Arm, Column, Matrix, Row};
use serde_json::Value;

pub(crate) fn read(name: &str) -> Value {
    let path = format!("{}/fixtures/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{path}: {e}"))
}

pub(crate) fn list(value: &Value) -> &Vec<Value> {
    value.as_array().expect("a list")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().expect("a string")
}

/// An angle as a table writes it: exact where the fixture says how it was written.
fn angle(joint: &Value, key: &str) -> String {
    match &joint[format!("{key}_deg")] {
        Value::Null => format!("approx {:?}rad", number(&joint[key])),
        degrees => format!("{degrees}deg"),
    }
}

/// The text of the table.
pub(crate) fn table(robot: &Value) -> String {
    let convention = if robot["convention"] == "craig" { "modified" } else { "standard" };
    let unit = if robot["unit"] == "mm" { "unit = mm;\n" } else { "" };
    let mut out = format!("struct Arm;\nconvention = {convention};\n{unit}| joint | alpha | a | d | theta |\n");
    for (i, joint) in list(&robot["joints"]).iter().enumerate() {
        let (mut d, mut theta) = (format!("{:?}", number(&joint["d"])), angle(joint, "theta"));
        let moving = if joint["type"] == "R" { &mut theta } else { &mut d };
        *moving = format!("q{} + {moving}", i + 1).replace("+ -", "- ");
        out += &format!("| {} | {} | {:?} | {d} | {theta} |\n", i + 1, angle(joint, "alpha"), number(&joint["a"]));
    }
    out
}

/// The arm without a detour over the table.
fn arm(robot: &Value) -> Arm {
    let row = |(i, joint): (usize, &Value)| Row {
        alpha: number(&joint["alpha"]),
        a: number(&joint["a"]),
        d: number(&joint["d"]),
        theta: number(&joint["theta"]),
        moves: Some((joint["type"] == "R", vec![(i, 1.0)])),
    };
    Arm {
        modified: robot["convention"] == "craig",
        rows: list(&robot["joints"]).iter().enumerate().map(row).collect(),
        ..Arm::default()
    }
}

#[test]
fn poses_and_jacobians_of_all_arms() {
    let (robots, truth) = (read("robots.json"), read("forward.json"));
    assert_eq!(list(&robots).len(), 49);
    for robot in list(&robots) {
        let name = text(&robot["name"]);
        let spec = spec(&table(robot));
        let interpreter = Interpreter::new(&spec);
        let plain = arm(robot);
        let engine = interpreter.engine();
        let cases = list(&truth[name]);
        assert_eq!(cases.len(), 10, "{name}");
        for case in cases {
            let q: Vec<f64> = list(&case["q"]).iter().map(number).collect();
            let reach = plain.reach(&q);
            let pose: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| number(&case["T"][i][j])));
            let jacobian: Vec<Column> =
                (0..q.len()).map(|j| std::array::from_fn(|i| number(&case["J"][i][j]))).collect();
            for (who, got) in
                [("interpreter", (engine.both)(&q)), ("plain", (plain.pose(&q), plain.jacobian_from_axes(&q)))]
            {
                let error = compare::poses(&got.0, &pose, reach);
                assert!(error <= compare::ROUNDING, "{name}: pose of the {who} is {error:.1e} off at {q:?}");
                let error = compare::jacobians(&got.1, &jacobian, reach);
                assert!(error <= compare::ROUNDING, "{name}: Jacobian of the {who} is {error:.1e} off at {q:?}");
            }
        }
    }
}

/// R^T R = 1 and det R = 1 as formulas: for every link of every arm, and for the whole arm where that takes no minutes.
#[test]
fn all_rotations_are_proven_to_be_rotations() {
    let mut whole = 0;
    for robot in list(&read("robots.json")) {
        let chain = Chain::new(spec(&table(robot)));
        let kinematics = Kinematics::new(&chain);
        for i in 1..=kinematics.len() {
            assert!(kinematics.link(i).is_some_and(Transform::is_rigid), "{}: link {i}", robot["name"]);
        }
        let pose = kinematics.pose();
        if pose.r.iter().flatten().all(|entry| entry.terms().len() <= 30) {
            assert!(pose.is_rigid(), "{}", robot["name"]);
            whole += 1;
        }
    }
    assert!(whole >= 45, "only {whole} arms as a whole");
}
