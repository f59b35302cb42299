//! Joint ranges on self-motions: the point that represents a self-motion is moved into the ranges where it passes through them.

use super::fallback::Search;
use super::verifier::{SAME, Verifier};
use crate::{Branch, FreeJoints, Real, Solution};
use dh_kernels::Kinematics;

/// Steps along a self-motion (rad, or length scales), and how many on each side: a whole turn.
const STEP: f64 = 0.02;
const STEPS: u16 = 314;
/// Distance kept from a limit (rad, or table units).
const EDGE: f64 = 0.01;
/// How far behind a limit the way into the ranges leads (rad, or table units): steps come nearer by a part of what is left.
const BEHIND: f64 = 0.2;
/// Steps of going into the ranges and back onto the self-motion.
const ENTERING: usize = 16;
/// Where it is entered: at joint values spread over the ranges (fractions of them).
const ENTRIES: [f64; 6] = [0.5, 0.3, 0.7, 0.15, 0.85, 0.4];

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Moves representatives that are out of range along their self-motion, no farther than needed, where that is one motion at
    /// constant joint rates.
    pub(super) fn move_into_ranges(&mut self) {
        for i in 0..self.out.len() {
            let Some(solution) = self.out.get(i).filter(|s| !s.free.is_empty()) else { continue };
            let q = solution.q.map(T::to_f64);
            if !self.inside(&q)
                && let Some(moved) = self.moved_inside(&q)
                && let Some(solution) = self.out.get_mut(i)
            {
                for ((x, joint), place) in moved.iter().zip(self.setting.joints).zip(&mut solution.q) {
                    *place = joint.normalize(T::of(*x));
                }
            }
        }
    }

    pub(super) fn inside(&self, q: &[f64; N]) -> bool {
        self.setting.joints.iter().zip(q).all(|(joint, x)| joint.contains(joint.normalize(T::of(*x))))
    }

    /// The same by arithmetic: along a motion at constant rates each joint is in range at certain stretches, whose ends are tried.
    fn straight_inside(&self, q: &[f64; N]) -> Option<[f64; N]> {
        let motions = self.motions(q);
        let v = motions.list.first().filter(|_| motions.len == 1)?;
        let mut best: Option<(f64, [f64; N])> = None;
        for (k, joint) in self.setting.joints.iter().enumerate() {
            let Some((least, greatest)) = joint.range.filter(|_| v[k].abs() > 1e-6) else { continue };
            let unit = if joint.is_revolute() { 1.0 } else { self.setting.length_scale };
            let inset = EDGE.min(0.25 * (greatest - least).to_f64());
            for end in [least.to_f64() + inset, greatest.to_f64() - inset] {
                for turn in if joint.is_revolute() { [0.0, 1.0, -1.0] } else { [0.0; 3] } {
                    let t = (end - q[k] + turn * core::f64::consts::TAU) / (v[k] * unit);
                    let moved = self.moved_by(q, v, t);
                    if best.is_none_or(|(s, _)| t.abs() < s) && self.inside(&moved) {
                        best = Some((t.abs(), moved));
                    }
                }
            }
        }
        best.filter(|(_, moved)| self.miss(moved) <= self.tolerance).map(|(_, moved)| moved)
    }

    /// The way to the nearest joint values within the ranges, a little off the limits.
    fn way_inside(&self, q: &[f64; N]) -> [f64; N] {
        core::array::from_fn(|k| {
            let joint = &self.setting.joints[k];
            let Some((least, greatest)) = joint.range.map(|(l, g)| (l.to_f64(), g.to_f64())) else { return 0.0 };
            let x = joint.normalize(T::of(q[k]));
            if self.setting.given[k].is_some() || joint.contains(x) {
                return 0.0;
            }
            let inset = BEHIND.min(0.25 * (greatest - least));
            // Of an angle out of range the limit may be nearer that is reached the other way round.
            let turn = if joint.is_revolute() { core::f64::consts::TAU } else { 0.0 };
            let ways = [0.0, turn, -turn].map(|by| {
                let x = x.to_f64() + by;
                x.max(least + inset).min(greatest - inset) - x
            });
            ways.into_iter().fold(ways[0], |m, x| if x.abs() < m.abs() { x } else { m })
        })
    }

    /// Joint values spread over the ranges.
    fn entry(&self, part: f64) -> [f64; N] {
        core::array::from_fn(|k| {
            if let Some(x) = self.setting.given[k] {
                return x;
            }
            let joint = &self.setting.joints[k];
            let whole = if joint.is_revolute() { core::f64::consts::PI } else { self.setting.length_scale };
            let (least, greatest) = joint.range.map_or((-whole, whole), |(l, g)| (l.to_f64(), g.to_f64()));
            // Neighbours go different ways.
            let part = if k % 2 == 0 { part } else { 1.0 - part };
            least + part * (greatest - least)
        })
    }

    #[cold]
    fn moved_inside(&self, q: &[f64; N]) -> Option<[f64; N]> {
        let motions = self.motions(q);
        let v = motions.list.first().filter(|_| motions.len == 1)?;
        (1..=STEPS)
            .flat_map(|k| [1.0, -1.0].map(|sign| sign * STEP * f64::from(k)))
            .map(|t| self.moved_by(q, v, t))
            .find(|moved| self.inside(moved) && self.miss(moved) <= self.tolerance)
    }
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Search<'_, A, T, N, M> {
    /// Moves representatives of self-motions that are out of range into the ranges: along a motion at constant rates where that leads there; and
    /// where no solution is in range of an arm with more joints than its task has dimensions, by a bounded search for one that is.
    pub(super) fn keep_in_ranges(&mut self) {
        let mut any_inside = false;
        for i in 0..self.verifier.out.len() {
            let Some(solution) = self.verifier.out.get(i) else { continue };
            let (q, is_free) = (solution.q.map(T::to_f64), !solution.free.is_empty());
            let moved = if self.verifier.inside(&q) {
                Some(q)
            } else if is_free {
                self.verifier.straight_inside(&q)
            } else {
                None
            };
            any_inside |= moved.is_some();
            if let Some(moved) = moved.filter(|_| is_free) {
                self.replace(i, &moved);
            }
        }
        let joints = self.verifier.setting.given.iter().filter(|x| x.is_none()).count();
        if any_inside || joints <= self.verifier.task.dimensions() {
            return;
        }
        let Some(found) = self.member_inside() else { return };
        match self.verifier.out.iter().position(|s| !s.free.is_empty()) {
            Some(i) => self.replace(i, &found),
            None => {
                let motions = self.verifier.motions(&found);
                let moves = |k: &usize| motions.list.iter().take(motions.len).any(|v| v[*k].abs() > 1e-6);
                let free = (0..N).filter(moves).fold(FreeJoints::NONE, FreeJoints::with);
                self.verifier.push(Solution::new(found.map(T::of), Branch::ANY).with_free(free));
            }
        }
    }

    /// Lets another point stand for a self-motion.
    fn replace(&mut self, i: usize, by: &[f64; N]) {
        let joints = self.verifier.setting.joints;
        let Some(solution) = self.verifier.out.get_mut(i) else { return };
        for (k, (x, joint)) in by.iter().zip(joints).enumerate() {
            let x = joint.normalize(T::of(*x));
            if (x - solution.q[k]).abs() > T::of(SAME) {
                solution.free = solution.free.with(k);
            }
            solution.q[k] = x;
        }
    }

    /// A solution in range, from joint values spread over the ranges.
    fn member_inside(&mut self) -> Option<[f64; N]> {
        for entry in ENTRIES {
            let v = &self.verifier;
            let (mut x, steps) = (v.entry(entry), ENTERING.min(self.work.steps_left()));
            let way = |x: &[f64; N]| v.way_inside(x);
            let (miss, taken) =
                dh_kernels::newton_into(v.arm, v.task, v.setting.length_scale, &mut x, steps, 0.1 * v.tolerance, way);
            self.work.steps += taken as u32;
            self.work.evaluations += taken as u32 + 1;
            if miss <= v.tolerance && v.inside(&x) {
                return Some(x);
            }
        }
        None
    }
}
