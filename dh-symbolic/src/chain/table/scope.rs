//! The scope of a table: what each declared name means while cells are read.

use super::sum::Sum;
use crate::algebra::Rational;
use crate::chain::{LengthUnit, MotionSpec};
use crate::diagnostic::Place;

/// What a declared name measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `let a2: length`.
    Length,
    /// `let beta: angle`.
    Angle,
    /// `let k: number`, or a constant without a unit: a coefficient, or a length in the table's unit.
    Number,
}

/// A name that `let` declared.
#[derive(Clone, Debug)]
pub(super) struct Declared {
    /// The name.
    pub(super) name: String,
    /// What it measures.
    pub(super) kind: Kind,
    /// True: a field of the struct, unknown while the macro runs.
    pub(super) field: bool,
    /// Value of a constant, or nominal value of a field.
    pub(super) value: Option<Sum>,
    /// False where the `let` line was wrong: cells that use the name are not checked any further.
    pub(super) sound: bool,
    /// The name's place.
    pub(super) place: Place,
}

impl Declared {
    /// The value in table units, for lengths and numbers that have one.
    pub(super) fn number(&self) -> Option<Rational> {
        let terms = &self.value.as_ref()?.terms;
        (self.kind != Kind::Angle).then(|| terms.iter().fold(Rational::ZERO, |x, t| &x + &t.factor))
    }

    /// The value of a constant (not of a field) in table units.
    pub(super) fn constant(&self) -> Option<Rational> {
        if self.field { None } else { self.number() }
    }
}

/// A pose that `let` declared.
#[derive(Clone, Debug)]
pub(super) struct DeclaredPose {
    /// The name.
    pub(super) name: String,
    /// Its nominal value.
    pub(super) value: Option<Vec<MotionSpec>>,
    /// The name's place.
    pub(super) place: Place,
}

/// The names in scope and the unit of bare lengths.
pub(super) struct Scope {
    /// `let` lines so far.
    pub(super) names: Vec<Declared>,
    /// Poses among them, which are no factors of cells.
    pub(super) poses: Vec<DeclaredPose>,
    /// The table's unit.
    pub(super) unit: LengthUnit,
}

impl Scope {
    /// The index of a name.
    pub(super) fn find(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|d| d.name == name)
    }

    /// The index of a pose.
    pub(super) fn pose(&self, name: &str) -> Option<usize> {
        self.poses.iter().position(|p| p.name == name)
    }

    /// Where a name was declared, if it was.
    pub(super) fn place(&self, name: &str) -> Option<Place> {
        let number = self.names.iter().find(|d| d.name == name).map(|d| d.place);
        number.or_else(|| self.poses.iter().find(|p| p.name == name).map(|p| p.place))
    }

    /// Replaces constants among the names of a product by their values: what is left are fields.
    pub(super) fn fold_constants(&self, factor: &Rational, names: &[usize]) -> (Rational, Vec<usize>) {
        let (mut factor, mut rest) = (factor.clone(), Vec::new());
        for &i in names {
            match self.names.get(i).and_then(Declared::constant) {
                Some(x) => factor = &factor * &x,
                None => rest.push(i),
            }
        }
        (factor, rest)
    }
}
