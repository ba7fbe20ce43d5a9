/* Elements of the page. Texts become text nodes, never HTML: what a file brings cannot be read as markup. */

const SVG = "http://www.w3.org/2000/svg";

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "on") for (const [event, handler] of Object.entries(value)) node.addEventListener(event, handler);
    else if (name === "data") for (const [key, v] of Object.entries(value)) node.dataset[key] = v;
    else if (name === "style") for (const [key, v] of Object.entries(value)) node.style.setProperty(key, v);
    else node.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children.flat(Infinity)) {
    if (child === undefined || child === null || child === false) continue;
    node.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return node;
}

/**
 * An element of HTML.
 * @param {string} tag
 * @param {object} [attributes] as in markup; `on`: {event: handler}, `data`: dataset, `style`: properties set by script
 * @param {...(Node|string|number|Array|null|false)} children texts are set as text
 */
export function el(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** An element of SVG, as `el`. */
export function svg(tag, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, tag), attributes, children);
}

/** A button with a text. */
export function button(text, click, attributes = {}) {
  return el("button", { type: "button", on: { click }, ...attributes }, text);
}

let count = 0;
/** A name for an element that no other has. */
export function freshId(stem) {
  count += 1;
  return `${stem}-${count}`;
}

/** Calls `f` at most once a frame, with the arguments of the last call. */
export function oncePerFrame(f) {
  let waiting = false;
  let last;
  return (...values) => {
    last = values;
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      f(...last);
    });
  };
}
