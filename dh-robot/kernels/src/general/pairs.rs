//! Arms with two parallel neighbours and two neighbours that meet: their equation in one angle, in closed form.
//!
//! Call the axes of the loop A to F, in order. B and C are parallel, D and E meet, and the link from F to A is any: so are nearly
//! all industrial arms whose wrist axes have no common point (axes 2 and 3 parallel, 4 and 5 meeting). In the frame of A, with the
//! angle of F given,
//!
//! ```text
//! e, w     the direction of E and the point where D and E meet: linear in the cosine and sine of that angle
//! n        the direction of B and C:  n.z = c1,  n.w = delta                        two solutions, where a circle cuts a plane
//! l        the direction of D:        n.l = c3,  e.l = c4                           two solutions for each of them
//! distance of the parallel axes:      u + v.l = 0                                   the equation
//! ```
//!
//! with a number `u` and a vector `v` that follow from `n` and `w`. The product of `u + v.l` over both `l` is a Gram determinant of `n`, `e`,
//! `v` and `l`; the product over both `n`, times the fourth power of the distance of `w` from A, is a trigonometric polynomial of degree 8.
//! If `n` cannot be distinguished from `-n`, half of that is enough. No angle is singled out, and no matrix is needed.

use super::super::chain::NumericChain;
use super::super::elementary::sqrt;
use super::super::pose::{IDENTITY, Pose, compose, inverse, turn};
use super::super::vector::{cross, dot, norm};
use super::super::{Blank, List};
use super::choice::Choice;
use super::closure::{loop_links, unit};
use super::determinant::{Determinant, Eliminant, Root};

/// Constants that differ from zero (or twists from parallel) by less, in radians and lengths over the length scale, are rounding errors of a
/// table's right angles.
const ROUNDING: f64 = 1e-14;
/// Axes that are nearer to parallel than this have no usable common normal.
const PARALLEL: f64 = 1e-3;
/// A squared sine that is less negative than this may be one that rounding took below zero: two directions that fall together.
const TOGETHER: f64 = 1e-6;
/// How far (relative) the last equation may be from holding at a multiple root, and at a simple one, for others than the best candidate.
const MISSES: f64 = 1e-2;
const HOLDS: f64 = 1e-5;
/// Where the squared sine between two axes is less, the angle to the second one is a bad equation.
const BLIND: f64 = 1e-6;
/// A point that is nearer to an axis is on it.
const ON_AXIS: f64 = 1e-4;
/// A unit in the last place.
const ULP: f64 = 2.3e-16;

/// A link between skew axes: what leads from the first to the second, in the basis `(first, second, first x second)`.
#[derive(Clone, Copy)]
struct Skew {
    /// Cosine of the angle between the axes, and its sine squared.
    cos: f64,
    sin2: f64,
    /// The way from the first frame's origin to the second one's.
    way: [f64; 3],
}

impl Skew {
    fn new(link: &Pose) -> Option<Self> {
        let ([x, y, cos], [px, py, pz]) = ([0, 1, 2].map(|i| link[i][2]), [0, 1, 2].map(|i| link[i][3]));
        let sin2 = x * x + y * y;
        let along = (px * x + py * y) / sin2;
        let across = (py * x - px * y) / sin2;
        (sin2 > PARALLEL * PARALLEL).then_some(Self { cos, sin2, way: [pz - along * cos, along, across] })
    }
}

/// The structure of an arm of this kind, and a target.
pub(super) struct Pairs {
    /// Links of the loop from A on.
    links: [Pose; 6],
    /// Coefficients of 1, cosine and sine of F: direction of E, and the point where D and E meet, from the nearest point of A's origin.
    e: [[f64; 3]; 3],
    w: [[f64; 3]; 3],
    /// A and B, and whether B and C point the same way (1) or not (-1).
    first: Skew,
    same: f64,
    /// C and D.
    second: Skew,
    /// The cosine of D and E.
    c4: f64,
    /// `n.z` and `n.w`.
    c1: f64,
    delta: f64,
    /// Offsets: along D from C's common normal to E, along the common normals of C and D and of A and B (over the sines).
    d4: f64,
    g3: f64,
    g1: f64,
    /// Constant parts of `u` and `v.v`, and `n.v`.
    u0: f64,
    vv0: f64,
    p: f64,
    /// Whether `n` cannot be told from `-n`.
    pub(super) symmetric: bool,
}

/// What the angle of F fixes.
struct AxisE {
    /// The direction of E, and where D and E meet.
    e: [f64; 3],
    w: [f64; 3],
    ww: f64,
    /// The squared distance of that point from A.
    far: f64,
    /// `n` times `far`, without what has two signs: that is the root of `across` times `(-w[1], w[0], 0)`.
    middle: [f64; 3],
    across: f64,
}

/// A candidate for the four angles that fix all others.
#[derive(Clone, Copy)]
pub(super) struct PairCandidate {
    n: [f64; 3],
    l: [f64; 3],
    /// How far (relative) it is from closing the loop.
    pub(super) misses: f64,
}

impl Blank for PairCandidate {
    const BLANK: Self = Self { n: [0.0; 3], l: [0.0; 3], misses: 0.0 };
}

impl Pairs {
    /// `arm` and `target` with lengths of order one; nothing if the arm isn't of this kind, cut that way.
    pub(super) fn new(arm: &NumericChain<6>, target: &Pose, choice: Choice) -> Option<Self> {
        if !fits(arm, choice) {
            return None;
        }
        let links = loop_links(arm, target, choice);
        let (first, second) = (Skew::new(&links[0])?, Skew::new(&links[2])?);
        let same = 1f64.copysign(links[1][2][2]);
        let rho2 = links[1][0][3] * links[1][0][3] + links[1][1][3] * links[1][1][3];
        // Where D and E meet: `on_d` along D, `on_e` along E.
        let meeting = Skew::new(&links[3])?;
        let ([on_d, back, _], c4) = (meeting.way, meeting.cos);
        let on_e = -back;
        let [c1, c3] = [same * first.cos, second.cos];
        let (d4, g3, g1) = (second.way[1] + on_d, second.way[2], same * first.way[2]);
        if d4 * d4 + g3 * g3 < PARALLEL * PARALLEL {
            // C, D and E meet in one point: the arm has more structure than this.
            return None;
        }
        let eta = second.way[0] + same * (first.way[1] + links[1][2][3]);
        let delta = eta + d4 * c3;
        let u0 = d4 * d4 + g3 * g3 * second.sin2 + g1 * g1 * first.sin2 - rho2 - eta * eta + 2.0 * g3 * g1 * c1 * c3;
        let vv0 =
            g1 * g1 * (d4 * d4 * first.sin2 + g3 * g3) - g3 * g3 * delta * delta + 2.0 * g3 * g1 * d4 * delta * c1;
        let [m, n] = [inverse(&links[5]), inverse(&links[4])];
        // M Rz(-angle) (x, y, z) in powers of cosine and sine.
        let turned = |[x, y, z]: [f64; 3]| {
            let column = |k: usize| [m[0][k], m[1][k], m[2][k]];
            let mix = |x: f64, y: f64| {
                let (a, b) = (column(0), column(1));
                [0, 1, 2].map(|i| a[i] * x + b[i] * y)
            };
            [column(2).map(|a| a * z), mix(x, y), mix(y, -x)]
        };
        let direction = [0, 1, 2].map(|i| n[i][2]);
        let e = turned(direction);
        let mut w = turned([0, 1, 2].map(|i| n[i][3] + on_e * direction[i]));
        for i in 0..3 {
            w[0][i] += m[i][3];
        }
        w[0][2] -= first.way[0];
        let symmetric = [c1, c3, delta, g3, g1].iter().all(|x| x.abs() < ROUNDING);
        let p = -d4 * delta - g3 * g1 * c1;
        Some(Self { links, e, w, first, same, second, c4, c1, delta, d4, g3, g1, u0, vv0, p, symmetric })
    }

    fn place(&self, [c, s]: [f64; 2]) -> AxisE {
        let at = |v: &[[f64; 3]; 3]| [0, 1, 2].map(|i| v[0][i] + c * v[1][i] + s * v[2][i]);
        let (e, w) = (at(&self.e), at(&self.w));
        let far = w[0] * w[0] + w[1] * w[1];
        let along = self.delta - self.c1 * w[2];
        let across = far * (1.0 - self.c1 * self.c1) - along * along;
        AxisE { e, w, ww: far + w[2] * w[2], far, middle: [along * w[0], along * w[1], self.c1 * far], across }
    }

    /// `v` without what is along `n`.
    fn v(&self, place: &AxisE, n: [f64; 3]) -> [f64; 3] {
        let (wn, zn) = (cross(place.w, n), [-n[1], n[0], 0.0]);
        let mut v = [0, 1, 2].map(|i| self.d4 * (self.g1 * zn[i] - place.w[i]) - self.g3 * wn[i]);
        v[2] -= self.g3 * self.g1;
        v
    }

    /// The Gram determinant for both `n`: `x + y r` with the root `r` of `place.across`; that is `[x, y]`.
    fn gram_of_both(&self, place: &AxisE) -> [f64; 2] {
        let AxisE { w, far, middle, across, .. } = *place;
        let one = 1.0 / far;
        // n.x = [middle.x, g.x] / far
        let times_n = |x: [f64; 3]| [dot(middle, x) * one, (w[0] * x[1] - w[1] * x[0]) * one];
        self.gram(place, times_n, [0.0, 1.0], across)
    }

    /// The Gram determinant, with all numbers of the form `x + y r`: `[x, y]`, where `r^2 = across`; from the products of `n` with vectors,
    /// and with `z x w`.
    #[inline]
    fn gram(&self, place: &AxisE, times_n: impl Fn([f64; 3]) -> [f64; 2], turned: [f64; 2], across: f64) -> [f64; 2] {
        let AxisE { e, w, ww, .. } = *place;
        let (c3, c4, p) = (self.second.cos, self.c4, self.p);
        let product = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] + a[1] * b[1] * across, a[0] * b[1] + a[1] * b[0]];
        let kappa = times_n(e);
        let (moment, ez) = (cross(w, e), [e[1], -e[0], 0.0]);
        let mut q = times_n([0, 1, 2].map(|i| self.g3 * moment[i] + self.d4 * self.g1 * ez[i]));
        q[0] -= self.d4 * dot(w, e) + self.g3 * self.g1 * e[2];
        let u = [0.5 * (ww + self.u0) + self.g1 * turned[0], self.g1 * turned[1]];
        let lengths = self.d4 * self.d4 + self.g3 * self.g3;
        let vv = [lengths * (ww + 2.0 * self.g1 * turned[0]) + self.vv0, 2.0 * lengths * self.g1 * turned[1]];
        let kk = product(kappa, kappa);
        let sines = [1.0 - kk[0], -kk[1]];
        // sines u^2 + 2 u b + a + vv (d - sines) - (p c4 - c3 q)^2
        let kq = product(kappa, q);
        let b = [0, 1].map(|i| q[i] * c4 - p * c4 * kappa[i] - c3 * kq[i] + if i == 0 { p * c3 } else { 0.0 });
        let qq = product(q, q);
        let a = [p * p - 2.0 * p * kq[0] + qq[0], qq[1] - 2.0 * p * kq[1]];
        let d = [c3 * c3 + c4 * c4 - 2.0 * c3 * c4 * kappa[0] - sines[0], -2.0 * c3 * c4 * kappa[1] - sines[1]];
        let rest = [p * c4 - c3 * q[0], -c3 * q[1]];
        let (su, vd, rr) = (product(sines, u), product(vv, d), product(rest, rest));
        let uu = product([su[0] + 2.0 * b[0], su[1] + 2.0 * b[1]], u);
        [uu[0] + a[0] + vd[0] - rr[0], uu[1] + a[1] + vd[1] - rr[1]]
    }

    /// The candidates at a root of the polynomial, best first; more of them for a root that is not simple. None only where all are complex.
    pub(super) fn candidates(&self, at: [f64; 2], multiple: bool) -> List<PairCandidate, 16> {
        let place = self.place(at);
        let mut candidates = List::<PairCandidate, 16>::new();
        // Where the two directions fall together, the root may be off by a little.
        if !(place.across > -TOGETHER * place.far) {
            return candidates;
        }
        let one = 1.0 / place.far;
        let across = sqrt(place.across.max(0.0)) * one;
        let [x, y, z] = place.middle.map(|m| m * one);
        for sign in [across, -across] {
            self.complete(&place, [x - sign * place.w[1], y + sign * place.w[0], z], &mut candidates);
        }
        candidates.as_mut_slice().sort_unstable_by(|a, b| a.misses.total_cmp(&b.misses));
        // The error of the best one shows how well the root is known.
        let known = candidates.first().map_or(0.0, |c| 1e3 * c.misses);
        let limit = if multiple { MISSES } else { HOLDS.max(known).min(MISSES) };
        let mut best = List::new();
        for (i, c) in candidates.iter().enumerate() {
            if i == 0 || c.misses < limit {
                best.push(*c);
            }
        }
        best
    }

    /// Adds the candidates with a given `n`.
    fn complete(&self, place: &AxisE, n: [f64; 3], candidates: &mut List<PairCandidate, 16>) {
        let v = self.v(place, n);
        let u = 0.5 * (place.ww + self.u0) + self.g1 * (place.w[0] * n[1] - place.w[1] * n[0]);
        let size = norm(v) + u.abs();
        let kappa = dot(place.e, n);
        for &l in meeting(n, self.second.cos, place.e, self.c4).iter() {
            candidates.push(PairCandidate { n, l, misses: (dot(v, l) + u).abs() / size });
        }
        if 1.0 - kappa * kappa < BLIND {
            // Where E is parallel to C, its angle with D says nothing.
            for &l in meeting(n, self.second.cos, v, -u).iter() {
                candidates.push(PairCandidate { n, l, misses: (dot(place.e, l) - self.c4).abs() });
            }
        }
    }

    /// Where the point in which D and E meet lies on A, any `n` at the right angle to A will do, and the Gram determinant tells which: its
    /// roots as candidates, and whether they are all. Nothing where that point is elsewhere.
    pub(super) fn candidates_on_axis(&self, at: [f64; 2]) -> Option<(List<PairCandidate, 16>, bool)> {
        let place = self.place(at);
        let along = self.delta - self.c1 * place.w[2];
        if !(place.far < ON_AXIS * ON_AXIS && along.abs() < ON_AXIS) {
            return None;
        }
        let shoulder = Shoulder { pairs: self, place };
        let determinant = Determinant::<4, 9, 12>::new(&shoulder);
        let (mut candidates, mut all) = (List::new(), determinant.means_something());
        let effort = determinant.each_root(&shoulder, |angle, kind| {
            let before = candidates.len();
            self.complete(&shoulder.place, shoulder.direction(angle), &mut candidates);
            // Of the two at a simple root one is right.
            let mut best: Option<PairCandidate> = None;
            while candidates.len() > before {
                let candidate = candidates.pop();
                best = match (best, candidate) {
                    (Some(a), Some(b)) => Some(if a.misses < b.misses { a } else { b }),
                    (a, b) => a.or(b),
                };
            }
            if let Some(best) = best {
                candidates.push(best);
            }
            all &= matches!(kind, Root::Crossing(_) | Root::NearMiss);
        });
        Some((candidates, all && !effort.exhausted))
    }

    /// The size of the terms in the Gram determinant.
    fn size(&self, place: &AxisE) -> f64 {
        let u = place.ww + self.u0.abs();
        u * u + 4.0 * (self.d4 * self.d4 + self.g3 * self.g3) * place.ww
    }

    /// The cosines and sines of all angles, in the order of the loop, and by how much the loop doesn't close.
    pub(super) fn angles(&self, at: [f64; 2], candidate: &PairCandidate) -> ([[f64; 2]; 6], f64) {
        let PairCandidate { n, l, .. } = *candidate;
        let (links, place) = (&self.links, self.place(at));
        let column = |t: &Pose, k: usize| [t[0][k], t[1][k], t[2][k]];
        // What a vector looks like in a frame, without its z.
        let seen = |t: &Pose, v: [f64; 3]| [0, 1].map(|k| dot(column(t, k), v));
        // The turn about z that takes one vector to another.
        let between = |[x, y, _]: [f64; 3], [p, q]: [f64; 2]| unit([x * p + y * q, x * q - y * p]);
        let after = |before: &Pose, angle: [f64; 2], k: usize| compose(&turn(before, angle), &links[k]);
        let a = between(column(&links[0], 2), [self.same * n[0], self.same * n[1]]);
        let to_b = after(&IDENTITY, a, 0);
        // From the point where D and E meet back to the origin of C's frame, and from B's origin to there.
        let across = cross(n, l);
        let [on_c, _, over] = self.second.way;
        let mut way = [0, 1, 2].map(|i| place.w[i] - on_c * n[i] - self.d4 * l[i] - over * across[i] - to_b[i][3]);
        way[2] += self.first.way[0];
        let b = between(column(&links[1], 3), seen(&to_b, way));
        let to_c = after(&to_b, b, 1);
        let c = between(column(&links[2], 2), seen(&to_c, l));
        let to_d = after(&to_c, c, 2);
        let d = between(column(&links[3], 2), seen(&to_d, place.e));
        let to_e = after(&to_d, d, 3);
        // The loop closes: what is missing between E's frame and A's is the turn of E, its link, and F with its link.
        let back = compose(&inverse(&links[5]), &turn(&IDENTITY, [at[0], -at[1]]));
        let mut rest = compose(&compose(&inverse(&to_e), &back), &inverse(&links[4]));
        let e = unit([rest[0][0] + rest[1][1], rest[1][0] - rest[0][1]]);
        let [cos, sin] = e;
        for (row, turn) in rest.iter_mut().zip([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]) {
            for (x, turn) in row.iter_mut().zip(turn) {
                *x -= turn;
            }
        }
        let gap = sqrt(rest.iter().flatten().map(|x| x * x).sum());
        ([a, b, c, d, e, at], gap)
    }
}

/// The Gram determinant as a function of the angle of `n` about A.
struct Shoulder<'a> {
    pairs: &'a Pairs,
    place: AxisE,
}

impl Shoulder<'_> {
    fn direction(&self, [c, s]: [f64; 2]) -> [f64; 3] {
        let sin = sqrt(self.pairs.first.sin2);
        [sin * c, sin * s, self.pairs.c1]
    }
}

impl Eliminant for Shoulder<'_> {
    const FLAT: f64 = Pairs::FLAT;
    const MOST: usize = Pairs::MOST;

    fn value(&self, at: [f64; 2]) -> (f64, f64) {
        let (n, w) = (self.direction(at), self.place.w);
        let turned = [w[0] * n[1] - w[1] * n[0], 0.0];
        let [x, _] = self.pairs.gram(&self.place, |v| [dot(n, v), 0.0], turned, 0.0);
        (x, x.abs() / self.pairs.size(&self.place))
    }

    fn again(&self, [c, s]: [f64; 2]) -> f64 {
        self.value([c - ULP * s, s + ULP * c]).0
    }
}

impl Eliminant for Pairs {
    // Values are cheap.
    const FLAT: f64 = 1e-5;
    const MOST: usize = 16;

    fn value(&self, at: [f64; 2]) -> (f64, f64) {
        let place = self.place(at);
        let [x, y] = self.gram_of_both(&place);
        let size = self.size(&place);
        if self.symmetric {
            (x * place.far, x.abs() / size)
        } else {
            let product = x * x - y * y * place.across;
            (product * place.far * place.far, product.abs() / (size * size))
        }
    }

    fn again(&self, [c, s]: [f64; 2]) -> f64 {
        // As much farther on as rounding hides.
        self.value([c - ULP * s, s + ULP * c]).0
    }
}

/// The directions at given "cosines" to a unit vector and to another vector: two, one twice, or none.
fn meeting(n: [f64; 3], cos: f64, x: [f64; 3], along: f64) -> List<[f64; 3], 2> {
    let (across, xx, nx) = (cross(n, x), dot(x, x), dot(n, x));
    let area = dot(across, across);
    let mut found = List::new();
    let rest = area - (cos * cos * xx - 2.0 * cos * along * nx + along * along);
    if area > 1e-20 * xx && rest > -TOGETHER * area {
        let one = 1.0 / area;
        let (a, b, c) = ((cos * xx - along * nx) * one, (along - cos * nx) * one, sqrt(rest.max(0.0)) * one);
        for c in [c, -c] {
            found.push([0, 1, 2].map(|i| a * n[i] + b * x[i] + c * across[i]));
        }
    }
    found
}

/// Whether an arm has the structure that this cut needs.
pub(super) fn fits(arm: &NumericChain<6>, choice: Choice) -> bool {
    let joints = choice.joints();
    // Against the order of the joints, a link belongs to the joint before.
    let link = |part: usize| if choice.reversed() { (joints[part] + 5) % 6 } else { joints[part] };
    // The link to the target has no structure, whatever it looks like without one.
    if arm.prismatic != [false; 6] || link(1) == 5 || link(3) == 5 {
        return false;
    }
    let [between, meeting] = [&arm.links[link(1)], &arm.links[link(3)]];
    let tilt = between[0][2].abs().max(between[1][2].abs());
    let apart = sqrt(between[0][3] * between[0][3] + between[1][3] * between[1][3]);
    // The distance of two axes, times the sine of their angle.
    let gap = (meeting[0][3] * meeting[1][2] - meeting[1][3] * meeting[0][2]).abs();
    tilt < ROUNDING
        && apart > PARALLEL
        && gap < ROUNDING
        && [0, 2, 3].iter().all(|&part| link(part) == 5 || Skew::new(&arm.links[link(part)]).is_some())
}
