//! Known poses: the target multiplied by the inverse transforms of known joints, from both ends of the arm.

use super::super::graph::{ONE, Value, ZERO};
use super::super::vector::V3;
use super::lower::{Lower, Pose};
use crate::algebra::Transform;
use crate::chain::Coordinate;
use crate::planner::{JointCombination, KnownPose};

impl Lower<'_> {
    /// Binds the symbols of a known pose: the target brought back over known joints. Turns about parallel axes are taken together.
    pub(super) fn bind_pose(&mut self, w: Pose, pose: &KnownPose, before: usize) {
        if self.bound.contains(&(pose.left, pose.right)) {
            return;
        }
        self.bound.push((pose.left, pose.right));
        let t = self.pose_between(w, pose.left, pose.right, before);
        for i in 0..3 {
            for j in 0..3 {
                self.g.bind(pose.r[i][j], t.columns[j][i]);
            }
            self.g.bind(pose.p[i], t.p[i]);
        }
        for j in 0..3 {
            let back = self.g.dot(t.columns[j], t.p);
            self.g.bind(pose.back[j], -back);
        }
        let square = self.g.dot(t.p, t.p);
        self.g.bind(pose.square, square);
    }

    fn pose_between(&mut self, w: Pose, left: usize, right: usize, before: usize) -> Pose {
        let mut t = w;
        let count = self.plan.axes.count();
        // From the left: the rotation waits until an axis of another direction comes.
        let mut pending: JointCombination = vec![0; count];
        for link in 0..left {
            let h = self.plan.axes.links[link].clone();
            if is_shift(&h.before) {
                let shift = self.vector(&h.before.p);
                t.p = self.g.minus(t.p, shift);
            } else {
                t = self.flush(t, &mut pending, before);
                t = self.before_inverse(t, &h.before);
            }
            if let Some(j) = h.joint {
                match self.plan.axes.coordinates[j] {
                    Coordinate::Angle(_) => {
                        pending[j] += 1;
                        let mut unit = vec![0; count];
                        unit[j] = 1;
                        let (c, s) = self.cos_sin_if_needed(&unit, before, t.p);
                        t.p = self.g.turn(2, (c, -s), t.p);
                    }
                    Coordinate::Length(s) => {
                        let d = self.g.symbol(s);
                        t.p = self.g.minus(t.p, [ZERO, ZERO, d]);
                    }
                }
            }
        }
        t = self.flush(t, &mut pending, before);
        for link in (right..self.plan.axes.links.len()).rev() {
            let h = self.plan.axes.links[link].clone();
            if let Some(j) = h.joint {
                match self.plan.axes.coordinates[j] {
                    Coordinate::Angle(_) => {
                        let mut unit = vec![0; count];
                        unit[j] = 1;
                        let (c, s) = self.cos_sin(&unit, before);
                        // Columns times Rz(-q): x' = x c - y s, y' = x s + y c.
                        let (x, y) = (t.columns[0], t.columns[1]);
                        let (a, b) = (self.g.times(c, x), self.g.times(s, y));
                        t.columns[0] = self.g.minus(a, b);
                        let (a, b) = (self.g.times(s, x), self.g.times(c, y));
                        t.columns[1] = self.g.plus(a, b);
                    }
                    Coordinate::Length(s) => {
                        let d = self.g.symbol(s);
                        let part = self.g.times(d, t.columns[2]);
                        t.p = self.g.minus(t.p, part);
                    }
                }
            }
            t = self.after_inverse(t, &h.before);
        }
        t
    }

    /// The turn of a position about z costs nothing where the position is on the axis.
    fn cos_sin_if_needed(&mut self, form: &[i8], before: usize, p: V3) -> (Value, Value) {
        if p[0] == ZERO && p[1] == ZERO { (ONE, ZERO) } else { self.cos_sin(form, before) }
    }

    /// Applies the waiting rotation to the columns.
    fn flush(&mut self, mut t: Pose, pending: &mut JointCombination, before: usize) -> Pose {
        if pending.iter().any(|k| *k != 0) {
            let (c, s) = self.cos_sin(pending, before);
            t.columns = t.columns.map(|v| self.g.turn(2, (c, -s), v));
            pending.fill(0);
        }
        t
    }
}

/// Whether the rotation part is the identity.
fn is_shift(t: &Transform) -> bool {
    t.r == Transform::identity().r
}
