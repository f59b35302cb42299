//! A plan as instructions: for each step the coefficients of its equations, computed from the target and from what is known.
//!
//! All lengths are over the arm's reach, so that one tolerance fits all. Known combinations enter as symbols of their cosine and
//! sine; which symbols an instruction needs tells at which depth of the search it is computed.

mod confirmation;
mod general;
mod known_pose;
mod lower;
mod pose;
mod row;

use super::graph::{Graph, Value, ZERO};
use super::{Names, Node};
use crate::algebra::{Poly, Symbol};
use crate::chain::Chain;
use crate::planner::{self, Collected, Form, Knowledge, KnownPose, Plan, Refusal, StepKind, combination};
use lower::{Lower, Pose};

/// The equations of one step, ready to be solved.
#[derive(Clone, Debug)]
pub struct Solver {
    /// What kind.
    pub kind: StepKind,
    /// Coefficients, one row per equation; their order belongs to the kind, see [`Inverse::derive`].
    pub rows: Vec<Vec<Value>>,
    /// The combinations it finds: indices into the plan's knowledge.
    pub finds: Vec<usize>,
    /// For a law of cosines: what to add to the side without the unknown to get the squared distance, and whether the amplitude of the
    /// other side grows with that distance.
    pub law: Option<(Value, bool)>,
}

impl Solver {
    /// Everything that has to be computed for the step.
    pub fn values(&self) -> Vec<Value> {
        self.rows.iter().flatten().copied().chain(self.law.map(|law| law.0)).collect()
    }
}

/// A plan with its instructions.
#[derive(Clone, Debug)]
pub struct Inverse {
    /// The plan.
    pub plan: Plan,
    /// The instructions.
    pub graph: Graph,
    /// Symbols of the target's entries: rotation by rows, then position.
    pub target: [Symbol; 12],
    /// The steps.
    pub solvers: Vec<Solver>,
    /// Each real coordinate as a combination of known ones.
    pub joints: Vec<Vec<i8>>,
    /// The pose that the known combinations give (12 values, columns first, lengths over the reach): what a branch is confirmed by.
    pub confirmation: Vec<Value>,
    /// For the general elimination: which of its joints slide.
    pub slides: [bool; 6],
    /// For the general elimination: the best ways to cut the loop of joints (`dh_kernels::general::Choice`).
    pub choices: [u8; 3],
    /// How the roots of shoulder, elbow and wrist are named.
    pub names: [Names; 3],
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

    /// Lowers a plan. Rows are, with "sum = 0":
    ///
    /// * `Linear` a, b of a d + b; `Quadratic` a, b, c;
    /// * `HalfTurn` a, b; `SinCos` and every row of `AtanPair` a, b, c of a cos u + b sin u + c;
    /// * `SecondHarmonic` the coefficients of 1, cos u, sin u, cos 2u, sin 2u;
    /// * `Bilinear` and `SlideAndTurn` nine: (1, cos u, sin u) or (1, d, d^2) times (1, cos v, sin v), the second factor running faster;
    /// * `General` seven poses of twelve entries (columns, then position): the constant transforms behind joints 1 to 6, then
    ///   the target.
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
        let mut solvers = Vec::new();
        for step in &plan.steps {
            for pose in poses_of(&step.collected, &plan.knowledge) {
                l.bind_pose(w, &pose, step.before);
            }
            let finds = (step.before..step.before + step.unknown.len()).collect();
            let rows = match step.kind {
                StepKind::General => l.general(w, step),
                _ => step.collected.iter().map(|c| l.row(step.kind, c)).collect(),
            };
            let law = super::law::law(&plan, step).map(|law| (l.formula(&law.base), law.grows));
            solvers.push(Solver { kind: step.kind, rows, finds, law });
        }
        let forms: Vec<Form> = plan.knowledge.known.iter().map(|k| k.form.clone()).collect();
        let joints = (0..plan.axes.real)
            .map(|k| {
                let mut unit = vec![0i8; plan.axes.count()];
                unit[k] = 1;
                combination(&unit, &forms).unwrap_or_default()
            })
            .collect();
        let confirmation = l.confirmation(chain);
        let graph = l.g;
        let (slides, choices, names) = ([false; 6], [0; 3], [Names::PLAIN; 3]);
        let mut inverse = Inverse { graph, target, solvers, joints, confirmation, slides, choices, names, plan };
        inverse.slides = inverse.sliding();
        inverse.choices = inverse.best_choices(chain);
        inverse.names = inverse.find_names(chain);
        inverse
    }

    /// Which joints of the general elimination slide.
    fn sliding(&self) -> [bool; 6] {
        let mut slides = [false; 6];
        for step in self.plan.steps.iter().filter(|s| s.kind == StepKind::General) {
            for (slide, form) in slides.iter_mut().zip(&step.unknown) {
                *slide = form.iter().position(|k| *k != 0).is_some_and(|k| !self.plan.axes.turns(k));
            }
        }
        slides
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
}

/// The known poses that occur in some equations.
fn poses_of(collected: &[Collected], knowledge: &Knowledge) -> Vec<KnownPose> {
    let mut symbols: Vec<Symbol> = collected.iter().flat_map(|c| c.values().flat_map(Poly::symbols)).collect();
    symbols.sort_unstable();
    symbols.dedup();
    let used = |k: &KnownPose| k.symbols().any(|s| symbols.binary_search(&s).is_ok());
    knowledge.poses.iter().filter(|k| used(k)).cloned().collect()
}
