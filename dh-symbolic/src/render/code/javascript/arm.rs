//! The JavaScript class of one robot: its data, `forward`, `frames`, `jacobian`, `inverse`.

use super::text::{indented, string};
use super::{Solver, candidates};
use crate::algebra::{Poly, Transform};
use crate::chain::{Chain, Convention, Coordinate, Handle, Joint, Role, Scalar, Task};
use crate::program::{Forward, Graph, Program};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::drive::{Matrices, matrices};
use crate::render::code::{bound, literal};

/// The class `Arm`.
pub fn class(chain: &Chain, forward: &Forward, solver: &Solver) -> String {
    let mut out = format!(
        "// {}: forward kinematics, Jacobian and inverse. Lengths in {}, angles in radians; a pose is the rows of [R | p].\n\
         class Arm {{\nconstructor() {{\n{}}}\n\n",
        chain.name,
        chain.settings.unit.name,
        data(chain, solver)
    );
    let functions = [
        ("base()", "The frame before the first row.", base(chain)),
        ("forward(q)", "The pose of the last frame (or tool).", pose(chain, forward)),
        ("links(q)", "The frame of every row of the table.", links(chain, forward)),
        ("jacobian(q)", "The geometric Jacobian, by rows: linear, then angular velocity.", jacobian(chain, forward)),
    ];
    for (head, doc, body) in functions {
        out.push_str(&format!("// {doc}\n{head} {{\n{}{body}}}\n\n", fields(chain)));
    }
    if let Some(Matrices { det, rows, actuators, revolute }) = matrices(chain).filter(|_| chain.is_geared()) {
        out.push_str(&format!(
            "// How actuators move rows, where whole turns of rows are not whole turns of actuators.\nget drive() {{\n\
             const self = this.parameters;\nconst det = {det};\nreturn {{ rows: {rows}, actuators: {actuators}, revolute: {revolute} }};\n}}\n\n"
        ));
    }
    let rows: Vec<String> = chain.joints.iter().map(|j| format!("all[{}]", j.row)).collect();
    out.push_str(&format!(
        "// The frame of every moving link.\nframes(q) {{\nconst all = this.links(q);\nreturn [{}];\n}}\n\n\
         // All solutions for a target, each verified by the forward kinematics.\n\
         inverse(target, given) {{\nreturn solve(this, target, given);\n}}\n",
        rows.join(", ")
    ));
    if let Solver::Closed(inverse) = solver {
        out.push('\n');
        out.push_str(&candidates::candidates(chain, inverse));
    }
    out.push_str("}\n");
    indented(&out)
}

/// The statement that gives formulas the parameters, of an arm that has any.
pub(super) fn fields(chain: &Chain) -> &'static str {
    let any = chain.parameters.iter().any(|p| matches!(p.role, Role::Field(_)));
    if any { "const self = this.parameters;\n" } else { "" }
}

fn number(x: f64) -> String {
    literal(x, Scalar::F64)
}

/// The statements of the constructor.
fn data(chain: &Chain, solver: &Solver) -> String {
    let fields: Vec<String> = chain
        .parameters
        .iter()
        .filter_map(|p| match &p.role {
            Role::Field(value) => Some(format!("{}: {}", p.name, number(assumed(chain, p.handle, value.is_some())))),
            Role::Constant(_) => None,
        })
        .collect();
    let joints: Vec<String> = chain.joints.iter().enumerate().map(|(i, j)| joint(chain, i, j)).collect();
    let length_scale = match solver {
        Solver::Closed(inverse) => inverse.plan.axes.length_scale,
        _ => crate::planner::Axes::new(chain).length_scale,
    };
    let (task, rank_deficient) = match chain.settings.task {
        Task::Pose => ("pose", chain.dof() - chain.settings.redundant.len() < 6),
        Task::Position => ("position", false),
        Task::Planar => ("planar", false),
        Task::Axis => ("axis", false),
    };
    let convention = match chain.convention {
        Convention::Modified => "modified",
        Convention::Standard => "standard",
    };
    let mut out = format!("this.name = {};\nthis.unit = {};\n", string(&chain.name), string(chain.settings.unit.name));
    out.push_str(&format!("this.parameters = {{ {} }};\n", fields.join(", ")));
    out.push_str(&format!("this.joints = [\n{}];\n", joints.concat()));
    out.push_str(&format!(
        "this.convention = \"{convention}\";\nthis.task = \"{task}\";\nthis.rankDeficient = {rank_deficient};\n"
    ));
    out.push_str(&format!("this.redundant = {};\n", format_args!("{:?}", chain.settings.redundant)));
    out.push_str(&format!("this.lengthScale = {};\n", number(length_scale)));
    out
}

/// The value of a field: its nominal one; 1 for lengths and 30 degrees for angles without one, as in the worked example of the notes.
fn assumed(chain: &Chain, handle: Handle, known: bool) -> f64 {
    match handle {
        _ if known => chain.nominal(handle),
        Handle::Length(_) => 1.0,
        Handle::Angle(_) => std::f64::consts::FRAC_PI_6,
    }
}

fn joint(chain: &Chain, index: usize, joint: &Joint) -> String {
    let periodic = chain.is_periodic(index);
    let range = match &joint.range {
        Some((least, greatest)) => format!("[{}, {}]", number(bound(least)), number(bound(greatest))),
        None => "null".to_string(),
    };
    let (angle, prismatic) = (is_angle(chain, index), matches!(joint.coordinate, Coordinate::Length(_)));
    let (row, name) = (joint.row, string(&joint.name));
    format!(
        "{{ name: {name}, row: {row}, periodic: {periodic}, angle: {angle}, prismatic: {prismatic}, range: {range} }},\n"
    )
}

/// Whether the actuator's variable is an angle. (It is for an actuator that drives a rack by a pinion, though no joint turns with it.)
fn is_angle(chain: &Chain, actuator: usize) -> bool {
    chain.joints.iter().zip(&chain.drive).any(|(j, row)| {
        row.get(actuator).is_some_and(|k| {
            let driven = !k.is_zero();
            driven && (matches!(j.coordinate, Coordinate::Angle(_)) || k.as_rational().is_none())
        })
    })
}

fn rows_of(body: &Body<'_>, from: usize) -> String {
    let o = |k: usize| body.output(from + k);
    let row = |i: usize| format!("[{}, {}, {}, {}]", o(i), o(3 + i), o(6 + i), o(9 + i));
    format!("[\n{},\n{},\n{},\n]", row(0), row(1), row(2))
}

fn body<'a>(chain: &'a Chain, program: &'a Program) -> (Body<'a>, String) {
    let body = Body::whole(Dialect::JavaScript, chain, program, Scalar::F64);
    let lines: String = body.lines.iter().map(|l| format!("{l}\n")).collect();
    (body, lines)
}

fn base(chain: &Chain) -> String {
    let t = chain.base.iter().fold(Transform::identity(), |t, e| t.times(&e.transform()));
    let mut graph = Graph::new(chain);
    let columns = [t.column(0), t.column(1), t.column(2), t.p.clone()];
    let outputs = columns.iter().flatten().map(|p: &Poly| graph.polynomial(p)).collect();
    let program = Program { graph, outputs };
    let (body, lines) = body(chain, &program);
    format!("{lines}return {};\n", rows_of(&body, 0))
}

fn pose(chain: &Chain, forward: &Forward) -> String {
    let (body, lines) = body(chain, &forward.pose);
    format!("{lines}return {};\n", rows_of(&body, 0))
}

fn links(chain: &Chain, forward: &Forward) -> String {
    let (body, lines) = body(chain, &forward.frames);
    let frames: Vec<String> = (0..chain.links.len()).map(|i| rows_of(&body, 12 * i)).collect();
    format!("{lines}return [{}];\n", frames.join(", "))
}

fn jacobian(chain: &Chain, forward: &Forward) -> String {
    let outputs = forward.jacobian.outputs.get(12..).unwrap_or_default().to_vec();
    let program = Program { graph: forward.jacobian.graph.clone(), outputs };
    let (body, lines) = body(chain, &program);
    let rows: Vec<String> = (0..6)
        .map(|r| {
            let row: Vec<String> = (0..chain.dof()).map(|j| body.output(6 * j + r)).collect();
            format!("[{}],\n", row.join(", "))
        })
        .collect();
    format!("{lines}return [\n{}];\n", rows.concat())
}
