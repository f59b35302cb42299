// The page: from a keystroke to what the chosen tab shows.

const EXAMPLES = JSON.parse(byId("examples").textContent);
const editor = new Editor(byId("table"), byId("backdrop"), byId("mistakes"));
const stored = (key) => { try { return localStorage.getItem(key); } catch { return null; } };
const store = (key, value) => { try { localStorage.setItem(key, value); } catch { /* no storage: nothing is kept */ } };
let compiler = null, tab = "arm", turn = 0, shownTab = null;

// Asks about the table as it stands; of a later table's turn nothing is shown any more.
function asker(mine) {
  const table = editor.text;
  return async (ask, more = {}) => {
    const answer = await compiler.ask({ ask, table, language, ...more });
    if (mine !== turn) throw new Stopped("dropped");
    return answer;
  };
}

// Runs something that asks; what was stopped is said, what was dropped is not.
async function attempt(action) {
  try {
    await action();
  } catch (error) {
    if (!(error instanceof Stopped)) throw error;
    if (error.why === "dropped") return;
    shownTab = null;
    byId("panel").classList.remove("stale");
    byId("panel").replaceChildren(make("p", { class: "stopped" }, word(error.why)), make("button", { type: "button", onclick: refresh }, word("again")));
    document.body.dataset.done = turn;
  }
}

function refresh() {
  const mine = ++turn, ask = asker(mine), panel = byId("panel"), done = () => { document.body.dataset.done = mine; };
  document.body.dataset.turn = mine;
  compiler.drop();
  return attempt(async () => {
    const table = await ask("table");
    const bad = table.mistakes ?? [];
    editor.show(bad, "wrong");
    byId("edit").classList.toggle("bad", bad.length > 0);
    panel.classList.toggle("stale", bad.length > 0);
    if (bad.length > 0) {
      byId("summary").textContent = bad.length === 1 ? word("wrong one") : word("wrong").replace("{n}", bad.length);
      panel.dataset.stale = word("stale");
      if (shownTab !== tab) { shownTab = null; panel.classList.remove("stale"); panel.replaceChildren(make("p", {}, word("nothing"))); }
      return done();
    }
    byId("table").dataset.name = table.name;
    const summary = word("fine").replace("{name}", table.name).replace("{rows}", table.rows).replace("{joints}", table.joints);
    byId("summary").textContent = summary;
    await TABS[tab].show(panel, ask);
    shownTab = tab;
    panel.dataset.shown = `${tab} ${mine}`;
    const { mistakes } = await ask("inverse");
    editor.show(mistakes ?? [], "doubtful");
    if (mistakes) byId("summary").textContent = `${summary}; ${word("doubtful")}`;
    done();
  });
}

function choose(name, focus) {
  tab = name;
  for (const node of byId("tabs").children) {
    const chosen = node.id === `tab-${name}`;
    node.setAttribute("aria-selected", chosen);
    node.tabIndex = chosen ? 0 : -1;
    if (chosen && focus) node.focus();
    if (chosen) node.scrollIntoView({ block: "nearest", inline: "nearest" });
  }
  const panel = byId("panel");
  panel.setAttribute("aria-labelledby", `tab-${name}`);
  panel.className = name;
  panel.replaceChildren();
  panel.scrollTop = 0;
  shownTab = null;
  return refresh();
}

function fillTabs() {
  const names = Object.keys(TABS);
  byId("tabs").replaceChildren(...names.map((name, k) => {
    const node = make("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": "panel", onclick: () => choose(name) }, word(name));
    node.addEventListener("keydown", (event) => {
      const to = { ArrowRight: k + 1, ArrowLeft: k - 1 + names.length, Home: 0, End: names.length - 1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      choose(names[to % names.length], true);
    });
    return node;
  }));
}

function fillExamples() {
  const option = ({ id, title }) => make("option", { value: id }, title);
  const group = (kind) => make("optgroup", { label: word(kind) }, ...EXAMPLES.filter((e) => e.kind === kind).map(option));
  const chosen = byId("example").value;
  byId("example").replaceChildren(make("option", { value: "", hidden: true }, word("own")), group("robots"), group("lectures"));
  byId("example").value = chosen;
}

function load(id) {
  const example = EXAMPLES.find((e) => e.id === id);
  if (!example) return;
  byId("example").value = id;
  editor.text = example.table;
  byId("table").scrollTop = 0;
  if (location.hash) history.replaceState(null, "", "#");
  return refresh();
}

function speak(chosen) {
  language = chosen;
  byId("language").value = chosen;
  store("dh.language", chosen);
  translate();
  fillExamples();
  fillTabs();
}

function colour(theme) {
  byId("theme").value = theme;
  store("dh.theme", theme);
  document.documentElement.style.colorScheme = theme === "auto" ? "light dark" : theme;
}

// A question that takes longer is shown with a button to stop it.
let ticking = 0;
function busy(since) {
  clearInterval(ticking);
  byId("busy").hidden = true;
  if (since === null) return;
  ticking = setInterval(() => {
    const seconds = (performance.now() - since) / 1000;
    byId("busy").hidden = seconds < 0.4;
    byId("busytext").textContent = word("working").replace("{}", seconds.toFixed(1));
  }, 200);
}

function listen() {
  let timer = 0;
  byId("table").addEventListener("input", () => {
    byId("example").value = "";
    clearTimeout(timer);
    // A new drawing for every letter would flicker.
    timer = setTimeout(refresh, tab === "arm" ? 300 : 0);
  });
  byId("example").addEventListener("change", (event) => load(event.target.value));
  byId("language").addEventListener("change", (event) => { speak(event.target.value); choose(tab); });
  byId("theme").addEventListener("change", (event) => { colour(event.target.value); if (tab === "arm") refresh(); });
  byId("stop").addEventListener("click", () => compiler.restart("stopped"));
  byId("save").addEventListener("click", () => download(`${byId("table").dataset.name ?? "arm"}.dh`, editor.text, "text/plain"));
  byId("open").addEventListener("click", () => byId("file").click());
  byId("file").addEventListener("change", async (event) => {
    const [file] = event.target.files;
    if (!file) return;
    if (file.size > LONGEST_LINK) { byId("summary").textContent = word("not read"); return; }
    editor.text = await file.text();
    byId("example").value = "";
    event.target.value = "";
    refresh();
  });
  byId("link").addEventListener("click", async (event) => {
    const button = event.currentTarget;
    location.hash = await toFragment(editor.text);
    copy(location.href, button);
  });
  addEventListener("hashchange", followLink);
}

// The table of the address, where it is another one than in the editor.
async function followLink() {
  const text = await fromFragment(location.hash);
  if (text === null || text === editor.text) return text !== null;
  editor.text = text;
  byId("example").value = "";
  refresh();
  return true;
}

async function begin() {
  colour(stored("dh.theme") ?? "auto");
  speak(stored("dh.language") ?? (navigator.language.startsWith("zh") ? "zh" : "en"));
  const linked = await fromFragment(location.hash);
  editor.text = linked ?? EXAMPLES[0].table;
  byId("example").value = linked === null ? EXAMPLES[0].id : "";
  listen();
  compiler = new Compiler(await unpack(byId("module").textContent), byId("worker").textContent, busy);
  choose("arm");
}

begin();
