//! Tests of the list of solutions: order, ties, ranges, capacity.

use core::f64::consts::PI;

use super::*;
use crate::{Elbow, FreeJoints};

static JOINTS: [Joint; 3] = [
    Joint::revolute("q1"),
    Joint::revolute("q2").with_range(-1.5 * PI, 1.5 * PI),
    Joint::prismatic("q3").with_range(0.0, 0.5),
];

fn list(rows: &[[f64; 3]]) -> Solutions<f64, 3, 4> {
    let mut solutions = Solutions::new(&JOINTS);
    for (i, q) in rows.iter().enumerate() {
        solutions.push(Solution::new(*q, Branch::ANY.with_step(0, i)));
    }
    solutions
}

fn indices(solutions: &Solutions<f64, 3, 4>) -> Vec<usize> {
    solutions.iter().filter_map(|s| s.branch.step(0)).collect()
}

#[test]
fn pushing_beyond_the_capacity_changes_nothing() {
    let full = list(&[[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]]);
    let mut more = full;
    assert!(!more.push(Solution::default()));
    assert!(!more.insert(Solution::new([9.0; 3], Branch::ANY), 1e-9));
    assert_eq!(more, full);
    let mut none: Solutions<f64, 3, 0> = Solutions::new(&JOINTS);
    assert!(!none.push(Solution::default()));
    assert!(none.is_empty() && none.closest_to(&[0.0; 3]).is_none());
}

#[test]
fn it_is_a_slice_and_iterates_both_ways() {
    let mut solutions = list(&[[2.0; 3], [1.0; 3]]);
    assert_eq!(solutions[1].q, [1.0; 3]);
    assert_eq!(solutions.iter().len(), 2);
    assert_eq!((&solutions).into_iter().count(), 2);
    assert_eq!(solutions.into_iter().map(|s| s.q[0]).collect::<Vec<_>>(), [2.0, 1.0]);
    solutions.sort_by(|a, b| a.q[0].total_cmp(&b.q[0]));
    assert_eq!(indices(&solutions), [1, 0]);
}

#[test]
fn the_closest_is_counted_modulo_whole_turns_for_turning_joints_only() {
    let solutions = list(&[[0.0, 0.0, 0.0], [3.1, 0.0, 0.0], [3.1, 0.0, 0.5]]);
    assert_eq!(solutions.closest_to(&[-3.1, 0.0, 0.1]).unwrap().branch.step(0), Some(1));
    assert_eq!(solutions.closest_to(&[-3.1 - 20.0 * PI, 2.0 * PI, 0.1]).unwrap().branch.step(0), Some(1));
    assert_eq!(solutions.closest_to(&[-3.1, 0.0, 0.4]).unwrap().branch.step(0), Some(2));
    assert_eq!(solutions.closest_to(&[3.1, 0.0, 6.0]).unwrap().branch.step(0), Some(2));
}

#[test]
fn of_equally_near_solutions_the_first_is_taken() {
    let solutions = list(&[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    assert_eq!(solutions.closest_to(&[0.0; 3]).unwrap().branch.step(0), Some(0));
    assert_eq!(solutions.toward(&[0.0; 3]).unwrap().branch.step(0), Some(0));
    assert!(solutions.closest_to(&[f64::NAN; 3]).is_some());
    assert!(solutions.toward(&[f64::NAN; 3]).is_none());
}

#[test]
fn no_solution_is_close_to_anything() {
    let empty = list(&[]);
    assert!(empty.closest_to(&[0.0; 3]).is_none());
    assert!(empty.toward(&[0.0; 3]).is_none());
    assert!(empty.with_branch(Branch::ANY).is_none());
    assert!(empty.within_range().is_empty());
    assert_eq!(empty.into_iter().count(), 0);
}

#[test]
fn toward_shifts_by_whole_turns_inside_the_range() {
    let solutions = list(&[[0.5, -0.9 * PI, 0.2]]);
    let goal = solutions.toward(&[0.4 + 4.0 * PI, 1.2 * PI, 0.0]).unwrap();
    assert!((goal.q[0] - (0.5 + 4.0 * PI)).abs() < 1e-12, "no range: any number of turns");
    assert!((goal.q[1] - 1.1 * PI).abs() < 1e-12, "inside the range");
    assert_eq!(goal.q[2], 0.2);
    let goal = solutions.toward(&[0.0, 2.9 * PI, 0.0]).unwrap();
    assert!((goal.q[1] - 1.1 * PI).abs() < 1e-12, "3.1 pi would be nearer but is out of range: {}", goal.q[1] / PI);
}

#[test]
fn toward_prefers_the_movement_that_the_range_allows() {
    // From 1.4 pi the first is 0.2 pi away modulo turns, but only at -0.4 pi in range; the second is 0.5 pi away.
    let solutions = list(&[[0.0, -0.4 * PI, 0.0], [0.0, 0.9 * PI, 0.0]]);
    let q = [0.0, 1.4 * PI, 0.0];
    assert_eq!(solutions.closest_to(&q).unwrap().branch.step(0), Some(0));
    assert_eq!(solutions.toward(&q).unwrap().branch.step(0), Some(1));
}

#[test]
fn ranges_filter_and_clamp_round_off() {
    let solutions = list(&[[9.0, 0.0, 0.25], [0.0, 4.8, 0.25], [0.0, 0.0, -1e-12], [0.0, 0.0, 0.6]]);
    let inside = solutions.within_range();
    assert_eq!(indices(&inside), [0, 2]);
    assert_eq!(inside[1].q[2], 0.0);
    assert_eq!(inside.why(), Why::Solved);
}

#[test]
fn emptiness_has_its_reason() {
    let outside = list(&[[0.0, 0.0, 0.6], [0.0, 5.0, 0.0]]).within_range();
    assert_eq!(outside.why(), Why::OutOfRange { solutions: 2 });
    assert_eq!(outside.or_why(), Err(Why::OutOfRange { solutions: 2 }));

    let mut solutions = list(&[]);
    assert_eq!(solutions.why(), Why::NoSolution);
    let (far, near) = (1.3, 0.9);
    let reach = |needs| Why::OutOfReach { step: "elbow", needs, has: 0.8, unit: "m" };
    solutions.refuse(reach(far));
    solutions.refuse(reach(near));
    assert_eq!(solutions.why(), reach(near));
    assert_eq!(solutions.within_range().why(), reach(near));
    assert_eq!(solutions.to_string(), "elbow: distance 0.900 m exceeds 0.800 m");
    solutions.push(Solution::default());
    assert_eq!(solutions.why(), Why::Solved);
    assert!(solutions.or_why().is_ok());
    assert_eq!(Solutions::<f64, 3, 4>::none(&JOINTS, Why::NotFinite).why(), Why::NotFinite);
}

#[test]
fn inserting_merges_double_roots_and_normalizes() {
    let mut solutions = list(&[]);
    assert!(solutions.insert(Solution::new([-PI, 1.4 * PI, 0.1], Branch::ANY.with_elbow(Elbow::Up)), 1e-9));
    assert_eq!(solutions[0].q[0], PI);
    assert!((solutions[0].q[1] + 0.6 * PI).abs() < 1e-12);
    let again = Solution::new([PI - 1e-12, -0.6 * PI, 0.1], Branch::ANY.with_elbow(Elbow::Down));
    assert!(!solutions.insert(again.with_free(FreeJoints::of(&[1])), 1e-9));
    assert_eq!(solutions.len(), 1);
    assert_eq!(solutions[0].branch.elbow(), Some(Elbow::Up));
    assert_eq!(solutions[0].free, FreeJoints::of(&[1]));
    assert!(solutions.insert(Solution::new([PI - 1e-6, -0.6 * PI, 0.1], Branch::ANY), 1e-9));
    assert!(solutions.insert(Solution::new([PI, -0.6 * PI, 0.1 + 2.0 * PI], Branch::ANY), 1e-9));
    assert_eq!(solutions.len(), 3);
}

#[test]
fn a_branch_can_be_asked_for_again() {
    let solutions = list(&[[0.0; 3], [1.0; 3]]);
    let branch = solutions[1].branch;
    assert_eq!(solutions.with_branch(branch), Some(&solutions[1]));
    assert_eq!(solutions.with_branch(Branch::ANY), Some(&solutions[0]));
    assert_eq!(solutions.with_branch(Branch::ANY.with_elbow(Elbow::Up)), None);
}

#[test]
fn single_precision_works_the_same_way() {
    static SINGLE: [Joint<f32>; 1] = [Joint::revolute("q1").with_range(0.0, 6.0)];
    let mut solutions: Solutions<f32, 1, 2> = Solutions::new(&SINGLE);
    solutions.insert(Solution::new([-1.0], Branch::ANY), 1e-5);
    assert!((solutions[0].q[0] - 5.283_185_5).abs() < 1e-6);
    assert_eq!(solutions.within_range().len(), 1);
    assert_eq!(solutions.to_string(), "[5.2832]");
}
