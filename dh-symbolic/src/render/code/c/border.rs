//! Prints the Rust side of the C interface: the functions that C calls, in one file, the only one with `unsafe`.

use super::interface::{Function, Interface, Kind, Parameter, Solved};
use crate::chain::{PoseField, Task};
use crate::render::code::constant_pose;

/// The file. The robot's type stands in the module above it.
pub(super) fn text(interface: &Interface<'_>) -> String {
    let (name, f) = (&interface.name, interface.scalar());
    let solved = interface.inverse.as_ref();
    let mut out = include_str!("templates/border.in").replace("@imports@", &imports(interface));
    out.push_str(&params(interface));
    if let Some(solved) = solved {
        out.push_str(&target(&interface.chain.settings.task));
        out.push_str(&solutions(interface, solved));
    }
    for function in &interface.functions {
        out.push_str(&shared(function));
    }
    for function in &interface.functions {
        for (suffix, with) in interface.forms() {
            out.push_str(&exported(function, suffix, with));
        }
    }
    out.replace("@name@", name)
        .replace("@n@", &interface.dof().to_string())
        .replace("type F = f64", &format!("type F = {f}"))
}

fn imports(interface: &Interface<'_>) -> String {
    let robot = format!("use super::{} as Robot;\n", interface.chain.name);
    if interface.inverse.is_none() {
        return robot + "use core::ffi::c_int;\nuse dh_robot::pose::to_rows;\n";
    }
    let (pose, nalgebra) = match interface.chain.settings.task {
        Task::Pose => ("{from_rows, to_rows}", ", nalgebra"),
        Task::Position | Task::Axis => ("to_rows", ", nalgebra"),
        Task::Planar => ("to_rows", ""),
    };
    format!(
        "{robot}use core::ffi::{{c_char, c_int}};\nuse core::fmt::{{self, Write}};\nuse dh_robot::pose::{pose};\n\
         use dh_robot::{{Branch, Solution, Solutions, Why{nalgebra}}};\n"
    )
}

/// The parameters of the table as a struct of C.
fn params(interface: &Interface<'_>) -> String {
    if interface.fields.is_empty() {
        return String::new();
    }
    let fields: String = interface.fields.iter().map(|field| format!("    {}: F,\n", field.name)).collect();
    let list = |value: &dyn Fn(&str) -> String| -> String {
        let each = interface.fields.iter().map(|field| format!("        {},\n", value(&field.name)));
        each.collect()
    };
    let poses = &interface.chain.poses;
    let nominal = |p: &PoseField| constant_pose(interface.chain, p.nominal.as_deref().unwrap_or(&[]));
    let rest: String = poses.iter().map(|p| format!("        {}: {},\n", p.name, nominal(p))).collect();
    let mut out = format!(
        "\n/// The parameters of the table.\n#[repr(C)]\n#[derive(Clone, Copy)]\npub struct Params {{\n{fields}}}\n\n\
         /// The robot with these parameters; `None` if the pointer is null.\n///\n/// # Safety\n/// `params` is null or points to them.\n\
         unsafe fn with(params: *const Params) -> Option<Robot> {{\n    if params.is_null() {{\n        return None;\n    }}\n    \
         let params = unsafe {{ params.read() }};\n    Some(Robot {{\n{}    }})\n}}\n",
        list(&|name| format!("{name}: params.{name}")) + &rest
    );
    if interface.is_nominal() {
        out.push_str(&format!(
            "\n#[unsafe(no_mangle)]\npub extern \"C\" fn @name@_nominal() -> Params {{\n    let robot = Robot::default();\n    \
             Params {{\n{}    }}\n}}\n",
            list(&|name| format!("{name}: robot.{name}"))
        ));
    }
    out
}

/// The target as Rust takes it.
fn target(task: &Task) -> String {
    let (length, kind, value) = match task {
        Task::Pose => (
            16,
            "nalgebra::IsometryMatrix3<F>",
            "let row = |i: usize| [t[i], t[i + 1], t[i + 2], t[i + 3]];\n    from_rows(&[row(0), row(4), row(8), row(12)])",
        ),
        Task::Position => (3, "nalgebra::Point3<F>", "Ok((*t).into())"),
        Task::Planar => (3, "(F, F, F)", "let [x, y, phi] = *t;\n    Ok((x, y, phi))"),
        Task::Axis => (
            6,
            "(nalgebra::Point3<F>, nalgebra::UnitVector3<F>)",
            "let [x, y, z, u, v, w] = *t;\n    let axis = nalgebra::Vector3::new(u, v, w);\n    \
             Ok((nalgebra::Point3::new(x, y, z), nalgebra::Unit::new_unchecked(axis)))",
        ),
    };
    format!(
        "\n/// The target as Rust takes it, which checks it.\n#[inline]\nfn target_of(t: &[F; {length}]) -> Result<{kind}, Why<F>> {{\n    {value}\n}}\n"
    )
}

/// Solutions and reasons.
fn solutions(interface: &Interface<'_>, solved: &Solved) -> String {
    let steps: Vec<String> = solved.steps.iter().map(|step| format!("{step:?}")).collect();
    include_str!("templates/solutions.in")
        .replace("@steps@", &steps.join(", "))
        .replace("@count@", &steps.len().to_string())
        .replace("@unit@", interface.chain.settings.unit.name)
        .replace("@most@", &solved.most.to_string())
}

fn parameters(list: &[Parameter]) -> String {
    let one = |p: &Parameter| {
        let kind = match p.kind {
            Kind::Numbers(_) => "*const F",
            Kind::Place(_) => "*mut F",
            Kind::Number => "F",
            Kind::Count => "usize",
            Kind::Solutions(_) => "*mut Found",
            Kind::Counts => "*mut c_int",
            Kind::Reasons => "*mut Reason",
        };
        format!("{}: {kind}", p.name)
    };
    list.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// The function that both forms call.
fn shared(function: &Function) -> String {
    let body: String = function.body.lines().map(|line| format!("    {line}\n")).collect();
    format!(
        "\n#[inline]\nunsafe fn {}(robot: &Robot, {}) -> c_int {{\n{body}}}\n",
        function.name,
        parameters(&function.parameters)
    )
}

/// A function that C calls.
fn exported(function: &Function, suffix: &str, with: bool) -> String {
    let (name, list) = (function.name, parameters(&function.parameters));
    let pass = function.parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>().join(", ");
    let (params, body) = if with {
        (
            "params: *const Params, ",
            format!(
                "    match unsafe {{ with(params) }} {{\n        Some(robot) => unsafe {{ self::{name}(&robot, {pass}) }},\n        \
                 None => NULL_POINTER,\n    }}\n"
            ),
        )
    } else {
        ("", format!("    unsafe {{ self::{name}(&Robot::default(), {pass}) }}\n"))
    };
    format!(
        "\n#[unsafe(no_mangle)]\npub unsafe extern \"C\" fn @name@_{name}{suffix}({params}{list}) -> c_int {{\n{body}}}\n"
    )
}
