//! What follows from a table once and for all, and what has to be computed again when a parameter changes.

use dh_robot::Joint;
use dh_symbolic::TableError;
use dh_symbolic::algebra::Angle;
use dh_symbolic::chain::{Bound, Chain, Nominal, Role, Task};
use dh_symbolic::planner::Step;
use dh_symbolic::program::{Forward, Inverse};

use crate::actuators::Actuators;
use crate::batched::FastPath;
use crate::intern;
use crate::plan::FlatPlan;
use crate::straight::{Coordinates, Straight, StraightNumbers};
use crate::values::Values;

/// The proven programs of an arm in flat form.
pub(crate) struct Model {
    pub(crate) chain: Chain,
    pub(crate) joints: &'static [Joint],
    pub(crate) pose: Straight,
    pub(crate) frames: Straight,
    pub(crate) jacobian: Straight,
    /// The inverse, `None` where the table asks for none, or why there is none.
    pub(crate) inverse: Result<Option<InverseModel>, TableError>,
}

/// The flat form of an inverse.
pub(crate) struct InverseModel {
    pub(crate) inverse: Inverse,
    pub(crate) plan: FlatPlan,
    pub(crate) fast: Option<FastPath>,
    pub(crate) eliminates: bool,
}

/// The numbers that programs need of the arm's parameters.
pub(crate) struct Numbers {
    pub(crate) coordinates: Coordinates,
    pub(crate) actuators: Actuators,
    pub(crate) pose: StraightNumbers,
    pub(crate) frames: StraightNumbers,
    pub(crate) jacobian: StraightNumbers,
    pub(crate) plan: Vec<f64>,
    pub(crate) fast: Vec<f64>,
}

impl Model {
    /// The programs of a chain, in flat form.
    pub(crate) fn new(chain: Chain, forward: &Forward, inverse: Result<Option<Inverse>, TableError>) -> Model {
        let joint = |(i, joint): (usize, &dh_symbolic::chain::Joint)| {
            let name = intern::name(&joint.name);
            let kind = if chain.is_periodic(i) { Joint::revolute(name) } else { Joint::prismatic(name) };
            let labelled = kind.with_label(joint.label.as_deref().map_or("", intern::name));
            match &joint.range {
                Some((least, greatest)) => labelled.with_range(bound(least), bound(greatest)),
                None => labelled,
            }
        };
        let joints: Vec<Joint> = chain.joints.iter().enumerate().map(joint).collect();
        let flat = |inverse: Inverse| {
            let plan = FlatPlan::new(&chain, &inverse);
            let fast = FastPath::new(&chain, &inverse, &plan);
            let eliminates = inverse.plan.steps.iter().any(Step::is_elimination);
            InverseModel { inverse, plan, fast, eliminates }
        };
        Model {
            joints: intern::joints(&joints),
            pose: Straight::new(&chain, &forward.pose),
            frames: Straight::new(&chain, &forward.frames),
            jacobian: Straight::new(&chain, &forward.jacobian),
            inverse: inverse.map(|inverse| inverse.map(flat)),
            chain,
        }
    }

    /// The inverse, where there is one.
    pub(crate) fn inverse(&self) -> Option<&InverseModel> {
        self.inverse.as_ref().ok().and_then(Option::as_ref)
    }

    /// The nominal values of all parameters; not a number where the table gives none.
    pub(crate) fn nominal(&self) -> Vec<f64> {
        let value = |p: &dh_symbolic::chain::Parameter| match p.role {
            Role::Field(None) => f64::NAN,
            _ => self.chain.nominal(p.handle),
        };
        self.chain.parameters.iter().map(value).collect()
    }

    /// The numbers for these values of the parameters.
    pub(crate) fn numbers(&self, list: &[f64]) -> Numbers {
        let values = Values { chain: &self.chain, list, per_length: 1.0 };
        let inverse = self.inverse();
        Numbers {
            coordinates: Coordinates::new(&values),
            actuators: Actuators::new(&values),
            pose: self.pose.numbers(&values),
            frames: self.frames.numbers(&values),
            jacobian: self.jacobian.numbers(&values),
            plan: inverse.map_or_else(Vec::new, |i| i.plan.numbers(&values)),
            fast: inverse.and_then(|i| i.fast.as_ref()).map_or_else(Vec::new, |f| f.numbers(&values)),
        }
    }

    /// What the inverse is asked for.
    pub(crate) fn task(&self) -> Task {
        self.chain.settings.task
    }
}

/// The value of a bound.
fn bound(b: &Bound) -> f64 {
    match b {
        Bound::HalfTurns(x) => Angle::half_turns(x.clone()).radians(),
        Bound::Radians(x) | Bound::Length(x) => x.to_f64(),
    }
}

/// Whether a parameter is a field, and whether it is a length.
pub(crate) fn field(p: &dh_symbolic::chain::Parameter) -> Option<bool> {
    let length = matches!(p.handle, dh_symbolic::chain::Handle::Length(_));
    match &p.role {
        Role::Field(Some(Nominal::Length(_) | Nominal::Angle(_)) | None) => Some(length),
        Role::Constant(_) => None,
    }
}
