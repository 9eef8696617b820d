#include "maps/formats/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"

namespace oxturn::svg {
namespace {

constexpr double kLeastWidth = 100;  // pixels
constexpr double kMostAspect = 2;    // height over width

}  // namespace

Canvas::Canvas(const Box& box, double width_px) {
  const Point size = box.size();
  width = std::max(width_px, kLeastWidth);
  const double inner = width - 2 * kMargin;
  scale = std::min(inner / std::max(size.x(), 1e-9), kMostAspect * inner / std::max(size.y(), 1e-9));
  low = box.low - Point((inner / scale - size.x()) / 2, 0);
  height = size.y() * scale + 2 * kMargin;
}

std::string px(double value) { return to_decimal(std::round(value * 100) / 100); }

void PathData::move(const Point& p) {
  flush();
  put('M', canvas_(p));
}

void PathData::line(const Point& p) {
  const Point at = canvas_(p);
  skipped_ = (at - last_).squaredNorm() < least2_;
  if (skipped_)
    skipped_at_ = at;
  else
    put('L', at);
}

void PathData::close() {
  skipped_ = false;
  text_ += 'Z';
}

void PathData::add(const Polyline& points) {
  if (points.empty()) return;
  move(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) line(points[i]);
}

std::string PathData::take() {
  flush();
  return std::exchange(text_, {});
}

/// The last vertex of a polyline is always drawn.
void PathData::flush() {
  if (skipped_) put('L', skipped_at_);
  skipped_ = false;
}

void PathData::put(char letter, const Point& at) {
  text_ += letter == 'M' ? 'M' : ' ';  // pairs after M are lines without a letter
  text_ += px(at.x()) + ' ' + px(at.y());
  last_ = at;
}

std::string region_data(const Canvas& canvas, const Region& region) {
  PathData data(canvas, kLeastWallStep);
  for_each_ring(region, [&](const Ring& ring) {
    data.add(ring);
    if (!ring.empty()) data.close();
  });
  return data.take();
}

}  // namespace oxturn::svg
