// What the page shows now, and who is told when that changes.
const app = {
  view: "outline",
  time: totalTime,
  chosen: null,      // a shape, a connection or a leg
  hovered: null,
  startDraft: null,  // the start while it is dragged
  layers: {drawing: true, path: true, connections: true, edits: true},
  sight: new View(),
  small: false,      // the panel covers the drawing
  stale: {base: true, asked: false},

  /** Paints at the next frame; `all`: the view, the colours or the layers are others. */
  redraw(all) {
    this.stale.base = this.stale.base || all;
    if (this.stale.asked) return;
    this.stale.asked = true;
    requestAnimationFrame(() => paintAll());
  },
  /** After anything but time and view. */
  refresh() {
    fillCard();
    this.redraw(false);
  },
  hover(at) {
    const before = this.hovered;
    this.hovered = at ? this.tool.hover(at) : null;
    if (!at) this.tool.near = null;
    byId("overlay").classList.toggle("pick", this.hovered !== null);
    if (this.hovered !== before && !this.chosen) fillCard();
    this.redraw(false);
  },
  use(name) {
    if (this.tool) this.tool.leave();
    this.tool = this.tools[name];
    this.tool.enter();
    if (name !== "curve") this.chosen = null;
    byId("overlay").classList.toggle("draw", name === "cut" || name === "start");
    showButtons();
    showDetails(false);
    this.refresh();
    return this.tool;
  },
  look(view) {
    this.view = view;
    showButtons();
    this.redraw(true);
  },
  editsChanged() {
    fillEdits();
    app.refresh();
  },
};
data.traces.forEach((trace, i) => app.layers["trace" + i] = false);

const contexts = Object.fromEntries(["base", "work", "overlay"].map(id => [id, byId(id).getContext("2d")]));

function paintAll() {
  const {base, work, overlay} = contexts, all = app.stale.base;
  app.stale = {base: false, asked: false};
  if (all) paintBase(base);
  paintWork(work, all);
  overlay.setTransform(1, 0, 0, 1, 0, 0);
  overlay.clearRect(0, 0, overlay.canvas.width, overlay.canvas.height);
  paintChosen(overlay, app.hovered, 0.25);
  paintChosen(overlay, app.chosen, 0.45);
  paintEdits(overlay);
  paintPresent(overlay);
  if (app.view === "connections") paintOrder(overlay);
  paintStart(overlay);
  app.tool.paint(overlay);
  if (all) showScale();
}

function resize() {
  const stage = byId("stage"), pixels = window.devicePixelRatio || 1;
  for (const {canvas} of Object.values(contexts)) {
    canvas.width = Math.max(1, Math.round(stage.clientWidth * pixels));
    canvas.height = Math.max(1, Math.round(stage.clientHeight * pixels));
  }
  app.small = matchMedia("(max-width: 800px)").matches;
  app.sight.covered = app.small && stage.clientHeight > 400 ? {top: 44, bottom: 170} : {top: 0, bottom: 0};
  app.sight.resize(stage.clientWidth, stage.clientHeight, pixels);
  fillCard();
  app.stale.base = true;
  paintAll();
}

function zoomBy(factor) {
  app.sight.zoom(app.sight.width / 2, app.sight.height / 2, factor);
  app.redraw(true);
}
function fit() {
  app.sight.fit(wholeBox);
  app.redraw(true);
}

function onKey(event) {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) && event.target.type !== "range";
  if (byId("saved").open || typing) return;
  if ((event.ctrlKey || event.metaKey) && event.key === "z") return app.edits.undo();
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const step = seconds => () => app.player.go(app.time + seconds);
  const keys = {
    " ": () => app.player.toggle(), ArrowLeft: step(-totalTime / 200), ArrowRight: step(totalTime / 200),
    "+": () => zoomBy(1.3), "=": () => zoomBy(1.3), "-": () => zoomBy(1 / 1.3), 0: fit,
    1: () => app.look("outline"), 2: () => app.look("realistic"), 3: () => app.look("connections"),
    Escape: () => app.use("select"),
  };
  const onButton = event.key === " " && event.target.tagName === "BUTTON";
  if (!keys[event.key] || onButton) return;
  event.preventDefault();
  keys[event.key]();
}

function begin() {
  document.body.classList.toggle("no-drawing", !editable);
  app.edits = new Edits(data.edits, app.editsChanged);
  app.tools = {select: new SelectTool(), connect: new ConnectTool(), curve: new CurveTool(), fill: new FillTool(),
               cut: new CutTool(), start: new StartTool()};
  app.player = new Player();
  app.use("select");
  for (const node of document.querySelectorAll("[data-view]")) node.onclick = () => app.look(node.dataset.view);
  for (const node of document.querySelectorAll("[data-tool]")) node.onclick = () => app.use(node.dataset.tool);
  byId("zoom-in").onclick = () => zoomBy(1.4);
  byId("zoom-out").onclick = () => zoomBy(1 / 1.4);
  byId("zoom-fit").onclick = fit;
  byId("undo").onclick = () => app.edits.undo();
  byId("details").onclick = () => showDetails(!document.body.classList.contains("details"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    readColours();
    app.redraw(true);
  });
  addEventListener("keydown", onKey);
  new Pointers(byId("overlay"));
  new ResizeObserver(resize).observe(byId("stage"));
  prepareSaving();
  fillSummary();
  fillLayers();
  fillFigures();
  fillEdits();
  resize();
}
begin();
