//! The inputs of the general elimination: six constant transforms and the target.

use super::super::graph::{Graph, Value, ZERO};
use super::super::vector::{V3, identity};
use super::lower::{Lower, Pose};
use crate::algebra::{Angle, Poly, Rational, Transform};
use crate::planner::Step;

impl Lower<'_> {
    /// The constant transforms behind the open joints, filled up to six, and the target.
    pub(super) fn general(&mut self, w: Pose, step: &Step) -> Vec<Vec<Value>> {
        let before = step.before;
        let open = |j: usize| step.unknown.iter().any(|f| f[j] != 0);
        let flat = |t: Pose| [t.columns[0], t.columns[1], t.columns[2], t.p].concat();
        let none = Pose { columns: identity(), p: [ZERO; 3] };
        // Constants between open joints; what stands before the first one is taken off the target.
        let mut list: Vec<Pose> = vec![none];
        for link in self.plan.axes.links.clone() {
            let last = list.len() - 1;
            list[last] = self.times(list[last], &link.before);
            match link.joint {
                Some(j) if !open(j) => list[last] = self.moved(list[last], j, before),
                Some(_) => list.push(none),
                None => {}
            }
        }
        // W' = list[0]^-1 W.
        let first = list.remove(0);
        let p = self.g.minus(w.p, first.p);
        let turned = |g: &mut Graph, v: V3| -> V3 { std::array::from_fn(|i| g.dot(first.columns[i], v)) };
        let goal = Pose { columns: w.columns.map(|v| turned(&mut self.g, v)), p: turned(&mut self.g, p) };
        // Further joints with transforms around them that cancel when they are zero.
        let mut undo = Transform::identity();
        for k in list.len()..6 {
            let t = filler(k);
            let last = list.len() - 1;
            list[last] = self.times(list[last], &t);
            undo = undo.times(&t);
            list.push(none);
        }
        if let Some(last) = list.last().copied().filter(|_| undo != Transform::identity()) {
            let end = list.len() - 1;
            list[end] = self.times(last, &undo.inverse());
        }
        list.push(goal);
        list.into_iter().map(flat).collect()
    }
}

/// A transform without any structure, lengths over the length scale, in front of the k-th joint of the general elimination.
fn filler(k: usize) -> Transform {
    let angle = |degrees: i64| {
        let (c, s) = Angle::degrees(&Rational::int(degrees)).cos_sin().unwrap_or_default();
        move |axis: usize| Transform::rotation(axis, (&c, &s))
    };
    let length = |n: i64| Poly::constant(Rational::new(n, 100).unwrap_or(Rational::ZERO));
    let n = k as i64;
    angle(60)(0)
        .times(&Transform::translation(0, &length(23 + 7 * n)))
        .times(&angle(45 + 15 * n)(1))
        .times(&Transform::translation(2, &length(31 - 5 * n)))
        .times(&angle(75)(0))
}
