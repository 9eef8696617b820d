// Area that the path works outside of what is to be drawn, square metres: outside the filled areas, and farther from
// the strokes than half their width plus 1 cm.
#include <algorithm>
#include <map>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "maps/drawing.hpp"
#include "metrics/drawn_lines.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kSpillM2;

namespace {

constexpr double kNear = 0.01;        // metres
constexpr double kChordError = 1e-3;  // of a width
constexpr double kRounding = 2e-5;    // metres: strokes are thinned by half of that, areas rounded

Region areas_of(const Drawing& drawing) {
  std::vector<Region> areas;
  for (const FilledArea& area : drawing.areas) areas.push_back({{area.area}});
  return unite(areas);
}

Path strokes_of(const Drawing& drawing) {
  Path path;
  for (const DrawnStroke& stroke : drawing.strokes)
    if (stroke.tool) path.legs.push_back({true, stroke.points, Gear::forward, stroke.width});
  return path;
}

/// Finds most of the segments that spill nothing: along one segment of a stroke, or inside an area.
class HarmlessWork {
 public:
  HarmlessWork(const Drawing& drawing, double tool_width)
      : strokes_(strokes_of(drawing), tool_width), areas_(areas_of(drawing)) {}

  bool contains(const Point& a, const Point& b, double width) const {
    if (areas_.contains(a) && !areas_.nearest(a, b, width / 2 - kRounding)) return true;
    bool found = false;
    strokes_.for_each_touching(a, b, kNear - width / 2, [&](const PathSegment& s) {
      const double reach = kNear + (s.width - width) / 2 - kRounding;
      // Capsules are convex: what holds for both ends holds between them.
      found = std::max(distance_to_segment(a, s.a, s.b), distance_to_segment(b, s.a, s.b)) <= reach;
      return found;
    });
    return found;
  }

 private:
  PathSegments strokes_;
  EdgeIndex areas_;
};

/// A lower bound of what the tool sweeps, without what certainly is no spill.
Region worked(const Path& path, const HarmlessWork& harmless, double tool_width) {
  std::map<double, std::vector<Polyline>> lines;  // by width
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    const double width = width_of(leg, tool_width);
    std::vector<Polyline>& all = lines[width];
    bool joins = false;
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      const bool counts = !harmless.contains(a, b, width);
      if (counts && !joins) all.push_back({a});
      if (counts) all.back().push_back(b);
      joins = counts;
    }
  }
  std::vector<Region> parts;
  parts.reserve(lines.size());
  for (const auto& [width, all] : lines) parts.push_back(swath(all, width / 2, kChordError * width, Bound::inside));
  return unite(parts);
}

std::optional<double> compute(const Scored& s) {
  if (!s.problem.map().drawing) return std::nullopt;
  const Drawing& drawing = *s.problem.map().drawing;
  const double tool_width = s.problem.robot().tool_width;
  const Region rest = worked(s.path, HarmlessWork(drawing, tool_width), tool_width);
  if (rest.empty()) return 0;
  const Box box = bounding_box(rest);
  std::vector<Region> allowed;
  for (const FilledArea& area : drawing.areas)
    if (bounding_box(area.area.outer).overlaps(box)) allowed.push_back({{area.area}});
  for (const DrawnStroke& stroke : drawing.strokes)
    if (stroke.tool)
      allowed.push_back(swath({stroke.points}, stroke.width / 2 + kNear, kChordError * stroke.width, Bound::outside));
  return area(subtract(rest, allowed));
}

}  // namespace

const Metric kSpillM2{"spill_m2", "m2", Better::lower,
                      "area worked outside of a drawing's areas and strokes (these 1 cm wider); empty: no drawing",
                      compute};

}  // namespace oxturn
