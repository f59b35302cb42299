//! The reasons why an arm gets no inverse for its task, as data, and the limits that are checked before any search.

use super::axes::Axes;
use super::mobility::Mobility;
use super::plane::Plane;
use crate::chain::{Chain, Task};

/// Joints that an inverse can leave to be solved for: a pose has six coordinates.
pub const MOST_OPEN_JOINTS: usize = 6;

/// Why there is no inverse. `render::refusal` puts it into words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// More joints are open than a pose has coordinates.
    TooManyJoints {
        /// Joints that have to be solved for.
        open: usize,
        /// Joints that the caller gives.
        given: usize,
    },
    /// The caller gives more joints than the arm can spare for its task.
    NotSpare {
        /// Joints that the caller gives.
        given: usize,
        /// Joints more than what the arm moves through, of what the task asks for.
        spare: usize,
    },
    /// `task = planar` asks for an angle about z only, and these joints (from 0) tilt the tool.
    Tilting(Vec<usize>),
    /// `task = planar` asks for the angle of the tool's x axis about z, and this axis always points along z.
    Upright,
    /// The equations never come down to one or two unknowns.
    Stuck {
        /// Joint combinations that were found before the search got stuck.
        solved: Vec<String>,
        /// Joints (from 0) that remain.
        open: Vec<usize>,
    },
    /// A plan was found, but it does not find the joint vectors of all sample poses.
    Unconfirmed {
        /// Samples that were not found.
        missed: usize,
        /// The number of them all.
        of: usize,
    },
}

/// Whether the task suits the arm at all.
///
/// # Errors
/// The first reason why it does not.
pub(super) fn check(chain: &Chain) -> Result<(), Refusal> {
    let given = chain.settings.redundant.len();
    let open = chain.dof().saturating_sub(given);
    // A plan that leaves a joint to chance would be found, and fail.
    if open > MOST_OPEN_JOINTS {
        return Err(Refusal::TooManyJoints { open, given });
    }
    if chain.settings.task == Task::Planar {
        let plane = Plane::new(chain);
        let tilting = plane.tilting_joints();
        if !tilting.is_empty() {
            return Err(Refusal::Tilting(tilting));
        }
        if plane.is_upright() {
            return Err(Refusal::Upright);
        }
    }
    Ok(())
}

/// Whether the arm can do without the joints that the caller gives.
///
/// # Errors
/// Where the others alone cannot do what all do together.
pub(super) fn check_given(chain: &Chain, axes: &Axes) -> Result<(), Refusal> {
    let given = chain.settings.redundant.len();
    if given == 0 {
        return Ok(());
    }
    let spare = chain.dof().saturating_sub(Mobility::of_joints(chain, axes, &[]).rank);
    if given > spare { Err(Refusal::NotSpare { given, spare }) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::samples::chain;
    use crate::planner::search;

    fn refusal(settings: &str, rows: &str) -> Option<Refusal> {
        let table = format!("struct A; convention = modified; {settings}\n| alpha | a | d | theta |\n{rows}");
        search(&chain(&table)).err()
    }

    #[test]
    fn tasks_that_do_not_suit_the_arm() {
        let planar = "| 0 | 0 | 0 | q1 |\n| 0 | 0.3 | 0 | q2 |\n| 0 | 0.2 | 0 | q3 |\n";
        assert_eq!(refusal("task = planar;", planar), None);
        assert_eq!(refusal("task = planar; tool = ry(90deg);", planar), Some(Refusal::Upright));
        let tilted = planar.replace("| 0 | 0.3", "| 90deg | 0.3");
        assert_eq!(refusal("task = planar;", &tilted), Some(Refusal::Tilting(vec![1, 2])));
        let rows = |n: usize| -> String {
            let row = |k| format!("| {} | 0 | {} | q{k} |\n", ["90deg", "-90deg"][k % 2], ["0.3", "0"][k % 2]);
            (1..=n).map(row).collect()
        };
        assert_eq!(refusal("", &rows(7)), Some(Refusal::TooManyJoints { open: 7, given: 0 }));
        assert_eq!(refusal("redundant = q3;", &rows(8)), Some(Refusal::TooManyJoints { open: 7, given: 1 }));
        assert_eq!(refusal("redundant = q3;", &rows(7)), None);
        assert_eq!(refusal("redundant = q3, q1;", &rows(8)), None);
        assert_eq!(refusal("redundant = q1;", &rows(6)), Some(Refusal::NotSpare { given: 1, spare: 0 }));
        assert_eq!(refusal("redundant = q1, q2;", &rows(7)), Some(Refusal::NotSpare { given: 2, spare: 1 }));
        // Where all axes are parallel, three joints move a point through two dimensions.
        assert_eq!(refusal("task = position; redundant = q3; tool = tx(0.1);", planar), None);
        assert_eq!(refusal("task = position; redundant = q1, q4, q6;", &rows(6)), None);
    }
}
