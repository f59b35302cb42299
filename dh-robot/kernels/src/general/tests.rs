//! Whole arms through the general solver: generated poses, published poses, singular poses.

use super::attempt::Account;
use super::*;
use crate::pose::{IDENTITY, Pose, compose, turn};
use crate::testing::{Rng, general_6r, link};
use crate::tolerance::REACHED;
use crate::{Kinematics, List, NumericChain, TaskTarget, polish};

mod locked;

fn arm(links: [Pose; 6]) -> NumericChain<6> {
    NumericChain { links, prismatic: [false; 6] }
}

/// A link of the modified convention: Tz(d) of this joint, then Rx(alpha) Tx(a) before the next one.
fn modified(d: f64, alpha: f64, a: f64) -> Pose {
    compose(&link(d, 0.0, alpha), &link(0.0, a, 0.0))
}

/// FANUC CRX-10iA: axes 2 and 3 parallel, neighbours 1-2, 3-4, 4-5, 5-6 meet, no common point in the wrist.
fn offset_wrist() -> NumericChain<6> {
    let minus_quarter_turn = turn(&IDENTITY, [0.0, -1.0]);
    arm([
        modified(0.0, -90.0, 0.0),
        compose(&minus_quarter_turn, &modified(0.0, 0.0, 0.54)),
        modified(0.0, -90.0, 0.0),
        modified(0.54, 90.0, 0.0),
        modified(-0.15, -90.0, 0.0),
        modified(0.16, 0.0, 0.0),
    ])
}

/// The arm of Manseur and Doty (*A robot manipulator with 16 real inverse kinematic solution sets*, 1989).
fn sixteen_solutions() -> NumericChain<6> {
    arm([
        link(0.0, 0.3, 90.0),
        link(0.0, 1.0, 1.0),
        link(0.2, 0.0, 90.0),
        link(0.0, 1.5, 1.0),
        link(0.0, 0.0, 90.0),
        link(0.0, 0.0, 1.0),
    ])
}

/// UFACTORY xArm6: as the CRX, and axes 3 and 4, 5 and 6 don't meet.
fn ufactory() -> NumericChain<6> {
    let (s, c) = 79.34995f64.to_radians().sin_cos();
    arm([
        modified(0.267, -90.0, 0.0),
        compose(&turn(&IDENTITY, [c, -s]), &modified(0.0, 0.0, 0.28948866)),
        compose(&turn(&IDENTITY, [c, s]), &modified(0.0, -90.0, 0.0775)),
        modified(0.3425, 90.0, 0.0),
        modified(0.0, -90.0, 0.076),
        modified(0.097, 0.0, 0.0),
    ])
}

fn solver(arm: &NumericChain<6>) -> General6R {
    let mut rng = Rng::new(70);
    let samples: [(NumericChain<6>, [f64; 6]); 4] = [(); 4].map(|()| (*arm, [(); 6].map(|()| rng.angle())));
    let best = rank::<3>(&samples);
    let at = |i: usize| best.get(i).or(best.first()).map_or(Choice::default(), |r| r.choice);
    General6R::with_prismatic(&arm.links, &arm.prismatic, [at(0), at(1), at(2)])
}

fn apart(p: &[f64; 6], q: &[f64; 6]) -> f64 {
    p.iter().zip(q).fold(0.0, |m, (a, b)| f64::max(m, (0.5 * (a - b)).sin().abs()))
}

/// Every solution reaches the target, and no two are the same.
fn assert_sound(arm: &NumericChain<6>, target: &Pose, solved: &Solved) {
    for (i, q) in solved.solutions.iter().enumerate() {
        let miss = polish(arm, &mut q.clone(), &TaskTarget::Pose(*target), arm.length_scale(), 0);
        assert!(miss.reaches(2.0 * REACHED), "{miss:?}");
        assert!((0..6).all(|j| arm.prismatic[j] || q[j].abs() <= core::f64::consts::PI));
        assert!(solved.solutions[..i].iter().all(|p| apart(p, q) > 1e-7));
    }
}

fn generated_poses_come_back(arm: &NumericChain<6>, seed: u64, most: usize) {
    let solver = solver(arm);
    let mut rng = Rng::new(seed);
    let mut largest = 0;
    for _ in 0..40 {
        let q = [(); 6].map(|()| rng.angle());
        let target = arm.forward(&q);
        let solved = solver.solve(&target);
        assert!(solved.solutions.iter().any(|p| apart(p, &q) < 1e-6), "{q:?}");
        assert!(solved.solutions.len().is_multiple_of(2), "{q:?}");
        assert_sound(arm, &target, &solved);
        largest = largest.max(solved.solutions.len());
    }
    assert!(largest >= most, "{largest}");
}

#[test]
fn an_arm_without_structure() {
    generated_poses_come_back(&general_6r(), 71, 6);
}

#[test]
fn an_arm_with_parallel_axes_and_an_offset_wrist() {
    generated_poses_come_back(&offset_wrist(), 72, 12);
}

#[test]
fn an_arm_with_many_solutions() {
    generated_poses_come_back(&sixteen_solutions(), 73, 12);
}

/// UFACTORY xArm7 with joint 3 held at 0: axes 2 and 3 parallel, no common point anywhere.
fn locked_seven_axis_arm() -> NumericChain<6> {
    arm([
        modified(0.267, -90.0, 0.0),
        compose(&modified(0.0, 90.0, 0.0), &modified(0.293, 90.0, 0.0525)),
        modified(0.0, 90.0, 0.0775),
        modified(0.3425, 90.0, 0.0),
        modified(0.0, -90.0, 0.076),
        modified(0.097, 0.0, 0.0),
    ])
}

#[test]
fn choices_that_do_not_fit_the_arm_are_replaced() {
    // With more structure than the choices were made for, most of them are useless.
    let arm = locked_seven_axis_arm();
    let mut rng = Rng::new(76);
    for number in (0..Choice::COUNT).step_by(5) {
        let solver = General6R::new(&arm.links, [Choice::new(number); 3]);
        let q = [(); 6].map(|()| rng.angle());
        let target = arm.forward(&q);
        let solved = solver.solve(&target);
        assert!(solved.solutions.iter().any(|p| apart(p, &q) < 1e-6), "{number} {q:?}");
        assert!(solved.solutions.len().is_multiple_of(2), "{number} {q:?} {}", solved.solutions.len());
        assert_sound(&arm, &target, &solved);
    }
}

#[test]
fn joints_that_slide() {
    // On a rail; with a telescope; with two slides in a row.
    for prismatic in [[0, 0], [2, 2], [5, 5], [0, 1], [3, 2]] {
        let mut arm = general_6r();
        for j in prismatic {
            arm.prismatic[j] = true;
        }
        generated_poses_come_back(&arm, 74, 4);
    }
}

#[test]
fn all_sixteen_solutions_of_a_published_pose() {
    // Problem 6 of Wampler and Morgan (*Solving the 6R inverse position problem using a generic-case solution methodology*, 1991), also
    // in Manocha and Canny, 1994; its six digits made orthonormal.
    let target = [
        [-0.7601170954517629, -0.6416887913189714, 0.10226190051809382, -1.140175],
        [0.13333303810415512, 1.7448607485795684e-07, 0.9910712895397007, 0.0],
        [-0.635959355738943, 0.7669651198689326, 0.08555818343409317, 0.0],
    ];
    let arm = sixteen_solutions();
    let solved = solver(&arm).solve(&target);
    assert_sound(&arm, &target, &solved);
    assert_eq!((solved.solutions.len(), solved.clean), (16, true));
}

#[test]
fn two_solutions_may_share_the_hidden_angle() {
    // Joint angles of 10, -80, 10, 20, -20, 45 degrees at the controller: 16 solutions, some of which share the angles of joints 2 and 3.
    let arm = offset_wrist();
    let q = [10.0, -80.0, 70.0, -20.0, 20.0, -45.0f64].map(f64::to_radians);
    let target = arm.forward(&q);
    let solved = solver(&arm).solve(&target);
    assert_sound(&arm, &target, &solved);
    assert_eq!(solved.solutions.len(), 16);
}

/// Links of a random arm with the structure that this choice needs; none if that would be a structure of the target.
fn arm_for(choice: Choice, rng: &mut Rng) -> Option<NumericChain<6>> {
    let joints = choice.joints();
    let link_after = |part: usize| if choice.reversed() { (joints[part] + 5) % 6 } else { joints[part] };
    let (parallel, meeting) = (link_after(1), link_after(3));
    if parallel == 5 || meeting == 5 {
        return None;
    }
    let mut links = [(); 6].map(|()| {
        let (d, a) = (0.3 * rng.symmetric(), 0.3 * rng.symmetric());
        let twist = if rng.unit() < 0.5 { 90.0 } else { 40.0 + 80.0 * rng.unit() };
        link(d, if rng.unit() < 0.5 { 0.0 } else { a }, twist)
    });
    links[parallel] = link(0.2 * rng.symmetric(), 0.3 + 0.2 * rng.unit(), if rng.unit() < 0.5 { 0.0 } else { 180.0 });
    links[meeting] = link(0.3 * rng.symmetric(), 0.0, if rng.unit() < 0.5 { 90.0 } else { 50.0 });
    Some(arm(links))
}

#[test]
fn two_parallel_and_two_meeting_axes_at_any_place() {
    let mut rng = Rng::new(77);
    let (mut most, mut poses, mut open) = (0, 0, 0);
    for choice in (0..Choice::COUNT).map(Choice::new).filter(|c| c.is_pairs()) {
        for _ in 0..3 {
            let Some(arm) = arm_for(choice, &mut rng) else { continue };
            let structured = General6R::new(&arm.links, [choice; 3]);
            let general = General6R::new(&arm.links, [Choice::new(0), Choice::new(13), Choice::new(43)]);
            for _ in 0..4 {
                let q = [(); 6].map(|()| rng.angle());
                let target = arm.forward(&q);
                let mut solutions = List::new();
                let attempt = structured.attempt(
                    &structured.scaled_target(&target),
                    choice,
                    &mut { Budget::THOROUGH },
                    &mut solutions,
                );
                poses += 1;
                open += usize::from(attempt.account != Account::Full);
                let solved = structured.solve(&target);
                assert!(solved.solutions.iter().any(|p| apart(p, &q) < 1e-6), "{choice:?} {q:?}");
                assert_sound(&arm, &target, &solved);
                // The elimination by matrices counts the same.
                assert_eq!(solved.solutions.len(), general.solve(&target).solutions.len(), "{choice:?} {q:?}");
                most = most.max(solved.solutions.len());
            }
        }
    }
    assert!(most >= 12 && poses >= 75 && 20 * open < poses, "{most} {poses} {open}");
}

#[test]
fn a_wrist_above_the_base_leaves_the_shoulder_to_the_last_equation() {
    // The point where axes 4 and 5 meet lies on axis 1 for one angle of joint 6: four of the eight solutions are there.
    let quarter = core::f64::consts::FRAC_PI_2;
    let arm = ufactory();
    let target = arm.forward(&[0.0, -quarter, 0.0, quarter, -quarter, -quarter]);
    let solved = solver(&arm).solve(&target);
    assert_sound(&arm, &target, &solved);
    assert_eq!((solved.solutions.len(), solved.clean), (8, true));
}

#[test]
fn three_pairs_of_solutions_may_share_the_hidden_angle() {
    let arm = offset_wrist();
    let quarter = core::f64::consts::FRAC_PI_2;
    let target = arm.forward(&[-2.0 * quarter, 2.0 * quarter, 2.0 * quarter, 2.0 * quarter, 2.0 * quarter, -quarter]);
    let solved = solver(&arm).solve(&target);
    assert_sound(&arm, &target, &solved);
    assert_eq!(solved.solutions.len(), 6);
}

#[test]
fn a_calibrated_arm_with_distant_normals_keeps_its_digits() {
    // A UR5 whose file says 298 m up and down again, because axes 2 to 4 are parallel within a thousandth of a radian.
    let tilted = |d: f64, a: f64, alpha: f64| link(d, a, alpha);
    let arm = arm([
        tilted(0.0895, 0.0001, 90.02),
        tilted(298.3, -0.1, 0.07),
        tilted(-328.7, -0.02, 0.05),
        tilted(30.5, 0.0, 89.97),
        tilted(0.0946, 0.0, -90.01),
        tilted(0.0823, 0.0, 0.0),
    ]);
    let solver = solver(&arm);
    let mut rng = Rng::new(78);
    let scale = General6R::new(&arm.links, [Choice::default(); 3]).scaled_arm().length_scale();
    assert!((scale - 1.0).abs() < 1e-9);
    for _ in 0..20 {
        let q = [(); 6].map(|()| rng.angle());
        let target = arm.forward(&q);
        let solved = solver.solve(&target);
        assert!(solved.solutions.iter().any(|p| apart(p, &q) < 1e-6), "{q:?}");
        for q in solved.solutions.iter() {
            // In metres: forward kinematics itself loses three digits on its way up and down.
            let miss = polish(&arm, &mut q.clone(), &TaskTarget::Pose(target), 1.0, 0);
            assert!(miss.reaches(1e-11), "{miss:?}");
        }
    }
}

#[test]
fn unreachable_poses_have_no_solution() {
    for arm in [general_6r(), offset_wrist(), sixteen_solutions()] {
        let mut target = arm.forward(&[0.3; 6]);
        target[0][3] += 10.0;
        let solved = solver(&arm).solve(&target);
        assert!(solved.solutions.is_empty() && solved.clean);
    }
}

#[test]
fn a_singular_pose_gives_what_there_is() {
    // Stretched out: a double solution at least, and the elimination degenerates.
    for arm in [general_6r(), offset_wrist(), sixteen_solutions()] {
        let target = arm.forward(&[0.0; 6]);
        let solved = solver(&arm).solve(&target);
        assert!(!solved.solutions.is_empty());
        assert_sound(&arm, &target, &solved);
    }
}

#[test]
fn bad_numbers_give_nothing() {
    let arm = general_6r();
    for bad in [f64::NAN, f64::INFINITY] {
        let mut target = arm.forward(&[0.3; 6]);
        target[1][3] = bad;
        assert!(solver(&arm).solve(&target).solutions.is_empty());
    }
}

#[test]
fn ranking_refuses_an_arm_that_cannot_move_freely() {
    // Six parallel axes.
    let arm = arm([link(0.1, 0.3, 0.0); 6]);
    let samples = [(arm, [0.1, 0.5, -0.4, 1.0, 2.0, -1.3]); 3];
    assert!(rank::<3>(&samples).is_empty());
}
