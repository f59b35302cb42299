// What the compiler wrote as HTML becomes elements: those it is known to write, with the attributes it is known to write. Anything else is
// shown as the text that it holds. (It escapes names and comments; this is the second lock, the page's content policy the third.)

const ELEMENTS = new Set(("h1 h2 h3 h4 h5 p ul ol li table thead tbody tr th td pre code em strong div figure figcaption "
  + "svg title polyline polygon circle text tspan "
  + "math mrow mi mn mo mtext mspace msub msup msubsup mfrac msqrt mover munder mmultiscripts mprescripts none mtable mtr mtd").split(" "));
const ATTRIBUTES = new Set(("class style xmlns display displaystyle mathvariant stretchy form width height viewbox role points fill stroke "
  + "stroke-width stroke-dasharray stroke-linecap stroke-linejoin font-family font-size font-style cx cy r x y dy text-anchor paint-order "
  + "columnalign lspace rspace linethickness").split(" "));

function elements(html) {
  const parsed = new DOMParser().parseFromString(html, "text/html");
  const out = document.createDocumentFragment();
  for (const node of parsed.body.childNodes) out.append(copied(node));
  return out;
}

function copied(node) {
  if (node.nodeType === Node.TEXT_NODE) return document.createTextNode(node.data);
  if (node.nodeType !== Node.ELEMENT_NODE) return document.createTextNode("");
  if (!ELEMENTS.has(node.localName)) return document.createTextNode(node.textContent);
  const out = document.createElementNS(node.namespaceURI, node.localName);
  for (const { name, value } of node.attributes) if (ATTRIBUTES.has(name.toLowerCase())) out.setAttribute(name, value);
  for (const child of node.childNodes) out.append(copied(child));
  return out;
}

// An element with attributes, listeners (`onclick`) and children.
function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    else if (value !== false) node.setAttribute(key, value === true ? "" : value);
  }
  node.append(...children);
  return node;
}

const byId = (id) => document.getElementById(id);
