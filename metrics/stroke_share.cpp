// Share of the drawing's strokes that the path draws: within 1 cm of a leg with the tool on, as wide as the stroke, and
// in its direction within 20 degrees (either sense). By length, exact for the path's lines as drawn_lines.hpp has them.
#include "maps/drawing.hpp"
#include "metrics/drawn_lines.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kStrokeShare;

namespace {

constexpr double kNear = 0.01;                   // metres
constexpr double kSameWidth = 0.01;              // relative
constexpr double kParallel = 0.939692620785908;  // cosine of 20 degrees

bool draws(const PathSegment& s, const Point& along, double width) {
  return std::abs(s.width - width) <= kSameWidth * width &&
         std::abs((s.b - s.a).dot(along)) >= kParallel * distance(s.a, s.b);
}

/// A stroke wider than the tool is drawn by all of it.
double drawn_length(const DrawnStroke& stroke, const PathSegments& work, double tool_width) {
  double drawn = 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    const Point &a = stroke.points[i - 1], &b = stroke.points[i];
    const double length = distance(a, b);
    if (length <= 0) continue;
    Cover cover;
    work.for_each_near(a, b, kNear, [&](const PathSegment& s) {
      if (draws(s, (b - a) / length, std::min(stroke.width, tool_width))) cover.add(within(a, b, s.a, s.b, kNear));
      return cover.is_whole();
    });
    drawn += cover.share() * length;
  }
  return drawn;
}

std::optional<double> compute(const Scored& s) {
  if (!s.problem.map().drawing) return std::nullopt;
  const double tool_width = s.problem.robot().tool_width;
  const PathSegments work(s.path, tool_width);
  double drawn = 0, all = 0;
  for (const DrawnStroke& stroke : s.problem.map().drawing->strokes) {
    if (!stroke.tool) continue;
    drawn += drawn_length(stroke, work, tool_width);
    all += length(stroke.points);
  }
  if (all <= 0) return std::nullopt;
  return drawn / all;
}

}  // namespace

const Metric kStrokeShare{"stroke_share", "1", Better::higher,
                          "share of a drawing's strokes drawn within 1 cm, as wide as they are; empty: no strokes",
                          compute};

}  // namespace oxturn
