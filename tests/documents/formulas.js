// Renders every formula of the Markdown documents of a folder with KaTeX; warnings are errors.
"use strict";
const fs = require("fs");
const path = require("path");
const katex = require(process.env.KATEX || "katex");

const folder = process.argv[2];
let formulas = 0;
let bad = 0;
const files = fs.readdirSync(folder).filter((name) => name.endsWith(".md")).sort();
for (const name of files) {
  const text = fs.readFileSync(path.join(folder, name), "utf8").replace(/<svg[^]*?<\/svg>/g, "").replace(/\\\$/g, "");
  for (const [whole, display, inline] of text.matchAll(/\$\$([^]*?)\$\$|\$([^$\n]*)\$/g)) {
    formulas += 1;
    try {
      katex.renderToString(display || inline, { displayMode: Boolean(display), strict: (code) => (code === "unicodeTextInMathMode" ? "ignore" : "error") });
    } catch (error) {
      bad += 1;
      console.log(`${name}: ${error.message}: ${whole.slice(0, 120)}`);
    }
  }
}
console.log(`katex: ${formulas - bad} formulas of ${files.length} documents`);
process.exit(bad ? 1 : 0);
