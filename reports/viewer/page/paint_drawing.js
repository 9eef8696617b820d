// Under the path: the map, the drawing and the planner's stages. Over it: order, directions, what is chosen.
const mapPath = new Path2D();
for (const rings of data.map) pathOfRings(rings, mapPath);
const tracePaths = data.traces.map(trace => {
  const path = new Path2D();
  for (const line of trace.lines) pathOf(line, false, path);
  return path;
});

function paintBase(context) {
  const realistic = app.view === "realistic", pixel = 1 / app.sight.scale;
  app.sight.inPixels(context);
  context.fillStyle = realistic ? colour["sand-outside"] : colour.outside;
  context.fillRect(0, 0, app.sight.width, app.sight.height);
  app.sight.inMetres(context);
  context.fillStyle = realistic ? colour.sand : colour.canvas;
  context.fill(mapPath, "evenodd");
  context.lineJoin = context.lineCap = "round";
  if (!realistic && app.layers.drawing) {
    context.fillStyle = colour.area;
    for (const shape of shapes) if (shape.kind === "area") context.fill(shape.path, "evenodd");
    context.strokeStyle = colour.ink;
    for (const shape of shapes) {
      context.lineWidth = (shape.kind === "area" ? 1 : 2) * pixel;
      context.setLineDash(shape.tool ? [] : [6 * pixel, 5 * pixel]);
      context.stroke(shape.path);
    }
    context.setLineDash([]);
  }
  tracePaths.forEach((path, i) => {
    if (!app.layers["trace" + i]) return;
    context.lineWidth = 1.5 * pixel;
    context.strokeStyle = traceColour(i);
    context.stroke(path);
  });
}

/** An arrowhead at a point of a path. */
function paintArrow(context, at, fill) {
  const [px, py] = app.sight.toScreen(at.x, at.y), angle = Math.atan2(-at.dy, at.dx);
  context.save();
  context.translate(px, py);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(6, 0);
  context.lineTo(-5, 5);
  context.lineTo(-5, -5);
  context.closePath();
  context.fillStyle = fill;
  context.fill();
  context.restore();
}

/** Text with a halo; false if another label is there. */
function paintLabel(context, text, px, py, taken) {
  if (taken.some(([x, y]) => Math.abs(x - px) < 26 && Math.abs(y - py) < 18)) return false;
  taken.push([px, py]);
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 4;
  context.lineJoin = "round";
  context.strokeStyle = colour.halo;
  context.strokeText(text, px, py);
  context.fillStyle = colour.label;
  context.fillText(text, px, py);
  return true;
}

/** Directions of the connections, and in which order the elements are driven. */
function paintOrder(context) {
  app.sight.inPixels(context);
  for (const connection of connections) {
    if (connection.t1 > app.time || !app.layers.connections) continue;
    if (connection.length * app.sight.scale < 24) continue;
    connection.middle = connection.middle || pointAlong(connection.flat, 0.5);
    paintArrow(context, connection.middle, colour.transit);
  }
  const taken = [];
  for (const shape of shapes) {
    if (!shape.order || shape.t0 > app.time) continue;
    const [px, py] = app.sight.toScreen(...shape.entry);
    paintLabel(context, String(shape.order), px, py - 12, taken);
  }
}

function paintStart(context) {
  const start = app.edits.ofKind("start")[0], [x, y] = app.startDraft || (start ? start.at : data.start);
  const [px, py] = app.sight.toScreen(x, y);
  app.sight.inPixels(context);
  context.beginPath();
  context.arc(px, py, 8, 0, 2 * Math.PI);
  context.fillStyle = start || app.startDraft ? colour.edit : colour.enforced;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = colour.halo;
  context.stroke();
}

/** A halo round what is chosen or under the pointer. */
function paintChosen(context, chosen, strength) {
  if (!chosen) return;
  app.sight.inMetres(context);
  context.globalAlpha = strength;
  context.lineJoin = context.lineCap = "round";
  context.strokeStyle = colour.accent;
  context.lineWidth = 7 / app.sight.scale;
  context.stroke(chosen.path);
  if (chosen.kind === "area") {
    context.globalAlpha = strength / 3;
    context.fillStyle = colour.accent;
    context.fill(chosen.path, "evenodd");
  }
  context.globalAlpha = 1;
}
