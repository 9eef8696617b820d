/** A line drawn across an area cuts it. */
class CutTool extends Tool {
  enter() { this.leave(); }
  leave() {
    this.line = null;
    this.message = "";
  }

  press() { return true; }
  drag(at, first) { this.line = [[first.x, first.y], [at.x, at.y]]; }
  cancel() { this.line = null; }
  drop(at, first) {
    this.line = null;
    const line = [[first.x, first.y], [at.x, at.y]].map(p => p.map(millimetres));
    const crossed = shapes.filter(shape => shape.kind === "area" && this.crosses(line, shape));
    const divided = crossed.filter(shape => this.divides(line, shape));
    const elements = [...new Set(divided.map(shape => shape.element))];
    const message = crossed.length ? "This line does not divide the area: draw it right across." :
        "The line meets no filled area.";
    this.message = elements.length ? "" : message;
    if (elements.length) app.edits.add(elements.map(element => ({kind: "cut", element, line})));
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

  paint(context) { if (this.line) paintLine(context, this.line.flat(), colour.edit, 3, [8, 6]); }
  card() {
    return [title("Cut"), ...(this.message ? [create("p", {className: "message"}, this.message)] : []),
            note("Drag a line right across a filled area to cut it in two. Two fingers or the wheel move the view.")];
  }
}
