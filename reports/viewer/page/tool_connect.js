/** Two taps on ends of elements enforce a connection; a tap on a connection chooses it, to keep or delete it. */
class ConnectTool extends Tool {
  enter() { this.leave(); }
  leave() {
    this.first = null;
    this.say("");
  }

  hover(at) {
    const connection = this.connectionAt(at);
    this.near = connection ? null : nodeNear(at.x, at.y, at.reach);
    return connection;
  }
  /** A connection that is pointed at away from its ends, which are there for a new connection; over an area, which may
   *  be meant too, from half as far. */
  connectionAt(at) {
    if (this.first) return null;
    const reach = areaAt(at.x, at.y) ? at.reach / 2 : at.reach;
    const hit = connectionNear(at, reach, canBeEdited), node = nodeNear(at.x, at.y, at.reach);
    const away = node ? Math.hypot(node.x - at.x, node.y - at.y) : Infinity;
    return hit && away > Math.max(at.reach / 2, 2 * hit.distance) ? hit.item : null;
  }

  tap(at) {
    this.say("");
    const connection = this.connectionAt(at), node = nodeNear(at.x, at.y, at.reach);
    app.chosen = connection;
    if (connection) return;  // then nothing was begun
    if (!node) this.say("Nothing is here: tap a round mark, or an element.");
    else if (!this.first || this.first === node) this.first = this.first ? null : node;
    else if (this.first.shape === node.shape) this.say("A connection joins two different elements.");
    else this.join(this.first, node);
  }
  join(from, to) {
    const gone = app.edits.connect("enforce", from, to), names = [from, to].map(node => nodeText(referenceOf(node)));
    this.first = null;
    this.say(`Connected: ${names.join(" – ")}.${insteadOf(gone)}`, true);
  }

  paint(context) {
    const visible = shapes.length <= 500 ? shapes : shapes.filter(shape => app.hovered === shape);
    for (const shape of visible) for (const node of shape.nodes) paintHandle(context, node.x, node.y, 4, colour.path);
    if (this.near) paintHandle(context, this.near.x, this.near.y, 8, colour.enforced);
    if (this.first) paintHandle(context, this.first.x, this.first.y, 9, colour.enforced, colour.enforced);
  }

  card() {
    if (app.chosen) return thingCard(app.chosen);
    if (!this.first)
      return [title("Connect"), ...this.said(),
              note("Tap the end of an element, then the end of another: the path will go from one to the other. " +
                   "Tap a connection to keep or delete it.")];
    return [title("Connect"), ...this.said(),
            note(`From ${nodeText(referenceOf(this.first))}. Now tap the end of another element.`),
            buttonsOf(button("Cancel", () => { this.leave(); app.refresh(); }))];
  }
}
