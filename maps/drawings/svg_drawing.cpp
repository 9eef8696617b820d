// From the elements of an SVG document to strokes and areas on the canvas.
//
// Decisions  1. Elements are painted in order: a white area erases what lies below it, areas that overlap are united
//               and keep the name of the first.
//            2. Stroke widths within one percent of 1, 3 and 5 pixels count as these: programs that write millimetres
//               round them.
//            3. What a stroke or an area covers of another stroke stays: only white erases.
//            4. Overlaps narrower than the flattening are contact: areas that share a boundary stay two.
#include "maps/svg_drawing.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/sha256.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/drawings/canvas_fit.hpp"
#include "maps/drawings/painted_areas.hpp"
#include "maps/drawings/stroke_pieces.hpp"
#include "maps/drawings/svg_elements.hpp"

namespace oxturn {
namespace {

using svg::Element;
using svg::Flattened;
using svg::Paint;

constexpr double kWidthTolerance = 1.01;
constexpr double kFlatness = 1e-3;  // of the narrowest pen
constexpr std::size_t kMostVertices = 5'000'000;

bool is_stroked(const Element& e) { return e.stroke != Paint::none && e.stroke != Paint::white; }
bool is_pen(const Element& e) { return is_stroked(e) && e.stroke != Paint::green; }
bool is_area(const Element& e) { return e.fill != Paint::none && e.fill != Paint::white; }

double pen_width(const Element& e, const DrawingOptions& o) {
  if (e.stroke_width <= 1 * kWidthTolerance) return o.width_1;
  if (e.stroke_width <= 3 * kWidthTolerance) return o.width_3;
  return e.stroke_width <= 5 * kWidthTolerance ? o.width_5 : o.width_7;
}

/// Collects what is painted, from the bottom to the top.
class Painter {
 public:
  Painter(std::string file, const DrawingOptions& options, const svg::Affine& to_canvas, double tolerance,
          SvgDrawing& out)
      : file_(std::move(file)),
        options_(options),
        to_canvas_(to_canvas),
        tolerance_(tolerance),
        out_(out),
        areas_(tolerance) {}

  void paint(const Element& e) {
    const std::vector<Flattened> lines = flattened_lines(e);
    try {
      if (e.fill != Paint::none) fill(e, lines);
    } catch (const std::length_error& error) { throw_invalid("{}:{}: {}", file_, e.line, error.what()); }
    if (e.stroke == Paint::green) drawing().start = lines.back().points.back();
    if (is_pen(e)) stroke(e, lines);
  }

  void finish() {
    number_strokes();
    try {
      drawing().areas = areas_.take();
    } catch (const std::length_error& error) { throw_invalid("{}: {}", file_, error.what()); }
  }

 private:
  Drawing& drawing() { return out_.drawing; }

  std::vector<Flattened> flattened_lines(const Element& e) {
    std::vector<Flattened> lines;
    for (const svg::Subpath& subpath : transformed(e.outline, to_canvas_)) {
      auto line = svg::flattened(subpath, tolerance_, kMostVertices - vertices_);
      if (!line) throw_invalid("{}:{}: the drawing has more than {} vertices", file_, e.line, kMostVertices);
      vertices_ += line->points.size();
      lines.push_back(std::move(*line));
    }
    return lines;
  }

  void fill(const Element& e, const std::vector<Flattened>& lines) {
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!options_.literal || e.outline[i].closed) rings.push_back(lines[i].points);
    if (rings.empty()) return;
    require_untangled(rings);
    const Region region = options_.literal ? first_less_others(rings) : enclosed(rings, e.rule);
    if (e.fill != Paint::white) {
      areas_.add(e.id, region);
    } else if (!options_.literal && !region.empty()) {
      areas_.erase(region);
      erase_strokes(region);
    }
  }
  static Region first_less_others(const std::vector<Ring>& rings) {
    const Region first = enclosed({rings.front()}, FillRule::nonzero);
    return subtract(first, enclosed({rings.begin() + 1, rings.end()}, FillRule::nonzero));
  }

  void erase_strokes(const Region& white) {
    const Box box = bounding_box(white);
    const EdgeIndex index(white);
    std::vector<DrawnStroke> left;
    for (DrawnStroke& stroke : drawing().strokes) {
      if (!bounding_box(stroke.points).overlaps(box)) {
        left.push_back(std::move(stroke));
        continue;
      }
      for (DrawnStroke& piece : pieces_outside(stroke, index)) left.push_back(std::move(piece));
    }
    drawing().strokes = std::move(left);
  }

  void stroke(const Element& e, const std::vector<Flattened>& lines) {
    const bool tool = e.stroke != Paint::red;
    for (const Flattened& line : lines)
      if (line.points.size() > 1)
        drawing().strokes.push_back(
            {e.id, line.points, pen_width(e, options_), tool, line.nodes, line.corners, e.line});
      else
        out_.remarks.push_back(fmt::format("{}:{}: a stroke without length is not drawn", file_, e.line));
  }

  /// Strokes of one element are told apart by a number after its name.
  void number_strokes() {
    std::map<std::string, std::size_t> count, next;
    for (const DrawnStroke& stroke : drawing().strokes) ++count[stroke.element];
    for (DrawnStroke& stroke : drawing().strokes)
      if (const std::string element = stroke.element; count[element] > 1)
        stroke.element += "#" + std::to_string(next[element]++);
  }

  std::string file_;
  const DrawingOptions& options_;
  svg::Affine to_canvas_;
  double tolerance_;
  SvgDrawing& out_;
  PaintedAreas areas_;
  std::size_t vertices_ = 0;
};

/// The box of the outlines' nodes.
Box node_box(const svg::Outline& outline) {
  Box box;
  for (const svg::Subpath& subpath : outline)
    for (const svg::CurveSegment& segment : subpath.segments) {
      box.add(segment.start());
      box.add(segment.end());
    }
  return box;
}

CanvasFit fit_of(const std::vector<Element>& elements, const DrawingOptions& options) {
  CanvasFit fit;
  for (const Element& e : elements) {
    if (!is_stroked(e) && !is_area(e)) continue;
    const bool draws = is_pen(e) && e.stroke != Paint::red && !options.literal;
    fit.add(options.literal ? node_box(e.outline) : bounding_box(e.outline), draws ? pen_width(e, options) / 2 : 0);
  }
  return fit;
}

void check(const DrawingOptions& o) {
  for (const double value : {o.canvas_width, o.canvas_height, o.width_1, o.width_3, o.width_5, o.width_7})
    if (!(value > 0 && value <= 1e6)) throw_invalid("a canvas's or a stroke's width is {}, expected above 0", value);
  if (!(o.margin >= 0)) throw_invalid("the margin is {}, expected at least 0", o.margin);
}

}  // namespace

SvgDrawing drawing_from_svg(const std::string& text, const std::string& file, const DrawingOptions& options) {
  check(options);
  svg::Elements read = svg::read_elements(text, file, options.literal);
  SvgDrawing out{{}, std::move(read.remarks)};
  const CanvasFit fit = fit_of(read.elements, options);
  const auto nothing = [&] {
    if (!out.remarks.empty()) throw_invalid("{}; there is nothing to draw but that", out.remarks.front());
    if (read.elements.empty()) throw_invalid("{}:{}: nothing to draw: no element has an outline", file, read.root_line);
    throw_invalid("{}:{}: nothing to draw: no element has a stroke or a fill other than white, {}", file,
                  read.elements.front().line, "with a length or an area");
  };
  if (fit.empty()) nothing();
  double narrowest = options.width_7;
  for (const Element& e : read.elements)
    if (is_pen(e)) narrowest = std::min(narrowest, pen_width(e, options));
  const svg::Affine to_canvas = fit.placed({options.canvas_width, options.canvas_height}, options.margin);
  Painter painter(file, options, to_canvas, kFlatness * narrowest, out);
  for (const Element& e : read.elements) painter.paint(e);
  painter.finish();
  if (out.drawing.strokes.empty() && out.drawing.areas.empty()) nothing();
  out.drawing.sha256 = sha256(text);
  return out;
}

}  // namespace oxturn
