// Uses the page as a reader would, and writes down what it shows: one JSON document in an element of its own.
(() => {
  const report = {}, byId = (id) => document.getElementById(id);
  const fire = (node, kind) => node.dispatchEvent(new Event(kind, { bubbles: true }));
  const numbers = (selector) => [...document.querySelectorAll(selector)].map((cell) => Number(cell.dataset.value));
  const rows = () => [...document.querySelectorAll("#solutions tr[tabindex]")];
  const look = () => ({
    q: [...document.querySelectorAll("#joints input[type=range]")].map((slider) => Number(slider.value)),
    pose: numbers("#pose td"),
    jacobian: numbers("#jacobian td"),
    solutions: rows().map((row) => [...row.querySelectorAll("td[data-value]")].map((cell) => Number(cell.dataset.value))),
    chosen: rows().findIndex((row) => row.classList.contains("chosen")),
    drawn: byId("drawing").querySelectorAll("line, polygon").length,
    text: byId("count")?.textContent ?? "",
  });
  const step = (name, action) => { action(); report[name] = look(); };
  try {
    step("start", () => {});
    step("radians", () => { byId("unit").value = "rad"; fire(byId("unit"), "change"); });
    step("slider", () => { byId("slider0").value = 0.75; fire(byId("slider0"), "input"); });
    report.clicks = rows().map((_, i) => { rows()[i].click(); return look(); });
    step("ghosts", () => { byId("ghosts").checked = true; fire(byId("ghosts"), "change"); });
    step("far", () => { byId("target0").value = 100; fire(byId("target0"), "change"); });
    report.formulas = document.querySelectorAll(".formulas math").length;
    // An element of MathML that the browser lays out has a size.
    report.laidOut = document.querySelector(".formulas mtable").getBoundingClientRect().height > 20;
    // Nothing of the arm leaves the drawing.
    const frame = byId("drawing").getBoundingClientRect();
    report.inside = [...byId("drawing").querySelectorAll(".bar, .cylinder, .box")].every((node) => {
      const box = node.getBoundingClientRect();
      return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
    });
    report.requests = performance.getEntriesByType("resource").length;
  } catch (error) { report.error = String(error.stack ?? error); }
  const out = document.createElement("pre");
  out.id = "report";
  out.textContent = JSON.stringify(report);
  document.body.append(out);
})();
