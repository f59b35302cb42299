//! Two equations in two angles, each linear in the cosine and sine of both: what leads to Pieper's quartic.

use super::elementary::sqrt;
use super::least_squares::solve_many;
use super::list::List;
use super::newton_pair::{Unknown, polish_pair};
use super::one_equation::solve_sincos;
use super::roots::{Angles, Outcome, Roots};
use super::tolerance::{ACCEPT, SAME, TOUCH, ZERO};
use super::trig_poly::TrigPoly;
use super::two_equations::solve_pair;

/// Two angles, `u` and `v`, each as `[cos, sin]`.
pub type AnglePair = [[f64; 2]; 2];

/// Below this sine of the angle between the two equations in `u`, the ratio of determinants isn't trusted and a single equation is
/// used instead; polishing then removes the rest of the error.
const NEARLY_DEPENDENT: f64 = 1e-3;
/// Where the eliminant only touches zero, solutions are looked for this far (radians) to both sides too: the fourth root of rounding.
const NEIGHBOUR: f64 = 4e-3;

/// All pairs of angles that solve two equations
///
/// ```text
/// sum_ij e[3 i + j] U_i V_j = 0,    U = (1, cos u, sin u),  V = (1, cos v, sin v).
/// ```
///
/// For a given `v` they are two linear equations in `(cos u, sin u)`; Cramer's rule gives `cos u = X/W` and `sin u = Y/W` with quadratic
/// trigonometric polynomials in `v`, and `X^2 + Y^2 = W^2` is one of degree 4: up to eight solutions. (Pieper, *The
/// kinematics of manipulators under computer control*, 1968, has the half-angle form of a special case of this.) The degree may well be
/// lower; nothing depends on its leading coefficients.
///
/// - An equation without `u` (or without `v`) is solved first, and the other one after it.
/// - Where `W` vanishes at a root, the stronger of the two equations gives two values of `u`.
/// - Each solution is polished by Newton on both equations; what doesn't solve them within [`ACCEPT`] is dropped.
/// - [`Outcome::Free`]: the equations leave an angle free, at some value of the other one or altogether: an equation with all
///   coefficients at most `tol` (absolute), or two that have a curve of solutions in common. A free angle takes its value from
///   `choice`, and the other one is solved for. Isolated solutions are returned as well.
pub fn solve_bilinear_choosing(e1: &[f64; 9], e2: &[f64; 9], choice: AnglePair, tol: f64) -> Roots<AnglePair, 8> {
    if !(e1.iter().chain(e2).all(|x| x.is_finite())) {
        return Roots::none(Outcome::NoRealRoot);
    }
    let (e1, e2) = match (scaled(e1, tol), scaled(e2, tol)) {
        (Some(e1), Some(e2)) => (e1, e2),
        (Some(e), None) | (None, Some(e)) => return choose(&e, &e, choice),
        (None, None) => return free(choice),
    };
    let back = [choice[1], choice[0]];
    for (first, second) in [(&e1, &e2), (&e2, &e1)] {
        if lacks_first(first) {
            return second_angle_first(first, second, choice[0]);
        }
        if lacks_first(&transposed(first)) {
            return swapped(second_angle_first(&transposed(first), &transposed(second), back[0]));
        }
    }
    let found = by_elimination(&e1, &e2, choice[0]);
    if !(found.is_free() && found.roots.is_empty()) {
        return found;
    }
    // Eliminating the other angle may still work, e.g. if both equations have a factor in u alone.
    let found = swapped(by_elimination(&transposed(&e1), &transposed(&e2), back[0]));
    if !(found.is_free() && found.roots.is_empty()) {
        return found;
    }
    choose(&e1, &e2, choice)
}

fn free(root: AnglePair) -> Roots<AnglePair, 8> {
    let mut found = Roots::none(Outcome::Free);
    found.roots.push(root);
    found
}

/// Solutions of two dependent equations: one angle as chosen, the other one to it.
#[cold]
fn choose(e1: &[f64; 9], e2: &[f64; 9], choice: AnglePair) -> Roots<AnglePair, 8> {
    let mut found = Roots::none(Outcome::Free);
    for swap in [false, true] {
        let (e, u) = if swap { ([*e1, *e2], choice[1]) } else { ([transposed(e1), transposed(e2)], choice[0]) };
        let [[a1, b1, c1], [a2, b2, c2]] = e.map(|e| at_second(&e, u));
        let vs = solve_pair(b1, c1, -a1, b2, c2, -a2, ZERO);
        for &v in &vs.or_if_free(choice[usize::from(!swap)]) {
            found.roots.push(if swap { [v, u] } else { [u, v] });
        }
        if !found.roots.is_empty() {
            break;
        }
    }
    found
}

/// The equation over its largest coefficient; `None` if that is nothing.
fn scaled(e: &[f64; 9], tol: f64) -> Option<[f64; 9]> {
    let size = e.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    if size <= tol { None } else { Some(e.map(|x| x / size)) }
}

/// The equation with the roles of the two angles exchanged.
fn transposed(e: &[f64; 9]) -> [f64; 9] {
    [e[0], e[3], e[6], e[1], e[4], e[7], e[2], e[5], e[8]]
}

/// The solutions with the roles of the two angles exchanged.
fn swapped(mut found: Roots<AnglePair, 8>) -> Roots<AnglePair, 8> {
    for root in found.roots.as_mut_slice() {
        root.swap(0, 1);
    }
    found
}

/// Whether `u` is absent from a scaled equation.
fn lacks_first(e: &[f64; 9]) -> bool {
    e[3..].iter().all(|x| x.abs() <= ZERO)
}

/// The coefficients of `1`, `cos u`, `sin u`, as polynomials in `v`.
fn in_second(e: &[f64; 9]) -> [TrigPoly<1>; 3] {
    [0, 3, 6].map(|i| TrigPoly::linear(e[i], e[i + 1], e[i + 2]))
}

/// The same at one `v`.
fn at_second(e: &[f64; 9], [c, s]: [f64; 2]) -> [f64; 3] {
    [0, 3, 6].map(|i| e[i] + e[i + 1] * c + e[i + 2] * s)
}

/// The angles `u` that solve one equation at a given `v`.
fn first_angle(e: &[f64; 9], v: [f64; 2]) -> Angles<2> {
    let [a, b, c] = at_second(e, v);
    solve_sincos(b, c, -a, ZERO)
}

/// `first` has no `u`; where `second` has none either, it is `choice`.
fn second_angle_first(first: &[f64; 9], second: &[f64; 9], choice: [f64; 2]) -> Roots<AnglePair, 8> {
    let vs = solve_sincos(first[1], first[2], -first[0], ZERO);
    let mut found = Roots { roots: List::new(), outcome: vs.outcome };
    let mut free = vs.is_free();
    for &v in &vs {
        let us = first_angle(second, v);
        free |= us.is_free();
        if us.outcome != Outcome::Regular {
            found.outcome = us.outcome;
        }
        for &u in &us.or_if_free(choice) {
            found.roots.push([u, v]);
        }
    }
    if free {
        found.outcome = Outcome::Free;
    } else if !found.roots.is_empty() && matches!(found.outcome, Outcome::OutOfReach { .. }) {
        found.outcome = Outcome::Regular;
    }
    found
}

/// The value of `v` near a touching root at which both equations hold whatever `u` is; `None` if there is none.
#[cold]
fn free_at(e1: &[f64; 9], e2: &[f64; 9], near: [f64; 2]) -> Option<[f64; 2]> {
    let rows: [[f64; 3]; 6] = core::array::from_fn(|k| {
        let (e, i) = if k < 3 { (e1, 3 * k) } else { (e2, 3 * (k - 3)) };
        [e[i + 1], e[i + 2], -e[i]]
    });
    let holds = |v: &[f64; 2]| [e1, e2].iter().all(|e| at_second(e, *v).iter().all(|x| x.abs() <= ACCEPT));
    let close = |v: &[f64; 2]| (v[0] - near[0]).abs() + (v[1] - near[1]).abs() <= NEIGHBOUR;
    solve_many(&rows, ZERO).iter().copied().find(|v| close(v) && holds(v))
}

/// The general case.
fn by_elimination(e1: &[f64; 9], e2: &[f64; 9], choice: [f64; 2]) -> Roots<AnglePair, 8> {
    let ([a1, b1, c1], [a2, b2, c2]) = (in_second(e1), in_second(e2));
    let minor = |p: &TrigPoly<1>, q: &TrigPoly<1>, r: &TrigPoly<1>, s: &TrigPoly<1>| -> TrigPoly<2> {
        p.times::<1, 2>(q).plus(&r.times::<1, 2>(s), -1.0)
    };
    let (x, y, w) = (minor(&c1, &a2, &c2, &a1), minor(&a1, &b2, &a2, &b1), minor(&b1, &c2, &b2, &c1));
    let eliminant: TrigPoly<4> = x.times(&x).plus(&y.times(&y), 1.0).plus(&w.times(&w), -1.0);
    let vs: Roots<_, 8> = eliminant.marked_roots(ZERO, TOUCH);
    let mut found = Roots { roots: List::new(), outcome: vs.outcome };
    for &(v, touches) in &vs {
        if touches && let Some(v) = free_at(e1, e2, v) {
            found.outcome = Outcome::Free;
            found.roots.push([choice, v]);
            continue;
        }
        let mut starts = List::<[f64; 2], 3>::new();
        starts.push(v);
        if touches {
            // Rounding may hide two double roots behind one.
            starts.push(v.moved(NEIGHBOUR));
            starts.push(v.moved(-NEIGHBOUR));
        }
        for &v in &starts {
            let ([a1, b1, c1], [a2, b2, c2]) = (at_second(e1, v), at_second(e2, v));
            let w = b1 * c2 - b2 * c1;
            let (n1, n2) = (b1 * b1 + c1 * c1, b2 * b2 + c2 * c2);
            if w * w > NEARLY_DEPENDENT * NEARLY_DEPENDENT * n1.max(n2) {
                let inverse = 1.0 / w;
                let (c, s) = ((c1 * a2 - c2 * a1) * inverse, (a1 * b2 - a2 * b1) * inverse);
                add(&mut found.roots, e1, e2, [c, s], v);
                continue;
            }
            let us = first_angle(if n1 >= n2 { e1 } else { e2 }, v);
            for &u in &us {
                add(&mut found.roots, e1, e2, u, v);
            }
        }
    }
    if found.roots.is_empty() && found.outcome != Outcome::Free {
        found.outcome = Outcome::NoRealRoot;
    }
    found
}

/// Polishes a candidate and keeps it if it is a solution, and a new one.
fn add(roots: &mut List<AnglePair, 8>, e1: &[f64; 9], e2: &[f64; 9], u: [f64; 2], mut v: [f64; 2]) {
    let norm = sqrt(u[0] * u[0] + u[1] * u[1]);
    if !(norm > 0.0 && norm < f64::INFINITY) {
        return;
    }
    let mut u = u.map(|x| x / norm);
    let residual = polish_pair(&mut u, &mut v, 1e-15, |u, v| [e1, e2].map(|e| value_and_slopes(e, u, v)));
    let distance = |a: &AnglePair| {
        let d = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs() + (p[1] - q[1]).abs();
        d(a[0], u) + d(a[1], v)
    };
    if residual <= ACCEPT && roots.iter().all(|r| distance(r) > SAME) {
        roots.push([u, v]);
    }
}

/// The value of an equation and its derivatives by `u` and `v`.
#[inline]
fn value_and_slopes(e: &[f64; 9], u: [f64; 2], v: [f64; 2]) -> [f64; 3] {
    let [a, b, c] = at_second(e, v);
    let [da, db, dc] = [0, 3, 6].map(|i| e[i + 2] * v[0] - e[i + 1] * v[1]);
    [a + b * u[0] + c * u[1], c * u[0] - b * u[1], da + db * u[0] + dc * u[1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Rng;

    /// With zero for a free angle.
    fn solve(e1: &[f64; 9], e2: &[f64; 9]) -> Roots<AnglePair, 8> {
        solve_bilinear_choosing(e1, e2, [[1.0, 0.0]; 2], 1e-12)
    }

    fn circle(t: f64) -> [f64; 2] {
        [t.cos(), t.sin()]
    }

    fn value(e: &[f64; 9], u: [f64; 2], v: [f64; 2]) -> f64 {
        value_and_slopes(e, u, v)[0]
    }

    /// A random equation through the given solution.
    fn through(rng: &mut Rng, u: [f64; 2], v: [f64; 2]) -> [f64; 9] {
        let mut e = [(); 9].map(|()| rng.symmetric());
        e[0] -= value(&e, u, v);
        e
    }

    fn contains(found: &Roots<AnglePair, 8>, u: [f64; 2], v: [f64; 2], tol: f64) -> bool {
        let d = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        found.iter().any(|r| d(r[0], u) + d(r[1], v) < tol)
    }

    /// The number of solutions by brute force: sign changes of the second equation along the solutions of the first.
    fn count_by_grid(e1: &[f64; 9], e2: &[f64; 9]) -> usize {
        let steps = 20_000;
        let branch = |i: usize| {
            let v = circle(core::f64::consts::TAU * (i as f64 + 0.37) / steps as f64);
            let us = first_angle(e1, v);
            (us.len() == 2).then(|| [value(e2, us[0], v) > 0.0, value(e2, us[1], v) > 0.0])
        };
        (0..steps)
            .map(|i| match (branch(i), branch(i + 1)) {
                (Some(a), Some(b)) => usize::from(a[0] != b[0]) + usize::from(a[1] != b[1]),
                _ => 0,
            })
            .sum()
    }

    #[test]
    fn random_systems_give_back_their_solution_and_all_others() {
        let mut rng = Rng::new(40);
        let (mut most, mut total, mut by_grid) = (0, 0, 0);
        for i in 0..400 {
            let (u, v) = (circle(rng.angle()), circle(rng.angle()));
            let (e1, e2) = (through(&mut rng, u, v), through(&mut rng, u, v));
            let found = solve(&e1, &e2);
            assert!(contains(&found, u, v, 1e-6), "{found:?}");
            assert!(found.len().is_multiple_of(2));
            for r in &found {
                assert!(value(&e1, r[0], r[1]).abs() < 1e-13 && value(&e2, r[0], r[1]).abs() < 1e-13);
                assert!((r[0][0].hypot(r[0][1]) - 1.0).abs() < 1e-12);
            }
            if i < 40 {
                // The grid doesn't see solutions near the folds of the first equation.
                let grid = count_by_grid(&e1, &e2);
                assert!(found.len() >= grid, "{} < {grid}", found.len());
                total += found.len();
                by_grid += grid;
            }
            most = most.max(found.len());
        }
        assert!(most >= 6, "{most}");
        assert!(total - by_grid <= 6, "{total} {by_grid}");
    }

    #[test]
    fn special_angles_work() {
        let mut rng = Rng::new(41);
        for i in 0..8 {
            for j in 0..8 {
                let quarter = core::f64::consts::FRAC_PI_4;
                let (u, v) = (circle(f64::from(i) * quarter), circle(f64::from(j) * quarter));
                let (e1, e2) = (through(&mut rng, u, v), through(&mut rng, u, v));
                assert!(contains(&solve(&e1, &e2), u, v, 1e-7));
            }
        }
    }

    #[test]
    fn dependent_equations_in_u_at_a_root_give_both_values_of_u() {
        // e2 = 2 e1 + (cos v - cos v0) g: at v0 both say the same about u.
        let mut rng = Rng::new(42);
        for _ in 0..200 {
            let (u, v) = (circle(rng.angle()), circle(rng.angle()));
            let e1 = through(&mut rng, u, v);
            let (g, h, k) = (rng.symmetric(), rng.symmetric(), rng.symmetric());
            let mut e2 = e1.map(|x| 2.0 * x);
            for (i, f) in [(0, g), (3, h), (6, k)] {
                e2[i] -= v[0] * f;
                e2[i + 1] += f;
            }
            let found = solve(&e1, &e2);
            for &u in &first_angle(&e1, v) {
                assert!(contains(&found, u, v, 1e-6), "{u:?} {v:?} {found:?}");
            }
        }
    }

    #[test]
    fn an_equation_in_one_angle_is_solved_first() {
        let mut rng = Rng::new(43);
        for swap in [false, true] {
            for order in [false, true] {
                let (u, v) = (circle(0.4), circle(-2.0));
                let full = through(&mut rng, u, v);
                let mut alone = [0.0; 9];
                (alone[1], alone[2]) = (0.7, 0.2);
                alone[0] = -value(&alone, u, v);
                let (a, b) = if swap { (transposed(&alone), transposed(&full)) } else { (alone, full) };
                let (u, v) = if swap { (v, u) } else { (u, v) };
                let found = if order { solve(&a, &b) } else { solve(&b, &a) };
                assert!(contains(&found, u, v, 1e-12) && found.len() >= 2);
            }
        }
    }

    #[test]
    fn separate_and_degenerate_systems() {
        let mut e1 = [0.0; 9];
        (e1[0], e1[3]) = (-0.5, 1.0);
        let mut e2 = [0.0; 9];
        (e2[0], e2[2]) = (-0.6, 1.0);
        assert_eq!(solve(&e1, &e2).len(), 4);
        e2[0] = -1.6;
        assert!(matches!(solve(&e1, &e2).outcome, Outcome::OutOfReach { .. }));
        assert!(solve(&[0.0; 9], &e1).is_free());
        // Both in v alone, with one v in common: u is free there.
        let (alone, again) =
            ([0.5, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 3f64.sqrt(), 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert!(solve(&alone, &again).is_free() && solve(&again, &alone).is_free());
        let e = [0.1, 0.2, 0.3, -0.4, 0.5, 0.6, 0.7, -0.8, 0.9];
        assert!(solve(&e, &e.map(|x| -3.0 * x)).is_free());
        assert!(solve(&[f64::NAN; 9], &e).is_empty());
    }
}
