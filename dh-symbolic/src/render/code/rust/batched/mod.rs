//! The fast path of `inverse`: the batched program printed as loops over branches (see `dh_robot::runtime::batched`).

mod actuators;
mod loops;
mod ranges;
mod step;
mod writer;

use crate::chain::{Chain, Scalar};
use crate::program::{Batched, Inverse, Value, What};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::steps::{Variables, branch, given};
use actuators::{Actuator, whole_actuators};
use writer::BatchedWriter;

/// A program that can go the fast path.
pub(super) struct FastPath {
    batched: Batched,
    actuators: Vec<Actuator>,
}

impl FastPath {
    /// The fast path of an inverse, if there is one: its steps can be batched, and actuators are sums of what is found.
    pub(super) fn of(chain: &Chain, inverse: &Inverse) -> Option<FastPath> {
        let actuators = whole_actuators(chain, &inverse.body.result()?.joints)?;
        let fits = |b: &Batched| chain.settings.redundant.is_empty() && b.free.is_empty() || chain.is_direct();
        let batched = inverse.batched(chain.settings.task).filter(fits)?;
        Some(FastPath { batched, actuators })
    }

    /// Whether any value does for some joints.
    pub(super) fn is_free(&self) -> bool {
        !self.batched.free.is_empty()
    }

    /// How many branches it has.
    pub(super) fn branches(&self) -> usize {
        self.batched.branches
    }

    /// The statements of `inverse` that follow `frame`: the fast path, and the fallback path where that has to decide.
    pub(super) fn call(&self, chain: &Chain, inverse: &Inverse) -> String {
        let (n, total) = (chain.dof(), self.batched.branches);
        let number = passed(chain);
        let same = if chain.settings.redundant.is_empty() { "" } else { ", given" };
        let mut out = format!(
            "let mut q = [[0.0; {total}]; {n}];\nlet mut valid = [0.0; {total}];\n\
             if !self.all_branches(&frame{number}, &mut q, &mut valid) {{\nreturn self.inverse_with_work(target{same}).0;\n}}\n"
        );
        if self.is_free() {
            let free: Vec<String> = self.batched.free.iter().map(usize::to_string).collect();
            out.push_str(&format!(
                "let list = ::dh_robot::runtime::batched::collect_free(&Self::JOINTS, &valid, &q, &Self::BRANCHES, ::dh_robot::FreeJoints::of(&[{}]));\n\
                 if !::dh_robot::runtime::batched::free_in_range(&list) {{\nreturn self.inverse_with_work(target{same}).0;\n}}\nlist\n",
                free.join(", ")
            ));
            return out;
        }
        if inverse.plan.max_solutions == total {
            // Written out, so that the list is made where the caller wants it: nothing is copied.
            let list: Vec<String> = (0..total).map(|k| format!("at({k})")).collect();
            out.push_str(&format!(
                "if valid == [1.0; {total}] {{\n\
                 let at = |branch: usize| ::dh_robot::runtime::batched::solution(&Self::JOINTS, &q, &Self::BRANCHES, branch);\n\
                 return ::dh_robot::Solutions::full(&Self::JOINTS, [{}]);\n}}\n",
                list.join(", ")
            ));
        }
        out.push_str("::dh_robot::runtime::batched::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)\n");
        out
    }

    /// The constant `BRANCHES` and the function `all_branches`.
    pub(super) fn items(self, chain: &Chain, inverse: &Inverse) -> String {
        let (plan, batched) = (&inverse.plan, &self.batched);
        let outputs: Vec<Value> = batched
            .solves
            .iter()
            .flat_map(|s| s.needs.iter().copied())
            .chain(batched.confirmation.iter().map(|r| r.value))
            .collect();
        let variables = Variables::of(inverse);
        let mut body = Body::of_inverse(Dialect::Rust, chain, inverse, outputs, &variables);
        let (n, total) = (chain.dof(), batched.branches);
        let parameter = match chain.settings.redundant.len() {
            0 => String::new(),
            1 => ", given: f64".to_string(),
            k => format!(", given: [f64; {k}]"),
        };
        let mut w = BatchedWriter::new(chain, inverse, batched, variables, self.actuators);
        w.loops.out = names(inverse, &w.variables, total);
        w.loops.out.push_str(&format!(
            "/// The plan for all branches at once: joint values, and which branches are real; false where the fallback path has to decide.\n\
             #[inline]\nfn all_branches(&self, t: &::dh_robot::runtime::Pose{parameter}, q: &mut [[f64; {total}]; {n}], valid: &mut [f64; {total}]) -> bool {{\n"
        ));
        for (i, v) in w.variables.known.iter().enumerate().take(plan.given) {
            w.loops.out.push_str(&given(chain, i, v));
        }
        for (i, k) in chain.settings.redundant.iter().copied().enumerate() {
            let name = if chain.settings.redundant.len() == 1 { "given".to_string() } else { format!("given[{i}]") };
            // A narrower scalar is brought into its range with the others, once it is rounded.
            let value = match chain.settings.scalar {
                Scalar::F64 => format!("Self::JOINTS[{k}].normalize({name})"),
                Scalar::F32 => name,
            };
            w.loops.out.push_str(&format!("q[{k}] = [{value}; {total}];\n"));
            w.written.insert(k);
        }
        w.loops.enter(0, 1, false);
        // What needs nothing, or only what is given.
        for depth in 0..=plan.given {
            body.statements(&batched.depths, depth);
            w.loops.out.push_str(&body.take_text());
            w.confirm(&body, depth);
        }
        let last = batched.items.last().map_or(0, |item| item.in_loop);
        for item in &batched.items {
            w.loops.enter(item.in_loop, item.width, item.in_loop == last);
            match item.what {
                What::Step(i) => w.step(&mut body, i),
                What::Values(depth) => w.values(&mut body, depth),
                What::Finish => w.finish(),
            }
        }
        w.loops.close();
        let valid = if w.loops.width == total {
            "all_valid".into()
        } else {
            format!("::core::array::from_fn(|branch| all_valid[branch % {}])", w.loops.width)
        };
        w.loops.out.push_str(&format!(
            "*valid = {valid};\n::dh_robot::runtime::batched::confirmed(&all_valid, &all_margin, &all_error)\n}}\n"
        ));
        w.loops.out
    }
}

/// How the joint values that the caller gives are passed on.
pub(super) fn passed(chain: &Chain) -> &'static str {
    match chain.settings.redundant.len() {
        0 => "",
        1 => ", given.into()",
        _ => ", given.map(|x| x.into())",
    }
}

/// The names of all branches, which are decided when the program is compiled.
fn names(inverse: &Inverse, variables: &Variables, total: usize) -> String {
    let (mut roots, mut before) = (String::new(), 1);
    for (i, step) in inverse.plan.steps.iter().enumerate() {
        if step.roots > 1 {
            roots.push_str(&format!("let {} = branch / {before} % {};\n", variables.steps[i].root, step.roots));
        }
        before *= step.roots;
    }
    format!(
        "/// Which root each step takes in each branch.\n\
         const BRANCHES: [::dh_robot::Branch; {total}] = {{\nlet mut all = [::dh_robot::Branch::ANY; {total}];\nlet mut branch = 0;\n\
         while branch < {total} {{\n{roots}all[branch] = {};\nbranch += 1;\n}}\nall\n}};\n",
        branch(inverse.body.result().map_or(&[][..], |r| &r.branch), variables)
    )
}
