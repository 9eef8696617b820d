/// Where a drawing goes on its canvas. Private to maps.
///
///   CanvasFit fit;
///   fit.add(bounding_box(outline), pen / 2);
///   const svg::Affine to_canvas = fit.placed({20, 15}, 0.2);
#pragma once

#include <map>

#include "maps/drawings/outline.hpp"

namespace oxturn {

/// Collects boxes in pixels (y down), each drawn by a pen that reaches some metres beyond its box.
class CanvasFit {
 public:
  void add(const Box& pixels, double reach) { boxes_[reach].add(pixels); }
  bool empty() const { return boxes_.empty(); }
  /// From pixels to metres on the canvas, y up: as large as the margin allows, centred. A drawing without extent is not
  /// enlarged. Throws std::invalid_argument if the canvas has no room.
  svg::Affine placed(const Point& canvas, double margin) const;

 private:
  std::map<double, Box> boxes_;  // by the pen's reach: a pen is as wide at every scale
};

}  // namespace oxturn
