// The person's edits, as a list that is replaced as a whole at each change: undo takes the one before. Written in the
// format that `oxturn draw --edits` reads (docs/viewer.md).

/** Of a file of edits (or null) the list, in the file's order. */
function editsFrom(file) {
  if (!file) return [];
  // A curve's own kind is its shape here.
  const of = (key, kind) => (file[key] || []).map(edit => ({shape: edit.kind, ...edit, kind}));
  const start = file.start ? [{kind: "start", at: file.start}] : [];
  return [...start, ...of("cuts", "cut"), ...of("fills", "fill"), ...of("connections", "connection"),
          ...of("curves", "curve")];
}

/** A path leaves a node once and arrives there once, so enforced connections that meet in a node have one direction:
 *  those that meet `edit` against its own are turned round, and with them what they meet. */
function turned(list, edit) {
  const out = [...list], todo = [edit], done = new Set();
  const against = (a, b) => sameReference(a.from, b.from) || sameReference(a.to, b.to);
  while (todo.length) {
    const next = todo.pop();
    out.forEach((other, i) => {
      if (other.kind !== "connection" || other.action !== "enforce" || done.has(i) || !against(next, other)) return;
      done.add(i);
      out[i] = {...other, from: other.to, to: other.from};
      todo.push(out[i]);
    });
  }
  return out;
}

class Edits {
  constructor(file, changed) {
    this.list = editsFrom(file);
    this.planned = this.list;  // those that the path on the page obeys
    this.history = [];
    this.changed = changed;
  }

  change(list) {
    this.history.push(this.list);
    this.list = list;
    this.changed();
  }
  undo() {
    if (!this.history.length) return;
    this.list = this.history.pop();
    this.changed();
  }
  remove(edit) { this.change(this.list.filter(e => e !== edit)); }
  /** `replaced`: edits that the new ones take over from. */
  add(edits, replaced = []) { this.change([...this.list.filter(e => !replaced.includes(e)), ...edits]); }

  ofKind(kind) { return this.list.filter(edit => edit.kind === kind); }
  pair(kind, from, to) {
    return this.ofKind(kind).find(e => (sameEnd(e.from, from) && sameEnd(e.to, to)) ||
                                       (sameEnd(e.from, to) && sameEnd(e.to, from)));
  }

  /** Enforces or deletes the connection of two nodes; what contradicts it goes, and is returned. */
  connect(action, from, to) {
    const edit = {kind: "connection", action, from: referenceOf(from), to: referenceOf(to)};
    const same = this.pair("connection", edit.from, edit.to), curve = this.pair("curve", edit.from, edit.to);
    const gone = action === "enforce" ? this.inTheWayOf([from, to], [same, curve]) : curve ? [curve] : [];
    const kept = this.list.filter(e => e !== same && !gone.includes(e));
    this.change([...(action === "enforce" ? turned(kept, edit) : kept), edit]);
    return gone;
  }
  /** Gives the connection of two nodes a curve, which enforces it too; what contradicts it goes, and is returned. */
  bend(edit, from, to) {
    const same = this.pair("curve", edit.from, edit.to), connection = this.pair("connection", edit.from, edit.to);
    const gone = this.inTheWayOf([from, to], [same, connection]);
    if (connection && connection.action === "delete") gone.push(connection);
    this.add([edit], [same, ...gone]);
    return gone;
  }
  inTheWayOf(nodes, except) {
    const gone = new Set(nodes.flatMap(node => this.inTheWayOfOne(node, except)));
    for (const edit of [...gone]) gone.add(this.pair("curve", edit.from, edit.to) || edit);
    return [...gone];
  }
  /** Connections that a person demands and that leave no room for one more at a node: an open stroke has one at each
   *  end; a closed one is entered and left in the same vertex, so it has two there and none elsewhere. */
  inTheWayOfOne(node, except) {
    const demanded = this.list.filter(e => e.kind === "curve" || (e.kind === "connection" && e.action === "enforce"));
    // A connection that has a curve, too, counts once.
    const own = demanded.filter(e => !except.includes(e) &&
                                     !(e.kind === "curve" && demanded.includes(this.pair("connection", e.from, e.to))));
    const at = e => [e.from, e.to].find(end => end.element === node.shape.element);
    if (!node.shape.closed) return own.filter(e => at(e) && at(e).vertex === node.vertex);
    if (node.shape.kind === "area") return own.filter(at).slice(1);
    const elsewhere = own.filter(e => at(e) && at(e).vertex !== node.vertex);
    return [...elsewhere, ...own.filter(e => at(e) && at(e).vertex === node.vertex).slice(1)];
  }

  moveStart(x, y) { this.add([{kind: "start", at: [x, y].map(millimetres)}], this.ofKind("start")); }

  /** The file's text. One edit a line, so that changes are seen in version control. */
  toText() {
    const pick = (edit, keys) => Object.fromEntries(keys.filter(k => edit[k] !== undefined).map(k => [k, edit[k]]));
    const lines = (key, kind, write) => {
      const own = this.ofKind(kind).map(edit => "  " + JSON.stringify(write(edit)));
      return own.length ? [`"${key}": [\n${own.join(",\n")}\n ]`] : [];
    };
    const start = this.ofKind("start").map(edit => `"start": ${JSON.stringify(edit.at)}`);
    return "{" + [
      `"oxturn_edits": 1`,
      `"drawing_sha256": ${JSON.stringify(data.drawing ? data.drawing.sha256 : "")}`,
      ...start,
      ...lines("cuts", "cut", e => pick(e, ["element", "line"])),
      ...lines("fills", "fill", e => pick(e, ["element", "at", "fill", "angle_deg", "outline"])),
      ...lines("connections", "connection", e => pick(e, ["action", "from", "to"])),
      ...lines("curves", "curve", e => ({from: e.from, to: e.to, kind: e.shape, points: e.points})),
    ].join(",\n ") + "}\n";
  }
}

const kFillNames = {spiral: "spiral", zigzag: "zigzag", contour: "contour", none: "not filled"};

const endsText = edit => `${nodeText(edit.from)} – ${nodeText(edit.to)}`;

/** One line for the list. */
function editText(edit) {
  switch (edit.kind) {
    case "start": return `Start at ${edit.at[0].toFixed(2)}, ${edit.at[1].toFixed(2)} m`;
    case "cut": return `Cut ${edit.element}`;
    case "fill": {
      const parts = [];
      if (edit.fill) parts.push(kFillNames[edit.fill]);
      if (edit.angle_deg !== undefined) parts.push(`lanes at ${edit.angle_deg}°`);
      if (edit.outline !== undefined) parts.push(edit.outline ? "with outline" : "no outline");
      return `Fill ${edit.element}: ${parts.join(", ")}`;
    }
    case "connection":
      return `${edit.action === "enforce" ? "Connect" : "Never connect"} ${endsText(edit)}`;
    default: return `Curve ${endsText(edit)}`;
  }
}
/** Of edits that others took over from, for the card. */
const insteadOf = gone => gone.length ? ` In place of: ${gone.map(editText).join("; ")}.` : "";
