/** The part of an area that holds a point, after the area's cuts. The area is painted on a small canvas, the cuts are
 *  erased, and the part is filled from the point, so the page needs no arithmetic on polygons. */
class Part {
  static kHereAndBeside = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]];
  static kPixels = 512;  // of the longer side: 4 cm on an area of 20 m

  constructor(shape, x, y, cuts) {
    const box = shape.box, size = Math.max(box.right - box.left, box.top - box.bottom, 1e-9);
    this.box = box;
    this.scale = (Part.kPixels - 4) / size;
    this.canvas = create("canvas", {width: Math.ceil((box.right - box.left) * this.scale) + 4,
                                    height: Math.ceil((box.top - box.bottom) * this.scale) + 4});
    const context = this.canvas.getContext("2d", {willReadFrequently: true});
    context.setTransform(this.scale, 0, 0, this.scale, 2 - box.left * this.scale, 2 - box.bottom * this.scale);
    context.fill(shape.path, "evenodd");
    context.globalCompositeOperation = "destination-out";
    context.lineWidth = 2 / this.scale;
    for (const cut of cuts) context.stroke(pathOf(cut.line.flat()));
    this.mask = this.flood(context.getImageData(0, 0, this.canvas.width, this.canvas.height), x, y);
    this.canvas = null;
  }

  pixel(x, y) {
    return [x - this.box.left, y - this.box.bottom].map(metres => Math.floor(metres * this.scale) + 2);
  }

  flood(image, x, y) {
    const {width, height} = image, mask = new Uint8Array(width * height), todo = [];
    this.width = width;
    const visit = (c, r) => {
      const i = r * width + c;
      if (c < 0 || r < 0 || c >= width || r >= height || mask[i] || image.data[4 * i + 3] < 128) return;
      mask[i] = 1;
      todo.push(c, r);
    };
    const [c0, r0] = this.pixel(x, y);
    for (const [dc, dr] of Part.kHereAndBeside) if (!todo.length) visit(c0 + dc, r0 + dr);
    while (todo.length) {
      const r = todo.pop(), c = todo.pop();
      visit(c + 1, r);
      visit(c - 1, r);
      visit(c, r + 1);
      visit(c, r - 1);
    }
    return mask;
  }

  contains(x, y) {
    const [c, r] = this.pixel(x, y);
    return Part.kHereAndBeside.some(([dc, dr]) => this.mask[(r + dr) * this.width + c + dc] === 1);
  }

  /** Paints the part in a colour, in metres. */
  paint(context, colour) {
    if (!this.canvas) {
      const height = this.mask.length / this.width, image = new ImageData(this.width, height);
      this.mask.forEach((set, i) => image.data[4 * i + 3] = set ? 255 : 0);
      this.canvas = create("canvas", {width: this.width, height});
      const own = this.canvas.getContext("2d");
      own.putImageData(image, 0, 0);
      own.globalCompositeOperation = "source-in";
      own.fillStyle = colour;
      own.fillRect(0, 0, this.width, height);
    }
    context.globalAlpha = 0.35;
    context.drawImage(this.canvas, this.box.left - 2 / this.scale, this.box.bottom - 2 / this.scale,
                      this.canvas.width / this.scale, this.canvas.height / this.scale);
    context.globalAlpha = 1;
  }
}

function partAt(shape, x, y) {
  return new Part(shape, x, y, app.edits.ofKind("cut").filter(cut => cut.element === shape.element));
}
/** The edit of the fill of a part; undefined if there is none. */
function fillEditOf(shape, part) {
  return app.edits.ofKind("fill").find(edit => edit.element === shape.element && part.contains(edit.at[0], edit.at[1]));
}
