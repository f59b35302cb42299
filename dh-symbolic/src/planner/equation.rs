//! An equation of the pool, exact: left side minus right side, in joint coordinates and symbols of a known pose.

use super::axes::Axes;
use super::known::Knowledge;
use super::pool::{Equation, Scalar};
use crate::algebra::{Poly, Transform, Vector, dot};

/// The frames up to which, and from which on, the target is brought back over known joints for this equation.
pub(super) fn fold(axes: &Axes, knowledge: &Knowledge, e: &Equation) -> (usize, usize) {
    (knowledge.prefix(axes).min(e.a), knowledge.suffix(axes).max(e.b))
}

/// About how many terms the products of an equation have before any are put together.
pub(super) fn weight(axes: &Axes, knowledge: &Knowledge, e: &Equation) -> usize {
    let (left, right) = fold(axes, knowledge, e);
    let size =
        |t: &Transform| -> usize { t.r.iter().flatten().chain(&t.p).map(|p| p.terms().len()).max().unwrap_or(0) };
    let before = size(axes.between(left, e.a));
    let after = axes.between(e.b, right);
    let direct = axes.between(e.a, e.b);
    match e.scalar {
        Scalar::Distance => (before * size(after)).max(size(after).pow(2)).max(size(direct).pow(2)),
        _ => before * size(after),
    }
}

/// Left minus right.
pub(super) fn exact(axes: &Axes, knowledge: &mut Knowledge, e: &Equation) -> Poly {
    let (left, right) = fold(axes, knowledge, e);
    let known = knowledge.pose(left, right);
    let direct = axes.between(e.a, e.b);
    let before = axes.between(left, e.a);
    let after = axes.between(e.b, right);
    let k = known.transform();
    // The other side: before^-1 K after^-1.
    let other = |e: &Equation| -> Poly {
        match e.scalar {
            Scalar::Rotation(i, j) => {
                let row: Vector = before.column(usize::from(i)); // row of the inverse
                let column: Vector = std::array::from_fn(|c| after.r[usize::from(j)][c].clone());
                dot(&row, &k.rotate(&column))
            }
            Scalar::Position(i) => {
                let v = after.inverse().p;
                let w: Vector = plus(&k.rotate(&v), &minus(&k.p, &before.p));
                dot(&before.column(usize::from(i)), &w)
            }
            Scalar::Back(j) => {
                // The inverse: after K^-1 before, with K^-1 = (R^T, back).
                let kt = Transform {
                    r: std::array::from_fn(|a| std::array::from_fn(|b| k.r[b][a].clone())),
                    p: known.back.map(Poly::symbol),
                };
                let w = plus(&kt.rotate(&before.p), &kt.p);
                &dot(&after.r[usize::from(j)], &w) + &after.p[usize::from(j)]
            }
            Scalar::Distance => {
                // |R v + k - t|^2 with R orthogonal
                let v = after.inverse().p;
                let t = &before.p;
                let two = |p: Poly| p.scale(&2.into());
                let turned = k.rotate(&v);
                [
                    dot(&v, &v),
                    Poly::symbol(known.square),
                    dot(t, t),
                    two(dot(&minus(&k.p, t), &turned)),
                    -&two(dot(&k.p, t)),
                ]
                .into_iter()
                .sum()
            }
        }
    };
    let this = match e.scalar {
        Scalar::Rotation(i, j) => direct.r[usize::from(i)][usize::from(j)].clone(),
        Scalar::Position(i) => direct.p[usize::from(i)].clone(),
        Scalar::Back(j) => direct.inverse().p[usize::from(j)].clone(),
        Scalar::Distance => dot(&direct.p, &direct.p),
    };
    &this - &other(e)
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] + &b[i])
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] - &b[i])
}
