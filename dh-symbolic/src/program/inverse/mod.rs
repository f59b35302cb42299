//! A plan as a program: values computed from the target and from what is known, and the tree that solves for the rest.
//!
//! All lengths are over the arm's length scale, so that one tolerance fits all. Known combinations enter as symbols of their cosine and
//! sine; the symbols an instruction needs determine at which depth of the search it is computed.

mod batched;
mod branches;
mod confirmation;
mod general;
mod interpret;
mod ir;
mod known_pose;
mod lower;
mod pose;
mod row;
mod step;
mod text;

pub use batched::{Batched, BatchedSolve, Item, Mirror, Residual, What};
pub(crate) use branches::sides;
pub use interpret::{InterpretedRun, InterpretedSolution, Shortfall, TOLERANCE};
pub use ir::{Choice, Distance, Indicator, Instruction, Loop, Naming, Report, Sequence, Solve, Yield};

use super::Node;
use super::graph::{Graph, Value, ZERO};
use crate::algebra::Symbol;
use crate::chain::Chain;
use crate::planner::{self, JointCombination, Plan, Refusal, combination};
use lower::{Lower, Pose};

/// A plan as a program.
#[derive(Clone, Debug)]
pub struct Inverse {
    /// The plan.
    pub plan: Plan,
    /// The values.
    pub graph: Graph,
    /// Symbols of the target's entries: rotation by rows, then position.
    pub target: [Symbol; 12],
    /// What is done with them.
    pub body: Sequence,
    /// The pose that the known combinations give (12 values, columns first, lengths over the length scale): what a branch is confirmed by.
    pub confirmation: Vec<Value>,
}

/// Sample poses whose joint vectors a plan must find again.
const SAMPLES: usize = 6;

impl Inverse {
    /// Plans an arm, lowers the plan and tries it on sample poses: what the macro, plans, notes and pages rest on.
    ///
    /// # Errors
    /// Why there is no inverse, a plan that missed samples among it.
    pub fn of(chain: &Chain) -> Result<Inverse, Refusal> {
        let inverse = Inverse::derive(chain, planner::search(chain)?);
        match inverse.check(chain, SAMPLES) {
            Ok(()) => Ok(inverse),
            Err((missed, of)) => Err(Refusal::Unconfirmed { missed, of }),
        }
    }

    /// Lowers a plan.
    pub fn derive(chain: &Chain, plan: Plan) -> Inverse {
        let mut plan = plan;
        let ring = &mut plan.knowledge.ring;
        let names = ["g11", "g12", "g13", "g21", "g22", "g23", "g31", "g32", "g33", "gx", "gy", "gz"];
        let target = names.map(|n| {
            let mut name = n.to_string();
            while ring.find_symbol(&name).is_some() {
                name.push('_');
            }
            ring.symbol(&name)
        });
        let mut l = Lower { g: Graph::new(chain), plan: &plan, bound: Vec::new() };
        let entry = |l: &mut Lower<'_>, i: usize| l.g.symbol(target[i]);
        let mut w = Pose { columns: [[ZERO; 3]; 3], p: [ZERO; 3] };
        for j in 0..3 {
            w.columns[j] = std::array::from_fn(|i| entry(&mut l, 3 * i + j));
        }
        w.p = std::array::from_fn(|i| entry(&mut l, 9 + i));
        // The target as the first frame and the last one see it.
        let w = l.after_inverse(w, &plan.axes.end);
        let w = l.before_inverse(w, &plan.axes.start);
        let steps: Vec<(Solve, Report)> = (0..plan.steps.len()).map(|i| l.step(w, i)).collect();
        let confirmation = l.confirmation(chain);
        let graph = l.g;
        let body = Sequence::default();
        let mut inverse = Inverse { graph, target, body, confirmation, plan };
        inverse.body = inverse.tree(steps);
        inverse.choose_cuts(chain);
        inverse.name_branches(chain);
        inverse
    }

    /// The values of all steps.
    pub fn values(&self) -> Vec<Value> {
        let reports = self.body.reports();
        let of = |solve: &Solve| -> Vec<Value> {
            let report = reports.iter().find(|r| r.step == solve.step);
            solve.equations.concat().into_iter().chain(report.into_iter().flat_map(|r| r.values())).collect()
        };
        self.body.solves().into_iter().flat_map(of).collect()
    }

    /// How many known combinations must be there before each node can be computed.
    pub fn depths(&self) -> Vec<usize> {
        let mut depth = Vec::with_capacity(self.graph.nodes().len());
        for node in self.graph.nodes() {
            let d = match *node {
                Node::Symbol(s) => {
                    self.plan.knowledge.known.iter().position(|k| k.symbols.contains(&s)).map_or(0, |i| i + 1)
                }
                Node::Add(a, b) => usize::max(depth[a.node as usize], depth[b.node as usize]),
                Node::Mul(a, b) => usize::max(depth[a as usize], depth[b as usize]),
                Node::Constant(_) | Node::Cos(_) | Node::Sin(_) => 0,
            };
            depth.push(d);
        }
        depth
    }

    /// The tree: one loop in the other, each value as soon as it can be computed.
    fn tree(&self, steps: Vec<(Solve, Report)>) -> Sequence {
        let depths = self.depths();
        let values: Vec<Value> =
            steps.iter().flat_map(|(s, r)| s.equations.concat().into_iter().chain(r.values())).collect();
        let live = self.graph.live(&values);
        let compute = |known: usize| {
            let nodes = (0..depths.len()).filter(|k| live[*k] && depths[*k] == known).map(|k| k as u32).collect();
            Instruction::Compute { known, nodes }
        };
        let choices = self.plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1);
        let branch = choices.map(|(step, _)| Choice { step, name: None }).collect();
        let mut inner = Sequence(vec![Instruction::Yield(Yield { joints: self.joints(), branch })]);
        for (solve, report) in steps.into_iter().rev() {
            let (step, binds) = (solve.step, solve.finds.clone());
            let mut body: Vec<Instruction> = binds.iter().map(|k| compute(k + 1)).collect();
            body.append(&mut inner.0);
            let axes = &self.plan.axes;
            let unknown = &self.plan.steps[step].unknown;
            let free_joints = unknown.iter().flat_map(|f| (0..axes.real).filter(|k| f[*k] != 0)).collect();
            let over = Loop { step, binds, free_joints, body: Sequence(body) };
            inner =
                Sequence(vec![Instruction::Solve(solve), Instruction::Reject(report), Instruction::ForEachRoot(over)]);
        }
        let mut first = vec![compute(0)];
        for known in 0..self.plan.given {
            first.extend([Instruction::Given { known }, compute(known + 1)]);
        }
        first.append(&mut inner.0);
        Sequence(first)
    }

    /// Each real coordinate as a combination of known ones.
    fn joints(&self) -> Vec<JointCombination> {
        let axes = &self.plan.axes;
        let forms: Vec<JointCombination> = self.plan.knowledge.known.iter().map(|k| k.form.clone()).collect();
        (0..axes.real)
            .map(|k| {
                let mut unit = vec![0i8; axes.count()];
                unit[k] = 1;
                combination(&unit, &forms).unwrap_or_default()
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::samples::{PUMA, UR5, chain};
    use crate::chain::tests::revolute_chain;

    fn program(chain: &Chain) -> String {
        Inverse::of(chain).unwrap_or_else(|e| panic!("{e:?}")).to_string()
    }

    #[test]
    fn program_of_a_puma() {
        insta::assert_snapshot!(program(&chain(PUMA)));
    }

    #[test]
    fn program_of_a_ur5() {
        insta::assert_snapshot!(program(&chain(UR5)));
    }

    #[test]
    fn batched_programs() {
        let text = [PUMA, UR5].map(|table| {
            let chain = chain(table);
            let inverse = Inverse::of(&chain).unwrap_or_else(|e| panic!("{e:?}"));
            inverse.batched(chain.settings.task).map_or(String::new(), |b| b.to_string())
        });
        insta::assert_snapshot!(text.join("\n"));
    }

    #[test]
    fn program_of_a_general_arm() {
        let rows = [
            (40, "0.3", "0.1", 0),
            (-70, "0.5", "0.2", 0),
            (110, "0.2", "0.3", 0),
            (55, "0.1", "0.4", 0),
            (-85, "0.2", "0.05", 0),
            (25, "0.1", "0.3", 0),
        ];
        insta::assert_snapshot!(program(&revolute_chain(Convention::Standard, &rows)));
    }
}
