// Candidates in, verified solutions out: each is put through the forward kinematics, polished where rounding shows, and dropped where
// it misses. As in dh-robot (src/inverse) and dh-kernels (polish.rs). A pose is the upper three rows [R | p].
const EXACT = 1e-13, REACHED = 1e-10, REACHED_FEW = 1e-9, SAME = 1e-6, STEPS = 60, STARTS = 60;

const TAU = 2 * Math.PI;
const IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]];
const times = (a, b) => a.map((r) => b[0].map((_, j) => r[0] * b[0][j] + r[1] * b[1][j] + r[2] * b[2][j] + (j === 3 ? r[3] : 0)));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.sqrt(a.reduce((s, x) => s + x * x, 0));
const columnOf = (pose, j) => pose.map((row) => row[j]);
const isRotation = (t) => [0, 1, 2].every((i) => [0, 1, 2].every((j) =>
  Math.abs(dot(columnOf(t, i), columnOf(t, j)) - (i === j ? 1 : 0)) < 2e-6)) && dot(cross(columnOf(t, 0), columnOf(t, 1)), columnOf(t, 2)) > 0;

// The angle in (-pi, pi].
function wrapped(angle) {
  if (angle > -Math.PI && angle <= Math.PI) return angle;
  const rest = angle - TAU * Math.floor(0.5 + angle / TAU);
  return rest <= -Math.PI ? rest + TAU : rest;
}

// An angle in (-pi, pi], or shifted by whole turns into the joint's range where that fits.
function normalized(joint, value) {
  if (!joint.periodic) return value;
  const angle = wrapped(value);
  if (!joint.range) return angle;
  const [least, greatest] = [joint.range[0] - 1e-9, joint.range[1] + 1e-9];
  let shifted = angle;
  if (angle < least) shifted += TAU * Math.ceil((least - angle) / TAU);
  else if (angle > greatest) shifted -= TAU * Math.ceil((angle - greatest) / TAU);
  return shifted >= least && shifted <= greatest ? shifted : angle;
}

const difference = (joint, a, b) => Math.abs(joint.periodic ? wrapped(b - a) : b - a);
const inRange = (joint, x) => !joint.range || (x >= joint.range[0] - 1e-9 && x <= joint.range[1] + 1e-9);

// Actuator values after whole turns of a row, for a drive of which these are no whole turns of the actuators. As in dh-kernels (drive.rs).
const turned = (drive, q, row, turns) => q.map((x, k) => x + TAU * turns * drive.actuators[k][row]);

// Actuator values with each row turned by an angle in (-pi, pi], except rows that would move actuators whose values are given.
function principal(drive, q, given) {
  const angles = drive.rows.map((row) => row.reduce((sum, k, i) => sum + k * q[i], 0));
  const stays = (i) => !drive.revolute[i] || given.some((k) => drive.actuators[k][i] !== 0);
  return angles.reduce((out, angle, i) => (stays(i) ? out : turned(drive, out, i, Math.floor(0.5 - angle / TAU))), q);
}

// Turns rows by whole turns, as few as possible, so that all actuators come into their ranges, where one row after the other can do that.
function intoRanges(drive, joints, q) {
  const inside = (values) => values.every((x, k) => inRange(joints[k], x)), open = [...drive.revolute];
  if (inside(q)) return q;
  let out = q;
  while (open.includes(true)) {
    // A row that alone still moves some actuator with a range; without one, the first.
    const others = (k, i) => open.some((o, j) => o && j !== i && drive.actuators[k][j] !== 0);
    const decides = (k, i) => joints[k].range && drive.actuators[k][i] !== 0 && !others(k, i);
    const rows = [...open.keys()].filter((i) => open[i]);
    const i = rows.find((row) => joints.some((_, k) => decides(k, row))) ?? rows[0];
    let fewest = -Infinity, most = Infinity;
    joints.forEach((joint, k) => {
      if (!decides(k, i)) return;
      const [least, greatest] = joint.range, turn = TAU * drive.actuators[k][i];
      const ends = [(least - 1e-9 - out[k]) / turn, (greatest + 1e-9 - out[k]) / turn];
      fewest = Math.max(fewest, Math.ceil(Math.min(...ends)));
      most = Math.min(most, Math.floor(Math.max(...ends)));
    });
    if (!(fewest <= most)) return q;
    out = turned(drive, out, i, Math.max(fewest, Math.min(most, 0)));
    open[i] = false;
  }
  return inside(out) ? out : q;
}

// The rotation vector from one orientation to another, in base axes.
function rotationBetween(from, to) {
  const e = to.map((r) => from.map((s) => dot(r, s)));
  const v = [0.5 * (e[2][1] - e[1][2]), 0.5 * (e[0][2] - e[2][0]), 0.5 * (e[1][0] - e[0][1])];
  const cos = 0.5 * (e[0][0] + e[1][1] + e[2][2] - 1), sin = length(v);
  if (cos > 0 && sin < 1e-4) return v.map((x) => x * (1 + sin * sin / 6));
  const angle = Math.atan2(sin, cos);
  if (cos > -0.99) return v.map((x) => x * angle / sin);
  const k = e[0][0] >= e[1][1] && e[0][0] >= e[2][2] ? 0 : e[1][1] >= e[2][2] ? 1 : 2;
  const axis = [0, 1, 2].map((i) => 0.5 * (e[i][k] + e[k][i]) - (i === k ? cos : 0));
  const n = length(axis), sign = dot(axis, v) < 0 ? -1 : 1;
  return axis.map((x) => sign * x * angle / n);
}

// What each task compares: `frame` is the target for the plan with lengths over the length scale, `error` what is missing to it, `rows` the
// part of the Jacobian that counts.
const TASKS = {
  pose: {
    frame: (t, arm) => t.map((r) => [r[0], r[1], r[2], r[3] / arm.lengthScale]),
    of: (pose) => pose,
    error: (t, pose) => [[0, 1, 2].map((i) => t[i][3] - pose[i][3]), rotationBetween(pose, t)],
    rows: (pose, j) => j,
  },
  position: {
    frame: (t, arm) => frameOfAxis(t.map((x) => x / arm.lengthScale), [0, 0, 1]),
    of: (pose) => columnOf(pose, 3),
    error: (t, pose) => [[0, 1, 2].map((i) => t[i] - pose[i][3]), [0, 0, 0]],
    rows: (pose, j) => j.map((row, i) => (i < 3 ? row : row.map(() => 0))),
  },
  axis: {
    frame: ([p, z], arm) => frameOfAxis(p.map((x) => x / arm.lengthScale), z),
    of: (pose) => [columnOf(pose, 3), columnOf(pose, 2)],
    error: ([p, direction], pose) => {
      const z = columnOf(pose, 2), v = cross(z, direction), sin = length(v), cos = dot(z, direction);
      const turn = sin > 0 ? v.map((x) => x * Math.atan2(sin, cos) / sin) : columnOf(pose, 0).map((x) => (cos < 0 ? x * Math.PI : 0));
      return [[0, 1, 2].map((i) => p[i] - pose[i][3]), turn];
    },
    rows: (pose, j) => {
      const z = columnOf(pose, 2), along = j[0].map((_, k) => dot(z, [j[3][k], j[4][k], j[5][k]]));
      return j.map((row, i) => (i < 3 ? row : row.map((x, k) => x - z[i - 3] * along[k])));
    },
  },
  planar: {
    frame: ([x, y, phi], arm) => {
      const zero = arm.forward(arm.joints.map(() => 0)), turn = phi - Math.atan2(zero[1][0], zero[0][0]), c = Math.cos(turn), s = Math.sin(turn);
      const first = [0, 1, 2].map((j) => c * zero[0][j] - s * zero[1][j]), second = [0, 1, 2].map((j) => s * zero[0][j] + c * zero[1][j]);
      return [[...first, x / arm.lengthScale], [...second, y / arm.lengthScale], [...zero[2], 0]];
    },
    of: (pose) => [pose[0][3], pose[1][3], Math.atan2(pose[1][0], pose[0][0])],
    error: ([x, y, phi], pose) => {
      const s = Math.sin(phi), c = Math.cos(phi), ps = pose[1][0], pc = pose[0][0];
      return [[x - pose[0][3], y - pose[1][3], 0], [0, 0, Math.atan2(s * pc - c * ps, c * pc + s * ps)]];
    },
    rows: (pose, j) => j.map((row, i) => (i < 2 || i > 4 ? row : row.map(() => 0))),
  },
};

// A frame at a point with a given z axis; x is any perpendicular direction.
function frameOfAxis(p, z) {
  const k = [0, 1, 2].reduce((b, i) => (Math.abs(z[i]) < Math.abs(z[b]) ? i : b), 0);
  let y = cross(z, [0, 1, 2].map((i) => (i === k ? 1 : 0)));
  y = y.map((v) => v / length(y));
  const x = cross(y, z);
  return [0, 1, 2].map((i) => [x[i], y[i], z[i], p[i]]);
}

// The values that steps take for what their equations leave free: choice 0 is zero everywhere, the others spread over the circle.
function sampleOf(choice) {
  const place = (step) => choice * [1, 5, 7, 11][step % 4] % 12;
  const degrees = [0, 90, 180, 270, 30, 120, 210, 300, 60, 150, 240, 330];
  const lengths = [0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1, -1, 1.5, -1.5, 2];
  return {
    angle: (step) => {
      if (place(step) === 0) return [1, 0];
      const angle = degrees[place(step)] * Math.PI / 180;
      return [Math.cos(angle), Math.sin(angle)];
    },
    length: (step) => lengths[place(step)],
  };
}

// What the steps of a run say about solutions that it may have missed. As in dh-kernels (status.rs).
class Status {
  constructor() { Object.assign(this, { degenerate: false, lost: false, grazed: false, doubt: false }); }

  // A step whose outcome is not regular; `chosen`: were values chosen before for unknowns that were free?
  note(step, chosen) {
    if (step.outcome === FREE) this.degenerate = true;
    else if (step.outcome === TOUCHING) this.grazed = true;
    else if (step.outcome !== REGULAR) {
      this.lost ||= chosen || this.grazed || justMissesARoot(step);
      this.doubt ||= mayHideARoot(step);
    }
  }
}

// What a run of the plan reports beside its candidates.
class Attempt {
  constructor() { Object.assign(this, { status: new Status(), why: { kind: "none" } }); }

  refuse(why) {
    const known = this.why;
    const nearer = known.kind === "none" || (known.kind === "reach" && why.kind === "reach" && known.unit === why.unit
      && Math.abs(why.needs - why.has) < Math.abs(known.needs - known.has));
    if (nearer) this.why = why;
  }

  // A step that is not regular; `free` are the joints for which values were chosen before.
  note(step, free, name, scale, unit) {
    this.status.note(step, free.length > 0);
    if (step.outcome === OUT_OF_REACH) this.refuse({ kind: "reach", step: name, needs: step.needed * scale, has: step.available * scale, unit });
    else if (step.outcome === NO_ROOT) this.refuse({ kind: "root", step: name });
  }

  // The same for a law of cosines: reports distances.
  noteDistance(step, free, name, [base, rest], grows, lengthScale, unit) {
    if (step.outcome !== OUT_OF_REACH) return this.note(step, free, name, 1, unit);
    this.status.note(step, free.length > 0);
    const distance = Math.sqrt(Math.max(base + rest, 0));
    const available = rest > 0 ? step.available : -step.available;
    const half = grows ? (0.5 * available) / distance : 0;
    const root = Math.sqrt(Math.max(base + (grows ? half * half : available), 0));
    const limit = distance < half ? half - root : half + root;
    this.refuse({ kind: "reach", step: name, needs: distance * lengthScale, has: Math.max(limit, 0) * lengthScale, unit });
  }
}

// All solutions of an arm for a target: { solutions: [{ q, branch, free }], why, numeric }. The values of the redundant joints are a list,
// or a number where there is one.
function solve(arm, target, values) {
  const given = [values ?? []].flat().slice(0, arm.redundant.length);
  const task = TASKS[arm.task];
  if (!finite(target.flat(2)) || given.length < arm.redundant.length || !finite(given)) return { solutions: [], why: { kind: "finite" }, numeric: false };
  if (arm.task === "pose" && !isRotation(target)) return { solutions: [], why: { kind: "rotation" }, numeric: false };
  const verifier = new Verifier(arm, task, target, given);
  if (!arm.candidates) {
    verifier.search(true);
    return { solutions: verifier.out, why: { kind: "none" }, numeric: true };
  }
  const frame = task.frame(target, arm), run = (t, choice, take) => arm.candidates(t, given, sampleOf(choice), take);
  const attempt = run(frame, 0, (q, branch, free) => verifier.take(q, branch, free));
  if (verifier.out.length === 0 || verifier.lost || attempt.status.lost) rescue(verifier, frame, attempt, run);
  let why = attempt.why;
  if (verifier.out.length === 0 && verifier.nearest < Infinity) why = { kind: arm.rankDeficient ? "task" : "verified", by: verifier.nearest };
  return { solutions: verifier.out, why, numeric: false };
}

class Verifier {
  constructor(arm, task, target, given) {
    Object.assign(this, { arm, task, target, given, out: [], nearest: Infinity, lost: false });
    this.tolerance = arm.rankDeficient ? REACHED_FEW : REACHED;
  }

  error(q) {
    const [p, r] = this.task.error(this.target, this.arm.forward(q));
    return [...p.map((x) => x / this.arm.lengthScale), ...r];
  }

  jacobian(q) {
    const j = this.arm.jacobian(q).map((row, i) => row.map((x, k) => (this.arm.redundant.includes(k) ? 0 : i < 3 ? x / this.arm.lengthScale : x)));
    return this.task.rows(this.arm.forward(q), j);
  }

  miss(q) { const m = largest(this.error(q)); return Number.isNaN(m) ? Infinity : m; }

  // The joint vector after damped Newton steps, and whether the target is reached.
  polish(q, steps) {
    const done = levenbergMarquardt(q, steps, (x) => this.error(x), (x) => this.jacobian(x));
    const off = Math.max(length(done.e.slice(0, 3)), length(done.e.slice(3)));
    if (off < this.nearest) this.nearest = off;
    return { q: done.q, reached: off <= this.tolerance };
  }

  take(q, branch, free) {
    const miss = this.miss(q);
    if (free.length > 0) return this.takeChosen(q, miss, branch);
    if (!(miss <= EXACT)) {
      this.nearest = Math.min(this.nearest, miss);
      if (!(miss < 0.5)) return;
      const polished = this.polish(q, 12);
      if (!polished.reached) return;
      q = polished.q;
    }
    this.add({ q, branch, free: [] });
  }

  takeChosen(q, miss, branch) {
    const exact = miss <= EXACT, polished = exact ? { q, reached: true } : miss < 0.5 ? this.polish(q, 12) : { q, reached: false };
    if (!polished.reached) {
      this.nearest = Math.min(this.nearest, miss);
      this.lost = true;
      return;
    }
    const free = this.freeJoints(polished.q, exact);
    this.lost ||= free.length === 0;
    this.insert(polished.q, branch, free, 0);
  }

  takeRough(q, branch, earlier) {
    const polished = this.polish(q, STEPS);
    if (polished.reached) this.insert(polished.q, branch, this.freeJoints(polished.q, false), earlier);
  }

  // Adds a solution, unless it is another point of a self-motion that is represented already.
  insert(q, branch, free, earlier) {
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
    const known = this.out.some((s, i) => (i < earlier || same(s.branch, branch)) && free.length > 0 && s.free.length > 0
      && this.apart(s.q, q).every((d, k) => s.free.includes(k) || free.includes(k) || d <= 1e-5));
    if (!known) this.add({ q, branch, free });
  }

  // How far each actuator is from one joint vector to the other, without whole turns.
  apart(a, b) {
    const { joints, drive } = this.arm;
    if (drive) return principal(drive, b.map((x, k) => x - a[k]), []).map(Math.abs);
    return joints.map((joint, k) => difference(joint, a[k], b[k]));
  }

  add(solution) {
    const { joints, drive, redundant } = this.arm;
    const known = this.out.find((s) => this.apart(s.q, solution.q).every((d) => d <= SAME));
    const q = drive ? intoRanges(drive, joints, principal(drive, solution.q, redundant)) : solution.q;
    if (known) known.free = [...new Set([...known.free, ...solution.free])].sort();
    else this.out.push({ ...solution, q: q.map((x, k) => normalized(joints[k], x)) });
  }

  // The joints that take part in motions which keep the target reached.
  freeJoints(q, exact) {
    const free = new Set();
    for (const v of this.motions(q)) {
      for (const k of exact ? v.keys() : this.movedAlong(q, v)) if (!exact || Math.abs(v[k]) > 1e-6) free.add(k);
    }
    return [...free].sort();
  }

  movedAlong(q, v) {
    const unit = this.arm.joints.map((joint) => (joint.periodic ? 0.05 : 0.05 * this.arm.lengthScale));
    for (const sign of [1, -1]) {
      const polished = this.polish(q.map((x, k) => x + sign * unit[k] * v[k]), 60);
      const far = (limit) => [...q.keys()].filter((k) => Math.abs(polished.q[k] - q[k]) / unit[k] > limit);
      if (polished.reached && far(0.1).length > 0) return far(1e-3);
    }
    return [];
  }

  // The null space of the task's Jacobian.
  motions(q) {
    const n = q.length, j = this.jacobian(q).map((row) => row.map((x, k) => (this.arm.joints[k].periodic ? x : x * this.arm.lengthScale)));
    const pivots = [];
    for (let r = 0; r < 6; r++) {
      let best = [0, 0, 0];
      for (let i = r; i < 6; i++) for (let k = 0; k < n; k++) if (Math.abs(j[i][k]) > best[0] && !pivots.includes(k)) best = [Math.abs(j[i][k]), i, k];
      const [size, i, k] = best;
      if (size < 1e-7) break;
      [j[r], j[i]] = [j[i], j[r]];
      pivots.push(k);
      for (let i = 0; i < 6; i++) {
        const factor = j[i][k] / j[r][k];
        if (i !== r && factor !== 0) j[i] = j[i].map((x, c) => x - factor * j[r][c]);
      }
    }
    const list = [];
    for (let k = 0; k < n; k++) {
      if (pivots.includes(k) || this.arm.redundant.includes(k)) continue;
      const v = Array(n).fill(0);
      v[k] = 1;
      pivots.forEach((p, r) => { v[p] = -j[r][k] / j[r][p]; });
      const size = largest(v);
      list.push(v.map((x) => x / size));
    }
    return list;
  }

  // Damped Newton steps from starts all over the joint space, until one arrives, or from all of them.
  search(all) {
    const ratios = [0.898654, 0.807579, 0.725734, 0.652184, 0.586087, 0.526690, 0.473312], { arm } = this;
    for (let start = 1; start <= (all && !arm.candidates ? 4 * STARTS : STARTS); start++) {
      const q = arm.joints.map((joint, k) => {
        if (arm.redundant.includes(k)) return this.given[arm.redundant.indexOf(k)];
        const x = start * ratios[k % 7], y = 2 * (x - Math.floor(x)) - 1;
        return joint.periodic ? y * Math.PI : y * arm.lengthScale;
      });
      const polished = this.polish(q, STEPS);
      if (!polished.reached) continue;
      this.insert(polished.q, {}, arm.candidates ? this.freeJoints(polished.q, false) : [], this.out.length);
      if (!all) return;
    }
  }
}

// Where the closed form degenerates: other values for what it left free, nearby poses, and at last a search from many starts.
function rescue(verifier, frame, first, run) {
  if (first.status.degenerate) {
    for (let choice = 1; choice < 12; choice++) {
      const earlier = verifier.out.length;
      run(frame, choice, (q, branch, free) => { if (free.length > 0) verifier.takeRough(q, branch, earlier); });
    }
  }
  if (verifier.arm.rankDeficient) {
    if (first.status.degenerate) verifier.search(true);
    return;
  }
  const motions = [[0.31, -0.77, 0.52, 0.63, 0.29, -0.71], [-0.83, 0.21, 0.47, -0.37, 0.88, 0.24], [0.59, 0.67, -0.43, 0.19, -0.53, 0.79],
    [-0.27, -0.61, -0.73, -0.91, -0.17, -0.41], [0.91, -0.13, 0.37, 0.43, 0.71, 0.57], [-0.49, 0.83, -0.23, 0.77, -0.67, 0.11]];
  for (const size of [1e-4, 1e-2]) {
    for (const motion of motions) {
      const earlier = verifier.out.length;
      run(nearby(frame, motion, size), 0, (q, branch) => verifier.takeRough(q, branch, earlier));
    }
    if (verifier.out.length > 0) return;
  }
  if (first.status.degenerate) verifier.search(false);
}

// A pose after a small motion.
function nearby(frame, motion, size) {
  let t = IDENTITY;
  for (let axis = 0; axis < 3; axis++) {
    const angle = motion[axis] * size, [j, k] = [(axis + 1) % 3, (axis + 2) % 3], r = IDENTITY.map((row) => [...row]);
    r[j][j] = r[k][k] = Math.cos(angle);
    r[j][k] = -Math.sin(angle);
    r[k][j] = Math.sin(angle);
    t = times(t, r);
  }
  return times(frame, t).map((row, i) => [row[0], row[1], row[2], frame[i][3] + motion[3 + i] * size]);
}

// Drives error(q) to zero in the sense of least squares; the damping is proportional to the square of the error.
function levenbergMarquardt(start, steps, error, jacobian) {
  const square = (e) => e.reduce((s, x) => s + x * x, 0), n = start.length;
  let q = start, e = error(q), now = square(e), weight = 1e-2;
  for (let taken = 0; taken < steps && now > 1e-30 && now < Infinity; taken++) {
    const j = jacobian(q), normal = Array.from({ length: n }, () => Array(n).fill(0)), right = Array(n).fill(0);
    j.forEach((row, r) => {
      for (let a = 0; a < n; a++) {
        right[a] += row[a] * e[r];
        for (let b = 0; b <= a; b++) normal[a][b] += row[a] * row[b];
      }
    });
    let helped = false;
    for (let attempt = 0; attempt < 12; attempt++) {
      const step = solveDamped(normal, right, weight * now), next = q.map((x, i) => x + step[i]), eNext = error(next), then = square(eNext);
      if (then < now) {
        if (then < 0.25 * now) weight *= 0.1;
        helped = then < 0.25 * now || now > 1e-26;
        [q, e, now] = [next, eNext, then];
        break;
      }
      if (now <= 1e-26) break;
      weight = weight < 1e-6 ? 1e-4 : weight * 6;
    }
    if (!helped) break;
  }
  return { q, e };
}

// (A + m I) x = b for the lower triangle of a positive semidefinite A.
function solveDamped(a, b, m) {
  const n = b.length, floor = 1e-15 * a.reduce((s, row, i) => s + row[i], 0), l = a.map(() => Array(n).fill(0)), d = [];
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < i; j++) {
      let x = a[i][j];
      for (let k = 0; k < j; k++) x -= l[i][k] * l[j][k] * d[k];
      l[i][j] = d[j] > 0 ? x / d[j] : 0;
    }
    let x = a[i][i] + m;
    for (let k = 0; k < i; k++) x -= l[i][k] * l[i][k] * d[k];
    d.push(x > floor ? x : 0);
  }
  const x = [...b];
  for (let i = 0; i < n; i++) for (let k = 0; k < i; k++) x[i] -= l[i][k] * x[k];
  for (let i = 0; i < n; i++) x[i] = d[i] > 0 ? x[i] / d[i] : 0;
  for (let i = n - 1; i >= 0; i--) for (let k = i + 1; k < n; k++) x[i] -= l[k][i] * x[k];
  return x;
}
