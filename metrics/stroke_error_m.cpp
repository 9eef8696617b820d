// Largest distance from a drawing's strokes to where the path drives with the tool on, metres. Strokes are sampled
// every 5 mm and at their vertices (but not twice within 0.5 mm), so the result is at most 2.75 mm too small.
#include <limits>

#include "maps/drawing.hpp"
#include "metrics/drawn_lines.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kStrokeErrorM;

namespace {

constexpr double kStep = 0.005;        // metres
constexpr double kLeastStep = 0.0005;  // metres

/// By reaches that double until a segment is found. Stops at one that is no farther than `enough`: then the distance
/// may be less.
double distance_to(const PathSegments& work, const Point& p, double from, double enough) {
  for (double reach = std::max(from, kStep);; reach *= 2) {
    double least = std::numeric_limits<double>::infinity();
    work.for_each_near(p, p, reach, [&](const PathSegment& s) {
      least = std::min(least, distance_to_segment(p, s.a, s.b));
      return least <= enough;
    });
    if (least <= reach || reach > 1e12) return least;
  }
}

std::optional<double> compute(const Scored& s) {
  if (!s.problem.map().drawing) return std::nullopt;
  const PathSegments work(s.path, s.problem.robot().tool_width);
  if (work.empty()) return std::nullopt;
  double most = -1, near = kStep, since = 0;  // metres since the last sample
  for (const DrawnStroke& stroke : s.problem.map().drawing->strokes) {
    if (!stroke.tool) continue;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      const Point &a = stroke.points[i - 1], &b = stroke.points[i];
      const auto steps = static_cast<std::size_t>(std::ceil(distance(a, b) / kStep));
      for (std::size_t k = i == 1 ? 0 : 1; k <= steps; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(std::max<std::size_t>(1, steps));
        if (k > 0) since += distance(a, b) / static_cast<double>(steps);
        if (k > 0 && since < kLeastStep && i + 1 < stroke.points.size()) continue;
        since = 0;
        most = std::max(most, near = distance_to(work, lerp(a, b, share), near, most));
      }
    }
  }
  if (most < 0) return std::nullopt;
  return most;
}

}  // namespace

const Metric kStrokeErrorM{"stroke_error_m", "m", Better::lower,
                           "largest distance from a drawing's strokes to the work of the path; empty: no strokes",
                           compute};

}  // namespace oxturn
