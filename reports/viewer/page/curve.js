// The course of an edited connection, from its control points: of kind "bezier" the points pull the curve, of kind
// "spiro" it passes through them. The planner solves the spiro curve; the page shows a Catmull-Rom curve through the
// same points, which is near it.

/** A Bezier curve of any degree at t, by de Casteljau. */
function bezierAt(points, t) {
  let level = points;
  const between = (p, q) => [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
  while (level.length > 1) level = level.slice(1).map((p, i) => between(level[i], p));
  return level[0];
}

/** A centripetal Catmull-Rom curve from p1 to p2 at u, as a cubic with the neighbours p0 and p3. */
function catmullRomAt(p0, p1, p2, p3, u) {
  const gap = (p, q) => Math.max(1e-6, Math.sqrt(Math.hypot(q[0] - p[0], q[1] - p[1])));
  const a = gap(p0, p1), b = gap(p1, p2), c = gap(p2, p3);
  return [0, 1].map(k => {
    const first = (p1[k] - p0[k]) / a - (p2[k] - p0[k]) / (a + b) + (p2[k] - p1[k]) / b;
    const last = (p2[k] - p1[k]) / b - (p3[k] - p1[k]) / (b + c) + (p3[k] - p2[k]) / c;
    const m1 = first * b, m2 = last * b, u2 = u * u, u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * p1[k] + (u3 - 2 * u2 + u) * m1 + (3 * u2 - 2 * u3) * p2[k] + (u3 - u2) * m2;
  });
}

/** The curve as a flat polyline. `points` lie between `start` and `end`. */
function curveOf(kind, start, points, end) {
  const all = [start, ...points, end], flat = [];
  const steps = 32;
  if (kind === "bezier") {
    for (let i = 0; i <= steps; ++i) flat.push(...bezierAt(all, i / steps));
    return flat;
  }
  flat.push(...start);
  for (let i = 0; i + 1 < all.length; ++i) {
    const before = all[i - 1] || [2 * all[i][0] - all[i + 1][0], 2 * all[i][1] - all[i + 1][1]];
    const after = all[i + 2] || [2 * all[i + 1][0] - all[i][0], 2 * all[i + 1][1] - all[i][1]];
    for (let s = 1; s <= steps / 2; ++s) flat.push(...catmullRomAt(before, all[i], all[i + 1], after, 2 * s / steps));
  }
  return flat;
}

/** Control points that give about the course of `flat`: of a Bezier the cubic through its points at a third and two
 *  thirds, of a spiro curve the points themselves. */
function controlPointsOf(kind, flat) {
  const n = flat.length, p0 = [flat[0], flat[1]], p3 = [flat[n - 2], flat[n - 1]];
  const [q1, q2] = [1 / 3, 2 / 3].map(share => pointAlong(flat, share)).map(p => [p.x, p.y]);
  if (kind === "spiro") return [q1, q2].map(p => p.map(millimetres));
  // 27 q1 = 8 p0 + 12 p1 + 6 p2 + p3 and 27 q2 = p0 + 6 p1 + 12 p2 + 8 p3.
  const solved = [0, 1].map(k => {
    const a = 27 * q1[k] - 8 * p0[k] - p3[k], b = 27 * q2[k] - p0[k] - 8 * p3[k];
    return [(2 * a - b) / 18, (2 * b - a) / 18];
  });
  // Within the page's map, where they can be seen and dragged.
  const {left, right, bottom, top} = wholeBox, within = (v, least, most) => Math.min(most, Math.max(least, v));
  return [0, 1].map(i => [within(solved[0][i], left, right), within(solved[1][i], bottom, top)].map(millimetres));
}
