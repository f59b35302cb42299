//! The pool of candidate equations between pairs of frames, and the joints that each depends on.
//!
//! For frames a <= b of the arm, the part of the chain between them equals the target brought back over the two ends:
//! M(a, b) = M(0, a)^-1 W M(b, n)^-1. From both sides are read the nine direction cosines, the position p, the position seen from
//! the other end -R^T p, and p.p: sixteen scalar equations per pair of frames (Pieper 1968; Paul 1981; Raghavan and Roth 1990).
//! Those that no sliding length occurs in come from `planner/prismatic.rs`.
//!
//! On which joints an equation depends is measured (derivatives at random points, the space they span); what the plan then uses
//! is derived exactly.

use super::axes::Axes;
use super::prismatic;
use super::random::Random;
use super::scalar::{Equation, FrameScalar};
use super::subspace::Subspace;
use dh_kernels::pose::{self, Pose};

/// Equations that depend on the same joint combinations.
#[derive(Clone, Debug)]
pub struct Family {
    /// The combinations.
    pub span: Subspace,
    /// The equations.
    pub equations: Vec<Equation>,
}

const SCALARS: [FrameScalar; 16] = {
    use FrameScalar::{Back, Distance, Position, Rotation};
    [
        Rotation(0, 0),
        Rotation(0, 1),
        Rotation(0, 2),
        Rotation(1, 0),
        Rotation(1, 1),
        Rotation(1, 2),
        Rotation(2, 0),
        Rotation(2, 1),
        Rotation(2, 2),
        Position(0),
        Position(1),
        Position(2),
        Back(0),
        Back(1),
        Back(2),
        Distance,
    ]
};

/// The scalars of a pose in the order of `SCALARS`.
#[cfg(test)]
fn scalars(t: &Pose) -> [f64; 16] {
    let back = |j: usize| -(t[0][j] * t[0][3] + t[1][j] * t[1][3] + t[2][j] * t[2][3]);
    let d = t[0][3] * t[0][3] + t[1][3] * t[1][3] + t[2][3] * t[2][3];
    [
        t[0][0],
        t[0][1],
        t[0][2],
        t[1][0],
        t[1][1],
        t[1][2],
        t[2][0],
        t[2][1],
        t[2][2],
        t[0][3],
        t[1][3],
        t[2][3],
        back(0),
        back(1),
        back(2),
        d,
    ]
}

/// All equations, sorted into families.
pub fn families(axes: &Axes) -> Vec<Family> {
    let n = axes.count();
    let frames = axes.links.len() + 1;
    let pairs: Vec<(usize, usize)> = (0..frames).flat_map(|a| (a + 1..frames).map(move |b| (a, b))).collect();
    let mut spans: Vec<[Subspace; 16]> = vec![Default::default(); pairs.len()];
    let mut random = Random::new(7);
    for _ in 0..3 {
        // The target is one thing, the joints another: equations hold or not, here only their slopes matter.
        let x: Vec<f64> = (0..n).map(|_| 2.3 * random.next()).collect();
        let y: Vec<f64> = (0..n).map(|_| 2.3 * random.next()).collect();
        let target = *axes.frames_number(&y).last().unwrap_or(&pose::IDENTITY);
        let (f, rate) = (axes.frames_number(&x), rates(axes, &x));
        for (pair, (a, b)) in pairs.iter().enumerate() {
            let mut slopes = vec![[0.0; 16]; n];
            let inverse_a = pose::inverse(&f[*a]);
            // Left: M(a, b). Right: M(0, a)^-1 W M(b, n)^-1 with M(b, n) = f_b^-1 f_n.
            let left = pose::compose(&inverse_a, &f[*b]);
            let tail = pose::compose(&pose::inverse(&f[f.len() - 1]), &f[*b]);
            let right = pose::compose(&inverse_a, &pose::compose(&target, &tail));
            for (k, slope) in slopes.iter_mut().enumerate() {
                let Some(link) = axes.links.iter().position(|h| h.joint == Some(k)) else { continue };
                // A joint's motion is a screw about its axis in frame 0: d(f) = S f for frames behind it.
                let screw = &rate[k];
                let change = if link >= *a && link < *b {
                    // Left side moves: d(M) = f_a^-1 S f_b.
                    let s = conjugate(screw, &inverse_a);
                    difference(&left, &apply(&s, &left), 1.0)
                } else if link < *a {
                    // d(f_a^-1) = -f_a^-1 S: d(right) = -(f_a^-1 S f_a) right.
                    let s = conjugate(screw, &inverse_a);
                    difference(&right, &apply(&s, &right), 1.0)
                } else {
                    // M(b, n)^-1 = f_n^-1 f_b with f_n behind the joint: d(f_n^-1) = -f_n^-1 S.
                    let s = conjugate(screw, &pose::inverse(&f[*b]));
                    // right * f_b^-1 ... : d(right) = -right (f_b^-1 S f_b)
                    difference(&right, &apply_right(&right, &s), 1.0)
                };
                *slope = change;
            }
            for (e, span) in spans[pair].iter_mut().enumerate() {
                let gradient: Vec<f64> = slopes.iter().map(|s| s[e]).collect();
                span.add(&gradient);
            }
        }
    }
    collect(&pairs, spans, prismatic::equations(axes))
}

/// Joint screws in frame 0: (direction, moment; or zero and direction for a slide).
pub(super) fn rates(axes: &Axes, x: &[f64]) -> Vec<[[f64; 4]; 3]> {
    let f = axes.frames_number(x);
    (0..axes.count())
        .map(|k| {
            let link = axes.links.iter().position(|h| h.joint == Some(k)).unwrap_or(0);
            let t = &f[link + 1];
            let z = [t[0][2], t[1][2], t[2][2]];
            let p = [t[0][3], t[1][3], t[2][3]];
            if axes.is_revolute(k) {
                let m = [p[1] * z[2] - p[2] * z[1], p[2] * z[0] - p[0] * z[2], p[0] * z[1] - p[1] * z[0]];
                [[0.0, -z[2], z[1], m[0]], [z[2], 0.0, -z[0], m[1]], [-z[1], z[0], 0.0, m[2]]]
            } else {
                [[0.0, 0.0, 0.0, z[0]], [0.0, 0.0, 0.0, z[1]], [0.0, 0.0, 0.0, z[2]]]
            }
        })
        .collect()
}

/// t S t^-1 for a twist S.
fn conjugate(s: &Pose, t: &Pose) -> Pose {
    let inverse = pose::inverse(t);
    apply_right_twist(t, s, &inverse)
}

fn apply_right_twist(t: &Pose, s: &Pose, inverse: &Pose) -> Pose {
    // (t S) as rows: rotation part R S_r, translation R s_p; then times t^-1, where the last row of S is zero.
    let ts = apply(&rotation_only(t), s);
    let mut out = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..4 {
            out[i][j] = (0..3).map(|k| ts[i][k] * inverse[k][j]).sum();
        }
        out[i][3] += ts[i][3];
    }
    out
}

fn rotation_only(t: &Pose) -> Pose {
    let mut r = *t;
    for row in &mut r {
        row[3] = 0.0;
    }
    r
}

/// S t for a twist or pure rotation matrix S (last row zero): translation S_r p + s_p.
fn apply(s: &Pose, t: &Pose) -> Pose {
    let mut out = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..4 {
            out[i][j] = (0..3).map(|k| s[i][k] * t[k][j]).sum();
        }
        out[i][3] += s[i][3];
    }
    out
}

/// t S for a twist S.
fn apply_right(t: &Pose, s: &Pose) -> Pose {
    let mut out = [[0.0; 4]; 3];
    for i in 0..3 {
        for j in 0..4 {
            out[i][j] = (0..3).map(|k| t[i][k] * s[k][j]).sum();
        }
    }
    out
}

/// Slopes of the sixteen scalars of `t` when it changes at the rate `d`.
fn difference(t: &Pose, d: &Pose, sign: f64) -> [f64; 16] {
    let back = |j: usize| -(0..3).map(|i| d[i][j] * t[i][3] + t[i][j] * d[i][3]).sum::<f64>();
    let distance = 2.0 * (0..3).map(|i| t[i][3] * d[i][3]).sum::<f64>();
    [
        d[0][0],
        d[0][1],
        d[0][2],
        d[1][0],
        d[1][1],
        d[1][2],
        d[2][0],
        d[2][1],
        d[2][2],
        d[0][3],
        d[1][3],
        d[2][3],
        back(0),
        back(1),
        back(2),
        distance,
    ]
    .map(|x| sign * x)
}

fn collect(pairs: &[(usize, usize)], spans: Vec<[Subspace; 16]>, more: Vec<(Equation, Subspace)>) -> Vec<Family> {
    let plain = pairs.iter().zip(spans).flat_map(|(&(a, b), list)| {
        SCALARS.into_iter().zip(list).map(move |(scalar, span)| (Equation { a, b, scalar }, span))
    });
    let mut families: Vec<(Vec<i32>, Family)> = Vec::new();
    for (equation, span) in plain.chain(more).filter(|(_, span)| span.dimension() > 0) {
        let key = span.key();
        match families.iter_mut().find(|f| f.0 == key) {
            Some(f) => f.1.equations.push(equation),
            None => families.push((key, Family { span, equations: vec![equation] })),
        }
    }
    families.into_iter().map(|f| f.1).collect()
}

/// The value of an equation, left minus right, at a joint vector for a target: zero where both agree.
#[cfg(test)]
pub(super) fn residual(axes: &Axes, e: &Equation, x: &[f64], target: &Pose) -> f64 {
    let f = axes.frames_number(x);
    if let Some(x) = prismatic::number(axes, e, &f, target) {
        return x;
    }
    let inverse_a = pose::inverse(&f[e.a]);
    let left = pose::compose(&inverse_a, &f[e.b]);
    let tail = pose::compose(&pose::inverse(&f[f.len() - 1]), &f[e.b]);
    let right = pose::compose(&inverse_a, &pose::compose(target, &tail));
    let i = SCALARS.iter().position(|s| *s == e.scalar).unwrap_or(0);
    scalars(&left)[i] - scalars(&right)[i]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Convention;
    use crate::chain::tests::revolute_chain;

    #[test]
    fn every_equation_holds_at_a_solution_and_its_slopes_are_measured_right() {
        let rows = [(-90, "0.1", "0.2", 0), (60, "0.3", "0", 30), (90, "0", "0.1", -90), (180, "0.2", "0", 0)];
        let axes = Axes::new(&revolute_chain(Convention::Standard, &rows));
        let mut random = Random::new(5);
        let x: Vec<f64> = (0..4).map(|_| 2.0 * random.next()).collect();
        let target = *axes.frames_number(&x).last().unwrap();
        let all = families(&axes);
        assert!(all.len() > 5);
        for family in &all {
            for e in &family.equations {
                assert!(residual(&axes, e, &x, &target).abs() < 1e-12, "{e:?}");
                // A step in a direction outside the family's span changes nothing.
                for k in 0..4 {
                    let touches = family.span.rows().iter().any(|r| r[k].abs() > 1e-9);
                    let mut y = x.clone();
                    y[k] += 0.1;
                    if !touches {
                        assert!(residual(&axes, e, &y, &target).abs() < 1e-12, "{e:?} moves with joint {k}");
                    }
                }
            }
        }
    }
}
