//! Finds self-motions from runs of the plan: where a step leaves its unknown free, it is sampled so that connected solutions are recognised.

use super::cells::{Cells, Cut, Event, common_zeros};
use super::fallback::{BLUNT, FEW, MANY, Plan, RUN, Search};
use super::path::{Path, SinCosEquation};
use super::sheets::{Node, Sheets};
use super::{Attempt, Sample};
use crate::{Branch, FreeJoints, Real, Solution};
use dh_kernels::{Kinematics, List, Pose};

/// Angles at which the equations behind a free unknown are seen: three determine the sinusoids of the coefficients, the fourth checks them.
const ANGLES: [f64; 4] = [0.0, 2.1, -2.1, 0.9];
/// Further angles where that is not enough.
const MORE: [f64; 5] = [-0.8, 1.5, 2.8, -1.5, 3.3];

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Search<'_, A, T, N, M> {
    /// The self-motions, from a run in which a step was free.
    pub(super) fn self_motions(
        &mut self,
        frame: &Pose,
        first: &List<Node<N>, RUN>,
        run: &Attempt,
        sample: Sample,
        plan: &impl Plan<N>,
    ) {
        let free = first.iter().filter_map(|n| n.path.first_free()).chain(run.first_free()).min();
        let Some(step) = free else { return };
        // Isolated solutions beside a self-motion: the candidates miss.
        let mut kept: List<Node<N>, RUN> = List::new();
        let (mut crossed, mut wide) = (false, false);
        for node in first.iter().filter(|n| n.path.is_chosen()) {
            let mut node = *node;
            self.alone |= !self.keep(&mut node);
            crossed |= self.verifier.motions(&node.q).len > 1;
            wide |= node.path.free.count_ones() > 1;
            kept.push(node);
        }
        wide = wide && self.surfaces(frame, run, plan);
        let is_curve = |n: &Node<N>| n.path.is_chosen() && !(wide && n.path.free.count_ones() > 1);
        if !run.status.lost && !kept.iter().any(is_curve) {
            return;
        }
        let plain = run.equations.is_empty() && !run.status.lost && !self.alone && !crossed;
        let mut sheets: Sheets<N> = Sheets::new();
        if plain {
            for node in kept.iter().filter(|n| is_curve(n)) {
                sheets.push(*node);
            }
            return self.take_sheets(&sheets, &Cells::of(&[], &[]));
        }
        let at = |angle: f64| sample.with(step, angle);
        let mut runs: [List<Node<N>, RUN>; 3] = [List::new(); 3];
        let mut equations: [List<SinCosEquation, 24>; 4] = [run.equations, List::new(), List::new(), List::new()];
        for (k, angle) in ANGLES.iter().enumerate().skip(1) {
            equations[k] = self.run(frame, &at(*angle), plan, &mut runs[k - 1]).equations;
        }
        if self.alone {
            self.take_alone(frame, &at, [&kept, &runs[0], &runs[1], &runs[2]], plan);
        }
        let cells = Cells::of(&ANGLES, &equations.each_ref().map(|l| l.as_slice()));
        let mut sampled = 0_u32;
        let (drive, setting) = (self.verifier.drive, self.verifier.setting);
        let differ = |p: &[f64; N], q: &[f64; N]| {
            let way = super::connectivity::apart(&drive, &setting, p, q);
            (0..N).filter(|k| way[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with)
        };
        let mut add = |sheets: &mut Sheets<N>, list: &List<Node<N>, RUN>, angle: f64| {
            let cell = cells.cell(angle);
            let new = cell.is_none_or(|c| sampled >> c & 1 == 0) || cells.rough;
            for node in list.iter().filter(|n| is_curve(n)) {
                let node = Node { cell, angle, ..*node };
                if new {
                    sheets.push(node);
                } else {
                    sheets.compare(&node, differ);
                }
            }
            if let Some(c) = cell {
                sampled |= 1 << c;
            }
        };
        add(&mut sheets, &kept, 0.0);
        for (list, angle) in runs.iter().zip(&ANGLES[1..]) {
            add(&mut sheets, list, *angle);
        }
        for cell in 0..cells.len() {
            let middle = cells.middle(cell);
            if cells.len() > 1 && !sheets.covers(cell) && !self.work.is_used_up() {
                let mut list = List::new();
                self.run(frame, &at(middle), plan, &mut list);
                add(&mut sheets, &list, middle);
            }
        }
        for cut in cells.cuts.iter().filter(|c| c.event != Event::Fold) {
            if !self.work.is_used_up() {
                let mut list = List::new();
                self.run(frame, &at(cut.angle).with_tolerance(BLUNT), plan, &mut list);
                for node in list.iter().filter(|n| n.path.is_chosen()) {
                    sheets.push(Node { cell: None, angle: cut.angle, ..*node });
                }
            }
        }
        if cells.rough || run.status.lost && sheets.is_empty() {
            for angle in MORE {
                if !self.work.is_used_up() {
                    let mut list = List::new();
                    self.run(frame, &at(angle), plan, &mut list);
                    add(&mut sheets, &list, angle);
                }
            }
        }
        self.take_sheets(&sheets, &cells);
    }

    /// Self-motions of two dimensions, where two steps are free at values of no special kind: one point represents each. Paths that differ
    /// in the half turns of later steps meet where those are free too. Returns whether there are any.
    fn surfaces(&mut self, frame: &Pose, run: &Attempt, plan: &impl Plan<N>) -> bool {
        let mut lists: [List<Node<N>, RUN>; 2] = [List::new(); 2];
        for (k, list) in lists.iter_mut().enumerate() {
            let sample = self.verifier.first_sample();
            self.run(frame, &Sample::nth(k as u8 + 1).with_tolerance(sample.tolerance), plan, list);
        }
        let half_turn = |step: usize| run.equations.iter().filter(|e| e.step == step).all(|e| e.coefficients[2] == 0.0);
        let mut taken: List<Path, RUN> = List::new();
        for node in lists[0].iter().filter(|n| n.path.free.count_ones() > 1) {
            let path = (0..16).filter(|k| half_turn(*k)).fold(node.path, Path::without);
            let mut node = *node;
            if taken.contains(&path) || !self.keep(&mut node) {
                continue;
            }
            let motions = self.verifier.motions(&node.q);
            let basis = motions.list.iter().take(motions.len).flatten();
            let mut free = FreeJoints::NONE;
            for (k, x) in basis.enumerate() {
                free = if x.abs() > 1e-6 { free.with(k % N) } else { free };
            }
            let same = |n: &&Node<N>| (0..16).filter(|k| half_turn(*k)).fold(n.path, Path::without) == path;
            for other in lists.iter().flat_map(|l| l.iter()).filter(same) {
                let way = self.verifier.apart(&node.q, &other.q);
                free = (0..N).filter(|k| way[*k].abs() > 1e-6).fold(free, FreeJoints::with);
            }
            if motions.len > 1 && taken.push(path) {
                self.verifier.push(Solution::new(node.q.map(T::of), node.branch).with_free(free));
            }
        }
        !taken.is_empty()
    }

    /// Isolated solutions, where a step left free what other equations decide: the candidates' error is a sinusoid of the unknown, and
    /// its zeros are solutions.
    fn take_alone(
        &mut self,
        frame: &Pose,
        at: &impl Fn(f64) -> Sample,
        lists: [&List<Node<N>, RUN>; 4],
        plan: &impl Plan<N>,
    ) {
        for node in lists[0].iter() {
            if self.verifier.miss(&node.q) <= 1e-5 {
                continue;
            }
            let same = lists.map(|l| l.iter().find(|n| n.path == node.path));
            let mut angles: List<f64, 2> = List::new();
            if let [Some(a), Some(b), Some(c), Some(d)] = same {
                self.work.evaluations += 4;
                let v = &self.verifier;
                let values = [a, b, c, d].map(|n| v.task.difference(&v.arm.forward(&n.q), v.setting.length_scale));
                for root in &common_zeros(ANGLES, &values) {
                    angles.push(crate::math::atan2(root[1], root[0]));
                }
            }
            for angle in &angles {
                let mut list: List<Node<N>, RUN> = List::new();
                if !self.work.is_used_up() {
                    self.run(frame, &at(*angle), plan, &mut list);
                }
                for found in list.iter().filter(|n| n.path == node.path) {
                    let mut q = found.q;
                    if self.settle(&mut q, FEW) {
                        self.take(q, found.branch);
                    }
                }
            }
            for found in same.iter().flatten().filter(|_| angles.is_empty()) {
                let mut q = found.q;
                if self.newton(&mut q, MANY) <= self.verifier.tolerance {
                    self.take(q, found.branch);
                }
            }
        }
    }

    /// Brings a candidate behind a free unknown onto its target, if it misses by rounding only; returns whether it does.
    fn keep(&mut self, node: &mut Node<N>) -> bool {
        self.work.evaluations += 1;
        let miss = self.verifier.miss(&node.q);
        miss <= 0.1 * self.verifier.tolerance || miss < 1e-5 && self.newton(&mut node.q, FEW) <= self.verifier.tolerance
    }

    /// Takes one point of every self-motion.
    fn take_sheets(&mut self, sheets: &Sheets<N>, cells: &Cells) {
        let groups = sheets.joined(cells);
        for root in 0..sheets.len() {
            if groups[root] as usize != root {
                continue;
            }
            self.take_group(sheets, &groups, root);
        }
    }

    /// Takes one point of a self-motion: within the ranges, if one of those known is.
    fn take_group(&mut self, sheets: &Sheets<N>, groups: &[u8; super::sheets::NODES], root: usize) {
        let mut chosen: Option<([f64; N], Branch, FreeJoints)> = None;
        let mut moved = FreeJoints::NONE;
        for (node, _) in sheets.iter().zip(groups).filter(|(_, g)| **g as usize == root) {
            let inside = self.verifier.inside(&node.q);
            if let Some((q, ..)) = &chosen {
                let way = self.verifier.apart(q, &node.q);
                moved = (0..N).filter(|k| way[*k].abs() > 1e-6).fold(moved, FreeJoints::with);
                if self.verifier.inside(q) || !inside {
                    continue;
                }
            }
            let mut node = *node;
            if self.keep(&mut node) {
                self.work.evaluations += 1;
                let motions = self.verifier.motions(&node.q);
                if motions.len == 0 {
                    self.verifier.insert(node.q, node.branch);
                    continue;
                }
                let mut free = node.moved;
                for v in motions.list.iter().take(motions.len) {
                    let moves = (0..N).filter(|k| v[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with);
                    if motions.len == 1 && moves.intersects(node.path.joints) {
                        free = free.union(moves);
                    } else if free.is_empty() || node.path.free.count_ones() > 1 {
                        free = free.union(self.moved_along(&node.q, v, self.verifier.tolerance));
                    }
                }
                chosen = Some((node.q, node.branch, free));
            }
        }
        if let Some((q, branch, free)) = chosen
            && !self.is_known(&q)
        {
            self.verifier.push(Solution::new(q.map(T::of), branch).with_free(free.union(moved)));
        }
    }
}

impl Cut {
    /// Whether a node lies on a path through this cut's step.
    pub(super) fn is_on(&self, path: &Path) -> bool {
        path.before(self.step) == self.path.before(self.step)
    }
}
