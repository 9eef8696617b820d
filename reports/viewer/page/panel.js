// Everything beside the canvas: summary, remarks, card, list of edits, layers, figures.

/** "path_m" is "path", in metres; "tool_up_m2" in square metres. */
function figureText([name, value]) {
  const units = [["_per_m", " /m"], ["_m2", " m²"], ["_rad", " rad"], ["_m", " m"], ["_s", " s"]];
  const unit = units.find(([ending]) => name.endsWith(ending));
  const label = (unit ? name.slice(0, -unit[0].length) : name).replaceAll("_", " ");
  const digits = Number.isInteger(value) || Math.abs(value) >= 100 ? value.toFixed(0) : value.toPrecision(4);
  const text = unit && unit[0] === "_s" ? minutes(value) : Number(digits) + (unit ? unit[1] : "");
  return [label, text];
}

function fillSummary() {
  const box = wholeBox, size = `${(box.right - box.left).toFixed(1)} × ${(box.top - box.bottom).toFixed(1)} m`;
  const sum = legs.reduce((total, leg) => total + leg.length, 0);
  const off = legs.reduce((total, leg) => total + (leg.tool ? 0 : leg.length), 0);
  const parts = legs.length ? [`path ${metres(sum)}, of which ${metres(off)} with the tool off`,
                               `${minutes(totalTime)}\u00a0${totalTime < 3600 ? "min" : "h"}`] : ["no path"];
  if (editable) parts.push(`${shapes.length} ${shapes.length === 1 ? "element" : "elements"}`);
  byId("title").textContent = fileName;
  const note = data.flaw ? ["not a valid path, see remarks"] : data.remarks.length ? ["see remarks"] : [];
  byId("summary").textContent = [...parts, size, ...note].join(" · ");
}

function fillLayers() {
  const mark = (kind, paint) => create("i", {style: `border-top-style: ${kind}; border-top-color: ${paint}`});
  const row = (key, text, sign) => create("label", {}, create("input", {
    type: "checkbox", checked: app.layers[key], name: key,
    onchange: event => {
      app.layers[key] = event.target.checked;
      app.redraw(true);
    }}), sign, text);
  byId("layers").replaceChildren(
      ...(editable ? [row("drawing", "Drawing", mark("solid", "var(--ink)"))] : []),
      row("path", "Path, tool on", mark("solid", "var(--path)")),
      row("connections", editable ? "Connections, tool off" : "Transit, tool off", mark("dashed", "var(--transit)")),
      ...(editable ? [row("edits", "Edits", mark("solid", "var(--edit)"))] : []),
      ...data.traces.map((trace, i) => row("trace" + i, "Stage: " + trace.name, mark("solid", traceColour(i)))));
}

function fillFigures() {
  byId("notes").hidden = !data.flaw && !data.remarks.length;
  byId("flaw").textContent = data.flaw ? `Not a valid path: ${data.flaw}` : "";
  byId("remarks").replaceChildren(...data.remarks.map(sentence => create("li", {}, sentence)));
  byId("figures").replaceChildren(...data.figures.map(figureText).map(
      ([label, value]) => create("tr", {}, create("td", {}, label), create("td", {}, value))));
}

function fillEdits() {
  const {edits} = app;
  byId("edits").replaceChildren(...edits.list.map(edit => create("li", {}, create("span", {}, editText(edit)),
      button("Delete", () => edits.remove(edit), {ariaLabel: `Delete: ${editText(edit)}`}))));
  const same = edits.list.length === edits.planned.length && edits.list.every((edit, i) => edit === edits.planned[i]);
  byId("edits-note").textContent = !edits.list.length && same ? "None. The tools above the drawing make them." :
      same ? "The path obeys these edits." : "The path does not know these edits yet: save them and plan again.";
  byId("undo").disabled = !edits.history.length;
  byId("save").disabled = same && !edits.list.length;
}

function fillCard() {
  const lines = app.tool.card();
  byId("card").replaceChildren(...lines);
}

function showButtons() {
  const press = (node, pressed) => node.setAttribute("aria-pressed", pressed);
  for (const node of document.querySelectorAll("[data-view]")) press(node, node.dataset.view === app.view);
  for (const node of document.querySelectorAll("[data-tool]")) press(node, app.tools[node.dataset.tool] === app.tool);
}

/** On a small screen the panel covers the drawing. */
function showDetails(shown) {
  document.body.classList.toggle("details", shown);
  byId("details").setAttribute("aria-expanded", shown);
}

function showScale() {
  const wanted = 90 / app.sight.scale, power = 10 ** Math.floor(Math.log10(wanted));
  const length = [5, 2, 1].map(m => m * power).find(l => l <= wanted);
  byId("scale").style.width = `${length * app.sight.scale}px`;
  byId("scale").firstChild.textContent = length >= 1 ? `${length} m` : `${Math.round(length * 1000) / 10} cm`;
}
