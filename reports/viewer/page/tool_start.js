/** Moves the point where the path begins. */
class StartTool extends Tool {
  enter() { this.leave(); }
  leave() {
    app.startDraft = null;
    this.say("");
  }
  moveTo(at) {
    app.startDraft = null;
    const inside = testContext.isPointInPath(mapPath, at.x, at.y, "evenodd");
    if (inside) app.edits.moveStart(at.x, at.y);
    this.say(inside ? "The path will begin here." : "The start must lie on the canvas.", inside);
  }
  tap(at) { this.moveTo(at); }
  press(at) {
    const start = app.edits.ofKind("start")[0], [x, y] = start ? start.at : data.start;
    return Math.hypot(at.x - x, at.y - y) < 1.4 * at.reach;
  }
  drag(at) { app.startDraft = [at.x, at.y]; }
  drop(at) { this.moveTo(at); }
  cancel() { app.startDraft = null; }
  card() {
    return [title("Start"), ...this.said(), note("Tap where the path is to begin, or drag the round mark.")];
  }
}
