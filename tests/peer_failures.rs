//! Poses of other libraries' test suites at which solutions were missing, or returned twice: arms with few joints whose reachable set crosses itself,
//! parallel axes, offset wrists.
//!
//! `peer_failures/records.txt` has a line for each: the arm, the kind of the record, joint values, and the solution that was missing (nothing: the
//! joint values themselves).

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{FreeJoints, dh_robot};
use std::f64::consts::TAU;

dh_robot! {
    /// 5R 5R 23 intersecting 34 parallel.
    struct Arm5R5R23Intersecting34Parallel;
    convention = modified;
    base = tx(1.0) * ty(1.0);
    tool = tz(1.0) * rz(-90deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | -90deg | 1.0 | 2.0 | q2 + 90deg |
    | 90deg | 0 | 0 | q3 + 90deg |
    | 0 | 1.0 | 0 | q4 |
    | -90deg | 1.0 | 0 | q5 |
}

dh_robot! {
    /// 5R 5R 23 parallel 45 intersecting 2.
    struct Arm5R5R23Parallel45Intersecting2;
    convention = modified;
    base = tz(1.0) * rz(90deg);
    tool = tx(1.0) * ty(1.0);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 1.0 | 0 | q2 |
    | 0 | 1.0 | 0 | q3 + 90deg |
    | 90deg | 0 | 2.0 | q4 + 90deg |
    | 90deg | 0 | 0 | q5 |
}

dh_robot! {
    /// 5R 5R 34 intersecting 23 parallel.
    struct Arm5R5R34Intersecting23Parallel;
    convention = modified;
    base = tz(1.0) * rz(90deg);
    tool = tx(1.0) * ty(1.0);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 1.0 | 0 | q2 |
    | 0 | 1.0 | 0 | q3 + 90deg |
    | 90deg | 0 | 2.0 | q4 + 90deg |
    | 90deg | 1.0 | 0 | q5 |
}

dh_robot! {
    /// 6R 234 Parallel.
    struct Arm6R234Parallel;
    convention = modified;
    base = tz(1.0) * rz(90deg);
    tool = tz(2.0) * rz(-90deg) * ry(-90deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 1.0 | 0 | q2 |
    | 0 | 1.0 | 0 | q3 |
    | 0 | 1.0 | 0 | q4 |
    | -90deg | 1.0 | 0 | q5 |
    | 90deg | 1.0 | 0 | q6 |
}

dh_robot! {
    /// 6R puma reversed.
    struct Arm6RPumaReversed;
    convention = modified;
    base = tz(0.05334);
    tool = tz(0.62357) * rz(180deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0 | 0 | q2 + 180deg |
    | 90deg | 0 | 0.431999 | q3 + 180deg |
    | 90deg | 0 | 0 | q4 |
    | 0 | 0.4318 | 0.12954 | q5 + 180deg |
    | 90deg | 0 | 0 | q6 |
}

dh_robot! {
    /// 6R two Sphericals.
    struct Arm6RTwoSphericals;
    convention = modified;
    base = tx(0.0528192) * rz(180deg) * rx(90deg);
    tool = rx(90deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0 | 0 | q2 |
    | 90deg | 0 | 0 | q3 + 180deg |
    | 0 | 0.140253 | 0 | q4 |
    | 90deg | 0 | 0 | q5 |
    | 90deg | 0 | 0 | q6 |
}

dh_robot! {
    /// Doosan Robotics H2515.
    struct DoosanRoboticsH2515;
    convention = modified;
    unit = mm;
    | alpha | a | d | theta |
    | 0 | 0 | 344.300000000000011 | q1 + 180deg |
    | -90deg | 0 | -9.9 | -q2 - 90deg |
    | 0 | 759.5 | 0 | -q3 - 90deg |
    | -90deg | 0 | 619.5 | q4 |
    | 90deg | 0 | 0 | -q5 |
    | -90deg | 0 | 121.0 | q6 |
}

dh_robot! {
    /// Kinova Gen3 6DOF.
    struct KinovaGen36Dof;
    convention = modified;
    unit = mm;
    | alpha | a | d | theta |
    | 0 | 0 | 284.800000000000011 | q1 |
    | -90deg | 0 | 1.0 | q2 - 90deg |
    | 0 | 410.0 | 0 | -q3 - 90deg |
    | -90deg | 0 | 314.300000000000011 | -q4 |
    | 90deg | 0 | 0 | -q5 |
    | -90deg | 0 | 167.400000000000006 | -q6 |
}

dh_robot! {
    /// Parkman13.
    struct Parkman13;
    convention = modified;
    | alpha | a | d | theta |
    | 0 | 0 | 1.0 | q1 |
    | 90deg | 0 | 0 | q2 |
    | 0 | 2.0 | 0 | q3 |
    | 180deg | 3.0 | q4 | 0 |
    | 90deg | 0 | 5.0 | q5 |
}

dh_robot! {
    /// gen3 lite ik.
    struct Gen3LiteIk;
    convention = modified;
    base = tz(0.243250110196153);
    tool = tz(0.105000000000708) * rz(90deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0 | 0 | q2 + 90deg |
    | 180deg | 0.28 | -0.009999485750678 | q3 + 90deg |
    | 90deg | 0 | 0.24500010468729 | q4 + 90deg |
    | 90deg | 0 | 0.057000385686728 | q5 + 180deg |
    | 90deg | 0 | 0 | q6 |
}

dh_robot! {
    /// hc10 ik.
    struct Hc10Ik;
    convention = modified;
    base = tz(0.275) * rz(180deg);
    tool = rz(180deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0 | 0 | q2 + 90deg |
    | 180deg | 0.7 | 0 | q3 + 90deg |
    | 90deg | 0 | -0.5 | q4 + 180deg |
    | 90deg | 0 | -0.162 | q5 + 180deg |
    | 90deg | 0 | 0 | q6 |
}

dh_robot! {
    /// jaco2 ik.
    struct Jaco2Ik;
    convention = modified;
    base = tz(0.2755) * rz(180deg) * rx(180deg);
    tool = tz(-0.202758550968094) * rz(90deg) * rx(180deg);
    | alpha | a | d | theta |
    | 0 | 0 | 0 | q1 |
    | 90deg | 0 | 0 | q2 + 90deg |
    | 180deg | 0.41 | -0.0098 | q3 + 90deg |
    | 90deg | 0 | -0.250060739468094 | q4 |
    | 60deg | 0 | -0.085519290436188 | q5 + 180deg |
    | 60deg | 0 | 0 | q6 |
}

type List = Vec<(Vec<f64>, FreeJoints)>;

/// An arm as functions of slices.
struct Arm {
    name: &'static str,
    forward: fn(&[f64]) -> IsometryMatrix3<f64>,
    inverse: fn(&IsometryMatrix3<f64>, &[f64]) -> List,
}

fn array<const N: usize>(q: &[f64]) -> [f64; N] {
    std::array::from_fn(|k| q[k])
}

macro_rules! arm {
    ($name:literal, $robot:expr, $n:literal, |$q:ident| ($($given:expr)?)) => {
        Arm {
            name: $name,
            forward: |q| $robot.forward(&array::<$n>(q)),
            inverse: |t, $q| {
                let _ = $q;
                $robot.inverse(t $(, $given)?).iter().map(|s| (s.q.to_vec(), s.free)).collect()
            },
        }
    };
}

fn arms() -> Vec<Arm> {
    vec![
        arm!("Arm5R5R23Intersecting34Parallel", Arm5R5R23Intersecting34Parallel, 5, |q| ()),
        arm!("Arm5R5R23Parallel45Intersecting2", Arm5R5R23Parallel45Intersecting2, 5, |q| ()),
        arm!("Arm5R5R34Intersecting23Parallel", Arm5R5R34Intersecting23Parallel, 5, |q| ()),
        arm!("Arm6R234Parallel", Arm6R234Parallel, 6, |q| ()),
        arm!("Arm6RPumaReversed", Arm6RPumaReversed, 6, |q| ()),
        arm!("Arm6RTwoSphericals", Arm6RTwoSphericals, 6, |q| ()),
        arm!("DoosanRoboticsH2515", DoosanRoboticsH2515, 6, |q| ()),
        arm!("KinovaGen36Dof", KinovaGen36Dof, 6, |q| ()),
        arm!("Parkman13", Parkman13, 5, |q| ()),
        arm!("Gen3LiteIk", Gen3LiteIk, 6, |q| ()),
        arm!("Hc10Ik", Hc10Ik, 6, |q| ()),
        arm!("Jaco2Ik", Jaco2Ik, 6, |q| ()),
    ]
}

fn apart(a: f64, b: f64) -> f64 {
    let x = a - b;
    (x - TAU * (x / TAU).round()).abs()
}

/// Does a solution stand for these joint values: all but its free joints agree?
fn stands_for((s, free): &(Vec<f64>, FreeJoints), q: &[f64]) -> bool {
    (0..q.len()).all(|k| free.contains(k) || apart(s[k], q[k]) < 1e-4)
}

#[test]
fn what_was_missing_is_found_and_what_was_double_is_single() {
    let arms = arms();
    let mut lost = Vec::new();
    let records = include_str!("peer_failures/records.txt");
    for line in records.lines() {
        let mut parts = line.split(';').map(str::trim);
        let (name, kind) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
        let mut numbers = || -> Vec<f64> {
            let list = parts.next().unwrap_or_default().split_whitespace();
            list.map(|x| x.parse().unwrap_or_else(|_| panic!("{line}"))).collect()
        };
        let (q, missing) = (numbers(), numbers());
        let arm = arms.iter().find(|a| a.name == name).unwrap_or_else(|| panic!("{line}"));
        let list = (arm.inverse)(&(arm.forward)(&q), &q);
        let fine = if kind == "near_duplicate" {
            let same = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| apart(*a, *b) < 1e-4);
            list.iter().enumerate().all(|(i, a)| list[..i].iter().all(|b| !same(&a.0, &b.0)))
        } else {
            let wanted = if missing.is_empty() { &q } else { &missing };
            list.iter().any(|s| stands_for(s, wanted))
        };
        if !fine {
            lost.push(format!("{line}: {list:?}"));
        }
    }
    assert!(records.lines().count() > 70, "the records are missing");
    assert!(lost.is_empty(), "{} of {}:\n{}", lost.len(), records.lines().count(), lost.join("\n"));
}
