//! Tests of seven-axis arms with one joint fixed: choices made for other values may not fit, and special poses have self-motions.

use core::f64::consts::{FRAC_PI_2, PI};

use super::*;

/// Rows `(alpha, a, d)` of the modified convention, in degrees, with joint `held` (from 0) at `x`.
fn locked(rows: &[(f64, f64, f64); 7], held: usize, x: f64) -> NumericChain<6> {
    let mut links = [IDENTITY; 6];
    for (i, row) in rows.iter().enumerate() {
        let next = rows.get(i + 1).unwrap_or(&(0.0, 0.0, 0.0));
        let mut link = modified(row.2, next.0, next.1);
        if i == held {
            let (s, c) = x.sin_cos();
            link = compose(&turn(&IDENTITY, [c, s]), &link);
        }
        // What is held is part of the link before.
        if i < held {
            links[i] = link;
        } else {
            links[i - 1] = if i == held { compose(&links[i - 1], &link) } else { link };
        }
    }
    arm(links)
}

/// A small second source: regular solutions that damped Newton steps find from anywhere.
fn regular_solutions(arm: &NumericChain<6>, target: &Pose, starts: usize) -> Vec<[f64; 6]> {
    let mut rng = Rng::new(81);
    let task = TaskTarget::Pose(*target);
    let mut found: Vec<[f64; 6]> = Vec::new();
    for _ in 0..starts {
        let mut q = [(); 6].map(|()| rng.angle());
        if polish(arm, &mut q, &task, arm.length_scale(), 40).reaches(1e-12)
            && !super::super::solve::is_singular(arm, &q)
            && found.iter().all(|p| apart(p, &q) > 1e-5)
        {
            found.push(q);
        }
    }
    found
}

/// `choices` are good for most values of the joint that is held.
fn assert_complete(arm: &NumericChain<6>, choices: [u8; 3], q: &[f64; 6], least: usize) {
    let target = arm.forward(q);
    let solved = General6R::new(&arm.links, choices.map(Choice::new)).solve(&target);
    assert_sound(arm, &target, &solved);
    let regular = regular_solutions(arm, &target, 300);
    assert!(regular.len() >= least, "{}", regular.len());
    for p in &regular {
        assert!(solved.solutions.iter().any(|s| apart(s, p) < 1e-6), "{p:?} is missing in {:?}", solved.solutions);
    }
}

/// Kassow KR1018: neighbouring axes at right angles, and offsets at shoulder and elbow.
const OFFSET_ELBOW: [(f64, f64, f64); 7] = [
    (0.0, 0.0, 0.3572),
    (-90.0, 0.062, 0.1052),
    (90.0, -0.062, 0.5225),
    (-90.0, 0.05, -0.0857),
    (90.0, -0.05, 0.4775),
    (-90.0, 0.0, 0.111),
    (90.0, 0.0, 0.108),
];

#[test]
fn a_value_at_or_next_to_a_special_one_makes_most_choices_useless() {
    // With joint 5 at half a turn, axes 4 and 6 are parallel; 1e-12 beside, determinants vanish but for a trace.
    let choices = [61, 19, 37];
    let arm = locked(&OFFSET_ELBOW, 4, PI + 1e-12);
    assert_complete(&arm, choices, &[PI, PI, -FRAC_PI_2, -FRAC_PI_2, -FRAC_PI_2, 0.0], 12);
    let arm = locked(&OFFSET_ELBOW, 4, PI);
    assert_complete(&arm, choices, &[0.0, -FRAC_PI_2, 0.0, PI, -FRAC_PI_2, FRAC_PI_2], 3);
}

#[test]
fn points_of_a_continuum_make_room_for_regular_solutions() {
    // A spherical wrist, stretched: joints 4 and 6 turn about one line.
    let arm = arm([
        link(0.3, 0.1, 90.0),
        link(0.0, 0.4, 0.0),
        link(0.1, 0.0, 90.0),
        link(0.4, 0.0, -90.0),
        link(0.0, 0.0, 90.0),
        link(0.1, 0.0, 0.0),
    ]);
    let solver = General6R::new(&arm.links, [Choice::default(); 3]);
    let mut solutions = List::new();
    for k in 0..16 {
        assert_eq!(
            solver.place(&IDENTITY, &mut solutions, [0.7, 0.4, 1.1, 0.3 * f64::from(k), 0.0, 0.2]),
            (k as usize, true)
        );
    }
    let (singular, regular) = ([0.3, 0.9, 0.8, 0.1, 0.0, 0.3], [0.7, 0.4, 1.1, 0.3, 0.9, 0.2]);
    assert_eq!(solver.place(&IDENTITY, &mut solutions, singular), (16, false));
    assert_eq!(solver.place(&IDENTITY, &mut solutions, regular), (0, true));
    assert_eq!((solutions.len(), solutions[0]), (16, regular));
}
