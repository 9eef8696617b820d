/** Moves the point where the path begins. */
class StartTool extends Tool {
  leave() { app.startDraft = null; }
  moveTo(at) {
    app.startDraft = null;
    if (testContext.isPointInPath(mapPath, at.x, at.y, "evenodd")) app.edits.moveStart(at.x, at.y);
    else this.message = "The start must lie on the canvas.";
  }
  tap(at) {
    this.message = "";
    this.moveTo(at);
  }
  press(at) {
    const start = app.edits.ofKind("start")[0], [x, y] = start ? start.at : data.start;
    this.message = "";
    return Math.hypot(at.x - x, at.y - y) < 1.4 * at.reach;
  }
  drag(at) { app.startDraft = [at.x, at.y]; }
  drop(at) { this.moveTo(at); }
  cancel() { app.startDraft = null; }
  card() {
    return [title("Start"), ...(this.message ? [create("p", {className: "message"}, this.message)] : []),
            note("Tap where the path is to begin, or drag the round mark.")];
  }
}
