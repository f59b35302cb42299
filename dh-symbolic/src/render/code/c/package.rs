//! Prints what surrounds the headers: the crate, the CMake package, examples, and a page that says how to build it.

use super::Crate;
use super::header::{number, quoted};
use super::interface::{Interface, Solved};
use crate::chain::{Scalar, Task};

/// The files, by their paths.
pub(super) fn files(interface: &Interface<'_>, own: &Crate<'_>) -> Vec<(String, String)> {
    let name = &interface.name;
    let fill = |text: &str| filled(interface, own, text);
    let file = |path: &str, text: &str| (path.replace("@name@", name), fill(text));
    vec![
        file(".gitignore", "/build/\n/target/\n"),
        file("CMakeLists.txt", include_str!("templates/CMakeLists.txt.in")),
        file("Cargo.toml", include_str!("templates/Cargo.toml.in")),
        file("README.md", include_str!("templates/README.md.in")),
        file("cmake/@name@-config.cmake.in", include_str!("templates/config.cmake.in")),
        file("cmake/@name@-targets.cmake", include_str!("templates/targets.cmake.in")),
        file("examples/example.c", include_str!("templates/example.c.in")),
        file("examples/example.cpp", include_str!("templates/example.cpp.in")),
        file("src/lib.rs", include_str!("templates/lib.rs.in")),
    ]
}

fn filled(interface: &Interface<'_>, own: &Crate<'_>, text: &str) -> String {
    let dependency = match own.path {
        Some(path) => format!("{{ path = {} }}", toml(path)),
        None => toml(own.version),
    };
    let table: String = own.table.trim_start_matches('\u{feff}').lines().map(|line| format!("{line}\n")).collect();
    let example = Example::of(interface);
    let inverse = |text: &'static str| if interface.inverse.is_some() { text } else { "" };
    text.replace("@inverse.c@", inverse(include_str!("templates/inverse.c.in")))
        .replace("@inverse.cpp@", inverse(include_str!("templates/inverse.cpp.in")))
        .replace("@include.math@", if example.atan2 { "#include <math.h>\n" } else { "" })
        .replace("@include.cmath@", if example.atan2 { "#include <cmath>\n" } else { "" })
        .replace("@params.c@", &example.params_c)
        .replace("@params.cpp@", &example.params_cpp)
        .replace("@self@", &example.own)
        .replace("@with@", if example.own.is_empty() { "" } else { "_with" })
        .replace("@q@", &example.q)
        .replace("@target@", &example.target)
        .replace("@target.std@", &example.target.replace("atan2", "std::atan2"))
        .replace("@given.c@", &example.given[0])
        .replace("@given.cpp@", &example.given[1])
        .replace(
            "@given.end@",
            &example.given[2].strip_suffix(", ").map_or(String::new(), |value| format!(", {value}")),
        )
        .replace("@given@", &example.given[2])
        .replace("@robot.cpp@", if example.own.is_empty() { "" } else { "params" })
        .replace("@dependency@", &dependency)
        .replace("@unit@", interface.chain.settings.unit.name)
        .replace("@number@", interface.number())
        .replace("@n@", &interface.dof().to_string())
        .replace("@Type@", &interface.chain.name)
        .replace("@name@", &interface.name)
        .replace("@NAME@", &interface.upper)
        .replace("@table@\n", &table)
}

/// A string of TOML.
fn toml(text: &str) -> String {
    if text.contains(['\'', '\n']) { quoted(text) } else { format!("'{text}'") }
}

/// What the example programs compute with.
struct Example {
    /// Joint values, well inside the ranges.
    q: String,
    /// The target that the pose at these values makes.
    target: String,
    /// Whether that takes an arc tangent.
    atan2: bool,
    /// The joints that are given: the statements that list them in C and C++, and the argument.
    given: [String; 3],
    /// Parameters, where not all have nominal values, in C and C++.
    params_c: String,
    params_cpp: String,
    /// The argument that holds them in C.
    own: String,
}

impl Example {
    fn of(interface: &Interface<'_>) -> Example {
        let value = |(i, (_, _, range)): (usize, (_, _, Option<[f64; 2]>))| match range {
            Some([least, greatest]) => ((least + 0.4 * (greatest - least)) * 100.0).round() / 100.0,
            None => 0.3 + 0.2 * i as f64,
        };
        let q: Vec<String> = interface.joints().enumerate().map(value).map(|x| number(interface, x)).collect();
        let target = match interface.chain.settings.task {
            Task::Pose => (0..16).map(|i| format!("pose[{i}]")).collect::<Vec<_>>().join(", "),
            Task::Position => "pose[3], pose[7], pose[11]".to_string(),
            Task::Planar if interface.chain.settings.scalar == Scalar::F32 => {
                "pose[3], pose[7], (float)atan2(pose[4], pose[0])".to_string()
            }
            Task::Planar => "pose[3], pose[7], atan2(pose[4], pose[0])".to_string(),
            Task::Axis => "pose[3], pose[7], pose[11], pose[2], pose[6], pose[10]".to_string(),
        };
        let given = interface.inverse.as_ref().map(|solved| given(interface, solved)).unwrap_or_default();
        let planar = interface.chain.settings.task == Task::Planar;
        let (mut params_c, mut params_cpp, mut own) = (String::new(), String::new(), String::new());
        if !interface.is_nominal() {
            let name = &interface.name;
            let value = |f: &super::interface::Field| number(interface, f.nominal.unwrap_or(1.0));
            let set: String =
                interface.fields.iter().map(|f| format!("    params.{} = {};\n", f.own, value(f))).collect();
            params_c = format!("    {name}_params params; /* put your arm's numbers here */\n{set}");
            params_cpp = format!("    {name}::Params params; // put your arm's numbers here\n{set}");
            own = "&params, ".to_string();
        }
        Example {
            q: q.join(", "),
            atan2: planar && interface.inverse.is_some(),
            target,
            given,
            params_c,
            params_cpp,
            own,
        }
    }
}

fn given(interface: &Interface<'_>, solved: &Solved) -> [String; 3] {
    let index = |name: &String| interface.chain.joints.iter().position(|joint| joint.name == *name).unwrap_or(0);
    let values: Vec<String> = solved.given.iter().map(|name| format!("q[{}]", index(name))).collect();
    match values.as_slice() {
        [] => <[String; 3]>::default(),
        [one] => [String::new(), String::new(), format!("{one}, ")],
        several => {
            let (list, kind, name) = (several.join(", "), interface.number(), &interface.name);
            [
                format!("    const {kind} given[] = {{{list}}};\n"),
                format!("    const {name}::Given given{{{list}}};\n"),
                "given, ".to_string(),
            ]
        }
    }
}
