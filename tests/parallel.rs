//! Batches on all cores give what single calls give, in the order of the input.

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{InverseKinematics, ParallelInverse, Robot, Solutions, Why};
use dh_tests::sample::Random;
use generated_examples::panda::Panda;
use generated_examples::puma560::Puma560;

#[test]
fn solutions_are_those_of_single_calls() {
    let arm = Puma560::default();
    let mut random = Random::new(71);
    // No whole number of shares; among them a pose out of reach and one that is not finite.
    let q: Vec<[f64; 6]> = (0..333).map(|_| std::array::from_fn(|_| 3.0 * random.signed())).collect();
    let mut targets: Vec<_> = q.iter().map(|q| arm.forward(q)).collect();
    targets[100] = IsometryMatrix3::translation(9.0, 0.0, 0.0);
    targets[200].translation.vector.x = f64::NAN;
    let mut found = vec![Solutions::none(&Puma560::JOINTS, Why::NoSolution); 340];
    arm.par_inverse_batch(&targets, &mut found);
    let mut near = vec![Err(Why::NoSolution); 333];
    arm.par_inverse_near_batch(&targets, &q, &mut near);
    for (i, target) in targets.iter().enumerate() {
        let single = arm.inverse(target);
        assert_eq!((found[i].len(), found[i].why().to_string()), (single.len(), single.why().to_string()), "{i}");
        assert!(found[i].iter().zip(single.iter()).all(|(a, b)| a.q == b.q), "{i}");
        let (a, b) = (near[i].map(|s| s.q).ok(), arm.inverse_near(target, &q[i]).map(|s| s.q).ok());
        assert_eq!(a, b, "{i}");
    }
    assert!(found[333..].iter().all(|s| s.is_empty()), "what lies beyond stays as it is");
}

#[test]
fn given_joints_are_part_of_the_target() {
    let arm = Panda;
    let mut random = Random::new(72);
    let q: Vec<[f64; 7]> = (0..90).map(|_| std::array::from_fn(|_| 2.0 * random.signed())).collect();
    let targets: Vec<_> = q.iter().map(|q| (arm.forward(q), q[6])).collect();
    let mut found = vec![InverseKinematics::inverse(&arm, &targets[0]); 90];
    arm.par_inverse_batch(&targets, &mut found);
    assert_eq!(arm.dof(), 7);
    for ((found, target), q) in found.iter().zip(&targets).zip(&q) {
        assert_eq!(*found, InverseKinematics::inverse(&arm, target));
        let nearest = found.closest_to(q).expect("the pose is reached");
        let (a, b) = (arm.forward(&nearest.q), arm.forward(q));
        assert!((a.to_homogeneous() - b.to_homogeneous()).norm() < 1e-9);
    }
}
