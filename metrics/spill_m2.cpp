// Area that the path works outside of what is to be drawn, square metres: outside the filled areas, and farther from
// the strokes than half their width plus 1 cm.
#include <map>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "maps/drawing.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kSpillM2;

namespace {

constexpr double kNear = 0.01;        // metres
constexpr double kChordError = 1e-3;  // of a width

/// A lower bound of what the tool sweeps.
Region worked(const Path& path, double tool_width) {
  std::map<double, std::vector<Polyline>> lines;  // by width
  for (const Leg& leg : path.legs)
    if (leg.tool) lines[leg.width > 0 ? std::min(leg.width, tool_width) : tool_width].push_back(leg.points);
  std::vector<Region> parts;
  parts.reserve(lines.size());
  for (const auto& [width, all] : lines) parts.push_back(swath(all, width / 2, kChordError * width, Bound::inside));
  return unite(parts);
}

std::optional<double> compute(const Scored& s) {
  if (!s.problem.map().drawing) return std::nullopt;
  const Drawing& drawing = *s.problem.map().drawing;
  std::vector<Region> allowed;
  for (const FilledArea& area : drawing.areas) allowed.push_back({{area.area}});
  for (const DrawnStroke& stroke : drawing.strokes)
    if (stroke.tool)
      allowed.push_back(swath({stroke.points}, stroke.width / 2 + kNear, kChordError * stroke.width, Bound::outside));
  return area(subtract(worked(s.path, s.problem.robot().tool_width), allowed));
}

}  // namespace

const Metric kSpillM2{"spill_m2", "m2", Better::lower,
                      "area worked outside of a drawing's areas and strokes (these 1 cm wider); empty: no drawing",
                      compute};

}  // namespace oxturn
