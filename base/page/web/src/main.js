/* Reads the document of the page and lays it out: title, facts, contents, sections with their figures. */
import "./style.css";
import "uplot/dist/uPlot.min.css";
import { Clock, clockKey } from "./clock.js";
import { readDocument } from "./document.js";
import { button, el } from "./dom.js";
import { createFigure } from "./figure.js";
import { chooseTheme, startTheme, themeChoice } from "./theme.js";

const LEVELS = { good: ["✓", "good"], warning: ["!", "look closer"], bad: ["✕", "bad"] };
const THEMES = ["auto", "light", "dark"];

function level(section) {
  const known = Object.hasOwn(LEVELS, section.level ?? "") ? LEVELS[section.level] : null;
  if (!known) return null;
  return el("span", { class: `level ${section.level}` }, el("span", { "aria-hidden": "true" }, `${known[0]} `), known[1]);
}

function themeButton() {
  const label = () => `Colours: ${themeChoice()}`;
  const node = button(label(), () => {
    chooseTheme(THEMES[(THEMES.indexOf(themeChoice()) + 1) % THEMES.length]);
    node.textContent = label();
  });
  return node;
}

function head(doc) {
  return el(
    "header",
    { class: "page-head" },
    el("p", { class: "program" }, doc.program ?? "umbra", doc.command ? el("code", {}, doc.command) : null),
    el("h1", {}, doc.title ?? ""),
    [doc.lead ?? []].flat().map((text, i) => el("p", { class: i === 0 ? "lead first" : "lead" }, text)),
    doc.facts?.length > 0
      ? el("dl", { class: "facts" }, doc.facts.map((f) => el("div", {}, el("dt", {}, f.name), el("dd", {}, f.value))))
      : null,
    doc.sets?.length > 1 ? el("p", { class: "sets" }, `Beside each other: ${doc.sets.map((s) => s.name).join(", ")}`) : null,
  );
}

function contents(sections) {
  return el(
    "nav",
    { class: "contents", "aria-label": "Questions" },
    el("ol", {}, sections.map((s, i) => el("li", {}, el("a", { href: `#section-${i + 1}` }, s.question ?? s.id)))),
  );
}

/** Marks in the contents the section that is read. */
function follow(nav, sections) {
  const links = [...nav.querySelectorAll("a")];
  const seen = new Set();
  const watch = new IntersectionObserver(
    (entries) => {
      for (const e of entries) seen[e.isIntersecting ? "add" : "delete"](e.target);
      const first = sections.findIndex((s) => seen.has(s));
      links.forEach((a, i) => (i === first ? a.setAttribute("aria-current", "true") : a.removeAttribute("aria-current")));
    },
    { rootMargin: "-10% 0px -60% 0px" },
  );
  for (const s of sections) watch.observe(s);
}

/** Lays the page out, then draws: a drawing takes the width of its place. */
function layOut(page) {
  const doc = page.document;
  const sections = doc.sections ?? [];
  const figures = [];
  const nodes = sections.map((s, i) => {
    const own = (s.figures ?? []).map((f) => createFigure(f, page));
    figures.push(...own);
    return el(
      "section",
      { id: `section-${i + 1}`, tabindex: "-1", "aria-labelledby": `question-${i + 1}`, data: { id: s.id } },
      el("h2", { id: `question-${i + 1}` }, s.question ?? s.id, level(s)),
      [s.text ?? []].flat().map((t) => el("p", { class: "section-text" }, t)),
      own.map((f) => f.node),
    );
  });
  const nav = contents(sections);
  const print = button("Print", () => window.print());
  const app = el(
    "div",
    { class: "page", id: "umbra-page" },
    el("a", { class: "skip", href: "#umbra-main" }, "Skip to the results"),
    el("div", { class: "bar-top" }, el("span", { class: "bar-title" }, doc.title ?? ""), themeButton(), print),
    el("div", { class: "columns" }, nav, el("main", { id: "umbra-main", tabindex: "-1" }, head(doc), nodes, el("footer", {}, footer(doc)))),
  );
  document.getElementById("umbra-static")?.remove();
  document.body.prepend(app);
  document.title = doc.title ?? document.title;
  follow(nav, nodes);
  return figures.map((f) => f.draw());
}

function footer(doc) {
  return [
    el("p", {}, `Made by ${doc.program ?? "umbra"}. This file holds all its numbers and needs no network.`),
    el("p", {}, "Keys: arrows step the time, Shift makes ten steps, + and − zoom a plot that has the focus, Escape shows all."),
  ];
}

function complain(error) {
  console.error(error);
  document.body.prepend(el("p", { class: "failed", role: "alert" }, `The drawings of this page could not be made: ${error.message}. What stands below needs no script.`));
}

async function start() {
  startTheme();
  const { document: doc, array } = await readDocument();
  const clock = new Clock();
  const figures = layOut({ document: doc, array, clock });
  // Keys that nothing else takes step the time.
  document.addEventListener("keydown", (e) => {
    const free = e.target === document.body || e.target.id === "umbra-main" || e.target.tagName === "SECTION";
    if (free && (e.key === "ArrowLeft" || e.key === "ArrowRight")) clockKey(clock, e);
  });
  return {
    document: doc,
    array,
    clock,
    figures: figures.map((f) => f.id),
    /** What a figure draws, for tests and for who looks under the hood. */
    figure: (id) => figures.find((f) => f.id === id) ?? null,
  };
}

window.umbra = { ready: null };
window.umbra.ready = start().then((page) => Object.assign(window.umbra, page));
window.umbra.ready.catch(complain);
