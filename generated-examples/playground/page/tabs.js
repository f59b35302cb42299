// The tabs: what each asks the compiler, and what it shows of the answer.

// A button that copies a text.
const copier = (text, label) => make("button", { type: "button", onclick: (event) => copy(text, event.currentTarget) }, label);
const FORMATS = { latex: "LaTeX", typst: "Typst", markdown: "Markdown" };
const copiers = (piece) => make("div", { class: "copy" }, make("span", {}, word("copy")), ...Object.entries(FORMATS).map(([key, name]) => copier(piece[key], name)));
const article = (html) => { const node = make("article"); node.append(elements(html)); return node; };

// A mistake or a reason as an item of a list.
const reasons = (list) => make("ul", {}, ...list.map((m) => {
  const item = make("li", {});
  item.append(quoted(m.message));
  if (m.help) item.append(make("div", { class: "note" }, quoted(m.help)));
  return item;
}));

const TABS = {
  arm: {
    async show(panel, ask) {
      const { html, mistakes } = await ask("page");
      if (mistakes) return panel.replaceChildren(reasons(mistakes));
      const name = byId("table").dataset.name;
      const save = make("button", { type: "button", onclick: () => download(`${name}.html`, html, "text/html") }, word("page"));
      panel.replaceChildren(make("div", { class: "tools" }, save), frame(html));
    },
  },
  formulas: {
    async show(panel, ask) {
      const { sections } = await ask("formulas");
      panel.replaceChildren(...sections.map((piece) => {
        const node = article(piece.html);
        node.prepend(copiers(piece));
        return node;
      }));
    },
  },
  notes: {
    async show(panel, ask) {
      const { title, html } = await ask("notes");
      const kinds = { latex: "tex", typst: "typ", markdown: "md", html: "html", text: "txt" }, names = { ...FORMATS, html: "HTML", text: "text" };
      const select = make("select", { "aria-label": word("download") }, ...Object.keys(kinds).map((key) => make("option", { value: key }, names[key])));
      const print = async (use) => use((await ask("print", { format: select.value })).text);
      const save = make("button", { type: "button", onclick: () => print((text) => download(`${byId("table").dataset.name}.${kinds[select.value]}`, text, "text/plain")) }, word("download"));
      const take = make("button", { type: "button", onclick: (event) => { const button = event.currentTarget; print((text) => copy(text, button)); } }, word("copy"));
      const node = article(html);
      node.prepend(make("h1", {}, title));
      panel.replaceChildren(make("div", { class: "tools" }, select, take, save), node);
    },
  },
  plan: {
    async show(panel, ask) {
      const plan = await ask("plan");
      if (plan.mistakes) return panel.replaceChildren(make("p", {}, word("no plan")), reasons(plan.mistakes));
      const node = article(plan.html), bar = copiers(plan);
      bar.append(copier(plan.mermaid, "Mermaid"));
      node.prepend(bar, make("p", {}, word("solutions").replace("{}", plan.solutions)));
      panel.replaceChildren(node);
    },
  },
  code: {
    async show(panel, ask) {
      const table = byId("table").value, call = rust(table, byId("table").dataset.name);
      const listing = (title, text) => make("section", {}, make("h3", {}, title), make("div", { class: "copy" }, copier(text, word("copy"))), make("pre", { class: "code", tabindex: 0 }, text));
      panel.replaceChildren(listing(word("in your crate"), call));
      const { expansion, mistakes } = await ask("code");
      panel.append(mistakes ? reasons(mistakes) : listing(word("expansion"), expansion));
    },
  },
  derivation: {
    async show(panel, ask) {
      const area = make("textarea", { id: "derivation", spellcheck: "false", "aria-label": word("derivation"), rows: 10 }), list = make("div", { id: "lines" });
      area.value = TABS.derivation.text;
      const check = async () => {
        TABS.derivation.text = area.value;
        const found = await ask("derivation", { text: area.value });
        if (found.mistakes) return list.replaceChildren(reasons(found.mistakes));
        list.replaceChildren(...lines(found.lines, area));
        if (found.lines.length === 0 && area.value.trim() !== "") list.append(make("p", { class: "note" }, word("no lines")));
        if (found.table) list.append(make("h3", {}, word("in the table")), ...lines(found.table, byId("table")));
      };
      let timer = 0;
      const later = () => { clearTimeout(timer); timer = setTimeout(() => attempt(check), 250); };
      area.addEventListener("input", later);
      const fill = (text) => { area.value = text; attempt(check); };
      const own = async () => fill((await ask("formulas")).sections.map((piece) => piece.latex).join("\n"));
      panel.replaceChildren(make("p", {}, word("paste")),
        make("div", { class: "tools" },
          make("button", { type: "button", id: "own", onclick: () => attempt(own) }, word("own formulas")),
          make("button", { type: "button", onclick: () => fill("") }, word("clear"))),
        area, list);
      await check();
    },
    text: "",
  },
};

// The lines of a derivation with what was found; a click selects the line.
function lines(list, area) {
  return list.map(({ line, finding, text, details }) => {
    const name = word(finding === "wrong" ? "is wrong" : finding);
    const go = () => {
      const all = area.value.split("\n"), from = all.slice(0, line - 1).reduce((n, l) => n + l.length + 1, 0);
      area.focus();
      area.setSelectionRange(from, from + (all[line - 1] ?? "").length);
    };
    return make("div", { class: `line ${finding}` },
      make("div", { class: "head" }, make("span", { class: "badge" }, name), make("button", { type: "button", onclick: go }, word("line").replace("{}", line))),
      make("pre", {}, [text, ...details].join("\n")));
  });
}

// What one writes into a program of one's own.
function rust(table, name) {
  const body = table.trimEnd().split("\n").map((line) => (line === "" ? "" : `    ${line}`)).join("\n");
  return `// Cargo.toml: dh-robot = "0.1"\nuse dh_robot::dh_robot;\n\ndh_robot! {\n${body}\n}\n\n// ${name} has forward, frames, jacobian and inverse: see its documentation, \`cargo doc --open\`.\n`;
}

// The interactive page in a frame of its own: another origin, no network, scripts only those that it was made of.
function frame(html) {
  const page = new DOMParser().parseFromString(html, "text/html");
  const script = page.querySelector("body > script"), text = script.textContent;
  script.textContent = byId("boot").textContent;
  const policy = page.createElement("meta");
  policy.httpEquiv = "Content-Security-Policy";
  policy.content = document.querySelector("meta[http-equiv]").content;
  page.head.prepend(policy);
  // The page knows light colours only.
  page.documentElement.style.colorScheme = "light";
  const node = make("iframe", { sandbox: "allow-scripts", title: word("arm"), srcdoc: `<!DOCTYPE html>${page.documentElement.outerHTML}` });
  node.addEventListener("load", () => node.contentWindow.postMessage(text, "*"), { once: true });
  return node;
}
