//! The kinds of steps that a plan is made of, one file each: which equations it recognises, its rank in the search, which
//! kernel solves it, how many roots it has, how it degenerates, and its name in textbooks.
//!
//! A new kind is a file here with its [`Kind`], its kernel in `dh-kernels` (and in the JavaScript runtime), and its lines in the two
//! lists below. Search, lowering, interpreter, printers, notes and plan read everything else from its file.

mod atan_pair;
mod bilinear;
mod choose;
mod general;
mod half_turn;
mod kernel;
mod length_and_angle;
mod linear;
mod quadratic;
mod recognise;
mod second_harmonic;
mod sin_cos;
mod words;

pub use kernel::{
    Argument, BatchedKernel, BatchedRoots, Call, Coefficient, Kernel, KernelRoots, Representative, Unknown,
};
pub(super) use recognise::{Offer, Row, Scene, SingleUnknown, TwoUnknowns};
pub use sin_cos::ReachLimit;
pub use words::{Slot, Wording, Words};

use super::known::Basis;
use super::scalar::FrameScalar;
use super::step::{Plan, Step};

/// Lists the kinds: the search asks them in this order, and of equally good offers the first one counts.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident = $module:ident;)*) => {
        /// What kind of equations a step solves. Every collected equation reads "sum = 0".
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum StepKind {
            $($(#[$doc])* $kind,)*
        }

        impl StepKind {
            /// All kinds.
            pub(super) const ALL: &'static [StepKind] = &[$(StepKind::$kind),*];

            /// The description in its file.
            fn kind(self) -> &'static dyn Kind {
                match self {
                    $(StepKind::$kind => &$module::$kind,)*
                }
            }
        }
    };
}

kinds! {
    /// a d + b = 0.
    Linear = linear;
    /// a d^2 + b d + c = 0.
    Quadratic = quadratic;
    /// Two or more equations a cos u + b sin u + c = 0 in the same angle.
    AtanPair = atan_pair;
    /// a cos u + b sin u = 0: half a turn apart, never out of reach. A second such equation decides where the first one vanishes.
    HalfTurn = half_turn;
    /// a cos u + b sin u + c = 0.
    SinCos = sin_cos;
    /// A trigonometric polynomial of second degree.
    SecondHarmonic = second_harmonic;
    /// Two equations, each linear in (1, cos u, sin u) and in (1, cos v, sin v).
    Bilinear = bilinear;
    /// Two equations in a prismatic joint d (up to d^2) and an angle v.
    LengthAndAngle = length_and_angle;
    /// The elimination for six joints in general position.
    General = general;
    /// The combination is free at every pose: a value is chosen.
    Choose = choose;
}

/// A kind of step.
trait Kind: Sync {
    /// The ways to find one combination of joints from equations that hold no other unknown.
    fn for_one_unknown(&self, _: &SingleUnknown<'_>) -> Vec<Offer> {
        Vec::new()
    }

    /// The best way to find two combinations from two equations that hold no other unknown.
    fn for_two_unknowns(&self, _: &TwoUnknowns<'_>) -> Option<Offer> {
        None
    }

    /// The step that is taken where no equation holds one or two unknowns.
    fn fallback(&self, _: &Scene<'_>) -> Option<Step> {
        None
    }

    /// The basis functions that the coefficients of one equation belong to, in their order.
    fn columns(&self) -> Vec<Vec<Basis>>;

    /// The call of its kernel for a number of equations; `is_angle` says whether the (first) unknown is an angle.
    fn call(&self, equations: usize, is_angle: bool) -> Call<Coefficient>;

    /// The kernel that solves it for many branches side by side, if there is one. `constant` gives the coefficients that are 1, 0 or -1.
    fn batched(
        &self,
        _equations: usize,
        _is_angle: bool,
        _constant: &dyn Fn(usize, usize) -> Option<i8>,
    ) -> Option<BatchedKernel> {
        None
    }

    /// Whether the numbers of its equations measure a length; otherwise they are pure numbers.
    fn measures_length(&self, step: &Step) -> bool {
        step.equations.iter().any(|e| !matches!(e.scalar, FrameScalar::Rotation(..)))
    }

    /// The distance behind the step, if it is a law of cosines.
    fn reach_limit(&self, _: &Plan, _: &Step) -> Option<ReachLimit> {
        None
    }

    /// Whether one solution is found from more equations than unknowns, of which special poses may leave too few.
    fn is_overdetermined(&self) -> bool {
        false
    }

    /// Its name in the literature. `is_distance` says whether its equations state the distance of two origins.
    fn words(&self, is_distance: bool) -> Words;
}

impl StepKind {
    pub(super) fn for_one_unknown(self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        self.kind().for_one_unknown(at)
    }

    pub(super) fn for_two_unknowns(self, at: &TwoUnknowns<'_>) -> Option<Offer> {
        self.kind().for_two_unknowns(at)
    }

    pub(super) fn fallback(self, at: &Scene<'_>) -> Option<Step> {
        self.kind().fallback(at)
    }

    /// The basis functions that the coefficients of one equation belong to, in their order.
    pub fn columns(self) -> Vec<Vec<Basis>> {
        self.kind().columns()
    }

    /// The call of its kernel for a number of equations; `is_angle` says whether the (first) unknown is an angle.
    pub fn call(self, equations: usize, is_angle: bool) -> Call<Coefficient> {
        self.kind().call(equations, is_angle)
    }

    /// The kernel that solves it for many branches side by side. `constant` gives the coefficients that are 1, 0 or -1, by equation and
    /// place.
    pub fn batched(
        self,
        equations: usize,
        is_angle: bool,
        constant: &dyn Fn(usize, usize) -> Option<i8>,
    ) -> Option<BatchedKernel> {
        self.kind().batched(equations, is_angle, constant)
    }

    pub(super) fn is_overdetermined(self) -> bool {
        self.kind().is_overdetermined()
    }
}

impl Step {
    /// Whether every equation states the distance of two origins.
    pub fn is_distance(&self) -> bool {
        !self.equations.is_empty() && self.equations.iter().all(|e| e.scalar == FrameScalar::Distance)
    }

    /// Whether the numbers of its equations measure a length; otherwise they are pure numbers.
    pub fn measures_length(&self) -> bool {
        self.kind.kind().measures_length(self)
    }

    /// The distance behind the step, if it is a law of cosines.
    pub fn reach_limit(&self, plan: &Plan) -> Option<ReachLimit> {
        self.kind.kind().reach_limit(plan, self)
    }

    /// Its name in the literature.
    pub fn words(&self) -> Words {
        self.kind.kind().words(self.is_distance())
    }

    /// Whether it solves for all remaining unknowns from the whole pose instead of chosen equations.
    pub fn is_elimination(&self) -> bool {
        self.equations.is_empty() && self.unknown.len() > 2
    }
}
