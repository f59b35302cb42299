//! Arms whose table is read while the program runs: `DynamicArm` answers what the arm that the macro made answers.

use dh_dynamic::DynamicArm;
use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{Arm, InverseKinematics, SolutionView};
use dh_symbolic::chain::Task;
use dh_tests::engine::{invented, spec};
use dh_tests::sample::{Random, joint_vectors};
use generated_examples::{crx10ia::Crx10ia, kuka_kr6_r700::KukaKr6R700, puma560::Puma560, ur5::Ur5};

use crate::closure::{arms as generated, random_joints};
use crate::robots::robot;

type Pose = IsometryMatrix3<f64>;

macro_rules! boxes {
    ($($module:ident $name:ident $dof:literal)*) => {
        /// Every example robot as the macro made it.
        fn boxes() -> Vec<Box<dyn Arm>> {
            vec![$(Box::new(robot!($module, generated_examples::$module::$name))),*]
        }
    };
}

generated_examples::for_every_robot!(boxes);

/// The same robot from its table.
fn dynamic(body: &str) -> DynamicArm {
    let arm = DynamicArm::parse(body).unwrap_or_else(|e| panic!("{e}"));
    let missing: Vec<String> = arm.parameters().filter(|p| p.value.is_nan()).map(|p| p.name.to_string()).collect();
    let values: Vec<(&str, f64)> = missing.iter().map(|name| (name.as_str(), invented(name))).collect();
    arm.with_parameters(&values).expect("fields")
}

/// Joint values that the caller gives, of those that made a pose.
fn given(arm: &DynamicArm, q: &[f64]) -> Vec<f64> {
    arm.redundant().iter().map(|k| q[*k]).collect()
}

fn all(arm: &dyn Arm, target: &Pose, given: &[f64]) -> (Vec<(Vec<f64>, String)>, String) {
    let mut found = Vec::new();
    let why = arm.inverse(target, given, &mut |s: SolutionView<'_, f64>| {
        found.push((s.q.to_vec(), format!("{:?} {}", s.branch, s.free)));
    });
    (found, why.to_string())
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The same for joint values, where half a turn has two names.
fn turned(arm: &DynamicArm, a: &[f64], b: &[f64]) -> f64 {
    let all = arm.joints().iter().zip(a.iter().zip(b));
    all.map(|(joint, (a, b))| joint.difference(*a, *b).abs()).fold(0.0, f64::max)
}

fn entries(pose: &Pose) -> Vec<f64> {
    pose.to_homogeneous().as_slice().to_vec()
}

#[test]
fn an_interpreted_arm_moves_like_the_generated_one() {
    let sources = generated_examples::source::all().expect("the modules of the examples");
    for (arm, (source, alone)) in boxes().iter().zip(sources.iter().zip(generated())) {
        assert_eq!(source.module, alone.module);
        let (same, spec) = (dynamic(&source.body), spec(&source.body));
        assert_eq!(format!("{:?}", same.joints()), format!("{:?}", arm.joints()), "{}", source.module);
        assert_eq!(Arm::max_solutions(&same), arm.max_solutions(), "{}", source.module);
        let dof = same.dof();
        for q in joint_vectors(&spec, 20) {
            let (a, b) = (arm.forward(&q).expect("the joints"), Arm::forward(&same, &q).expect("the joints"));
            let size = 1.0 + a.translation.vector.norm();
            assert!(difference(&entries(&a), &entries(&b)) < 4e-15 * size, "{} at {q:?}: {a} {b}", source.module);
            let mut frames = [vec![Pose::identity(); dof], vec![Pose::identity(); dof]];
            let mut columns = [vec![[0.0; 6]; dof], vec![[0.0; 6]; dof]];
            for (k, arm) in [arm.as_ref(), &same as &dyn Arm].into_iter().enumerate() {
                arm.frames(&q, &mut frames[k]).expect("the joints");
                arm.jacobian(&q, &mut columns[k]).expect("the joints");
            }
            let [a, b] = frames.map(|list| list.iter().flat_map(entries).collect::<Vec<f64>>());
            assert!(difference(&a, &b) < 4e-15 * size, "{} at {q:?}", source.module);
            let [a, b] = columns.map(|list| list.concat());
            assert!(difference(&a, &b) < 4e-15 * size, "{} at {q:?}", source.module);
        }
    }
}

#[test]
fn an_interpreted_arm_has_the_solutions_of_the_generated_one() {
    let sources = generated_examples::source::all().expect("the modules of the examples");
    for (arm, source) in boxes().iter().zip(&sources) {
        let (same, spec) = (dynamic(&source.body), spec(&source.body));
        let mut random = Random::new(62);
        let mut vectors = joint_vectors(&spec, 10);
        vectors.extend((0..60).map(|_| random_joints(&spec, &mut random)));
        for (i, q) in vectors.iter().enumerate() {
            let mut target = arm.forward(q).expect("the joints");
            if i % 9 == 8 {
                target.translation.vector *= 1.7;
            }
            let name = format!("{} at {q:?}", source.module);
            let chosen = given(&same, q);
            let ((wanted, why), (found, reason)) = (all(arm.as_ref(), &target, &chosen), all(&same, &target, &chosen));
            assert_eq!(found.len(), wanted.len(), "{name}:\n{found:?} {reason}\n{wanted:?} {why}");
            assert_eq!(reason.split(" by ").next(), why.split(" by ").next(), "{name}");
            // The generated arm's fast path lists branches in another order where the interpreted one has none.
            let sorted = |list: &[(Vec<f64>, String)]| {
                let mut list = list.to_vec();
                list.sort_by(|a, b| a.1.cmp(&b.1).then(a.0.partial_cmp(&b.0).expect("joint values are numbers")));
                list
            };
            for (a, b) in sorted(&found).iter().zip(&sorted(&wanted)) {
                assert_eq!(a.1, b.1, "{name}");
                assert!(turned(&same, &a.0, &b.0) < 1e-7, "{name}:\n{a:?}\n{b:?}");
            }
            // A batch says the same.
            let target = same.target(&target);
            let batch = same.inverse_batch(3, |_| (target, chosen.as_slice()), Some(1));
            for (k, count) in batch.count.iter().enumerate() {
                assert_eq!(usize::from(*count), found.len(), "{name}");
                for (s, wanted) in found.iter().enumerate() {
                    let place = (k * batch.most + s) * q.len();
                    assert!(turned(&same, &batch.q[place..place + q.len()], &wanted.0) < 1e-9, "{name}");
                }
            }
        }
    }
}

/// `inverse_near` of a generated arm and of its table, at some targets from some joints.
fn near<R: InverseKinematics<6, Target = Pose> + Arm>(arm: &R, module: &str) {
    let sources = generated_examples::source::all().expect("the modules of the examples");
    let source = sources.iter().find(|s| s.module == module).expect("an example");
    let (same, spec) = (dynamic(&source.body), spec(&source.body));
    assert_eq!(spec.settings.task, Task::Pose);
    let mut random = Random::new(63);
    for (i, q) in joint_vectors(&spec, 40).iter().enumerate() {
        let target = Arm::forward(arm, q).expect("six joints");
        let size = if i % 2 == 0 { 1e-3 } else { 0.8 };
        let from: [f64; 6] = std::array::from_fn(|k| q[k] + size * random.signed());
        let wanted = arm.inverse_near(&target, &from);
        let mut found = from;
        let result = same.inverse_near(&same.target(&target), &[], &mut found);
        let name = format!("{module} at {q:?} from {from:?}");
        match (wanted, result) {
            (Ok(wanted), Ok(_)) => {
                assert!(difference(&wanted.q, &found) < 1e-6, "{name}:\n{:?}\n{found:?}", wanted.q);
            }
            (wanted, result) => panic!("{name}: {wanted:?} {result:?}"),
        }
    }
}

#[test]
fn an_interpreted_arm_goes_on_like_the_generated_one() {
    near(&Puma560::default(), "puma560");
    near(&Ur5, "ur5");
    near(&KukaKr6R700, "kuka_kr6_r700");
    near(&Crx10ia, "crx10ia");
}

#[test]
fn batches_of_poses_are_single_poses_on_any_number_of_threads() {
    let sources = generated_examples::source::all().expect("the modules of the examples");
    let source = sources.iter().find(|s| s.module == "puma560").expect("an example");
    let (arm, mut random) = (dynamic(&source.body), Random::new(64));
    let n = 1001;
    let mut q: Vec<f64> = (0..6 * n).map(|_| 3.0 * random.signed()).collect();
    q[6 * 17 + 3] = f64::NAN;
    let mut results = Vec::new();
    for threads in [Some(1), Some(3), None] {
        let (mut poses, mut frames, mut jacobians) = (vec![0.0; 16 * n], vec![0.0; 96 * n], vec![0.0; 36 * n]);
        arm.forward_batch(&q, &mut poses, threads);
        arm.frames_batch(&q, &mut frames, threads);
        arm.jacobian_batch(&q, &mut jacobians, threads);
        for i in 0..n {
            let single = Arm::forward(&arm, &q[6 * i..6 * i + 6]).expect("six joints").to_homogeneous();
            let bits = |x: f64| if x.is_nan() { 0 } else { x.to_bits() };
            for k in 0..16 {
                assert_eq!(bits(poses[16 * i + k]), bits(single[(k / 4, k % 4)]), "{i} {k}");
            }
            let spoiled = poses[16 * i..16 * i + 16].iter().any(|x| x.is_nan());
            assert_eq!(spoiled, i == 17);
            let last = &frames[96 * i + 80..96 * i + 96];
            assert!(spoiled || difference(last, &poses[16 * i..16 * i + 16]) < 1e-14);
        }
        let target = |i: usize| {
            let p: [f64; 16] = poses[16 * i..16 * i + 16].try_into().expect("16 numbers");
            let rows = std::array::from_fn(|i| std::array::from_fn(|j| p[4 * i + j]));
            let pose = dh_robot::pose::from_entries(rows, std::array::from_fn(|i| p[4 * i + 3]));
            (arm.target(&pose), &[][..])
        };
        let batch = arm.inverse_batch(n, target, threads);
        assert_eq!(batch.refused.iter().map(|r| r.0).collect::<Vec<_>>(), [17]);
        let bits: Vec<u64> = batch.q.iter().map(|x| x.to_bits()).collect();
        results.push((bits, batch.count, batch.names));
    }
    assert!(results.windows(2).all(|w| w[0] == w[1]));
}

#[test]
fn fields_can_be_changed() {
    let arm = DynamicArm::parse(
        generated_examples::source::all()
            .expect("examples")
            .iter()
            .find(|s| s.module == "puma560")
            .map(|s| s.body.as_str())
            .expect("an example"),
    )
    .expect("a table");
    let names: Vec<(String, bool)> = arm.parameters().map(|p| (p.name.to_string(), p.is_length)).collect();
    assert_eq!(names.iter().map(|n| n.0.as_str()).collect::<Vec<_>>(), ["a2", "a3", "d3", "d4"]);
    let longer = arm.with_parameters(&[("d4", 0.5), ("a3", 0.0)]).expect("fields");
    let generated = Puma560 { d4: 0.5, a3: 0.0, ..Puma560::default() };
    let q = [0.1, -0.7, 0.4, 1.2, 0.8, -2.0];
    let target = generated.forward(&q);
    assert!(difference(&entries(&target), &entries(&Arm::forward(&longer, &q).expect("six joints"))) < 4e-15);
    assert_eq!(all(&longer, &target, &[]).0.len(), generated.inverse(&target).len());
    assert_eq!(arm.with_parameters(&[("a9", 1.0)]).err(), Some("a9"));
}
