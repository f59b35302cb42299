//! Poses of random arms whose solutions were lost once: double roots behind double roots, and linkages that turn a little only.

use std::f64::consts::{FRAC_PI_2, PI};

use super::apart;
use super::compiled::Compiled;

/// Joint values, and the table.
const CASES: &[(&[f64], &str)] = &[
    // The shoulder nearly stretched, the wrist centre next to an axis: the rounding of one step is as large as what the next one sees.
    (
        &[
            -0.670_024_998_592_977_5,
            -1.273_592_135_278_821_3,
            -0.808_271_501_599_420_1,
            2.665_647_546_762_149,
            1e-8,
            PI,
        ],
        "convention = modified; base = tz(-0.559) * rx(-20deg);
        | alpha | a | d | theta |
        | 0deg | 0 | -0.511 | q1 - 90deg |
        | -90deg | 0.069 | -0.332 | q2 |
        | 0deg | -0.3 | 0 | q3 - 90deg |
        | 0deg | 0.542 | 0 | q4 - 90deg |
        | 90deg | -0.391 | -0.3 | q5 |
        | 90deg | 0 | 0 | q6 |",
    ),
    // Two double roots in a row.
    (
        &[
            FRAC_PI_2,
            -1.474_091_433_625_816_8,
            1.942_211_586_446_489_3,
            2.216_577_059_196_252,
            1.570_796_426_794_897,
            FRAC_PI_2,
        ],
        "convention = modified; tool = ty(0.26) * rz(55.3deg);
        | alpha | a | d | theta |
        | 0deg | 0 | 0 | q1 + 180deg |
        | 100deg | 0 | -0.585 | q2 |
        | 90deg | -0.469 | 0 | q3 + 30deg |
        | 55.3deg | 0 | -0.182 | q4 |
        | 100deg | 0 | 0 | q5 - 90deg |
        | 90deg | 0 | -0.204 | q6 |",
    ),
    // A double root of the last joint, and three parallel axes folded.
    (
        &[
            -1.089_901_293_450_257_9,
            -1.616_749_089_532_328_9,
            2.801_467_206_441_332_6,
            -3.141_592_654_589_792_3,
            FRAC_PI_2,
            FRAC_PI_2,
        ],
        "convention = modified; tool = tz(-0.3) * ry(-90deg);
        | alpha | a | d | theta |
        | 0deg | 0 | 0 | q1 |
        | -90deg | 0 | 0.3 | q2 |
        | 90deg | 0.126 | 0 | q3 + 17.3deg |
        | 0deg | -0.3 | 0 | q4 + 180deg |
        | 0deg | 0.3 | -0.114 | q5 |
        | -90deg | -0.237 | 0 | q6 + 30deg |",
    ),
    // Four parallel axes: a linkage with a rocker of a few degrees, in two ways.
    (
        &[PI, 0.0, FRAC_PI_2, 2.839_650_692_994_774_2, -FRAC_PI_2, 0.0],
        "convention = standard; tool = tx(-0.379) * rz(30deg);
        | alpha | a | d | theta |
        | 0deg | 0.365 | 0.38 | q1 |
        | 0deg | 0.319 | 0 | q2 |
        | -90deg | 0 | 0.3 | q3 |
        | 90deg | -0.056 | -0.354 | q4 + 17.3deg |
        | 90deg | 0 | 0 | q5 + 180deg |
        | 0deg | 0 | -0.215 | q6 |",
    ),
];

#[test]
fn what_was_lost_once_is_found() {
    for (q, table) in CASES {
        let arm = Compiled::new(&format!("pub struct Arm; {table}")).unwrap_or_else(|_| panic!("no plan: {table}"));
        let reach = arm.inverse.plan.axes.length_scale;
        let found = arm.invert(&arm.arm.pose(q), q);
        // A root of multiplicity four is good to 1e-4, times what the arm's shape makes of it.
        let holds = |(s, free): (&Vec<f64>, &dh_robot::FreeJoints)| {
            (0..q.len()).all(|k| free.contains(k) || apart(&arm, reach, k, s[k], q[k]) < 5e-3)
        };
        assert!(found.q.iter().zip(&found.free).any(holds), "{q:?} of {table}: {:?} {:?}", found.q, found.free);
    }
}

/// A triple point seen from three sides is one solution.
#[test]
fn a_root_of_high_order_is_returned_once() {
    let q = [
        -0.817_808_854_716_324_3,
        -0.801_328_812_511_673_1,
        2.322_932_127_645_959_4,
        -1.223_051_259_423_322_7,
        1.326_805_799_359_967_8,
        1.117_073_144_861_792,
    ];
    let table = "pub struct Arm; convention = standard;
        | alpha | a | d | theta |
        | -90deg | -0.236 | -0.099 | q1 |
        | 90deg | 0 | -0.264 | q2 |
        | -90deg | 0 | 0 | q3 + 17.3deg |
        | -45deg | -0.411 | 0.3 | q4 + 180deg |
        | 30deg | 0.3 | 0.32 | q5 + 180deg |
        | 0deg | 0 | 0.3 | q6 |";
    let arm = Compiled::new(table).unwrap_or_else(|_| panic!("no plan"));
    let found = arm.invert(&arm.arm.pose(&q), &q);
    let near = |s: &&Vec<f64>| (0..6).all(|k| apart(&arm, 1.0, k, s[k], q[k]) < 1e-3);
    assert_eq!(found.q.iter().filter(near).count(), 1, "{:?}", found.q);
}
