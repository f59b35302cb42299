//! The program of an inverse in Rust, node by node: nested loops over the roots of its steps.

use crate::chain::{Chain, Scalar};
use crate::program::{Instruction, Inverse, Loop, Report, Sequence, Solve, Yield};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::drive::actuators;
use crate::render::code::steps::{
    LENGTH_SCALE, Variables, branch, call, combination, given, pattern, unit, with_representative,
};

/// The private function that runs the program.
pub(super) fn candidates(chain: &Chain, inverse: &Inverse) -> String {
    let n = chain.dof();
    let redundant = match chain.settings.redundant.len() {
        0 => String::new(),
        1 => "given: f64, ".to_string(),
        n => format!("given: [f64; {n}], "),
    };
    let attempt = if chain.settings.scalar == Scalar::F32 { "single" } else { "new" };
    let variables = Variables::of(inverse);
    let body = Body::of_inverse(Dialect::Rust, chain, inverse, inverse.values(), &variables);
    let depths = inverse.depths();
    let mut printer = Printer { chain, inverse, variables, body, depths, solve: None, out: String::new() };
    printer.sequence(&inverse.body);
    format!(
        "/// Runs the plan: calls `found` with every candidate.\n\
         fn candidates(&self, t: &::dh_robot::runtime::Pose, {redundant}sample: &::dh_robot::runtime::Sample, found: &mut dyn FnMut([f64; {n}], ::dh_robot::Branch, ::dh_robot::runtime::Path)) \
         -> ::dh_robot::runtime::Attempt {{\n\
         let mut attempt = ::dh_robot::runtime::Attempt::{attempt}();\nlet path = ::dh_robot::runtime::Path::START;\n{}attempt\n}}\n",
        printer.out
    )
}

struct Printer<'a> {
    chain: &'a Chain,
    inverse: &'a Inverse,
    variables: Variables,
    body: Body<'a>,
    depths: Vec<usize>,
    /// What is being solved.
    solve: Option<&'a Solve>,
    out: String,
}

impl<'a> Printer<'a> {
    fn sequence(&mut self, sequence: &'a Sequence) {
        for instruction in &sequence.0 {
            match instruction {
                Instruction::Given { known } => {
                    self.out.push_str(&given(self.chain, *known, &self.variables.known[*known]));
                }
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

    fn solve(&mut self, solve: &'a Solve) {
        let unknowns: Vec<&str> =
            solve.finds.iter().map(|k| self.inverse.plan.knowledge.known[*k].name.as_str()).collect();
        let call = call(Dialect::Rust, &solve.call, &self.variables, &self.body, solve);
        self.out.push_str(&format!(
            "// Step {}: {} from {}.\nlet {} = {call};\n",
            solve.step + 1,
            unknowns.join(", "),
            solve.name,
            self.variables.steps[solve.step].roots
        ));
        self.solve = Some(solve);
    }

    fn reject(&mut self, report: &Report) {
        let roots = &self.variables.steps[report.step].roots;
        let (name, (scale, unit)) = (report.name(), unit(self.chain, report, LENGTH_SCALE));
        let note = match report.distance {
            Some(d) => {
                let (base, rest) = (self.body.value(d.base), self.body.value(d.rest));
                format!(
                    "note_law({roots}.outcome, &path, \"{name}\", [{base}, {rest}], {}, {scale}, \"{unit}\")",
                    d.grows
                )
            }
            None => format!("note({roots}.outcome, &path, \"{name}\", {scale}, \"{unit}\")"),
        };
        self.out.push_str(&format!("if !{roots}.is_regular() {{ attempt.{note}; }}\n"));
    }

    fn each_root(&mut self, over: &'a Loop) {
        let Some(solve) = self.solve.take() else { return };
        let names = &self.variables.steps[over.step];
        if let Some(equation) = solve.sine_equation().filter(|_| over.step > 0) {
            let equation = format!("[{}]", equation.map(|v| self.body.value(v)).join(", "));
            self.out.push_str(&format!("if path.is_chosen() {{ attempt.see({}, &path, {equation}); }}\n", over.step));
        }
        let joints: Vec<String> = over.free_joints.iter().map(ToString::to_string).collect();
        self.out.push_str(&format!(
            "let path = if {}.is_free() {{ attempt.choose({}, &path, ::dh_robot::FreeJoints::of(&[{}])) }} else {{ path }};\n",
            names.roots,
            over.step,
            joints.join(", ")
        ));
        self.out.push_str(&format!(
            "for ({}, &{}) in {}.iter().enumerate() {{\n",
            names.root,
            pattern(Dialect::Rust, &self.variables, solve),
            with_representative(Dialect::Rust, &self.variables, solve)
        ));
        if self.inverse.plan.steps[over.step].roots > 1 {
            self.out.push_str(&format!("let path = path.root({}, {});\n", over.step, names.root));
        }
        for k in &over.binds {
            let known = &self.variables.known[*k];
            let [c, s] = &known.pair;
            self.out.push_str(&if known.is_angle {
                format!("let {} = ::dh_robot::runtime::atan2({s}, {c});\n", known.value)
            } else {
                format!("let {} = {c} * {LENGTH_SCALE};\n", known.value)
            });
        }
        self.sequence(&over.body);
        self.out.push_str("}\n");
    }

    fn result(&mut self, result: &Yield) {
        let values = self.variables.values();
        let x: Vec<String> = result.joints.iter().map(|form| combination(form, &values)).collect();
        let (actuators, branch) = (actuators(self.chain, &x).join(", "), branch(&result.branch, &self.variables));
        self.out.push_str(&format!("let branch = {branch};\nfound([{actuators}], branch, path);\n"));
    }
}
