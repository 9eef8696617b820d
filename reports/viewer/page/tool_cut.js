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
    const whole = crossed.filter(shape => !line.some(([x, y]) => insideArea(shape, x, y)));
    const elements = [...new Set(whole.map(shape => shape.element))];
    const message = crossed.length ? "Draw the line right across the area: both ends outside it." :
        "The line meets no filled area.";
    this.message = elements.length ? "" : message;
    if (elements.length) app.edits.add(elements.map(element => ({kind: "cut", element, line})));
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
