//! An equation of the pool, exact: left side minus right side, in joint coordinates and symbols of a known pose.

use super::axes::Axes;
use super::known::Knowledge;
use super::prismatic;
use super::scalar::{Equation, FrameScalar, fold};
use crate::algebra::{Poly, Transform, Vector, dot};

/// An estimate of the number of terms of an equation's products before like terms are combined.
pub(super) fn weight(axes: &Axes, knowledge: &mut Knowledge, e: &Equation) -> usize {
    let (left, right) = fold(axes, knowledge, e);
    let size =
        |t: &Transform| -> usize { t.r.iter().flatten().chain(&t.p).map(|p| p.terms().len()).max().unwrap_or(0) };
    let sides = || (size(axes.between(left, e.a)), size(axes.between(e.b, right)));
    match e.scalar {
        FrameScalar::Distance => {
            let (before, after) = sides();
            (before * after).max(after.pow(2)).max(size(axes.between(e.a, e.b)).pow(2))
        }
        FrameScalar::Rotation(..) | FrameScalar::Position(_) | FrameScalar::Back(_) => {
            let (before, after) = sides();
            before * after
        }
        FrameScalar::Across(j) => prismatic::across_weight(axes, knowledge, e, usize::from(j)),
        FrameScalar::Bridge(i, j) => prismatic::bridge_weight(axes, knowledge, e, [i, j].map(usize::from)),
    }
}

/// Left minus right.
pub(super) fn exact(axes: &Axes, knowledge: &mut Knowledge, e: &Equation) -> Poly {
    let (left, right) = fold(axes, knowledge, e);
    let known = knowledge.pose(left, right);
    let sides = || (axes.between(left, e.a), axes.between(e.b, right), axes.between(e.a, e.b));
    let k = known.transform();
    // The other side is before^-1 K after^-1.
    match e.scalar {
        FrameScalar::Rotation(i, j) => {
            let (before, after, direct) = sides();
            let row: Vector = before.column(usize::from(i)); // row of the inverse
            let column: Vector = std::array::from_fn(|c| after.r[usize::from(j)][c].clone());
            &direct.r[usize::from(i)][usize::from(j)] - &dot(&row, &k.rotate(&column))
        }
        FrameScalar::Position(i) => {
            let (before, _, direct) = sides();
            let v = &axes.back(e.b, right).p;
            // R^T (w - p) = R^T w + (-R^T p), the latter without multiplying out what cancels.
            let w: Vector = plus(&k.rotate(v), &k.p);
            let other = &dot(&before.column(usize::from(i)), &w) + &axes.back(left, e.a).p[usize::from(i)];
            &direct.p[usize::from(i)] - &other
        }
        FrameScalar::Back(j) => {
            let (before, after, _) = sides();
            // The inverse: after K^-1 before, with K^-1 = (R^T, back).
            let kt = Transform {
                r: std::array::from_fn(|a| std::array::from_fn(|b| k.r[b][a].clone())),
                p: known.back.map(Poly::symbol),
            };
            let w = plus(&kt.rotate(&before.p), &kt.p);
            let other = &dot(&after.r[usize::from(j)], &w) + &after.p[usize::from(j)];
            &axes.back(e.a, e.b).p[usize::from(j)] - &other
        }
        FrameScalar::Distance => {
            let before = axes.between(left, e.a);
            // |R v + k - t|^2 with R orthogonal
            let v = &axes.back(e.b, right).p;
            let t = &before.p;
            let two = |p: Poly| p.scale(&2.into());
            let turned = k.rotate(v);
            let other: Poly = [
                axes.square(e.b, right).clone(),
                Poly::symbol(known.square),
                axes.square(left, e.a).clone(),
                two(dot(&minus(&k.p, t), &turned)),
                -&two(dot(&k.p, t)),
            ]
            .into_iter()
            .sum();
            axes.square(e.a, e.b) - &other
        }
        FrameScalar::Across(j) => prismatic::across_exact(axes, knowledge, e, usize::from(j)),
        FrameScalar::Bridge(i, j) => prismatic::bridge_exact(axes, knowledge, e, [i, j].map(usize::from)),
    }
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] + &b[i])
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}
