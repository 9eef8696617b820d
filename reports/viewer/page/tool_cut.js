/** A line drawn across an area cuts it. */
class CutTool extends Tool {
  enter() { this.leave(); }
  leave() {
    this.line = null;
    this.say("");
  }

  tap() { this.say("A tap does not cut: drag a line across the area."); }
  press() { return true; }
  drag(at, first) { this.line = [[first.x, first.y], [at.x, at.y]]; }
  cancel() { this.line = null; }
  drop(at, first) {
    this.line = null;
    const drawn = [[first.x, first.y], [at.x, at.y]];
    const crossed = shapes.filter(shape => shape.kind === "area" && this.crosses(drawn, shape));
    const cuts = new Map();  // by element
    for (const element of new Set(crossed.map(shape => shape.element))) {
      const own = crossed.filter(shape => shape.element === element);
      const line = own.reduce((longer, shape) => this.extended(longer, shape), drawn).map(p => p.map(millimetres));
      if (own.some(shape => this.divides(line, shape))) cuts.set(element, line);
    }
    const names = [...cuts.keys()];
    if (names.length) {
      app.edits.add([...cuts].map(([element, line]) => ({kind: "cut", element, line})));
      this.say(`Cut: ${names.join(", ")}. Fill chooses how each part is filled.`, true);
    } else {
      this.say(crossed.length ? "This line does not divide the area: draw it right across." :
               "The line meets no filled area.");
    }
  }
  /** The line, drawn on from where it ends within the area to the area's boundary, and a little beyond. */
  extended(line, shape) {
    const {left, right, top, bottom} = shape.box;
    const beyond = Math.max(0.002, 0.001 * Math.max(right - left, top - bottom));
    const length = Math.hypot(line[1][0] - line[0][0], line[1][1] - line[0][1]);
    return line.map(([x, y], end) => {
      if (!insideArea(shape, x, y)) return [x, y];
      const dx = (x - line[1 - end][0]) / length, dy = (y - line[1 - end][1]) / length;
      let least = Infinity;
      for (const flat of shape.flats)
        forEachSegment(flat, (ax, ay, bx, by) => {
          const across = dx * (by - ay) - dy * (bx - ax);
          const ahead = ((ax - x) * (by - ay) - (ay - y) * (bx - ax)) / across;
          const share = ((ax - x) * dy - (ay - y) * dx) / across;
          if (ahead >= 0 && share >= 0 && share <= 1) least = Math.min(least, ahead);
        });
      return isFinite(least) ? [x + (least + beyond) * dx, y + (least + beyond) * dy] : [x, y];
    });
  }
  /** Are the two sides of the line somewhere in different parts? Not if it ends within the area, or in a hole. */
  divides(line, shape) {
    const [[ax, ay], [bx, by]] = line, cuts = app.edits.ofKind("cut").filter(cut => cut.element === shape.element);
    const {left, right, top, bottom} = shape.box, length = Math.hypot(bx - ax, by - ay);
    const aside = 4 * Math.max(right - left, top - bottom) / Part.kPixels;
    const nx = (ay - by) / length * aside, ny = (bx - ax) / length * aside;
    const samples = 40;
    for (let i = 1; i < samples; ++i) {
      const x = ax + (bx - ax) * i / samples, y = ay + (by - ay) * i / samples;
      if (![[x, y], [x + nx, y + ny], [x - nx, y - ny]].every(([px, py]) => insideArea(shape, px, py))) continue;
      if (!new Part(shape, x + nx, y + ny, [...cuts, {line}]).contains(x - nx, y - ny)) return true;
    }
    return false;
  }
  crosses([[ax, ay], [bx, by]], shape) {
    const steps = 400;
    for (let i = 0; i <= steps; ++i)
      if (insideArea(shape, ax + (bx - ax) * i / steps, ay + (by - ay) * i / steps)) return true;
    return false;
  }

  paint(context) {
    if (!this.line) return;
    paintLine(context, this.line.flat(), colour.edit, 3, [8, 6]);
    for (const shape of shapes)
      if (shape.kind === "area" && this.line.some(([x, y]) => insideArea(shape, x, y)))
        paintLine(context, this.extended(this.line, shape).flat(), colour.edit, 1.5, [3, 4]);
  }
  card() {
    return [title("Cut"), ...this.said(),
            note("Drag a line right across a filled area to cut it in two. Two fingers or the wheel move the view.")];
  }
}
