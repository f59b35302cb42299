//! The same arms from proptest, which makes a failing one as plain as it can: fewer lengths, right angles, joints at zero.
//!
//! The seed is fixed; `PROPTEST_RNG_SEED=7 PROPTEST_CASES=2000 cargo test -p dh-tests shrinking` looks further. What fails is kept in
//! `shrinking.txt` and tried first from then on.

use std::f64::consts::{FRAC_PI_2, PI};

use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{FileFailurePersistence, RngSeed};

use super::classes::{CLASSES, table};
use super::compiled::Compiled;
use super::newton::Problem;
use super::{Judge, Random, StepKind, complete};

/// Numbers that a table is made of: more than any class asks for.
const DRAWS: usize = 96;

/// A joint value in half turns (or reaches): any, or a quarter turn.
fn joint() -> impl Strategy<Value = f64> {
    prop_oneof![2 => -1.0..1.0, 1 => (-2_i8..=2).prop_map(|k| 0.5 * f64::from(k))]
}

/// One arm at one pose: solved, complete, or refused where no class is.
fn judged(class: &str, draws: &[f64], values: &[f64]) {
    let mut next = draws.iter().cycle();
    let text = table(class, &mut || next.next().copied().unwrap_or(0.0));
    let arm = Compiled::new(&text).unwrap_or_else(|r| panic!("{class}: refused: {r:?}\n{text}"));
    let reach = arm.inverse.plan.axes.length_scale;
    let value = |(slides, x): (&bool, &f64)| if *slides { x * reach } else { x * PI };
    let q: Vec<f64> = arm.slides.iter().zip(values).map(value).collect();
    let target = arm.arm.pose(&q);
    let problem =
        Problem { arm: &arm.arm, task: arm.spec.settings.task, target, reach, frozen: &arm.spec.settings.redundant };
    let found = arm.invert(&target, &q);
    let mut judge = Judge { poses: 0, untold: Vec::new() };
    judge.pose(&arm, &problem, &q, &found, &format!("{class}, {q:?}\n{text}"));
    let general = arm.inverse.plan.steps.iter().any(|s| s.kind == StepKind::General);
    if !general && q.iter().all(|x| (x / FRAC_PI_2).fract() != 0.0) {
        complete(&arm, &problem, &q, &found, &mut Random::new(9), class);
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60,
        max_shrink_iters: 300,
        rng_seed: RngSeed::Fixed(2026),
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct("arms/shrinking.txt"))),
        ..ProptestConfig::default()
    })]

    #[test]
    fn arms_of_every_class_are_inverted(
        class in select(CLASSES),
        draws in prop::collection::vec(-1.0..1.0, DRAWS),
        values in prop::collection::vec(joint(), 7),
    ) {
        judged(class, &draws, &values);
    }
}
