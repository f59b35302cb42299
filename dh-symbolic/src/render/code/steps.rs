//! What both backends say of a plan's steps: names, sums of angles, branches, and what is reported where a step has no root.

use super::body::Body;
use super::drive::chosen;
use super::literal;
use crate::algebra::Symbol;
use crate::chain::{Chain, Scalar};
use crate::planner::{Form, StepKind};
use crate::program::Inverse;

/// Names of the target's entries and of known combinations.
pub(in crate::render) fn inputs(inverse: &Inverse) -> Vec<(Symbol, String)> {
    let mut inputs: Vec<(Symbol, String)> = Vec::new();
    for (i, s) in inverse.target.iter().enumerate() {
        let (row, column) = if i < 9 { (i / 3, i % 3) } else { (i - 9, 3) };
        inputs.push((*s, format!("t[{row}][{column}]")));
    }
    for k in &inverse.plan.knowledge.known {
        for s in k.symbols {
            inputs.push((s, identifier(inverse.plan.knowledge.ring.symbol_name(s))));
        }
    }
    inputs
}

/// The statements for what the caller gives: its coordinate `a0`, cosine and sine (or the length over the reach).
pub(super) fn known_beforehand(chain: &Chain, inverse: &Inverse) -> String {
    let (plan, mut out) = (&inverse.plan, String::new());
    for (i, k) in plan.knowledge.known.iter().take(plan.given).enumerate() {
        let [c, s] = k.symbols.map(|s| identifier(plan.knowledge.ring.symbol_name(s)));
        let value = chosen(chain);
        out.push_str(&format!("let a{i} = {value};\n"));
        out.push_str(&if k.turns {
            format!("let ({s}, {c}) = ::dh_robot::runtime::sin_cos(a{i});\n")
        } else {
            format!("let {c} = a{i} / {};\n", literal(plan.axes.reach, Scalar::F64))
        });
    }
    out
}

/// How a step without roots is reported.
pub(in crate::render) struct Reported {
    /// What it decides, and the unknowns.
    pub(in crate::render) name: String,
    /// Expression of what turns the numbers of the equation into the unit.
    pub(in crate::render) scale: String,
    /// The unit; empty for pure numbers.
    pub(in crate::render) unit: &'static str,
    /// For a law of cosines: the side of the equation without the unknown, less than the squared distance by the first; does the amplitude
    /// of the other side grow with the distance?
    pub(in crate::render) law: Option<(String, String, bool)>,
}

/// What is said of a step without roots.
pub(in crate::render) fn reported(chain: &Chain, inverse: &Inverse, i: usize, body: &Body<'_>) -> Reported {
    let (plan, solver) = (&inverse.plan, &inverse.solvers[i]);
    let step = &plan.steps[i];
    let names: Vec<String> = step.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
    let reach = literal(plan.axes.reach, Scalar::F64);
    let part = inverse.part(i).map_or("", |p| ["shoulder ", "elbow ", "wrist "][p]);
    let name = format!("{part}{}", names.join(", "));
    if let Some((base, grows)) = solver.law {
        let law = Some((body.value(base), body.negative(solver.rows[0][2]), grows));
        return Reported { name, scale: reach, unit: chain.unit.name, law };
    }
    // Two equations for a cosine and a sine whose squares do not add up to 1: a pure number.
    let length = step.kind != StepKind::AtanPair
        && step.equations.iter().any(|e| !matches!(e.scalar, crate::planner::Scalar::Rotation(..)));
    let (scale, unit) = if length { (reach, chain.unit.name) } else { ("1.0".into(), "") };
    Reported { name, scale, unit, law: None }
}

/// The condition under which the root of a step that decides a part has its first name; `equal` compares in the language at hand.
pub(in crate::render) fn is_first(inverse: &Inverse, i: usize, equal: &str) -> String {
    let names = inverse.part(i).and_then(|part| inverse.names.get(part));
    let first = names.map_or(0, |n| n.first);
    match names.and_then(|n| n.over) {
        Some(shoulder) => format!("(i{i} {equal} {first}) {equal} (i{shoulder} {equal} 0)"),
        None => format!("i{i} {equal} {first}"),
    }
}

/// Which root each step took, with the names that robot controllers use.
pub(super) fn branch(inverse: &Inverse) -> String {
    let mut out = String::from("::dh_robot::Branch::ANY");
    for (place, (i, _)) in inverse.plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1).enumerate() {
        if place < 8 {
            out.push_str(&format!(".with_step({place}, i{i})"));
        }
        let (setter, first, second) = match inverse.part(i) {
            Some(0) => ("shoulder", "Shoulder::Left", "Shoulder::Right"),
            Some(1) => ("elbow", "Elbow::Up", "Elbow::Down"),
            Some(_) => ("wrist", "Wrist::NoFlip", "Wrist::Flip"),
            None => continue,
        };
        let is_first = is_first(inverse, i, "==");
        out.push_str(&format!(
            ".with_{setter}(if {is_first} {{ ::dh_robot::{first} }} else {{ ::dh_robot::{second} }})"
        ));
    }
    out
}

pub(in crate::render) fn joints_of(form: &Form, real: usize) -> Vec<usize> {
    (0..real).filter(|k| form[*k] != 0).collect()
}

pub(in crate::render) fn combination(form: &[i8], angles: &[String]) -> String {
    let mut out = String::new();
    for (k, a) in form.iter().zip(angles).filter(|(k, _)| **k != 0) {
        let sign = match (out.is_empty(), *k < 0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        out.push_str(sign);
        if k.unsigned_abs() > 1 {
            out.push_str(&format!("{:?} * ", f64::from(k.unsigned_abs())));
        }
        out.push_str(a);
    }
    if out.is_empty() { "0.0".into() } else { out }
}

/// A symbol's name as an identifier of generated code.
pub(in crate::render) fn identifier(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_")
}
