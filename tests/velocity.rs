//! Velocities end to end: the Jacobian in the tool's axes, its derivative against finite differences, singular poses, joint speeds.

use dh_robot::dh_robot;
use dh_robot::nalgebra::{IsometryMatrix3, SMatrix, Vector3, Vector6};
use dh_tests::engine::invented;
use dh_tests::sample::Random;
use generated_examples::panda::Panda;
use generated_examples::puma560::Puma560;

use crate::robots::robot;

dh_robot! {
    /// Geared: every row moves by several motors, whole turns of rows are no whole turns of motors.
    struct Gears;
    convention = standard;
    let g: length = 0.75;
    | theta               | d    | a    | alpha  |
    | q1                  | 0.4  | 0.1  | -90deg |
    | 0.5*q2              | 0    | 0.5  |   0    |
    | q3 - 0.5*q2 - 30deg | 0    | 0.05 | -90deg |
    | 2*q4                | 0.45 | 0    |  90deg |
    | q5 - 2*q4           | 0    | 0    | -90deg |
    | q6 + g*q5           | 0.1  | 0    |   0    |
}

dh_robot! {
    /// The last motor lifts while it turns; the first two are exchanged.
    struct Screw;
    convention = standard;
    tool = tx(0.1) * rx(40deg);
    | theta   | d               | a    | alpha  |
    | q2      | 0               | 0.25 |   0    |
    | q1 - q2 | 0               | 0.3  |  80deg |
    | 0       | q3 + 0.00398*q4 | 0    |   0    |
    | -q4     | 0               | 0    |   0    |
}

/// The derivative along `speeds` by central differences, two steps extrapolated.
fn slope<const N: usize>(
    jacobian: impl Fn(&[f64; N]) -> SMatrix<f64, 6, N>,
    q: &[f64; N],
    speeds: &[f64; N],
) -> SMatrix<f64, 6, N> {
    let at = |h: f64| jacobian(&std::array::from_fn(|i| q[i] + h * speeds[i]));
    let central = |h: f64| (at(h) - at(-h)) / (2.0 * h);
    (central(5e-4) * 4.0 - central(1e-3)) / 3.0
}

/// What a robot's functions must satisfy at random joint values.
macro_rules! check {
    ($name:expr, $arm:expr, $dof:literal) => {{
        let arm = $arm;
        let mut random = Random::new(31);
        for _ in 0..20 {
            let q: [f64; $dof] = std::array::from_fn(|_| 3.0 * random.signed());
            let speeds: [f64; $dof] = std::array::from_fn(|_| random.signed());
            let jacobian = arm.jacobian(&q);
            let size = 1.0 + jacobian.norm();
            let wrong = (arm.jacobian_dot(&q, &speeds) - slope(|q| arm.jacobian(q), &q, &speeds)).abs().max();
            assert!(wrong < 1e-9 * size * size, "{}: {wrong:e} at {q:?}", $name);
            // In the tool's axes it is the tool's own motion: pose(t)^-1 pose(t + h).
            let pose = arm.forward(&q);
            let own = arm.jacobian_in_tool(&q);
            for j in 0..$dof {
                let moved = |h: f64| arm.forward(&std::array::from_fn(|i| q[i] + if i == j { h } else { 0.0 }));
                let step = |h: f64| motion(&(pose.inverse() * moved(h)));
                let slope = (step(1e-4) - step(-1e-4)) / 2e-4;
                assert!((slope - own.column(j)).abs().max() < 1e-6 * size * size, "{}: column {j}", $name);
            }
            // Joint speeds come back as far as they can, and the rest is said.
            let twist = jacobian * SMatrix::<f64, $dof, 1>::from(speeds);
            let found = arm.solve_velocity(&q, &twist);
            let reached = jacobian * SMatrix::<f64, $dof, 1>::from(found.speeds);
            assert!((twist - reached - found.missed).norm() < 1e-12 * size, "{}", $name);
            assert!(found.damping > 0.0 || found.missed.norm() < 1e-10 * size, "{}: {found:?}", $name);
            let least = arm.smallest_singular_value(&q);
            assert!(least >= 0.0 && arm.manipulability(&q) >= least.powi(6).min(least) * 0.999 - 1e-12, "{}", $name);
        }
    }};
}

/// A small motion as a twist: translation, and the rotation's axis times its sine.
fn motion(pose: &IsometryMatrix3<f64>) -> Vector6<f64> {
    let (p, r) = (pose.translation.vector, pose.rotation.matrix());
    let w = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) / 2.0;
    Vector6::new(p.x, p.y, p.z, w.x, w.y, w.z)
}

macro_rules! examples {
    ($($module:ident $name:ident $dof:literal)*) => {
        #[test]
        fn velocities_of_every_example() {
            $(check!(stringify!($module), robot!($module, generated_examples::$module::$name), $dof);)*
        }
    };
}

generated_examples::for_every_robot!(examples);

#[test]
fn velocities_of_coupled_drives() {
    check!("gears", Gears::default(), 6);
    check!("screw", Screw, 4);
}

#[test]
fn singular_poses_are_damped_and_say_so() {
    let arm = Puma560::default();
    let twist = Vector6::new(0.1, 0.2, -0.1, 0.3, 0.4, 0.2);
    let bent = [0.3, -0.8, 0.4, 0.2, 0.9, -0.5];
    let exact = arm.solve_velocity(&bent, &twist);
    assert_eq!(exact.damping, 0.0);
    assert!(exact.missed.norm() < 1e-12 && arm.smallest_singular_value(&bent) > 0.01);
    // A straight wrist.
    let straight = [0.3, -0.8, 0.4, 0.2, 0.0, -0.5];
    let damped = arm.solve_velocity(&straight, &twist);
    assert!(arm.smallest_singular_value(&straight) < 1e-12 && arm.manipulability(&straight) < 1e-12);
    assert!(damped.damping > 0.005 && damped.missed.norm() > 0.01);
    assert!(damped.speeds.iter().all(|s| s.abs() < 58.0 * twist.norm()));
    // On the way there the speeds do not jump.
    let mut last = exact.speeds;
    for k in 0..=9000 {
        let q = [0.3, -0.8, 0.4, 0.2, 0.9 - f64::from(k) * 1e-4, -0.5];
        let now = arm.solve_velocity(&q, &twist).speeds;
        assert!(last.iter().zip(&now).all(|(a, b)| (a - b).abs() < 0.5), "{q:?}");
        last = now;
    }
    // A joint to spare: of all speeds the shortest, so nothing along the self-motion.
    let q = [0.1, -0.5, 0.3, -1.8, 0.2, 1.5, 0.4];
    let found = Panda.solve_velocity(&q, &twist);
    assert!(found.damping == 0.0 && found.missed.norm() < 1e-12);
    let jacobian = Panda.jacobian(&q);
    let square = (jacobian * jacobian.transpose()).try_inverse().expect("not singular");
    let wanted = jacobian.transpose() * (square * twist);
    assert!((SMatrix::<f64, 7, 1>::from(found.speeds) - wanted).norm() < 1e-10);
}
