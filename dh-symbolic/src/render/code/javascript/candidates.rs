//! The plan as nested loops over the roots of its steps, as the Rust backend writes them.

use super::text::string;
use crate::chain::{Chain, Scalar};
use crate::planner::StepKind;
use crate::program::{Inverse, Solver, Value};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::drive::{chosen, motors};
use crate::render::code::literal;
use crate::render::code::steps::{combination, identifier, inputs, is_first, joints_of, reported};

/// The method that runs the plan: it calls `take` with every candidate.
pub(super) fn candidates(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let reach = literal(plan.axes.reach, Scalar::F64);
    let outputs: Vec<Value> = inverse.solvers.iter().flat_map(Solver::values).collect();
    let scale = (Scalar::F64, 1.0 / plan.axes.reach);
    let mut body = Body::in_stages(Dialect::JavaScript, chain, &inverse.graph, outputs, scale, inputs(inverse));
    let depths = inverse.depths();
    let mut out = String::from("let attempt = new Attempt(), free = [];\n");
    let mut angles: Vec<String> = Vec::new();
    let emit = |body: &mut Body<'_>, depth: usize, out: &mut String| {
        body.statements(&depths, depth, &[]);
        for line in body.take_lines() {
            out.push_str(&line);
            out.push('\n');
        }
    };
    let names = |k: usize| {
        let symbols = plan.knowledge.known.get(k).map(|k| k.symbols);
        symbols.map(|s| s.map(|s| identifier(plan.knowledge.ring.symbol_name(s)))).unwrap_or_default()
    };
    for (i, k) in plan.knowledge.known.iter().take(plan.given).enumerate() {
        let [c, s] = names(i);
        let value = chosen(chain);
        out.push_str(&format!("const a{i} = {value};\n"));
        match k.turns {
            true => out.push_str(&format!("const {c} = Math.cos(a{i}), {s} = Math.sin(a{i});\n")),
            false => out.push_str(&format!("const {c} = a{i} / {reach};\n")),
        }
        angles.push(format!("a{i}"));
    }
    for depth in 0..=plan.given {
        emit(&mut body, depth, &mut out);
    }
    let mut depth = plan.given;
    for (i, (solver, step)) in inverse.solvers.iter().zip(&plan.steps).enumerate() {
        let unknown: Vec<String> = step.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
        let turns = solver.finds.first().and_then(|k| plan.knowledge.known.get(*k)).is_some_and(|k| k.turns);
        let call = call((i, turns, solver), &body);
        out.push_str(&format!("// {}\nconst r{i} = {};\n", unknown.join(", "), call.text));
        out.push_str(&format!("if (r{i}.roots.length === 0) {{\n{}\n}}\n", note(chain, inverse, i, &body)));
        let joints: Vec<String> =
            step.unknown.iter().flat_map(|f| joints_of(f, plan.axes.real)).map(|j| j.to_string()).collect();
        let outer = if i == 0 { "free".to_string() } else { format!("free{}", i - 1) };
        out.push_str(&format!(
            "if (r{i}.outcome === FREE) {{\nattempt.degenerate = true;\n}}\n\
             const free{i} = r{i}.outcome === FREE ? [...{outer}, {}] : {outer};\n",
            joints.join(", ")
        ));
        let roots = match &call.representative {
            Some(representative) => format!("orIfFree(r{i}, {representative})"),
            None => format!("r{i}.roots"),
        };
        let symbols: Vec<[String; 2]> = solver.finds.iter().map(|k| names(*k)).collect();
        let patterns: Vec<String> = solver
            .finds
            .iter()
            .zip(&symbols)
            .map(|(k, [c, s])| {
                let turns = plan.knowledge.known.get(*k).is_some_and(|k| k.turns);
                if turns { format!("[{c}, {s}]") } else { c.clone() }
            })
            .collect();
        let pattern = match patterns.as_slice() {
            [one] => one.clone(),
            many => format!("[{}]", many.join(", ")),
        };
        out.push_str(&format!("for (const [i{i}, {pattern}] of {roots}.entries()) {{\n"));
        for (k, [c, s]) in solver.finds.iter().zip(&symbols) {
            if plan.knowledge.known.get(*k).is_some_and(|k| k.turns) {
                out.push_str(&format!("const a{k} = Math.atan2({s}, {c});\n"));
            } else {
                out.push_str(&format!("const a{k} = {c} * {reach};\n"));
            }
            angles.push(format!("a{k}"));
            depth += 1;
        }
        for d in depth + 1 - solver.finds.len()..=depth {
            emit(&mut body, d, &mut out);
        }
    }
    let x: Vec<String> = inverse.joints.iter().map(|form| combination(form, &angles)).collect();
    let free = inverse.solvers.len().checked_sub(1).map_or("free".to_string(), |i| format!("free{i}"));
    out.push_str(&format!("take([{}], {}, {free});\n", motors(chain, &x).join(", "), branch(inverse)));
    out.push_str(&"}\n".repeat(inverse.solvers.len()));
    out.push_str("return attempt;\n");
    let fields = if out.contains("self.") { "const self = this.parameters;\n" } else { "" };
    format!(
        "// Runs the plan for the frame t (lengths over the reach): calls `take` with every candidate.\n\
         candidates(t, given, pick, take) {{\n{fields}{out}}}\n"
    )
}

/// Which root each step took, and the names that robot controllers use.
fn branch(inverse: &Inverse) -> String {
    let mut parts = Vec::new();
    let choices: Vec<String> =
        inverse.plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1).map(|(i, _)| format!("i{i}")).collect();
    for (i, step) in inverse.plan.steps.iter().enumerate() {
        let (part, first, second) = match inverse.part(i).filter(|_| step.roots > 1) {
            Some(0) => ("shoulder", "left", "right"),
            Some(1) => ("elbow", "up", "down"),
            Some(_) => ("wrist", "no flip", "flip"),
            None => continue,
        };
        let is_first = is_first(inverse, i, "===");
        parts.push(format!("{part}: {is_first} ? \"{first}\" : \"{second}\""));
    }
    parts.push(format!("steps: [{}]", choices.join(", ")));
    format!("{{ {} }}", parts.join(", "))
}

/// How a step without roots is reported.
fn note(chain: &Chain, inverse: &Inverse, i: usize, body: &Body<'_>) -> String {
    let report = reported(chain, inverse, i, body);
    let free = if i == 0 { "free".to_string() } else { format!("free{}", i - 1) };
    let (name, unit) = (string(&report.name), string(report.unit));
    match report.law {
        Some((base, rest, grows)) => {
            format!("attempt.noteDistance(r{i}, {free}, {name}, [{base}, {rest}], {grows}, {}, {unit});", report.scale)
        }
        None => format!("attempt.note(r{i}, {free}, {name}, {}, {unit});", report.scale),
    }
}

/// A call of a kernel.
struct Call {
    text: String,
    /// What a free unknown takes; `None` where the kernel knows.
    representative: Option<String>,
}

fn call((step, turns, solver): (usize, bool, &Solver), body: &Body<'_>) -> Call {
    let value = |r: usize, i: usize| solver.rows.get(r).and_then(|row| row.get(i)).copied();
    let v = |r: usize, i: usize| value(r, i).map_or("0".into(), |v| body.value(v));
    let minus = |r: usize, i: usize| value(r, i).map_or("0".into(), |v| body.negative(v));
    let list = |r: usize, n: usize| (0..n).map(|i| v(r, i)).collect::<Vec<_>>().join(", ");
    let (angle, length) = (Some(format!("pick.angle({step})")), Some(format!("pick.length({step})")));
    let pair = |first: &Option<String>| {
        format!("[{}], [{}], [{}, pick.angle({})]", list(0, 9), list(1, 9), first.clone().unwrap_or_default(), step + 1)
    };
    let (text, representative) = match solver.kind {
        StepKind::Linear => (format!("solveQuadratic(0, {}, NOISE)", list(0, 2)), length),
        StepKind::Quadratic => (format!("solveQuadratic({}, NOISE)", list(0, 3)), length),
        StepKind::HalfTurn if solver.rows.len() == 2 => {
            (format!("solveHalfTurn([{}], [{}], NOISE)", list(0, 2), list(1, 2)), angle)
        }
        StepKind::HalfTurn => (format!("solveSinCos({}, 0, NOISE)", list(0, 2)), angle),
        StepKind::SinCos => (format!("solveSinCos({}, {}, NOISE)", list(0, 2), minus(0, 2)), angle),
        StepKind::AtanPair if solver.rows.len() == 2 => {
            let rows: Vec<String> = (0..2).map(|r| format!("{}, {}", list(r, 2), minus(r, 2))).collect();
            (format!("solvePair({}, NOISE)", rows.join(", ")), angle)
        }
        StepKind::AtanPair => {
            let rows: Vec<String> =
                (0..solver.rows.len()).map(|r| format!("[{}, {}]", list(r, 2), minus(r, 2))).collect();
            (format!("solveMany([{}], NOISE)", rows.join(", ")), angle)
        }
        StepKind::SecondHarmonic => {
            let (c, s) = (format!("[{}, {}]", v(0, 1), v(0, 3)), format!("[{}, {}]", v(0, 2), v(0, 4)));
            (format!("new TrigPoly({}, {c}, {s}).roots(NOISE)", v(0, 0)), angle)
        }
        StepKind::Bilinear => (format!("solveBilinear({}, NOISE)", pair(&angle)), None),
        StepKind::SlideAndTurn => (format!("solveLengthAndAngle({}, NOISE)", pair(&length)), None),
        // The elimination is not printed: see `Solver::of`.
        StepKind::Choose | StepKind::General => ("found(FREE)".to_string(), if turns { angle } else { length }),
    };
    Call { text, representative }
}
