/** How an area is filled. A tap chooses the area, or the part of it that its cuts leave; a drag over it gives the
 *  direction of its lanes. */
class FillTool extends Tool {
  enter() { this.leave(); }
  leave() {
    this.shape = null;
    this.part = null;
    this.drawn = null;
    this.say("");
  }

  choose(shape, x, y) {
    this.shape = shape;
    this.at = shape ? [x, y].map(millimetres) : null;
    this.part = shape ? partAt(shape, x, y) : null;
    app.chosen = shape;
    this.say(shape ? "" : "No filled area is here.");
    app.refresh();
  }
  saved() { return this.shape ? fillEditOf(this.shape, this.part) : undefined; }

  /** Changes some of the choices; an edit without any goes. */
  set(choices) {
    const saved = this.saved();
    const edit = {kind: "fill", element: this.shape.element, at: this.at, ...saved, ...choices};
    for (const key of ["fill", "angle_deg", "outline"]) if (edit[key] === undefined) delete edit[key];
    const empty = edit.fill === undefined && edit.angle_deg === undefined && edit.outline === undefined;
    app.edits.add(empty ? [] : [edit], saved ? [saved] : []);
  }

  hover(at) { return areaAt(at.x, at.y); }
  tap(at) { this.choose(areaAt(at.x, at.y), at.x, at.y); }
  press(at) { return areaAt(at.x, at.y) !== null; }
  drag(at, first) { this.drawn = [first.x, first.y, at.x, at.y]; }
  cancel() { this.drawn = null; }
  drop(at, first) {
    this.drawn = null;
    this.choose(areaAt(first.x, first.y), first.x, first.y);
    const degrees = Math.round(Math.atan2(at.y - first.y, at.x - first.x) * 180 / Math.PI);
    this.set({fill: "zigzag", angle_deg: (degrees + 360) % 180});
  }

  paint(context) {
    app.sight.inMetres(context);
    if (this.part) this.part.paint(context, colour.edit);
    if (this.drawn) paintLine(context, this.drawn, colour.edit, 3);
  }

  choiceOf(label, value, options) {
    const select = create("select", {onchange: event => options[event.target.selectedIndex].choose()},
                          ...options.map(o => create("option", {selected: o.value === value}, o.text)));
    return create("label", {className: "field"}, label, select);
  }
  card() {
    if (!this.shape)
      return [title("Fill"), ...this.said(),
              note("Tap an area to choose how it is filled, or drag over it in the direction of its lanes.")];
    const saved = this.saved() || {};
    const fill = (text, value) => {
      const angle = value === "zigzag" ? saved.angle_deg : undefined;
      return {text, value, choose: () => this.set({fill: value, angle_deg: angle})};
    };
    const outline = (text, value) => ({text, value, choose: () => this.set({outline: value})});
    const lines = [
      title(`Fill of ${this.shape.element}`),
      this.choiceOf("Fill", saved.fill, [fill("Planner's choice", undefined), fill("Spiral", "spiral"),
                                         fill("Zigzag", "zigzag"), fill("Contour", "contour"), fill("None", "none")]),
      this.choiceOf("Outline", saved.outline, [outline("Planner's choice", undefined), outline("Yes", true),
                                               outline("No", false)])];
    if (saved.fill === "zigzag") {
      const angle = create("input", {
        type: "number", min: 0, max: 179, step: 1, value: saved.angle_deg ?? "", placeholder: "free",
        onchange: event => this.set({angle_deg: this.degrees(event.target.value)})});
      lines.push(create("label", {className: "field"}, "Direction, degrees", angle));
    }
    return lines;
  }
  degrees(text) {
    const number = text.trim() === "" ? NaN : Number(text);
    return isFinite(number) ? ((number % 180) + 180) % 180 : undefined;
  }
}
