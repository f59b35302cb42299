//! The fast way of `inverse`: every step for all branches side by side, in loops over lanes (see `dh_robot::runtime::lanes`).
//!
//! Steps and values with the same number of lanes share one loop. Long loops are what compilers turn into vector instructions well;
//! short ones they unroll first, and find less in what they then see.

mod loops;
mod motors;
mod ranges;
mod segments;
mod step;
mod twin;
mod writer;

use crate::algebra::Poly;
use crate::chain::{Chain, Scalar, Task};
use crate::planner::BatchedKernel;
use crate::program::{Inverse, Solve, Value};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::steps::{Variables, branch, given, length_scale};
use motors::whole_motors;
use segments::What;
use writer::Writer;

/// Most branches side by side.
const MOST: usize = 16;

/// Can the plan go the fast way? All steps have one or two roots by formula, and the whole pose confirms a branch.
pub(super) fn fits(chain: &Chain, inverse: &Inverse) -> bool {
    chain.task == Task::Pose
        && inverse.body.result().is_some_and(|r| whole_motors(chain, &r.joints).is_some())
        && (chain.redundant.is_none() || chain.is_direct())
        && inverse.plan.axes.count() == chain.dof()
        && inverse.body.solves().iter().all(|solve| kernel(inverse, solve).is_some())
        && branches(inverse) <= MOST
}

/// The batched kernel of a step.
fn kernel(inverse: &Inverse, solve: &Solve) -> Option<BatchedKernel> {
    let constant = |row: usize, place: usize| -> Option<i8> {
        let p = inverse.graph.as_constant(*solve.equations.get(row)?.get(place)?)?;
        [(0, Poly::zero()), (1, Poly::one()), (-1, -&Poly::one())].into_iter().find(|(_, n)| p == *n).map(|(n, _)| n)
    };
    inverse.plan.steps.get(solve.step)?.kind.batched(solve.equations.len(), &constant)
}

/// How many branches a plan has.
pub(super) fn branches(inverse: &Inverse) -> usize {
    inverse.plan.steps.iter().map(|s| s.roots).product()
}

/// The statements of `inverse` that follow `frame`: the fast way, and the robust one where that has to decide.
pub(super) fn call(chain: &Chain, inverse: &Inverse) -> String {
    let (n, total) = (chain.dof(), branches(inverse));
    let [number, same] = if chain.redundant.is_some() { [", given.into()", ", given"] } else { [""; 2] };
    let mut out = format!(
        "let mut q = [[0.0; {total}]; {n}];\nlet mut valid = [0.0; {total}];\n\
         if !self.lanes(&frame{number}, &mut q, &mut valid) {{\nreturn self.robust(target{same});\n}}\n"
    );
    if inverse.plan.max_solutions == total {
        // Written out, so that the list is made where the caller wants it: nothing is copied.
        let list: Vec<String> = (0..total).map(|l| format!("at({l})")).collect();
        out.push_str(&format!(
            "if valid == [1.0; {total}] {{\n\
             let at = |l: usize| ::dh_robot::runtime::lanes::solution(&Self::JOINTS, &q, &Self::BRANCHES, l);\n\
             return ::dh_robot::Solutions::full(&Self::JOINTS, [{}]);\n}}\n",
            list.join(", ")
        ));
    }
    out.push_str("::dh_robot::runtime::lanes::collect(&Self::JOINTS, &valid, &q, &Self::BRANCHES)\n");
    out
}

/// The constant `BRANCHES` and the function `lanes`.
pub(super) fn lanes(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let mut outputs: Vec<Value> = inverse.body.solves().iter().flat_map(|s| s.equations.concat()).collect();
    let confirmation = confirmation(inverse, &outputs);
    outputs.extend(confirmation.iter().map(|(_, v)| *v));
    let live = inverse.graph.live(&outputs);
    let variables = Variables::of(inverse);
    let mut body = Body::of_inverse(Dialect::Rust, chain, inverse, outputs, &variables);
    let joints = inverse.body.result().map(|r| r.joints.clone()).unwrap_or_default();
    let motors = whole_motors(chain, &joints).unwrap_or_default();
    let mut w = Writer::new(inverse, variables, motors, confirmation, live);
    let (n, total) = (chain.dof(), branches(inverse));
    let parameter = if chain.redundant.is_some() { ", given: f64" } else { "" };
    w.loops.out = constant(inverse, &w.variables, total);
    w.loops.out.push_str(&format!(
        "/// The plan for all branches at once: joint values, and which branches are real; false where the robust way has to decide.\n\
         #[inline]\nfn lanes(&self, t: &::dh_robot::runtime::Pose{parameter}, q: &mut [[f64; {total}]; {n}], valid: &mut [f64; {total}]) -> bool {{\n"
    ));
    if let Some(k) = chain.redundant {
        // A narrower scalar is brought into its range with the others, once it is rounded.
        let value = match chain.scalar {
            Scalar::F64 => format!("Self::JOINTS[{k}].normalize(given)"),
            Scalar::F32 => "given".into(),
        };
        let known: String =
            w.variables.known.iter().take(plan.given).map(|v| given(chain, v, &length_scale(inverse))).collect();
        w.loops.out.push_str(&format!("{}q[{k}] = [{value}; {total}];\n", known));
        w.written.insert(k);
    }
    w.loops.enter(0, 1, false);
    // What needs nothing, or only what is given.
    for depth in 0..=plan.given {
        body.statements(&w.depths, depth);
        w.loops.out.push_str(&body.take_text());
        w.tell(&body, depth);
    }
    let last = w.items.last().map_or(0, |item| item.segment);
    for item in w.items.clone() {
        w.loops.enter(item.segment, item.lanes, item.segment == last);
        match item.what {
            What::Step(i) => w.step(&mut body, chain, i),
            What::Depth(depth) => w.depth(&mut body, depth),
            What::Finish => w.finish(chain, total),
        }
    }
    w.loops.close();
    let valid = if w.loops.lanes == total {
        "valid_".into()
    } else {
        format!("::core::array::from_fn(|l| valid_[l % {}])", w.loops.lanes)
    };
    w.loops.out.push_str(&format!(
        "*valid = {valid};\n::dh_robot::runtime::lanes::confirmed(&valid_, &margin_, &error_)\n}}\n"
    ));
    w.loops.out
}

/// The names of all branches, which are decided when the program is compiled.
fn constant(inverse: &Inverse, variables: &Variables, total: usize) -> String {
    let (mut roots, mut before) = (String::new(), 1);
    for (i, step) in inverse.plan.steps.iter().enumerate() {
        if step.roots > 1 {
            let root = &variables.steps[i].root;
            roots.push_str(&format!("let {root} = l / {before} % {};\n", step.roots));
        }
        before *= step.roots;
    }
    format!(
        "const BRANCHES: [::dh_robot::Branch; {total}] = {{\nlet mut all = [::dh_robot::Branch::ANY; {total}];\nlet mut l = 0;\n\
         while l < {total} {{\n{roots}all[l] = {};\nl += 1;\n}}\nall\n}};\n",
        branch(inverse.body.result().map_or(&[][..], |r| &r.branch), variables)
    )
}

/// The entries of the pose that confirm a branch, with their places: two columns of the rotation fix the third, so the one that costs
/// most is left out.
fn confirmation(inverse: &Inverse, rows: &[Value]) -> Vec<(usize, Value)> {
    let without = |column: usize| -> Vec<(usize, Value)> {
        inverse.confirmation.iter().copied().enumerate().filter(|(k, _)| k / 3 != column).collect()
    };
    let cost = |column: &usize| {
        let outputs: Vec<Value> = rows.iter().copied().chain(without(*column).iter().map(|(_, v)| *v)).collect();
        inverse.graph.live(&outputs).iter().filter(|live| **live).count()
    };
    without((0..3).min_by_key(cost).unwrap_or(0))
}
