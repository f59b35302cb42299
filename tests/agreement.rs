//! Four engines, one answer: the macro, the expanded file, the interpreter and the plain product.

use dh_tests::compare::{self, ROUNDING};
use dh_tests::engine::{Interpreter, fields, naive, spec};
use dh_tests::naive::Arm;
use dh_tests::sample::joint_vectors;

use crate::robots;

#[test]
fn every_example_agrees_with_the_plain_product() {
    let sources = generated_examples::source::all().expect("the examples can be read");
    let robots = robots::all();
    assert_eq!(sources.len(), robots.len());
    for (source, (module, engines)) in sources.iter().zip(&robots) {
        assert_eq!(source.module, *module);
        let spec = spec(&source.body);
        let interpreter = Interpreter::new(&spec);
        let arm = Arm::new(&spec, &fields(&interpreter.chain));
        let (interpreter, plain) = (interpreter.engine(), naive(arm.clone()));
        for q in joint_vectors(&spec, 100) {
            for engine in engines.iter().chain([&interpreter]) {
                compare::engines(engine, &plain, module, &q, arm.reach(&q), ROUNDING);
            }
        }
    }
}

/// The two Jacobians of the second opinion are derived in different ways, so they check each other.
#[test]
fn the_second_opinion_agrees_with_itself() {
    for source in generated_examples::source::all().expect("the examples can be read") {
        let spec = spec(&source.body);
        let arm = Arm::new(&spec, &fields(&dh_symbolic::chain::Chain::new(spec.clone())));
        for q in joint_vectors(&spec, 20) {
            let error = compare::jacobians(&arm.jacobian_from_axes(&q), &arm.jacobian_from_slopes(&q), arm.reach(&q));
            assert!(error <= ROUNDING, "{}: {error:.1e} at {q:?}", source.module);
        }
    }
}
