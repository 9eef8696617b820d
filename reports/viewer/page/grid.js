/** Segments in square buckets, for the nearest one to a point. Adding is linear in the length of what is added. */
class SegmentGrid {
  constructor(box) {
    this.box = box;
    this.cell = Math.max(box.right - box.left, box.top - box.bottom, 1e-9) / 200;
    this.buckets = new Map();
  }

  column(x) { return Math.floor((x - this.box.left) / this.cell); }
  row(y) { return Math.floor((y - this.box.bottom) / this.cell); }

  /** All segments of a polyline; `item` is what nearest() answers. */
  add(flat, item) {
    forEachSegment(flat, (ax, ay, bx, by, segment) => {
      const entry = {item, segment, ax, ay, bx, by};
      // A long segment in pieces as long as a cell, else a diagonal one would lie in all cells of its box.
      const pieces = Math.max(1, Math.ceil(Math.hypot(bx - ax, by - ay) / this.cell));
      const seen = new Set();
      for (let i = 0; i < pieces; ++i) {
        const at = t => [ax + (bx - ax) * t / pieces, ay + (by - ay) * t / pieces];
        const [px, py] = at(i), [qx, qy] = at(i + 1);
        this.forEachKey(Math.min(px, qx), Math.min(py, qy), Math.max(px, qx), Math.max(py, qy), key => seen.add(key));
      }
      for (const key of seen) {
        if (!this.buckets.has(key)) this.buckets.set(key, []);
        this.buckets.get(key).push(entry);
      }
    });
  }

  forEachKey(left, bottom, right, top, f) {
    for (let r = this.row(bottom); r <= this.row(top); ++r)
      for (let c = this.column(left); c <= this.column(right); ++c) f(r * 65536 + c);
  }

  /** {item, segment, distance, x, y} of the nearest segment within `radius` whose entry is accepted, or null. */
  nearest(x, y, radius, accept = () => true) {
    let best = null;
    this.forEachKey(x - radius, y - radius, x + radius, y + radius, key => {
      for (const entry of this.buckets.get(key) || []) {
        const found = toSegment(x, y, entry.ax, entry.ay, entry.bx, entry.by);
        if (found.distance > radius || (best && found.distance >= best.distance) || !accept(entry)) continue;
        best = {item: entry.item, segment: entry.segment, ...found};
      }
    });
    return best;
  }
}
