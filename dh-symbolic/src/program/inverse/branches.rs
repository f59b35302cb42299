//! Names the roots of a plan by configuration: left or right shoulder, upper or lower elbow, flipped wrist or not.
//!
//! Found by looking at the solutions of sample poses, as Lee and Ziegler (1984) define the indicators of a PUMA: the arm reaches its wrist
//! forward or over its own shoulder; the elbow is above or below the line from shoulder to wrist. An arm whose solutions say nothing (other
//! axes, other joints) keeps the order of its roots.

use super::{Indicator, Inverse, Naming};
use crate::algebra::Transform;
use crate::chain::Chain;
use crate::planner::{Axes, Plan, joint_vectors, numeric};
use dh_kernels::vector::{cross, dot};

/// Parts of an arm with names for their two sides, in this order.
const PARTS: usize = 3;
/// Poses that are looked at.
const POSES: usize = 2;
/// Lengths over the length scale below which two axes meet, and sines below which they are parallel.
const NOTHING: f64 = 1e-9;

/// The indicators in their order.
const INDICATORS: [Indicator; PARTS] = [Indicator::Shoulder, Indicator::Elbow, Indicator::Wrist];

impl Plan {
    /// Which part of an arm a step with two roots decides; each part once.
    ///
    /// Of the joints that are solved for the first is the shoulder's, the second and third are the elbow's, the others the wrist's. A sum of
    /// angles belongs to its last joint: `q2 + q3 + q4` is how the hand points, not where the elbow is. Where two steps would have one name,
    /// and there are names enough, they have them in the order of their joints.
    pub fn indicator(&self, step: usize) -> Option<Indicator> {
        let joints = self.solved_joints();
        // The joint that each step with two roots decides, in order.
        let mut places: Vec<(usize, usize)> = (0..self.steps.len())
            .filter_map(|i| {
                let step = self.steps.get(i).filter(|s| s.roots == 2)?;
                let form = step.unknown.first()?;
                let place = joints.iter().rposition(|k| form.get(*k).is_some_and(|x| *x != 0))?;
                Some((place, i))
            })
            .collect();
        places.sort_unstable();
        let plain = |place: usize| [0, 1, 1].get(place).copied().unwrap_or(2);
        let mut parts: Vec<usize> = places.iter().map(|p| plain(p.0)).collect();
        if let ([a, b], 2) = (parts.as_slice(), parts.len()) {
            parts = match (*a, *b) {
                (1, 1) => vec![0, 1],
                (2, 2) => vec![1, 2],
                (a, b) => vec![a, b],
            };
        } else if parts.len() == PARTS {
            parts = vec![0, 1, 2];
        }
        let own = places.iter().position(|p| p.1 == step)?;
        let part = *parts.get(own)?;
        // Of too many steps the first of the plan has the name.
        let earlier = |k: usize| parts[k] == part && places[k].1 < step;
        if (0..parts.len()).any(earlier) { None } else { INDICATORS.get(part).copied() }
    }

    /// The joints that are solved for.
    fn solved_joints(&self) -> Vec<usize> {
        let given = self.knowledge.known.get(..self.given).unwrap_or_default();
        let open = |k: &usize| !given.iter().any(|g| g.form.get(*k).is_some_and(|x| *x != 0));
        (0..self.axes.real).filter(open).collect()
    }
}

impl Inverse {
    /// Names the roots of shoulder, elbow and wrist.
    pub(super) fn name_branches(&mut self, chain: &Chain) {
        let names = self.find_names(chain);
        let indicators: Vec<Option<Indicator>> = (0..self.plan.steps.len()).map(|i| self.plan.indicator(i)).collect();
        for choice in self.body.result_mut().map(|r| r.branch.as_mut_slice()).unwrap_or_default() {
            choice.name = names.into_iter().find(|n| indicators.get(choice.step) == Some(&Some(n.indicator)));
        }
    }

    /// The names of the roots of shoulder, elbow and wrist; in the order of the roots where the solutions say nothing.
    fn find_names(&self, chain: &Chain) -> [Naming; PARTS] {
        let mut names = INDICATORS.map(|indicator| Naming { indicator, first: 0, flipped_by: None });
        let axes = &self.plan.axes;
        let step_of = |i: Indicator| (0..self.plan.steps.len()).find(|k| self.plan.indicator(*k) == Some(i));
        let steps: [Option<usize>; PARTS] = INDICATORS.map(step_of);
        let solved = self.plan.solved_joints();
        if solved.len() != 6 || axes.count() != axes.real || steps == [None; PARTS] {
            return names;
        }
        // Votes for the first root having the first name: as it is, flipped by the shoulder's second root, of how many.
        let mut votes = [[0usize; 3]; PARTS];
        for x in joint_vectors(axes, POSES, 0) {
            let constant = |t| numeric(chain, t, axes.length_scale);
            let Some(last) = axes.frames_number(&x).pop() else { continue };
            let compose = dh_kernels::pose::compose;
            let target = compose(&compose(&constant(&axes.start), &last), &constant(&axes.end));
            let given: Vec<f64> = self.plan.knowledge.known[..self.plan.given].iter().map(|k| k.at(&x)).collect();
            for candidate in self.solve(chain, &target, &given) {
                let sides = sides(chain, axes, &candidate.x, &solved);
                let root = |part: usize| steps[part].and_then(|i| candidate.branch.get(i).copied());
                for (part, votes) in votes.iter_mut().enumerate() {
                    let (Some(side), Some(root_taken)) = (sides[part], root(part)) else { continue };
                    let first = (root_taken == 0) == side;
                    votes[0] += usize::from(first);
                    votes[1] += usize::from(first == (root(0) != Some(1)));
                    votes[2] += 1;
                }
            }
        }
        for (part, [plain, over, all]) in votes.into_iter().enumerate() {
            let clear = |count: usize| 10 * count >= 9 * all || 10 * count <= all;
            if all == 0 {
                continue;
            }
            if clear(plain) {
                names[part].first = usize::from(2 * plain < all);
            } else if clear(over) && part == 1 {
                names[part].first = usize::from(2 * over < all);
                names[part].flipped_by = steps[0];
            }
        }
        names
    }
}

/// The z axis of frame 0 as the first axis sees it.
fn upright(chain: &Chain, axes: &Axes) -> [f64; 3] {
    let base = chain.base.iter().fold(Transform::identity(), |t, e| t.times(&e.transform()));
    let (base, start) = (numeric(chain, &base, axes.length_scale), numeric(chain, &axes.start, axes.length_scale));
    [0, 1, 2].map(|j| (0..3).map(|i| start[i][j] * base[i][2]).sum())
}

/// Left shoulder, elbow up, wrist not flipped at given joint coordinates, where the arm has such parts. `solved`: the joints that are not
/// given, six of them.
pub(crate) fn sides(chain: &Chain, axes: &Axes, x: &[f64], solved: &[usize]) -> [Option<bool>; PARTS] {
    let frames = axes.frames_number(x);
    // Point and direction of each axis.
    let axis = |place: usize| {
        let joint = *solved.get(place)?;
        let link = axes.links.iter().position(|h| h.joint == Some(joint))?;
        let t = frames.get(link + 1).filter(|_| axes.is_revolute(joint))?;
        Some(([t[0][3], t[1][3], t[2][3]], [t[0][2], t[1][2], t[2][2]]))
    };
    let mut sides = [None; PARTS];
    let middle = solved.get(4).copied().unwrap_or_default();
    let offset =
        chain.joints.get(middle).and_then(|j| chain.links.get(j.row)).map_or(0.0, |l| l.theta.constant.radians());
    sides[2] = x.get(middle).map(|angle| (angle + offset).sin() > 0.0);
    // A joint that is given may carry the arm, not stand in it.
    if solved.windows(2).any(|w| w[1] != w[0] + 1) {
        return sides;
    }
    let (Some(mut waist), Some(shoulder), Some(fourth), Some(fifth)) = (axis(0), axis(1), axis(3), axis(4)) else {
        return sides;
    };
    // Above is where the z axis of frame 0 points, also where the first joint turns about its negative.
    if dot(upright(chain, axes), waist.1) < -0.5 {
        waist.1 = waist.1.map(|x| -x);
    }
    let parallel = |a: [f64; 3], b: [f64; 3]| dot(cross(a, b), cross(a, b)) < NOTHING;
    let elbow = axis(2).filter(|elbow| parallel(elbow.1, shoulder.1));
    let Some(wrist) = nearest(fourth, fifth) else { return sides };
    // Where axis 4 is parallel to these too, it is the next point whose place does not depend on how the elbow bends.
    let hand = match (elbow, axis(5)) {
        (Some(elbow), Some(sixth)) if parallel(elbow.1, fourth.1) => nearest(fifth, sixth).unwrap_or(wrist),
        _ => wrist,
    };
    // Forward: away from the waist where the shoulder is ahead of it, else along the first frame's x axis.
    let ahead = cross(shoulder.1, waist.1);
    let length = dot(ahead, ahead).sqrt();
    if length < 0.5 {
        return sides;
    }
    let offset = dot(minus(shoulder.0, waist.0), ahead) / length;
    let first =
        axes.links.iter().position(|h| h.joint == solved.first().copied()).and_then(|link| frames.get(link + 1));
    let along_x = first.map_or(0.0, |t| dot([t[0][0], t[1][0], t[2][0]], ahead) / length);
    let sign = if offset.abs() > NOTHING { offset } else { along_x };
    if sign.abs() <= NOTHING {
        return sides;
    }
    let forward = ahead.map(|x| if sign < 0.0 { -x / length } else { x / length });
    let ahead_of_waist = dot(minus(hand, waist.0), forward);
    let facing = if ahead_of_waist < 0.0 { forward.map(|x| -x) } else { forward };
    let left = cross(waist.1, facing);
    let aside = dot(minus(hand, waist.0), left);
    sides[0] = Some(if aside.abs() > NOTHING { aside > 0.0 } else { ahead_of_waist > 0.0 });
    if let Some(elbow) = elbow {
        let turned = cross(minus(elbow.0, shoulder.0), minus(wrist, shoulder.0));
        sides[1] = Some(dot(turned, left) > 0.0);
    }
    sides
}

/// A point and a direction.
type Line = ([f64; 3], [f64; 3]);

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The point of one line that is nearest to another; none where they are parallel.
fn nearest(a: Line, b: Line) -> Option<[f64; 3]> {
    let normal = cross(a.1, b.1);
    let size = dot(normal, normal);
    let along = dot(cross(minus(b.0, a.0), b.1), normal) / size;
    (size >= NOTHING).then(|| [0, 1, 2].map(|i| a.0[i] + along * a.1[i]))
}
