// What the page was made with (reports/viewer/viewer_json.cpp), and small helpers that every other file uses.
// Polylines are flat arrays x, y, x, y, ... in metres, y up.
const data = JSON.parse(document.getElementById("data").textContent);
const editable = data.drawing !== null;
const fileName = data.file.split(/[\\/]/).pop();

const byId = id => document.getElementById(id);

/** An element of the page: create("button", {onclick: f}, "Text", other). */
function create(name, properties = {}, ...children) {
  const node = document.createElement(name);
  Object.assign(node, properties);
  node.append(...children);
  return node;
}

const button = (text, onclick, properties = {}) => create("button", {type: "button", onclick, ...properties}, text);

/** Calls f(ax, ay, bx, by, i) for each segment of a flat polyline. */
function forEachSegment(flat, f) {
  for (let i = 0; i + 3 < flat.length; i += 2) f(flat[i], flat[i + 1], flat[i + 2], flat[i + 3], i / 2);
}

function lengthOf(flat) {
  let sum = 0;
  forEachSegment(flat, (ax, ay, bx, by) => sum += Math.hypot(bx - ax, by - ay));
  return sum;
}

/** The point at a share (0 to 1) of the length, and the direction there. */
function pointAlong(flat, share) {
  let left = lengthOf(flat) * share, found = null;
  forEachSegment(flat, (ax, ay, bx, by) => {
    const length = Math.hypot(bx - ax, by - ay);
    if (found || length === 0) return;
    if (left <= length * (1 + 1e-9)) {
      found = {x: ax + (bx - ax) * left / length, y: ay + (by - ay) * left / length, dx: bx - ax, dy: by - ay};
    }
    left -= length;
  });
  if (found) return found;
  return {x: flat[flat.length - 2], y: flat[flat.length - 1], dx: 1, dy: 0};  // without length
}

/** Distance of a point to a segment, and the nearest point. */
function toSegment(x, y, ax, ay, bx, by) {
  const dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
  const nx = ax + t * dx, ny = ay + t * dy;
  return {distance: Math.hypot(x - nx, y - ny), x: nx, y: ny};
}

function pathOf(flat, closed = false, path = new Path2D()) {
  for (let i = 0; i < flat.length; i += 2) i === 0 ? path.moveTo(flat[0], flat[1]) : path.lineTo(flat[i], flat[i + 1]);
  if (closed) path.closePath();
  return path;
}

function pathOfRings(rings, path = new Path2D()) {
  for (const ring of rings) pathOf(ring, true, path);
  return path;
}

function boxOf(flats) {
  const box = {left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity};
  for (const flat of flats)
    for (let i = 0; i < flat.length; i += 2) {
      box.left = Math.min(box.left, flat[i]);
      box.right = Math.max(box.right, flat[i]);
      box.bottom = Math.min(box.bottom, flat[i + 1]);
      box.top = Math.max(box.top, flat[i + 1]);
    }
  return box;
}

const metres = value => `${value < 10 ? value.toFixed(2) : value < 1000 ? value.toFixed(1) : value.toFixed(0)} m`;
function minutes(seconds) {
  const whole = Math.round(seconds), two = value => String(value).padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const before = hours > 0 ? `${hours}:${two(Math.floor(whole / 60) % 60)}` : Math.floor(whole / 60);
  return `${before}:${two(whole % 60)}`;
}
/** To millimetres: finer than anybody can point. */
const millimetres = value => Math.round(value * 1000) / 1000;
