/* Several documents as one: curves of the same figure and panel stand beside each other, and below them what sets them apart. */

/** Keys of a series that name arrays. */
const ARRAYS = ["data", "error", "low", "high", "x"];

/** The series of another document, its arrays numbered behind those that stand before. */
function moved(series, base, set, x) {
  const out = { ...series, set, x: series.x ?? x };
  for (const key of ARRAYS) if (out[key] !== undefined) out[key] += base;
  return out;
}

/** The other less the first, of series of one name at the same places; null where they differ in these. */
function difference(array, first, other, xFirst, xOther) {
  const [a, b] = [array(first.data), array(other.data)];
  const [xa, xb] = [array(first.x ?? xFirst), array(other.x ?? xOther)];
  if (!xa || !xb || xa.length !== xb.length || xa.some((v, i) => v !== xb[i])) return null;
  return Float64Array.from(b, (v, i) => v - a[i]);
}

function mergePanel(panel, others, array, x) {
  const series = panel.series.map((s) => ({ ...s, set: 0 }));
  const apart = [];
  for (const { panel: other, base, set, x: otherX } of others)
    for (const s of other.series) {
      const here = moved(s, base, set, otherX);
      series.push(here);
      const same = panel.series.find((f) => f.name === s.name && !f.hidden);
      const data = same ? difference(array, same, here, x, otherX + base) : null;
      if (data) apart.push({ name: s.name, set, data, mark: "line" });
    }
  const out = [{ ...panel, series }];
  if (apart.length > 0)
    out.push({ name: `${panel.name}: less the first`, unit: panel.unit, scale: "linear", zero: true, series: apart });
  return out;
}

function mergeFigure(figure, others, array) {
  if (figure.kind !== "axes") return figure;
  const same = others.flatMap(({ document, base, set }) => {
    const found = document.sections.flatMap((s) => s.figures).find((f) => f.kind === "axes" && f.id === figure.id);
    return found ? [{ figure: found, base, set }] : [];
  });
  const panels = figure.panels.flatMap((panel) => {
    const beside = same.flatMap(({ figure: f, base, set }) => {
      const found = f.panels.find((p) => p.name === panel.name);
      return found && !panel.stacked ? [{ panel: found, base, set, x: f.x.data }] : [];
    });
    return mergePanel(panel, beside, array, figure.x.data);
  });
  return { ...figure, panels, file: undefined };
}

/** Facts that differ are told of each. */
function mergeFacts(facts, others, sets) {
  return facts.map((fact) => {
    const values = [fact.value, ...others.map((o) => o.document.facts?.find((f) => f.name === fact.name)?.value ?? "–")];
    if (values.every((v) => v === values[0])) return fact;
    return { name: fact.name, value: values.map((v, i) => `${sets[i].name}: ${v}`).join("; ") };
  });
}

/**
 * One document of several; the first has the say where only one can stand.
 * @param {object[]} documents @param {string[]} names of each
 * @param {(index: any) => ArrayLike<number>} array reads numbers of all, one document's behind the other's
 */
export function beside(documents, names, array) {
  const sets = names.map((name) => ({ name }));
  let base = documents[0].arrays.length;
  const others = documents.slice(1).map((document, i) => {
    const here = { document, base, set: i + 1 };
    base += document.arrays.length;
    return here;
  });
  const [first] = documents;
  return {
    ...first,
    title: names.join(" beside "),
    command: documents.map((d) => d.command).join("; "),
    sets,
    facts: mergeFacts(first.facts ?? [], others, sets),
    sections: first.sections.map((s) => ({ ...s, figures: s.figures.map((f) => mergeFigure(f, others, array)) })),
  };
}
