// Mouse, finger and pen on the drawing. One pointer drags what the tool takes up, else the view; two pinch; the wheel
// zooms; a short press without motion is a tap.
const kTapSlack = {mouse: 4, pen: 6, touch: 10};  // pixels of motion that still make a tap

class Pointers {
  constructor(target) {
    this.target = target;
    this.down = new Map();  // by pointer id
    this.dragging = null;   // "tool" or "view"
    const on = (name, f) => target.addEventListener(name, event => {
      event.preventDefault();
      f.call(this, event);
    }, {passive: false});
    on("pointerdown", this.press);
    on("pointermove", this.move);
    on("pointerup", this.release);
    on("pointercancel", this.cancel);
    on("wheel", this.wheel);
    on("contextmenu", () => {});
    target.addEventListener("pointerleave", () => app.hover(null));
  }

  at(event) {
    const box = this.target.getBoundingClientRect(), px = event.clientX - box.left, py = event.clientY - box.top;
    const [x, y] = app.sight.toPlane(px, py);
    // Metres within which something is meant: a finger is wider than a mouse.
    const reach = (event.pointerType === "mouse" ? 10 : 22) / app.sight.scale;
    return {px, py, x, y, reach};
  }

  press(event) {
    document.activeElement.blur();  // so that keys are the page's again
    this.target.setPointerCapture(event.pointerId);
    const at = this.at(event);
    this.down.set(event.pointerId, {...at, first: at, moved: false, slack: kTapSlack[event.pointerType] || 6});
    if (this.down.size === 1) {
      this.dragging = event.button === 0 && app.tool.press(at) ? "tool" : "view";
    } else {
      if (this.dragging === "tool") app.tool.cancel();
      this.dragging = "view";
      for (const pointer of this.down.values()) pointer.moved = true;
    }
  }

  move(event) {
    const at = this.at(event), pointer = this.down.get(event.pointerId);
    if (!pointer) return app.hover(at);
    if (!pointer.moved && Math.hypot(at.px - pointer.first.px, at.py - pointer.first.py) <= pointer.slack) return;
    pointer.moved = true;
    if (this.down.size === 2) this.pinch(event.pointerId, at);
    else if (this.dragging === "tool") app.tool.drag(at, pointer.first);
    else app.sight.pan(at.px - pointer.px, at.py - pointer.py);
    Object.assign(pointer, at);
    app.redraw(this.dragging === "view");
  }

  pinch(id, at) {
    const pointer = this.down.get(id), other = [...this.down].find(([key]) => key !== id)[1];
    const distance = p => Math.max(10, Math.hypot(p.px - other.px, p.py - other.py));
    app.sight.pan((at.px - pointer.px) / 2, (at.py - pointer.py) / 2);
    app.sight.zoom((at.px + other.px) / 2, (at.py + other.py) / 2, distance(at) / distance(pointer));
  }

  release(event) {
    const pointer = this.down.get(event.pointerId);
    if (!pointer) return;
    this.down.delete(event.pointerId);
    const at = this.at(event);
    if (!pointer.moved) {
      if (this.dragging === "tool") app.tool.cancel();
      if (event.button === 0) app.tool.tap(at);
    } else if (this.dragging === "tool") {
      app.tool.drop(at, pointer.first);
    }
    if (!this.down.size) this.dragging = null;
    app.refresh();
  }

  cancel(event) {
    if (this.dragging === "tool") app.tool.cancel();
    this.down.delete(event.pointerId);
    if (!this.down.size) this.dragging = null;
    app.refresh();
  }

  wheel(event) {
    const at = this.at(event), lines = event.deltaMode === 1 ? 16 : 1;
    app.sight.zoom(at.px, at.py, Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)));
    app.redraw(true);
  }
}
