//! The library's surface: formulas of every example in numbers, beside plain 4x4 products; derivatives as slopes; errors.

use dh_symbolic::chain::{Chain, Role};
use dh_symbolic::{EvalError, Robot};
use dh_tests::engine::{fields, spec};
use dh_tests::naive::Arm;
use dh_tests::sample::joint_vectors;

/// A step for differences of numbers, and how far they may be off a derivative, lengths over the reach.
const STEP: f64 = 1e-5;
const SLOPE: f64 = 1e-8;

/// The coupled, shifted, obliquely twisted arm that no example is.
const ODD: &str = "
pub struct Odd;
convention = standard;
let beta: angle = 20deg;
let offset: length = 0.2m;
let p: length = 0.5;
base = tz(0.3) * ry(45deg);
| theta              | d           | a      | alpha  |
|--------------------|-------------|--------|--------|
| q1 + 30deg         | 0           | 0.1    | beta   |
| q2 - q1            | 0.25        | offset | 60deg  |
| 0                  | p*(q3 - q2) | 0      | beta   |
| q4 + approx 0.3rad | 0           | 0.07   | -45deg |
";

fn tables() -> Vec<(String, String)> {
    let sources = generated_examples::source::all().expect("the examples can be read");
    let examples = sources.into_iter().map(|s| (s.module, s.body));
    examples.chain([("odd".to_string(), ODD.to_string())]).collect()
}

/// `q1`, `q2`, ... with their values, then the fields with theirs.
fn values<'a>(names: &'a [String], q: &[f64], list: &'a [(String, f64)]) -> Vec<(&'a str, f64)> {
    let joints = names.iter().map(String::as_str).zip(q.iter().copied());
    joints.chain(list.iter().map(|(n, x)| (n.as_str(), *x))).collect()
}

#[test]
fn poses_jacobians_and_derivatives_are_those_of_the_plain_product() {
    for (module, body) in tables() {
        let robot = Robot::parse(&body).unwrap_or_else(|e| panic!("{e}"));
        let spec = spec(&body);
        let chain = Chain::new(spec.clone());
        let field = fields(&chain);
        let arm = Arm::new(&spec, &field);
        let fields: Vec<(String, f64)> = chain
            .parameters
            .iter()
            .filter(|p| p.declared && matches!(p.role, Role::Field(_)))
            .map(|p| (p.name.clone(), field(&p.name)))
            .collect();
        let names: Vec<String> = (1..=robot.dof()).map(|k| format!("q{k}")).collect();
        let (pose, jacobian) = (robot.pose(), robot.jacobian());
        let slopes: Vec<_> = fields.iter().map(|(name, _)| pose.diff(name)).collect();
        for q in joint_vectors(&spec, 4) {
            let at = values(&names, &q, &fields);
            let (reach, plain) = (arm.reach(&q), arm.pose(&q));
            let got = robot.forward(&at).unwrap_or_else(|e| panic!("{module}: {e}"));
            for i in 0..3 {
                for j in 0..4 {
                    assert!((got[i][j] - plain[i][j]).abs() < 1e-12 * (1.0 + reach), "{module} ({i}, {j}) at {q:?}");
                }
            }
            let got = jacobian.eval(&at).unwrap_or_else(|e| panic!("{module}: {e}"));
            for (k, column) in arm.jacobian_from_slopes(&q).iter().enumerate() {
                for i in 0..6 {
                    assert!((got[i][k] - column[i]).abs() < 1e-12 * (1.0 + reach), "{module} J({i}, {k}) at {q:?}");
                }
            }
            for ((name, x), slope) in fields.iter().zip(&slopes) {
                let step = STEP * if x.abs() > 0.0 { x.abs() } else { 1.0 };
                let moved = |by: f64| Arm::new(&spec, &|n: &str| field(n) + if n == name { by } else { 0.0 }).pose(&q);
                let (more, less) = (moved(step), moved(-step));
                let got = slope.eval(&at).unwrap_or_else(|e| panic!("{module}: {e}"));
                for i in 0..3 {
                    for j in 0..4 {
                        let want = (more[i][j] - less[i][j]) / (2.0 * step);
                        let size = 1.0 + want.abs() + reach / x.abs().max(step);
                        assert!((got[i][j] - want).abs() < SLOPE * size, "{module} d({i}, {j})/d{name} at {q:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn names_without_a_value_and_names_that_are_none() {
    let robot = Robot::parse(&ODD.replace("= 20deg", "")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(robot.names()[..5], ["q1", "q2", "q3", "q4", "beta"]);
    let all: Vec<(&str, f64)> = ["q1", "q2", "q4", "beta"].map(|n| (n, 0.1)).to_vec();
    let missing = |names: &[&str]| Err(EvalError::Missing(names.iter().map(|n| (*n).to_string()).collect()));
    assert_eq!(robot.forward(&all), missing(&["q3"]));
    assert_eq!(robot.transform(0, 1).eval(&[("q2", 1.0)]).err(), missing(&["q1", "beta"]).err());
    assert_eq!(robot.forward(&[("q9", 1.0)]), Err(EvalError::Unknown("q9".into())));
    assert!(robot.pose().diff("q9").entry(0, 3).is_zero());
}

#[test]
fn equality_is_decided_between_formulas_of_one_table() {
    let (a, b) = (Robot::parse(ODD).unwrap(), Robot::parse(ODD).unwrap());
    assert_eq!(a.pose(), b.pose());
    let t = a.transform(0, 2);
    assert_eq!(&t * &a.transform(2, 0), a.transform(3, 3));
    assert_eq!(t.entry(0, 3) - t.entry(0, 3), t.entry(3, 0));
    let other = Robot::parse(&ODD.replace("beta", "gamma")).unwrap();
    assert!(a.pose() != other.pose());
    assert_eq!((a.get_transform(0, 5), t.get(4, 0)), (None, None));
}

#[test]
fn all_mistakes_of_a_table_with_their_places() {
    let broken = ODD.replace("beta   |\n| q2", "90 |\n| q2").replace("0.25 ", "d9 ").replace("standard", "classic");
    let error = Robot::parse_file("arm.dh", &broken).unwrap_err();
    let places: Vec<(usize, usize)> = error.mistakes().iter().map(|m| (m.line, m.column)).collect();
    assert_eq!(places, [(3, 14), (10, 47), (11, 24)], "{error}");
    assert!(error.mistakes()[0].help.as_ref().is_some_and(|h| h.contains("`standard`")), "{error}");
    let drawn = error.to_string();
    assert!(drawn.contains("--> arm.dh:3:14") && drawn.contains("^^^^^^^") && drawn.contains("3 errors"), "{drawn}");
    for text in ["", "|", "pub struct", "prove { x }", "\u{0}", "| 90° |", "(((", "struct A; convention = modified;"] {
        assert!(!Robot::parse(text).unwrap_err().mistakes().is_empty(), "{text}");
    }
}

#[test]
fn claims_and_refusals() {
    let robot = Robot::parse(ODD).unwrap();
    assert!(robot.check("T(0,1).pz = 0; T(0,1).px = a1*stheta1").is_err());
    let error = robot.check("T(0,1).pz = a1").unwrap_err();
    assert_eq!((error.mistakes()[0].line, error.mistakes().len()), (1, 1), "{error}");
    for text in ["", ";", "T(0,9) = 0", "T(0,1).pz", "((", "x = 1 ="] {
        assert!(text.trim_matches(';').is_empty() || robot.check(text).is_err(), "{text}");
    }
    let rows: String = (1..=7).map(|k| format!("| q{k} | 0.3 | 0 | {}90deg |\n", ["", "-"][k % 2])).collect();
    let seven = Robot::parse(&format!("struct A; convention = standard;\n| theta | d | a | alpha |\n{rows}")).unwrap();
    let error = seven.plan().unwrap_err();
    assert_eq!((error.mistakes()[0].line, error.mistakes()[0].column), (1, 8), "{error}");
    assert_eq!(seven.verify().unwrap_err(), error);
    assert!(robot.verify().is_err() == robot.plan().is_err());
}

/// A robot can be shared between threads.
#[test]
fn robots_and_formulas_can_be_sent() {
    fn sent<T: Send + Sync>() {}
    sent::<Robot>();
    sent::<dh_symbolic::Formula>();
    sent::<dh_symbolic::Matrix>();
    sent::<dh_symbolic::TableError>();
}
