//! How many solutions there are at poses of several singularities at once: self-motions that cross, roots of high order beside them.

use super::apart;
use super::compiled::Compiled;
use super::newton::Problem;
use std::f64::consts::{FRAC_PI_2, PI};

/// Joint values, the number of solutions, and the table.
const CASES: &[(&[f64], usize, &str)] = &[
    // Folded, so that the wrist centre is on the second axis: joints 2 and 5 turn together (two ways), and where joint 5 is straight on
    // the way, joints 4 and 6 (two ways); four solutions of the other shoulder.
    (
        &[0.0, -FRAC_PI_2, -FRAC_PI_2, -FRAC_PI_2, PI, -FRAC_PI_2],
        8,
        "| alpha | a | d | theta |
        | 0 | 0 | 0 | q1 |
        | -90deg | 250mm | 0 | -q2 |
        | 0 | 550mm | 0 | -q3 |
        | -90deg | 0 | 550mm | q4 |
        | 90deg | 0 | 0 | -q5 |
        | -90deg | 0 | 185mm | q6 |",
    ),
    // The same, much smaller than the arm is long.
    (
        &[0.0, -FRAC_PI_2, -FRAC_PI_2, -FRAC_PI_2, PI, -FRAC_PI_2],
        8,
        "| alpha | a | d | theta |
        | 0 | 0 | 170mm | q1 |
        | -90deg | 20mm | 0 | -q2 |
        | 0 | 165mm | 0 | -q3 |
        | -90deg | 0 | 165mm | q4 |
        | 90deg | 0 | 0 | -q5 |
        | -90deg | 0 | 46mm | q6 |",
    ),
    // Folded on the shoulder's centre, the tool upright: joints 1, 2, 5 and 6 have two motions (two ways), and where the wrist is straight
    // meanwhile, joints 1, 4 and 6 have two (two ways).
    (
        &[-FRAC_PI_2, 0.0, PI, 0.0, -FRAC_PI_2, -FRAC_PI_2],
        4,
        "| alpha | a | d | theta |
        | 0 | 0 | 215mm | -q1 |
        | -90deg | 0 | 0 | q2 |
        | 0 | 300mm | 0 | q3 - 90deg |
        | -90deg | 0 | 300mm | -q4 |
        | 90deg | 0 | 0 | q5 |
        | -90deg | 0 | 160.5mm | -q6 + 180deg |",
    ),
    // A straight wrist: half a turn of joints 4 and 6 against each other leads from one representative to the other.
    (
        &[-FRAC_PI_2, PI, -FRAC_PI_2, PI, 0.0, -FRAC_PI_2],
        7,
        "| alpha | a | d | theta |
        | 0 | 0 | 550mm | q1 |
        | -90deg | 170mm | 0 | q2 |
        | 0 | 880mm | 0 | q3 |
        | -90deg | 190mm | 810mm | q4 |
        | 90deg | 0 | 0 | q5 |
        | -90deg | 0 | 115mm | q6 |",
    ),
    // Straight wrist and stretched elbow: a thousandth of a millionth beside the self-motion the target is reached, too.
    (
        &[-FRAC_PI_2, PI, -FRAC_PI_2, PI, 0.0, -FRAC_PI_2],
        5,
        "| alpha | a | d | theta |
        | 0 | 0 | 412mm | q1 + 90deg |
        | -90deg | 100mm | 0 | -q2 - 90deg |
        | 0 | 420mm | 0 | -q3 |
        | -90deg | 0 | 400mm | -q4 |
        | 90deg | 0 | 0 | -q5 |
        | -90deg | 0 | 80mm | -q6 |",
    ),
    // No wrist centre, and everything straight: a root of high order, to which polishing comes from several sides.
    (
        &[-FRAC_PI_2, 0.0, PI, 0.0, -FRAC_PI_2, -FRAC_PI_2],
        9,
        "| alpha | a | d | theta |
        | 0 | 0 | 300mm | q1 |
        | -90deg | 0 | -3.2mm | q2 - 90deg |
        | 0 | 450mm | 0 | q3 - 90deg |
        | -90deg | 0 | 350mm | q4 |
        | 90deg | 0 | -183mm | q5 |
        | -90deg | 0 | 228mm | q6 + 180deg |",
    ),
];

#[test]
fn every_continuum_is_represented_once_where_several_cross() {
    for (q, count, table) in CASES {
        let arm = Compiled::new(&format!("pub struct Arm; convention = modified; {table}"))
            .unwrap_or_else(|_| panic!("no plan: {table}"));
        let reach = arm.inverse.plan.axes.length_scale;
        let found = arm.invert(&arm.arm.pose(q), q);
        let holds = |(s, free): (&Vec<f64>, &dh_robot::FreeJoints)| {
            (0..q.len()).all(|k| free.contains(k) || apart(&arm, reach, k, s[k], q[k]) < 1e-3)
        };
        assert!(found.q.iter().zip(&found.free).any(holds), "{q:?} of {table}: {:?} {:?}", found.q, found.free);
        assert_eq!(found.q.len(), *count, "{q:?} of {table}: {:?} {:?}", found.q, found.free);
    }
}

/// Where the wrist of the UR5 is straight, joints 2 to 4 and 6 are free. Beside it there are as many solutions as anywhere near.
#[test]
fn beside_a_continuum_solutions_stand_alone() {
    let table = "pub struct Arm; convention = modified;
        | alpha | a | d | theta |
        | 0 | 0 | 89.159mm | q1 |
        | 90deg | 0 | 0 | q2 + 180deg |
        | 0 | 425mm | 0 | q3 |
        | 0 | 392.25mm | 109.15mm | q4 + 180deg |
        | -90deg | 0 | 94.65mm | q5 |
        | 90deg | 0 | 82.3mm | q6 |";
    let arm = Compiled::new(table).unwrap_or_else(|_| panic!("no plan"));
    let reach = arm.inverse.plan.axes.length_scale;
    for off in [1e-9, 1e-8, 1e-7, 1e-6, 1e-3] {
        let q = [0.934_523_563, 0.008_718_051, -0.720_461_907, -2.747_860_587, off, -1.352_896_528];
        let target = arm.arm.pose(&q);
        let found = arm.invert(&target, &q);
        let problem = Problem { arm: &arm.arm, task: arm.spec.settings.task, target, reach, frozen: &[] };
        assert_eq!(found.q.len(), 8, "{off}: {:?} {:?}", found.q, found.free);
        assert!(found.free.iter().all(|f| f.is_empty()), "{off}: {:?}", found.free);
        assert!(found.q.iter().all(|s| problem.miss(s) < 1e-13), "{off}: {:?}", found.q);
    }
}
