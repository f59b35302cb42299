//! `inverse`: the plan as nested loops over the roots of its steps, and what verification needs.

use super::body::Body;
use super::lanes;
use super::{literal, scalar_name, shift_expression};
use crate::algebra::{Poly, Symbol};
use crate::chain::{Chain, Coordinate, Scalar, Task};
use crate::planner::{Form, StepKind};
use crate::program::{Forward, Inverse, NOISE, Program, Solver, Value};

/// All functions and traits of the inverse.
pub fn inverse(chain: &Chain, name: &str, forward: &Forward, inverse: &Inverse) -> String {
    let (n, f) = (chain.dof(), scalar_name(chain.scalar));
    let m = inverse.plan.max_solutions;
    let reach = literal(inverse.plan.axes.reach, Scalar::F64);
    let (target, frame, task, target_type) = target(chain, &reach);
    let given = if chain.redundant.is_some() { format!(", given: {f}") } else { String::new() };
    let pass = if chain.redundant.is_some() { ", given.into()" } else { "" };
    let fits = lanes::fits(chain, inverse);
    let fixed = chain.redundant.map_or("None".into(), |k| format!("Some(({k}, given.into()))"));
    let few = inverse.plan.few;
    let robust = format!(
        "{frame}\nlet setting = ::dh_robot::inverse::Setting {{ joints: &Self::JOINTS, reach: {reach}, few: {few}, given: {fixed} }};\n\
         let task = {task};\n\
         ::dh_robot::inverse::solve(self, setting, &task, &frame, |frame, pick, found| self.candidates(frame{pass}, pick, found))\n"
    );
    let rest = if fits { format!("{frame}\n{}", lanes::call(chain, inverse)) } else { robust.clone() };
    let mut out = format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl {name} {{\n\
         /// Greatest number of solutions of [`inverse`](Self::inverse), by the plan below.\n\
         pub const MAX_SOLUTIONS: usize = {m};\n\
         {}\n\
         #[must_use]\npub fn inverse(&self, {target}{given}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n\
         {rest}}}\n\n",
        docs(chain, inverse),
    );
    out.push_str(&candidates(chain, inverse));
    if fits {
        out.push_str(&format!(
            "/// The plan root by root, with everything that special poses need.\n#[cold]\n#[inline(never)]\n\
             fn robust(&self, {target}) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{\n{robust}}}\n"
        ));
        out.push_str(&lanes::lanes(chain, inverse));
    }
    out.push_str("}\n");
    out.push_str(&kinematics(chain, name, forward));
    if chain.redundant.is_none() {
        out.push_str(&format!(
            "impl ::dh_robot::InverseKinematics<{n}, {m}, {f}> for {name} {{\ntype Target = {target_type};\n\
             fn inverse(&self, target: &Self::Target) -> ::dh_robot::Solutions<{f}, {n}, {m}> {{ {} }}\n}}\n",
            match chain.task {
                Task::Pose | Task::Position => format!("{name}::inverse(self, target)"),
                Task::Planar => format!("{name}::inverse(self, *target)"),
                Task::Axis => format!("{name}::inverse(self, (&target.0, &target.1))"),
            }
        ));
    }
    out
}

/// Parameter, the statements that make `frame`, the task, and the target's type for the trait.
fn target(chain: &Chain, reach: &str) -> (String, String, String, String) {
    let f = scalar_name(chain.scalar);
    let refuse = "return ::dh_robot::Solutions::none(&Self::JOINTS, why)";
    let finite = |list: &str| {
        format!(
            "if !{list}.iter().all(|x: &f64| x.is_finite()) {{ return ::dh_robot::Solutions::none(&Self::JOINTS, ::dh_robot::Why::NotFinite); }}"
        )
    };
    match chain.task {
        Task::Pose => (
            format!("target: &::dh_robot::nalgebra::IsometryMatrix3<{f}>"),
            format!(
                "let frame = match ::dh_robot::inverse::frame_of(target, {reach}) {{ Ok(frame) => frame, Err(why) => {refuse} }};"
            ),
            format!("::dh_robot::ik::Task::Pose(::dh_robot::inverse::in_units(&frame, {reach}))"),
            format!("::dh_robot::nalgebra::IsometryMatrix3<{f}>"),
        ),
        Task::Position => (
            format!("target: &::dh_robot::nalgebra::Point3<{f}>"),
            format!(
                "let p: [f64; 3] = [target.x.into(), target.y.into(), target.z.into()];\n{}\n\
                 let frame = ::dh_robot::inverse::frame_of_axis(p.map(|x| x / {reach}), [0.0, 0.0, 1.0]);",
                finite("p")
            ),
            "::dh_robot::ik::Task::Position(p)".into(),
            format!("::dh_robot::nalgebra::Point3<{f}>"),
        ),
        Task::Planar => (
            format!("target: ({f}, {f}, {f})"),
            format!(
                "let (x, y, phi): (f64, f64, f64) = (target.0.into(), target.1.into(), target.2.into());\n{}\n\
                 let frame = ::dh_robot::inverse::frame_of_plane([x / {reach}, y / {reach}], phi, {});",
                finite("[x, y, phi]"),
                plane(chain)
            ),
            "::dh_robot::ik::Task::Planar(x, y, phi)".into(),
            format!("({f}, {f}, {f})"),
        ),
        Task::Axis => (
            format!("target: (&::dh_robot::nalgebra::Point3<{f}>, &::dh_robot::nalgebra::UnitVector3<{f}>)"),
            format!(
                "let p: [f64; 3] = [target.0.x.into(), target.0.y.into(), target.0.z.into()];\n\
                 let z: [f64; 3] = [target.1.x.into(), target.1.y.into(), target.1.z.into()];\n{}\n{}\n\
                 let frame = ::dh_robot::inverse::frame_of_axis(p.map(|x| x / {reach}), z);",
                finite("p"),
                finite("z")
            ),
            "::dh_robot::ik::Task::Axis(p, z)".into(),
            format!("(::dh_robot::nalgebra::Point3<{f}>, ::dh_robot::nalgebra::UnitVector3<{f}>)"),
        ),
    }
}

/// Pose of the tool of a planar arm with all joints at zero: its rotation and height are the same at every configuration up to a
/// turn about z (and slides along it).
pub(in crate::render) fn plane(chain: &Chain) -> String {
    let kinematics = crate::kinematics::Kinematics::new(chain);
    let at_zero = |p: &Poly| {
        let value = p.evaluate(&crate::algebra::Point {
            symbol: &|s| {
                if chain.joints.iter().any(|j| j.coordinate == Coordinate::Length(s)) {
                    0.0
                } else {
                    chain.nominal(crate::chain::Handle::Length(s))
                }
            },
            angle: &|v| {
                if chain.joints.iter().any(|j| j.coordinate == Coordinate::Angle(v)) {
                    0.0
                } else {
                    chain.nominal(crate::chain::Handle::Angle(v))
                }
            },
        });
        literal(value, Scalar::F64)
    };
    let t = kinematics.pose();
    let rows: Vec<String> =
        (0..3).map(|i| format!("[{}]", (0..3).map(|j| at_zero(&t.r[i][j])).collect::<Vec<_>>().join(", "))).collect();
    format!("[{}]", rows.join(", "))
}

/// The plan in the doc comment.
fn docs(chain: &Chain, inverse: &Inverse) -> String {
    let mut out = String::from(
        "/// All solutions for a target, each verified by forward kinematics; empty with a reason where there is none.\n///\n/// Plan:\n",
    );
    for (i, s) in inverse.plan.steps.iter().enumerate() {
        let names: Vec<String> =
            s.unknown.iter().map(|f| inverse.plan.knowledge.form_name(&inverse.plan.axes, f)).collect();
        let how = match s.kind {
            StepKind::Linear => "a linear equation",
            StepKind::Quadratic => "a quadratic equation",
            StepKind::HalfTurn => "a cos + b sin = 0: two values half a turn apart",
            StepKind::SinCos => "a cos + b sin = c: two values",
            StepKind::AtanPair => "two equations in its sine and cosine: one value",
            StepKind::SecondHarmonic => "a trigonometric polynomial of second degree",
            StepKind::Bilinear => "two equations, each linear in both sines and cosines (Pieper)",
            StepKind::SlideAndTurn => "two equations in a length and an angle",
            StepKind::General => "elimination of the general six-axis arm (Raghavan and Roth)",
            StepKind::Choose => "free at every pose: 0 is taken",
        };
        out.push_str(&format!("/// {}. `{}`: {how}.\n", i + 1, names.join("`, `")));
    }
    let _ = chain;
    out
}

/// Expression of each joint variable from the coordinates x.
pub(in crate::render) fn motors(chain: &Chain, x: &[String]) -> Vec<String> {
    let shifted: Vec<String> = chain
        .joints
        .iter()
        .zip(x)
        .map(|(j, x)| match shift_expression(chain, &j.shift, Scalar::F64) {
            Some(s) => format!("{x} - ({s})"),
            None => x.clone(),
        })
        .collect();
    if chain.is_direct() {
        return shifted;
    }
    // Cramer's rule, exact: q = adj(D) x / det(D).
    let (adjugate, det) = adjugate(&chain.drive);
    let value = |p: &Poly| super::body::field_polynomial(chain, p);
    let det = value(&det);
    adjugate
        .iter()
        .map(|row| {
            let parts: Vec<String> = row
                .iter()
                .zip(&shifted)
                .filter(|(k, _)| !k.is_zero())
                .map(|(k, x)| format!("({}) * ({x})", value(k)))
                .collect();
            format!("({}) / ({det})", if parts.is_empty() { "0.0".into() } else { parts.join(" + ") })
        })
        .collect()
}

/// Adjugate and determinant of a small matrix of formulas.
fn adjugate(m: &[Vec<Poly>]) -> (Vec<Vec<Poly>>, Poly) {
    let n = m.len();
    let minor = |skip_row: usize, skip_column: usize| -> Poly {
        let rows: Vec<Vec<Poly>> = (0..n)
            .filter(|i| *i != skip_row)
            .map(|i| (0..n).filter(|j| *j != skip_column).map(|j| m[i][j].clone()).collect())
            .collect();
        determinant(&rows)
    };
    let signed = |p: Poly, odd: bool| if odd { -&p } else { p };
    let adjugate = (0..n).map(|i| (0..n).map(|j| signed(minor(j, i), (i + j) % 2 == 1)).collect()).collect();
    (adjugate, determinant(m))
}

fn determinant(m: &[Vec<Poly>]) -> Poly {
    let Some(first) = m.first() else { return Poly::one() };
    first
        .iter()
        .enumerate()
        .filter(|(_, x)| !x.is_zero())
        .map(|(j, x)| {
            let rest: Vec<Vec<Poly>> = m[1..]
                .iter()
                .map(|r| r.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, p)| p.clone()).collect())
                .collect();
            let term = x * &determinant(&rest);
            if j % 2 == 1 { -&term } else { term }
        })
        .sum()
}

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

/// The private function that runs the plan.
fn candidates(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let n = chain.dof();
    let reach = literal(plan.axes.reach, Scalar::F64);
    let given = if chain.redundant.is_some() { "given: f64, " } else { "" };
    let outputs: Vec<Value> = inverse.solvers.iter().flat_map(|s| s.rows.concat()).collect();
    let mut body = Body::staged(chain, &inverse.graph, outputs, Scalar::F64, 1.0 / plan.axes.reach, inputs(inverse));
    let depths = inverse.depths();
    let mut out = format!(
        "/// Runs the plan: calls `found` with every candidate.\n\
         fn candidates(&self, t: &::dh_robot::ik::Pose, {given}pick: ::dh_robot::inverse::Pick, found: &mut dyn FnMut([f64; {n}], ::dh_robot::Branch, ::dh_robot::FreeJoints)) \
         -> ::dh_robot::inverse::Attempt {{\n\
         let mut attempt = ::dh_robot::inverse::Attempt::new();\nlet free = ::dh_robot::FreeJoints::NONE;\n"
    );
    let mut angles: Vec<String> = Vec::new();
    let emit = |body: &mut Body<'_>, depth: usize, out: &mut String| {
        body.statements(&depths, depth, &[]);
        for line in body.take_lines() {
            out.push_str(&line);
            out.push('\n');
        }
    };
    for (i, k) in plan.knowledge.known[..plan.given].iter().enumerate() {
        let joint = chain.redundant.unwrap_or(0);
        let shift = shift_expression(chain, &chain.joints[joint].shift, Scalar::F64);
        let [c, s] = k.symbols.map(|s| identifier(plan.knowledge.ring.symbol_name(s)));
        let value = shift.map_or("given".to_string(), |s| format!("given + ({s})"));
        if k.turns {
            out.push_str(&format!("let a{i} = {value};\nlet ({s}, {c}) = ::dh_robot::math::sin_cos(a{i});\n"));
        } else {
            out.push_str(&format!("let a{i} = {value};\nlet {c} = a{i} / {reach};\n"));
        }
        angles.push(format!("a{i}"));
    }
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
        out.push_str(&format!("if r{i}.roots.is_empty() {{ {} }}\n", note(chain, inverse, i, &body)));
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
                out.push_str(&format!("let a{k} = ::dh_robot::math::atan2({s}, {c});\n"));
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

/// How a step without roots is reported.
pub(in crate::render) struct Reported {
    /// What it decides, and the unknowns.
    pub(in crate::render) name: String,
    /// Expression of what turns the numbers of the equation into the unit.
    pub(in crate::render) scale: String,
    /// The unit; empty for pure numbers.
    pub(in crate::render) unit: &'static str,
    /// For a law of cosines: the squared distance, and the side of the equation without the unknown.
    pub(in crate::render) square: Option<(String, String)>,
}

/// What is said of a step without roots.
pub(in crate::render) fn reported(chain: &Chain, inverse: &Inverse, i: usize, body: &Body<'_>) -> Reported {
    let (plan, solver) = (&inverse.plan, &inverse.solvers[i]);
    let step = &plan.steps[i];
    let names: Vec<String> = step.unknown.iter().map(|f| plan.knowledge.form_name(&plan.axes, f)).collect();
    let reach = literal(plan.axes.reach, Scalar::F64);
    let part = part_of(inverse, i).map_or("", |p| ["shoulder ", "elbow ", "wrist "][p]);
    let name = format!("{part}{}", names.join(", "));
    if let (StepKind::SinCos, [crate::planner::Equation { scalar: crate::planner::Scalar::Distance, .. }]) =
        (step.kind, step.equations.as_slice())
    {
        let one = step.collected[0].get(&vec![crate::planner::Part::One]);
        let squared = plan.knowledge.poses.iter().find(|k| one.is_some_and(|p| p.has_symbol(k.square)));
        if let Some(square) = squared.and_then(|k| inverse.graph.bound_to(k.square)) {
            let square = Some((body.value(square), body.negative(solver.rows[0][2])));
            return Reported { name, scale: reach, unit: chain.unit.name, square };
        }
    }
    let length = step.equations.iter().any(|e| !matches!(e.scalar, crate::planner::Scalar::Rotation(..)));
    let (scale, unit) = if length { (reach, chain.unit.name) } else { ("1.0".into(), "") };
    Reported { name, scale, unit, square: None }
}

/// The statement that reports a step without roots.
fn note(chain: &Chain, inverse: &Inverse, i: usize, body: &Body<'_>) -> String {
    let Reported { name, scale, unit, square } = reported(chain, inverse, i, body);
    match square {
        Some((square, rest)) => {
            format!("attempt.note_distance(r{i}.outcome, free, \"{name}\", {square}, {rest}, {scale}, \"{unit}\");")
        }
        None => format!("attempt.note(r{i}.outcome, free, \"{name}\", {scale}, \"{unit}\");"),
    }
}

/// Which part of an arm with six joints a step with two roots decides: 0 shoulder, 1 elbow, 2 wrist; each part once.
pub(in crate::render) fn part_of(inverse: &Inverse, i: usize) -> Option<usize> {
    let part = |i: usize| {
        let step = &inverse.plan.steps[i];
        let joint = joints_of(step.unknown.first()?, inverse.plan.axes.real).first().copied()?;
        (step.roots == 2).then_some(match joint {
            0 => 0,
            1 | 2 => 1,
            _ => 2,
        })
    };
    let own = part(i)?;
    (!(0..i).any(|k| part(k) == Some(own))).then_some(own)
}

/// A symbol's name as an identifier of generated code.
pub(in crate::render) fn identifier(name: &str) -> String {
    name.replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_")
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

/// Which root each step took, with the names that robot controllers use.
pub(super) fn branch(inverse: &Inverse) -> String {
    let mut out = String::from("::dh_robot::Branch::ANY");
    for (place, (i, _)) in inverse.plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1).enumerate() {
        if place < 8 {
            out.push_str(&format!(".with_step({place}, i{i})"));
        }
        let (setter, first, second) = match part_of(inverse, i) {
            Some(0) => ("shoulder", "Shoulder::Left", "Shoulder::Right"),
            Some(1) => ("elbow", "Elbow::Up", "Elbow::Down"),
            Some(_) => ("wrist", "Wrist::NoFlip", "Wrist::Flip"),
            None => continue,
        };
        out.push_str(&format!(
            ".with_{setter}(if i{i} == 0 {{ ::dh_robot::{first} }} else {{ ::dh_robot::{second} }})"
        ));
    }
    out
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
        StepKind::Linear => {
            (format!("::dh_robot::ik::solve_quadratic(0.0, {}, {}, {noise})", v(0, 0), v(0, 1)), picked_length, length)
        }
        StepKind::Quadratic => (
            format!("::dh_robot::ik::solve_quadratic({}, {}, {}, {noise})", v(0, 0), v(0, 1), v(0, 2)),
            picked_length,
            length,
        ),
        StepKind::HalfTurn if solver.rows.len() == 2 => {
            let row = |r: usize| format!("[{}, {}]", v(r, 0), v(r, 1));
            (format!("::dh_robot::ik::solve_half_turn({}, {}, {noise})", row(0), row(1)), picked, angle)
        }
        StepKind::HalfTurn => {
            (format!("::dh_robot::ik::solve_sincos({}, {}, 0.0, {noise})", v(0, 0), v(0, 1)), picked, angle)
        }
        StepKind::SinCos => {
            (format!("::dh_robot::ik::solve_sincos({}, {}, {}, {noise})", v(0, 0), v(0, 1), minus(0, 2)), picked, angle)
        }
        StepKind::AtanPair if solver.rows.len() == 2 => (
            format!(
                "::dh_robot::ik::solve_pair({}, {}, {}, {}, {}, {}, {noise})",
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
            (format!("::dh_robot::ik::solve_many(&[{}], {noise})", rows.join(", ")), picked, angle)
        }
        StepKind::SecondHarmonic => (
            format!(
                "::dh_robot::ik::TrigPoly::<2> {{ constant: {}, cos: [{}, {}], sin: [{}, {}] }}.roots::<4>({noise})",
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
                "::dh_robot::ik::solve_bilinear_choosing(&[{}], &[{}], [{picked}, pick.angle({})], {noise})",
                list(0, 9),
                list(1, 9),
                step + 1
            ),
            String::new(),
            (|s| format!("[[{}, {}], [{}, {}]]", s[0][0], s[0][1], s[1][0], s[1][1])) as fn(&[[String; 2]]) -> String,
        ),
        StepKind::SlideAndTurn => (
            format!(
                "::dh_robot::ik::solve_length_squared_and_angle_choosing(&[{}], &[{}], ({picked_length}, pick.angle({})), {noise})",
                list(0, 9),
                list(1, 9),
                step + 1
            ),
            String::new(),
            (|s| format!("({}, [{}, {}])", s[0][0], s[1][0], s[1][1])) as fn(&[[String; 2]]) -> String,
        ),
        StepKind::Choose if !turns => {
            (format!("::dh_robot::ik::solve_quadratic(0.0, 0.0, 0.0, {noise})"), picked_length, length)
        }
        StepKind::Choose => (format!("::dh_robot::ik::solve_sincos(0.0, 0.0, 0.0, {noise})"), picked, angle),
        StepKind::General => {
            let poses: Vec<String> = (0..7)
                .map(|r| {
                    let row = |i: usize| format!("[{}, {}, {}, {}]", v(r, i), v(r, 3 + i), v(r, 6 + i), v(r, 9 + i));
                    format!("[{}, {}, {}]", row(0), row(1), row(2))
                })
                .collect();
            let cuts = inverse.choices.map(|c| format!("::dh_robot::ik::general::Choice::new({c})")).join(", ");
            (
                format!(
                    "::dh_robot::ik::general::General6R::with_slides(&[{}], &{:?}, [{cuts}]).find(&{})",
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

/// What polishing needs: forward kinematics and Jacobian in `f64`.
fn kinematics(chain: &Chain, name: &str, forward: &Forward) -> String {
    let n = chain.dof();
    let entry = |body: &Body<'_>, from: usize| {
        let row = |i: usize| {
            let o = |k: usize| body.output(from + 3 * k + i);
            format!("[{}, {}, {}, {}]", o(0), o(1), o(2), o(3))
        };
        format!("[{}, {}, {}]", row(0), row(1), row(2))
    };
    let pose = Body::new(chain, &forward.pose, Scalar::F64);
    let both = Body::new(chain, &forward.jacobian, Scalar::F64);
    let rows: Vec<String> = (0..6)
        .map(|r| {
            let row: Vec<String> = (0..n)
                .map(|j| if chain.redundant == Some(j) { "0.0".into() } else { both.output(12 + 6 * j + r) })
                .collect();
            format!("[{}]", row.join(", "))
        })
        .collect();
    let _: &Program = &forward.pose;
    format!(
        "#[allow(unused, clippy::all, clippy::pedantic)]\nimpl ::dh_robot::ik::Kinematics<{n}> for {name} {{\n\
         #[inline]\nfn forward(&self, q: &[f64; {n}]) -> ::dh_robot::ik::Pose {{\n{}\n{}\n}}\n\
         fn forward_and_jacobian(&self, q: &[f64; {n}]) -> (::dh_robot::ik::Pose, [[f64; {n}]; 6]) {{\n{}\n({}, [{}])\n}}\n}}\n",
        pose.lines.join("\n"),
        entry(&pose, 0),
        both.lines.join("\n"),
        entry(&both, 0),
        rows.join(", ")
    )
}
