// The arm as a drawing: links as bars, turning joints as cylinders, sliding ones as boxes, frames as arrows; seen from far away.
const SVG = "http://www.w3.org/2000/svg";
const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const middle = (a, b) => add(a, add(b, a, -1), 0.5);
const distance = (a, b) => length(add(a, b, -1));
const unitOf = (v) => { const n = length(v); return n > 0 ? v.map((x) => x / n) : v; };

// What is to be drawn of an arm at q: bars, joints, frames.
function skeleton(arm, q) {
  const frames = [arm.base(), ...arm.links(q)], tip = arm.forward(q), bars = [], joints = [];
  const origin = (f) => columnOf(f, 3), modified = arm.convention === "modified";
  if (distance([0, 0, 0], origin(frames[0])) > 1e-9 * arm.lengthScale) bars.push({ from: [0, 0, 0], to: origin(frames[0]), part: "base" });
  for (let i = 1; i < frames.length; i++) {
    const before = frames[i - 1], after = frames[i], a = origin(before), b = origin(after);
    // The table's row goes along x by a and along z by d, in the order of its convention.
    const axis = columnOf(modified ? after : before, 2), d = dot(add(b, a, -1), axis);
    const corner = modified ? add(b, axis, -d) : add(a, axis, d);
    const along = modified ? [corner, b] : [a, corner], across = modified ? [a, corner] : [corner, b];
    const k = arm.joints.findIndex((joint) => joint.row === i - 1), prismatic = k >= 0 && arm.joints[k].prismatic;
    bars.push({ from: across[0], to: across[1], part: "a" }, { from: along[0], to: along[1], part: prismatic ? "rod" : "d" });
    if (k >= 0) joints.push({ k, prismatic, axis, at: middle(along[0], along[1]) });
  }
  const end = origin(frames[frames.length - 1]);
  if (distance(end, origin(tip)) > 1e-9 * arm.lengthScale) bars.push({ from: end, to: origin(tip), part: "tool" });
  return { bars: bars.filter((b) => distance(b.from, b.to) > 1e-9 * arm.lengthScale), joints, frames, tip, moved: distance(end, origin(tip)) > 1e-9 * arm.lengthScale };
}

// Centre and radius of what the arm can reach, by samples; and whether it stays in a horizontal plane.
function extentOf(arm, ranges) {
  const points = [[0, 0, 0]];
  let seed = 1, flat = true;
  const random = () => { seed = (seed * 16807) % 2147483647; return seed / 2147483647; };
  for (let i = 0; i < 150; i++) {
    const q = ranges.map(([least, greatest]) => least + (greatest - least) * random());
    for (const f of [...arm.links(q), arm.forward(q)]) points.push(columnOf(f, 3));
    flat &&= arm.links(q).every((f) => Math.abs(f[2][2]) > 0.999);
  }
  const low = [0, 1, 2].map((i) => Math.min(...points.map((p) => p[i]))), high = [0, 1, 2].map((i) => Math.max(...points.map((p) => p[i])));
  const centre = middle(low, high);
  flat &&= high[2] - low[2] < 1e-6 * arm.lengthScale;
  return { centre, flat, radius: Math.max(...points.map((p) => distance(p, centre)), 1e-9) };
}

class Scene {
  constructor(svg, arm, ranges) {
    Object.assign(this, { svg, arm, zoom: 1, showFrames: true, ...extentOf(arm, ranges) });
    [this.azimuth, this.elevation] = this.flat ? [-Math.PI / 2, Math.PI / 2] : [-0.9, 0.42];
    // Labels are drawn in pixels: the drawing is 600 units wide.
    svg.setAttribute("viewBox", "-300 -300 600 600");
  }

  camera() {
    const [a, e] = [this.azimuth, this.elevation];
    const toward = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)], right = [-Math.sin(a), Math.cos(a), 0];
    return { toward, right, up: cross(toward, right), scale: 0 };
  }

  // As large as the arm's usual postures allow, and smaller where this one needs more room.
  fit({ bars, frames }, arrow) {
    const ends = [...bars.flatMap((b) => [b.from, b.to]), ...frames.map((f) => columnOf(f, 3))].map((p) => add(p, this.centre, -1));
    const { right, up } = this.eye, far = Math.max(...ends.map((d) => Math.max(Math.abs(dot(d, right)), Math.abs(dot(d, up))))) + arrow;
    return this.zoom * Math.min(270 / (0.72 * this.radius), 270 / far);
  }

  draw(q, ghosts = []) {
    this.eye = this.camera();
    const body = skeleton(this.arm, q), { bars, joints, frames, tip, moved } = body, size = 1.1 * this.radius / Math.sqrt(this.zoom);
    this.eye.scale = this.fit(body, 0.15 * size);
    this.items = [];
    this.svg.textContent = "";
    this.grid();
    for (const ghost of ghosts) for (const bar of skeleton(this.arm, ghost).bars) this.line(bar.from, bar.to, "ghost", -1e6);
    for (const bar of bars) this.line(bar.from, bar.to, `bar ${bar.part}`);
    for (const joint of joints) {
      const shrink = 1 - 0.06 * joint.k, along = 0.058 * size * shrink, across = 0.036 * size * shrink;
      if (joint.prismatic) this.prism(joint.at, joint.axis, 1.3 * along, 1.1 * across, 4, "box");
      else this.prism(joint.at, joint.axis, along, across, 20, "cylinder");
    }
    this.items.sort((a, b) => a.depth - b.depth);
    for (const item of this.items) this.svg.append(item.node);
    if (this.showFrames) this.frames(moved ? [...frames, tip] : frames, moved, 0.15 * size);
  }

  screen(p) {
    const d = add(p, this.centre, -1), { right, up, toward, scale } = this.eye;
    return [scale * dot(d, right), -scale * dot(d, up), dot(d, toward)];
  }

  node(name, attributes, kind) {
    const node = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (kind) node.setAttribute("class", kind);
    return node;
  }

  polygon(points, kind) { return this.node("polygon", { points: points.map((p) => `${p[0].toFixed(1)},${p[1].toFixed(1)}`).join(" ") }, kind); }

  line(from, to, kind, depth) {
    const [a, b] = [this.screen(from), this.screen(to)], ends = { x1: a[0].toFixed(1), y1: a[1].toFixed(1), x2: b[0].toFixed(1), y2: b[1].toFixed(1) };
    const group = this.node("g", {}, kind);
    if (kind.startsWith("bar")) group.append(this.node("line", ends, "edge"));
    group.append(this.node("line", ends));
    this.items.push({ depth: depth ?? (a[2] + b[2]) / 2, node: group });
  }

  // A cylinder, or a box (four corners).
  prism(at, axis, along, across, corners, kind) {
    const u = unitOf(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), v = cross(axis, u);
    const ring = (end) => Array.from({ length: corners }, (_, i) => {
      const t = TAU * (i + 0.5) / corners;
      return add(add(add(at, axis, end * along), u, across * Math.cos(t) * (corners === 4 ? 1.3 : 1)), v, across * Math.sin(t) * (corners === 4 ? 1.3 : 1));
    });
    const near = dot(axis, this.eye.toward) >= 0 ? 1 : -1, group = this.node("g", {}, kind);
    const rings = [ring(-near), ring(near)].map((r) => r.map((p) => this.screen(p)));
    if (corners === 4) {
      for (let i = 0; i < 4; i++) {
        const face = [rings[0][i], rings[0][(i + 1) % 4], rings[1][(i + 1) % 4], rings[1][i]];
        const t = TAU * (i + 1) / 4, normal = add(u.map((x) => x * Math.cos(t)), v, Math.sin(t));
        if (dot(normal, this.eye.toward) > 0) group.append(this.polygon(face, "side"));
      }
    } else group.append(this.polygon(hull(rings.flat()), "side"));
    group.append(this.polygon(rings[1], "cap"));
    this.items.push({ depth: this.screen(at)[2] + across, node: group });
  }

  // The floor: a square grid of round steps through the base.
  grid() {
    const power = 10 ** Math.floor(Math.log10(this.radius)), step = this.radius < 2 * power ? power / 5 : power, count = Math.ceil(1.2 * this.radius / step), size = count * step;
    const centre = [Math.round(this.centre[0] / step) * step, Math.round(this.centre[1] / step) * step];
    for (let i = -count; i <= count; i++) {
      const x = centre[0] + i * step, y = centre[1] + i * step;
      for (const [a, b] of [[[x, centre[1] - size, 0], [x, centre[1] + size, 0]], [[centre[0] - size, y, 0], [centre[0] + size, y, 0]]]) {
        const [p, r] = [this.screen(a), this.screen(b)];
        this.svg.append(this.node("line", { x1: p[0].toFixed(1), y1: p[1].toFixed(1), x2: r[0].toFixed(1), y2: r[1].toFixed(1) }, "grid"));
      }
    }
  }

  // Arrows of x, y and z, with names that do not cover each other; arrows that fall together share one.
  frames(list, hasTool, size) {
    const arrows = list.flatMap((frame, i) => ["x", "y", "z"].map((letter, k) => {
      const origin = columnOf(frame, 3), name = hasTool && i === list.length - 1 ? "T" : String(i);
      const a = this.screen(origin), b = this.screen(add(origin, columnOf(frame, k), k === 1 ? 0.6 * size : size));
      return { letter, a, b, far: Math.hypot(b[0] - a[0], b[1] - a[1]), names: [name] };
    }));
    const named = [];
    for (const arrow of arrows) {
      const { letter, a, b, far } = arrow;
      this.svg.append(this.node("line", { x1: a[0].toFixed(1), y1: a[1].toFixed(1), x2: b[0].toFixed(1), y2: b[1].toFixed(1) }, `axis ${letter}`));
      if (far >= 4) {
        const [ux, uy] = [(b[0] - a[0]) / far, (b[1] - a[1]) / far];
        this.svg.append(this.polygon([[b[0] + 5 * ux, b[1] + 5 * uy], [b[0] - 3 * uy, b[1] + 3 * ux], [b[0] + 3 * uy, b[1] - 3 * ux]], `head ${letter}`));
      }
      if (letter === "y" || far < 4) continue;
      const same = named.find((n) => n.letter === letter && Math.hypot(n.b[0] - b[0], n.b[1] - b[1]) < 5);
      if (same) same.names.push(...arrow.names);
      else named.push(arrow);
    }
    const taken = [];
    for (const { letter, a, b, far, names } of named) {
      const [ux, uy] = [(b[0] - a[0]) / far, (b[1] - a[1]) / far], width = 9 + 4 * names.join(",").length;
      // Past the tip, or beside it where another name stands.
      for (const [along, aside] of [[14, 0], [14, 14], [14, -14], [26, 0], [26, 16], [26, -16], [38, 0], [-6, 14], [-6, -14]]) {
        const at = [b[0] + along * ux - aside * uy, b[1] + along * uy + aside * ux];
        if (Math.abs(at[0]) > 290 || Math.abs(at[1]) > 290 || taken.some((t) => Math.abs(t.at[0] - at[0]) < width + t.width && Math.abs(t.at[1] - at[1]) < 15)) continue;
        taken.push({ at, width });
        const text = this.node("text", { x: at[0].toFixed(1), y: (at[1] + 4).toFixed(1) }, `name ${letter}`);
        text.append(letter, this.node("tspan", { dy: 4, "font-size": 11 }));
        text.lastChild.textContent = names.join(",");
        this.svg.append(text);
        break;
      }
    }
  }
}

// The convex hull of points in the plane.
function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => list.reduce((out, p) => {
    while (out.length > 1) {
      const [a, b] = out.slice(-2);
      if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
      out.pop();
    }
    return [...out, p];
  }, []);
  return [...half(sorted).slice(0, -1), ...half(sorted.reverse()).slice(0, -1)];
}
