// Numeric kernels of the inverse kinematics: every real solution of one equation, or of two in two unknowns.
// The same methods and tolerances as dh-kernels, where each is explained; angles are pairs [cos, sin].
const BOUNDARY = 1e-9, DOUBLE = 1e-14, TOUCH = 1e-10, RANK = 1e-9, CONTRADICTION = 1e-3, ACCEPT = 1e-8, TINY = 1e-12, NOISE = 1e-11;

const FREE = "free", REGULAR = "regular", TOUCHING = "touching", OUT_OF_REACH = "out of reach", NO_ROOT = "no real root";
const found = (outcome, roots = [], more = {}) => ({ outcome, roots, ...more });
const outOfReach = (needed, available) => found(OUT_OF_REACH, [], { needed, available });
// Is a step without a root possibly one with a root that rounding hides? Is it beyond what is available by the error of a double root before?
const mayHideARoot = (f) => f.outcome === NO_ROOT || (f.outcome === OUT_OF_REACH && !(f.needed > 1.05 * f.available && f.available > 1e-4));
const justMissesARoot = (f) => f.outcome === OUT_OF_REACH && f.needed > f.available && f.needed <= f.available * (1 + 1e-4);
const orIfFree = (f, root) => (f.outcome === FREE && f.roots.length === 0 ? [root] : f.roots);
const largest = (list) => list.reduce((m, x) => Math.max(m, Math.abs(x)), 0);
const finite = (list) => list.every(Number.isFinite);
const signOf = (x) => (x < 0 || Object.is(x, -0) ? -1 : 1);

// a cos t + b sin t = c
function solveSinCos(a, b, c, tol) {
  const h = Math.sqrt(a * a + b * b), needed = Math.abs(c);
  if (h <= tol && needed <= tol) return found(FREE);
  const gap = h - needed;
  if (!(h > tol && gap >= -BOUNDARY * h && h < Infinity)) return outOfReach(needed, h);
  const ua = a / h, ub = b / h;
  if (gap <= DOUBLE * h) return found(TOUCHING, [[signOf(c) * ua, signOf(c) * ub]]);
  const uc = c / h, r = Math.sqrt(gap * (h + needed)) / h;
  return found(REGULAR, [[ua * uc - ub * r, ub * uc + ua * r], [ua * uc + ub * r, ub * uc - ua * r]]);
}

// a cos t + b sin t = 0 twice, by the equation with the larger coefficients
function solveHalfTurn(p, q, tol) {
  const [a, b] = p[0] * p[0] + p[1] * p[1] >= q[0] * q[0] + q[1] * q[1] ? p : q;
  return solveSinCos(a, b, 0, tol);
}

// a1 cos t + b1 sin t = c1 and a2 cos t + b2 sin t = c2
function solvePair(a1, b1, c1, a2, b2, c2, tol) {
  const det = a1 * b2 - a2 * b1, size = a1 * a1 + b1 * b1 + a2 * a2 + b2 * b2;
  const rows = [[a1, b1, c1], [a2, b2, c2]];
  if (!(size > tol * tol && Math.abs(det) > RANK * size)) return solveMany(rows, tol);
  const x = c1 * b2 - c2 * b1, y = a1 * c2 - a2 * c1, norm = Math.sqrt(x * x + y * y);
  if (!(Math.abs(norm - Math.abs(det)) <= CONTRADICTION * size)) return outOfReach(norm / Math.abs(det), 1);
  if (norm <= RANK * size) return solveMany(rows, tol);
  const scale = signOf(det) / norm;
  return found(REGULAR, [[x * scale, y * scale]]);
}

// Any number of such equations, in the sense of least squares.
function solveMany(rows, tol) {
  let p = 0, q = 0, g = 0, r = 0, h = 0, rest = 0;
  for (let [a, b, c] of rows) {
    let n = Math.sqrt(p * p + a * a);
    if (n > 0) {
      const co = p / n, si = a / n;
      [p, a, q, b, g, c] = [n, 0, co * q + si * b, co * b - si * q, co * g + si * c, co * c - si * g];
    }
    n = Math.sqrt(r * r + b * b);
    if (n > 0) {
      const co = r / n, si = b / n;
      [r, b, h, c] = [n, 0, co * h + si * c, co * c - si * h];
    }
    rest += c * c + a + b;
  }
  rest = Math.sqrt(rest);
  const m11 = p * p, m12 = p * q, m22 = q * q + r * r, half = 0.5 * (m11 - m22);
  const root = Math.sqrt(half * half + m12 * m12), first = Math.sqrt(0.5 * (m11 + m22) + root);
  const right = Math.sqrt(g * g + h * h);
  if (first <= tol) {
    const needed = Math.sqrt(right * right + rest * rest);
    return needed <= tol ? found(FREE) : outOfReach(needed, first);
  }
  if (!(first < Infinity && rest < Infinity)) return outOfReach(NaN, first);
  if (!(rest <= CONTRADICTION * (first + right))) return outOfReach(rest, first);
  const det = p * r;
  if (Math.abs(det) <= RANK * first * first) {
    let [x, y] = half >= 0 ? [half + root, m12] : [m12, root - half];
    const n = Math.sqrt(x * x + y * y);
    [x, y] = [x / n, y / n];
    const u = (p * x + q * y) / first, v = r * y / first, off = Math.abs(u * h - v * g);
    return off <= CONTRADICTION * (first + right) ? solveSinCos(x, y, (u * g + v * h) / first, RANK) : outOfReach(off, first);
  }
  const s = h / r, c = (g - q * s) / p, norm = Math.sqrt(c * c + s * s);
  if (!(norm > RANK && Math.abs(norm - 1) * Math.abs(det) <= CONTRADICTION * first * first)) return outOfReach(norm, 1);
  return found(REGULAR, [[c / norm, s / norm]]);
}

// a x^2 + b x + c = 0
function solveQuadratic(a, b, c, tol) {
  if (Math.abs(a) <= tol) {
    if (Math.abs(b) <= tol) return Math.abs(c) <= tol ? found(FREE) : outOfReach(Math.abs(c), 0);
    return found(REGULAR, [-c / b]);
  }
  const bb = b * b, ac = 4 * a * c, discriminant = bb - ac, size = Math.max(bb, Math.abs(ac));
  if (!(discriminant >= -BOUNDARY * size && size < Infinity && Math.abs(a) < Infinity)) return found(NO_ROOT);
  if (discriminant <= DOUBLE * size) return found(TOUCHING, [-0.5 * b / a]);
  const q = -0.5 * (b + signOf(b) * Math.sqrt(discriminant));
  return found(REGULAR, [q / a, c / q]);
}

// An angle [cos, sin] or a length after a small step.
const moved = (x, by) => {
  if (typeof x === "number") return x + by;
  const h = 0.5 * by, inverse = 1 / (1 + h * h), c = (1 - h * h) * inverse, s = 2 * h * inverse;
  return [x[0] * c - x[1] * s, x[0] * s + x[1] * c];
};

// Newton's method for two equations in two unknowns; `system` gives two rows [value, by x, by y].
function polishPair(x, y, system) {
  const goal = 1e-15, residual = (e) => Math.max(Math.abs(e[0][0]), Math.abs(e[1][0]));
  let now = system(x, y), best = residual(now), at = [x, y], kept = [x, y];
  for (let step = 0; step < 12 && best > goal; step++) {
    const [[e, ex, ey], [f, fx, fy]] = now, m = 1e-3 * (e * e + f * f);
    const a = ex * ex + fx * fx + m, b = ex * ey + fx * fy, c = ey * ey + fy * fy + m;
    const g = ex * e + fx * f, h = ey * e + fy * f, det = a * c - b * b, plain = ex * fy - ey * fx;
    let dx, dy;
    if (plain * plain > 1e-6 * a * c) [dx, dy] = [(ey * f - fy * e) / plain, (fx * e - ex * f) / plain];
    else if (det > 0) [dx, dy] = [(b * h - c * g) / det, (b * g - a * h) / det];
    else break;
    at = [moved(at[0], dx), moved(at[1], dy)];
    const next = system(at[0], at[1]), before = residual(now);
    now = next;
    if (residual(next) < best) [best, kept] = [residual(next), at];
    else if (before <= 1e3 * goal || !(residual(next) < 1e3 * best)) break;
  }
  return { x: kept[0], y: kept[1], residual: best };
}

const transposed = (e) => [e[0], e[3], e[6], e[1], e[4], e[7], e[2], e[5], e[8]];
const inSecond = (e) => [0, 3, 6].map((i) => new TrigPoly(e[i], [e[i + 1]], [e[i + 2]]));
const atSecond = (e, [c, s]) => [0, 3, 6].map((i) => e[i] + e[i + 1] * c + e[i + 2] * s);
const slopeSecond = (e, [c, s]) => [0, 3, 6].map((i) => e[i + 2] * c - e[i + 1] * s);
const scaledBy = (e, tol) => { const size = largest(e); return size <= tol ? null : e.map((x) => x / size); };
const minor = (p, q, r, s) => p.times(q).plus(r.times(s), -1);

// sum e[3 i + j] U_i V_j = 0 for two equations, U = (1, cos u, sin u), V = (1, cos v, sin v): pairs [u, v]. (Pieper)
function solveBilinear(e1, e2, choice, tol) {
  if (!finite(e1) || !finite(e2)) return found(NO_ROOT);
  [e1, e2] = [scaledBy(e1, tol), scaledBy(e2, tol)];
  if (!e1 && !e2) return found(FREE, [choice]);
  if (!e1 || !e2) return chooseAngles(e1 || e2, e1 || e2, choice);
  const lacks = (e) => largest(e.slice(3)) <= TINY, back = [choice[1], choice[0]];
  const swapped = (f) => ({ ...f, roots: f.roots.map(([a, b]) => [b, a]) });
  for (const [first, second] of [[e1, e2], [e2, e1]]) {
    if (lacks(first)) return secondAngleFirst(first, second, choice[0]);
    if (lacks(transposed(first))) return swapped(secondAngleFirst(transposed(first), transposed(second), back[0]));
  }
  let out = byElimination(e1, e2, choice[0]);
  if (out.outcome === FREE && out.roots.length === 0) out = swapped(byElimination(transposed(e1), transposed(e2), back[0]));
  return out.outcome === FREE && out.roots.length === 0 ? chooseAngles(e1, e2, choice) : out;
}

function chooseAngles(e1, e2, choice) {
  for (const swap of [false, true]) {
    const u = swap ? choice[1] : choice[0];
    const [[a1, b1, c1], [a2, b2, c2]] = [e1, e2].map((e) => atSecond(swap ? e : transposed(e), u));
    const vs = orIfFree(solvePair(b1, c1, -a1, b2, c2, -a2, TINY), choice[swap ? 0 : 1]);
    if (vs.length > 0) return found(FREE, vs.map((v) => (swap ? [v, u] : [u, v])));
  }
  return found(FREE);
}

function firstAngle(e, v) {
  const [a, b, c] = atSecond(e, v);
  return solveSinCos(b, c, -a, TINY);
}

function secondAngleFirst(first, second, choice) {
  const vs = solveSinCos(first[1], first[2], -first[0], TINY), roots = [];
  let free = vs.outcome === FREE, outcome = vs.outcome;
  for (const v of vs.roots) {
    const us = firstAngle(second, v);
    free ||= us.outcome === FREE;
    if (us.outcome !== REGULAR) outcome = us.outcome;
    roots.push(...orIfFree(us, choice).map((u) => [u, v]));
  }
  if (free) outcome = FREE;
  else if (roots.length > 0 && outcome === OUT_OF_REACH) outcome = REGULAR;
  return { ...vs, outcome, roots };
}

function byElimination(e1, e2, choice) {
  const [a1, b1, c1] = inSecond(e1), [a2, b2, c2] = inSecond(e2);
  const x = minor(c1, a2, c2, a1), y = minor(a1, b2, a2, b1), w = minor(b1, c2, b2, c1);
  const vs = x.times(x).plus(y.times(y), 1).plus(w.times(w), -1).markedRoots(TINY, TOUCH);
  const roots = [];
  let outcome = vs.outcome;
  for (const [v, touches] of vs.roots) {
    const stays = touches && freeAt(e1, e2, v);
    if (stays) {
      outcome = FREE;
      roots.push([choice, stays]);
      continue;
    }
    for (const at of touches ? [v, moved(v, 4e-3), moved(v, -4e-3)] : [v]) {
      const [f1, g1, h1] = atSecond(e1, at), [f2, g2, h2] = atSecond(e2, at);
      const det = g1 * h2 - g2 * h1, n1 = g1 * g1 + h1 * h1, n2 = g2 * g2 + h2 * h2;
      if (det * det > 1e-6 * Math.max(n1, n2)) {
        addAngles(roots, e1, e2, [(h1 * f2 - h2 * f1) / det, (f1 * g2 - f2 * g1) / det], at);
      } else {
        for (const u of firstAngle(n1 >= n2 ? e1 : e2, at).roots) addAngles(roots, e1, e2, u, at);
      }
    }
  }
  return found(roots.length === 0 && outcome !== FREE ? NO_ROOT : outcome, roots);
}

// The second angle near a touching root at which both equations hold whatever the first one is.
function freeAt(e1, e2, near) {
  const rows = [e1, e2].flatMap((e) => [0, 3, 6].map((i) => [e[i + 1], e[i + 2], -e[i]]));
  const holds = (v) => largest([...atSecond(e1, v), ...atSecond(e2, v)]) <= ACCEPT;
  const close = (v) => Math.abs(v[0] - near[0]) + Math.abs(v[1] - near[1]) <= 4e-3;
  return solveMany(rows, TINY).roots.find((v) => close(v) && holds(v));
}

function addAngles(roots, e1, e2, u, v) {
  const norm = Math.sqrt(u[0] * u[0] + u[1] * u[1]);
  if (!(norm > 0 && norm < Infinity)) return;
  const system = (u, v) => [e1, e2].map((e) => {
    const [a, b, c] = atSecond(e, v), [da, db, dc] = slopeSecond(e, v);
    return [a + b * u[0] + c * u[1], c * u[0] - b * u[1], da + db * u[0] + dc * u[1]];
  });
  const { x, y, residual } = polishPair(u.map((k) => k / norm), v, system);
  const apart = ([a, b]) => Math.abs(a[0] - x[0]) + Math.abs(a[1] - x[1]) + Math.abs(b[0] - y[0]) + Math.abs(b[1] - y[1]);
  if (residual <= ACCEPT && roots.every((r) => apart(r) > 1e-6)) roots.push([x, y]);
}

// sum e[3 i + j] D_i V_j = 0 for two equations, D = (1, d, d^2): pairs [d, v].
function solveLengthAndAngle(e1, e2, choice, tol) {
  if (!finite(e1) || !finite(e2)) return found(NO_ROOT);
  [e1, e2] = [scaledBy(e1, tol), scaledBy(e2, tol)];
  if (!e1 || !e2) return chooseLength(e1 || e2 || Array(9).fill(0), choice);
  const absent = (e, from) => largest(e.slice(from)) <= TINY;
  const p = inSecond(e1), q = inSecond(e2), by = (i, j) => minor(p[i], q[j], q[i], p[j]);
  let vs;
  if (absent(e1, 3)) vs = p[0].roots(TINY);
  else if (absent(e2, 3)) vs = q[0].roots(TINY);
  else if (absent(e1, 6) && absent(e2, 6)) vs = by(0, 1).roots(TINY);
  else vs = minor(by(0, 2), by(0, 2), by(0, 1), by(1, 2)).roots(TINY);
  const roots = [];
  let outcome = vs.outcome;
  for (const v of vs.roots) {
    const q1 = atSecond(e1, v), q2 = atSecond(e2, v), weight = (q) => Math.max(Math.abs(q[1]), Math.abs(q[2]));
    const k = weight(q1) >= weight(q2) ? q1 : q2, ds = solveQuadratic(k[2], k[1], k[0], TINY);
    if (ds.outcome === FREE) {
      outcome = FREE;
      roots.push([choice[0], v]);
    }
    const bottom = q1[1] * q2[2] - q2[1] * q1[2], top = q1[0] * q2[2] - q2[0] * q1[2];
    for (const d of Math.abs(bottom) > TINY ? [...ds.roots, -top / bottom] : ds.roots) addLength(roots, e1, e2, d, v);
  }
  if (roots.length > 0) return found(outcome, roots);
  if (outcome !== FREE) return found(NO_ROOT);
  const weight = (e) => largest(e.slice(3)), [strong, weak] = weight(e1) >= weight(e2) ? [e1, e2] : [e2, e1];
  const holds = ([d, v]) => { const [a, b, c] = atSecond(weak, v); return Math.abs(a + d * (b + d * c)) <= ACCEPT * (1 + d * d); };
  return found(FREE, chooseLength(strong, choice).roots.filter(holds));
}

function chooseLength(e, choice) {
  const [a, b, c] = atSecond(e, choice[1]);
  const ds = orIfFree(solveQuadratic(c, b, a, TINY), choice[0]);
  if (ds.length > 0) return found(FREE, ds.map((d) => [d, choice[1]]));
  const d = choice[0], [f, g, h] = [0, 1, 2].map((i) => e[i] + d * (e[i + 3] + d * e[i + 6]));
  return found(FREE, orIfFree(solveSinCos(g, h, -f, TINY), choice[1]).map((v) => [d, v]));
}

function addLength(roots, e1, e2, d, v) {
  const system = (d, v) => [e1, e2].map((e) => {
    const [a, b, c] = atSecond(e, v), [da, db, dc] = slopeSecond(e, v);
    return [a + d * (b + d * c), b + 2 * d * c, da + d * (db + d * dc)];
  });
  const { x, y, residual } = polishPair(d, v, system), scale = 1 + x * x;
  const apart = ([e, w]) => Math.abs(e - x) + Math.abs(w[0] - y[0]) + Math.abs(w[1] - y[1]);
  if (residual <= ACCEPT * scale && roots.every((r) => apart(r) > 1e-6 * scale)) roots.push([x, y]);
}
