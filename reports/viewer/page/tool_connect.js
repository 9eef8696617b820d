/** Two taps on ends of elements enforce a connection; a tap on a connection chooses it, to keep or delete it. */
class ConnectTool extends Tool {
  enter() { this.leave(); }
  leave() {
    this.first = null;
    this.connection = null;
    this.message = "";
  }

  hover(at) {
    const connection = this.connectionAt(at);
    this.near = connection ? null : nodeNear(at.x, at.y, at.reach);
    return connection;
  }
  /** A connection that is pointed at away from its ends, which are there for a new connection. */
  connectionAt(at) {
    if (this.first) return null;
    const hit = connectionNear(at), node = nodeNear(at.x, at.y, at.reach);
    return hit && !(node && Math.hypot(node.x - at.x, node.y - at.y) < at.reach) ? hit.item : null;
  }

  tap(at) {
    this.message = "";
    const connection = this.connectionAt(at), node = nodeNear(at.x, at.y, at.reach);
    app.chosen = connection;
    if (connection || !node) {
      this.first = null;
    } else if (!this.first || this.first === node) {
      this.first = this.first ? null : node;
    } else if (this.first.shape === node.shape) {
      this.message = "A connection joins two different elements.";
    } else {
      app.edits.connect("enforce", this.first, node);
      this.first = null;
      this.message = "";
    }
  }

  paint(context) {
    const visible = shapes.length <= 500 ? shapes : shapes.filter(shape => app.hovered === shape);
    for (const shape of visible) for (const node of shape.nodes) paintHandle(context, node.x, node.y, 4, colour.path);
    if (this.near) paintHandle(context, this.near.x, this.near.y, 8, colour.enforced);
    if (this.first) paintHandle(context, this.first.x, this.first.y, 9, colour.enforced, colour.enforced);
  }

  card() {
    if (app.chosen) return thingCard(app.chosen);
    const error = this.message ? [create("p", {className: "message"}, this.message)] : [];
    if (!this.first)
      return [title("Connect"), ...error,
              note("Tap the end of an element, then the end of another: the path will go from one to the other. " +
                   "Tap a connection to keep or delete it.")];
    return [title("Connect"), ...error,
            note(`From ${nodeText(referenceOf(this.first))}. Now tap the end of another element.`),
            buttonsOf(button("Cancel", () => { this.leave(); app.refresh(); }))];
  }
}
