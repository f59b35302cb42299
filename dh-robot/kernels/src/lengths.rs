//! Equations with a prismatic unknown: alone, or together with an angle.

use super::elementary::sqrt;
use super::list::List;
use super::newton_pair::polish_pair;
use super::one_equation::solve_sincos;
use super::roots::{Outcome, Roots};
use super::tolerance::{ACCEPT, BLUR, BOUNDARY, DOUBLE, GRAZING, SAME, ZERO};
use super::trig_poly::TrigPoly;

/// A length and an angle `[cos, sin]`.
pub type LengthAngle = (f64, [f64; 2]);

/// All real `x` with `a x^2 + b x + c = 0`, without loss of digits.
///
/// `q = -(b + sign(b) sqrt(b^2 - 4 a c)) / 2`, then `x = q / a` and `x = c / q` (Press et al., *Numerical Recipes*, section 5.6).
///
/// - `|a| <= tol`: the linear equation; `|a|` and `|b|` at most `tol`: [`Outcome::Free`] if `|c|` is too, else no solution.
///   A linear equation no larger than [`BLUR`] whose root is out of any reach: [`Outcome::Free`].
///   `tol` is absolute: scale the unknown so that it is of order one.
/// - A discriminant within [`BOUNDARY`] (relative) below zero counts as zero: one root, [`Outcome::Touching`].
#[inline]
pub fn solve_quadratic(a: f64, b: f64, c: f64, tol: f64) -> Roots<f64, 2> {
    let mut roots = List::new();
    if a.abs() <= tol {
        if b.abs() <= tol {
            let needed = c.abs();
            return Roots::none(if needed <= tol {
                Outcome::Free
            } else {
                Outcome::OutOfReach { needed, available: 0.0 }
            });
        }
        if b.abs() <= BLUR && c.abs() <= BLUR && c.abs() > 4.0 * b.abs() {
            return Roots::none(Outcome::Free);
        }
        roots.push(-c / b);
        return Roots { roots, outcome: Outcome::Regular };
    }
    let (bb, ac) = (b * b, 4.0 * a * c);
    let (discriminant, size) = (bb - ac, bb.max(ac.abs()));
    if !(discriminant >= -BOUNDARY * size && size < f64::INFINITY && a.abs() < f64::INFINITY) {
        return Roots::none(Outcome::NoRealRoot);
    }
    // Roots that differ by less than 1e-7 are one: the square root of rounding.
    if discriminant <= DOUBLE * size.max(a * a) {
        roots.push(-0.5 * b / a);
        return Roots { roots, outcome: Outcome::Touching };
    }
    let q = -0.5 * (b + sqrt(discriminant).copysign(b));
    roots.push(q / a);
    roots.push(c / q);
    let grazing = discriminant <= GRAZING * size.max(a * a);
    Roots { roots, outcome: if grazing { Outcome::Touching } else { Outcome::Regular } }
}

/// All `(d, v)` with `sum_ij e[3 i + j] D_i V_j = 0` for both equations, `D = (1, d, d^2)`, `V = (1, cos v, sin v)`.
///
/// The resultant of two quadratics in `d` is a trigonometric polynomial of degree 4 in `v`: up to eight solutions.
/// Lengths should be of order one (divide by the length scale).
///
/// - Where `d` is linear in both equations, the degree is 2. Where an equation has no `d` at all, it is solved first.
/// - Each solution is polished on both equations and dropped if it misses them by more than [`ACCEPT`].
/// - [`Outcome::Free`]: the equations leave an unknown free, at some value of the other one or altogether: an equation whose
///   coefficients are all at most `tol` (absolute), or a common curve. It then takes its value from `choice`, and the other one is
///   solved for. Isolated solutions are returned as well.
pub fn solve_length_squared_and_angle_choosing(
    e1: &[f64; 9],
    e2: &[f64; 9],
    choice: LengthAngle,
    tol: f64,
) -> Roots<LengthAngle, 8> {
    if !e1.iter().chain(e2).all(|x| x.is_finite()) {
        return Roots::none(Outcome::NoRealRoot);
    }
    let size = |e: &[f64; 9]| e.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let (s1, s2) = (size(e1), size(e2));
    let scaled = |e: &[f64; 9], s: f64| e.map(|x| x / s);
    match (s1 <= tol, s2 <= tol) {
        (false, false) => {}
        (false, true) => return choose(&scaled(e1, s1), choice),
        (true, false) => return choose(&scaled(e2, s2), choice),
        (true, true) => return choose(&[0.0; 9], choice),
    }
    let (e1, e2) = (scaled(e1, s1), scaled(e2, s2));
    let absent = |e: &[f64; 9], from: usize| e[from..].iter().all(|x| x.abs() <= ZERO);
    let (p1, p2) = (in_angle(&e1), in_angle(&e2));
    let minor =
        |i: usize, j: usize| -> TrigPoly<2> { p1[i].times::<1, 2>(&p2[j]).plus(&p2[i].times::<1, 2>(&p1[j]), -1.0) };
    let vs = if absent(&e1, 3) {
        p1[0].roots::<8>(ZERO)
    } else if absent(&e2, 3) {
        p2[0].roots::<8>(ZERO)
    } else if absent(&e1, 6) && absent(&e2, 6) {
        minor(0, 1).roots::<8>(ZERO)
    } else {
        let eliminant: TrigPoly<4> = minor(0, 2).times(&minor(0, 2)).plus(&minor(0, 1).times(&minor(1, 2)), -1.0);
        eliminant.roots::<8>(ZERO)
    };
    let mut found = Roots { roots: List::new(), outcome: vs.outcome };
    for &v in &vs {
        let (q1, q2) = (at_angle(&e1, v), at_angle(&e2, v));
        // The equation that says more about d gives the candidates, the other one decides.
        let weight = |q: &[f64; 3]| q[1].abs().max(q[2].abs());
        let q = if weight(&q1) >= weight(&q2) { q1 } else { q2 };
        let ds = solve_quadratic(q[2], q[1], q[0], ZERO);
        if ds.is_free() {
            found.outcome = Outcome::Free;
            found.roots.push((choice.0, v));
        }
        // Both equations together, without d^2: exact where the single one has a double root.
        let (bottom, top) = (q1[1] * q2[2] - q2[1] * q1[2], q1[0] * q2[2] - q2[0] * q1[2]);
        let common = if bottom.abs() > ZERO { Some(-top / bottom) } else { None };
        for &d in ds.iter().chain(&common) {
            add(&mut found.roots, &e1, &e2, d, v);
        }
    }
    if found.roots.is_empty() && found.outcome == Outcome::Free {
        // The angle drops out: the lengths at a chosen one.
        let weight = |e: &[f64; 9]| e[3..].iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let (strong, weak) = if weight(&e1) >= weight(&e2) { (&e1, &e2) } else { (&e2, &e1) };
        let mut chosen = choose(strong, choice);
        let candidates = core::mem::take(&mut chosen.roots);
        for root in candidates.iter() {
            let [a, b, c] = at_angle(weak, root.1);
            if (a + root.0 * (b + root.0 * c)).abs() <= ACCEPT * (1.0 + root.0 * root.0) {
                chosen.roots.push(*root);
            }
        }
        return chosen;
    }
    if found.roots.is_empty() {
        found.outcome = Outcome::NoRealRoot;
    }
    found
}

/// Solutions of one equation: the angle as chosen and the lengths to it, or the length as chosen and the angles to it.
#[cold]
fn choose(e: &[f64; 9], choice: LengthAngle) -> Roots<LengthAngle, 8> {
    let mut found = Roots::none(Outcome::Free);
    let [a, b, c] = at_angle(e, choice.1);
    for &d in &solve_quadratic(c, b, a, ZERO).or_if_free(choice.0) {
        found.roots.push((d, choice.1));
    }
    if found.roots.is_empty() {
        let d = choice.0;
        let [a, b, c] = [0, 1, 2].map(|i| e[i] + d * (e[i + 3] + d * e[i + 6]));
        for &v in &solve_sincos(b, c, -a, ZERO).or_if_free(choice.1) {
            found.roots.push((d, v));
        }
    }
    found
}

/// The coefficients of `1`, `d`, `d^2` as polynomials in the angle.
fn in_angle(e: &[f64; 9]) -> [TrigPoly<1>; 3] {
    [0, 3, 6].map(|i| TrigPoly::linear(e[i], e[i + 1], e[i + 2]))
}

/// The same at one angle.
fn at_angle(e: &[f64; 9], [c, s]: [f64; 2]) -> [f64; 3] {
    [0, 3, 6].map(|i| e[i] + e[i + 1] * c + e[i + 2] * s)
}

/// Polishes a candidate and keeps it if it is a solution, and a new one.
fn add(roots: &mut List<LengthAngle, 8>, e1: &[f64; 9], e2: &[f64; 9], mut d: f64, mut v: [f64; 2]) {
    let residual = polish_pair(&mut d, &mut v, 1e-15, |d, v| {
        [e1, e2].map(|e| {
            let [a, b, c] = at_angle(e, v);
            let [da, db, dc] = [0, 3, 6].map(|i| e[i + 2] * v[0] - e[i + 1] * v[1]);
            [a + d * (b + d * c), b + 2.0 * d * c, da + d * (db + d * dc)]
        })
    });
    let scale = 1.0 + d * d;
    let new = |r: &LengthAngle| (r.0 - d).abs() + (r.1[0] - v[0]).abs() + (r.1[1] - v[1]).abs() > SAME * scale;
    if residual <= ACCEPT * scale && roots.iter().all(new) {
        roots.push((d, v));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Rng;

    #[test]
    fn quadratics_keep_their_digits() {
        let found = solve_quadratic(1.0, -1e8, 1.0, 1e-12);
        assert!(found.iter().any(|x| (x - 1e-8).abs() < 1e-23) && found.len() == 2);
        assert_eq!(solve_quadratic(1.0, 0.0, -4.0, 1e-12).len(), 2);
        assert_eq!(solve_quadratic(0.0, 2.0, -4.0, 1e-12).as_ref(), &[2.0]);
        let touching = solve_quadratic(1.0, -2.0, 1.0 + 1e-12, 1e-12);
        assert_eq!((touching.as_ref(), touching.outcome), (&[1.0][..], Outcome::Touching));
        assert_eq!(solve_quadratic(1.0, 0.0, 1.0, 1e-12).outcome, Outcome::NoRealRoot);
        assert!(solve_quadratic(0.0, 0.0, 0.0, 1e-12).is_free());
        assert!(matches!(solve_quadratic(0.0, 0.0, 1.0, 1e-12).outcome, Outcome::OutOfReach { .. }));
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(
                solve_quadratic(1.0, bad, 0.0, 1e-12).is_empty() && solve_quadratic(1.0, 0.0, bad, 1e-12).is_empty()
            );
            assert!(solve_quadratic(bad, 0.0, -1.0, 1e-12).is_empty());
        }
        // x^2 = 0, the commonest double root of all.
        assert_eq!(solve_quadratic(1.0, 0.0, 0.0, 1e-12).as_ref(), &[0.0]);
    }

    /// With zero for what is free.
    fn solve(e1: &[f64; 9], e2: &[f64; 9]) -> Roots<LengthAngle, 8> {
        solve_length_squared_and_angle_choosing(e1, e2, (0.0, [1.0, 0.0]), 1e-12)
    }

    fn through<const K: usize>(rng: &mut Rng, degree: usize, d: f64, v: [f64; 2]) -> [f64; K] {
        let mut e = [(); K].map(|()| rng.symmetric());
        let mut sum = 0.0;
        for i in 0..=degree {
            sum += d.powi(i as i32) * (e[3 * i] + e[3 * i + 1] * v[0] + e[3 * i + 2] * v[1]);
        }
        e[0] -= sum;
        e
    }

    fn contains(found: &Roots<LengthAngle, 8>, d: f64, v: [f64; 2]) -> bool {
        found.iter().any(|r| (r.0 - d).abs() + (r.1[0] - v[0]).abs() + (r.1[1] - v[1]).abs() < 1e-6)
    }

    #[test]
    fn lengths_with_angles_come_back() {
        let mut rng = Rng::new(50);
        for i in 0..400 {
            let t = if i < 16 { f64::from(i) * core::f64::consts::PI / 8.0 } else { rng.angle() };
            let (d, v) = (if i % 5 == 0 { 0.0 } else { rng.symmetric() }, [t.cos(), t.sin()]);
            // Both linear in the length.
            let (e1, e2): ([f64; 6], [f64; 6]) = (through(&mut rng, 1, d, v), through(&mut rng, 1, d, v));
            let widen = |e: [f64; 6]| [e[0], e[1], e[2], e[3], e[4], e[5], 0.0, 0.0, 0.0];
            assert!(contains(&solve(&widen(e1), &widen(e2)), d, v));
            let (e1, e2): ([f64; 9], [f64; 9]) = (through(&mut rng, 2, d, v), through(&mut rng, 2, d, v));
            let found = solve(&e1, &e2);
            assert!(contains(&found, d, v) && found.len().is_multiple_of(2));
            // One quadratic and one linear equation; and one without the length.
            let mut flat = e1;
            flat[6..].fill(0.0);
            flat[0] -= at_angle(&flat, v)[0] + d * at_angle(&flat, v)[1];
            assert!(contains(&solve(&flat, &e2), d, v));
            flat[3..].fill(0.0);
            flat[0] -= at_angle(&flat, v)[0];
            assert!(contains(&solve(&flat, &e2), d, v));
            assert!(contains(&solve(&e2, &flat), d, v));
        }
    }

    #[test]
    fn common_curves_are_free() {
        let e = [0.1, 0.2, 0.3, -0.4, 0.5, 0.6, 0.7, -0.8, 0.9];
        assert!(solve(&e, &e.map(|x| 2.0 * x)).is_free());
        assert!(solve(&e, &[0.0; 9]).is_free());
        assert!(solve(&e, &[f64::NAN; 9]).is_empty());
    }
}
