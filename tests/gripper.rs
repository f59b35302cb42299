//! Poses that the program sets, in `base` and `tool`: against the same tables without them, multiplied by nalgebra.

use dh_robot::nalgebra::{IsometryMatrix3, Point3, SMatrix, Unit, Vector3, Vector6};
use dh_robot::{Arm, InverseKinematics, Stop, Why, dh_robot, follow, pose};

mod bare {
    use dh_robot::dh_robot;

    dh_robot! {
        pub struct Six;
        convention = standard;
        tool = tz(50mm);
        | joint | theta | d | a | alpha | range |
        | 1 | q1 | 89mm | 0 | 90deg | -360deg..=360deg |
        | 2 | q2 | 0 | -425mm | 0 | -360deg..=360deg |
        | 3 | q3 | 0 | -392mm | 0 | -360deg..=360deg |
        | 4 | q4 | 109mm | 0 | 90deg | -360deg..=360deg |
        | 5 | q5 | 95mm | 0 | -90deg | -360deg..=360deg |
        | 6 | q6 | 82mm | 0 | 0 | -360deg..=360deg |
    }
}

dh_robot! {
    /// An arm on a rail with a gripper.
    pub struct Six;
    convention = standard;
    let l2 = 425mm;
    let high: length = 0.3m;
    /// Where the arm stands.
    let rail: pose;
    let gripper: pose = tz(120mm) * ry(90deg);
    base = tz(high) * rail * rz(90deg);
    tool = tz(50mm) * gripper * tx(10mm);
    | joint | theta | d | a | alpha | range |
    | 1 | q1 | 89mm | 0 | 90deg | -360deg..=360deg |
    | 2 | q2 | 0 | -l2 | 0 | -360deg..=360deg |
    | 3 | q3 | 0 | -392mm | 0 | -360deg..=360deg |
    | 4 | q4 | 109mm | 0 | 90deg | -360deg..=360deg |
    | 5 | q5 | 95mm | 0 | -90deg | -360deg..=360deg |
    | 6 | q6 | 82mm | 0 | 0 | -360deg..=360deg |
}

dh_robot! {
    pub struct Wrist;
    convention = modified;
    task = position;
    let gripper: pose = tz(120mm) * ry(90deg);
    tool = tx(30mm) * gripper;
    | joint | alpha | a | d | theta |
    | 1 | 0 | 0 | 0.4 | q1 |
    | 2 | 90deg | 0 | 0 | q2 |
    | 3 | 0 | 0.5 | 0 | q3 |
}

dh_robot! {
    pub struct Flat;
    convention = modified;
    task = planar;
    let base_pose: pose = tx(0);
    let hand: pose = tx(0.1) * rz(30deg);
    base = base_pose;
    tool = tx(0.3) * hand;
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 0 | 0.5 | 0 | q2 |
    | 0 | 0.4 | 0 | q3 |
}

dh_robot! {
    pub struct Five;
    convention = standard;
    task = axis;
    let hand: pose = tz(0.1);
    base = hand;
    tool = hand;
    | theta | d | a | alpha |
    | q1 | 0.2 | 0 | 90deg |
    | q2 | 0 | 0.4 | 0 |
    | q3 | 0 | 0.3 | 0 |
    | q4 + 90deg | 0 | 0 | 90deg |
    | q5 | 0.15 | 0 | 0 |
}

dh_robot! {
    pub struct Spare;
    convention = modified;
    task = position;
    redundant = q1;
    scalar = f32;
    let rail: pose = tx(0.5);
    base = rail * tz(0.1);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0.2 | 0 | q2 |
    | 0 | 0.5 | 0 | q3 |
    | 0 | 0.4 | 0 | q4 |
}

fn some(k: f64) -> IsometryMatrix3<f64> {
    IsometryMatrix3::new(Vector3::new(0.1 * k, -0.07, 0.05 - 0.02 * k), Vector3::new(0.3, 0.2 * k, -0.5))
}

fn joints<const N: usize>(k: usize) -> [f64; N] {
    core::array::from_fn(|i| (1.7 * (k * N + i) as f64 + 0.3).sin() * 2.0 + 0.1)
}

fn six() -> Six {
    Six { high: 0.2, rail: some(2.0), gripper: some(-1.0) }
}

fn apart(a: &IsometryMatrix3<f64>, b: &IsometryMatrix3<f64>) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

#[test]
fn forward_frames_and_jacobian_are_those_of_the_product() {
    let robot = six();
    let before = IsometryMatrix3::translation(0.0, 0.0, 0.2)
        * some(2.0)
        * IsometryMatrix3::rotation(Vector3::z() * core::f64::consts::FRAC_PI_2);
    let after = some(-1.0) * IsometryMatrix3::translation(0.01, 0.0, 0.0);
    for k in 0..50 {
        let q = joints(k);
        assert!(apart(&robot.forward(&q), &(before * bare::Six.forward(&q) * after)) < 1e-14);
        for (a, b) in robot.frames(&q).iter().zip(bare::Six.frames(&q)) {
            assert!(apart(a, &(before * b)) < 1e-14);
        }
        let jacobian = robot.jacobian(&q);
        let (h, mut slopes) = (1e-6, SMatrix::<f64, 6, 6>::zeros());
        for j in 0..6 {
            let (mut plus, mut minus) = (q, q);
            plus[j] += h;
            minus[j] -= h;
            let (a, b) = (robot.forward(&minus), robot.forward(&plus));
            let v = (b.translation.vector - a.translation.vector) / (2.0 * h);
            let r = (b.rotation * a.rotation.inverse()).into_inner();
            let w = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) / (4.0 * h);
            slopes.set_column(j, &Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z));
        }
        assert!((jacobian - slopes).abs().max() < 1e-8, "{k}");
        let (speeds, t) = ([0.3, -0.2, 0.5, 0.1, -0.4, 0.2], 1e-6);
        let at = |t: f64| robot.jacobian(&core::array::from_fn(|i| q[i] + t * speeds[i]));
        assert!((robot.jacobian_dot(&q, &speeds) - (at(t) - at(-t)) / (2.0 * t)).abs().max() < 1e-7);
        let turned =
            robot.forward(&q).rotation.inverse() * Vector3::new(jacobian[(0, 2)], jacobian[(1, 2)], jacobian[(2, 2)]);
        assert!((robot.jacobian_in_tool(&q).fixed_view::<3, 1>(0, 2) - turned).norm() < 1e-14);
        let twist = jacobian * Vector6::from(speeds);
        if robot.smallest_singular_value(&q) > 0.05 {
            let solved = robot.solve_velocity(&q, &twist);
            assert!(solved.speeds.iter().zip(speeds).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }
}

#[test]
fn the_inverse_finds_what_forward_came_from() {
    let robot = six();
    let mut targets = Vec::new();
    for k in 0..60 {
        let q = joints(k);
        let target = robot.forward(&q);
        let found = robot.inverse(&target);
        assert!(!found.is_empty() && found.iter().all(|s| apart(&robot.forward(&s.q), &target) < 1e-9), "{k}: {found}");
        let near = robot.inverse_near(&target, &q).unwrap();
        assert!(near.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-7), "{k}: {near} {q:?}");
        assert_eq!(robot.inverse_exhaustive(&target).len(), found.len());
        targets.push(target);
    }
    let mut all = [robot.inverse(&targets[0]); 60];
    robot.inverse_batch(&targets, &mut all);
    assert!(all.iter().zip(&targets).all(|(list, target)| *list == robot.inverse(target)));
    let arm: &dyn Arm = &robot;
    let mut count = 0;
    arm.inverse(&targets[3], &[], &mut |_| count += 1);
    assert_eq!((arm.dof(), count), (6, all[3].len()));
}

#[test]
fn a_path_can_be_followed() {
    let robot = six();
    let start = [0.3, -1.1, 1.4, -0.6, 1.2, 0.4];
    let from = robot.forward(&start);
    let path = (1..=50).map(|i| IsometryMatrix3::translation(0.002 * f64::from(i), 0.0, 0.0) * from);
    let ends: Result<Vec<_>, Stop> = follow(&robot, path, start, 0.2).collect();
    let last = ends.unwrap()[49];
    assert!((robot.forward(&last).translation.vector - from.translation.vector - Vector3::x() * 0.1).norm() < 1e-9);
}

#[test]
fn points_of_grippers_are_reached() {
    let robot = Wrist { gripper: some(1.0) };
    for robot in [robot, Wrist::default()] {
        for k in 0..50 {
            let q = joints(k);
            let target = Point3::from(robot.forward(&q).translation.vector);
            let found = robot.inverse(&target);
            assert!(found.iter().all(|s| (robot.forward(&s.q).translation.vector - target.coords).norm() < 1e-9));
            let wrap = |x: f64| x.sin().atan2(x.cos()).abs();
            assert!(found.iter().any(|s| s.q.iter().zip(q).all(|(a, b)| wrap(a - b) < 1e-6)), "{k}: {found}");
        }
    }
}

#[test]
fn poses_of_planar_arms_stay_in_the_plane() {
    let turned =
        |x, y, angle| IsometryMatrix3::translation(x, y, 0.1) * IsometryMatrix3::rotation(Vector3::z() * angle);
    let mut robot = Flat { base_pose: turned(0.2, -0.3, 0.7), hand: turned(0.1, 0.2, -0.4) };
    for k in 0..50 {
        let q = joints(k);
        let target = robot.forward(&q);
        let phi = target.rotation[(1, 0)].atan2(target.rotation[(0, 0)]);
        let found = robot.inverse((target.translation.x, target.translation.y, phi));
        let wrap = |x: f64| x.sin().atan2(x.cos()).abs();
        assert!(found.iter().any(|s| s.q.iter().zip(q).all(|(a, b)| wrap(a - b) < 1e-6)), "{k}: {found}");
        assert!(found.iter().all(|s| apart(&robot.forward(&s.q), &target) < 1e-9));
    }
    robot.base_pose = some(1.0);
    assert_eq!(robot.inverse((0.5, 0.1, 0.0)).why().to_string(), "`base` tilts the plane of the arm");
}

#[test]
fn axes_of_grippers_are_reached() {
    let along = |z, angle| IsometryMatrix3::translation(0.0, 0.0, z) * IsometryMatrix3::rotation(Vector3::z() * angle);
    let mut robot = Five { hand: along(0.2, 0.4) };
    for k in 0..40 {
        let q = joints(k);
        let pose = robot.forward(&q);
        let axis = Unit::new_normalize(pose.rotation * Vector3::z());
        let found = robot.inverse((Point3::from(pose.translation.vector), axis));
        assert!(!found.is_empty(), "{k}: {found}");
        for s in &found {
            let there = robot.forward(&s.q);
            assert!((there.translation.vector - pose.translation.vector).norm() < 1e-8);
            assert!((there.rotation * Vector3::z() - axis.into_inner()).norm() < 1e-8);
        }
    }
    robot.hand = some(1.0);
    let why = robot.inverse((Point3::new(0.3, 0.1, 0.4), Vector3::z_axis())).why();
    assert!(why.to_string().starts_with("`tool` moves the tool off"), "{why}");
}

#[test]
fn joints_that_are_given_and_single_precision() {
    let robot = Spare { rail: some(1.0).cast() };
    for k in 0..30 {
        let q = joints::<4>(k).map(|x| x as f32);
        let target = Point3::from(robot.forward(&q).translation.vector);
        // Three joints are left for three coordinates only in the plane of the given one.
        let found = InverseKinematics::inverse(&robot, &(target, q[0]));
        for s in &found {
            assert!((robot.forward(&s.q).translation.vector - target.coords).norm() < 1e-4, "{k}");
        }
    }
}

#[test]
fn a_pose_that_is_none_is_an_answer() {
    let target = six().forward(&joints(1));
    let q = joints(1);
    for (x, text) in [
        (f64::NAN, "`gripper` holds a number that is not finite"),
        (f64::INFINITY, "`gripper` holds a number that is not finite"),
    ] {
        let mut robot = six();
        robot.gripper.translation.y = x;
        assert_eq!(robot.inverse(&target).why().to_string(), text);
        assert_eq!(robot.inverse_near(&target, &q).unwrap_err().to_string(), text);
        _ = (robot.forward(&q), robot.jacobian(&q), robot.manipulability(&q));
    }
    let mut robot = six();
    robot.rail = pose::from_entries([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
    assert!(matches!(robot.inverse(&target).why(), Why::UnfitPose { of: "rail", .. }));
    // One that lost digits is repaired, as a target is.
    let mut robot = six();
    let exact = robot.gripper;
    let rounded = exact.to_homogeneous().map(|x| (x * 1e6).round() / 1e6);
    let entry = |i: usize| [rounded[(i, 0)], rounded[(i, 1)], rounded[(i, 2)]];
    robot.gripper =
        pose::from_entries([entry(0), entry(1), entry(2)], [rounded[(0, 3)], rounded[(1, 3)], rounded[(2, 3)]]);
    let found = robot.inverse(&target);
    assert!(!found.is_empty() && found.iter().all(|s| apart(&robot.forward(&s.q), &target) < 5e-6), "{found}");
}

#[test]
fn documents_and_exports_say_what_they_leave_out() {
    use dh_symbolic::{ExportOptions, Format, Language, NotesOptions, Robot};

    let table = "struct A; convention = modified; task = position;
        let gripper: pose = tz(0.1); let rail: pose = tx(1); base = rail * tz(0.3); tool = tz(50mm) * gripper * ry(90deg);
        | alpha | a | d | theta | | 0 | 0 | 0 | q1 | | 90deg | 0 | 0 | q2 | | 0 | 0.5 | 0 | q3 |
        prove { T(0,2).pz = 0; }";
    let robot = Robot::parse(table).unwrap();
    assert!(robot.check_proofs().is_some_and(|checked| checked.is_fine()));
    for (language, words) in [(Language::English, "The program sets"), (Language::Chinese, "由程序在运行时给定")]
    {
        let notes = robot.notes(&NotesOptions { language, ..NotesOptions::default() }).print(Format::Text);
        assert!(notes.contains(words) && notes.contains("gripper"), "{notes}");
        let plan = robot.plan().unwrap().document(language).print(Format::Text);
        assert!(plan.contains(words) && plan.contains("gripper"), "{plan}");
    }
    let files = robot.export_c(&ExportOptions::default()).unwrap();
    assert!(files.iter().any(|f| f.0 == "src/lib.rs" && f.1.contains("let gripper: pose")));
    assert!(robot.page(&NotesOptions::default()).unwrap().contains("<html"));
    assert!(dh_dynamic::DynamicArm::new(&robot).is_err_and(|e| e.to_string().contains("poses that the program sets")));
    let open = Robot::parse(&table.replace("rail: pose = tx(1)", "rail: pose")).unwrap();
    assert!(open.export_c(&ExportOptions::default()).is_err_and(|e| e.to_string().contains("no nominal value")));
}
