// The page: sliders, pose, Jacobian and solutions of one arm.
const byId = (id) => document.getElementById(id);
const make = (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) key.startsWith("on") ? node.addEventListener(key.slice(2), value) : node.setAttribute(key, value);
  node.append(...children);
  return node;
};
const DEGREE = Math.PI / 180;
// Awkward enough to be in general position; the same as in the worked example of the notes.
const EXAMPLE = [20, -35, 50, 40, -60, 75, 30, -25];

const arm = new Arm();
const inDegrees = () => byId("unit").value === "deg";
const shown = (x, places = 4) => { const text = x.toFixed(places); return /^-0\.?0*$/.test(text) ? text.slice(1) : text; };
// A joint's value as the page shows it, and back.
const display = (joint, x) => (joint.angle && inDegrees() ? x / DEGREE : x);
const value = (joint, x) => (joint.angle && inDegrees() ? x * DEGREE : x);
const unitName = (joint) => (joint.angle ? (inDegrees() ? "°" : "rad") : arm.unit);

// Where a table gives no range, an angle goes all the way round, and a slide as far as half the arm's reach.
const ranges = arm.joints.map((joint) => joint.range ?? (joint.angle ? [-Math.PI, Math.PI] : [0, 0.5 * arm.lengthScale]));
const first = arm.joints.map((joint, k) => {
  const [least, greatest] = ranges[k];
  const wanted = joint.angle ? EXAMPLE[k % EXAMPLE.length] * DEGREE : least + 0.4 * (greatest - least);
  return Math.min(Math.max(wanted, least), greatest);
});

const state = { q: first, target: null, answer: null, chosen: -1, hovered: -1 };
const scene = new Scene(byId("drawing"), arm, ranges);

function fillJoints() {
  byId("joints").replaceChildren(...arm.joints.map((joint, k) => {
    const [least, greatest] = ranges[k].map((x) => display(joint, x));
    const slide = (event) => move(k, value(joint, Number(event.target.value)));
    return make("div", { class: "joint" },
      make("label", { for: `slider${k}` }, joint.name),
      make("input", { type: "range", id: `slider${k}`, min: least, max: greatest, step: "any", oninput: slide }),
      make("input", { type: "number", id: `number${k}`, step: "any", "aria-label": joint.name, onchange: slide }),
      make("span", { class: "of" }, unitName(joint)));
  }));
}

function fillParameters() {
  const names = Object.keys(arm.parameters);
  byId("fields").hidden = names.length === 0;
  byId("parameters").replaceChildren(...names.map((name) => {
    const change = (event) => {
      const x = Number(event.target.value);
      if (event.target.value === "" || !Number.isFinite(x)) return;
      arm.parameters[name] = x;
      move();
    };
    return make("label", {}, name, make("input", { type: "number", step: "any", value: arm.parameters[name], onchange: change }));
  }));
}

// A joint is moved by hand: the pose becomes the target.
function move(k, x) {
  if (k !== undefined && Number.isFinite(x)) state.q = state.q.map((old, i) => (i === k ? x : old));
  aim(TASKS[arm.task].of(arm.forward(state.q)), state.q);
}

// Another target: all joint vectors that reach it, and the arm goes to the one that is nearest.
function aim(target, q) {
  state.target = target;
  state.answer = WANTED ? arm.inverse(target, arm.redundant.map((k) => state.q[k])) : null;
  const list = state.answer?.solutions ?? [], off = (s) => s.q.reduce((sum, x, k) => sum + difference(arm.joints[k], x, (q ?? state.q)[k]) ** 2, 0);
  state.chosen = list.reduce((best, s, i) => (best < 0 || off(s) < off(list[best]) ? i : best), -1);
  if (!q && state.chosen >= 0) state.q = list[state.chosen].q;
  if (q && state.chosen >= 0 && off(list[state.chosen]) > 1e-9) state.chosen = -1;
  show();
}

function choose(i) {
  state.chosen = i;
  state.q = state.answer.solutions[i].q;
  show();
}

function show() {
  arm.joints.forEach((joint, k) => {
    const x = display(joint, state.q[k]);
    byId(`slider${k}`).value = x;
    if (document.activeElement !== byId(`number${k}`)) byId(`number${k}`).value = shown(x, joint.angle && inDegrees() ? 2 : 4);
    byId(`number${k}`).classList.toggle("outside", !inRange(joint, state.q[k]));
  });
  const list = state.answer?.solutions ?? [], all = byId("ghosts").checked;
  const ghosts = list.filter((_, i) => i !== state.chosen && (all || i === state.hovered)).map((s) => s.q);
  scene.showFrames = byId("frames").checked;
  scene.draw(state.q, ghosts);
  const pose = arm.forward(state.q);
  fillTable("pose", [...pose, [0, 0, 0, 1]], 4);
  const jacobian = arm.jacobian(state.q);
  fillTable("jacobian", jacobian, 3);
  byId("determinant").textContent = arm.joints.length === 6 ? `det J = ${determinant(jacobian).toPrecision(4)}` : "";
  fillSolutions();
  fillTarget(pose);
}

function fillTable(id, rows, places) {
  byId(id).replaceChildren(...rows.map((row) => make("tr", {}, ...row.map((x) => make("td", { "data-value": String(x) }, shown(x, places))))));
}

// By Gauss, with row pivots.
function determinant(matrix) {
  const m = matrix.map((row) => [...row]);
  let product = 1;
  for (let k = 0; k < m.length; k++) {
    const p = m.reduce((best, row, i) => (i >= k && Math.abs(row[k]) > Math.abs(m[best][k]) ? i : best), k);
    if (p !== k) { [m[k], m[p]] = [m[p], m[k]]; product = -product; }
    product *= m[k][k];
    if (product === 0) return 0;
    for (let i = k + 1; i < m.length; i++) { const f = m[i][k] / m[k][k]; m[i] = m[i].map((x, j) => x - f * m[k][j]); }
  }
  return product;
}

const PARTS = ["shoulder", "elbow", "wrist"];

function why(reason) {
  const words = WORDS[`why ${reason.kind}`] ?? WORDS["why none"], few = (x) => Number(x).toPrecision(4);
  if (reason.kind !== "reach") return words.replace("{step}", reason.step ?? "").replace("{by}", few(reason.by ?? 0));
  const sentence = WORDS[reason.needs > reason.has ? "why far" : "why near"];
  return sentence.replace("{step}", reason.step).replace("{needs}", few(reason.needs)).replace("{has}", few(reason.has)).replaceAll("{unit}", reason.unit);
}

function fillSolutions() {
  const { answer } = state;
  if (!answer) return;
  const list = answer.solutions, inside = (s) => s.q.every((x, k) => inRange(arm.joints[k], x));
  byId("count").textContent = list.length > 0 ? WORDS.found.replace("{n}", list.length).replace("{m}", list.filter(inside).length) : why(answer.why);
  byId("red").hidden = list.every(inside);
  const places = (joint) => (joint.angle && inDegrees() ? 1 : 3);
  const parts = PARTS.filter((part) => list.some((s) => s.branch?.[part])), free = list.some((s) => s.free.length > 0);
  const head = make("tr", {}, make("th"), ...[...arm.joints.map((j) => j.name), ...parts.map((part) => WORDS[part]), ...(free ? [""] : [])].map((name) => make("th", {}, name)));
  byId("solutions").replaceChildren(...(list.length > 0 ? [head] : []), ...list.map((s, i) => {
    const cells = s.q.map((x, k) => make("td", { class: s.free.includes(k) ? "free" : inRange(arm.joints[k], x) ? "" : "outside", "data-value": String(x) },
      shown(display(arm.joints[k], x), places(arm.joints[k]))));
    cells.push(...parts.map((part) => make("td", {}, WORDS[s.branch[part]] ?? "")));
    if (free) cells.push(make("td", {}, s.free.length > 0 ? WORDS.free.replace("{q}", s.free.map((k) => arm.joints[k].name).join(", ")) : ""));
    const kind = [i === state.chosen ? "chosen" : "", inside(s) ? "" : "beyond"].join(" ");
    const row = make("tr", { class: kind, tabindex: 0, onclick: () => choose(i) }, make("td", {}, String(i + 1)), ...cells);
    row.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); choose(i); byId("solutions").rows[i + 1].focus(); } });
    row.addEventListener("mouseenter", () => hover(i));
    row.addEventListener("mouseleave", () => hover(-1));
    return row;
  }));
}

// The posture under the mouse is drawn as a shadow; the table stays.
function hover(i) {
  state.hovered = i;
  const list = state.answer?.solutions ?? [];
  const ghosts = list.filter((_, k) => k !== state.chosen && (byId("ghosts").checked || k === i)).map((s) => s.q);
  scene.draw(state.q, ghosts);
}

// The target in numbers: position, and roll, pitch, yaw (turns about the fixed x, y, z axes).
const anglesOf = (t) => {
  const pitch = Math.atan2(-t[2][0], Math.hypot(t[0][0], t[1][0]));
  return Math.abs(Math.cos(pitch)) < 1e-9 ? [0, pitch, Math.atan2(-t[0][1], t[1][1])] : [Math.atan2(t[2][1], t[2][2]), pitch, Math.atan2(t[1][0], t[0][0])];
};
const rotationOf = ([a, b, c]) => {
  const [ca, sa, cb, sb, cc, sc] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b), Math.cos(c), Math.sin(c)];
  return [[cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa], [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa], [-sb, cb * sa, cb * ca]];
};
const TARGETS = {
  pose: { names: ["x", "y", "z", "roll", "pitch", "yaw"], of: (t) => [...columnOf(t, 3), ...anglesOf(t)], to: (v) => rotationOf(v.slice(3)).map((r, i) => [...r, v[i]]) },
  position: { names: ["x", "y", "z"], of: (t) => t, to: (v) => v },
  planar: { names: ["x", "y", "phi"], of: (t) => t, to: (v) => v },
  axis: { names: ["x", "y", "z"], of: ([p]) => p, to: (v) => [v, state.target[1]] },
};

function fillTarget() {
  if (!WANTED || byId("target").contains(document.activeElement)) return;
  const { names, of, to } = TARGETS[arm.task], numbers = of(state.target), isAngle = (i) => i >= (arm.task === "planar" ? 2 : 3);
  const read = () => {
    const list = names.map((_, i) => ({ typed: byId(`target${i}`).value, shown: byId(`target${i}`).dataset.shown, x: numbers[i] }));
    if (list.some((l) => l.typed === "")) return;
    // A field that was not touched keeps all its digits.
    aim(to(list.map((l, i) => (l.typed === l.shown ? l.x : Number(l.typed) * (isAngle(i) && inDegrees() ? DEGREE : 1)))));
  };
  byId("target").replaceChildren(...names.map((name, i) => {
    const text = shown(isAngle(i) && inDegrees() ? numbers[i] / DEGREE : numbers[i], isAngle(i) && inDegrees() ? 2 : 4);
    return make("label", {}, WORDS[name] ?? name, make("input", { id: `target${i}`, type: "number", step: "any", value: text, "data-shown": text, onchange: read }));
  }));
}

// Turning and zooming.
function watchDrawing() {
  const svg = byId("drawing");
  let from = null;
  svg.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; svg.setPointerCapture(event.pointerId); });
  svg.addEventListener("pointerup", () => { from = null; });
  svg.addEventListener("pointermove", (event) => {
    if (!from) return;
    scene.azimuth -= 0.008 * (event.clientX - from[0]);
    scene.elevation = Math.min(Math.max(scene.elevation + 0.008 * (event.clientY - from[1]), -Math.PI / 2), Math.PI / 2);
    from = [event.clientX, event.clientY];
    hover(state.hovered);
  });
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    scene.zoom = Math.min(Math.max(scene.zoom * Math.exp(-0.001 * event.deltaY), 0.3), 10);
    hover(state.hovered);
  }, { passive: false });
}

for (const id of ["ghosts", "frames"]) byId(id).addEventListener("change", show);
byId("unit").addEventListener("change", () => { fillJoints(); show(); });
byId("reset").addEventListener("click", () => { state.q = first; move(); });
fillJoints();
fillParameters();
watchDrawing();
move();
