// The table as text: mistakes underlined at their cells, listed below, a click goes there.

class Editor {
  constructor(area, backdrop, list) {
    Object.assign(this, { area, backdrop, list, marks: [] });
    area.addEventListener("scroll", () => this.follow());
    area.addEventListener("input", () => this.paint());
  }

  get text() { return this.area.value; }
  set text(text) { this.area.value = text; this.show([], ""); }

  follow() {
    this.backdrop.scrollTop = this.area.scrollTop;
    this.backdrop.scrollLeft = this.area.scrollLeft;
  }

  // Where a mistake stands: lines and columns count characters, strings in a browser count halves of some.
  range({ line, column, length }) {
    if (line === 0) return null;
    const text = this.area.value;
    let from = 0;
    for (let k = 1; k < line; k++) {
      from = text.indexOf("\n", from) + 1;
      if (from === 0) return null;
    }
    const end = text.indexOf("\n", from), row = [...text.slice(from, end < 0 ? text.length : end)];
    const before = row.slice(0, column - 1).join("").length;
    return [from + before, from + before + row.slice(column - 1, column - 1 + length).join("").length];
  }

  // Mistakes (`kind` is `wrong`), or what is in the way of an inverse (`kind` is `doubtful`).
  show(mistakes, kind) {
    this.marks = mistakes.map((m) => ({ ...m, kind, range: this.range(m) }));
    this.paint();
    this.list.replaceChildren(...this.marks.map((m) => make("li", { class: kind },
      make("button", { type: "button", onclick: () => this.go(m) }, m.line > 0 ? word("line").replace("{}", m.line) : word("whole")),
      " ", quoted(m.message), ...(m.help ? [make("div", { class: "note" }, quoted(m.help))] : []))));
  }

  go({ range }) {
    this.area.focus();
    if (range) this.area.setSelectionRange(...range);
  }

  // The text once more behind the text, invisible but for the underlines. While one types they stay at their lines until the compiler
  // has answered.
  paint() {
    const text = this.area.value, out = document.createDocumentFragment();
    const places = this.marks.filter((m) => m.range).sort((a, b) => a.range[0] - b.range[0]);
    let at = 0;
    for (const { range: [from, to], kind, message } of places) {
      if (from < at || to > text.length) continue;
      out.append(text.slice(at, from), make("mark", { class: kind, title: message }, text.slice(from, to) || " "));
      at = to;
    }
    out.append(text.slice(at) + "\n");
    this.backdrop.replaceChildren(out);
    this.follow();
  }
}

// A sentence with names between backticks.
function quoted(sentence) {
  const out = document.createDocumentFragment();
  sentence.split("`").forEach((piece, k) => out.append(k % 2 === 1 ? make("code", {}, piece) : piece));
  return out;
}
