//! Arms of all kinds in one list: what `dyn Arm` answers is what each robot's own functions answer.

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{Arm, SolutionView, Why};
use dh_tests::engine::{invented, spec};
use dh_tests::sample::Random;

use crate::closure::{arms as alone, random_joints};
use crate::robots::robot;

macro_rules! boxes {
    ($($module:ident $name:ident $dof:literal)*) => {
        /// Every example robot as a trait object.
        fn boxes() -> Vec<Box<dyn Arm>> {
            vec![$(Box::new(robot!($module, generated_examples::$module::$name))),*]
        }
    };
}

generated_examples::for_every_robot!(boxes);

/// The robots, with the joint whose value the caller gives.
fn redundant(module: &str, q: &[f64]) -> Option<f64> {
    (module == "panda").then(|| q[6])
}

#[test]
fn a_list_of_mixed_arms_answers_like_each_of_them() {
    let mut random = Random::new(61);
    let sources = generated_examples::source::all().expect("the modules of the examples");
    for (arm, alone) in boxes().iter().zip(alone()) {
        let source = sources.iter().find(|s| s.module == alone.module).expect("a module");
        let spec = spec(&source.body);
        let dof = arm.joints().len();
        assert_eq!(arm.dof(), dof);
        for _ in 0..20 {
            let q = random_joints(&spec, &mut random);
            let target = arm.forward(&q).expect("as many values as joints");
            assert_eq!(target, (alone.forward)(&q), "{}", alone.module);
            let size = 1.0 + target.translation.vector.norm();
            let mut frames = vec![IsometryMatrix3::identity(); dof];
            arm.frames(&q, &mut frames).expect("as many frames as joints");
            let (mut columns, mut again) = (vec![[0.0; 6]; dof], vec![[0.0; 6]; dof]);
            let pose = arm.forward_and_jacobian(&q, &mut columns).expect("as many columns as joints");
            assert!((pose.to_homogeneous() - target.to_homogeneous()).abs().max() < 1e-14 * size, "{}", alone.module);
            arm.jacobian(&q, &mut again).expect("the same");
            assert_eq!(columns, again);
            // A column is the slope of the position by its joint.
            for (j, column) in columns.iter().enumerate() {
                let mut moved = q.clone();
                moved[j] += 1e-6;
                let by = arm.forward(&moved).expect("as before").translation.vector - target.translation.vector;
                assert!((0..3).all(|i| (by[i] * 1e6 - column[i]).abs() < 1e-4 * size), "{}: column {j}", alone.module);
            }
            let wanted = (alone.inverse)(&target, &q);
            let mut found = Vec::new();
            let why = arm.inverse(&target, redundant(alone.module, &q).as_slice(), &mut |s: SolutionView<'_, f64>| {
                found.push(s.q.to_vec());
            });
            assert_eq!((why, found.len()), (Why::Solved, wanted.q.len()), "{}", alone.module);
            let mut pairs = found.iter().flatten().zip(wanted.q.iter().flatten());
            assert!(pairs.all(|(a, b)| (a - b).abs() < 1e-9), "{}: {found:?}, {:?}", alone.module, wanted.q);
            assert!(found.len() <= arm.max_solutions());
            // The nearest one within the ranges, and back where the arm stands.
            let inside = |q: &[f64]| arm.joints().iter().zip(q).all(|(joint, q)| joint.contains(*q));
            let mut next = q.clone();
            let why = arm
                .toward(&target, redundant(alone.module, &q).as_slice(), &mut next)
                .expect("as many values as joints");
            assert_eq!(why == Why::Solved, found.iter().any(|q| inside(q)), "{}: {why}", alone.module);
            assert!(if why == Why::Solved { inside(&next) } else { next == q });
        }
    }
}

#[test]
fn slices_of_another_length_are_refused() {
    for arm in boxes() {
        let (dof, pose) = (arm.dof(), IsometryMatrix3::identity());
        for given in [0, dof - 1, dof + 1] {
            let mut q = vec![0.1; given];
            let refused = arm.forward(&q).expect_err("another length");
            assert_eq!((refused.joints, refused.given), (dof, given));
            assert_eq!(arm.toward(&pose, &[], &mut q), Err(refused));
            assert!(arm.frames(&vec![0.1; dof], &mut vec![pose; given]).is_err());
            assert!(arm.frames(&q, &mut vec![pose; dof]).is_err());
            assert!(arm.jacobian(&vec![0.1; dof], &mut vec![[0.0; 6]; given]).is_err());
        }
        assert!(dof != 6 || arm.forward(&[0.0; 5]).unwrap_err().to_string().contains("6 joints, the slice 5 entries"));
    }
}
