//! Prints the C header (C99): table and formulas as a comment, constants, types, and a prototype with documentation for each function.

use super::interface::{Interface, Kind, Parameter, Solved};
use crate::chain::Scalar;
use crate::kinematics::Kinematics;
use crate::render::code::closed_form::closed_form;
use crate::render::code::{docs, literal};

/// The header.
pub(super) fn text(interface: &Interface<'_>) -> String {
    let mut out = format!("/* {}.h: {}\n */\n", interface.name, comment(&about(interface), " * "));
    let guard = format!("{}_H", interface.upper);
    out.push_str(&format!("#ifndef {guard}\n#define {guard}\n\n#include <stddef.h>\n#include <stdint.h>\n\n"));
    out.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    out.push_str(&constants(interface));
    out.push_str(&joints(interface));
    out.push_str(&params(interface));
    if let Some(solved) = &interface.inverse {
        out.push_str(&solutions(interface, solved));
    }
    for function in &interface.functions {
        for (suffix, with) in interface.forms() {
            let docs = if with && interface.is_nominal() {
                vec!["The same for an arm with other parameters.".to_string()]
            } else {
                function.docs.clone()
            };
            out.push_str(&documented(&docs));
            let own = with.then(|| format!("const {}_params *params", interface.name));
            let list = own.into_iter().chain(function.parameters.iter().map(|p| declared(interface, p)));
            let head = format!("int {}_{}{suffix}(", interface.name, function.name);
            out.push_str(&prototype(&head, &list.collect::<Vec<_>>()));
        }
    }
    out.push_str(&others(interface));
    out.push_str("#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    out
}

/// Text that may stand in a comment of C.
fn safe(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *").replace('\r', "")
}

/// Lines of a comment, each behind a prefix but the first.
fn comment(lines: &[String], prefix: &str) -> String {
    let text: Vec<String> = lines.iter().map(|line| safe(line).trim_end().to_string()).collect();
    text.join(&format!("\n{prefix}")).replace(&format!("{prefix}\n"), &format!("{}\n", prefix.trim_end()))
}

/// A comment in front of a declaration.
fn documented(lines: &[String]) -> String {
    format!("/** {} */\n", comment(lines, " *  "))
}

/// A string of C.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' => out.extend(['\\', char::from(byte)]),
            b'?' => out.push_str("\\?"),
            b' '..=b'~' => out.push(char::from(byte)),
            _ => out.push_str(&format!("\\{byte:03o}")),
        }
    }
    out.push('"');
    out
}

/// A number of C.
pub(super) fn number(interface: &Interface<'_>, x: f64) -> String {
    let scalar = interface.chain.settings.scalar;
    let text = literal(x, scalar);
    if scalar == Scalar::F32 { format!("{text}f") } else { text }
}

/// What stands at the top: the arm, its table, its formulas, what all functions have in common.
fn about(interface: &Interface<'_>) -> Vec<String> {
    let (chain, written) = (interface.chain, &interface.written);
    let mut lines =
        vec![format!("kinematics of {}, from its Denavit-Hartenberg table. Made by `dh export`.", chain.name)];
    let mut paragraph = |text: Vec<String>| {
        lines.push(String::new());
        lines.extend(text);
    };
    if !written.docs.is_empty() {
        paragraph(written.docs.iter().map(|line| line.trim().to_string()).collect());
    }
    paragraph(vec![docs::heading(chain)]);
    paragraph(aligned(written.table));
    if !written.motions.is_empty() {
        paragraph(written.motions.iter().map(|(name, value)| format!("  {name} = {value}")).collect());
    }
    let form = closed_form(chain, &Kinematics::new(chain));
    paragraph(vec![form.heading]);
    if !form.formulas.is_empty() {
        paragraph(form.formulas.lines().map(|line| format!("  {line}").trim_end().to_string()).collect());
    }
    paragraph(rules(interface));
    lines
}

/// The table with its columns one below the other.
fn aligned(table: &[Vec<String>]) -> Vec<String> {
    let width =
        |j: usize| table.iter().filter_map(|row| row.get(j)).map(|cell| cell.chars().count()).max().unwrap_or(0);
    let line = |row: &Vec<String>| {
        let cells = row.iter().enumerate().map(|(j, cell)| format!("  {cell:<0$}", width(j)));
        cells.collect::<String>().trim_end().to_string()
    };
    table.iter().map(line).collect()
}

/// What holds for all functions.
fn rules(interface: &Interface<'_>) -> Vec<String> {
    let (unit, upper, name) = (interface.chain.settings.unit.name, &interface.upper, &interface.name);
    let mut text = format!(
        "Angles are in radians, lengths in {unit}. A pose is a homogeneous matrix, 4 x 4, row after row: its position stands in pose[3], pose[7]\n\
         and pose[11], and pose[12] to pose[15] are 0 0 0 1.\n\n\
         Functions return {upper}_OK{}, or {upper}_NULL_POINTER where a pointer is null that must not be; then\n\
         nothing was written. No function allocates, keeps anything between calls, or is ended by bad numbers: what follows from input\n\
         that is not finite is not finite, or says so. Any thread may call any function at any time. Input and output may overlap, but for\n\
         batches.",
        if interface.inverse.is_some() { " or a number of solutions" } else { "" }
    );
    if !interface.fields.is_empty() {
        text.push_str(&if interface.is_nominal() {
            format!(
                "\n\nThe lengths and angles that the table declares are the fields of {name}_params. A function whose name ends in _with takes\n\
                 them first; the function without is that of the nominal arm."
            )
        } else {
            format!(
                "\n\nThe lengths and angles that the table declares are the fields of {name}_params, which every function takes first. Not all of\n\
                 them have a nominal value."
            )
        });
    }
    text.lines().map(String::from).collect()
}

fn constants(interface: &Interface<'_>) -> String {
    let upper = &interface.upper;
    let mut out = format!("/** Number of joints. */\n#define {upper}_DOF {}\n", interface.dof());
    if let Some(solved) = &interface.inverse {
        out.push_str(&format!(
            "/** The most solutions of a target. */\n#define {upper}_MAX_SOLUTIONS {}\n\
             /** How many numbers a target has: {}. */\n#define {upper}_TARGET {}\n\
             /** How many joint values are given with it. */\n#define {upper}_GIVEN {}\n",
            solved.most,
            solved.meaning,
            solved.length,
            solved.given.len()
        ));
    }
    out.push_str(&format!(
        "\n/** The work is done. */\n#define {upper}_OK 0\n/** A pointer is null that must not be. */\n#define {upper}_NULL_POINTER (-1)\n\n"
    ));
    out
}

fn joints(interface: &Interface<'_>) -> String {
    let (name, number_type) = (&interface.name, interface.number());
    let list = interface.joints().map(|(joint, turns, range)| {
        let range = range.map(|bounds| bounds.map(|x| number(interface, x)));
        let [least, greatest] = range.clone().unwrap_or_else(|| [number(interface, 0.0), number(interface, 0.0)]);
        format!(
            "    {{{}, {}, {}, {}, {least}, {greatest}}}",
            quoted(&joint.name),
            quoted(joint.label.as_deref().unwrap_or("")),
            i32::from(turns),
            i32::from(range.is_some())
        )
    });
    format!(
        "/** A joint variable. */\ntypedef struct {name}_joint {{\n    \
         const char *name;  /**< as in the table: q1 */\n    \
         const char *label; /**< what the table calls its row, or \"\" */\n    \
         int revolute;      /**< 1 if it turns (radians), 0 if it slides */\n    \
         int limited;       /**< 1 if the table gives a range */\n    \
         {number_type} least;\n    {number_type} greatest;\n}} {name}_joint;\n\n\
         /** The joints of the table. */\nstatic const {name}_joint {name}_joints[{}] = {{\n{}\n}};\n\n",
        interface.dof(),
        list.collect::<Vec<_>>().join(",\n")
    )
}

fn params(interface: &Interface<'_>) -> String {
    if interface.fields.is_empty() {
        return String::new();
    }
    let (name, kind) = (&interface.name, interface.number());
    let field = |f: &super::interface::Field| {
        let text: Vec<&str> = f.docs.iter().map(|line| line.trim()).collect();
        format!("    {kind} {}; /**< {} */\n", f.own, safe(&text.join(" ")))
    };
    let fields: String = interface.fields.iter().map(field).collect();
    let mut out =
        format!("/** The parameters of the table. */\ntypedef struct {name}_params {{\n{fields}}} {name}_params;\n\n");
    if interface.is_nominal() {
        out.push_str(&format!("/** The nominal parameters. */\n{name}_params {name}_nominal(void);\n\n"));
    }
    out
}

/// Types and constants of the inverse.
fn solutions(interface: &Interface<'_>, solved: &Solved) -> String {
    let steps: Vec<String> = solved.steps.iter().map(|step| quoted(step)).collect();
    let names = if steps.is_empty() {
        String::new()
    } else {
        format!(
            "/** What the steps of the solution are called. */\nstatic const char *const {}_steps[{}] = {{{}}};\n\n",
            interface.name,
            steps.len(),
            steps.join(", ")
        )
    };
    include_str!("templates/solutions.h.in")
        .replace("@name@", &interface.name)
        .replace("@NAME@", &interface.upper)
        .replace("@n@", &interface.dof().to_string())
        .replace("@number@", interface.number())
        .replace("@unit@", interface.chain.settings.unit.name)
        .replace("@steps@", &names)
}

/// A parameter as C declares it.
fn declared(interface: &Interface<'_>, p: &Parameter) -> String {
    let (name, number, own) = (&p.name, interface.number(), &interface.name);
    match p.kind {
        Kind::Numbers(Some(length)) => format!("const {number} {name}[{length}]"),
        Kind::Numbers(None) => format!("const {number} *{name}"),
        Kind::Place(Some([rows, columns])) if rows == 4 => format!("{number} {name}[{}]", rows * columns),
        Kind::Place(Some([rows, columns])) => format!("{number} {name}[{rows} * {columns}]"),
        Kind::Place(None) => format!("{number} *{name}"),
        Kind::Number => format!("{number} {name}"),
        Kind::Count => format!("size_t {name}"),
        Kind::Solutions(Some(most)) => format!("{own}_solution {name}[{most}]"),
        Kind::Solutions(None) => format!("{own}_solution *{name}"),
        Kind::Counts => format!("int *{name}"),
        Kind::Reasons => format!("{own}_why *{name}"),
    }
}

/// A prototype, on two lines where it is long.
fn prototype(head: &str, parameters: &[String]) -> String {
    let line = format!("{head}{});", parameters.join(", "));
    if line.len() <= 110 { format!("{line}\n\n") } else { format!("{head}\n    {});\n\n", parameters.join(", ")) }
}

/// The functions that compute no kinematics.
fn others(interface: &Interface<'_>) -> String {
    let (name, upper, number) = (&interface.name, &interface.upper, interface.number());
    let mut out = format!(
        "/** 1 if all joint values are in the ranges of the table, else 0. */\nint {name}_in_range(const {number} q[{}]);\n\n",
        interface.dof()
    );
    if interface.inverse.is_some() {
        out.push_str(&include_str!("templates/texts.h.in").replace("@name@", name).replace("@NAME@", upper));
    }
    out
}
