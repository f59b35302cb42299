//! Source locations of the parts of a chain, so that later stages can point at a cell.

use crate::diagnostic::Place;

/// A column of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Label of the row.
    Joint,
    /// Link twist.
    Alpha,
    /// Link length.
    A,
    /// Link offset.
    D,
    /// Joint angle.
    Theta,
    /// Range of the variable.
    Range,
}

impl Column {
    /// All columns, in the usual order.
    pub const ALL: [Column; 6] = [Column::Joint, Column::Alpha, Column::A, Column::D, Column::Theta, Column::Range];

    /// The name in the header.
    pub fn name(self) -> &'static str {
        match self {
            Column::Joint => "joint",
            Column::Alpha => "alpha",
            Column::A => "a",
            Column::D => "d",
            Column::Theta => "theta",
            Column::Range => "range",
        }
    }
}

/// Places of all that was written.
#[derive(Clone, Debug)]
pub struct Origins {
    /// The robot's name.
    pub name: Place,
    /// The header of the table.
    pub header: Place,
    /// Per row: the whole row, and its cells.
    pub(super) rows: Vec<(Place, Vec<(Column, Place)>)>,
    /// The values of the settings, by name.
    pub(super) settings: Vec<(String, Place)>,
    /// The names of the `let` lines, in order.
    pub parameters: Vec<Place>,
    /// Per joint: its row and the column where it moves.
    pub(super) joints: Vec<(usize, Column)>,
}

impl Origins {
    /// A row (from 0); the header where there is no such row.
    pub fn row(&self, row: usize) -> Place {
        self.rows.get(row).map_or(self.header, |r| r.0)
    }

    /// A cell; the row where the table has no such column.
    pub fn cell(&self, row: usize, column: Column) -> Place {
        let cells = self.rows.get(row).map_or(&[][..], |r| r.1.as_slice());
        cells.iter().find(|c| c.0 == column).map_or_else(|| self.row(row), |c| c.1)
    }

    /// The cell where joint `joint` (from 0) has its variable.
    pub fn joint(&self, joint: usize) -> Place {
        self.joints.get(joint).map_or(self.header, |(row, column)| self.cell(*row, *column))
    }

    /// The value of a setting; the robot's name where it was not written.
    pub fn setting(&self, name: &str) -> Place {
        self.settings.iter().find(|s| s.0 == name).map_or(self.name, |s| s.1)
    }
}
