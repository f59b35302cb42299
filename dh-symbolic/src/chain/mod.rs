//! What a robot is: a [`Chain`] of links and joints, exact, with every name in one ring.
//!
//! **In:** a [`ChainSpec`] (typed rows, from `table` or written by hand). **Out:** a [`Chain`].
//!
//! **Never here:** tokens (only `table/` reads them), formulas of products (that is `kinematics`), floats.

mod around;
mod build;
mod convention;
#[cfg(test)]
pub(crate) mod samples;
mod spec;
pub mod table;
#[cfg(test)]
pub(crate) mod tests;

pub use around::{Factor, PoseField};
pub use convention::{Convention, Elementary};
pub use spec::*;

use crate::algebra::{AngleVar, LinearAngle, Poly, Ring, Symbol, determinant};

/// A serial robot, ready for algebra.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Type name.
    pub name: String,
    /// Which of the two Denavit-Hartenberg conventions the rows follow.
    pub convention: Convention,
    /// What the table sets for the robot as a whole.
    pub settings: Settings,
    /// Names of all symbols and angles of this robot's formulas.
    pub ring: Ring,
    /// Declared lengths and angles, and those that numeric cells gave rise to.
    pub parameters: Vec<Parameter>,
    /// The rows of the table, in order.
    pub links: Vec<Link>,
    /// The moving rows, in order.
    pub joints: Vec<Joint>,
    /// Coupling: the joint coordinate x_i (angle theta_i or the moving part of d_i) is sum_j `drive[i][j]` q_j + shift_i.
    /// The identity matrix for ordinary arms.
    pub drive: Vec<Vec<Poly>>,
    /// Constant transform before the first row: what stands in `base` behind the last pose that the program sets.
    pub base: Vec<Elementary>,
    /// Constant transform after the last row: what stands in `tool` before the first pose that the program sets.
    pub tool: Vec<Elementary>,
    /// Poses that the program sets.
    pub poses: Vec<PoseField>,
    /// What stands in `base` up to the last pose that the program sets; formulas are without it.
    pub before: Vec<Factor>,
    /// What stands in `tool` from the first pose on that the program sets; formulas are without it.
    pub after: Vec<Factor>,
}

/// One row of the table, in the symbols of the ring. What the four columns mean depends on the convention.
#[derive(Clone, Debug)]
pub struct Link {
    /// Link twist.
    pub alpha: LinearAngle,
    /// Link length.
    pub a: Poly,
    /// Link offset (for a sliding joint: with its variable).
    pub d: Poly,
    /// Joint angle (for a turning joint: with its variable).
    pub theta: LinearAngle,
    /// Index of the joint of this row; `None` for a fixed row.
    pub joint: Option<usize>,
}

/// A moving row.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Name of the variable, `q3`.
    pub name: String,
    /// Index of its row.
    pub row: usize,
    /// The joint coordinate of the formulas: the angle theta_i, or the sliding variable in d_i.
    pub coordinate: Coordinate,
    /// Constant part of the joint angle that is kept out of the formulas, since its sine is not exact: the coordinate is
    /// the drive's combination of the q plus this. Zero for sliding joints and for offsets of whole 15-degree steps.
    pub shift: AngleCell,
    /// Range of q, in radians or table units.
    pub range: Option<(Bound, Bound)>,
    /// What the table calls the row, where that is not its number: `shoulder`.
    pub label: Option<String>,
}

/// The coordinate of a joint in formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinate {
    /// A turning joint.
    Angle(AngleVar),
    /// A sliding joint.
    Length(Symbol),
}

/// A named length or angle.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name; for a numeric cell the name of the cell's quantity (`a2`, `d4`, `alpha3`).
    pub name: String,
    /// Where it stands in the ring.
    pub handle: Handle,
    /// Declared without `= value` (a field), with one, or a constant.
    pub role: Role,
    /// False for the ones that numeric cells gave rise to.
    pub declared: bool,
    /// Whether it is a coordinate of the tool's point, which the poses that the program sets determine.
    pub of_point: bool,
}

/// Where a parameter stands in the ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// A length.
    Length(Symbol),
    /// An angle.
    Angle(AngleVar),
}

impl Chain {
    /// Builds the chain: names every quantity and finds the groups of parallel axes.
    pub fn new(spec: ChainSpec) -> Chain {
        build::build(spec)
    }

    /// The same robot with other settings.
    pub fn with(&self, settings: Settings) -> Chain {
        Chain { settings, ..self.clone() }
    }

    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.joints.len()
    }

    /// The nominal value of a parameter in table units or radians; 0 for fields without one.
    pub fn nominal(&self, handle: Handle) -> f64 {
        let value = self.parameters.iter().find(|p| p.handle == handle).and_then(|p| match &p.role {
            Role::Field(v) => v.as_ref(),
            Role::Constant(v) => Some(v),
        });
        match value {
            Some(Nominal::Length(x)) => x.to_f64(),
            Some(Nominal::Angle(cell)) => cell.radians(),
            None => 0.0,
        }
    }

    /// Whether every joint has its own actuator, without coupling.
    pub fn is_direct(&self) -> bool {
        self.drive
            .iter()
            .enumerate()
            .all(|(i, row)| row.iter().enumerate().all(|(j, p)| if i == j { p.is_one() } else { p.is_zero() }))
    }

    /// The joint coordinates that the actuators which the caller chooses move alone, and how far: a coordinate is that factor times the
    /// actuator's position, plus the joint's shift.
    pub fn chosen(&self) -> Vec<(usize, Poly)> {
        let one = |actuator: &usize| {
            let alone = |row: &[Poly]| row.iter().enumerate().all(|(j, k)| (j == *actuator) != k.is_zero());
            let joint = self.drive.iter().position(|row| alone(row))?;
            Some((joint, self.drive.get(joint)?.get(*actuator)?.clone()))
        };
        self.settings.redundant.iter().filter_map(one).collect()
    }

    /// Whether a whole turn of this actuator leaves the arm where it was. False where it drives a prismatic joint, or turns a row by a fraction of a turn.
    pub fn is_periodic(&self, actuator: usize) -> bool {
        let mut periodic = false;
        for (joint, row) in self.joints.iter().zip(&self.drive) {
            let Some(k) = row.get(actuator).filter(|k| !k.is_zero()) else { continue };
            let whole = k.as_rational().is_some_and(|r| r.to_f64().fract() == 0.0);
            if !(whole && matches!(joint.coordinate, Coordinate::Angle(_))) {
                return false;
            }
            periodic = true;
        }
        periodic
    }

    /// Whether a whole turn of some row is not a whole number of actuator turns (gears, actuators that turn and lift together).
    pub fn is_geared(&self) -> bool {
        let revolute = |i: usize| matches!(self.joints[i].coordinate, Coordinate::Angle(_));
        let rows: Vec<usize> = (0..self.dof()).filter(|i| revolute(*i)).collect();
        let actuators: Vec<usize> =
            (0..self.dof()).filter(|k| rows.iter().any(|i| !self.drive[*i][*k].is_zero())).collect();
        let whole = actuators.iter().all(|k| self.is_periodic(*k));
        let block: Vec<Vec<Poly>> =
            rows.iter().map(|i| actuators.iter().map(|k| self.drive[*i][*k].clone()).collect()).collect();
        let unit = rows.len() == actuators.len() && {
            let det = determinant(&block, usize::MAX).unwrap_or_default();
            det.is_one() || (-&det).is_one()
        };
        !(whole && unit)
    }

    /// The factors of row `i` (from 0), in order.
    pub fn link_factors(&self, i: usize) -> Vec<Elementary> {
        self.convention.factors(&self.links[i])
    }
}
