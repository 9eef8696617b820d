// The edits over the drawing: enforced connections green, deleted ones red and crossed out, cuts, curves and the
// direction of fills in the colour of edits.

/** The course of the connection that joins two nodes on the page, else the straight line; null if a node is unknown. */
function courseOf(from, to) {
  const found = connections.find(connection => joins(connection, from, to));
  if (found) return found.flat;
  const a = nodeOf(from), b = nodeOf(to);
  return a && b ? [a.x, a.y, b.x, b.y] : null;
}

function paintLine(context, flat, stroke, width, dash = []) {
  const pixel = 1 / app.sight.scale;
  app.sight.inMetres(context);
  context.lineJoin = context.lineCap = "round";
  context.lineWidth = width * pixel;
  context.strokeStyle = stroke;
  context.setLineDash(dash.map(length => length * pixel));
  context.stroke(pathOf(flat));
  context.setLineDash([]);
}

function paintCross(context, flat, stroke) {
  const at = pointAlong(flat, 0.5), [px, py] = app.sight.toScreen(at.x, at.y);
  app.sight.inPixels(context);
  context.lineWidth = 3;
  context.strokeStyle = stroke;
  context.beginPath();
  context.moveTo(px - 7, py - 7);
  context.lineTo(px + 7, py + 7);
  context.moveTo(px - 7, py + 7);
  context.lineTo(px + 7, py - 7);
  context.stroke();
}

function paintConnectionEdit(context, edit) {
  const flat = courseOf(edit.from, edit.to);
  if (!flat) return;
  const enforced = edit.action === "enforce";
  paintLine(context, flat, enforced ? colour.enforced : colour.deleted, 3.5, enforced ? [] : [2, 7]);
  if (!enforced) paintCross(context, flat, colour.deleted);
}

/** The curve of an edit; its ends are where the connection on the page has them. */
function flatOfCurve(edit) {
  const course = courseOf(edit.from, edit.to);
  if (!course) return null;
  const n = course.length, a = nodeOf(edit.from);
  const begin = [course[0], course[1]], end = [course[n - 2], course[n - 1]];
  const backwards = a && Math.hypot(a.x - begin[0], a.y - begin[1]) > Math.hypot(a.x - end[0], a.y - end[1]);
  return backwards ? curveOf(edit.shape, end, edit.points, begin) : curveOf(edit.shape, begin, edit.points, end);
}

/** Three short lanes in the direction of a fill. */
function paintDirection(context, [x, y], degrees) {
  const angle = degrees * Math.PI / 180, [px, py] = app.sight.toScreen(x, y);
  app.sight.inPixels(context);
  context.save();
  context.translate(px, py);
  context.rotate(-angle);
  context.lineWidth = 3;
  context.lineCap = "round";
  context.strokeStyle = colour.edit;
  context.beginPath();
  for (const side of [-8, 0, 8]) {
    context.moveTo(-18, side);
    context.lineTo(18, side);
  }
  context.stroke();
  context.restore();
}

function paintFillEdit(context, edit) {
  if (edit.angle_deg !== undefined) return paintDirection(context, edit.at, edit.angle_deg);
  const [px, py] = app.sight.toScreen(...edit.at);
  app.sight.inPixels(context);
  paintLabel(context, kFillNames[edit.fill] || "outline", px, py, []);
}

function paintEdits(context) {
  if (!app.layers.edits) return;
  for (const edit of app.edits.list) {
    if (edit.kind === "connection") paintConnectionEdit(context, edit);
    if (edit.kind === "cut") paintLine(context, edit.line.flat(), colour.edit, 3, [8, 6]);
    if (edit.kind === "fill") paintFillEdit(context, edit);
    if (edit.kind === "curve") {
      const flat = flatOfCurve(edit);
      if (flat) paintLine(context, flat, colour.edit, 3);
    }
  }
}

/** A round handle, in pixels. */
function paintHandle(context, x, y, radius, stroke, fill = colour.halo) {
  const [px, py] = app.sight.toScreen(x, y);
  app.sight.inPixels(context);
  context.beginPath();
  context.arc(px, py, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = stroke;
  context.stroke();
}
