//! The plan as nested loops over the roots of its steps.

use crate::chain::{Chain, Scalar};
use crate::planner::StepKind;
use crate::program::{Inverse, NOISE, Solver, Value};
use crate::render::code::body::Body;
use crate::render::code::drive::motors;
use crate::render::code::literal;
use crate::render::code::steps::{
    Reported, branch, combination, identifier, inputs, joints_of, known_beforehand, reported,
};

/// The private function that runs the plan.
pub(super) fn candidates(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let n = chain.dof();
    let reach = literal(plan.axes.reach, Scalar::F64);
    let given = if chain.redundant.is_some() { "given: f64, " } else { "" };
    let outputs: Vec<Value> = inverse.solvers.iter().flat_map(Solver::values).collect();
    let mut body = Body::staged(chain, &inverse.graph, outputs, Scalar::F64, 1.0 / plan.axes.reach, inputs(inverse));
    let depths = inverse.depths();
    let attempt = if chain.scalar == Scalar::F32 { "single" } else { "new" };
    let mut out = format!(
        "/// Runs the plan: calls `found` with every candidate.\n\
         fn candidates(&self, t: &::dh_robot::runtime::Pose, {given}pick: ::dh_robot::runtime::Pick, found: &mut dyn FnMut([f64; {n}], ::dh_robot::Branch, ::dh_robot::FreeJoints)) \
         -> ::dh_robot::runtime::Attempt {{\n\
         let mut attempt = ::dh_robot::runtime::Attempt::{attempt}();\nlet free = ::dh_robot::FreeJoints::NONE;\n"
    );
    let mut angles: Vec<String> = Vec::new();
    let emit = |body: &mut Body<'_>, depth: usize, out: &mut String| {
        body.statements(&depths, depth, &[]);
        for line in body.take_lines() {
            out.push_str(&line);
            out.push('\n');
        }
    };
    out.push_str(&known_beforehand(chain, inverse));
    angles.extend((0..plan.given).map(|i| format!("a{i}")));
    // What needs nothing, or only what is given, stands before the first loop.
    for depth in 0..=plan.given {
        emit(&mut body, depth, &mut out);
    }
    let mut depth = plan.given;
    for (i, (solver, step)) in inverse.solvers.iter().zip(&plan.steps).enumerate() {
        let names: Vec<String> = step.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
        out.push_str(&format!("// {}\n", names.join(", ")));
        let turns = solver.finds.first().is_some_and(|k| plan.knowledge.known[*k].turns);
        let call = call((i, turns, solver), &body, inverse);
        out.push_str(&format!("let r{i} = {};\n", call.text));
        out.push_str(&format!("if !r{i}.is_regular() {{ {} }}\n", note(chain, inverse, i, &body)));
        let bits: Vec<String> =
            step.unknown.iter().flat_map(|f| joints_of(f, plan.axes.real)).map(|j| j.to_string()).collect();
        out.push_str(&format!(
            "let free = if r{i}.is_free() {{ attempt.degenerate = true; free.union(::dh_robot::FreeJoints::of(&[{}])) }} else {{ free }};\n",
            bits.join(", ")
        ));
        let symbols: Vec<[String; 2]> = solver
            .finds
            .iter()
            .map(|k| plan.knowledge.known[*k].symbols.map(|s| identifier(plan.knowledge.ring.symbol_name(s))))
            .collect();
        let pattern = (call.pattern)(&symbols);
        let or =
            if call.representative.is_empty() { "".into() } else { format!(".or_if_free({})", call.representative) };
        out.push_str(&format!("for (i{i}, &{pattern}) in r{i}{or}.iter().enumerate() {{\n"));
        for (k, [c, s]) in solver.finds.iter().zip(&symbols) {
            let form = &plan.knowledge.known[*k];
            if form.turns {
                out.push_str(&format!("let a{k} = ::dh_robot::runtime::atan2({s}, {c});\n"));
            } else {
                out.push_str(&format!("let a{k} = {c} * {reach};\n"));
            }
            angles.push(format!("a{k}"));
            depth += 1;
        }
        for d in depth + 1 - solver.finds.len()..=depth {
            emit(&mut body, d, &mut out);
        }
    }
    let x: Vec<String> = inverse.joints.iter().map(|form| combination(form, &angles)).collect();
    out.push_str(&format!("let branch = {};\n", branch(inverse)));
    out.push_str(&format!("found([{}], branch, free);\n", motors(chain, &x).join(", ")));
    out.push_str(&"}\n".repeat(inverse.solvers.len()));
    out.push_str("attempt\n}\n");
    out
}

/// The statement that reports a step without roots.
fn note(chain: &Chain, inverse: &Inverse, i: usize, body: &Body<'_>) -> String {
    let Reported { name, scale, unit, law } = reported(chain, inverse, i, body);
    match law {
        Some((base, rest, grows)) => {
            format!("attempt.note_law(r{i}.outcome, free, \"{name}\", [{base}, {rest}], {grows}, {scale}, \"{unit}\");")
        }
        None => format!("attempt.note(r{i}.outcome, free, \"{name}\", {scale}, \"{unit}\");"),
    }
}

/// A call of a kernel.
struct Call {
    text: String,
    /// What a free unknown takes; empty where the kernel knows.
    representative: String,
    pattern: fn(&[[String; 2]]) -> String,
}

fn call((step, turns, solver): (usize, bool, &Solver), body: &Body<'_>, inverse: &Inverse) -> Call {
    let noise = format!("{NOISE:e}");
    let v = |r: usize, i: usize| solver.rows.get(r).and_then(|row| row.get(i)).map_or("0.0".into(), |v| body.value(*v));
    let minus =
        |r: usize, i: usize| solver.rows.get(r).and_then(|row| row.get(i)).map_or("0.0".into(), |v| body.negative(*v));
    let list = |r: usize, n: usize| (0..n).map(|i| v(r, i)).collect::<Vec<_>>().join(", ");
    let angle: fn(&[[String; 2]]) -> String = |s| format!("[{}, {}]", s[0][0], s[0][1]);
    let length: fn(&[[String; 2]]) -> String = |s| s[0][0].clone();
    let picked = format!("pick.angle({step})");
    let picked_length = format!("pick.length({step})");
    let (text, representative, pattern) = match solver.kind {
        StepKind::Linear => (
            format!("::dh_robot::runtime::solve_quadratic(0.0, {}, {}, {noise})", v(0, 0), v(0, 1)),
            picked_length,
            length,
        ),
        StepKind::Quadratic => (
            format!("::dh_robot::runtime::solve_quadratic({}, {}, {}, {noise})", v(0, 0), v(0, 1), v(0, 2)),
            picked_length,
            length,
        ),
        StepKind::HalfTurn if solver.rows.len() == 2 => {
            let row = |r: usize| format!("[{}, {}]", v(r, 0), v(r, 1));
            (format!("::dh_robot::runtime::solve_half_turn({}, {}, {noise})", row(0), row(1)), picked, angle)
        }
        StepKind::HalfTurn => {
            (format!("::dh_robot::runtime::solve_sincos({}, {}, 0.0, {noise})", v(0, 0), v(0, 1)), picked, angle)
        }
        StepKind::SinCos => (
            format!("::dh_robot::runtime::solve_sincos({}, {}, {}, {noise})", v(0, 0), v(0, 1), minus(0, 2)),
            picked,
            angle,
        ),
        StepKind::AtanPair if solver.rows.len() == 2 => (
            format!(
                "::dh_robot::runtime::solve_pair({}, {}, {}, {}, {}, {}, {noise})",
                v(0, 0),
                v(0, 1),
                minus(0, 2),
                v(1, 0),
                v(1, 1),
                minus(1, 2)
            ),
            picked,
            angle,
        ),
        StepKind::AtanPair => {
            let rows: Vec<String> =
                (0..solver.rows.len()).map(|r| format!("[{}, {}, {}]", v(r, 0), v(r, 1), minus(r, 2))).collect();
            (format!("::dh_robot::runtime::solve_many(&[{}], {noise})", rows.join(", ")), picked, angle)
        }
        StepKind::SecondHarmonic => (
            format!(
                "::dh_robot::runtime::TrigPoly::<2> {{ constant: {}, cos: [{}, {}], sin: [{}, {}] }}.roots::<4>({noise})",
                v(0, 0),
                v(0, 1),
                v(0, 3),
                v(0, 2),
                v(0, 4)
            ),
            picked,
            angle,
        ),
        StepKind::Bilinear => (
            format!(
                "::dh_robot::runtime::solve_bilinear_choosing(&[{}], &[{}], [{picked}, pick.angle({})], {noise})",
                list(0, 9),
                list(1, 9),
                step + 1
            ),
            String::new(),
            (|s| format!("[[{}, {}], [{}, {}]]", s[0][0], s[0][1], s[1][0], s[1][1])) as fn(&[[String; 2]]) -> String,
        ),
        StepKind::SlideAndTurn => (
            format!(
                "::dh_robot::runtime::solve_length_squared_and_angle_choosing(&[{}], &[{}], ({picked_length}, pick.angle({})), {noise})",
                list(0, 9),
                list(1, 9),
                step + 1
            ),
            String::new(),
            (|s| format!("({}, [{}, {}])", s[0][0], s[1][0], s[1][1])) as fn(&[[String; 2]]) -> String,
        ),
        StepKind::Choose if !turns => {
            (format!("::dh_robot::runtime::solve_quadratic(0.0, 0.0, 0.0, {noise})"), picked_length, length)
        }
        StepKind::Choose => (format!("::dh_robot::runtime::solve_sincos(0.0, 0.0, 0.0, {noise})"), picked, angle),
        StepKind::General => {
            let poses: Vec<String> = (0..7)
                .map(|r| {
                    let row = |i: usize| format!("[{}, {}, {}, {}]", v(r, i), v(r, 3 + i), v(r, 6 + i), v(r, 9 + i));
                    format!("[{}, {}, {}]", row(0), row(1), row(2))
                })
                .collect();
            let cuts = inverse.choices.map(|c| format!("::dh_robot::runtime::Choice::new({c})")).join(", ");
            (
                format!(
                    "::dh_robot::runtime::General6R::with_slides(&[{}], &{:?}, [{cuts}]).find(&{})",
                    poses[..6].join(", "),
                    inverse.slides,
                    poses[6]
                ),
                "[[1.0, 0.0]; 6]".into(),
                (|s| {
                    // A displacement stands in both places, and a name may be bound once.
                    let known = s.iter().map(|[c, s]| if c == s { format!("[{c}, _]") } else { format!("[{c}, {s}]") });
                    let all: Vec<String> = known.chain((s.len()..6).map(|_| "_".to_string())).collect();
                    format!("[{}]", all.join(", "))
                }) as fn(&[[String; 2]]) -> String,
            )
        }
    };
    Call { text, representative, pattern }
}
