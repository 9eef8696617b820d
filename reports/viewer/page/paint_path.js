// The path in pieces of some hundred vertices, so that a part of it is painted without the rest: what is done stays on
// its canvas while the path is played, and only the present piece is painted anew.
const kPieceVertices = 300;

function piecesOf(allLegs) {
  const pieces = [];
  allLegs.forEach((leg, number) => {
    const n = leg.points.length / 2;
    for (let i = 0; i + 1 < n; i += kPieceVertices) {
      const end = Math.min(n - 1, i + kPieceVertices), flat = leg.points.slice(2 * i, 2 * end + 2);
      pieces.push({leg, number, flat, first: i, t0: leg.times[i], t1: leg.times[end], path: pathOf(flat)});
    }
  });
  return pieces;
}
const pieces = piecesOf(legs);

/** The number of pieces that are complete at time t. */
function piecesDone(t) {
  let low = 0, high = pieces.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (pieces[middle].t1 <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The index of the last vertex of a leg that is reached at time t. */
function lastVertexAt(leg, t) {
  let low = 0, high = leg.times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (leg.times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** {x, y, heading, leg, vertex} at time t; null without a path. */
function robotAt(t) {
  if (!pieces.length) return null;
  const piece = pieces[Math.min(piecesDone(t), pieces.length - 1)], leg = piece.leg;
  const i = Math.min(lastVertexAt(leg, t), leg.times.length - 2), span = leg.times[i + 1] - leg.times[i];
  const share = span > 0 ? Math.min(1, Math.max(0, (t - leg.times[i]) / span)) : t >= leg.times[i + 1] ? 1 : 0;
  const [ax, ay, bx, by] = leg.points.slice(2 * i, 2 * i + 4);
  const heading = Math.atan2(by - ay, bx - ax) + (leg.reverse ? Math.PI : 0);
  return {x: ax + (bx - ax) * share, y: ay + (by - ay) * share, heading, leg, piece, vertex: i};
}

/** As the sand looks: a band as wide as the tool, with the grooves of its tines if there is room for them. */
function paintRaked(context, leg, path) {
  const grooves = leg.width * app.sight.scale > 9 ? [1, 0.72, 0.44, 0.16] : [1];
  context.setLineDash([]);
  grooves.forEach((share, i) => {
    context.lineWidth = Math.max(leg.width * share, 1.2 / app.sight.scale);
    context.strokeStyle = i % 2 ? colour.groove : colour.raked;
    context.stroke(path);
  });
}

function paintPiece(context, leg, path) {
  const pixel = 1 / app.sight.scale;
  context.lineJoin = "round";
  context.lineCap = "round";
  if (app.view === "realistic") {
    if (leg.tool && app.layers.path) paintRaked(context, leg, path);
    if (leg.tool || !app.layers.connections) return;
    context.lineWidth = 1.5 * pixel;
    context.strokeStyle = colour.track;
  } else {
    if (leg.tool ? app.view === "connections" || !app.layers.path : !app.layers.connections) return;
    context.lineWidth = (app.view === "connections" ? 2 : 1.6) * pixel;
    context.strokeStyle = leg.tool ? colour.path : colour.transit;
  }
  context.setLineDash(leg.tool || app.view === "connections" ? [] : [5 * pixel, 4 * pixel]);
  context.stroke(path);
  context.setLineDash([]);
}

/** What is painted on the canvas `work`: pieces [0, done) since it was last cleared. */
const painted = {done: 0};

function paintWork(context, clear) {
  const done = piecesDone(app.time);
  if (clear || done < painted.done) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, context.canvas.width, context.canvas.height);
    painted.done = 0;
  }
  app.sight.inMetres(context);
  for (; painted.done < done; ++painted.done) paintPiece(context, pieces[painted.done].leg, pieces[painted.done].path);
}

/** The present piece, and the robot. */
function paintPresent(context) {
  const robot = robotAt(app.time);
  if (!robot) return;
  app.sight.inMetres(context);
  if (app.time < totalTime) {
    const part = robot.leg.points.slice(2 * robot.piece.first, 2 * robot.vertex + 2);
    paintPiece(context, robot.leg, pathOf([...part, robot.x, robot.y]));
  }
  const pixel = 1 / app.sight.scale;
  const size = Math.max(data.robot.radius, 6 * pixel), across = Math.max(robot.leg.width / 2, 4 * pixel);
  context.save();
  context.translate(robot.x, robot.y);
  context.rotate(robot.heading);
  context.lineWidth = 2 / app.sight.scale;
  context.strokeStyle = colour.robot;
  context.fillStyle = colour.halo;
  context.globalAlpha = 0.85;
  context.beginPath();
  context.moveTo(size, 0);
  context.lineTo(-size * 0.7, size * 0.7);
  context.lineTo(-size * 0.7, -size * 0.7);
  context.closePath();
  context.fill();
  context.stroke();
  if (robot.leg.tool) {
    context.lineWidth = 3 / app.sight.scale;
    context.strokeStyle = colour.label;
    context.stroke(pathOf([0, -across, 0, across]));
  }
  context.restore();
}
