// When the path drives which shape, and how it gets from one to the next. The path does not say: each of its segments
// belongs to the stroke that it follows, or to the area that it lies in.
const legs = data.legs;
for (const leg of legs) leg.length = lengthOf(leg.points);
const totalTime = legs.length ? legs[legs.length - 1].times[legs[legs.length - 1].times.length - 1] : 0;

const kParallel = Math.sin(Math.PI / 6);  // a stroke in another direction is crossed, not followed

/** Of the segment from (ax, ay) to (bx, by). A path stays with the stroke that it is on within half of its width, and
 *  takes up another within a quarter. */
function shapeOfSegment(leg, ax, ay, bx, by, current) {
  const x = (ax + bx) / 2, y = (ay + by) / 2, dx = bx - ax, dy = by - ay;
  const parallel = e => Math.abs(dx * (e.by - e.ay) - dy * (e.bx - e.ax)) <=
                        kParallel * Math.hypot(dx, dy) * Math.hypot(e.bx - e.ax, e.by - e.ay);
  const near = (radius, accept) => shapeGrid.nearest(
      x, y, radius, e => e.item.kind === "stroke" && e.item.tool === leg.tool && accept(e.item) && parallel(e));
  if (current && current.kind === "stroke" && near(leg.width / 2, shape => shape === current)) return current;
  const hit = near(leg.width / 4, () => true);
  if (hit) return hit.item;
  return leg.tool ? areaAt(x, y) : null;
}

/** Runs of one shape (null: none), or of transit: {shape, tool, flat, t0, t1}. */
function runsOf(allLegs) {
  const runs = [];
  for (const leg of allLegs) {
    let run = runs[runs.length - 1];
    forEachSegment(leg.points, (ax, ay, bx, by, i) => {
      const shape = shapes.length ? shapeOfSegment(leg, ax, ay, bx, by, run ? run.shape : null) : null;
      if (!run || run.tool !== leg.tool || run.shape !== shape) {
        run = {shape, tool: leg.tool, width: leg.width, flat: [ax, ay], t0: leg.times[i], t1: 0};
        runs.push(run);
      }
      run.flat.push(bx, by);
      run.t1 = leg.times[i + 1];
    });
  }
  return runs;
}

/** Short work beside the shapes (a rounded corner) belongs to the run before. */
function joined(runs) {
  const out = [];
  for (const run of runs) {
    const last = out[out.length - 1];
    const beside = run.tool && !run.shape && last && last.tool && lengthOf(run.flat) < 2 * run.width;
    if (last && last.tool === run.tool && (last.shape === run.shape || beside)) {
      for (let i = 2; i < run.flat.length; ++i) last.flat.push(run.flat[i]);
      last.t1 = run.t1;
    } else {
      out.push(run);
    }
  }
  return out;
}

const runs = joined(runsOf(legs));
/** Transit between two shapes, in driving order. `from` and `to` are nodes; null at the path's ends. */
const connections = [];
let elementsDriven = 0;

function findOrder() {
  runs.forEach((run, i) => {
    if (run.shape) {
      if (!run.shape.order)
        Object.assign(run.shape, {order: ++elementsDriven, t0: run.t0, driven: 0, entry: run.flat.slice(0, 2)});
      run.shape.t1 = run.t1;
      run.shape.driven += lengthOf(run.flat);
    } else if (!run.tool) {
      const before = runs[i - 1], after = runs[i + 1], n = run.flat.length;
      const between = [before, after].map(run => run && run.shape || null);
      const from = between[0] && nearestNode(between[0], run.flat[0], run.flat[1]);
      const to = between[1] && nearestNode(between[1], run.flat[n - 2], run.flat[n - 1]);
      connections.push({number: connections.length + 1, from, to, between, inside: between[0] === between[1],
                        t0: run.t0, t1: run.t1, flat: run.flat, length: lengthOf(run.flat), path: pathOf(run.flat)});
    }
  });
}
findOrder();

const connectionGrid = new SegmentGrid(wholeBox);
for (const connection of connections) connectionGrid.add(connection.flat, connection);
const legGrid = new SegmentGrid(wholeBox);
if (!shapes.length) legs.forEach((leg, i) => leg.tool && legGrid.add(leg.points, i));

/** Has the connection these two ends, in any direction? */
function joins(connection, a, b) {
  if (!canBeEdited(connection)) return false;
  const from = referenceOf(connection.from), to = referenceOf(connection.to);
  return (sameEnd(from, a) && sameEnd(to, b)) || (sameEnd(from, b) && sameEnd(to, a));
}
/** Between two elements: only these have names in a file of edits. */
const canBeEdited = connection => connection.from && connection.to && !connection.inside;
