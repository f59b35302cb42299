//! What the code printers of an inverse share: names of variables, calls of kernels, branches, reports of steps without a root.

use super::body::{Body, Code, Dialect};
use super::drive::chosen;
use super::literal;
use super::names::CodeNames;
use crate::algebra::Symbol;
use crate::chain::{Chain, Scalar};
use crate::planner::{Argument, Call, Representative};
use crate::program::{Choice, Indicator, Inverse, Report, Solve, Value};

/// Names that generated functions use for something else.
const RESERVED: [&str; 22] = [
    "q", "s", "c", "self", "t", "angles", "found", "attempt", "given", "free", "sample", "path", "branch", "valid",
    "margin", "error", "frame", "target", "lane", "take", "setting", "task",
];

/// The variables of a combination of joints.
#[derive(Clone, Debug)]
pub(in crate::render) struct Variable {
    /// Cosine and sine; for a length the length over the length scale, twice.
    pub(in crate::render) pair: [String; 2],
    /// The joint value: `q3`, `q2_plus_q3`.
    pub(in crate::render) value: String,
    /// Whether it is an angle.
    pub(in crate::render) is_angle: bool,
}

/// The variables of a step.
#[derive(Clone, Debug)]
pub(in crate::render) struct StepNames {
    /// All roots.
    pub(in crate::render) roots: String,
    /// The number of the root at hand.
    pub(in crate::render) root: String,
}

/// The variables of an inverse.
#[derive(Clone, Debug)]
pub(in crate::render) struct Variables {
    /// Of every known combination.
    pub(in crate::render) known: Vec<Variable>,
    /// Of every step.
    pub(in crate::render) steps: Vec<StepNames>,
    symbols: Vec<(Symbol, String)>,
}

impl Variables {
    /// Names everything.
    pub(in crate::render) fn of(inverse: &Inverse) -> Variables {
        let (knowledge, mut names) = (&inverse.plan.knowledge, CodeNames::new(&RESERVED));
        let mut symbols: Vec<(Symbol, String)> = Vec::new();
        for (i, s) in inverse.target.iter().enumerate() {
            let (row, column) = if i < 9 { (i / 3, i % 3) } else { (i - 9, 3) };
            symbols.push((*s, format!("t[{row}][{column}]")));
        }
        let known: Vec<Variable> = knowledge
            .known
            .iter()
            .map(|k| {
                let value = names.take(&identifier(&k.label));
                let [c, s] = k.symbols;
                let pair = if k.is_angle {
                    [c, s].map(|s| names.take(&identifier(knowledge.ring.symbol_name(s))))
                } else {
                    let scaled = names.take(&format!("{value}_scaled"));
                    [scaled.clone(), scaled]
                };
                symbols.extend([c, s].into_iter().zip(pair.clone()));
                Variable { pair, value, is_angle: k.is_angle }
            })
            .collect();
        let step = |solve: &Solve| {
            let found: Vec<&str> = solve.finds.iter().map(|k| known[*k].value.as_str()).collect();
            let wish = if found.len() > 2 { "joints".to_string() } else { found.join("_and_") };
            StepNames { roots: names.take(&format!("{wish}_roots")), root: names.take(&format!("{wish}_root")) }
        };
        let steps = inverse.body.solves().into_iter().map(step).collect();
        Variables { known, steps, symbols }
    }

    /// What the program calls its inputs.
    pub(in crate::render) fn inputs(&self) -> Vec<(Symbol, Code)> {
        let is_angle = |name: &String| self.known.iter().any(|k| k.is_angle && k.pair.contains(name));
        let code = |name: &String| if is_angle(name) { Code::trigonometric(name) } else { Code::atom(name) };
        self.symbols.iter().map(|(s, name)| (*s, code(name))).collect()
    }

    /// The name of a symbol.
    pub(super) fn name(&self, symbol: Symbol) -> String {
        self.symbols.iter().find(|s| s.0 == symbol).map(|s| s.1.clone()).unwrap_or_default()
    }

    /// All names, so that nothing else takes them.
    pub(in crate::render) fn taken(&self) -> impl Iterator<Item = &str> {
        let known = self.known.iter().flat_map(|k| k.pair.iter().chain([&k.value]));
        let steps = self.steps.iter().flat_map(|s| [&s.roots, &s.root]);
        RESERVED.into_iter().chain(known.chain(steps).map(String::as_str))
    }

    /// The joint values.
    pub(in crate::render) fn values(&self) -> Vec<String> {
        self.known.iter().map(|k| k.value.clone()).collect()
    }
}

/// A call of a kernel as text.
pub(in crate::render) fn call(
    dialect: Dialect,
    call: &Call<Value>,
    variables: &Variables,
    body: &Body<'_>,
    solve: &Solve,
) -> String {
    let mut arguments: Vec<String> = call
        .arguments
        .iter()
        .map(|a| argument(dialect, a, &|v| body.value(*v), &representatives(dialect, variables, solve)))
        .collect();
    if call.kernel.takes_tolerance {
        arguments.push(match dialect {
            Dialect::Rust => "sample.tolerance".into(),
            Dialect::JavaScript => "NOISE".into(),
        });
    }
    let name = match dialect {
        Dialect::Rust => format!("::dh_robot::runtime::{}", call.kernel.rust),
        Dialect::JavaScript => call.kernel.javascript.unwrap_or(call.kernel.rust).to_string(),
    };
    format!("{name}({})", arguments.join(", "))
}

/// An argument of a kernel as text.
pub(in crate::render) fn argument<N>(
    dialect: Dialect,
    a: &Argument<N>,
    number: &dyn Fn(&N) -> String,
    representatives: &str,
) -> String {
    let list = |l: &[Argument<N>]| -> String {
        let items: Vec<String> = l.iter().map(|a| argument(dialect, a, number, representatives)).collect();
        format!("[{}]", items.join(", "))
    };
    match (a, dialect) {
        (Argument::Number(n), _) => number(n),
        (Argument::Reference(l), Dialect::Rust) => format!("&{}", list(l)),
        (Argument::Array(l) | Argument::Reference(l), _) => list(l),
        (Argument::Representatives, _) => representatives.to_string(),
        (Argument::Elimination { prismatic, cuts }, _) => format!("&{prismatic:?}, {cuts:?}, sample.budget()"),
    }
}

/// What the unknowns of a step take where they are free.
fn representatives(dialect: Dialect, variables: &Variables, solve: &Solve) -> String {
    let one = |(i, k): (usize, &usize)| {
        let kind = if variables.known[*k].is_angle { "angle" } else { "length" };
        format!("sample.{kind}({})", solve.step + i)
    };
    let all: Vec<String> = solve.finds.iter().enumerate().map(one).collect();
    grouped(dialect, variables, solve, &all)
}

/// One thing per unknown of a step, as its kernel groups them: alone, an array, or a tuple of a length and an angle.
fn grouped(dialect: Dialect, variables: &Variables, solve: &Solve, all: &[String]) -> String {
    let mixed = solve.finds.len() == 2 && solve.finds.iter().any(|k| !variables.known[*k].is_angle);
    match all {
        [one] if solve.call.kernel.unknowns == 1 => one.clone(),
        _ if mixed && dialect == Dialect::Rust => format!("({})", all.join(", ")),
        _ => format!("[{}]", all.join(", ")),
    }
}

/// The roots of a step with a value for what it leaves free, as text.
pub(in crate::render) fn with_representative(dialect: Dialect, variables: &Variables, solve: &Solve) -> String {
    let roots = &variables.steps[solve.step].roots;
    let representative = match solve.call.kernel.free {
        Representative::Passed if dialect == Dialect::Rust => return roots.clone(),
        Representative::Passed => return format!("{roots}.roots"),
        Representative::Chosen => representatives(dialect, variables, solve),
        Representative::Zero => format!("[[1.0, 0.0]; {}]", solve.call.kernel.unknowns),
    };
    match dialect {
        Dialect::Rust => format!("{roots}.or_if_free({representative})"),
        Dialect::JavaScript => format!("orIfFree({roots}, {representative})"),
    }
}

/// The pattern that binds a root of a step.
pub(in crate::render) fn pattern(dialect: Dialect, variables: &Variables, solve: &Solve) -> String {
    let unknowns = solve.call.kernel.unknowns;
    let one = |k: &usize| {
        let Variable { pair: [c, s], is_angle, .. } = &variables.known[*k];
        match (is_angle, unknowns) {
            (true, _) => format!("[{c}, {s}]"),
            (false, 6) => format!("[{c}, _]"),
            (false, _) => c.clone(),
        }
    };
    let mut all: Vec<String> = solve.finds.iter().map(one).collect();
    all.resize(all.len().max(unknowns), "_".into());
    grouped(dialect, variables, solve, &all)
}

/// The statements for what the caller gives: its coordinate, cosine and sine (or the length over the length scale).
pub(super) fn given(chain: &Chain, index: usize, variable: &Variable) -> String {
    let name = if chain.settings.redundant.len() == 1 { "given".to_string() } else { format!("given[{index}]") };
    let (Variable { pair: [c, s], value, is_angle }, known) = (variable, chosen(chain, index, &name));
    let bound = if *is_angle {
        format!("let ({s}, {c}) = ::dh_robot::runtime::sin_cos({value});\n")
    } else {
        format!("let {c} = {value} / {LENGTH_SCALE};\n")
    };
    format!("let {value} = {known};\n{bound}")
}

/// What turns the numbers of a step's equation into a unit: an expression, and the unit (empty for pure numbers).
pub(in crate::render) fn unit<'a>(chain: &'a Chain, report: &Report, scale: &'a str) -> (&'a str, &'static str) {
    if report.is_length || report.distance.is_some() { (scale, chain.settings.unit.name) } else { ("1.0", "") }
}

/// The length scale in Rust: a constant of the arm.
pub(in crate::render) const LENGTH_SCALE: &str = "Self::LENGTH_SCALE";

/// Its definition, and that of its inverse, which lengths are multiplied by.
pub(super) fn length_scale(chain: &Chain, inverse: &Inverse) -> String {
    format!(
        "/// The sum of the arm's lengths, in {}: equations are solved for lengths over it, so that one tolerance fits all.\n\
         const LENGTH_SCALE: f64 = {};\n/// What a length is multiplied by.\nconst PER_LENGTH: f64 = 1.0 / {LENGTH_SCALE};\n",
        chain.settings.unit.name,
        literal(inverse.plan.axes.length_scale, Scalar::F64)
    )
}

/// The condition under which the root of a step that decides a part has its first name; `equal` compares in the language at hand.
pub(in crate::render) fn is_first(choice: &Choice, variables: &Variables, equal: &str) -> String {
    let root = |step: usize| &variables.steps[step].root;
    let first = choice.name.map_or(0, |n| n.first);
    match choice.name.and_then(|n| n.flipped_by) {
        Some(shoulder) => format!("({} {equal} {first}) {equal} ({} {equal} 0)", root(choice.step), root(shoulder)),
        None => format!("{} {equal} {first}", root(choice.step)),
    }
}

/// Which root each step took, with the names that robot controllers use.
pub(super) fn branch(choices: &[Choice], variables: &Variables) -> String {
    let mut out = String::from("::dh_robot::Branch::ANY");
    for (place, choice) in choices.iter().enumerate() {
        if place < 8 {
            out.push_str(&format!(".with_step({place}, {})", variables.steps[choice.step].root));
        }
        let (setter, first, second) = match choice.name.map(|n| n.indicator) {
            Some(Indicator::Shoulder) => ("shoulder", "Shoulder::Left", "Shoulder::Right"),
            Some(Indicator::Elbow) => ("elbow", "Elbow::Up", "Elbow::Down"),
            Some(Indicator::Wrist) => ("wrist", "Wrist::NoFlip", "Wrist::Flip"),
            None => continue,
        };
        let is_first = is_first(choice, variables, "==");
        out.push_str(&format!(
            ".with_{setter}(if {is_first} {{ ::dh_robot::{first} }} else {{ ::dh_robot::{second} }})"
        ));
    }
    out
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
