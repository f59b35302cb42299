//! The program of an inverse in JavaScript, node by node, as the Rust backend prints it.

use super::text::string;
use crate::chain::Chain;
use crate::program::{Choice, Indicator, Instruction, Inverse, Loop, Report, Sequence, Solve, Yield};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::drive::{actuators, chosen};
use crate::render::code::steps::{
    Variable, Variables, call, combination, is_first, pattern, unit, with_representative,
};

/// The method that runs the program: it calls `take` with every candidate.
pub(super) fn candidates(chain: &Chain, inverse: &Inverse) -> String {
    let variables = Variables::of(inverse);
    let body = Body::of_inverse(Dialect::JavaScript, chain, inverse, inverse.values(), &variables);
    let (depths, scale) = (inverse.depths(), LENGTH_SCALE);
    let (solve, free) = (None, "free".to_string());
    let mut printer = Printer { chain, inverse, variables, body, depths, scale, solve, free, out: String::new() };
    printer.sequence(&inverse.body);
    format!(
        "// Runs the plan for the frame t (lengths over the length scale): calls `take` with every candidate.\n\
         candidates(t, given, sample, take) {{\n{}let attempt = new Attempt(), free = [];\n{}return attempt;\n}}\n",
        super::arm::fields(chain),
        printer.out
    )
}

/// The length scale, a field of the arm.
const LENGTH_SCALE: &str = "this.lengthScale";

struct Printer<'a> {
    chain: &'a Chain,
    inverse: &'a Inverse,
    variables: Variables,
    body: Body<'a>,
    depths: Vec<usize>,
    scale: &'static str,
    /// What is being solved.
    solve: Option<&'a Solve>,
    /// The variable that holds the joints which were free before.
    free: String,
    out: String,
}

impl<'a> Printer<'a> {
    fn sequence(&mut self, sequence: &'a Sequence) {
        for instruction in &sequence.0 {
            match instruction {
                Instruction::Given { known } => self.given(*known),
                Instruction::Compute { known, .. } => {
                    self.body.statements(&self.depths, *known);
                    self.out.push_str(&self.body.take_text());
                }
                Instruction::Solve(solve) => self.solve(solve),
                Instruction::Reject(report) => self.reject(report),
                Instruction::ForEachRoot(over) => self.each_root(over),
                Instruction::Yield(result) => self.result(result),
            }
        }
    }

    fn given(&mut self, known: usize) {
        let Variable { pair: [c, s], value, is_angle } = &self.variables.known[known];
        self.out.push_str(&format!("const {value} = {};\n", chosen(self.chain, known, &format!("given[{known}]"))));
        self.out.push_str(&if *is_angle {
            format!("const {c} = Math.cos({value}), {s} = Math.sin({value});\n")
        } else {
            format!("const {c} = {value} / {};\n", self.scale)
        });
    }

    fn solve(&mut self, solve: &'a Solve) {
        let unknowns: Vec<&str> =
            solve.finds.iter().map(|k| self.inverse.plan.knowledge.known[*k].name.as_str()).collect();
        let call = call(Dialect::JavaScript, &solve.call, &self.variables, &self.body, solve);
        self.out.push_str(&format!(
            "// Step {}: {} from {}.\nconst {} = {call};\n",
            solve.step + 1,
            unknowns.join(", "),
            solve.name,
            self.variables.steps[solve.step].roots
        ));
        self.solve = Some(solve);
    }

    fn reject(&mut self, report: &Report) {
        let (roots, free) = (&self.variables.steps[report.step].roots, &self.free);
        let (name, (scale, unit)) = (string(&report.name()), unit(self.chain, report, self.scale));
        let unit = string(unit);
        let note = match report.distance {
            Some(d) => {
                let (base, rest) = (self.body.value(d.base), self.body.value(d.rest));
                format!("noteDistance({roots}, {free}, {name}, [{base}, {rest}], {}, {scale}, {unit})", d.grows)
            }
            None => format!("note({roots}, {free}, {name}, {scale}, {unit})"),
        };
        self.out.push_str(&format!("if ({roots}.outcome !== REGULAR) {{\nattempt.{note};\n}}\n"));
    }

    fn each_root(&mut self, over: &'a Loop) {
        let Some(solve) = self.solve.take() else { return };
        let names = &self.variables.steps[over.step];
        let joints: Vec<String> = over.free_joints.iter().map(ToString::to_string).collect();
        let free = format!("free_{}", over.step + 1);
        self.out.push_str(&format!(
            "const {free} = {}.outcome === FREE ? [...{}, {}] : {};\nfor (const [{}, {}] of {}.entries()) {{\n",
            names.roots,
            self.free,
            joints.join(", "),
            self.free,
            names.root,
            pattern(Dialect::JavaScript, &self.variables, solve),
            with_representative(Dialect::JavaScript, &self.variables, solve)
        ));
        for k in &over.binds {
            let Variable { pair: [c, s], value, is_angle } = &self.variables.known[*k];
            self.out.push_str(&if *is_angle {
                format!("const {value} = Math.atan2({s}, {c});\n")
            } else {
                format!("const {value} = {c} * {};\n", self.scale)
            });
        }
        let outer = std::mem::replace(&mut self.free, free);
        self.sequence(&over.body);
        self.free = outer;
        self.out.push_str("}\n");
    }

    fn result(&mut self, result: &Yield) {
        let values = self.variables.values();
        let x: Vec<String> = result.joints.iter().map(|form| combination(form, &values)).collect();
        let (actuators, branch) = (actuators(self.chain, &x).join(", "), branch(&result.branch, &self.variables));
        self.out.push_str(&format!("take([{actuators}], {branch}, {});\n", self.free));
    }
}

/// Which root each step took, and the names that robot controllers use.
fn branch(choices: &[Choice], variables: &Variables) -> String {
    let mut parts = Vec::new();
    for choice in choices {
        let (part, first, second) = match choice.name.map(|n| n.indicator) {
            Some(Indicator::Shoulder) => ("shoulder", "left", "right"),
            Some(Indicator::Elbow) => ("elbow", "up", "down"),
            Some(Indicator::Wrist) => ("wrist", "no flip", "flip"),
            None => continue,
        };
        let is_first = is_first(choice, variables, "===");
        parts.push(format!("{part}: {is_first} ? \"{first}\" : \"{second}\""));
    }
    let steps: Vec<&str> = choices.iter().map(|c| variables.steps[c.step].root.as_str()).collect();
    parts.push(format!("steps: [{}]", steps.join(", ")));
    format!("{{ {} }}", parts.join(", "))
}
