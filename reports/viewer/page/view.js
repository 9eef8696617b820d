/** Where the plane lies on the screen: pixels = (x + scale * metres, y - scale * metres). */
class View {
  constructor() {
    Object.assign(this, {scale: 1, x: 0, y: 0, width: 1, height: 1, pixels: 1, fitted: true});
    this.covered = {top: 0, bottom: 0};  // pixels behind buttons and card, which fit() leaves empty
  }

  resize(width, height, pixels) {
    const dx = (width - this.width) / 2, dy = (height - this.height) / 2;
    Object.assign(this, {width, height, pixels});
    if (this.fitted) this.fit(wholeBox);
    else this.pan(dx, dy);
  }
  fit(box) {
    const margin = 24, height = this.height - this.covered.top - this.covered.bottom - 2 * margin;
    const w = Math.max(box.right - box.left, 1e-9), h = Math.max(box.top - box.bottom, 1e-9);
    this.fitScale = Math.max(1e-9, Math.min((this.width - 2 * margin) / w, height / h));
    this.scale = this.fitScale;
    this.x = this.width / 2 - this.scale * (box.left + box.right) / 2;
    this.y = this.covered.top + margin + height / 2 + this.scale * (box.bottom + box.top) / 2;
    this.fitted = true;
  }
  pan(dx, dy) {
    this.x += dx;
    this.y += dy;
    this.fitted = false;
  }
  /** The point under the pixel stays there. */
  zoom(px, py, factor) {
    const scale = Math.min(this.fitScale * 500, Math.max(this.fitScale / 4, this.scale * factor));
    this.x = px - (px - this.x) * scale / this.scale;
    this.y = py - (py - this.y) * scale / this.scale;
    this.scale = scale;
    this.fitted = false;
  }
  toPlane(px, py) { return [(px - this.x) / this.scale, (this.y - py) / this.scale]; }
  toScreen(x, y) { return [this.x + this.scale * x, this.y - this.scale * y]; }
  /** Lets a context draw in metres, or in pixels of the page. */
  inMetres(context) {
    const p = this.pixels;
    context.setTransform(this.scale * p, 0, 0, -this.scale * p, this.x * p, this.y * p);
  }
  inPixels(context) { context.setTransform(this.pixels, 0, 0, this.pixels, 0, 0); }
}
