/** Plays the path in time: the slider is the time of the robot, not of the spectator. */
class Player {
  static kSpeeds = [1, 2, 5, 10, 20, 50, 100, 200, 500];
  static kWatch = 30;  // seconds in which a path is shown if nobody chooses another speed

  constructor() {
    this.playing = false;
    this.slider = byId("time");
    const wanted = Player.kSpeeds.find(speed => totalTime / speed <= Player.kWatch) || 500;
    byId("speed").append(...Player.kSpeeds.map(s => create("option", {value: s, selected: s === wanted}, `${s}×`)));
    this.slider.max = totalTime || 1;
    this.slider.oninput = () => this.go(Number(this.slider.value));
    byId("play").onclick = () => this.toggle();
    for (const part of [this.slider, byId("play")]) part.disabled = totalTime === 0;
    this.show();
  }

  toggle() {
    if (totalTime === 0) return;
    this.playing = !this.playing;
    if (this.playing && app.time >= totalTime) this.go(0);
    this.last = null;
    if (this.playing) requestAnimationFrame(now => this.step(now));
    this.show();
  }
  step(now) {
    if (!this.playing) return;
    const passed = this.last === null ? 0 : (now - this.last) / 1000;
    this.last = now;
    this.go(app.time + passed * Number(byId("speed").value));
    if (app.time >= totalTime) this.playing = false;
    else requestAnimationFrame(next => this.step(next));
    this.show();
  }
  go(time) {
    app.time = Math.min(totalTime, Math.max(0, time));
    app.redraw(false);
    this.show();
  }
  show() {
    this.slider.value = app.time;
    byId("clock").value = `${minutes(app.time)} / ${minutes(totalTime)}`;
    byId("play").textContent = this.playing ? "❚❚" : "▶";
    byId("play").setAttribute("aria-label", this.playing ? "Pause" : "Play");
  }
}
