//! What the roots of a plan mean in space: which one is the left shoulder, the upper elbow, the wrist that is not flipped.
//!
//! Found by looking at the solutions of sample poses, as Lee and Ziegler (1984) define the indicators of a PUMA: the arm reaches its wrist
//! forward or over its own shoulder; the elbow is above or below the line from shoulder to wrist. An arm whose solutions say nothing (other
//! axes, other joints) keeps the order of its roots.

use super::Inverse;
use crate::chain::Chain;
use crate::planner::kernels::pose::{cross, dot};
use crate::planner::{joint_vectors, numeric};

/// Parts of an arm with names for their two sides, in this order.
const PARTS: usize = 3;
/// Poses that are looked at.
const POSES: usize = 2;
/// Lengths over the reach below which two axes meet, and sines below which they are parallel.
const NOTHING: f64 = 1e-9;

/// How the roots of a step are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Names {
    /// Which root has the first name (left, up, no flip); for an elbow `over` the one it has where the shoulder takes its first root.
    pub first: usize,
    /// The step of the shoulder, whose second root turns the names round: what was above is then below.
    pub over: Option<usize>,
}

impl Names {
    /// In the order of the roots.
    pub(super) const PLAIN: Self = Self { first: 0, over: None };
}

impl Inverse {
    /// Which part of an arm with six joints a step with two roots decides: 0 shoulder, 1 elbow, 2 wrist; each part once. A sum of angles
    /// belongs to its last joint: `q2 + q3 + q4` is how the hand points, not where the elbow is.
    pub fn part(&self, step: usize) -> Option<usize> {
        let part = |i: usize| {
            let step = self.plan.steps.get(i).filter(|s| s.roots == 2)?;
            let form = step.unknown.first()?;
            match (0..self.plan.axes.real).rev().find(|k| form.get(*k).is_some_and(|x| *x != 0))? {
                0 => Some(0),
                1 | 2 => Some(1),
                _ => Some(2),
            }
        };
        let own = part(step)?;
        (!(0..step).any(|k| part(k) == Some(own))).then_some(own)
    }

    /// The names of the roots of shoulder, elbow and wrist.
    pub(super) fn find_names(&self, chain: &Chain) -> [Names; PARTS] {
        let mut names = [Names::PLAIN; PARTS];
        let axes = &self.plan.axes;
        let step_of = |part: usize| (0..self.plan.steps.len()).find(|i| self.part(*i) == Some(part));
        let steps: [Option<usize>; PARTS] = std::array::from_fn(step_of);
        if axes.real != 6 || axes.count() != 6 || steps == [None; PARTS] {
            return names;
        }
        // How often the first root is the first name: as it is, and with the shoulder's second root turning it round; of how many.
        let mut votes = [[0usize; 3]; PARTS];
        for x in joint_vectors(axes, POSES, 0) {
            let constant = |t| numeric(chain, t, axes.reach);
            let Some(last) = axes.frames_number(&x).pop() else { continue };
            let compose = crate::planner::kernels::pose::compose;
            let target = compose(&compose(&constant(&axes.start), &last), &constant(&axes.end));
            for candidate in self.solve(chain, &target, &[]) {
                let sides = self.sides(chain, &candidate.x);
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
                names[part] = Names { first: usize::from(2 * over < all), over: steps[0] };
            }
        }
        names
    }

    /// Left shoulder, elbow up, wrist not flipped: what joint coordinates say, where the arm has such a thing.
    fn sides(&self, chain: &Chain, x: &[f64]) -> [Option<bool>; PARTS] {
        let axes = &self.plan.axes;
        let frames = axes.frames_number(x);
        // Point and direction of each axis.
        let axis = |joint: usize| {
            let hop = axes.hops.iter().position(|h| h.joint == Some(joint))?;
            let t = frames.get(hop + 1).filter(|_| axes.turns(joint))?;
            Some(([t[0][3], t[1][3], t[2][3]], [t[0][2], t[1][2], t[2][2]]))
        };
        let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        let mut sides = [None; PARTS];
        let (Some(waist), Some(shoulder), Some(fourth), Some(fifth)) = (axis(0), axis(1), axis(3), axis(4)) else {
            return sides;
        };
        // The wrist: the point of axis 4 that is nearest to axis 5.
        let normal = cross(fourth.1, fifth.1);
        let size = dot(normal, normal);
        if size < NOTHING {
            return sides;
        }
        let along = dot(cross(minus(fifth.0, fourth.0), fifth.1), normal) / size;
        let wrist = [0, 1, 2].map(|i| fourth.0[i] + along * fourth.1[i]);
        // Forward: away from the waist where the shoulder is ahead of it, else along the first frame's x axis.
        let ahead = cross(shoulder.1, waist.1);
        let length = dot(ahead, ahead).sqrt();
        if length < 0.5 {
            return sides;
        }
        let offset = dot(minus(shoulder.0, waist.0), ahead) / length;
        let first = axes.hops.iter().position(|h| h.joint == Some(0)).and_then(|hop| frames.get(hop + 1));
        let along_x = first.map_or(0.0, |t| dot([t[0][0], t[1][0], t[2][0]], ahead) / length);
        let sign = if offset.abs() > NOTHING { offset } else { along_x };
        if sign.abs() <= NOTHING {
            return sides;
        }
        let forward = ahead.map(|x| if sign < 0.0 { -x / length } else { x / length });
        let reach = dot(minus(wrist, waist.0), forward);
        let facing = if reach < 0.0 { forward.map(|x| -x) } else { forward };
        let left = cross(waist.1, facing);
        let aside = dot(minus(wrist, waist.0), left);
        sides[0] = Some(if aside.abs() > NOTHING { aside > 0.0 } else { reach > 0.0 });
        if let Some(elbow) = axis(2)
            && dot(cross(elbow.1, shoulder.1), cross(elbow.1, shoulder.1)) < NOTHING
        {
            let turned = cross(minus(elbow.0, shoulder.0), minus(wrist, shoulder.0));
            sides[1] = Some(dot(turned, left) > 0.0);
        }
        let offset =
            chain.joints.get(4).and_then(|j| chain.links.get(j.row)).map_or(0.0, |l| l.theta.constant.radians());
        sides[2] = x.get(4).map(|angle| (angle + offset).sin() > 0.0);
        sides
    }
}
