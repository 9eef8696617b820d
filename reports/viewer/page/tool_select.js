/** What all tools do: answer taps, and drags if press() takes them, paint over the drawing, fill the card. */
class Tool {
  static cursor = "";
  enter() {}
  leave() {}
  hover() { return null; }  // what would be chosen here: anything with a path
  tap() {}
  press() { return false; }
  drag() {}
  drop() {}
  cancel() {}
  paint() {}
  card() { return []; }

  /** What the card says about the last tap or drag, until the next: `done`, or why it did nothing. */
  say(text, done = false) { this.message = text && {text, done}; }
  said() {
    const {text, done} = this.message || {};
    return text ? [create("p", {className: done ? "done" : "message"}, text)] : [];
  }
}

const title = text => create("h2", {}, text);
const note = text => create("p", {}, text);
const buttonsOf = (...buttons) => create("div", {className: "buttons"}, ...buttons);

function ordinal(n) {
  const last = n % 100;
  return n + (last > 10 && last < 14 ? "th" : ["th", "st", "nd", "rd"][n % 10] || "th");
}

const connectionNear = (at, reach = at.reach, accept = () => true) => app.layers.connections
    ? connectionGrid.nearest(at.x, at.y, reach, e => e.item.t0 <= app.time && accept(e.item)) : null;

/** The shape, connection or leg at a point; null if there is none. */
function thingAt(at) {
  const stroke = shapeGrid.nearest(at.x, at.y, at.reach, e => e.item.kind === "stroke");
  const connection = connectionNear(at);
  if (connection && (!stroke || connection.distance < stroke.distance)) return connection.item;
  if (stroke) return stroke.item;
  const leg = legGrid.nearest(at.x, at.y, at.reach);
  if (leg) return legThing(leg.item);
  return areaAt(at.x, at.y);
}
function legThing(number) {
  const leg = legs[number];
  leg.path = leg.path || pathOf(leg.points);
  return Object.assign(leg, {kind: "leg", number: number + 1});
}

function shapeCard(shape) {
  const size = shape.kind === "area" ? `Filled area of ${shape.squareMetres.toFixed(2)} m²` :
      `${shape.closed ? "Closed line" : "Line"}, ${metres(shape.length)} long, ${metres(shape.width)} wide`;
  const when = shape.order ?
      `Driven ${ordinal(shape.order)} of ${elementsDriven}: ${metres(shape.driven)} ` +
      `from ${minutes(shape.t0)} to ${minutes(shape.t1)}` :
      "The path does not drive it.";
  const lines = [title(shape.element || "Without id"), note(size), note(when)];
  if (shape.kind === "area")
    lines.push(buttonsOf(button("Change fill", () => app.use("fill").choose(shape, ...shape.tapped))));
  return lines;
}

function connectionCard(connection) {
  const name = (node, shape, none) => node ? nodeText(referenceOf(node)) : shape ? shape.element : none;
  const [before, after] = connection.between, lines = [
    title(`Connection ${connection.number} of ${connections.length}`),
    note(connection.inside && before ? `Within ${before.element}` :
         `From ${name(connection.from, before, "the path's start")} ` +
         `to ${name(connection.to, after, "the path's end")}`),
    note(`${metres(connection.length)}, tool off, at ${minutes(connection.t0)}`)];
  if (!canBeEdited(connection) || !editable) return lines;
  const edit = app.edits.pair("connection", referenceOf(connection.from), referenceOf(connection.to));
  if (edit) lines.push(note(edit.action === "enforce" ? "Will be kept." : "Will be avoided."));
  const act = (text, action) => button(text, () => app.edits.connect(action, connection.from, connection.to));
  lines.push(buttonsOf(act("Keep", "enforce"), act("Delete", "delete"),
                       button("Change curve", () => app.use("curve").choose(connection))));
  return lines;
}

const legCard = leg => [title(`Leg ${leg.number} of ${legs.length}`),
                        note(`${metres(leg.length)}, tool on${leg.reverse ? ", in reverse" : ""}`),
                        note(`From ${minutes(leg.times[0])} to ${minutes(leg.times[leg.times.length - 1])}`)];

function thingCard(thing) {
  if (thing.kind === "leg") return legCard(thing);
  return thing.kind ? shapeCard(thing) : connectionCard(thing);
}

class SelectTool extends Tool {
  hover(at) { return thingAt(at); }
  tap(at) {
    app.chosen = thingAt(at);
    if (app.chosen && app.chosen.kind === "area") app.chosen.tapped = [at.x, at.y];
  }
  card() {
    const shown = app.chosen || app.hovered;
    if (shown) return thingCard(shown);
    const things = editable ? "a line, an area or a connection to see what it is" : "the path to see when it is driven";
    return app.small ? [] : [title(editable ? "Select" : "Path"),
                             note(`Point at ${things}. Drag to move the view, turn the wheel or pinch to zoom.`)];
  }
}
