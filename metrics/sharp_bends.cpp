#include "metrics/sharp_bends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/bends.hpp"
#include "geometry/edge_index.hpp"
#include "maps/drawing.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostRemarks = 10;
constexpr double kLoop = 3;  // least turning radii that a loop reaches at most, and a little more

/// The stroke or area that is nearest.
std::string element_at(const Drawing& drawing, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  std::string name = "the start";
  const auto offer = [&](const Point& a, const Point& b, const auto& text) {
    if (const double d = distance_to_segment(p, a, b); d < least) least = d, name = text();
  };
  for (const DrawnStroke& s : drawing.strokes)
    for (std::size_t k = 1; k < s.points.size(); ++k)
      offer(s.points[k - 1], s.points[k], [&] {
        return fmt::format("stroke '{}'{}", s.element, s.line > 0 ? fmt::format(" (line {})", s.line) : "");
      });
  for (const FilledArea& area : drawing.areas)
    for (std::size_t k = 0; k < area.area.outer.size(); ++k)
      offer(area.area.outer[k], area.area.outer[(k + 1) % area.area.outer.size()],
            [&] { return fmt::format("area '{}'", area.element); });
  return name;
}

}  // namespace

std::vector<std::string> remarks_on_sharp_bends(const Problem& problem, const Path& path) {
  std::vector<std::string> sentences;
  const Robot& robot = problem.robot();
  const double radius = robot.min_turn_radius, room = robot.radius + kLoop * radius;
  if (!problem.map().drawing || !(radius > 0)) return sentences;
  std::size_t more = 0;
  for (const Bend& bend : bends(path, problem.tolerance(), robot.tool_width)) {
    if (!too_sharp(bend, radius)) continue;
    if (sentences.size() == kMostRemarks) {
      ++more;
      continue;
    }
    const bool near_boundary = problem.map_edges().nearest(bend.at, room).has_value();
    sentences.push_back(fmt::format("at ({:.2f}, {:.2f}), {}, the path turns more sharply than {} m{}", bend.at.x(),
                                    bend.at.y(), element_at(*problem.map().drawing, bend.at), radius,
                                    near_boundary ? fmt::format(": it is near the canvas's boundary, and a margin of "
                                                                "{:.2g} m leaves room for every turn (--margin)",
                                                                room)
                                                  : ""));
  }
  if (more > 0) sentences.push_back(fmt::format("{} more bends are too sharp", more));
  return sentences;
}

}  // namespace oxturn
