/// The basics of SVG pictures: scale, numbers, path data. Private to maps/formats.
///
///   const svg::Canvas canvas(bounding_box(region), 1000);
///   out += "<path d=\"" + svg::region_data(canvas, region) + "\"/>";
///
/// y points up in maps and down in SVG: it is reversed in Canvas and nowhere else. Numbers are rounded to
/// hundredths of a pixel: short, and the same on every machine.
#pragma once

#include <string>

#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn::svg {

inline constexpr double kMargin = 12;  // pixels round the map

// Vertices nearer than this to the last one drawn are left out: pixels.
inline constexpr double kLeastLineStep = 0.25;
inline constexpr double kLeastWallStep = 0.05;

/// From metres to pixels.
struct Canvas {
  Point low{0, 0};
  double scale = 1, width = 0, height = 0;  // pixels per metre; size of the map's part of the picture, in pixels

  Canvas(const Box& box, double width_px);
  Point operator()(const Point& p) const {
    return {kMargin + (p.x() - low.x()) * scale, height - kMargin - (p.y() - low.y()) * scale};
  }
};

/// Pixels as text: "12.5".
std::string px(double value);

/// Path data of polylines, without vertices nearer than `least_px` pixels to the last one drawn.
class PathData {
 public:
  PathData(const Canvas& canvas, double least_px) : canvas_(canvas), least2_(least_px * least_px) {}
  void move(const Point& p);
  void line(const Point& p);
  void close();
  /// A whole polyline.
  void add(const Polyline& line);
  bool empty() const { return text_.empty(); }
  std::string take();

 private:
  void flush();
  void put(char letter, const Point& at);
  const Canvas& canvas_;
  double least2_;
  std::string text_;
  Point last_{0, 0}, skipped_at_{0, 0};
  bool skipped_ = false;  // the last vertex was left out
};

std::string region_data(const Canvas& canvas, const Region& region);

}  // namespace oxturn::svg
