//! A robot as written: typed cells, before it has a ring. What `table` produces and what a program may build by hand.

use super::Convention;
use crate::algebra::{Angle, Rational};

/// A robot as written.
#[derive(Clone, Debug)]
pub struct ChainSpec {
    /// Type name.
    pub name: String,
    /// Which convention the rows follow.
    pub convention: Convention,
    /// What applies to the robot as a whole.
    pub settings: Settings,
    /// `let` lines in order. Cells refer to them by index.
    pub parameters: Vec<ParameterSpec>,
    /// Rows in order.
    pub rows: Vec<RowSpec>,
    /// Constant transform before the first row.
    pub base: Vec<MotionSpec>,
    /// Constant transform after the last row.
    pub tool: Vec<MotionSpec>,
    /// Poses that the program sets: factors of `base` and `tool` refer to them by index.
    pub poses: Vec<PoseSpec>,
}

/// What a table sets for the robot as a whole, beside its convention, which has no default. One field for each setting.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Unit of bare lengths and of every length at the API.
    pub unit: LengthUnit,
    /// Number type at the API.
    pub scalar: Scalar,
    /// What `inverse` is asked for.
    pub task: Task,
    /// Numbers (from 0) of the variables that the caller chooses, in the order of its arguments.
    pub redundant: Vec<usize>,
    /// Whether inverse kinematics is wanted.
    pub ik: bool,
}

/// What holds where a table is silent.
impl Default for Settings {
    fn default() -> Settings {
        Settings {
            unit: LengthUnit { name: "m", metres: Rational::ONE },
            scalar: Scalar::F64,
            task: Task::Pose,
            redundant: Vec::new(),
            ik: true,
        }
    }
}

/// One row as written. Variables are numbered from 0: `q1` is 0.
#[derive(Clone, Debug, Default)]
pub struct RowSpec {
    /// Column `alpha`.
    pub alpha: AngleCell,
    /// Column `a`.
    pub a: LengthCell,
    /// Column `d`, without the variable part.
    pub d: LengthCell,
    /// Column `theta`, without the variable part.
    pub theta: AngleCell,
    /// Moving rows: which column moves and the combination of variables that drives it.
    pub moves: Option<Drive>,
    /// Range of the variable with this row's number, in radians or table units.
    pub range: Option<(Bound, Bound)>,
    /// What column `joint` calls the row, where that is not its number: `shoulder`.
    pub label: Option<String>,
}

/// The variable part of a moving cell.
#[derive(Clone, Debug)]
pub struct Drive {
    /// True: column `theta` moves; false: column `d`.
    pub revolute: bool,
    /// Combination of variables: (number of the variable from 0, coefficient). An ordinary joint has one term with coefficient 1.
    pub terms: Vec<(usize, LengthCell)>,
}

/// A constant angle: exact part + approximate part + declared angles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AngleCell {
    /// Multiple of pi, as a factor of pi.
    pub half_turns: Option<Rational>,
    /// `approx 1.2rad`: radians.
    pub approx: Option<Rational>,
    /// Declared angles: (index in `parameters`, whole factor).
    pub symbols: Vec<(usize, i8)>,
}

impl AngleCell {
    /// The exact part.
    pub fn exact(&self) -> Angle {
        Angle::half_turns(self.half_turns.clone().unwrap_or(Rational::ZERO))
    }

    /// The value in radians, without declared angles.
    pub fn radians(&self) -> f64 {
        self.exact().radians() + self.approx.as_ref().map_or(0.0, Rational::to_f64)
    }

    /// Whether the angle is written as 0.
    pub fn is_zero(&self) -> bool {
        self.exact().is_zero() && self.approx.as_ref().is_none_or(Rational::is_zero) && self.symbols.is_empty()
    }
}

/// A length (or a dimensionless coefficient): a polynomial in declared lengths with exact coefficients in table units.
/// Each term: coefficient and the indices in `parameters` of its factors. Empty: 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LengthCell {
    /// The terms.
    pub terms: Vec<(Rational, Vec<usize>)>,
}

impl LengthCell {
    /// A number in table units.
    pub fn number(x: Rational) -> LengthCell {
        LengthCell { terms: if x.is_zero() { vec![] } else { vec![(x, vec![])] } }
    }
}

/// A bound of a range: an exact angle or a length in table units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Factor of pi.
    HalfTurns(Rational),
    /// Radians, approximately.
    Radians(Rational),
    /// Table units.
    Length(Rational),
}

/// One factor of `base` or `tool`.
#[derive(Clone, Debug)]
pub enum MotionSpec {
    /// Translation along axis 0, 1, 2.
    Translate(usize, LengthCell),
    /// Rotation about axis 0, 1, 2.
    Rotate(usize, AngleCell),
    /// A pose that the program sets: its index in `poses`.
    Pose(usize),
}

/// `let gripper: pose = tz(120mm);`: a rigid motion that the program sets.
#[derive(Clone, Debug)]
pub struct PoseSpec {
    /// The name.
    pub name: String,
    /// Its nominal value, constant motions.
    pub nominal: Option<Vec<MotionSpec>>,
}

/// A `let` line.
#[derive(Clone, Debug)]
pub struct ParameterSpec {
    /// The name.
    pub name: String,
    /// Length or angle.
    pub quantity: Quantity,
    /// Field or constant.
    pub role: Role,
}

/// What a parameter measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A length in table units, or a dimensionless number.
    Length,
    /// An angle.
    Angle,
}

/// How a parameter gets its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// `let a2: length;` or `let a2: length = 431.8mm;`: a public field, with its nominal value.
    Field(Option<Nominal>),
    /// `let a2 = 431.8mm;` or a number in a cell: folded into the code.
    Constant(Nominal),
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Nominal {
    /// Table units.
    Length(Rational),
    /// An angle without declared angles in it.
    Angle(AngleCell),
}

/// Unit of lengths.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LengthUnit {
    /// As written: `mm`.
    pub name: &'static str,
    /// In metres.
    pub metres: Rational,
}

/// Number type at the API.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// Double precision.
    F64,
    /// Single precision.
    F32,
}

/// What `inverse` is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// The whole pose.
    Pose,
    /// The position of the tool.
    Position,
    /// x, y and the angle about z.
    Planar,
    /// The position and the direction of the last z axis.
    Axis,
}
