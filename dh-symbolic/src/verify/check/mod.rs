//! Checks the lines of a hand derivation against the chain: proven, wrong (with the difference and the smallest repair), or not
//! understood.
//!
//! **In:** a [`Chain`] and a [`Derivation`]. **Out:** a [`Report`] with one [`Verdict`] per line. The notation is described in
//! [`verify::language`](crate::verify::language).
//!
//! Equality of formulas is equality of normal forms, so a verdict is a decision, not an estimate; only `~`, `<` and `>` look at
//! numbers. No verdict rests on the algebra alone: both sides are evaluated at many poses as well, by a program that shares nothing with
//! the normal form. A proof that fails at a pose is none, conditions must be met by a pose, and what holds at some is not called wrong.

mod approximate;
mod blame;
mod compare;
mod configuration;
mod direct;
mod either;
mod evaluate;
mod functions;
mod jacobian;
mod line;
mod number;
mod point;
mod ratio;
mod refusal;
mod repair;
mod repair_at_poses;
mod root;
mod scope;
mod settle;
mod substitute;
#[cfg(test)]
mod tests;
mod value;

#[cfg(feature = "documents")]
pub(super) use approximate::NO_VALUE;
pub use ratio::Ratio;
pub use settle::Pair;

use crate::algebra::{Angle, AngleVar, Poly, Ring, Symbol};
use crate::chain::{Chain, Coordinate, Joint};
use crate::kinematics::Kinematics;
use crate::program::Indicator;
use crate::verify::language::{Derivation, NotUnderstood, Place, Token};
use std::collections::BTreeMap;

/// What was found about a derivation.
#[derive(Clone, Debug)]
pub struct Report {
    /// The names that the formulas of the verdicts use: the chain's, and those that the derivation added.
    pub ring: Ring,
    /// The groups of the joints' angles, from base to tip: the order in which formulas are written.
    pub groups: Vec<u16>,
    /// One verdict per line.
    pub verdicts: Vec<Verdict>,
    /// The rows of the Jacobian that J stands for at the end, from 1: 1 to 3 linear, 4 to 6 angular.
    pub jacobian_rows: Vec<usize>,
}

impl Report {
    /// How many lines are wrong.
    pub fn wrong(&self) -> usize {
        self.verdicts.iter().filter(|v| matches!(v, Verdict::Wrong(_))).count()
    }

    /// Is no line wrong or not understood?
    pub fn is_fine(&self) -> bool {
        self.verdicts.iter().all(|v| !matches!(v, Verdict::Wrong(_) | Verdict::NotUnderstood(..)))
    }
}

/// What was found about one line.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// A definition or a setting; nothing is claimed.
    Noted,
    /// The line holds for all values of the variables; or where some conditions are met, which they can be.
    Proven(Where),
    /// The line holds at the given values, to the given digits.
    Agrees,
    /// The line does not hold: here (in a matrix there may be several places; one at least).
    Wrong(Vec<Fault>),
    /// The line cannot be read, means nothing, or cannot be decided; with a change that makes it right, where one was found.
    NotUnderstood(NotUnderstood, Option<Repair>),
}

/// Where a line holds: everywhere, if there are no conditions.
#[derive(Clone, Debug, Default)]
pub struct Where {
    /// All of them are to be met.
    pub conditions: Vec<Condition>,
    /// A pose of the arm at which they are met.
    pub example: Option<Example>,
    /// The configurations in which exactly they are met, where these have names: the part of the arm, and whether it is on its first side
    /// (left, up, not flipped).
    pub configuration: Vec<(Indicator, bool)>,
}

impl Where {
    /// For all values of the variables.
    pub fn everywhere() -> Where {
        Where::default()
    }

    /// Under conditions.
    pub(self) fn under(conditions: Vec<Condition>) -> Where {
        Where { conditions, ..Where::default() }
    }

    /// Without any condition?
    pub fn is_everywhere(&self) -> bool {
        self.conditions.is_empty()
    }
}

/// A pose of the arm.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// Name, value (radians or table units), and whether it is an angle.
    pub joints: Vec<(String, f64, bool)>,
}

/// A formula that must not be negative (strict: that must be positive).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Condition {
    /// The formula.
    pub formula: Poly,
    /// Is zero excluded?
    pub strict: bool,
}

/// One place where a line does not hold.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The tokens of the printed formula (of the entry, where it is an entry of a written matrix).
    pub place: Place,
    /// Row and column, from 1, where matrices are compared.
    pub entry: Option<(usize, usize)>,
    /// What is wrong.
    pub kind: FaultKind,
    /// The smallest change that makes it right, where one was found.
    pub repair: Option<Repair>,
}

/// What is wrong at a place.
#[derive(Clone, Debug)]
pub enum FaultKind {
    /// Two formulas differ.
    Formula {
        /// What the line says.
        printed: Ratio,
        /// What follows from the table.
        correct: Ratio,
        /// printed - correct.
        difference: Ratio,
    },
    /// Two angles differ; where they are given by their sides there is no difference in radians, and this is a formula that
    /// would be zero if they were equal.
    Angle(Ratio),
    /// Two angles differ by half a turn.
    Opposite,
    /// Two angles differ, by more than a short formula says: a pose, and both angles there.
    AngleAt(Box<Example>, Pair),
    /// A definition with which a later line (by its number in the derivation) is wrong, and which the repair makes right.
    Definition(usize),
    /// The line is wrong because of the definition in an earlier line (by its number in the derivation).
    Follows(usize),
    /// The line holds nowhere: a pose, and both sides there.
    Nowhere(Box<Example>, Pair),
    /// Of several possibilities none holds at this pose.
    None(Box<Example>),
    /// Two numbers differ by more than their rounding.
    Number {
        /// What the line says.
        printed: f64,
        /// What follows from the table and the given values.
        correct: f64,
        /// How far they may be apart.
        tolerance: f64,
        /// Are they angles in radians?
        angle: bool,
    },
    /// `!=` between equal formulas.
    Same,
    /// `<` and the like: the two values.
    Order {
        /// Left.
        left: f64,
        /// Right.
        right: f64,
    },
    /// The quantity is of the other kind: true where it is an angle.
    Kind(bool),
}

/// A change of the text that makes a line right.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// One or two edits, in order.
    pub edits: Vec<Edit>,
}

/// Other tokens in place of some.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// The tokens that go; empty: an insertion before `place.start`.
    pub place: Place,
    /// The tokens that come; empty: a deletion.
    pub tokens: Vec<Token>,
}

/// Checks a derivation.
pub fn check(chain: &Chain, derivation: &Derivation) -> Report {
    report(Evaluator::new(chain, &derivation.tokens), derivation)
}

/// The same without looking for the changes that make wrong lines right: for many lines of which only the verdicts matter.
pub fn check_without_repairs(chain: &Chain, derivation: &Derivation) -> Report {
    let mut e = Evaluator::new(chain, &derivation.tokens);
    e.searched = usize::MAX;
    report(e, derivation)
}

fn report<'a>(mut e: Evaluator<'a>, derivation: &'a Derivation) -> Report {
    let mut verdicts: Vec<Verdict> = derivation.lines.iter().map(|l| e.line(l)).collect();
    e.blame_definitions(derivation, &mut verdicts);
    let group = |j: &Joint| match j.coordinate {
        Coordinate::Angle(v) => Some(v.group()),
        Coordinate::Length(_) => None,
    };
    let jacobian_rows = e.rows.iter().map(|i| i + 1).collect();
    Report { ring: e.ring, groups: e.chain.joints.iter().filter_map(group).collect(), verdicts, jacobian_rows }
}

/// A square root in a formula: a symbol whose square is the radicand, and which is not negative.
#[derive(Clone, Debug)]
struct Root {
    symbol: Symbol,
    radicand: Ratio,
}

/// Everything that the meaning of a line depends on.
struct Evaluator<'a> {
    chain: &'a Chain,
    tokens: &'a [Token],
    kinematics: Kinematics,
    ring: Ring,
    transforms: BTreeMap<(usize, usize), value::Matrix>,
    /// The variables q1, q2, ...
    joints: Vec<value::Value>,
    locals: Vec<(String, value::Value)>,
    /// The same names as they were written, for evaluation in numbers.
    meanings: Vec<(String, direct::Meaning<'a>)>,
    /// Poses at which lines are tried, and whether the arm has the lengths of the table there.
    spots: Vec<Option<(direct::Spot, bool)>>,
    /// Angles without exact sine, by their size.
    constants: Vec<(AngleVar, Angle)>,
    roots: Vec<Root>,
    given: Vec<point::Given>,
    work: ratio::Work,
    /// Words read in search of repairs.
    searched: usize,
    /// The rows of the Jacobian that J stands for, from 0.
    rows: Vec<usize>,
    /// Those that a matrix of the derivation has shown.
    shown_rows: Vec<usize>,
}

impl<'a> Evaluator<'a> {
    fn new(chain: &'a Chain, tokens: &'a [Token]) -> Evaluator<'a> {
        let mut ring = chain.ring.clone();
        // an actuator variable of a coupled drive may be a sum of angles and lengths: angles then count in radians
        for v in chain.ring.angles() {
            if !chain.is_direct() {
                ring.symbol(chain.ring.angle_name(v));
            }
        }
        let radians = |t: &value::Turn| {
            let symbol = |v: AngleVar| ring.find_symbol(ring.angle_name(v)).map_or_else(Poly::zero, Poly::symbol);
            t.terms.iter().map(|(v, k)| symbol(*v).scale(k)).sum::<Poly>().into()
        };
        let joints = scope::joint_variables(chain, radians).unwrap_or_default();
        Evaluator {
            chain,
            tokens,
            kinematics: Kinematics::new(chain),
            ring,
            transforms: BTreeMap::new(),
            joints,
            locals: Vec::new(),
            meanings: Vec::new(),
            spots: Vec::new(),
            constants: scope::constant_angles(chain),
            roots: Vec::new(),
            given: Vec::new(),
            work: ratio::Work::new(),
            searched: 0,
            rows: jacobian::ALL.to_vec(),
            shown_rows: jacobian::ALL.to_vec(),
        }
    }
}
