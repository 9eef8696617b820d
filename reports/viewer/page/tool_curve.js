/** Shapes a connection by its control points. */
class CurveTool extends Tool {
  enter() {
    const chosen = app.chosen;
    this.leave();
    this.say("");
    if (chosen && !chosen.kind) this.choose(chosen);
  }
  leave() {
    this.connection = null;
    this.draft = null;  // the edit as it is being dragged
  }

  choose(connection) {
    this.connection = canBeEdited(connection) ? connection : null;
    this.say(this.connection ? "" : "Only connections between two elements have a curve of their own.");
    app.chosen = this.connection;
    app.refresh();
  }

  saved() {
    const {from, to} = this.connection || {};
    return this.connection && app.edits.pair("curve", referenceOf(from), referenceOf(to));
  }
  /** The edit that the handles show: being dragged, saved, or proposed from the connection's course. */
  edit() {
    const {from, to, flat} = this.connection;
    return this.draft || this.saved() || {kind: "curve", from: referenceOf(from), to: referenceOf(to), shape: "bezier",
                                          points: controlPointsOf("bezier", flat)};
  }
  keep(edit) {
    this.draft = null;
    const gone = app.edits.bend(edit, this.connection.from, this.connection.to);
    this.say(`The path will follow this curve.${insteadOf(gone)}`, true);
  }

  /** One that can be edited before one that cannot. */
  connectionAt(at) { return (connectionNear(at, at.reach, canBeEdited) || connectionNear(at))?.item || null; }
  hover(at) { return this.connectionAt(at); }
  tap(at) {
    const connection = this.connectionAt(at);
    if (connection) return this.choose(connection);
    this.leave();
    app.chosen = null;
    this.say("No connection is here: tap a dashed line.");
  }

  press(at) {
    if (!this.connection) return false;
    const edit = this.edit();
    let least = 1.4 * at.reach;
    this.handle = -1;
    edit.points.forEach(([x, y], i) => {
      const distance = Math.hypot(x - at.x, y - at.y);
      if (distance < least) [this.handle, least] = [i, distance];
    });
    return this.handle >= 0;
  }
  drag(at) {
    const edit = this.edit();
    this.draft = {...edit, points: edit.points.map((p, i) => i === this.handle ? [at.x, at.y].map(millimetres) : p)};
  }
  drop(at) {
    this.drag(at);
    this.keep(this.draft);
  }
  cancel() { this.draft = null; }

  paint(context) {
    if (!this.connection) return;
    const edit = this.edit(), flat = flatOfCurve(edit), n = flat.length;
    paintLine(context, flat, colour.edit, 3);
    if (edit.shape === "bezier")
      paintLine(context, [flat[0], flat[1], ...edit.points.flat(), flat[n - 2], flat[n - 1]], colour.edit, 1, [4, 4]);
    for (const [x, y] of edit.points) paintHandle(context, x, y, 9, colour.edit);
  }

  /** One more or one fewer control point; the curve is resampled, so that its course stays about the same. */
  recount(by) {
    const edit = this.edit(), flat = flatOfCurve(edit), count = edit.points.length + by;
    const points = Array.from({length: count}, (_, i) => pointAlong(flat, (i + 1) / (count + 1)));
    this.keep({...edit, points: points.map(p => [p.x, p.y].map(millimetres))});
  }
  reshape(shape) {
    const edit = this.edit();
    this.keep({...edit, shape, points: controlPointsOf(shape, flatOfCurve(edit))});
  }

  card() {
    if (!this.connection)
      return [title("Curve"), ...this.said(), note("Tap a connection, then drag its control points.")];
    const edit = this.edit(), saved = this.saved();
    const kinds = create("select", {ariaLabel: "Kind of curve", onchange: event => this.reshape(event.target.value)},
                         create("option", {value: "bezier", selected: edit.shape === "bezier"}, "Pulled by points"),
                         create("option", {value: "spiro", selected: edit.shape === "spiro"}, "Through points"));
    const lines = [title(`Curve of connection ${this.connection.number}`), ...this.said(),
                   note("Drag its control points."),
                   create("label", {className: "field"}, "Kind", kinds)];
    const actions = [];
    if (edit.shape === "spiro") {
      actions.push(button("More points", () => this.recount(1), {disabled: edit.points.length >= 8}),
                   button("Fewer", () => this.recount(-1), {disabled: edit.points.length <= 1}));
    }
    if (saved) actions.push(button("Planner's curve", () => app.edits.remove(saved)));
    return [...lines, buttonsOf(...actions)];
  }
}
