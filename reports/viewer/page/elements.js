// The drawing's strokes and areas as shapes that can be painted, hit and named. An SVG element may give several shapes;
// its vertices are counted through all of its strokes, as files of edits count them.
const kCorner = Math.PI / 12;  // a vertex of an area's boundary that turns less is no node: curves have hundreds

const kMostRoundNodes = 16;    // of a boundary without corners

/** Indices of the vertices of a ring at which it turns; some, evenly spread, if it has no three such. */
function cornersOf(ring) {
  const n = ring.length / 2, corners = [];
  for (let i = 0; i < n; ++i) {
    const p = (i + n - 1) % n, q = (i + 1) % n;
    const before = Math.atan2(ring[2 * i + 1] - ring[2 * p + 1], ring[2 * i] - ring[2 * p]);
    const after = Math.atan2(ring[2 * q + 1] - ring[2 * i + 1], ring[2 * q] - ring[2 * i]);
    const turn = Math.abs(Math.atan2(Math.sin(after - before), Math.cos(after - before)));
    if (turn > kCorner) corners.push(i);
  }
  if (corners.length > 2) return corners;
  const step = Math.ceil(n / kMostRoundNodes);
  return Array.from({length: n}, (_, i) => i).filter(i => i % step === 0 || corners.includes(i));
}

function strokeShape(stroke, firstVertex) {
  const flat = stroke.points, n = flat.length / 2;
  const closed = n > 2 && flat[0] === flat[2 * n - 2] && flat[1] === flat[2 * n - 1];
  // A stroke without nodes: every point is one, as planners count them.
  const positions = stroke.nodes.length ? stroke.nodes : Array.from({length: n}, (_, i) => i);
  const nodes = positions.map((at, i) => {
    const number = firstVertex + i;  // `vertex` is its name, which may be -1
    return {vertex: number, number, x: flat[2 * at], y: flat[2 * at + 1]};
  });
  return {
    kind: "stroke", element: stroke.element, flats: [flat], closed, width: stroke.width, tool: stroke.tool,
    length: lengthOf(flat), path: pathOf(flat), box: boxOf([flat]), allNodes: nodes,
    // The path enters and leaves an open stroke at its ends only; a closed one at any node, the last being the first.
    nodes: closed ? nodes.slice(0, -1) : [nodes[0], nodes[nodes.length - 1]],
  };
}

function areaShape(area) {
  const outer = area.rings[0];
  let squareMetres = 0;
  for (const ring of area.rings)
    for (let i = 0, n = ring.length; i < n; i += 2)
      squareMetres += (ring[i] * ring[(i + 3) % n] - ring[(i + 2) % n] * ring[i + 1]) / 2;
  return {
    kind: "area", element: area.element, flats: area.rings.map(ring => [...ring, ring[0], ring[1]]), closed: true,
    tool: true, squareMetres: Math.abs(squareMetres), rings: area.rings, path: pathOfRings(area.rings),
    box: boxOf(area.rings), nodes: cornersOf(outer).map(i => ({vertex: i, x: outer[2 * i], y: outer[2 * i + 1]})),
  };
}

/** Of an element's last stroke, the end that is its last vertex is called -1. */
function nameLastVertices(shapes) {
  const lastOf = new Map();
  for (const shape of shapes) if (shape.kind === "stroke") lastOf.set(shape.element, shape);
  for (const shape of lastOf.values()) if (!shape.closed) shape.nodes[1].vertex = -1;
}

function shapesOf(drawing) {
  if (!drawing) return [];
  const areas = drawing.areas.map(areaShape), strokes = [], counts = new Map();
  for (const stroke of drawing.strokes) {
    const first = counts.get(stroke.element) || 0, shape = strokeShape(stroke, first);
    counts.set(stroke.element, first + shape.allNodes.length);
    strokes.push(shape);
  }
  nameLastVertices(strokes);
  // A vertex of an element that has strokes is one of theirs, so an area of the same name has none.
  for (const shape of areas) if (counts.has(shape.element)) shape.nodes = [];
  for (const shape of [...areas, ...strokes]) for (const node of shape.nodes) node.shape = shape;
  return [...areas, ...strokes];
}

const shapes = shapesOf(data.drawing);
const wholeBox = {left: data.box[0][0], bottom: data.box[0][1], right: data.box[1][0], top: data.box[1][1]};
const shapeGrid = new SegmentGrid(wholeBox);
for (const shape of shapes) for (const flat of shape.flats) shapeGrid.add(flat, shape);

const testContext = document.createElement("canvas").getContext("2d");
function insideArea(shape, x, y) {
  const box = shape.box;
  return x >= box.left && x <= box.right && y >= box.bottom && y <= box.top &&
         testContext.isPointInPath(shape.path, x, y, "evenodd");
}
const areaAt = (x, y) => shapes.find(shape => shape.kind === "area" && insideArea(shape, x, y)) || null;

/** The smallest closed line with the point inside; null if there is none. */
function closedLineAround(x, y) {
  const size = ({box}) => (box.right - box.left) * (box.top - box.bottom);
  const around = shapes.filter(shape => shape.kind === "stroke" && shape.closed && insideArea(shape, x, y));
  return around.sort((a, b) => size(a) - size(b))[0] || null;
}

/** The node nearest to a point, of one shape. */
function nearestNode(shape, x, y) {
  let best = null, least = Infinity;
  for (const node of shape.nodes) {
    const distance = Math.hypot(node.x - x, node.y - y);
    if (distance < least) [best, least] = [node, distance];
  }
  return best;
}

/** The node that somebody means who points at (x, y): one within the radius, else that of the shape which is there. */
function nodeNear(x, y, radius) {
  let best = null, least = radius;
  for (const shape of shapes)
    for (const node of shape.nodes) {
      const distance = Math.hypot(node.x - x, node.y - y);
      if (distance < least) [best, least] = [node, distance];
    }
  if (best) return best;
  const hit = shapeGrid.nearest(x, y, radius), shape = hit ? hit.item : areaAt(x, y) || closedLineAround(x, y);
  return shape ? nearestNode(shape, x, y) : null;
}

const referenceOf = node => ({element: node.shape.element, vertex: node.vertex});
const sameReference = (a, b) => a.element === b.element && a.vertex === b.vertex;
/** The node that a file of edits names; null if there is none in the drawing. */
function nodeOf(reference) {
  for (const shape of shapes)
    if (shape.element === reference.element)
      for (const node of [...shape.nodes, ...(shape.allNodes || [])])
        if (node.vertex === reference.vertex || node.number === reference.vertex) return {shape, ...node};
  return vertexOfArea(reference);
}
/** A vertex of an area's boundary that is no node here: older files of edits name such. */
function vertexOfArea(reference) {
  const shape = shapes.find(s => s.kind === "area" && s.element === reference.element);
  const at = 2 * reference.vertex;
  if (!shape || !shape.nodes.length || !(at >= 0 && at < shape.rings[0].length)) return null;
  return {shape, vertex: reference.vertex, x: shape.rings[0][at], y: shape.rings[0][at + 1]};
}
/** The same node; or any two of one area: its fill ends near to the vertex that is named, and seldom in it. */
function sameEnd(a, b) {
  if (a.element !== b.element) return false;
  const node = a.vertex === b.vertex ? null : nodeOf(a);
  return a.vertex === b.vertex || (node !== null && node.shape.kind === "area");
}
function nodeText(reference) {
  const node = nodeOf(reference);
  const open = node && node.shape.kind === "stroke" && !node.shape.closed;
  if (reference.vertex === -1) return `${reference.element}, end`;
  if (open && reference.vertex === 0) return `${reference.element}, begin`;
  return `${reference.element}, vertex ${reference.vertex}`;
}
