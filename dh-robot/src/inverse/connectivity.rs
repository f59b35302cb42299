//! Connectivity of the solution set: whether a self-motion of the arm leads from one solution to another.

use super::Setting;
use super::null_space::Motions;
use super::verifier::{SAME, Verifier};
use crate::{Real, math};
use dh_kernels::{Drive, Kinematics};

/// Most steps along a self-motion.
const WALK: usize = 40;
/// Longest step (rad, or length scales).
const STRIDE: f64 = 0.3;
/// Turns beyond this (rad) may as well be made the other way round: of three that add up to a whole one the largest is.
const ROUND: f64 = 2.0;
/// Joint vectors nearer than this are the same.
const ARRIVED: f64 = 1e-4;

/// The shortest way from `p` to `q`, in rad and length scales.
pub(super) fn apart<T: Real, const N: usize>(
    drive: &Option<Drive<N>>,
    setting: &Setting<T, N>,
    p: &[f64; N],
    q: &[f64; N],
) -> [f64; N] {
    let mut way: [f64; N] = core::array::from_fn(|k| q[k] - p[k]);
    if let Some(drive) = drive {
        way = drive.shortest(way);
    }
    core::array::from_fn(|k| {
        let x = way[k];
        if setting.joints[k].is_revolute() {
            x - core::f64::consts::TAU * math::floor(x / core::f64::consts::TAU + 0.5)
        } else {
            x / setting.length_scale
        }
    })
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// The shortest way from `p` to `q`, in rad and length scales.
    pub(super) fn apart(&self, p: &[f64; N], q: &[f64; N]) -> [f64; N] {
        apart(&self.drive, &self.setting, p, q)
    }

    /// `p` after a step in rad and length scales.
    pub(super) fn moved_by(&self, p: &[f64; N], step: &[f64; N], size: f64) -> [f64; N] {
        core::array::from_fn(|k| {
            let unit = if self.setting.joints[k].is_revolute() { 1.0 } else { self.setting.length_scale };
            p[k] + size * unit * step[k]
        })
    }

    /// Ways from `p` to `q`: the shortest one, then those on which one of the joints turns the other way round. Half a turn of two joints
    /// against each other and half a turn of both together end at the same joint vector.
    fn ways(&self, p: &[f64; N], q: &[f64; N]) -> impl Iterator<Item = [f64; N]> {
        let shortest = self.apart(p, q);
        let (joints, single) = (self.setting.joints, self.drive.is_none());
        let far = move |k: &usize| single && joints[*k].is_revolute() && shortest[*k].abs() > ROUND;
        core::iter::once(shortest).chain((0..N).filter(far).map(move |k| {
            let mut way = shortest;
            way[k] -= core::f64::consts::TAU.copysign(way[k]);
            way
        }))
    }

    /// A straight way from `p` among the solutions that ends at `q`, or so near that it is the same. (Beside a self-motion polishing may end
    /// at a joint vector that does not belong to it but still reaches the target.)
    pub(super) fn straight_way(&self, p: &[f64; N], q: &[f64; N]) -> Option<[f64; N]> {
        let level = self.level(p);
        let reached = |way: &[f64; N], t: f64| self.miss(&self.moved_by(p, way, t)) <= level;
        self.ways(p, q).find_map(|way| {
            let along = self.within_motions(p, &way).map(|x| if x.abs() <= SAME { 0.0 } else { x });
            let ends = way.iter().zip(&along).all(|(w, a)| (w - a).abs() <= SAME);
            (ends && [0.5, 0.3, 0.85].iter().all(|t| reached(&along, *t))).then_some(along)
        })
    }

    /// Whether a path leads from `p` to `q` among the solutions.
    pub(super) fn are_joined(&self, p: &[f64; N], q: &[f64; N]) -> bool {
        self.ways(p, q).any(|way| self.walk(p, way))
    }

    /// Walks from `p` in a direction as far as the solutions reach; returns whether it arrives.
    fn walk(&self, p: &[f64; N], mut way: [f64; N]) -> bool {
        let size = |v: &[f64; N]| math::sqrt(v.iter().map(|x| x * x).sum::<f64>());
        let level = self.level(p);
        let mut x = *p;
        let mut left = size(&way);
        for _ in 0..WALK {
            if left <= ARRIVED {
                return true;
            }
            let step = self.within_motions(&x, &way);
            let length = size(&step);
            if length < 0.02 * left {
                return false;
            }
            let stride = (STRIDE / length).min(1.0);
            let mut next = self.moved_by(&x, &step, stride);
            if !self.brought_back(&mut next, 20, level) {
                return false;
            }
            let moved = self.apart(&x, &next);
            way = core::array::from_fn(|k| way[k] - moved[k]);
            let then = size(&way);
            if then > left - 0.1 * stride * length.min(left) {
                return false;
            }
            (x, left) = (next, then);
        }
        false
    }

    /// The part of a direction that leaves the target reached, to first order.
    pub(super) fn within_motions(&self, x: &[f64; N], way: &[f64; N]) -> [f64; N] {
        self.within(self.motions(x), way)
    }

    /// The part of a direction that is a sum of motions.
    pub(super) fn within(&self, mut basis: Motions<N>, way: &[f64; N]) -> [f64; N] {
        let dot = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut part = [0.0; N];
        for i in 0..basis.len {
            // Gram-Schmidt.
            let mut v = basis.list[i];
            for u in basis.list.iter().take(i) {
                let along = dot(&v, u);
                for k in 0..N {
                    v[k] -= along * u[k];
                }
            }
            let h: f64 = math::sqrt(dot(&v, &v));
            basis.list[i] = if h > 1e-9 { v.map(|x| x / h) } else { [0.0; N] };
            let along = dot(way, &basis.list[i]);
            for k in 0..N {
                part[k] += along * basis.list[i][k];
            }
        }
        part
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Joint;
    use crate::inverse::Setting;
    use dh_kernels::{NumericChain, TaskTarget, pose};

    static JOINTS: [Joint; 2] = [Joint::revolute("q1"), Joint::revolute("q2")];

    /// Two joints about one axis: what one turns the other turns back.
    #[test]
    fn joints_on_one_axis_turn_against_each_other() {
        let mut tool = pose::IDENTITY;
        tool[0][3] = 1.0;
        let arm = NumericChain { links: [pose::IDENTITY, tool], prismatic: [false; 2] };
        let (a, b) = ([0.2, 0.3], [1.2, -0.7]);
        let task = TaskTarget::Pose(arm.forward(&a));
        let setting = Setting { joints: &JOINTS, length_scale: 1.0, rank_deficient: true, given: [None; 2] };
        let verifier: Verifier<'_, _, f64, 2, 4> = Verifier::new(&arm, setting, &task);
        assert!(verifier.straight_way(&a, &b).is_some() && verifier.are_joined(&a, &b));
        let off = [1.2, 0.3];
        assert!(verifier.straight_way(&a, &off).is_none() && !verifier.are_joined(&a, &off));
        // The short way round.
        let way = verifier.apart(&[3.0, 0.0], &[-3.0, 0.5]);
        assert!((way[0] - (core::f64::consts::TAU - 6.0)).abs() < 1e-15 && way[1] == 0.5);
        assert!(verifier.straight_way(&[3.0, -2.5], &[-3.0, 3.5]).is_some());
        // Half a turn of both, of which each shortest way alone is the same turn.
        let half = core::f64::consts::PI;
        let there = [0.2 + half, 0.3 + half];
        assert!(verifier.straight_way(&a, &there).is_some() && verifier.are_joined(&a, &there));
    }
}
