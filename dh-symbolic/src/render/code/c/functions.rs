//! The list of the functions that C can call: parameters, documentation, and the Rust statements that each runs.
//!
//! The statements see `robot` and the parameters as raw pointers; `read`, `write`, `target_of`, `all` and `one` stand in the border file.

use super::interface::{Function, Kind, Parameter, Solved};
use crate::chain::Chain;

/// All functions of a robot.
pub(super) fn functions(chain: &Chain, solved: Option<&Solved>) -> Vec<Function> {
    let mut list = of_forward(chain);
    list.extend(solved.map(|solved| of_inverse(chain.dof(), solved)).unwrap_or_default());
    list
}

fn lines(text: &str) -> Vec<String> {
    text.lines().map(String::from).collect()
}

/// Numbers that are read: so many, or as many as the function says.
fn numbers(name: &str, length: Option<usize>) -> Parameter {
    Parameter::new(name, Kind::Numbers(length))
}

fn place(name: &str, length: Option<[usize; 2]>) -> Parameter {
    Parameter::new(name, Kind::Place(length))
}

fn of_forward(chain: &Chain) -> Vec<Function> {
    let (n, unit) = (chain.dof(), chain.settings.unit.name);
    let q = || numbers("q", Some(n));
    let one = |place: Parameter, docs: String, value: &str| Function {
        name: "",
        docs: lines(&docs),
        body: format!(
            "let Some(q) = (unsafe {{ read(q) }}) else {{ return NULL_POINTER }};\nunsafe {{ write({}, {value}) }}\n",
            place.name
        ),
        parameters: vec![q(), place],
    };
    let many = |to: &str, single: &str, length: usize, what: &str| Function {
        name: "",
        docs: lines(&format!(
            "{what} of `count` joint vectors: {n} numbers each in q, {length} numbers each in {to}. A vector that is not finite spoils its own\n\
             result only."
        )),
        body: format!(
            "if count > 0 && (q.is_null() || {to}.is_null()) {{\n    return NULL_POINTER;\n}}\nfor i in 0..count {{\n    \
             unsafe {{ {single}(robot, q.add({n} * i), {to}.add({length} * i)) }};\n}}\nOK\n"
        ),
        parameters: vec![numbers("q", None), Parameter::new("count", Kind::Count), place(to, None)],
    };
    let jacobian = format!(
        "Geometric Jacobian, 6 rows of {n} numbers: rows 0 to 2 linear velocity ({unit} per radian, or 1 for a sliding joint), rows 3 to 5\n\
         angular velocity; base axes, at the origin of the last frame (or tool)."
    );
    let both = Function {
        name: "",
        docs: lines("Both together, for little more than one of them."),
        body: "let Some(q) = (unsafe { read(q) }) else { return NULL_POINTER };\n\
               if pose.is_null() || jacobian.is_null() {\n    return NULL_POINTER;\n}\n\
               let (frame, matrix) = robot.forward_and_jacobian(&q);\n\
               unsafe { write(pose, to_rows(&frame)) };\n\
               unsafe { write(jacobian, matrix.transpose().data.0) }\n"
            .to_string(),
        parameters: vec![q(), place("pose", Some([4, 4])), place("jacobian", Some([6, n]))],
    };
    let frames = Function {
        name: "",
        docs: lines(&format!(
            "Poses of the {n} moving links' frames in the base, one after the other, without the tool."
        )),
        body: "let (Some(q), false) = (unsafe { read(q) }, frames.is_null()) else { return NULL_POINTER };\n\
               for (i, frame) in robot.frames(&q).iter().enumerate() {\n    \
               unsafe { write(frames.add(16 * i), to_rows(frame)) };\n}\nOK\n"
            .to_string(),
        parameters: vec![q(), place("frames", Some([n, 16]))],
    };
    let list = [
        (
            "forward",
            one(
                place("pose", Some([4, 4])),
                "Pose of the last frame (or tool) in the base.".into(),
                "to_rows(&robot.forward(&q))",
            ),
        ),
        ("frames", frames),
        ("jacobian", one(place("jacobian", Some([6, n])), jacobian, "robot.jacobian(&q).transpose().data.0")),
        ("forward_and_jacobian", both),
        ("forward_batch", many("poses", "forward", 16, "Poses")),
        ("jacobian_batch", many("jacobians", "jacobian", 6 * n, "Jacobians")),
    ];
    list.into_iter().map(|(name, function)| Function { name, ..function }).collect()
}

fn of_inverse(n: usize, solved: &Solved) -> Vec<Function> {
    let Solved { most, target, length, meaning, given, .. } = solved;
    let (targets, k, argument) = (format!("{target}s"), given.len(), solved.argument());
    let why = || Parameter::new("why", Kind::Reasons);
    let solutions = |name: &str, length: Option<usize>| Parameter::new(name, Kind::Solutions(length));
    let note = match given.as_slice() {
        [] => String::new(),
        [joint] => format!("\n`{joint}` is the value of that joint, which you choose."),
        several => format!("\n`given` holds the values of {}, which you choose.", several.join(", ")),
    };
    // Several values are read like other arrays; one is a number. `pass` hands them to Rust's functions, `next` to those of this border.
    let (read, pass, next) = match given.as_slice() {
        [] => ("", String::new(), String::new()),
        [joint] => ("", format!(", {joint}"), ", given.add(i).read()".to_string()),
        _ => (
            "let Some(given) = (unsafe { read(given) }) else { return NULL_POINTER };\n",
            ", given".to_string(),
            format!(", given.add({k} * i)"),
        ),
    };
    let inverse = format!(
        "let (Some(target), false) = (unsafe {{ read({target}) }}, solutions.is_null()) else {{ return NULL_POINTER }};\n{read}\
         let found = match target_of(&target) {{\n    Ok(target) => robot.inverse({argument}{pass}),\n    \
         Err(why) => Solutions::none(&Robot::JOINTS, why),\n}};\nunsafe {{ all(&found, solutions, why) }}\n"
    );
    let near = format!(
        "let (Some(target), Some(q), false) = (unsafe {{ read({target}) }}, unsafe {{ read(q) }}, solution.is_null()) else {{\n    \
         return NULL_POINTER;\n}};\n{read}\
         let found = target_of(&target).and_then(|target| robot.inverse_near({argument}{pass}, &q));\n\
         unsafe {{ one(&found, solution, why) }}\n"
    );
    let null_given = if k == 0 { "" } else { " || given.is_null()" };
    let batch = format!(
        "if count > 0 && ({targets}.is_null(){null_given} || solutions.is_null() || counts.is_null()) {{\n    return NULL_POINTER;\n}}\n\
         for i in 0..count {{\n    let why = if why.is_null() {{ why }} else {{ unsafe {{ why.add(i) }} }};\n    \
         let found = unsafe {{ inverse(robot, {targets}.add({length} * i){next}, solutions.add({most} * i), why) }};\n    \
         unsafe {{ counts.add(i).write(found) }};\n}}\nOK\n"
    );
    let one = || std::iter::once(numbers(target, Some(*length))).chain(solved.given());
    let given_many = (k > 0).then(|| numbers("given", None));
    let each = if k == 0 { String::new() } else { format!(", {k} in given") };
    vec![
        Function {
            name: "inverse",
            docs: lines(&format!(
                "Every solution for a target, each once; returns how many there are, 0 to {most}. The target is {meaning}.{note}\n\
                 `why` is null, or takes the reason why there is none. Places beyond the solutions stay as they are."
            )),
            parameters: one().chain([solutions("solutions", Some(*most)), why()]).collect(),
            body: inverse,
        },
        Function {
            name: "inverse_near",
            docs: lines(&format!(
                "The solution that continues from the joint values q: the one of least travel, on a self-motion (at a singular pose) the point\n\
                 nearest to q. Returns 1, or 0 where no joint values reach the target.{note}"
            )),
            parameters: one().chain([numbers("q", Some(n)), solutions("solution", None), why()]).collect(),
            body: near,
        },
        Function {
            name: "inverse_batch",
            docs: lines(&format!(
                "Every solution of `count` targets: {length} numbers each in {targets}{each}. There are counts[i] solutions of target i, from\n\
                 solutions[{most} * i] on. `why` is null or takes `count` reasons. A target that is not finite spoils its own result only."
            )),
            parameters: std::iter::once(numbers(&targets, None))
                .chain(given_many)
                .chain([Parameter::new("count", Kind::Count), solutions("solutions", None)])
                .chain([Parameter::new("counts", Kind::Counts), why()])
                .collect(),
            body: batch,
        },
    ]
}
