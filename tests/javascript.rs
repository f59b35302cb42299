//! The printed JavaScript computes what Rust computes: poses, frames, Jacobians and all solutions of the inverse.
//!
//! Needs `node`, or what `NODE` names; where there is none the test says so and passes, unless `NODE` is set.

use std::f64::consts::TAU;
use std::io::Write;
use std::process::{Command, Stdio};

use dh_symbolic::render::code::javascript::script;
use dh_tests::engine::{Interpreter, spec};
use dh_tests::naive::Matrix;
use dh_tests::sample::{Random, joint_vectors};
use serde_json::{Value, json};

use crate::closure::{Found, arms, miss, random_joints};

/// How far JavaScript may be from Rust: over the size of the numbers.
const AGREE: f64 = 1e-12;
/// The same for joint values that are solved for: near a singular pose they are as much less exact as the arm is nearly singular.
const SOLVED: f64 = 1e-10;

/// What node answers; `None` where there is no node.
fn node(input: &Value) -> Option<Value> {
    let program = concat!(env!("CARGO_MANIFEST_DIR"), "/javascript.js");
    let asked = std::env::var_os("NODE");
    let started = Command::new(asked.clone().unwrap_or_else(|| "node".into()))
        .arg(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let mut child = match started {
        Ok(child) => child,
        Err(error) => {
            assert!(asked.is_none(), "what NODE names does not start: {error}");
            eprintln!("skipped: there is no node to run JavaScript ({error})");
            return None;
        }
    };
    let mut pipe = child.stdin.take().expect("a pipe");
    let text = input.to_string();
    let writer = std::thread::spawn(move || pipe.write_all(text.as_bytes()));
    let done = child.wait_with_output().expect("node ends");
    writer.join().expect("a thread").expect("node reads");
    assert!(done.status.success(), "node failed");
    Some(serde_json::from_slice(&done.stdout).expect("JSON"))
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap_or(f64::NAN)],
    }
}

fn compare(what: &str, ours: &[f64], theirs: &Value) {
    let theirs = numbers(theirs);
    assert_eq!(ours.len(), theirs.len(), "{what}");
    let size = ours.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in ours.iter().zip(&theirs) {
        assert!((a - b).abs() <= AGREE * size, "{what}: {a} in Rust, {b} in JavaScript");
    }
}

fn rows(matrix: &Matrix) -> Vec<f64> {
    matrix[..3].concat()
}

/// Every solution of one list stands in the other one.
fn same_solutions(what: &str, rust: &Found, answer: &Value) {
    let list = answer["solutions"].as_array().expect("a list");
    let theirs: Vec<Vec<f64>> = list.iter().map(|s| numbers(&s["q"])).collect();
    assert_eq!(rust.q.len(), theirs.len(), "{what}: {:?} in Rust, {theirs:?} in JavaScript", rust.q);
    for (q, free) in rust.q.iter().zip(&rust.free) {
        let near = |other: &&Vec<f64>| q.iter().zip(*other).all(|(a, b)| (a - b).abs() < SOLVED * (1.0 + a.abs()));
        assert!(*free || theirs.iter().any(|t| near(&t)), "{what}: {q:?} is not among {theirs:?}");
    }
}

#[test]
fn javascript_agrees_with_rust() {
    let sources = generated_examples::source::all().expect("the examples can be read");
    let arms = arms();
    let mut input = Vec::new();
    let mut work = Vec::new();
    for (arm, source) in arms.iter().zip(&sources) {
        let spec = spec(&source.body);
        let interpreter = Interpreter::new(&spec);
        let mut random = Random::new(11);
        let mut cases = joint_vectors(&spec, 0);
        let special = cases.len();
        cases.extend((0..60).map(|_| random_joints(&spec, &mut random)));
        let names = interpreter.chain.parameters.iter().map(|p| p.name.clone());
        let parameters: serde_json::Map<String, Value> =
            names.map(|n| (n.clone(), json!((interpreter.fields)(&n)))).collect();
        let script = script(&interpreter.chain).expect("proven programs");
        input.push(json!({ "script": script, "parameters": parameters, "cases": cases }));
        work.push((arm, spec.settings.task, interpreter.engine(), cases, special));
    }
    let Some(answers) = node(&Value::Array(input)) else { return };
    for ((arm, task, engine, cases, special), answers) in work.iter().zip(answers.as_array().expect("a list")) {
        for (i, (q, answer)) in cases.iter().zip(answers.as_array().expect("a list")).enumerate() {
            let what = format!("{} at {q:?}", arm.module);
            compare(&what, &rows(&(engine.pose)(q)), &answer["pose"]);
            compare(&what, &(engine.frames)(q).iter().flat_map(rows).collect::<Vec<_>>(), &answer["frames"]);
            let columns = (engine.jacobian)(q);
            let by_rows: Vec<f64> = (0..6).flat_map(|r| columns.iter().map(move |c| c[r])).collect();
            compare(&what, &by_rows, &answer["jacobian"]);
            let target = (arm.forward)(q);
            let rust = (arm.inverse)(&target, q);
            // At the special ones rounding decides how singular a pose is: there may be more points of one self-motion.
            if i >= *special {
                same_solutions(&what, &rust, answer);
            }
            let list = answer["solutions"].as_array().expect("a list");
            assert_eq!(list.is_empty(), rust.q.is_empty(), "{what}");
            for solution in list.iter().map(|s| numbers(&s["q"])).chain(rust.q) {
                let error = miss(*task, &(arm.forward)(&solution), &target, 1.0);
                assert!(error < 1e-8, "{what}: {solution:?} misses by {error:.1e}");
            }
        }
    }
}

/// Gears in the wrist, as in `coupled.rs`: whole turns of its rows are no whole turns of its motors.
const GEARS: &str = "pub struct Gears; convention = standard; let g: length = 0.75;
    | theta               | d    | a    | alpha  | range            |
    | q1                  | 0.4  | 0.1  | -90deg | 200deg..=560deg  |
    | 0.5*q2              | 0    | 0.5  |   0    | 0deg..=720deg    |
    | q3 - 0.5*q2 - 30deg | 0    | 0.05 | -90deg | -180deg..=180deg |
    | 2*q4                | 0.45 | 0    |  90deg | 100deg..=280deg  |
    | q5 - 2*q4           | 0    | 0    | -90deg | -200deg..=200deg |
    | q6 + g*q5           | 0.1  | 0    |   0    | -900deg..=-500deg |";

/// From motors to rows.
const ROWS: [[f64; 6]; 6] = [
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.5, 0.0, 0.0, 0.0, 0.0],
    [0.0, -0.5, 1.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 2.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, -2.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.75, 1.0],
];

#[test]
fn geared_motors_come_into_their_ranges_in_javascript_too() {
    let interpreter = Interpreter::new(&spec(GEARS));
    let ranges = [[200.0, 560.0], [0.0, 720.0], [-180.0, 180.0], [100.0, 280.0], [-200.0, 200.0], [-900.0, -500.0]];
    let ranges = ranges.map(|r| r.map(f64::to_radians));
    let mut random = Random::new(31);
    let any =
        |[least, greatest]: [f64; 2], random: &mut Random| least + 0.5 * (random.signed() + 1.0) * (greatest - least);
    let cases: Vec<Vec<f64>> = (0..80).map(|_| ranges.iter().map(|r| any(*r, &mut random)).collect()).collect();
    let script = script(&interpreter.chain).expect("proven programs");
    let input = json!([{ "script": script, "parameters": { "g": 0.75 }, "cases": cases }]);
    let Some(answers) = node(&input) else { return };
    let apart = |a: &[f64], b: &[f64]| {
        let row = |k: &[f64; 6]| {
            let turn: f64 = k.iter().zip(a.iter().zip(b)).map(|(k, (a, b))| k * (b - a)).sum();
            (turn - TAU * (turn / TAU).round()).abs()
        };
        ROWS.iter().map(row).fold(0.0, f64::max)
    };
    for (q, answer) in cases.iter().zip(answers[0].as_array().expect("a list")) {
        let list: Vec<Vec<f64>> =
            answer["solutions"].as_array().expect("a list").iter().map(|s| numbers(&s["q"])).collect();
        let inside = |s: &[f64]| s.iter().zip(&ranges).all(|(x, [l, g])| (l - 1e-8..=g + 1e-8).contains(x));
        assert!(list.iter().any(|s| inside(s) && apart(s, q) < 1e-6), "{q:?} is not among {list:?}");
        for (i, s) in list.iter().enumerate() {
            assert!(!list[..i].iter().any(|t| apart(s, t) < 1e-4), "{q:?}: twice {s:?} in {list:?}");
            let (ours, wanted) = (interpreter.run(&interpreter.forward.pose, s), numbers(&answer["pose"]));
            let columns: Vec<f64> = (0..12).map(|i| wanted[4 * (i % 3) + i / 3]).collect();
            assert!(ours.iter().zip(&columns).all(|(a, b)| (a - b).abs() < 1e-9), "{q:?}: {s:?} misses");
        }
    }
}
