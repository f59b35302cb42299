// Trigonometric polynomials in one angle, and all their real roots: arcs of the circle are halved in Bernstein form until each has
// no root, exactly one, or one that only touches zero. As in dh-kernels (trig_roots.rs, root_isolation.rs, bernstein.rs).
const ARCS = 4, FIRST_MIDDLE = 0.131, MAX_DEPTH = 24;

class TrigPoly {
  // constant + sum over k of cos[k - 1] cos(k t) + sin[k - 1] sin(k t)
  constructor(constant, cos, sin) { Object.assign(this, { constant, cos, sin }); }

  get degree() { return this.cos.length; }

  size() { return [this.constant, ...this.cos, ...this.sin].reduce((sum, x) => sum + Math.abs(x), 0); }

  plus(other, factor) {
    const add = (a, b) => a.map((x, k) => x + factor * b[k]);
    return new TrigPoly(this.constant + factor * other.constant, add(this.cos, other.cos), add(this.sin, other.sin));
  }

  times(other) {
    const n = this.degree, m = other.degree, cos = Array(n + m).fill(0), sin = Array(n + m).fill(0);
    let constant = this.constant * other.constant;
    for (let k = 0; k < n; k++) { cos[k] += this.cos[k] * other.constant; sin[k] += this.sin[k] * other.constant; }
    for (let l = 0; l < m; l++) { cos[l] += this.constant * other.cos[l]; sin[l] += this.constant * other.sin[l]; }
    for (let k = 0; k < n; k++) {
      for (let l = 0; l < m; l++) {
        const a = 0.5 * this.cos[k], b = 0.5 * this.sin[k], c = other.cos[l], d = other.sin[l];
        cos[k + l + 1] += a * c - b * d;
        sin[k + l + 1] += b * c + a * d;
        const dc = a * c + b * d, ds = b * c - a * d;
        if (k > l) { cos[k - l - 1] += dc; sin[k - l - 1] += ds; }
        else if (k < l) { cos[l - k - 1] += dc; sin[l - k - 1] -= ds; }
        else constant += dc;
      }
    }
    return new TrigPoly(constant, cos, sin);
  }

  // Value, first and second derivative at [cos t, sin t].
  at([c, s]) {
    let re = 1, im = 0, value = this.constant, slope = 0, bend = 0;
    for (let k = 0; k < this.degree; k++) {
      [re, im] = [re * c - im * s, re * s + im * c];
      const along = this.cos[k] * re + this.sin[k] * im, across = this.sin[k] * re - this.cos[k] * im;
      value += along;
      slope += (k + 1) * across;
      bend -= (k + 1) * (k + 1) * along;
    }
    return [value, slope, bend];
  }

  roots(zero) {
    const marked = this.markedRoots(zero, TOUCH);
    return { ...marked, roots: marked.roots.map((r) => r[0]) };
  }

  // All real roots as [[cos, sin], only touching?].
  markedRoots(zero, touch) {
    const size = this.size();
    if (size <= zero) return found(FREE);
    if (!(size < Infinity)) return found(NO_ROOT);
    const search = new RootSearch(size, touch);
    for (const arc of this.onArcs()) search.arc(arc);
    const roots = [...search.brackets.map((b) => [this.refined(b), false]), ...search.touching.map((t) => [t, true])];
    return found(search.touching.length > 0 ? TOUCHING : roots.length > 0 ? REGULAR : NO_ROOT, roots);
  }

  onArcs() {
    const D = this.degree, tables = bernsteinTables(D);
    const turned = tables.turn.map(([c, s], k) => [this.cos[k] * c + this.sin[k] * s, this.sin[k] * c - this.cos[k] * s]);
    const arcs = [];
    for (let i = 0; i < ARCS; i++) {
      const even = tables.one.map((x) => this.constant * x), odd = tables.one.map(() => 0), b = Array(2 * D + 1);
      for (let k = 0; k < D; k++) {
        const [c, s] = turned[k];
        for (let j = 0; j <= D; j++) { even[j] += c * tables.cos[k][j]; odd[j] += s * tables.sin[k][j]; }
        turned[k] = [[s, -c], [-c, -s], [-s, c], [c, s]][k % 4];
      }
      for (let j = 0; j <= D; j++) { b[2 * D - j] = even[j] - odd[j]; b[j] = even[j] + odd[j]; }
      b[D] = even[D] + odd[D];
      arcs.push({ b, ends: [tables.ends[i], tables.ends[i + 1]], depth: 0 });
    }
    for (let i = 0; i < ARCS; i++) arcs[(i + 1) % ARCS].b[0] = arcs[i].b[2 * D];
    return arcs;
  }

  // The root in a bracket: Halley's steps, or Newton's that never leave the bracket.
  refined(bracket) {
    let at = bracket.at, last = 1;
    for (let i = 0; i < 3; i++) {
      const [value, slope, bend] = this.at(at), a = -value * slope, b = 2 * slope * slope - value * bend;
      const inverse = 1 / (a * a + b * b), c = (b * b - a * a) * inverse, s = 2 * a * b * inverse;
      at = [at[0] * c - at[1] * s, at[0] * s + at[1] * c];
      last = s;
    }
    const [from, to] = bracket.ends.map(squared);
    const inside = from[0] * at[1] - from[1] * at[0] >= 0 && at[0] * to[1] - at[1] * to[0] >= 0;
    const ahead = from[0] * at[0] + from[1] * at[1] > 0;
    return inside && ahead && Math.abs(last) < 1e-6 ? at : this.bracketed(bracket);
  }

  bracketed({ ends, rising }) {
    const [d0, d1] = ends, area = 2 * (d0[0] * d1[1] - d0[1] * d1[0]);
    let low = 0, high = 1, x = 0.5;
    for (let i = 0; i < 60; i++) {
      const d = between(ends, x), inverse = 1 / (d[0] * d[0] + d[1] * d[1]), at = squared(d).map((k) => k * inverse);
      const [value, slope] = this.at(at);
      if (value === 0) return at;
      if (value > 0 === rising) high = x;
      else low = x;
      const newton = x - value / (slope * area * inverse);
      if (Math.abs(newton - x) < 1e-9) { x = Math.min(Math.max(newton, low), high); break; }
      x = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (high - low < 1e-16) break;
    }
    return point(ends, x);
  }
}

// constant + cos[0] cos t + cos[1] cos 2t + sin[0] sin t + sin[1] sin 2t = 0
const solveSecondHarmonic = (constant, cos, sin, tol) => new TrigPoly(constant, cos, sin).roots(tol);

const between = ([d0, d1], x) => [d0[0] + x * (d1[0] - d0[0]), d0[1] + x * (d1[1] - d0[1])];
const squared = (d) => [d[0] * d[0] - d[1] * d[1], 2 * d[0] * d[1]];
const point = (ends, x) => { const d = between(ends, x), n = d[0] * d[0] + d[1] * d[1]; return squared(d).map((k) => k / n); };

// From Fourier to Bernstein coefficients on an arc around zero.
const tablesByDegree = new Map();
function bernsteinTables(degree) {
  if (tablesByDegree.has(degree)) return tablesByDegree.get(degree);
  const halfArc = Math.PI / ARCS, s = Math.sin(0.5 * halfArc), c = Math.cos(0.5 * halfArc);
  const tables = { turn: [], cos: [], sin: [], one: [], ends: [] };
  for (let k = 0; k <= degree; k++) {
    let re = [1], im = [0];
    for (let count = 0; count < 2 * degree; count++) {
      const y = count < degree + k ? s : -s, r = [], m = [];
      for (let j = 0; j <= count + 1; j++) {
        const [a, b, p, q] = [re[j] ?? 0, im[j] ?? 0, re[j - 1] ?? 0, im[j - 1] ?? 0];
        r.push(a * c + b * y + p * c - q * y);
        m.push(b * c - a * y + q * c + p * y);
      }
      [re, im] = [r, m];
    }
    let binomial = 1;
    const rows = [[], []];
    for (let j = 0; j <= degree; j++) {
      rows[0].push(re[j] / binomial);
      rows[1].push(im[j] / binomial);
      binomial = binomial * (2 * degree - j) / (j + 1);
    }
    if (k === 0) tables.one = rows[0];
    else {
      tables.cos.push(rows[0]);
      tables.sin.push(rows[1]);
      tables.turn.push([Math.cos(k * FIRST_MIDDLE), Math.sin(k * FIRST_MIDDLE)]);
    }
  }
  for (let arc = 0; arc <= ARCS; arc++) {
    const angle = FIRST_MIDDLE + 2 * arc * halfArc - halfArc;
    tables.ends.push([Math.cos(0.5 * angle), Math.sin(0.5 * angle)]);
  }
  tablesByDegree.set(degree, tables);
  return tables;
}

class RootSearch {
  constructor(scale, touch) {
    Object.assign(this, { touch: touch * scale, noise: 1e-15 * scale, nothing: 1e-14 * scale, brackets: [], touching: [] });
  }

  arc(arc) {
    const stack = this.settle(arc) ? [] : [arc];
    while (stack.length > 0) {
      const [left, right] = halves(stack.pop());
      const [l, r] = [this.settle(left), this.settle(right)];
      if (!r) stack.push(right);
      if (!l) stack.push(left);
    }
  }

  // Notes the roots in an arc, if they can be told.
  settle(arc) {
    const { b, ends } = arc, n = b.length - 1, verdict = signsOf(b, this.touch);
    if (verdict === "empty") return true;
    if (verdict === "one") return this.bracket(ends, 0, 1, crossing(b), b[0] < 0);
    if (this.byExtremum(arc)) return true;
    if (largest(b) <= this.nothing || arc.depth >= MAX_DEPTH) {
      this.touches(point(ends, 0.5));
      if (b[0] < 0 !== b[n] < 0) this.bracket(ends, 0, 1, 0.5, b[0] < 0);
      return true;
    }
    return false;
  }

  byExtremum({ b, ends }) {
    const n = b.length - 1, bends = b.slice(2).map((x, j) => b[j] - 2 * b[j + 1] + x);
    const least = Math.min(...bends), most = Math.max(...bends);
    if (least < 0 && most > 0) return false;
    const first = b[1] - b[0], last = b[n] - b[n - 1], crosses = b[0] < 0 !== b[n] < 0;
    if (first < 0 === last < 0) {
      if (crosses) return this.bracket(ends, 0, 1, crossing(b), b[0] < 0);
      const flat = 1e-4 * Math.max(Math.abs(most - least), Math.abs(least));
      if (Math.abs(b[0]) <= this.touch && Math.abs(first) <= flat) this.touches(point(ends, 0));
      if (Math.abs(b[n]) <= this.touch && Math.abs(last) <= flat) this.touches(point(ends, 1));
      return true;
    }
    const [x, value] = extremum(b);
    if (crosses) {
      const [low, high] = value < 0 !== b[0] < 0 ? [0, x] : [x, 1];
      this.bracket(ends, low, high, 0.5 * (low + high), b[0] < 0);
      if (Math.abs(value) <= this.touch) this.touches(point(ends, x));
    } else if (value < 0 !== b[0] < 0 && Math.abs(value) > this.noise) {
      const reach = (end) => Math.sqrt(Math.min(Math.max(value / (value - end), 0), 1));
      this.bracket(ends, 0, x, x - x * reach(b[0]), b[0] < 0);
      this.bracket(ends, x, 1, x + (1 - x) * reach(b[n]), value < 0);
    } else if (Math.abs(value) <= this.touch) this.touches(point(ends, x));
    return true;
  }

  bracket(ends, low, high, x, rising) {
    this.brackets.push({ ends: [between(ends, low), between(ends, high)], rising, at: point(ends, x) });
    return true;
  }

  touches(at) {
    if (!this.touching.some((t) => Math.abs(t[0] - at[0]) + Math.abs(t[1] - at[1]) < 1e-6)) this.touching.push(at);
  }
}

function halves({ b, ends, depth }) {
  const right = [...b], left = [b[0]], n = b.length - 1;
  for (let r = 1; r <= n; r++) {
    for (let j = 0; j <= n - r; j++) right[j] = 0.5 * (right[j] + right[j + 1]);
    left.push(right[0]);
  }
  const middle = between(ends, 0.5);
  return [
    { b: left, ends: [ends[0], middle], depth: depth + 1 },
    { b: right, ends: [middle, ends[1]], depth: depth + 1 },
  ];
}

// What the signs of Bernstein coefficients say about roots; those within `touch` of zero may have either sign.
function signsOf(b, touch) {
  if (Math.min(...b) > touch || Math.max(...b) < -touch) return "empty";
  const changes = b.slice(1).filter((x, j) => x < 0 !== b[j] < 0).length;
  if (b.every((x) => Math.abs(x) > touch)) return changes === 1 ? "one" : "unclear";
  let worst = 0, sign = 0;
  for (const x of b) {
    const s = Math.abs(x) <= touch ? -sign : signOf(x);
    if (s * sign < 0) worst += 1;
    sign = s;
  }
  return worst === 1 && b[0] < 0 !== b[b.length - 1] < 0 && Math.abs(b[0]) > touch ? "one" : "unclear";
}

function crossing(b) {
  const n = b.length - 1, j = b.findIndex((x, i) => i < n && b[i + 1] < 0 !== b[0] < 0);
  const x = (j + b[j] / (b[j] - b[j + 1])) / n;
  return x > 0 && x < 1 ? x : 0.5;
}

// Parameter and value of the only extremum on an arc.
function extremum(b) {
  const n = b.length - 1, first = b[1] - b[0], last = b[n] - b[n - 1], falls = first < 0;
  let low = 0, high = 1, x = first / (first - last), value = b[0];
  for (let i = 0; i < 60; i++) {
    const w = [...b];
    for (let r = 1; r < n - 1; r++) for (let j = 0; j <= n - r; j++) w[j] += x * (w[j + 1] - w[j]);
    const d0 = w[1] - w[0], d1 = w[2] - w[1], slope = d0 + x * (d1 - d0);
    value = w[0] + x * (d0 + slope);
    if (slope === 0) break;
    if (slope < 0 === falls) low = x;
    else high = x;
    const newton = x - slope / ((d1 - d0) * (n - 1));
    if (Math.abs(newton - x) < 1e-9) break;
    x = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return [x, value];
}
