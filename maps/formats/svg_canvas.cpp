#include "maps/formats/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oxturn::svg {
namespace {

constexpr double kLeastWidth = 100;  // pixels
constexpr double kMostAspect = 2;    // height over width

std::int64_t hundredths(double px) { return std::llround(px * 100); }

/// Hundredths of a pixel as a decimal: 1250 -> "12.5".
void append_hundredths(std::string& out, std::int64_t h) {
  if (h < 0) {
    out += '-';
    h = -h;
  }
  out += std::to_string(h / 100);
  const int rest = static_cast<int>(h % 100);
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

}  // namespace

Canvas::Canvas(const Box& box, double width_px) {
  const Point size = box.size();
  width = std::max(width_px, kLeastWidth);
  const double inner = width - 2 * kMargin;
  scale = std::min(inner / std::max(size.x(), 1e-9), kMostAspect * inner / std::max(size.y(), 1e-9));
  low = box.low - Point((inner / scale - size.x()) / 2, 0);
  height = size.y() * scale + 2 * kMargin;
}

std::string px(double value) {
  std::string out;
  append_hundredths(out, hundredths(value));
  return out;
}

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
  append_hundredths(text_, hundredths(at.x()));
  text_ += ' ';
  append_hundredths(text_, hundredths(at.y()));
  last_ = at;
}

std::string region_data(const Canvas& canvas, const Region& region) {
  PathData data(canvas, kLeastWallStep);
  for_each_ring(region, [&](const Ring& ring) {
    if (ring.empty()) return;
    data.add(ring);
    data.close();
  });
  return data.take();
}

}  // namespace oxturn::svg
