//! Many poses in one call: a batch answers what each single call answers, for every example, and for targets of every kind.

use dh_robot::nalgebra::{IsometryMatrix3, Point3, SMatrix, UnitVector3, Vector3};
use dh_robot::{Real, Solution, Solutions, Why, dh_robot};
use dh_tests::engine::invented;
use dh_tests::sample::Random;
use generated_examples::panda::Panda;
use generated_examples::puma560::Puma560;

use crate::robots::robot;

/// Random joint vectors, one of them with a NaN in it.
fn joints<T: Real, const N: usize>(count: usize, seed: u64) -> Vec<[T; N]> {
    let mut random = Random::new(seed);
    let mut out: Vec<[T; N]> = (0..count).map(|_| std::array::from_fn(|_| T::of(3.0 * random.signed()))).collect();
    if let Some(q) = out.get_mut(5) {
        q[N - 1] = T::of(f64::NAN);
    }
    out
}

/// The same text: also where there are NaNs, which equal nothing.
fn same(a: &impl std::fmt::Debug, b: &impl std::fmt::Debug) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

/// The same numbers but for rounding: vector registers may multiply and add with one rounding.
fn close(a: &[f64], b: &[f64]) -> bool {
    let size = b.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-13 * size || (a.is_nan() && b.is_nan());
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(*a, *b))
}

/// The entries of a pose.
fn entries(pose: &IsometryMatrix3<f64>) -> [[f64; 4]; 4] {
    pose.to_homogeneous().into()
}

macro_rules! forward {
    ($($module:ident $name:ident $dof:literal)*) => {
        #[test]
        fn poses_and_jacobians_are_those_of_single_calls() {
            $({
                let arm = robot!($module, generated_examples::$module::$name);
                // No whole number of any vector's width; one is not a number, two are beyond what is computed without a decision:
                // registers reduce angles up to a bound, and leave larger ones to single calls.
                let mut q = joints::<f64, $dof>(19, 7);
                q[12][0] = 1.0e6;
                q[3][0] = 1.0e12;
                let mut poses = [IsometryMatrix3::identity(); 21];
                arm.forward_batch(&q, &mut poses);
                let mut jacobians = vec![SMatrix::<f64, 6, $dof>::zeros(); 17];
                arm.jacobian_batch(&q, &mut jacobians);
                for (q, pose) in q.iter().zip(&poses) {
                    let (batch, single) = (entries(pose), entries(&arm.forward(q)));
                    assert!(close(batch.as_flattened(), single.as_flattened()), "{}: {q:?}", stringify!($module));
                }
                for (q, jacobian) in q.iter().zip(&jacobians) {
                    let single = arm.jacobian(q);
                    assert!(close(jacobian.as_slice(), single.as_slice()), "{}: {q:?}", stringify!($module));
                }
                assert_eq!(poses[19..], [IsometryMatrix3::identity(); 2], "{}", stringify!($module));
                arm.forward_batch(&[], &mut poses);
                arm.forward_batch(&q, &mut []);
            })*
        }
    };
}

generated_examples::for_every_robot!(forward);

#[test]
fn solutions_are_those_of_single_calls() {
    let arm = Puma560::default();
    let q = joints::<f64, 6>(12, 8);
    let targets: Vec<_> = q.iter().map(|q| arm.forward(q)).collect();
    let untouched = Solutions::none(&Puma560::JOINTS, Why::NoSolution);
    let mut found = vec![untouched; 14];
    arm.inverse_batch(&targets, &mut found);
    for (i, (target, found)) in targets.iter().zip(&found).enumerate() {
        assert!(same(found, &arm.inverse(target)), "{i}");
        assert_eq!(found.is_empty(), i == 5, "{i}");
    }
    assert_eq!(found[5].why(), Why::NotFinite);
    assert!(found[12..].iter().all(|s| s.is_empty() && s.why() == Why::NoSolution));
    let mut near = vec![Err(Why::NoSolution); 14];
    arm.inverse_near_batch(&targets, &q[..9], &mut near);
    for (i, (target, q)) in targets.iter().zip(&q[..9]).enumerate() {
        assert!(same(&near[i], &arm.inverse_near(target, q)), "{i}");
    }
    assert!(near[9..].iter().all(|s| *s == Err(Why::NoSolution)));
}

#[test]
fn chosen_joints_come_with_each_target() {
    let arm = Panda;
    let q = joints::<f64, 7>(8, 9);
    let targets: Vec<_> = q.iter().map(|q| arm.forward(q)).collect();
    let given: Vec<f64> = q.iter().map(|q| q[6]).collect();
    let mut found = vec![Solutions::none(&Panda::JOINTS, Why::NoSolution); 8];
    arm.inverse_batch(&targets, &given[..7], &mut found);
    let mut near = vec![Err(Why::NoSolution); 8];
    arm.inverse_near_batch(&targets, &given, &q, &mut near);
    for i in 0..7 {
        assert!(same(&found[i], &arm.inverse(&targets[i], given[i])), "{i}");
        assert!(same(&near[i], &arm.inverse_near(&targets[i], given[i], &q[i])), "{i}");
        assert_eq!(found[i].is_empty(), i == 5, "{i}");
    }
    assert!(found[7].is_empty());
}

dh_robot! {
    /// A PUMA in single precision that is asked for a point: the wrist is given.
    struct Wrist;
    convention = modified;
    task = position;
    redundant = q4, q5, q6;
    scalar = f32;
    tool = tx(0.05) * tz(0.1);
    | alpha  | a      | d       | theta |
    | 0      | 0      | 0       | q1    |
    | -90deg | 0      | 0       | q2    |
    | 0      | 0.4318 | 0.15005 | q3    |
    | -90deg | 0.0203 | 0.4318  | q4    |
    | 90deg  | 0      | 0       | q5    |
    | -90deg | 0      | 0       | q6    |
}

dh_robot! {
    /// Three parallel joints in the plane.
    struct Plane;
    convention = modified;
    task = planar;
    tool = tx(0.2);
    | alpha | a   | d | theta |
    | 0     | 0   | 0 | q1    |
    | 0     | 0.4 | 0 | q2    |
    | 0     | 0.3 | 0 | q3    |
}

dh_robot! {
    /// Five joints that point a tool.
    struct Pointer;
    convention = standard;
    task = axis;
    | theta      | d     | a     | alpha |
    | q1         | 0.147 | 0.033 | 90deg |
    | q2 + 90deg | 0     | 0.155 | 0     |
    | q3         | 0     | 0.135 | 0     |
    | q4 + 90deg | 0     | 0     | 90deg |
    | q5         | 0.218 | 0     | 0     |
}

#[test]
fn every_kind_of_target_has_its_batch() {
    let q = joints::<f32, 6>(8, 10);
    let targets: Vec<Point3<f32>> = q.iter().map(|q| Wrist.forward(q).translation.vector.into()).collect();
    let given: Vec<[f32; 3]> = q.iter().map(|q| [q[3], q[4], q[5]]).collect();
    let mut found = vec![Solutions::none(&Wrist::JOINTS, Why::NoSolution); 8];
    Wrist.inverse_batch(&targets, &given, &mut found);
    assert!((0..8).all(|i| same(&found[i], &Wrist.inverse(&targets[i], given[i]))));
    assert!((0..8).all(|i| found[i].is_empty() == (i == 5)));

    let targets = [(0.5, 0.2, 0.3), (f64::NAN, 0.0, 0.0), (0.1, 0.3, -2.0)];
    let mut found = [Solutions::none(&Plane::JOINTS, Why::NoSolution); 3];
    Plane.inverse_batch(&targets, &mut found);
    assert!((0..3).all(|i| same(&found[i], &Plane.inverse(targets[i]))));
    assert_eq!((found[0].len(), found[1].len(), found[2].len()), (2, 0, 2));

    let q = joints::<f64, 5>(4, 11);
    let targets: Vec<(Point3<f64>, UnitVector3<f64>)> = q
        .iter()
        .map(|q| Pointer.forward(q))
        .map(|pose| (pose.translation.vector.into(), UnitVector3::new_normalize(pose.rotation * Vector3::z())))
        .collect();
    let mut near: [Result<Solution<f64, 5>, Why<f64>>; 4] = [Err(Why::NoSolution); 4];
    Pointer.inverse_near_batch(&targets, &q, &mut near);
    for (q, near) in q.iter().zip(&near) {
        let found = near.as_ref().expect("the pose is the arm's own");
        assert!(found.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-7), "{q:?}: {found}");
    }
}
